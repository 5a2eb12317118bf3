// SPDX-License-Identifier: MIT
//
// A live calibration: samples in, what is known so far out. It begins by a second of listening, in which rate and
// unit of the readings show.
import { Log } from "./log.js";
import { statedUnit, stepOf, toolOptions, unitOf } from "./units.js";

const EVENTS = ["", "moving", "settling", "ready", "taken", "refused"];
const LISTEN = 1; // seconds

const length = (v) => Math.hypot(...v);

// Degrees a second that a reading of a gyro is, if its unit is known.
const GYRO_UNITS = { "°/s": 1, "rad/s": 180 / Math.PI };

// The mean of a gyro in the rests: its bias. Each rest is one reading of it.
class GyroBias {
    constructor(late) {
        this.late = late; // samples at the end of a rest that may be motion already
        this.rests = [];
        this.clear();
    }

    clear() {
        this.sum = [0, 0, 0];
        this.n = 0;
        this.held = [];
    }

    add(rate) {
        this.held.push(rate);
        if (this.held.length > this.late) {
            this.held.shift().forEach((v, i) => (this.sum[i] += v));
            this.n++;
        }
    }

    take() {
        if (this.n > 0) {
            this.rests.push(this.sum.map((s) => s / this.n));
        }
        this.clear();
    }

    // { mean, sigma } by the scatter between rests, sigma of the worst axis; null before the third.
    result() {
        const n = this.rests.length;
        if (n < 3) {
            return null;
        }
        const mean = [0, 1, 2].map((i) => this.rests.reduce((s, r) => s + r[i], 0) / n);
        const variance = mean.map((m, i) => this.rests.reduce((s, r) => s + (r[i] - m) ** 2, 0) / (n - 1) / n);
        return { mean, sigma: Math.sqrt(Math.max(...variance)) };
    }
}

export class Session {
    // live: the instance. options: { rate, unit, target: [over field, 1, rad], rounds: the source may round }
    constructor(live, options, onEvent) {
        this.live = live;
        this.options = options;
        this.onEvent = onEvent;
        this.first = []; // samples until it begins
        this.log = new Log();
        this.unit = null;
        this.samples = 0;
        this.up = [0, 0, 1];
        this.positions = [];
        this.gains = null; // sigma of a length in each direction of the picture; the page asks for it
        this.refused = [];
        this.state = "listening";
        this.gyro = new GyroBias(0);
        this.gyroUnit = null; // degrees a second, if that is known
        this.result = null;
        this.step = 0;
        this.began = null;
    }

    // A sample, and when it came, seconds.
    add(sample, seconds) {
        this.began ??= seconds;
        this.seconds = seconds;
        if (this.unit) {
            this.feed(sample);
            return;
        }
        this.first.push(sample);
        const passed = seconds - this.began;
        const isEnough = this.options.rate ? this.first.length >= this.options.rate * LISTEN : passed >= LISTEN;
        if (isEnough && this.first.length >= 8) {
            this.begin(this.options.rate || (this.first.length - 1) / passed);
        }
    }

    begin(rate) {
        const isWhole = this.first.every(({ acc }) => acc.every(Number.isInteger));
        const lengths = this.first.map(({ acc }) => length(acc));
        const stated = this.options.unit || (this.first[0].raw ? "8192" : "");
        this.unit = stated ? statedUnit(stated, isWhole) : unitOf(lengths, isWhole);
        this.rate = rate;
        this.gyro = new GyroBias(Math.ceil(rate / 4));
        const gyro = this.first[0].raw ? "16" : this.options.gyro;
        this.gyroUnit = gyro ? (GYRO_UNITS[gyro] ?? 1 / Number(gyro)) : null;
        const status = this.live.begin(this.unit.counts, Math.round(rate));
        if (status !== 0) {
            this.state = "failed";
            throw new Error(`${this.text(this.live.status_text(status))}: ${rate.toFixed(1)} readings per second, 1 g = ${(this.unit.counts / this.unit.factor).toPrecision(3)}`);
        }
        if (this.options.rounds) {
            this.step = stepOf(this.first);
        }
        this.state = "moving";
        this.guide();
        for (const sample of this.first.splice(0)) {
            this.feed(sample);
        }
    }

