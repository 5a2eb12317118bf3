/* SPDX-License-Identifier: MIT
 *
 * invcal/invcal.h: a device calibrates its own accelerometer, with nothing but gravity for a
 * reference. This header is all that most programs include:
 *
 *     calibration   what a correction is, and how it is applied
 *     calibrate     position means that stand in an array
 *     session       the whole procedure: samples in, what to tell the person out
 *
 * Beside it: store.h (what survives a reset), thermal.h (temperature), allan.h (noise), plan.h
 * (programs for a stand), expert.h (the steps one by one, and the options that few need).
 *
 * The sensor. A triad at rest in a field of length 1 reads, whatever its orientation eta,
 *
 *     u = (I + S) eta + delta + noise,
 *
 * u what the nominal calibration of the data sheet makes of the raw counts, S = diag(dk) + the
 * symmetric cross terms gamma / 2. So all readings lie on an ellipsoid, and a dozen of them tell
 * its nine parameters (mathematics.md, "The sensor").
 *
 * Units. A reading is in *raw* counts, as the sensor delivers it, or *over field*: in units of the
 * length of the field, which is g for an accelerometer. There is no other unit; invcal_scale makes
 * m/s^2 of a calibration. A magnetometer is calibrated the same way, over its own field.
 *
 * Rules for all of the library, not repeated at each function:
 *
 * - A function that returns anything but INVCAL_OK has left its outputs untouched, unless its own
 *   description says otherwise.
 * - Every comparison fails closed: a NaN is never taken for a good value.
 * - Structures are plain data owned by the caller: no pointers into themselves, no release, and they
 *   may be copied with memcpy. What is in them may be read; change it by the functions only.
 * - There are no globals: every function is reentrant, and safe in an interrupt or a thread as long
 *   as nobody else changes its arguments meanwhile.
 * - A null pointer is a programming error (INVCAL_ASSERT), not a status.
 * - Costs are instructions of a Cortex-M4F at -O2 and stack of the same at -Os, in float.
 */
#ifndef INVCAL_INVCAL_H
#define INVCAL_INVCAL_H

#include <float.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- what a build may choose ------------------------------------------------------------------
 *
 * Nothing has to be set. Define a macro on the command line, or name a header of your own that is
 * included first: -DINVCAL_CONFIG_HEADER='"my_invcal_config.h"'. A program and a library that were
 * compiled with different choices do not link. */
#ifdef INVCAL_CONFIG_HEADER
#include INVCAL_CONFIG_HEADER
#endif

/* The version. This is its only source: packages read it from here. */
#define INVCAL_VERSION_MAJOR 0
#define INVCAL_VERSION_MINOR 2 /* of 0.2.0 */
#define INVCAL_VERSION_PATCH 0 /* of 0.2.0 */
/* All three as text. */
#define INVCAL_VERSION                                                                             \
    INVCAL_TEXT(INVCAL_VERSION_MAJOR)                                                              \
    "." INVCAL_TEXT(INVCAL_VERSION_MINOR) "." INVCAL_TEXT(INVCAL_VERSION_PATCH)
#define INVCAL_TEXT(number) INVCAL_TEXT_OF(number) /* a macro's value as text */
#define INVCAL_TEXT_OF(number) #number             /* its name as text */

/* 0: invcal_real is float, and nothing is computed in double. 1: it is double. */
#ifndef INVCAL_DOUBLE
#define INVCAL_DOUBLE 0
#endif

/* How many positions a session keeps, and among how many outliers are looked for: a number from 12
 * to 64, in plain digits. Each costs 12 bytes of the session (float). By default 24, on an AVR 16. */
#if defined(__AVR__) && !defined(INVCAL_MAX_POSITIONS)
#define INVCAL_MAX_POSITIONS 16 /* with 2 KB of RAM, as an Arduino Uno has them */
#endif
#ifndef INVCAL_MAX_POSITIONS
#define INVCAL_MAX_POSITIONS 24
#endif

/* Called with a condition that only a programming error can break. By default nothing is compiled;
 * define it, for example, as assert or as a breakpoint. */
#ifndef INVCAL_ASSERT
#define INVCAL_ASSERT(condition) ((void)sizeof((condition) ? 1 : 0))
#endif

