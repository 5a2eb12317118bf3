/* SPDX-License-Identifier: MIT
 *
 * invcal/invcal.h: a device calibrates its own accelerometer against gravity alone. Most programs
 * need only this header, or store.h, which includes it:
 *
 *     calibration   what a correction is, and how to apply it
 *     calibrate     from an array of position means
 *     session       the whole procedure: samples in, instructions for the user out
 *
 * Further headers: store.h (what survives a reset), gyro.h (the whole IMU), magnetometer.h, frame.h
 * (the axes of the case), thermal.h (temperature), allan.h (noise), plan.h (programs for a stand),
 * expert.h (each single step, and rarely needed options).
 *
 * The sensor. A triad at rest in a field eta, of length 1, reads
 *
 *     u = (I + S) eta + delta + noise,
 *
 * where u is the raw reading after the nominal calibration of the data sheet, and S is diag(dk)
 * plus the symmetric cross terms gamma / 2. So all readings lie on an ellipsoid, and a dozen of
 * them determine its nine parameters (mathematics.md, "The sensor").
 *
 * Units. A reading is in *raw* counts, as the sensor delivers it, or *over field*: in units of the
 * length of the field, which is g for an accelerometer. There is no other unit; invcal_scale
 * converts a calibration to m/s^2. A magnetometer is calibrated the same way, over its own field.
 *
 * Rules for the whole library, not repeated for each function:
 *
 * - A function that does not return INVCAL_OK leaves its outputs untouched, unless its description
 *   says otherwise.
 * - Every comparison fails closed: a NaN never passes for a good value.
 * - Structures are plain data owned by the caller: they hold no pointers into themselves, need no
 *   release, and can be copied with memcpy. Read their members; set only those whose
 *   description says so.
 * - There are no globals: every function is reentrant, and safe in an interrupt or a thread as long
 *   as nothing else changes its arguments meanwhile.
 * - A null pointer is a programming error (INVCAL_ASSERT), not a status.
 * - Costs are those of a Cortex-M4F in float at -Os, both instructions and stack.
 */
#ifndef INVCAL_INVCAL_H
#define INVCAL_INVCAL_H

#include "invcal/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The nine parameters, in the order of the paper's vector X. Every array of nine uses this
 * order. */
enum {
    INVCAL_DELTA_X = 0, /* zero offset over field (for an accelerometer, in g) */
    INVCAL_DELTA_Y,     /* of y */
    INVCAL_DELTA_Z,     /* of z */
    INVCAL_DK_X,        /* scale error (1): 0.01 reads 1 % too much */
    INVCAL_DK_Y,        /* of y */
    INVCAL_DK_Z,        /* of z */
    INVCAL_GAMMA_XY,    /* non-orthogonality (rad): sum of the two cross terms of the pair */
    INVCAL_GAMMA_XZ,    /* of x and z */
    INVCAL_GAMMA_ZY,    /* of z and y */
    INVCAL_PARAMETERS   /* their number */
};

/* The name of a parameter: "delta_x" ... "gamma_zy". Outside 0 ... 8: "?". */
const char *invcal_parameter_text(unsigned parameter);

/* ---- a calibration, and its use -------------------------------------------------------------- */

/* A correction: calibrated = matrix (raw - offset). The same structure holds the starting point:
 * the *nominal* calibration of a data sheet, or an earlier one to be renewed. */
typedef struct {
    invcal_real offset[3];    /* raw reading in no field, raw counts */
    invcal_real matrix[3][3]; /* over field per raw count, by rows */
} invcal_calibration;

/* The nominal calibration of a data sheet.
 *
 * zero    raw reading in no field, raw counts.
 * counts  raw counts per field (per g) of each axis; a negative one reverses the axis.
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOMINAL if a number is not finite, a count is outside 1e-10 ...
 * 1e10, or a zero exceeds 1e18 times the field. */
invcal_status invcal_nominal(const invcal_real zero[3], const invcal_real counts[3],
                             invcal_calibration *out);

