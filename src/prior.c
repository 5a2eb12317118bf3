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
} known;

static invcal_status know(const invcal_real sigma[INVCAL_PARAMETERS], known *prior)
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

/* One more row for each, noise / sigma p(r) = 0. */
static void add_rows(const known *prior, invcal_real noise, invcal_real *a)
{
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (prior->sigma[r] > 0) {
            const invcal_real ratio = noise / prior->sigma[r];
            a[INVCAL_PACKED(r, r)] += ratio * ratio;
        }
    }
}

/* The sums and the prior to L. Where the positions alone leave parameters open the noise is raised to
 * the least with which the prior is more than rounding beside the largest sums: with less, rounding
 * errors would count as data. */
static invcal_status factor(const invcal_sums *sums, const known *prior, invcal_real *noise,
                            invcal_sums *l, invcal_real *trace)
{
    *l = *sums;
    invcal_sums_system(l);
    const invcal_real largest = invcal_largest_diagonal(l->sum, INVCAL_PARAMETERS);
    if (invcal_factor(l->sum, INVCAL_PARAMETERS, INVCAL_PARAMETERS, 30 * INVCAL_FLOOR) !=
        INVCAL_OK) {
        const invcal_real least = prior->widest * INVCAL_SQRT(4 * INVCAL_EPSILON * largest);
        *noise = *noise >= least ? *noise : least;
    }
    *l = *sums;
    invcal_sums_system(l);
    add_rows(prior, *noise, l->sum);
    *trace = invcal_trace(l->sum, INVCAL_PARAMETERS);
    return invcal_factor(l->sum, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_EPSILON);
}

/* The share of parameter r that the data told, 0 ... 1: 1 - posterior / prior variance. */
static invcal_real told_by_data(const known *prior, unsigned r, invcal_real noise, invcal_real k)
{
    if (!(prior->sigma[r] > 0)) {
        return 1;
    }
    const invcal_real ratio = noise / prior->sigma[r];
    return 1 - k * ratio * ratio;
}

/* How many parameters the data had to determine: what the prior supplies does not count. */
static invcal_real told_of_all(const known *prior, invcal_real noise, const invcal_real *inverse)
{
    invcal_real sum = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        sum += told_by_data(prior, r, noise, invcal_variance(inverse, INVCAL_PARAMETERS, r));
    }
    return sum;
}

static invcal_status judge_parameters(const known *prior, const invcal_real *inverse,
                                      const invcal_real a[3][3], invcal_quality *q,
                                      uint16_t *from_prior)
{
    invcal_real k[INVCAL_PARAMETERS];
    unsigned bits = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        k[r] = invcal_variance(inverse, INVCAL_PARAMETERS, r);
        if (!(prior->sigma[r] > 0 || k[r] <= INVCAL_HOPELESS_K)) {
            return INVCAL_UNDETERMINED;
        }
        const int is_of_data = told_by_data(prior, r, q->noise, k[r]) >= INVCAL_REAL(0.5);
        bits |= (is_of_data ? 0u : 1u) << r;
    }
    invcal_judge_parameters(k, 1, a, q);
    /* A posterior is no wider than its prior; what sigma leaves out of the Jacobian may say so by a
     * second-order trifle. */
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (prior->sigma[r] > 0 && q->sigma[r] > prior->sigma[r]) {
            q->sigma[r] = prior->sigma[r];
        }
    }
    *from_prior = (uint16_t)bits;
    return INVCAL_OK;
}

/* sums: of the second pass. */
INVCAL_APART static invcal_status judge(const invcal_positions *positions, const known *prior,
                                        const invcal_sums *sums, const invcal_real a[3][3],
                                        invcal_quality *q, uint16_t *from_prior)
{
    invcal_sums l;
    invcal_real trace;
    invcal_real noise = positions->noise;

    invcal_status status = factor(sums, prior, &noise, &l, &trace);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_invert(l.sum, INVCAL_PARAMETERS);
    invcal_judge_noise(positions->noise, sums->sum[INVCAL_MOMENTS + INVCAL_PARAMETERS],
                       (invcal_real)sums->count - told_of_all(prior, noise, l.sum), q);
    status = factor(sums, prior, &q->noise, &l, &trace);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_invert(l.sum, INVCAL_PARAMETERS);
    q->condition = invcal_condition(l.sum, INVCAL_PARAMETERS, trace);
    return judge_parameters(prior, l.sum, a, q, from_prior);
}

/* First pass. sums: of exact rows; a is what calibrates u. */
INVCAL_APART static invcal_status solve(const invcal_positions *positions, const known *prior,
                                        const invcal_sums *sums, invcal_real a[3][3],
                                        invcal_calibration *out)
{
    invcal_sums l;
    invcal_real trace;
    invcal_real noise = positions->noise;

    if (sums->count == 0 || sums->count + prior->count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    invcal_status status = factor(sums, prior, &noise, &l, &trace);
    if (status == INVCAL_OK) {
        invcal_back_substitute(l.sum, INVCAL_PARAMETERS);
        status = invcal_ellipsoid(&l.sum[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], out);
    }
    if (status == INVCAL_OK) {
        invcal_make_symmetric(out->matrix);
        memcpy(a, out->matrix, sizeof out->matrix);
        status = invcal_behind(positions->nominal, out);
    }
    return status;
}

static invcal_status calibrate(const invcal_positions *positions, const known *prior,
                               invcal_calibration *out, invcal_quality *q, uint16_t *from_prior)
{
    invcal_sums sums;
    invcal_real a[3][3];
    invcal_status status = invcal_positions_sum(positions, &sums);

    if (status == INVCAL_OK) {
        status = solve(positions, prior, &sums, a, out);
    }
    if (status == INVCAL_OK) {
        status = invcal_positions_compare(positions, out, (const invcal_real(*)[3])a, &sums, q);
    }
    return status == INVCAL_OK
               ? judge(positions, prior, &sums, (const invcal_real(*)[3])a, q, from_prior)
               : status;
}

/* The data may be noisier than stated: then the prior counts for more, and all is made once more. */
invcal_status invcal_calibrate_with_prior(const invcal_real *raw, unsigned count,
                                          const invcal_calibration *nominal, invcal_real noise,
                                          const invcal_real prior[INVCAL_PARAMETERS],
                                          invcal_calibration *out, invcal_quality *quality,
                                          uint16_t *from_prior)
{
    invcal_positions positions = {raw, count, 0, nominal, noise};
    known beforehand;
    invcal_calibration c;
    invcal_quality q;
    uint16_t bits;

    INVCAL_ASSERT((raw || count == 0) && nominal && prior && out && quality && from_prior);
    invcal_status status = noise > 0 ? invcal_positions_check(&positions) : INVCAL_BAD_NOISE;
    if (status == INVCAL_OK) {
        status = know(prior, &beforehand);
    }
    for (unsigned time = 0; time < 2 && status == INVCAL_OK; time++) {
        status = calibrate(&positions, &beforehand, &c, &q, &bits);
        positions.noise = q.noise < 1 ? q.noise : 1;
    }
    if (status == INVCAL_OK) {
        *out = c;
        *quality = q;
        *from_prior = bits;
    }
    return status;
}
