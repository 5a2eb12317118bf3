/* SPDX-License-Identifier: MIT */
#include "judge.h"

#include <stddef.h>
#include <string.h>

#include "solve.h"
#include "vector.h"

#define WEAK INVCAL_REAL(10.0)       /* sigma over noise. Above: usable only within its sigma */
#define NOISE_SHARE INVCAL_REAL(0.1) /* of the information on a parameter: above, it is weak */
#define ABSURD INVCAL_REAL(0.1)      /* rms of the residuals; above: no readings of one field */
#define OPEN INVCAL_REAL(1e4)        /* quality.condition; above: parameters are left open */

/* ---- residuals ---------------------------------------------------------------------------------- */

void invcal_residuals_begin(invcal_quality *q)
{
    q->rms = 0;
    q->max = 0;
    q->worst = 0;
}

/* Noise of u, alike on its axes, moves the length of eta = A (u - delta) by |A eta| times itself. */
static invcal_real sensitivity2(const invcal_real a[3][3], const invcal_real eta[3])
{
    invcal_real square = 0;

    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real x = a[i][0] * eta[0] + a[i][1] * eta[1] + a[i][2] * eta[2];
        square += x * x;
    }
    return square;
}

/* j = (|eta|^2 - 1)/2 = (|eta| - 1)(|eta| + 1)/2 */
invcal_status invcal_residuals_add(const invcal_calibration *c, const invcal_real a[3][3],
                                   const invcal_real raw[3], unsigned i, invcal_row *row,
                                   invcal_real *weight, invcal_quality *q)
{
    const invcal_status status = invcal_observe(c, raw, row);

    if (status != INVCAL_OK) {
        return status;
    }
    *weight = 1 / sensitivity2(a, row->h);
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
invcal_status invcal_positions_compare(const invcal_positions *positions,
                                       const invcal_calibration *c, const invcal_real a[3][3],
                                       invcal_sums *sums, invcal_quality *q)
{
    invcal_row row;
    invcal_real weight;

    invcal_sums_init(sums);
    invcal_residuals_begin(q);
    q->left_out = positions->left_out;
    for (unsigned i = 0; i < positions->count; i++) {
        if (invcal_is_left_out(positions, i)) {
            continue;
        }
        if (invcal_residuals_add(c, a, &positions->raw[3 * (size_t)i], i, &row, &weight, q) !=
            INVCAL_OK) {
            return INVCAL_NOT_ELLIPSOID; /* fit for the first pass, absurd after it */
        }
        invcal_sums_add_row(sums, &row, weight);
    }
    return invcal_residuals_end(sums->count, q);
}

/* ---- judgement ---------------------------------------------------------------------------------- */

void invcal_judge_noise(invcal_real stated, invcal_real squares, invcal_real dof, invcal_quality *q)
{
    const invcal_real observed = dof >= 1 ? INVCAL_SQRT(squares / dof) : 0;

    q->dof = (uint8_t)(dof >= 1 ? dof : 0);
    q->noise = observed > stated ? observed : stated;
    if (!(q->noise > 0)) {
        q->noise = 1; /* nobody knows: the whole field, which no one will mistake for good */
    }
}

/* From unit vectors back to the parameters. A deviation of the calibrated triad moves u by I + S
 * times it: scale errors and offsets of an axis by 1 + dk of it, the cross terms by the geometric mean of
 * theirs. That is within 2 % of the whole Jacobian at errors of 10 %. */
void invcal_judge_parameters(const invcal_real k[INVCAL_PARAMETERS], int is_known,
                             const invcal_real a[3][3], invcal_quality *q)
{
    /* of x y z xx yy zz xy xz yz */
    static const uint8_t one[INVCAL_PARAMETERS] = {0, 1, 2, 0, 1, 2, 0, 0, 1};
    static const uint8_t other[INVCAL_PARAMETERS] = {0, 1, 2, 0, 1, 2, 1, 2, 2};
    const invcal_real of_noise =
        is_known ? (invcal_real)q->positions * q->noise * q->noise / NOISE_SHARE : 0;

    q->weak = 0;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real ratio = INVCAL_SQRT(k[r] / (a[one[r]][one[r]] * a[other[r]][other[r]]));
        if (!(ratio <= WEAK && k[r] * of_noise <= 1)) {
            q->weak |= (uint16_t)(1u << r);
        }
        q->sigma[r] = q->noise * ratio;
    }
    q->verdict = (uint8_t)(q->weak ? INVCAL_WEAK : q->dof > 0 ? INVCAL_GOOD : INVCAL_NO_REDUNDANCY);
}

