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

#include "solve.h"
#include "sums.h"
#include "vector.h"

/* mathematics.md, "Verdict, and near cones"; and "Uncertainty" for those in standard deviations. */
#define NOISE_SHARE INVCAL_REAL(0.1) /* of the information on a parameter: above, it is weak */
#define ABSURD INVCAL_REAL(0.1)      /* rms of the residuals; above: not readings of one field */
#define LIKELY INVCAL_REAL(1.73)     /* exceeded in 5 % of cases: more noise than stated */
#define POSSIBLE INVCAL_REAL(3.0)    /* exceeded in 0.3 %: more than noise */
#define SILENT INVCAL_REAL(-2.8)     /* below in at most 0.1 %: less than that noise */
#define OPEN INVCAL_REAL(1e4)        /* quality.condition; above: parameters are left open */

/* ---- residuals ------------------------------------------------------------------------------- */

/* |eta| - 1 of j = (|eta|^2 - 1)/2 = (|eta| - 1)(|eta| + 1)/2: a root less 1 would cancel. */
INVCAL_INLINE void invcal_residuals_add(invcal_residuals *residuals, unsigned i,
                                        const invcal_row *row)
{
    const invcal_real twice = 2 * row->h[INVCAL_J];
    const invcal_real r = twice / (1 + INVCAL_SQRT(1 + twice));

    residuals->rms += r * r;
    if (!(INVCAL_FABS(r) <= residuals->max)) {
        residuals->max = INVCAL_FABS(r);
        residuals->worst = i;
    }
    residuals->count++;
}

invcal_status invcal_residuals_end(invcal_residuals *residuals)
{
    residuals->rms = INVCAL_SQRT(residuals->rms / invcal_number(residuals->count));
    return residuals->rms <= ABSURD ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

INVCAL_INLINE invcal_real invcal_gradient(const invcal_real a[3][3], const invcal_real eta[3],
                                          invcal_real g[3])
{
    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        g[i] = invcal_dot3(a[i], eta);
    }
    return invcal_dot3(g, g);
}

/* ---- the passes ------------------------------------------------------------------------------ */

/* A calibrated position, weighted by its actual noise. X changes J, except for the sign, by
 * d eta = -A (d delta + dS eta), so dJ = eta d eta = -g (d delta + dS eta). */
static INVCAL_ONCE void add_calibrated(invcal_sums *sums, const invcal_real a[3][3],
                                       const invcal_row *row)
{
    invcal_real g[INVCAL_PARAMETERS + 1];

    const invcal_real weight = 1 / invcal_gradient(a, row->h, g);
    invcal_products(row->h, g);
    g[INVCAL_J] = row->h[INVCAL_J];
    invcal_rank_one(sums->sum, g, INVCAL_PARAMETERS + 1, weight);
}

/* The rows of all that are not left out: exact ones, or, with residuals, of calibrated
 * positions. */
static INVCAL_NOINLINE invcal_status pass(const invcal_positions *positions,
                                          const invcal_calibration *c, const invcal_real a[3][3],
                                          invcal_sums *sums, invcal_residuals *residuals)
{
    invcal_row row;

    invcal_sums_init(sums);
    for (unsigned i = 0; i < positions->count; i++) {
        if (invcal_is_left_out(positions, i)) {
            continue;
        }
        const invcal_status status = invcal_read(c, &positions->raw[3 * (size_t)i], row.h);
        if (status != INVCAL_OK) {
            return status;
        }
        if (residuals != NULL) {
            invcal_residuals_add(residuals, i, &row);
            add_calibrated(sums, a, &row);
        } else {
            invcal_sums_add_row(sums, &row, 1);
        }
    }
    return INVCAL_OK;
}

invcal_status invcal_positions_sum(const invcal_positions *positions, invcal_sums *sums)
{
    return pass(positions, positions->nominal, NULL, sums, NULL);
}

invcal_status invcal_positions_compare(const invcal_positions *positions,
                                       const invcal_calibration *c, const invcal_real a[3][3],
                                       invcal_sums *sums, invcal_residuals *residuals)
{
    invcal_zero(residuals, sizeof *residuals);
    /* readings that pass the first pass may be absurd after it */
    return pass(positions, c, a, sums, residuals) == INVCAL_OK ? invcal_residuals_end(residuals)
                                                               : INVCAL_NOT_ELLIPSOID;
}

