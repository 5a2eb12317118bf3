// SPDX-License-Identifier: MIT

export const now = () => performance.now() / 1000;
export const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

// Waits until isTrue() is, at most this many seconds; returns whether it is.
export async function until(isTrue, seconds) {
    const end = now() + seconds;
    while (!isTrue() && now() < end) {
        await pause(50);
    }
    return isTrue();
}