/* Applies a calibration: calibrated = matrix (raw - offset).
 *
 * x, y, z     one sample or mean, raw counts: numbers of any type, so that no array of another type
 *             can be misread.
 * calibrated  the field.
 *
 * Checks nothing: a NaN in gives a NaN out. Cost: 61 instructions. */
void invcal_apply(const invcal_calibration *calibration, invcal_real x, invcal_real y,
                  invcal_real z, invcal_real calibrated[3]);

/* Converts a calibration to a unit: field is the length of the field in that unit, 9.80665 for
 * m/s^2. After that, only apply it: it can no longer be a nominal.
 *
 * Returns INVCAL_OK; INVCAL_BAD_FIELD unless field is finite and positive. */
invcal_status invcal_scale(invcal_calibration *calibration, invcal_real field);

/* ---- how good it is -------------------------------------------------------------------------- */

/* A systematic error that the nine parameters do not describe. */
typedef enum {
    INVCAL_NO_SYSTEMATIC, /* none was found */
    INVCAL_DRIFT,         /* the offset changes from the first position to the last */
    INVCAL_QUADRATIC,     /* an axis with component x of the field reads size x^2 too much */
    INVCAL_CUBIC,         /* the same with x^3 */
    INVCAL_HYSTERESIS     /* an axis reads more if turned up into position than if turned down */
} invcal_systematic;

/* A phrase for it: "drift", "nonlinearity x^2", "nonlinearity x^3", "hysteresis"; "" for
 * INVCAL_NO_SYSTEMATIC; any other value gives "unknown error". For quality.systematic, and for each
 * bit of quality.unchecked. */
const char *invcal_systematic_text(invcal_systematic systematic);

/* Whether the calibration may be used. Larger is worse; if several apply, it is the largest. */
typedef enum {
    INVCAL_GOOD,          /* every parameter is determined, and checked by further positions */
    INVCAL_NO_REDUNDANCY, /* as many directions as unknowns: determined, but nothing checks it */
    INVCAL_ROUGH,         /* residuals that noise does not explain, or too many positions that
                             contradict the others: something is wrong */
    INVCAL_DRIFTING,      /* the sensor drifts: let it warm up, or work faster */
    INVCAL_BENT,          /* nonlinearity or hysteresis: nine parameters do not describe it */
    INVCAL_WEAK           /* some parameter is poorly determined, see quality.weak: usable only
                             within its large sigma */
} invcal_verdict;

/* "good", "no redundancy", "rough", "drifting", "bent", "weak"; any other value gives "unknown
 * verdict". */
const char *invcal_verdict_text(invcal_verdict verdict);

/* How well a calibration is known. */
typedef struct {
    uint8_t verdict;    /* an invcal_verdict: the summary */
    uint8_t systematic; /* an invcal_systematic: what was found */
    uint8_t axis;       /* on which axis: 0 x, 1 y, 2 z */
    /* bit k: systematic error k was not tested, or the positions hardly separate it from the
     * parameters */
    uint8_t unchecked;
    /* bit r: parameter r is poorly determined: its sigma exceeds ten times the noise, or it looks
     * determined only because of the noise in the readings */
    uint16_t weak;
    uint16_t positions;    /* number of positions used */
    uint16_t dof;          /* degrees of freedom of the residuals; 0: no check */
    uint16_t sigma_dof;    /* degrees of freedom behind sigma, for invcal_coverage */
    uint16_t worst;        /* the position of max, from 0 */
    invcal_mask left_out;  /* bit i: position i contradicts the others, and was left out */
    invcal_mask suspected; /* bit i: suspect i; at least one of them is wrong */
    /* of the systematic error, over field: the growth of the offset from the first position to the
     * last; the coefficient of x^2 or x^3; the excess of "up" over "down" */
    invcal_real size;
    /* what sigma is based on: the standard deviation of a position mean on each axis, over field.
     * Stated and observed noise combined; the observed alone if it is clearly larger, or nearly
     * zero; 1, the whole field, if there is neither */
    invcal_real noise;
    invcal_real rms; /* of the residuals |calibrated| - 1 over the positions */
    invcal_real max; /* the largest absolute value of these */
    /* of the normal equations: tr K tr K^-1, with K the covariance over noise^2, an upper bound of
     * their condition number. The best sets have 125 to 130 */
    invcal_real condition;
    invcal_real sigma[INVCAL_PARAMETERS]; /* standard deviation of delta (over field), dk (1) and
                                             gamma (rad) against nominal: the Cramer-Rao bound */
} invcal_quality;

