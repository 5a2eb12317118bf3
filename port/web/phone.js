// SPDX-License-Identifier: MIT
//
// The sensors of a phone, as a source of samples (sink.js).

const TIMEOUT = 2000; // milliseconds without a reading

export async function phone(sink) {
    if (typeof DeviceMotionEvent === "undefined") {
        throw new Error("This browser has no motion sensors.");
    }
    if (DeviceMotionEvent.requestPermission && (await DeviceMotionEvent.requestPermission()) !== "granted") {
        throw new Error("The browser does not let this page read the motion sensors. Reload the page, and allow it when asked.");
    }
    let hasReading = false;
    const onMotion = ({ accelerationIncludingGravity: a, rotationRate: w, timeStamp }) => {
        if (!a || a.x === null) {
            return;
        }
        hasReading = true;
        const gyro = w && w.beta !== null ? [w.beta, w.gamma, w.alpha] : null;
        sink.sample({ columns: 3, time: null, acc: [a.x, a.y, a.z], gyro }, timeStamp / 1000);
    };
    addEventListener("devicemotion", onMotion);
    const timer = setTimeout(() => {
        if (!hasReading) {
            sink.notify(isSecureContext ? "No readings arrive. This device has no motion sensors, or the browser's settings block them." : "Browsers let pages read motion sensors only over https. Open this page from an https address or from a file.");
        }
    }, TIMEOUT);
    return {
        stop() {
            clearTimeout(timer);
            removeEventListener("devicemotion", onMotion);
        },
    };
}
