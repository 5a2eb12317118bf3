/* SPDX-License-Identifier: MIT
 *
 * read/signature.h: recognises files that are not tables by their first bytes.
 */
#ifndef SIGNATURE_H
#define SIGNATURE_H

#include <stddef.h>

/* What the file is and what to do with it, to follow "this is " in a message; null if the bytes are
 * not recognised. */
const char *signature_find(const char *bytes, size_t length);

#endif