invcal_status invcal_positions_check(const invcal_positions *positions)
{
    if (!(positions->noise >= 0 && positions->noise < 1)) {
        return INVCAL_BAD_NOISE;
    }
    return positions->count < UINT16_MAX ? invcal_nominal_check(positions->nominal)
                                         : INVCAL_BAD_COUNT;
}

/* Used for both passes: even if undetermined in nominal units, the readings may look well spread
 * once calibrated by a solution made of rounding errors. */
invcal_status invcal_determine(invcal_real *a, unsigned rows, invcal_real k[INVCAL_PARAMETERS],
                               invcal_real *condition)
{
    const invcal_real trace = invcal_trace(a, INVCAL_PARAMETERS);
    invcal_real of_inverse = 0;
    const invcal_status status = invcal_factor(a, INVCAL_PARAMETERS, rows, INVCAL_FLOOR);

    if (status != INVCAL_OK) {
        return status;
    }
    if (rows > INVCAL_PARAMETERS) {
        invcal_back_substitute(a, INVCAL_PARAMETERS);
    }
    invcal_invert(a, INVCAL_PARAMETERS);
    INVCAL_ROLL
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) { /* A^-1 = L^-T L^-1 */
        k[r] = 0;
        INVCAL_ROLL
        for (unsigned c = 0; c <= r; c++) {
            k[c] += *a * *a;
            of_inverse += *a * *a;
            a++;
        }
    }
    *condition = trace * of_inverse;
    /* in float the first is the narrower, in double the second */
    return invcal_is_resolved(*condition) && of_inverse <= INVCAL_HOPELESS_K ? INVCAL_OK
                                                                             : INVCAL_UNDETERMINED;
}

/* ---- judgement ------------------------------------------------------------------------------- */

void invcal_judge_residuals(const invcal_residuals *residuals, invcal_quality *q)
{
    q->rms = residuals->rms;
    q->max = residuals->max;
    q->worst = (uint16_t)residuals->worst;
    q->positions = (uint16_t)residuals->count;
}

/* By how many standard deviations residuals exceed a noise: the root of 2 chi squared is nearly
 * normal about that of 2 dof - 1 (Fisher). 0 if there is nothing to compare; NaN if stated is. */
static INVCAL_NOINLINE invcal_real excess(invcal_real stated, invcal_real squares, invcal_real dof)
{
    const invcal_real known = stated * stated;

    if (known <= 0 || dof < 1) {
        return 0;
    }
    return INVCAL_SQRT(2 * squares / known) - INVCAL_SQRT(2 * dof - 1);
}

/* sigma_J^2 = (4 stated^2 + Q) / (4 + dof), or Q / dof: mathematics.md, "Uncertainty". */
void invcal_judge_noise(invcal_real stated, invcal_real squares, invcal_real dof, invcal_quality *q)
{
    const invcal_real above = excess(stated, squares, dof);
    const unsigned weight = stated > 0 && above <= LIKELY ? INVCAL_STATED : 0;
    const invcal_real share = invcal_number(weight);

    if (!(above <= POSSIBLE)) {
        invcal_raise(q, INVCAL_ROUGH);
    }
    q->sigma_dof = (uint16_t)(q->dof + weight);
    q->noise = 1; /* unknown: the whole field, which cannot pass for good */
    if (q->sigma_dof > 0) {
        q->noise = INVCAL_SQRT((share * stated * stated + squares) / (share + dof));
    }
}

/* A stated noise does not count if the residuals are nearly zero against it. With a prior, weighed
 * by it, the residuals do not matter. */
void invcal_weigh_noise(invcal_real stated, invcal_real squares, invcal_quality *quality)
{
    const invcal_real dof = invcal_number(quality->dof);
    const int is_silent = excess(stated, squares, dof) < SILENT;

    invcal_judge_noise(is_silent ? 0 : stated, squares, dof, quality);
}