/* The factor k for which +- k sigma covers 95 %: Student's t for a sigma estimated with dof degrees
 * of freedom, 12.706 at 1 (and at 0), 1.960 for very many. Accurate to 0.002 (relative). */
invcal_real invcal_coverage(unsigned dof);

/* The accuracy of a calibrated length: the half-width of its 95 % interval, over field, root mean
 * square over all directions. The noise of the reading itself comes on top.
 *
 * gravity  standard deviation of the stated magnitude of the field, over field. 0.0027 for
 *          9.80665 m/s^2 anywhere on Earth, 0.00005 if computed from latitude and height; 0 if the
 *          field itself is the unit.
 *
 * Computed from sigma alone, as if scale errors were independent: within 10 % (mathematics.md,
 * "Accuracy"). */
invcal_real invcal_accuracy(const invcal_quality *quality, invcal_real gravity);

/* Calibrates from position means.
 *
 * raw      3 * count numbers: position means x y z, x y z, ... in raw counts, in any order. At
 *          least nine; twelve to eighteen well spread ones are good. In float a mean has 24 bits:
 *          subtract a constant from counts above 2^24 first.
 * count    up to 65534.
 * nominal  data sheet, or an earlier calibration; may equal out.
 * noise    standard deviation of a position mean on each axis, over field, below 1; 0: not known,
 *          estimated from the residuals alone.
 * out      the calibration: the symmetric correction A, closest to the axes of nominal
 *          (mathematics.md, "From p to the calibration").
 * quality  how good it is. Check its verdict before you use the calibration.
 *
 * Judges by the size of the residuals alone: invcal_calibrate looks for their causes.
 *
 * Returns INVCAL_OK;
 *   INVCAL_BAD_NOMINAL    see invcal_nominal; or singular to within rounding;
 *   INVCAL_BAD_NOISE, INVCAL_BAD_COUNT;
 *   INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE    for a reading: invcal_bad_reading says which;
 *   INVCAL_TOO_FEW        fewer than nine;
 *   INVCAL_UNDETERMINED   the positions leave parameters open, to the precision of the number type:
 *                         invcal_undetermined names them;
 *   INVCAL_NOT_ELLIPSOID  the readings lie on no ellipsoid (but on a hyperboloid, for example), on
 *                         one that no triad has (a semi-axis below about 1/10 of nominal or of
 *                         another one, or a centre beyond ten times the field), or scatter by a
 *                         tenth of the field.
 * Cost: 30,000 instructions for 18 positions. Stack: about 660 bytes. */
invcal_status invcal_calibrate_plain(const invcal_real *raw, unsigned count,
                                     const invcal_calibration *nominal, invcal_real noise,
                                     invcal_calibration *out, invcal_quality *quality);

/* The same, but also tests what the nine parameters do not explain (mathematics_judgement.md).
 * Leaves out positions that contradict the others; reports a systematic error - drift,
 * nonlinearity, hysteresis - with its axis and size. Directions within 5 degrees count once.
 *
 * count  up to INVCAL_MAX_POSITIONS, in the order of the visits, at equal intervals of time.
 * out    must not equal nominal.
 *
 * Sets left_out, suspected, systematic, axis, size and unchecked of quality, and a verdict that
 * considers them all. About one in a hundred sets of 18 good positions is not called good.
 *
 * Returns as invcal_calibrate_plain; INVCAL_BAD_COUNT for more than INVCAL_MAX_POSITIONS.
 * Cost: 160,000 instructions for 18 good positions. Stack: about 1,200 bytes. */
