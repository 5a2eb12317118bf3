// SPDX-License-Identifier: MIT
//
// Where samples go. A source (serial.js, phone.js, replay.js, simulator.js) is given a sink,
//
//     sink.sample(sample, seconds)   one sample (lines.js), and when it came
//     sink.gap()                     samples were lost
//     sink.tell(text)                a message for the user
//     sink.end(lines)                there are no more
//
// and returns { stop, ... } or a promise of it.
import { many } from "./words.js";

// isCurrent: does the session still run? tell, stop: what the page does.
export function makeSink(session, { isCurrent, tell, stop }) {
    return {
        sample(sample, seconds) {
            if (!isCurrent()) {
                return;
            }
            try {
                session.add(sample, seconds);
            } catch (error) {
                tell(`${error.message}. State them under Settings.`);
                stop();
            }
        },
        gap: () => session.gap(),
        tell: (text) => isCurrent() && tell(text),
        end(lines) {
            const before = session.first.length;
            session.finish();
            stop();
            if (before > 0) {
                tell(`${many(before, "reading")} only: a calibration needs at least one second of them to begin with.`);
            } else if (lines?.taken === 0) {
                tell("No line of this log looks like x,y,z or t,x,y,z. The report below may understand other formats.");
            }
        },
    };
}
