/* SPDX-License-Identifier: MIT */
#include "invcal/thermal.h"

#include <limits.h>
#include <stddef.h>
#include <string.h>

#include "evidence.h"
#include "near.h"
#include "triad.h"
#include "vector.h"

#define FARTHEST INVCAL_REAL(2.0)         /* |t| */
#define NARROWEST INVCAL_REAL(5.0)        /* K, for each degree */
#define OPEN_ROOT_K INVCAL_REAL(10.0)     /* of a slope over the span: above, it is left out */
#define NARROWEST_STEP INVCAL_REAL(0.125) /* of t, to a point of interpolation */
#define USUAL_SLOPE INVCAL_REAL(1e-3)     /* 1/K */
#define USUAL_NOISE INVCAL_REAL(1e-4)     /* of the field */

enum {
    SUMS = INVCAL_THERMAL_SUMS,
    DEGREE = INVCAL_THERMAL_DEGREE,
    N = INVCAL_PARAMETERS,
    BLOCK = INVCAL_PACKED_SIZE(INVCAL_PARAMETERS),
    LARGE = INVCAL_PACKED_SIZE(INVCAL_THERMAL_ROWS * INVCAL_PARAMETERS)
};

/* What an equation of this room is made of. */
typedef struct {
    const invcal_thermal_sums *sums;
    const invcal_settings *settings;
    const invcal_thermal_settings *thermal;
    const invcal_thermal_calibration *base;  /* what the rows were made with */
    const invcal_thermal_calibration *known; /* what a prior holds to */
} problem;

const char *invcal_thermal_fallback_text(invcal_thermal_fallback fallback)
{
    return fallback == INVCAL_THERMAL_AS_ASKED ? "as asked"
           : fallback == INVCAL_THERMAL_FEW    ? "too few positions for slopes"
           : fallback == INVCAL_THERMAL_NARROW ? "too narrow a range of temperatures for slopes"
           : fallback == INVCAL_THERMAL_OPEN   ? "positions and temperatures leave slopes open"
                                               : "unknown reason";
}

/* ---- the polynomials ---------------------------------------------------------------------- */

/* Nine polynomials of t by Horner's rule; c: DEGREE + 1 rows of nine coefficients. */
static void evaluate(const invcal_real *c, invcal_real t, invcal_real out[INVCAL_PARAMETERS])
{
    memcpy(out, &c[(size_t)DEGREE * N], N * sizeof *out);
    for (unsigned a = DEGREE; a-- > 0;) {
        for (unsigned r = 0; r < N; r++) {
            out[r] = c[a * N + r] + t * out[r];
        }
    }
}

static invcal_real scaled(const invcal_thermal_calibration *model, invcal_real temperature)
{
    return (temperature - model->reference) / model->span;
}

/* delta, dk, gamma of X. */
static void name_thermal(const invcal_real x[INVCAL_PARAMETERS], invcal_solution *out)
{
    memcpy(out->delta, x, sizeof out->delta);
    memcpy(out->dk, x + INVCAL_DK_X, sizeof out->dk);
    memcpy(out->gamma, x + INVCAL_GAMMA_XY, sizeof out->gamma);
}

/* X at t; not its calibration. */
static void parameters_at(const invcal_thermal_calibration *model, invcal_real t,
                          invcal_solution *out)
{
    invcal_real x[N];

    evaluate(&model->x[0][0], t, x);
    name_thermal(x, out);
}

static invcal_thermal_place place_of(const invcal_thermal_calibration *model,
                                     invcal_real *temperature)
{
    if (!(*temperature >= model->least)) {
        *temperature = model->least;
        return INVCAL_THERMAL_BELOW;
    }
    if (!(*temperature <= model->greatest)) {
        *temperature = model->greatest;
        return INVCAL_THERMAL_ABOVE;
    }
    return INVCAL_THERMAL_WITHIN;
}

invcal_status invcal_thermal_at(const invcal_thermal_calibration *calibration,
                                invcal_real temperature, invcal_solution *solution,
                                invcal_thermal_place *place)
{
    const invcal_thermal_calibration *c = calibration;
    invcal_real inverse[3][3]; /* of the nominal matrix */
    invcal_real p[N];
    invcal_triad triad;

    INVCAL_ASSERT(c && solution && place);
    const invcal_settings settings = {c->nominal, c->field, 0, {0}, c->frame};
    if (!invcal_is_finite(temperature)) {
        return INVCAL_NOT_FINITE;
    }
    if (!invcal_is_positive(c->field) || !invcal_are_finite(c->nominal.offset) ||
        invcal_calibration_inverse(&c->nominal, inverse) != INVCAL_OK) {
        return INVCAL_BAD_SETTING;
    }
    const invcal_thermal_place where = place_of(c, &temperature);
    evaluate(&c->x[0][0], scaled(c, temperature), p);
    for (unsigned r = 0; r < N; r++) {
        p[r] = -p[r];
    }
    if (!invcal_triad_of_linear(p, &triad)) {
        return INVCAL_NOT_ELLIPSOID;
    }
    const invcal_status status = invcal_triad_join(&triad, &settings, inverse, solution);
    if (status == INVCAL_OK) {
        *place = where;
    }
    return status;
}

