/* SPDX-License-Identifier: MIT
 *
 * invcal/gyro.h: the gyroscope, from the same moves.
 *
 * Between two rests the gyroscope must turn the one way up into the other. Twelve quarter turns between the
 * six faces determine the nine elements of its matrix and the nine parameters of the accelerometer, in one
 * solution and without a calibration beforehand. No sample is stored: a move is kept as a few segments.
 *
 *     static invcal_imu_session both;                         3.7 kB; or a session and moves of their own
 *     invcal_imu_record record;
 *     invcal_imu imu;
 *     if (invcal_load_imu(&result, &record) == INVCAL_OK)     calibrated: record.accelerometer, record.gyro
 *     else if (invcal_load_imu_session(&progress, &both) != INVCAL_OK)    else it goes on there; or it begins:
 *         invcal_session_init(&both.session, 16384, 100);     counts for 1 g; samples per second
 *         invcal_moves_init(&both.moves, &gyro, 400);         rad/s per count; samples per second
 *     for every sample of the gyroscope:
 *         invcal_moves_feed(&both.moves, raw);
 *     for every sample of the accelerometer:
 *         event = invcal_session_feed(&both.session, raw);
 *         invcal_moves_follow(&both.moves, &both.session.rests, event);
 *         if (event == INVCAL_TAKEN)
 *             invcal_save_imu_session(&progress, &both);
 *             if (both.moves.count > 12 &&
 *                 invcal_imu_solve(both.session.mean[0], both.session.count, &both.session.nominal, &both.moves,
 *                                  NULL, &imu) == INVCAL_OK && imu.verdict == INVCAL_GOOD)
 *                 invcal_save_imu(&result, &imu);
 *
 * invcal_tour tells twelve such turns, invcal_turns_next the one that would tell most, and
 * invcal_turns_sigma how exactly turns will determine the 18, made or planned.
 *
 * The two sensors may be sampled at different rates. What is assumed of time: samples are fed in the order
 * in which they were taken. Those of the accelerometer may come up to 0.1 s late, which costs nothing, as a
 * rest is cut off 0.3 s before motion was noticed; those of the gyroscope 0.02 s: of 0.05 s the error is
 * twice as large. While a memory is written no sample may be lost: the device is in motion then. Sensors keep
 * them for a second (FIFO), or an interrupt does; else the call is invcal_moves_gap, and the move is taken again.
 *
 * invcal.h states the rules and units; mathematics.md, "The gyroscope", derives this.
 */
#ifndef INVCAL_GYRO_H
#define INVCAL_GYRO_H

#include "invcal/store.h"

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
#define INVCAL_BOTH_CHOSEN(name) INVCAL_CHOSEN(INVCAL_GYRO_CHOSEN(name), INVCAL_MAX_POSITIONS)
#define invcal_imu_session_resume INVCAL_BOTH_CHOSEN(invcal_imu_session_resume)
#define invcal_load_imu_session INVCAL_BOTH_CHOSEN(invcal_load_imu_session)
#define invcal_imu_record_init INVCAL_CHOSEN(invcal_imu_record_init, 9)
#define invcal_imu_record_decode INVCAL_CHOSEN(invcal_imu_record_decode, 9)
#define invcal_load_imu INVCAL_CHOSEN(invcal_load_imu, 9)

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
    /* what does not last over a reset */
    invcal_real rho[3];     /* internal: rotation vector of the segment in the making */
    invcal_real v[3];       /* internal: and its integral */
    invcal_real still[3];   /* internal: integral since the rest began */
    uint32_t still_samples; /* internal: and its samples */
    uint32_t samples;       /* internal: of the move since it began */
    uint16_t missing;       /* internal: samples of the segment in the making */
    uint16_t cut, fixed;    /* internal: segments of the rest begin, of those that are not merged */
    uint16_t used;          /* internal: segments altogether */
    uint8_t marks;          /* internal: blocks among those not merged */
    uint8_t fault;          /* internal: of the move */
    uint8_t spoilt;         /* internal: of the segment in the making */
    /* what does */
    uint32_t layout;            /* of this, to be told from another build's */
    int32_t low;                /* rail */
    uint32_t between;           /* readings between it and the other */
    uint16_t blocks;            /* of rests, so far; at most 65535 */
    uint16_t first;             /* segments of the moves that are there; those of the next follow */
    uint8_t count;              /* rests */
    uint8_t none[3];            /* 0 */
    invcal_calibration nominal; /* rad/s per count */
    invcal_real rate;           /* samples per second */
    invcal_real bias[3];        /* that v is free of, rad/s: of the first rest */
    invcal_still rest[INVCAL_MAX_MOVES];         /* with the moves that led to them */
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
    invcal_real slope_sigma[3][4]; /* 0 if fewer than 12 rests tell them */
    invcal_real noise;             /* of a position mean behind sigma, over field */
    invcal_real move_noise;        /* of a move, rad on each axis, root mean square */
    invcal_real move_rms;          /* residuals of moves, rad on each axis, root mean square */
    invcal_real move_max;          /* the largest, both axes together, rad */
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

