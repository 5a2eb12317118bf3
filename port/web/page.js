// SPDX-License-Identifier: MIT
//
// The page: buttons to sources, a session to pictures and words.
import { liveInstance } from "./inlined.js";
import { Session } from "./session.js";
import { Sphere, DIRECTIONS, between } from "./sphere.js";
import * as sources from "./sources.js";
import { showLog } from "./report.js";
import { save } from "./save.js";
import { sound } from "./sound.js";

const $ = (id) => document.getElementById(id);
const sphere = new Sphere($("sphere"));
const live = await liveInstance();
let session = null;
let source = null; // what is running, or was
let isRunning = false;
let gains = null;
let isTold = false; // that it may be stopped, by sound

// ---- words -----------------------------------------------------------------------------------------

const put = (element, text) => {
    if (element.textContent !== text) {
        element.textContent = text;
    }
};
const notice = (text) => put($("notice"), text);
const say = (text) => put($("said"), text); // to a screen reader
const many = (n, thing) => `${n} ${thing}${n === 1 ? "" : "s"}`;
const clock = (seconds) => `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, "0")}`;
const turnTo = (words) => `Turn to ${words.replaceAll("-", "−").replace(" deg", "°")}`;

const BARS = [
    { name: "offsets", unit: "mg", scale: 1e3 },
    { name: "scales", unit: "%", scale: 100 },
    { name: "angles", unit: "°", scale: 180 / Math.PI },
];
const bars = [...BARS, { name: "gyro" }].map(({ name }) => {
    const bar = document.createElement("div");
    bar.className = "bar";
    bar.innerHTML = `<b></b><i><u></u><s></s></i><span></span>`;
    bar.firstChild.textContent = name;
    bar.querySelector("s").style.left = "10%";
    $("bars").append(bar);
    return bar;
});

// Logarithmic: a tenth of the bar is the target, all of it a hundred times as much. Without a target there is none.
function showBar(bar, ratio, text) {
    const width = Math.max(2, Math.min(100, 10 + 45 * Math.log10(ratio)));
    bar.querySelector("u").style.width = `${Number.isFinite(width) ? width : 100}%`;
    bar.classList.toggle("ok", ratio <= 1);
    put(bar.lastChild, text);
}

function showBars() {
    const sigma = session?.result?.sigma;
    BARS.forEach(({ unit, scale }, i) => {
        const target = session?.options.target[i];
        const isKnown = sigma && sigma[i] < 1; // nine positions for nine parameters tell nothing of sigma
        const wanted = target < Infinity ? ` (${Number((target * scale).toPrecision(3))})` : "";
        showBar(bars[i], isKnown ? sigma[i] / target : NaN, isKnown ? `± ${figure(sigma[i] * scale)} ${unit}${sigma[i] <= target ? " ✓" : wanted}` : "not yet known");
    });
    showGyro(bars[3]);
}

const GYRO_TARGET = 0.05; // degrees a second

function showGyro(bar) {
    const gyro = session?.hasGyro ? session.gyro.result() : null;
    bar.hidden = !session?.hasGyro;
    if (!gyro) {
        showBar(bar, NaN, "after three positions");
        return;
    }
    const scale = session.gyroUnit;
    const sigma = 2 * gyro.sigma * (scale ?? 1);
    const isEnough = sigma <= GYRO_TARGET;
    bar.classList.toggle("free", !scale);
    showBar(bar, scale ? sigma / GYRO_TARGET : NaN, `± ${figure(sigma)} ${scale ? `°/s${isEnough ? " ✓" : ` (${GYRO_TARGET})`}` : "of its readings"}`);
}

const figure = (v) => String(Number(v.toPrecision(2)));

const MEANING = {
    good: "Go on: few positions check it so far.",
    "no redundancy": "Nothing checks it yet: go on.",
    rough: "Residuals that noise does not explain: was it moved, or knocked? Go on, holding it still.",
    drifting: "The sensor drifts: let it warm up, and begin again.",
    bent: "An axis is not linear, or has hysteresis: no calibration of this kind takes that out.",
    weak: "Some directions are missing: follow the arrow.",
};

// Its class, its headline, and what stands behind.
function verdict() {
    const { result, positions } = session ?? {};
    if (!session || positions.length === 0) {
        return ["", "–", "nine positions are the least, twelve to eighteen are good"];
    }
    const taken = many(positions.length, "position");
    if (result.status !== 0) {
        const missing = 9 - positions.length;
        return missing > 0 ? ["", taken, `${missing} more, and it can be calibrated`] : ["caution", "Not yet", result.text];
    }
    const left = result.leftOut > 0 ? `, ${result.leftOut} of them left out, for contradicting the others` : "";
    const rest = `${taken}${left}${positions.length > 9 ? `; residuals ${figure(1e3 * result.rms)} mg` : ""}.`;
    if (result.mayStop) {
        return ["good", "✓ Good: you may stop", rest];
    }
    if (result.isGood) {
        return ["good", "✓ Good, not yet as exact as wanted", `${rest} Go on, or stop here.`];
    }
    const name = result.verdict === "good" ? "good so far" : result.verdict;
    return ["caution", name[0].toUpperCase() + name.slice(1), `${rest} ${MEANING[result.verdict]}`];
}