/* ---- settings ----------------------------------------------------------------------------- */

static invcal_status check_thermal(const invcal_settings *settings,
                                   const invcal_thermal_settings *thermal)
{
    invcal_real steepest = 0;

    for (unsigned r = 0; r < N; r++) {
        if (!(thermal->slope[r] >= 0 && thermal->slope[r] <= INVCAL_REAL_MAX &&
              thermal->curvature[r] >= 0 && thermal->curvature[r] <= INVCAL_REAL_MAX)) {
            return INVCAL_BAD_SETTING;
        }
        steepest += thermal->slope[r] + thermal->curvature[r];
    }
    if (thermal->less > DEGREE || (steepest > 0 && !(settings->noise > 0))) {
        return INVCAL_BAD_SETTING;
    }
    return invcal_settings_check(settings);
}

invcal_status invcal_thermal_start(const invcal_settings *settings,
                                   const invcal_thermal_settings *thermal,
                                   invcal_thermal_calibration *out)
{
    INVCAL_ASSERT(settings && thermal && out);
    if (!invcal_is_finite(thermal->reference) || !invcal_is_positive(thermal->span)) {
        return INVCAL_BAD_SETTING;
    }
    const invcal_status status = check_thermal(settings, thermal);
    if (status == INVCAL_OK) {
        memset(out, 0, sizeof *out);
        out->nominal = settings->nominal;
        out->field = settings->field;
        out->frame = settings->frame;
        out->reference = thermal->reference;
        out->span = thermal->span;
        out->least = thermal->reference;
        out->greatest = thermal->reference;
    }
    return status;
}

/* The standard deviation of the coefficient of t^power of parameter r; 0: not known. */
static invcal_real prior_of(const problem *m, unsigned power, unsigned r)
{
    const invcal_real span = m->base->span;

    return power == 0   ? m->settings->prior[r]
           : power == 1 ? m->thermal->slope[r] * span
                        : m->thermal->curvature[r] * span * span;
}

static unsigned coefficients_without_prior(const problem *m, unsigned degree)
{
    unsigned count = 0;

    for (unsigned a = 0; a <= degree; a++) {
        for (unsigned r = 0; r < N; r++) {
            count += !(prior_of(m, a, r) > 0);
        }
    }
    return count;
}

static int has_prior(const problem *m, unsigned degree)
{
    return coefficients_without_prior(m, degree) < (degree + 1) * N;
}

invcal_real invcal_thermal_drift_limit(const invcal_settings *settings,
                                       const invcal_thermal_settings *thermal)
{
    invcal_real steepest = 0;

    INVCAL_ASSERT(settings && thermal);
    for (unsigned r = 0; r < N; r++) {
        steepest = thermal->slope[r] > steepest ? thermal->slope[r] : steepest;
    }
    const invcal_real slope = steepest > 0 ? steepest : USUAL_SLOPE;
    const invcal_real noise = settings->noise > 0 ? settings->noise / settings->field : USUAL_NOISE;
    const invcal_real limit = 2 * noise / slope;
    return invcal_is_positive(limit) ? limit : 0;
}

/* ---- the sums ----------------------------------------------------------------------------- */

void invcal_thermal_init(invcal_thermal_sums *sums)
{
    INVCAL_ASSERT(sums);
    memset(sums, 0, sizeof *sums);
}

/* One row, calibrated with the base at its temperature, and its residual: sums of one position. */
static invcal_status observe(const invcal_thermal_calibration *base, const invcal_real raw[3],
                             invcal_real temperature, invcal_residuals *one)
{
    invcal_solution triad;
    invcal_real u[3];

    if (!invcal_is_finite(temperature)) {
        return INVCAL_NOT_FINITE;
    }
    const invcal_real t = scaled(base, temperature);
    if (!(INVCAL_FABS(t) <= FARTHEST)) {
        return INVCAL_BAD_SETTING;
    }
    const invcal_status status = invcal_observation_reading(&base->nominal, base->field, raw, u);
    if (status != INVCAL_OK) {
        return status;
    }
    parameters_at(base, t, &triad);
    invcal_residuals_init(one, &triad);
    return invcal_residuals_add(one, u, 1, NULL);
}

static void add_factored(invcal_normal *sum, const invcal_normal *row, invcal_real factor)
{
    for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
        sum->moment[i] += factor * row->moment[i];
    }
    for (unsigned r = 0; r < N; r++) {
        sum->htj[r] += factor * row->htj[r];
    }
    sum->jtj += factor * row->jtj;
}

/* All sums: the row times t^k. */
static void accumulate_powers(invcal_thermal_sums *sums, const invcal_normal *row, invcal_real t,
                              invcal_real sign)
{
    for (unsigned k = 0; k < SUMS; k++) {
        add_factored(&sums->sum[k], row, sign);
        sign *= t;
    }
}

