/* SPDX-License-Identifier: MIT */
#include "invcal/quality.h"

#include <string.h>

#include "evidence.h"
#include "vector.h"

#define WEAK_ROOT_K INVCAL_REAL(10.0)       /* above: usable only within its sigma */
#define HOPELESS_ROOT_K INVCAL_REAL(1000.0) /* above: refused */
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
    //@ assert !\is_NaN(dof);
    const invcal_real n = dof < 1000 ? (invcal_real)(int)dof : 1000;
    return INVCAL_REAL(1.959964) +
           (INVCAL_REAL(2.372271) +
            (INVCAL_REAL(2.822498) + (INVCAL_REAL(2.555849) + INVCAL_REAL(1.589534) / n) / n) / n) /
               n;
}

/* The share of parameter r that the data told, 0 ... 1: 1 - posterior / prior variance. */
INVCAL_APART static invcal_real told_by_data(const invcal_evidence *e, unsigned r, invcal_real k)
{
    const invcal_real sigma = e->settings->prior[r];

    return sigma > 0 ? 1 - k * e->noise * e->noise / (sigma * sigma) : 1;
}

/* L^-1 of H'H with the prior into e->l. */
static invcal_status invert(invcal_evidence *e)
{
    const invcal_status status =
        invcal_information_factor(&e->residuals->normal, e->settings, &e->noise, e->l);

    if (status == INVCAL_OK) {
        invcal_cholesky_invert(e->l, INVCAL_PARAMETERS);
    }
    return status;
}

/* K(r,r), the square of a column of L^-1. */
INVCAL_APART static invcal_real variance(const invcal_evidence *e, unsigned r)
{
    invcal_real sum = 0;

    for (unsigned i = r; i < INVCAL_PARAMETERS; i++) {
        const invcal_real x = e->l[INVCAL_PACKED(i, r)];
        sum += x * x;
    }
    return sum;
}

/* How many parameters the data had to determine: what the prior supplies, at the noise stated,
 * does not count. */
static invcal_status parameters_of_data(invcal_evidence *e, invcal_real *parameters)
{
    *parameters = INVCAL_PARAMETERS;
    if (!invcal_has_prior(e->settings)) {
        return INVCAL_OK;
    }
    const invcal_status status = invert(e);
    if (status == INVCAL_OK) {
        *parameters = 0;
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            *parameters += told_by_data(e, r, variance(e, r));
        }
    }
    return status;
}

void invcal_evidence_noise(invcal_evidence *e, invcal_real stated, invcal_real parameters,
                           invcal_quality *q)
{
    const invcal_real dof = (invcal_real)e->residuals->count - parameters * e->share;

    q->dof = dof >= 1 ? dof : 0;
    const invcal_real observed = q->dof > 0 ? INVCAL_SQRT(e->residuals->normal.jtj / q->dof) : 0;
    const int is_stated = observed <= stated;
    q->noise = is_stated ? stated : observed;
    q->coverage = is_stated ? INVCAL_REAL(1.959964) : invcal_coverage(q->dof);
    if (!(q->noise > 0)) {
        q->noise = 1; /* nobody knows: the whole field, which no one will mistake for good */
    }
    e->noise = q->noise * INVCAL_SQRT(e->share);
}

/* noise, dof and coverage. The noise stated is that of readings: in calibrated units it is gain
 * times as large. */
static invcal_status judge_noise(invcal_evidence *e, invcal_quality *q)
{
    const invcal_real stated = e->residuals->gain * e->settings->noise / e->settings->field;
    invcal_real parameters;

    e->noise = stated * INVCAL_SQRT(e->share);
    const invcal_status status = parameters_of_data(e, &parameters);
    if (status == INVCAL_OK) {
        invcal_evidence_noise(e, stated, parameters, q);
    }
    return status;
}

/* The condition of H'H. Pivots alone let singular sets through now and then: one whose open
 * combination hardly involves the last parameters has no small pivot. */
static invcal_status judge_condition(invcal_evidence *e, invcal_quality *q)
{
    invcal_information(&e->residuals->normal, e->settings, &e->noise, e->l);
    q->noise = e->noise / INVCAL_SQRT(e->share); /* a prior may have raised it */
    q->condition = invcal_condition(e->l, INVCAL_PARAMETERS);
    return invcal_has_prior(e->settings) || q->condition * INVCAL_PIVOT_FLOOR < 1
               ? INVCAL_OK
               : INVCAL_UNDETERMINED;
}

/* Weak: sqrt(K) is large, or the information 1 / K is no more than what noise in the readings
 * themselves, about noise^2 in each row, adds to H'H: then directions that determine nothing
 * look as if they did. */
