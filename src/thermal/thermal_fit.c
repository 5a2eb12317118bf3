/* SPDX-License-Identifier: MIT
 *
 * Fits polynomials of temperature to positions (mathematics.md, "Temperature"). The exact row is
 * widened to h (x) (1 t t^2), and one system of 9 (degree + 1) unknowns solves for all coefficients
 * of p. But X, not p, is a polynomial: so p becomes X at the ends of the range (and in the middle),
 * the readings are calibrated by that, and a second solve is for the remainder, whose square is
 * negligible. Nothing has to converge.
 *
 * Order: the system; the solution, which falls back to a lower degree if slopes are open; the
 * judgement, with the steps of judge.c, at several temperatures; all in one.
 */
#include <stddef.h>
#include <string.h>

#include "../calibrate/judge.h"
#include "polynomials.h"
#include "../core/sums.h"
#include "../core/vector.h"

#define FARTHEST INVCAL_REAL(2.0)         /* |t| */
#define NARROWEST INVCAL_REAL(5.0)        /* K, for each degree */
#define NARROWEST_STEP INVCAL_REAL(0.125) /* of t, to a point of interpolation */

enum {
    DEGREE = INVCAL_THERMAL_DEGREE,
    NINE = INVCAL_PARAMETERS,
    UNKNOWNS = NINE * (DEGREE + 1) /* coefficient of t^a, parameter r: number 9 a + r */
};

/* The state of a fit. */
typedef struct {
    const invcal_positions *positions;
    const invcal_thermal *base; /* the mean of a prior */
    invcal_real noise;          /* the weight of a prior, over field */
    invcal_real held[UNKNOWNS]; /* 1 / standard deviation of the prior; 0: none */
    invcal_real widest;         /* the largest of these standard deviations; 0: no prior */
    int is_judged;              /* the rows are derivatives at the solution, not equations for it */
    invcal_real min, max;       /* temperatures */
    invcal_thermal now;         /* the current calibration, used for the rows */
    invcal_quality q;           /* its quality */
    invcal_real squares;        /* weighted, of the residuals */
    invcal_real largest;        /* on the diagonal of the system */
    /* The system of n = 9 (degree + 1) unknowns; solved: L^-1, and p in row n. */
    invcal_real a[INVCAL_PACKED_SIZE(UNKNOWNS + 1)];
} job;

const char *invcal_thermal_fallback_text(invcal_thermal_fallback fallback)
{
    return fallback == INVCAL_THERMAL_AS_ASKED ? "as asked"
           : fallback == INVCAL_THERMAL_FEW    ? "too few positions for slopes"
           : fallback == INVCAL_THERMAL_NARROW ? "too narrow a range of temperatures for slopes"
           : fallback == INVCAL_THERMAL_OPEN   ? "positions and temperatures leave slopes open"
                                               : "unknown reason";
}

/* ---- the system ------------------------------------------------------------------------------ */

/* The row (h, t h, t^2 h, j), and its products with itself. */
static void add_at(job *j, unsigned n, const invcali_row *row, invcal_real weight, invcal_real t)
{
    invcal_real wide[UNKNOWNS + 1];

    memcpy(wide, row->h, NINE * sizeof *wide);
    for (unsigned i = NINE; i < n; i++) {
        wide[i] = t * wide[i - NINE];
    }
    wide[n] = row->h[INVCAL_J];
    invcali_rank_one(j->a, wide, n + 1, weight);
}

/* All positions, with the current calibration: their equations, or, to judge, derivatives as in
 * judge.c. Both are weighted by the actual noise, 1 / |g|^2. */
static invcal_status gather(job *j, unsigned n)
{
    const invcal_positions *p = j->positions;
    invcal_calibration triad;
    invcal_real u[3];
    invcal_real g[NINE];
    invcali_row row;

    invcali_zero(j->a, sizeof j->a);
    j->q.rms = 0;
    j->q.max = 0;
    j->q.positions = 0;
    for (unsigned i = 0; i < p->count; i++) {
        const invcal_real t = invcali_thermal_scaled(&j->now, p->temperature[i]);
        invcali_correct(&j->now.nominal, p->mean[i].v, u);
        invcal_status status = invcali_thermal_triad(&j->now, t, &triad);
        if (status == INVCAL_OK) {
            status = invcali_observe(&triad, u, &row);
        }
        if (status != INVCAL_OK) {
            return status;
        }
        invcali_residuals_add(&j->q, i, &row);
        const invcal_real square =
            invcali_gradient((const invcal_real(*)[3])triad.matrix, row.h, g);
        if (j->is_judged) {
            invcali_products(row.h, g);
            memcpy(row.h, g, sizeof g);
        }
        add_at(j, n, &row, 1 / square, t);
    }
    return j->is_judged ? invcali_residuals_end(&j->q) : INVCAL_OK;
}

