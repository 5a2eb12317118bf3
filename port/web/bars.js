// SPDX-License-Identifier: MIT
//
// The uncertainty of each kind of parameter, against the target.
import { $, setText } from "./dom.js";
import { figure } from "./words.js";

export const KINDS = [
    { name: "offsets", unit: " mg", scale: 1e3 },
    { name: "scales", unit: " %", scale: 100 },
    { name: "angles", unit: "°", scale: 180 / Math.PI },
];
const GYRO_GOAL = 0.05; // degrees a second

const bars = [...KINDS, { name: "gyro" }].map(({ name }) => {
    const bar = document.createElement("div");
    bar.className = "bar";
    bar.innerHTML = `<b></b><i><u></u><s></s></i><span></span>`;
    bar.firstChild.textContent = name;
    bar.querySelector("s").style.left = "10%";
    $("bars").append(bar);
    return bar;
});

// Logarithmic: the goal is at a tenth of the bar, a hundred times the goal at its end. Unknown values have no bar.
function show(bar, ratio, text) {
    const width = Math.max(2, Math.min(100, 10 + 45 * Math.log10(ratio)));
    bar.querySelector("u").style.width = `${Number.isFinite(width) ? width : 0}%`;
    bar.classList.toggle("ok", ratio <= 1);
    setText(bar.lastChild, text);
}

function showKind(bar, { unit, scale }, sigma, goal) {
    if (!(sigma < 1)) { // nine positions for nine parameters do not determine sigma
        show(bar, NaN, "not yet known");
        return;
    }
    const goalText = goal < Infinity ? ` (goal ${Number((goal * scale).toPrecision(3))})` : "";
    show(bar, sigma / goal, `± ${figure(sigma * scale)}${unit}${sigma <= goal ? " ✓" : goalText}`);
}

function showGyro(bar, session) {
    const gyro = session?.hasGyro ? session.gyro.result() : null;
    bar.hidden = !session?.hasGyro;
    bar.classList.toggle("free", !session?.gyroUnit);
    if (!gyro) {
        show(bar, NaN, "after three positions");
        return;
    }
    if (!session.gyroUnit) {
        show(bar, NaN, `± ${figure(2 * gyro.sigma)}, unit unknown`);
        return;
    }
    const sigma = 2 * gyro.sigma * session.gyroUnit;
    show(bar, sigma / GYRO_GOAL, `± ${figure(sigma)} °/s${sigma <= GYRO_GOAL ? " ✓" : ` (goal ${GYRO_GOAL})`}`);
}

export function showBars(session) {
    KINDS.forEach((kind, i) => showKind(bars[i], kind, session?.result?.sigma?.[i], session?.options.target[i]));
    showGyro(bars[3], session);
}
