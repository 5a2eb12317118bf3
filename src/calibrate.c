/* SPDX-License-Identifier: MIT */
#include "invcal/calibrate.h"

#include <stddef.h>
#include <string.h>

#include "vector.h"

/* First pass: the normal equations of all positions. */
static invcal_status add_positions(const invcal_real *raw, unsigned count,
                                   const invcal_settings *settings, invcal_normal *normal,
                                   unsigned *position)
{
    invcal_observation row;
    const invcal_real *mean = raw;

    for (*position = 0; *position < count; ++*position, mean += 3) {
        invcal_status status = invcal_observe(&settings->nominal, settings->field, mean, &row);
        if (status == INVCAL_OK) {
            status = invcal_normal_add(normal, &row, 1);
        }
        if (status != INVCAL_OK) {
            return status;
        }
    }
    return INVCAL_OK;
}

invcal_real invcal_faded(unsigned days)
{
    invcal_real weight = 1;

    /* at most 255 steps: what an age holds */
    for (; days > 0; days--) {
        weight *= INVCAL_REAL(0.96875); /* 31/32 */
    }
    return weight;
}

static int is_left_out(const invcal_positions *positions, unsigned i)
{
    return positions->left_out && (positions->left_out >> i & 1u);
}

/* Second pass: the residuals of the solution. */
static invcal_status compare(const invcal_positions *positions, const invcal_settings *settings,
                             const invcal_solution *solution, invcal_residuals *residuals)
{
    invcal_real u[3];

    invcal_residuals_init(residuals, solution);
    for (unsigned i = 0; i < positions->count; i++) {
        if (is_left_out(positions, i)) {
            continue;
        }
        const invcal_real weight = invcal_faded(positions->age ? positions->age[i] : 0);
        if (invcal_observation_reading(&settings->nominal, settings->field,
                                       &positions->raw[3 * (size_t)i], u) != INVCAL_OK ||
            invcal_residuals_add(residuals, u, weight, NULL) != INVCAL_OK) {
            return INVCAL_NOT_ELLIPSOID; /* a reading fit for the first pass, absurd after it */
        }
    }
    return INVCAL_OK;
}

/* Do the sums determine a solution in this number type? If not it is one of rounding errors, and
 * readings calibrated by it may look well spread. A prior holds what is open.
 * cond A <= tr A tr A^-1: where that is small enough, the condition itself, which takes six times as
 * long, need not be known. */
INVCAL_APART static int is_resolved(const invcal_normal *normal, const invcal_settings *settings)
{
    invcal_real hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_real variance[INVCAL_PARAMETERS];
    invcal_real trace = 0;
    invcal_real of_inverse = 0;

    if (invcal_has_prior(settings)) {
        return 1;
    }
    invcal_normal_matrix(normal, hth);
    memcpy(l, hth, sizeof l);
    (void)invcal_cholesky_factor(l, INVCAL_PARAMETERS, INVCAL_PIVOT_FLOOR); /* solved before */
    invcal_cholesky_inverse_diagonal(l, INVCAL_PARAMETERS, variance);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        trace += hth[INVCAL_PACKED(r, r)];
        of_inverse += variance[r];
    }
    return trace * of_inverse * INVCAL_PIVOT_FLOOR < INVCAL_REAL(0.5) ||
           invcal_condition(hth, INVCAL_PARAMETERS) * INVCAL_PIVOT_FLOOR < 1;
}

INVCAL_APART static invcal_status solve_and_assess(const invcal_normal *normal,
                                                   const invcal_positions *positions,
                                                   const invcal_settings *settings,
                                                   invcal_solution *solution,
                                                   invcal_quality *quality, invcal_real *gain)
{
    invcal_residuals residuals;
    invcal_status status = invcal_solve(normal, settings, solution);

    if (status == INVCAL_NOT_ELLIPSOID && !invcal_has_prior(settings) &&
        invcal_undetermined(normal)) {
        return INVCAL_UNDETERMINED; /* what is left open may take any shape */
    }
    if (status == INVCAL_OK && !is_resolved(normal, settings)) {
        return INVCAL_UNDETERMINED;
    }
    if (status == INVCAL_OK) {
        status = compare(positions, settings, solution, &residuals);
    }
    if (status == INVCAL_OK) {
        status = invcal_assess(&residuals, normal->count, settings, solution, quality);
        *gain = residuals.gain;
    }
    return status;
}

/* The data may be noisier than stated: then the prior counts for more, and the solution is made
 * once more. Whether residuals or the user told the noise was decided the first time. */
INVCAL_APART static invcal_status weigh_prior_again(const invcal_normal *normal,
                                                    const invcal_positions *positions,
                                                    const invcal_settings *settings,
                                                    invcal_solution *solution,
                                                    invcal_quality *quality, invcal_real gain)
{
    const invcal_real coverage = quality->coverage;
    const invcal_real observed = quality->noise * settings->field / gain;
    invcal_settings noisier = *settings;

    noisier.noise = observed < settings->field ? observed : settings->field;
    const invcal_status status =
        solve_and_assess(normal, positions, &noisier, solution, quality, &gain);
    quality->coverage = coverage;
    return status;
}

/* The n-th position that is not left out. */
static unsigned nth_kept(const invcal_positions *positions, unsigned n)
{
    unsigned i = 0;

    while (is_left_out(positions, i) || n-- > 0) { /* at most as many as there are positions */
        i++;
        //@ assert i < positions->count;
    }
    return i;
}

invcal_status invcal_calibrate_sums(const invcal_normal *normal, const invcal_positions *positions,
                                    const invcal_settings *settings, invcal_solution *solution,
                                    invcal_quality *quality)
{
    invcal_real gain;

    INVCAL_ASSERT(normal && positions && settings && solution && quality);
    invcal_status status = solve_and_assess(normal, positions, settings, solution, quality, &gain);
    if (status == INVCAL_OK && invcal_has_prior(settings)) {
        status = weigh_prior_again(normal, positions, settings, solution, quality, gain);
    }
    if (status == INVCAL_OK) {
        quality->worst = nth_kept(positions, quality->worst);
    }
    return status;
}

invcal_status invcal_calibrate(const invcal_real *raw, unsigned count,
                               const invcal_settings *settings, invcal_solution *solution,
                               invcal_quality *quality, invcal_reason *reason)
{
    const invcal_positions positions = {raw, NULL, count, 0};
    invcal_normal normal;
    invcal_solution s;
    invcal_quality q;
    unsigned position = count;

    INVCAL_ASSERT((raw || count == 0) && settings && solution && quality);
    invcal_normal_init(&normal);
    invcal_status status = invcal_settings_check(settings);
    if (status == INVCAL_OK) {
        status = add_positions(raw, count, settings, &normal, &position);
    }
    if (status == INVCAL_OK) {
        status = invcal_calibrate_sums(&normal, &positions, settings, &s, &q);
    }
    if (status == INVCAL_OK) {
        *solution = s;
        *quality = q;
    } else if (reason != NULL) {
        reason->position = position;
        reason->undetermined = invcal_undetermined(&normal);
    } /* cppcheck-suppress misra-c2012-15.7 ; nobody asks for the reason */
    return status;
}
