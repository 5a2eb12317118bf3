/* SPDX-License-Identifier: MIT
 *
 * invcal/thermal.h: a calibration for every temperature.
 *
 * Offsets, scales and angles are polynomials of temperature of the degree INVCAL_THERMAL_DEGREE
 * (config.h), here on a reference temperature and a span, so that t stays within about -1 ... 1:
 *
 *     t = (T - reference) / span,   X(T) = x0 + x1 t + x2 t^2,   X = (delta, dk, gamma)
 *
 * Positions of all temperatures together give all coefficients: the row h(u) of the exact equation
 * becomes h(u) (x) (1 t t^2), the unknowns 18 or 27, and one Cholesky solves for them. H'H
 * consists of 9x9 blocks, of which (a, b) is the sum of t^(a+b) h h': so the sums are those of
 * normal.h, 2 degree + 1 times, and grow neither with positions nor with temperatures. At every
 * temperature the same closed form (solution.h) makes the calibration, exact for errors of any
 * size.
 *
 * Why there is no iterative refinement, as in the paper's ref. 12: the widened rows are linear in
 * the coefficients and exact at every temperature. One solve has the minimum over all of them, and
 * there is nothing that would have to converge.
 *
 * What that leaves, and why invcal_thermal_calibrate solves twice: twice by count, not until
 * something converges. Linear in the equation are the coefficients p of the ellipsoid, and where
 * X is linear in temperature, as in sensors it nearly is, p is not: they differ by the square of
 * slope times span. One solve of degree 1 leaves 1.3e-3 of the field (rms over -20 ... 70 C, every
 * slope at 1 mg/K and 500 ppm/K), many times the noise; a degree of 2 for p would pay for nine
 * unknowns that the sensor does not have. So X is taken from the first solve at the ends of the
 * range, by the closed form, as a polynomial of its own, and the second solve is for what is left
 * between it and the readings. That is small, and its square is nothing: 9e-7 remain, a hundredth
 * of a noise of 1e-4. Only a prior asks for one solve more: it has to be weighed with the noise
 * that the residuals tell.
 *
 * How good it is (tests; 18 positions at each of -20, 25, 70 C, noise 1e-4 of the field, slopes up
 * to 1 mg/K, 500 ppm/K, 100 urad/K). Degree 1: the error over the range and all directions is 0.99
 * to 1.01 of the Cramer-Rao bound of the 18 parameters, 5e-5 of the field. Nine parameters for the
 * same positions: 300 to 550 times that, 2 to 3 % of the field. Degree 2 for a sensor that is bent:
 * 0.99 to 1.01 of the bound of 27 parameters, which is 1.26 times that of 18: do not ask for it
 * without need. What is not a polynomial of this degree stays in the residuals, and so in the
 * noise and every sigma.
 *
 * In float, 18 and 27 unknowns lose 5e-8 of the field, no more than nine: as t is scaled, and
 * slopes that only a small part of the span tells are left out (INVCAL_THERMAL_OPEN) before
 * rounding would make them.
 *
 * Temperatures are in K or degrees C, from the sensor's own thermometer if it has one. It need not
 * be right, but must tell the same each time.
 */
#ifndef INVCAL_THERMAL_H
#define INVCAL_THERMAL_H

#include "invcal/calibrate.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_THERMAL_ROWS (INVCAL_THERMAL_DEGREE + 1)     /* coefficients of a parameter */
#define INVCAL_THERMAL_SUMS (2 * INVCAL_THERMAL_DEGREE + 1) /* powers of t in H'H */

/* What the user knows of temperature. All zero is a good start. */
typedef struct {
    invcal_real reference; /* t = 0; not used while span is 0 */
    invcal_real span;      /* t = 1 at reference + span, K: half the range of use. 0, with
                              invcal_thermal_calibrate only: reference and span are the middle and
                              half the range of the temperatures given, at least 1 K */
    /* What is known beforehand of the slopes of delta (1/K: field over field), dk (1/K) and gamma
     * (rad/K), and of what bends them (the same per K^2): standard deviations about none; 0:
     * nothing is known. Needs the noise stated. With a prior on every slope even one temperature
     * is enough: what the positions leave open stays at none, within its prior. In float none
     * should be below a thousandth of the widest, times the span. */
    invcal_real slope[INVCAL_PARAMETERS];
    invcal_real curvature[INVCAL_PARAMETERS]; /* for degree 2 */
    uint8_t less; /* so much below INVCAL_THERMAL_DEGREE is the highest degree that is wanted */
} invcal_thermal_settings;

/* Why the degree is lower than was wanted: what stood against one more. */
typedef enum {
    INVCAL_THERMAL_AS_ASKED, /* it is not */
    INVCAL_THERMAL_FEW,      /* fewer positions than coefficients without a prior: 9 (degree + 1) */
    INVCAL_THERMAL_NARROW,   /* temperatures of less than 5 K for each degree, and no prior: a
                                thermometer on a chip is some 0.5 K off what it should tell (steps,
                                lag, heat of its own), and over less a tenth of a slope would be
                                its error */
    INVCAL_THERMAL_OPEN      /* the positions do not tell the slopes: some coefficient's sqrt(K)
                                exceeds 10, the limit of a weak parameter (quality.h). So it is
                                when temperatures fill less than 8 % of the span, when there are
                                but two for a parabola, or not enough orientations at one of two */
} invcal_thermal_fallback;