/* tr A^-1: the squares of all elements of L^-1. */
invcal_real invcal_condition(const invcal_real *inverse, unsigned n, invcal_real trace)
{
    return trace * invcal_dot(inverse, inverse, INVCAL_PACKED_SIZE(n));
}

/* ---- both passes -------------------------------------------------------------------------------- */

invcal_status invcal_positions_check(const invcal_positions *positions)
{
    if (!(positions->noise >= 0 && positions->noise < 1)) {
        return INVCAL_BAD_NOISE;
    }
    return positions->count <= UINT8_MAX ? invcal_nominal_check(positions->nominal)
                                         : INVCAL_BAD_COUNT;
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

/* The sums to p and L^-1. Is what they determine more than rounding? If not in nominal units, readings
 * calibrated by it may look well spread all the same. */
static invcal_status determine(invcal_sums *sums, invcal_real *condition)
{
    invcal_real *a = sums->sum;

    invcal_sums_system(sums);
    const invcal_real trace = invcal_trace(a, INVCAL_PARAMETERS);
    const invcal_status status =
        invcal_factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS + 1, INVCAL_FLOOR);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_back_substitute(a, INVCAL_PARAMETERS);
    invcal_invert(a, INVCAL_PARAMETERS);
    *condition = invcal_condition(a, INVCAL_PARAMETERS, trace);
    return invcal_is_resolved(*condition) ? INVCAL_OK : INVCAL_UNDETERMINED;
}

static invcal_status judge(const invcal_positions *positions, const invcal_calibration *c,
                           const invcal_real a[3][3], invcal_sums *sums, invcal_quality *q)
{
    invcal_real k[INVCAL_PARAMETERS];
    invcal_status status = invcal_positions_compare(positions, c, a, sums, q);

    if (status != INVCAL_OK) {
        return status;
    }
    invcal_judge_noise(positions->noise, sums->sum[INVCAL_MOMENTS + INVCAL_PARAMETERS],
                       (invcal_real)(sums->count - INVCAL_PARAMETERS), q);
    status = determine(sums, &q->condition);
    if (status != INVCAL_OK) {
        return status;
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        k[r] = invcal_variance(sums->sum, INVCAL_PARAMETERS, r);
        if (INVCAL_DOUBLE && !(k[r] <= INVCAL_HOPELESS_K)) { /* never, in float: is_resolved */
            return INVCAL_UNDETERMINED;
        }
    }
    invcal_judge_parameters(k, q->dof > 0 || positions->noise > 0, a, q);
    return INVCAL_OK;
}

invcal_status invcal_positions_solve(const invcal_positions *positions, invcal_sums *sums,
                                     invcal_calibration *out, invcal_quality *q)
{
    invcal_real a[3][3];
    invcal_status status = invcal_positions_sum(positions, sums);

    if (status == INVCAL_OK) {
        status = sums->count < INVCAL_PARAMETERS ? INVCAL_TOO_FEW : determine(sums, &q->condition);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    status = invcal_ellipsoid(&sums->sum[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], out);
    if (status != INVCAL_OK) { /* what is left open may take any shape */
        return q->condition > OPEN ? INVCAL_UNDETERMINED : status;
    }
    invcal_make_symmetric(out->matrix);
    memcpy(a, out->matrix, sizeof a);
    status = invcal_behind(positions->nominal, out);
    return status == INVCAL_OK ? judge(positions, out, (const invcal_real(*)[3])a, sums, q)
                               : status;
}
