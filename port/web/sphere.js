// SPDX-License-Identifier: MIT
//
// The picture: a sphere of directions in the frame of the case. Its centre is the direction that points up now, so
// it turns with the sensor.

const SPOTS = 400;
const REACH = 0.43; // radius over the size of the canvas
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (v) => v.map((x) => x / (Math.hypot(...v) || 1));

// Evenly spread: a Fibonacci spiral.
export const DIRECTIONS = Array.from({ length: SPOTS }, (_, i) => {
    const z = 1 - (2 * (i + 0.5)) / SPOTS;
    const r = Math.sqrt(1 - z * z);
    const angle = i * 2.399963229728653;
    return [r * Math.cos(angle), r * Math.sin(angle), z];
});

const FACES = [["+x", [1, 0, 0]], ["−x", [-1, 0, 0]], ["+y", [0, 1, 0]], ["−y", [0, -1, 0]], ["+z", [0, 0, 1]], ["−z", [0, 0, -1]]];

// Degrees between two directions.
export function between(a, b) {
    const cosine = dot(unit(a), unit(b));
    return (Math.acos(Math.max(-1, Math.min(1, cosine))) * 180) / Math.PI;
}

export class Sphere {
    constructor(canvas) {
        this.canvas = canvas;
        this.right = [1, 0, 0];
        this.updateColours();
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.updateColours());
    }

    updateColours() {
        const style = getComputedStyle(document.documentElement);
        const colour = (name) => style.getPropertyValue(`--${name}`).trim();
        this.colours = Object.fromEntries(["ink", "soft", "card", "paper", "accent", "good", "known", "open"].map((n) => [n, colour(n)]));
        this.lastKey = null;
    }

    // now: { up, next, positions, sigmas, progress, isReady }
    draw(now) {
        this.pixelRatio = Math.min(2, devicePixelRatio);
        const size = Math.min(640, Math.round(this.canvas.clientWidth * this.pixelRatio));
        const key = JSON.stringify([size, now.up.map((v) => Math.round(v * 500)), now.next, now.positions.length, now.progress, now.isReady]);
        if (key === this.lastKey || size === 0) {
            return;
        }
        this.lastKey = key;
        if (this.canvas.width !== size) {
            this.canvas.width = this.canvas.height = size;
        }
        this.g = this.canvas.getContext("2d");
        this.size = size;
        this.radius = size * REACH;
        this.setCamera(unit(now.up));
        this.drawDots(now);
        this.drawPositions(now.positions);
        this.drawFaces();
        this.drawTarget(now);
        this.drawCrosshair();
        this.drawProgress(now);
    }

    // Centres `up`, with the least rotation since the last frame.
    setCamera(up) {
        let right = this.right.map((v, i) => v - dot(this.right, up) * up[i]);
        if (Math.hypot(...right) < 0.1) {
            right = cross(up, Math.abs(up[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0]);
        }
        this.right = unit(right);
        this.axes = [this.right, cross(up, this.right), up];
    }

    // Position on the canvas, and distance in front of it.
    project(d) {
        const [x, y, z] = this.axes.map((a) => dot(a, d));
        return [this.size / 2 + this.radius * x, this.size / 2 - this.radius * y, z];
    }

    drawDisc(x, y, r, fill) {
        this.g.beginPath();
        this.g.arc(x, y, r, 0, 2 * Math.PI);
        this.g.fillStyle = fill;
        this.g.fill();
    }

    drawRing(x, y, r, width, colour, share = 1) {
        this.g.beginPath();
        this.g.arc(x, y, r, -Math.PI / 2, -Math.PI / 2 + 2 * Math.PI * share);
        this.g.lineWidth = width;
        this.g.strokeStyle = colour;
        this.g.stroke();
    }

    drawText(text, x, y, size, colour) {
        this.g.font = `600 ${size}px system-ui, sans-serif`;
        this.g.textAlign = "center";
        this.g.textBaseline = "middle";
        this.g.fillStyle = colour;
        this.g.fillText(text, x, y);
    }

    // Uncertain directions have large dots of the colour "open", the others small ones of "known".
    drawDots({ sigmas }) {
        const { g, size, radius, colours } = this;
        g.clearRect(0, 0, size, size);
        this.drawDisc(size / 2, size / 2, radius * 1.04, colours.card);
        DIRECTIONS.forEach((d, i) => {
            const [x, y, z] = this.project(d);
            if (z < 0.03) {
                return;
            }
            const open = sigmas ? Math.max(0, Math.min(1, Math.log10(sigmas[i] / 0.6) / 2)) : 1;
            g.globalAlpha = 0.25 + 0.6 * z;
            g.beginPath();
            const r = radius * (0.018 + 0.047 * open);
            g.ellipse(x, y, r, r * Math.max(0.25, z), Math.atan2(y - size / 2, x - size / 2) + Math.PI / 2, 0, 2 * Math.PI);
            g.fillStyle = open > 0.35 ? colours.open : colours.known;
            g.fill();
        });
        g.globalAlpha = 1;
    }

    drawFaces() {
        for (const [name, d] of FACES) {
            const [x, y, z] = this.project(d);
            if (z > 0.05) {
                this.drawText(name, x, y - this.size * 0.05, Math.max(this.size * 0.034, 12 * this.pixelRatio), this.colours.ink);
            }
        }
    }

    drawPositions(positions) {
        positions.forEach((p, i) => {
            const [x, y, z] = this.project(unit(p));
            if (z > 0) {
                const r = Math.max(this.size * 0.019, 8 * this.pixelRatio);
                this.drawDisc(x, y, r + 2, this.colours.paper);
                this.drawDisc(x, y, r, this.colours.accent);
                this.drawText(String(i + 1), x, y, 1.2 * r, this.colours.paper);
            }
        });
    }

    // A ring at the next direction, and an arrow to it.
    drawTarget({ up, next }) {
        if (!next) {
            return;
        }
        const { g, size, radius, colours } = this;
        const [x, y, z] = this.project(next);
        const middle = size / 2;
        const far = Math.hypot(x - middle, y - middle) || 1;
        const [ex, ey] = far > 1 ? [(x - middle) / far, (y - middle) / far] : [1, 0];
        if (z > 0) {
            this.drawRing(x, y, size * 0.04, size * 0.009, colours.good);
        }
        if (between(up, next) < 14) {
            return;
        }
        const tip = (z > 0 ? far : radius) - size * 0.05;
        const head = size * 0.035;
        g.strokeStyle = g.fillStyle = colours.ink;
        g.lineWidth = size * 0.01;
        g.beginPath();
        g.moveTo(middle + ex * size * 0.05, middle + ey * size * 0.05);
        g.lineTo(middle + ex * (tip - head), middle + ey * (tip - head));
        g.stroke();
        g.beginPath();
        g.moveTo(middle + ex * tip, middle + ey * tip);
        g.lineTo(middle + ex * (tip - head) - ey * head * 0.6, middle + ey * (tip - head) + ex * head * 0.6);
        g.lineTo(middle + ex * (tip - head) + ey * head * 0.6, middle + ey * (tip - head) - ex * head * 0.6);
        g.fill();
    }

    // The direction that points up now.
    drawCrosshair() {
        const { g, size, colours } = this;
        const c = size / 2;
        this.drawRing(c, c, size * 0.022, size * 0.007, colours.ink);
        g.beginPath();
        for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
            g.moveTo(c + dx * size * 0.015, c + dy * size * 0.015);
            g.lineTo(c + dx * size * 0.035, c + dy * size * 0.035);
        }
        g.stroke();
    }

    drawProgress({ progress, isReady }) {
        if (progress > 0) {
            this.drawRing(this.size / 2, this.size / 2, this.radius * 1.09, this.size * 0.022, isReady ? this.colours.good : this.colours.accent, progress / 100);
        }
    }
}
