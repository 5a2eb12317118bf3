// SPDX-License-Identifier: MIT
//
// The result as C source, and as a line for a board.
export function constant(session) {
    const { offset, matrix } = session.result;
    const row = (v) => `{${v.map((x) => Number(x.toPrecision(9))).join(", ")}}`;
    const gyro = session.hasGyro ? session.gyro.result() : null;
    const bias = gyro ? `\nstatic const float gyro_bias[3] = ${row(gyro.mean.map((v) => Number(v.toPrecision(4))))};` : "";
    return `/* g = matrix (reading - offset); reading: ${session.unit.name} */\nstatic const float offset[3] = ${row(offset)};\nstatic const float matrix[3][3] = {\n    ${matrix.map(row).join(",\n    ")}};${bias}`;
}

// The line that port/manual/browser.md describes.
export const recordLine = (record) => `invcal ${[...record].map((b) => b.toString(16).padStart(2, "0")).join("")}\n`;
