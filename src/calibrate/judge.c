/* SPDX-License-Identifier: MIT
 *
 * The two passes over the positions, and the judgement of the result (mathematics.md, "Residuals",
 * "Uncertainty", "Verdict, and near cones"). The first pass sums exact rows in nominal units, from
 * which p is solved. The second sums rows of the calibrated positions: derivatives with respect to
 * the parameters as reported, each weighted by its noise. Sigma is of the second, because K of the
 * first is wrong by the size of the errors.
 *
 * Each step is a function of its own, since prior.c, thermal_fit.c and cell_fit.c take the same
 * steps with other rows.
 */
#include "judge.h"

#include <stddef.h>

#include "../core/solve.h"
#include "../core/sums.h"
#include "../core/vector.h"

/* mathematics.md, "Verdict, and near cones"; and "Uncertainty" for those in standard deviations. */
#define NOISE_SHARE INVCAL_REAL(0.1) /* of the information on a parameter: above, it is weak */
#define LIKELY INVCAL_REAL(1.73)     /* exceeded in 5 % of cases: more noise than stated */
#define POSSIBLE INVCAL_REAL(3.0)    /* exceeded in 0.3 %: more than noise */
#define SILENT INVCAL_REAL(-2.8)     /* below in at most 0.1 %: less than that noise */
#define OPEN INVCAL_REAL(1e4)        /* quality.condition; above: parameters are left open */

/* ---- the passes ------------------------------------------------------------------------------ */

/* Of a calibrated position the derivatives of J, and its weight by its actual noise. X changes J,
 * except for the sign, by d eta = -A (d delta + dS eta), so dJ = eta d eta = -g (d delta + dS eta). */
static INVCAL_ONCE invcal_real derive(const invcal_real a[3][3], invcali_row *row)
{
    invcal_real g[3];

    const invcal_real square = invcali_gradient(a, row->h, g);
    invcali_products(g, row->h);
    memcpy(row->h, g, sizeof g);
    return 1 / square;
}

invcal_status invcali_positions_pass(const invcali_selection *selection,
                                     const invcal_calibration *c, const invcal_real a[3][3],
                                     invcal_sums *sums, invcal_quality *q)
{
    invcali_row row;

    invcal_sums_init(sums);
    if (q != NULL) {
        invcali_judge_begin(q);
    }
    for (unsigned i = 0; i < selection->given.count; i++) {
        invcal_real weight = 1;
        if (invcali_is_left_out(selection, i)) {
            continue;
        }
        const invcal_status status = invcali_read(c, selection->given.mean[i].v, row.h);
        if (status != INVCAL_OK) { /* readings that pass the first pass may be absurd after it */
            return q != NULL ? INVCAL_NOT_ELLIPSOID : status;
        }
        if (q != NULL) {
            invcali_residuals_add(q, i, &row);
            weight = derive(a, &row);
        }
        invcali_sums_add_row(sums, &row, weight);
    }
    return q != NULL ? invcali_residuals_end(q) : INVCAL_OK;
}

invcal_status invcali_positions_check(const invcal_positions *positions)
{
    if (!(positions->noise >= 0 && positions->noise < 1)) {
        return INVCAL_BAD_NOISE;
    }
    return positions->count < UINT16_MAX ? invcali_nominal_check(positions->nominal)
                                         : INVCAL_BAD_COUNT;
}

/* Used for both passes: even if undetermined in nominal units, the readings may look well spread
 * once calibrated by a solution made of rounding errors. */
invcal_status invcali_determine(invcal_real *a, unsigned rows, invcal_quality *q)
{
    invcal_real of_inverse = 0;

    q->condition = invcali_trace(a, INVCAL_PARAMETERS);
    const invcal_status status = invcali_factor(a, INVCAL_PARAMETERS, rows, INVCAL_FLOOR);

    if (status != INVCAL_OK) {
        return status;
    }
    if (rows > INVCAL_PARAMETERS) {
        invcali_back_substitute(a, INVCAL_PARAMETERS);
    }
    invcali_invert(a, INVCAL_PARAMETERS);
    INVCAL_ROLL
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        q->sigma[r] = invcali_variance_inline(a, INVCAL_PARAMETERS, r);
        of_inverse += q->sigma[r];
    }
    q->condition *= of_inverse;
    /* in float the first is the narrower, in double the second */
    return invcali_is_resolved(q->condition) && of_inverse <= INVCAL_HOPELESS_K
               ? INVCAL_OK
               : INVCAL_UNDETERMINED;
}

invcal_status invcali_positions_solve(const invcali_selection *selection, invcal_sums *sums,
                                      invcal_quality *q)
{
    invcal_status status = invcali_positions_sum(selection, sums);

    if (status == INVCAL_OK) {
        status = sums->count < INVCAL_PARAMETERS
                     ? INVCAL_TOO_FEW
                     : invcali_determine(sums->sum, INVCAL_PARAMETERS + 1, q);
    }
    return status;
}

