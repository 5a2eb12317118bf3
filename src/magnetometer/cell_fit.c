/* SPDX-License-Identifier: MIT
 *
 * From cells to a calibration and its quality (mathematics_magnetometer.md, "From cells to
 * positions", "The effective number of samples", "Disturbances"). The ellipsoid comes from the mean
 * rows, which satisfy its equation exactly. Sigma and verdict are those of positions: so each cell
 * then becomes one, along its mean and with the root-mean-square length of its samples, and judge.c
 * solves these like any others.
 *
 * Order: coverage, the ellipsoid, the positions, then sigma from the scatter of the samples and the
 * test for a step.
 */
#include <string.h>

#include "cells.h"
#include "../calibrate/judge.h"
#include "../core/solve.h"
#include "../core/sums.h"
#include "../core/vector.h"

/* mathematics_magnetometer.md, "The effective number of samples" and, for a step,
 * "Disturbances". */
enum { POWER_DOF = 24 };               /* degrees of freedom of the power of samples */
#define CELLS_SCATTER INVCAL_REAL(3.0) /* ratio of variances: above, it is not chance */
#define STEP_CHI_SQUARE                                                                            \
    INVCAL_REAL(28.0) /* chi squared of 4, with a power known to a third; 18.5 if exact */
#define STEP_F INVCAL_REAL(160.0) /* 4 times F of 4 and n - 4, for cells with a common error */
enum { STEP_UNKNOWNS = 4, STEP_CELLS = 10 };

/* ---- what is covered ------------------------------------------------------------------------- */

unsigned invcali_cells_count(const invcali_cell_tables *tables, unsigned k)
{
    return (unsigned)tables->early->count[k] + tables->late->count[k];
}

/* The cosine of the angle from cell k to the nearest one with samples. */
static invcal_real nearest_covered(const invcali_cell_tables *tables, unsigned k)
{
    invcal_real nearest = -1;
    invcal_real d[3];
    invcal_real e[3];

    if (invcali_cells_count(tables, k) > 0) {
        return 1;
    }
    invcali_cell_direction(k, d);
    for (unsigned i = 0; i < INVCAL_CELLS; i++) {
        invcali_cell_direction(i, e);
        const invcal_real cosine = invcali_dot3(d, e);
        if (invcali_cells_count(tables, i) > 0 && cosine > nearest) {
            nearest = cosine;
        }
    }
    return nearest;
}

invcal_real invcali_cells_gap(const invcali_cell_tables *tables, unsigned *worst)
{
    invcal_real gap = nearest_covered(tables, 0);

    *worst = 0;
    for (unsigned k = 1; k < INVCAL_CELLS; k++) {
        const invcal_real nearest = nearest_covered(tables, k);
        if (nearest < gap || /* no cell has fewer than an empty one */
            invcali_cells_count(tables, k) < invcali_cells_count(tables, *worst)) {
            gap = nearest;
            *worst = k;
        }
    }
    return gap;
}

/* ---- the solution ---------------------------------------------------------------------------- */

/* Computes the mean row of cell k, and J. Returns the number of samples; if 0, h is lost. */
static unsigned mean_row(const invcali_cell_tables *tables, unsigned k,
                         invcal_real h[INVCAL_PARAMETERS + 1])
{
    const unsigned count = invcali_cells_count(tables, k);
    const invcal_real n = invcali_number(count);

    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        h[i] = (tables->early->sum[k][i] + tables->late->sum[k][i]) / n;
    }
    h[INVCAL_J] = (invcali_square_of(h) - 1) / 2;
    return count;
}

/* A system like invcal_sums; but in a sum over mean rows no two elements are the same: the mean of
 * xy, squared, is not the mean of x^2 times that of y^2. */
invcal_status invcali_cells_solve(invcali_cell_fit *fit)
{
    invcal_real a[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS + 1)];
    invcal_real h[INVCAL_PARAMETERS + 1];
    unsigned count = 0;

    invcali_zero(a, sizeof a);
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        if (mean_row(&fit->tables, k, h) > 0) {
            invcali_rank_one(a, h, INVCAL_PARAMETERS + 1, 1);
            count++;
        }
    }
    if (count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    const invcal_status status =
        invcali_factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_FLOOR);
    if (status != INVCAL_OK) {
        return status;
    }
    invcali_back_substitute(a, INVCAL_PARAMETERS);
    memcpy(fit->p, &a[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], sizeof fit->p);
    return invcali_ellipsoid(fit->p, a, &fit->triad);
}

/* For a mean row: eta = A (v - delta) of the mean, and the mean of |eta|^2, which is larger:
 * |eta|^2 + tr A C A', with C the products less those of the mean. */
static invcal_real mean_square(const invcal_calibration *triad,
                               const invcal_real h[INVCAL_PARAMETERS], invcal_real eta[3])
{
    invcal_real g[INVCAL_PARAMETERS];

    invcali_correct(triad, h, eta);
    invcal_real square = invcali_dot3(eta, eta);
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real *const a = triad->matrix[i];
        const invcal_real ahead = invcali_dot3(a, h);
        memcpy(g, a, 3 * sizeof *g);
        invcali_row_of(g);
        square += invcali_dot3(&g[INVCAL_DK_X], &h[INVCAL_DK_X]) +
                  2 * invcali_dot3(&g[INVCAL_GAMMA_XY], &h[INVCAL_GAMMA_XY]) - ahead * ahead;
    }
    return square;
}

