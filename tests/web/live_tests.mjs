// SPDX-License-Identifier: MIT
//
// Live calibrations: simulator, replayed logs, a phone; what can be saved; speed.
import { test, expect, equal, close, native, file, put, sleep } from "./harness.mjs";
import { DIRECTIONS, SENSOR, noise, reads, samples, unit } from "./sensor.mjs";

const GOOD = "invcal.session()?.result?.mayStop";
const TAKEN = (n) => `invcal.session()?.positions.length >= ${n}`;

const result = (page) => page.evaluate(() => {
    const { offset, matrix, sigma, verdict } = invcal.session().result;
    return { offset, matrix, sigma, verdict };
});

async function simulate(page, speed = "Infinity") {
    await page.select("#speed", speed);
    await page.click("#simulator");
}

// The offsets of the simulated sensor, as the page's source states them.
const SIMULATED = [327.7, -245.8, 491.5];

test("simulator to Good: it says when to stop, and its results are true", async (open) => {
    const page = await open();
    await page.picture("idle");
    await simulate(page, "16");
    await page.until(TAKEN(4), "four positions");
    await page.picture("four");
    await page.until('invcal.session().state === "settling"', "a hold");
    await page.until(GOOD, "good");
    await page.until('document.querySelector("#say").textContent.includes("you may stop")', "may stop");
    await page.picture("good");
    const { offset, sigma, verdict } = await result(page);
    equal(verdict, "good", "verdict");
    offset.forEach((v, i) => close(v, SIMULATED[i], 3, `offset ${i}, counts`));
    expect(sigma[0] < 1e-3 && sigma[1] < 1e-3 && sigma[2] < 0.1 * Math.PI / 180, `sigma ${sigma}`);
    const gyro = await page.evaluate(() => invcal.session().gyro.result());
    gyro.mean.forEach((v, i) => close(v, [12, -7, 3][i], 0.3, `gyro bias ${i}`));
    expect(/^✓ Good: you may stop/.test(await page.text("#verdict")), await page.text("#verdict"));
});

test("report and files of a live calibration agree with what was shown", async (open) => {
    const page = await open();
    await simulate(page);
    await page.until(GOOD, "good");
    await page.click("#stop");
    const live = await result(page);
    await page.click("#make");
    await page.until('!document.querySelector("#made").hidden', "made");
    put("live.csv", await page.evaluate(() => invcal.session().csv().text()));
    const options = await page.$eval("#options", (input) => input.value);
    const wanted = native("calibrate", "live.csv", ...options.split(" "), "--out", "CAL.json", "--report", "report.html");
    equal(await page.text("#table"), wanted.stdout, "table");
    const made = JSON.parse(file("CAL.json"));
    made.offset.forEach((v, i) => close(live.offset[i], v, 0.02, `offset ${i}, counts`));
    made.matrix.flat().forEach((v, i) => close(live.matrix.flat()[i] * 9.80665, v, 1e-9, `matrix ${i}`));
    await page.picture("taken-away");
});

test("stopped and started again, each time from scratch", async (open) => {
    const page = await open();
    for (let i = 0; i < 3; i++) {
        await simulate(page);
        await page.until(TAKEN(2), "two positions");
        await page.click("#stop");
        const n = await page.evaluate(() => invcal.session().samples);
        await sleep(150);
        equal(await page.evaluate(() => invcal.session().samples), n, "samples after stop");
        equal(await page.$eval("#simulator", (b) => b.ariaPressed), "false", "pressed");
    }
    await simulate(page);
    await page.until(TAKEN(1), "one position");
    await page.evaluate(() => (window.before = invcal.session()));
    await simulate(page);
    await page.until("invcal.session() !== window.before", "begun again");
    await page.until(TAKEN(1), "one position");
});

test("a dropped log is replayed, at a stated speed and as fast as possible: all positions, the native tool's offsets", async (open) => {
    const readings = DIRECTIONS.map(reads);
    const rows = [...samples(readings)].map((v, i) => `${(i / 100).toFixed(2)},${v.map(Math.round).join(",")}`);
    put("replay.csv", `t,x,y,z\n${rows.join("\n")}\n`);
    native("calibrate", "replay.csv", "--zero", "0,0,0", "--lsb", String(9.80665 / 16384), "--out", "CAL.json");
    const page = await open();
    await page.drop("replay.csv");
    await page.until('!document.querySelector("#made").hidden', "made");
    for (const speed of [4, 16]) {
        await page.select("#speed", String(speed));
        const began = await page.evaluate(() => performance.now());
        await page.click("#replay");
        await page.until(`invcal.session()?.samples > ${40 * speed}`, "begun");
        await page.click("#stop");
        const [passed, samples] = await page.evaluate((then) => [performance.now() - then, invcal.session().samples], began);
        expect(samples / 100 <= (passed / 1000) * speed + 0.1, `${samples} samples of 100 a second in ${passed} ms at ${speed} times`);
    }
    for (const time of [1, 2]) {
        await page.select("#speed", "Infinity");
        await page.click("#replay");
        await page.until('invcal.session()?.state === "ended"', `replayed, time ${time}`);
        const { offset } = await result(page);
        equal(await page.evaluate(() => invcal.session().positions.length), 18, "positions");
        JSON.parse(file("CAL.json")).offset.forEach((v, i) => close(offset[i], v, 0.05, `offset ${i}, counts`));
        offset.forEach((v, i) => close(v, SENSOR.offset[i], 5, `true offset ${i}`));
    }
});

