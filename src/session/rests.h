/* SPDX-License-Identifier: MIT
 *
 * Internal: the detector of rests.
 *
 * The user turns the device, holds it, and turns it again. The detector finds the rests (static
 * intervals: stretches in which only noise changes the readings) in the stream of raw samples,
 * trims the motion at their ends, and sums the samples between exactly. There is nothing to tune:
 * no threshold in counts or m/s^2, no quiet time at the beginning. It learns from the stream:
 *
 *     noise    variance inside a block of about 1/8 s, a low quantile of all quiet blocks
 *     wander   squared distance of a block mean from the trend, also a low quantile: hand tremor
 *     quantum  the smallest change of a reading
 *     reach    how far readings have moved from the last rest: the scale of "another orientation"
 *
 * A block is quiet if its variance is that of the noise, and belongs to the rest if its mean is
 * where the rest expects it. After trimming, 0.6 s of blocks make a position; holding longer makes
 * it better. The slope over the last two seconds detects a slow turn, which a threshold on a
 * variance cannot: 0.3 degrees/s (up to 1 mg of noise, 100 Hz or more) never passes for a rest.
 *
 * All three axes are treated alike and together, and the decisions do not depend on unit, offset or
 * order of the axes. All arithmetic is in integers. Raw counts may be any int32. Noise may reach
 * 65,000 counts (standard deviation); more looks like motion, and so do readings that creep by more
 * than 500,000 counts in one rest. Noise is what stays the same: a steady vibration counts as rest,
 * and adds to the variance. It works for a magnetometer too.
 *
 * A rest needs 2 seconds (from 32 Hz on; 5 at 10 Hz). About 0.5 s are trimmed at its beginning,
 * 0.3 s at its end.
 *
 * Members of invcal_private_rests. A level is a logarithm, see rests.c:
 *
 *     stage, flags, hold, drift   of the current rest, see rests.c
 *     pended    its newest blocks, held back, up to 2; 0: none
 *     skip      quiet blocks to skip before it begins
 *     reason    of the last refusal
 *     taken     1: `place` is that of a position
 *     seen      of the block
 *     run       blocks in a row of another noise level, or of none
 *     least     min blocks of a position, however short the time to hold
 *     bits      a block has 1 << bits samples
 *     dwell     min blocks with the time to hold
 *     blocks    summed in the rest, without those held back; at most 1.6 hours
 *     pace      blocks in 1/125 s, 1/65536
 *     noise, wander, reach   levels, learned from the stream; 0: not known yet
 *     other     candidate for a new noise level
 *     missing   samples until the block is full; 0: the next one begins a block
 *     span      twice the largest difference for the fast sum; 0: none
 *     quantum   smallest change seen inside a block, counts; 0: none yet
 *     time      samples in full blocks so far, modulo 2^32
 *     low       lower limit
 *     between   readings between low and the upper limit
 *     square    of the block: squares of the differences, the three axes together; then their
 *               variance
 *     begin     of the rest: first block's first sample
 *     end       after the newest block
 *     variance  of the rest: sum over its blocks and those held back, 1/64 counts^2
 *
 * and of an axis. Means are in 1/1024 counts:
 *
 *     first     first sample of the block
 *     sum       of the differences to it, modulo 2^32; then the block's mean from origin
 *     origin    what block means are relative to
 *     place     of the last position; before the first one, of the first block
 *     total     sum of the samples of the rest, relative to origin, modulo 2^64
 *     pending   means of the blocks held back: lost if motion follows
 *     once      exponential mean of the means
 *     lag       its lead over its own exponential mean
 *
 * Begin a stream at rest, if you can: its beginning counts as noise until something quieter
 * follows, and if the device moves at several g, the first second may look like a rest.
 */
#ifndef INVCAL_RESTS_H
#define INVCAL_RESTS_H

#include "invcal/invcal.h"
#include "../core/names.h"

#define INVCAL_RATE_MIN 8    /* samples per second */
#define INVCAL_RATE_MAX 8000 /* the same */

/* A rest. */
typedef struct {
    int64_t sum[3];       /* of the raw samples, exact */
    uint32_t count;       /* how many, > 0 */
    uint32_t begin, end;  /* index of the first, and of the one after the last; fewer than
                             end - begin are summed if the rest was disturbed in between. Samples
                             in full blocks count, from 0, modulo 2^32 */
    invcal_real variance; /* of one sample about its block, counts^2, the mean of the three axes */
} invcali_rest;

/* Begins a stream.
 *
 * rate  samples per second, INVCAL_RATE_MIN ... INVCAL_RATE_MAX; an error of 10 % does no harm.
 *
 * Returns INVCAL_OK; INVCAL_BAD_RATE for any other. */
invcal_status invcali_rests_init(invcal_private_rests *rests, invcal_real rate);

/* Sets the counts at which the sensor clips (-32768, 32767), from now on. Without it only the
 * ends of int32 count as clipped.
 *
 * Returns INVCAL_OK; INVCAL_BAD_LIMITS unless low < high. */
invcal_status invcali_rests_rails(invcal_private_rests *rests, int32_t low, int32_t high);

/* Sets how long a rest must be measured from now on, trimmed ends not included; a shorter one is
 * refused. If the current rest is READY but shorter, it is no longer READY; READY is returned again
 * later.
 *
 * milliseconds  clamped to 600 (the minimum for a position) ... 3,600,000. */
void invcali_rests_hold(invcal_private_rests *rests, uint32_t milliseconds);

/* Feeds one sample, of any value.
 *
 * Returns what happened. INVCAL_TAKEN comes 0.6 to 1 s after motion began. Costs as much as
 * invcal_session_feed. */
invcal_event invcali_rests_feed(invcal_private_rests *rests, const int32_t raw[3]);

/* Call it where samples were lost: a new block begins. The rest goes on if the next samples agree
 * with it; otherwise it ends as if by motion. */
void invcali_rests_gap(invcal_private_rests *rests);

/* Ends the stream: closes the current rest, if any, as motion would.
 *
 * Returns INVCAL_TAKEN, INVCAL_REFUSED, or INVCAL_MOVING if there is none. Samples may follow; what
 * was learned is kept. */
invcal_event invcali_rests_finish(invcal_private_rests *rests);

/* Progress of the current position, percent of the time to hold: 0 in motion, 100 from READY on. It
 * does not fall during a rest, unless the rest is refused for drift and restarts, or the time to
 * hold is raised. */
unsigned invcali_rests_progress(const invcal_private_rests *rests);

/* Why the last rest was REFUSED: an INVCAL_REST_ of invcal_status. INVCAL_OK after READY or TAKEN,
 * and before the first. */
invcal_status invcali_rests_reason(const invcal_private_rests *rests);

/* The rest that is READY, as measured so far without the newest quarter of a second; or the one
 * just TAKEN, until the next sample. Returns 1; 0, out untouched, if there is neither. */
int invcali_rests_get(const invcal_private_rests *rests, invcali_rest *out);

/* Only the mean of its samples: computed from differences, so the size of the sum costs no
 * precision. Within 1 ulp of the largest reading; returns as invcali_rests_get. */
int invcali_rests_mean(const invcal_private_rests *rests, invcal_real mean[3]);

#endif