/* ---- what survives a reset: the moves -----------------------------------------------------------
 *
 * Moves are of no use without the means of their rests, and the last of these belong to the last of those:
 * so both are kept at once, in one slot, and wherever power fails both are as before or as now (store.h).
 * Of moves and session lasts what was taken. The move in which the reset came is refused, INVCAL_MOVE_GAP:
 * what is taken next begins another.
 *
 * These bytes are the device's own, as those of a session: another number type, order of bytes, version of
 * the library or number of moves or segments refuses them; a table of means of another size takes them if
 * they fit. */
typedef struct {
    invcal_moves moves;     /* its end lasts */
    invcal_session session; /* its beginning lasts */
} invcal_imu_session;

/* How many bytes last at most. */
#define INVCAL_IMU_SESSION_SIZE                                                                    \
    ((uint32_t)(offsetof(invcal_imu_session, session) - INVCAL_IMU_SESSION_FROM) +                 \
     INVCAL_SESSION_SIZE)
/* From which byte of the structure on. */
#define INVCAL_IMU_SESSION_FROM offsetof(invcal_imu_session, moves.layout)

/* How many bytes last now. Who has other means than an invcal_store keeps these. */
uint32_t invcal_imu_session_size(const invcal_imu_session *both);

/* Goes on with both, whose bytes have been put back, and with streams that begin. If it fails, begin them
 * anew.
 *
 * size  how many bytes were put back.
 *
 * Returns INVCAL_OK;
 *   INVCAL_OTHER_VERSION  they are not what a build like this has kept;
 *   INVCAL_DAMAGED        the moves contradict themselves;
 *   INVCAL_BAD_NOMINAL, INVCAL_BAD_RATE, INVCAL_BAD_RAILS    a content that no moves have;
 *   as invcal_session_resume. */
invcal_status invcal_imu_session_resume(invcal_imu_session *both, uint32_t size);

/* Saves what lasts of both.
 *
 * Returns as invcal_store_save. Stack as that. */
invcal_status invcal_save_imu_session(const invcal_store *store, const invcal_imu_session *both);

/* Loads it, to go on with streams that begin. If anything fails, begin both anew.
 *
 * Returns as invcal_store_load, then as invcal_imu_session_resume. Stack as these. */
invcal_status invcal_load_imu_session(const invcal_store *store, invcal_imu_session *both);

/* ---- what survives a reset: the result ----------------------------------------------------------
 *
 * Both calibrations with all that is known about them as 344 bytes, for a memory (store.h), a file or a
 * radio. Numbers as in a record of store.h:
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
 *     146   1     1: the g-sensitivity was taken from the moves
 *     147   1     0
 *     148   12    move_noise, move_rms, move_max
 *     160   48    gyroscope: offset x, y, z, matrix by rows
 *     208   36    sigma of its nine parameters
 *     244   48    g-sensitivity and drift, by rows: x, y, z, drift
 *     292   48    sigma of these
 *     340   4     CRC-32 of all before it
 *
 * A device that knows no gyroscope finds a record at byte 4. */
#define INVCAL_IMU_RECORD_SIZE 344u /* bytes */

