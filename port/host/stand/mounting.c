/* SPDX-License-Identifier: MIT */
#include "stand/mounting.h"

#include <math.h>
#include <string.h>

#include "maths/matrix.h"
#include "maths/rotation.h"
#include "stand/full_vector.h"
#include "text/number.h"

enum { UNKNOWNS = 4 }; /* of each axis */

double mounting_leverage(const mounting *m, const double eta[3])
{
    const double g[UNKNOWNS] = {eta[0], eta[1], eta[2], 1};
    double sum = 0;

    for (unsigned r = 0; r < UNKNOWNS; r++) {
        for (unsigned c = 0; c < UNKNOWNS; c++) {
            sum += g[r] * g[c] * m->k[r >= c ? INVCAL_PACKED(r, c) : INVCAL_PACKED(c, r)];
        }
    }
    return sum;
}

void mounting_direction(const mounting *m, const double raw[3], double direction[3])
{
    invcal_apply(&m->stand, raw[0], raw[1], raw[2], direction);
    const double length = sqrt(direction[0] * direction[0] + direction[1] * direction[1] +
                               direction[2] * direction[2]);
    for (unsigned i = 0; i < 3; i++) {
        direction[i] /= length;
    }
}

double mounting_squared_error(const mounting *m, const mounting_position *p)
{
    double direction[3];
    double square = 0;

    mounting_direction(m, p->raw, direction);
    for (unsigned i = 0; i < 3; i++) {
        square += (direction[i] - p->eta[i]) * (direction[i] - p->eta[i]);
    }
    return square;
}

void mounting_turn(const mounting *m, const double eta[3], double out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        out[i] = m->turn[i][0] * eta[0] + m->turn[i][1] * eta[1] + m->turn[i][2] * eta[2];
    }
}

/* The sum of squares across the directions has the expectation 2 (n - 4) noise^2, as all three axes
 * have the same leverages. */
static void find_scatter(const mounting_position *p, unsigned count, mounting *out)
{
    double squares = 0;
    unsigned kept = 0;

    for (unsigned i = 0; i < count; i++) {
        if (!p[i].is_left_out) {
            squares += mounting_squared_error(out, &p[i]);
            kept++;
        }
    }
    out->dof = 2.0 * (kept - UNKNOWNS);
    out->scatter = out->dof > 0 ? sqrt(squares / out->dof) : NUMBER_UNKNOWN;
}

/* A turn about axis a is half the difference of two elements of M, each of which has the variance
 * of its direction, in the frame of the unit. */
static void find_sigma(mounting *out)
{
    double variance[3] = {0, 0, 0};

    for (unsigned a = 0; a < 3; a++) {
        const double *row = out->turn[a];
        for (unsigned r = 0; r < 3; r++) {
            for (unsigned c = 0; c < 3; c++) {
                variance[a] +=
                    row[r] * row[c] * out->k[r >= c ? INVCAL_PACKED(r, c) : INVCAL_PACKED(c, r)];
            }
        }
    }
    for (unsigned a = 0; a < 3; a++) {
        out->sigma[a] = out->scatter / 2 * sqrt(variance[(a + 1) % 3] + variance[(a + 2) % 3]);
    }
}

invcal_status mounting_fit(const mounting_position *p, unsigned count,
                           const invcal_calibration *nominal, mounting *out)
{
    full_vector full;
    double x[INVCAL_PARAMETERS];

    full_vector_init(&full);
    for (unsigned i = 0; i < count; i++) {
        if (!p[i].is_left_out) {
            (void)full_vector_add(&full, nominal, p[i].raw,
                                  p[i].eta); /* cannot fail: it was in the fit of lengths */
        }
    }
    memcpy(out->k, full.sum, sizeof out->k);
    const invcal_status status = full_vector_solve(&full, nominal, &out->stand, x, out->turn);
    if (status != INVCAL_OK) {
        return status;
    }
    if (!matrix_invert_packed(out->k, UNKNOWNS)) {
        return INVCAL_UNDETERMINED;
    }
    rotation_vector((const double(*)[3])out->turn, out->angle);
    find_scatter(p, count, out);
    find_sigma(out);
    return INVCAL_OK;
}
