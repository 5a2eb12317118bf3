// SPDX-License-Identifier: MIT
//
// All samples of a live calibration, for the report at the end: an hour at 1,000 per second takes 170 MB.

const COLUMNS = 6; // accelerometer, gyro

export class Log {
    constructor() {
        this.values = new Float64Array(COLUMNS * 4096);
        this.rows = 0;
        this.gaps = 0;
        this.hasGyro = false;
        this.endsWithGap = false; // the last row is a gap
    }

    row(values) {
        const at = COLUMNS * this.rows++;
        if (at === this.values.length) {
            const more = new Float64Array(2 * at);
            more.set(this.values);
            this.values = more;
        }
        this.values.set(values, at);
    }

    add({ acc, gyro }) {
        this.endsWithGap = false;
        this.hasGyro ||= Boolean(gyro);
        this.row([...acc, ...(gyro ?? [0, 0, 0])]);
    }

    // Samples were lost: a row of NaN.
    gap() {
        if (!this.endsWithGap) {
            this.endsWithGap = true;
            this.gaps++;
            this.row(new Array(COLUMNS).fill(NaN));
        }
    }

    // A file of t, x, y, z and, if there is one, the gyro. A gap is one second.
    csv(rate) {
        const columns = this.hasGyro ? 6 : 3;
        const parts = [this.hasGyro ? "t,x,y,z,gx,gy,gz\n" : "t,x,y,z\n"];
        let text = "";
        let gaps = 0;
        for (let i = 0, n = 0; i < this.rows; i++) {
            const row = this.values.subarray(COLUMNS * i, COLUMNS * i + columns);
            if (Number.isNaN(row[0])) {
                gaps++;
                continue;
            }
            text += `${(n++ / rate + gaps).toFixed(5)},${row.join(",")}\n`;
            if (text.length > 1 << 20) {
                parts.push(text);
                text = "";
            }
        }
        return new Blob([...parts, text], { type: "text/csv" });
    }
}
