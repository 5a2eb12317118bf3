/* SPDX-License-Identifier: MIT */
#include "invcal/solution.h"

#include <string.h>

#include "near.h"
#include "triad.h"
#include "vector.h"

#define LARGEST_SETTING                                                                            \
    (INVCAL_REAL_MAX * INVCAL_REAL(1e-6)) /* what comes of it fits the number type */

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

/* All but the nominal calibration. */
static int are_usable(const invcal_settings *settings)
{
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (!is_usable_number(settings->prior[r])) {
            return 0;
        }
    }
    return invcal_is_positive(settings->field) && is_usable_number(settings->noise) &&
           settings->noise <= settings->field &&
           (settings->noise > 0 || !invcal_has_prior(settings)) &&
           (settings->frame == INVCAL_FRAME_SYMMETRIC ||
            settings->frame == INVCAL_FRAME_TRIANGULAR);
}

/* Of the nominal calibration; a NaN is not. */
static int are_moderate(const invcal_settings *settings, invcal_real inverse[3][3])
{
    for (unsigned i = 0; i < 3; i++) {
        if (!(INVCAL_FABS(settings->nominal.offset[i]) <= LARGEST_SETTING)) {
            return 0;
        }
        for (unsigned j = 0; j < 3; j++) {
            if (!(INVCAL_FABS(settings->nominal.matrix[i][j]) <= LARGEST_SETTING &&
                  INVCAL_FABS(inverse[i][j]) * settings->field <= LARGEST_SETTING)) {
                return 0;
            }
        }
    }
    return 1;
}

static invcal_status check_settings(const invcal_settings *settings, invcal_real inverse[3][3])
{
    return are_usable(settings) &&
                   invcal_calibration_inverse(&settings->nominal, inverse) == INVCAL_OK &&
                   are_moderate(settings, inverse)
               ? INVCAL_OK
               : INVCAL_BAD_SETTING;
}

invcal_status invcal_settings_check(const invcal_settings *settings)
{
    invcal_real inverse[3][3];

    INVCAL_ASSERT(settings);
    return check_settings(settings, inverse);
}

/* The least noise with which the prior is more than rounding beside the largest sums. */
static invcal_real resolvable_noise(const invcal_settings *settings, invcal_real largest)
{
    invcal_real widest = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        widest = settings->prior[r] > widest ? settings->prior[r] : widest;
    }
    return widest * INVCAL_SQRT(4 * INVCAL_EPSILON * largest);
}

/* Parameter r is 0 with standard deviation prior[r]: one more row sigma / prior[r] p(r) = 0. */
static void add_settings_prior(const invcal_settings *settings, invcal_real noise, invcal_real *hth)
{
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (settings->prior[r] > 0) {
            const invcal_real ratio = noise / settings->prior[r];
            hth[INVCAL_PACKED(r, r)] += ratio * ratio;
        }
    }
}

void invcal_information(const invcal_normal *normal, const invcal_settings *settings,
                        invcal_real *noise, invcal_real hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)])
{
    INVCAL_ASSERT(normal && settings && noise && hth);
    invcal_normal_matrix(normal, hth);
    if (!invcal_has_prior(settings)) {
        return;
    }
    const invcal_real largest = invcal_largest_diagonal(hth, INVCAL_PARAMETERS);
    if (invcal_cholesky_factor(hth, INVCAL_PARAMETERS, 30 * INVCAL_PIVOT_FLOOR) != INVCAL_OK) {
        const invcal_real least = resolvable_noise(settings, largest);
        *noise = *noise >= least ? *noise : least;
    }
    invcal_normal_matrix(normal, hth);
    add_settings_prior(settings, *noise, hth);
}

invcal_status invcal_information_factor(const invcal_normal *normal,
                                        const invcal_settings *settings, invcal_real *noise,
                                        invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)])
{
    invcal_information(normal, settings, noise, l);
    /* A prior holds what the positions leave open. */
    return invcal_cholesky_factor(l, INVCAL_PARAMETERS,
                                  invcal_has_prior(settings) ? INVCAL_EPSILON : INVCAL_PIVOT_FLOOR);
}

