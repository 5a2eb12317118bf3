/* SPDX-License-Identifier: MIT
 *
 * Solves the problems on its input, one a line,
 *
 *     count frame field noise zero(3) nominal(9, by rows) raw(3 count)
 *
 * and prints for each: status verdict, the nine parameters, offset(3), matrix(9), sigma of the
 * nine, sigma of the offset(3), noise, residual_rms, residual_max, condition; all as hexadecimal
 * floating-point numbers, so exactly. Before the first, what the headers promise: INVCAL_LOSS,
 * _LENGTH, _SIGMA, _AGAIN, INVCAL_EPSILON, INVCAL_PIVOT_FLOOR.
 */
#include <stdio.h>

#include "support.h"
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

static void print_result(invcal_status status, const invcal_solution *s, const invcal_quality *q)
{
    printf("%d %d", (int)status, (int)q->verdict);
    print_numbers(s->delta, 3);
    print_numbers(s->dk, 3);
    print_numbers(s->gamma, 3);
    print_numbers(s->calibration.offset, 3);
    print_numbers(s->calibration.matrix[0], 9);
    print_numbers(q->sigma_delta, 3);
    print_numbers(q->sigma_dk, 3);
    print_numbers(q->sigma_gamma, 3);
    print_numbers(q->sigma_offset, 3);
    print_numbers(&q->noise, 1);
    print_numbers(&q->residual_rms, 1);
    print_numbers(&q->residual_max, 1);
    print_numbers(&q->condition, 1);
    putchar('\n');
}

int main(void)
{
    unsigned count;
    int frame;

    const invcal_real promised[] = {INVCAL_LOSS,       INVCAL_LOSS_LENGTH, INVCAL_LOSS_SIGMA,
                                    INVCAL_LOSS_AGAIN, INVCAL_EPSILON,     INVCAL_PIVOT_FLOOR};
    print_numbers(promised, sizeof promised / sizeof promised[0]);
    putchar('\n');
    while (scanf("%u %d", &count, &frame) == 2) {
        invcal_settings settings = {.frame =
                                        frame ? INVCAL_FRAME_TRIANGULAR : INVCAL_FRAME_SYMMETRIC};
        invcal_real raw[MAX_POSITIONS][3];
        invcal_solution solution = {.delta = {0}};
        invcal_quality quality = {.dof = 0};
        if (count > MAX_POSITIONS || !read_numbers(&settings.field, 1) ||
            !read_numbers(&settings.noise, 1) || !read_numbers(settings.nominal.offset, 3) ||
            !read_numbers(settings.nominal.matrix[0], 9) || !read_numbers(raw[0], 3 * count)) {
            return 1;
        }
        const invcal_status status =
            invcal_calibrate(raw[0], count, &settings, &solution, &quality, NULL);
        print_result(status, &solution, &quality);
    }
    return ferror(stdin) || ferror(stdout);
}
