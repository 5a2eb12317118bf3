/* SPDX-License-Identifier: MIT
 *
 * read/temperature.h: the temperature column of a log. Drivers write nan, or nothing, until they
 * have a value. Unless the temperature is required, this is not an error.
 */
#ifndef TEMPERATURE_H
#define TEMPERATURE_H

#include "read/columns.h"

/* 1 if the current row holds no temperature, and none is required (columns_option.h). In a live
 * stream, another word in its place means a garbled line, which columns_number reports. The column
 * must exist. */
int temperature_is_missing(const table *t, const columns *where);

/* Reads the temperature of the current row, degrees C; without the column, *out is untouched. If
 * the value is missing, warns, and ignores the column from here on.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message. */
int temperature_read(const table *t, columns *where, double *out);

/* Warns about the value in the current row. `becomes` says what is done: "ignored". */
void temperature_warn(const table *t, const columns *where, const char *becomes);

#endif
