// SPDX-License-Identifier: MIT
//
// A board on a serial port, as a source of samples (sink.js). It resumes when the board is plugged in again.
import { Lines } from "./lines.js";
import { now, until } from "./clock.js";

const PATIENCE = 3; // seconds without a line
const GARBAGE = 20; // lines, none of which can be read
const WAKE = 10; // seconds that a board may take to start, once its port is opened
const ANSWER = 5; // seconds until it answers

const NONE = "This browser cannot open serial ports. Use Chrome, Edge, Opera or a recent Firefox on a computer, or save what the board prints to a file and drop it here.";
const NOT_SECURE = "Browsers open serial ports only for pages from https or from a file. Save this page, and open the saved file.";
const WHY = {
    NotFoundError: "No port was chosen. If your board is not in the list, check its cable (some only charge) and its driver.",
    SecurityError: "The browser does not let this page use serial ports. Allow them in the browser's settings for this page.",
    NetworkError: "The port cannot be opened. Close other programs that use it, such as a serial monitor. On Linux your account may need permission: sudo usermod -aG dialout $USER, then log in again.",
    InvalidStateError: "The port is open already. Press Stop, wait a moment, and try again.",
};

// What an error means to the user.
const explained = (error) => new Error(WHY[error.name] ?? error.message);

// The port that the user chooses. Browsers show the dialog only after a click.
export async function choosePort() {
    if (!navigator.serial) {
        throw new Error(isSecureContext ? NONE : NOT_SECURE);
    }
    return navigator.serial.requestPort().catch((error) => {
        throw explained(error);
    });
}

export class Board {
    constructor(port, sink, baudRate) {
        this.port = port;
        this.sink = sink;
        this.baudRate = baudRate;
        this.reply = null;
        this.lines = new Lines({
            isTorn: true,
            onText: (text) => (this.reply = text),
            onSample: (sample) => sink.sample(sample, now()),
        });
        this.isOpen = false;
        this.lost = this.lost.bind(this);
        this.back = this.back.bind(this);
    }

    async start() {
        await this.open();
        navigator.serial.addEventListener("disconnect", this.lost);
        navigator.serial.addEventListener("connect", this.back);
        this.heard = { taken: 0, skipped: 0, at: now() };
        this.watching = setInterval(() => this.watch(), 500);
        return this;
    }

    // May be called more than once.
    stop() {
        this.stopped ??= this.end();
        return this.stopped;
    }

    async end() {
        clearInterval(this.watching);
        navigator.serial.removeEventListener("disconnect", this.lost);
        navigator.serial.removeEventListener("connect", this.back);
        await this.close();
    }

    async open() {
        await this.port.open({ baudRate: this.baudRate, bufferSize: 65536 }).catch((error) => {
            throw explained(error);
        });
        this.isOpen = true;
        this.isGone = false;
        this.lines.tear();
        this.reading = this.read();
    }

    async close() {
        this.isOpen = false;
        await this.reader?.cancel().catch(() => {}); // the port may be gone
        await this.reading; // then its lock is released
        await this.port.close().catch(() => {});
    }

    // After a framing or an overrun error there is another stream, and samples are lost.
    async read() {
        const decoder = new TextDecoder();
        while (this.port.readable && this.isOpen) {
            this.reader = this.port.readable.getReader();
            try {
                await this.readStream(decoder);
            } catch {
                this.sink.gap();
                this.lines.tear();
            } finally {
                this.reader.releaseLock();
                this.reader = null;
            }
        }
    }

    async readStream(decoder) {
        for (;;) {
            const { value, done } = await this.reader.read();
            if (done) {
                return;
            }
            this.lines.push(decoder.decode(value, { stream: true }));
        }
    }

    lost({ target }) {
        if (target === this.port) {
            this.isGone = true;
            this.sink.gap();
            this.tell("The board is unplugged. Plug it in again: the positions taken are kept.");
        }
    }

    async back({ target }) {
        if (target !== this.port) {
            return;
        }
        await this.close(); // it may be closed already
        try {
            await this.open();
            this.tell("The board is back: go on.");
        } catch (error) {
            this.tell(`The board is back. ${error.message}`);
        }
    }

    // Says why no line can be read, and clears that once lines come.
    watch() {
        const { taken, skipped } = this.lines;
        if (taken > this.heard.taken) {
            this.heard = { taken, skipped, at: now() };
            this.tell("");
            return;
        }
        const unread = skipped - this.heard.skipped;
        if (unread >= GARBAGE) {
            this.tell(`Lines arrive, but none of them can be read. Is ${this.baudRate} baud right (Settings)? Does the board print x,y,z?`);
        } else if (!this.isGone && now() - this.heard.at > PATIENCE) {
            this.tell(taken > 0 ? "The board has stopped printing readings. Reset it." : "Nothing arrives from the board. Is this its port, and does its program print readings?");
        }
    }

    // Only if it is new: others may have shown a text in between.
    tell(text) {
        if (text !== (this.told ?? "")) {
            this.told = text;
            this.sink.tell(text);
        }
    }

    // Sends a line, and returns the board's answer, or null. Opens a port that was stopped: the board may restart
    // then, and hears nothing until it prints.
    async send(text) {
        const wasOpen = Boolean(this.port.writable);
        if (!wasOpen) {
            await this.open();
            const { taken } = this.lines;
            await until(() => this.lines.taken > taken, WAKE);
        }
        this.reply = null;
        const writer = this.port.writable.getWriter();
        try {
            await writer.write(new TextEncoder().encode(text));
        } finally {
            writer.releaseLock();
        }
        await until(() => this.reply !== null, ANSWER);
        if (!wasOpen) {
            await this.close();
        }
        return this.reply;
    }
}
