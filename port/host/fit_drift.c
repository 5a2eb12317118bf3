/* SPDX-License-Identifier: MIT */
#include "fit_drift.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"

enum { NINE = INVCAL_PARAMETERS, ALL = NINE + 3, PASSES = 4 };

typedef struct {
    const double *tau;
    unsigned count;
    const fit_settings *settings;
    double *level;        /* the readings without drift */
    double inverse[3][3]; /* of the nominal matrix: input units per unit of the field */
} work;

/* How the parameters and the drift move J of a reading, over its noise: a row of the linear problem. */
static void row_of(const work *w, const fit_solution *s, unsigned i, double row[ALL + 1])
{
    invcal_row observed;
    double g[3];

    (void)invcal_observe(&s->symmetric, &w->level[3 * (size_t)i], &observed); /* as the fit did */
    const double *eta = observed.h;
    for (unsigned a = 0; a < 3; a++) { /* g = A eta, A = M N^-1 */
        g[a] = 0;
        for (unsigned b = 0; b < 3; b++) {
            for (unsigned c = 0; c < 3; c++) {
                g[a] += s->symmetric.matrix[a][b] * w->inverse[b][c] * eta[c];
            }
        }
    }
    const double scale = 1 / sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    for (unsigned a = 0; a < 3; a++) {
        row[a] = scale * g[a];
        row[3 + a] = scale * g[a] * eta[a];
        row[NINE + a] = scale * g[a] * w->tau[i];
    }
    row[6] = scale * (g[0] * eta[1] + g[1] * eta[0]) / 2;
    row[7] = scale * (g[0] * eta[2] + g[2] * eta[0]) / 2;
    row[8] = scale * (g[2] * eta[1] + g[1] * eta[2]) / 2;
    row[ALL] = scale * observed.h[INVCAL_J];
}

/* The normal equations of the first n unknowns, and J behind them; then L^-1 with the solution. */
static int solve_linear(const work *w, const fit_solution *s, unsigned n,
                        double a[INVCAL_PACKED_SIZE(ALL + 1)])
{
    double row[ALL + 1];

    memset(a, 0, INVCAL_PACKED_SIZE(ALL + 1) * sizeof *a);
    for (unsigned i = 0; i < w->count; i++) {
        row_of(w, s, i, row);
        row[n] = row[ALL];
        for (unsigned r = 0; r <= n; r++) {
            for (unsigned c = 0; c <= r; c++) {
                a[INVCAL_PACKED(r, c)] += row[r] * row[c];
            }
        }
    }
    if (invcal_factor(a, n, n + 1, INVCAL_FLOOR) != INVCAL_OK) {
        return 0;
    }
    invcal_back_substitute(a, n);
    invcal_invert(a, n);
    return 1;
}

/* Takes the drift found so far from the readings. */
static void level(const work *w, const double *raw, const double drift[3])
{
    for (unsigned i = 0; i < w->count; i++) {
        for (unsigned a = 0; a < 3; a++) {
            const double *n = w->inverse[a];
            w->level[3 * (size_t)i + a] =
                raw[3 * (size_t)i + a] -
                w->tau[i] * (n[0] * drift[0] + n[1] * drift[1] + n[2] * drift[2]);
        }
    }
}

/* Judges the noise again, by the library's rule (mathematics.md, "Uncertainty"): of the degrees of freedom that
 * it saw, the drift took three. Returns how many times as large the noise is that comes of it. */
static double judge_noise(double stated, double sensitivity, fit_quality *q)
{
    const double was = q->noise / sensitivity;
    const double squares = was * was * q->sigma_dof - stated * stated * (q->sigma_dof - q->dof);
    const double dof = q->dof - 3;
    const double above = stated > 0 ? sqrt(2 * squares) / stated - sqrt(2 * dof - 1) : 0;
    const double share = stated > 0 && -2.8 <= above && above <= 1.73 ? 4 : 0;
    const double noise = sqrt((share * stated * stated + squares) / (share + dof));

    if (!(above <= 3) && q->verdict < INVCAL_ROUGH) {
        q->verdict = INVCAL_ROUGH;
    }
    q->noise = sensitivity * noise;
    q->dof = dof;
    q->sigma_dof = share + dof;
    q->coverage = invcal_coverage((unsigned)q->sigma_dof);
    return noise / was;
}

/* The nine lose certainty to the drift, too. */
static void widen(const work *w, const fit_solution *s, const double *nine, const double *twelve,
                  fit_quality *q, double sigma[3])
{
    const double usual = fit_sensitivity(&s->symmetric, &w->settings->nominal);
    const double times = judge_noise(w->settings->noise, usual, q);

    for (unsigned r = 0; r < NINE; r++) {
        const double grown =
            sqrt(invcal_variance(twelve, ALL, r) / invcal_variance(nine, NINE, r)) * times;
        q->sigma[r] *= grown;
        if (r < 3) {
            q->sigma_offset[r] *= grown;
            sigma[r] = q->noise / usual * sqrt(invcal_variance(twelve, ALL, NINE + r));
        }
    }
}

static invcal_status solve(const work *w, const double *raw, fit_solution *s, fit_quality *q,
                           double drift[3], double sigma[3])
{
    double nine[INVCAL_PACKED_SIZE(ALL + 1)];
    double twelve[INVCAL_PACKED_SIZE(ALL + 1)];

    for (unsigned pass = 0;; pass++) {
        level(w, raw, drift);
        const invcal_status status = fit_make(w->level, w->count, w->settings, s, q, NULL);
        if (status != INVCAL_OK) {
            return status;
        }
        if (!solve_linear(w, s, ALL, twelve) || !solve_linear(w, s, NINE, nine)) {
            return INVCAL_UNDETERMINED;
        }
        if (pass == PASSES) {
            widen(w, s, nine, twelve, q, sigma);
            return INVCAL_OK;
        }
        for (unsigned a = 0; a < 3; a++) {
            drift[a] -= twelve[INVCAL_PACKED(ALL, NINE + a)];
        }
    }
}

invcal_status fit_drift_make(const double *raw, const double *tau, unsigned count,
                             const fit_settings *settings, fit_solution *solution,
                             fit_quality *quality, double drift[3], double sigma[3])
{
    work w = {.tau = tau, .count = count, .settings = settings};
    double found[3] = {0, 0, 0};
    fit_solution s;
    fit_quality q;
    invcal_status status = INVCAL_TOO_FEW;

    w.level = malloc((3 * (size_t)count + 1) * sizeof *w.level);
    if (w.level && count >= FIT_DRIFT_FEWEST && matrix_inverse(&settings->nominal, w.inverse)) {
        status = solve(&w, raw, &s, &q, found, sigma);
    }
    free(w.level);
    if (status == INVCAL_OK) {
        *solution = s;
        *quality = q;
        memcpy(drift, found, sizeof found);
    }
    return status;
}
