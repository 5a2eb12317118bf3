/* SPDX-License-Identifier: MIT
 *
 * watch/wave.h: leading a person through the calibration of a magnetometer while it is waved: which directions it
 * has not passed through yet, what disturbs it, and when that is enough.
 */
#ifndef WATCH_WAVE_H
#define WATCH_WAVE_H

#include "read/waved.h"
#include "watch/wish.h"

/* As live_read (live.h); of the wish rate, field, target, need, field_sigma, told and talk count. need is over the field,
 * or, where the field is not known (0), in the unit of the readings.
 *
 * Returns, and is to be released, as waved_read. */
int wave_read(positions *p, const char *path, const invcal_calibration *nominal,
              const live_wish *wish, waved *out);

#endif