#if INVCAL_DOUBLE != 0 && INVCAL_DOUBLE != 1
#error "INVCAL_DOUBLE must be 0 (float) or 1 (double)"
#endif
#if INVCAL_DOUBLE && DBL_MANT_DIG < 53
#error "double has no 53 bits here: use float"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "-ffast-math and -ffinite-math-only remove the checks against NaN"
#endif
#if INVCAL_MAX_POSITIONS < 12 || INVCAL_MAX_POSITIONS > 64
#error "INVCAL_MAX_POSITIONS must be from 12 to 64"
#endif

/* The number type, its limits, and libc's functions for it. */
#if INVCAL_DOUBLE
typedef double invcal_real;
#define INVCAL_REAL_NAME double
#define INVCAL_REAL(literal) literal
#define INVCAL_EPSILON DBL_EPSILON
#define INVCAL_REAL_MAX DBL_MAX
#define INVCAL_SQRT sqrt
#define INVCAL_FABS fabs
#else
typedef float invcal_real; /* double with INVCAL_DOUBLE */
/* Its name. (No comment on that line: Arduino's preprocessor would paste it too.) */
#define INVCAL_REAL_NAME float
#define INVCAL_REAL(literal) literal##f /* a constant of this type */
#define INVCAL_EPSILON FLT_EPSILON      /* from 1 to the next number */
#define INVCAL_REAL_MAX FLT_MAX         /* the largest number */
#define INVCAL_SQRT sqrtf               /* the functions of math.h that are needed */
#define INVCAL_FABS fabsf               /* the other of the two */
#endif

/* The choices stand in the names of the functions that every use of a structure begins with: where
 * they differ, the linker says so, and nothing is written behind a structure. */
#define INVCAL_CHOSEN(name, choice) INVCAL_CHOSEN_(name, INVCAL_REAL_NAME, choice)
#define INVCAL_CHOSEN_(name, real, choice) INVCAL_CHOSEN__(name, real, choice) /* step of it */
#define INVCAL_CHOSEN__(name, real, choice) name##_##real##_##choice           /* step of it */
#define invcal_apply INVCAL_CHOSEN(invcal_apply, 9)
#define invcal_nominal INVCAL_CHOSEN(invcal_nominal, 9)
#define invcal_calibrate INVCAL_CHOSEN(invcal_calibrate, INVCAL_MAX_POSITIONS)
#define invcal_calibrate_judged INVCAL_CHOSEN(invcal_calibrate_judged, INVCAL_MAX_POSITIONS)
#define invcal_session_init INVCAL_CHOSEN(invcal_session_init, INVCAL_MAX_POSITIONS)
#define invcal_session_begin INVCAL_CHOSEN(invcal_session_begin, INVCAL_MAX_POSITIONS)

/* A set of positions: bit i for position i. */
#if INVCAL_MAX_POSITIONS <= 16
typedef uint16_t invcal_mask;
#elif INVCAL_MAX_POSITIONS > 32
typedef uint64_t invcal_mask;
#else
typedef uint32_t invcal_mask;
#endif

/* ---- answers ---------------------------------------------------------------------------------- */