static void widen(invcal_thermal_sums *sums, invcal_real temperature)
{
    if (sums->sum[0].count == 0 || temperature < sums->least) {
        sums->least = temperature;
    }
    if (sums->sum[0].count == 0 || temperature > sums->greatest) {
        sums->greatest = temperature;
    }
}

invcal_status invcal_thermal_add(invcal_thermal_sums *sums, const invcal_thermal_calibration *base,
                                 const invcal_real raw[3], invcal_real temperature)
{
    invcal_residuals one;

    INVCAL_ASSERT(sums && base && raw);
    const invcal_status status = observe(base, raw, temperature, &one);
    if (status != INVCAL_OK) {
        return status;
    }
    accumulate_powers(sums, &one.normal, scaled(base, temperature), 1);
    widen(sums, temperature);
    sums->squares += one.squares;
    if (!(one.max <= sums->max)) {
        sums->max = one.max;
        sums->worst = sums->sum[0].count;
    }
    sums->sum[0].count += sums->sum[0].count < UINT_MAX;
    return INVCAL_OK;
}

invcal_status invcal_thermal_remove(invcal_thermal_sums *sums,
                                    const invcal_thermal_calibration *base,
                                    const invcal_real raw[3], invcal_real temperature)
{
    invcal_residuals one;

    INVCAL_ASSERT(sums && base && raw);
    if (sums->sum[0].count == 0) {
        return INVCAL_TOO_FEW;
    }
    const invcal_status status = observe(base, raw, temperature, &one);
    if (status != INVCAL_OK) {
        return status;
    }
    accumulate_powers(sums, &one.normal, scaled(base, temperature), -1);
    sums->squares -= one.squares;
    if (--sums->sum[0].count == 0) {
        invcal_thermal_init(sums); /* no rounding errors of what has gone */
    }
    return INVCAL_OK;
}

/* ---- the equations ------------------------------------------------------------------------ */

/* The unknowns stand with the highest power of t first, and last X at t itself, not that at the
 * reference: X(s) = X(t) + sum over a >= 1 of c_a (s^a - t^a). So the last nine rows of L are the
 * factor of what is known of X at t once the rest has been eliminated. */
static invcal_real constant_of(unsigned power, invcal_real t)
{
    return power == 0 ? 0 : power == 1 ? -t : -t * t;
}

/* One block of H'WH: the sum of (s^a + u)(s^b + v) h h' over all positions. */
static void block(const invcal_thermal_sums *sums, unsigned a, unsigned b, invcal_real t,
                  invcal_real out[BLOCK])
{
    const invcal_real u = constant_of(a, t);
    const invcal_real v = constant_of(b, t);
    invcal_normal sum = sums->sum[a + b];

    add_factored(&sum, &sums->sum[a], v);
    add_factored(&sum, &sums->sum[b], u);
    add_factored(&sum, &sums->sum[0], u * v);
    invcal_normal_matrix(&sum, out);
}

static void place_block(const invcal_real m[BLOCK], unsigned row, unsigned column,
                        invcal_real *large)
{
    for (unsigned r = 0; r < N; r++) {
        for (unsigned c = 0; c < N && column + c <= row + r; c++) {
            large[INVCAL_PACKED(row + r, column + c)] =
                m[c <= r ? INVCAL_PACKED(r, c) : INVCAL_PACKED(c, r)];
        }
    }
}

/* H'WH of all unknowns up to this degree, packed. */
INVCAL_APART static void matrix(const problem *m, unsigned degree, invcal_real t,
                                invcal_real *large)
{
    invcal_real one[BLOCK];

    for (unsigned i = 0; i <= degree; i++) {
        for (unsigned j = 0; j <= i; j++) {
            block(m->sums, degree - i, degree - j, t, one);
            place_block(one, i * N, j * N, large);
        }
    }
}

/* A coefficient is known with a standard deviation: a row (noise / prior) c = 0. That at the
 * reference is X(t) + sum over a >= 1 of -t^a c_a. */
static void add_thermal_prior(const problem *m, unsigned degree, invcal_real t, invcal_real noise,
                              invcal_real *large)
{
    for (unsigned r = 0; r < N; r++) {
        for (unsigned i = 0; i <= degree; i++) {
            const unsigned a = degree - i;
            const invcal_real prior = prior_of(m, a, r);
            const invcal_real at_reference = m->settings->prior[r];
            const invcal_real u = a == 0 ? 1 : constant_of(a, t);
            if (a > 0 && prior > 0) {
                large[INVCAL_PACKED(i * N + r, i * N + r)] += noise / prior * (noise / prior);
            }
            for (unsigned j = 0; j <= i && at_reference > 0; j++) {
                const invcal_real v = j == degree ? 1 : constant_of(degree - j, t);
                const invcal_real ratio = noise / at_reference;
                large[INVCAL_PACKED(i * N + r, j * N + r)] += ratio * ratio * u * v;
            }
        }
    }
}

