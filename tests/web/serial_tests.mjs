// SPDX-License-Identifier: MIT
//
// A board at a serial port, with a mock of WebSerial (mock_serial.js).
import { readFileSync } from "node:fs";
import { test, expect, equal, close, sleep } from "./harness.mjs";
import { DIRECTIONS, SENSOR, reads, samples } from "./sensor.mjs";

const mock = readFileSync(new URL("mock_serial.js", import.meta.url), "utf8");

// CRC-32 of IEEE 802.3, bit by bit.
function crc32(bytes) {
    let crc = 0xffffffff;
    for (const byte of bytes) {
        crc ^= byte;
        for (let bit = 0; bit < 8; bit++) {
            crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
        }
    }
    return ~crc >>> 0;
}

const lines = (readings, print, options) => [...samples(readings, options)].map((v) => `${print(v.map(Math.round))}\r\n`);
const commas = (v) => v.join(",");

// Opens a port with a stated rate of readings, as the test prints faster than a board.
async function connect(open, { rate = "100", unit = "16384", page = null } = {}) {
    page ??= await open({ before: mock });
    await page.evaluate((r) => (document.querySelector("#rate").value = r), rate);
    await page.select("#unit", unit);
    const opened = await page.evaluate(() => board.opened);
    await page.click("#serial");
    await page.until(`board.opened === ${opened + 1}`, "open");
    return page;
}

const print = (page, text, piece = 4000) => page.evaluate(async ([all, n]) => {
    for (let i = 0; i < all.length; i += n) {
        board.print(all.slice(i, i + n));
        if (i % (50 * n) === 0) {
            await new Promise((done) => setTimeout(done));
        }
    }
}, [text, piece]);

const state = (page) => page.evaluate(() => ({ samples: invcal.session().samples, positions: invcal.session().positions.length, refused: invcal.session().refused, result: invcal.session().result }));
const arrived = (page, n) => page.until(`invcal.session().samples >= ${n}`, `${n} samples`);
const skipped = async (page) => Number(/(\d+) lines? skipped/.exec(await page.text("#facts"))?.[1] ?? 0);

const good = async (page) => {
    const { result } = await state(page);
    equal(result.verdict, "good", "verdict");
    result.offset.forEach((v, i) => close(v, SENSOR.offset[i], 5, `offset ${i}`));
};

// The Firefox that is tested has no serial ports yet: of the tests with the mock it runs only those without this.
const CHROMIUM = { only: "chromium" };

const LAYOUTS = {
    "x,y,z": commas,
    "x y z": (v) => v.join(" "),
    "x\\ty\\tz": (v) => v.join("\t"),
    "ax:1,ay:2,az:3": (v) => `ax:${v[0]},ay:${v[1]},az:${v[2]}`,
    "t,x,y,z": (v) => `12.5,${v}`,
    "x,y,z,gx,gy,gz": (v) => `${v},3,-2,1`,
    "t x y z gx gy gz": (v) => `17 ${v.join(" ")} 3 -2 1`,
    "Raw: of MotionCal": (v) => `Raw:${v},3,-2,1,100,200,300`,
};
for (const [name, layout] of Object.entries(LAYOUTS)) {
    test(`serial, lines ${name}`, async (open) => {
        const page = await connect(open);
        const all = lines(DIRECTIONS.map(reads), layout);
        await print(page, `torn,,\r\n${all.join("")}Uni:0.1,0.2,9.8\r\nCal1:0.000,0.000,0.000,0.000,0.000,0.000,0.000,0.000,0.000,50.000\r\n# a comment\r\nwords\r\n`);
        await arrived(page, all.length);
        equal(await skipped(page), 0, "skipped lines");
        await good(page);
        equal((await state(page)).positions, 17, "positions"); // the last is still held
        const gyro = await page.evaluate(() => invcal.session().gyro.result()?.mean);
        equal(gyro, /gx|Raw/.test(name) ? [3, -2, 1] : undefined, "gyro");
    }, name.startsWith("Raw") ? {} : CHROMIUM);
}

