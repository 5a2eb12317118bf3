/* SPDX-License-Identifier: MIT
 *
 * The noise model of an Allan deviation, and the dwell for a target sigma (mathematics_programs.md,
 * "How long to stay"). adev^2 is linear in N^2, B^2, K^2, so least squares finds them. None may be
 * negative: with three kinds there are only seven sets, so all are tried, and no method for
 * inequalities is needed.
 */
#include "noise.h"

#include "../core/sums.h"

enum { KINDS = INVCAL_NOISE_KINDS, ALL = (1 << INVCAL_NOISE_KINDS) - 1 };

/* Those of the fit: mathematics_programs.md, "How long to stay". */
#define FLICKER INVCAL_REAL(0.44127120030530317) /* 2 ln 2 / pi */
#define FLOOR_MARGIN INVCAL_REAL(0.1025)         /* 1.05^2 - 1 */
#define EDF_MIN 5                                /* with fewer, chance has too long a tail */
#define MODEL_VARIANCE INVCAL_REAL(0.0025)       /* variance of the model itself, relative: 5 % */
#define ROUNDS 8                                 /* of reweighting: within 0.3 % of convergence */
#define VISIBLE (INVCAL_REAL(1.0) / 3)           /* relative standard deviation of a term */
#define CORRELATED 2 /* factor on that of slow noise, which correlates neighbouring tau */
#define POOR_FIT 2   /* misfit; above: not by chance */

/* adev^2(tau) = N^2 / tau + (2 ln 2 / pi) B^2 + K^2 tau / 3: the factors of the squares. */
static void shares(invcal_real tau, invcal_real of[KINDS])
{
    of[INVCAL_NOISE_WHITE] = 1 / tau;
    of[INVCAL_NOISE_INSTABILITY] = FLICKER;
    of[INVCAL_NOISE_WALK] = tau / 3;
}

static int has_no_negative(const invcal_real x[KINDS])
{
    return x[0] >= 0 && x[1] >= 0 && x[2] >= 0;
}

/* ---- the noise model ------------------------------------------------------------------------- */

/* The usable averaging times. */
typedef struct {
    unsigned count;
    invcal_allan_point first, lowest, last;
    invcal_real tau[INVCAL_ALLAN_TAUS];      /* over that of the first */
    invcal_real variance[INVCAL_ALLAN_TAUS]; /* adev^2, over that of the first */
    invcal_real weight[INVCAL_ALLAN_TAUS];   /* of variance / model */
} curve;

/* A model of it: the squares of N, B, K, and their relative standard deviations. */
typedef struct {
    invcal_real square[KINDS];
    invcal_real relative[KINDS];
    unsigned kinds; /* those present */
} mixture;

/* Its normal equations, packed, then right side and constant (expert.h), in units that make the
 * diagonal 1. */
typedef struct {
    invcal_real a[INVCAL_PACKED_SIZE(KINDS + 1)];
    invcal_real unit[KINDS + 1];
} equations;

static void collect(const invcal_allan *a, curve *c)
{
    invcal_allan_point p;

    invcali_zero(c, sizeof *c);
    invcali_zero(&p, sizeof p);
    //@ loop unroll INVCAL_ALLAN_TAUS;
    for (unsigned k = 0; k < a->taus; k++) {
        if (invcal_allan_get(a, k, &p) != INVCAL_OK || !(p.edf >= EDF_MIN) || !(p.adev > 0)) {
            continue;
        }
        if (c->count == 0) {
            c->first = p;
        }
        if (c->count == 0 || p.adev < c->lowest.adev) {
            c->lowest = p;
        }
        c->last = p;
        const invcal_real ratio = p.adev / c->first.adev;
        c->tau[c->count] = (invcal_real)p.m / (invcal_real)c->first.m;
        c->variance[c->count] = ratio * ratio;
        c->weight[c->count] = 1 / (2 / p.edf + MODEL_VARIANCE);
        c->count++;
    }
}

/* adev^2 of the model at averaging time k, as measured if there is no model; and its shares. */
static invcal_real model(const curve *c, const mixture *x, unsigned k, invcal_real of[KINDS])
{
    shares(c->tau[k], of);
    return x->kinds ? invcali_dot(x->square, of, KINDS) : c->variance[k];
}

/* Normal equations of variance / model = sum of square (share / model): variances scatter in
 * proportion to what they estimate, so the model, not the measured curve, must weigh them. */
