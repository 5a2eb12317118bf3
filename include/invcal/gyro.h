/* SPDX-License-Identifier: MIT
 *
 * invcal/gyro.h: the gyroscope, calibrated from the turns between the rests.
 *
 * The turn that the gyroscope measures between two rests must carry the up direction of the first
 * into that of the second. Twelve quarter turns between the six faces determine the nine elements
 * of its matrix and the nine parameters of the accelerometer, in one solution and without a
 * previous calibration. No sample is stored: a move is kept as a few segments.
 *
 *     static invcal_imu_session both;     3.8 kB; or a separate session and moves
 *     invcal_imu_record record;
 *     invcal_imu imu;
 *     if (invcal_imu_load(&record, &result) == INVCAL_OK)
 *         calibrated: apply record.accelerometer and record.gyro
 *     invcal_session_init(&both.session, sizeof both.session, 16384, 100)     counts per g, Hz
 *     invcal_moves_init(&both.moves, sizeof both.moves, &gyro, 400)           rad/s per count, Hz
 *     invcal_imu_session_load(&both, &progress)       goes on, if it was interrupted
 *     for every sample of the gyroscope:
 *         invcal_moves_feed(&both.moves, x, y, z);
 *     for every sample of the accelerometer:
 *         event = invcal_session_feed(&both.session, x, y, z);
 *         invcal_moves_follow(&both.moves, &both.session.rests, event);
 *         if (event == INVCAL_TAKEN)
 *             invcal_imu_session_save(&both, &progress);
 *             if (both.moves.count > 12 &&
 *                 invcal_imu_solve(both.session.mean, both.session.count,
 *                                  &both.session.nominal, &both.moves, NULL, &imu) == INVCAL_OK &&
 *                 imu.verdict == INVCAL_GOOD)
 *                 invcal_imu_save(&imu, &result);
 *
 * invcal_tour gives twelve such turns, invcal_turns_next the one that would add most, and
 * invcal_turns_sigma how accurately turns, made or planned, determine all 18.
 *
 * The two sensors may be sampled at different rates. Feed samples in the order in which they were
 * taken. Those of the accelerometer may be up to 0.1 s late at no cost, since a rest ends 0.3 s
 * before motion is noticed; those of the gyroscope 0.02 s: with 0.05 s the error doubles. Lose no
 * sample while a memory is written, since the device is in motion then: let the sensor's FIFO or an
 * interrupt buffer one second. Otherwise call invcal_moves_gap, and make the move again.
 *
 * invcal.h states the rules and units; mathematics_imu.md derives this.
 */
#ifndef INVCAL_GYRO_H
#define INVCAL_GYRO_H

#include "invcal/store.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- moves ----------------------------------------------------------------------------------- */

/* At most 20 degrees of a move. For an ideal gyroscope its rotation vector is v + kappa; for
 * another matrix M it is M v + cof(M) kappa. */
typedef struct {
    int16_t v[3];     /* integral of the nominal rate, 2^-15 rad */
    int16_t kappa[3]; /* coning, 2^-18 rad */
    uint16_t time;    /* twice the samples, plus 1 if a block of rests ends with it */
} invcal_segment;

/* A rest, and the move that led to it. */
typedef struct {
    int16_t bias[3]; /* minus moves.bias, 2^-18 rad/s */
    uint16_t when;   /* time at which it was taken, in blocks */
    int8_t move;     /* number of segments; or -status: invcal_moves_reason */
} invcal_still;

/* All moves: 3.2 kB (float). You may read all but the internal members. */
typedef struct {
    /* lost in a reset */
    invcal_real rho[3];     /* internal: rotation vector of the current segment */
    invcal_real v[3];       /* internal: and its integral */
    invcal_real still[3];   /* internal: integral since the rest began */
    uint32_t still_samples; /* internal: and its samples */
    uint32_t samples;       /* internal: samples of the move so far */
    uint16_t missing;       /* internal: samples of the current segment */
    uint16_t cut, fixed;    /* internal: first segment of the rest, first that is not merged */
    uint16_t used;          /* internal: number of segments */
    uint8_t marks;          /* internal: blocks among those not merged */
    uint8_t fault;          /* internal: status of the move */
    uint8_t spoilt;         /* internal: status of the current segment */
    /* kept over a reset */
    uint32_t layout;                     /* identifies this build */
    int32_t low;                         /* lower rail */
    uint32_t between;                    /* readings between the rails */
    uint16_t blocks;                     /* blocks of rests since the first READY, up to 2 h */
    uint16_t first;                      /* segments of complete moves; those of the next follow */
    uint8_t count;                       /* rests */
    uint8_t none[3];                     /* 0 */
    invcal_calibration nominal;          /* rad/s per count */
    invcal_real rate;                    /* samples per second */
    invcal_real bias[3];                 /* subtracted from v, rad/s: that of the first rest */
    invcal_still rest[INVCAL_MAX_MOVES]; /* with the moves that led to them */
    invcal_segment segment[INVCAL_MAX_SEGMENTS]; /* of all moves, in their order */
} invcal_moves;

