/* SPDX-License-Identifier: MIT
 *
 * watch/frame.h: the screen of a live calibration, as characters.
 */
#ifndef WATCH_FRAME_H
#define WATCH_FRAME_H

#include "watch/canvas.h"
#include "watch/state.h"

/* CANVAS_LINES lines of at most CANVAS_COLUMNS columns, `line_end` after each. Returns text. */
const char *frame_print(const watch_state *now, const char *line_end, char text[CANVAS_BYTES]);

#endif