/* The least noise with which the prior is more than rounding beside the largest sums. */
static invcal_real resolvable_thermal_noise(const problem *m, unsigned degree, invcal_real largest)
{
    invcal_real widest = 0;

    for (unsigned a = 0; a <= degree; a++) {
        for (unsigned r = 0; r < N; r++) {
            const invcal_real prior = prior_of(m, a, r);
            widest = prior > widest ? prior : widest;
        }
    }
    return widest * INVCAL_SQRT(4 * INVCAL_EPSILON * largest);
}

/* L of H'WH and the prior. The noise is raised where a prior has to hold what the positions leave
 * open, as invcal_information does. */
static invcal_status factor_system(const problem *m, unsigned degree, invcal_real t,
                                   invcal_real *noise, invcal_real *large)
{
    const unsigned n = (degree + 1) * N;

    matrix(m, degree, t, large);
    if (!has_prior(m, degree)) {
        return invcal_cholesky_factor(large, n, INVCAL_PIVOT_FLOOR);
    }
    const invcal_real largest = invcal_largest_diagonal(large, n);
    if (invcal_cholesky_factor(large, n, 30 * INVCAL_PIVOT_FLOOR) != INVCAL_OK) {
        const invcal_real least = resolvable_thermal_noise(m, degree, largest);
        *noise = *noise >= least ? *noise : least;
    }
    matrix(m, degree, t, large);
    add_thermal_prior(m, degree, t, *noise, large);
    return invcal_cholesky_factor(large, n, INVCAL_EPSILON);
}

/* K(i,i), the square of a column of L^-1. */
static invcal_real thermal_variance(const invcal_real *inverse, unsigned n, unsigned i)
{
    invcal_real sum = 0;

    for (unsigned k = i; k < n; k++) {
        const invcal_real x = inverse[INVCAL_PACKED(k, i)];
        sum += x * x;
    }
    return sum;
}

/* ---- the solution ------------------------------------------------------------------------- */

static int are_slopes_known(const problem *m, unsigned degree, const invcal_real *inverse)
{
    const unsigned n = (degree + 1) * N;

    for (unsigned i = 0; i < degree * N; i++) {
        const int is_held = prior_of(m, degree - i / N, i % N) > 0;
        if (!is_held && !(thermal_variance(inverse, n, i) <= OPEN_ROOT_K * OPEN_ROOT_K)) {
            return 0;
        }
    }
    return 1;
}

/* p of the readings calibrated with the base: DEGREE + 1 rows, of which those above degree are 0.
 * INVCAL_UNDETERMINED if it, or a slope in it, is left open. */
INVCAL_APART static invcal_status solve_degree(const problem *m, unsigned degree, invcal_real *p)
{
    const unsigned n = (degree + 1) * N;
    invcal_real noise = m->settings->noise / m->settings->field;
    invcal_real large[LARGE];
    invcal_real x[INVCAL_THERMAL_ROWS * INVCAL_PARAMETERS];

    const invcal_status status = factor_system(m, degree, 0, &noise, large);
    if (status != INVCAL_OK) {
        return status;
    }
    for (unsigned i = 0; i < n; i++) {
        const unsigned a = degree - i / N;
        const unsigned r = i % N;
        const invcal_real prior = prior_of(m, a, r);
        const invcal_real ratio = prior > 0 ? noise / prior : 0;
        /* p is -X against the base, which is not where the prior is 0 */
        x[i] = ratio * ratio * (m->base->x[a][r] - m->known->x[a][r]) - m->sums->sum[a].htj[r];
    }
    invcal_cholesky_solve(large, n, x);
    invcal_cholesky_invert(large, n);
    if (!are_slopes_known(m, degree, large)) {
        return INVCAL_UNDETERMINED;
    }
    memset(p, 0, sizeof x);
    for (unsigned i = 0; i < n; i++) {
        p[(degree - i / N) * N + i % N] = x[i];
    }
    return INVCAL_OK;
}

static void unpack(const invcal_real s[6], invcal_real m[3][3])
{
    for (unsigned r = 0; r < 3; r++) {
        for (unsigned c = 0; c <= r; c++) {
            m[r][c] = s[INVCAL_PACKED(r, c)];
            m[c][r] = m[r][c];
        }
    }
}

/* S of a triad P1 = I + S1 that still reads with P2 = I + S2 once it is calibrated:
 * P^2 = P1 P2^2 P1 = (I + m)(I + m)', I + m = P1 P2. Returns 0 if it is no triad. */
static int join_deviations(const invcal_real s1[6], const invcal_real s2[6], invcal_real s[6])
{
    invcal_real first[3][3];
    invcal_real m[3][3];
    invcal_real square[6];
    invcal_real correction[6];

    unpack(s1, first);
    unpack(s2, m);
    for (unsigned c = 0; c < 3; c++) {
        const invcal_real column[3] = {m[0][c], m[1][c], m[2][c]};
        invcal_real product[3];
        invcal_near_multiply(s1, column, product);
        for (unsigned r = 0; r < 3; r++) {
            m[r][c] = first[r][c] + product[r];
        }
    }
    for (unsigned r = 0; r < 3; r++) {
        for (unsigned c = 0; c <= r; c++) {
            square[INVCAL_PACKED(r, c)] = m[r][c] + m[c][r] + invcal_dot3(m[r], m[c]);
        }
    }
    if (!invcal_near_is_between(square, INVCAL_SHORTEST * INVCAL_SHORTEST,
                                INVCAL_LONGEST * INVCAL_LONGEST)) {
        return 0;
    }
    invcal_near_root(square, s, correction);
    return 1;
}

