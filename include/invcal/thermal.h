/* SPDX-License-Identifier: MIT
 *
 * invcal/thermal.h: a calibration for every temperature.
 *
 *     invcal_thermal_calibrate   positions at several temperatures in, a calibration out
 *     invcal_thermal_at          the calibration at a temperature, to apply to samples
 *
 * Offsets, scales and angles are polynomials of degree 0, 1 or 2 of temperature, over a reference
 * and a span, so that t stays within about -1 ... 1:
 *
 *     t = (T - reference) / span,   X(T) = x0 + x1 t + x2 t^2,   X = (delta, dk, gamma)
 *
 * Positions at all temperatures together determine all coefficients. Exactly two solves, the second
 * for the remainder of the first: nothing has to converge (mathematics.md, "Temperature"). The
 * error over the range is the Cramer-Rao bound of the coefficients; a parabola's is 1.26 times that
 * of a line, so use one only if needed. Deviations from the polynomial stay in the residuals, and
 * so in every sigma.
 *
 * Temperatures are in K or degrees C, from the sensor's own thermometer if it has one. It need not
 * be accurate, but must be repeatable.
 */
#ifndef INVCAL_THERMAL_H
#define INVCAL_THERMAL_H

#include "invcal/positions.h"
#include "invcal/store.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_THERMAL_ROWS 3u /* coefficients of a parameter, those above the degree 0 */

/* A calibration for every temperature: 176 bytes (float). */
typedef struct {
    invcal_real reference, span; /* t = (T - reference) / span */
    invcal_real min, max;        /* temperatures seen: the polynomials hold only between them */
    invcal_calibration nominal;  /* the base of x */
    /* delta, dk, gamma: the coefficients of t^k, k = 0 ... 2 */
    invcal_real x[INVCAL_THERMAL_ROWS][INVCAL_PARAMETERS];
    uint8_t degree;   /* of x */
    uint8_t fitted;   /* degree fitted to the positions; below `degree` only if slopes were kept
                         from the calibration that was renewed (invcal_thermal_fit) */
    uint8_t fallback; /* an invcal_thermal_fallback: why `fitted` is below the requested degree */
} invcal_thermal;

/* ---- at a temperature ------------------------------------------------------------------------ */

/* Where a temperature lies. */
typedef enum {
    INVCAL_THERMAL_WITHIN, /* in the range seen */
    INVCAL_THERMAL_BELOW,  /* colder: gives the calibration at `min` */
    INVCAL_THERMAL_ABOVE   /* warmer: gives the calibration at `max` */
} invcal_thermal_place;

/* The calibration at a temperature, for invcal_apply, by the exact closed form. A device that was
 * calibrated elsewhere links nothing else.
 *
 * Outside the range seen the value at its edge is held, and place reports it: the behaviour of the
 * sensor there is not known, and no sigma covers it.
 *
 * Returns INVCAL_OK; INVCAL_BAD_TEMPERATURE if it is not finite; INVCAL_BAD_NOMINAL,
 * INVCAL_NOT_ELLIPSOID if thermal is damaged.
 * Cost: 1,300 instructions. Call it again only after a relevant change of T: at 1 mg/K, 0.05 K are
 * 5e-5 of the field. Stack: about 250 bytes. */
invcal_status invcal_thermal_at(const invcal_thermal *thermal, invcal_real temperature,
                                invcal_calibration *calibration, invcal_thermal_place *place);

/* ---- the fit --------------------------------------------------------------------------------- */

/* Why the degree is lower than requested: the obstacle to the next higher one. */
typedef uint8_t invcal_thermal_fallback;
enum {
    INVCAL_THERMAL_AS_ASKED, /* it is not lower */
    INVCAL_THERMAL_FEW,      /* fewer positions than coefficients without a prior: 9 (degree + 1) */
    INVCAL_THERMAL_NARROW, /* temperatures span less than 5 K per degree, and there is no prior: the
                                0.5 K of a chip's thermometer would be a tenth of a slope */
    INVCAL_THERMAL_OPEN    /* the positions leave slopes open: some coefficient's sqrt(K) exceeds
                                10. Temperatures fill less than 8 % of the span, are only two for a
                                parabola, or one of two has too few orientations */
};

/* A phrase for it, in read-only memory. Any other value: "unknown reason". */
const char *invcal_thermal_fallback_text(invcal_thermal_fallback fallback);

/* Calibrates from position means and their temperatures.
 *
 * positions  with temperatures, the mean over each rest, which should not drift by more than
 *            2 noise / slope: 0.2 K, if neither is known. At least nine positions for each
 *            coefficient, at different temperatures; twelve to eighteen at each are good, in any
 *            order. Any number.
 * degree     highest degree to fit: 0 (constants), 1 (slopes), 2 (parabolas); at most
 *            INVCAL_THERMAL_DEGREE of the library.
 * out        reference and span are the middle and half the range of the temperatures, at least
 *            1 K.
 * quality    sigma at the reference; elsewhere: invcal_thermal_judge. All other members are of
 *            the whole range, and of all positions and coefficients.
 *
 * Slopes that the positions leave open are omitted, and out->fallback gives the reason: that is not
 * a failure. But without slopes over 5 K or more everything is weak, since the actual slopes then
 * pass for other errors, which residuals need not show; not if degree is 0.
 *
 * Returns as invcal_calibrate_plain; INVCAL_BAD_TEMPERATURE if there are none, or one is not
 * finite; INVCAL_BAD_COUNT for the degree.
 * Cost: 350,000 instructions for 36 positions (degree 1). Stack: 1.3, 2.0, 3.0 KB for an
 * INVCAL_THERMAL_DEGREE of 0, 1, 2. */
