/* SPDX-License-Identifier: MIT
 *
 * invcal/thermal.h: a calibration for every temperature.
 *
 *     invcal_thermal_calibrate   positions at several temperatures in, a calibration out
 *     invcal_thermal_at          what holds at a temperature, to be applied to samples
 *
 * Offsets, scales and angles are polynomials of temperature of the degree INVCAL_THERMAL_DEGREE, on a
 * reference temperature and a span, so that t stays within about -1 ... 1:
 *
 *     t = (T - reference) / span,   X(T) = x0 + x1 t + x2 t^2,   X = (delta, dk, gamma)
 *
 * Positions of all temperatures together tell all coefficients. Two solves by count, the second for what
 * the first leaves: nothing has to converge (mathematics.md, "Temperature"). The error over the range is
 * the Cramer-Rao bound of the coefficients; a parabola's is 1.26 times that of a line, so do not ask for
 * it without need. What is no polynomial of this degree stays in the residuals, and so in every sigma.
 *
 * Temperatures are in K or degrees C, from the sensor's own thermometer if it has one. It need not
 * be right, but must tell the same each time.
 */
#ifndef INVCAL_THERMAL_H
#define INVCAL_THERMAL_H

#include "invcal/store.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The degree of the polynomials: 0 (none), 1 (slopes) or 2 (parabolas), a choice of the build. */
#ifndef INVCAL_THERMAL_DEGREE
#define INVCAL_THERMAL_DEGREE 1
#endif
#if INVCAL_THERMAL_DEGREE < 0 || INVCAL_THERMAL_DEGREE > 2
#error "INVCAL_THERMAL_DEGREE must be 0, 1 or 2"
#endif

/* The degree counts, and the positions, as quality has a bit for each. */
#define INVCAL_THERMAL_CHOSEN(name)                                                                \
    INVCAL_THERMAL_CHOSEN_(name, INVCAL_THERMAL_DEGREE, INVCAL_MAX_POSITIONS)
#define INVCAL_THERMAL_CHOSEN_(name, degree, positions)                                            \
    INVCAL_THERMAL_CHOSEN__(name, degree, positions) /* step of it */
