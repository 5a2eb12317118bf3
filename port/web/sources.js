// SPDX-License-Identifier: MIT
//
// Where samples come from. Each source is a function of a sink,
//
//     sink.sample(sample, seconds)   one sample (lines.js), and when it came
//     sink.gap()                     samples were lost
//     sink.tell(text)                what the person should know
//     sink.end()                     there are no more
//
// and gives { stop, ... } at once or as a promise.
import { Lines } from "./lines.js";

const now = () => performance.now() / 1000;

// ---- a serial port -------------------------------------------------------------------------------

const PATIENCE = 3; // seconds without a line that can be read

// Opens the port that the person chooses. Unplugged and plugged in again it goes on.
export async function serial(sink, { baudRate, onReply = () => {} }) {
    const port = await navigator.serial.requestPort();
    const lines = new Lines({ isTorn: true, onText: onReply, onSample: (sample) => sink.sample(sample, now()) });
    let isStopped = false;
    let reader = null;
    let reading = null; // the promise of read()

    const read = async () => {
        const decoder = new TextDecoder();
        while (port.readable && !isStopped) {
            reader = port.readable.getReader();
            try {
                for (;;) {
                    const { value, done } = await reader.read();
                    if (done) {
                        break;
                    }
                    lines.push(decoder.decode(value, { stream: true }));
                }
            } catch (error) {
                // A framing or an overrun error: the stream is there again, and samples are lost.
                sink.gap();
                lines.tear();
            } finally {
                reader.releaseLock();
                reader = null;
            }
        }
    };
    const open = async () => {
        await port.open({ baudRate, bufferSize: 65536 });
        lines.tear();
        reading = read();
    };
    const lost = (event) => {
        if (event.target === port && !isStopped) {
            sink.gap();
            sink.tell("The board is gone: plug it in again. What has been taken is kept.");
        }
    };
    const back = async (event) => {
        if (event.target === port && !isStopped) {
            await port.close().catch(() => {}); // it may be closed already
            await open().then(() => sink.tell("The board is back: go on."), (error) => sink.tell(`The board is back, but its port does not open: ${error.message}`));
        }
    };

    await open();
    navigator.serial.addEventListener("disconnect", lost);
    navigator.serial.addEventListener("connect", back);

    let heard = 0;
    const watch = setInterval(() => {
        if (lines.taken === heard && lines.taken === 0) {
            sink.tell(lines.skipped > 0 ? `${lines.skipped} lines, and none can be read: is it ${baudRate} baud? Does the board print x,y,z?` : "Nothing comes from the board: is this its port, and does its program print readings?");
        }
        heard = lines.taken;
    }, PATIENCE * 1000);

    return {
        lines,
        async send(text) {
            const writer = port.writable.getWriter();
            try {
                await writer.write(new TextEncoder().encode(text));
            } finally {
                writer.releaseLock();
            }
        },
        async stop() {
            isStopped = true;
            clearInterval(watch);
            navigator.serial.removeEventListener("disconnect", lost);
            navigator.serial.removeEventListener("connect", back);
            await reader?.cancel().catch(() => {}); // the port may be gone
            await reading; // then its lock is released
            await port.close().catch(() => {});
        },
    };
}

// ---- the sensors of a phone ------------------------------------------------------------------------

export async function phone(sink) {
    if (typeof DeviceMotionEvent === "undefined") {
        throw new Error("This browser has no motion sensors.");
    }
    if (DeviceMotionEvent.requestPermission && (await DeviceMotionEvent.requestPermission()) !== "granted") {
        throw new Error("The browser was not allowed to read the motion sensors: reload the page, and allow it.");
    }
    let heard = false;
    const hear = ({ accelerationIncludingGravity: a, rotationRate: w, timeStamp }) => {
        if (!a || a.x === null) {
            return;
        }
        heard = true;
        const gyro = w && w.beta !== null ? [w.beta, w.gamma, w.alpha] : null;
        sink.sample({ columns: 3, time: null, acc: [a.x, a.y, a.z], gyro }, timeStamp / 1000);
    };
    addEventListener("devicemotion", hear);
    const patience = setTimeout(() => {
        if (!heard) {
            sink.tell(isSecureContext ? "No readings come: this device has no motion sensors, or the browser's settings forbid them." : "Browsers show motion sensors over https only: open the page from there, or from a file.");
        }
    }, 2000);
    return {
        stop() {
            clearTimeout(patience);
            removeEventListener("devicemotion", hear);
        },
    };
}

