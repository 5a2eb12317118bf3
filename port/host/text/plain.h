/* SPDX-License-Identifier: MIT
 *
 * text/plain.h: names of files and columns may hold any bytes; control characters among them must
 * not reach the terminal.
 */
#ifndef PLAIN_H
#define PLAIN_H

#define PLAIN_MAX 4200 /* a path and some more */

/* 1 if it is UTF-8 without control characters: those below a blank, DEL, and U+0080 ... U+009F, of
 * which U+009B starts a command like ESC [. */
int plain_is(const char *text);

/* Replaces each byte that violates this by '?'. Returns text. */
char *plain(char *text);

/* The same on a copy, truncated to fit. Returns out. */
const char *plain_copy(const char *text, char out[PLAIN_MAX]);

#endif
