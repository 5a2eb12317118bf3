/* SPDX-License-Identifier: MIT
 *
 * invcal/gyro.h: the gyroscope, from the same moves.
 *
 * Between two rests the gyroscope must turn the one way up into the other. Twelve quarter turns between the
 * six faces determine the nine elements of its matrix and the nine parameters of the accelerometer, in one
 * solution and without a calibration beforehand. No sample is stored: a move is kept as a few segments.
 *
 *     invcal_moves moves;
 *     invcal_moves_init(&moves, &gyro, 400);                  rad/s per count; samples per second
 *     for every sample of the gyroscope:
 *         invcal_moves_feed(&moves, raw);
 *     for every sample of the accelerometer:
 *         event = invcal_session_feed(&session, raw);
 *         invcal_moves_follow(&moves, &session.rests, event);
 *     invcal_imu_solve(session.mean[0], session.count, &session.nominal, &moves, NULL, &imu);
 *
 * The two sensors may be sampled at different rates. What is assumed of time: samples are fed in the order
 * in which they were taken. Those of the accelerometer may come up to 0.1 s late, which costs nothing, as a
 * rest is cut off 0.3 s before motion was noticed; those of the gyroscope 0.02 s: of 0.05 s the error is
 * twice as large.
 *
 * invcal.h states the rules and units; mathematics.md, "The gyroscope", derives this.
 */
#ifndef INVCAL_GYRO_H
#define INVCAL_GYRO_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Segments of all moves together, 64 to 1000, 14 bytes each; a quarter turn takes five or six, and 24 are kept
 * free for what is going on. Where memory is short, 100 segments and 14 rests hold twelve quarter turns in 1.7 kB. */
#ifndef INVCAL_MAX_SEGMENTS
#define INVCAL_MAX_SEGMENTS 192
#endif
/* Rests that are kept, and so moves: 4 to 32; 10 bytes each. */
#ifndef INVCAL_MAX_MOVES
#define INVCAL_MAX_MOVES 32
#endif
#if INVCAL_MAX_SEGMENTS < 64 || INVCAL_MAX_SEGMENTS > 1000
#error "INVCAL_MAX_SEGMENTS must be from 64 to 1000"
#endif
#if INVCAL_MAX_MOVES < 4 || INVCAL_MAX_MOVES > 32
#error "INVCAL_MAX_MOVES must be from 4 to 32"
#endif

/* A program and a library whose choices differ do not link: see invcal.h. */
#define INVCAL_GYRO_CHOSEN(name) INVCAL_GYRO_CHOSEN_(name, INVCAL_MAX_SEGMENTS, INVCAL_MAX_MOVES)
#define INVCAL_GYRO_CHOSEN_(name, s, m)                                                            \
    INVCAL_GYRO_CHOSEN__(name, INVCAL_REAL_NAME, s, m)                                 /* step */
#define INVCAL_GYRO_CHOSEN__(name, real, s, m) INVCAL_GYRO_CHOSEN___(name, real, s, m) /* step */
#define INVCAL_GYRO_CHOSEN___(name, real, s, m) name##_##real##_##s##_##m              /* step */
#define invcal_moves_init INVCAL_GYRO_CHOSEN(invcal_moves_init)
#define invcal_imu_solve INVCAL_GYRO_CHOSEN(invcal_imu_solve)

/* ---- moves -------------------------------------------------------------------------------------- */

/* At most 20 degrees of a move. Its rotation vector, if the gyroscope were ideal, is v + kappa: of another
 * matrix M it is M v + cof(M) kappa. */
typedef struct {
    int16_t v[3];     /* integral of the nominal rate, 2^-15 rad */
    int16_t kappa[3]; /* what coning adds to it, 2^-18 rad */
    uint16_t time;    /* twice the samples; and 1 if a block of rests ends with it */
} invcal_segment;

/* A rest, and the move that led to it. */
typedef struct {
    int16_t bias[3]; /* beyond moves.bias, 2^-18 rad/s */
    uint16_t when;   /* it was taken, in blocks */
    int8_t move;     /* segments; or -status: invcal_moves_reason */
} invcal_still;

