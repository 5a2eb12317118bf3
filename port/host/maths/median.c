/* SPDX-License-Identifier: MIT */
#include "maths/median.h"

#include <stdlib.h>

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;

    return (x > y) - (x < y);
}

void sort_numbers(double *x, size_t n)
{
    qsort(x, n, sizeof *x, compare);
}

double median_of(double *x, size_t n)
{
    sort_numbers(x, n);
    return n > 0 ? x[n / 2] : 0;
}
