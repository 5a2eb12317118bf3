/* SPDX-License-Identifier: MIT
 *
 * invcal/thermal.h: a calibration for every temperature.
 *
 *     invcal_thermal_calibrate   positions at several temperatures in, a calibration out
 *     invcal_thermal_at          the calibration at a temperature, to apply to samples
 *
 * Offsets, scales and angles are polynomials of temperature, over a reference and a span, so that t
 * stays within about -1 ... 1:
 *
 *     t = (T - reference) / span,   X(T) = x0 + x1 t + x2 t^2,   X = (delta, dk, gamma)
 *
 * Positions at all temperatures together determine all coefficients. Exactly two solves: nothing
 * has to converge (mathematics.md, "Temperature"). A parabola's error is 1.26 times that of a line,
 * so use one only if needed. Deviations from the polynomial stay in the residuals, and so in every
 * sigma.
 *
 * Temperatures are in K or degrees C, from the sensor's own thermometer if it has one. It need not
 * be accurate, but must be repeatable. Leave out rests in which it drifts by more than twice the
 * noise of a mean / slope of an offset: 0.2 K, if neither is known.
 *
 * invcal.h states the rules and units; thermal_store.h keeps the result.
 */
#ifndef INVCAL_THERMAL_H
#define INVCAL_THERMAL_H

#include "invcal/positions.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Why the degree is lower than requested: the obstacle to the next higher one. */
typedef uint8_t invcal_thermal_fallback;
enum {
    INVCAL_THERMAL_AS_ASKED, /* it is not lower */
    INVCAL_THERMAL_FEW,      /* fewer positions than coefficients without a prior: 9 (degree + 1) */
    INVCAL_THERMAL_NARROW,   /* temperatures span less than 5 K per degree, and there is no prior */
    INVCAL_THERMAL_OPEN      /* the positions leave slopes open: temperatures fill less than 8 % of
                                the span, are only two for a parabola, or one of two has too few
                                orientations */
};

/* A phrase for it; "unknown reason" for any other value. */
const char *invcal_thermal_fallback_text(invcal_thermal_fallback fallback);

/* A calibration for every temperature: 176 bytes (float) in every build. */
typedef struct {
    invcal_real reference, span;         /* t = (T - reference) / span */
    invcal_real min, max;                /* temperatures seen: X holds only between them */
    invcal_calibration nominal;          /* the base of x */
    invcal_real x[3][INVCAL_PARAMETERS]; /* coefficients of t^0, t^1, t^2; 0 above degree */
    uint8_t degree;                      /* of x */
    uint8_t fitted; /* to the positions; below `degree` only if invcal_thermal_fit kept the slopes
                       of its base */
    invcal_thermal_fallback fallback; /* why `fitted` is below the requested degree */
} invcal_thermal;

/* ---- at a temperature ------------------------------------------------------------------------ */

/* Where a temperature lies. */
typedef enum {
    INVCAL_THERMAL_WITHIN, /* in the range seen */
    INVCAL_THERMAL_BELOW,  /* colder: gives the calibration at `min` */
    INVCAL_THERMAL_ABOVE   /* warmer: gives the calibration at `max` */
} invcal_thermal_place;

/* The calibration at a temperature, for invcal_apply. A device that was calibrated elsewhere links
 * nothing else.
 *
 * out    outside the range seen the value at its edge is held: the behaviour of the sensor there is
 *        not known, and no sigma covers it.
 * place  out; may be null.
 *
 * Returns INVCAL_OK; INVCAL_BAD_TEMPERATURE if it is not finite; INVCAL_BAD_NOMINAL,
 * INVCAL_NOT_ELLIPSOID if thermal is damaged.
 * Cost: 1,300 instructions. Call it again only after a relevant change of T: at 1 mg/K, 0.05 K are
 * 5e-5 of the field. Stack: about 250 bytes. */
invcal_status invcal_thermal_at(const invcal_thermal *thermal, invcal_real temperature,
                                invcal_calibration *out, invcal_thermal_place *place);

/* ---- the fit --------------------------------------------------------------------------------- */

/* Calibrates from position means and their temperatures.
 *
 * positions  with temperatures: at least nine positions for each coefficient, at different
 *            temperatures; twelve to eighteen at each are good, in any order.
 * degree     highest degree to fit: 0 (constants), 1 (slopes), 2 (parabolas); at most
 *            INVCAL_THERMAL_DEGREE of the library.
 * out        reference and span are the middle and half the range of the temperatures, at least
 *            1 K.
 * quality    sigma at the reference; elsewhere: invcal_thermal_judge. All other members are of
 *            the whole range.
 *
 * Slopes that the positions leave open are omitted, and out->fallback gives the reason: that is not
 * a failure. But without slopes over 5 K or more everything is weak, since they then pass for other
 * errors; unless degree is 0.
 *
 * Returns as invcal_calibrate_plain; INVCAL_BAD_TEMPERATURE if there are none, or one is not
 * finite; INVCAL_BAD_COUNT for the degree.
 * Cost: 350,000 instructions for 36 positions (degree 1). Stack: 1.3, 2.0, 3.0 KB for an
 * INVCAL_THERMAL_DEGREE of 0, 1, 2. */
invcal_status invcal_thermal_calibrate(const invcal_positions *positions, unsigned degree,
                                       invcal_thermal *out, invcal_quality *quality);

/* Standard deviations of X about the base, known beforehand: sigma[0] at the reference, sigma[1] of
 * its slopes (per K), sigma[2] of its curvature terms (per K^2). In float none should be below a
 * thousandth of the widest, times the span. */
typedef struct {
    invcal_real sigma[3][INVCAL_PARAMETERS]; /* 0: not known */
} invcal_thermal_prior;

/* The same with an earlier calibration, or with what is known beforehand.
 *
 * A base with slopes keeps them if the positions determine no others: a few positions at one
 * temperature, degree 0, renew offsets, scales and angles of a calibration that has aged. The range
 * of the base then stays, widened by the temperatures of the positions. Otherwise it is theirs.
 *
 * prior  null, or what is known; the noise must be stated then. With a prior on every slope even
 *        one temperature is enough. quality->noise weighs the prior: judge with that. Where sigma
 *        exceeds 0.7 of its prior, the prior determines that parameter more than the positions.
 * base   null: positions->nominal at all temperatures; or an earlier calibration, which replaces
 *        it; may equal out.
 *
 * Returns as invcal_thermal_calibrate; INVCAL_BAD_TEMPERATURE also for one more than two spans from
 * the reference, INVCAL_BAD_COUNT also for the degree of the base, INVCAL_BAD_NOISE for a prior
 * without it, INVCAL_BAD_PRIOR for one that is negative or not finite. */
invcal_status invcal_thermal_fit(const invcal_positions *positions,
                                 const invcal_thermal_prior *prior, const invcal_thermal *base,
                                 unsigned degree, invcal_thermal *out, invcal_quality *quality);

/* How good it is at a temperature: sigma, weak, verdict there, from the covariance of the
 * coefficients and the powers of t.
 *
 * positions, prior  those it was fitted with; prior may be null.
 * temperature       outside the range seen: at its edge, where the value is held.
 *
 * Returns as invcal_thermal_fit. */
invcal_status invcal_thermal_judge(const invcal_positions *positions,
                                   const invcal_thermal_prior *prior, const invcal_thermal *thermal,
                                   invcal_real temperature, invcal_quality *quality);

#ifdef __cplusplus
}
#endif

#endif
