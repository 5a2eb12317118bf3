/* SPDX-License-Identifier: MIT
 *
 * Calibration with a prior, and by six faces, which is a prior on the angles (mathematics.md,
 * "Prior"). Each known parameter is one more row, noise / sigma p(r) = 0, which only adds to the
 * diagonal of H'H.
 *
 * The weight of these rows needs the noise of the positions, and the residuals may show more than
 * was stated. So everything is solved twice, the second time with the noise found by the first.
 */
#include <string.h>

#include "invcal/positions.h"
#include "judge.h"
#include "../core/solve.h"
#include "../core/vector.h"

enum { SYSTEM = INVCAL_PACKED_SIZE(INVCAL_PARAMETERS + 1) };

/* What is known beforehand: parameter r is 0 with standard deviation sigma[r]; 0: nothing. And the
 * result with the positions. */
typedef struct {
    const invcal_real *sigma;
    invcal_real widest;   /* of them */
    unsigned count;       /* of those that are stated */
    invcal_real stated;   /* noise, as passed */
    invcal_real noise;    /* used for the weights */
    invcal_real resolved; /* min noise that resolves what the positions leave open */
    invcal_calibration c;
    invcal_quality q;
    uint8_t of_noise; /* verdict on the residuals alone */
} update;

static invcal_status check_prior(const invcal_positions *positions, update *prior)
{
    const invcal_real *sigma = prior->sigma;

    if (!(positions->noise > 0)) {
        return INVCAL_BAD_NOISE;
    }
    const invcal_status status = invcali_positions_check(positions);
    if (status != INVCAL_OK) {
        return status;
    }
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
static invcal_real row_of(const update *prior, unsigned r)
{
    const invcal_real ratio = prior->sigma[r] > 0 ? prior->noise / prior->sigma[r] : 0;

    return ratio * ratio;
}

/* Positions and prior to L. If the positions alone leave parameters open, the noise is raised until
 * the prior just exceeds rounding of the largest sums: with less, rounding errors would count as
 * data. */
static invcal_status factor_with(const invcal_real *of_positions, update *prior,
                                 invcal_real l[SYSTEM])
{
    const invcal_real largest = invcali_largest_diagonal(of_positions, INVCAL_PARAMETERS);

    memcpy(l, of_positions, SYSTEM * sizeof *l);
    if (invcali_factor(l, INVCAL_PARAMETERS, INVCAL_PARAMETERS, 30 * INVCAL_FLOOR) != INVCAL_OK) {
        const invcal_real resolved = prior->widest * INVCAL_SQRT(4 * INVCAL_EPSILON * largest);
        prior->resolved = prior->resolved >= resolved ? prior->resolved : resolved;
        prior->noise = prior->noise >= resolved ? prior->noise : resolved;
    }
    memcpy(l, of_positions, SYSTEM * sizeof *l);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        l[INVCAL_PACKED(r, r)] += row_of(prior, r);
    }
    return invcali_factor(l, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_EPSILON);
}

/* First pass. triad calibrates u. */
static invcal_status solve_with(const invcali_selection *all, update *prior, invcal_sums *sums,
                                invcal_real l[SYSTEM], invcal_calibration *triad)
{
    invcal_status status = invcali_positions_sum(all, sums);
    if (status != INVCAL_OK) {
        return status;
    }
    if (sums->count == 0 || sums->count + prior->count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    status = factor_with(sums->sum, prior, l);
    if (status != INVCAL_OK) {
        return status;
    }
    invcali_back_substitute(l, INVCAL_PARAMETERS);
    return invcali_ellipsoid(&l[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], l, triad);
}

/* Of the second pass. Of a parameter, 1 - K(r,r) noise^2 / sigma^2 is what the data had to
 * determine: only that costs degrees of freedom, and below 1/2 it is from the prior. Its sigma is
 * at most that of the prior, except for rounding. */
static invcal_status judge_with(const invcal_real *information, update *prior,
                                invcal_real l[SYSTEM], const invcal_real a[3][3])
{
    invcal_quality *q = &prior->q;
    invcal_real *const k = q->sigma;
    invcal_real dof = (invcal_real)q->positions;
    invcal_real trace = 0;
    unsigned bits = 0;

    const invcal_status status = factor_with(information, prior, l);
    if (status != INVCAL_OK) {
        return status;
    }
    invcali_invert(l, INVCAL_PARAMETERS);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real row = row_of(prior, r);
        k[r] = invcali_variance(l, INVCAL_PARAMETERS, r);
        if (!(prior->sigma[r] > 0 || k[r] <= INVCAL_HOPELESS_K)) {
            return INVCAL_UNDETERMINED;
        }
        if (k[r] * row > 1) {
            k[r] = 1 / row;
        }
        bits |= (k[r] * row <= INVCAL_REAL(0.5) ? 0u : 1u) << r;
        dof -= 1 - k[r] * row;
        trace += information[INVCAL_PACKED(r, r)] + row;
    }
    q->dof = invcali_whole(dof);
    q->condition = invcali_condition(l, INVCAL_PARAMETERS, trace);
    q->verdict = INVCAL_GOOD;
    invcali_judge_noise(prior->stated, information[SYSTEM - 1], dof, -INVCAL_REAL_MAX, q);
    prior->of_noise = q->verdict;
    const invcal_real seen = q->noise >= prior->resolved ? q->noise : prior->resolved;
    q->noise = prior->noise; /* the weight of the prior */
    prior->noise = seen;
    invcali_judge_parameters(a, q);
    q->held = (uint16_t)bits;
    return INVCAL_OK;
}