function instruction() {
    if (!session) {
        return "Choose a source, or drop a log here";
    }
    if (!isRunning) {
        return session.result?.mayStop ? "Done" : "Stopped";
    }
    if (!session.unit) {
        return "Hold it still: listening …";
    }
    if (session.result?.mayStop) {
        return "✓ Done: you may stop";
    }
    if (session.isReady()) {
        return `✓ ${turnTo(session.words)}`;
    }
    if (session.state === "settling") {
        return `Hold still … ${session.progress()} %`;
    }
    if (session.state === "refused") {
        return `Not taken: ${session.refused.at(-1)}`;
    }
    return turnTo(session.words);
}

// Is there somewhere to turn to?
const isLed = () => isRunning && session.unit && !session.result?.mayStop;

function where() {
    if (!session) {
        return "Nothing at hand? The simulator shows how it goes.";
    }
    if (!isLed() || (session.state === "settling" && !session.isReady())) {
        return "";
    }
    return `${Math.round(between(session.up, session.next))}° to go`;
}

function facts() {
    if (!session?.unit) {
        return "";
    }
    const seconds = session.seconds - session.began;
    const skipped = source?.lines?.skipped ? `, ${many(source.lines.skipped, "line")} skipped` : "";
    return `${clock(seconds)} · ${session.samples} samples, ${session.rate.toPrecision(3)} a second${skipped} · read as ${session.unit.name}${rounding()}`;
}

// What steps of readings mean.
function rounding() {
    const { step, unit } = session;
    const mg = (1e3 * step * unit.factor) / unit.counts;
    if (!(mg > 2)) { // finer than the noise of any phone
        return "";
    }
    return `. The browser rounds the readings to ${figure(mg)} mg: a position held very still may be wrong by ${figure(mg / 2)} mg, or refused, since nothing changes. The ± above tells what that does. It shows how calibration works; it is no instrument.`;
}

// ---- pictures --------------------------------------------------------------------------------------

const IDLE = { up: [0.35, 0.45, 0.82], next: null, positions: [], gains: null, progress: 0, isReady: false };

function show() {
    requestAnimationFrame(show);
    const isLive = session?.unit;
    const progress = isLive ? session.progress() : 0;
    const isReady = Boolean(isLive) && session.isReady();
    sphere.draw(isLive ? { up: session.up, next: isLed() ? session.next : null, positions: session.positions, gains, progress, isReady } : IDLE);
    put($("say"), instruction());
    $("hold").firstChild.style.width = `${progress}%`;
    $("hold").setAttribute("aria-valuenow", progress);
    $("hold").classList.toggle("ready", isReady);
    put($("where"), where());
    put($("facts"), facts());
}

function showKnown() {
    showBars();
    const [kind, head, text] = verdict();
    $("verdict").className = kind;
    put($("verdict").firstChild, head);
    put($("verdict").lastChild, text);
    const refused = session?.refused ?? [];
    put($("refused"), refused.length > 0 ? `${many(refused.length, "rest")} refused, at last: ${refused.at(-1)}` : "");
    const result = session?.result;
    $("take").hidden = !(result && result.status === 0);
    if (!$("take").hidden) {
        put($("constant"), constant(result));
        $("send").disabled = !source?.send || !isRunning;
    }
}

// What invcal_apply of the library takes.
function constant({ offset, matrix }) {
    const row = (v) => `{${v.map((x) => Number(x.toPrecision(9))).join(", ")}}`;
    const gyro = session.hasGyro ? session.gyro.result() : null;
    const bias = gyro ? `\nstatic const float gyro_bias[3] = ${row(gyro.mean.map((v) => Number(v.toPrecision(4))))};` : "";
    return `/* g = matrix (reading - offset); reading: ${session.unit.name} */\nstatic const float offset[3] = ${row(offset)};\nstatic const float matrix[3][3] = {\n    ${matrix.map(row).join(",\n    ")}};${bias}`;
}

function happened(name) {
    if (name === "taken") {
        gains = session.uncertainty(DIRECTIONS);
        say(`Position ${session.positions.length} taken. ${verdict()[1]}. ${instruction()}`);
    } else if (name === "ready") {
        say(instruction());
    } else if (name === "refused") {
        say(`Not taken: ${session.refused.at(-1)}. ${turnTo(session.words)}`);
    }
    const tone = name === "taken" ? (session.result.mayStop && !isTold ? "stop" : null) : name === "ready" || name === "refused" ? name : null;
    isTold ||= tone === "stop";
    if (tone && $("sound").checked) {
        sound(tone);
    }
    if (name === "taken" || name === "refused") {
        showKnown();
    }
}

// ---- sources ---------------------------------------------------------------------------------------