/* All moves: 3.2 kB (float). What is not called internal may be read. */
typedef struct {
    invcal_calibration nominal; /* rad/s per count */
    invcal_real rate;           /* samples per second */
    invcal_real bias[3];        /* that v is free of, rad/s: of the first rest */
    invcal_real rho[3];         /* internal: rotation vector of the segment in the making */
    invcal_real v[3];           /* internal: and its integral */
    int32_t low;                /* rail */
    uint32_t between;           /* readings between it and the other */
    invcal_real still[3];       /* internal: integral since the rest began */
    uint32_t still_samples;     /* internal: and its samples */
    uint32_t samples;           /* internal: of the move since it began */
    uint16_t missing;           /* internal: samples of the segment in the making */
    uint16_t blocks;            /* of rests, so far; at most 65535 */
    uint16_t first, cut,
        fixed;      /* internal: segments of the move begin, of the rest, that are not merged */
    uint16_t used;  /* internal: segments altogether */
    uint8_t marks;  /* internal: blocks among those not merged */
    uint8_t fault;  /* internal: of the move */
    uint8_t spoilt; /* internal: of the segment in the making */
    uint8_t count;  /* rests */
    invcal_still rest[INVCAL_MAX_MOVES];
    invcal_segment segment[INVCAL_MAX_SEGMENTS]; /* of all moves, in their order */
} invcal_moves;

/* Begins.
 *
 * nominal  data sheet: rad/s per count; offset as far as it is known, else 0. Its axes are to be those of
 *          the accelerometer (invcal_imu_mounting).
 * rate     samples per second, 8 ... 8000. An error of it counts as one of the scale.
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOMINAL, INVCAL_BAD_RATE. Nothing is written then. */
invcal_status invcal_moves_init(invcal_moves *moves, const invcal_calibration *nominal,
                                invcal_real rate);

/* The counts at which the gyroscope clips: a move that touches one of them is refused from now on.
 *
 * Returns INVCAL_OK; INVCAL_BAD_RAILS unless low < high. */
invcal_status invcal_moves_rails(invcal_moves *moves, int32_t low, int32_t high);

/* Takes in one sample, moving or not, raw counts. Cost: 150 instructions. Stack: about 120 bytes. */
void invcal_moves_feed(invcal_moves *moves, const int32_t raw[3]);

/* Samples were lost here: this move is refused, rests stay. */
void invcal_moves_gap(invcal_moves *moves);

/* After every sample of the accelerometer, what it brought about. With INVCAL_TAKEN a move ends, and its
 * rest has the bias. A rest that was refused ends none. Where INVCAL_MAX_MOVES rests are there, the oldest
 * goes.
 *
 * rests  the detector of the accelerometer's samples.
 * event  of invcal_session_feed or invcal_rests_feed, or ..._finish: INVCAL_NOTHING costs nothing.
 *
 * Cost: up to 3,000 instructions once in 1/8 s. Stack: about 200 bytes. */
void invcal_moves_follow(invcal_moves *moves, const invcal_rests *rests, invcal_event event);

/* Why the move that led to a rest is of no use: INVCAL_OK; INVCAL_REST_CLIPPED, INVCAL_MOVE_GAP,
 * INVCAL_MOVE_LONG, INVCAL_NO_SPACE; INVCAL_REST_DRIFT: the bias of its two rests differs by 0.5 degrees/s, so
 * in one of them the device turned; INVCAL_MOUNTING: more than seven turns; INVCAL_TOO_FEW: none led to it.
 *
 * rest  from 0, below moves->count. */
invcal_status invcal_moves_reason(const invcal_moves *moves, unsigned rest);

/* ---- both sensors at once ----------------------------------------------------------------------- */

enum { INVCAL_GYRO_PARAMETERS = 9, INVCAL_IMU_PARAMETERS = 18 };

/* What is known beforehand. */
typedef struct {
    uint8_t held;            /* 1: the accelerometer is calibrated, the gyroscope alone is solved */
    invcal_real noise;       /* standard deviation of a position mean, over field; 0: not known */
    invcal_real rate_noise;  /* density, rad/s/sqrt(Hz) */
    invcal_real instability; /* of the bias, rad/s */
    const invcal_real *prior; /* 18 standard deviations from nominal, 0: not known; or null */
} invcal_imu_settings;

/* Where nothing is known: a consumer's gyroscope, 0.005 degrees/s/sqrt(Hz) and 20 degrees/h. */
#define INVCAL_IMU_USUAL {0, 0, INVCAL_REAL(8.7e-5), INVCAL_REAL(1e-4), 0}

