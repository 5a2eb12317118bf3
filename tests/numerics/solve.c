/* SPDX-License-Identifier: MIT
 *
 * Solves the problems on its input, one a line,
 *
 *     count triangular? noise zero(3) nominal(9, by rows) raw(3 count)
 *
 * and prints for each: status verdict, the nine parameters, offset(3), matrix(9), sigma of the
 * nine, sigma of the offset(3), noise, rms, max, condition; all as hexadecimal floating-point
 * numbers, so exactly. Before the first, what the header promises: INVCAL_LOSS, _LENGTH, _SIGMA,
 * _AGAIN, INVCAL_EPSILON, INVCAL_FLOOR; and INVCAL_UNDETERMINED.
 */
#include <stdio.h>

#include "core/solve.h"
#include "support.h"
#include "core/system.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static int read_numbers(invcal_real *to, unsigned count)
{
    double value;

    for (unsigned i = 0; i < count; i++) {
        if (scanf("%lf", &value) != 1) {
            return 0;
        }
        to[i] = (invcal_real)value;
    }
    return 1;
}

static void print_numbers(const invcal_real *from, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        printf(" %a", (double)from[i]);
    }
}

static void print_result(invcal_status status, const invcal_calibration *c,
                         const invcal_calibration *nominal, int is_triangular,
                         const invcal_quality *q)
{
    invcal_calibration turned = *c;
    invcal_real x[INVCAL_PARAMETERS];
    invcal_real sigma_offset[3];

    invcal_deviation(c, nominal, x);
    invcal_sigma_offset(q, nominal, sigma_offset);
    if (is_triangular) {
        invcali_make_triangular(&turned, nominal);
    }
    printf("%d %d", (int)status, (int)q->verdict);
    print_numbers(x, INVCAL_PARAMETERS);
    print_numbers(turned.offset, 3);
    print_numbers(turned.matrix[0], 9);
    print_numbers(q->sigma, INVCAL_PARAMETERS);
    print_numbers(sigma_offset, 3);
    print_numbers(&q->noise, 1);
    print_numbers(&q->rms, 1);
    print_numbers(&q->max, 1);
    print_numbers(&q->condition, 1);
    putchar('\n');
}

int main(void)
{
    unsigned count;
    int is_triangular;

    const invcal_real promised[] = {INVCAL_LOSS,
                                    INVCAL_LOSS_LENGTH,
                                    INVCAL_LOSS_SIGMA,
                                    INVCAL_LOSS_AGAIN,
                                    INVCAL_EPSILON,
                                    INVCAL_FLOOR,
                                    (invcal_real)INVCAL_UNDETERMINED};
    print_numbers(promised, sizeof promised / sizeof promised[0]);
    putchar('\n');
    while (scanf("%u %d", &count, &is_triangular) == 2) {
        invcal_calibration nominal;
        invcal_calibration found;
        invcal_real noise;
        invcal_real raw[MAX_POSITIONS][3];
        invcal_quality quality = {.dof = 0};
        if (count > MAX_POSITIONS || !read_numbers(&noise, 1) || !read_numbers(nominal.offset, 3) ||
            !read_numbers(nominal.matrix[0], 9) || !read_numbers(raw[0], 3 * count)) {
            return 1;
        }
        found = nominal;
        const invcal_status status =
            invcal_calibrate_plain(POSITIONS_OF(raw[0], count, &nominal, noise), &found, &quality);
        print_result(status, &found, &nominal, is_triangular, &quality);
    }
    return ferror(stdin) || ferror(stdout);
}
