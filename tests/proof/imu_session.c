/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "rotation.h"
#include "solve.h"

// eva: -eva-precision 2 -eva-slevel 40 -eva-split-return full
// stubs: store session moves nominal

invcal_status invcal_nominal_check(const invcal_calibration *nominal)
{
    (void)nominal->matrix[2][2];
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

void invcal_moves_restart(invcal_moves *m)
{
    (void)m->count;
    ANY(*m);
}

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

invcal_status invcal_session_resume(invcal_session *session, uint32_t size)
{
    (void)size;
    ANY(*session);
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_IO);
}

void main(void)
{
    static invcal_imu_session both;
    invcal_store store;

    ANY(store);
    ANY(both);
    (void)invcal_imu_session_save(&both, &store);
    (void)invcal_imu_session_load(&both, &store);
    ANY(both);
    both.moves.layout = INVCAL_MOVES_LAYOUT;
    (void)invcal_imu_session_resume(&both, BETWEEN(0, UINT32_MAX));
}
