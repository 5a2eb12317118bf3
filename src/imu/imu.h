/* SPDX-License-Identifier: MIT
 *
 * Internal: the equations of rests and moves.
 */
#ifndef INVCAL_IMU_H
#define INVCAL_IMU_H

#include "invcal/expert.h"
#include "invcal/gyro.h"
#include "../session/rests.h"
#include "../core/sums.h"

/* The two kinds of equations. */
enum { INVCAL_OF_RESTS, INVCAL_OF_MOVES, INVCAL_KINDS };

/* The data of a pass, and its results. */
typedef struct {
    const invcal_moves *moves;
    const invcal_vector *mean; /* means of the rests from begin on */
    const invcal_imu_settings *settings;
    invcal_imu *out;          /* accelerometer and parameters so far, left_out, idle, worst */
    invcal_real noise_square; /* variance of a mean, stated or usual */
    unsigned n;               /* unknowns: 18, 9, or 0 for residuals only */
    unsigned begin;           /* first rest of moves that has a mean */
    unsigned apart;           /* moves left out */
    int is_stated, is_adapted;
    invcal_real g_bias[3];              /* bias due to acceleration in the last rest */
    invcal_real variance[INVCAL_KINDS]; /* over the expected variance */
    struct {
        unsigned kind[INVCAL_KINDS];              /* rows of each kind */
        invcal_real squares[INVCAL_KINDS];        /* of their residuals, over expected variances */
        unsigned rows;                            /* of both kinds and the prior */
        invcal_real variances, residuals;         /* sums over moves: expected; squares in rad^2 */
        invcal_real worst_square, worst_residual; /* over its expected variance; in rad^2 */
        invcal_real sum[INVCAL_PACKED_SIZE(INVCAL_IMU_PARAMETERS + 1)];
    } pass;                                /* results */
    invcal_real bias[INVCAL_MAX_MOVES][3]; /* of the rests: measured, later fitted */
} invcal_imu_work;

/* A move, integrated from its segments. */
typedef struct {
    invcal_real c[3][3];     /* from its end to its beginning */
    invcal_real s[3][3][3];  /* derivative of its rotation by each row of E */
    invcal_real time, angle; /* seconds; squares of its segments, rad^2 */
} invcal_replay;

/* Integrates a move with its bias, rad/s; up points up before and after it. */
void invcal_replay_move(const invcal_imu_work *work, const invcal_segment *segment, unsigned count,
                        const invcal_real bias[3], const invcal_real up[2][3],
                        invcal_replay *replay);

/* Returns INVCAL_OK, INVCAL_BAD_NOISE or INVCAL_BAD_PRIOR. */
invcal_status invcal_imu_settings_check(const invcal_imu_settings *settings);

/* Begins a solution. Returns INVCAL_OK, or which argument is bad. */
invcal_status invcal_imu_begin(invcal_imu_work *work, const invcal_vector *mean, unsigned count,
                               const invcal_calibration *accelerometer, const invcal_moves *moves,
                               const invcal_imu_settings *settings, invcal_imu *out);

/* Sums all equations. Returns INVCAL_OK; INVCAL_OUT_OF_RANGE if a mean is not a reading of the
 * field. */
invcal_status invcal_imu_sum(invcal_imu_work *work);

#endif
