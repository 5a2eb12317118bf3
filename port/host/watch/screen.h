/* SPDX-License-Identifier: MIT
 *
 * watch/screen.h: a live calibration on a screen that is redrawn: where the device points and where it is
 * to, which directions are covered, how well everything is known, and what it comes to (frame.h).
 */
#ifndef WATCH_SCREEN_H
#define WATCH_SCREEN_H

#include "watch/state.h"

/* 1 if it is the standard output, and a terminal that can be drawn on: not dumb, with Braille (the console of
 * Linux has none), and large enough. */
int screen_is_possible(FILE *talk);

/* Draws at each WATCH_PASSED, in one write. Each time the cursor is hidden and shown again, and
 * colours are taken off: whatever ends the program leaves the terminal as it was. A bell says that a position is
 * good, that a rest is refused, and that all is good. */
void screen_tell(const watch_state *now, watch_news what);

#endif