const positive = (id) => {
    const value = Number($(id).value.replace(",", "."));
    return value > 0 ? value : null;
};

function options(own) {
    const target = [0, 1, 2].map((i) => (positive(`target${i}`) ?? Infinity) / BARS[i].scale);
    return { rate: positive("rate"), unit: $("unit").value, gyro: $("gyro").value, target, ...own };
}

async function stop() {
    const old = source;
    source = old && { lines: old.lines }; // what it skipped is still shown
    isRunning = false;
    document.querySelectorAll("#sources [aria-pressed]").forEach((button) => button.setAttribute("aria-pressed", "false"));
    $("stop").disabled = true;
    await old?.stop?.();
    showKnown();
}

// Begins again with a source; `own` are the options that it knows better than the settings.
async function start(button, begin, own = {}) {
    await stop();
    notice("");
    put($("sent"), "");
    gains = null;
    isTold = false;
    source = null;
    const mine = new Session(live, options(own), happened);
    const sink = {
        sample(sample, seconds) {
            if (session !== mine || !isRunning) {
                return;
            }
            try {
                mine.add(sample, seconds);
            } catch (error) {
                notice(`${error.message}. See the settings.`);
                stop();
            }
        },
        gap: () => mine.gap(),
        tell: notice,
        end(lines) {
            if (mine.first.length > 0) {
                notice(`${many(mine.samples + mine.first.length, "reading")}: less than a second of them, too few to begin with.`);
            } else if (lines?.taken === 0) {
                notice("No line of it is x,y,z, t,x,y,z or the like. The report below may know more formats.");
            }
            mine.finish();
            stop();
        },
    };
    session = mine;
    isRunning = true;
    document.body.classList.remove("log-only");
    button?.setAttribute("aria-pressed", "true");
    $("stop").disabled = false;
    showKnown();
    try {
        source = await begin(sink, mine);
        if (!isRunning || session !== mine) {
            await source.stop();
        }
    } catch (error) {
        session = null;
        await stop();
        notice(error.name === "NotFoundError" ? "No port was chosen." : error.name === "NetworkError" || error.name === "InvalidStateError" ? "The port does not open: does another program, such as a serial monitor, use it?" : error.message);
    }
}

const NO_SERIAL = "This browser cannot open serial ports: use Chrome, Edge, Opera or a recent Firefox on a computer. Or save what the board prints to a file, and drop that here.";
const NOT_SECURE = "Browsers open serial ports for pages from https or from a file only: save this page, and open it from there.";

$("serial").onclick = () => {
    if (!navigator.serial) {
        notice(isSecureContext ? NO_SERIAL : NOT_SECURE);
        return;
    }
    const onReply = (text) => put($("sent"), `The board says: ${text.replace(/^invcal\W*/, "")}`);
    start($("serial"), (sink) => sources.serial(sink, { baudRate: Number($("baud").value), onReply }));
};
$("phone").onclick = () => start($("phone"), (sink) => sources.phone(sink), { unit: "m/s²", gyro: "°/s", rounds: true });
$("simulator").onclick = () => {
    const speed = Math.min(200, Number($("speed").value));
    start($("simulator"), (sink, mine) => sources.simulator(sink, { speed, wanted: () => mine.next ?? [1, 0, 0] }), { unit: "16384", gyro: "16", rate: 100 });
};
$("stop").onclick = () => {
    session?.finish();
    stop();
};

// ---- logs ------------------------------------------------------------------------------------------

async function take(files) {
    if (files.length > 0) {
        document.body.classList.toggle("log-only", !session);
        await showLog([...files]);
    }
}
$("choose").onclick = () => $("file").click();
$("file").onchange = () => take($("file").files);
addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("dropping");
});
addEventListener("dragleave", () => document.body.classList.remove("dropping"));
addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("dropping");
    take(event.dataTransfer.files);
});
addEventListener("replay", ({ detail: file }) => {
    const rate = positive("rate") ?? 100;
    start(null, (sink) => sources.replay(sink, file, { speed: Number($("speed").value), rate }));
    $("live").scrollIntoView();
});

// ---- take it away ------------------------------------------------------------------------------------

$("copy").onclick = async () => {
    await navigator.clipboard.writeText($("constant").textContent).then(() => put($("sent"), "Copied."), () => put($("sent"), "The browser does not allow it: mark the text, and copy it."));
};

// The line that port/manual/browser.md describes.
export const recordLine = (record) => `invcal ${[...record].map((b) => b.toString(16).padStart(2, "0")).join("")}\n`;

$("send").onclick = async () => {
    put($("sent"), "Sent; the board has not answered yet.");
    await source.send(recordLine(session.result.record)).catch((error) => put($("sent"), `Not sent: ${error.message}`));
};
$("log").onclick = () => save("live.csv", session.csv());
$("make").onclick = () => showLog([new File([session.csv()], "live.csv")], session.toolOptions());

showKnown();
show();
window.invcal = { live, Session, sphere, recordLine, session: () => session }; // for the tests, and the curious
document.documentElement.dataset.ready = "1";