/* A coefficient known with a standard deviation is one more row, (noise / sigma) x = 0: it is 0 at
 * the base, and p is -x against the current calibration. */
static invcal_status solve_at_noise(job *j, unsigned n, invcal_real floor)
{
    const invcal_real *now = &j->now.x[0][0];
    const invcal_real *base = &j->base->x[0][0];

    invcal_status status = gather(j, n);
    if (status != INVCAL_OK) {
        return status;
    }
    j->squares = j->a[INVCAL_PACKED(n, n)];
    j->largest = invcali_largest_diagonal(j->a, n);
    for (unsigned i = 0; i < n; i++) {
        const invcal_real ratio = j->noise * j->held[i];
        j->a[INVCAL_PACKED(i, i)] += ratio * ratio;
        j->a[INVCAL_PACKED(n, i)] -= ratio * ratio * (now[i] - base[i]);
    }
    const invcal_real trace = invcali_trace(j->a, n);
    status = invcali_factor(j->a, n, n + 1, floor);
    if (status != INVCAL_OK) {
        return status;
    }
    invcali_back_substitute(j->a, n);
    invcali_invert(j->a, n);
    j->q.condition = invcali_condition(j->a, n, trace);
    return j->widest > 0 || invcali_is_resolved(j->q.condition) ? INVCAL_OK : INVCAL_UNDETERMINED;
}

/* If a prior must hold what the positions leave open, raises the noise until the prior just exceeds
 * rounding of the largest sums. */
static invcal_status solve_to(job *j, unsigned n)
{
    invcal_status status = solve_at_noise(j, n, j->widest > 0 ? 30 * INVCAL_FLOOR : INVCAL_FLOOR);

    if (status == INVCAL_UNDETERMINED && j->widest > 0) {
        const invcal_real resolved = j->widest * INVCAL_SQRT(4 * INVCAL_EPSILON * j->largest);
        j->noise = j->noise >= resolved ? j->noise : resolved;
        status = solve_at_noise(j, n, INVCAL_EPSILON);
    }
    return status;
}

/* ---- the solution ---------------------------------------------------------------------------- */

/* Number of coefficients, from this one on, that neither a prior nor, once solved, the positions
 * hold. */
static unsigned count_open(const job *j, unsigned from, unsigned n, int is_solved)
{
    unsigned count = 0;

    for (unsigned i = from; i < UNKNOWNS && i < n; i++) {
        count += !(j->held[i] > 0 || (is_solved && invcali_variance(j->a, n, i) <= INVCAL_WEAK_K));
    }
    return count;
}

/* The obstacle to a degree, before or after solving. */
static invcal_thermal_fallback try_degree(job *j, unsigned degree, invcal_status *status)
{
    const unsigned n = (degree + 1) * NINE;
    const invcal_real noise = j->noise;
    //@ split n;

    *status = INVCAL_TOO_FEW;
    if (j->positions->count < count_open(j, 0, n, 0)) {
        return INVCAL_THERMAL_FEW;
    }
    if (j->max - j->min < (invcal_real)degree * NARROWEST &&
        count_open(j, degree * NINE, n, 0) > 0) {
        return INVCAL_THERMAL_NARROW;
    }
    *status = solve_to(j, n);
    if (*status == INVCAL_OK && count_open(j, NINE, n, 1) > 0) {
        *status = INVCAL_UNDETERMINED;
    }
    if (*status != INVCAL_UNDETERMINED) {
        return INVCAL_THERMAL_AS_ASKED;
    }
    j->noise = noise; /* as before the attempt */
    return INVCAL_THERMAL_OPEN;
}

/* The highest possible degree, at most `degree`. */
static invcal_status solve_highest(job *j, unsigned degree)
{
    invcal_status status;
    invcal_thermal_fallback why = try_degree(j, degree, &status);

    while (why != INVCAL_THERMAL_AS_ASKED && degree > 0) { /* at most INVCAL_THERMAL_DEGREE */
        j->now.fallback = why;
        why = try_degree(j, --degree, &status);
    }
    j->now.fitted = (uint8_t)degree;
    return status;
}