/* p = -(H'H + prior)^-1 H'J */
INVCAL_APART static invcal_status solve_normal(const invcal_normal *normal,
                                               const invcal_settings *settings,
                                               invcal_real p[INVCAL_PARAMETERS])
{
    invcal_real noise = settings->noise / settings->field;
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];

    if (normal->count == 0 || normal->count < parameters_without_prior(settings)) {
        return INVCAL_TOO_FEW;
    }
    const invcal_status status = invcal_information_factor(normal, settings, &noise, l);
    if (status == INVCAL_OK) {
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            p[r] = -normal->htj[r];
        }
        invcal_cholesky_solve(l, INVCAL_PARAMETERS, p);
    }
    return status;
}

/* No square root of a negative number, no NaN gets past here. */
INVCAL_APART int invcal_triad_of_ellipsoid(const invcal_real p[INVCAL_PARAMETERS], invcal_triad *t)
{
    /* Q - I */
    const invcal_real q[6] = {2 * p[INVCAL_DK_X], p[INVCAL_GAMMA_XY], 2 * p[INVCAL_DK_Y],
                              p[INVCAL_GAMMA_XZ], p[INVCAL_GAMMA_ZY], 2 * p[INVCAL_DK_Z]};
    const invcal_real v[3] = {-p[0], -p[1], -p[2]};
    invcal_real f[6];

    /* delta = -Q^-1 v. If zero lies outside the ellipsoid, Q and k are negative, and Q / k is
     * positive all the same. */
    invcal_near_inverse(q, f);
    invcal_near_multiply(f, v, t->delta);
    /* k = 1 + delta Q delta = 1 - v delta, and A = (Q / k)^1/2 */
    const invcal_real excess = invcal_dot(v, t->delta, 3);
    for (unsigned i = 0; i < 6; i++) {
        const invcal_real of_unit = i == 0 || i == 2 || i == 5 ? excess : 0;
        f[i] = (q[i] - of_unit) / (1 + excess);
    }
    if (!invcal_near_is_between(f, INVCAL_SHORTEST * INVCAL_SHORTEST,
                                INVCAL_LONGEST * INVCAL_LONGEST)) {
        return 0;
    }
    invcal_near_root(f, t->a, t->s);
    return 1;
}

INVCAL_APART int invcal_triad_of_linear(const invcal_real p[INVCAL_PARAMETERS], invcal_triad *t)
{
    const invcal_real s[6] = {-p[INVCAL_DK_X],         -p[INVCAL_GAMMA_XY] / 2, -p[INVCAL_DK_Y],
                              -p[INVCAL_GAMMA_XZ] / 2, -p[INVCAL_GAMMA_ZY] / 2, -p[INVCAL_DK_Z]};

    for (unsigned i = 0; i < 3; i++) {
        t->delta[i] = -p[i];
    }
    memcpy(t->s, s, sizeof t->s);
    invcal_near_inverse(s, t->a);
    return invcal_near_is_between(s, INVCAL_SHORTEST, INVCAL_LONGEST);
}

/* A - I -> L' - I with L L' = A^2: the same lengths in another frame. Semi-axes within their
 * limits cannot make it fail. */
INVCAL_APART static void make_triangular(invcal_real a[6])
{
    const invcal_real rows[3][3] = {
        {1 + a[0], a[1], a[3]}, {a[1], 1 + a[2], a[4]}, {a[3], a[4], 1 + a[5]}};

    for (unsigned r = 0; r < 3; r++) {
        for (unsigned c = 0; c <= r; c++) {
            a[INVCAL_PACKED(r, c)] = invcal_dot(rows[r], rows[c], 3);
        }
    }
    (void)invcal_cholesky_factor(a, 3, 0);
    for (unsigned i = 0; i < 3; i++) {
        a[INVCAL_PACKED(i, i)] -= 1;
    }
}