void invcal_judge_parameters(const invcal_real k[INVCAL_PARAMETERS], const invcal_real a[3][3],
                             invcal_quality *q)
{
    /* in calibrated units: |A eta| times that of u, here the mean square over all directions */
    const invcal_real square = q->noise * q->noise * invcal_dot(a[0], a[0], 9) / 3;
    const invcal_real of_noise = invcal_number(q->positions) * square;
    invcal_real most = INVCAL_WEAK_K;
    unsigned weak = 0;

    if (q->noise < 1 && most * of_noise > NOISE_SHARE) {
        most = NOISE_SHARE / of_noise;
    }
    INVCAL_ROLL
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (!(k[r] <= most)) {
            weak |= 1u << r;
        }
        q->sigma[r] = q->noise * INVCAL_SQRT(k[r]);
    }
    q->weak = (uint16_t)weak;
    invcal_raise(q, weak > 0 ? INVCAL_WEAK : q->dof > 0 ? INVCAL_GOOD : INVCAL_NO_REDUNDANCY);
}

/* tr A^-1: the squares of all elements of L^-1. */
invcal_real invcal_condition(const invcal_real *inverse, unsigned n, invcal_real trace)
{
    return trace * invcal_dot(inverse, inverse, INVCAL_PACKED_SIZE(n));
}

/* ---- all in one ------------------------------------------------------------------------------ */

/* triad: what calibrates u. */
static INVCAL_ONCE invcal_status solve(const invcal_positions *positions, invcal_sums *sums,
                                       invcal_calibration *triad)
{
    invcal_real condition;

    invcal_status status = invcal_positions_sum(positions, sums);
    if (status == INVCAL_OK && sums->count < INVCAL_PARAMETERS) {
        status = INVCAL_TOO_FEW;
    }
    if (status == INVCAL_OK) {
        invcal_real k[INVCAL_PARAMETERS];
        status = invcal_determine(sums->sum, INVCAL_PARAMETERS + 1, k, &condition);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_real *a = sums->sum;
    status = invcal_ellipsoid(&a[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], a, triad);
    /* an open direction may take any shape */
    return status != INVCAL_OK && condition > OPEN ? INVCAL_UNDETERMINED : status;
}

/* Not inline: its caller needs the stack for more tests. */
INVCAL_NOINLINE invcal_status invcal_positions_calibrate(const invcal_positions *positions,
                                                         invcal_calibration *out,
                                                         invcal_quality *quality)
{
    invcal_calibration triad;
    const invcal_real(*a)[3] = (const invcal_real(*)[3])triad.matrix;
    invcal_calibration c;
    invcal_residuals residuals;
    invcal_sums sums;
    invcal_real k[INVCAL_PARAMETERS];
    invcal_real condition;

    invcal_status status = invcal_positions_check(positions);
    if (status == INVCAL_OK) {
        status = solve(positions, &sums, &triad);
    }
    if (status == INVCAL_OK) {
        c = triad;
        status = invcal_compose(positions->nominal, &c);
    }
    if (status == INVCAL_OK) {
        status = invcal_positions_compare(positions, &c, a, &sums, &residuals);
    }
    if (status == INVCAL_OK) {
        status = invcal_determine(sums.sum, INVCAL_PARAMETERS, k, &condition);
    }
    if (status == INVCAL_OK) {
        *out = c; /* which may be nominal */
        invcal_judge_begin(quality);
        quality->left_out = positions->left_out;
        quality->condition = condition;
        quality->dof = (uint16_t)(residuals.count - INVCAL_PARAMETERS);
        invcal_judge_residuals(&residuals, quality);
        invcal_weigh_noise(positions->noise,
                           sums.sum[INVCAL_PACKED(INVCAL_PARAMETERS, INVCAL_PARAMETERS)], quality);
        invcal_judge_parameters(k, a, quality);
    }
    return status;
}

invcal_status invcal_calibrate_without(const invcal_real *raw, unsigned count, invcal_mask left_out,
                                       const invcal_calibration *nominal, invcal_real noise,
                                       invcal_calibration *out, invcal_quality *quality)
{
    const invcal_positions positions = {raw, count, left_out, nominal, noise};

    INVCAL_ASSERT((raw || count == 0) && nominal && out && quality);
    return invcal_positions_calibrate(&positions, out, quality);
}
