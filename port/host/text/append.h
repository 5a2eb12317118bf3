/* SPDX-License-Identifier: MIT
 *
 * text/append.h: a text that grows.
 */
#ifndef APPEND_H
#define APPEND_H

#include <stddef.h>

#if defined(__GNUC__)
#define APPEND_FORMAT __attribute__((format(printf, 3, 4)))
#else
#define APPEND_FORMAT
#endif

/* Appends to a text in `size` bytes; what is too long is cut off. */
void append(char *text, size_t size, const char *format, ...) APPEND_FORMAT;

#endif