invcal_status invcal_calibrate(const invcal_real *raw, unsigned count,
                               const invcal_calibration *nominal, invcal_real noise,
                               invcal_calibration *out, invcal_quality *quality);

/* ---- a session: the whole procedure -------------------------------------------------------------
 *
 *     invcal_session_init(&session, sizeof session, 16384, 100);
 *     for every sample:
 *         switch (invcal_session_feed(&session, x, y, z))
 *             READY   the position is good; where to turn next: invcal_session_next_text
 *             TAKEN   the position is in the table; store.h: save the session
 *             REFUSED why: invcal_session_reason_text
 *     until invcal_session_is_good(&session)
 *     invcal_session_solve
 *
 * A *static interval*, or rest, is a stretch of samples in which the device does not turn. The
 * session finds rests in the stream, trims the motion at their ends, and sums the samples exactly,
 * in integers. There is nothing to tune: it learns the noise from the stream. About 2 s in each
 * orientation are enough, 5 s at 10 samples per second. Begin a stream at rest, if you can. */

/* What happened with a sample. */
typedef enum {
    INVCAL_NOTHING,  /* nothing: its block of 1/8 s is not full */
    INVCAL_MOVING,   /* motion, or a rest disturbed for a moment */
    INVCAL_SETTLING, /* at rest: hold still; see invcal_session_progress */
    INVCAL_READY,    /* enough for a position, once per rest: move on, or stay for a better mean */
    INVCAL_TAKEN,    /* the device has left the position, and its mean is in the table. Usually
                        preceded by READY; not if the rest was accepted only once motion ended it */
    INVCAL_REFUSED   /* a rest, but not a position: invcal_session_reason. Once per rest, and again
                        if the reason changes, or as it ends. For every sample, if the session was
                        not begun */
} invcal_event;

/* Internal: an axis of the rest detector. Means are in 1/1024 counts. */
typedef struct {
    int32_t first;  /* first sample of the block */
    uint32_t sum;   /* of the differences to it, modulo 2^32; then the block's mean from origin */
    int32_t origin; /* what block means are relative to */
    int32_t place;  /* of the last position; before the first one, of the first block */
    struct {
        uint64_t total;     /* sum of the samples, relative to origin, modulo 2^64 */
        int32_t pending[2]; /* means of the blocks held back: lost if motion follows */
        int32_t once;       /* exponential mean of the means */
        int32_t lag;        /* its lead over its own exponential mean */
    } rest;                 /* the current one */
} invcal_rests_axis;

/* Internal: the rest detector (expert.h). A level is a logarithm, see rests.c. */
typedef struct {
    uint8_t stage, flags, hold, drift; /* of the current rest, see rests.c */
    uint8_t pended;                    /* its newest blocks, held back, up to 2; 0: none */
    uint8_t skip;                      /* quiet blocks to skip before it begins */
    uint8_t reason;                    /* of the last refusal */
    uint8_t taken;                     /* 1: `place` is that of a position */
    uint8_t seen;                      /* of the block */
    uint8_t run;                       /* blocks in a row of another noise level, or of none */
    uint8_t least;       /* min blocks of a position, however short the time to hold */
    uint8_t bits;        /* a block has 1 << bits samples */
    uint16_t dwell;      /* min blocks with the time to hold */
    uint16_t blocks;     /* summed in the rest, without those held back; at most 1.6 hours */
    uint16_t pace;       /* blocks in 1/125 s, 1/65536 */
    int16_t noise;       /* level, learned from the stream; 0: not known yet */
    int16_t wander;      /* the same */
    int16_t reach;       /* the same */
    int16_t other;       /* candidate for a new noise level */
    uint16_t missing;    /* samples until the block is full; 0: the next one begins a block */
    uint32_t span;       /* twice the largest difference for the fast sum; 0: none */
    uint32_t quantum;    /* smallest change seen inside a block, counts; 0: none yet */
    uint32_t time;       /* samples in full blocks so far, modulo 2^32 */
    int32_t low;         /* lower rail */
    uint32_t between;    /* readings between low and the other rail */
    uint64_t square;     /* of the block: squares of the differences, the three axes together; then
                         their variance */
    uint32_t begin, end; /* of the rest: first block's first sample; after the newest block */
    uint64_t variance;   /* of the rest: sum over its blocks and those held back, 1/64 counts^2 */
    invcal_rests_axis axis[3]; /* x, y, z */
} invcal_rests;

