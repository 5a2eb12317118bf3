/* SPDX-License-Identifier: MIT
 *
 * Plain calibration, and what its sigma means to a user (mathematics.md, "Uncertainty"): the half
 * width of a 95 % interval in sigma, and the accuracy of a calibrated length. The solution itself
 * is that of judge.c with no position left out.
 */
#include "invcal/expert.h"
#include "../core/vector.h"

invcal_status invcal_calibrate_plain(const invcal_real *raw, unsigned count,
                                     const invcal_calibration *nominal, invcal_real noise,
                                     invcal_calibration *out, invcal_quality *quality)
{
    return invcal_calibrate_without(raw, count, 0, nominal, noise, out, quality);
}

/* Cornish and Fisher's expansion of Student's quantile about the normal one, z = 1.96 (Abramowitz
 * and Stegun 26.7.5: the coefficients are its g1 ... g4 at z); it needs 3 degrees of freedom; 1 and
 * 2 have values of their own. */
invcal_real invcal_coverage(unsigned dof)
{
    if (dof < 2) {
        return INVCAL_REAL(12.7062);
    }
    if (dof < 3) {
        return INVCAL_REAL(4.30265);
    }
    const invcal_real n = (invcal_real)dof;
    return INVCAL_NORMAL +
           (INVCAL_REAL(2.372271) +
            (INVCAL_REAL(2.822498) + (INVCAL_REAL(2.555849) + INVCAL_REAL(1.589534) / n) / n) / n) /
               n;
}

/* The error of a length is h X. The mean squares of h over all directions: x 1/3, x^2 1/5, xy 1/15.
 * Covariances of dk are neglected. The sigma of gravity is stated, not estimated, so it has the
 * normal quantile. */
invcal_real invcal_accuracy(const invcal_quality *quality, invcal_real gravity)
{
    INVCAL_ASSERT(quality);
    const invcal_real *const delta = &quality->sigma[INVCAL_DELTA_X];
    const invcal_real *const dk = &quality->sigma[INVCAL_DK_X];
    const invcal_real *const gamma = &quality->sigma[INVCAL_GAMMA_XY];
    const invcal_real wide = invcal_coverage(quality->sigma_dof);
    const invcal_real square =
        invcal_dot3(delta, delta) / 3 + invcal_dot3(dk, dk) / 5 + invcal_dot3(gamma, gamma) / 15;

    return INVCAL_SQRT(wide * wide * square + INVCAL_NORMAL * INVCAL_NORMAL * gravity * gravity);
}
