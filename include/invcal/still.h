/* SPDX-License-Identifier: MIT
 *
 * invcal/still.h: raw samples in, means of rest positions out.
 *
 * Whoever calibrates turns the device, holds it, turns it again. This room finds the rests in the
 * stream of raw samples, cuts off what still moves at their ends, and sums the rest exactly.
 * There is nothing to tune: no threshold in counts or m/s^2, no quiet time at the beginning. What
 * noise is, the stream itself must tell:
 *
 *     noise    variance inside a block of 1/8 s, a low quantile of all quiet blocks
 *     wander   squared step from block mean to block mean, a low quantile too: a hand holds it
 *     quantum  the smallest change of a reading
 *     reach    how far readings have moved from the last rest: the scale of "another place"
 *
 * A block is quiet if its variance is that of the noise, and belongs to the rest if its mean is
 * where the rest expects it. Five such blocks, 0.6 s, behind those cut off make a position; holding
 * on makes it better. The slope of the last two seconds tells a slow turn, which no threshold on
 * a variance sees: 0.3 degrees/s (up to 1 mg of noise, 100 Hz or more) is never taken for a rest.
 *
 * All three axes are treated alike and together, and the decisions do not depend on unit, offset
 * or order of the axes. Raw counts may be any int32; noise may reach 4 million counts, more looks
 * like motion. Noise is what stays the same: a vibration that does so too counts as rest, and adds
 * to the variance. A magnetometer's samples are found the same way.
 *
 * A rest wants 2 seconds (from 32 Hz on; 5 at 10 Hz). About 0.5 s are cut off at its beginning,
 * 0.25 s at its end.
 *
 * Let a stream begin at rest, if you can: what it begins with is taken for noise until something
 * quieter is seen, and in motion of several g the first second may look like a rest.
 */
#ifndef INVCAL_STILL_H
#define INVCAL_STILL_H

#include "invcal/block.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_STILL_RATE_MIN 8    /* samples per second */
#define INVCAL_STILL_RATE_MAX 8000 /* likewise */

/* What a sample brought about. */
typedef enum {
    INVCAL_STILL_NONE,     /* nothing: its block of 1/8 s is not full */
    INVCAL_STILL_MOVING,   /* block full: motion, or a rest disturbed for a moment */
    INVCAL_STILL_SETTLING, /* block full: quiet; see invcal_still_progress */
    INVCAL_STILL_READY,    /* enough for a position, said once in a rest: move on, or hold on and
                              make it better */
    INVCAL_STILL_TAKEN,    /* motion, or the end, closed a position: here it is. READY came before,
                              but for a rest that only the motion after it showed to be none of
                              the faults below */
    INVCAL_STILL_REFUSED   /* a rest, but no position: see invcal_still_reason; said once */
} invcal_still_event;

/* Why a rest is no position. */
typedef enum {
    INVCAL_REST_GOOD,    /* it is one */
    INVCAL_REST_SHORT,   /* motion came before it was READY */
    INVCAL_REST_DRIFT,   /* readings creep: a slow turn, or it settles */
    INVCAL_REST_CLIPPED, /* a rail was touched */
    INVCAL_REST_FROZEN,  /* nothing has ever changed, or noise ceased, or an axis stands still amid
                            the noise of the others: not read, or at a rail that was not stated */
    INVCAL_REST_GAP,     /* short, for samples were lost */
    INVCAL_REST_SAME     /* where the last position was taken: it tells nothing new */
} invcal_rest_reason;

/* A rest that was taken. */
typedef struct {
    int64_t sum[3];       /* of the raw samples, exact */
    uint32_t count;       /* how many, > 0 */
    uint32_t begin, end;  /* index of the first, and of the one after the last; fewer than
                             end - begin are summed if the rest was disturbed in between. Samples
                             count from 0, in blocks that were full, modulo 2^32 */
    invcal_real variance; /* of one sample about its block, counts^2, the mean of the three axes */
} invcal_rest;

