/* SPDX-License-Identifier: MIT
 *
 * read/columns_option.h: the option --columns, which states the columns of the log. It holds for
 * the whole run, which has a single log.
 */
#ifndef COLUMNS_OPTION_H
#define COLUMNS_OPTION_H

#include "read/column.h"
#include "read/heading.h"
#include "read/table.h"

/* Its help text. */
#define COLUMNS_OPTION_HELP                                                                        \
    "  --columns X,Y,Z     columns of LOG to use, by name or number: ax,ay,az or 2,3,4. State\n"   \
    "                      others by what they are: t=1,x=2,y=3,z=4,temperature=5; t=none or\n"    \
    "                      temperature=none ignores one\n"

/* Parses the value of the option: three names or numbers (from 1) for x, y, z, or any columns with
 * their meanings, in any order. Columns that it does not state are found by the header; so are all
 * if text is null. Time, temperature and others may be `none`, and are then ignored.
 *
 * Returns EXIT_GOOD; EXIT_USAGE, with a message that refers to the help of `command`. */
int columns_option_parse(const char *command, const char *text);

/* 1 if the option states this column. */
int columns_option_has(column which);

/* Marks a column that another option requires; to be called after columns_option_parse. Stated
 * columns are required, too. */
void columns_option_require(column which);
int columns_option_requires(column which);

/* The value of the option; empty: not given. */
const char *columns_option_text(void);

/* Finds a stated column by its name, with or without the unit, else by its number; *index is -1 for
 * `none`.
 *
 * headings  of all columns, if the table has a header.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message. */
int columns_option_find(const table *t, const heading *headings, column which, int *index);

/* The same for x, y and z, which must be three different columns. */
int columns_option_find_axes(const table *t, const heading *headings, int index[3]);

#endif