    feed(sample) {
        const { factor } = this.unit;
        const [x, y, z] = sample.acc;
        const l = length(sample.acc) || 1;
        const fade = Math.min(1, 12 / this.rate);
        sample.acc.forEach((v, i) => (this.up[i] += fade * (v / l - this.up[i])));
        this.samples++;
        this.log.add(sample);
        const event = this.live.feed(Math.round(x * factor), Math.round(y * factor), Math.round(z * factor));
        if (event !== 0) {
            this.happened(EVENTS[event]);
        }
        if (sample.gyro && (this.state === "settling" || this.state === "ready")) {
            this.gyro.add(sample.gyro);
        }
    }

    happened(name) {
        const before = this.state;
        this.state = name;
        if (name === "settling" && before !== "ready" && this.live.progress() < 20) {
            this.gyro.clear(); // another rest
        }
        if (name === "taken") {
            this.gyro.take();
            this.taken();
        } else if (name === "refused") {
            this.gyro.clear();
            this.refused.push(this.text(this.live.why()));
        } else if (name === "ready" && before !== "ready") {
            this.guide();
        }
        if (name !== before || name === "taken" || name === "refused") {
            this.onEvent(name);
        }
    }

    taken() {
        const n = this.live.count();
        this.positions = [];
        for (let i = 0; i < n; i++) {
            this.live.position(i);
            this.positions.push(this.numbers(3));
        }
        this.guide();
        this.solve();
    }

    guide() {
        this.words = this.text(this.live.next());
        this.next = this.numbers(3);
    }

    // Sigmas are those that cover 95 %.
    solve() {
        const status = this.live.solve(this.unit.factor);
        if (status !== 0) {
            this.result = { status, text: this.text(this.live.status_text(status)) };
            return;
        }
        const v = this.numbers(29);
        const worst = (from) => v[21] * Math.max(...v.slice(from, from + 3));
        const sigma = [worst(12), worst(15), worst(18)];
        const isGood = v[28] === 1;
        const isReached = sigma.every((s, i) => s <= this.options.target[i]);
        const record = new Uint8Array(this.live.memory.buffer, this.live.record_buffer(), 136).slice();
        this.result = {
            status: 0,
            offset: v.slice(0, 3),
            matrix: [v.slice(3, 6), v.slice(6, 9), v.slice(9, 12)],
            sigma,
            verdict: this.text(this.live.verdict_text(v[22])),
            leftOut: v[23],
            rms: v[24],
            isGood,
            isReached,
            mayStop: isGood && isReached,
            record,
        };
    }

    // Samples were lost.
    gap() {
        if (this.unit) {
            this.live.gap();
            this.log.gap();
        }
    }

    // The stream ends: a rest that goes on counts.
    finish() {
        if (this.unit) {
            this.happened(EVENTS[this.live.finish()]);
        }
        this.state = "ended";
    }

    progress() {
        return this.unit && (this.state === "settling" || this.state === "ready") ? this.live.progress() : 0;
    }

    // May it be moved on? The event is told once, and the rest goes on.
    isReady() {
        return this.progress() === 100;
    }

    // sigma of a length in each direction, over that of a position.
    uncertainty(directions) {
        const buffer = new Float64Array(this.live.memory.buffer, this.live.direction_buffer(), 3 * directions.length);
        directions.forEach((d, i) => buffer.set(d, 3 * i));
        this.live.uncertainty(directions.length);
        return directions.map((d, i) => buffer[3 * i]);
    }

    csv() {
        return this.log.csv(this.rate);
    }

    // What the tool has to be told of it.
    toolOptions() {
        return toolOptions(this.unit);
    }

    get hasGyro() {
        return this.log.hasGyro;
    }

    numbers(n) {
        return [...new Float64Array(this.live.memory.buffer, this.live.results(), n)];
    }

    text(at) {
        const bytes = new Uint8Array(this.live.memory.buffer, at, 200);
        return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
    }
}
