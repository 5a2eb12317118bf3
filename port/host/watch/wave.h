/* SPDX-License-Identifier: MIT
 *
 * watch/wave.h: guides the user through the calibration of a magnetometer while it is waved: which
 * directions are missing, what disturbs it, and when to stop.
 */
#ifndef WATCH_WAVE_H
#define WATCH_WAVE_H

#include "read/magnetometer_log.h"
#include "watch/live_options.h"

/* As live_read (live.h); uses rate, field, target, need, field_sigma, units and out of the options.
 * need is over the field, or, if the field is unknown (0), in the unit of the readings.
 *
 * Returns as magnetometer_log_read; release the result as there. */
int wave_read(positions *p, const char *path, const invcal_calibration *nominal,
              const live_options *options, magnetometer_log *out);

#endif
