/* SPDX-License-Identifier: MIT
 *
 * read/angles_file.h: the angles of a stand from a table like those of `invcal plan --csv`.
 *
 * Columns alpha and beta, degrees, and optionally dwell, seconds, are found by these names; others
 * are ignored. Without a header there are two or three columns, in this order.
 */
#ifndef ANGLES_FILE_H
#define ANGLES_FILE_H

#include "maths/angles.h"

typedef struct {
    stand_angles *angle; /* `capacity` of them, in (-180, 180] */
    double *dwell;       /* the same number; all 0 if the table has no such column */
    unsigned capacity;
    unsigned count;
} angles_list;

/* Reads a table ("-": standard input) into angle and dwell, which the caller provides.
 *
 * Returns EXIT_GOOD, with at least one position; EXIT_FILE, with a message, if it is unreadable or
 * malformed, lacks these columns, has more than `capacity` positions, an angle beyond 360 degrees,
 * a dwell that is negative or above 1e6 s, or only dwells of 0. */
int angles_file_read(angles_list *a, const char *path);

#endif
