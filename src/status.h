/* SPDX-License-Identifier: MIT
 *
 * Internal: the sentences for refusals of a session, linked without the others.
 */
#ifndef INVCAL_STATUS_H
#define INVCAL_STATUS_H

#include "invcal/invcal.h"

/* Of INVCAL_OUT_OF_RANGE ... INVCAL_REST_SAME; "" for INVCAL_OK; any other gives that of a reading far from
 * the field. */
const char *invcal_refusal_text(invcal_status status);

#endif
