/* SPDX-License-Identifier: MIT */
#include "invcal/quality.h"

#include <string.h>

#include "vector.h"

#define WEAK_ROOT_K INVCAL_REAL(10.0)       /* above: usable only within its sigma */
#define HOPELESS_ROOT_K INVCAL_REAL(1000.0) /* above: refused */
#define ABSURD_RESIDUAL INVCAL_REAL(0.1)
#define NOISE_SHARE INVCAL_REAL(0.1) /* of the information on a parameter: above, it is weak */

const char *invcal_verdict_text(invcal_verdict verdict)
{
    return verdict == INVCAL_GOOD            ? "good"
           : verdict == INVCAL_NO_REDUNDANCY ? "no redundancy"
           : verdict == INVCAL_WEAK          ? "weak"
                                             : "unknown verdict";
}

/* Cornish and Fisher's expansion of Student's quantile about the normal one, z = 1.96
 * (Abramowitz and Stegun 26.7.5); it needs 3 degrees of freedom, the first two have their own. */
invcal_real invcal_coverage(invcal_real dof)
{
    if (!(dof >= 2)) {
        return INVCAL_REAL(12.7062);
    }
    if (dof < 3) {
        return INVCAL_REAL(4.30265);
    }
    const invcal_real n = dof < 1000 ? (invcal_real)(int)dof : 1000;
    return INVCAL_REAL(1.959964) +
           (INVCAL_REAL(2.372271) +
            (INVCAL_REAL(2.822498) + (INVCAL_REAL(2.555849) + INVCAL_REAL(1.589534) / n) / n) / n) /
               n;
}

/* H'H in calibrated units (+ prior). */
static invcal_status information(const invcal_residuals *residuals, const invcal_settings *settings,
                                 invcal_real noise, invcal_normal *out)
{
    *out = residuals->normal;
    return invcal_has_prior(settings) ? invcal_normal_add_prior(out, settings->prior, noise)
                                      : INVCAL_OK;
}

/* L of the same. Without a prior nothing near rounding error passes. */
static invcal_status factor(const invcal_residuals *residuals, const invcal_settings *settings,
                            invcal_real noise, invcal_normal *out)
{
    const invcal_real floor = invcal_has_prior(settings) ? INVCAL_EPSILON : INVCAL_PIVOT_FLOOR;
    const invcal_status status = information(residuals, settings, noise, out);

    return status == INVCAL_OK ? invcal_cholesky_factor(out->hth, INVCAL_PARAMETERS, floor)
                               : status;
}

/* The share of parameter r that the data told, 0 ... 1: 1 - posterior / prior variance. */
static invcal_real told_by_data(const invcal_settings *settings, unsigned r, invcal_real k,
                                invcal_real noise)
{
    const invcal_real sigma = settings->prior[r];

    return sigma > 0 ? 1 - k * noise * noise / (sigma * sigma) : 1;
}

/* The noise of a position mean in calibrated units over field, as stated, but no less than the
 * prior can be resolved with. */
static invcal_real stated_noise(const invcal_residuals *residuals, const invcal_settings *settings)
{
    const invcal_real stated = residuals->gain * settings->noise / settings->field;
    const invcal_real least = invcal_normal_prior_noise(&residuals->normal, settings->prior);

    return stated > least ? stated : least;
}

/* Positions minus the parameters that the data had to determine, 0 if less than one is left. */
static invcal_real freedom(const invcal_residuals *residuals, invcal_real used,
                           invcal_real parameters)
{
    const invcal_real stored = (invcal_real)residuals->count;
    const invcal_real dof = stored - parameters * stored / used;

    return dof >= 1 ? dof : 0;
}

/* How many parameters the data had to determine: what the prior supplies, at the noise stated,
 * does not count. */
static invcal_status parameters_of_data(const invcal_residuals *residuals,
                                        const invcal_settings *settings, invcal_real stated,
                                        invcal_normal *work, invcal_real *parameters)
{
    invcal_real diagonal[INVCAL_PARAMETERS];

    *parameters = INVCAL_PARAMETERS;
    if (!invcal_has_prior(settings)) {
        return INVCAL_OK;
    }
    const invcal_status status = factor(residuals, settings, stated, work);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_cholesky_inverse_diagonal(work->hth, INVCAL_PARAMETERS, diagonal);
    *parameters = 0;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        *parameters += told_by_data(settings, r, diagonal[r], stated);
    }
    return INVCAL_OK;
}

/* noise, dof and coverage. */
static invcal_status judge_noise(const invcal_residuals *residuals, invcal_real used,
                                 const invcal_settings *settings, invcal_normal *work,
                                 invcal_quality *q)
{
    const invcal_real stated = stated_noise(residuals, settings);
    invcal_real parameters;
    const invcal_status status = parameters_of_data(residuals, settings, stated, work, &parameters);

    if (status != INVCAL_OK) {
        return status;
    }
    q->dof = freedom(residuals, used, parameters);
    const invcal_real observed = q->dof > 0 ? INVCAL_SQRT(residuals->normal.jtj / q->dof) : 0;
    q->noise = observed > stated ? observed : stated;
    q->coverage = observed > stated ? invcal_coverage(q->dof) : INVCAL_REAL(1.959964);
    if (!(q->noise > 0)) {
        q->noise = 1; /* nobody knows: the whole field, which no one will mistake for good */
    }
    return INVCAL_OK;
}

