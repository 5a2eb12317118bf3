/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "judge.h"
#include "solve.h"
#include "vector.h"

/* What is known beforehand: parameter r is 0 with standard deviation sigma[r]; 0: nothing. */
typedef struct {
    const invcal_real *sigma;
    invcal_real widest; /* of them */
    unsigned count;     /* of those that are stated */
} prior_sigma;

static invcal_status know(const invcal_real sigma[INVCAL_PARAMETERS], prior_sigma *prior)
{
    prior->sigma = sigma;
    prior->widest = 0;
    prior->count = 0;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (!(sigma[r] >= 0 && sigma[r] <= INVCAL_REAL_MAX)) {
            return INVCAL_BAD_PRIOR;
        }
        prior->widest = sigma[r] > prior->widest ? sigma[r] : prior->widest;
        prior->count += sigma[r] > 0;
    }
    return prior->count > 0 ? INVCAL_OK : INVCAL_BAD_PRIOR;
}

/* One more row, noise / sigma p(r) = 0: its square, 0 if there is none. */
static invcal_real row_of(const prior_sigma *prior, unsigned r, invcal_real noise)
{
    const invcal_real ratio = prior->sigma[r] > 0 ? noise / prior->sigma[r] : 0;

    return ratio * ratio;
}

/* What the positions tell, and the prior, to L; with the right-hand side behind it, if rows is ten.
 * Where the positions alone leave parameters open the noise is raised to that with which the prior is
 * just more than rounding beside the largest sums: with less, rounding errors would count as data. */
static invcal_status factor_with(const invcal_real *told, unsigned rows, const prior_sigma *prior,
                                 invcal_real *noise, invcal_real *l)
{
    const size_t size = INVCAL_PACKED_SIZE(rows) * sizeof *l;

    memcpy(l, told, size);
    const invcal_real largest = invcal_largest_diagonal(l, INVCAL_PARAMETERS);
    if (invcal_factor(l, INVCAL_PARAMETERS, INVCAL_PARAMETERS, 30 * INVCAL_FLOOR) != INVCAL_OK) {
        const invcal_real resolved = prior->widest * INVCAL_SQRT(4 * INVCAL_EPSILON * largest);
        *noise = *noise >= resolved ? *noise : resolved;
    }
    memcpy(l, told, size);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        l[INVCAL_PACKED(r, r)] += row_of(prior, r, *noise);
    }
    return invcal_factor(l, INVCAL_PARAMETERS, rows, INVCAL_EPSILON);
}

/* The same of the nine alone to L^-1. */
static invcal_status invert_with(const invcal_real *told, const prior_sigma *prior,
                                 invcal_real *noise, invcal_real *l)
{
    const invcal_status status = factor_with(told, INVCAL_PARAMETERS, prior, noise, l);

    invcal_invert(l, INVCAL_PARAMETERS); /* of whatever is there: nobody looks at it on failure */
    return status;
}

/* The share of parameter r that the data told: 1 - posterior / prior variance; 0 where rounding has made
 * the posterior the larger. */
static invcal_real told_by_data(const prior_sigma *prior, unsigned r, invcal_real noise,
                                invcal_real *k)
{
    const invcal_real row = row_of(prior, r, noise);

    if (*k * row > 1) {
        *k = 1 / row;
    }
    return 1 - *k * row;
}

/* information: of the second pass. */
INVCAL_APART static invcal_status judge_with(const invcal_positions *positions,
                                             const prior_sigma *prior,
                                             const invcal_real *information,
                                             const invcal_real a[3][3], invcal_quality *q,
                                             uint16_t *from_prior)
{
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_real k[INVCAL_PARAMETERS];
    invcal_real noise = positions->noise;
    invcal_real dof =
        (invcal_real)q->positions; /* a parameter that the prior supplies costs none */
    invcal_real trace = 0;
    unsigned bits = 0;

    invcal_status status = invert_with(information, prior, &noise, l);
    if (status == INVCAL_OK) {
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            k[r] = invcal_variance(l, INVCAL_PARAMETERS, r);
            dof -= told_by_data(prior, r, noise, &k[r]);
        }
        q->dof = invcal_whole(dof);
        invcal_judge_noise(positions->noise,
                           information[INVCAL_PACKED(INVCAL_PARAMETERS, INVCAL_PARAMETERS)], dof,
                           q);
        status = invert_with(information, prior, &q->noise, l);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        k[r] = invcal_variance(l, INVCAL_PARAMETERS, r);
        if (!(prior->sigma[r] > 0 || k[r] <= INVCAL_HOPELESS_K)) {
            return INVCAL_UNDETERMINED;
        }
        bits |= (told_by_data(prior, r, q->noise, &k[r]) >= INVCAL_REAL(0.5) ? 0u : 1u) << r;
        trace += information[INVCAL_PACKED(r, r)] + row_of(prior, r, q->noise);
    }
    q->condition = invcal_condition(l, INVCAL_PARAMETERS, trace);
    invcal_judge_parameters(k, a, q);
    *from_prior = (uint16_t)bits;
    return INVCAL_OK;
}

