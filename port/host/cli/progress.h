/* SPDX-License-Identifier: MIT
 *
 * cli/progress.h: how far the reading of a long file has come, on stderr if that is a terminal.
 */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <limits.h>
#include <stdio.h>

/* From now on nothing is shown. */
void progress_quiet(void);

/* After each row; shows something now and then. `found` is how many positions there are, or
 * PROGRESS_ROWS if none are looked for. */
#define PROGRESS_ROWS UINT_MAX
void progress_show(FILE *file, unsigned long line, unsigned found);

/* Clears the line. Messages do that themselves. */
void progress_end(void);

#endif