static void sum_curve(const curve *c, const mixture *x, equations *e)
{
    invcal_real row[KINDS + 1];

    invcali_zero(e->a, sizeof e->a);
    for (unsigned k = 0; k < c->count; k++) {
        const invcal_real scale = 1 / model(c, x, k, row);
        row[KINDS] = -c->variance[k];
        for (unsigned i = 0; i <= KINDS; i++) {
            row[i] *= scale;
        }
        invcali_rank_one(e->a, row, KINDS + 1, c->weight[k]);
    }
    invcal_real *a = e->a;
    for (unsigned i = 0; i <= KINDS; i++) {
        e->unit[i] = i < KINDS ? 1 / INVCAL_SQRT(a[i]) : 1;
        for (unsigned j = 0; j <= i; j++) {
            *a++ *= e->unit[i] * e->unit[j];
        }
    }
}

/* The equations without some kinds: their squares become 0. */
static void leave_out(const equations *e, unsigned kinds, invcal_real *a)
{
    const invcal_real *from = e->a;

    for (unsigned i = 0; i <= KINDS; i++) {
        for (unsigned j = 0; j <= i; j++) {
            *a++ = i == j || ((kinds >> i | kinds >> j) & 1u) == 0 ? *from : 0;
            from++;
        }
    }
}

/* The solution for one set of kinds becomes the best model so far, if it is determined, no square
 * is negative, and its residual sum of squares is below `min` by more than rounding. */
static void try_set(const equations *e, unsigned kinds, invcal_real *min, mixture *best)
{
    const invcal_real rounding = 8 * INVCAL_EPSILON * e->a[INVCAL_PACKED(KINDS, KINDS)];
    invcal_real a[INVCAL_PACKED_SIZE(KINDS + 1)];
    const invcal_real *x = &a[INVCAL_PACKED(KINDS, 0)];
    const invcal_real *left = &a[INVCAL_PACKED(KINDS, KINDS)];

    leave_out(e, ALL & ~kinds, a);
    if (invcali_factor(a, KINDS, KINDS + 1, INVCAL_FLOOR) != INVCAL_OK ||
        !(*left < *min - rounding)) {
        return;
    }
    invcali_back_substitute(a, KINDS);
    if (!has_no_negative(x)) {
        return;
    }
    *min = *left;
    invcali_invert(a, KINDS);
    best->kinds = kinds;
    for (unsigned i = 0; i < KINDS; i++) {
        const invcal_real sigma = INVCAL_SQRT(invcali_variance(a, KINDS, i));
        best->square[i] = x[i] * e->unit[i];
        best->relative[i] =
            x[i] > 0 ? (i == INVCAL_NOISE_WHITE ? 1 : CORRELATED) * sigma / x[i] : 0;
    }
}

/* The best set of kinds within those allowed: least squares without a negative square, iteratively
 * reweighted by the model from x on. */
static void fit_model(const curve *c, unsigned allowed, mixture *x)
{
    equations e;

    for (unsigned step = 0; step < ROUNDS; step++) {
        sum_curve(c, x, &e);
        invcal_real min = e.a[INVCAL_PACKED(KINDS, KINDS)];
        invcali_zero(x, sizeof *x);
        for (unsigned kinds = 1; kinds <= ALL; kinds++) {
            if ((kinds & ~allowed) == 0) {
                try_set(&e, kinds, &min, x);
            }
        }
    }
}

/* The least significant kind, if it is not significant; else KINDS. */
static unsigned hidden_kind(const mixture *x)
{
    invcal_real most = VISIBLE;
    unsigned which = KINDS;

    for (unsigned i = 0; i < KINDS; i++) {
        if (x->relative[i] > most) {
            most = x->relative[i];
            which = i;
        }
    }
    return which;
}

static invcal_real misfit(const curve *c, const mixture *x)
{
    invcal_real sum = 0;
    invcal_real of[KINDS];

    for (unsigned k = 0; k < c->count; k++) {
        const invcal_real d = c->variance[k] / model(c, x, k, of) - 1;
        sum += c->weight[k] * d * d;
    }
    return INVCAL_SQRT(sum / (invcal_real)c->count);
}

/* Drops insignificant kinds, one by one, as long as the others explain the curve. The fit without
 * one begins at the weights of the fit with it. */
