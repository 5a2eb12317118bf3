/* SPDX-License-Identifier: MIT
 *
 * text/utf8.h: names of files may hold any bytes; what is printed should be UTF-8.
 */
#ifndef UTF8_H
#define UTF8_H

#include <stddef.h>

/* The length of the character of UTF-8 at `text`, 1 ... 4; 0 if it is none. */
unsigned utf8_length(const char *text);

/* The columns that a terminal shows a text in: no byte, no combining mark and no colour (paint.h) takes
 * one of its own, and what East Asia writes takes two. */
size_t utf8_columns(const char *text);

/* The same of its first `size` bytes. */
size_t utf8_columns_of(const char *text, size_t size);

#endif
