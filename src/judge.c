/* SPDX-License-Identifier: MIT */
#include "judge.h"

#include <stddef.h>
#include <string.h>

#include "solve.h"
#include "vector.h"

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

/* j = (|eta|^2 - 1)/2 = (|eta| - 1)(|eta| + 1)/2 */
invcal_status invcal_residuals_add(const invcal_calibration *c, const invcal_real raw[3],
                                   unsigned i, invcal_row *row, invcal_quality *q)
{
    const invcal_status status = invcal_observe(c, raw, row);

    if (status != INVCAL_OK) {
        return status;
    }
    const invcal_real r = 2 * row->j / (1 + INVCAL_SQRT(1 + 2 * row->j));
    q->rms += r * r;
    if (!(INVCAL_FABS(r) <= q->max)) {
        q->max = INVCAL_FABS(r);
        q->worst = (uint16_t)i;
    }
    return INVCAL_OK;
}

invcal_status invcal_residuals_end(unsigned count, invcal_quality *q)
{
    q->positions = (uint16_t)count;
    q->rms = INVCAL_SQRT(q->rms / (invcal_real)count);
    return q->rms <= ABSURD ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

invcal_real invcal_gradient(const invcal_real a[3][3], const invcal_real eta[3], invcal_real g[3])
{
    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        g[i] = a[i][0] * eta[0] + a[i][1] * eta[1] + a[i][2] * eta[2];
    }
    return invcal_dot3(g, g);
}

/* How X moves j: d eta = -A (d delta + dS eta), so dj = eta d eta = -g (d delta + dS eta). */
static INVCAL_INLINE void slope(const invcal_real g[3], invcal_real h[INVCAL_PARAMETERS])
{
    h[INVCAL_DK_X] = g[0] * h[0];
    h[INVCAL_DK_Y] = g[1] * h[1];
    h[INVCAL_DK_Z] = g[2] * h[2];
    h[INVCAL_GAMMA_XY] = (g[0] * h[1] + g[1] * h[0]) / 2;
    h[INVCAL_GAMMA_XZ] = (g[0] * h[2] + g[2] * h[0]) / 2;
    h[INVCAL_GAMMA_ZY] = (g[1] * h[2] + g[2] * h[1]) / 2;
    memcpy(h, g, 3 * sizeof *h);
}

static INVCAL_INLINE void add_row(invcal_real *a, const invcal_real h[INVCAL_PARAMETERS],
                                  invcal_real weight)
{
    INVCAL_UNROLL_ROWS
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real weighted = weight * h[r];
        INVCAL_UNROLL_ROWS
        for (unsigned c = 0; c <= r; c++) {
            *a++ += weighted * h[c];
        }
    }
}

invcal_status invcal_positions_compare(const invcal_positions *positions,
                                       const invcal_calibration *c, const invcal_real a[3][3],
                                       invcal_real *information, invcal_real *squares,
                                       invcal_quality *q)
{
    unsigned count = 0;
    invcal_real g[3];
    invcal_row row;

    memset(information, 0, INVCAL_PACKED_SIZE(INVCAL_PARAMETERS) * sizeof *information);
    *squares = 0;
    invcal_residuals_begin(q);
    q->left_out = positions->left_out;
    for (unsigned i = 0; i < positions->count; i++) {
        if (invcal_is_left_out(positions, i)) {
            continue;
        }
        if (invcal_residuals_add(c, &positions->raw[3 * (size_t)i], i, &row, q) != INVCAL_OK) {
            return INVCAL_NOT_ELLIPSOID; /* fit for the first pass, absurd after it */
        }
        const invcal_real weight = 1 / invcal_gradient(a, row.h, g);
        *squares += weight * row.j * row.j;
        slope(g, row.h);
        add_row(information, row.h, weight);
        count++;
    }
    return invcal_residuals_end(count, q);
}

/* ---- judgement ---------------------------------------------------------------------------------- */

void invcal_judge_noise(invcal_real stated, invcal_real squares, invcal_real dof, invcal_quality *q)
{
    q->noise = stated;
    q->dof = 0;
    if (dof >= 1) {
        const invcal_real observed = INVCAL_SQRT(squares / dof);
        q->noise = observed > stated ? observed : stated;
        //@ assert \is_finite(dof) && dof < 65536; // no more than positions
        q->dof = (uint16_t)dof;
    }
    if (!(q->noise > 0)) {
        q->noise = 1; /* nobody knows: the whole field, which no one will mistake for good */
    }
}

void invcal_judge_parameters(const invcal_real k[INVCAL_PARAMETERS], int is_known,
                             const invcal_real a[3][3], invcal_quality *q)
{
    /* in calibrated units: |A eta| times itself, here the mean square over all directions */
    const invcal_real of_noise =
        (invcal_real)q->positions * q->noise * q->noise * invcal_dot(a[0], a[0], 9) / 3;
    const invcal_real most =
        is_known && of_noise * INVCAL_WEAK_K > NOISE_SHARE ? NOISE_SHARE / of_noise : INVCAL_WEAK_K;

    q->weak = 0;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        q->weak |= (uint16_t)((k[r] <= most ? 0u : 1u) << r);
        q->sigma[r] = q->noise * INVCAL_SQRT(k[r]);
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
    return positions->count < UINT16_MAX ? invcal_nominal_check(positions->nominal)
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

/* The system to p, if there is a row behind the nine, and L^-1. Is what it determines more than
 * rounding? If not in nominal units, readings calibrated by it may look well spread all the same. */
static invcal_status determine_all(invcal_real *a, unsigned rows, invcal_real *condition)
{
    const invcal_real trace = invcal_trace(a, INVCAL_PARAMETERS);
    const invcal_status status = invcal_factor(a, INVCAL_PARAMETERS, rows, INVCAL_FLOOR);

    if (status != INVCAL_OK) {
        return status;
    }
    if (rows > INVCAL_PARAMETERS) {
        invcal_back_substitute(a, INVCAL_PARAMETERS);
    }
    invcal_invert(a, INVCAL_PARAMETERS);
    *condition = invcal_condition(a, INVCAL_PARAMETERS, trace);
    return invcal_is_resolved(*condition) ? INVCAL_OK : INVCAL_UNDETERMINED;
}

static invcal_status judge_result(const invcal_positions *positions, const invcal_calibration *c,
                                  const invcal_real a[3][3], invcal_real *information,
                                  invcal_quality *q)
{
    invcal_real k[INVCAL_PARAMETERS];
    invcal_real squares;
    invcal_status status = invcal_positions_compare(positions, c, a, information, &squares, q);

    if (status != INVCAL_OK) {
        return status;
    }
    invcal_judge_noise(positions->noise, squares, (invcal_real)(q->positions - INVCAL_PARAMETERS),
                       q);
    status = determine_all(information, INVCAL_PARAMETERS, &q->condition);
    if (status != INVCAL_OK) {
        return status;
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        k[r] = invcal_variance(information, INVCAL_PARAMETERS, r);
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

    if (status == INVCAL_OK && sums->count < INVCAL_PARAMETERS) {
        status = INVCAL_TOO_FEW;
    }
    if (status == INVCAL_OK) {
        invcal_sums_system(sums);
        status = determine_all(sums->sum, INVCAL_PARAMETERS + 1, &q->condition);
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
    return status == INVCAL_OK
               ? judge_result(positions, out, (const invcal_real(*)[3])a, sums->sum, q)
               : status;
}
