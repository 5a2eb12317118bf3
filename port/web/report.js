// SPDX-License-Identifier: MIT
//
// A log, by the tool itself: table, report, CAL.json, exports. Each has the bytes that the native tool writes.
import { run, typed, words } from "./tool.js";
import { $ } from "./dom.js";
import { save } from "./save.js";

const LARGEST = 2 ** 31 - 1; // bytes: what a 32-bit file position holds

let files = [];
let made = null; // CAL.json and report.html
let running = null;

const operand = () => files[0].name.replace(/^-+/, "./$&");
const args = () => ["calibrate", operand(), ...words($("options").value), "--out", "CAL.json", "--report", "report.html"];

function showCommand() {
    $("command").textContent = files.length > 0 ? typed(args()) : "";
}

function trouble(text) {
    $("trouble").textContent = text;
    $("trouble").hidden = text === "";
}

// The log is the first file; others, such as an earlier calibration, options may name.
export async function showLog(given, options = null) {
    files = given.map((file) => ({ name: file.name, blob: file }));
    $("name").textContent = files[0].name;
    $("options").value = options ? options.join(" ") : $("options").value;
    $("report").hidden = false;
    $("report").scrollIntoView({ block: "start" });
    await calibrate();
}

async function calibrate() {
    running?.cancel();
    showCommand();
    made = null;
    $("made").hidden = true;
    trouble("");
    if (files[0].blob.size > LARGEST) {
        trouble(`${files[0].name} is larger than 2 GB, too large for a page. Use the command line:\n${typed(args())}`);
        return;
    }
    $("progress").hidden = false;
    $("progress").value = 0;
    $("cancel").disabled = false;
    const mine = run(args(), files, (share) => ($("progress").value = share));
    running = mine;
    try {
        const { code, stdout, stderr, files: written } = await mine;
        trouble(stderr.trim());
        if (written.has("CAL.json")) {
            made = written;
            $("made").hidden = false;
            $("table").textContent = stdout;
            $("page").src = URL.createObjectURL(new Blob([written.get("report.html")], { type: "text/html" }));
        } else if (code === 0 || !stderr) {
            trouble(`The program ended with exit code ${code} and gave no result.`);
        }
    } catch (error) {
        trouble(error.message === "cancelled" ? "Cancelled." : `${error.message}. Use the command line:\n${typed(args())}`);
    } finally {
        if (running === mine) {
            $("progress").hidden = true;
            $("cancel").disabled = true;
        }
    }
}

async function exported() {
    const format = $("format").value;
    const given = ["export", "CAL.json", "--format", format, ...words($("export-options").value)];
    const { code, stdout, stderr } = await run(given, [{ name: "CAL.json", blob: new Blob([made.get("CAL.json")]) }]);
    $("exported").textContent = stderr.trim() || "Saved.";
    if (code === 0) {
        const ending = { c: "h", "c-arrays": "h", fusion: "h", imu_tk: "calib", ros: "yaml", px4: "params", ardupilot: "param" };
        save(`calibration.${ending[format]}`, stdout);
    }
}

$("options").oninput = showCommand;
$("options").onchange = showCommand;
$("options").onkeydown = (event) => event.key === "Enter" && calibrate();
$("run").onclick = calibrate;
$("cancel").onclick = () => running?.cancel();
$("replay").onclick = () => dispatchEvent(new CustomEvent("replay", { detail: files[0].blob }));
$("export").onclick = exported;
document.querySelectorAll("[data-save]").forEach((button) => {
    button.onclick = () => save(button.dataset.save, made.get(button.dataset.save));
});
