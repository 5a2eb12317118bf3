/* SPDX-License-Identifier: MIT
 *
 * read/rests.h: the positions in a log of samples.
 */
#ifndef RESTS_H
#define RESTS_H

#include "invcal/expert.h"
#include "read/positions.h"
#include "read/recording.h"
#include "read/turns.h"

/* INVCAL_REST_SHORT ... INVCAL_REST_SAME: why a rest is no position. */
enum { RESTS_REASONS = INVCAL_REST_SAME - INVCAL_REST_SHORT + 1 };

#define RESTS_SAMPLES 50u /* that a rest takes at least, where they are slow */
#define RESTS_TOLD 10u    /* of the refused ones */

typedef struct {
    double end;         /* seconds from the first sample, about */
    unsigned long line; /* about there */
    invcal_status why;  /* an INVCAL_REST_ */
} rests_refusal;

/* What was seen besides the positions. */
typedef struct rests_summary {
    unsigned long samples;
    double seconds;
    double rate;
    int is_rate_known;
    unsigned long gaps;                /* in the times, or of lines that were skipped */
    unsigned long skipped;             /* malformed lines of a live stream, cut ones of a log */
    unsigned refused[RESTS_REASONS];   /* rests, by their reason, from INVCAL_REST_SHORT on */
    rests_refusal refusal[RESTS_TOLD]; /* the first of them */
    const recording *track;            /* what is remembered of the log, */
    double unit;                       /* a count of which is so many input units */
} rests_summary;

/* Seconds that a rest takes at least, so that it is found at this rate. */
double rests_least(double rate);

/* Why a rest is no position, or its mean no reading of this field. */
const char *rests_reason_text(invcal_status reason);

/* Counts a rest that was refused for an INVCAL_REST_. */
void rests_refuse(rests_summary *summary, invcal_status reason, recording *log);

/* Adds a rest to the positions. `unit` is that of a count. Returns as positions_add. */
int rests_take(positions *p, const invcal_rest *rest, double unit, const recording *log);

/* Makes the noise of a position mean of the sums in noise_square: once, or of a copy. */
void rests_noise(positions *p);

/* All rests are taken, and so is the log: completes the positions and the summary. */
void rests_end(positions *p, const samples *log, rests_summary *summary);

/* Finds the rests in a log ("-": standard input), in fixed memory but for the positions. If the rate
 * is unknown, 100 samples per second are assumed; or 50 or 25, if only these find enough rests for a calibration.
 *
 * rate  samples per second; 0: see samples.h.
 * clip  null, or the least and the greatest reading of the sensor, input units.
 *
 * gyro  null: a gyroscope's columns are ignored; else they are kept in it, if there are some: without
 *       readings it is empty. To be released with turns_free in either case.
 *
 * Returns EXIT_GOOD, also without any rest; EXIT_FILE, with a message. The positions are to be
 * released with positions_free in either case; their lines are those of the first samples. */
int rests_read(positions *p, const char *path, double rate, const double clip[2], turns *gyro,
               rests_summary *summary);

#endif