/* What a function answers. */
typedef enum {
    INVCAL_OK = 0, /* it has done what it says */

    /* the data */
    INVCAL_NOT_FINITE,    /* a reading is NaN or infinite */
    INVCAL_TOO_FEW,       /* fewer positions, or less of something else, than are needed */
    INVCAL_UNDETERMINED,  /* the positions leave some parameters open: invcal_undetermined */
    INVCAL_NOT_ELLIPSOID, /* the readings lie on no ellipsoid that a sensor triad can produce */

    /* a static interval that is no position */
    INVCAL_OUT_OF_RANGE, /* a reading is below 1/10 or above 10 of the field */
    INVCAL_REST_SHORT,   /* motion came before it was READY */
    INVCAL_REST_DRIFT,   /* readings creep: a slow turn, or it settles */
    INVCAL_REST_CLIPPED, /* the end of the sensor's range was touched */
    INVCAL_REST_FROZEN,  /* nothing has ever changed, or an axis stands still amid the noise of the
                            others: it is not read */
    INVCAL_REST_GAP,     /* short, since samples were lost */
    INVCAL_REST_SAME,    /* where the last position was taken: it tells nothing new */

    /* an argument; the function's description gives its range */
    INVCAL_BAD_NOMINAL,     /* the nominal calibration: singular, not finite, absurdly scaled */
    INVCAL_BAD_RATE,        /* samples per second */
    INVCAL_BAD_RAILS,       /* the ends of the sensor's range */
    INVCAL_BAD_NOISE,       /* a standard deviation */
    INVCAL_BAD_WEIGHT,      /* of a row */
    INVCAL_BAD_PRIOR,       /* what is known beforehand */
    INVCAL_BAD_FIELD,       /* the length of the field */
    INVCAL_BAD_COUNT,       /* of positions, or of anything else */
    INVCAL_BAD_DIRECTION,   /* no unit vector */
    INVCAL_BAD_PROGRAM,     /* angles, or positions per group, of a stand's program */
    INVCAL_BAD_TEMPERATURE, /* a temperature, its reference or its span */
    INVCAL_BAD_TAU,         /* averaging times */
    INVCAL_BAD_STORE,       /* slot size or granularity of a memory */

    /* stored bytes */
    INVCAL_NO_RECORD,     /* nothing is stored there */
    INVCAL_DAMAGED,       /* not what was written: too short, a wrong CRC, or nonsense */
    INVCAL_OTHER_VERSION, /* of a version of the library, or a kind, unknown here */
    INVCAL_NO_SPACE,      /* larger than the buffer, the slot, or the table of a session */
    INVCAL_IO,            /* the memory's driver reports a failure */

    /* moves between rests: gyro.h */
    INVCAL_MOVE_GAP,    /* samples were lost in it */
    INVCAL_MOVE_LONG,   /* it took more than 10 s */
    INVCAL_MOVE_APART,  /* it contradicts the others */
    INVCAL_MOUNTING,    /* the gyroscope turns otherwise than the accelerometer */
    INVCAL_STATUS_COUNT /* their number; no status */
} invcal_status;

/* A sentence for a status, in plain English without a full stop, in read-only memory. Any value
 * outside the enumeration gives "unknown status". */
const char *invcal_status_text(invcal_status status);

