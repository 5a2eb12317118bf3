/* SPDX-License-Identifier: MIT */
#include "judge.h"

#include <stddef.h>

#include "solve.h"
#include "sums.h"
#include "invcal/expert.h"
#include "vector.h"

#define WEAK_K INVCAL_REAL(100.0)    /* square of 10. Above: usable only within its sigma */
#define HOPELESS_K INVCAL_REAL(1e6)  /* square of 1000. Above: refused */
#define NOISE_SHARE INVCAL_REAL(0.1) /* of the information on a parameter: above, it is weak */
#define ABSURD INVCAL_REAL(0.1)      /* rms of the residuals; above: no readings of one field */

/* Noise, alike on the raw axes, moves the length of a reading along eta by |M' eta| times itself, M
 * the matrix of the calibration. */
static invcal_real sensitivity(const invcal_calibration *c, const invcal_real eta[3])
{
    invcal_real square = 0;

    INVCAL_UNROLL
    for (unsigned j = 0; j < 3; j++) {
        const invcal_real x =
            c->matrix[0][j] * eta[0] + c->matrix[1][j] * eta[1] + c->matrix[2][j] * eta[2];
        square += x * x;
    }
    return square;
}

/* Mean square of |M' eta| over all directions. */
static invcal_real mean_sensitivity(const invcal_calibration *c)
{
    invcal_real sum = 0;

    for (unsigned i = 0; i < 3; i++) {
        sum += invcal_dot3(c->matrix[i], c->matrix[i]) / 3;
    }
    return sum;
}

/* Second pass, now with calibrated readings: residuals without cancellation, the covariance of unit
 * vectors, and each row weighted with the noise that it really has. */
static invcal_status compare(const invcal_positions *positions, const invcal_calibration *c,
                             invcal_sums *sums, invcal_quality *q)
{
    const invcal_real mean = mean_sensitivity(c);
    invcal_real squares = 0;
    invcal_row row;

    invcal_sums_init(sums);
    q->max = 0;
    for (unsigned i = 0; i < positions->count; i++) {
        if (invcal_is_left_out(positions, i)) {
            continue;
        }
        if (invcal_observe(c, &positions->raw[3 * (size_t)i], &row) != INVCAL_OK) {
            return INVCAL_NOT_ELLIPSOID; /* fit for the first pass, absurd after it */
        }
        invcal_sums_add_row(sums, &row, mean / sensitivity(c, row.h));
        /* j = (|eta|^2 - 1)/2 = (|eta| - 1)(|eta| + 1)/2 */
        const invcal_real r = 2 * row.j / (1 + INVCAL_SQRT(1 + 2 * row.j));
        squares += r * r;
        if (!(INVCAL_FABS(r) <= q->max)) {
            q->max = INVCAL_FABS(r);
            q->worst = (uint8_t)i;
        }
    }
    q->rms = INVCAL_SQRT(squares / (invcal_real)sums->count);
    return q->rms <= ABSURD ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

/* The larger of what is stated, in calibrated units, and what the residuals say. */
static void judge_noise(invcal_real stated, invcal_real weighted_squares, invcal_quality *q)
{
    const invcal_real observed =
        q->dof > 0 ? INVCAL_SQRT(weighted_squares / (invcal_real)q->dof) : 0;

    q->noise = observed > stated ? observed : stated;
    if (!(q->noise > 0)) {
        q->noise = 1; /* nobody knows: the whole field, which no one will mistake for good */
    }
}

/* From unit vectors back to the parameters. A deviation of the calibrated triad moves u by I + S
 * times it: scale errors and offsets of an axis by 1 + dk of it, the cross terms by the mean of
 * theirs. That is within 2 % of the whole Jacobian at errors of 10 %. */
static void spread(const invcal_calibration *nominal, const invcal_calibration *c,
                   invcal_real sigma[INVCAL_PARAMETERS])
{
    invcal_real cofactor[3][3];
    invcal_real length[3]; /* 1 + dk */

    const invcal_real det = invcal_cofactors(nominal->matrix, cofactor);
    for (unsigned i = 0; i < 3; i++) {
        length[i] = det / invcal_dot3(c->matrix[i], cofactor[i]); /* of (A N) N^-1 */
        sigma[INVCAL_DELTA_X + i] *= length[i];
        sigma[INVCAL_DK_X + i] *= length[i];
    }
    sigma[INVCAL_GAMMA_XY] *= (length[0] + length[1]) / 2;
    sigma[INVCAL_GAMMA_XZ] *= (length[0] + length[2]) / 2;
    sigma[INVCAL_GAMMA_ZY] *= (length[1] + length[2]) / 2;
}

/* sigma, weak and condition from L^-1. Weak: K is large, or the information 1 / K no more than what
 * noise in the readings themselves, about noise^2 in each row, adds to H'H: then directions that
 * determine nothing look as if they did. */
static invcal_status judge_parameters(const invcal_real *inverse, invcal_real trace, int is_known,
                                      invcal_quality *q)
{
    const invcal_real of_noise =
        is_known ? (invcal_real)q->positions * q->noise * q->noise / NOISE_SHARE : 0;
    invcal_real of_inverse = 0;

    q->weak = 0;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real k = invcal_variance(inverse, INVCAL_PARAMETERS, r);
        if (!(k <= HOPELESS_K)) {
            return INVCAL_UNDETERMINED;
        }
        if (!(k <= WEAK_K && k * of_noise <= 1)) {
            q->weak |= (uint16_t)(1u << r);
        }
        q->sigma[r] = q->noise * INVCAL_SQRT(k);
        of_inverse += k;
    }
    q->condition = trace * of_inverse;
    return q->condition * INVCAL_FLOOR < 2 ? INVCAL_OK : INVCAL_UNDETERMINED;
}

