/* SPDX-License-Identifier: MIT */
#include "solve.h"

#include <string.h>

#include "sums.h"
#include "invcal/expert.h"
#include "vector.h"

#define LONGEST INVCAL_REAL(10.0) /* semi-axis and centre, of nominal; the shortest is 1 / 10 */
enum { STEPS = 12 };              /* of Newton's iteration: semi-axes from 0.1 to 10 take ten */

invcal_real invcal_cofactors(const invcal_real m[3][3], invcal_real c[3][3])
{
    static const uint8_t next[4] = {1, 2, 0, 1};

    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real *a = m[next[i]];
        const invcal_real *b = m[next[i + 1]];
        INVCAL_UNROLL
        for (unsigned j = 0; j < 3; j++) {
            c[i][j] = a[next[j]] * b[next[j + 1]] - a[next[j + 1]] * b[next[j]];
        }
    }
    return invcal_dot3(m[0], c[0]);
}

/* L of L L' = A'A to the symmetric A. R = L' = U A with U orthonormal, which Newton's iteration
 * U <- (U + U^-T) / 2 finds from R itself. */
static void make_symmetric(const invcal_real l[6], invcal_real a[3][3])
{
    invcal_real u[3][3];
    invcal_real change = 1;

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            u[i][j] = i <= j ? l[INVCAL_PACKED(j, i)] : 0;
        }
    }
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
    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        INVCAL_UNROLL
        for (unsigned j = 0; j < 3; j++) {
            a[i][j] = 0;
            INVCAL_UNROLL
            for (unsigned k = 0; k <= j; k++) {
                a[i][j] += u[k][i] * l[INVCAL_PACKED(j, k)];
            }
        }
    }
}

/* Divides L by root, and puts its diagonal, which is reciprocal, right. 0 if that is absurd. */
static int scale_axes(invcal_real l[6], invcal_real root)
{
    for (unsigned r = 0; r < 3; r++) {
        for (unsigned c = 0; c < r; c++) {
            *l++ /= root;
        }
        *l = 1 / (*l * root);
        if (!(*l > 1 / LONGEST && *l < LONGEST)) {
            return 0;
        }
        l++;
    }
    return 1;
}

/* Centre and axes of an ellipsoid as a calibration of u:
 *
 *     v = (p0 p1 p2),  Q = I + [2p3 p6 p7; p6 2p4 p8; p7 p8 2p5]
 *     delta = -Q^-1 v,  k = 1 + delta Q delta = 1 + v Q^-1 v,  A'A = Q / k
 *
 * With v below Q and -1 behind it, one Cholesky gives all: Q = L L', A'A = L L' / k. Where zero
 * lies outside the ellipsoid, Q and k are negative, and -Q, -k do as well. */
invcal_status invcal_ellipsoid(const invcal_real p[INVCAL_PARAMETERS], invcal_calibration *out)
{
    static const uint8_t order[] = {INVCAL_DK_X,     INVCAL_GAMMA_XY, INVCAL_DK_Y,
                                    INVCAL_GAMMA_XZ, INVCAL_GAMMA_ZY, INVCAL_DK_Z,
                                    INVCAL_DELTA_X,  INVCAL_DELTA_Y,  INVCAL_DELTA_Z};
    const invcal_real sign = 1 + 2 * p[INVCAL_DK_X] < 0 ? (invcal_real)-1 : 1;
    invcal_real q[INVCAL_PACKED_SIZE(4)];
    invcal_real *delta = &q[INVCAL_PACKED(3, 0)];

    for (unsigned i = 0; i < sizeof order; i++) {
        const unsigned r = order[i];
        q[i] = sign * (r >= INVCAL_DK_X && r <= INVCAL_DK_Z ? 1 + 2 * p[r] : p[r]);
    }
    q[9] = -sign;
    if (invcal_factor(q, 3, 4, INVCAL_EPSILON) != INVCAL_OK || !(q[9] < 0)) {
        return INVCAL_NOT_ELLIPSOID;
    }
    invcal_back_substitute(q, 3);
    if (!scale_axes(q, INVCAL_SQRT(-q[9])) || !(invcal_dot3(delta, delta) < LONGEST * LONGEST)) {
        return INVCAL_NOT_ELLIPSOID;
    }
    make_symmetric(q, out->matrix);
    for (unsigned i = 0; i < 3; i++) {
        out->offset[i] = delta[i];
    }
    return INVCAL_OK;
}

/* A (u - delta) with u = N (raw - zero): matrix = A N, offset = zero + N^-1 delta. */
invcal_status invcal_behind(const invcal_calibration *nominal, invcal_calibration *c)
{
    const invcal_calibration a = *c;
    invcal_real cofactor[3][3];
    const invcal_real det = invcal_cofactors(nominal->matrix, cofactor);

    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        invcal_real moved = 0;
        INVCAL_UNROLL
        for (unsigned j = 0; j < 3; j++) {
            moved += cofactor[j][i] * a.offset[j];
            c->matrix[i][j] = 0;
            INVCAL_UNROLL
            for (unsigned k = 0; k < 3; k++) {
                c->matrix[i][j] += a.matrix[i][k] * nominal->matrix[k][j];
            }
        }
        c->offset[i] = nominal->offset[i] + moved / det;
    }
    return invcal_are_finite(c->offset) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

invcal_status invcal_solve(invcal_sums *sums, const invcal_calibration *nominal,
                           invcal_calibration *out)
{
    INVCAL_ASSERT(sums && nominal && out);
    if (sums->count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    invcal_sums_system(sums);
    invcal_status status =
        invcal_factor(sums->sum, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_FLOOR);
    if (status == INVCAL_OK) {
        invcal_back_substitute(sums->sum, INVCAL_PARAMETERS);
        status = invcal_ellipsoid(&sums->sum[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], out);
    }
    return status == INVCAL_OK ? invcal_behind(nominal, out) : status;
}
