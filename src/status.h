/* SPDX-License-Identifier: MIT
 *
 * Internal: words. Those for what a session refuses come without those for all the rest.
 */
#ifndef INVCAL_STATUS_H
#define INVCAL_STATUS_H

#include "invcal/invcal.h"

/* The nth of texts that stand one after the other, each with its end mark: no table of pointers, which would
 * need relocation and so writable memory. */
const char *invcal_text(const char *texts, unsigned n);

/* Of INVCAL_OUT_OF_RANGE ... INVCAL_REST_SAME; "" for INVCAL_OK; any other is a reading that is far from
 * the field. */
const char *invcal_refusal_text(invcal_status status);

#endif
