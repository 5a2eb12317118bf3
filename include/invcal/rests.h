/* SPDX-License-Identifier: MIT
 *
 * invcal/rests.h: raw samples in, means of rests out.
 *
 * Whoever calibrates turns the device, holds it, turns it again. Here the rests (static intervals:
 * stretches of the stream in which nothing but noise changes the readings) are found in the stream
 * of raw samples, what still moves at their ends is cut off, and the samples between are summed
 * exactly. There is nothing to tune: no threshold in counts or m/s^2, no quiet time at the
 * beginning. What noise is, the stream itself must tell:
 *
 *     noise    variance inside a block of about 1/8 s, a low quantile of all quiet blocks
 *     wander   squared step from block mean to block mean, a low quantile too: a hand holds it
 *     quantum  the smallest change of a reading
 *     reach    how far readings have moved from the last rest: the scale of "another place"
 *
 * A block is quiet if its variance is that of the noise, and belongs to the rest if its mean is
 * where the rest expects it. Blocks of 0.6 s, behind those cut off, make a position; holding on
 * makes it better. The slope of the last two seconds tells a slow turn, which no threshold on a
 * variance sees: 0.3 degrees/s (up to 1 mg of noise, 100 Hz or more) is never taken for a rest.
 *
 * All three axes are treated alike and together, and the decisions depend neither on offset nor on
 * order of the axes, and on the unit only as far as logarithms are rounded. Everything is computed
 * in integers. Raw counts may be any int32. Noise may reach 65,000 counts (standard deviation), more
 * looks like motion; so do readings that creep away by more than 500,000 counts in one rest. Noise
 * is what stays the same: a vibration that does so too counts as rest, and adds to the variance. A
 * magnetometer's samples are found the same.
 *
 * A rest wants 2 seconds (from 32 Hz on; 5 at 10 Hz). About 0.5 s are cut off at its beginning,
 * 0.3 s at its end.
 *
 * Let a stream begin at rest, if you can: what it begins with is taken for noise until something
 * quieter is seen, and in motion of several g the first second may look like a rest.
 */
#ifndef INVCAL_RESTS_H
#define INVCAL_RESTS_H

#include "invcal/status.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_RATE_MIN 8    /* samples per second */
#define INVCAL_RATE_MAX 8000 /* the same */

/* What a sample brought about. */
typedef enum {
    INVCAL_NOTHING,  /* nothing: its block is not full */
    INVCAL_MOVING,   /* block full: motion, or a rest disturbed for a moment */
    INVCAL_SETTLING, /* block full: quiet; see invcal_rests_progress */
    INVCAL_READY,    /* enough for a position, said once in a rest: move on, or hold on and make it
                        better */
    INVCAL_TAKEN,    /* motion, or the end, closed a position: see invcal_rests_get. READY came
                        before, but for a rest that only the motion after it showed to be none of
                        the faults below */
    INVCAL_REFUSED   /* a rest, but no position: see invcal_rests_reason; said once */
} invcal_event;

/* A rest. */
typedef struct {
    int64_t sum[3];       /* of the raw samples, exact */
    uint32_t count;       /* how many, > 0 */
    uint32_t begin, end;  /* index of the first, and of the one after the last; fewer than
                             end - begin are summed if the rest was disturbed in between. Samples
                             count from 0, in blocks that were full, modulo 2^32 */
    invcal_real variance; /* of one sample about its block, counts^2, the mean of the three axes */
} invcal_rest;

/* The detector: 200 bytes. Nothing in it is meant to be read or changed. What is called a level is a
 * logarithm, see rests.c. */
