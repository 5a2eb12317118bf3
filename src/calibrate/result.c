/* SPDX-License-Identifier: MIT
 *
 * Other forms of a calibration: parameters against nominal, the triangular frame, sigma in counts
 * (mathematics.md, "From p to the calibration"). All follow from the calibration and its nominal,
 * matrix = A N: the solution does not compute them, and only those that are called are linked.
 */
#include "invcal/background.h"
#include "../core/solve.h"
#include "../core/vector.h"

/* m n^-1 */
static void divide(const invcal_real m[3][3], const invcal_real n[3][3], invcal_real out[3][3])
{
    invcal_real cofactor[3][3];
    const invcal_real det = invcali_cofactors(n, cofactor);

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            out[i][j] = invcali_dot3(m[i], cofactor[j]) / det;
        }
    }
}

/* matrix = A N, offset = zero + N^-1 delta: I + S = A^-1 = N matrix^-1. */
void invcal_deviation(const invcal_calibration *calibration, const invcal_calibration *nominal,
                      invcal_real x[INVCAL_PARAMETERS])
{
    invcal_real shift[3];
    invcal_real p[3][3]; /* I + S */

    INVCAL_ASSERT(calibration && nominal && x);
    divide(nominal->matrix, calibration->matrix, p);
    for (unsigned i = 0; i < 3; i++) {
        shift[i] = calibration->offset[i] - nominal->offset[i];
    }
    for (unsigned i = 0; i < 3; i++) {
        x[INVCAL_DELTA_X + i] = invcali_dot3(nominal->matrix[i], shift);
        x[INVCAL_DK_X + i] = p[i][i] - 1;
    }
    x[INVCAL_GAMMA_XY] = p[0][1] + p[1][0];
    x[INVCAL_GAMMA_XZ] = p[0][2] + p[2][0];
    x[INVCAL_GAMMA_ZY] = p[1][2] + p[2][1];
}

/* A'A = L L', so L' is A up to a rotation. */
void invcali_make_triangular(invcal_calibration *calibration, const invcal_calibration *nominal)
{
    invcal_real a[3][3];
    invcal_real l[INVCAL_PACKED_SIZE(3)];

    INVCAL_ASSERT(calibration && nominal);
    divide((const invcal_real(*)[3])calibration->matrix, nominal->matrix, a);
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j <= i; j++) {
            l[INVCAL_PACKED(i, j)] = a[0][i] * a[0][j] + a[1][i] * a[1][j] + a[2][i] * a[2][j];
        }
    }
    if (invcali_factor(l, 3, 3, 0) != INVCAL_OK) {
        return; /* not a calibration */
    }
    for (unsigned j = 0; j < 3; j++) {
        const invcal_real x = nominal->matrix[0][j];
        const invcal_real y = nominal->matrix[1][j];
        const invcal_real z = nominal->matrix[2][j];
        calibration->matrix[0][j] = x / l[0] + y * l[1] + z * l[3];
        calibration->matrix[1][j] = y / l[2] + z * l[4];
        calibration->matrix[2][j] = z / l[5];
    }
}

void invcal_sigma_offset(const invcal_quality *quality, const invcal_calibration *nominal,
                         invcal_real sigma[3])
{
    invcal_real cofactor[3][3];

    INVCAL_ASSERT(quality && nominal && sigma);
    const invcal_real det = invcali_cofactors(nominal->matrix, cofactor);
    for (unsigned i = 0; i < 3; i++) {
        invcal_real square = 0;
        for (unsigned j = 0; j < 3; j++) {
            const invcal_real x = cofactor[j][i] / det * quality->sigma[INVCAL_DELTA_X + j];
            square += x * x;
        }
        sigma[i] = INVCAL_SQRT(square);
    }
}

/* Squared half widths of the intervals: a sigma that is small by luck does not win. */
static invcal_real squares(const invcal_quality *q)
{
    const invcal_real coverage = invcal_coverage(q->sigma_dof);

    return coverage * coverage * invcali_dot(q->sigma, q->sigma, INVCAL_PARAMETERS);
}

int invcal_improves(const invcal_quality *found, const invcal_quality *present)
{
    INVCAL_ASSERT(found && present);
    return found->verdict <= present->verdict && squares(found) < squares(present);
}