/* Begins.
 *
 * size     sizeof *moves.
 * nominal  data sheet: rad/s per count; offset as far as known, else 0: within 7 degrees/s, if
 *          the first rest is TAKEN without being READY. Its axes must be those of the accelerometer
 *          (invcal_imu_mounting).
 * rate     samples per second, 8 ... 8000. Its error becomes a scale error.
 *
 * Returns INVCAL_OK; INVCAL_OTHER_BUILD, INVCAL_BAD_NOMINAL, INVCAL_BAD_RATE. */
INVCAL_NODISCARD invcal_status invcal_moves_init(invcal_moves *moves, size_t size,
                                                 const invcal_calibration *nominal,
                                                 invcal_real rate);

/* Sets the counts at which the gyroscope clips: a move that reaches one of them is refused from now
 * on.
 *
 * Returns INVCAL_OK; INVCAL_BAD_LIMITS unless low < high. */
invcal_status invcal_moves_set_limits(invcal_moves *moves, int32_t low, int32_t high);

/* Feeds one sample, moving or not, raw counts. Cost: 290 instructions. Stack: about 100 bytes. */
void invcal_moves_feed(invcal_moves *moves, int32_t x, int32_t y, int32_t z);

/* Reports lost samples: the current move is refused, rests are kept. A move lasts until the rest
 * after it is TAKEN: samples lost in that rest cost it, too. */
void invcal_moves_gap(invcal_moves *moves);

/* Call it after every sample of the accelerometer, with its event. INVCAL_TAKEN ends a move, and
 * its rest determines the bias. A refused rest does not end the move. If there are INVCAL_MAX_MOVES
 * rests, the oldest is dropped.
 *
 * rests  the detector of the accelerometer's samples.
 * event  from invcal_session_feed or invcal_rests_feed, or ..._finish: INVCAL_NOTHING costs
 *        nothing.
 *
 * Cost: 1,400 instructions once per 1/8 s. Stack: about 180 bytes. */
void invcal_moves_follow(invcal_moves *moves, const invcal_private_rests *rests,
                         invcal_event event);

/* Why the move that led to a rest is unusable; INVCAL_OK if it is usable. INVCAL_REST_CLIPPED,
 * INVCAL_MOVE_GAP, INVCAL_MOVE_LONG, INVCAL_NO_SPACE; INVCAL_REST_DRIFT: the biases of its two
 * rests differ by 0.5 degrees/s, so the device turned in one of them, or one by 7 degrees/s from
 * that of the first rest; INVCAL_MOUNTING: more than seven turns, or faster than its segments hold;
 * INVCAL_TOO_FEW: no move led to it.
 *
 * rest  from 0, below moves->count. */
invcal_status invcal_moves_reason(const invcal_moves *moves, unsigned rest);

/* ---- both sensors at once -------------------------------------------------------------------- */

enum { INVCAL_GYRO_PARAMETERS = 9, INVCAL_IMU_PARAMETERS = 18 };

/* Prior knowledge. */
typedef struct {
    uint8_t held;            /* 1: the accelerometer is calibrated, only the gyroscope is solved */
    invcal_real noise;       /* standard deviation of a position mean, over field; 0: unknown */
    invcal_real rate_noise;  /* noise density, rad/s/sqrt(Hz) */
    invcal_real instability; /* of the bias, rad/s */
    /* 18 standard deviations from nominal, 0 or infinite: unknown; or null */
    const invcal_real *prior;
} invcal_imu_settings;

