// SPDX-License-Identifier: MIT
//
// A live calibration: takes samples, and gives the result so far. The first second of samples shows the rate and the
// unit of the readings.
import { Log } from "./log.js";
import { statedUnit, stepOf, toolOptions, unitOf } from "./units.js";

const EVENTS = ["", "moving", "settling", "ready", "taken", "refused"];
const DETECTION_TIME = 1; // seconds

const length = (v) => Math.hypot(...v);

// Degrees per second per unit.
const GYRO_UNITS = { "°/s": 1, "rad/s": 180 / Math.PI };

// The bias of a gyro: the mean of its means in the rests.
class GyroBias {
    constructor(discard) {
        this.discard = discard; // samples at the end of a rest, which may be motion already
        this.rests = [];
        this.clear();
    }

    clear() {
        this.sum = [0, 0, 0];
        this.n = 0;
        this.recent = [];
    }

    add(rate) {
        this.recent.push(rate);
        if (this.recent.length > this.discard) {
            this.recent.shift().forEach((v, i) => (this.sum[i] += v));
            this.n++;
        }
    }

    take() {
        if (this.n > 0) {
            this.rests.push(this.sum.map((s) => s / this.n));
        }
        this.clear();
    }

    // { mean, sigma }, sigma from the scatter between rests, for the worst axis; null before the third rest.
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
    // live: the WebAssembly instance. options: { rate, unit, gyro, target: [over the field, 1, rad], rounds: the
    // source may round }
    constructor(live, options, onEvent) {
        this.live = live;
        this.options = options;
        this.onEvent = onEvent;
        this.pending = []; // samples before rate and unit are known
        this.log = new Log();
        this.unit = null;
        this.samples = 0;
        this.up = [0, 0, 1];
        this.positions = [];
        this.sigmas = null; // of a length in each direction of the picture; set by the page
        this.refused = [];
        this.state = "listening";
        this.gyro = new GyroBias(0);
        this.gyroUnit = null; // degrees per second, if known
        this.result = null;
        this.step = 0;
        this.began = null;
    }

    // A sample, and its time of arrival, seconds.
    add(sample, seconds) {
        this.began ??= seconds;
        this.seconds = seconds;
        if (this.unit) {
            this.feed(sample);
            return;
        }
        this.pending.push(sample);
        const passed = seconds - this.began;
        const isLongEnough = this.options.rate ? this.pending.length >= this.options.rate * DETECTION_TIME : passed >= DETECTION_TIME;
        if (isLongEnough && this.pending.length >= 8) {
            this.begin(this.options.rate || (this.pending.length - 1) / passed);
        }
    }

    begin(rate) {
        const isWhole = this.pending.every(({ acc }) => acc.every(Number.isInteger));
        const lengths = this.pending.map(({ acc }) => length(acc));
        const stated = this.options.unit || (this.pending[0].raw ? "8192" : "");
        this.unit = stated ? statedUnit(stated, isWhole) : unitOf(lengths, isWhole);
        this.rate = rate;
        this.gyro = new GyroBias(Math.ceil(rate / 4));
        const gyro = this.pending[0].raw ? "16" : this.options.gyro;
        this.gyroUnit = gyro ? (GYRO_UNITS[gyro] ?? 1 / Number(gyro)) : null;
        const status = this.live.begin(this.unit.counts, Math.round(rate));
        if (status !== 0) {
            this.state = "failed";
            throw new Error(`${this.text(this.live.status_text(status))}: ${rate.toFixed(1)} readings per second, 1 g = ${(this.unit.counts / this.unit.factor).toPrecision(3)}`);
        }
        if (this.options.rounds) {
            this.step = stepOf(this.pending);
        }
        this.state = "moving";
        this.guide();
        for (const sample of this.pending.splice(0)) {
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
            this.handleEvent(EVENTS[event]);
        }
        if (sample.gyro && (this.state === "settling" || this.state === "ready")) {
            this.gyro.add(sample.gyro);
        }
    }

    handleEvent(name) {
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

    // sigma is multiplied by the coverage factor for 95 %.
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

    // The stream ends: the current rest counts.
    finish() {
        if (this.unit) {
            this.handleEvent(EVENTS[this.live.finish()]);
        }
        this.state = "ended";
    }

    progress() {
        return this.unit && (this.state === "settling" || this.state === "ready") ? this.live.progress() : 0;
    }

    // True from the event "ready" until the end of the rest.
    isReady() {
        return this.progress() === 100;
    }

    // Sigma of a length in each direction, over that of a position.
    uncertainty(directions) {
        const buffer = new Float64Array(this.live.memory.buffer, this.live.direction_buffer(), 3 * directions.length);
        directions.forEach((d, i) => buffer.set(d, 3 * i));
        this.live.uncertainty(directions.length);
        return directions.map((d, i) => buffer[3 * i]);
    }

    csv() {
        return this.log.csv(this.rate);
    }

    // Options of the tool for its log.
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