/* sigma of the combination x of calibrated parameters; x is lost. */
static invcal_real sigma_of(const invcal_real *l, invcal_real noise, invcal_real *x)
{
    invcal_cholesky_forward(l, INVCAL_PARAMETERS, x);
    return noise * INVCAL_SQRT(invcal_dot(x, x, INVCAL_PARAMETERS));
}

/* A posterior is no wider than its prior; the Jacobian, taken beside it, may say so by a
 * second-order trifle. */
static invcal_real within_prior(invcal_real sigma, invcal_real prior)
{
    return prior > 0 && sigma > prior ? prior : sigma;
}

/* d delta = (I + S) d delta', and d offset = field N^-1 d delta. */
static void judge_offset(const invcal_real s[6], invcal_real inverse[3][3],
                         const invcal_settings *settings, const invcal_real *l, invcal_quality *q)
{
    const invcal_real rows[3][3] = {
        {1 + s[0], s[1], s[3]}, {s[1], 1 + s[2], s[4]}, {s[3], s[4], 1 + s[5]}};

    for (unsigned i = 0; i < 3; i++) {
        invcal_real x[INVCAL_PARAMETERS] = {rows[i][0], rows[i][1], rows[i][2]};
        q->sigma_delta[i] = within_prior(sigma_of(l, q->noise, x), settings->prior[i]);

        invcal_real y[INVCAL_PARAMETERS] = {0};
        for (unsigned j = 0; j < 3; j++) {
            y[j] = settings->field * (inverse[i][0] * rows[0][j] + inverse[i][1] * rows[1][j] +
                                      inverse[i][2] * rows[2][j]);
        }
        q->sigma_offset[i] = sigma_of(l, q->noise, y);
    }
}

/* The Jacobian of element (i,j) of P = I + S. A deviation S' in calibrated units makes
 * P^2 <- P (I + 2 S') P, so P dP + dP P = 2 P S' P: in the axes V of P, of semi-axes a,
 *
 *     (V' dP V)(m,n) = 2 a_m a_n / (a_m + a_n) (V' S' V)(m,n),
 *
 * the harmonic mean. Hence dP(i,j) = sum_mn W(m,n) S'(m,n) with W = V T V',
 * T(m,n) = V(i,m) V(j,n) 2 a_m a_n / (a_m + a_n), and a gamma' is S'(m,n) + S'(n,m). */
static void jacobian(const invcal_eigen3 *axes, unsigned i, unsigned j, invcal_real *x)
{
    const invcal_real a[3] = {1 + axes->value[0], 1 + axes->value[1], 1 + axes->value[2]};
    invcal_real vt[3][3] = {{0}}; /* V T */
    invcal_real w[3][3];

    for (unsigned m = 0; m < 3; m++) {
        for (unsigned n = 0; n < 3; n++) {
            const invcal_real t =
                axes->vector[i][m] * axes->vector[j][n] * 2 * a[m] * a[n] / (a[m] + a[n]);
            for (unsigned r = 0; r < 3; r++) {
                vt[r][n] += axes->vector[r][m] * t;
            }
        }
    }
    for (unsigned r = 0; r < 3; r++) {
        for (unsigned c = 0; c < 3; c++) {
            w[r][c] = invcal_dot(vt[r], axes->vector[c], 3);
        }
    }
    x[INVCAL_DELTA_X] = x[INVCAL_DELTA_Y] = x[INVCAL_DELTA_Z] = 0;
    x[INVCAL_DK_X] = w[0][0];
    x[INVCAL_DK_Y] = w[1][1];
    x[INVCAL_DK_Z] = w[2][2];
    x[INVCAL_GAMMA_XY] = (w[0][1] + w[1][0]) / 2;
    x[INVCAL_GAMMA_XZ] = (w[0][2] + w[2][0]) / 2;
    x[INVCAL_GAMMA_ZY] = (w[1][2] + w[2][1]) / 2;
}

/* dk(i) = P(i,i) - 1, gamma(ij) = 2 P(i,j). */
static void judge_matrix(const invcal_real s[6], const invcal_settings *settings,
                         const invcal_real *l, invcal_quality *q)
{
    static const unsigned char pair[3][2] = {{0, 1}, {0, 2}, {2, 1}};
    invcal_eigen3 axes;
    invcal_real x[INVCAL_PARAMETERS];

    invcal_eigen3_decompose(s, &axes);
    for (unsigned i = 0; i < 3; i++) {
        jacobian(&axes, i, i, x);
        q->sigma_dk[i] = within_prior(sigma_of(l, q->noise, x), settings->prior[INVCAL_DK_X + i]);
        jacobian(&axes, pair[i][0], pair[i][1], x);
        q->sigma_gamma[i] =
            within_prior(2 * sigma_of(l, q->noise, x), settings->prior[INVCAL_GAMMA_XY + i]);
    }
}