// ---- a log, as if it came now ------------------------------------------------------------------------

// speed: 1 as it was recorded, 10 ten times as fast, Infinity as fast as can be. rate: of a log without time.
export function replay(sink, file, { speed, rate }) {
    const rows = [];
    const lines = new Lines({ onSample: (sample) => rows.push(sample) });
    const reader = file.stream().getReader();
    const decoder = new TextDecoder();
    let isStopped = false;
    let at = 0; // seconds in the log
    let before = null;

    const feed = (sample) => {
        const step = sample.time !== null && before !== null ? sample.time - before : 1 / rate;
        before = sample.time;
        at += step > 0 && step < 5 ? step : 1 / rate;
        sink.sample(sample, at);
    };
    const more = async () => {
        const { value, done } = await reader.read();
        if (done) {
            lines.end();
            return false;
        }
        lines.push(decoder.decode(value, { stream: true }));
        return true;
    };
    const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
    const play = async () => {
        const began = now();
        let isMore = true;
        while (!isStopped && (isMore || rows.length > 0)) {
            while (isMore && rows.length === 0) {
                isMore = await more();
            }
            const slice = now();
            let i = 0;
            while (i < rows.length && now() - slice < 0.012 && at <= (now() - began) * speed) {
                feed(rows[i++]);
            }
            rows.splice(0, i);
            await pause(i > 0 && speed === Infinity ? 0 : 8);
        }
        await reader.cancel();
        if (!isStopped) {
            sink.end(lines);
        }
    };
    play().catch((error) => sink.tell(`${file.name} cannot be read: ${error.message}`));
    return {
        lines,
        stop() {
            isStopped = true;
        },
    };
}

// ---- a simulated sensor in a hand that does what it is told --------------------------------------------

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (v) => v.map((x) => x / Math.hypot(...v));

// xorshift32: the same hand each time.
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

// What the simulated sensor is wrong by: counts of 16384 per g, and of 1/16 degree a second.
export const TRUTH = {
    offset: [327.7, -245.8, 491.5],
    matrix: [
        [1.01, 0.005, -0.003],
        [0.005, 0.992, 0.004],
        [-0.003, 0.004, 1.012],
    ],
    gyro: [12, -7, 3],
};

// wanted: gives the direction that is asked for; the hand is some degrees off.
export function simulator(sink, { speed, wanted, seed = 1 }) {
    const RATE = 100;
    const REST = 3;
    const TURN = 1.5;
    const chance = random(seed);
    let from = [0, 0, 1];
    let to = from;
    let phase = 0; // seconds in this rest and the turn after it
    let n = 0;

    const read = (up, isTurning) => {
        const acc = TRUTH.matrix.map((row, i) => Math.round(16384 * dot(row, up) + TRUTH.offset[i] + chance.normal() * (isTurning ? 150 : 12)));
        const gyro = TRUTH.gyro.map((bias) => Math.round(bias + chance.normal() * (isTurning ? 800 : 2)));
        sink.sample({ columns: 6, time: null, acc, gyro }, n / RATE);
        n++;
    };
    const step = () => {
        phase += 1 / RATE;
        if (phase >= REST + TURN) {
            from = to;
            phase = 0;
        }
        if (phase < REST) {
            read(from, false);
            return;
        }
        if (from === to) {
            to = unit(wanted().map((v) => v + 0.06 * chance.normal()));
        }
        const share = (phase - REST) / TURN;
        const way = share * share * (3 - 2 * share);
        const aside = dot(from, to) < -0.9 ? Math.sin(Math.PI * way) : 0; // not through the middle
        read(unit(from.map((v, i) => v * (1 - way) + to[i] * way + aside * [from[1], -from[0], 0.5][i])), true);
    };
    let told = now();
    const timer = setInterval(() => {
        const passed = Math.min(0.1, now() - told);
        told = now();
        for (let i = 0; i < passed * speed * RATE; i++) {
            step();
        }
    }, 15);
    return {
        stop() {
            clearInterval(timer);
        },
    };
}