/* If nothing is known: a consumer gyroscope, 0.005 degrees/s/sqrt(Hz) and 20 degrees/h. */
#define INVCAL_IMU_USUAL {0, 0, INVCAL_REAL(8.7e-5), INVCAL_REAL(1e-4), 0}

/* The result. */
typedef struct {
    /* raw counts to rad/s, in the axes of the accelerometer; its offset is the bias of the last
     * rest, without the effect of acceleration if g_is_used */
    invcal_calibration gyro;
    invcal_calibration accelerometer; /* raw counts to field; as passed if it is held */
    /* M of the gyroscope by rows, true rate = M nominal rate; then the nine of the accelerometer in
     * the order of invcal.h, to first order: invcal_deviation gives them exactly */
    invcal_real parameter[INVCAL_IMU_PARAMETERS];
    invcal_real sigma[INVCAL_IMU_PARAMETERS]; /* standard deviations; 0 for what is held */
    /* of the bias of each axis: g-sensitivity, rad/s per field along x, y, z; drift from the first
     * rest to the last, rad/s. In nominal rates: multiply by M for calibrated ones, which differ by
     * the scale error. All 0 with fewer than 12 rests, or if these do not determine them */
    invcal_real slope[3][4];
    invcal_real slope_sigma[3][4]; /* standard deviations; 0 as slope */
    invcal_real noise;             /* of a position mean, used for sigma, over field */
    invcal_real move_noise;        /* of a move, rad on each axis, root mean square */
    invcal_real move_rms;          /* residuals of moves, rad on each axis, root mean square */
    invcal_real move_max;          /* the one farthest beyond its noise, both axes together, rad */
    uint32_t left_out; /* bit i: the move to rest i contradicts the others: INVCAL_MOVE_APART */
    uint32_t idle;     /* bit i: the move to rest i did not turn: INVCAL_REST_SAME */
    /* bit r: parameter r is undetermined; or weak: sigma above both 2.5 noise and 2.5 move_noise */
    uint32_t open;
    uint16_t dof;      /* degrees of freedom of the residuals */
    uint8_t worst;     /* the rest that the move of move_max led to */
    uint8_t moves;     /* number of moves used */
    uint8_t passes;    /* number of passes */
    uint8_t verdict;   /* an invcal_verdict: good, no redundancy, rough, weak */
    uint8_t g_is_used; /* a g-sensitivity exceeds 4 sigma: the moves were corrected for it */
} invcal_imu;

/* Solves both sensors, or the gyroscope with a calibrated accelerometer.
 *
 * mean           of the rests, raw counts. They are paired with the rests of
 *                moves from the end: the last with the last. If there are more of one, its oldest
 *                are ignored.
 * count          number of means.
 * accelerometer  nominal calibration, or the one that is held.
 * settings       INVCAL_IMU_USUAL, with the values that you know; or null: the same values, but the
 *                residuals are not checked against them, and the verdict is never rough.
 * out            the result; must not contain *accelerometer.
 *
 * It takes 4 to 10 Gauss-Newton passes. Up to three of these weigh rests and moves against each
 * other by their residuals. If there are more than six moves, it leaves out up to three whose
 * residuals exceed 5 sigma of the others; each takes two more passes.
 *
 * Returns INVCAL_OK; else out is overwritten:
 *   INVCAL_BAD_NOMINAL    the accelerometer's;
 *   INVCAL_BAD_NOISE, INVCAL_BAD_PRIOR    of the settings: negative or not a number, or noises of 1
 *                                         or more in total;
 *   INVCAL_OUT_OF_RANGE   a mean is not a reading of this field;
 *   INVCAL_TOO_FEW        no moves, or fewer equations than unknowns;
 *   INVCAL_UNDETERMINED   out->open names the undetermined parameters, and may name weak ones; or
 *                         none, if too few moves to converge;
 *   INVCAL_MOUNTING       residuals of 0.1 rad, or divergence: call invcal_imu_mounting.
 * Cost: 300,000 instructions per pass for 25 rests and 24 moves. Stack: about 2,400 bytes. */
invcal_status invcal_imu_solve(const invcal_vector *mean, unsigned count,
                               const invcal_calibration *accelerometer, const invcal_moves *moves,
                               const invcal_imu_settings *settings, invcal_imu *out);

