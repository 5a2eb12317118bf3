// SPDX-License-Identifier: MIT
//
// For users who cannot see the page, have no mouse, use a phone, or prefer it dark.
import { once } from "node:events";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { test, expect, equal, PAGE } from "./harness.mjs";

const GOOD = "invcal.session()?.result?.mayStop";

test("one file of less than 700 kB, its live part below 100 kB, that requests nothing", async () => {
    const page = readFileSync(new URL(PAGE), "utf8");
    expect(page.length < 700e3, `${page.length} bytes`);
    const tool = /id="tool-wasm">[^<]*/.exec(page)[0].length + /id="worker">[^]*?<\/script>/.exec(page)[0].length;
    expect(page.length - tool < 100e3, `${page.length - tool} bytes of the live part`);
    expect(page.includes("default-src 'none'") && !page.includes("connect-src"), "the policy lets nothing in");
    expect(!/(src|href)=["']?https?:/.test(page), "no address");
    for (const name of ["invcal", "browser_wasi_shim", "musl", "Permission is hereby granted"]) {
        expect(page.includes(name), `${name} has its licence there`);
    }
});

test("the network is blocked: the page itself refuses a request", async (open) => {
    const page = await open();
    const refused = await page.evaluate(async () => {
        const violated = new Promise((done) => addEventListener("securitypolicyviolation", (event) => done(event.effectiveDirective)));
        fetch("data:text/plain,x").catch(() => {});
        return violated;
    });
    page.trouble.length = 0; // the browser says so on its console
    equal(refused, "connect-src", "directive");
});

test("from a web server, too: one request, and everything works", async (open) => {
    const asked = [];
    const server = createServer((request, response) => {
        asked.push(request.url);
        response.setHeader("Content-Type", "text/html");
        response.end(readFileSync(new URL(PAGE)));
    }).listen(0, "127.0.0.1");
    await once(server, "listening");
    const page = await open();
    await page.goto(`http://127.0.0.1:${server.address().port}/invcal.html`);
    await page.waitForFunction("document.documentElement.dataset.ready");
    await page.select("#speed", "Infinity");
    await page.click("#simulator");
    await page.until(GOOD, "good");
    await page.click("#make");
    await page.until('!document.querySelector("#made").hidden', "made");
    server.close();
    equal(asked, ["/invcal.html"], "requests");
    page.trouble = page.trouble.filter((text) => !/^request: http:\/\/127\.0\.0\.1:\d+\/invcal\.html$/.test(text)); // the one that was asked for
});

test("every control has a name, and the keyboard reaches it; the focus is visible", async (open) => {
    const page = await open();
    await page.evaluate(() => (document.querySelector("#settings").open = true));
    const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, iframe, canvas, progress")].filter((e) => !(e.textContent.trim() && e.tagName === "BUTTON") && !e.ariaLabel && !e.labels?.[0]?.textContent.trim() && !e.title && e.id !== "progress").map((e) => e.outerHTML.slice(0, 60)));
    equal(nameless, [], "controls without a name");
    const wanted = await page.evaluate(() => [...document.querySelectorAll("button, input, select, summary, a")].filter((e) => !e.disabled && e.offsetParent).map((e) => e.id || e.tagName));
    const reached = new Set();
    for (let i = 0; i < wanted.length + 3; i++) {
        await page.keyboard.press("Tab");
        const [id, outline] = await page.evaluate(() => [document.activeElement.id || document.activeElement.tagName, getComputedStyle(document.activeElement).outlineWidth]);
        if (id !== "BODY" && !reached.has(id)) {
            expect(outline !== "0px", `no outline of ${id}`);
        }
        reached.add(id);
    }
    equal(wanted.filter((id) => !reached.has(id)), [], "not reached");
});

test("started and stopped by the keyboard alone", async (open) => {
    const page = await open();
    await page.focus("#simulator");
    await page.keyboard.press("Enter");
    await page.until("invcal.session()?.samples > 0", "begun");
    await page.focus("#stop");
    await page.keyboard.press(" ");
    await page.until('invcal.session().state === "ended"', "stopped");
});

test("a screen reader hears each position, where to turn, and when to stop; not each picture", async (open) => {
    const page = await open();
    await page.evaluate(() => {
        window.heard = [];
        const said = document.querySelector("#said");
        new MutationObserver(() => window.heard.push(said.textContent)).observe(said, { childList: true, characterData: true, subtree: true });
    });
    equal(await page.$eval("#said", (e) => [e.ariaLive, getComputedStyle(e).display !== "none"]), ["polite", true], "live region");
    await page.select("#speed", "16");
    await page.click("#simulator");
    await page.until(GOOD, "good");
    await page.until('window.heard.at(-1).includes("you may stop")', "may stop");
    const heard = await page.evaluate(() => window.heard);
    expect(heard.some((text) => /^Position 3 taken/.test(text)) && heard.some((text) => /Turn to [+−][xyz] up/.test(text)), heard.join(" | "));
    const n = await page.evaluate(() => invcal.session().positions.length);
    expect(heard.length <= 4 * n, `${heard.length} sentences for ${n} positions`);
});

test("with reduced motion nothing glides", async (open) => {
    const page = await open({ still: true });
    equal(await page.$eval(".bar u", (e) => getComputedStyle(e).transitionDuration), "0s", "transition");
}, { only: "chromium" });

test("on paper: the result, its table as a whole, and nothing to press", async (open) => {
    const page = await open();
    await page.select("#speed", "Infinity");
    await page.click("#simulator");
    await page.until(GOOD, "good");
    await page.click("#make");
    await page.until('!document.querySelector("#made").hidden', "made");
    await page.emulateMediaType("print");
    const [buttons, cut] = await page.evaluate(() => [
        [...document.querySelectorAll("button, select, input, iframe")].filter((e) => e.offsetParent).map((e) => e.id),
        document.querySelector("#table").scrollHeight - document.querySelector("#table").clientHeight,
    ]);
    equal(buttons.filter((id) => id !== "options"), [], "controls");
    equal(cut, 0, "pixels of the table that are cut off");
    expect((await page.evaluate(() => document.body.innerText)).includes("Good: you may stop"), "the verdict");
}, { only: "chromium" });

// Contrast by WCAG 2: relative luminance of what is visible.
const contrasts = () => {
    const canvas = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
    const rgb = (colour) => {
        canvas.clearRect(0, 0, 1, 1);
        canvas.fillStyle = colour;
        canvas.fillRect(0, 0, 1, 1);
        return [...canvas.getImageData(0, 0, 1, 1).data];
    };
    const light = ([r, g, b]) => [r, g, b].map((v) => v / 255).map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)).reduce((s, v, i) => s + v * [0.2126, 0.7152, 0.0722][i], 0);
    const behind = (element) => {
        for (let e = element; e; e = e.parentElement) {
            const colour = rgb(getComputedStyle(e).backgroundColor);
            if (colour[3] > 0) {
                return colour;
            }
        }
        return [255, 255, 255, 255];
    };
    const bad = [];
    let seen = 0;
    for (const element of document.querySelectorAll("body *")) {
        const hasText = [...element.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim());
        if (!hasText || !element.offsetParent || element.disabled || element.closest("script, #said")) {
            continue;
        }
        seen++;
        const [a, b] = [light(rgb(getComputedStyle(element).color)), light(behind(element))];
        const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        const isMark = element.matches("figcaption b");
        if (ratio < (isMark ? 1.5 : 4.5)) {
            bad.push(`${element.textContent.slice(0, 20)}: ${ratio.toFixed(2)}`);
        }
    }
    return [bad, seen];
};