/* X at t of the current calibration and p together: delta = delta1 + (I + S1) delta2,
 * (I + S)^2 = (A2 A1)^-1 (A2 A1)^-T. */
static invcal_status compose(const job *j, invcal_real t, invcal_real x[INVCAL_PARAMETERS])
{
    const unsigned degree = j->now.fitted;
    //@ split degree;
    invcal_calibration first;
    invcal_calibration c;
    invcal_real scratch[INVCAL_WORK];
    invcal_real m[3][3];

    invcali_polynomials(&j->a[INVCAL_PACKED((degree + 1) * NINE, 0)], degree, t, x);
    invcal_status status = invcali_ellipsoid(x, scratch, &c);
    if (status == INVCAL_OK) {
        status = invcali_thermal_triad(&j->now, t, &first);
    }
    if (status == INVCAL_OK) {
        status = invcali_compose(&first, &c);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    invcali_inverse3((const invcal_real(*)[3])c.matrix, m);
    invcali_make_symmetric(m, scratch);
    memcpy(x, c.offset, sizeof c.offset);
    for (unsigned i = 0; i < 3; i++) {
        x[INVCAL_DK_X + i] = m[i][i] - 1;
    }
    x[INVCAL_GAMMA_XY] = 2 * m[0][1];
    x[INVCAL_GAMMA_XZ] = 2 * m[0][2];
    x[INVCAL_GAMMA_ZY] = 2 * m[1][2];
    return INVCAL_OK;
}

/* The polynomials of X through its values at both ends of the range and, for a parabola, in the
 * middle m: mean + slope (t - m) + c2 ((t - m)^2 - half^2). */
static invcal_status interpolate(job *j)
{
    const invcal_real low = invcali_thermal_scaled(&j->now, j->now.min);
    const invcal_real range = invcali_thermal_scaled(&j->now, j->now.max) - low;
    const invcal_real half = range / 2 > NARROWEST_STEP ? range / 2 : NARROWEST_STEP;
    const invcal_real m = low + range / 2;
    const invcal_real place[3] = {m - half, m + half, m};
    const unsigned places = j->now.degree > 1 ? 3 : 2;
    invcal_real x[3][NINE];

    //@ split places;
    for (unsigned k = 0; k < places; k++) {
        const invcal_status status = compose(j, place[k], x[k]);
        if (status != INVCAL_OK) {
            return status;
        }
    }
    for (unsigned r = 0; r < NINE; r++) {
        const invcal_real mean = (x[0][r] + x[1][r]) / 2;
        const invcal_real slope = (x[1][r] - x[0][r]) / (2 * half);
        const invcal_real c2 = places > 2 ? (mean - x[2][r]) / (half * half) : 0;
        const invcal_real c[3] = {mean - slope * m + c2 * (m * m - half * half), slope - 2 * c2 * m,
                                  c2};
        for (unsigned a = 0; a <= DEGREE; a++) {
            j->now.x[a][r] = c[a];
        }
    }
    return INVCAL_OK;
}

/* Solves for the deviation from the current calibration. */
static invcal_status improve(job *j, unsigned degree)
{
    invcal_thermal *now = &j->now;
    invcal_status status = solve_highest(j, degree);

    if (status != INVCAL_OK) {
        return status;
    }
    //@ split now->fitted;
    const int is_new = now->fitted >= now->degree; /* else slopes and their range are kept */
    now->min = is_new || j->min < now->min ? j->min : now->min;
    now->max = is_new || j->max > now->max ? j->max : now->max;
    now->degree = is_new ? now->fitted : now->degree;
    status = interpolate(j);
    return status == INVCAL_NOT_ELLIPSOID && count_open(j, 0, (now->fitted + 1u) * NINE, 1) > 0
               ? INVCAL_UNDETERMINED /* an open direction may take any shape */
               : status;
}

/* ---- the judgement --------------------------------------------------------------------------- */

/* The noise of the data, and L^-1 with it. A coefficient supplied by a prior is not an unknown. */
static invcal_status weigh(job *j)
{
    const unsigned n = (j->now.fitted + 1u) * NINE;
    invcal_real dof = (invcal_real)j->positions->count - (invcal_real)n;

    //@ split n;
    j->is_judged = 1;
    invcal_status status = solve_to(j, n);
    if (status != INVCAL_OK) {
        return status;
    }
    for (unsigned i = 0; i < n; i++) {
        const invcal_real ratio = j->noise * j->held[i];
        const invcal_real share = ratio * ratio * invcali_variance(j->a, n, i);
        dof += share > 1 ? 1 : share; /* above 1 by rounding only */
    }
    j->q.verdict = INVCAL_GOOD;
    j->q.unchecked = INVCAL_UNCHECKED;
    j->q.dof = invcali_whole(dof);
    invcali_judge_noise(j->positions->noise, j->squares, dof, -INVCAL_REAL_MAX, &j->q);
    if (j->widest > 0) {
        j->noise = j->q.noise;
        status = solve_to(j, n);
        j->q.noise = j->noise;
    }
    return status;
}

/* K(r,r) of X(t): the squared length of L^-1 (1 t t^2). */
static invcal_real variance_at(const job *j, invcal_real t, unsigned r)
{
    invcal_real sum = 0;

    //@ split j->now.fitted;
    for (unsigned i = r; i < (j->now.fitted + 1u) * NINE; i++) {
        invcal_real y = 0;
        for (unsigned a = (i - r) / NINE + 1; a-- > 0;) {
            y = j->a[INVCAL_PACKED(i, a * NINE + r)] + t * y;
        }
        sum += y * y;
    }
    return sum;
}

static invcal_status judge_at(job *j, invcal_real temperature)
{
    const invcal_thermal *now = &j->now;
    invcal_thermal_place place;
    invcal_calibration triad;
    invcal_real *const k = j->q.sigma;
    invcal_real t;

    invcal_status status = invcali_thermal_find(now, temperature, &t, &place);
    if (status == INVCAL_OK) {
        status = invcali_thermal_triad(now, t, &triad);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    for (unsigned r = 0; r < NINE; r++) {
        k[r] = variance_at(j, t, r);
        if (!(k[r] <= INVCAL_HOPELESS_K || j->held[r] > 0)) {
            return INVCAL_UNDETERMINED;
        }
    }
    invcali_judge_parameters((const invcal_real(*)[3])triad.matrix, &j->q);
    return INVCAL_OK;
}

/* At several temperatures: weak at one is weak. Without slopes over a range that needs them
 * everything is weak, since slopes pass for other errors, and the residuals may not show it. */
static invcal_status judge_range(job *j, const invcal_real *temperature, unsigned count,
                                 invcal_quality *quality)
{
    const invcal_thermal *now = &j->now;
    const int lacks_slopes = DEGREE > 0 && now->degree == 0 && !(now->max - now->min < NARROWEST);
    unsigned weak = lacks_slopes ? (1u << NINE) - 1u : 0;
    invcal_status status = weigh(j);

    for (unsigned i = 0; i < count && status == INVCAL_OK; i++) {
        status = judge_at(j, temperature[i]);
        weak |= j->q.weak;
    }
    if (status == INVCAL_OK) {
        *quality = j->q;
        quality->weak = (uint16_t)weak;
        quality->verdict = weak > 0 ? INVCAL_WEAK : j->q.verdict;
    }
    return status;
}

/* ---- all in one ------------------------------------------------------------------------------ */

static invcal_status find_range(const invcal_positions *positions, invcal_real *min,
                                invcal_real *max)
{
    if (positions->temperature == NULL && positions->count > 0) {
        return INVCAL_BAD_TEMPERATURE;
    }
    for (unsigned i = 0; i < positions->count; i++) {
        const invcal_real one = positions->temperature[i];
        if (!invcali_is_finite(one)) {
            return INVCAL_BAD_TEMPERATURE;
        }
        *min = i > 0 && *min < one ? *min : one;
        *max = i > 0 && *max > one ? *max : one;
    }
    return positions->count > 0 ? INVCAL_OK : INVCAL_TOO_FEW;
}

/* What is known beforehand, over the span. */
static invcal_status set_prior(job *j, const invcal_thermal_prior *prior)
{
    invcal_real power = 1;

    for (unsigned a = 0; a <= DEGREE; a++) {
        for (unsigned r = 0; r < NINE; r++) {
            const invcal_real stated = prior->sigma[a][r];
            const invcal_real sigma = stated * power;
            const invcal_real held = stated == 0 ? 0 : 1 / sigma;
            if (!(sigma >= 0 && sigma <= INVCAL_REAL_MAX && held <= INVCAL_REAL_MAX)) {
                return INVCAL_BAD_PRIOR;
            }
            j->held[a * NINE + r] = held;
            j->widest = sigma > j->widest ? sigma : j->widest;
        }
        power *= j->now.span;
    }
    return j->noise > 0 ? INVCAL_OK : INVCAL_BAD_NOISE;
}

static invcal_status set_up(job *j, const invcal_positions *positions,
                            const invcal_thermal_prior *prior, const invcal_thermal *base,
                            unsigned degree)
{
    invcal_positions plain = *positions;

    plain.nominal = &base->nominal;
    invcali_zero(j, sizeof *j);
    j->positions = positions;
    j->base = base;
    j->noise = positions->noise;
    j->now = *base;
    invcal_status status = degree <= DEGREE && base->degree <= DEGREE
                               ? invcali_positions_check(&plain)
                               : INVCAL_BAD_COUNT;
    if (status == INVCAL_OK) {
        status = find_range(positions, &j->min, &j->max);
    }
    if (status == INVCAL_OK && (!(INVCAL_FABS(invcali_thermal_scaled(base, j->min)) <= FARTHEST) ||
                                !(INVCAL_FABS(invcali_thermal_scaled(base, j->max)) <= FARTHEST))) {
        return INVCAL_BAD_TEMPERATURE;
    }
    return status == INVCAL_OK && prior != NULL ? set_prior(j, prior) : status;
}

/* Exactly two solves, and their quality. If the data are noisier than stated, a prior has more
 * weight: again with their noise. Readings that pass the first pass may be absurd after it. */
static invcal_status run(job *j, unsigned degree, invcal_thermal *out, invcal_quality *quality)
{
    j->now.fallback = INVCAL_THERMAL_AS_ASKED;
    invcal_status status = improve(j, degree);
    if (status != INVCAL_OK) {
        return status;
    }
    status = improve(j, j->now.fitted);
    if (status == INVCAL_OK && j->widest > 0) {
        status = weigh(j);
        status = status == INVCAL_OK ? improve(j, j->now.fitted) : status;
    }
    if (status == INVCAL_OK) {
        const invcal_real at[3] = {j->now.min, j->now.max, j->now.reference};
        status = judge_range(j, at, 3, quality);
    }
    if (status == INVCAL_OK) {
        *out = j->now;
    }
    return status == INVCAL_OUT_OF_RANGE ? INVCAL_NOT_ELLIPSOID : status;
}

/* The nominal calibration at all temperatures: X = 0. */
static invcal_status make_base(const invcal_positions *positions, invcal_thermal *base)
{
    invcal_status status = invcali_nominal_check(positions->nominal);

    invcali_zero(base, sizeof *base);
    if (status == INVCAL_OK) {
        status = find_range(positions, &base->min, &base->max);
    }
    if (status == INVCAL_OK) {
        const invcal_real half = base->max / 2 - base->min / 2;
        base->nominal = *positions->nominal;
        base->reference = base->min + half;
        base->span = half >= 1 ? half : 1;
    }
    return status;
}

invcal_status invcal_thermal_fit(const invcal_positions *positions,
                                 const invcal_thermal_prior *prior, const invcal_thermal *base,
                                 unsigned degree, invcal_thermal *out, invcal_quality *quality)
{
    invcal_thermal begun;
    job j;

    INVCAL_ASSERT(positions && (base || positions->nominal) && out && quality);
    invcal_status status = base == NULL ? make_base(positions, &begun) : INVCAL_OK;
    if (status == INVCAL_OK) {
        status = set_up(&j, positions, prior, base == NULL ? &begun : base, degree);
    }
    return status == INVCAL_OK ? run(&j, degree, out, quality) : status;
}

invcal_status invcal_thermal_calibrate(const invcal_positions *positions, unsigned degree,
                                       invcal_thermal *out, invcal_quality *quality)
{
    return invcal_thermal_fit(positions, NULL, NULL, degree, out, quality);
}

invcal_status invcal_thermal_judge(const invcal_positions *positions,
                                   const invcal_thermal_prior *prior, const invcal_thermal *thermal,
                                   invcal_real temperature, invcal_quality *quality)
{
    job j;

    INVCAL_ASSERT(positions && thermal && quality);
    const invcal_status status = set_up(&j, positions, prior, thermal, thermal->fitted);
    return status == INVCAL_OK ? judge_range(&j, &temperature, 1, quality) : status;
}
