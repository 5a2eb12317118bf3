/* SPDX-License-Identifier: MIT */
#include "solve.h"

#include <string.h>

#include "sums.h"
#include "invcal/expert.h"
#include "vector.h"

#define LONGEST INVCAL_REAL(10.0) /* semi-axis and centre, of nominal; the shortest is 1 / 10 */
enum { STEPS = 12 };              /* of Newton's iteration: semi-axes from 0.1 to 10 take ten */

/* c: its rows are the cross products of the other two rows of m, so that c / det m = m^-T. Returns
 * det m. */
static invcal_real cofactors(const invcal_real m[3][3], invcal_real c[3][3])
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

void invcal_inverse3(const invcal_real m[3][3], invcal_real inverse[3][3])
{
    invcal_real c[3][3];
    const invcal_real det = cofactors(m, c);

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            inverse[i][j] = c[j][i] / det;
        }
    }
}

/* A = U S with U orthonormal, which Newton's iteration U <- (U + U^-T) / 2 finds from A itself, and
 * S = U'A. */
void invcal_make_symmetric(invcal_real a[3][3])
{
    invcal_real u[3][3];
    invcal_real c[3][3];
    invcal_real change = 1;

    memcpy(u, a, sizeof u);
    for (unsigned step = 0; step < STEPS && change > INVCAL_EPSILON; step++) {
        const invcal_real det = cofactors((const invcal_real(*)[3])u, c);
        change = 0;
        for (unsigned i = 0; i < 3; i++) {
            for (unsigned j = 0; j < 3; j++) {
                const invcal_real half = (c[i][j] / det - u[i][j]) / 2;
                u[i][j] += half;
                change += half * half;
            }
        }
    }
    memcpy(c, a, sizeof c);
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            a[i][j] = u[0][i] * c[0][j] + u[1][i] * c[1][j] + u[2][i] * c[2][j];
        }
    }
}

/* A'A = Q / k, packed in f, to the upper triangular A. */
static invcal_status make_triangular(invcal_real f[6], invcal_real a[3][3])
{
    if (invcal_factor(f, 3, 3, INVCAL_EPSILON) != INVCAL_OK) {
        return INVCAL_NOT_ELLIPSOID;
    }
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < i; j++) {
            a[i][j] = 0;
            a[j][i] = *f++;
        }
        if (!(*f < LONGEST)) { /* 1 / L(i,i) */
            return INVCAL_NOT_ELLIPSOID;
        }
        a[i][i] = 1 / *f++;
    }
    return INVCAL_OK;
}

/* v = (p0 p1 p2), Q = I + [2p3 p6 p7; p6 2p4 p8; p7 p8 2p5],
 * delta = -Q^-1 v, k = 1 + delta Q delta = 1 - v delta, A'A = Q / k. */
invcal_status invcal_triad_of(const invcal_real p[INVCAL_PARAMETERS], invcal_triad *t)
{
    invcal_real f[6];
    invcal_real q[3][3];

    q[0][1] = q[1][0] = p[INVCAL_GAMMA_XY];
    q[0][2] = q[2][0] = p[INVCAL_GAMMA_XZ];
    q[1][2] = q[2][1] = p[INVCAL_GAMMA_ZY];
    for (unsigned i = 0; i < 3; i++) {
        q[i][i] = 1 + 2 * p[INVCAL_DK_X + i];
    }
    invcal_inverse3((const invcal_real(*)[3])q, t->a);
    for (unsigned i = 0; i < 3; i++) {
        t->delta[i] = -invcal_dot3(t->a[i], p);
    }
    const invcal_real k = 1 - invcal_dot3(p, t->delta);
    invcal_real most = invcal_dot3(t->delta, t->delta);
    invcal_real *packed = f;
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j <= i; j++) {
            *packed++ = q[i][j] / k;
        }
        most = packed[-1] <= most ? most : packed[-1]; /* a NaN stays */
    }
    if (!(most < LONGEST * LONGEST) || make_triangular(f, t->a) != INVCAL_OK) {
        return INVCAL_NOT_ELLIPSOID;
    }
    invcal_make_symmetric(t->a);
    return INVCAL_OK;
}

/* calibrated = A (u - delta), u = N (raw - zero): matrix = A N, offset = zero + N^-1 delta. */
void invcal_triad_join(const invcal_triad *t, const invcal_calibration *nominal,
                       invcal_calibration *out)
{
    invcal_real inverse[3][3];

    invcal_inverse3(nominal->matrix, inverse);
    for (unsigned i = 0; i < 3; i++) {
        out->offset[i] = nominal->offset[i] + invcal_dot3(inverse[i], t->delta);
    }
    const invcal_calibration n = *nominal; /* may be out */
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            out->matrix[i][j] = t->a[i][0] * n.matrix[0][j] + t->a[i][1] * n.matrix[1][j] +
                                t->a[i][2] * n.matrix[2][j];
        }
    }
}

invcal_status invcal_solve(invcal_sums *sums, const invcal_calibration *nominal,
                           invcal_calibration *out)
{
    invcal_triad triad;

    INVCAL_ASSERT(sums && nominal && out);
    if (sums->count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    invcal_sums_system(sums);
    invcal_status status =
        invcal_factor(sums->sum, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_FLOOR);
    if (status == INVCAL_OK) {
        invcal_back_substitute(sums->sum, INVCAL_PARAMETERS);
        status = invcal_triad_of(&sums->sum[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], &triad);
    }
    if (status == INVCAL_OK) {
        invcal_triad_join(&triad, nominal, out);
    }
    return status;
}
