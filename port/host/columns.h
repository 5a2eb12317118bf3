/* SPDX-License-Identifier: MIT
 *
 * columns.h: which column of a table means what, by its header or by the number of columns.
 */
#ifndef COLUMNS_H
#define COLUMNS_H

#include "table.h"

typedef enum {
    COLUMN_X,
    COLUMN_Y,
    COLUMN_Z,
    COLUMN_STD_X, /* standard deviation of the samples behind a mean; one column may be all */
    COLUMN_STD_Y,
    COLUMN_STD_Z,
    COLUMN_SAMPLES, /* their number */
    COLUMN_TIME,
    COLUMN_TEMPERATURE,
    COLUMN_COUNT
} column;

/* For each meaning the index into table.field, or -1. */
typedef struct {
    int index[COLUMN_COUNT];
} columns;

/* How the columns of a table without a header are understood. */
typedef enum {
    COLUMNS_POSITIONS, /* x y z; x y z std n; x y z std_x std_y std_z n */
    COLUMNS_LOG        /* x y z; t x y z; t x y z temperature; the first two also with the three of
                          a gyro behind, which are ignored */
} columns_kind;

/* Names that a header may use, for help texts. */
#define COLUMNS_NAMES                                                                              \
    "  x y z (or ax ay az, acc_x .., accel_x .., mx my mz, mag_x .., mean_x ..);\n"                \
    "  std or std_x std_y std_z; n, n_samples or count; t, time or timestamp;\n"                   \
    "  temperature or temp. Upper and lower case are the same; other columns are ignored.\n"

/* Finds the columns of a table that has just been opened.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if x, y and z are not there or there twice, or
 * another name is there twice, or the number of columns tells nothing. */
int columns_find(const table *t, columns_kind kind, columns *out);

/* Reads a number from the current row; the column must be there.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message that names line and column. */
int columns_number(const table *t, const columns *where, column which, double *out);

/* "x", "std", ... */
const char *columns_name(column which);

#endif