static int is_weak(const invcal_evidence *e, invcal_real k, const invcal_quality *q)
{
    const invcal_real stored = (invcal_real)e->residuals->count;
    const int known = q->dof > 0 || e->settings->noise > 0;
    const invcal_real of_noise = known ? k * stored * q->noise * q->noise : 0;

    return !(INVCAL_SQRT(k * e->share) <= WEAK_ROOT_K && of_noise <= NOISE_SHARE);
}

invcal_status invcal_evidence_parameters(const invcal_evidence *e, invcal_quality *q)
{
    q->undetermined = 0;
    q->from_prior = 0;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real k = variance(e, r);
        if (!(INVCAL_SQRT(k * e->share) <= HOPELESS_ROOT_K) && !(e->settings->prior[r] > 0)) {
            return INVCAL_UNDETERMINED;
        }
        q->undetermined |= (uint16_t)((is_weak(e, k, q) ? 1u : 0u) << r);
        q->from_prior |= (uint16_t)((told_by_data(e, r, k) >= INVCAL_REAL(0.5) ? 0u : 1u) << r);
    }
    q->verdict = q->undetermined ? INVCAL_WEAK : q->dof > 0 ? INVCAL_GOOD : INVCAL_NO_REDUNDANCY;
    return INVCAL_OK;
}

