/* SPDX-License-Identifier: MIT */
#include "solve.h"

#include <string.h>

#include "sums.h"
#include "invcal/expert.h"
#include "vector.h"

/* Of ten: a semi-axis is at least 1/10 of nominal, and of another one; the centre is at most at 10. */
#define SQUARE INVCAL_REAL(100.0)
enum { STEPS = 12 }; /* of Newton's iteration: semi-axes from 0.1 to 10 take ten */

invcal_real invcal_cofactors(const invcal_real m[3][3], invcal_real c[3][3])
{
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real *a = m[i == 2 ? 0 : i + 1];
        const invcal_real *b = m[i == 0 ? 2 : i - 1];
        c[i][0] = a[1] * b[2] - a[2] * b[1];
        c[i][1] = a[2] * b[0] - a[0] * b[2];
        c[i][2] = a[0] * b[1] - a[1] * b[0];
    }
    return invcal_dot3(m[0], c[0]);
}

/* Upper triangular R, packed by columns, to the symmetric A with A'A = R'R: R = U A with U
 * orthonormal, which Newton's iteration U <- (U + U^-T) / 2 finds from R itself. */
static void make_symmetric(const invcal_real r[6], invcal_real a[3][3])
{
    invcal_real u[3][3] = {{r[0], r[1], r[3]}, {0, r[2], r[4]}, {0, 0, r[5]}};
    invcal_real change = 1;

    for (unsigned step = 0; step < STEPS && change > INVCAL_EPSILON; step++) {
        const invcal_real det = invcal_cofactors((const invcal_real(*)[3])u, a);
        change = 0;
        for (unsigned i = 0; i < 3; i++) {
            for (unsigned j = 0; j < 3; j++) {
                const invcal_real half = (a[i][j] / det - u[i][j]) / 2;
                u[i][j] += half;
                change += half * half;
            }
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        a[i][0] = u[0][i] * r[0];
        a[i][1] = u[0][i] * r[1] + u[1][i] * r[2];
        a[i][2] = u[0][i] * r[3] + u[1][i] * r[4] + u[2][i] * r[5];
    }
}

/* Centre and axes of an ellipsoid as a calibration of u:
 *
 *     v = (p0 p1 p2),  Q = I + [2p3 p6 p7; p6 2p4 p8; p7 p8 2p5]
 *     delta = -Q^-1 v,  k = 1 + delta Q delta = 1 + v Q^-1 v,  A'A = Q / k
 *
 * With v below Q and -1 behind it, one Cholesky gives all: Q = L L', R = L' / sqrt(k). Where zero
 * lies outside the ellipsoid, Q and k are negative, and -Q, -k do as well. */
invcal_status invcal_ellipsoid(const invcal_real p[INVCAL_PARAMETERS], invcal_calibration *out)
{
    invcal_real q[INVCAL_PACKED_SIZE(4)] = {1 + 2 * p[INVCAL_DK_X], p[INVCAL_GAMMA_XY],
                                            1 + 2 * p[INVCAL_DK_Y], p[INVCAL_GAMMA_XZ],
                                            p[INVCAL_GAMMA_ZY],     1 + 2 * p[INVCAL_DK_Z],
                                            p[INVCAL_DELTA_X],      p[INVCAL_DELTA_Y],
                                            p[INVCAL_DELTA_Z],      -1};
    invcal_real *delta = &q[INVCAL_PACKED(3, 0)];

    if (q[0] < 0) {
        for (unsigned i = 0; i < sizeof q / sizeof q[0]; i++) {
            q[i] = -q[i];
        }
    }
    if (invcal_factor(q, 3, 4, 1 / SQUARE) != INVCAL_OK || !(q[9] < 0)) {
        return INVCAL_NOT_ELLIPSOID;
    }
    const invcal_real root = INVCAL_SQRT(-q[9]);
    invcal_back_substitute(q, 3);
    for (unsigned i = 0; i < 3; i++) {
        q[INVCAL_PACKED(i, i)] = 1 / q[INVCAL_PACKED(i, i)];
    }
    for (unsigned i = 0; i < INVCAL_PACKED_SIZE(3); i++) {
        q[i] /= root;
    }
    /* the squares of all elements are those of the semi-axes of A, added up */
    if (!(invcal_dot(q, q, INVCAL_PACKED_SIZE(3)) < SQUARE &&
          invcal_dot(delta, delta, 3) < SQUARE)) {
        return INVCAL_NOT_ELLIPSOID;
    }
    make_symmetric(q, out->matrix);
    memcpy(out->offset, delta, sizeof out->offset);
    return INVCAL_OK;
}

/* A (u - delta) with u = N (raw - zero): matrix = A N, offset = zero + N^-1 delta. */
invcal_status invcal_behind(const invcal_calibration *nominal, invcal_calibration *c)
{
    invcal_real cofactor[3][3];
    invcal_real delta[3];
    const invcal_real det = invcal_cofactors(nominal->matrix, cofactor);

    memcpy(delta, c->offset, sizeof delta);
    for (unsigned i = 0; i < 3; i++) {
        invcal_real row[3];
        memcpy(row, c->matrix[i], sizeof row);
        invcal_real sum = 0;
        for (unsigned j = 0; j < 3; j++) {
            sum += cofactor[j][i] * delta[j];
            c->matrix[i][j] = row[0] * nominal->matrix[0][j] + row[1] * nominal->matrix[1][j] +
                              row[2] * nominal->matrix[2][j];
        }
        c->offset[i] = nominal->offset[i] + sum / det;
    }
    return invcal_are_finite(c->offset) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

invcal_status invcal_solve(invcal_sums *sums, const invcal_calibration *nominal,
                           invcal_calibration *out)
{
    invcal_calibration c;

    INVCAL_ASSERT(sums && nominal && out);
    if (sums->count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    invcal_sums_system(sums);
    invcal_status status =
        invcal_factor(sums->sum, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_FLOOR);
    if (status == INVCAL_OK) {
        invcal_back_substitute(sums->sum, INVCAL_PARAMETERS);
        status = invcal_ellipsoid(&sums->sum[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], &c);
    }
    if (status == INVCAL_OK) {
        status = invcal_behind(nominal, &c);
    }
    if (status == INVCAL_OK) {
        *out = c; /* which may be nominal */
    }
    return status;
}
