// SPDX-License-Identifier: MIT
//
// Runs the tool in a worker.
import { toolModule, workerUrl } from "./inlined.js";

// Splits a command line as a shell does.
export function splitArguments(line) {
    return [...line.matchAll(/(?:[^\s"']+|"[^"]*"|'[^']*')+/g)].map(([word]) => word.replace(/["']/g, ""));
}

// A command line to type, with quotes where needed.
export function commandLine(args) {
    const quoted = (word) => (/^[\w.,:+\-/=@%]+$/.test(word) ? word : `'${word.replace(/'/g, "'\\''")}'`);
    return ["invcal", ...args].map(quoted).join(" ");
}

// `files` are { name, blob }. The promise has a method `cancel`. It resolves to { code, stdout, stderr, files }, stdout
// and stderr as strings, files as a Map from name to bytes.
export function run(args, files = [], progress = () => {}) {
    let worker;
    let cancel;
    const result = new Promise((resolve, reject) => {
        cancel = () => {
            worker?.terminate();
            worker = null;
            reject(new Error("cancelled"));
        };
        toolModule().then((module) => {
            if (worker === null) {
                return;
            }
            worker = new Worker(workerUrl());
            worker.onerror = (event) => reject(new Error(event.message || "the worker does not start"));
            worker.onmessage = async ({ data }) => {
                if ("progress" in data) {
                    progress(data.progress);
                    return;
                }
                worker.terminate();
                if (data.failed) {
                    reject(new Error(data.failed));
                    return;
                }
                const written = new Map(data.files.map(({ name, bytes }) => [name, bytes]));
                resolve({ code: data.code, stdout: await data.stdout.text(), stderr: await data.stderr.text(), files: written });
            };
            worker.postMessage({ module, args, files });
        }, reject);
    });
    result.cancel = cancel;
    return result;
}
