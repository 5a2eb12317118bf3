/* SPDX-License-Identifier: MIT
 *
 * text/constant.h: a calibration as C constants, for `invcal export --format c` and reports.
 */
#ifndef CONSTANT_H
#define CONSTANT_H

#include <stdio.h>

#include "text/number.h"

/* The shortest text that reads back as the float nearest to x. Returns text. */
const char *constant_float(double x, char text[NUMBER_TEXT_MAX]);

/* The same of a double or a float, as a C literal to which a suffix can be added: with a point or
 * an exponent. Returns text. */
const char *constant_literal(double x, int is_double, char text[NUMBER_TEXT_MAX]);

/* 1 if a float can hold it: neither above its range nor so small that digits are lost. */
int constant_fits_float(double x);

/* 1 if floats can hold the whole calibration, as the default build of the library needs. */
int constant_fits(const double offset[3], const double (*matrix)[3]);

/* Writes {x, y, z}, each between `before` and `after`. */
void constant_row(FILE *file, const double x[3], int is_double, const char *before,
                  const char *after);

/* Writes the line "static const invcal_real NAME[3][3] = {...};". */
void constant_write_matrix(FILE *file, const char *name, const double (*matrix)[3]);

/* Writes "static const invcal_calibration NAME = {...};" and an end of line. Nothing in it needs
 * escaping in HTML. */
void constant_write(FILE *file, const char *name, const double offset[3],
                    const double (*matrix)[3]);

#endif
