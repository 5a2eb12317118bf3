/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "session/session.h"

// stubs: store session

invcal_status invcal_store_load(const invcal_store *store, uint8_t *bytes, uint32_t capacity,
                                uint32_t *size)
{
    (void)store->slot_size;
    *size = BETWEEN(1, capacity);
    Frama_C_make_unknown((char *)bytes, capacity);
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_IO);
}

invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size)
{
    (void)store->slot_size;
    (void)bytes[BETWEEN(0, size - 1)];
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_IO);
}

uint32_t invcal_session_size(const invcal_session *session)
{
    (void)session->count;
    return BETWEEN(1, INVCAL_SESSION_SIZE);
}

invcal_status invcali_session_take(invcal_session *session, const uint8_t *begun,
                                   invcal_status status, uint32_t size)
{
    (void)begun[INVCAL_SESSION_HEAD - 1];
    (void)size;
    ANY(*session);
    return BETWEEN(0, 1) ? status : INVCAL_DAMAGED;
}

void main(void)
{
    invcal_session session;
    invcal_store store;

    ANY(store);
    ANY(session);
    (void)invcal_session_save(&session, &store);
    (void)invcal_session_load(&session, &store);
}
