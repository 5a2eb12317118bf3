/* SPDX-License-Identifier: MIT
 *
 * read/column.h: what a column of a table can mean.
 */
#ifndef COLUMN_H
#define COLUMN_H

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
    COLUMN_ALPHA, /* angles of a stand; by a header only */
    COLUMN_BETA,
    COLUMN_COUNT
} column;

/* "x", "std", ... */
const char *column_name(column which);

#define COLUMNS_CHOICE_MAX 256 /* of what --columns states */

#endif
