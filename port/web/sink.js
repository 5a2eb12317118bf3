// SPDX-License-Identifier: MIT
//
// Receives samples. A source (serial.js, phone.js, replay.js, simulator.js) gets a sink,
//
//     sink.sample(sample, seconds)   one sample (lines.js), and its time of arrival
//     sink.gap()                     samples were lost
//     sink.notify(text)              a message for the user
//     sink.end(lines)                there are no more samples
//
// and returns { stop, ... } or a promise of it.
import { many } from "./words.js";

// isCurrent: whether the session is still running. notify, stop: functions of the page.
export function makeSink(session, { isCurrent, notify, stop }) {
    return {
        sample(sample, seconds) {
            if (!isCurrent()) {
                return;
            }
            try {
                session.add(sample, seconds);
            } catch (error) {
                notify(`${error.message}. State them under Settings.`);
                stop();
            }
        },
        gap: () => session.gap(),
        notify: (text) => isCurrent() && notify(text),
        end(lines) {
            const before = session.pending.length;
            session.finish();
            stop();
            if (before > 0) {
                notify(`${many(before, "reading")} only: a calibration needs at least one second of them to begin with.`);
            } else if (lines?.taken === 0) {
                notify("No line of this log looks like x,y,z or t,x,y,z. The report below may understand other formats.");
            }
        },
    };
}
