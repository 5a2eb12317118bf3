/* SPDX-License-Identifier: MIT
 *
 * watch/live.h: leading a person through a calibration while the samples come in.
 */
#ifndef LIVE_H
#define LIVE_H

#include "read/rests.h"
#include "watch/wish.h"

/* Reads a stream to its end, or until it is interrupted (Ctrl-C), says what to do, and
 * collects the positions. Malformed lines are reported and skipped. It is shown on a screen if wish.talk is
 * the standard output and can show one (screen.h), else by lines (lines.h).
 *
 * gyro  as in rests_read.
 *
 * Returns, and is to be released, as rests_read. */
int live_read(positions *p, const char *path, const live_wish *wish, gyro_log *gyro,
              rests_summary *summary);

#endif
