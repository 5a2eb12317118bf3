/* SPDX-License-Identifier: MIT */
#include "fit/fit_extended.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/result.h"
#include "maths/matrix.h"
#include "calibrate/judge.h"
#include "core/sums.h"
#include "core/system.h"

enum { NINE = INVCAL_PARAMETERS, UNKNOWNS_MAX = NINE + 3 * FIT_EXTENDED_KINDS, PASSES = 8 };

typedef struct {
    const fit_extension *extension;
    unsigned unknowns;
    unsigned count;
    const fit_settings *settings;
    double *corrected;    /* the readings without the additional errors */
    double inverse[3][3]; /* of the nominal matrix: input units per unit of the field */
} work;

/* The derivatives of J of a reading with respect to all unknowns, over its noise: a row of the
 * linear problem. */
static void row_of(const work *w, const fit_solution *s, unsigned i, double row[UNKNOWNS_MAX + 1])
{
    invcali_row observed;
    double g[3];

    (void)invcali_observe(&s->symmetric, &w->corrected[3 * (size_t)i],
                          &observed); /* as the fit did */
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
    row[w->unknowns] = scale * observed.h[INVCAL_J];
}

/* Solves the normal equations of the first n unknowns, with J as the last column. a: L^-1 and the
 * solution. */
static int solve_linear(const work *w, const fit_solution *s, unsigned n,
                        double a[INVCAL_PACKED_SIZE(UNKNOWNS_MAX + 1)])
{
    double row[UNKNOWNS_MAX + 1];

    memset(a, 0, INVCAL_PACKED_SIZE(UNKNOWNS_MAX + 1) * sizeof *a);
    for (unsigned i = 0; i < w->count; i++) {
        row_of(w, s, i, row);
        row[n] = row[w->unknowns];
        for (unsigned r = 0; r <= n; r++) {
            for (unsigned c = 0; c <= r; c++) {
                a[INVCAL_PACKED(r, c)] += row[r] * row[c];
            }
        }
    }
    if (invcali_factor(a, n, n + 1, INVCAL_FLOOR) != INVCAL_OK) {
        return 0;
    }
    invcali_back_substitute(a, n);
    invcali_invert(a, n);
    return 1;
}

/* Subtracts the errors found so far from the readings: e_a = sum of extra times value, at the
 * calibrated directions. */
static void correct(const work *w, const double *raw, const fit_solution *s, const double *extra)
{
    for (unsigned i = 0; i < w->count; i++) {
        double *out = &w->corrected[3 * (size_t)i];
        double eta[3];
        double error[3] = {0, 0, 0};
        invcal_apply(&s->symmetric, out[0], out[1], out[2], eta);
        for (unsigned e = 0; e < w->unknowns - NINE; e++) {
            error[e % 3] += extra[e] * w->extension->value(w->extension, i, e / 3, eta[e % 3]);
        }
        for (unsigned a = 0; a < 3; a++) {
            const double *n = w->inverse[a];
            out[a] = raw[3 * (size_t)i + a] - (n[0] * error[0] + n[1] * error[1] + n[2] * error[2]);
        }
    }
}

/* Estimates the noise again, with the degrees of freedom that the additional unknowns leave.
 * Returns its ratio to the noise before. */
static double reweigh_noise(double stated, double sensitivity, unsigned extra, fit_quality *q)
{
    const double before = q->noise / sensitivity;
    const double squares_before = before * before * q->sigma_dof;
    const double squares = fmax(squares_before - stated * stated * (q->sigma_dof - q->dof), 0);
    invcal_quality reduced = {.verdict = q->verdict, .dof = (uint16_t)(q->dof - extra)};

    invcali_weigh_noise(stated, squares, &reduced);
    q->verdict = reduced.verdict;
    q->noise = sensitivity * reduced.noise;
    q->dof = reduced.dof;
    q->sigma_dof = reduced.sigma_dof;
    q->coverage = invcal_coverage(reduced.sigma_dof);
    return reduced.noise / before;
}

/* The additional unknowns increase sigma of the nine, too. */
static void widen(const work *w, const fit_solution *s, const double *nine, const double *all,
                  fit_quality *q, double *sigma)
{
    const double sensitivity = fit_sensitivity(&s->symmetric, &w->settings->nominal);
    const double noise_ratio =
        reweigh_noise(w->settings->noise, sensitivity, w->unknowns - NINE, q);

    for (unsigned r = 0; r < NINE; r++) {
        const double factor =
            sqrt(invcali_variance(all, w->unknowns, r) / invcali_variance(nine, NINE, r)) *
            noise_ratio;
        q->sigma[r] *= factor;
        if (r < 3) {
            q->sigma_offset[r] *= factor;
        }
    }
    for (unsigned e = 0; e < w->unknowns - NINE; e++) {
        sigma[e] = q->noise / sensitivity * sqrt(invcali_variance(all, w->unknowns, NINE + e));
    }
}

static invcal_status solve(const work *w, const double *raw, fit_solution *s, fit_quality *q,
                           double *extra, double *sigma)
{
    double nine[INVCAL_PACKED_SIZE(UNKNOWNS_MAX + 1)];
    double all[INVCAL_PACKED_SIZE(UNKNOWNS_MAX + 1)];

    for (unsigned pass = 0;; pass++) {
        const invcal_status status = fit_make(w->corrected, w->count, w->settings, s, q, NULL);
        if (status != INVCAL_OK) {
            return status;
        }
        if (!solve_linear(w, s, w->unknowns, all) || !solve_linear(w, s, NINE, nine)) {
            return INVCAL_UNDETERMINED;
        }
        if (pass == PASSES) {
            widen(w, s, nine, all, q, sigma);
            return INVCAL_OK;
        }
        for (unsigned e = 0; e < w->unknowns - NINE; e++) {
            extra[e] -= all[INVCAL_PACKED(w->unknowns, NINE + e)];
        }
        correct(w, raw, s, extra);
    }
}

invcal_status fit_extended_make(const double *raw, unsigned count, const fit_settings *settings,
                                const fit_extension *extension, fit_solution *solution,
                                fit_quality *quality, double *extra, double *sigma)
{
    work w = {.extension = extension,
              .unknowns = NINE + 3 * extension->kinds,
              .count = count,
              .settings = settings};
    double found[2][3 * FIT_EXTENDED_KINDS] = {{0}};
    fit_solution s;
    fit_quality q;
    invcal_status status = INVCAL_TOO_FEW;

    w.corrected = malloc((3 * (size_t)count + 1) * sizeof *w.corrected);
    if (w.corrected && count >= w.unknowns + FIT_EXTENDED_REDUNDANT &&
        matrix_inverse(&settings->nominal, w.inverse)) {
        memcpy(w.corrected, raw, 3 * (size_t)count * sizeof *raw);
        status = solve(&w, raw, &s, &q, found[0], found[1]);
    }
    free(w.corrected);
    if (status == INVCAL_OK) {
        *solution = s;
        *quality = q;
        memcpy(extra, found[0], (w.unknowns - NINE) * sizeof *extra);
        memcpy(sigma, found[1], (w.unknowns - NINE) * sizeof *sigma);
    }
    return status;
}