/* What the bytes say: of invcal_imu, what is called the same there. */
typedef struct {
    invcal_real move_noise;  /* of a move, rad on each axis */
    invcal_real move_rms;    /* residuals of moves */
    invcal_real move_max;    /* the largest */
    invcal_calibration gyro; /* counts to rad/s; its offset is the bias of that day */
    invcal_real sigma[INVCAL_GYRO_PARAMETERS]; /* of the gyroscope's parameters */
    invcal_real slope[3][4];                   /* g-sensitivity along x, y, z; drift */
    invcal_real slope_sigma[3][4];             /* standard deviations of these */
    invcal_record accelerometer; /* over field; more may be filled in: sensor, date, temperature */
    uint16_t weak;               /* of the gyroscope's parameters */
    uint16_t dof;                /* degrees of freedom left to the residuals */
    uint8_t verdict;             /* of both, an invcal_verdict */
    uint8_t moves;               /* that made it */
    uint8_t g_is_used;           /* 1: take slope from rates */
} invcal_imu_record;

/* Makes one of what invcal_imu_solve gives. If the accelerometer was held, put its own record into
 * record->accelerometer: what was known of it then. Where only the gyroscope is weak, the accelerometer's
 * verdict is INVCAL_NO_REDUNDANCY: nothing has checked it. */
void invcal_imu_record_init(invcal_imu_record *record, const invcal_imu *imu);

/* A record as bytes.
 *
 * Returns INVCAL_OK: invcal_imu_record_decode accepts the bytes. On failure they are lost: as
 * invcal_record_encode, of either sensor; INVCAL_DAMAGED also for a tenth parameter, or a verdict that
 * does not fit what is weak. Stack: about 700 bytes. */
invcal_status invcal_imu_record_encode(const invcal_imu_record *record,
                                       uint8_t bytes[INVCAL_IMU_RECORD_SIZE]);

/* A record from bytes, at any alignment.
 *
 * size  how many there are; what follows the record is not looked at.
 *
 * Returns INVCAL_OK; INVCAL_DAMAGED; INVCAL_OTHER_VERSION for sound bytes of another kind or version; as
 * invcal_imu_record_encode otherwise. out is untouched then. Stack: as above. */
invcal_status invcal_imu_record_decode(const uint8_t *bytes, uint32_t size, invcal_imu_record *out);

/* Saves a result as its record; over field, so before invcal_scale.
 *
 * Returns INVCAL_OK; as invcal_store_save; as invcal_imu_record_encode, of what no solution gives. Stack:
 * about 1,500 bytes, without the callbacks. */
invcal_status invcal_save_imu(const invcal_store *store, const invcal_imu *imu);

/* Loads it.
 *
 * Returns INVCAL_OK; as invcal_store_load; as invcal_imu_record_decode. INVCAL_NO_SPACE or
 * INVCAL_OTHER_VERSION: it holds something else. Stack: about 1,100 bytes. */
invcal_status invcal_load_imu(const invcal_store *store, invcal_imu_record *out);

/* The name of a parameter: "gyro_xx" (scale), "gyro_xy" ... "gyro_zz", then those of
 * invcal_parameter_name. Outside 0 ... 17: "?". */
const char *invcal_imu_parameter_name(unsigned parameter);

/* ---- which turns to make ------------------------------------------------------------------------ */

enum {
    INVCAL_TOUR = 12,     /* quarter turns of invcal_tour */
    INVCAL_TOUR_FULL = 16 /* all of its turns, full ones too */
};

/* A turn about an axis that is fixed in the device. */
typedef struct {
    invcal_real
        axis[3]; /* unit vector in the axes of the device, which turns about it right-handed */
    invcal_real degrees; /* by so much, at most 720 */
    invcal_real up[3];   /* unit vector that points up after it */
} invcal_turn;