/* Internal: the fading regression of block means on time. */
typedef struct {
    invcal_real weight;             /* of all blocks; the newest has 1 */
    invcal_real mean_t, mean[3];    /* t in blocks, 0 at the newest; relative to origin */
    invcal_real var_t, cov[3], var; /* weighted sums of squares about these means */
} invcal_trend;

/* 248 bytes on a 32-bit machine (float). Nothing in it is meant to be read or changed. */
typedef struct {
    invcal_block block; /* the one being filled */
    uint32_t time;      /* samples in full blocks so far, modulo 2^32 */

    invcal_real noise;  /* learned from the stream, see above; negative: nothing is known yet */
    invcal_real wander; /* likewise */
    invcal_real reach;  /* squared, as all of these */
    invcal_real other;  /* another noise level in the making */
    int32_t place[3];   /* mean of the position taken last; before that, of the first block */

    invcal_real newest[3]; /* mean of the block before, relative to origin */
    int32_t origin[3];     /* of the candidate: mean of its first block, zero of what follows */
    int64_t total[3];      /* of the candidate: sum of the blocks committed, relative to origin */
    int32_t pending[2][3]; /* sums of the newest quiet blocks: lost if motion follows */
    invcal_trend trend;    /* of the candidate */
    invcal_real variance;  /* mean of its block variances */
    uint32_t begin, end;   /* of the blocks committed */
    uint16_t blocks;       /* committed; a rest stops growing at 65535, after two hours */
    uint8_t dwell;         /* blocks that make a position */
    uint8_t stage, reason, flags, pended, skip, hold, drift, run, frozen; /* see still.c */
} invcal_still;

/* Begins a stream.
 *
 * rate       samples per second, INVCAL_STILL_RATE_MIN ... INVCAL_STILL_RATE_MAX; to 10 % is good
 *            enough.
 * low, high  the counts at which the sensor clips (-32768, 32767), or both 0 if not known: only
 *            the ends of int32 then count as clipped.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING for any other rate (NaN too), or low >= high. */
invcal_status invcal_still_init(invcal_still *still, invcal_real rate, int32_t low, int32_t high);

/* Takes in one sample, of any value.
 *
 * out  written with INVCAL_STILL_TAKEN only: the position that has ended.
 *
 * Returns what happened. A position is handed out 0.6 to 0.8 s after motion began.
 * Cost: see invcal_block_add; with every full block some 150 floating-point operations, 15 of
 * them divisions. Stack: about 350 bytes (float, Cortex-M4F, -Os). */
invcal_still_event invcal_still_push(invcal_still *still, const int32_t raw[3], invcal_rest *out);

/* Samples were lost here; a block begins anew. The rest goes on if what comes agrees with it, and
 * ends as by motion if it does not. */
void invcal_still_gap(invcal_still *still);

/* The stream ends: the rest that is going on, if any, is closed as motion would.
 *
 * Returns INVCAL_STILL_TAKEN, INVCAL_STILL_REFUSED, or INVCAL_STILL_MOVING if there is none.
 * Samples may follow; what has been learned stays. */
invcal_still_event invcal_still_finish(invcal_still *still, invcal_rest *out);

/* How much of a position is there, percent: 0 in motion, 100 from READY on. It does not fall
 * as long as the rest goes on, unless it is refused for drift and begins anew. */
unsigned invcal_still_progress(const invcal_still *still);

/* Of the last REFUSED or TAKEN; INVCAL_REST_GOOD before the first. */
invcal_rest_reason invcal_still_reason(const invcal_still *still);

/* The position in the making, as good as it is by now; the newest quarter of a second is held
 * back. Returns 1, or 0, out untouched, unless READY was said of the rest that is going on. */
int invcal_still_current(const invcal_still *still, invcal_rest *out);

/* The mean of the samples: sum / count, an integer division and its remainder, so nothing that
 * an invcal_real can hold is lost to the size of the sum. A rest with no samples gives 0. */
void invcal_rest_mean(const invcal_rest *rest, invcal_real mean[3]);

/* A sentence for a reason, in plain English without a full stop, in read-only memory.
 * Any value outside the enumeration gives "unknown reason". */
const char *invcal_rest_reason_text(invcal_rest_reason reason);

#ifdef __cplusplus
}
#endif

#endif
