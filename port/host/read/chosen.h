/* SPDX-License-Identifier: MIT
 *
 * read/chosen.h: which columns of the log are meant, as --columns states it for the whole run: there is
 * one log in it.
 */
#ifndef CHOSEN_H
#define CHOSEN_H

#include "read/column.h"
#include "read/heading.h"
#include "read/table.h"

/* The option, for help texts. */
#define CHOSEN_OPTION                                                                              \
    "  --columns X,Y,Z     columns of LOG to use, by name or number: ax,ay,az or 2,3,4. State\n"   \
    "                      others by what they are: t=1,x=2,y=3,z=4,temperature=5; t=none or\n"    \
    "                      temperature=none ignores one\n"

/* Reads the option: three names or numbers from 1 for x, y, z, or each with its meaning, in any order.
 * What it does not name is found as ever; null: all is. One of the others may be `none`: it is as if it was
 * not there.
 *
 * Returns EXIT_GOOD; EXIT_USAGE, with a message that points to the help of `command`. */
int chosen_read(const char *command, const char *text);

/* 1 if it is stated which column this is. */
int chosen_is(column which);

/* An option of this run needs the column, after chosen_read; what is stated is needed, too. */
void chosen_need(column which);
int chosen_is_needed(column which);

/* The option as it was stated; empty: it was not. */
const char *chosen_text(void);

/* Finds a column that is stated, by its name with or without its unit, else by its number; -1: none.
 *
 * headings  of all columns, if the table has a header.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message. */
int chosen_find(const table *t, const heading *headings, column which, int *index);

/* The same for x, y and z, which are three different columns. */
int chosen_find_axes(const table *t, const heading *headings, int index[3]);

#endif
