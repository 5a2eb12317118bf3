/* SPDX-License-Identifier: MIT
 *
 * text/utf8.h: names of files may hold any bytes; what is printed should be UTF-8.
 */
#ifndef UTF8_H
#define UTF8_H

/* The length of the character of UTF-8 at `text`, 1 ... 4; 0 if it is none. */
unsigned utf8_length(const char *text);

#endif
