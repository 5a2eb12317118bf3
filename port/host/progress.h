/* SPDX-License-Identifier: MIT
 *
 * progress.h: how far the reading of a long file has come, on stderr if that is a terminal.
 */
#ifndef PROGRESS_H
#define PROGRESS_H

#include "table.h"

/* After each row; shows something now and then. `found` is how many positions there are. */
void progress_show(const table *t, unsigned found);

/* Clears the line. */
void progress_end(void);

#endif
