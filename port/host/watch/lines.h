/* SPDX-License-Identifier: MIT
 *
 * watch/lines.h: a live calibration in lines, one below the other. On a terminal the progress of a rest is
 * shown on one line that changes.
 */
#ifndef WATCH_LINES_H
#define WATCH_LINES_H

#include "watch/state.h"

void lines_tell(const watch_state *now, watch_news what);

#endif