static invcal_status judge(const invcal_positions *positions, const invcal_calibration *c,
                           invcal_sums *sums, invcal_quality *q)
{
    invcal_real *a = sums->sum;
    invcal_status status = compare(positions, c, sums, q);

    if (status != INVCAL_OK) {
        return status;
    }
    q->left_out = positions->left_out;
    q->positions = (uint8_t)sums->count;
    q->dof = (uint8_t)(sums->count - INVCAL_PARAMETERS);
    const invcal_real stated =
        positions->noise * INVCAL_SQRT(mean_sensitivity(c) / mean_sensitivity(positions->nominal));
    judge_noise(stated, sums->sum[INVCAL_MOMENTS + INVCAL_PARAMETERS], q);
    invcal_sums_system(sums);
    const invcal_real trace = invcal_trace(a, INVCAL_PARAMETERS);
    status = invcal_factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS, INVCAL_FLOOR);
    if (status == INVCAL_OK) {
        invcal_invert(a, INVCAL_PARAMETERS);
        status = judge_parameters(a, trace, q->dof > 0 || positions->noise > 0, q);
    }
    if (status == INVCAL_OK) {
        spread(positions->nominal, c, q->sigma);
        q->verdict = (uint8_t)(q->weak      ? INVCAL_WEAK
                               : q->dof > 0 ? INVCAL_GOOD
                                            : INVCAL_NO_REDUNDANCY);
    }
    return status;
}

invcal_status invcal_positions_sum(const invcal_positions *positions, invcal_sums *sums)
{
    invcal_status status = INVCAL_OK;

    invcal_sums_init(sums);
    for (unsigned i = 0; i < positions->count && status == INVCAL_OK; i++) {
        if (!invcal_is_left_out(positions, i)) {
            status = invcal_sums_add(sums, positions->nominal, &positions->raw[3 * (size_t)i]);
        }
    }
    return status;
}

invcal_status invcal_positions_check(const invcal_positions *positions)
{
    if (!(positions->noise >= 0 && positions->noise < 1)) {
        return INVCAL_BAD_NOISE;
    }
    return positions->count <= UINT8_MAX ? invcal_nominal_check(positions->nominal)
                                         : INVCAL_BAD_COUNT;
}

/* Is what the sums have determined more than rounding? If not, readings calibrated by it may look
 * well spread all the same. tr A tr A^-1 is at least the condition. L stands in sums, and is lost. */
static int is_resolved(invcal_sums *sums, invcal_real trace)
{
    invcal_real of_inverse = 0;

    invcal_invert(sums->sum, INVCAL_PARAMETERS);
    for (unsigned i = 0; i < INVCAL_PACKED_SIZE(INVCAL_PARAMETERS); i++) {
        of_inverse += sums->sum[i] * sums->sum[i];
    }
    return trace * of_inverse * INVCAL_FLOOR < 2;
}

invcal_status invcal_positions_solve(const invcal_positions *positions, invcal_sums *sums,
                                     invcal_calibration *out, invcal_quality *q)
{
    invcal_status status = invcal_positions_sum(positions, sums);

    if (status != INVCAL_OK) {
        return status;
    }
    if (sums->count < INVCAL_PARAMETERS) {
        return INVCAL_TOO_FEW;
    }
    invcal_sums_system(sums);
    const invcal_real trace = invcal_trace(sums->sum, INVCAL_PARAMETERS);
    status = invcal_factor(sums->sum, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_FLOOR);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_back_substitute(sums->sum, INVCAL_PARAMETERS);
    if (!is_resolved(sums, trace)) {
        return INVCAL_UNDETERMINED;
    }
    status = invcal_ellipsoid(&sums->sum[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], out);
    if (status == INVCAL_OK) {
        status = invcal_behind(positions->nominal, out);
    }
    return status == INVCAL_OK ? judge(positions, out, sums, q) : status;
}
