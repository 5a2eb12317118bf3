/* SPDX-License-Identifier: MIT
 *
 * invcal/gyro.h: the gyroscope, calibrated from the turns between the rests.
 *
 * The rotation that the gyroscope measures between two rests must carry one rest's "up" into the
 * next one's. Twelve quarter turns between the six faces determine the nine elements of its matrix
 * and the nine parameters of the accelerometer, in one solution and without a previous calibration.
 * No sample is stored: a move, the turn between two rests, is kept as a few segments.
 *
 *     static invcal_imu imu;                                              3.8 kB
 *     invcal_session_init(&imu.session, sizeof imu.session, 16384, 100)   counts per g, Hz
 *     invcal_imu_init(&imu, sizeof imu, 3753, 400)                        counts per rad/s, Hz
 *     for every sample of the gyroscope:
 *         invcal_imu_feed_gyro(&imu, x, y, z)
 *     for every sample of the accelerometer:
 *         event = invcal_imu_feed(&imu, x, y, z)
 *         READY   show invcal_imu_next_text
 *         TAKEN   invcal_imu_save (gyro_store.h); enough if
 *                 invcal_imu_solve(&imu, NULL, &result) == INVCAL_OK && result.verdict ==
 *                 INVCAL_GOOD
 *         REFUSED show invcal_session_reason_text(&imu.session)
 *
 * The two sensors may be sampled at different rates. Feed samples in the order in which they were
 * taken. Those of the accelerometer may be up to 0.1 s late at no cost; those of the gyroscope 0.02
 * s: with 0.05 s the error doubles. Lose no sample while a memory is written, since the device is
 * in motion then: let the sensor's FIFO or an interrupt buffer one second. Otherwise call
 * invcal_imu_gap, and make the move again.
 *
 * invcal.h states the rules and units; mathematics_imu.md derives this.
 */
#ifndef INVCAL_GYRO_H
#define INVCAL_GYRO_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The nine of the gyroscope follow those of invcal.h: the elements by rows of M, true rate = M
 * nominal rate, less 1 on the diagonal. */
enum {
    INVCAL_GYRO_XX = INVCAL_PARAMETERS, /* scale */
    INVCAL_GYRO_XY,                     /* y in x */
    INVCAL_GYRO_XZ,                     /* z in x */
    INVCAL_GYRO_YX,                     /* x in y */
    INVCAL_GYRO_YY,                     /* scale */
    INVCAL_GYRO_YZ,                     /* z in y */
    INVCAL_GYRO_ZX,                     /* x in z */
    INVCAL_GYRO_ZY,                     /* y in z */
    INVCAL_GYRO_ZZ,                     /* scale */
    INVCAL_IMU_PARAMETERS               /* of both sensors: 18 */
};

/* Both sensors: 3.8 kB (float). */
typedef struct {
    invcal_private_moves own;   /* private */
    invcal_calibration nominal; /* of the gyroscope, what it began with: rad/s per count */
    uint8_t rests;              /* kept, with the moves that led to them: up to INVCAL_MAX_MOVES */
    invcal_session session;     /* the accelerometer's: set and read it by invcal.h, but feed it by
                                   invcal_imu_feed only, and do not end it */
} invcal_imu;

/* Begins with moves. The session must have been begun.
 *
 * size    sizeof *imu.
 * counts  raw counts of the gyroscope per rad/s: 57.2958 times those per degree/s. Its axes must be
 *         those of the accelerometer (invcal_imu_mounting).
 * rate    samples of the gyroscope per second, 8 ... 8000. Its error becomes a scale error.
 *
 * Returns INVCAL_OK; else every sample is refused, for this reason: INVCAL_OTHER_BUILD,
 * INVCAL_NOT_BEGUN, INVCAL_BAD_NOMINAL, INVCAL_BAD_RATE. */
INVCAL_NODISCARD invcal_status invcal_imu_init(invcal_imu *imu, size_t size, invcal_real counts,
                                               invcal_real rate);

/* The same for any other gyroscope.
 *
 * nominal  rad/s per count; offset as far as known, else 0. */
INVCAL_NODISCARD invcal_status invcal_imu_init_nominal(invcal_imu *imu, size_t size,
                                                       const invcal_calibration *nominal,
                                                       invcal_real rate);

