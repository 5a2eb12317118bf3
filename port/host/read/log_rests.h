/* SPDX-License-Identifier: MIT
 *
 * read/log_rests.h: finds the positions in a log of samples.
 */
#ifndef LOG_RESTS_H
#define LOG_RESTS_H

#include "read/positions.h"
#include "read/recording.h"
#include "read/gyro_log.h"
#include "session/rests.h"

/* INVCAL_REST_SHORT ... INVCAL_REST_SAME: why a rest was refused. */
enum { RESTS_REASONS = INVCAL_REST_SAME - INVCAL_REST_SHORT + 1 };

#define RESTS_SAMPLES 50u /* the minimum of a rest at low rates */
#define RESTS_LISTED 10u  /* refused rests that are listed */

typedef struct {
    double end;         /* seconds from the first sample, approximately */
    unsigned long line; /* approximately */
    invcal_status why;  /* an INVCAL_REST_ */
} rests_refusal;

/* What was found besides the positions. */
typedef struct rests_summary {
    unsigned long samples;
    double seconds;
    double rate;
    int is_rate_known;
    unsigned long gaps;              /* in the times, or by lines that were skipped */
    unsigned long skipped;           /* malformed lines of a live stream, cut ones of a log */
    unsigned refused[RESTS_REASONS]; /* number of refused rests by reason, from INVCAL_REST_SHORT */
    rests_refusal refusal[RESTS_LISTED]; /* the first of them */
    const recording *track;              /* of the log */
    double unit;                         /* input units in a count of it */
} rests_summary;

/* The minimum duration of a rest at this rate, seconds. */
double rests_min_seconds(double rate);

/* The reason in words: why a rest was refused, or its mean is not a reading of this field. */
const char *rests_reason_text(invcal_status reason);

/* Counts a refused rest; `reason` is an INVCAL_REST_. */
void rests_refuse(rests_summary *summary, invcal_status reason, recording *log);

/* Adds a rest to the positions. `unit`: input units in a count. Returns as positions_add. */
int rests_take(positions *p, const invcali_rest *rest, double unit, const recording *log);

/* Turns the sums in noise_square into the noise of a position mean; to be called once, or on a
 * copy. */
void rests_noise(positions *p);

/* At the end of the log, after the last rest: completes the positions and the summary. */
void rests_end(positions *p, const samples *log, rests_summary *summary);

/* Finds the rests in a log ("-": standard input). Memory grows only with the positions and the
 * gyroscope's readings. If the rate is unknown, it assumes 100 samples per second, or 50 or 25 if
 * only these give enough rests for a calibration.
 *
 * rate  samples per second; 0: see samples.h.
 * clip  null, or the smallest and the largest reading of the sensor, input units.
 * gyro  null: the columns of a gyroscope are ignored; else out: its readings, none if there is no
 *       gyroscope. Release it with gyro_log_free in either case.
 *
 * Returns EXIT_GOOD, also without any rest; EXIT_FILE, with a message. Release the positions with
 * positions_free in either case. Their lines are those of the first samples. */
int rests_read(positions *p, const char *path, double rate, const double clip[2], gyro_log *gyro,
               rests_summary *summary);

#endif
