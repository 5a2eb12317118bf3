/* SPDX-License-Identifier: MIT */
#include "invcal/criteria.h"

#include "vector.h"

invcal_status invcal_criteria_add(invcal_normal *design, const invcal_real vertical[3])
{
    invcal_observation row;

    INVCAL_ASSERT(design && vertical);
    const invcal_status status = invcal_observation_vertical(vertical, vertical, &row);
    if (status != INVCAL_OK) {
        return status;
    }
    row.j = 0; /* the rounding error of a unit vector's length is no measurement */
    return invcal_normal_add(design, &row, 1);
}

/* ln x = e ln 2 + 2 (s + s^3/3 + s^5/5 ...), x = 2^e m, s = (m - 1)/(m + 1), m near 1; for
 * finite x > 0. The library needs no other logarithm, so it asks libc for none. */
static invcal_real logarithm(invcal_real x)
{
    invcal_real e = 0;
    invcal_real sum = 0;

    while (x > INVCAL_REAL(1.4142136)) { /* at most 128 steps (double: 1024) */
        x /= 2;
        e++;
    }
    while (x < INVCAL_REAL(0.7071067)) { /* at most 149 steps (double: 1074) */
        x *= 2;
        e--;
    }
    const invcal_real s = (x - 1) / (x + 1); /* |s| < 0.172 */
    invcal_real power = s;
    for (unsigned k = 1; k <= (INVCAL_DOUBLE ? 21u : 9u); k += 2) {
        sum += power / (invcal_real)k;
        power *= s * s;
    }
    return e * INVCAL_REAL(0.69314718055994531) + 2 * sum;
}

/* The largest root of three. */
static invcal_real largest_root(const invcal_real k[3])
{
    const invcal_real larger = k[0] > k[1] ? k[0] : k[1];

    return INVCAL_SQRT(larger > k[2] ? larger : k[2]);
}

invcal_status invcal_criteria_judge(const invcal_normal *design, invcal_criteria *out)
{
    invcal_real work[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]; /* H'H, then L, then K */
    invcal_real k[INVCAL_PARAMETERS];                        /* the diagonal of K */
    invcal_real log_det = 0;
    invcal_real trace = 0;
    invcal_real condition;

    INVCAL_ASSERT(design && out);
    invcal_normal_matrix(design, work);
    const invcal_status status =
        invcal_cholesky_factor(work, INVCAL_PARAMETERS, INVCAL_PIVOT_FLOOR);
    if (status != INVCAL_OK) {
        return status;
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        log_det += 2 * logarithm(work[INVCAL_PACKED(r, r)]); /* det = product of L(r,r)^2 */
    }
    invcal_cholesky_inverse(work, INVCAL_PARAMETERS);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        k[r] = work[INVCAL_PACKED(r, r)];
        trace += k[r];
    }
    condition = invcal_largest_eigenvalue(work, INVCAL_PARAMETERS);
    invcal_normal_matrix(design, work);
    condition *= invcal_largest_eigenvalue(work, INVCAL_PARAMETERS);
    if (!(condition * INVCAL_PIVOT_FLOOR < 1) || !invcal_is_finite(trace)) {
        return INVCAL_UNDETERMINED; /* an open combination may hide behind sound pivots */
    }
    out->positions = design->count;
    out->sigma_delta = largest_root(&k[INVCAL_DELTA_X]);
    out->sigma_dk = largest_root(&k[INVCAL_DK_X]);
    out->sigma_gamma = largest_root(&k[INVCAL_GAMMA_XY]);
    out->condition = condition;
    out->log_det = log_det;
    return INVCAL_OK;
}