/* Sets the counts at which the gyroscope clips: a move that reaches one of them is refused from now
 * on. (The accelerometer's: invcal_session_set_limits.)
 *
 * Returns INVCAL_OK; INVCAL_BAD_LIMITS unless low < high. */
invcal_status invcal_imu_set_limits(invcal_imu *imu, int32_t low, int32_t high);

/* Feeds one sample of the gyroscope, moving or not, raw counts. Cost: 290 instructions. Stack:
 * about 100 bytes. */
void invcal_imu_feed_gyro(invcal_imu *imu, int32_t x, int32_t y, int32_t z);

/* Feeds one sample of the accelerometer. INVCAL_TAKEN ends a move, and its rest determines the
 * bias. A refused rest does not end the move. If the table of rests is full, the oldest is dropped.
 *
 * Returns as invcal_session_feed. Cost: as that, and 1,400 instructions once per 1/8 s. Stack:
 * about 200 bytes. */
invcal_event invcal_imu_feed(invcal_imu *imu, int32_t x, int32_t y, int32_t z);

/* Call it where samples of either sensor were lost: the current move is refused, rests are kept. A
 * move lasts until the rest after it is TAKEN: samples lost in that rest cost it, too. */
void invcal_imu_gap(invcal_imu *imu);

/* Why the move that led to a rest is unusable; INVCAL_OK if it is usable. INVCAL_REST_CLIPPED,
 * INVCAL_MOVE_GAP, INVCAL_MOVE_LONG, INVCAL_NO_SPACE; INVCAL_REST_DRIFT: the device turned in one
 * of its two rests; INVCAL_MOUNTING: more than seven turns, or faster than its segments hold;
 * INVCAL_TOO_FEW: no move led to it.
 *
 * rest  from 0, below imu->rests. */
invcal_status invcal_imu_move_reason(const invcal_imu *imu, unsigned rest);

/* ---- which turn to make next ----------------------------------------------------------------- */

/* A turn about an axis that is fixed in the device. */
typedef struct {
    invcal_real axis[3]; /* unit vector; the device turns about it right-handed */
    invcal_real angle;   /* rad */
    invcal_real up[3];   /* unit vector that points up after it */
} invcal_turn;

/* The turn to make next: a tour of quarter turns through the six faces, each of the twelve edges
 * once,
 *
 *     +z +x +y +z -x +y -z +x -y -z -x -y +z
 *
 * until each of its turns was made, in either direction, and not refused: that determines all 18.
 * Then the one of the shortest turns to 26 directions that adds the most information. A position
 * that is READY and still held counts as taken. If nothing is known yet, the angle is 0, with +z
 * up.
 *
 * Cost: 500,000 instructions, in the tour 25,000. Stack: about 3,000 bytes. */
void invcal_imu_next(const invcal_imu *imu, invcal_turn *turn);

/* The direction up after it, in words: invcal_direction_text. Returns text. */
const char *invcal_imu_next_text(const invcal_imu *imu, char text[INVCAL_TEXT_SIZE]);

/* ---- both sensors at once -------------------------------------------------------------------- */

/* Prior knowledge. Set all to zero first, then what you know: members may be added. */
typedef struct {
    uint8_t held; /* 1: the session's nominal is the accelerometer's calibration, and only the
                     gyroscope is solved */
    invcal_real rate_noise;   /* noise density, rad/s/sqrt(Hz); 0: unknown, 8.7e-5 */
    invcal_real instability;  /* of the bias, rad/s; 0: unknown, 1e-4 */
    const invcal_real *prior; /* 18 standard deviations from nominal, 0 or infinite: unknown; or
                                 null */
} invcal_imu_settings;