/* The result. */
typedef struct {
    /* raw counts to rad/s, in the axes of the accelerometer; its offset is the bias of the last rest */
    invcal_calibration gyro;
    invcal_calibration accelerometer; /* raw counts to field; as handed over where it is held */
    /* M of the gyroscope by rows, true rate = M nominal rate; then the nine of the accelerometer in the
     * order of invcal.h, to the first order: invcal_deviation tells them exactly */
    invcal_real parameter[INVCAL_IMU_PARAMETERS];
    invcal_real sigma[INVCAL_IMU_PARAMETERS]; /* standard deviations; 0 of what is held */
    /* Of the bias, axis by axis: g-sensitivity, rad/s per field along x, y, z; and its drift from the first
     * rest to the last, rad/s. Their standard deviations are 0 if fewer than 12 rests tell them. */
    invcal_real slope[3][4];
    invcal_real slope_sigma[3][4];
    invcal_real noise;      /* of a position mean behind sigma, over field */
    invcal_real move_noise; /* of a move, rad on each axis, root mean square */
    invcal_real move_rms;   /* residuals of moves, rad on each axis, root mean square */
    invcal_real move_max;   /* the largest, both axes together, rad */
    uint32_t left_out; /* bit i: the move to rest i contradicts the others: INVCAL_MOVE_APART */
    uint32_t idle;     /* bit i: it turned nothing: INVCAL_REST_SAME */
    uint32_t open;     /* bit r: parameter r is undetermined; or weak: sigma above 2.5 move_noise */
    uint16_t dof;      /* degrees of freedom left to the residuals */
    uint8_t worst;     /* the rest that the move of move_max led to */
    uint8_t moves;     /* that made it */
    uint8_t passes;    /* that it took */
    uint8_t verdict;   /* an invcal_verdict: good, no redundancy, rough, weak */
    uint8_t g_is_used; /* some g-sensitivity is beyond 4 sigma: it was taken from the moves */
} invcal_imu;

/* Solves both sensors, or the gyroscope beside a calibrated accelerometer.
 *
 * raw            means of the rests, as invcal_calibrate wants them. The last of them belongs to the last
 *                rest of moves, the one before to that before, and so on: more of either are left alone.
 * count          of them.
 * accelerometer  nominal calibration, or the one that is held.
 * settings       INVCAL_IMU_USUAL, and what is known better; or null.
 * out            the result; may not be what accelerometer points into.
 *
 * It takes up to 6 passes of Gauss and Newton, and two more for each move that is left out: three at most, whose
 * residual is beyond 5 sigma of the others', once six are there.
 *
 * Returns INVCAL_OK; else out is lost:
 *   INVCAL_BAD_NOMINAL    the accelerometer's;
 *   INVCAL_BAD_NOISE, INVCAL_BAD_PRIOR    of the settings: negative or no number, or noise of 1 and more;
 *   INVCAL_OUT_OF_RANGE   a mean is no reading of this field;
 *   INVCAL_TOO_FEW        no moves, or fewer equations than unknowns;
 *   INVCAL_UNDETERMINED   out->open names what is left open;
 *   INVCAL_MOUNTING       residuals of 0.1 rad, or no end after 6 passes: invcal_imu_mounting tells more;
 * Cost: 310,000 instructions a pass for 25 rests and 24 moves, 4 to 5 passes. Stack: about 2,400 bytes. */
invcal_status invcal_imu_solve(const invcal_real *raw, unsigned count,
                               const invcal_calibration *accelerometer, const invcal_moves *moves,
                               const invcal_imu_settings *settings, invcal_imu *out);

/* How the axes of the gyroscope fit those of the accelerometer: the commonest mistake is that they do not.
 * Tries all 48 ways, in rad and in degrees.
 *
 * axes   out: about accelerometer axis i turns gyroscope axis |axes[i]| - 1, the other way round if it is
 *        negative. 1, 2, 3 is right. 0: gyroscope axis i never turns, and no more is looked for.
 * unit   out: 1; or 57.3, where it is taken for less than it is: nominal was for degrees.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW, INVCAL_UNDETERMINED: the moves tell no way from another, nothing is
 * written. Cost: 96 passes, each a third of one of a solution. Stack: about 2,500 bytes. */
invcal_status invcal_imu_mounting(const invcal_real *raw, unsigned count,
                                  const invcal_calibration *accelerometer,
                                  const invcal_moves *moves, int8_t axes[3], invcal_real *unit);

/* The name of a parameter: "gyro_xx" (scale), "gyro_xy" ... "gyro_zz", then those of
 * invcal_parameter_name. Outside 0 ... 17: "?". */
const char *invcal_imu_parameter_name(unsigned parameter);

#ifdef __cplusplus
}
#endif

#endif
