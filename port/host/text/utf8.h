/* SPDX-License-Identifier: MIT
 *
 * text/utf8.h: lengths and widths of UTF-8 text that may hold invalid bytes.
 */
#ifndef UTF8_H
#define UTF8_H

#include <stddef.h>

/* The length of the UTF-8 character at `text`, 1 ... 4; 0 if it is invalid. */
unsigned utf8_length(const char *text);

/* The columns that a text takes on a terminal: combining marks and colours (paint.h) take none,
 * East Asian wide characters two. */
size_t utf8_columns(const char *text);

/* The same of its first `size` bytes. */
size_t utf8_columns_of(const char *text, size_t size);

#endif