/* X at t of the base and of p together: delta = delta1 + P1 delta2. Returns 0 if it is no triad. */
INVCAL_APART static int compose(const invcal_thermal_calibration *base, const invcal_real *p,
                                invcal_real t, invcal_real x[INVCAL_PARAMETERS])
{
    invcal_real here[N];
    invcal_triad rest;
    invcal_solution first;
    invcal_real s1[6];
    invcal_real s[6];

    evaluate(p, t, here);
    if (!invcal_triad_of_ellipsoid(here, &rest)) {
        return 0;
    }
    parameters_at(base, t, &first);
    invcal_solution_deviation(&first, s1);
    if (!join_deviations(s1, rest.s, s)) {
        return 0;
    }
    invcal_near_multiply(s1, rest.delta, x);
    for (unsigned i = 0; i < 3; i++) {
        x[INVCAL_DELTA_X + i] += first.delta[i];
        x[INVCAL_DK_X + i] = s[INVCAL_PACKED(i, i)];
    }
    x[INVCAL_GAMMA_XY] = 2 * s[INVCAL_PACKED(1, 0)];
    x[INVCAL_GAMMA_XZ] = 2 * s[INVCAL_PACKED(2, 0)];
    x[INVCAL_GAMMA_ZY] = 2 * s[INVCAL_PACKED(2, 1)];
    return 1;
}

/* The polynomials of X through what it is at both ends of the temperatures seen and, for a
 * parabola, in their middle: Newton's interpolation, about t = 0. */
static invcal_status interpolate(const problem *m, const invcal_real *p, unsigned degree,
                                 invcal_thermal_calibration *out)
{
    const invcal_real least = scaled(m->base, m->sums->least);
    const invcal_real greatest = scaled(m->base, m->sums->greatest);
    const invcal_real half = (greatest - least) / 2;
    const invcal_real step = half > NARROWEST_STEP ? half : NARROWEST_STEP;
    const invcal_real t = least + half;
    invcal_real low[N];
    invcal_real middle[N];
    invcal_real high[N];

    if (!(compose(m->base, p, t - step, low) && compose(m->base, p, t, middle) &&
          compose(m->base, p, t + step, high))) {
        return INVCAL_NOT_ELLIPSOID;
    }
    memset(out->x, 0, sizeof out->x);
    for (unsigned r = 0; r < N; r++) {
        const invcal_real rise = (high[r] - low[r]) / 2;
        const invcal_real bend = (high[r] - middle[r]) - (middle[r] - low[r]);
        const invcal_real c2 = degree == 2 ? bend / (2 * step * step) : 0;
        const invcal_real c1 = degree >= 1 ? rise / step - 2 * c2 * t : 0;
        const invcal_real c0 = (degree == 1 ? low[r] + rise : middle[r]) - (c1 + c2 * t) * t;
        const invcal_real c[3] = {c0, c1, c2};
        for (unsigned a = 0; a <= DEGREE; a++) {
            out->x[a][r] = c[a];
        }
    }
    return INVCAL_OK;
}

/* Why slopes of this degree are not even tried. */
static invcal_thermal_fallback obstacle(const problem *m, unsigned degree)
{
    const unsigned count = m->sums->sum[0].count;
    const invcal_real range = m->sums->greatest - m->sums->least;
    int is_held = 1;

    if (count == 0 || count < coefficients_without_prior(m, degree)) {
        return INVCAL_THERMAL_FEW;
    }
    for (unsigned r = 0; r < N && degree > 0; r++) {
        is_held &= prior_of(m, degree, r) > 0;
    }
    return is_held || range >= (invcal_real)degree * NARROWEST ? INVCAL_THERMAL_AS_ASKED
                                                               : INVCAL_THERMAL_NARROW;
}

/* p of the highest degree that can be had, most at most. */
static invcal_status solve_highest(const problem *m, unsigned most, invcal_real *p,
                                   invcal_thermal_calibration *out)
{
    invcal_thermal_fallback why = INVCAL_THERMAL_AS_ASKED;

    //@ split most;
    for (unsigned degree = most; degree > 0; degree--) {
        const invcal_thermal_fallback reason = obstacle(m, degree);
        const invcal_status status =
            reason == INVCAL_THERMAL_AS_ASKED ? solve_degree(m, degree, p) : INVCAL_TOO_FEW;
        if (status == INVCAL_OK) {
            out->fitted = (uint8_t)degree;
            out->fallback = why;
            return INVCAL_OK;
        }
        why = reason == INVCAL_THERMAL_AS_ASKED ? INVCAL_THERMAL_OPEN : reason;
    }
    out->fitted = 0;
    out->fallback = why;
    return obstacle(m, 0) == INVCAL_THERMAL_AS_ASKED ? solve_degree(m, 0, p) : INVCAL_TOO_FEW;
}

