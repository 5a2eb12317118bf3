/* SPDX-License-Identifier: MIT */
#include "invcal/solution.h"

#include <string.h>

#include "vector.h"

#define RIDGE INVCAL_REAL(1e-4) /* of the largest diagonal element: between weak and good */

/* The sensor model in its own axes: S = V diag(value) V'. Readings lie on the ellipsoid with the
 * centre delta and the semi-axes 1 + value. All matrices are kept as deviations from I, whose
 * ones would cost a float three of its seven digits. */
typedef struct {
    invcal_eigen3 axes;
    invcal_real delta[3];
} triad;

static unsigned parameters_without_prior(const invcal_settings *settings)
{
    unsigned count = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        count += !(settings->prior[r] > 0);
    }
    return count;
}

int invcal_has_prior(const invcal_settings *settings)
{
    INVCAL_ASSERT(settings);
    return parameters_without_prior(settings) < INVCAL_PARAMETERS;
}

static int is_usable_number(invcal_real x) /* for what may be 0: not known */
{
    return x >= 0 && x <= INVCAL_REAL_MAX;
}

invcal_status invcal_settings_check(const invcal_settings *settings)
{
    invcal_real inverse[3][3];

    INVCAL_ASSERT(settings);
    for (unsigned i = 0; i < 3; i++) {
        if (!invcal_is_finite(settings->nominal.offset[i])) {
            return INVCAL_BAD_SETTING;
        }
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (!is_usable_number(settings->prior[r])) {
            return INVCAL_BAD_SETTING;
        }
    }
    if (!(invcal_is_positive(settings->field) && is_usable_number(settings->noise) &&
          settings->noise <= settings->field) ||
        (invcal_has_prior(settings) && settings->noise == 0) ||
        (settings->frame != INVCAL_FRAME_SYMMETRIC && settings->frame != INVCAL_FRAME_TRIANGULAR)) {
        return INVCAL_BAD_SETTING;
    }
    return invcal_calibration_inverse(&settings->nominal, inverse);
}

/* The least noise with which the prior is more than rounding beside the largest sums. */
static invcal_real resolvable_noise(const invcal_normal *normal, const invcal_settings *settings)
{
    invcal_real widest = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        widest = settings->prior[r] > widest ? settings->prior[r] : widest;
    }
    return widest * INVCAL_SQRT(4 * INVCAL_EPSILON *
                                invcal_largest_diagonal(normal->hth, INVCAL_PARAMETERS));
}

invcal_status invcal_information(const invcal_normal *normal, const invcal_settings *settings,
                                 invcal_real *noise, invcal_normal *out)
{
    INVCAL_ASSERT(normal && settings && noise && out);
    *out = *normal;
    if (!invcal_has_prior(settings)) {
        return INVCAL_OK;
    }
    if (invcal_cholesky_factor(out->hth, INVCAL_PARAMETERS, 30 * INVCAL_PIVOT_FLOOR) != INVCAL_OK) {
        const invcal_real least = resolvable_noise(normal, settings);
        *noise = *noise >= least ? *noise : least;
    }
    *out = *normal;
    return invcal_normal_add_prior(out, settings->prior, *noise);
}

invcal_status invcal_information_factor(const invcal_normal *normal,
                                        const invcal_settings *settings, invcal_real *noise,
                                        invcal_normal *out)
{
    /* A prior holds what the positions leave open. */
    const invcal_real floor = invcal_has_prior(settings) ? INVCAL_EPSILON : INVCAL_PIVOT_FLOOR;
    const invcal_status status = invcal_information(normal, settings, noise, out);

    return status == INVCAL_OK ? invcal_cholesky_factor(out->hth, INVCAL_PARAMETERS, floor)
                               : status;
}

/* p = -(H'H + prior)^-1 H'J, in place of work->htj. */
static invcal_status solve_normal(const invcal_normal *normal, const invcal_settings *settings,
                                  invcal_normal *work)
{
    invcal_real noise = settings->noise / settings->field;

    if (normal->count == 0 || normal->count < parameters_without_prior(settings)) {
        return INVCAL_TOO_FEW;
    }
    const invcal_status status = invcal_information_factor(normal, settings, &noise, work);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_cholesky_solve(work->hth, INVCAL_PARAMETERS, work->htj);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        work->htj[r] = -work->htj[r];
    }
    return INVCAL_OK;
}

