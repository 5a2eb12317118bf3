/* SPDX-License-Identifier: MIT
 *
 * The rotation from magnetometer to accelerometer, and the dip (mathematics_magnetometer.md, "Its
 * axes and those of an accelerometer"). With b the row (a (x) m, 1) of a sample, each residual and
 * each of its derivatives is a product of b and a row that depends on R and s alone. So all normal
 * equations of Gauss-Newton are forms u M v in the one matrix M = sum b b', and a step costs the
 * same for any number of samples.
 */
#include "invcal/magnetometer.h"

#include <limits.h>
#include <stddef.h>
#include <string.h>

#include "invcal/expert.h"
#include "../core/solve.h"
#include "../core/sums.h"
#include "../core/vector.h"

enum { DIP_UNKNOWNS = 4, DIP_STEPS = 8 };
#define DIP_FLOOR INVCAL_REAL(1e-3) /* of a pivot: an angle with less is undetermined */

void invcal_dip_init(invcal_dip *dip)
{
    INVCAL_ASSERT(dip);
    invcali_zero(dip, sizeof *dip);
}

invcal_status invcal_dip_add(invcal_dip *dip, const invcal_real up[3], const invcal_real field[3])
{
    invcal_real row[INVCAL_PRIVATE_DIP];

    INVCAL_ASSERT(dip && up && field);
    const invcal_real a = invcali_dot3(up, up);
    const invcal_real m = invcali_dot3(field, field);
    if (!invcali_are_finite(up) || !invcali_are_finite(field)) {
        return INVCAL_NOT_FINITE;
    }
    const invcal_real scale = 1 / (INVCAL_SQRT(a) * INVCAL_SQRT(m));
    if (!invcali_is_positive(scale)) { /* a length is 0, or beyond the number type */
        return INVCAL_OUT_OF_RANGE;
    }
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            row[3 * i + j] = scale * up[i] * field[j];
        }
    }
    row[INVCAL_PRIVATE_DIP - 1] = 1;
    invcali_rank_one(dip->own_sum, row, INVCAL_PRIVATE_DIP, 1);
    dip->count += dip->count < UINT_MAX;
    return INVCAL_OK;
}

/* u M v, with M the mean of b b', of which the sums are the lower triangle. */
static invcal_real between(const invcal_dip *dip, const invcal_real u[INVCAL_PRIVATE_DIP],
                           const invcal_real v[INVCAL_PRIVATE_DIP])
{
    const invcal_real *m = dip->own_sum;
    invcal_real sum = 0;

    for (unsigned r = 0; r < INVCAL_PRIVATE_DIP; r++) {
        for (unsigned c = 0; c <= r; c++) {
            sum += *m++ * (c < r ? u[r] * v[c] + u[c] * v[r] : u[r] * v[c]);
        }
    }
    return sum / (invcal_real)dip->count;
}

/* The row of a R m - s, and its derivatives: by rotation of R about each axis of a, and by s. A
 * small rotation about axis k moves component j of R m by component i, and component i by minus
 * component j. */
static void make_rows(const invcal_real r[3][3], invcal_real s,
                      invcal_real row[DIP_UNKNOWNS + 1][INVCAL_PRIVATE_DIP])
{
    invcali_zero(row, (DIP_UNKNOWNS + 1) * sizeof row[0]);
    for (unsigned k = 0; k < 3; k++) {
        const unsigned i = (k + 1) % 3;
        const unsigned j = (k + 2) % 3;
        for (unsigned c = 0; c < 3; c++) {
            row[k][3 * j + c] = r[i][c];
            row[k][3 * i + c] = -r[j][c];
            row[DIP_UNKNOWNS][3 * k + c] = r[k][c];
        }
    }
    row[3][INVCAL_PRIVATE_DIP - 1] = -1;
    row[DIP_UNKNOWNS][INVCAL_PRIVATE_DIP - 1] = -s;
}