static invcal_status solve_degrees(const problem *m, unsigned most, invcal_thermal_calibration *out)
{
    const invcal_thermal_calibration *base = m->base;
    invcal_real p[INVCAL_THERMAL_ROWS * INVCAL_PARAMETERS];
    invcal_thermal_calibration c = *base;

    invcal_status status = solve_highest(m, most, p, &c);
    if (status != INVCAL_OK) {
        return status;
    }
    c.degree = c.fitted > base->degree ? c.fitted : base->degree;
    c.least = m->sums->least;
    c.greatest = m->sums->greatest;
    status = interpolate(m, p, c.degree, &c);
    if (status == INVCAL_OK) {
        *out = c;
    }
    return status;
}

invcal_status invcal_thermal_solve(const invcal_thermal_sums *sums,
                                   const invcal_thermal_calibration *base,
                                   const invcal_settings *settings,
                                   const invcal_thermal_settings *thermal,
                                   invcal_thermal_calibration *out)
{
    const problem m = {sums, settings, thermal, base, base};

    INVCAL_ASSERT(sums && base && settings && thermal && out);
    const invcal_status status = check_thermal(settings, thermal);
    return status == INVCAL_OK ? solve_degrees(&m, DEGREE - (unsigned)thermal->less, out) : status;
}

/* ---- the judgement ------------------------------------------------------------------------ */

/* The residuals of the positions, as those of one temperature. */
static void gather_residuals(const invcal_thermal_sums *sums,
                             const invcal_thermal_calibration *calibration, invcal_residuals *out)
{
    invcal_solution triad;

    parameters_at(calibration, 0, &triad);
    invcal_residuals_init(out, &triad); /* the gain: it hardly depends on temperature */
    out->normal = sums->sum[0];
    out->squares = sums->squares;
    out->max = sums->max;
    out->worst = sums->worst;
    out->count = sums->sum[0].count;
}

/* What is known beforehand of the parameters at t. */
static void spread_prior(const problem *m, unsigned degree, invcal_real t,
                         invcal_real prior[INVCAL_PARAMETERS])
{
    for (unsigned r = 0; r < N; r++) {
        invcal_real square = 0;
        invcal_real power = 1;
        int is_known = 1;
        for (unsigned a = 0; a <= degree; a++) {
            const invcal_real sigma = prior_of(m, a, r);
            is_known &= sigma > 0;
            square += sigma * power * (sigma * power);
            power *= t;
        }
        prior[r] = is_known ? INVCAL_SQRT(square) : 0;
    }
}

/* How many coefficients the data had to determine: what the prior supplies does not count. */
INVCAL_APART static invcal_status coefficients_of_data(const problem *m, unsigned degree,
                                                       invcal_real noise, invcal_real *count)
{
    const unsigned n = (degree + 1) * N;
    invcal_real large[LARGE];

    *count = (invcal_real)n;
    if (!has_prior(m, degree)) {
        return INVCAL_OK;
    }
    const invcal_status status = factor_system(m, degree, 0, &noise, large);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_cholesky_invert(large, n);
    for (unsigned i = 0; i < n; i++) {
        const invcal_real sigma = prior_of(m, degree - i / N, i % N);
        if (sigma > 0) {
            *count -= thermal_variance(large, n, i) * noise * noise / (sigma * sigma);
        }
    }
    return INVCAL_OK;
}

/* The factor of the information on X at t: the last nine rows and columns of L. */
INVCAL_APART static invcal_status factor_at(const problem *m, unsigned degree, invcal_real t,
                                            invcal_real *noise, invcal_real l[BLOCK])
{
    const unsigned first = degree * N;
    invcal_real large[LARGE];

    const invcal_status status = factor_system(m, degree, t, noise, large);
    for (unsigned r = 0; r < N && status == INVCAL_OK; r++) {
        memcpy(&l[INVCAL_PACKED(r, 0)], &large[INVCAL_PACKED(first + r, first)],
               (r + 1) * sizeof *l);
    }
    return status;
}

/* The condition of L L'. */
INVCAL_APART static invcal_real condition_of(const invcal_real l[BLOCK])
{
    invcal_real a[BLOCK];

    for (unsigned r = 0; r < N; r++) {
        for (unsigned c = 0; c <= r; c++) {
            a[INVCAL_PACKED(r, c)] =
                invcal_dot(&l[INVCAL_PACKED(r, 0)], &l[INVCAL_PACKED(c, 0)], c + 1);
        }
    }
    return invcal_condition(a, N);
}