invcal_status invcal_thermal_calibrate(const invcal_positions *positions, unsigned degree,
                                       invcal_thermal *out, invcal_quality *quality);

/* What is known beforehand of X against the base, as standard deviations about 0: sigma[0] of X at
 * the reference, sigma[1] of its slopes (per K), sigma[2] of its curvature terms (per K^2); 0: not
 * known. In float none should be below a thousandth of the widest, times the span. */
typedef struct {
    invcal_real sigma[INVCAL_THERMAL_ROWS][INVCAL_PARAMETERS]; /* 0: not known */
} invcal_thermal_prior;

/* The same with an earlier calibration, or with what is known beforehand.
 *
 * A base with slopes keeps them if the positions determine no others: a few positions at one
 * temperature, degree 0, renew offsets, scales and angles of a calibration that has aged. The range
 * of the base then stays, widened by the temperatures of the positions. Otherwise it is theirs.
 *
 * prior   null, or what is known beforehand; the noise must be stated then. With a prior on every
 *         slope even one temperature is enough. If the residuals show more noise than stated,
 *         theirs, quality->noise, weighs the prior: judge with that. Where sigma is more than 0.7
 *         of its prior, that parameter is determined by the prior more than by the positions.
 * base    null: positions->nominal at all temperatures; or an earlier calibration, which replaces
 *         it; may equal out.
 *
 * Returns as invcal_thermal_calibrate; INVCAL_BAD_TEMPERATURE also for one more than two spans from
 * the reference, INVCAL_BAD_COUNT also for the degree of the base, INVCAL_BAD_NOISE for a prior without it, INVCAL_BAD_PRIOR for one that is negative or not
 * finite. */
invcal_status invcal_thermal_fit(const invcal_positions *positions,
                                 const invcal_thermal_prior *prior, const invcal_thermal *base,
                                 unsigned degree, invcal_thermal *out, invcal_quality *quality);

/* How good it is at a temperature: sigma, weak and verdict there, from the covariance of the
 * coefficients and the powers of t.
 *
 * positions, prior  those it was fitted with; prior may be null.
 * temperature       outside the range seen: at its edge, where the value is held.
 *
 * Returns as invcal_thermal_fit. */
invcal_status invcal_thermal_judge(const invcal_positions *positions,
                                   const invcal_thermal_prior *prior, const invcal_thermal *thermal,
                                   invcal_real temperature, invcal_quality *quality);

/* ---- as bytes -----------------------------------------------------------------------------------
 *
 * A calibration for every temperature, with all that is known about it, as 248, 284 or 320 bytes
 * (degree 0, 1, 2), for a memory (store.h), a file or a radio. Numbers as in a record of store.h:
 *
 *     at    size  what
 *       0   1     kind, 0xCB
 *       1   1     version, 2
 *       2   2     length, 212 + 36 (degree + 1)
 *       4   136   the record of the calibration at the reference (store.h)
 *     140   1     degree
 *     141   1     fitted
 *     142   1     fallback
 *     143   1     1: the frame is triangular
 *     144   16    reference, span, min, max
 *     160   48    nominal: offset x, y, z, matrix by rows
 *     208   36    the coefficients x of t^0; then of each further power up to the degree
 *     ...   4     CRC-32 of all before it
 *
 * A device that does not know its temperature finds a plain record at byte 4. */
#define INVCAL_THERMAL_RECORD_BYTES(degree) (212u + 36u * ((degree) + 1u))
/* The largest. */
#define INVCAL_THERMAL_RECORD_SIZE INVCAL_THERMAL_RECORD_BYTES(INVCAL_THERMAL_ROWS - 1u)

/* The content of the bytes. */
typedef struct {
    invcal_thermal thermal; /* the calibration for every temperature */
    invcal_record record;   /* at the reference, or the nearest temperature seen; fill in what you
                               know */
    uint8_t is_triangular;  /* 1: turned by invcal_make_triangular */
} invcal_thermal_record;

/* Makes a record of the result of invcal_thermal_calibrate. Returns as invcal_thermal_at. */
invcal_status invcal_thermal_record_init(invcal_thermal_record *record,
                                         const invcal_thermal *thermal,
                                         const invcal_quality *quality);

/* Encodes a record as bytes, INVCAL_THERMAL_RECORD_BYTES of its degree.
 *
 * Returns INVCAL_OK; on failure the bytes are overwritten: as invcal_record_encode,
 * INVCAL_NOT_FINITE, INVCAL_BAD_NOMINAL, INVCAL_NOT_ELLIPSOID, INVCAL_BAD_COUNT for a degree above
 * 2, and INVCAL_DAMAGED for what no fit gives, or a record of another calibration.
 * Stack: about 660 bytes. */
invcal_status invcal_thermal_record_encode(const invcal_thermal_record *record,
                                           uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE]);

/* Decodes a record from bytes, at any alignment.
 *
 * size  number of bytes; those after the record are ignored.
 *
 * Returns INVCAL_OK; INVCAL_OTHER_VERSION for sound bytes of another kind or version, or of a
 * degree above 2; as invcal_thermal_record_encode otherwise. Stack: as above. */
invcal_status invcal_thermal_record_decode(const uint8_t *bytes, uint32_t size,
                                           invcal_thermal_record *out);

#ifdef __cplusplus
}
#endif

#endif