static invcal_status calibrate(const invcal_positions *positions, update *prior)
{
    const invcali_selection all = {*positions, 0};
    invcal_sums sums;
    invcal_calibration triad;
    invcal_real l[SYSTEM];
    const invcal_real(*a)[3] = (const invcal_real(*)[3])triad.matrix;

    invcal_status status = solve_with(&all, prior, &sums, l, &triad);
    if (status == INVCAL_OK) {
        prior->c = triad;
        status = invcali_compose(positions->nominal, &prior->c);
    }
    if (status == INVCAL_OK) {
        status = invcali_positions_pass(&all, &prior->c, a, &sums, &prior->q);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    status = judge_with(sums.sum, prior, l, a);
    if (status == INVCAL_OK) { /* again, with the noise found */
        status = judge_with(sums.sum, prior, l, a);
    }
    return status;
}

/* If the data are noisier than stated, the prior has more weight: solve again. */
static invcal_status calibrate_twice(const invcal_positions *positions, const invcal_real *sigma,
                                     update *u)
{
    invcali_zero(u, sizeof *u);
    u->sigma = sigma;
    u->stated = positions->noise;
    u->noise = positions->noise;
    invcal_status status = check_prior(positions, u);
    if (status == INVCAL_OK) {
        status = calibrate(positions, u);
    }
    if (status == INVCAL_OK) {
        status = calibrate(positions, u);
    }
    return status;
}

invcal_status invcal_calibrate_prior(const invcal_positions *positions,
                                     const invcal_real prior[INVCAL_PARAMETERS],
                                     invcal_calibration *out, invcal_quality *quality)
{
    update u;

    INVCAL_ASSERT(INVCAL_ARE_GIVEN(positions) && prior && out && quality);
    const invcal_status status = calibrate_twice(positions, prior, &u);
    if (status == INVCAL_OK) {
        *out = u.c;
        *quality = u.q;
    }
    return status;
}

/* An angle that the positions hardly determine is held by the prior, and the verdict ignores it. */
invcal_status invcal_calibrate_faces(const invcal_positions *positions, invcal_real gamma,
                                     invcal_calibration *out, invcal_quality *quality)
{
    const invcal_real prior[INVCAL_PARAMETERS] = {0, 0, 0, 0, 0, 0, gamma, gamma, gamma};
    const unsigned angles = 0x1C0;
    update u;

    INVCAL_ASSERT(INVCAL_ARE_GIVEN(positions) && out && quality);
    const invcal_status status =
        gamma < 1 ? calibrate_twice(positions, prior, &u) : INVCAL_BAD_PRIOR;
    if (status == INVCAL_OK) {
        const unsigned weak = u.q.weak;
        u.q.held = (uint16_t)(u.q.held | (weak & angles));
        u.q.weak = (uint16_t)(weak & ~angles);
        if (u.q.weak == 0) {
            u.q.verdict = u.of_noise;
            invcali_raise(&u.q, u.q.dof > 0 ? INVCAL_GOOD : INVCAL_NO_REDUNDANCY);
        }
        *out = u.c;
        *quality = u.q;
    }
    return status;
}
