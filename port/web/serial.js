// SPDX-License-Identifier: MIT
//
// A board on a serial port, as a source of samples (sink.js), which resumes when the board is plugged in again.
import { Lines } from "./lines.js";
import { now, until } from "./clock.js";

const SILENCE = 3; // seconds without a line
const UNREADABLE = 20; // lines in a row that cannot be read
const START_TIME = 10; // seconds until a board prints, after its port was opened
const ANSWER_TIME = 5; // seconds until it answers

const UNSUPPORTED = "This browser cannot open serial ports. Use Chrome, Edge, Opera or a recent Firefox on a computer, or save what the board prints to a file and drop it here.";
const NOT_SECURE = "Browsers open serial ports only for pages from https or from a file. Save this page, and open the saved file.";
const ERRORS = {
    NotFoundError: "No port was chosen. If your board is not in the list, check its cable (some only charge) and its driver.",
    SecurityError: "The browser does not let this page use serial ports. Allow them in the browser's settings for this page.",
    NetworkError: "The port cannot be opened. Close other programs that use it, such as a serial monitor. On Linux your account may need permission: sudo usermod -aG dialout $USER, then log in again.",
    InvalidStateError: "The port is open already. Press Stop, wait a moment, and try again.",
};

// An error in words that help the user.
const explained = (error) => new Error(ERRORS[error.name] ?? error.message);

// The port that the user chooses. Browsers show the dialog only after a click.
export async function choosePort() {
    if (!navigator.serial) {
        throw new Error(isSecureContext ? UNSUPPORTED : NOT_SECURE);
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
        this.onDisconnect = this.onDisconnect.bind(this);
        this.onConnect = this.onConnect.bind(this);
    }

    async start() {
        await this.open();
        navigator.serial.addEventListener("disconnect", this.onDisconnect);
        navigator.serial.addEventListener("connect", this.onConnect);
        this.progress = { taken: 0, skipped: 0, at: now() };
        this.timer = setInterval(() => this.checkLines(), 500);
        return this;
    }

    // May be called more than once.
    stop() {
        this.stopped ??= this.end();
        return this.stopped;
    }

    async end() {
        clearInterval(this.timer);
        navigator.serial.removeEventListener("disconnect", this.onDisconnect);
        navigator.serial.removeEventListener("connect", this.onConnect);
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

    // A framing or overrun error ends the stream: another one follows, and samples are lost.
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

    onDisconnect({ target }) {
        if (target === this.port) {
            this.isGone = true;
            this.sink.gap();
            this.notify("The board is unplugged. Plug it in again: the positions taken are kept.");
        }
    }

    async onConnect({ target }) {
        if (target !== this.port) {
            return;
        }
        await this.close(); // it may be closed already
        try {
            await this.open();
            this.notify("The board is back: go on.");
        } catch (error) {
            this.notify(`The board is back. ${error.message}`);
        }
    }

    // Says why no line can be read; clears that message when lines arrive.
    checkLines() {
        const { taken, skipped } = this.lines;
        if (taken > this.progress.taken) {
            this.progress = { taken, skipped, at: now() };
            this.notify("");
            return;
        }
        const unread = skipped - this.progress.skipped;
        if (unread >= UNREADABLE) {
            this.notify(`Lines arrive, but none of them can be read. Is ${this.baudRate} baud right (Settings)? Does the board print x,y,z?`);
        } else if (!this.isGone && now() - this.progress.at > SILENCE) {
            this.notify(taken > 0 ? "The board has stopped printing readings. Reset it." : "Nothing arrives from the board. Is this its port, and does its program print readings?");
        }
    }

    // Only if it is new, since others may have shown a message in between.
    notify(text) {
        if (text !== (this.notice ?? "")) {
            this.notice = text;
            this.sink.notify(text);
        }
    }

    // Sends a line, and returns the board's answer, or null. Opens the port again if it was stopped: that may reset
    // the board, which receives nothing until it prints.
    async send(text) {
        const wasOpen = Boolean(this.port.writable);
        if (!wasOpen) {
            await this.open();
            const { taken } = this.lines;
            await until(() => this.lines.taken > taken, START_TIME);
        }
        this.reply = null;
        const writer = this.port.writable.getWriter();
        try {
            await writer.write(new TextEncoder().encode(text));
        } finally {
            writer.releaseLock();
        }
        await until(() => this.reply !== null, ANSWER_TIME);
        if (!wasOpen) {
            await this.close();
        }
        return this.reply;
    }
}