/* The result. */
typedef struct {
    invcal_real move_noise; /* of a move, rad on each axis, root mean square */
    invcal_real move_rms;   /* residuals of moves, rad on each axis, root mean square */
    invcal_real move_max;   /* the one farthest beyond its noise, both axes together, rad */
    /* raw counts to rad/s, in the axes of the accelerometer; its offset is the bias of the last
     * rest, without the effect of acceleration if g_is_used */
    invcal_calibration gyro;
    invcal_real sigma[INVCAL_IMU_PARAMETERS]; /* standard deviations; 0 for what is held */
    /* of the bias of each axis: g-sensitivity, rad/s per field along x, y, z; drift from the first
     * rest to the last, rad/s. In nominal rates. All 0 with fewer than 12 rests, or if these do not
     * determine them */
    invcal_real slope[3][4];
    invcal_real slope_sigma[3][4];    /* standard deviations; 0 as slope */
    invcal_calibration accelerometer; /* raw counts to field; the session's nominal if it is held */
    invcal_real noise;                /* of a position mean, used for sigma, over field */
    invcal_mask left_out; /* rests the move to which contradicts the others: INVCAL_MOVE_APART */
    invcal_mask idle;     /* rests the move to which did not turn: INVCAL_REST_SAME */
    uint32_t weak; /* bit r: parameter r is undetermined, or its sigma is above both 2.5 noise
                             and 2.5 move_noise */
    uint16_t dof;  /* degrees of freedom of the residuals */
    uint8_t worst; /* the rest that the move of move_max led to */
    uint8_t moves; /* number of moves used */
    invcal_verdict verdict; /* good, no redundancy, rough, weak */
    uint8_t g_is_used;      /* a g-sensitivity exceeds 4 sigma: the moves were corrected for it */
} invcal_imu_result;

/* Solves both sensors, or the gyroscope with a calibrated accelerometer. Means of the session are
 * paired with rests from the end: the last with the last.
 *
 * settings  null: nothing is known; the residuals are then not checked against a noise, and the
 *           verdict is never rough.
 * out       overwritten on failure.
 *
 * It takes 4 to 10 Gauss-Newton passes, and leaves out up to three of more than six moves whose
 * residuals exceed 5 sigma of the others; each takes two more passes.
 *
 * Returns INVCAL_OK;
 *   INVCAL_NOT_BEGUN;
 *   INVCAL_BAD_NOMINAL    the session's;
 *   INVCAL_BAD_NOISE, INVCAL_BAD_PRIOR    negative or not a number, or noises of 1 or more in
 *                                         total;
 *   INVCAL_OUT_OF_RANGE   a mean is not a reading of this field;
 *   INVCAL_TOO_FEW        no moves, or fewer equations than unknowns;
 *   INVCAL_UNDETERMINED   out->weak names the undetermined parameters, and may name weak ones; or
 *                         none, if too few moves to converge;
 *   INVCAL_MOUNTING       residuals of 0.1 rad, or divergence: call invcal_imu_mounting.
 * Cost: 300,000 instructions per pass for 25 rests and 24 moves. Stack: about 2,500 bytes. */
INVCAL_NODISCARD invcal_status invcal_imu_solve(const invcal_imu *imu,
                                                const invcal_imu_settings *settings,
                                                invcal_imu_result *out);

/* Finds how the axes of the gyroscope are mounted against those of the accelerometer: exchanged
 * axes or wrong signs are the most common mistake. Tries all 48 mountings, in rad and in degrees.
 *
 * axes   out: gyroscope axis |axes[i]| - 1 measures turns about accelerometer axis i, reversed if
 *        axes[i] is negative. 1, 2, 3 is right. If gyroscope axis i never turns, axes[i] is 0, and
 *        the search ends: the other axes and the unit are then given as right.
 * unit   out: 1; or 57.3, if readings are that many times too small: degrees were converted to
 *        radians twice. If they were not converted, every move is refused, and this returns
 *        INVCAL_TOO_FEW.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW, INVCAL_UNDETERMINED: the moves do not distinguish the
 * mountings; INVCAL_NOT_BEGUN, INVCAL_BAD_NOMINAL, INVCAL_OUT_OF_RANGE as invcal_imu_solve.
 * Cost: 96 passes, each a third of a pass of the solution. Stack: about 2,500 bytes. */
INVCAL_NODISCARD invcal_status invcal_imu_mounting(const invcal_imu *imu, int8_t axes[3],
                                                   invcal_real *unit);

/* Applies the gyroscope's part to a sample, raw counts, and subtracts the effect of acceleration if
 * g_is_used. (The accelerometer's: invcal_apply.)
 *
 * acceleration  the latest, calibrated, over field.
 * rate          out: rad/s.
 *
 * Checks nothing. Cost: 150 instructions. */
void invcal_imu_apply(const invcal_imu_result *result, invcal_real x, invcal_real y, invcal_real z,
                      const invcal_real acceleration[3], invcal_real rate[3]);

#ifdef __cplusplus
}
#endif

#endif