static void fit_visible(const curve *c, mixture *x)
{
    mixture fewer;

    invcali_zero(x, sizeof *x);
    fit_model(c, ALL, x);
    for (unsigned i = hidden_kind(x); i < KINDS; i = hidden_kind(x)) { /* at most KINDS */
        fewer = *x;
        fit_model(c, x->kinds & ~(1u << i), &fewer);
        const invcal_real after = misfit(c, &fewer);
        if (after > POOR_FIT && after > 2 * misfit(c, x)) {
            return;
        }
        *x = fewer;
    }
}

invcal_status invcal_allan_solve(const invcal_allan *allan, invcal_real rate, invcal_noise *out)
{
    curve c;
    mixture x;
    invcal_noise n;

    INVCAL_ASSERT(allan && out);
    if (allan->taus == 0) {
        return INVCAL_NOT_BEGUN;
    }
    if (!invcali_is_positive(rate)) {
        return INVCAL_BAD_RATE;
    }
    collect(allan, &c);
    fit_visible(&c, &x);
    if (x.kinds == 0) {
        return INVCAL_TOO_FEW;
    }
    n.shortest = (invcal_real)c.first.m / rate;
    n.longest = (invcal_real)c.last.m / rate;
    n.best = (invcal_real)c.lowest.m / rate;
    n.minimum = c.lowest.adev;
    n.misfit = misfit(&c, &x);
    n.visible = x.kinds;
    const invcal_real unit[KINDS] = {n.shortest, 1,
                                     1 / n.shortest}; /* tau was relative to shortest */
    for (unsigned i = 0; i < KINDS; i++) {
        n.coefficient[i] = c.first.adev * INVCAL_SQRT(x.square[i] * unit[i]);
        n.relative[i] = x.relative[i] / 2; /* of the root: half that of the square */
    }
    if (!invcali_are_finite(n.coefficient) || !invcali_is_finite(n.longest)) {
        return INVCAL_BAD_RATE;
    }
    *out = n;
    return INVCAL_OK;
}

/* ---- how long to stay ------------------------------------------------------------------------ */

invcal_real invcali_noise_sigma(const invcal_noise *noise, invcal_real tau)
{
    invcal_real of[KINDS];
    invcal_real sum = 0;

    INVCAL_ASSERT(noise);
    shares(tau, of);
    for (unsigned i = 0; i < KINDS; i++) {
        sum += noise->coefficient[i] * noise->coefficient[i] * of[i];
    }
    return INVCAL_SQRT(sum);
}

/* Where a / T + b + c T = 1, in units of the target variance: the smaller root of
 * c T^2 - (1 - b) T + a, or, if there is none, the minimum: sqrt(a / c), or without random walk 5 %
 * above the floor. The root is in the form that does not cancel, and allows c = 0. */
static invcal_real time_of(const invcal_noise *noise, invcal_real sigma)
{
    invcal_real term[KINDS];

    shares(1, term);
    for (unsigned i = 0; i < KINDS; i++) {
        const invcal_real ratio = noise->coefficient[i] / sigma;
        term[i] *= ratio * ratio;
    }
    const invcal_real a = term[INVCAL_NOISE_WHITE];
    const invcal_real b = term[INVCAL_NOISE_INSTABILITY];
    const invcal_real c = term[INVCAL_NOISE_WALK];
    const invcal_real left = 1 - b;
    const invcal_real square = left * left - 4 * a * c;
    if (left > 0 && square >= 0) {
        return 2 * a / (left + INVCAL_SQRT(square));
    }
    return c > 0 ? INVCAL_SQRT(a / c) : a / (FLOOR_MARGIN * b);
}

invcal_status invcal_noise_dwell(const invcal_noise *noise, invcal_real sigma, invcal_dwell *out)
{
    INVCAL_ASSERT(noise && out);
    if (!invcali_is_positive(sigma) || !has_no_negative(noise->coefficient)) {
        return INVCAL_BAD_NOISE;
    }
    const invcal_real wanted = time_of(noise, sigma);
    const invcal_real seconds = wanted <= noise->shortest ? noise->shortest : wanted;
    const invcal_real reached = invcali_noise_sigma(noise, seconds);
    if (!invcali_is_positive(seconds) || !invcali_is_positive(reached)) {
        return INVCAL_BAD_NOISE;
    }
    out->seconds = seconds;
    out->sigma = reached;
    out->end = reached > sigma * (1 + 16 * INVCAL_EPSILON) ? INVCAL_DWELL_FLOOR
               : seconds <= noise->longest                 ? INVCAL_DWELL_REACHED
                                                           : INVCAL_DWELL_BEYOND;
    return INVCAL_OK;
}
