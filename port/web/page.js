// SPDX-License-Identifier: MIT
//
// The page: connects its buttons with sources of samples, and a session with pictures and texts.
import { liveInstance } from "./inlined.js";
import { $, setText } from "./dom.js";
import { Session } from "./session.js";
import { Sphere, DIRECTIONS } from "./sphere.js";
import { KINDS, showBars } from "./bars.js";
import * as words from "./words.js";
import { makeSink } from "./sink.js";
import { Board, choosePort } from "./serial.js";
import { phone } from "./phone.js";
import { replay } from "./replay.js";
import { simulator } from "./simulator.js";
import { constant, recordLine } from "./formats.js";
import { showLog } from "./report.js";
import { save } from "./save.js";
import { sound } from "./sound.js";

const sphere = new Sphere($("sphere"));
const live = await liveInstance();
const now = { session: null, source: null, isRunning: false };

const notice = (text) => setText($("notice"), text);
const announce = (text) => setText($("said"), text); // to a screen reader

// ---- what is shown -----------------------------------------------------------------------------------

const IDLE = { up: [0.35, 0.45, 0.82], next: null, positions: [], sigmas: null, progress: 0, isReady: false };

function scene(session) {
    const { up, next, positions, sigmas } = session;
    return { up, next: words.isGuiding(now) ? next : null, positions, sigmas, progress: session.progress(), isReady: session.isReady() };
}

// Each frame.
function show() {
    requestAnimationFrame(show);
    const { progress, isReady, ...rest } = now.session?.unit ? scene(now.session) : IDLE;
    sphere.draw({ progress, isReady, ...rest });
    setText($("say"), words.instruction(now));
    setText($("where"), words.where(now));
    setText($("facts"), words.facts(now));
    $("hold").firstChild.style.width = `${progress}%`;
    $("hold").setAttribute("aria-valuenow", progress);
    $("hold").classList.toggle("ready", isReady);
}

// After each position.
function showResult() {
    const { session, source } = now;
    const [kind, head, text] = words.verdict(now);
    showBars(session);
    $("verdict").className = kind;
    setText($("verdict").firstChild, head);
    setText($("verdict").lastChild, text);
    setText($("refused"), words.refused(now));
    $("take").hidden = session?.result?.status !== 0;
    if (!$("take").hidden) {
        setText($("constant"), constant(session));
        $("send").disabled = !source?.send;
    }
}

// ---- what happens ------------------------------------------------------------------------------------

const ANNOUNCEMENTS = {
    taken: ({ positions }) => `Position ${positions.length} taken. ${words.verdict(now)[1]}. ${words.instruction(now)}`,
    ready: () => words.instruction(now),
    refused: (session) => `Not taken: ${session.refused.at(-1)}. ${words.turnTo(session)}`,
};

function handleEvent(name, session) {
    if (!ANNOUNCEMENTS[name]) {
        return;
    }
    announce(ANNOUNCEMENTS[name](session));
    const mayStop = name === "taken" && session.result.mayStop && !session.isAnnounced;
    session.isAnnounced ||= mayStop;
    if ($("sound").checked && (mayStop || name !== "taken")) {
        sound(mayStop ? "stop" : name);
    }
    if (name === "taken") {
        session.sigmas = session.uncertainty(DIRECTIONS);
    }
    if (name !== "ready") {
        showResult();
    }
}

// ---- sources ---------------------------------------------------------------------------------------

const positive = (id) => {
    const value = Number($(id).value.replace(",", "."));
    return value > 0 ? value : null;
};

// From the settings; a source may override them by its `own`.
function options(own) {
    const target = KINDS.map(({ scale }, i) => (positive(`target${i}`) ?? Infinity) / scale);
    return { rate: positive("rate"), unit: $("unit").value, gyro: $("gyro").value, target, ...own };
}

// Keeps the source, to show what it skipped, and to send to the board.
async function stop() {
    now.isRunning = false;
    document.querySelectorAll("#sources [aria-pressed]").forEach((button) => button.setAttribute("aria-pressed", "false"));
    $("stop").disabled = true;
    await now.source?.stop();
    showResult();
}

// Starts a session with a source. If that fails, the previous one stays.
async function start(button, begin, own = {}) {
    await stop();
    const before = { ...now };
    const session = new Session(live, options(own), (name) => handleEvent(name, session));
    const isCurrent = () => now.session === session && now.isRunning;
    notice("");
    setText($("sent"), "");
    Object.assign(now, { session, source: null, isRunning: true });
    document.body.classList.remove("log-only");
    button?.setAttribute("aria-pressed", "true");
    $("stop").disabled = false;
    showResult();
    try {
        const source = await begin(makeSink(session, { isCurrent, notify: notice, stop }), session);
        if (isCurrent()) {
            now.source = source;
        } else {
            await source.stop(); // stopped, or another one begun, meanwhile
        }
    } catch (error) {
        Object.assign(now, before);
        await stop();
        notice(error.message);
    }
}

$("serial").onclick = async () => {
    try {
        const port = await choosePort();
        await start($("serial"), (sink) => new Board(port, sink, Number($("baud").value)).start());
    } catch (error) {
        notice(error.message);
    }
};
$("phone").onclick = () => start($("phone"), phone, { unit: "m/s²", gyro: "°/s", rounds: true });
$("simulator").onclick = () => {
    const speed = Math.min(200, Number($("speed").value));
    start($("simulator"), (sink, session) => simulator(sink, { speed, nextDirection: () => session.next ?? [1, 0, 0] }), { unit: "16384", gyro: "16", rate: 100 });
};
$("stop").onclick = () => {
    now.session?.finish();
    stop();
    announce(words.instruction(now));
};

// ---- logs ------------------------------------------------------------------------------------------

async function openFiles(files) {
    if (files.length > 0) {
        document.body.classList.toggle("log-only", !now.session);
        await showLog([...files]);
    }
}
$("choose").onclick = () => $("file").click();
$("file").onchange = () => openFiles($("file").files);
addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("dropping");
});
addEventListener("dragleave", () => document.body.classList.remove("dropping"));
addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("dropping");
    openFiles(event.dataTransfer.files);
});
addEventListener("replay", ({ detail: file }) => {
    const rate = positive("rate") ?? 100;
    start(null, (sink) => replay(sink, file, { speed: Number($("speed").value), rate }));
    $("live").scrollIntoView();
});

// ---- output ------------------------------------------------------------------------------------------

const sent = (text) => setText($("sent"), text);

$("copy").onclick = async () => {
    await navigator.clipboard.writeText($("constant").textContent).then(() => sent("Copied."), () => sent("The browser does not allow copying. Select the text, and copy it yourself."));
};
$("send").onclick = async () => {
    sent("Sent. Waiting for the board's answer …");
    $("send").disabled = true;
    try {
        const answer = await now.source.send(recordLine(now.session.result.record));
        sent(answer ? `The board says: ${answer.replace(/^invcal\W*/, "")}` : "The board has not answered. Does its program understand the line, as the Arduino example Browser does?");
    } catch (error) {
        sent(`Not sent. ${error.message}`);
    }
    showResult();
};
$("log").onclick = () => save("live.csv", now.session.csv());
$("make").onclick = () => showLog([new File([now.session.csv()], "live.csv")], now.session.toolOptions());

showResult();
show();
window.invcal = { live, Session, sphere, session: () => now.session }; // for the tests
document.documentElement.dataset.ready = "1";
