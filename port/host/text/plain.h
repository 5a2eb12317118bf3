/* SPDX-License-Identifier: MIT
 *
 * text/plain.h: names of files and of columns may hold anything; a terminal should get none of what it
 * would take for a command.
 */
#ifndef PLAIN_H
#define PLAIN_H

#define PLAIN_MAX 4200 /* a path, and more */

/* 1 if it is UTF-8 without control characters: those below a blank, DEL, and U+0080 ... U+009F, of
 * which U+009B begins a command as ESC [ does. */
int plain_is(const char *text);

/* Makes it so: each byte that is none of it becomes '?'. Returns text. */
char *plain(char *text);

/* The same of a copy, cut to size. Returns out. */
const char *plain_copy(const char *text, char out[PLAIN_MAX]);

#endif
