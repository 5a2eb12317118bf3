/* SPDX-License-Identifier: MIT */
#include "judge.h"

#include <stddef.h>
#include <string.h>

#include "solve.h"
#include "sums.h"
#include "vector.h"

#define WEAK INVCAL_REAL(10.0)       /* sigma over noise. Above: usable only within its sigma */
#define NOISE_SHARE INVCAL_REAL(0.1) /* of the information on a parameter: above, it is weak */
#define ABSURD INVCAL_REAL(0.1)      /* rms of the residuals; above: no readings of one field */
#define OPEN INVCAL_REAL(1e4)        /* quality.condition; above: parameters are left open */
/* Of quality.condition. Above, the float build has solved rounding errors; in double sigma is about a
 * thousand times the noise. */
#define HIGHEST (INVCAL_DOUBLE ? INVCAL_REAL(4e7) : 2 / INVCAL_FLOOR)

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

invcal_status invcal_compare(const invcal_positions *positions, const invcal_real a[3][3],
                             const invcal_calibration *c, invcal_sums *sums, invcal_quality *q)
{
    invcal_real squares = 0;
    invcal_row row;

    invcal_sums_init(sums);
    q->left_out = positions->left_out;
    q->max = 0;
    for (unsigned i = 0; i < positions->count; i++) {
        if (invcal_is_left_out(positions, i)) {
            continue;
        }
        if (invcal_observe(c, &positions->raw[3 * (size_t)i], &row) != INVCAL_OK) {
            return INVCAL_NOT_ELLIPSOID; /* fit for the first pass, absurd after it */
        }
        invcal_sums_add_row(sums, &row, 1 / sensitivity2(a, row.h));
        /* j = (|eta|^2 - 1)/2 = (|eta| - 1)(|eta| + 1)/2 */
        const invcal_real r = 2 * row.j / (1 + INVCAL_SQRT(1 + 2 * row.j));
        squares += r * r;
        if (!(INVCAL_FABS(r) <= q->max)) {
            q->max = INVCAL_FABS(r);
            q->worst = (uint8_t)i;
        }
    }
    q->positions = (uint8_t)sums->count;
    q->rms = INVCAL_SQRT(squares / (invcal_real)sums->count);
    return q->rms <= ABSURD ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
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
    *condition = trace * invcal_dot(a, a, INVCAL_PACKED_SIZE(INVCAL_PARAMETERS));
    return *condition < HIGHEST ? INVCAL_OK : INVCAL_UNDETERMINED;
}

void invcal_judge_noise(invcal_real stated, invcal_real weighted_squares, invcal_real dof,
                        invcal_quality *q)
{
    const invcal_real observed = dof > 0 ? INVCAL_SQRT(weighted_squares / dof) : 0;

    q->dof = (uint8_t)dof;
    q->noise = observed > stated ? observed : stated;
}

/* From unit vectors back to the parameters. A deviation of the calibrated triad moves u by I + S
 * times it: scale errors and offsets of an axis by 1 + dk of it, the cross terms by the mean of
 * theirs. That is within 2 % of the whole Jacobian at errors of 10 %.
 *
 * Weak: sigma is large beside the noise; or the information 1 / sigma^2 is no more than ten times
 * what noise in the readings themselves, about noise^2 in each row, adds to it: then directions that
 * determine nothing look as if they did. */
void invcal_judge_parameters(const invcal_real *inverse, const invcal_real a[3][3],
                             invcal_quality *q)
{
    /* of x y z xx yy zz xy xz yz */
    static const uint8_t one[INVCAL_PARAMETERS] = {0, 1, 2, 0, 1, 2, 0, 0, 1};
    static const uint8_t other[INVCAL_PARAMETERS] = {0, 1, 2, 0, 1, 2, 1, 2, 2};
    const invcal_real information = (invcal_real)q->positions / NOISE_SHARE;
    const int is_known = q->noise > 0;

    if (!is_known) {
        q->noise = 1; /* the whole field, which no one will mistake for good */
    }
    q->weak = 0;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real length = (1 / a[one[r]][one[r]] + 1 / a[other[r]][other[r]]) / 2;
        const invcal_real k = invcal_variance(inverse, INVCAL_PARAMETERS, r);
        const invcal_real sigma = q->noise * INVCAL_SQRT(k);
        q->sigma[r] = sigma * length;
        if (!(q->sigma[r] <= WEAK * q->noise) || (is_known && sigma * sigma * information > 1)) {
            q->weak |= (uint16_t)(1u << r);
        }
    }
    q->verdict = (uint8_t)(q->weak ? INVCAL_WEAK : q->dof > 0 ? INVCAL_GOOD : INVCAL_NO_REDUNDANCY);
}

static invcal_status judge(const invcal_positions *positions, const invcal_real a[3][3],
                           const invcal_calibration *c, invcal_sums *sums, invcal_quality *q)
{
    invcal_status status = invcal_compare(positions, a, c, sums, q);

    if (status == INVCAL_OK) {
        invcal_judge_noise(positions->noise, sums->sum[INVCAL_MOMENTS + INVCAL_PARAMETERS],
                           (invcal_real)(sums->count - INVCAL_PARAMETERS), q);
        status = determine(sums, &q->condition);
    }
    if (status == INVCAL_OK) {
        invcal_judge_parameters(sums->sum, a, q);
    }
    return status;
}

invcal_status invcal_positions_solve(const invcal_positions *positions, invcal_sums *sums,
                                     invcal_calibration *out, invcal_quality *q)
{
    invcal_real a[3][3];
    invcal_status status = invcal_positions_sum(positions, sums);

    if (status == INVCAL_OK) {
        status = sums->count < INVCAL_PARAMETERS ? INVCAL_TOO_FEW : determine(sums, &q->condition);
    }
    if (status == INVCAL_OK) {
        status = invcal_ellipsoid(&sums->sum[INVCAL_PACKED(INVCAL_PARAMETERS, 0)], out);
        if (status != INVCAL_OK && q->condition > OPEN) {
            status = INVCAL_UNDETERMINED; /* what is left open may take any shape */
        }
    }
    if (status == INVCAL_OK) {
        memcpy(a, out->matrix, sizeof a);
        status = invcal_behind(positions->nominal, out);
    }
    return status == INVCAL_OK ? judge(positions, (const invcal_real(*)[3])a, out, sums, q)
                               : status;
}
