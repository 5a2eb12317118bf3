/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "../positions.h"
#include "arbitrary.h"
#include "calibrate/judge.h"
#include "thermal/polynomials.h"
#include "core/sums.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 30 -eva-slevel 12 -eva-slevel-merge-after-loop @all -eva-split-return full
// trusted: 1
// config: -DINVCAL_THERMAL_DEGREE=2
// config: -DINVCAL_THERMAL_DEGREE=0
// dead: judge_range 1
// The test for slopes is decided at compile time.
// dead: -DINVCAL_THERMAL_DEGREE=0 add_at 3 count_open 1 judge_range 6 solve_highest 6 try_degree 1 there is no lower degree, and no slope
// stubs: thermal solve nominal sums system judge apply

/* ---- what other modules do -------------------------------------------------------------------- */

#define UNKNOWN(array, count) Frama_C_make_unknown((char *)(array), (count) * sizeof *(array))

static invcal_status or_fail(invcal_status failure)
{
    return BETWEEN(0, 1) ? INVCAL_OK : failure;
}

static invcal_real any_real(void)
{
    invcal_real x;

    ANY(x);
    return x;
}

invcal_status invcali_thermal_triad(const invcal_thermal *thermal, invcal_real t,
                                    invcal_calibration *triad)
{
    (void)thermal->x[INVCAL_THERMAL_DEGREE][8];
    (void)t;
    ANY(*triad);
    return or_fail(INVCAL_NOT_ELLIPSOID);
}

invcal_status invcali_thermal_find(const invcal_thermal *thermal, invcal_real temperature,
                                   invcal_real *t, invcal_thermal_place *place)
{
    (void)thermal->span;
    (void)temperature;
    ANY(*t);
    *place = INVCAL_THERMAL_WITHIN;
    return or_fail(INVCAL_BAD_TEMPERATURE);
}

void invcali_polynomials(const invcal_real *c, unsigned degree, invcal_real t,
                         invcal_real out[INVCAL_PARAMETERS])
{
    (void)c[(degree + 1) * INVCAL_PARAMETERS - 1];
    (void)t;
    UNKNOWN(out, INVCAL_PARAMETERS);
}

invcal_status invcali_compose(const invcal_calibration *nominal, invcal_calibration *c)
{
    (void)nominal->matrix[2][2];
    (void)c->matrix[2][2];
    ANY(*c);
    return or_fail(INVCAL_BAD_NOMINAL);
}

invcal_status invcali_ellipsoid(const invcal_real p[INVCAL_PARAMETERS],
                                invcal_real work[INVCAL_WORK], invcal_calibration *out)
{
    (void)p[INVCAL_PARAMETERS - 1];
    UNKNOWN(work, INVCAL_WORK);
    ANY(*out);
    return or_fail(INVCAL_NOT_ELLIPSOID);
}

void invcali_correct(const invcal_calibration *calibration, const invcal_real raw[3],
                     invcal_real calibrated[3])
{
    (void)calibration->matrix[2][2];
    (void)raw[2];
    UNKNOWN(calibrated, 3);
}

void invcali_make_symmetric(invcal_real a[3][3], invcal_real work[INVCAL_WORK])
{
    (void)a[2][2];
    UNKNOWN(work, INVCAL_WORK);
    UNKNOWN(a, 3);
}

void invcali_inverse3(const invcal_real m[3][3], invcal_real inverse[3][3])
{
    (void)m[2][2];
    UNKNOWN(inverse, 3);
}

invcal_status invcali_nominal_check(const invcal_calibration *nominal)
{
    (void)nominal->matrix[2][2];
    return or_fail(INVCAL_BAD_NOMINAL);
}

invcal_status invcali_observe(const invcal_calibration *nominal, const invcal_real reading[3],
                              invcali_row *row)
{
    (void)nominal->matrix[2][2];
    (void)reading[2];
    ANY(*row);
    return BETWEEN(0, 1) ? INVCAL_OK : BETWEEN(0, 1) ? INVCAL_NOT_FINITE : INVCAL_OUT_OF_RANGE;
}

void invcali_rank_one(invcal_real *a, const invcal_real *v, unsigned n, invcal_real weight)
{
    for (unsigned i = 0; i < n; i++) {
        (void)(v[i] + weight);
    }
    UNKNOWN(a, INVCAL_PACKED_SIZE(n));
}

invcal_real invcali_trace(const invcal_real *a, unsigned n)
{
    (void)a[INVCAL_PACKED_SIZE(n) - 1];
    return any_real();
}

invcal_real invcali_largest_diagonal(const invcal_real *a, unsigned n)
{
    (void)a[INVCAL_PACKED_SIZE(n) - 1];
    return any_real();
}

invcal_status invcali_factor(invcal_real *a, unsigned n, unsigned rows, invcal_real floor)
{
    (void)n;
    (void)floor;
    UNKNOWN(a, INVCAL_PACKED_SIZE(rows));
    return or_fail(INVCAL_UNDETERMINED);
}

