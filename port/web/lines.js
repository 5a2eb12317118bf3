// SPDX-License-Identifier: MIT
//
// Parses lines that boards print:
//
//     x,y,z                        separated by commas, semicolons, blanks or tabs,
//     t,x,y,z   x,y,z,gx,gy,gz     with time first, then a gyro, then a magnetometer,
//     ax:1 ay:2 az:3               with names, as for Arduino's plotter,
//     Raw:ax,ay,az,gx,gy,gz,mx,my,mz    as printed by MotionCal and Adafruit's sketches.

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const MAX_LENGTH = 512; // characters of a line
const AGREEING_LINES = 3; // with the same number of columns

// Number of columns -> first column of time, accelerometer, gyro; -1: none.
const LAYOUT = { 3: [-1, 0, -1], 4: [0, 1, -1], 5: [0, 1, -1], 6: [-1, 0, 3], 7: [0, 1, 4], 9: [-1, 0, 3], 10: [0, 1, 4] };

// A line -> { columns, raw, time, acc, gyro }; "other" if it is not a sample; null if it is malformed.
function parseLine(line) {
    let text = line.trim();
    if (text === "" || /^(#|%|\/\/|Uni:|Ori:|Cal)/.test(text)) {
        return "other";
    }
    const raw = text.startsWith("Raw:");
    text = raw ? text.slice(4) : text.replace(/[a-z_]\w*\s*[:=]/gi, " ");
    const fields = text.split(/[\s,;]+/).filter((field) => field !== "");
    if (!fields.every((field) => NUMBER.test(field))) {
        return /^[a-z]{3}/i.test(line) && !raw ? "other" : null; // words, or a torn line
    }
    const values = fields.map(Number);
    const layout = LAYOUT[values.length];
    if (!layout || !values.every(Number.isFinite) || (raw && values.length !== 9)) {
        return null;
    }
    const [time, acc, gyro] = layout;
    return {
        columns: raw ? "Raw" : values.length,
        raw,
        time: time < 0 ? null : values[time],
        acc: values.slice(acc, acc + 3),
        gyro: gyro < 0 ? null : values.slice(gyro, gyro + 3),
    };
}

// Splits a stream of text into samples. The first lines determine the number of columns, since a line that was torn
// in two may look like a sample of fewer columns.
export class Lines {
    constructor({ isTorn = false, onSample, onText = () => {} }) {
        this.rest = "";
        this.isTorn = isTorn; // the beginning of the next line is lost
        this.onSample = onSample;
        this.onText = onText;
        this.skipped = 0;
        this.taken = 0;
        this.layout = null; // columns
        this.waiting = []; // samples before the number of columns is known
    }

    push(text) {
        const lines = (this.rest + text).split(/\r\n|\n|\r/);
        this.rest = lines.pop();
        if (this.rest.length > MAX_LENGTH) {
            this.rest = "";
            this.isTorn = true;
            this.skipped++;
        }
        for (const line of lines) {
            this.line(line);
        }
    }

    end() {
        if (this.rest !== "") {
            this.line(this.rest);
        }
        this.rest = "";
        this.skipped += this.waiting.splice(0).length;
    }

    // The stream was interrupted: it continues in the middle of a line.
    tear() {
        this.rest = "";
        this.isTorn = true;
    }

    line(line) {
        if (this.isTorn) {
            this.isTorn = false;
            return;
        }
        if (line.startsWith("invcal")) {
            this.onText(line.trim());
            return;
        }
        const sample = line.length > MAX_LENGTH ? null : parseLine(line);
        if (sample === "other") {
            return;
        }
        if (!sample || (this.layout !== null && sample.columns !== this.layout)) {
            this.skipped++;
        } else if (this.layout === null) {
            this.agree(sample);
        } else {
            this.take(sample);
        }
    }

    take(sample) {
        this.taken++;
        this.onSample(sample);
    }

    // The first number of columns that three lines have; until then, samples wait.
    agree(sample) {
        this.waiting.push(sample);
        if (this.waiting.filter(({ columns }) => columns === sample.columns).length < AGREEING_LINES) {
            return;
        }
        this.layout = sample.columns;
        for (const early of this.waiting.splice(0)) {
            early.columns === this.layout ? this.take(early) : this.skipped++;
        }
    }
}