/* A session: 680 bytes (float, 24 positions; on AVR 136 less, as its memory is short and it keeps
 * no solution). mean and count may be read. Means are in counts, so nominal may be replaced by
 * another one with which all of them are readings (invcal_bad_reading, expert.h). A session that is
 * good uses it from the next position on. */
typedef struct {
    /* saved: store.h */
    uint8_t reason;             /* of INVCAL_REFUSED, an invcal_status. First, in every build */
    uint8_t count;              /* of the means */
    uint8_t last;               /* internal: the last event that was not INVCAL_NOTHING */
    uint8_t good;               /* internal: is_good, if already computed */
    uint32_t layout;            /* internal: identifies the build */
    invcal_real rate;           /* samples per second */
    invcal_calibration nominal; /* what it began with */
    invcal_real noise;          /* stated, over field; 0: not known */
    invcal_real mean[INVCAL_MAX_POSITIONS][3]; /* raw counts, in the order they were taken */
    /* not saved */
    invcal_rests rests; /* the detector */
#ifndef __AVR__
    invcal_calibration calibration; /* internal: the solution, while good */
    invcal_quality quality;         /* of it */
#endif
} invcal_session;

/* Begins a session for a sensor with zero at 0 and the same scale on all axes.
 *
 * size    sizeof *session.
 * counts  raw counts per field: 16384 for a sensor of +-2 g and 16 bits.
 * rate    samples per second, 8 ... 8000; an error of 10 % does no harm.
 *
 * Returns INVCAL_OK; else every sample is refused, for this reason: INVCAL_OTHER_BUILD,
 * INVCAL_BAD_NOMINAL, INVCAL_BAD_RATE. */
INVCAL_NODISCARD invcal_status invcal_session_init(invcal_session *session, size_t size,
                                                   invcal_real counts, invcal_real rate);

/* Begins a session for any other sensor.
 *
 * nominal  data sheet (invcal_nominal), or an earlier calibration to be renewed.
 *
 * Returns as invcal_session_init. */
INVCAL_NODISCARD invcal_status invcal_session_init_nominal(invcal_session *session, size_t size,
                                                           const invcal_calibration *nominal,
                                                           invcal_real rate);

/* Sets the counts at which the sensor clips, low < high (-32768 and 32767 for 16 bits): rests that
 * reach them are refused from now on. Without it only the ends of int32 count as clipped.
 *
 * Returns INVCAL_OK; INVCAL_NOT_BEGUN, INVCAL_BAD_LIMITS. */
invcal_status invcal_session_set_limits(invcal_session *session, int32_t low, int32_t high);

/* States the noise: the standard deviation of a position mean on each axis, over field, above 0 and
 * below 1. Without it the noise is estimated from the residuals alone.
 *
 * Returns INVCAL_OK; INVCAL_NOT_BEGUN, INVCAL_BAD_NOISE. */
invcal_status invcal_session_set_noise(invcal_session *session, invcal_real noise);

/* Sets how long a rest must be measured from now on: 0.6 ... 3600 s; less means 0.6 s. If you
 * measured the noise with allan.h, pass its dwell.
 *
 * Returns INVCAL_OK; INVCAL_NOT_BEGUN; INVCAL_BAD_TIME for more, or a NaN. */
invcal_status invcal_session_set_hold(invcal_session *session, invcal_real seconds);