/* All that can be refused; leaves L^-1 in e->l. */
static invcal_status judge_thermal(const problem *m, unsigned degree, invcal_real t,
                                   invcal_evidence *e, invcal_quality *q)
{
    const invcal_real stated = e->residuals->gain * m->settings->noise / m->settings->field;
    invcal_real unknowns;

    q->residual_rms = INVCAL_SQRT(e->residuals->squares / (invcal_real)e->residuals->count);
    q->residual_max = e->residuals->max;
    q->worst = e->residuals->worst;
    if (!(q->residual_rms <= INVCAL_ABSURD_RESIDUAL)) {
        return INVCAL_NOT_ELLIPSOID;
    }
    invcal_status status = coefficients_of_data(m, degree, stated, &unknowns);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_evidence_noise(e, stated, unknowns, q);
    status = factor_at(m, degree, t, &e->noise, e->l);
    if (status != INVCAL_OK) {
        return status;
    }
    q->noise = e->noise; /* a prior may have raised it */
    q->condition = condition_of(e->l);
    if (!has_prior(m, degree) && !(q->condition * INVCAL_PIVOT_FLOOR < 1)) {
        return INVCAL_UNDETERMINED;
    }
    invcal_cholesky_invert(e->l, N);
    return invcal_evidence_parameters(e, q);
}

/* Without slopes over a range that wants some, slopes pass for errors of everything else, and the
 * residuals may not show it. */
static int lacks_slopes(const invcal_thermal_calibration *c)
{
    return DEGREE > 0 && c->degree == 0 && !(c->greatest - c->least < NARROWEST);
}

/* Slopes that are wanting pass for errors of any kind. */
static void doubt_slopes(const invcal_thermal_calibration *calibration, invcal_quality *q)
{
    if (lacks_slopes(calibration)) {
        q->undetermined = (1u << INVCAL_PARAMETERS) - 1;
        q->verdict = INVCAL_WEAK;
    }
}

invcal_status invcal_thermal_assess(const invcal_thermal_sums *sums,
                                    const invcal_thermal_calibration *calibration,
                                    const invcal_settings *settings,
                                    const invcal_thermal_settings *thermal, invcal_real temperature,
                                    invcal_quality *quality)
{
    const problem m = {sums, settings, thermal, calibration, calibration};
    invcal_residuals residuals;
    invcal_solution triad;
    invcal_evidence e;
    invcal_quality q;

    INVCAL_ASSERT(sums && calibration && settings && thermal && quality);
    if (!invcal_is_finite(temperature)) {
        return INVCAL_NOT_FINITE;
    }
    if (sums->sum[0].count == 0 || check_thermal(settings, thermal) != INVCAL_OK) {
        return INVCAL_BAD_SETTING;
    }
    const unsigned degree = calibration->fitted;
    //@ split degree;
    invcal_settings here = *settings;
    (void)place_of(calibration, &temperature);
    const invcal_real t = scaled(calibration, temperature);
    gather_residuals(sums, calibration, &residuals);
    spread_prior(&m, degree, t, here.prior);
    e.residuals = &residuals;
    e.settings = &here;
    e.share = 1;
    invcal_status status = judge_thermal(&m, degree, t, &e, &q);
    if (status == INVCAL_OK) {
        invcal_real s[6];
        parameters_at(calibration, t, &triad);
        invcal_solution_deviation(&triad, s);
        invcal_evidence_spread_offset(&e, s, &q);
        invcal_evidence_spread_matrix(&e, s, &q);
        status = invcal_evidence_check(&q);
    }
    if (status == INVCAL_OK) {
        doubt_slopes(calibration, &q);
        *quality = q;
    }
    return status;
}

/* ---- all in one --------------------------------------------------------------------------- */

/* The positions of a calibration, and what is made of them. */
typedef struct {
    const invcal_real *raw;
    const invcal_real *temperature;
    unsigned count;
    const invcal_thermal_settings *thermal;
    invcal_thermal_calibration start;
    invcal_thermal_calibration now;
    invcal_thermal_sums sums; /* of rows made with `now` */
    unsigned position;        /* a bad one, else count */
} job;

/* The middle of the temperatures and half their range, at least 1 K, unless a span is given. */
static invcal_status centre(const invcal_real *temperature, unsigned count,
                            invcal_thermal_settings *thermal, unsigned *position)
{
    invcal_real least = count > 0 ? temperature[0] : 0;
    invcal_real greatest = least;

    for (*position = 0; *position < count; ++*position) {
        const invcal_real t = temperature[*position];
        if (!invcal_is_finite(t)) {
            return INVCAL_NOT_FINITE;
        }
        least = t < least ? t : least;
        greatest = t > greatest ? t : greatest;
    }
    if (thermal->span == 0) {
        const invcal_real half = greatest / 2 - least / 2;
        thermal->reference = least + half;
        thermal->span = half >= 1 ? half : 1;
    }
    return INVCAL_OK;
}

/* The sums of all positions, calibrated with what is there by now. */
static invcal_status gather(job *j)
{
    invcal_thermal_init(&j->sums);
    for (j->position = 0; j->position < j->count; j->position++) {
        const invcal_status status = invcal_thermal_add(
            &j->sums, &j->now, &j->raw[3 * (size_t)j->position], j->temperature[j->position]);
        if (status != INVCAL_OK) {
            return status;
        }
    }
    return INVCAL_OK;
}

