/* SPDX-License-Identifier: MIT */
#include "judge.h"

#include <stddef.h>

#include "solve.h"
#include "vector.h"

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

invcal_real invcal_mean_sensitivity(const invcal_calibration *c)
{
    return invcal_dot(c->matrix[0], c->matrix[0], 9) / 3;
}

void invcal_residuals_begin(invcal_quality *q)
{
    q->rms = 0;
    q->max = 0;
    q->worst = 0;
}

/* j = (|eta|^2 - 1)/2 = (|eta| - 1)(|eta| + 1)/2 */
invcal_status invcal_residuals_add(const invcal_calibration *c, invcal_real mean,
                                   const invcal_real raw[3], unsigned i, invcal_row *row,
                                   invcal_real *weight, invcal_quality *q)
{
    const invcal_status status = invcal_observe(c, raw, row);

    if (status != INVCAL_OK) {
        return status;
    }
    *weight = mean / sensitivity(c, row->h);
    const invcal_real r = 2 * row->j / (1 + INVCAL_SQRT(1 + 2 * row->j));
    q->rms += r * r;
    if (!(INVCAL_FABS(r) <= q->max)) {
        q->max = INVCAL_FABS(r);
        q->worst = (uint8_t)i;
    }
    return INVCAL_OK;
}

invcal_status invcal_residuals_end(unsigned count, invcal_quality *q)
{
    q->positions = (uint8_t)count;
    q->rms = INVCAL_SQRT(q->rms / (invcal_real)count);
    return q->rms <= ABSURD ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

/* Second pass, now with calibrated readings: residuals without cancellation, the covariance of unit
 * vectors, and each row weighted with the noise that it really has. */
static invcal_status compare(const invcal_positions *positions, const invcal_calibration *c,
                             invcal_sums *sums, invcal_quality *q)
{
    const invcal_real mean = invcal_mean_sensitivity(c);
    invcal_row row;
    invcal_real weight;

    invcal_sums_init(sums);
    invcal_residuals_begin(q);
    for (unsigned i = 0; i < positions->count; i++) {
        if (invcal_is_left_out(positions, i)) {
            continue;
        }
        if (invcal_residuals_add(c, mean, &positions->raw[3 * (size_t)i], i, &row, &weight, q) !=
            INVCAL_OK) {
            return INVCAL_NOT_ELLIPSOID; /* fit for the first pass, absurd after it */
        }
        invcal_sums_add_row(sums, &row, weight);
    }
    return invcal_residuals_end(sums->count, q);
}

void invcal_judge_noise(invcal_real stated, const invcal_calibration *nominal,
                        const invcal_calibration *c, invcal_real squares, invcal_real dof,
                        invcal_quality *q)
{
    const invcal_real observed = dof >= 1 ? INVCAL_SQRT(squares / dof) : 0;

    stated *= INVCAL_SQRT(invcal_mean_sensitivity(c) / invcal_mean_sensitivity(nominal));
    q->dof = (uint8_t)(dof >= 1 ? dof : 0);
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

void invcal_judge_parameters(const invcal_real k[INVCAL_PARAMETERS], int is_known,
                             const invcal_calibration *nominal, const invcal_calibration *c,
                             invcal_quality *q)
{
    const invcal_real of_noise =
        is_known ? (invcal_real)q->positions * q->noise * q->noise / NOISE_SHARE : 0;

    q->weak = 0;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (!(k[r] <= INVCAL_WEAK_K && k[r] * of_noise <= 1)) {
            q->weak |= (uint16_t)(1u << r);
        }
        q->sigma[r] = q->noise * INVCAL_SQRT(k[r]);
    }
    spread(nominal, c, q->sigma);
    q->verdict = (uint8_t)(q->weak ? INVCAL_WEAK : q->dof > 0 ? INVCAL_GOOD : INVCAL_NO_REDUNDANCY);
}

/* tr A^-1: the squares of all elements of L^-1. */
invcal_real invcal_condition(const invcal_real *inverse, unsigned n, invcal_real trace)
{
    return trace * invcal_dot(inverse, inverse, INVCAL_PACKED_SIZE(n));
}

/* L^-1 of the second pass; refuses what is more than badly determined. */
static invcal_status judge_system(invcal_real *a, invcal_real k[INVCAL_PARAMETERS],
                                  invcal_quality *q)
{
    const invcal_real trace = invcal_trace(a, INVCAL_PARAMETERS);
    const invcal_status status =
        invcal_factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS, INVCAL_FLOOR);

    if (status != INVCAL_OK) {
        return status;
    }
    invcal_invert(a, INVCAL_PARAMETERS);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        k[r] = invcal_variance(a, INVCAL_PARAMETERS, r);
        if (!(k[r] <= INVCAL_HOPELESS_K)) {
            return INVCAL_UNDETERMINED;
        }
    }
    q->condition = invcal_condition(a, INVCAL_PARAMETERS, trace);
    return invcal_is_resolved(q->condition) ? INVCAL_OK : INVCAL_UNDETERMINED;
}

static invcal_status judge(const invcal_positions *positions, const invcal_calibration *c,
                           invcal_sums *sums, invcal_quality *q)
{
    invcal_real k[INVCAL_PARAMETERS];
    invcal_status status = compare(positions, c, sums, q);

    if (status != INVCAL_OK) {
        return status;
    }
    q->left_out = positions->left_out;
    invcal_judge_noise(positions->noise, positions->nominal, c,
                       sums->sum[INVCAL_MOMENTS + INVCAL_PARAMETERS],
                       (invcal_real)(sums->count - INVCAL_PARAMETERS), q);
    invcal_sums_system(sums);
    status = judge_system(sums->sum, k, q);
    if (status == INVCAL_OK) {
        invcal_judge_parameters(k, q->dof > 0 || positions->noise > 0, positions->nominal, c, q);
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
 * well spread all the same. L stands in the sums, and is lost. */
static int are_resolved(invcal_real *l)
{
    invcal_real trace = invcal_dot(l, l, INVCAL_PACKED_SIZE(INVCAL_PARAMETERS));

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) { /* the diagonal of L is reciprocal */
        const invcal_real square = l[INVCAL_PACKED(r, r)] * l[INVCAL_PACKED(r, r)];
        trace += 1 / square - square;
    }
    invcal_invert(l, INVCAL_PARAMETERS);
    return invcal_is_resolved(invcal_condition(l, INVCAL_PARAMETERS, trace));
}

invcal_status invcal_positions_solve(const invcal_positions *positions, invcal_sums *sums,
                                     invcal_calibration *out, invcal_quality *q)
{
    invcal_status status = invcal_positions_sum(positions, sums);

    if (status != INVCAL_OK) {
        return status;
    }
    status = invcal_solve(sums, positions->nominal, out);
    /* what is left open may take any shape */
    if ((status == INVCAL_OK || status == INVCAL_NOT_ELLIPSOID) && !are_resolved(sums->sum)) {
        return INVCAL_UNDETERMINED;
    }
    return status == INVCAL_OK ? judge(positions, out, sums, q) : status;
}
