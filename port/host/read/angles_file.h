/* SPDX-License-Identifier: MIT
 *
 * read/angles_file.h: the angles of a stand from a table, as `invcal plan --csv` writes it.
 *
 * Columns alpha and beta, degrees, and, if there is one, dwell, seconds, are found by these names; others
 * are left alone. Without a header there are two columns or three, in this order.
 */
#ifndef ANGLES_FILE_H
#define ANGLES_FILE_H

#include "maths/angles.h"

typedef struct {
    stand_angles *angle; /* `capacity` of them, above -180, at most 180 */
    double *dwell;       /* as many; all 0 if the table has no such column */
    unsigned capacity;
    unsigned count;
} angles_list;

/* Reads a table ("-": standard input) into angle and dwell, which are given.
 *
 * Returns EXIT_GOOD, with one position at least; EXIT_FILE, with a message, if it is unreadable or
 * malformed, has no such columns, more than `capacity` positions, an angle beyond 360 degrees, a dwell
 * that is negative or beyond 1e6 s, or none above 0. */
int angles_file_read(angles_list *a, const char *path);

#endif
