// SPDX-License-Identifier: MIT
//
// Replays a log, as a source of samples (sink.js).
import { Lines } from "./lines.js";
import { now, pause } from "./clock.js";

const SLICE = 0.012; // seconds, after which the page is updated
const MAX_STEP = 5; // seconds; a longer step between two lines is a gap in the log

class Replay {
    constructor(sink, file, speed, rate) {
        this.sink = sink;
        this.speed = speed;
        this.rate = rate;
        this.rows = [];
        this.lines = new Lines({ onSample: (sample) => this.rows.push(sample) });
        this.reader = file.stream().getReader();
        this.decoder = new TextDecoder();
        this.hasMore = true;
        this.isStopped = false;
        this.time = 0; // seconds in the log
        this.lastTime = null; // the time in the last line
    }

    async read() {
        const { value, done } = await this.reader.read();
        if (done) {
            this.lines.end();
            this.hasMore = false;
        } else {
            this.lines.push(this.decoder.decode(value, { stream: true }));
        }
    }

    feed(sample) {
        const step = sample.time !== null && this.lastTime !== null ? sample.time - this.lastTime : 1 / this.rate;
        this.lastTime = sample.time;
        this.time += step > 0 && step < MAX_STEP ? step : 1 / this.rate;
        this.sink.sample(sample, this.time);
    }

    // Delivers the samples that are due, at most for one SLICE; returns whether there were any.
    feedDue(due) {
        const began = now();
        let n = 0;
        while (n < this.rows.length && now() - began < SLICE && this.time <= due) {
            this.feed(this.rows[n++]);
        }
        this.rows.splice(0, n);
        return n > 0;
    }

    async play() {
        const began = now();
        while (!this.isStopped && (this.hasMore || this.rows.length > 0)) {
            while (this.hasMore && this.rows.length === 0) {
                await this.read();
            }
            const isBusy = this.feedDue((now() - began) * this.speed);
            await pause(isBusy && this.speed === Infinity ? 0 : 8);
        }
        await this.reader.cancel();
        if (!this.isStopped) {
            this.sink.end(this.lines);
        }
    }

    stop() {
        this.isStopped = true;
    }
}

// speed: 1 as recorded, 10 ten times as fast, Infinity as fast as possible. rate: for a log without time.
export function replay(sink, file, { speed, rate }) {
    const source = new Replay(sink, file, speed, rate);
    source.play().catch((error) => sink.notify(`${file.name} cannot be read: ${error.message}`));
    return source;
}
