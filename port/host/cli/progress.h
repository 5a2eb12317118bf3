/* SPDX-License-Identifier: MIT
 *
 * cli/progress.h: the progress of reading a long file, on stderr if that is a terminal.
 */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <limits.h>
#include <stdio.h>

/* Disables it. */
void progress_quiet(void);

/* To be called after each row; updates the display from time to time. `found`: the number of
 * positions so far, or PROGRESS_ROWS if they are not counted. */
#define PROGRESS_ROWS UINT_MAX
void progress_show(FILE *file, unsigned long line, unsigned found);

/* Clears the line. message() does so itself. */
void progress_end(void);

#endif