/* Feeds one sample, raw counts, any value: three numbers, so that an array of another type, as
 * int16_t[3], is an error of the compiler.
 *
 * Positions beyond INVCAL_MAX_POSITIONS replace the oldest.
 *
 * Returns what happened. Never solves, so its cost is bounded.
 * Cost: 140 instructions on average at 1 kHz, 180 instructions at 100 Hz.
 * Stack: about 140 bytes. */
invcal_event invcal_session_feed(invcal_session *session, int32_t x, int32_t y, int32_t z);

/* Call it where samples were lost. A rest goes on if the next samples agree with it. */
void invcal_session_gap(invcal_session *session);

/* Ends the stream: closes the current rest as motion would. Returns INVCAL_TAKEN, INVCAL_REFUSED,
 * or INVCAL_MOVING if there was none. */
invcal_event invcal_session_end(invcal_session *session);

/* Progress of the current position, percent: 0 in motion, 100 from READY on. */
unsigned invcal_session_progress(const invcal_session *session);

/* Why the last rest or sample was refused; INVCAL_OK before the first. If the session was not begun
 * successfully: why. */
invcal_status invcal_session_reason(const invcal_session *session);

/* The same as a sentence, as from invcal_status_text, "" before the first. Links only the sentences
 * that it needs. */
const char *invcal_session_reason_text(const invcal_session *session);

/* Which orientation to take next: of 26 directions - the faces, edges and corners of a cube - the
 * one that adds the most information (mathematics_programs.md, "Guidance"); of equals, the nearest
 * to the current orientation. A position that is READY and still held counts as taken. The
 * direction need not be hit exactly: the next one is computed from the orientations measured.
 *
 * up  out: the direction to point upwards, in the frame of the case: a unit vector.
 *
 * Cost: 25,000 instructions. Stack: about 480 bytes. */
void invcal_session_next(const invcal_session *session, invcal_real up[3]);

#define INVCAL_TEXT_SIZE 40u /* bytes, with the terminating zero */

/* The same in words: see invcal_direction_text. Returns text. */
const char *invcal_session_next_text(const invcal_session *session, char text[INVCAL_TEXT_SIZE]);

/* A direction in words: "+z up"; "+z up, tilt 45 deg, +x rises"; "-z up, tilt 55 deg, +x and -y
 * rise": from an axis pointing up, tilt the case by that angle (rounded to 5 degrees) so that the
 * sides named come up. Plain ASCII, terminated by zero.
 *
 * up  unit vector; anything else, a NaN too, gives words like any other. Returns text. */
const char *invcal_direction_text(const invcal_real up[3], char text[INVCAL_TEXT_SIZE]);

/* Is the position that is READY, or else the last one, within 20 degrees of a direction, such as
 * that of a program (plan.h)? Returns 1 or 0; 0 if there is neither.
 *
 * up  unit vector. */
int invcal_session_is_at(const invcal_session *session, const invcal_real up[3]);

/* Solves the positions so far, without those that contradict the others (quality.left_out; see
 * invcal_calibrate). Does not change the session: more may follow. If
 * invcal_session_is_good has said so, copies what that has solved.
 *
 * Returns as invcal_calibrate_plain. Cost: 140,000 instructions for 18 good positions, 440,000
 * instructions if three are wrong. Stack: about 1,200 bytes. */
invcal_status invcal_session_solve(const invcal_session *session, invcal_calibration *out,
                                   invcal_quality *quality);

/* Are there enough positions? Returns 1 if the result of invcal_session_solve is good, with
 * quality.dof of 3 or more or a stated noise. Solves only if a position was taken or the noise
 * stated since the last call. */
int invcal_session_is_good(invcal_session *session);

/* Is it accurate enough? Returns 1 if it is good, and every sigma, widened for few degrees of
 * freedom, is within its target: sigma of delta (over field), dk (1), gamma (rad). Solves on every
 * call: call it after a position was taken. */
int invcal_session_reaches(const invcal_session *session, const invcal_real target[3]);

#ifdef __cplusplus
}
#endif

#endif
