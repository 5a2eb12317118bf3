// SPDX-License-Identifier: MIT
//
// A simulated sensor that is turned as instructed, as a source of samples (sink.js).
import { now } from "./clock.js";

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (v) => v.map((x) => x / Math.hypot(...v));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

// xorshift32: reproducible.
function random(seed) {
    let state = seed;
    const uniform = () => {
        state ^= state << 13;
        state ^= state >>> 17;
        state ^= state << 5;
        return (state >>> 0) / 4294967296;
    };
    return { uniform, normal: () => Math.sqrt(-2 * Math.log(1 - uniform())) * Math.cos(2 * Math.PI * uniform()) };
}

// The errors of the simulated sensor, in counts: 16384 per g, and 1/16 degree per second.
const TRUTH = {
    offset: [327.7, -245.8, 491.5],
    matrix: [
        [1.01, 0.005, -0.003],
        [0.005, 0.992, 0.004],
        [-0.003, 0.004, 1.012],
    ],
    gyro: [12, -7, 3],
    gyroMatrix: [
        [1.02, 0.01, 0],
        [0, 0.985, -0.01],
        [0.005, 0, 1.01],
    ],
};
const RATE = 100;
const REST = 3; // seconds
const TURN = 1.5;

class Hand {
    constructor(sink, nextDirection, seed) {
        this.sink = sink;
        this.nextDirection = nextDirection;
        this.random = random(seed);
        this.from = this.to = this.last = [0, 0, 1];
        this.phase = 0; // seconds in this rest and the turn after it
        this.n = 0; // samples
    }

    read(up, isTurning) {
        const { normal } = this.random;
        const acc = TRUTH.matrix.map((row, i) => Math.round(16384 * dot(row, up) + TRUTH.offset[i] + normal() * (isTurning ? 150 : 12)));
        // The shortest turn from the up direction of the last sample to this one: w = du/dt x u, 1/16 degree per second.
        const turn = cross(up, this.last).map((x) => (x * RATE * 16 * 180) / Math.PI);
        const gyro = TRUTH.gyroMatrix.map((row, i) => Math.round(dot(row, turn) + TRUTH.gyro[i] + normal() * 2));
        this.last = up;
        this.sink.sample({ columns: 6, time: null, acc, gyro }, this.n / RATE);
        this.n++;
    }

    step() {
        this.phase += 1 / RATE;
        if (this.phase >= REST + TURN) {
            this.from = this.to;
            this.phase = 0;
        }
        if (this.phase < REST) {
            this.read(this.from, false);
            return;
        }
        if (this.from === this.to) {
            this.to = unit(this.nextDirection().map((v) => v + 0.06 * this.random.normal())); // some degrees off
        }
        this.read(this.between((this.phase - REST) / TURN), true);
    }

    between(share) {
        const { from, to } = this;
        const smooth = share * share * (3 - 2 * share);
        const detour = dot(from, to) < -0.9 ? Math.sin(Math.PI * smooth) : 0; // nearly opposite directions have no shortest path
        return unit(from.map((v, i) => v * (1 - smooth) + to[i] * smooth + detour * [from[1], -from[0], 0.5][i]));
    }
}

// nextDirection: returns the requested direction.
export function simulator(sink, { speed, nextDirection, seed = 1 }) {
    const hand = new Hand(sink, nextDirection, seed);
    let last = now();
    const timer = setInterval(() => {
        const passed = Math.min(0.1, now() - last);
        last = now();
        for (let i = 0; i < passed * speed * RATE; i++) {
            hand.step();
        }
    }, 15);
    return {
        stop() {
            clearInterval(timer);
        },
    };
}
