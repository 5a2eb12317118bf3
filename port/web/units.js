// SPDX-License-Identifier: MIT
//
// The unit of readings, and the step that they are rounded to.

const G = 9.80665;

// Units of readings, by the length of 1 g. Values that are not whole counts are multiplied by `factor`, so no digit is
// lost.
const UNITS = {
    g: { length: 1, factor: 65536, tool: ["--unit", "g"] },
    mg: { length: 1000, factor: 64, tool: ["--unit", "mg"] },
    "m/s²": { length: G, factor: 8192, tool: ["--unit", "m/s2"] },
};

// Counts per g in data sheets.
const COUNTS = [16384, 8192, 4096, 2048, 1024, 512, 256, 128, 64];

const near = (a, b) => Math.abs(a / b - 1) < 0.12;
const median = (v) => [...v].sort((a, b) => a - b)[v.length >> 1];

// The unit that fits the lengths of readings: { name, counts, factor }, counts for 1 g after multiplication by factor.
export function unitOf(lengths, isWhole) {
    const middle = median(lengths);
    for (const [name, unit] of Object.entries(UNITS)) {
        if (near(middle, unit.length) && !(isWhole && name === "g")) {
            return { name, counts: unit.length * unit.factor, factor: unit.factor };
        }
    }
    const best = COUNTS.filter((c) => near(middle, c)).sort((a, b) => Math.abs(middle / a - 1) - Math.abs(middle / b - 1))[0];
    return statedUnit(best ?? Number(middle.toPrecision(2)), isWhole);
}

// Counts per g as stated, or the name of a unit.
export function statedUnit(unit, isWhole = true) {
    if (UNITS[unit]) {
        return { name: unit, counts: UNITS[unit].length * UNITS[unit].factor, factor: UNITS[unit].factor };
    }
    const counts = Number(unit);
    const factor = isWhole ? 1 : 2 ** Math.max(0, Math.ceil(Math.log2(16384 / counts)));
    return { name: `${counts} counts/g`, counts: counts * factor, factor };
}

// The smallest change between readings, the step that a browser rounds to; 0 if there is none.
export function stepOf(rows) {
    let step = Infinity;
    for (let i = 1; i < rows.length; i++) {
        for (let k = 0; k < 3; k++) {
            const change = Math.abs(rows[i].acc[k] - rows[i - 1].acc[k]);
            step = change > 1e-9 ? Math.min(step, change) : step;
        }
    }
    return Number.isFinite(step) ? step : 0;
}

// The tool's options for a unit.
export function toolOptions({ name, counts, factor }) {
    return UNITS[name]?.tool ?? ["--zero", "0,0,0", "--lsb", String(Number(((G / counts) * factor).toPrecision(12)))];
}