/* Residual figures; absurd ones are refused. */
static invcal_status judge_residuals(const invcal_residuals *residuals, invcal_quality *q)
{
    q->residual_rms = INVCAL_SQRT(residuals->squares / (invcal_real)residuals->count);
    q->residual_max = residuals->max;
    q->worst = residuals->worst;
    return q->residual_rms <= INVCAL_ABSURD_RESIDUAL ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

/* All that can be refused; leaves L^-1 in e->l. */
static invcal_status judge(invcal_evidence *e, invcal_quality *q)
{
    invcal_status status = judge_residuals(e->residuals, q);

    if (status == INVCAL_OK) {
        status = judge_noise(e, q);
    }
    if (status == INVCAL_OK) {
        status = judge_condition(e, q);
    }
    if (status == INVCAL_OK) {
        status = invert(e);
    }
    return status == INVCAL_OK ? invcal_evidence_parameters(e, q) : status;
}

/* sigma of a combination of calibrated parameters: x has its count factors from parameter first on.
 * Its variance is x'K x = |L^-1 x|^2. */
static invcal_real sigma_of(const invcal_evidence *e, const invcal_real *x, unsigned first,
                            unsigned count)
{
    invcal_real sum = 0;

    for (unsigned r = first; r < INVCAL_PARAMETERS; r++) {
        const unsigned terms = r - first < count ? r - first + 1 : count;
        const invcal_real y = invcal_dot(&e->l[INVCAL_PACKED(r, first)], x, terms);
        sum += y * y;
    }
    return e->noise * INVCAL_SQRT(sum);
}

/* A posterior is no wider than its prior; the Jacobian, taken beside it, may say so by a
 * second-order trifle. */
static invcal_real within_prior(const invcal_evidence *e, unsigned r, invcal_real sigma)
{
    const invcal_real prior = e->settings->prior[r];

    return prior > 0 && sigma > prior ? prior : sigma;
}

/* d delta = (I + S) d delta', and d offset = field N^-1 d delta. */
INVCAL_APART void invcal_evidence_spread_offset(const invcal_evidence *e, const invcal_real s[6],
                                                invcal_quality *q)
{
    const invcal_real rows[3][3] = {
        {1 + s[0], s[1], s[3]}, {s[1], 1 + s[2], s[4]}, {s[3], s[4], 1 + s[5]}};
    invcal_real inverse[3][3];
    invcal_real x[3];

    (void)invcal_calibration_inverse(&e->settings->nominal, inverse); /* checked before */
    //@ assert \initialized(&inverse[0 .. 2][0 .. 2]);
    for (unsigned i = 0; i < 3; i++) {
        q->sigma_delta[i] = within_prior(e, i, sigma_of(e, rows[i], INVCAL_DELTA_X, 3));
        for (unsigned j = 0; j < 3; j++) {
            /* of a symmetric matrix. In raw units: then no field unit makes squares overflow */
            x[j] = e->settings->field * invcal_dot(inverse[i], rows[j], 3);
        }
        q->sigma_offset[i] = sigma_of(e, x, INVCAL_DELTA_X, 3);
    }
}

/* The Jacobian of element (i,j) of P = I + S. A deviation S' in calibrated units makes
 * P^2 <- P (I + 2 S') P, so P dP + dP P = 2 P S' P: in the axes V of P, of semi-axes a,
 *
 *     (V' dP V)(m,n) = 2 a_m a_n / (a_m + a_n) (V' S' V)(m,n),
 *
 * the harmonic mean. Hence dP(i,j) = sum_mn W(m,n) S'(m,n) with W = V T V',
 * T(m,n) = V(i,m) V(j,n) 2 a_m a_n / (a_m + a_n), and a gamma' is S'(m,n) + S'(n,m). */
INVCAL_APART static void jacobian(const invcal_eigen3 *axes, unsigned i, unsigned j,
                                  invcal_real x[6])
{
    const invcal_real a[3] = {1 + axes->value[0], 1 + axes->value[1], 1 + axes->value[2]};
    invcal_real vt[3][3] = {{0}}; /* V T */
    invcal_real w[3][3];

    INVCAL_UNROLL
    for (unsigned m = 0; m < 3; m++) {
        INVCAL_UNROLL
        for (unsigned n = 0; n < 3; n++) {
            const invcal_real t =
                axes->vector[i][m] * axes->vector[j][n] * 2 * a[m] * a[n] / (a[m] + a[n]);
            INVCAL_UNROLL
            for (unsigned r = 0; r < 3; r++) {
                vt[r][n] += axes->vector[r][m] * t;
            }
        }
    }
    INVCAL_UNROLL
    for (unsigned r = 0; r < 3; r++) {
        INVCAL_UNROLL
        for (unsigned c = 0; c < 3; c++) {
            w[r][c] = invcal_dot(vt[r], axes->vector[c], 3);
        }
    }
    for (unsigned r = 0; r < 3; r++) {
        x[r] = w[r][r];
    }
    x[3] = (w[0][1] + w[1][0]) / 2;
    x[4] = (w[0][2] + w[2][0]) / 2;
    x[5] = (w[1][2] + w[2][1]) / 2;
}

/* dk(i) = P(i,i) - 1, gamma(ij) = 2 P(i,j). */
INVCAL_APART void invcal_evidence_spread_matrix(const invcal_evidence *e, const invcal_real s[6],
                                                invcal_quality *q)
{
    static const unsigned char pair[3][2] = {{0, 1}, {0, 2}, {2, 1}};
    invcal_eigen3 axes;
    invcal_real x[6]; /* of dk and gamma */

    invcal_eigen3_decompose(s, &axes);
    for (unsigned i = 0; i < 3; i++) {
        jacobian(&axes, i, i, x);
        q->sigma_dk[i] = within_prior(e, INVCAL_DK_X + i, sigma_of(e, x, INVCAL_DK_X, 6));
        jacobian(&axes, pair[i][0], pair[i][1], x);
        q->sigma_gamma[i] =
            within_prior(e, INVCAL_GAMMA_XY + i, 2 * sigma_of(e, x, INVCAL_DK_X, 6));
    }
}

/* Those of the parameters are bounded: by the condition, or by their priors. */
invcal_status invcal_evidence_check(const invcal_quality *q)
{
    return invcal_are_finite(q->sigma_offset) ? INVCAL_OK : INVCAL_BAD_SETTING;
}

invcal_status invcal_assess(const invcal_residuals *residuals, unsigned used,
                            const invcal_settings *settings, const invcal_solution *solution,
                            invcal_quality *quality)
{
    invcal_evidence e;
    invcal_quality q;

    INVCAL_ASSERT(residuals && settings && solution && quality);
    if (residuals->count == 0 || used < residuals->count) {
        return INVCAL_BAD_SETTING;
    }
    e.residuals = residuals;
    e.settings = settings;
    e.share = (invcal_real)residuals->count / (invcal_real)used;
    invcal_status status = invcal_settings_check(settings);
    if (status == INVCAL_OK) {
        status = judge(&e, &q);
    }
    if (status == INVCAL_OK) {
        invcal_real s[6];
        invcal_solution_deviation(solution, s);
        invcal_evidence_spread_offset(&e, s, &q);
        invcal_evidence_spread_matrix(&e, s, &q);
        status = invcal_evidence_check(&q);
    }
    if (status == INVCAL_OK) {
        *quality = q;
    }
    return status;
}

invcal_status invcal_covariance(const invcal_residuals *residuals, const invcal_settings *settings,
                                invcal_real noise,
                                invcal_real K[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)])
{
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];

    INVCAL_ASSERT(residuals && settings && K);
    if (!invcal_is_positive(noise) || invcal_settings_check(settings) != INVCAL_OK) {
        return INVCAL_BAD_SETTING;
    }
    const invcal_status status = invcal_information_factor(&residuals->normal, settings, &noise, l);
    if (status == INVCAL_OK) {
        invcal_cholesky_inverse(l, INVCAL_PARAMETERS);
        memcpy(K, l, sizeof l);
    }
    return status;
}