/* calibrated = field A (u - delta), u = N (raw - zero) / field: so matrix = A N and
 * offset = zero + field N^-1 delta. */
static void join(const invcal_triad *t, const invcal_settings *settings, invcal_real inverse[3][3],
                 invcal_calibration *out)
{
    const invcal_calibration *nominal = &settings->nominal;
    const int is_upper = settings->frame == INVCAL_FRAME_TRIANGULAR;
    const invcal_real(*n)[3] = nominal->matrix;
    const invcal_real *a = t->a;

    for (unsigned i = 0; i < 3; i++) {
        out->offset[i] = nominal->offset[i] + settings->field * invcal_dot(inverse[i], t->delta, 3);
    }
    for (unsigned c = 0; c < 3; c++) {
        const invcal_real x = n[0][c];
        const invcal_real y = n[1][c];
        const invcal_real z = n[2][c];
        out->matrix[0][c] = x + (a[0] * x + a[1] * y + a[3] * z);
        out->matrix[1][c] = y + ((is_upper ? 0 : a[1] * x) + a[2] * y + a[4] * z);
        out->matrix[2][c] = z + ((is_upper ? 0 : a[3] * x + a[4] * y) + a[5] * z);
    }
}

/* dk and gamma from S. */
static void name_parameters(const invcal_triad *t, invcal_solution *out)
{
    memcpy(out->delta, t->delta, sizeof out->delta);
    out->dk[0] = t->s[0];
    out->dk[1] = t->s[2];
    out->dk[2] = t->s[5];
    out->gamma[0] = 2 * t->s[1];
    out->gamma[1] = 2 * t->s[3];
    out->gamma[2] = 2 * t->s[4];
}

invcal_status invcal_triad_join(invcal_triad *t, const invcal_settings *settings,
                                invcal_real inverse[3][3], invcal_solution *solution)
{
    if (!(invcal_dot(t->delta, t->delta, 3) <= INVCAL_LONGEST * INVCAL_LONGEST)) {
        return INVCAL_NOT_ELLIPSOID;
    }
    if (settings->frame == INVCAL_FRAME_TRIANGULAR) {
        make_triangular(t->a);
    }
    join(t, settings, inverse, &solution->calibration);
    name_parameters(t, solution);
    return INVCAL_OK;
}

invcal_status invcal_solve(const invcal_normal *normal, const invcal_settings *settings,
                           invcal_solution *solution)
{
    invcal_real inverse[3][3]; /* of the nominal matrix */
    invcal_real p[INVCAL_PARAMETERS];
    invcal_triad t;

    INVCAL_ASSERT(normal && settings && solution);
    invcal_status status = check_settings(settings, inverse);
    if (status == INVCAL_OK) {
        status = solve_normal(normal, settings, p);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    const int is_triad = normal->model == INVCAL_MODEL_ELLIPSOID ? invcal_triad_of_ellipsoid(p, &t)
                                                                 : invcal_triad_of_linear(p, &t);
    return is_triad ? invcal_triad_join(&t, settings, inverse, solution) : INVCAL_NOT_ELLIPSOID;
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
    invcal_normal_matrix(normal, l);
    const invcal_real ridge = INVCAL_RIDGE * invcal_largest_diagonal(l, INVCAL_PARAMETERS);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        l[INVCAL_PACKED(r, r)] += ridge;
    }
    if (invcal_cholesky_factor(l, INVCAL_PARAMETERS, INVCAL_EPSILON) != INVCAL_OK) {
        return (uint16_t)((1u << INVCAL_PARAMETERS) - 1);
    }
    invcal_cholesky_inverse_diagonal(l, INVCAL_PARAMETERS, diagonal);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        /* ridge K(r,r): the share of parameter r that the ridge holds, 0 ... 1 */
        open |= (uint16_t)((ridge * diagonal[r] <= INVCAL_REAL(0.1) ? 0u : 1u) << r);
    }
    return open;
}