for (const [name, size] of Object.entries({ desktop: [1280, 900], phone: [360, 780] })) {
    for (const dark of [false, true]) {
        test(`${name}, ${dark ? "dark" : "light"}: contrast, nothing too wide, nothing too small to touch`, async (open) => {
            const page = await open({ width: size[0], height: size[1], dark });
            await page.select("#speed", "Infinity");
            await page.click("#simulator");
            await page.until("invcal.session()?.positions.length >= 7", "seven positions");
            await page.picture(`${name}-${dark ? "dark" : "light"}-seven`);
            await page.until(GOOD, "good");
            await page.click("#make");
            await page.until('!document.querySelector("#made").hidden', "made");
            await page.evaluate(() => (document.querySelector("#settings").open = true));
            const [bad, seen] = await page.evaluate(contrasts);
            equal(bad, [], "contrast");
            expect(seen > 40, `${seen} texts`);
            const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
            expect(wide <= 0, `${wide} pixels too wide`);
            const small = await page.evaluate(() => [...document.querySelectorAll("button, select, input")].filter((e) => e.offsetParent && e.offsetHeight < 40).map((e) => e.id));
            equal(small, [], "too small");
            await (await (await page.$("#page")).contentFrame()).waitForFunction('document.body.innerText.includes("Good")');
            await page.evaluate(() => document.querySelector("#page").scrollIntoView()); // or it is not drawn
            await page.picture(`${name}-${dark ? "dark" : "light"}-all`);
        }, dark ? { only: "chromium" } : {});
    }
}
