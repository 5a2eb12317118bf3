// SPDX-License-Identifier: MIT
//
// A board at a serial port, for the tests: runs in the page before its script. board.print(text) makes the board print,
// in the pieces that the caller chooses; board.heard is what was sent to it.
{
    const listeners = { connect: new Set(), disconnect: new Set() };
    let controller = null;
    const port = {
        readable: null,
        writable: null,
        async open({ baudRate }) {
            if (board.isGone || board.isBusy) {
                throw new DOMException("Failed to open serial port.", "NetworkError");
            }
            if (port.readable) {
                throw new DOMException("The port is already open.", "InvalidStateError");
            }
            board.baudRate = baudRate;
            board.opened++;
            port.readable = new ReadableStream({ start: (c) => (controller = c) });
            port.writable = new WritableStream({ write: (bytes) => void (board.heard += new TextDecoder().decode(bytes)) });
        },
        async close() {
            if (port.readable?.locked) {
                throw new TypeError("the stream is locked");
            }
            port.readable = port.writable = null;
            board.closed++;
        },
    };
    const tell = (type) => {
        const event = new Event(type);
        Object.defineProperty(event, "target", { value: port });
        listeners[type].forEach((listener) => listener(event));
    };
    window.board = {
        opened: 0,
        closed: 0,
        heard: "",
        isGone: false,
        isBusy: false,
        refusal: null, // the name of an error
        print(text) {
            controller.enqueue(new TextEncoder().encode(text));
        },
        unplug() {
            board.isGone = true;
            const lost = new DOMException("The device has been lost.", "NetworkError");
            controller.error(lost);
            port.readable = port.writable = null;
            tell("disconnect");
        },
        plug() {
            board.isGone = false;
            tell("connect");
        },
        // A framing error: the stream ends, and there is another one.
        stumble() {
            const old = controller;
            port.readable = new ReadableStream({ start: (c) => (controller = c) });
            old.error(new DOMException("Framing error.", "FramingError"));
        },
    };
    Object.defineProperty(navigator, "serial", {
        value: {
            addEventListener: (type, listener) => listeners[type].add(listener),
            removeEventListener: (type, listener) => listeners[type].delete(listener),
            async requestPort() {
                if (board.refusal) {
                    throw new DOMException("Failed to execute 'requestPort' on 'Serial'.", board.refusal);
                }
                return port;
            },
        },
    });
}