/* delta = -Q^-1 v, with Q = I + V diag(value) V'. */
static void centre(const invcal_real v[3], triad *t)
{
    invcal_real s[6]; /* Q^-1 - I */

    invcal_eigen3_inverse(&t->axes, s);
    t->delta[0] = -v[0] - (s[0] * v[0] + s[1] * v[1] + s[3] * v[2]);
    t->delta[1] = -v[1] - (s[1] * v[0] + s[2] * v[1] + s[4] * v[2]);
    t->delta[2] = -v[2] - (s[3] * v[0] + s[4] * v[1] + s[5] * v[2]);
}

/* The general form of an ellipsoid, p, to its centre and semi-axes. */
static void triad_of_ellipsoid(const invcal_real p[INVCAL_PARAMETERS], triad *t)
{
    const invcal_real q[6] = {2 * p[INVCAL_DK_X], p[INVCAL_GAMMA_XY], 2 * p[INVCAL_DK_Y],
                              p[INVCAL_GAMMA_XZ], p[INVCAL_GAMMA_ZY], 2 * p[INVCAL_DK_Z]};
    const invcal_real *v = p; /* the first three */

    /* Of Q - I. If zero lies outside the ellipsoid, Q and k are negative, and Q / k is positive
     * all the same. */
    invcal_eigen3_decompose(q, &t->axes);
    centre(v, t);
    /* k = 1 + delta Q delta = 1 - v delta, and I + S = (Q / k)^-1/2: with values q of Q - I,
     * s + 1 = sqrt(k / (1 + q)), s = (k - 1 - q) / (1 + q) / (s + 2) */
    const invcal_real excess = -invcal_dot(v, t->delta, 3);
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real value = t->axes.value[i];
        const invcal_real semi_axis = INVCAL_SQRT((1 + excess) / (1 + value));
        t->axes.value[i] = (excess - value) / (1 + value) / (semi_axis + 1);
    }
}

/* X = -p is the model itself. */
static void triad_of_linear(const invcal_real p[INVCAL_PARAMETERS], triad *t)
{
    const invcal_real s[6] = {-p[INVCAL_DK_X],         -p[INVCAL_GAMMA_XY] / 2, -p[INVCAL_DK_Y],
                              -p[INVCAL_GAMMA_XZ] / 2, -p[INVCAL_GAMMA_ZY] / 2, -p[INVCAL_DK_Z]};

    invcal_eigen3_decompose(s, &t->axes);
    for (unsigned i = 0; i < 3; i++) {
        t->delta[i] = -p[i];
    }
}

/* No square root of a negative number, no NaN, no absurd ellipsoid gets past here. */
static int is_plausible(const triad *t)
{
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real semi_axis = 1 + t->axes.value[i];
        if (!(semi_axis >= INVCAL_REAL(0.1) && semi_axis <= INVCAL_REAL(10.0))) {
            return 0;
        }
    }
    return invcal_dot(t->delta, t->delta, 3) <= 100;
}

/* A - I with A'A = (I + S)^-2: symmetric, or upper triangular. */
static void correction(const triad *t, invcal_frame frame, invcal_real a[3][3])
{
    invcal_real s[6];

    if (frame == INVCAL_FRAME_TRIANGULAR) {
        /* A = L' with L L' = (I + S)^-2; semi-axes of 0.1 ... 10 cannot make it fail */
        invcal_real f[3];
        for (unsigned i = 0; i < 3; i++) {
            const invcal_real semi_axis = 1 + t->axes.value[i];
            f[i] = 1 / (semi_axis * semi_axis);
        }
        invcal_eigen3_compose(&t->axes, f, s);
        (void)invcal_cholesky_factor(s, 3, 0);
        for (unsigned i = 0; i < 3; i++) {
            s[INVCAL_PACKED(i, i)] -= 1;
        }
    } else {
        invcal_eigen3_inverse(&t->axes, s);
    }
    for (unsigned r = 0; r < 3; r++) {
        for (unsigned c = 0; c <= r; c++) {
            a[r][c] = frame == INVCAL_FRAME_TRIANGULAR ? 0 : s[INVCAL_PACKED(r, c)];
            a[c][r] = s[INVCAL_PACKED(r, c)];
        }
    }
}

