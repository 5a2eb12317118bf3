// SPDX-License-Identifier: MIT
//
// Logs: the page makes the same bytes of them as the native tool.
import { readFileSync, createWriteStream, statSync } from "node:fs";
import { once } from "node:events";
import { fileURLToPath } from "node:url";
import { test, expect, equal, native, file, put, work } from "./harness.mjs";
import { samples } from "./sensor.mjs";

const data = fileURLToPath(new URL("../data/", import.meta.url));
const FORMATS = ["c", "c-arrays", "fusion", "imu_tk", "imu_tk-gyro", "ros", "px4", "ardupilot"];

// Keeps what the page offers to save, by its name, instead of a download.
const catchFiles = () => {
    window.saved = {};
    HTMLAnchorElement.prototype.click = function () {
        window.saved[this.download] = fetchText(this.href);
    };
    const blobs = new Map();
    const create = URL.createObjectURL;
    URL.createObjectURL = (blob) => {
        const url = create(blob);
        blobs.set(url, blob);
        return url;
    };
    const fetchText = (url) => blobs.get(url).text();
};

async function save(page, selector, name) {
    await page.evaluate((n) => delete window.saved[n], name);
    await page.click(selector);
    await page.until(`window.saved[${JSON.stringify(name)}]`, `${name} saved`);
    return page.evaluate((n) => window.saved[n], name);
}

const DONE = '!document.querySelector("#made").hidden || (document.querySelector("#trouble").textContent !== "" && document.querySelector("#cancel").disabled)';

async function calibrated(page, name, options, others = []) {
    await page.evaluate((text) => (document.querySelector("#options").value = text), options);
    await page.drop(name, ...others);
    await page.until(DONE, `${name} calibrated`, 60000);
}

const args = (options) => options.split(" ").filter(Boolean);

// One number comes from sines and cosines, length95_most of six faces: its last digits depend on the libc.
const withoutLast = (json) => json.replace(/("length95_most": [\d.]{16})\d*/, "$1");

// Table, report, CAL.json and all exports.
async function compare(page, name, options) {
    const wanted = native("calibrate", name, ...args(options), "--out", "CAL.json", "--report", "report.html");
    equal(wanted.code, 0, `the native tool of ${name}: ${wanted.stderr}`);
    await calibrated(page, name, options);
    equal(await page.text("#table"), wanted.stdout, "table");
    equal(withoutLast(await save(page, '[data-save="CAL.json"]', "CAL.json")), withoutLast(file("CAL.json")), "CAL.json");
    equal(await save(page, '[data-save="report.html"]', "report.html"), file("report.html"), "report.html");
    for (const format of FORMATS) {
        const exported = native("export", "CAL.json", "--format", format);
        await page.select("#format", format);
        await page.evaluate(() => {
            window.saved = {};
            document.querySelector("#exported").textContent = "";
        });
        await page.click("#export");
        await page.until('document.querySelector("#exported").textContent !== ""', format);
        const [text] = await page.evaluate(() => Promise.all(Object.values(window.saved)));
        if (exported.code === 0) {
            equal(text, exported.stdout, format);
        } else {
            equal(text, undefined, `${format} is refused, too`);
            equal(await page.text("#exported"), exported.stderr.trim(), `why ${format} is refused`);
        }
    }
}

// Each real recording as a log: rests in its position means, and turns between.
const RECORDINGS = [
    ["xsens_mti", 12, "--gravity 9.81744"],
    ["mpu9150_0", 0.01, "--gravity 9.81 --unit m/s2"],
    ["t265", 0.01, "--gravity 9.8016 --unit m/s2"],
];
for (const [name, sigma, options] of RECORDINGS) {
    test(`log of ${name}: same bytes as the native tool`, async (open) => {
        const rows = readFileSync(`${data}${name}_positions.csv`, "utf8").trim().split("\n").map((row) => row.split(",").map(Number)).filter((row) => row.every(Number.isFinite));
        const log = [...samples(rows.map((row) => row.slice(0, 3)), { sigma })].map((v, i) => `${(i / 100).toFixed(2)},${v.map((x) => x.toFixed(4)).join(",")}`);
        put(`${name}.csv`, `t,x,y,z\n${log.join("\n")}\n`);
        await compare(await open({ before: catchFiles }), `${name}.csv`, options);
    });
}

test("positions, temperature, six faces: same bytes", async (open) => {
    const page = await open({ before: catchFiles });
    put("positions.csv", readFileSync(`${data}mpu9150_1_positions.csv`));
    await compare(page, "positions.csv", "--positions --gravity 9.81 --unit m/s2 --units ins");
    put("warm.csv", native("simulate", "--plan", "optimal:48", "--temperature", "10,20", "--dwell", "4").stdout);
    await compare(page, "warm.csv", "--noise 0.001 --robust --latitude 48.1 --height 520");
    put("faces.csv", native("simulate", "--plan", "faces").stdout);
    await compare(page, "faces.csv", "--six-faces --zero 0,0,0 --lsb 0.000598550415");
});