/* Solves for what is left against the calibration that is there, and looks at what remains. */
static invcal_status improve(job *j, const invcal_settings *settings, unsigned most)
{
    const problem m = {&j->sums, settings, j->thermal, &j->now, &j->start};
    const invcal_thermal_fallback why = j->now.fallback;
    const invcal_status status = solve_degrees(&m, most, &j->now);

    if (status == INVCAL_NOT_ELLIPSOID && !invcal_has_prior(settings) &&
        invcal_undetermined(&j->sums.sum[0])) {
        return INVCAL_UNDETERMINED; /* what is left open may take any shape */
    }
    if (status != INVCAL_OK) {
        return status;
    }
    if (j->now.fallback == INVCAL_THERMAL_AS_ASKED) {
        j->now.fallback = why;
    }
    /* readings fit for the first pass, absurd after it */
    return gather(j) == INVCAL_OK ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

/* Sigma at the reference; the verdict is the worst over the range. */
static invcal_status assess(const job *j, const invcal_settings *settings, invcal_quality *quality)
{
    const invcal_real at[3] = {j->now.least, j->now.greatest, j->now.reference};
    invcal_verdict verdict = INVCAL_GOOD;
    uint16_t undetermined = 0;
    uint16_t from_prior = 0;

    for (unsigned i = 0; i < 3; i++) {
        const invcal_status status =
            invcal_thermal_assess(&j->sums, &j->now, settings, j->thermal, at[i], quality);
        if (status != INVCAL_OK) {
            return status;
        }
        verdict = quality->verdict > verdict ? quality->verdict : verdict;
        undetermined |= quality->undetermined;
        from_prior |= quality->from_prior;
    }
    quality->verdict = verdict;
    quality->undetermined = undetermined;
    quality->from_prior = from_prior;
    return INVCAL_OK;
}

/* The data may be noisier than stated: then the prior counts for more. */
static invcal_status weigh_thermal_prior(job *j, const invcal_settings *settings,
                                         invcal_quality *quality)
{
    const invcal_real coverage = quality->coverage;
    invcal_settings noisier = *settings;
    invcal_residuals residuals;

    gather_residuals(&j->sums, &j->now, &residuals);
    const invcal_real observed = quality->noise * settings->field / residuals.gain;
    noisier.noise = observed < settings->field ? observed : settings->field;
    invcal_status status = improve(j, &noisier, j->now.fitted);
    if (status == INVCAL_OK) {
        status = assess(j, &noisier, quality);
    }
    quality->coverage = coverage;
    return status;
}

static invcal_status run(job *j, const invcal_settings *settings, invcal_quality *quality)
{
    invcal_status status = gather(j);

    if (status == INVCAL_OK) {
        status = improve(j, settings, DEGREE - (unsigned)j->thermal->less);
    }
    if (status == INVCAL_OK) {
        status = improve(j, settings, j->now.fitted);
    }
    if (status == INVCAL_OK) {
        status = assess(j, settings, quality);
    }
    const problem m = {&j->sums, settings, j->thermal, &j->now, &j->start};
    return status == INVCAL_OK && has_prior(&m, j->now.fitted)
               ? weigh_thermal_prior(j, settings, quality)
               : status;
}

/* Centres the settings of the job, which are its own, and does it. */
static invcal_status start_and_run(job *j, const invcal_settings *settings,
                                   invcal_thermal_settings *centred, invcal_quality *quality)
{
    invcal_status status = centre(j->temperature, j->count, centred, &j->position);

    if (status == INVCAL_OK) {
        status = invcal_thermal_start(settings, centred, &j->start);
    }
    if (status == INVCAL_OK) {
        j->now = j->start;
        status = run(j, settings, quality);
    }
    return status;
}

invcal_status invcal_thermal_calibrate(const invcal_real *raw, const invcal_real *temperature,
                                       unsigned count, const invcal_settings *settings,
                                       const invcal_thermal_settings *thermal,
                                       invcal_thermal_calibration *out, invcal_quality *quality,
                                       invcal_reason *reason)
{
    invcal_thermal_settings centred;
    invcal_quality q;
    job j;

    INVCAL_ASSERT(((raw && temperature) || count == 0) && settings && thermal && out && quality);
    centred = *thermal;
    j.raw = raw;
    j.temperature = temperature;
    j.count = count;
    j.thermal = &centred;
    invcal_thermal_init(&j.sums);
    const invcal_status status = start_and_run(&j, settings, &centred, &q);
    if (status == INVCAL_OK) {
        *out = j.now;
        *quality = q;
    } else if (reason != NULL) {
        reason->position = j.position;
        reason->undetermined = invcal_undetermined(&j.sums.sum[0]);
    } /* cppcheck-suppress misra-c2012-15.7 ; nobody asks for the reason */
    return status;
}