/* What rests and turns tell, made or planned: 720 bytes (float). */
typedef struct {
    invcal_real up[3];   /* unit vector that points up now */
    invcal_real seconds; /* of a quarter turn, and of less; of more in proportion: 1.5 unless set */
    invcal_real noise;   /* of a position mean, over field */
    invcal_real linear;  /* internal: of its square, what a turn's noise is, for each second */
    invcal_real square;  /* internal: for each second, squared */
    uint8_t n;           /* unknowns: 18; or 9, where the accelerometer is held */
    /* normal equations in the order of invcal_imu, lower triangle by rows, times the square of noise */
    invcal_real sum[INVCAL_IMU_PARAMETERS * (INVCAL_IMU_PARAMETERS + 1) / 2];
} invcal_turns;

/* Begins a plan: a rest, and nothing else yet.
 *
 * up        unit vector that points up in it.
 * settings  as of invcal_imu_solve, or null; with rate_noise and instability 0 the gyroscope is perfect.
 *
 * Returns INVCAL_OK; INVCAL_BAD_DIRECTION, INVCAL_BAD_NOISE, INVCAL_BAD_PRIOR. */
invcal_status invcal_turns_begin(invcal_turns *turns, const invcal_real up[3],
                                 const invcal_imu_settings *settings);

/* Begins with what is measured: arguments as of invcal_imu_solve.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW: no rest; and what invcal_imu_solve says of its arguments.
 * Cost: a pass of invcal_imu_solve. Stack: about 2,500 bytes. */
invcal_status invcal_turns_after(invcal_turns *turns, const invcal_real *raw, unsigned count,
                                 const invcal_calibration *accelerometer, const invcal_moves *moves,
                                 const invcal_imu_settings *settings);

/* The shortest turn that makes another direction point up. Both are unit vectors.
 *
 * Returns INVCAL_OK; INVCAL_BAD_DIRECTION, also of opposite ones: no way is the shortest. */
invcal_status invcal_turn_to(const invcal_real from[3], const invcal_real up[3], invcal_turn *out);

/* Turn i of a program that begins with z up. From 0 to INVCAL_TOUR - 1: quarter turns between the six
 * faces, each of the twelve edges once,
 *
 *     +z +x +y +z -x +y -z +x -y -z -x -y +z
 *
 * which determine all 18. Up to INVCAL_TOUR_FULL - 1 a full turn about x and about y, a quarter turn, and a
 * full turn about z: the scale twice as well. The axis
 * is always horizontal.
 *
 * Returns INVCAL_OK; INVCAL_BAD_PROGRAM: there is no turn i. */
invcal_status invcal_tour(unsigned i, invcal_turn *out);

/* The turn that tells most: of 26 directions (faces, edges and corners of a cube), by the shortest way,
 * that of the largest determinant of the normal equations. Twelve of these tell more than the tour, but a
 * person finds six faces more easily than corners.
 *
 * Cost: 175,000 instructions of 18 unknowns. Stack: about 1,300 bytes. */
void invcal_turns_next(const invcal_turns *turns, invcal_turn *out);

/* Makes a turn: the rest after it is a part. What turn->up says does not count.
 *
 * Returns INVCAL_OK; INVCAL_BAD_DIRECTION of the axis; INVCAL_BAD_PROGRAM of degrees.
 * Cost: 5,500 instructions. Stack: about 450 bytes. */
invcal_status invcal_turns_add(invcal_turns *turns, const invcal_turn *turn);

/* What sigma is to be expected.
 *
 * turn   a turn to be made besides, or null: so much would it improve.
 * sigma  out: over the noise of a position mean, in the order of invcal_imu; 0 of what is held. Where
 *        something is left open at most 10, as if each parameter were known to ten times that noise.
 * open   out: bit r: parameter r is left open; or, with INVCAL_OK, weak: above 2.5 times the noise of a
 *        turn, as invcal_imu says it.
 *
 * Returns INVCAL_OK; INVCAL_UNDETERMINED; and as invcal_turns_add of the turn: nothing is written then.
 * Cost: 30,000 instructions. Stack: about 1,200 bytes. */
invcal_status invcal_turns_sigma(const invcal_turns *turns, const invcal_turn *turn,
                                 invcal_real sigma[INVCAL_IMU_PARAMETERS], uint32_t *open);

#ifdef __cplusplus
}
#endif

#endif
