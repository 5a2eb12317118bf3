/* SPDX-License-Identifier: MIT
 *
 * fit/gyro.h: the gyroscope of a log, and the accelerometer with it, from the moves between rests.
 */
#ifndef GYRO_H
#define GYRO_H

#include "fit/rejection.h"
#include "invcal/gyro.h"
#include "read/positions.h"
#include "read/turns.h"
#include "text/unit.h"

/* What is asked for. */
typedef struct {
    double turn; /* rad/s in one unit; 0: not stated */
    int8_t axes
        [3]; /* about accelerometer axis i turns gyroscope axis |axes[i]| - 1, backwards if it is
                       negative; 0: not stated */
} gyro_wish;

/* A rest. */
typedef struct {
    unsigned position; /* its number, from 0 */
    size_t begin, end; /* samples */
    double bias[3];    /* rad/s, nominal, in the axes of the accelerometer */
    double up[3];
} gyro_rest;

/* The move that led to rest `to` of the list. */
typedef struct {
    unsigned to;
    double seconds;
    double angle;      /* that was turned, rad */
    double residual;   /* rad, across the way up; NaN: not known */
    invcal_status why; /* it is of no use; INVCAL_OK: it counts */
} gyro_move;

/* What a move's error is made of. */
enum { GYRO_PART_RESTS, GYRO_PART_NOISE, GYRO_PART_BIAS, GYRO_PARTS };

#define GYRO_TEXT_MAX 700
typedef struct {
    int is_there;     /* there are readings; else nothing below is known */
    const char *word; /* why there is no calibration: "axes", "unit", ...; null: there is one */
    char reason[GYRO_TEXT_MAX]; /* what is wrong, */
    char remedy[GYRO_TEXT_MAX]; /* and what to do */
    const turns *turns;
    double turn;           /* rad/s in one unit, */
    unit_origin turn_from; /* and who says so: header, option, size */
    int is_counts;         /* the unit is none that has a name: turn is what the moves tell */
    double lag;            /* seconds that readings are late, which was mended; 0: they are not */
    double rail[2][3]; /* readings of an axis at which it is stuck, least and greatest; NaN: none */
    int8_t axes[3];    /* as stated, or 1, 2, 3 */
    invcal_imu imu;    /* both, over the field; the gyroscope of counts of `unit` in those axes */
    invcal_calibration calibration; /* input units to rad/s, in the axes of imu.accelerometer */
    double interval;                /* so many sigma to either side cover 95 % */
    gyro_rest rest[INVCAL_MAX_MOVES];
    unsigned rests; /* the last ones */
    unsigned more;  /* rests before them, of which the moves found no room */
    gyro_move move[INVCAL_MAX_MOVES];
    unsigned moves;
    double part[GYRO_PARTS]; /* rad on an axis */
    double range;      /* of temperature over the rests, K; 0: not known, or too small to tell */
    double thermal[3]; /* of the bias, without what orientation does, rad/s per K, */
    double thermal_sigma[3]; /* and standard deviations */
} gyro_fit;

/* Calibrates both.
 *
 * rate   samples a second that rests were found with, and clip as in rests.h.
 * start  the accelerometer, over the field: about.
 * g      out; large.
 *
 * What is wrong is told there. Returns EXIT_GOOD; EXIT_FILE, with a message, without memory. */
int gyro_make(gyro_fit *g, const turns *t, const gyro_wish *wish, unsigned rate, const double *clip,
              const positions *p, const rejection *kept, const invcal_calibration *start);

/* Why a move is of no use: what the library says of rests means something else there. */
const char *gyro_reason(invcal_status why);

/* ---- inside ------------------------------------------------------------------------------------- */

/* How many readings late the gyroscope's are, by what moves both show; 0 if they tell nothing. */
long gyro_lag(const turns *t);

/* The reading as it is in the axes of the accelerometer, input units. */
void gyro_axes(const int8_t axes[3], const double x[3], double out[3]);

/* What moves tell of unit and axes. */
typedef struct {
    double turn;    /* rad/s in one unit, to some percent */
    double misfit;  /* root mean square, rad */
    int8_t axes[3]; /* that fit best, */
    int is_clear;   /* and no others do */
    unsigned moves;
} gyro_guess;

/* bias, input units. Returns 0 if fewer than two moves tell anything. */
int gyro_search(const turns *t, long lag, const gyro_rest *rest, unsigned rests,
                const double bias[3], const int8_t axes[3], gyro_guess *out);

/* The solution is there: completes rests, moves and parts. */
void gyro_measure(gyro_fit *g, long lag, const positions *p);

/* Readings [first, last) of a move from one rest to the next. */
void gyro_between(const turns *t, long lag, const gyro_rest *rest, size_t *first, size_t *last);

#endif
