// SPDX-License-Identifier: MIT
//
// node tests/web/wasi.mjs PROGRAM.wasm: runs it.
import { WASI } from "node:wasi";
import { readFileSync } from "node:fs";

const wasi = new WASI({ version: "preview1", args: ["program"], returnOnExit: true });
const module = new WebAssembly.Module(readFileSync(process.argv[2]));
process.exitCode = wasi.start(new WebAssembly.Instance(module, { wasi_snapshot_preview1: wasi.wasiImport }));