test("serial: units are recognized", async (open) => {
    const cases = [[1, "g", 5], [1000, "mg", 2], [9.80665, "m/s²", 4], [16384, "16384 counts/g", 0], [8192, "8192 counts/g", 0], [256, "256 counts/g", 0]];
    const page = await open({ before: mock });
    for (const [length, name, digits] of cases) {
        await connect(open, { unit: "", page });
        const readings = DIRECTIONS.map((up) => up.map((v, i) => length * v * (1 + 0.01 * i)));
        const text = [...samples(readings, { sigma: 0.001 * length })].map((v) => `${v.map((x) => x.toFixed(digits)).join(",")}\n`).join("");
        await print(page, `-\n${text}`);
        await arrived(page, 18 * 300);
        equal(await page.evaluate(() => invcal.session().unit.name), name, "unit");
        const { result } = await state(page);
        result.matrix.forEach((row, i) => close(row[i] * length * (1 + 0.01 * i), 1, 0.003, `scale ${i} of ${name}`));
        await page.click("#stop");
        await page.until("board.closed === board.opened", "closed");
    }
}, CHROMIUM);

test("serial: chunks of 1 to 7 bytes, a torn first line, garbage", async (open) => {
    const page = await connect(open);
    const all = lines(DIRECTIONS.map(reads), commas);
    const noisy = all.map((line, i) => (i % 97 === 50 ? `\u0000\ufffd${line.slice(2)}` : i % 211 === 100 ? `${line.split(",")[0]}\r\n` : i % 301 === 200 ? `7,${line}` : line)); // the last has the columns of another layout
    const broken = noisy.filter((line, i) => line !== all[i]).length;
    await page.evaluate(async (text) => {
        for (let i = 0, n = 1; i < text.length; i += n, n = (n % 7) + 1) {
            board.print(text.slice(i, i + n));
            if (i % 4001 < 7) {
                await new Promise((done) => setTimeout(done));
            }
        }
    }, `34,-12,1\r\n${noisy.join("")}`);
    await arrived(page, all.length - broken);
    await good(page);
    equal(await skipped(page), broken, "skipped lines");
    equal((await state(page)).samples, all.length - broken, "samples");
}, CHROMIUM);

test("serial: a line without an end is discarded", async (open) => {
    const page = await connect(open);
    await print(page, `${"7".repeat(100000)}\r\n${lines([reads([0, 0, 1])], commas).join("")}`);
    await arrived(page, 290);
}, CHROMIUM);

test("serial: unplugged and plugged in again, it continues", async (open) => {
    const page = await connect(open);
    const readings = DIRECTIONS.map(reads);
    await print(page, `torn\r\n${lines(readings.slice(0, 9), commas).join("")}`);
    await arrived(page, 9 * 300);
    const before = (await state(page)).positions;
    expect(before >= 8, `${before} positions`);
    await page.evaluate(() => board.unplug());
    await page.until('document.querySelector("#notice").textContent.includes("Plug it in again")', "notice");
    await page.picture("unplugged");
    await page.evaluate(() => board.plug());
    await page.until('document.querySelector("#notice").textContent.includes("is back")', "notice");
    const n = (await state(page)).samples;
    await print(page, `,12\r\n${lines(readings.slice(8), commas, { seed: 5 }).join("")}`);
    await arrived(page, n + 9 * 300);
    await good(page);
    expect((await state(page)).positions >= 16, "positions");
    await page.evaluate(() => board.stumble());
    await print(page, `9\r\n${lines([readings[0]], commas).join("")}`);
    await arrived(page, n + 10 * 300);
    equal(await page.evaluate(() => invcal.session().log.gaps), 2, "gaps");
});

