/* SPDX-License-Identifier: MIT
 *
 * invcal/invcal.h: a device calibrates its own accelerometer against gravity alone. With store.h,
 * which keeps the result, it is all that most programs need:
 *
 *     invcal_session_init(&session, sizeof session, 16384, 100)
 *     for every sample:
 *         switch (invcal_session_feed(&session, x, y, z))
 *             READY   the position is good; where to turn next: invcal_session_next_text
 *             TAKEN   the position is in the table; store.h: save the session
 *             REFUSED why: invcal_session_reason_text
 *     until invcal_session_is_good(&session)
 *     invcal_session_solve, then invcal_apply to every sample
 *
 * A triad at rest in a field eta, of length 1, reads u = (I + S) eta + delta + noise, where u is
 * the raw reading after the nominal calibration, and S is diag(dk) plus the symmetric cross terms
 * gamma / 2. So all readings lie on an ellipsoid, and a dozen of them determine its nine parameters
 * (mathematics.md, "The sensor").
 *
 * Units. A reading is in *raw* counts, as the sensor delivers it, or *over field*: in units of the
 * length of the field, g for an accelerometer; invcal_scale converts a calibration to m/s^2. Times
 * are in seconds, angles in radians; names that end in _deg are in degrees.
 *
 * Rules for the whole library, not repeated for each function:
 *
 * - A sample is three numbers, so that an array of another type, as int16_t[3], is an error of the
 *   compiler.
 * - The object of a function comes first, its results come last.
 * - A function that does not return INVCAL_OK leaves its outputs untouched, unless its description
 *   says otherwise.
 * - Every comparison fails closed: a NaN never passes for a good value.
 * - Structures are plain data of the caller, without pointers into themselves: memcpy copies them.
 *   Read their members, except those of private.h; set only those whose description says so.
 * - There are no globals: every function is reentrant, and safe in an interrupt or a thread as long
 *   as nothing else changes its arguments meanwhile.
 * - A null pointer is a programming error (INVCAL_ASSERT), not a status.
 * - Costs are those of a Cortex-M4F in float at -Os, both instructions and stack.
 */
#ifndef INVCAL_INVCAL_H
#define INVCAL_INVCAL_H

#include "invcal/private.h"
#include "invcal/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the result ------------------------------------------------------------------------------ */

/* A correction: calibrated = matrix (raw - offset). The same structure holds the starting point:
 * the *nominal* calibration of a data sheet, or an earlier one to be renewed. */
typedef struct {
    invcal_real offset[3];    /* raw reading in no field, raw counts */
    invcal_real matrix[3][3]; /* over field per raw count, by rows */
} invcal_calibration;

/* Applies it to a sample or a mean, raw counts.
 *
 * calibrated  out: the field.
 *
 * Checks nothing: a NaN in gives a NaN out. Cost: 61 instructions. */
void invcal_apply(const invcal_calibration *calibration, invcal_real x, invcal_real y,
                  invcal_real z, invcal_real calibrated[3]);

/* Converts it to a unit: field is the length of the field in that unit, 9.80665 for m/s^2. After
 * that, only apply it: it can no longer be saved, or be a nominal.
 *
 * Returns INVCAL_OK; INVCAL_BAD_FIELD unless field is finite and positive. */
invcal_status invcal_scale(invcal_calibration *calibration, invcal_real field);

/* The nine parameters: the paper's vector X, and the order of every array and bit set of them. */
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

/* Whether a calibration may be used. Larger is worse; if several apply, it is the largest. New ones
 * will come between. */
typedef uint8_t invcal_verdict;
enum {
    INVCAL_GOOD = 0,           /* every parameter is determined, and checked by further positions */
    INVCAL_NO_REDUNDANCY = 16, /* as many directions as unknowns: nothing checks it */
    INVCAL_ROUGH = 32,         /* residuals that noise does not explain, or too many positions that
                                  contradict the others: something is wrong */
    INVCAL_DRIFTING = 48,      /* the sensor drifts: let it warm up, or work faster */
    INVCAL_BENT = 64,          /* nonlinearity or hysteresis: nine parameters do not describe it */
    INVCAL_WEAK = 80           /* some parameter is poorly determined, see quality.weak: usable only
                                  within its large sigma */
};

/* "good", "no redundancy", "rough", "drifting", "bent", "weak"; any other value gives "unknown
 * verdict". */
const char *invcal_verdict_text(invcal_verdict verdict);

/* A systematic error that the nine parameters do not describe. */
typedef uint8_t invcal_systematic;
enum {
    INVCAL_NO_SYSTEMATIC, /* none was found */
    INVCAL_DRIFT,         /* the offset changes from the first position to the last */
    INVCAL_QUADRATIC,     /* an axis with component x of the field reads size x^2 too much */
    INVCAL_CUBIC,         /* the same with x^3 */
    INVCAL_HYSTERESIS     /* an axis reads more if turned up into position than if turned down */
};