/* First pass. triad calibrates u. */
INVCAL_APART static invcal_status solve_with(const invcal_positions *positions,
                                             const prior_sigma *prior, invcal_calibration *triad)
{
    invcal_sums sums;
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS + 1)];
    invcal_real noise = positions->noise;

    invcal_status status = invcal_positions_sum(positions, &sums);
    if (status != INVCAL_OK) {
        return status;
    }
    if (sums.count == 0 || sums.count + prior->count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    invcal_sums_system(&sums);
    status = factor_with(sums.sum, INVCAL_PARAMETERS + 1, prior, &noise, l);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_back_substitute(l, INVCAL_PARAMETERS);
    return invcal_ellipsoid(&l[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], l, triad);
}

static invcal_status calibrate(const invcal_positions *positions, const prior_sigma *prior,
                               invcal_calibration *out, invcal_quality *q, uint16_t *from_prior)
{
    invcal_sums sums;
    invcal_residuals residuals;
    invcal_calibration triad;
    const invcal_real(*a)[3] = (const invcal_real(*)[3])triad.matrix;

    invcal_status status = solve_with(positions, prior, &triad);
    if (status == INVCAL_OK) {
        *out = triad;
        status = invcal_behind(positions->nominal, out);
    }
    if (status == INVCAL_OK) {
        status = invcal_positions_compare(positions, out, a, &sums, &residuals);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    q->left_out = 0;
    invcal_judge_residuals(&residuals, q);
    return judge_with(positions, prior, sums.sum, a, q, from_prior);
}

static invcal_status check_with(const invcal_positions *positions,
                                const invcal_real sigma[INVCAL_PARAMETERS], prior_sigma *prior)
{
    if (!(positions->noise > 0)) {
        return INVCAL_BAD_NOISE;
    }
    const invcal_status status = invcal_positions_check(positions);
    return status == INVCAL_OK ? know(sigma, prior) : status;
}

/* The data may be noisier than stated: then the prior counts for more, and all is made once more. */
static invcal_status calibrate_twice(invcal_positions *positions, const prior_sigma *prior,
                                     invcal_calibration *out, invcal_quality *q,
                                     uint16_t *from_prior)
{
    invcal_status status = calibrate(positions, prior, out, q, from_prior);

    if (status == INVCAL_OK) {
        positions->noise = q->noise < 1 ? q->noise : 1;
        status = calibrate(positions, prior, out, q, from_prior);
    }
    return status;
}

invcal_status invcal_calibrate_with_prior(const invcal_real *raw, unsigned count,
                                          const invcal_calibration *nominal, invcal_real noise,
                                          const invcal_real prior[INVCAL_PARAMETERS],
                                          invcal_calibration *out, invcal_quality *quality,
                                          uint16_t *from_prior)
{
    invcal_positions positions = {raw, count, 0, nominal, noise};
    prior_sigma beforehand;
    invcal_calibration c;
    invcal_quality q;
    uint16_t bits;

    INVCAL_ASSERT((raw || count == 0) && nominal && prior && out && quality && from_prior);
    invcal_status status = check_with(&positions, prior, &beforehand);
    if (status == INVCAL_OK) {
        status = calibrate_twice(&positions, &beforehand, &c, &q, &bits);
    }
    if (status == INVCAL_OK) {
        *out = c;
        *quality = q;
        *from_prior = bits;
    }
    return status;
}