/* A phrase for it, in plain English, in read-only memory. Any other value: "unknown reason". */
const char *invcal_thermal_fallback_text(invcal_thermal_fallback fallback);

/* A calibration for every temperature: 108, 144, 180 bytes for degree 0, 1, 2 (float, Cortex-M). */
typedef struct {
    /* delta, dk, gamma: the coefficients of t^k, k = 0 ... INVCAL_THERMAL_DEGREE */
    invcal_real x[INVCAL_THERMAL_ROWS][INVCAL_PARAMETERS];
    invcal_calibration nominal;  /* of the settings */
    invcal_real field;           /* likewise */
    invcal_real reference, span; /* t = (T - reference) / span */
    invcal_real least, greatest; /* temperatures seen: only between them the polynomials hold */
    invcal_frame frame;          /* of the settings */
    invcal_thermal_fallback fallback; /* why `fitted` is less than was wanted */
    uint8_t degree;                   /* of x */
    uint8_t fitted; /* degree that the positions told; less than `degree` only where slopes came
                       from the calibration that was renewed (invcal_thermal_solve) */
} invcal_thermal_calibration;

/* Calibrates from position means and their temperatures: rows, two solutions, residuals,
 * judgement.
 *
 * raw          3 count numbers, as invcal_calibrate. Nine positions for each coefficient are the
 *              least, at different temperatures; twelve to eighteen at each temperature are good,
 *              the same or others. Order does not matter.
 * temperature  count numbers: the mean over each rest, see invcal_thermal_drift_limit.
 * settings     see invcal_settings; its prior is that of X at the reference.
 * quality      of the calibration at the reference (or the end of the range next to it); verdict,
 *              undetermined and from_prior hold for all the range. Sigma elsewhere:
 *              invcal_thermal_assess. The noise and residuals are those over all temperatures.
 * reason       null, or what was wrong; written on failure only.
 *
 * Slopes that the positions do not tell are left out, and out->fallback says so: a lower degree is
 * no failure. But with no slopes at all over 5 K or more the verdict is weak and undetermined
 * names everything: slopes then pass for errors of other kinds, which residuals need not show.
 *
 * Returns as invcal_calibrate; INVCAL_NOT_FINITE (with the position) for a temperature that is
 * none; INVCAL_BAD_SETTING also for a temperature more than two spans from the reference.
 * Cost: three passes over the positions, two solutions, three judgements: 508,000 instructions for
 * 54 positions (degree 1, Cortex-M4F); half as much again with a prior. Stack: 3.6 KB for degree 1, 4.9 KB for degree 2. */
invcal_status invcal_thermal_calibrate(const invcal_real *raw, const invcal_real *temperature,
                                       unsigned count, const invcal_settings *settings,
                                       const invcal_thermal_settings *thermal,
                                       invcal_thermal_calibration *out, invcal_quality *quality,
                                       invcal_reason *reason);

/* Where a temperature lies. */
typedef enum {
    INVCAL_THERMAL_WITHIN, /* in the range seen */
    INVCAL_THERMAL_BELOW,  /* colder: what holds at `least` is given */
    INVCAL_THERMAL_ABOVE   /* warmer: what holds at `greatest` is given */
} invcal_thermal_place;

/* The calibration at a temperature, for invcal_apply, by the exact closed form.
 *
 * Outside the range seen the polynomial tells nothing. There the value at its edge is held, and
 * place says so: what the sensor does beyond is not known, and no sigma covers it.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE for a temperature that is NaN or infinite;
 * INVCAL_BAD_SETTING, INVCAL_NOT_ELLIPSOID if the calibration has been damaged.
 * Cost: 25 calls of invcal_apply (1,070 instructions, Cortex-M4F). Temperatures change slowly:
 * make it anew when T has moved by what matters, 0.05 K are 5e-5 of the field at 1 mg/K, and apply
 * it to all samples in between. Stack: about 450 bytes. */
invcal_status invcal_thermal_at(const invcal_thermal_calibration *calibration,
                                invcal_real temperature, invcal_solution *solution,
                                invcal_thermal_place *place);

/* How far temperature may drift in one rest that is to be a position, K from least to greatest.
 *
 * X is nearly linear over a rest: the mean reading belongs to the mean temperature, and drift by
 * itself does no harm. But a thermometer that lags behind the sensor may be wrong by half of it.
 * The limit is where that makes as much as the noise of one position:
 *
 *     limit = 2 noise / slope
 *
 * with the noise stated, or 1e-4 of the field, and the largest slope of the prior, or 1 mg/K:
 * 0.2 K unless something else is known. 0, no drift at all, where that is no number: for a field
 * that is not positive, or noise without end. Fail closed: take a rest if drift <= limit, and else
 * wait for the sensor to settle. */
