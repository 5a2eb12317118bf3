/* SPDX-License-Identifier: MIT
 *
 * invcal/positions.h: from position means to a calibration, without a session.
 *
 *     invcal_positions positions = {0};     in C++ = {}
 *     positions.mean = mean;                invcal_vector mean[18]: {{16402, -35, 210}}, ...
 *     positions.count = 18;
 *     positions.nominal = &nominal;
 *     status = invcal_calibrate(&positions, &calibration, &quality);
 *
 * Every solver takes these positions, and looks for:
 *
 *     invcal_calibrate          outliers and systematic errors: what a session does
 *     invcal_calibrate_robust   outliers only, in half the flash
 *     invcal_calibrate_plain    neither: the smallest
 *     invcal_calibrate_faces    nothing: six faces, angles held
 *     invcal_calibrate_prior    parameters known beforehand
 *     invcal_thermal_calibrate  over temperature: thermal.h
 *
 * invcal.h states the rules and units.
 */
#ifndef INVCAL_POSITIONS_H
#define INVCAL_POSITIONS_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The data of a fit. Set all to zero first, then what you know: members will be added. */
typedef struct {
    const invcal_vector *mean; /* raw counts. In float a mean has 24 bits: subtract a constant from
                                  counts above 2^24 first */
    unsigned count;            /* of the means, up to 65534 */
    const invcal_calibration *nominal; /* data sheet, or an earlier calibration */
    invcal_real noise; /* standard deviation of a position mean on each axis, over field, below 1;
                          0: not known, estimated from the residuals alone */
    const invcal_real *temperature; /* thermal.h only: count numbers, the mean over each rest */
} invcal_positions;

/* The nominal calibration of a data sheet.
 *
 * zero    raw reading in no field, raw counts.
 * counts  raw counts per field (per g) of each axis; a negative one reverses the axis.
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOMINAL if a number is not finite, a count is outside 1e-10 ...
 * 1e10, or a zero exceeds 1e18 times the field. */
invcal_status invcal_nominal(const invcal_real zero[3], const invcal_real counts[3],
                             invcal_calibration *out);

/* Calibrates from position means. Leaves out positions that contradict the others; reports a
 * systematic error - drift, nonlinearity, hysteresis - with its axis and size
 * (mathematics_judgement.md). Directions within 5 degrees count once.
 *
 * positions  at least nine, up to INVCAL_MAX_POSITIONS; twelve to eighteen well spread ones are
 *            good. In the order of the visits, at equal intervals of time.
 * out        the calibration: the symmetric correction A, closest to the axes of nominal
 *            (mathematics.md, "From p to the calibration"); must not equal nominal.
 * quality    how good it is. Check its verdict before you use the calibration. About one in a
 *            hundred sets of 18 good positions is not called good.
 *
 * Returns INVCAL_OK;
 *   INVCAL_BAD_NOMINAL    see invcal_nominal; or singular to within rounding;
 *   INVCAL_BAD_NOISE, INVCAL_BAD_COUNT;
 *   INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE    for a reading: invcal_bad_reading says which;
 *   INVCAL_TOO_FEW        fewer than nine;
 *   INVCAL_UNDETERMINED   the positions leave parameters open, to the precision of the number type:
 *                         invcal_undetermined names them;
 *   INVCAL_NOT_ELLIPSOID  the readings lie on no ellipsoid, on
 *                         one that no triad has (a semi-axis below about 1/10 of nominal or of
 *                         another one, or a centre beyond ten times the field), or scatter by a
 *                         tenth of the field.
 * Cost: 160,000 instructions for 18 good positions. Stack: about 1,200 bytes. */
invcal_status invcal_calibrate(const invcal_positions *positions, invcal_calibration *out,
                               invcal_quality *quality);

/* The same without the search for systematic errors, all of which stay unchecked, and without
 * counting directions: the verdict is good if no remaining position contradicts the others. For a
 * device like an ATmega328P.
 *
 * out  may equal nominal.
 *
 * Cost: 110,000 instructions for 18 good positions. */
