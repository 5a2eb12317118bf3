/* SPDX-License-Identifier: MIT
 *
 * From p to the calibration in closed form (mathematics.md, "From p to the calibration"), from
 * X = (delta, dk, gamma) to the same, and the 3x3 algebra that other modules share.
 *
 * invcali_ellipsoid and invcali_triad accept only the semi-axes and the centre of a triad. So
 * Newton's iteration for the frame ends within a known number of steps, and no caller has to check
 * again.
 */
#include "solve.h"

#include <string.h>

#include "sums.h"
#include "vector.h"

/* Of ten: no semi-axis is shorter than 1/10 of nominal, or of another one; the centre is within
 * 10. */
#define LONGEST INVCAL_REAL(10.0)
#define SQUARE INVCAL_REAL(100.0)
enum { STEPS = 12 }; /* of Newton's iteration: semi-axes from 0.1 to 10 take ten */

#if !INVCAL_FAST
INVCAL_NOINLINE void invcali_cross(const invcal_real *a, const invcal_real *b,
                                   invcal_real *restrict out)
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}
#endif

invcal_real invcali_cofactors(const invcal_real m[3][3], invcal_real c[3][3])
{
    const invcal_real *a = m[1];
    const invcal_real *b = m[2];

    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        invcali_cross(a, b, c[i]);
        a = b;
        b = m[i];
    }
    return invcali_dot3(m[0], c[0]);
}

void invcali_inverse3(const invcal_real m[3][3], invcal_real inverse[3][3])
{
    invcal_real c[3][3];
    const invcal_real det = invcali_cofactors(m, c);

    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        INVCAL_ROLL
        for (unsigned j = 0; j < 3; j++) {
            inverse[i][j] = c[j][i] / det;
        }
    }
}

/* v = m v if step is 1, m' v if it is 3: the way from an element to the next of the same row. */
static INVCAL_NOINLINE void multiply(const invcal_real *m, unsigned step, invcal_real v[3])
{
    const invcal_real x = v[0];
    const invcal_real y = v[1];
    const invcal_real z = v[2];

    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        v[i] = m[0] * x + m[step] * y + m[2 * (size_t)step] * z;
        m += 4 - step;
    }
}

/* a = S U' with U orthonormal, which Newton's iteration U <- (U + U^-T) / 2 finds from a itself,
 * and S = a U, row by row. A singular value s becomes (s + 1/s) / 2, at least 1, and then each step
 * more than halves its distance from 1, and near 1 squares it. So from the second step on det shows
 * the distance: once it is below the root of epsilon, that step was the last. */
void invcali_make_symmetric(invcal_real a[3][3], invcal_real work[INVCAL_WORK])
{
    invcal_real *const u = work;     /* U' */
    invcal_real *const c = work + 9; /* its cofactors */
    const invcal_real *from = a[0];
    invcal_real det;
    unsigned step = 0;

    do { /* at most STEPS times */
        det = invcali_cofactors((const invcal_real(*)[3])from, (invcal_real(*)[3])c);
        INVCAL_ROLL
        for (unsigned i = 0; i < 9; i++) {
            u[i] = (c[i] / det + from[i]) / 2;
        }
        from = u;
        step++;
    } while (step < 2 || (step < STEPS && INVCAL_FABS(det) > 1 + INVCAL_SQRT(INVCAL_EPSILON)));
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        multiply(u, 1, a[i]);
    }
}

/* L / root. The diagonal of L is stored as reciprocals. */
static INVCAL_ONCE void make_triangular(const invcal_real *l, invcal_real root, invcal_real a[3][3])
{
    INVCAL_ROLL
    for (unsigned r = 0; r < 3; r++) {
        INVCAL_ROLL
        for (unsigned c = 0; c < 3; c++) {
            invcal_real x = c > r ? 0 : *l++;
            if (c == r) {
                x = 1 / x;
            }
            a[r][c] = x / root;
        }
    }
}

/* Centre and axes of an ellipsoid as a calibration of u:
 *
 *     v = (p0 p1 p2),  Q = I + [2p3 p6 p7; p6 2p4 p8; p7 p8 2p5]
 *     delta = -Q^-1 v,  k = 1 + delta Q delta = 1 + v Q^-1 v,  A A = Q / k
 *
 * With v below Q and then -1, one Cholesky gives all: Q = L L', A A = L L' / k. If zero lies
 * outside the ellipsoid, Q and k are negative, and -Q, -k serve as well. A is then made symmetric:
 * that root turns the axes least. */
