// SPDX-License-Identifier: MIT
//
// Runs the tool on a log: table, report, CAL.json, exports, with the same bytes as from the native tool.
import { run, commandLine, splitArguments } from "./tool.js";
import { $ } from "./dom.js";
import { save } from "./save.js";

const LARGEST = 2 ** 31 - 1; // bytes: the largest 32-bit file position

let files = [];
let outputs = null; // CAL.json and report.html
let running = null;

const operand = () => files[0].name.replace(/^-+/, "./$&");
const args = () => ["calibrate", operand(), ...splitArguments($("options").value), "--out", "CAL.json", "--report", "report.html"];

function showCommand() {
    $("command").textContent = files.length > 0 ? commandLine(args()) : "";
}

function showError(text) {
    $("trouble").textContent = text;
    $("trouble").hidden = text === "";
}

// The log is the first file; options may name the others, such as an earlier calibration.
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
    outputs = null;
    $("made").hidden = true;
    showError("");
    if (files[0].blob.size > LARGEST) {
        showError(`${files[0].name} is larger than 2 GB, too large for a page. Use the command line:\n${commandLine(args())}`);
        return;
    }
    $("progress").hidden = false;
    $("progress").value = 0;
    $("cancel").disabled = false;
    const mine = run(args(), files, (share) => ($("progress").value = share));
    running = mine;
    try {
        const { code, stdout, stderr, files: written } = await mine;
        showError(stderr.trim());
        if (written.has("CAL.json")) {
            outputs = written;
            $("made").hidden = false;
            $("table").textContent = stdout;
            $("page").src = URL.createObjectURL(new Blob([written.get("report.html")], { type: "text/html" }));
        } else if (code === 0 || !stderr) {
            showError(`The program ended with exit code ${code} and gave no result.`);
        }
    } catch (error) {
        showError(error.message === "cancelled" ? "Cancelled." : `${error.message}. Use the command line:\n${commandLine(args())}`);
    } finally {
        if (running === mine) {
            $("progress").hidden = true;
            $("cancel").disabled = true;
        }
    }
}

async function exportFile() {
    const format = $("format").value;
    const exportArgs = ["export", "CAL.json", "--format", format, ...splitArguments($("export-options").value)];
    const { code, stdout, stderr } = await run(exportArgs, [{ name: "CAL.json", blob: new Blob([outputs.get("CAL.json")]) }]);
    $("exported").textContent = stderr.trim() || "Saved.";
    if (code === 0) {
        const ending = { c: "h", "c-arrays": "h", fusion: "h", imu_tk: "calib", "imu_tk-gyro": "calib", ros: "yaml", px4: "params", ardupilot: "param" };
        save(`calibration.${ending[format]}`, stdout);
    }
}

$("options").oninput = showCommand;
$("options").onchange = showCommand;
$("options").onkeydown = (event) => event.key === "Enter" && calibrate();
$("run").onclick = calibrate;
$("cancel").onclick = () => running?.cancel();
$("replay").onclick = () => dispatchEvent(new CustomEvent("replay", { detail: files[0].blob }));
$("export").onclick = exportFile;
document.querySelectorAll("[data-save]").forEach((button) => {
    button.onclick = () => save(button.dataset.save, outputs.get(button.dataset.save));
});
