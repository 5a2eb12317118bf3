/* SPDX-License-Identifier: MIT
 *
 * The next direction to take: greedy D-optimal design over the 26 directions of a cube
 * (mathematics_programs.md, "Guidance"). One more row h multiplies det H'H by 1 + h K h', so the
 * largest leverage wins. A small ridge on H'H makes K finite from the first position on; refusal.c
 * and background.c use the same ridge.
 */
#include "guidance.h"

#include <stddef.h>
#include <string.h>

#include "../core/sums.h"
#include "../core/vector.h"

#define RIDGE INVCAL_REAL(1e-5)     /* over the trace plus 10: between weak and good */
#define ACROSS 128                  /* the opposite direction counts 1/64 less */
#define THE_SAME INVCAL_REAL(0.9)   /* cosine of 26 degrees: the same position if closer */
#define CLEARLY INVCAL_REAL(1.001)  /* if directions differ by less, the first wins */
#define NO_LENGTH INVCAL_REAL(1e-6) /* a square, so that 0 has a length too */

INVCAL_NOINLINE void invcali_direction(unsigned n, invcal_real up[3])
{
    n += n >= INVCAL_DIRECTIONS / 2; /* not the centre */
    //@ split n;
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        const unsigned third = n * 11 / 32; /* of n < 32: some have to call a function to divide */
        up[i] = (invcal_real)(1 - (int)(n - 3 * third));
        n = third;
    }
    const invcal_real length = INVCAL_SQRT(invcali_dot3(up, up));
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        up[i] /= length;
    }
}

/* ---- information ----------------------------------------------------------------------------- */

INVCAL_NOINLINE invcal_real invcali_ridged_inverse(invcal_sums *sums)
{
    invcal_real *const a = sums->sum;
    invcal_real *diagonal = a;

    /* 10: at first the trace is 0 */
    const invcal_real ridge = RIDGE * (10 + invcali_trace(a, INVCAL_PARAMETERS));
    INVCAL_ROLL
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        *diagonal += ridge;
        diagonal += r + 2;
    }
    /* a sum of squares and a ridge is positive definite */
    (void)invcali_factor(a, INVCAL_PARAMETERS, INVCAL_PARAMETERS, INVCAL_EPSILON);
    invcali_invert(a, INVCAL_PARAMETERS);
    return ridge;
}

/* The direction with the most information; of equals the closest to the current one, but not the
 * same again. */
void invcali_next_of_sums(invcal_sums *sums, const invcal_real current[3], invcal_real up[3])
{
    const invcal_real length = INVCAL_SQRT(invcali_dot3(current, current) + NO_LENGTH);
    invcal_real h[INVCAL_PARAMETERS];
    invcal_real most = 0;
    unsigned next = 0;

    (void)invcali_ridged_inverse(sums);
    for (unsigned n = 0; n < INVCAL_DIRECTIONS; n++) {
        invcali_direction(n, h);
        const invcal_real along = invcali_dot3(h, current);
        invcali_row_of(h);
        const invcal_real merit = invcali_leverage(sums->sum, h) * (ACROSS * length + along);
        if (along <= THE_SAME * length && !(merit <= most)) { /* any, if all are NaN */
            most = CLEARLY * merit;
            next = n;
        }
    }
    invcali_direction(next, up);
}

void invcali_sum_readings(const invcal_positions *positions, invcal_sums *sums, invcal_real last[3])
{
    invcali_row row;

    invcal_sums_init(sums);
    invcali_zero(last, 3 * sizeof *last);
    for (unsigned i = 0; i < positions->count; i++) {
        if (invcali_observe(positions->nominal, positions->mean[i].v, &row) == INVCAL_OK) {
            invcali_sums_add_row(sums, &row, 1);
            memcpy(last, row.h, 3 * sizeof *last);
        }
    }
}

void invcali_next(const invcal_positions *positions, invcal_real up[3])
{
    invcal_sums sums;
    invcal_real last[3];

    INVCAL_ASSERT(INVCAL_ARE_GIVEN(positions) && up);
    invcali_sum_readings(positions, &sums, last);
    invcali_next_of_sums(&sums, last, up);
}

/* J of a direction only planned is 0: it does not enter K. */
void invcali_prospect(const invcal_positions *positions, const invcal_real *up,
                      invcal_real root[INVCAL_PARAMETERS])
{
    invcal_sums sums;
    invcali_row row;

    INVCAL_ASSERT(INVCAL_ARE_GIVEN(positions) && root);
    invcali_sum_readings(positions, &sums, row.h);
    if (up != NULL) {
        memcpy(row.h, up, 3 * sizeof *up);
        invcali_row_of(row.h);
        row.h[INVCAL_J] = 0;
        invcali_sums_add_row(&sums, &row, 1);
    }
    (void)invcali_ridged_inverse(&sums);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        root[r] = INVCAL_SQRT(invcali_variance(sums.sum, INVCAL_PARAMETERS, r));
    }
}
