/* SPDX-License-Identifier: MIT
 *
 * What any sequence of calls leaves in a structure that only the library writes, proved by induction:
 * the proof of its module begins with any state for which the invariant holds (as much of it as the
 * code relies on), makes any one call, and shows that it still holds; and that it holds after init. So
 * no loop has to be followed, and no number of samples is too large.
 */
#ifndef HISTORY_H
#define HISTORY_H

#include "arbitrary.h"

/* A condition that Eva must prove: if it cannot, it raises an alarm, a division by zero. */
#define HOLDS(comparison) ((void)(1 / (comparison)))
#define WITHIN(x, low, high) (HOLDS((x) >= (low)), HOLDS((x) <= (high)))

#define INT32_BETWEEN(low, high) ((int32_t)Frama_C_long_interval(low, high))
#define UINT32_BETWEEN(low, high) ((uint32_t)Frama_C_unsigned_long_interval(low, high))
#define INT64_BETWEEN(low, high) Frama_C_long_long_interval(low, high)

#endif
