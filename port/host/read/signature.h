/* SPDX-License-Identifier: MIT
 *
 * read/signature.h: files that are no table, known by their first bytes.
 */
#ifndef SIGNATURE_H
#define SIGNATURE_H

#include <stddef.h>

/* What the file is and what to do with it, to follow "this is " in a message; null if the
 * bytes are of no kind that is known. */
const char *signature_find(const char *bytes, size_t length);

#endif