test("the report is shown in the page", async (open) => {
    put("edges.csv", native("simulate", "--plan", "edges").stdout);
    const page = await open({ before: catchFiles });
    await calibrated(page, "edges.csv", "");
    const frame = await (await page.$("#page")).contentFrame();
    await frame.waitForFunction('document.body && document.body.innerText.includes("Good")');
    const width = await frame.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    expect(width <= 1, `it is ${width} pixels too wide`);
    await page.picture("report");
});

test("an earlier calibration with the log; a name with a blank", async (open) => {
    put("a log.csv", native("simulate", "--plan", "edges", "--seed", "5").stdout);
    native("calibrate", "edges.csv", "--out", "before.json");
    put("edges.csv", native("simulate", "--plan", "edges").stdout);
    native("calibrate", "edges.csv", "--out", "before.json");
    const wanted = native("calibrate", "a log.csv", "--nominal", "before.json", "--out", "CAL.json", "--report", "report.html");
    const page = await open({ before: catchFiles });
    await calibrated(page, "a log.csv", "--nominal before.json", ["before.json"]);
    equal(await page.text("#table"), wanted.stdout, "table");
    equal(await page.text("#command"), "invcal calibrate 'a log.csv' --nominal before.json --out CAL.json --report report.html", "command");
    equal(await save(page, '[data-save="report.html"]', "report.html"), file("report.html"), "report.html");
});

test("what the tool refuses, the page refuses in the same words, and goes on", async (open) => {
    const page = await open({ before: catchFiles });
    put("bad.csv", "x,y,z\n1,2,3\n1,two,3\n");
    put("edges.csv", native("simulate", "--plan", "edges").stdout);
    await calibrated(page, "bad.csv", "");
    equal(await page.text("#trouble"), native("calibrate", "bad.csv", "--out", "CAL.json", "--report", "report.html").stderr.trim(), "words");
    expect(await page.$eval("#made", (element) => element.hidden), "nothing is made");
    await page.picture("refused");
    await calibrated(page, "edges.csv", "--gravty 9.8");
    equal(await page.text("#trouble"), native("calibrate", "edges.csv", "--gravty", "9.8").stderr.trim(), "an unknown option");
    await page.evaluate(() => (document.querySelector("#options").value = ""));
    await page.click("#run");
    await page.until('!document.querySelector("#made").hidden', "a good one after that");
});

test("more than 2 GB is refused with the native command", async (open) => {
    const page = await open();
    await page.evaluate(() => {
        const file = new File(["1,2,3\n"], "huge.csv");
        Object.defineProperty(file, "size", { value: 3e9 });
        const drop = new Event("drop", { cancelable: true });
        drop.dataTransfer = { files: [file] };
        dispatchEvent(drop);
    });
    const said = await page.text("#trouble");
    expect(said.includes("2 GB") && said.includes("invcal calibrate huge.csv"), said);
});

const LARGE = "large.csv";
async function makeLarge() {
    const out = createWriteStream(`${work}/${LARGE}`);
    const part = native("simulate", "--plan", "edges", "--dwell", "60").stdout.split("\n").slice(1).filter(Boolean).map((row) => row.split(",").slice(1).join(","));
    out.write("x,y,z\n");
    // Each rest 20 times as long.
    for (let i = 0; i < part.length; i += 500) {
        const rows = `${part.slice(i, i + 500).join("\n")}\n`;
        out.write(rows.repeat(55));
    }
    out.end();
    await once(out, "close");
}

test("a log of 100 MB: no freeze, progress, same bytes; cancelled and run again", async (open) => {
    await makeLarge();
    const size = statSync(`${work}/${LARGE}`).size;
    expect(size > 1e8, `${size} bytes`);
    const wanted = native("calibrate", LARGE, "--out", "CAL.json", "--report", "report.html");
    const page = await open({ before: catchFiles });
    await page.evaluate(() => {
        let last = window.began = performance.now();
        window.longest = 0;
        window.shares = new Set();
        setInterval(() => {
            window.longest = Math.max(window.longest, performance.now() - last);
            last = performance.now();
            window.shares.add(document.querySelector("#progress").value);
        }, 20);
    });
    await page.drop(LARGE);
    await page.until('document.querySelector("#progress").value > 0.1', "progress", 60000);
    await page.click("#cancel");
    await page.until('document.querySelector("#trouble").textContent === "Cancelled."', "cancelled");
    await page.click("#run");
    await page.until(DONE, "100 MB", 120000);
    equal(await page.text("#trouble"), wanted.stderr.trim(), "messages");
    if (wanted.code === 0) {
        equal(await page.text("#table"), wanted.stdout, "table");
        equal(await save(page, '[data-save="CAL.json"]', "CAL.json"), file("CAL.json"), "CAL.json");
    }
    const [longest, shares, all] = await page.evaluate(() => [window.longest, window.shares.size, performance.now() - window.began]);
    expect(longest < 0.1 * all, `the page froze for ${longest} ms of ${all}`);
    expect(shares > 10, `${shares} steps of progress`);
    return `the page was never busy for more than ${(100 * longest / all).toFixed(1)} % of the time`;
});
