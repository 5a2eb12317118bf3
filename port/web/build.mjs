// SPDX-License-Identifier: MIT
//
// node port/web/build.mjs BUILD VERSION: puts page, style, scripts and both programs into BUILD/invcal.html. The npm
// packages are in BUILD/web/npm, the programs in BUILD/web.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const build = process.argv[2];
const here = fileURLToPath(new URL(".", import.meta.url));
const npm = `${build}/web/npm/node_modules`;
const text = (name) => readFileSync(name, "utf8");

// Bundles a script with its modules.
function bundle(name, format) {
    return execFileSync(`${npm}/.bin/esbuild`, [here + name, "--bundle", "--minify", "--charset=utf8", "--target=es2022", `--format=${format}`], { env: { ...process.env, NODE_PATH: npm }, encoding: "utf8" }).trim();
}

// The code must not end its script element.
const script = (code) => code.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
const program = (name) => gzipSync(readFileSync(`${build}/web/${name}.wasm`), { level: 9 }).toString("base64");
const escaped = (t) => t.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
const style = execFileSync(`${npm}/.bin/esbuild`, ["--minify", "--loader=css"], { input: text(`${here}page.css`), encoding: "utf8" }).trim();

const parts = {
    STYLE: style,
    VERSION: process.argv[3],
    LICENCES: escaped(
        `invcal\n\n${text(`${here}../../LICENSE`)}\n\n@bjorn3/browser_wasi_shim\n\n${text(`${npm}/@bjorn3/browser_wasi_shim/LICENSE-MIT`)}\n\nwasi-libc and compiler-rt\n\n${text(`${here}licences.txt`)}`,
    ),
    LIVE: program("live"),
    TOOL: program("tool"),
    WORKER: script(bundle("worker.js", "iife")),
    SCRIPT: script(bundle("page.js", "esm")),
};
const page = text(`${here}page.html`).replace(/@([A-Z]+)@/g, (_, name) => parts[name]);
writeFileSync(`${build}/invcal.html`, page);
const size = page.length - parts.TOOL.length - parts.WORKER.length;
console.log(`invcal.html: ${Buffer.byteLength(page)} bytes, ${size} of them for the live part`);
