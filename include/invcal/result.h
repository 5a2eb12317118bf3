/* SPDX-License-Identifier: MIT
 *
 * invcal/result.h: what a calibration and its quality say, for a display, a protocol or a decision.
 *
 *     for each bit k of quality.unchecked: invcal_systematic_text(k)       what was not checked
 *     invcal_accuracy(&quality, 0.0027f) <= 0.005f                         is 5 mg enough?
 *
 * invcal.h states the rules and units.
 */
#ifndef INVCAL_RESULT_H
#define INVCAL_RESULT_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The name of a parameter: "delta_x" ... "gamma_zy"; from 9 on of a gyroscope (gyro.h), "gyro_xx"
 * ... "gyro_zz". Outside 0 ... 17: "?". */
const char *invcal_parameter_text(unsigned parameter);

/* A phrase for a systematic error: "drift", "nonlinearity x^2", "nonlinearity x^3", "hysteresis";
 * "" for INVCAL_NO_SYSTEMATIC; any other value gives "unknown error". For quality.systematic, and
 * for each bit of quality.unchecked. */
const char *invcal_systematic_text(invcal_systematic systematic);

/* The factor k for which +- k sigma covers 95 %: Student's t for a sigma estimated with dof degrees
 * of freedom, 12.706 at 1 (and at 0), 1.960 for very many. Accurate to 0.002 (relative). */
invcal_real invcal_coverage(unsigned dof);

/* The accuracy of a calibrated length: the half-width of its 95 % interval, over field, root mean
 * square over all directions. The noise of the reading itself comes on top. Parameters that are
 * quality.held count with 1.96 sigma, since theirs is stated, all others by Student's t.
 *
 * gravity  standard deviation of the stated magnitude of the field, over field. 0.0027 for
 *          9.80665 m/s^2 anywhere on Earth, 0.00005 if computed from latitude and height; 0 if the
 *          field itself is the unit.
 *
 * Computed from sigma alone, as if scale errors were independent: within 10 % (mathematics.md,
 * "Accuracy"). */
invcal_real invcal_accuracy(const invcal_quality *quality, invcal_real gravity);

/* Is every sigma, widened for few degrees of freedom, within its target? Returns 1 or 0; 0 unless
 * the verdict is good.
 *
 * delta, dk, gamma  the targets: over field, 1, rad. */
int invcal_reaches(const invcal_quality *quality, invcal_real delta, invcal_real dk,
                   invcal_real gamma);

/* X = (delta, dk, gamma): the errors of the sensor against nominal. The sensor reads
 * u = (I + S) eta + delta, and A = (I + S)^-1 corrects it.
 *
 * calibration  as it was solved: neither turned (frame.h) nor in another unit (invcal_scale).
 * nominal      the one it was solved with.
 * x            delta over field, dk (1), gamma (rad): accurate to a few INVCAL_EPSILON.
 *
 * Checks nothing: a bad calibration gives NaN. Stack: about 190 bytes. */
void invcal_deviation(const invcal_calibration *calibration, const invcal_calibration *nominal,
                      invcal_real x[INVCAL_PARAMETERS]);

/* The standard deviation of the offset in raw counts: quality.sigma of delta through the inverse of
 * nominal. If the matrix of nominal is not diagonal, accurate to a few percent, since the three
 * deltas count as independent.
 *
 * sigma  of the three raw axes, counts.
 *
 * Stack: about 80 bytes. */
void invcal_sigma_offset(const invcal_quality *quality, const invcal_calibration *nominal,
                         invcal_real sigma[3]);

#ifdef __cplusplus
}
#endif

#endif
