/* SPDX-License-Identifier: MIT
 *
 * A session in a memory. Not in session.c, so that a device without such a memory does not link
 * store.c.
 */
#include "invcal/store.h"

invcal_status invcal_save_session(const invcal_store *store, const invcal_session *session)
{
    return invcal_store_save(store, (const uint8_t *)session, invcal_session_size(session));
}

invcal_status invcal_load_session(const invcal_store *store, invcal_session *session)
{
    uint32_t size = 0;

    const invcal_status status =
        invcal_store_load(store, (uint8_t *)session, INVCAL_SESSION_SIZE, &size);
    return status == INVCAL_OK ? invcal_session_resume(session, size) : status;
}
