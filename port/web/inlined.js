// SPDX-License-Identifier: MIT
//
// Both programs, and the worker's script, which build.mjs has put into the page as text.

// base64 of gzip -> bytes, without a network request.
async function inlined(id) {
    const packed = Uint8Array.from(atob(document.getElementById(id).textContent), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
}

let tool;
export function toolModule() {
    tool ??= inlined("tool-wasm").then((bytes) => WebAssembly.compile(bytes));
    return tool;
}

let worker;
export function workerUrl() {
    worker ??= URL.createObjectURL(new Blob([document.getElementById("worker").textContent], { type: "text/javascript" }));
    return worker;
}

export async function liveInstance() {
    return (await WebAssembly.instantiate(await inlined("live-wasm"), {})).instance.exports;
}