/* Finds how the axes of the gyroscope are mounted against those of the accelerometer: exchanged
 * axes or wrong signs are the most common mistake. Tries all 48 mountings, in rad and in degrees.
 *
 * axes   out: gyroscope axis |axes[i]| - 1 measures turns about accelerometer axis i, reversed if
 *        axes[i] is negative. 1, 2, 3 is right. If gyroscope axis i never turns, axes[i] is 0, and
 *        the search ends: the other axes and the unit are then not tested, and are given as right.
 * unit   out: 1; or 57.3, if readings are that many times too small: degrees were converted to
 *        radians twice. If they were not converted, every move is refused (invcal_moves_reason:
 *        INVCAL_MOUNTING or INVCAL_NO_SPACE), and this returns INVCAL_TOO_FEW.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW, INVCAL_UNDETERMINED: the moves do not distinguish the
 * mountings; INVCAL_BAD_NOMINAL, INVCAL_OUT_OF_RANGE as invcal_imu_solve.
 * Cost: 96 passes, each a third of a pass of the solution. Stack: about 2,500 bytes. */
invcal_status invcal_imu_mounting(const invcal_vector *mean, unsigned count,
                                  const invcal_calibration *accelerometer,
                                  const invcal_moves *moves, int8_t axes[3], invcal_real *unit);

/* ---- what survives a reset: the moves -----------------------------------------------------------
 *
 * Moves are useless without the means of their rests, so both are kept together, in one slot: after
 * a power failure both are old or both are new (store.h). All rests and moves that were taken
 * survive. The move during the reset is refused, INVCAL_MOVE_GAP: the next rest begins another.
 *
 * These bytes belong to the device, as those of a session: a build with another number type, byte
 * order, layout of the structure or number of moves or segments refuses them; one with a table of
 * means of another size accepts them if they fit. */
typedef struct {
    invcal_moves moves;     /* its end survives */
    invcal_session session; /* its beginning survives */
} invcal_imu_session;

/* The largest number of bytes to keep. */
#define INVCAL_IMU_SESSION_SIZE                                                                    \
    ((uint32_t)(offsetof(invcal_imu_session, session) - INVCAL_IMU_SESSION_FROM) +                 \
     INVCAL_SESSION_SIZE)
/* The first byte of the structure to keep. */
#define INVCAL_IMU_SESSION_FROM offsetof(invcal_imu_session, moves.layout)

/* How many bytes to keep now, if you do not use an invcal_store. */
uint32_t invcal_imu_session_size(const invcal_imu_session *both);

/* Resumes both from these bytes, with new streams of samples. Both were begun before.
 *
 * Returns INVCAL_OK; else both are as they were begun:
 *   INVCAL_NOT_BEGUN;
 *   INVCAL_OTHER_SETTINGS  they were kept with another nominal calibration or rate, or by a
 *                          different build;
 *   INVCAL_DAMAGED         the moves are inconsistent, or as invcal_session_resume;
 *   INVCAL_NO_SPACE        more than INVCAL_IMU_SESSION_SIZE. */
invcal_status invcal_imu_session_resume(invcal_imu_session *both, const uint8_t *bytes,
                                        uint32_t size);

/* Saves both.
 *
 * Returns and stack: as invcal_store_save. */
invcal_status invcal_imu_session_save(const invcal_imu_session *both, const invcal_store *store);

/* Loads and resumes both, with new streams of samples. Both were begun before.
 *
 * Returns as invcal_store_load, then as invcal_imu_session_resume. INVCAL_OTHER_SETTINGS: also if
 * the store holds something else. Stack: as these. */
invcal_status invcal_imu_session_load(invcal_imu_session *both, const invcal_store *store);

/* ---- what survives a reset: the result ----------------------------------------------------------
 *
 * Both calibrations and their quality as 344 bytes, for a memory (store.h), a file or a radio.
 * Numbers as in a record of store.h:
 *
 *     at    size  what
 *       0   1     kind, 0xCC
 *       1   1     version, 1
 *       2   2     length, 344
 *       4   136   the record of the accelerometer (store.h)
 *     140   2     weak: bit r is set if parameter r of the gyroscope is
 *     142   2     dof
 *     144   1     verdict, of both
 *     145   1     moves
 *     146   1     1: the moves were corrected for g-sensitivity
 *     147   1     0
 *     148   12    move_noise, move_rms, move_max
 *     160   48    gyroscope: offset x, y, z, matrix by rows
 *     208   36    sigma of its nine parameters
 *     244   48    g-sensitivity and drift, by rows: x, y, z, drift
 *     292   48    sigma of these
 *     340   4     CRC-32 of all before it
 *
 * A device without gyroscope support finds a record at byte 4. */
