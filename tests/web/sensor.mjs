// SPDX-License-Identifier: MIT
//
// A sensor on a bench, for logs and for boards: rests with given readings, and turns between them.

// xorshift32, and a sum of twelve, which is close enough to normal.
export function noise(seed = 1) {
    let state = seed;
    const uniform = () => {
        state ^= state << 13;
        state ^= state >>> 17;
        state ^= state << 5;
        return (state >>> 0) / 4294967296;
    };
    return () => {
        let sum = -6;
        for (let i = 0; i < 12; i++) {
            sum += uniform();
        }
        return sum;
    };
}

export const unit = (v) => v.map((x) => x / Math.hypot(...v));

// The 18 edges and faces of a cube.
export const DIRECTIONS = [];
for (const x of [-1, 0, 1]) {
    for (const y of [-1, 0, 1]) {
        for (const z of [-1, 0, 1]) {
            const axes = x * x + y * y + z * z;
            if (axes === 1 || axes === 2) {
                DIRECTIONS.push(unit([x, y, z]));
            }
        }
    }
}

// The sensor's errors; readings are counts. calibrated = (1/scale) (reading - offset): no cross terms.
export const SENSOR = { offset: [150, -320, 410], scale: [16600, 16250, 16420] };
export const reads = (up) => up.map((u, i) => SENSOR.offset[i] + SENSOR.scale[i] * u);

// Samples of rests in these readings, `rest` and `turn` samples each.
export function* samples(readings, { rest = 300, turn = 100, sigma = 10, seed = 1 } = {}) {
    const chance = noise(seed);
    for (let k = 0; k < readings.length; k++) {
        for (let i = 0; i < rest; i++) {
            yield readings[k].map((v) => v + sigma * chance());
        }
        const next = readings[k + 1];
        for (let i = 0; next && i < turn; i++) {
            const share = i / turn;
            yield readings[k].map((v, a) => v * (1 - share) + next[a] * share + 15 * sigma * chance());
        }
    }
}
