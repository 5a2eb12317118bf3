// SPDX-License-Identifier: MIT
//
// The texts of the page about a calibration. `now` is { session, source, isRunning }; session and source may be null.
import { between } from "./sphere.js";

export const many = (n, thing) => `${n} ${thing}${n === 1 ? "" : "s"}`;
export const figure = (v) => (v < 1e-3 ? "<0.001" : String(Number(v.toPrecision(2))));
const clock = (seconds) => `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, "0")}`;

export const turnTo = (session) => `Turn to ${session.words.replaceAll("-", "−").replace(" deg", "°")}`;

// What to do now.
export function instruction({ session, isRunning }) {
    if (!session) {
        return "Choose a source of readings";
    }
    if (!isRunning) {
        return session.result?.mayStop ? "Done" : "Stopped";
    }
    if (!session.unit) {
        return "Hold it still for a second …";
    }
    if (session.result?.mayStop) {
        return "✓ Done: you may stop";
    }
    if (session.isReady()) {
        return `✓ ${turnTo(session)}`;
    }
    if (session.state === "settling") {
        return `Hold still … ${session.progress()} %`;
    }
    return session.state === "refused" ? `Not taken: ${session.refused.at(-1)}` : turnTo(session);
}

// Returns whether there is somewhere to turn to.
export const isGuiding = ({ session, isRunning }) => isRunning && session.unit && !session.result?.mayStop;

export function where(now) {
    const { session } = now;
    if (!session) {
        return "A board on a serial port, this phone, or a log file, which you may also drop here. Nothing at hand? Try the simulator.";
    }
    if (!isGuiding(now) || (session.state === "settling" && !session.isReady())) {
        return "";
    }
    return `${Math.round(between(session.up, session.next))}° to go`;
}

const MEANING = {
    good: "Few positions confirm it so far: keep going.",
    "no redundancy": "That is just enough for nine parameters, and nothing confirms them yet: keep going.",
    rough: "The positions disagree by more than noise explains. Was it moved or knocked? Keep going, and hold it still.",
    drifting: "The sensor drifts. Let it warm up, then start again.",
    bent: "An axis is not linear, or has hysteresis. This kind of calibration cannot correct that.",
    weak: "Some directions are missing: follow the arrow.",
};

// Its class, its headline, and the text after it.
export function verdict({ session }) {
    if (!session || session.positions.length === 0) {
        return ["", "No positions yet", "Nine are the minimum, twelve to eighteen are better."];
    }
    const { result, positions } = session;
    const taken = many(positions.length, "position");
    if (result.status !== 0) {
        const missing = 9 - positions.length;
        return missing > 0 ? ["", taken, `${missing} more until there is a result.`] : ["caution", "Not yet", result.text];
    }
    const left = result.leftOut > 0 ? `, ${result.leftOut} of them left out because they contradict the others` : "";
    const rest = `${taken}${left}${positions.length > 9 ? `; residuals ${figure(1e3 * result.rms)} mg` : ""}.`;
    if (result.mayStop) {
        return ["good", "✓ Good: you may stop", rest];
    }
    if (result.isGood) {
        return ["good", "✓ Good, but not yet at your goal", `${rest} Keep going, or stop here.`];
    }
    const name = result.verdict === "good" ? "good so far" : result.verdict;
    return [["good", "no redundancy"].includes(result.verdict) ? "" : "caution", name[0].toUpperCase() + name.slice(1), `${rest} ${MEANING[result.verdict]}`];
}

export function refused({ session }) {
    const all = session?.refused ?? [];
    return all.length > 0 ? `${many(all.length, "hold")} not taken. Last reason: ${all.at(-1)}` : "";
}

export function facts({ session, source }) {
    if (!session?.unit) {
        return "";
    }
    const seconds = session.seconds - session.began;
    const skipped = source?.lines?.skipped ? `, ${many(source.lines.skipped, "line")} skipped` : "";
    return `${clock(seconds)} · ${session.samples} samples, ${session.rate.toPrecision(3)} per second${skipped} · unit: ${session.unit.name}${rounding(session)}`;
}

// The effect of rounding steps of readings.
function rounding({ step, unit }) {
    const mg = (1e3 * step * unit.factor) / unit.counts;
    if (!(mg > 2)) { // finer than the noise of any phone
        return "";
    }
    return `. This browser rounds the readings to ${figure(mg)} mg, so a position held very still may be wrong by ${figure(mg / 2)} mg, or be refused because its readings never change. The ± above includes this, as it comes from how well the positions agree. Good enough to see how a calibration works, but not for measuring.`;
}
