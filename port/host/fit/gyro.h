/* SPDX-License-Identifier: MIT
 *
 * fit/gyro.h: the gyroscope of a log, and the accelerometer with it, from the moves between rests.
 */
#ifndef GYRO_H
#define GYRO_H

#include "cli/message.h"
#include "fit/rejection.h"
#include "invcal/gyro.h"
#include "read/positions.h"
#include "read/turns.h"
#include "text/unit.h"

/* What is asked for. */
typedef struct {
    double turn; /* rad/s in one unit; 0: not stated */
    int8_t axes
        [3]; /* gyroscope axis |axes[i]| - 1 turns about accelerometer axis i, backwards if it is
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
    double angle;      /* of the turn, rad; NaN: unknown */
    double residual;   /* rad, perpendicular to up; NaN: unknown */
    invcal_status why; /* it is unusable; INVCAL_OK: it counts */
    unsigned turned;   /* INVCAL_REST_DRIFT: that of its two rests in which the device turned, */
    double rate;       /* and how fast, rad/s: by its bias against that of most rests */
} gyro_move;

/* The parts of a move's error. */
enum { GYRO_PART_RESTS, GYRO_PART_NOISE, GYRO_PART_BIAS, GYRO_PARTS };

#define GYRO_TEXT_MAX 700
typedef struct {
    int is_there;     /* there are readings; else nothing below is known */
    const char *word; /* why there is no calibration: "axes", "unit", ...; null: there is one */
    char reason[GYRO_TEXT_MAX]; /* what is wrong, */
    char remedy[GYRO_TEXT_MAX]; /* and what to do */
    const turns *turns;
    double turn;           /* rad/s in one unit, */
    unit_origin turn_from; /* and its source: header, option, size */
    int is_counts;         /* the unit has no name: turn is found from the moves */
    double lag;            /* delay of readings, s, which was corrected; 0: none */
    double rail[2][3]; /* readings of an axis at which it is stuck, least and greatest; NaN: none */
    int8_t axes[3];    /* as stated, or 1, 2, 3 */
    invcal_imu imu;    /* both, over the field; the gyroscope of counts of `unit` in those axes */
    invcal_calibration calibration; /* input units to rad/s, in the axes of imu.accelerometer */
    double g
        [3]
        [3]; /* g-sensitivity of a rate that is corrected by it, rad/s per field; 0: none is used */
    double interval; /* this many sigma to either side cover 95 % */
    gyro_rest rest[INVCAL_MAX_MOVES];
    unsigned rests; /* the last ones */
    unsigned more;  /* rests before them, for which the moves had no room */
    gyro_move move[INVCAL_MAX_MOVES];
    unsigned moves;
    double part[GYRO_PARTS]; /* rad on an axis */
    double range;            /* of temperature over the rests, K; 0: unknown, or too small */
    double thermal[3];       /* of the bias, without the effect of orientation, rad/s per K, */
    double thermal_sigma[3]; /* and standard deviations */
} gyro_fit;

/* Calibrates both.
 *
 * rate   samples per second that rests were found with, and clip as in rests.h.
 * start  the accelerometer, over the field: about; null: the rests do not show it yet.
 * g      out; large.
 *
 * g says what is wrong. Returns EXIT_GOOD; EXIT_FILE, with a message, without memory. */
int gyro_make(gyro_fit *g, const turns *t, const gyro_wish *wish, unsigned rate, const double *clip,
              const positions *p, const rejection *kept, const invcal_calibration *start);

/* The information in the rests and moves of the last gyro_make, whose arguments these were. Returns 1; 0: the moves were
 * not read. */
int gyro_turns(const gyro_fit *g, const positions *p, const invcal_calibration *start,
               invcal_turns *out);

/* Why a move is unusable: the library's texts for rests mean something else there. */
const char *gyro_reason(invcal_status why);

/* The same of this move, with what was measured. */
#define GYRO_REASON_MAX 120
const char *gyro_move_reason(const gyro_fit *g, const gyro_move *m, char text[GYRO_REASON_MAX]);

/* Refuses a solution that leaves parameters open. */
void gyro_refuse_open(gyro_fit *g);

/* ---- inside ------------------------------------------------------------------------------------- */

/* There is no calibration, why, and what to do. */
void gyro_refuse(gyro_fit *g, const char *word, const char *format, ...) MESSAGE_FORMAT(3, 4);
void gyro_advise(gyro_fit *g, const char *format, ...) MESSAGE_FORMAT(2, 3);

/* How many moves are unusable, by their reasons. */
void gyro_add_reasons(gyro_fit *g);

/* No axes fit: misfit is what the best leave, rad; and some fit, but it is not clear which. */
void gyro_say_misfit(gyro_fit *g, double misfit);
void gyro_say_unclear(gyro_fit *g);

/* Too few rests to show which way was up in them. */
void gyro_say_no_start(gyro_fit *g);

/* What the library says of the moves. */
void gyro_say_status(gyro_fit *g, invcal_status status);

/* The delay of the gyroscope, in readings, from the moves that both show; 0 if it cannot be found. */
long gyro_lag(const turns *t);

/* The reading as it is in the axes of the accelerometer, input units. */
void gyro_axes(const int8_t axes[3], const double x[3], double out[3]);

/* Unit and axes, as found from the moves. */
typedef struct {
    double turn;    /* rad/s in one unit, to some percent */
    double misfit;  /* root mean square, rad */
    int8_t axes[3]; /* that fit best, */
    int is_clear;   /* and no others do */
    unsigned moves;
} gyro_guess;

/* bias, input units. Returns 0 with fewer than two usable moves. */
int gyro_search(const turns *t, long lag, const gyro_rest *rest, unsigned rests,
                const double bias[3], const int8_t axes[3], gyro_guess *out);

/* The solution is there: completes rests, moves and parts. */
void gyro_measure(gyro_fit *g, long lag, const positions *p);

/* Readings [first, last) of a move from one rest to the next. */
void gyro_between(const turns *t, long lag, const gyro_rest *rest, size_t *first, size_t *last);

#endif