typedef struct {
    uint8_t stage, reason, flags, seen, pended, skip, hold, drift, run, frozen, seek; /* rests.c */
    uint8_t bits;     /* a block has 1 << bits samples */
    uint8_t least;    /* blocks that make a position, however short the time to hold */
    uint16_t dwell;   /* the same with it */
    uint16_t rate;    /* samples per second */
    int16_t pace;     /* level of (blocks per second)^2 */
    int16_t noise;    /* level, learned from the stream, see above; 0: nothing is known yet */
    int16_t wander;   /* and this */
    int16_t reach;    /* and this */
    int16_t other;    /* another noise level in the making */
    uint16_t span;    /* twice what differences may be to be added quickly; 0: none */
    uint16_t blocks;  /* of the candidate: committed. It stops growing at 65535, after 1.6 hours */
    uint16_t lag;     /* of `once` behind a slope of one a block, 1/256 blocks */
    uint16_t spread;  /* and of `twice` behind `once` */
    uint32_t missing; /* samples until the block is full; 0: the next begins another */
    uint32_t quantum; /* smallest change ever seen inside a block, counts; 0: none as yet */
    uint32_t time;    /* samples in full blocks so far, modulo 2^32 */
    int32_t low;      /* rail, the least that the sensor reads */
    uint32_t between; /* readings between low and the other rail */
    uint32_t begin, end;   /* of the blocks committed */
    int32_t first[3];      /* sample of the block being filled, */
    uint32_t sum[3];       /* sums of the differences to it, modulo 2^32, */
    uint32_t square;       /* and of their squares, the three axes together; its overflow */
    uint32_t carry;        /* counts here */
    int32_t origin[3];     /* a place that means of blocks are relative to */
    int32_t once[3];       /* fading mean of the candidate's block means, 1/256 counts, */
    int32_t twice[3];      /* and fading mean of that mean */
    int32_t place[3];      /* where the position taken last was; before that, the first sample */
    int64_t total[3];      /* sum of the blocks committed, relative to origin */
    int32_t pending[2][3]; /* sums of the newest quiet blocks: lost if motion follows */
    uint64_t variance;     /* sum over the candidate's blocks, 1/64 counts^2 */
} invcal_rests;

/* Begins a stream.
 *
 * rate  samples per second, INVCAL_RATE_MIN ... INVCAL_RATE_MAX; to 10 % is good enough.
 *
 * Returns INVCAL_OK; INVCAL_BAD_RATE for any other. */
invcal_status invcal_rests_init(invcal_rests *rests, unsigned rate);

/* The counts at which the sensor clips (-32768, 32767), to be called before the first sample. Not
 * called: clipping is not noticed, but at the ends of int32.
 *
 * Returns INVCAL_OK; INVCAL_BAD_RAILS unless low < high. */
invcal_status invcal_rests_rails(invcal_rests *rests, int32_t low, int32_t high);

/* From now on a rest must be measured for so long, what is cut off not counted, or is refused as
 * too short. A rest that is READY and has not been measured so long is READY no more: it will be
 * said again.
 *
 * milliseconds  up to an hour, more counts as that; where unsigned has 16 bits it ends at 65 s. Less
 *               than what makes a position anyway, 0.6 s, counts as that. */
void invcal_rests_hold(invcal_rests *rests, unsigned milliseconds);

/* Takes in one sample, of any value.
 *
 * Returns what happened. A position is handed out 0.5 to 1.1 s after motion began.
 * Cost: 45 instructions on a Cortex-M4, 70 on an M0+, more close to a rail, in motion, with noise of
 * hundreds of counts, and, if the sensor counts in steps, in the first half minute; with every full
 * block 650 or 1,300 more. No division. Stack: about 170 bytes (Cortex-M4F, -Os). */
invcal_event invcal_rests_feed(invcal_rests *rests, const int32_t raw[3]);

/* Samples were lost here; a block begins anew. The rest goes on if what comes agrees with it, and
 * ends as by motion if it does not. */
void invcal_rests_gap(invcal_rests *rests);

/* The stream ends: the rest that is going on, if any, is closed as motion would.
 *
 * Returns INVCAL_TAKEN, INVCAL_REFUSED, or INVCAL_MOVING if there is none. Samples may follow; what
 * has been learned stays. */
invcal_event invcal_rests_finish(invcal_rests *rests);

/* How much of a position is there, percent of the time to hold: 0 in motion, 100 from READY on. It
 * does not fall as long as the rest goes on, unless it is refused for drift and begins anew, or is
 * to be held longer. */
unsigned invcal_rests_progress(const invcal_rests *rests);

/* Why the last rest was REFUSED: an INVCAL_REST_ of invcal_status. INVCAL_OK after READY or TAKEN,
 * and before the first. */
invcal_status invcal_rests_reason(const invcal_rests *rests);

/* The rest that is READY, as good as it is by now, the newest quarter of a second held back; or the
 * one just TAKEN, until the next sample. Returns 1; 0, out untouched, if there is neither. */
int invcal_rests_get(const invcal_rests *rests, invcal_rest *out);

/* The mean of the samples: sum / count in whole counts and a fraction, so nothing that an
 * invcal_real can hold is lost to the size of the sum. 0 for a rest with no samples, or a sum that
 * so many int32 do not have. */
void invcal_rest_mean(const invcal_rest *rest, invcal_real mean[3]);

#ifdef __cplusplus
}
#endif

#endif