#define INVCAL_IMU_RECORD_SIZE 344u /* bytes */

/* The contents of the bytes. Members with a name of invcal_imu are the same as there. */
typedef struct {
    invcal_real move_noise;  /* of a move, rad on each axis */
    invcal_real move_rms;    /* residuals of moves */
    invcal_real move_max;    /* the one farthest beyond its noise */
    invcal_calibration gyro; /* counts to rad/s; its offset is the bias at that time */
    invcal_real sigma[INVCAL_GYRO_PARAMETERS]; /* of the gyroscope's parameters */
    invcal_real slope[3][4];                   /* g-sensitivity along x, y, z; drift */
    invcal_real slope_sigma[3][4];             /* standard deviations of these */
    invcal_record accelerometer; /* over field; you may fill in sensor, date, temperature */
    uint16_t weak;               /* of the gyroscope's parameters */
    uint16_t dof;                /* degrees of freedom of the residuals */
    uint8_t verdict;             /* of both, an invcal_verdict */
    uint8_t moves;               /* number of moves used */
    uint8_t g_is_used;           /* 1: subtract slope times the acceleration from rates */
} invcal_imu_record;

/* Makes a record from the result of invcal_imu_solve. If the accelerometer was held, put its own
 * record into record->accelerometer. If only the gyroscope is weak, the accelerometer's verdict is
 * INVCAL_NO_REDUNDANCY: nothing has checked it. */
void invcal_imu_record_init(invcal_imu_record *record, const invcal_imu *imu);

/* Encodes a record.
 *
 * Returns INVCAL_OK: invcal_imu_record_decode accepts the bytes. On failure they are lost: as
 * invcal_record_encode, of either sensor; INVCAL_DAMAGED also for a tenth parameter, or a verdict
 * that contradicts weak. Stack: about 600 bytes. */
invcal_status invcal_imu_record_encode(const invcal_imu_record *record,
                                       uint8_t bytes[INVCAL_IMU_RECORD_SIZE]);

/* Decodes a record from bytes, at any alignment.
 *
 * size  number of bytes; any after the record are ignored.
 *
 * Returns INVCAL_OK; INVCAL_DAMAGED; INVCAL_OTHER_VERSION for intact bytes of another kind or
 * version; as invcal_imu_record_encode otherwise. On failure out is untouched. Stack: as above. */
invcal_status invcal_imu_record_decode(const uint8_t *bytes, uint32_t size, invcal_imu_record *out);

/* Saves a result as its record; over field, so before invcal_scale.
 *
 * Returns INVCAL_OK; as invcal_store_save; as invcal_imu_record_encode, for values that no solution
 * has.
 * Stack: about 1,300 bytes, without the callbacks. */
invcal_status invcal_imu_save(const invcal_imu *imu, const invcal_store *store);

/* Loads it.
 *
 * Returns INVCAL_OK; as invcal_store_load; as invcal_imu_record_decode. INVCAL_NO_SPACE,
 * INVCAL_OTHER_VERSION or INVCAL_DAMAGED, which it is for most other contents: the store holds
 * something else. Stack: about 1,000 bytes, without the callbacks. */
INVCAL_NODISCARD invcal_status invcal_imu_load(invcal_imu_record *out, const invcal_store *store);

/* The name of a parameter: "gyro_xx" (scale), "gyro_xy" ... "gyro_zz", then the names of
 * invcal_parameter_text. Outside 0 ... 17: "?". */
const char *invcal_imu_parameter_text(unsigned parameter);

/* ---- which turns to make --------------------------------------------------------------------- */

enum {
    INVCAL_TOUR = 12,     /* quarter turns of invcal_tour */
    INVCAL_TOUR_FULL = 16 /* all of its turns, full ones included */
};

/* A turn about an axis that is fixed in the device. */
typedef struct {
    /* unit vector in the axes of the device, which turns about it right-handed */
    invcal_real axis[3];
    invcal_real degrees; /* angle, at most 720 */
    invcal_real up[3];   /* unit vector that points up after it */
} invcal_turn;

