// SPDX-License-Identifier: MIT
//
// Lines that boards print, as samples. Understood are
//
//     x,y,z                        separated by commas, semicolons, blanks or tabs,
//     t,x,y,z   x,y,z,gx,gy,gz     with time before, a gyro behind, then a magnetometer,
//     ax:1 ay:2 az:3               with names, as for Arduino's plotter,
//     Raw:ax,ay,az,gx,gy,gz,mx,my,mz    what MotionCal and Adafruit's sketches print.

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const LONGEST = 512; // characters; what is longer is no line of numbers
const AGREED = 3; // lines

// How many columns there are -> where time (-1: there is none), the accelerometer, the gyro (-1) stand.
const LAYOUT = { 3: [-1, 0, -1], 4: [0, 1, -1], 5: [0, 1, -1], 6: [-1, 0, 3], 7: [0, 1, 4], 9: [-1, 0, 3], 10: [0, 1, 4] };

// A line -> { columns, raw, time, acc, gyro }; "other" if it is not meant to be a sample; null if it is broken.
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

// A stream of text in pieces, taken apart. What the first lines agree upon, all have to have: a line that was torn
// in two may look like a sample of fewer columns.
export class Lines {
    constructor({ isTorn = false, onSample, onText = () => {} }) {
        this.rest = "";
        this.isTorn = isTorn; // the first line began before we listened
        this.onSample = onSample;
        this.onText = onText;
        this.skipped = 0;
        this.taken = 0;
        this.layout = null; // columns
        this.waiting = []; // samples of which the columns are not agreed upon
    }

    push(text) {
        const lines = (this.rest + text).split(/\r\n|\n|\r/);
        this.rest = lines.pop();
        if (this.rest.length > LONGEST) {
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

    // The stream was interrupted: what comes next begins in the middle of a line.
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
        const sample = line.length > LONGEST ? null : parseLine(line);
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

    // The columns are those that three lines have first; what came before waits for that.
    agree(sample) {
        this.waiting.push(sample);
        if (this.waiting.filter(({ columns }) => columns === sample.columns).length < AGREED) {
            return;
        }
        this.layout = sample.columns;
        for (const early of this.waiting.splice(0)) {
            early.columns === this.layout ? this.take(early) : this.skipped++;
        }
    }
}