test("a log that cannot be replayed says so", async (open) => {
    const page = await open();
    put("words.csv", "a,b\nno,numbers\n");
    await page.drop("words.csv");
    await page.until('document.querySelector("#trouble").textContent !== ""', "refused");
    await page.click("#replay");
    await page.until('document.querySelector("#notice").textContent.startsWith("No line of this log")', "no samples");
});

test("tones: one for each position, and when to stop; none if they are switched off", async (open) => {
    const page = await open({ before: () => {
        window.tones = [];
        const start = OscillatorNode.prototype.start;
        OscillatorNode.prototype.start = function (...when) {
            window.tones.push(this.frequency.value);
            start.apply(this, when);
        };
    } });
    await simulate(page);
    await page.until(GOOD, "good");
    await page.until("window.tones.includes(1100)", "may stop");
    const [tones, n] = await page.evaluate(() => [window.tones.filter((pitch) => pitch === 880).length, invcal.session().positions.length]);
    expect(tones >= n && tones <= n + 3, `${tones} tones of ${n} positions`);
    await page.evaluate(() => document.querySelector("#sound").click());
    await simulate(page);
    await page.evaluate(() => (window.tones = []));
    await page.until(TAKEN(3), "positions");
    equal(await page.evaluate(() => window.tones.length), 0, "tones");
});

// ---- a phone ---------------------------------------------------------------------------------------

// DeviceMotion events as a browser sends them: rounded, 60 a second. The test makes the time.
const hold = (page, readings, rounded) => page.evaluate(async ([rows, step]) => {
    let t = performance.now() + 1e6;
    for (const [x, y, z] of rows) {
        const [rx, ry, rz] = [x, y, z].map((v) => (step ? Math.round(v / step) * step : v));
        const event = new DeviceMotionEvent("devicemotion", { accelerationIncludingGravity: { x: rx, y: ry, z: rz }, rotationRate: { alpha: 0.1, beta: 0.2, gamma: 0.3 }, interval: 16 });
        Object.defineProperty(event, "timeStamp", { value: (t += 1000 / 60) });
        dispatchEvent(event);
    }
}, [readings, rounded]);

async function begin(page) {
    await page.click("#phone");
    await page.until('document.querySelector("#phone").ariaPressed === "true"', "begun");
}

const inHand = (sigma) => [...samples(DIRECTIONS.map((up) => up.map((v) => 9.81 * v)), { rest: 200, turn: 60, sigma, seed: 9 })];

test("a phone that rounds to 0.1 m/s²: it is calibrated, and the page says what that means", async (open) => {
    const page = await open();
    await begin(page);
    await hold(page, inHand(0.04), 0.1);
    await page.until(TAKEN(15), "positions");
    const facts = await page.text("#facts");
    expect(facts.includes("rounds the readings to 10 mg") && facts.includes("not for measuring"), facts);
    const { offset, sigma } = await result(page); // of a sensor without errors
    expect(sigma[0] > 1e-4, `sigma of offsets ${sigma[0]}`);
    offset.forEach((v, i) => close(v / 9.80665, 0, 2 * sigma[0], `offset ${i}, g`));
    await page.picture("phone-sensors");
    await page.click("#stop");
    await begin(page);
    await hold(page, inHand(0.003), 0.1);
    await page.until('document.querySelector("#refused").textContent.includes("readings never change")', "held very still, it is refused");
    await page.click("#stop");
    await begin(page);
    await hold(page, inHand(0.004), 0);
    await page.until(TAKEN(17), "positions, started again");
    expect(!(await page.text("#facts")).includes("rounds"), "nothing is rounded");
});