/* Weak: sqrt(K) is large, or the information 1 / K is no more than what noise in the readings
 * themselves, about noise^2 in each row, adds to H'H: then directions that determine nothing
 * look as if they did. */
static int is_weak(const invcal_quality *q, invcal_real k, invcal_real used)
{
    const invcal_real share = q->dof > 0 ? k * used * q->noise * q->noise : 0;

    return !(INVCAL_SQRT(k) <= WEAK_ROOT_K && share <= NOISE_SHARE);
}

/* undetermined, from_prior and the verdict, from the diagonal of K. */
static invcal_status judge_parameters(const invcal_settings *settings, invcal_real used,
                                      const invcal_real *diagonal, invcal_quality *q)
{
    q->undetermined = 0;
    q->from_prior = 0;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real told = told_by_data(settings, r, diagonal[r], q->noise);
        if (!(INVCAL_SQRT(diagonal[r]) <= HOPELESS_ROOT_K) && !(settings->prior[r] > 0)) {
            return INVCAL_UNDETERMINED;
        }
        q->undetermined |= (uint16_t)(is_weak(q, diagonal[r], used) << r);
        q->from_prior |= (uint16_t)((!(told >= INVCAL_REAL(0.5))) << r);
    }
    q->verdict = q->undetermined ? INVCAL_WEAK : q->dof > 0 ? INVCAL_GOOD : INVCAL_NO_REDUNDANCY;
    return INVCAL_OK;
}

/* The condition of H'H. Pivots alone let singular sets through now and then: one whose open
 * combination hardly involves the last parameters has no small pivot. */
static invcal_status judge_condition(const invcal_residuals *residuals,
                                     const invcal_settings *settings, invcal_normal *work,
                                     invcal_quality *q)
{
    const invcal_status status = information(residuals, settings, q->noise, work);

    if (status != INVCAL_OK) {
        return status;
    }
    q->condition = invcal_condition(work->hth, INVCAL_PARAMETERS);
    return invcal_has_prior(settings) || q->condition * INVCAL_PIVOT_FLOOR < 1
               ? INVCAL_OK
               : INVCAL_UNDETERMINED;
}

/* Residual figures; absurd ones are refused. */
static invcal_status judge_residuals(const invcal_residuals *residuals, invcal_quality *q)
{
    q->residual_rms = INVCAL_SQRT(residuals->squares / (invcal_real)residuals->count);
    q->residual_max = residuals->max;
    q->worst = residuals->worst;
    return q->residual_rms <= ABSURD_RESIDUAL ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

static int is_usable(const invcal_residuals *residuals, invcal_real used,
                     const invcal_settings *settings)
{
    return residuals->count > 0 && used >= (invcal_real)residuals->count &&
           used <= INVCAL_REAL_MAX && invcal_is_positive(settings->field) &&
           (settings->noise == 0 || invcal_is_positive(settings->noise));
}

/* All that can be refused, in order of cost; leaves L in work. */
static invcal_status judge(const invcal_residuals *residuals, invcal_real used,
                           const invcal_settings *settings, invcal_normal *work, invcal_quality *q)
{
    invcal_real diagonal[INVCAL_PARAMETERS];
    invcal_status status = judge_residuals(residuals, q);

    if (status == INVCAL_OK) {
        status = judge_noise(residuals, used, settings, work, q);
    }
    if (status == INVCAL_OK) {
        status = judge_condition(residuals, settings, work, q);
    }
    if (status == INVCAL_OK) {
        status = factor(residuals, settings, q->noise, work);
    }
    if (status == INVCAL_OK) {
        invcal_cholesky_inverse_diagonal(work->hth, INVCAL_PARAMETERS, diagonal);
        status = judge_parameters(settings, used, diagonal, q);
    }
    return status;
}

invcal_status invcal_assess(const invcal_residuals *residuals, invcal_real used,
                            const invcal_settings *settings, const invcal_solution *solution,
                            invcal_quality *quality)
{
    invcal_quality q;
    invcal_normal work;
    invcal_real s[6];
    invcal_real inverse[3][3];

    INVCAL_ASSERT(residuals && settings && solution && quality);
    if (!is_usable(residuals, used, settings) ||
        invcal_calibration_inverse(&settings->nominal, inverse) != INVCAL_OK) {
        return INVCAL_BAD_SETTING;
    }
    const invcal_status status = judge(residuals, used, settings, &work, &q);
    if (status == INVCAL_OK) {
        invcal_solution_deviation(solution, s);
        judge_offset(s, inverse, settings, work.hth, &q);
        judge_matrix(s, settings, work.hth, &q);
        *quality = q;
    }
    return status;
}

invcal_status invcal_covariance(const invcal_residuals *residuals, const invcal_settings *settings,
                                invcal_real noise,
                                invcal_real K[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)])
{
    invcal_normal work;

    INVCAL_ASSERT(residuals && settings && K);
    const invcal_status status = factor(residuals, settings, noise, &work);
    if (status == INVCAL_OK) {
        invcal_cholesky_inverse(work.hth, INVCAL_PARAMETERS);
        memcpy(K, work.hth, sizeof work.hth);
    }
    return status;
}