/* calibrated = field A (u - delta), u = N (raw - zero) / field: so matrix = A N and
 * offset = zero + field N^-1 delta. */
static invcal_status join(const triad *t, const invcal_settings *settings, invcal_calibration *out)
{
    const invcal_calibration *nominal = &settings->nominal;
    invcal_real inverse[3][3];
    invcal_real a[3][3];

    if (invcal_calibration_inverse(nominal, inverse) != INVCAL_OK) {
        return INVCAL_BAD_SETTING;
    }
    correction(t, settings->frame, a);
    for (unsigned r = 0; r < 3; r++) {
        out->offset[r] = nominal->offset[r] + settings->field * invcal_dot(inverse[r], t->delta, 3);
        for (unsigned c = 0; c < 3; c++) {
            out->matrix[r][c] = nominal->matrix[r][c] +
                                (a[r][0] * nominal->matrix[0][c] + a[r][1] * nominal->matrix[1][c] +
                                 a[r][2] * nominal->matrix[2][c]);
        }
    }
    return INVCAL_OK;
}

/* dk and gamma from S. */
static void name_parameters(const triad *t, invcal_solution *out)
{
    invcal_real s[6];

    invcal_eigen3_compose(&t->axes, t->axes.value, s);
    memcpy(out->delta, t->delta, sizeof out->delta);
    out->dk[0] = s[0];
    out->dk[1] = s[2];
    out->dk[2] = s[5];
    out->gamma[0] = 2 * s[1];
    out->gamma[1] = 2 * s[3];
    out->gamma[2] = 2 * s[4];
}

invcal_status invcal_solve(const invcal_normal *normal, const invcal_settings *settings,
                           invcal_solution *solution)
{
    invcal_normal work;
    triad t;
    invcal_calibration calibration;

    INVCAL_ASSERT(normal && settings && solution);
    invcal_status status = invcal_settings_check(settings);
    if (status == INVCAL_OK) {
        status = solve_normal(normal, settings, &work);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    if (work.model == INVCAL_MODEL_ELLIPSOID) {
        triad_of_ellipsoid(work.htj, &t);
    } else {
        triad_of_linear(work.htj, &t);
    }
    if (!is_plausible(&t)) {
        return INVCAL_NOT_ELLIPSOID;
    }
    status = join(&t, settings, &calibration);
    if (status == INVCAL_OK) {
        solution->calibration = calibration;
        name_parameters(&t, solution);
    }
    return status;
}

void invcal_solution_deviation(const invcal_solution *solution, invcal_real s[6])
{
    INVCAL_ASSERT(solution && s);
    s[0] = solution->dk[0];
    s[2] = solution->dk[1];
    s[5] = solution->dk[2];
    s[1] = solution->gamma[0] / 2;
    s[3] = solution->gamma[1] / 2;
    s[4] = solution->gamma[2] / 2;
}

uint16_t invcal_undetermined(const invcal_normal *normal)
{
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_real diagonal[INVCAL_PARAMETERS];
    uint16_t open = 0;

    INVCAL_ASSERT(normal);
    memcpy(l, normal->hth, sizeof l);
    const invcal_real ridge = RIDGE * invcal_largest_diagonal(l, INVCAL_PARAMETERS);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        l[INVCAL_PACKED(r, r)] += ridge;
    }
    if (invcal_cholesky_factor(l, INVCAL_PARAMETERS, INVCAL_EPSILON) != INVCAL_OK) {
        return (uint16_t)((1u << INVCAL_PARAMETERS) - 1);
    }
    invcal_cholesky_inverse_diagonal(l, INVCAL_PARAMETERS, diagonal);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        /* ridge K(r,r): the share of parameter r that the ridge holds, 0 ... 1 */
        open |= (uint16_t)((!(ridge * diagonal[r] <= INVCAL_REAL(0.1))) << r);
    }
    return open;
}
