/* SPDX-License-Identifier: MIT
 *
 * watch/screen.h: a live calibration on a terminal's screen, redrawn all the time: current and next
 * direction, covered directions, uncertainties, and the verdict so far (frame.h).
 */
#ifndef WATCH_SCREEN_H
#define WATCH_SCREEN_H

#include "watch/state.h"

/* 1 if `out` is the standard output, and a terminal that can be drawn on: not dumb, with Braille
 * (the console of Linux has none), and large enough. */
int screen_is_possible(FILE *out);

/* Draws at each WATCH_TICK, in one write. Each one ends with a visible cursor and no colour, so the
 * program may be ended at any time. A bell rings when a position is good, a rest is refused, and
 * all is good. */
void screen_update(const watch_state *now, watch_event event);

#endif