invcal_status invcali_ellipsoid(const invcal_real p[INVCAL_PARAMETERS],
                                invcal_real work[INVCAL_WORK], invcal_calibration *out)
{
    static const uint8_t order[] = {INVCAL_DK_X,     INVCAL_GAMMA_XY, INVCAL_DK_Y,
                                    INVCAL_GAMMA_XZ, INVCAL_GAMMA_ZY, INVCAL_DK_Z,
                                    INVCAL_DELTA_X,  INVCAL_DELTA_Y,  INVCAL_DELTA_Z};
    const invcal_real sign = p[INVCAL_DK_X] < INVCAL_REAL(-0.5) ? (invcal_real)-1 : 1;
    invcal_real *q = work;

    INVCAL_ROLL
    for (unsigned i = 0; i < sizeof order; i++) {
        const unsigned r = order[i];
        q[i] = sign * (r >= INVCAL_DK_X && r <= INVCAL_DK_Z ? 1 + 2 * p[r] : p[r]);
    }
    q[9] = -sign;
    if (invcali_factor(q, 3, 4, 1 / SQUARE) != INVCAL_OK) {
        return INVCAL_NOT_ELLIPSOID;
    }
    invcali_back_substitute(q, 3);
    make_triangular(q, INVCAL_SQRT(-q[9]), out->matrix);
    memcpy(out->offset, &q[INVCAL_PACKED(3, 0)], sizeof out->offset);
    invcali_make_symmetric(out->matrix, work);
    /* the squares of all elements of A are those of 1 / semi-axis, added up; NaN if k <= 0 */
    return invcali_dot(out->matrix[0], out->matrix[0], 9) < SQUARE &&
                   invcali_dot3(out->offset, out->offset) < SQUARE
               ? INVCAL_OK
               : INVCAL_NOT_ELLIPSOID;
}

invcal_status invcali_triad(const invcal_real x[INVCAL_PARAMETERS], invcal_calibration *triad)
{
    const invcal_real xy = x[INVCAL_GAMMA_XY] / 2;
    const invcal_real xz = x[INVCAL_GAMMA_XZ] / 2;
    const invcal_real zy = x[INVCAL_GAMMA_ZY] / 2;
    const invcal_real p[3][3] = {{1 + x[INVCAL_DK_X], xy, xz},
                                 {xy, 1 + x[INVCAL_DK_Y], zy},
                                 {xz, zy, 1 + x[INVCAL_DK_Z]}}; /* I + S */
    int is_triad = p[0][0] * p[1][1] > xy * xy;

    invcali_inverse3(p, triad->matrix);
    memcpy(triad->offset, x, sizeof triad->offset);
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        is_triad &= p[i][i] > 0 && p[i][i] < LONGEST && INVCAL_FABS(x[i]) < LONGEST;
    }
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        is_triad &= triad->matrix[i][i] > 0 && triad->matrix[i][i] < LONGEST;
    }
    return is_triad ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

/* A (u - delta) with u = N (raw - zero): matrix = A N, offset = zero + N^-1 delta. */
static INVCAL_NOINLINE void compose_unchecked(const invcal_calibration *nominal,
                                              invcal_calibration *c)
{
    invcal_real cofactor[3][3];
    const invcal_real det = invcali_cofactors(nominal->matrix, cofactor);

    multiply(cofactor[0], 3, c->offset);
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        multiply(nominal->matrix[0], 3, c->matrix[i]);
        c->offset[i] = nominal->offset[i] + c->offset[i] / det;
    }
}

/* A calibration that is not a valid nominal cannot be stored either. */
invcal_status invcali_compose(const invcal_calibration *nominal, invcal_calibration *c)
{
    compose_unchecked(nominal, c);
    return invcali_nominal_check(c);
}

invcal_status invcal_sums_solve(invcal_sums *sums, const invcal_calibration *nominal,
                                invcal_calibration *out)
{
    invcal_calibration c;

    INVCAL_ASSERT(sums && nominal && out);
    if (sums->count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    invcal_real *a = sums->sum;
    invcal_status status =
        invcali_factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_FLOOR);
    if (status == INVCAL_OK) {
        invcali_back_substitute(a, INVCAL_PARAMETERS);
        status = invcali_ellipsoid(&a[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], a, &c);
    }
    if (status == INVCAL_OK) {
        status = invcali_compose(nominal, &c);
    }
    if (status == INVCAL_OK) {
        *out = c; /* which may be nominal */
    }
    return status;
}