invcal_status invcal_calibrate_robust(const invcal_positions *positions, invcal_calibration *out,
                                      invcal_quality *quality);

/* The same, but leaves nothing out, and judges by the size of the residuals alone. Any number of
 * positions.
 *
 * Cost: 30,000 instructions for 18 positions. Stack: about 660 bytes. */
invcal_status invcal_calibrate_plain(const invcal_positions *positions, invcal_calibration *out,
                                     invcal_quality *quality);

#define INVCAL_CROSS_AXIS INVCAL_REAL(0.01) /* rad, for a data sheet's 1 % (0.57 degrees) */

/* The usual procedure: each axis once up and once down determines offsets and scales, but none of
 * the three angles. They are held at those of nominal, with the standard deviation of the data
 * sheet: 1 % of cross-axis sensitivity leaves 4.5 mg rms in a calibrated length (mathematics.md,
 * "Six faces"). Six more positions midway between two axes determine them: invcal_calibrate.
 *
 * positions  six or more; noise must be stated. With six nothing checks it.
 * gamma      standard deviation of each angle, rad, above 0, up to about 0.2: INVCAL_CROSS_AXIS.
 * quality    of offsets and scales: verdict and weak do not cover the angles. held: each angle that
 *            the positions leave open.
 *
 * Returns as invcal_calibrate_plain; INVCAL_TOO_FEW for fewer than six; INVCAL_UNDETERMINED if they
 * leave offsets or scales open; INVCAL_BAD_PRIOR unless gamma is above 0 and below 1.
 * Cost: 51,000 instructions for six positions. Stack: about 990 bytes. */
invcal_status invcal_calibrate_faces(const invcal_positions *positions, invcal_real gamma,
                                     invcal_calibration *out, invcal_quality *quality);

/* With what is known beforehand: parameter r is 0 with standard deviation prior[r], a Bayesian
 * update (mathematics.md, "Prior"). A parameter that the positions leave open keeps its nominal
 * value, with the sigma of the prior. For a device that can only be tilted, or to renew the offsets
 * of an earlier calibration with three positions.
 *
 * positions  at least one, and as many as there are parameters without a prior; noise must be
 *            stated: it weighs the prior. It is raised if the residuals show more; or, if the
 *            positions alone leave parameters open, to what the number type resolves next to the
 *            prior, in float sqrt(count) / 2000 of the widest.
 * prior      about nominal, over field, 1 or rad, up to about 0.2 (above that, p is no longer -X);
 *            0: not known. Not all may be 0.
 * quality    sigma never exceeds the prior. dof counts data only, rounded down. condition includes
 *            the rows of the prior; it may be infinite if their widths differ very much. held: each
 *            parameter that the prior determines more than the data.
 *
 * Returns as invcal_calibrate_plain; INVCAL_BAD_PRIOR if a number is negative or not finite, or all
 * are 0. INVCAL_UNDETERMINED refers to parameters without a prior.
 * Cost: 80,000 instructions for 18 positions. Stack: about 950 bytes. */
invcal_status invcal_calibrate_prior(const invcal_positions *positions,
                                     const invcal_real prior[INVCAL_PARAMETERS],
                                     invcal_calibration *out, invcal_quality *quality);

/* ---- causes of a refusal --------------------------------------------------------------------- */

/* Which parameters the positions leave open, after INVCAL_TOO_FEW or INVCAL_UNDETERMINED. A hint,
 * never a verdict: noise can make an open parameter look determined. Skips what is not a reading.
 *
 * Returns bit r for parameter r; 0: none. Cost: 12,000 instructions for 18 positions. Stack: about
 * 360 bytes. */
uint16_t invcal_undetermined(const invcal_positions *positions);

/* Which position is not a reading of this field, after INVCAL_NOT_FINITE or INVCAL_OUT_OF_RANGE.
 *
 * Returns the first one, from 0; count if all are readings. Stack: about 70 bytes. */
unsigned invcal_bad_reading(const invcal_positions *positions);

#ifdef __cplusplus
}
#endif

#endif
