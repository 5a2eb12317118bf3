// SPDX-License-Identifier: MIT
//
// Browsers, pages and checks for the tests of the page. A page that logs an error on its console, or requests anything
// from the network, fails its test.
import { createRequire } from "node:module";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync, rmSync, mkdirSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { tmpdir } from "node:os";

export const build = resolve(process.argv[2]);
export const browserName = process.argv[3];
const only = new RegExp(process.argv[4] || ".");
const puppeteer = createRequire(`${build}/web/npm/`)("puppeteer-core");

export const PAGE = pathToFileURL(`${build}/invcal.html`).href;
export const work = mkdtempSync(`${tmpdir()}/invcal-web-`);
export const pictures = `${build}/web/pictures`;
mkdirSync(pictures, { recursive: true });

const LAUNCH = {
    chromium: {
        browser: "chrome",
        executablePath: "/usr/bin/chromium",
        args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
    },
    firefox: { browser: "firefox", executablePath: "/usr/bin/firefox-esr", args: [] },
};
let browser = null;

const tests = [];
export function test(name, run, options = {}) {
    if (only.test(name) && (!options.only || options.only === browserName)) {
        tests.push({ name, run, options });
    }
}

class Failed extends Error {}
export function expect(isTrue, what) {
    if (!isTrue) {
        throw new Failed(what);
    }
}
export function equal(found, wanted, what) {
    const [a, b] = [found, wanted].map((v) => (typeof v === "string" ? v : JSON.stringify(v)));
    if (a !== b) {
        let i = 0;
        while (a?.[i] === b?.[i]) {
            i++;
        }
        throw new Failed(`${what}: ${String(a).slice(Math.max(0, i - 30), i + 60)} is not ${String(b).slice(Math.max(0, i - 30), i + 60)}`);
    }
}
export const close = (found, wanted, by, what) => expect(Math.abs(found - wanted) <= by, `${what}: ${found} is not ${wanted} within ${by}`);
export const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

// The native tool, in `work`.
export function native(...args) {
    const { status, stdout, stderr } = spawnSync(`${build}/invcal`, args, { cwd: work, encoding: "utf8", maxBuffer: 1 << 30 });
    return { code: status, stdout, stderr };
}
export const file = (name) => readFileSync(`${work}/${name}`, "utf8");
export const put = (name, text) => writeFileSync(`${work}/${name}`, text);

// Loads a page. `before` runs in it before its own script.
export async function open({ before, width = 1280, height = 900, dark = false, still = false } = {}) {
    const page = await browser.newPage();
    page.trouble = [];
    page.on("console", (message) => ["error", "warn", "warning"].includes(message.type()) && page.trouble.push(`console: ${message.text()}`));
    page.on("pageerror", (error) => page.trouble.push(`error: ${error.message}`));
    page.on("request", (request) => /^(file|blob|data|about):/.test(request.url()) || page.trouble.push(`request: ${request.url()}`));
    await page.setViewport({ width, height });
    if (dark || still) {
        await page.emulateMediaFeatures([
            { name: "prefers-color-scheme", value: dark ? "dark" : "light" },
            { name: "prefers-reduced-motion", value: still ? "reduce" : "no-preference" },
        ]);
    }
    if (before) {
        await page.evaluateOnNewDocument(before);
    }
    await page.goto(PAGE);
    await page.waitForFunction("document.documentElement.dataset.ready");
    page.text = (selector) => page.$eval(selector, (element) => element.textContent);
    page.until = (condition, what, timeout = 30000) =>
        page.waitForFunction(condition, { timeout, polling: 50 }).catch(async () => {
            throw new Failed(`${what}: not after ${timeout / 1000} s; the page says "${await page.text("#say")}", "${await page.text("#notice")}"`);
        });
    page.picture = (name) => page.screenshot({ path: `${pictures}/${browserName}-${name}.png`, fullPage: true });
    page.drop = async (...names) => {
        const input = await page.$("#file");
        await input.uploadFile(...names.map((name) => `${work}/${name}`));
    };
    return page;
}

// A pattern may match tests of only the other browser; web.sh fails if neither has any.
export async function runAll() {
    if (tests.length === 0) {
        console.log("0 passed, 0 failed");
        return;
    }
    const profile = mkdtempSync(`${tmpdir()}/invcal-profile-`);
    browser = await puppeteer.launch({ headless: true, userDataDir: profile, ...LAUNCH[browserName] });
    let failed = 0;
    for (const { name, run } of tests) {
        const began = Date.now();
        const pages = [];
        let why = "";
        let figures = "";
        try {
            figures = await run(async (options) => {
                pages.push(await open(options));
                return pages.at(-1);
            });
            const trouble = pages.flatMap((page) => page.trouble);
            why = trouble.join("; ");
        } catch (error) {
            why = error instanceof Failed ? error.message : error.stack;
        }
        for (const page of pages) {
            await page.close().catch(() => {});
        }
        failed += why !== "";
        console.log(`${browserName}: ${name}: ${why !== "" ? `FAIL: ${why}` : figures ? `ok: ${figures}` : "ok"}${process.env.V ? ` (${Date.now() - began} ms)` : ""}`);
    }
    await browser.close();
    rmSync(work, { recursive: true, force: true });
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    console.log(`${tests.length - failed} passed, ${failed} failed`);
    process.exitCode = failed > 0 ? 1 : 0;
}