test("serial: 1,000 lines a second for three seconds, none lost, rate measured", async (open) => {
    const page = await connect(open, { rate: "" });
    await page.evaluate(async (text) => {
        const began = performance.now();
        let i = 0;
        while (i < text.length) {
            const due = Math.min(text.length, Math.floor(performance.now() - began));
            board.print(text.slice(i, due).join(""));
            i = due;
            await new Promise((done) => setTimeout(done, 4));
        }
    }, ["1\r\n", ...lines([reads([0, 0, 1])], commas, { rest: 3000 })]);
    await page.until("invcal.session().samples >= 3000", "all");
    const [rate, taken] = await page.evaluate(() => [invcal.session().rate, invcal.session().samples]);
    close(rate, 1000, 50, "rate");
    equal(taken, 3000, "samples");
}, CHROMIUM);

test("serial: the calibration is sent as a record in the library's format", async (open) => {
    const page = await connect(open);
    const all = lines(DIRECTIONS.map(reads), commas);
    await print(page, `torn\r\n${all.join("")}`);
    await arrived(page, all.length);
    await page.click("#send");
    await page.until('board.heard.endsWith("\\n")', "sent");
    const line = await page.evaluate(() => board.heard);
    expect(/^invcal [0-9a-f]{272}\n$/.test(line), line);
    const record = Buffer.from(line.slice(7, -1), "hex"); // store.h
    equal([record[0], record[1], record.readUInt16LE(2)], [0xca, 2, 136], "kind, version, length");
    equal(record.readUInt32LE(132), crc32(record.subarray(0, 132)), "CRC-32");
    for (let i = 0; i < 3; i++) {
        close(record.readFloatLE(48 + 4 * i), SENSOR.offset[i], 5, `offset ${i}`);
        close(record.readFloatLE(60 + 16 * i) * SENSOR.scale[i], 1, 1e-3, `scale ${i}`);
    }
    await print(page, "invcal: stored\r\n");
    await page.until('document.querySelector("#sent").textContent === "The board says: stored"', "the answer");
    await page.picture("sent");
});

test("serial: stopped, and started again; the port is closed between", async (open) => {
    const page = await connect(open);
    for (let i = 1; i <= 3; i++) {
        await print(page, `x\r\n${lines([reads([0, 0, 1])], commas).join("")}`);
        await arrived(page, 250);
        await page.click("#stop");
        await page.until(`board.closed === ${i}`, "closed");
        await page.click("#serial");
        await page.until(`board.opened === ${i + 1}`, "opened");
        equal((await state(page)).samples, 0, "samples");
    }
    await page.click("#simulator");
    await page.until("board.closed === 4 && invcal.session().samples > 0", "another source");
}, CHROMIUM);

test("serial: silence and a wrong baud rate are reported, until lines arrive", async (open) => {
    const page = await connect(open);
    const notices = (text) => page.until(`document.querySelector("#notice").textContent.includes(${JSON.stringify(text)})`, text);
    await notices("Nothing arrives from the board");
    await page.picture("silent");
    await print(page, "\u0001\u0002\ufffd\n".repeat(50));
    await notices("Is 115200 baud right");
    await print(page, lines([reads([0, 0, 1])], commas).join(""));
    await page.until('document.querySelector("#notice").textContent === ""', "cleared once lines arrive");
    await notices("has stopped printing");
    await page.click("#stop");
}, CHROMIUM);

test("a browser without WebSerial says what to do", async (open) => {
    const page = await open({ before: 'Object.defineProperty(navigator, "serial", { value: undefined });' });
    await page.click("#serial");
    const said = await page.text("#notice");
    expect(said.includes("Chrome, Edge, Opera or a recent Firefox") && said.includes("drop it here"), said);
});

test("serial: a page from plain http says what to do", async (open) => {
    const page = await open({ before: 'Object.defineProperty(navigator, "serial", { value: undefined }); Object.defineProperty(window, "isSecureContext", { value: false });' });
    await page.click("#serial");
    expect((await page.text("#notice")).includes("Save this page, and open the saved file"), await page.text("#notice"));
}, CHROMIUM);

