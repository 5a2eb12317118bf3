/* SPDX-License-Identifier: MIT
 *
 * Internal: what a session and its memory share.
 */
#ifndef INVCAL_SESSION_H
#define INVCAL_SESSION_H

#include <stddef.h>

#include "invcal/store.h"
#include "../core/vector.h"

#define INVCAL_SESSION_HEAD ((uint32_t)offsetof(invcal_session, mean)) /* bytes before the means */

/* Identifies layout, number type and byte order: one byte, shifted, which is short code. */
#define INVCAL_SESSION_LAYOUT ((INVCAL_SESSION_HEAD + 1u) << 20)

/* Like all before the means, at the same place in every build. */
static inline int invcali_session_is_begun(const invcal_session *session)
{
    return session->layout == INVCAL_SESSION_LAYOUT;
}

/* Are they the same bytes? */
static INVCAL_ONCE int invcali_is_same(const uint8_t *a, const uint8_t *b, unsigned size)
{
    for (unsigned i = 0; i < size; i++) {
        if (a[i] != b[i]) {
            return 0;
        }
    }
    return 1;
}

/* The session was begun, and then its first bytes were loaded: takes over their positions, if they
 * are of the same build and the same settings, and else none. All other settings are as begun.
 *
 * begun   the bytes before the means, as they were before.
 * status  of loading: nothing is taken over unless it is INVCAL_OK.
 * size    how many bytes were loaded.
 *
 * Returns status; INVCAL_OTHER_SETTINGS, INVCAL_DAMAGED. */
invcal_status invcali_session_take(invcal_session *session, const uint8_t *begun,
                                   invcal_status status, uint32_t size);

#endif