/* ---- judgement ------------------------------------------------------------------------------- */

/* sigma_J^2 = (4 stated^2 + Q) / (4 + dof), or Q / dof: mathematics.md, "Uncertainty". By how many
 * standard deviations the residuals exceed the stated noise: the root of 2 chi squared is nearly
 * normal about that of 2 dof - 1 (Fisher). 0 if there is nothing to compare; NaN if stated is. */
void invcali_judge_noise(invcal_real stated, invcal_real squares, invcal_real dof,
                         invcal_real silent, invcal_quality *q)
{
    const invcal_real known = stated * stated;
    invcal_real above = stated * 0;

    q->sigma_dof = q->dof;
    squares += above;
    if (known > 0) {
        if (dof >= 1) {
            above = INVCAL_SQRT(2 * squares / known) - INVCAL_SQRT(2 * dof - 1);
        }
        if (above <= LIKELY && above >= silent) {
            q->sigma_dof = (uint16_t)(q->dof + INVCAL_STATED);
            squares += invcali_number(INVCAL_STATED) * known;
            dof += invcali_number(INVCAL_STATED);
        }
    }
    if (!(above <= POSSIBLE)) {
        invcali_raise(q, INVCAL_ROUGH);
    }
    /* unknown: the whole field, which cannot pass for good */
    q->noise = q->sigma_dof > 0 ? INVCAL_SQRT(squares / dof) : 1;
}

void invcali_weigh_noise(invcal_real stated, invcal_real squares, invcal_quality *quality)
{
    invcali_judge_noise(stated, squares, invcali_number(quality->dof), SILENT, quality);
}

void invcali_judge_parameters(const invcal_real a[3][3], invcal_quality *q)
{
    /* in calibrated units: |A eta| times that of u, here the mean square over all directions */
    const invcal_real gain = invcali_dot(a[0], a[0], 9) / (3 * NOISE_SHARE);
    const invcal_real noise = q->noise;
    const invcal_real of_noise =
        noise < 1 ? invcali_number(q->positions) * noise * noise * gain : 0;
    const invcal_real least = of_noise > 1 / INVCAL_WEAK_K ? of_noise : 1 / INVCAL_WEAK_K;
    unsigned weak = 0;

    INVCAL_ROLL
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real k = q->sigma[r];
        weak |= (unsigned)!(k * least <= 1) << r;
        q->sigma[r] = noise * INVCAL_SQRT(k);
    }
    q->weak = (uint16_t)weak;
    invcali_raise(q, weak > 0 ? INVCAL_WEAK : q->dof > 0 ? INVCAL_GOOD : INVCAL_NO_REDUNDANCY);
}

/* tr A^-1: the squares of all elements of L^-1. */
invcal_real invcali_condition(const invcal_real *inverse, unsigned n, invcal_real trace)
{
    return trace * invcali_dot(inverse, inverse, INVCAL_PACKED_SIZE(n));
}

/* ---- all in one ------------------------------------------------------------------------------ */

/* Not inline: its caller needs the stack for more tests. */
INVCAL_NOINLINE invcal_status invcali_positions_calibrate(const invcali_selection *selection,
                                                          invcal_calibration *out,
                                                          invcal_quality *quality)
{
    invcal_calibration triad; /* what calibrates u */
    const invcal_real(*a)[3] = (const invcal_real(*)[3])triad.matrix;
    invcal_calibration c;
    invcal_quality q;
    invcal_sums sums;

    invcal_status status = invcali_positions_check(&selection->given);
    if (status == INVCAL_OK) {
        status = invcali_positions_solve(selection, &sums, &q);
    }
    if (status == INVCAL_OK) {
        status =
            invcali_ellipsoid(&sums.sum[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], sums.sum, &triad);
        if (status != INVCAL_OK && q.condition > OPEN) {
            status = INVCAL_UNDETERMINED; /* an open direction may take any shape */
        }
    }
    if (status == INVCAL_OK) {
        invcali_copy(&c, &triad, sizeof c);
        status = invcali_compose(selection->given.nominal, &c);
    }
    if (status == INVCAL_OK) {
        status = invcali_positions_pass(selection, &c, a, &sums, &q);
    }
    if (status == INVCAL_OK) {
        status = invcali_determine(sums.sum, INVCAL_PARAMETERS, &q);
    }
    if (status == INVCAL_OK) {
        invcali_copy(out, &c, sizeof c); /* which may be nominal */
        q.left_out = selection->left_out;
        q.dof = (uint16_t)(q.positions - INVCAL_PARAMETERS);
        invcali_weigh_noise(selection->given.noise,
                            sums.sum[INVCAL_PACKED(INVCAL_PARAMETERS, INVCAL_PARAMETERS)], &q);
        invcali_judge_parameters(a, &q);
        invcali_copy(quality, &q, sizeof q);
    }
    return status;
}