/* How well a calibration is known. What else it says: result.h. */
typedef struct {
    invcal_verdict verdict;       /* the summary */
    invcal_systematic systematic; /* what was found */
    uint8_t axis;                 /* on which axis: 0 x, 1 y, 2 z */
    /* bit k: systematic error k was not tested, or the positions hardly separate it from the
     * parameters */
    uint8_t unchecked;
    /* bit r: parameter r is poorly determined: its sigma exceeds ten times the noise, or it looks
     * determined only because of the noise in the readings */
    uint16_t weak;
    uint16_t held;         /* bit r: sigma of parameter r was stated, not measured: positions.h */
    uint16_t positions;    /* number of positions used */
    uint16_t dof;          /* degrees of freedom of the residuals; 0: no check */
    uint16_t sigma_dof;    /* degrees of freedom behind sigma, for invcal_coverage */
    uint16_t worst;        /* the position of max, from 0 */
    invcal_mask left_out;  /* positions that contradict the others, and were left out */
    invcal_mask suspected; /* positions at least one of which is wrong */
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

/* ---- a session: the whole procedure -------------------------------------------------------------
 *
 * A *static interval*, or rest, is a stretch of samples in which the device does not turn. The
 * session finds rests in the stream, trims the motion at their ends, and sums the samples exactly,
 * in integers. There is nothing to tune: it learns the noise. About 2 s in each
 * orientation are enough, 5 s at 10 samples per second. Begin a stream at rest, if you can. */

/* What happened with a sample. */
typedef enum {
    INVCAL_NOTHING,  /* nothing: its block of 1/8 s is not full */
    INVCAL_MOVING,   /* motion, or a rest disturbed for a moment */
    INVCAL_SETTLING, /* at rest: hold still; see invcal_session_progress */
    INVCAL_READY,    /* enough for a position, once per rest: move on, or stay for a better mean */
    INVCAL_TAKEN,    /* the device has left the position, and its mean is in the table. Not always
                        preceded by READY */
    INVCAL_REFUSED   /* a rest, but not a position: invcal_session_reason. Again if the reason
                        changes, or as it ends; for every sample, if the session was not begun */
} invcal_event;

/* Three numbers as an element of an array. */
typedef struct {
    invcal_real v[3]; /* x, y, z */
} invcal_vector;

/* A session: 680 bytes (float, 24 positions; on AVR 136 less, as it keeps no solution there). Means
 * are in counts, so nominal may be replaced by another one with which all of them are readings
 * (invcal_bad_reading, positions.h), from the next position on. */
typedef struct {
    /* saved: store.h */
    uint8_t reason;             /* of INVCAL_REFUSED, an invcal_status. First, in every build */
    uint8_t count;              /* of the means */
    uint8_t last;               /* private: the last event that was not INVCAL_NOTHING */
    uint8_t good;               /* private: is_good, if already computed */
    uint32_t layout;            /* private: identifies the build */
    invcal_real rate;           /* samples per second */
    invcal_calibration nominal; /* what it began with */
    invcal_real noise;          /* stated, over field; 0: not known */
    invcal_vector mean[INVCAL_MAX_POSITIONS]; /* raw counts, in the order they were taken */
    /* not saved */
    invcal_private_rests rests; /* the detector */
#ifndef __AVR__
    invcal_calibration calibration; /* private: the solution, while good */
    invcal_quality quality;         /* private: of it */
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

/* The same for any other sensor.
 *
 * nominal  data sheet (invcal_nominal, positions.h), or an earlier calibration to be renewed. */
INVCAL_NODISCARD invcal_status invcal_session_init_nominal(invcal_session *session, size_t size,
                                                           const invcal_calibration *nominal,
                                                           invcal_real rate);

/* Sets the counts at which the sensor clips, low < high (-32768 and 32767 for 16 bits): rests that
 * reach them are refused from now on. Without it only the ends of int32 count as clipped.
 *
 * Returns INVCAL_OK; INVCAL_NOT_BEGUN, INVCAL_BAD_LIMITS. */
invcal_status invcal_session_set_limits(invcal_session *session, int32_t low, int32_t high);

/* States the noise: the standard deviation of a position mean on each axis, over field, above 0 and
 * below 1.
 *
 * Returns INVCAL_OK; INVCAL_NOT_BEGUN, INVCAL_BAD_NOISE. */
invcal_status invcal_session_set_noise(invcal_session *session, invcal_real noise);

/* Sets how long a rest must be measured from now on: 0.6 ... 3600 s; less means 0.6 s. If you
 * measured the noise with allan.h, pass its dwell.
 *
 * Returns INVCAL_OK; INVCAL_NOT_BEGUN; INVCAL_BAD_TIME for more, or a NaN. */
invcal_status invcal_session_set_hold(invcal_session *session, invcal_real seconds);

/* Feeds one sample, raw counts, any value. Positions beyond INVCAL_MAX_POSITIONS replace the
 * oldest. If your driver delivers g or m/s^2 as fractions, multiply them by 1e6, here and for
 * invcal_apply, and begin with 1e6 or 9.80665e6 counts.
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
 * one that adds the most information (mathematics_programs.md, "Guidance"); of equals, the nearest.
 * A position that is READY and still held counts as taken. It need not be hit exactly.
 *
 * up  out: the direction of the case to point upwards, a unit vector.
 *
 * Cost: 25,000 instructions. Stack: about 480 bytes. */
void invcal_session_next(const invcal_session *session, invcal_real up[3]);

#define INVCAL_TEXT_SIZE 40u /* bytes, with the terminating zero */

/* The same in words: invcal_direction_text (plan.h). Returns text. */
const char *invcal_session_next_text(const invcal_session *session, char text[INVCAL_TEXT_SIZE]);

/* Are there enough positions? Returns 1 if the result of invcal_session_solve is good, with
 * quality.dof of 3 or more or a stated noise. Solves only if a position was taken or the noise
 * stated since. */
int invcal_session_is_good(invcal_session *session);

/* Solves the positions so far, without those that contradict the others (quality.left_out; see
 * invcal_calibrate). Does not change the session: more may follow. If invcal_session_is_good has
 * said so, copies what that has solved.
 *
 * Returns as invcal_calibrate (positions.h). Cost: 140,000 instructions for 18 good positions,
 * 440,000 instructions if three are wrong. Stack: about 1,200 bytes. */
invcal_status invcal_session_solve(const invcal_session *session, invcal_calibration *out,
                                   invcal_quality *quality);

#ifdef __cplusplus
}
#endif

#endif