test("motion sensors that Chromium emulates, and rounds itself: a position is taken, and the rounding is reported", async (open) => {
    const page = await open();
    const browser = await page.createCDPSession();
    for (const type of ["accelerometer", "linear-acceleration", "gyroscope"]) {
        await browser.send("Emulation.setSensorOverrideEnabled", { enabled: true, type, metadata: { available: true, minimumFrequency: 1, maximumFrequency: 60 } });
    }
    const feel = (type, [x, y, z]) => browser.send("Emulation.setSensorOverrideReadings", { type, reading: { xyz: { x, y, z } } });
    await feel("gyroscope", [0, 0, 0]);
    await feel("linear-acceleration", [0, 0, 0]);
    await feel("accelerometer", [5.55, -2.34, 7.73]); // of length 9.8
    await begin(page);
    const tremor = noise(7);
    const shake = async () => {
        while (!page.isHeld) {
            await feel("accelerometer", [5.55, -2.34, 7.73].map((v) => v + 0.06 * tremor()));
            await sleep(12);
        }
    };
    const shaking = shake();
    try {
        await page.until("invcal.session()?.isReady()", "held long enough");
    } finally {
        page.isHeld = true;
        await shaking;
    }
    expect((await page.text("#facts")).includes("rounds the readings to 10 mg"), await page.text("#facts"));
    await page.click("#stop"); // the position that is held counts
    equal(await page.evaluate(() => invcal.session().positions.length), 1, "positions");
}, { only: "chromium" });

test("a device without motion sensors says so", async (open) => {
    const page = await open();
    await page.click("#phone");
    await page.until('document.querySelector("#notice").textContent.startsWith("No readings arrive")', "notice");
});

test("sensors that plain http hides, and sensors that the user denied: each is reported", async (open) => {
    const insecure = await open({ before: 'Object.defineProperty(window, "isSecureContext", { value: false });' });
    await insecure.click("#phone");
    const denied = await open({ before: 'DeviceMotionEvent.requestPermission = async () => "denied";' });
    await denied.click("#phone");
    await denied.until('document.querySelector("#notice").textContent.includes("does not let this page read the motion sensors")', "denied");
    equal(await denied.$eval("#phone", (button) => button.ariaPressed), "false", "pressed");
    await insecure.until('document.querySelector("#notice").textContent.includes("only over https")', "https");
}, { only: "chromium" });

// ---- speed -----------------------------------------------------------------------------------------

// Seconds mean nothing on a machine that does other things; so each is compared with a plain loop in the same page.
const MEDIAN_OF = 9;
const median = (list) => list.toSorted((a, b) => a - b)[list.length >> 1];

test("a sample through the session costs less than 80 square roots", async (open) => {
    const page = await open();
    const times = await page.evaluate((rounds) => {
        const time = (run) => {
            const began = performance.now();
            run();
            return performance.now() - began;
        };
        const session = new invcal.Session(invcal.live, { rate: 100, unit: "16384", target: [1, 1, 1] }, () => {});
        let n = 0;
        let sum = 0;
        return Array.from({ length: rounds }, () => [time(() => {
            for (let i = 0; i < 1e5; i++, n++) {
                session.add({ raw: false, acc: [100 + (n & 7), -200 + ((n >> 3) & 7), 16384 - (n & 3)], gyro: null }, n / 100);
            }
        }), time(() => {
            for (let i = 0; i < 1e7; i++) {
                sum += Math.sqrt(i + sum);
            }
        })]);
    }, MEDIAN_OF);
    const roots = 100 * median(times.map(([session, loop]) => session / loop));
    expect(roots < 80, `${roots.toFixed(0)} of them`);
    return `${roots.toFixed(0)}; ${(100 / median(times.map(([session]) => session))).toFixed(1)} million samples a second`;
});

test("64 positions are drawn at more than half the rate of an empty picture", async (open) => {
    const page = await open();
    await simulate(page);
    await page.until(TAKEN(3), "three positions");
    await page.click("#stop");
    const positions = DIRECTIONS.concat(DIRECTIONS, DIRECTIONS, DIRECTIONS).slice(0, 64).map((d, i) => unit([d[0] + 0.01 * i, d[1], d[2]]));
    const rates = await page.evaluate(async (all, rounds) => {
        const sigmas = Array.from({ length: 400 }, (_, i) => 1 + i / 50);
        const rate = (paint) => new Promise((done) => {
            const began = performance.now();
            let i = 0;
            const draw = () => {
                paint(i++);
                i < 15 ? requestAnimationFrame(draw) : done((i / (performance.now() - began)) * 1000);
            };
            requestAnimationFrame(draw);
        });
        const sphere = (i) => invcal.sphere.draw({ up: [Math.cos(i / 20), Math.sin(i / 20), 0.3], next: [0, 0, 1], positions: all, sigmas, progress: 50, isReady: false });
        const found = [];
        while (found.length < rounds) {
            found.push([await rate(sphere), await rate(() => {})]);
        }
        return found;
    }, positions, MEDIAN_OF);
    const ratio = median(rates.map(([sphere, empty]) => sphere / empty));
    expect(ratio > 0.5, `${ratio.toFixed(2)} of it`);
    return `${ratio.toFixed(2)}; ${median(rates.map(([sphere]) => sphere)).toFixed(0)} pictures a second`;
});