void invcali_back_substitute(invcal_real *l, unsigned n)
{
    UNKNOWN(l, INVCAL_PACKED_SIZE(n + 1));
}

void invcali_invert(invcal_real *l, unsigned n)
{
    UNKNOWN(l, INVCAL_PACKED_SIZE(n));
}

invcal_real invcali_variance(const invcal_real *inverse, unsigned n, unsigned r)
{
    (void)inverse[INVCAL_PACKED_SIZE(n) - 1];
    (void)(1 / (r < n)); /* an alarm if there is no such parameter */
    return any_real();
}

invcal_real invcali_condition(const invcal_real *inverse, unsigned n, invcal_real trace)
{
    (void)inverse[INVCAL_PACKED_SIZE(n) - 1];
    (void)trace;
    return any_real();
}

invcal_status invcali_positions_check(const invcal_positions *positions)
{
    (void)positions->nominal->matrix[2][2];
    return BETWEEN(0, 1) ? INVCAL_OK : BETWEEN(0, 1) ? INVCAL_BAD_NOISE : INVCAL_BAD_COUNT;
}

invcal_real invcali_dot(const invcal_real *a, const invcal_real *b, unsigned n)
{
    (void)(a[0] + a[n - 1]);
    (void)(b[0] + b[n - 1]);
    return any_real();
}

void invcali_products(const invcal_real eta[3], invcal_real g[INVCAL_PARAMETERS])
{
    (void)(eta[2] + g[2]);
    UNKNOWN(g, INVCAL_PARAMETERS);
}

void invcali_judge_noise(invcal_real stated, invcal_real squares, invcal_real dof,
                         invcal_real silent, invcal_quality *q)
{
    (void)(stated + squares + dof + silent);
    (void)q->verdict;
    ANY(q->noise);
    ANY(q->sigma_dof);
    q->verdict = (uint8_t)BETWEEN(INVCAL_GOOD, INVCAL_ROUGH);
}

void invcali_judge_parameters(const invcal_real a[3][3], invcal_quality *q)
{
    (void)(q->sigma[INVCAL_PARAMETERS - 1] + a[2][2] + q->noise);
    (void)(q->positions + q->dof + q->verdict);
    UNKNOWN(q->sigma, INVCAL_PARAMETERS);
    q->weak = (uint16_t)BETWEEN(0, 0x1FF);
    q->verdict = (uint8_t)BETWEEN(INVCAL_GOOD, INVCAL_ROUGH);
}

/* ---- the fit ---------------------------------------------------------------------------------- */

enum { COUNT = 100 };

static invcal_vector mean[COUNT];
static invcal_real temperature[COUNT];

static void any_look(void)
{
    invcal_thermal_fallback fallback;

    ANY(fallback);
    (void)invcal_thermal_fallback_text(fallback);
}

static void any_calibrate(void)
{
    invcal_calibration nominal;
    invcal_real noise;
    invcal_thermal out;
    invcal_quality quality;

    ANY(nominal);
    ANY(noise);
    (void)invcal_thermal_calibrate(POSITIONS_AT(NULL, NULL, 0, &nominal, noise),
                                   INVCAL_THERMAL_DEGREE, &out, &quality);
    (void)invcal_thermal_calibrate(
        POSITIONS_AT(mean, temperature, BETWEEN(1, COUNT), &nominal, noise), INVCAL_THERMAL_DEGREE,
        &out, &quality);
}

/* From a base with that many coefficients fitted. */
static void any_fit(const invcal_thermal_prior *prior, unsigned fitted)
{
    invcal_calibration nominal;
    invcal_positions positions = {mean, BETWEEN(0, COUNT), &nominal, 0, temperature};
    invcal_thermal base;
    invcal_thermal out;
    invcal_quality quality;
    invcal_real at;

    ANY(nominal);
    ANY(positions.noise);
    ANY(base);
    ANY(at);
    base.fitted = (uint8_t)fitted;
    for (unsigned degree = 0; degree <= INVCAL_THERMAL_DEGREE + 1; degree++) {
        (void)invcal_thermal_fit(&positions, prior, &base, degree, &out, &quality);
        (void)invcal_thermal_fit(&positions, prior, NULL, degree, &out, &quality);
    }
    (void)invcal_thermal_judge(&positions, prior, &base, at, &quality);
    positions.temperature = NULL;
    (void)invcal_thermal_fit(&positions, prior, &base, 0, &out, &quality);
}

void main(void)
{
    invcal_thermal_prior prior;

    ANY(mean);
    ANY(temperature);
    ANY(prior);
    any_look();
    any_calibrate();
    for (unsigned fitted = 0; fitted <= INVCAL_THERMAL_DEGREE + 1; fitted++) {
        any_fit(NULL, fitted);
        any_fit(&prior, fitted);
    }
}
