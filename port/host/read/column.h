/* SPDX-License-Identifier: MIT
 *
 * read/column.h: the meanings of table columns.
 */
#ifndef COLUMN_H
#define COLUMN_H

typedef enum {
    COLUMN_X,
    COLUMN_Y,
    COLUMN_Z,
    COLUMN_STD_X, /* standard deviation of the samples of a mean; one column may serve all axes */
    COLUMN_STD_Y,
    COLUMN_STD_Z,
    COLUMN_SAMPLES, /* number of samples of a mean */
    COLUMN_TIME,
    COLUMN_TEMPERATURE,
    COLUMN_ALPHA, /* angles of a stand; only with a header */
    COLUMN_BETA,
    COLUMN_COUNT
} column;

/* "x", "std_x", ... */
const char *column_name(column which);

#define COLUMNS_OPTION_MAX 256 /* size of the value of --columns */

#endif
