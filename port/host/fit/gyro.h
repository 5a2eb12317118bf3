/* SPDX-License-Identifier: MIT
 *
 * fit/gyro.h: calibrates the gyroscope of a log together with the accelerometer, from the moves
 * between rests.
 */
#ifndef GYRO_H
#define GYRO_H

#include "cli/message.h"
#include "fit/rejection.h"
#include "invcal/gyro.h"
#include "imu/turns.h"
#include "read/positions.h"
#include "read/gyro_log.h"
#include "text/unit.h"

typedef struct {
    double rate_unit; /* rad/s in one unit; 0: not stated */
    /* gyroscope axis |axes[i]| - 1 is along accelerometer axis i, reversed if negative; 0: not
     * stated */
    int8_t axes[3];
} gyro_options;

/* A rest. */
typedef struct {
    unsigned position; /* number, from 0 */
    size_t begin, end; /* samples [begin, end) */
    double bias[3];    /* rad/s, nominal, in the axes of the accelerometer */
    double up[3];
} gyro_rest;

/* The move that led to a rest. */
typedef struct {
    unsigned to; /* index of the rest */
    double seconds;
    double angle;      /* of the turn, rad; NaN: unknown */
    double residual;   /* rad, perpendicular to up; NaN: unknown */
    invcal_status why; /* why it is unusable; INVCAL_OK: it is used */
    unsigned turned;   /* with INVCAL_REST_DRIFT: index of the rest in which the device turned */
    double rate;       /* rate of that turn, rad/s: bias of the rest less the median bias */
} gyro_move;

/* The parts of a move's error. */
enum { GYRO_PART_RESTS, GYRO_PART_NOISE, GYRO_PART_BIAS, GYRO_PARTS };

#define GYRO_TEXT_MAX 700
typedef struct {
    int has_readings; /* else the members below are not valid */
    const char *word; /* why there is no calibration: "axes", "unit", ...; null: there is one */
    char reason[GYRO_TEXT_MAX]; /* what is wrong */
    char remedy[GYRO_TEXT_MAX]; /* what to do */
    const gyro_log *log;
    double rate_unit;           /* rad/s in one unit */
    unit_origin rate_unit_from; /* header, option, or size */
    int is_counts;              /* the unit has no name: rate_unit is found from the moves */
    double lag;                 /* delay of the readings, s, which was corrected; 0: none */
    double rail[2][3];          /* minimum and maximum at which an axis is clipped; NaN: none */
    int8_t axes[3];             /* as stated, or 1, 2, 3 */
    invcal_imu_result
        imu; /* both sensors, over the field; the gyroscope in counts, in these axes */
    invcal_calibration calibration; /* input units to rad/s, in the axes of imu.accelerometer */
    double m[3][3];                 /* M of the gyroscope: true rate = M nominal rate */
    double g[3][3];  /* g-sensitivity of the calibrated rate, rad/s per field; 0: not used */
    double interval; /* +- this many sigma cover 95 % */
    gyro_rest rest[INVCAL_MAX_MOVES];
    unsigned rests;
    unsigned earlier_rests; /* rests before these, beyond INVCAL_MAX_MOVES */
    gyro_move move[INVCAL_MAX_MOVES];
    unsigned moves;
    double part[GYRO_PARTS]; /* rad on an axis */
    double range;            /* of temperature over the rests, K; 0: unknown, or too small */
    double thermal[3];       /* slope of the bias, without the effect of orientation, rad/s per K */
    double thermal_sigma[3]; /* its standard deviation */
} gyro_fit;

/* Calibrates both.
 *
 * rate   samples per second, and
 * clip   limits, with which rests_read found the rests.
 * start  approximate calibration of the accelerometer, over the field; null: the rests do not show
 *        it yet.
 * g      out; large. It says what is wrong if there is no calibration.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if memory is short. */
int gyro_make(gyro_fit *g, const gyro_log *log, const gyro_options *options, unsigned rate,
              const double *clip, const positions *p, const rejection *kept,
              const invcal_calibration *start);

/* The information in the rests and moves of the last gyro_make, with the same arguments. Returns 1;
 * 0 if there were no moves. */
int gyro_turns(const gyro_fit *g, const positions *p, const invcal_calibration *start,
               invcali_turns *out);

/* Why a move is unusable. The library's texts of these statuses are about rests. */
const char *gyro_reason(invcal_status why);

/* The same for a move, with the measured rate. */
#define GYRO_REASON_MAX 120
const char *gyro_move_reason(const gyro_fit *g, const gyro_move *m, char text[GYRO_REASON_MAX]);

/* Refuses a solution that leaves parameters undetermined. */
void gyro_refuse_open(gyro_fit *g);

/* ---- internal ----------------------------------------------------------------------------------- */

/* Sets why there is no calibration, and what to do. */
void gyro_refuse(gyro_fit *g, const char *word, const char *format, ...) MESSAGE_FORMAT(3, 4);
void gyro_advise(gyro_fit *g, const char *format, ...) MESSAGE_FORMAT(2, 3);

/* Appends the numbers of unusable moves by their reasons. */
void gyro_add_reasons(gyro_fit *g);

/* No axes fit, the best with this misfit, rad; or several fit. */
void gyro_say_misfit(gyro_fit *g, double misfit);
void gyro_say_unclear(gyro_fit *g);

/* There are too few rests to find their up directions. */
void gyro_say_no_start(gyro_fit *g);

/* By the status that the library returned for the moves. */
void gyro_say_status(gyro_fit *g, invcal_status status);

/* The delay of the gyroscope, in readings, from the moves that both sensors show; 0 if it cannot be
 * found. */
long gyro_find_lag(const gyro_log *log);

/* Converts a reading to the axes of the accelerometer. */
void gyro_axes(const int8_t axes[3], const double x[3], double out[3]);

/* Unit and axes, as found from the moves. */
typedef struct {
    double rate_unit; /* rad/s in one unit, within a few percent */
    double misfit;    /* root mean square, rad */
    int8_t axes[3];   /* that fit best */
    int is_clear;     /* no others fit nearly as well */
    unsigned moves;
} gyro_guess;

/* bias: input units. Returns 1; 0 with fewer than two usable moves. */
int gyro_search(const gyro_log *log, long lag, const gyro_rest *rest, unsigned rests,
                const double bias[3], const int8_t axes[3], gyro_guess *out);

/* After the solution: completes rests, moves, parts and thermal slopes. */
void gyro_measure(gyro_fit *g, long lag, const positions *p);

/* Readings [first, last) of a move from one rest to the next. */
void gyro_between(const gyro_log *log, long lag, const gyro_rest *rest, size_t *first,
                  size_t *last);

#endif