/* The normal equations of a Gauss-Newton step, factored, followed by the step. */
static invcal_status make_step(const invcal_dip *dip, const invcal_real r[3][3], invcal_real s,
                               invcal_real a[INVCAL_PACKED_SIZE(DIP_UNKNOWNS + 1)])
{
    invcal_real row[DIP_UNKNOWNS + 1][INVCAL_PRIVATE_DIP];
    unsigned n = 0;

    make_rows(r, s, row);
    for (unsigned i = 0; i <= DIP_UNKNOWNS; i++) {
        for (unsigned j = 0; j <= i; j++) {
            a[n] = between(dip, row[i], row[j]);
            n++;
        }
    }
    return invcali_factor(a, DIP_UNKNOWNS, DIP_UNKNOWNS + 1, DIP_FLOOR);
}

/* R becomes (I + [angle]) R, made orthonormal again. */
static void turn_by(const invcal_real angle[3], invcal_real r[3][3])
{
    invcal_real work[INVCAL_WORK];
    invcal_real turned[3][3];

    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = (i + 1) % 3;
        const unsigned k = (i + 2) % 3;
        for (unsigned c = 0; c < 3; c++) {
            turned[i][c] = r[i][c] + angle[j] * r[k][c] - angle[k] * r[j][c];
        }
    }
    invcali_make_symmetric(turned, work);
    memcpy(r, work, sizeof turned);
}

/* sigma^2 = n_a r^2 K / (n - 4). With n_a below 1, samples would count more than once. The heading
 * is in error by their root mean square over cos(dip), and cos^2 is 1 - s^2. */
static void judge_dip(const invcal_dip *dip, invcal_real alike, invcal_real s,
                      invcal_real a[INVCAL_PACKED_SIZE(DIP_UNKNOWNS + 1)],
                      invcal_dip_quality *quality)
{
    const invcal_real square = a[INVCAL_PACKED(DIP_UNKNOWNS, DIP_UNKNOWNS)];
    const invcal_real n = (invcal_real)(dip->count - DIP_UNKNOWNS);
    invcal_real sum = 0;

    quality->scatter = square > 0 ? INVCAL_SQRT(square) : 0;
    invcali_invert(a, DIP_UNKNOWNS);
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real variance = invcali_variance(a, DIP_UNKNOWNS, i) / n;
        quality->sigma[i] = quality->scatter * INVCAL_SQRT(variance * (alike > 1 ? alike : 1));
        sum += quality->sigma[i] * quality->sigma[i] / 3;
    }
    quality->sine = s;
    quality->heading = INVCAL_SQRT(sum / (1 - s * s));
}

/* Begins at R = I, so the axes must be roughly aligned. The system after the last step is not
 * solved: it is that of the solution, from which scatter and sigma come. */
invcal_status invcal_dip_solve(const invcal_dip *dip, invcal_real alike, invcal_rotation *out,
                               invcal_dip_quality *quality)
{
    invcal_real a[INVCAL_PACKED_SIZE(DIP_UNKNOWNS + 1)];
    invcal_real r[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    invcal_real s = 0;

    INVCAL_ASSERT(dip && out);
    if (dip->count <= DIP_UNKNOWNS) {
        return INVCAL_TOO_FEW;
    }
    invcal_real change = 1;
    invcal_status status = make_step(dip, (const invcal_real(*)[3])r, s, a);
    for (unsigned n = 0; n < DIP_STEPS && status == INVCAL_OK && change > INVCAL_EPSILON; n++) {
        invcali_back_substitute(a, DIP_UNKNOWNS);
        const invcal_real *const x = &a[INVCAL_PACKED(DIP_UNKNOWNS, 0)];
        turn_by(x, r);
        s += x[3];
        change = invcali_dot(x, x, DIP_UNKNOWNS);
        status = make_step(dip, (const invcal_real(*)[3])r, s, a);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    if (!(change <= INVCAL_EPSILON)) {
        return INVCAL_UNDETERMINED;
    }
    memcpy(out->r, r, sizeof out->r);
    if (quality != NULL) {
        judge_dip(dip, alike, s, a, quality);
    }
    return INVCAL_OK;
}
