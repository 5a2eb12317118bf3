/* SPDX-License-Identifier: MIT
 *
 * read/temperature.h: the column of temperature of a log. Drivers write nan, or nothing, until they know one:
 * where nobody needs it, that must not cost the log.
 */
#ifndef TEMPERATURE_H
#define TEMPERATURE_H

#include "read/columns.h"

/* 1 if the current row holds no temperature, and nobody needs one (chosen.h). In a live stream a word there
 * is a garbled line, which is for columns_number. The column must be there. */
int temperature_is_missing(const table *t, const columns *where);

/* Reads the temperature of the current row, degrees C; without the column *out is left alone. If it is
 * missing, the column is ignored from here on, with a warning.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message. */
int temperature_read(const table *t, columns *where, double *out);

/* The warning: what becomes of the temperature, "ignored", and what stands in the current row. */
void temperature_warn(const table *t, const columns *where, const char *becomes);

#endif