test("serial: no port chosen, a port denied, a busy port: each is reported, and the previous calibration is kept", async (open) => {
    const page = await connect(open);
    const all = lines(DIRECTIONS.map(reads), commas);
    await print(page, `torn\r\n${all.join("")}`);
    await arrived(page, all.length);
    await page.click("#stop");
    const before = (await state(page)).result.offset;
    const cases = {
        NotFoundError: "No port was chosen",
        SecurityError: "does not let this page use serial ports",
        NetworkError: "Close other programs",
    };
    for (const [name, text] of Object.entries(cases)) {
        await page.evaluate((n) => {
            board.refusal = n === "NetworkError" ? null : n;
            board.isBusy = n === "NetworkError";
        }, name);
        await page.click("#serial");
        await page.until(`document.querySelector("#notice").textContent.includes(${JSON.stringify(text)})`, text);
        equal((await state(page)).result.offset, before, "what was there before");
        equal(await page.$eval("#take", (element) => element.hidden), false, "it can still be saved");
    }
    await page.picture("busy");
}, CHROMIUM);

test("serial: after Stop, Send opens the port, waits until the board prints, and closes it", async (open) => {
    const page = await connect(open);
    const all = lines(DIRECTIONS.map(reads), commas);
    await print(page, `torn\r\n${all.join("")}`);
    await arrived(page, all.length);
    await page.click("#stop");
    await page.until("board.closed === 1", "closed");
    const { samples: n } = await state(page);
    await page.click("#send");
    await page.until("board.opened === 2", "opened again");
    await sleep(200);
    equal(await page.evaluate(() => board.heard), "", "sent to a board that does not run yet");
    await print(page, `1\r\n${all.slice(0, 9).join("")}`);
    await page.until('board.heard.startsWith("invcal ")', "sent");
    await print(page, "invcal: stored\r\n");
    await page.until('document.querySelector("#sent").textContent === "The board says: stored"', "the answer");
    await page.until("board.closed === 2", "closed again");
    equal((await state(page)).samples, n, "samples that arrived meanwhile");
    await page.evaluate(() => (board.isBusy = true));
    await page.click("#send");
    await page.until('document.querySelector("#sent").textContent.startsWith("Not sent. The port cannot be opened")', "a port that has become busy");
}, CHROMIUM);

// The statements that print a sample in the examples, taken from their sources.
test("the lines that the examples print are read", async (open) => {
    const source = (name) => readFileSync(new URL(`../../port/${name}`, import.meta.url), "utf8");
    const printed = {
        "esp-idf/examples/calibrate/main/main.c": /printf\("([^"]*)", \(int\)raw\[0\], \(int\)raw\[1\], \(int\)raw\[2\]\)/,
        "zephyr/samples/calibrate/src/main.c": /printk\("([^"]*)", \(int\)raw\[0\], \(int\)raw\[1\], \(int\)raw\[2\]\)/,
    };
    const page = await open({ before: mock });
    for (const [name, statement] of Object.entries(printed)) {
        const format = statement.exec(source(name))?.[1];
        expect(format, `${name} prints samples`);
        await connect(open, { page });
        const layout = (v) => v.reduce((text, value) => text.replace("%d", value), format.replace("\\n", ""));
        const said = ["next: +z up", "hold still, percent: 40", "good: move on", "positions taken: 1"]; // between, as there
        await print(page, `x\n${lines(DIRECTIONS.map(reads), layout).map((line, i) => (i % 500 ? line : `${said[(i / 500) % 4]}\n${line}`)).join("")}`);
        await arrived(page, 18 * 300);
        await good(page);
        await page.click("#stop");
        await page.until("board.closed === board.opened", "closed");
    }
}, CHROMIUM);