#define INVCAL_THERMAL_CHOSEN__(name, degree, positions)                                           \
    INVCAL_CHOSEN(name, degree##_##positions) /* step of it */
#define invcal_thermal_at INVCAL_THERMAL_CHOSEN(invcal_thermal_at)
#define invcal_thermal_calibrate INVCAL_THERMAL_CHOSEN(invcal_thermal_calibrate)
#define invcal_thermal_start INVCAL_THERMAL_CHOSEN(invcal_thermal_start)
#define invcal_thermal_fit INVCAL_THERMAL_CHOSEN(invcal_thermal_fit)
#define invcal_thermal_judge INVCAL_THERMAL_CHOSEN(invcal_thermal_judge)
#define invcal_thermal_record_decode INVCAL_THERMAL_CHOSEN(invcal_thermal_record_decode)
#define invcal_thermal_record_decode_v1 INVCAL_THERMAL_CHOSEN(invcal_thermal_record_decode_v1)

#define INVCAL_THERMAL_ROWS (INVCAL_THERMAL_DEGREE + 1) /* coefficients of a parameter */

/* A calibration for every temperature: 104, 140, 176 bytes for degree 0, 1, 2 (float). */
typedef struct {
    invcal_real reference, span; /* t = (T - reference) / span */
    invcal_real min, max;        /* temperatures seen: only between them the polynomials hold */
    invcal_calibration nominal;  /* what x is against */
    /* delta, dk, gamma: the coefficients of t^k, k = 0 ... INVCAL_THERMAL_DEGREE */
    invcal_real x[INVCAL_THERMAL_ROWS][INVCAL_PARAMETERS];
    uint8_t degree;   /* of x */
    uint8_t fitted;   /* degree that the positions told; less than `degree` only where slopes are
                         those of the calibration that was renewed (invcal_thermal_fit) */
    uint8_t fallback; /* an invcal_thermal_fallback: why `fitted` is less than was wanted */
} invcal_thermal;

/* ---- at a temperature --------------------------------------------------------------------------- */

/* Where a temperature lies. */
typedef enum {
    INVCAL_THERMAL_WITHIN, /* in the range seen */
    INVCAL_THERMAL_BELOW,  /* colder: what holds at `min` is given */
    INVCAL_THERMAL_ABOVE   /* warmer: what holds at `max` is given */
} invcal_thermal_place;

/* The calibration at a temperature, for invcal_apply, by the exact closed form. It is all that a
 * device links which has its calibration from elsewhere.
 *
 * Outside the range seen the value at its edge is held, and place says so: what the sensor does there
 * is not known, and no sigma covers it.
 *
 * Returns INVCAL_OK; INVCAL_BAD_TEMPERATURE if it is not finite; INVCAL_BAD_NOMINAL,
 * INVCAL_NOT_ELLIPSOID if what is stored there has been damaged.
 * Cost: 640 instructions. Make it anew only when T has moved by what matters: at 1 mg/K, 0.05 K are
 * 5e-5 of the field. Stack: about 200 bytes. */
invcal_status invcal_thermal_at(const invcal_thermal *thermal, invcal_real temperature,
                                invcal_calibration *calibration, invcal_thermal_place *place);

/* ---- the fit ------------------------------------------------------------------------------------- */

/* Why the degree is lower than was wanted: what stood against one more. */
typedef enum {
    INVCAL_THERMAL_AS_ASKED, /* it is not */
    INVCAL_THERMAL_FEW,      /* fewer positions than coefficients without a prior: 9 (degree + 1) */
    INVCAL_THERMAL_NARROW,   /* temperatures of less than 5 K for each degree, and no prior: the
                                0.5 K of a chip's thermometer would be a tenth of a slope */
    INVCAL_THERMAL_OPEN      /* the positions do not tell the slopes: some coefficient's sqrt(K)
                                exceeds 10. Temperatures fill less than 8 % of the span, are but two
                                for a parabola, or one of two has too few orientations */
} invcal_thermal_fallback;

/* A phrase for it, in plain English, in read-only memory. Any other value: "unknown reason". */
const char *invcal_thermal_fallback_text(invcal_thermal_fallback fallback);

/* Calibrates from position means and their temperatures.
 *
 * raw          3 count numbers, as invcal_calibrate. At least nine positions for each coefficient,
 *              at different temperatures; twelve to eighteen at each are good, in any order.
 * temperature  count numbers: the mean over each rest, see invcal_thermal_drift_limit.
 * count, nominal, noise  as invcal_calibrate.
 * out          reference and span are the middle and half the range of the temperatures, at least
 *              1 K.
 * quality      sigma at the reference; elsewhere: invcal_thermal_judge. All the rest is of the whole
 *              range, and of all positions and coefficients.
 *
 * Slopes that the positions do not tell are left out, and out->fallback says why: that is no failure.
 * But without any over 5 K or more everything is weak: slopes then pass for errors of other kinds,
 * which residuals need not show.
 *
 * Returns as invcal_calibrate, and INVCAL_BAD_TEMPERATURE for one that is not finite.
 * Cost: 350,000 instructions for 36 positions (degree 1). Stack: 1.4, 2.1, 3.1 KB for degree 0, 1, 2. */
invcal_status invcal_thermal_calibrate(const invcal_real *raw, const invcal_real *temperature,
                                       unsigned count, const invcal_calibration *nominal,
                                       invcal_real noise, invcal_thermal *out,
                                       invcal_quality *quality);

/* How far temperature may drift in one rest that is to be a position, K from min to max: 2 noise /
 * slope. A thermometer that lags behind the sensor is wrong by half the drift at most, and that then
 * makes no more than the noise of a position. (The drift itself does no harm: the mean reading belongs
 * to the mean temperature.)
 *
 * noise  of a position mean, over field; 0: not known, 1e-4.
 * slope  the largest one of an offset, 1/K; 0: not known, 1 mg/K. Both unknown make 0.2 K.
 *
 * Returns 0, no drift at all, for a noise or slope that is negative or no number. */
invcal_real invcal_thermal_drift_limit(invcal_real noise, invcal_real slope);

/* ---- by parts, for other choices ------------------------------------------------------------------ */

/* Positions, and what they were read with: see invcal_thermal_calibrate. */
typedef struct {
    const invcal_real *raw;         /* 3 count numbers */
    const invcal_real *temperature; /* count numbers */
    unsigned count;                 /* of the positions */
    invcal_real noise;              /* of a position mean, over field; 0: not known */
} invcal_thermal_positions;

/* A base that knows the nominal calibration only: X = 0 at all temperatures.
 *
 * temperature  count numbers, those of the positions or the ends of the range of use: they make
 *              reference and span, as in invcal_thermal_calibrate.
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOMINAL, INVCAL_BAD_TEMPERATURE, INVCAL_TOO_FEW if there are none. */
invcal_status invcal_thermal_start(const invcal_calibration *nominal,
                                   const invcal_real *temperature, unsigned count,
                                   invcal_thermal *out);

/* What is known beforehand of X against the base, as standard deviations about none: sigma[0] of X at
 * the reference, sigma[1] of its slopes (per K), sigma[2] of what bends them (per K^2); 0: nothing is
 * known. In float none should be below a thousandth of the widest, times the span. */
typedef struct {
    invcal_real sigma[INVCAL_THERMAL_ROWS][INVCAL_PARAMETERS]; /* 0: not known */
} invcal_thermal_prior;

/* Solves for what the positions have against the base, and corrects it.
 *
 * A base with slopes keeps them where the positions tell no others, and its range with them: a few
 * positions at one temperature, degree 0, renew offset, scales and angles of a calibration that has
 * aged. Otherwise the range is that of the positions.
 *
 * prior   null, or what is known beforehand; the noise has to be stated then. With a prior on every
 *         slope even one temperature is enough. Where the residuals tell more noise than is stated, the
 *         prior is weighed with theirs, quality->noise: judge with that. Where sigma is more than 0.7
 *         of its prior, the prior has told more of that parameter than the positions.
 * base    of invcal_thermal_start, or an earlier calibration; may be out.
 * degree  the highest one that is wanted.
 *
 * Returns as invcal_thermal_calibrate; INVCAL_BAD_TEMPERATURE also for one more than two spans from
 * the reference, INVCAL_BAD_COUNT for a degree above INVCAL_THERMAL_DEGREE, INVCAL_BAD_NOISE for a
 * prior without it, INVCAL_BAD_PRIOR for one that is negative or not finite. */
invcal_status invcal_thermal_fit(const invcal_thermal_positions *positions,
                                 const invcal_thermal_prior *prior, const invcal_thermal *base,
                                 unsigned degree, invcal_thermal *out, invcal_quality *quality);

/* How good it is at a temperature: sigma, weak and verdict there, from the covariance of the
 * coefficients and the powers of t.
 *
 * positions, prior  those that it was made of.
 * temperature       outside the range seen: at its edge, where the value is held.
 *
 * Returns as invcal_thermal_fit. */
invcal_status invcal_thermal_judge(const invcal_thermal_positions *positions,
                                   const invcal_thermal_prior *prior, const invcal_thermal *thermal,
                                   invcal_real temperature, invcal_quality *quality);

/* ---- as bytes -------------------------------------------------------------------------------------
 *
 * A calibration for every temperature with all that is known about it as 248, 284 or 320 bytes (degree
 * 0, 1, 2), for a memory (store.h), a file or a radio. Numbers as in a record of store.h:
 *
 *     at    size  what
 *       0   1     kind, 0xCB
 *       1   1     version, 2
 *       2   2     length, 212 + 36 (degree + 1)
 *       4   136   the record of what holds at the reference (store.h)
 *     140   1     degree
 *     141   1     fitted
 *     142   1     fallback
 *     143   1     1: the frame is triangular
 *     144   16    reference, span, min, max
 *     160   48    nominal: offset x, y, z, matrix by rows
 *     208   36    the coefficients x of t^0; so for each further power up to the degree
 *     ...   4     CRC-32 of all before it
 *
 * A device that does not know its temperature finds a record at byte 4. In version 1, of 0.1.0, the
 * record has 184 bytes, and matrices are in the unit of the field. */
#define INVCAL_THERMAL_RECORD_BYTES(degree) (212u + 36u * ((degree) + 1u))
/* The largest that this build writes, and reads. */
#define INVCAL_THERMAL_RECORD_SIZE INVCAL_THERMAL_RECORD_BYTES(INVCAL_THERMAL_DEGREE)
/* The same of version 1. */
#define INVCAL_THERMAL_RECORD_SIZE_V1                                                              \
    (INVCAL_THERMAL_RECORD_SIZE + INVCAL_RECORD_SIZE_V1 - INVCAL_RECORD_SIZE)

/* What the bytes say. */
typedef struct {
    invcal_thermal thermal; /* the calibration for every temperature */
    invcal_record record;   /* of what holds at the reference; more may be filled in */
    uint8_t is_triangular;  /* 1: that has been through invcal_make_triangular, as 0.1.0 offered */
} invcal_thermal_record;

/* Makes one of what invcal_thermal_calibrate gives. Returns as invcal_thermal_at. */
invcal_status invcal_thermal_record_init(invcal_thermal_record *record,
                                         const invcal_thermal *thermal,
                                         const invcal_quality *quality);

/* A record as bytes, INVCAL_THERMAL_RECORD_BYTES of its degree.
 *
 * Returns INVCAL_OK; on failure the bytes are lost: as invcal_record_encode, INVCAL_NOT_FINITE,
 * INVCAL_BAD_NOMINAL, INVCAL_NOT_ELLIPSOID, INVCAL_BAD_COUNT for a degree above that of the build, and
 * INVCAL_DAMAGED for what no fit gives, or a record of another calibration. Stack: about 700 bytes. */
invcal_status invcal_thermal_record_encode(const invcal_thermal_record *record,
                                           uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE]);

/* A record from bytes, at any alignment.
 *
 * size  how many there are; what follows the record is not looked at.
 *
 * Returns INVCAL_OK; INVCAL_OTHER_VERSION for sound bytes of another kind or version, or of a degree
 * above that of the build; as invcal_thermal_record_encode otherwise. Stack: as above. */
invcal_status invcal_thermal_record_decode(const uint8_t *bytes, uint32_t size,
                                           invcal_thermal_record *out);

/* The same of a record of version 1, which release 0.1.0 wrote: over field, as all are now.
 *
 * Returns as invcal_thermal_record_decode; INVCAL_OTHER_VERSION for any version but 1. Stack: about 800
 * bytes. */
invcal_status invcal_thermal_record_decode_v1(const uint8_t *bytes, uint32_t size,
                                              invcal_thermal_record *out);

#ifdef __cplusplus
}
#endif

#endif
