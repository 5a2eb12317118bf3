/* SPDX-License-Identifier: MIT
 *
 * text/append.h: appends to a text.
 */
#ifndef APPEND_H
#define APPEND_H

#include <stddef.h>

#if defined(__GNUC__)
#define APPEND_FORMAT __attribute__((format(printf, 3, 4)))
#else
#define APPEND_FORMAT
#endif

/* Appends to a text in a buffer of `size` bytes; the result is truncated to fit. */
void append(char *text, size_t size, const char *format, ...) APPEND_FORMAT;

#endif
