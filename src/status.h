/* SPDX-License-Identifier: MIT
 *
 * Internal: the words for what a session refuses, without those for all the rest.
 */
#ifndef INVCAL_STATUS_H
#define INVCAL_STATUS_H

#include "invcal/invcal.h"

/* Of INVCAL_OUT_OF_RANGE ... INVCAL_REST_SAME; "" for INVCAL_OK; any other is a reading that is far from
 * the field. */
const char *invcal_refusal_text(invcal_status status);

#endif
