/* SPDX-License-Identifier: MIT
 *
 * Internal: the equations of rests and moves.
 *
 * A segment is at most 20 degrees of a move. For an ideal gyroscope its rotation vector is
 * v + kappa; for another matrix M it is M v + cof(M) kappa.
 *
 *     v          integral of the nominal rate, 2^-15 rad
 *     kappa      coning, 2^-18 rad
 *     time       twice the samples, plus 1 if a block of rests ends with it
 *
 * Of a rest, and the move that led to it:
 *
 *     bias       minus that of the moves, 2^-18 rad/s
 *     when       time at which it was taken, in blocks
 *     move       number of segments; or minus a status
 *
 * Of all moves. Lost in a reset, and of the same size in every build:
 *
 *     rho        rotation vector of the current segment
 *     v          and its integral
 *     still      integral since the rest began, over still_samples
 *     samples    of the move so far
 *     missing    samples of the current segment
 *     cut        first segment of the rest
 *     fixed      first that is not merged
 *     used       number of segments
 *     marks      blocks among those not merged
 *     fault      status of the move; if not begun, why
 *     spoilt     status of the current segment
 *
 * Kept over a reset:
 *
 *     layout     identifies this build
 *     low        lower limit
 *     between    readings between the limits
 *     blocks     since the first READY, up to 2 h
 *     first      segments of complete moves; then the next
 *     rate       samples per second
 *     bias       subtracted from v, rad/s: of the first rest
 *     rest       with the moves that led to them
 *     segment    of all moves, in their order
 */
#ifndef INVCAL_IMU_H
#define INVCAL_IMU_H

#include "invcal/expert.h"
#include "invcal/gyro.h"
#include "invcal/positions.h"
#include "../session/rests.h"
#include "rotation.h"
#include "../session/session.h"
#include "../core/sums.h"

/* If nothing is known: of a mean, over field; a consumer gyroscope, 0.005 degrees/s/sqrt(Hz) and 20
 * degrees/h. */
#define INVCAL_IMU_MEAN_NOISE INVCAL_REAL(3e-4)
#define INVCAL_IMU_RATE_NOISE INVCAL_REAL(8.7e-5)
#define INVCAL_IMU_INSTABILITY INVCAL_REAL(1e-4)

/* The two kinds of equations. */
enum { INVCAL_OF_RESTS, INVCAL_OF_MOVES, INVCAL_KINDS };

/* Unknowns of the gyroscope. In a solution they come first: those of the accelerometer are not
 * solved if it is held. */
enum { INVCAL_GYRO_PARAMETERS = INVCAL_IMU_PARAMETERS - INVCAL_PARAMETERS };

/* The parameter that is unknown r of a solution; and the other way round. */
static inline unsigned invcali_imu_parameter(unsigned r)
{
    return r < INVCAL_PARAMETERS ? r + INVCAL_PARAMETERS : r - INVCAL_PARAMETERS;
}

/* Follows the rests: after every event of the session but INVCAL_NOTHING. For rests that a session
 * did not find: session.rests is their detector. */
void invcali_imu_follow(invcal_imu *imu, invcal_event event);

/* The data of a pass, and its results. */
typedef struct {
    const invcal_imu *imu;
    const invcal_vector *mean; /* means of the rests from begin on */
    const invcal_real *prior;  /* or null */
    invcal_imu_result *out;    /* accelerometer and slopes so far, worst */
    invcal_real rate_noise, instability;
    invcal_real noise_square; /* variance of a mean, stated or usual */
    unsigned n;               /* unknowns: 18, 9, or 0 for residuals only */
    unsigned begin;           /* first rest of moves that has a mean */
    unsigned apart;           /* moves left out: */
    uint32_t left_out;        /* as in the result */
    uint32_t idle;            /* the same */
    unsigned passes;
    int is_stated, is_adapted;
    int has_noise; /* of a mean: it is stated */
    /* M of the gyroscope by rows, then those of the accelerometer, to first order */
    invcal_real parameter[INVCAL_IMU_PARAMETERS];
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
} invcali_imu_work;

/* A move, integrated from its segments. */
typedef struct {
    invcal_real c[3][3];     /* from its end to its beginning */
    invcal_real s[3][3][3];  /* derivative of its rotation by each row of E */
    invcal_real time, angle; /* seconds; squares of its segments, rad^2 */
} invcali_replay;

/* Integrates a move with its bias, rad/s; up points up before and after it. */
void invcali_replay_move(const invcali_imu_work *work, const invcal_private_segment *segment,
                         unsigned count, const invcal_real bias[3], const invcal_real up[2][3],
                         invcali_replay *replay);

/* The means, nominal and noise of a session. */
invcal_positions invcali_imu_positions(const invcal_imu *imu);

/* Returns INVCAL_OK, INVCAL_BAD_NOISE or INVCAL_BAD_PRIOR.
 *
 * noise  of a position mean. */
invcal_status invcali_imu_settings_check(const invcal_imu_settings *settings, invcal_real noise);

/* invcal_imu_solve with these means, any number, and their nominal and noise. */
invcal_status invcali_imu_solve_of(const invcal_imu *imu, const invcal_positions *positions,
                                   const invcal_imu_settings *settings, invcal_imu_result *out);

/* Begins a solution. Returns INVCAL_OK, or which argument is bad. */
invcal_status invcali_imu_begin(invcali_imu_work *work, const invcal_imu *imu,
                                const invcal_positions *positions,
                                const invcal_imu_settings *settings, invcal_imu_result *out);

/* Sums all equations. Returns INVCAL_OK; INVCAL_OUT_OF_RANGE if a mean is not a reading of the
 * field. */
invcal_status invcali_imu_sum(invcali_imu_work *work);

/* invcal_imu_mounting with these means. */
invcal_status invcali_imu_mounting_of(const invcal_imu *imu, const invcal_positions *positions,
                                      int8_t axes[3], invcal_real *unit);

/* Were both begun? */
static inline int invcali_imu_is_begun(const invcal_imu *imu)
{
    return imu->own.layout == INVCAL_MOVES_LAYOUT && invcali_session_is_begun(&imu->session);
}

#endif
