/* SPDX-License-Identifier: MIT */
#include "guidance.h"

#include <stddef.h>
#include <string.h>

#include "sums.h"
#include "vector.h"

#define RIDGE INVCAL_REAL(1e-4)   /* of the largest diagonal element: between weak and good */
#define EQUAL INVCAL_REAL(0.99)   /* leverages above this share of the largest are equal */
#define THE_SAME INVCAL_REAL(0.9) /* cosine of 26 degrees: closer is the same position again */
#define FIRST INVCAL_REAL(1e-3)   /* of cosines that differ by less, the first counts */

enum { FACES = 6, EDGES = 12, DIRECTIONS = 26 };

/* Faces, edges and corners of a cube, as signs. */
static void direction(unsigned n, invcal_real up[3])
{
    static const int8_t directions[DIRECTIONS][3] = {
        {0, 0, 1},   {1, 0, 0},  {0, 1, 0},   {0, -1, 0},  {-1, 0, 0},   {0, 0, -1}, {1, 0, 1},
        {0, 1, 1},   {0, -1, 1}, {-1, 0, 1},  {1, 1, 0},   {1, -1, 0},   {-1, 1, 0}, {-1, -1, 0},
        {1, 0, -1},  {0, 1, -1}, {0, -1, -1}, {-1, 0, -1}, {1, 1, 1},    {1, -1, 1}, {-1, 1, 1},
        {-1, -1, 1}, {1, 1, -1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, -1},
    };
    const invcal_real length = n < FACES           ? 1
                               : n < FACES + EDGES ? INVCAL_REAL(0.70710678118654752)
                                                   : INVCAL_REAL(0.57735026918962576);

    for (unsigned i = 0; i < 3; i++) {
        up[i] = (invcal_real)directions[n][i] * length;
    }
}

/* ---- what they tell --------------------------------------------------------------------------- */

invcal_real invcal_ridged_inverse(invcal_sums *sums)
{
    invcal_real *a = sums->sum;

    invcal_sums_system(sums);
    const invcal_real largest = invcal_largest_diagonal(a, INVCAL_PARAMETERS);
    const invcal_real ridge = RIDGE * (largest > 1 ? largest : 1);
    invcal_add_ridge(a, INVCAL_PARAMETERS, ridge);
    /* a sum of squares and a ridge is positive definite */
    (void)invcal_factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS, INVCAL_EPSILON);
    invcal_invert(a, INVCAL_PARAMETERS);
    return ridge;
}

/* Of those that tell as much the closest to the present one, but rather any other than the same
 * again. */
static unsigned choose(const invcal_real leverage[DIRECTIONS], invcal_real least,
                       const invcal_real current[3])
{
    const invcal_real length = INVCAL_SQRT(invcal_dot3(current, current));
    invcal_real best = -3;
    unsigned chosen = 0;
    invcal_real up[3];

    for (unsigned n = 0; n < DIRECTIONS; n++) {
        direction(n, up);
        const invcal_real cosine = length > 0 ? invcal_dot3(up, current) / length : 0;
        const invcal_real merit = cosine > THE_SAME ? -2 : cosine;
        if (leverage[n] >= least && merit > best + FIRST) {
            best = merit;
            chosen = n;
        }
    }
    return chosen;
}

void invcal_next_beside(invcal_sums *sums, const invcal_real current[3], invcal_real up[3])
{
    invcal_real leverage[DIRECTIONS];
    invcal_real h[INVCAL_PARAMETERS];
    invcal_real most = 0;

    (void)invcal_ridged_inverse(sums);
    for (unsigned n = 0; n < DIRECTIONS; n++) {
        direction(n, h);
        invcal_row_of(h, h);
        leverage[n] = invcal_leverage(sums->sum, h);
        most = leverage[n] > most ? leverage[n] : most;
    }
    direction(choose(leverage, EQUAL * most, current), up);
}

void invcal_sum_readings(const invcal_real *raw, unsigned count, const invcal_calibration *nominal,
                         invcal_sums *sums, invcal_real last[3])
{
    invcal_row row;

    invcal_sums_init(sums);
    memset(last, 0, 3 * sizeof *last);
    for (unsigned i = 0; i < count; i++) {
        if (invcal_observe(nominal, &raw[3 * (size_t)i], &row) == INVCAL_OK) {
            invcal_sums_add_row(sums, &row, 1);
            memcpy(last, row.h, 3 * sizeof *last);
        }
    }
}

void invcal_next(const invcal_real *raw, unsigned count, const invcal_calibration *nominal,
                 invcal_real up[3])
{
    invcal_sums sums;
    invcal_real last[3];

    INVCAL_ASSERT((raw || count == 0) && nominal && up);
    invcal_sum_readings(raw, count, nominal, &sums, last);
    invcal_next_beside(&sums, last, up);
}

void invcal_prospect(const invcal_real *raw, unsigned count, const invcal_calibration *nominal,
                     const invcal_real *up, invcal_real root[INVCAL_PARAMETERS])
{
    invcal_sums sums;
    invcal_row row;

    INVCAL_ASSERT((raw || count == 0) && nominal && root);
    invcal_sum_readings(raw, count, nominal, &sums, row.h);
    if (up != NULL) {
        invcal_row_of(up, row.h);
        row.h[INVCAL_J] = 0;
        invcal_sums_add_row(&sums, &row, 1);
    }
    (void)invcal_ridged_inverse(&sums);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        root[r] = INVCAL_SQRT(invcal_variance(sums.sum, INVCAL_PARAMETERS, r));
    }
}
