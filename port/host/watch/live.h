/* SPDX-License-Identifier: MIT
 *
 * watch/live.h: guides the user through a calibration while the samples come in.
 */
#ifndef LIVE_H
#define LIVE_H

#include "read/log_rests.h"
#include "watch/live_options.h"

/* Reads a stream to its end, or until it is interrupted (Ctrl-C), gives instructions, and collects
 * the positions. Malformed lines are reported and skipped. Output is a screen if options->out is a
 * terminal that can show one (screen.h), else lines (lines.h).
 *
 * gyro  as in rests_read.
 *
 * Returns as rests_read; release the result as there. */
int live_read(positions *p, const char *path, const live_options *options, gyro_log *gyro,
              rests_summary *summary);

#endif