/* The information in rests and turns, made or planned: 720 bytes (float). */
typedef struct {
    invcal_real up[3];   /* unit vector that points up now */
    invcal_real seconds; /* of a quarter turn or less, others in proportion; 1.5, or set it */
    invcal_real noise;   /* of a position mean, over field */
    invcal_real linear;  /* internal: variance of a turn over that of a mean, per second */
    invcal_real square;  /* internal: the same, per second squared */
    uint8_t n;           /* unknowns: 18; or 9, if the accelerometer is held */
    /* normal equations in the order of invcal_imu, lower triangle by rows, times the square of
     * noise */
    invcal_real sum[INVCAL_IMU_PARAMETERS * (INVCAL_IMU_PARAMETERS + 1) / 2];
} invcal_turns;

/* Begins a plan with one rest.
 *
 * up        unit vector that points up in it.
 * settings  as for invcal_imu_solve, or null; with rate_noise and instability 0 the gyroscope is
 *           perfect.
 *
 * Returns INVCAL_OK; INVCAL_BAD_DIRECTION, INVCAL_BAD_NOISE, INVCAL_BAD_PRIOR. */
invcal_status invcal_turns_begin(invcal_turns *turns, const invcal_real up[3],
                                 const invcal_imu_settings *settings);

/* Begins a plan with the rests and moves measured so far: arguments as for invcal_imu_solve.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW without a rest; and as invcal_imu_solve for its arguments.
 * Cost: a pass of invcal_imu_solve. Stack: about 2,500 bytes. */
invcal_status invcal_turns_after(invcal_turns *turns, const invcal_vector *mean, unsigned count,
                                 const invcal_calibration *accelerometer, const invcal_moves *moves,
                                 const invcal_imu_settings *settings);

/* Finds the shortest turn after which another direction points up. Both are unit vectors.
 *
 * Returns INVCAL_OK; INVCAL_BAD_DIRECTION, also within 0.06 degrees of equal or of opposite
 * directions: no turn is the shortest. */
invcal_status invcal_turn_to(const invcal_real from[3], const invcal_real up[3], invcal_turn *out);

/* Turn i of a program that begins with z up. From 0 to INVCAL_TOUR - 1: quarter turns between the
 * six faces, each of the twelve edges once,
 *
 *     +z +x +y +z -x +y -z +x -y -z -x -y +z
 *
 * which determine all 18. Then up to INVCAL_TOUR_FULL - 1 a full turn about x and about y, a
 * quarter turn, and a full turn about z, which halve sigma of the scales. The axis is always
 * horizontal.
 *
 * Returns INVCAL_OK; INVCAL_BAD_ANGLE if there is no turn i. */
invcal_status invcal_tour(unsigned i, invcal_turn *out);

/* Finds the turn that adds most: of the shortest turns to 26 directions (faces, edges and corners
 * of a cube), the one with the largest determinant of the normal equations. Twelve of these are
 * better than the tour, but six faces are easier to find by hand than corners.
 *
 * Cost: 175,000 instructions for 18 unknowns. Stack: about 1,300 bytes. */
void invcal_turns_next(const invcal_turns *turns, invcal_turn *out);

/* Adds a turn and the rest after it. turn->up is ignored.
 *
 * Returns INVCAL_OK; INVCAL_BAD_DIRECTION for the axis; INVCAL_BAD_ANGLE for degrees.
 * Cost: 4,300 instructions. Stack: about 450 bytes. */
invcal_status invcal_turns_add(invcal_turns *turns, const invcal_turn *turn);

/* Computes the expected sigma.
 *
 * turn   one more turn, or null: shows its improvement.
 * sigma  out: over the noise of a position mean, in the order of invcal_imu; 0 for what is held. If
 *        a parameter is undetermined, at most 10, as if each were known to ten times that noise.
 * open   out: bit r: parameter r is undetermined; or, with INVCAL_OK, weak: above 2.5 times the
 *        noise of a turn, as in invcal_imu.
 *
 * Returns INVCAL_OK; INVCAL_UNDETERMINED; and as invcal_turns_add for the turn: nothing is written
 * then.
 * Cost: 26,000 instructions. Stack: about 1,200 bytes. */
invcal_status invcal_turns_sigma(const invcal_turns *turns, const invcal_turn *turn,
                                 invcal_real sigma[INVCAL_IMU_PARAMETERS], uint32_t *open);

#ifdef __cplusplus
}
#endif

#endif
