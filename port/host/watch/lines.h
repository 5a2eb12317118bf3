/* SPDX-License-Identifier: MIT
 *
 * watch/lines.h: a live calibration as lines of text. On a terminal, one line is overwritten with
 * the progress of a rest.
 */
#ifndef WATCH_LINES_H
#define WATCH_LINES_H

#include "watch/state.h"

void lines_update(const watch_state *now, watch_event event);

#endif
