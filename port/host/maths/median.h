/* SPDX-License-Identifier: MIT
 *
 * maths/median.h: numbers in order, and their median. None of them may be NaN.
 */
#ifndef MEDIAN_H
#define MEDIAN_H

#include <stddef.h>

/* Sorts n numbers, smallest first. */
void sort_numbers(double *x, size_t n);

/* Sorts n numbers, and returns their median: of an even number, the upper of the middle two; 0 of
 * none. */
double median_of(double *x, size_t n);

#endif
