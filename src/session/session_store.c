/* SPDX-License-Identifier: MIT
 *
 * A session in a memory. Not in session.c, so that a device without such a memory does not link
 * store.c.
 */
#include "session.h"
#include "../core/vector.h"

invcal_status invcal_session_save(const invcal_session *session, const invcal_store *store)
{
    return invcal_store_save(store, (const uint8_t *)session, invcal_session_size(session));
}

/* Straight into the session: the table is the largest part of it. */
invcal_status invcal_session_load(invcal_session *session, const invcal_store *store)
{
    uint8_t begun[INVCAL_SESSION_HEAD];
    uint32_t size = 0;

    INVCAL_ASSERT(session);
    if (!invcali_session_is_begun(session)) {
        return INVCAL_NOT_BEGUN;
    }
    invcali_copy(begun, session, sizeof begun);
    const invcal_status status =
        invcal_store_load(store, (uint8_t *)session, INVCAL_SESSION_SIZE, &size);
    return invcali_session_take(session, begun, status, size);
}
