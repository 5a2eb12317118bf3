/* SPDX-License-Identifier: MIT
 *
 * Plain calibration, and what its sigma means to a user (mathematics.md, "Uncertainty"): the half
 * width of a 95 % interval in sigma, and the accuracy of a calibrated length. The solution itself
 * is that of judge.c with no position left out.
 */
#include "invcal/result.h"
#include "judge.h"
#include "../core/vector.h"

invcal_status invcal_calibrate_plain(const invcal_positions *positions, invcal_calibration *out,
                                     invcal_quality *quality)
{
    INVCAL_ASSERT(INVCAL_ARE_GIVEN(positions) && out && quality);
    const invcali_selection all = {*positions, 0};

    return invcali_positions_calibrate(&all, out, quality);
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
 * Covariances of dk are neglected. What is stated, not estimated, has the normal quantile. */
invcal_real invcal_accuracy(const invcal_quality *quality, invcal_real gravity)
{
    INVCAL_ASSERT(quality);
    static const invcal_real share[3] = {INVCAL_REAL(1.0) / 3, INVCAL_REAL(0.2),
                                         INVCAL_REAL(1.0) / 15};
    const invcal_real wide = invcal_coverage(quality->sigma_dof);
    invcal_real measured = 0;
    invcal_real stated = gravity * gravity;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real square = share[r / 3] * quality->sigma[r] * quality->sigma[r];
        if ((unsigned)quality->held >> r & 1u) {
            stated += square;
        } else {
            measured += square;
        }
    }
    return INVCAL_SQRT(wide * wide * measured + INVCAL_NORMAL * INVCAL_NORMAL * stated);
}

/* With few degrees of freedom a sigma counts for more: its 95 % interval over 1.96. */
int invcal_reaches(const invcal_quality *quality, invcal_real delta, invcal_real dk,
                   invcal_real gamma)
{
    const invcal_real target[3] = {delta, dk, gamma};

    INVCAL_ASSERT(quality);
    if (quality->verdict != INVCAL_GOOD) {
        return 0;
    }
    const invcal_real wider = invcal_coverage(quality->sigma_dof) / INVCAL_NORMAL;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (!(quality->sigma[r] * wider <= target[r / 3])) {
            return 0;
        }
    }
    return 1;
}