unsigned invcali_cells_point(const invcali_cell_tables *tables, const invcal_calibration *triad,
                             unsigned k, invcal_real point[3])
{
    invcal_real h[INVCAL_PARAMETERS + 1];

    const unsigned count = mean_row(tables, k, h);
    if (count > 0) {
        invcal_real eta[3];
        const invcal_real square = mean_square(triad, h, eta);
        const invcal_real ratio = INVCAL_SQRT(square / invcali_dot3(eta, eta));
        for (unsigned j = 0; j < 3; j++) {
            point[j] = triad->offset[j] + ratio * (h[j] - triad->offset[j]);
        }
    }
    return count;
}

/* The positions of all cells that have samples. Returns their number. */
static unsigned make_points(const invcali_cell_fit *fit, invcal_vector point[INVCAL_CELLS])
{
    unsigned count = 0;

    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        count += invcali_cells_point(&fit->tables, &fit->triad, k, point[count].v) > 0;
    }
    return count;
}

invcal_status invcali_cells_calibrate(invcali_cell_fit *fit)
{
    static const invcal_calibration unit = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    invcal_vector point[INVCAL_CELLS];

    const invcal_status status = invcali_cells_solve(fit);
    if (status != INVCAL_OK) {
        return status;
    }
    invcali_zero(point, sizeof point);
    const invcali_selection all = {{point, make_points(fit, point), &unit, 0, NULL}, 0};
    return invcali_positions_calibrate(&all, &fit->triad, &fit->quality);
}

invcal_real invcali_cells_field(const invcali_cell_fit *fit)
{
    const invcal_real(*a)[3] = (const invcal_real(*)[3])fit->triad.matrix;

    return 3 / (a[0][0] + a[1][1] + a[2][2]);
}

/* ---- judgement ------------------------------------------------------------------------------- */

/* Combines the scatter of the samples, power / n of each cell, with that of the cells, weighted by
 * their degrees of freedom. If the latter is clearly larger, it stays alone: then cells differ by
 * more than their samples show. */
void invcali_cells_weigh(invcali_cell_fit *fit, invcal_real power)
{
    invcal_quality *const q = &fit->quality;
    const invcal_real seen = q->noise * q->noise;
    invcal_real expected = 0;

    for (unsigned i = 0; i < INVCAL_CELLS; i++) {
        const unsigned count = invcali_cells_count(&fit->tables, i);
        if (count > 0) {
            expected += power / (invcali_number(count) * invcali_number(q->positions));
        }
    }
    if (!(q->dof > 0 && seen > 0 && seen < CELLS_SCATTER * expected)) {
        return;
    }
    const invcal_real dof = invcali_number(q->dof);
    const invcal_real of_power = invcali_number(POWER_DOF);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        q->sigma[r] = q->sigma[r] * q->sigma[r] / seen; /* K */
    }
    q->noise = INVCAL_SQRT((dof * seen + of_power * expected) / (dof + of_power));
    q->sigma_dof = (uint16_t)(q->dof + POWER_DOF);
    q->verdict = INVCAL_GOOD;
    invcali_judge_parameters((const invcal_real(*)[3])fit->triad.matrix, q);
}

/* The row of cell k: (eta, 1, excess length of late samples), since an offset d moves the length by
 * eta d, and a change of field moves all lengths alike. Half the difference of squares is that of
 * lengths. Returns its weight, the number of samples that would give the same variance against an
 * exact length; 0 if early or late has none. */
static invcal_real compare_late(const invcali_cell_fit *fit, unsigned k, invcal_real row[5])
{
    const invcali_cell_tables early = {fit->tables.early, fit->tables.early};
    const invcali_cell_tables late = {fit->tables.late, fit->tables.late};
    const invcal_real n = invcali_number(early.early->count[k]);
    const invcal_real m = invcali_number(late.late->count[k]);
    invcal_real h[INVCAL_PARAMETERS + 1];

    if (!(n > 0 && m > 0)) {
        return 0;
    }
    (void)mean_row(&early, k, h);
    const invcal_real before = mean_square(&fit->triad, h, row);
    (void)mean_row(&late, k, h);
    row[STEP_UNKNOWNS] = (mean_square(&fit->triad, h, row) - before) / 2;
    row[3] = 1;
    return n * m / (n + m);
}

/* Compares the squares that a step explains with the power, and with the other differences of the
 * cells, since samples after a step raise the power. */
int invcali_cells_step(const invcali_cell_fit *fit, invcal_real power)
{
    invcal_real a[INVCAL_PACKED_SIZE(STEP_UNKNOWNS + 1)];
    invcal_real row[STEP_UNKNOWNS + 1];
    invcal_real total = 0;
    unsigned count = 0;

    invcali_zero(a, sizeof a);
    invcali_zero(row, sizeof row);
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        const invcal_real weight = compare_late(fit, k, row);
        if (weight > 0) {
            invcali_rank_one(a, row, STEP_UNKNOWNS + 1, weight);
            total += weight * row[STEP_UNKNOWNS] * row[STEP_UNKNOWNS];
            count++;
        }
    }
    if (!(power > 0) ||
        invcali_factor(a, STEP_UNKNOWNS, STEP_UNKNOWNS + 1, INVCAL_FLOOR) != INVCAL_OK) {
        return 0;
    }
    /* what factoring leaves of the constant: squares that no step explains */
    const invcal_real left = a[INVCAL_PACKED(STEP_UNKNOWNS, STEP_UNKNOWNS)];
    const invcal_real explained = total - left;
    return explained > STEP_CHI_SQUARE * power ||
           (count >= STEP_CELLS &&
            explained * invcali_number(count - STEP_UNKNOWNS) > STEP_F * left);
}
