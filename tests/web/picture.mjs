// SPDX-License-Identifier: MIT
//
// node tests/web/picture.mjs BUILD chromium: makes port/manual/browser.png, the page in the middle of a calibration.
import { test, runAll } from "./harness.mjs";

test("picture", async (open) => {
    const page = await open({ width: 880, height: 700 });
    await page.select("#speed", "4");
    await page.click("#simulator");
    await page.until("invcal.session()?.positions.length >= 10", "ten positions", 60000);
    await page.until('invcal.session().state === "moving" && document.querySelector("#where").textContent.replace(/°.*/, "") > 35', "a turn");
    await page.screenshot({ path: "port/manual/browser.png", clip: { x: 0, y: 0, width: 880, height: 656 } });
});

await runAll();
