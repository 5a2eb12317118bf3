/* SPDX-License-Identifier: MIT */
#include "fit/fit_extended.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "maths/matrix.h"

enum { NINE = INVCAL_PARAMETERS, MOST = NINE + 3 * FIT_EXTENDED_KINDS, PASSES = 8 };

typedef struct {
    const fit_extension *extension;
    unsigned all; /* unknowns */
    unsigned count;
    const fit_settings *settings;
    double *level;        /* the readings without the further errors */
    double inverse[3][3]; /* of the nominal matrix: input units per unit of the field */
} work;

/* How all unknowns move J of a reading, over its noise: a row of the linear problem. */
static void row_of(const work *w, const fit_solution *s, unsigned i, double row[MOST + 1])
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
        for (unsigned k = 0; k < w->extension->kinds; k++) {
            row[NINE + 3 * k + a] = scale * g[a] * w->extension->value(w->extension, i, k, eta[a]);
        }
    }
    row[6] = scale * (g[0] * eta[1] + g[1] * eta[0]) / 2;
    row[7] = scale * (g[0] * eta[2] + g[2] * eta[0]) / 2;
    row[8] = scale * (g[2] * eta[1] + g[1] * eta[2]) / 2;
    row[w->all] = scale * observed.h[INVCAL_J];
}

/* The normal equations of the first n unknowns, followed by J; then L^-1 with the solution. */
static int solve_linear(const work *w, const fit_solution *s, unsigned n,
                        double a[INVCAL_PACKED_SIZE(MOST + 1)])
{
    double row[MOST + 1];

    memset(a, 0, INVCAL_PACKED_SIZE(MOST + 1) * sizeof *a);
    for (unsigned i = 0; i < w->count; i++) {
        row_of(w, s, i, row);
        row[n] = row[w->all];
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

/* Takes what was found so far from the readings: e_a = sum of extra times value, at the direction that the
 * calibration makes of them. */
static void level(const work *w, const double *raw, const fit_solution *s, const double *extra)
{
    for (unsigned i = 0; i < w->count; i++) {
        double *out = &w->level[3 * (size_t)i];
        double eta[3];
        double error[3] = {0, 0, 0};
        invcal_apply(&s->symmetric, out, eta);
        for (unsigned e = 0; e < w->all - NINE; e++) {
            error[e % 3] += extra[e] * w->extension->value(w->extension, i, e / 3, eta[e % 3]);
        }
        for (unsigned a = 0; a < 3; a++) {
            const double *n = w->inverse[a];
            out[a] = raw[3 * (size_t)i + a] - (n[0] * error[0] + n[1] * error[1] + n[2] * error[2]);
        }
    }
}

/* Weighs the noise again: of the degrees of freedom that it saw, the others took theirs. Returns how many times
 * as large the noise is that comes of it. */
static double weigh_noise(double stated, double sensitivity, unsigned extra, fit_quality *q)
{
    const double was = q->noise / sensitivity;
    const double both = was * was * q->sigma_dof;
    const double squares = fmax(both - stated * stated * (q->sigma_dof - q->dof), 0);
    invcal_quality less = {.verdict = (uint8_t)q->verdict, .dof = (uint16_t)(q->dof - extra)};

    invcal_weigh_noise(stated, squares, &less);
    q->verdict = (invcal_verdict)less.verdict;
    q->noise = sensitivity * less.noise;
    q->dof = less.dof;
    q->sigma_dof = less.sigma_dof;
    q->coverage = invcal_coverage(less.sigma_dof);
    return less.noise / was;
}

/* The nine lose certainty to the others, too. */
static void widen(const work *w, const fit_solution *s, const double *nine, const double *all,
                  fit_quality *q, double *sigma)
{
    const double usual = fit_sensitivity(&s->symmetric, &w->settings->nominal);
    const double times = weigh_noise(w->settings->noise, usual, w->all - NINE, q);

    for (unsigned r = 0; r < NINE; r++) {
        const double grown =
            sqrt(invcal_variance(all, w->all, r) / invcal_variance(nine, NINE, r)) * times;
        q->sigma[r] *= grown;
        if (r < 3) {
            q->sigma_offset[r] *= grown;
        }
    }
    for (unsigned e = 0; e < w->all - NINE; e++) {
        sigma[e] = q->noise / usual * sqrt(invcal_variance(all, w->all, NINE + e));
    }
}

static invcal_status solve(const work *w, const double *raw, fit_solution *s, fit_quality *q,
                           double *extra, double *sigma)
{
    double nine[INVCAL_PACKED_SIZE(MOST + 1)];
    double all[INVCAL_PACKED_SIZE(MOST + 1)];

    for (unsigned pass = 0;; pass++) {
        const invcal_status status = fit_make(w->level, w->count, w->settings, s, q, NULL);
        if (status != INVCAL_OK) {
            return status;
        }
        if (!solve_linear(w, s, w->all, all) || !solve_linear(w, s, NINE, nine)) {
            return INVCAL_UNDETERMINED;
        }
        if (pass == PASSES) {
            widen(w, s, nine, all, q, sigma);
            return INVCAL_OK;
        }
        for (unsigned e = 0; e < w->all - NINE; e++) {
            extra[e] -= all[INVCAL_PACKED(w->all, NINE + e)];
        }
        level(w, raw, s, extra);
    }
}

invcal_status fit_extended_make(const double *raw, unsigned count, const fit_settings *settings,
                                const fit_extension *extension, fit_solution *solution,
                                fit_quality *quality, double *extra, double *sigma)
{
    work w = {.extension = extension,
              .all = NINE + 3 * extension->kinds,
              .count = count,
              .settings = settings};
    double found[2][3 * FIT_EXTENDED_KINDS] = {{0}};
    fit_solution s;
    fit_quality q;
    invcal_status status = INVCAL_TOO_FEW;

    w.level = malloc((3 * (size_t)count + 1) * sizeof *w.level);
    if (w.level && count >= w.all + FIT_EXTENDED_SPARE &&
        matrix_inverse(&settings->nominal, w.inverse)) {
        memcpy(w.level, raw, 3 * (size_t)count * sizeof *raw);
        status = solve(&w, raw, &s, &q, found[0], found[1]);
    }
    free(w.level);
    if (status == INVCAL_OK) {
        *solution = s;
        *quality = q;
        memcpy(extra, found[0], (w.all - NINE) * sizeof *extra);
        memcpy(sigma, found[1], (w.all - NINE) * sizeof *sigma);
    }
    return status;
}
