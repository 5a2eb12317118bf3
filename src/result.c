/* SPDX-License-Identifier: MIT */
#include "invcal/expert.h"

#include "solve.h"
#include "vector.h"

/* a b */
static void multiply(const invcal_real a[3][3], const invcal_real b[3][3], invcal_real out[3][3])
{
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
}

/* matrix = A N, offset = zero + N^-1 delta: I + S = A^-1 = N matrix^-1. */
void invcal_deviation(const invcal_calibration *calibration, const invcal_calibration *nominal,
                      invcal_real x[INVCAL_PARAMETERS])
{
    invcal_real inverse[3][3];
    invcal_real p[3][3]; /* I + S */
    invcal_real shift[3];

    INVCAL_ASSERT(calibration && nominal && x);
    invcal_inverse3((const invcal_real(*)[3])calibration->matrix, inverse);
    multiply((const invcal_real(*)[3])nominal->matrix, (const invcal_real(*)[3])inverse, p);
    for (unsigned i = 0; i < 3; i++) {
        shift[i] = calibration->offset[i] - nominal->offset[i];
    }
    for (unsigned i = 0; i < 3; i++) {
        x[INVCAL_DELTA_X + i] = invcal_dot3(nominal->matrix[i], shift);
        x[INVCAL_DK_X + i] = p[i][i] - 1;
    }
    x[INVCAL_GAMMA_XY] = p[0][1] + p[1][0];
    x[INVCAL_GAMMA_XZ] = p[0][2] + p[2][0];
    x[INVCAL_GAMMA_ZY] = p[1][2] + p[2][1];
}

/* A'A = U'U with U upper triangular: A turned. */
void invcal_make_triangular(invcal_calibration *calibration, const invcal_calibration *nominal)
{
    invcal_real inverse[3][3];
    invcal_real a[3][3];
    invcal_real f[6];
    invcal_real *packed = f;

    INVCAL_ASSERT(calibration && nominal);
    invcal_inverse3((const invcal_real(*)[3])nominal->matrix, inverse);
    multiply((const invcal_real(*)[3])calibration->matrix, (const invcal_real(*)[3])inverse, a);
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j <= i; j++) {
            *packed++ = a[0][i] * a[0][j] + a[1][i] * a[1][j] + a[2][i] * a[2][j];
        }
    }
    if (invcal_triangular_root(f, a) == INVCAL_OK) {
        multiply((const invcal_real(*)[3])a, (const invcal_real(*)[3])nominal->matrix,
                 calibration->matrix);
    }
}

void invcal_sigma_offset(const invcal_quality *quality, const invcal_calibration *nominal,
                         invcal_real sigma[3])
{
    invcal_real inverse[3][3];

    INVCAL_ASSERT(quality && nominal && sigma);
    invcal_inverse3(nominal->matrix, inverse);
    for (unsigned i = 0; i < 3; i++) {
        invcal_real square = 0;
        for (unsigned j = 0; j < 3; j++) {
            const invcal_real x = inverse[i][j] * quality->sigma[INVCAL_DELTA_X + j];
            square += x * x;
        }
        sigma[i] = INVCAL_SQRT(square);
    }
}

/* Squared half widths of the intervals: a sigma that is small by luck does not win. */
static invcal_real squares(const invcal_quality *q)
{
    const invcal_real coverage = invcal_coverage(q->dof);

    return coverage * coverage * invcal_dot(q->sigma, q->sigma, INVCAL_PARAMETERS);
}

int invcal_improves(const invcal_quality *found, const invcal_quality *present)
{
    INVCAL_ASSERT(found && present);
    return found->verdict <= present->verdict && squares(found) < squares(present);
}