invcal_real invcal_thermal_drift_limit(const invcal_settings *settings,
                                       const invcal_thermal_settings *thermal);

/* ---- position by position -------------------------------------------------------------------
 *
 * What invcal_thermal_calibrate is made of, for positions that come and go, that are not kept, or
 * that renew an earlier calibration:
 *
 *     start with the nominal, or have an earlier calibration: the base
 *     add every position
 *     solve: the base, corrected
 *
 * X against the base is what is solved for, and one solve is enough if that is small: a tenth of
 * the slopes above leave a hundredth of the error above, 1e-5. With the positions at hand add them
 * again, on what has been solved for, and solve again; the same sums are the residuals of what
 * they were made with, and invcal_thermal_assess judges by them. */

/* A base that knows nothing but the nominal calibration: X = 0 at all temperatures.
 *
 * thermal  a span > 0 is needed: that of use.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING for unusable settings (invcal_settings_check), a prior
 * that is negative, not finite, or there without the noise, a degree below 0, or no reference or
 * span. */
invcal_status invcal_thermal_start(const invcal_settings *settings,
                                   const invcal_thermal_settings *thermal,
                                   invcal_thermal_calibration *out);

/* The rows of readings that were calibrated with a base, each times the powers of its t.
 * 192, 536, 880 bytes for degree 0, 1, 2. */
typedef struct {
    invcal_normal sum[INVCAL_THERMAL_SUMS]; /* of t^k; the first counts */
    invcal_real squares;                    /* residuals of the base, as in residual.h */
    invcal_real max;                        /* the largest of them, without its sign */
    unsigned worst;                         /* the position of that, from 0 */
    invcal_real least, greatest;            /* temperatures */
} invcal_thermal_sums;

/* Empties the sums. All bytes zero is the same state. */
void invcal_thermal_init(invcal_thermal_sums *sums);

/* Adds one position.
 *
 * base  the same for all of them.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE for the reading or the temperature; INVCAL_OUT_OF_RANGE if
 * the calibrated reading is outside 0.1 ... 10 of the field; INVCAL_BAD_SETTING for a temperature
 * more than two spans from the reference.
 * Cost: six times that of a row in normal.h for degree 1. Stack: about 690 bytes. */
invcal_status invcal_thermal_add(invcal_thermal_sums *sums, const invcal_thermal_calibration *base,
                                 const invcal_real raw[3], invcal_real temperature);

/* Takes out a position that was added before with the same base. What is left equals the sums
 * without it to rounding; but the temperatures seen do not shrink, and the largest residual stays
 * that of all which were there. Without the last one the sums are empty again.
 * Returns as invcal_thermal_add, and INVCAL_TOO_FEW if the sums are empty. */
invcal_status invcal_thermal_remove(invcal_thermal_sums *sums,
                                    const invcal_thermal_calibration *base,
                                    const invcal_real raw[3], invcal_real temperature);

/* Solves for what the positions have against the base, and corrects it.
 *
 * sums      made with base. Not changed.
 * settings  noise and prior; nominal, field and frame are those of the base. What is known
 *           beforehand is known of the deviation from the base.
 * thermal   slopes and curvatures of the prior; reference and span are those of the base.
 * out       may be the base. Its range is that of the sums. A base with slopes keeps them where
 *           the positions tell no others: at one temperature an offset is renewed, and the
 *           slopes stay.
 *
 * Returns INVCAL_OK, whatever the degree; INVCAL_BAD_SETTING, INVCAL_TOO_FEW,
 * INVCAL_UNDETERMINED, INVCAL_NOT_ELLIPSOID as invcal_solve.
 * Cost: (9 (degree + 1))^3 / 3 multiply-adds. Stack: 1.7 KB for degree 1, 2.6 KB for degree 2. */
invcal_status invcal_thermal_solve(const invcal_thermal_sums *sums,
                                   const invcal_thermal_calibration *base,
                                   const invcal_settings *settings,
                                   const invcal_thermal_settings *thermal,
                                   invcal_thermal_calibration *out);

/* Judges a calibration at a temperature: sigma of everything there, condition, verdict
 * (quality.h). The covariance of the coefficients goes through the powers of t and the Jacobian at
 * that temperature; dof counts the coefficients. Weak, all parameters, where slopes are wanting
 * (invcal_thermal_calibrate).
 *
 * sums         of all its positions, made with this calibration as the base.
 * temperature  outside the range seen: sigma at its edge, where the value is held.
 *
 * Returns as invcal_assess, and INVCAL_NOT_FINITE for the temperature.
 * Stack: 2.0 KB for degree 1, 2.9 KB for degree 2. */
invcal_status invcal_thermal_assess(const invcal_thermal_sums *sums,
                                    const invcal_thermal_calibration *calibration,
                                    const invcal_settings *settings,
                                    const invcal_thermal_settings *thermal, invcal_real temperature,
                                    invcal_quality *quality);

#ifdef __cplusplus
}
#endif

#endif
