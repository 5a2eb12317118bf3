/* SPDX-License-Identifier: MIT
 *
 * text/constant.h: a calibration as a constant in C: what `invcal export --format c` writes, and a report shows.
 */
#ifndef CONSTANT_H
#define CONSTANT_H

#include <stdio.h>

#include "text/number.h"

/* The shortest text that reads back as the float nearest to x. Returns text. */
const char *constant_float(double x, char text[NUMBER_TEXT_MAX]);

/* The same for a double or float (digits of a double) as C wants it in front of a suffix: with a point or an exponent.
 * Returns text. */
const char *constant_literal(double x, int is_double, char text[NUMBER_TEXT_MAX]);

/* 1 if a float holds it: neither above its range nor so small that digits are lost. */
int constant_fits_float(double x);

/* 1 if floats hold all of a calibration: the usual build of the library has no others. */
int constant_fits(const double offset[3], const double (*matrix)[3]);

/* {x, y, z}, each between `before` and `after`. */
void constant_row(FILE *file, const double x[3], int is_double, const char *before,
                  const char *after);

/* "static const invcal_real NAME[3][3] = {...};" and the end of its line. */
void constant_write_matrix(FILE *file, const char *name, const double (*matrix)[3]);

/* "static const invcal_calibration NAME = {...};" and the end of its line. It has no character that means anything
 * in HTML. */
void constant_write(FILE *file, const char *name, const double offset[3],
                    const double (*matrix)[3]);

#endif
