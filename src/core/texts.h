/* SPDX-License-Identifier: MIT
 *
 * Internal: texts. The sentences for refusals of a session are linked without the others.
 */
#ifndef INVCAL_TEXTS_H
#define INVCAL_TEXTS_H

#include "invcal/invcal.h"
#include "names.h"

/* The nth of count texts in a row, each terminated by zero, or for any other number the one after
 * them. No table of pointers, which would need relocation and so writable memory. */
const char *invcali_text(const char *texts, unsigned n, unsigned count);

/* Of INVCAL_OUT_OF_RANGE ... INVCAL_BAD_RATE; "" for any other. */
const char *invcali_refusal_text(invcal_status status);

#endif