/* The nine parameters in the order of the paper's vector X and of every array of nine here. */
enum {
    INVCAL_DELTA_X = 0, /* zero offset over field (an accelerometer's: unit g) */
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
const char *invcal_parameter_name(unsigned parameter);

/* ---- a calibration, and its use ---------------------------------------------------------------- */

/* What a correction takes: calibrated = matrix (raw - offset). The same structure states what is
 * known beforehand: the *nominal* calibration of a data sheet, or an earlier one to be renewed. */
typedef struct {
    invcal_real offset[3];    /* raw reading in no field, raw counts */
    invcal_real matrix[3][3]; /* over field per raw count, by rows */
} invcal_calibration;

/* The nominal calibration of a data sheet.
 *
 * zero    raw reading in no field, raw counts.
 * counts  raw counts per field (per g) of each axis; a negative one turns the axis round.
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOMINAL if a number is not finite, or a count is outside 1e-10 ...
 * 1e10 or a zero beyond 1e18 of the field. */
invcal_status invcal_nominal(const invcal_real zero[3], const invcal_real counts[3],
                             invcal_calibration *out);

/* Applies a calibration: calibrated = matrix (raw - offset).
 *
 * raw         one sample or mean, raw counts.
 * calibrated  the field; may be the same array as raw.
 *
 * Nothing is checked: a NaN in gives a NaN out. Cost: 43 instructions. */
void invcal_apply(const invcal_calibration *calibration, const invcal_real raw[3],
                  invcal_real calibrated[3]);

/* The same for a sample as the sensor delivers it. */
void invcal_apply_counts(const invcal_calibration *calibration, const int32_t raw[3],
                         invcal_real calibrated[3]);

/* Puts a unit into a calibration: field is the length of the field in that unit, 9.80665 for m/s^2.
 * From then on it is one to apply only, no nominal.
 *
 * Returns INVCAL_OK; INVCAL_BAD_FIELD unless field is finite and positive. */
invcal_status invcal_scale(invcal_calibration *calibration, invcal_real field);

/* ---- how good it is ---------------------------------------------------------------------------- */

/* An error that positions share, and that no nine parameters describe. */
typedef enum {
    INVCAL_NO_SYSTEMATIC, /* none was found */
    INVCAL_DRIFT,         /* the offset changes from the first position to the last */
    INVCAL_QUADRATIC,     /* an axis that points x up reads x^2 too much, times the size */
    INVCAL_CUBIC,         /* the same with x^3 */
    INVCAL_HYSTERESIS /* an axis that was turned upwards to get there reads more than one turned down */
} invcal_systematic;

/* May the calibration be used? The larger, the worse: of two that hold it is the larger. */
typedef enum {
    INVCAL_GOOD,          /* every parameter determined, and checked by positions to spare */
    INVCAL_NO_REDUNDANCY, /* determined, but by as many directions as unknowns: nothing checks it */
    INVCAL_ROUGH,         /* residuals that noise does not explain, or too many positions that
                             contradict the others: something is wrong */
    INVCAL_DRIFTING,      /* the sensor drifts: let it warm up, or be quicker */
    INVCAL_BENT,          /* nonlinearity or hysteresis: no nine parameters describe this sensor */
    INVCAL_WEAK           /* some parameter is determined badly, see quality.weak: usable only
                             within its large sigma */
} invcal_verdict;

/* "good", "no redundancy", "rough", "drifting", "bent", "weak"; any other value gives "unknown
 * verdict". */
const char *invcal_verdict_text(invcal_verdict verdict);

/* How well a calibration is known. */
typedef struct {
    uint8_t verdict;    /* an invcal_verdict: what all this comes to */
    uint8_t systematic; /* an invcal_systematic: what was found */
    uint8_t axis;       /* where that is: 0 x, 1 y, 2 z */
    /* bit k: systematic error k was not looked for, or the positions hardly tell it from the nine */
    uint8_t unchecked;
    /* bit r: parameter r is badly determined: its sigma is above ten times the noise, or the noise
     * in the readings themselves would make it look determined */
    uint16_t weak;
    uint16_t positions;    /* that made it */
    uint16_t dof;          /* degrees of freedom left to the residuals; 0: no check */
    uint16_t sigma_dof;    /* degrees of freedom behind sigma, for invcal_coverage */
    uint16_t worst;        /* the position of max, from 0 */
    invcal_mask left_out;  /* bit i: position i contradicts the others, and was left out */
    invcal_mask suspected; /* bit i: position i may be the one of these that is wrong */
    /* of the systematic error, over field: by how much the offset has grown from the first position to the
     * last; the coefficient of x^2 or x^3; what "up" reads more than "down" */
    invcal_real size;
    invcal_real noise; /* standard deviation of a position mean on each axis behind sigma, over
                          field: what is stated and what is observed together, or what is observed
                          where that is clearly more, or next to nothing beside what is stated; 1,
                          the whole field, if neither is there */
    invcal_real rms;   /* of the residuals |calibrated| - 1 over the positions */
    invcal_real max;   /* the largest of these, without its sign */
    /* of the information on the nine: tr K tr K^-1 with K = sigma^2 / noise^2, which is above the
     * condition. 130 is the best there is */
    invcal_real condition;
    invcal_real sigma[INVCAL_PARAMETERS]; /* standard deviation of delta (over field), dk (1) and
                                             gamma (rad) against nominal: the Cramer-Rao bound */
} invcal_quality;

/* The factor k for which +- k sigma covers 95 %: Student's t for a sigma estimated with dof degrees
 * of freedom, 12.706 at 1 (and at 0), 1.960 for very many. Exact to 0.002 (relative). */
invcal_real invcal_coverage(unsigned dof);

/* How exact a calibrated length is: the half-width of the interval that holds what is wrong with it in
 * 95 % of cases, over field, the root mean square over all directions. The noise of the reading itself
 * comes on top.
 *
 * gravity  what is stated of the field's magnitude: its standard deviation, over field. 0.0027 if it is
 *          9.80665 m/s^2 somewhere on Earth, 0.00005 if latitude and height told it; 0 if the field
 *          itself is the unit.
 *
 * From sigma alone, as if the scale errors were independent: within 10 % (mathematics.md, "Accuracy").
 * Cost: 150 instructions. */
invcal_real invcal_accuracy(const invcal_quality *quality, invcal_real gravity);

/* Calibrates from position means.
 *
 * raw      3 count numbers: position means x y z, x y z, ... in raw counts, in any order. Nine is the
 *          min, twelve to eighteen well spread ones are good. In float a mean carries 24 bits: from
 *          counts above 2^24 subtract first.
 * count    up to 65534.
 * nominal  data sheet, or an earlier calibration; may be out.
 * noise    standard deviation of a position mean on each axis, over field, below 1; 0: not known,
 *          only the residuals tell.
 * out      the calibration: the symmetric correction A, closest to the axes of nominal
 *          (mathematics.md, "From p to the calibration").
 * quality  how good it is. Look at its verdict before you use the calibration.
 *
 * It judges by the size of the residuals alone: invcal_calibrate_judged looks at what is behind them.
 *
 * Returns INVCAL_OK;
 *   INVCAL_BAD_NOMINAL    see invcal_nominal; or singular to rounding;
 *   INVCAL_BAD_NOISE, INVCAL_BAD_COUNT;
 *   INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE    for a reading: invcal_bad_reading says which;
 *   INVCAL_TOO_FEW        fewer than nine;
 *   INVCAL_UNDETERMINED   the positions leave parameters open, to the precision of the number type:
 *                         invcal_undetermined names them;
 *   INVCAL_NOT_ELLIPSOID  the readings lie on no ellipsoid (but, say, on a hyperboloid), on no triad's
 *                         (with a semi-axis below about 1/10 of nominal or of another one, or its
 *                         centre beyond ten times the field), or scatter by a tenth of the field.
 * Cost: 18,000 instructions for 18 positions. Stack: about 620 bytes. */
invcal_status invcal_calibrate(const invcal_real *raw, unsigned count,
                               const invcal_calibration *nominal, invcal_real noise,
                               invcal_calibration *out, invcal_quality *quality);

/* The same, and looks for what the nine parameters do not explain (mathematics.md, "Judgement"): positions
 * that contradict the others, which are left out; and errors that all share - a drift, a nonlinearity,
 * hysteresis - which are named with their axis and size. Directions within 5 degrees count once.
 *
 * count  up to INVCAL_MAX_POSITIONS, in the order in which they were visited, at equal intervals.
 * out    not nominal.
 *
 * In quality, left_out, suspected, systematic, axis, size and unchecked are set, and the verdict is by all of
 * these. Of 18 good positions about one set in a hundred is not called good.
 *
 * Returns as invcal_calibrate; INVCAL_BAD_COUNT for more than INVCAL_MAX_POSITIONS.
 * Cost: 120,000 instructions for 18 good positions. Stack: about 980 bytes. */
invcal_status invcal_calibrate_judged(const invcal_real *raw, unsigned count,
                                      const invcal_calibration *nominal, invcal_real noise,
                                      invcal_calibration *out, invcal_quality *quality);

/* ---- a session: the whole procedure -------------------------------------------------------------
 *
 *     invcal_session_init(&session, 16384, 100);
 *     for every sample:
 *         switch (invcal_session_feed(&session, raw))
 *             READY   the position is good: move on
 *             TAKEN   where to turn next: invcal_session_next_words; store.h: save the session
 *             REFUSED why: invcal_session_why
 *     until invcal_session_is_good(&session)
 *     invcal_session_solve
 *
 * A *static interval*, or rest, is a stretch of samples in which the device does not turn. The
 * session finds them in the stream, cuts off what still moves at their ends, and sums the rest
 * exactly, in integers. There is nothing to tune: what noise is, the stream itself tells. About 2 s
 * in each orientation are enough. Let a stream begin at rest, if you can. */

/* What a sample brought about. */
typedef enum {
    INVCAL_NOTHING,  /* nothing: its block of 1/8 s is not full */
    INVCAL_MOVING,   /* motion, or a rest disturbed for a moment */
    INVCAL_SETTLING, /* at rest: hold still; see invcal_session_progress */
    INVCAL_READY,    /* enough for a position, said once in a rest: move on, or stay and make its
                        mean better */
    INVCAL_TAKEN,    /* the device has left it, and its mean is in the table */
    INVCAL_REFUSED   /* a rest, but no position: invcal_session_why; said once */
} invcal_event;

/* Internal: an axis of the detector of rests. Means are in 1/1024 counts. */
typedef struct {
    int32_t first;  /* sample of the block */
    uint32_t sum;   /* of the differences to it, modulo 2^32; then the block's mean from origin */
    int32_t origin; /* a place that means of blocks are relative to */
    int32_t place;  /* that of the position taken last; before that, of the first block */
} invcal_rests_axis;

/* Internal: the detector of rests (expert.h). What is called a level is a logarithm, see rests.c. */
typedef struct {
    uint8_t stage, flags, hold, drift; /* of the rest that is looked for, see rests.c */
    uint8_t pended;                    /* its newest blocks that are held back, up to 2; 0: none */
    uint8_t skip;                      /* quiet blocks to be passed over before it begins */
    uint8_t reason;                    /* of what was refused last */
    uint8_t taken;                     /* there has been a position: `place` is one */
    uint8_t seen;                      /* of the block */
    uint8_t run;                       /* blocks in a row of another noise level, or of none */
    uint8_t least;       /* blocks that make a position, however short the time to hold */
    uint8_t bits;        /* a block has 1 << bits samples */
    uint16_t dwell;      /* the same with it */
    uint16_t blocks;     /* summed of the rest, without those held back; at most 1.6 hours */
    uint16_t pace;       /* blocks in 1/125 s, 1/65536 */
    int16_t noise;       /* level, learned from the stream, see above; 0: nothing is known yet */
    int16_t wander;      /* and this */
    int16_t reach;       /* and this */
    int16_t other;       /* another noise level in the making */
    uint16_t missing;    /* samples until it is full; 0: the next begins another */
    uint32_t span;       /* twice what differences may be to be added quickly; 0: none */
    uint32_t quantum;    /* smallest change ever seen inside a block, counts; 0: none as yet */
    uint32_t time;       /* samples in full blocks so far, modulo 2^32 */
    int32_t low;         /* rail, the least that the sensor reads */
    uint32_t between;    /* readings between low and the other rail */
    uint64_t square;     /* of the block: squares of the differences, the three axes together; then
                         their variance */
    uint32_t begin, end; /* of the rest: first block's first sample; behind the newest block */
    invcal_rests_axis axis[3]; /* x, y, z */
    struct {
        uint64_t variance;     /* sum over the blocks and those held back, 1/64 counts^2 */
        uint64_t total[3];     /* sums of the samples, relative to origin, modulo 2^64 */
        int32_t pending[2][3]; /* means of the blocks held back: lost if motion follows */
        int32_t once[3];       /* fading mean of the means */
        int32_t lag[3];        /* how far the fading mean of that mean is behind it */
    } rest;                    /* the one that is looked for */
} invcal_rests;

/* A session: 560 bytes (float, 24 positions). mean and count may be read. nominal may be replaced, as
 * means are in counts: by one with which all of them are readings (invcal_bad_reading, expert.h).
 * invcal_session_is_good looks at it when the next position is taken. */
typedef struct {
    /* what lasts: store.h */
    uint32_t layout;                           /* of this, to be told from another build's */
    uint32_t hold;                             /* milliseconds, as stated; 0: as short as can be */
    int32_t low, high;                         /* rails */
    uint32_t rate;                             /* samples per second */
    uint8_t count;                             /* of the means */
    uint8_t last;                              /* the last event that was not INVCAL_NOTHING */
    uint8_t reason;                            /* of INVCAL_REFUSED, an invcal_status */
    uint8_t good;                              /* internal: is_good, as known by now */
    invcal_real noise;                         /* stated, over field; 0: not known */
    invcal_calibration nominal;                /* what it began with */
    invcal_real mean[INVCAL_MAX_POSITIONS][3]; /* raw counts, in the order they were taken */
    /* what does not */
    invcal_rests rests; /* the detector */
} invcal_session;

/* Begins a session for a sensor whose zero is 0 and whose axes have one scale.
 *
 * counts  raw counts per field: 16384 for a sensor of +-2 g and 16 bits.
 * rate    samples per second, 8 ... 8000; to 10 % is good enough.
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOMINAL, INVCAL_BAD_RATE. */
invcal_status invcal_session_init(invcal_session *session, invcal_real counts, unsigned rate);

/* Begins a session for any other sensor.
 *
 * nominal  data sheet (invcal_nominal), or an earlier calibration that is to be renewed.
 *
 * Returns as invcal_session_init. */
invcal_status invcal_session_begin(invcal_session *session, const invcal_calibration *nominal,
                                   unsigned rate);

/* The counts at which the sensor clips, low < high (-32768, 32767): a rest at one of them is refused
 * from now on. Without it clipping is not noticed.
 *
 * Returns INVCAL_OK; INVCAL_BAD_RAILS. */
invcal_status invcal_session_rails(invcal_session *session, int32_t low, int32_t high);

/* States the noise: the standard deviation of a position mean on each axis, over field, above 0 and
 * below 1. Without it the residuals alone tell.
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOISE. */
invcal_status invcal_session_noise(invcal_session *session, invcal_real noise);

/* How long a rest must be measured from now on, milliseconds; never less than 0.6 s, at most an
 * hour. How long is worth while, allan.h tells. */
void invcal_session_hold(invcal_session *session, uint32_t milliseconds);

/* Feeds one sample, raw counts, any value.
 *
 * Positions beyond INVCAL_MAX_POSITIONS take the place of the oldest.
 *
 * Bounded: it never solves. Cost: 62 instructions on average at 1 kHz, 98 at 100 Hz.
 * Stack: about 230 bytes. */
invcal_event invcal_session_feed(invcal_session *session, const int32_t raw[3]);

/* Samples were lost here. A rest goes on if what comes agrees with it. */
void invcal_session_gap(invcal_session *session);

/* The stream ends: a rest that is going on is closed as motion would. Returns INVCAL_TAKEN,
 * INVCAL_REFUSED, or INVCAL_MOVING if there was none. */
invcal_event invcal_session_finish(invcal_session *session);

/* How much of a position is there, percent: 0 in motion, 100 from READY on. */
unsigned invcal_session_progress(const invcal_session *session);

/* The last event other than INVCAL_NOTHING, for those who poll. */
invcal_event invcal_session_last(const invcal_session *session);

/* Why the last rest was refused; INVCAL_OK before the first. */
invcal_status invcal_session_reason(const invcal_session *session);

/* The same as a sentence, such as invcal_status_text gives, "" before the first; those of the other
 * statuses are not linked for it. */
const char *invcal_session_why(const invcal_session *session);

/* Which orientation to take next: of 26 directions - the faces, edges and corners of a cube - the
 * one that tells most beside those taken (mathematics.md, "Guidance"); of equals the one that is
 * nearest to the present one. A position that is READY and still held counts as taken. Positions
 * need not be hit: what was really read is in the table, and the next direction makes up for it.
 *
 * up  out: the direction that is to point upwards, in the frame of the case: a unit vector.
 *
 * Cost: 14,000 instructions. Stack: about 470 bytes. */
void invcal_session_next(const invcal_session *session, invcal_real up[3]);

#define INVCAL_WORDS 40u /* bytes, with the terminating zero */

/* The same in words, which are returned: see invcal_words. */
const char *invcal_session_next_words(const invcal_session *session, char words[INVCAL_WORDS]);

/* A direction in words: "+z up"; "+z up, tilt 45 deg, +x rises"; "-z up, tilt 55 deg, +x and -y
 * rise": from an axis pointing up, tilt the case by so much (to 5 degrees) that the sides named
 * come up. Plain ASCII, terminated by zero.
 *
 * up  unit vector. Returns words. */
const char *invcal_words(const invcal_real up[3], char words[INVCAL_WORDS]);

/* Is the position taken last within 20 degrees of a direction, such as that of a program (plan.h)?
 * Returns 1 or 0; 0 if none was taken.
 *
 * up  unit vector. */
int invcal_session_is_at(const invcal_session *session, const invcal_real up[3]);

/* Solves what has been taken so far, without the positions that contradict the others
 * (quality.left_out; see invcal_calibrate_judged). The session is not changed: more may follow.
 *
 * Returns as invcal_calibrate. Cost: 190,000 instructions for 18 good positions, up to 400,000 if
 * some are wrong. Stack: about 1,000 bytes. */
invcal_status invcal_session_solve(const invcal_session *session, invcal_calibration *out,
                                   invcal_quality *quality);

/* Is it enough? 1 if what invcal_session_solve gives is good, and 3 degrees of freedom or a stated
 * noise are behind its sigma. It solves only when a position was taken since it was last asked. */
int invcal_session_is_good(invcal_session *session);

/* Is it as good as wanted? 1 if it is good, and every sigma, widened by what few degrees of freedom
 * leave open, is within the target: sigma of delta (over field), dk (1), gamma (rad). Solves: ask
 * it after a position was taken. */
int invcal_session_reaches(const invcal_session *session, const invcal_real target[3]);

/* The same in one number: 1 if it is good, and invcal_accuracy, with the same gravity, is no more than
 * needed. Solves: ask it after a position was taken. */
int invcal_session_meets(const invcal_session *session, invcal_real need, invcal_real gravity);

#ifdef __cplusplus
}
#endif

#endif
