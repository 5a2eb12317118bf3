/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "imu/imu.h"
#include "invcal/gyro_store.h"

// eva: -eva-precision 2 -eva-slevel 40 -eva-split-return full
// stubs: store session moves

void invcali_moves_empty(invcal_imu *m, const invcal_calibration *nominal, invcal_real rate)
{
    (void)nominal->matrix[2][2];
    (void)rate;
    ANY(*m);
}

void invcali_moves_restart(invcal_imu *m)
{
    (void)m->rests;
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
    static invcal_imu both;
    invcal_store store;

    ANY(store);
    ANY(both);
    (void)invcal_imu_save(&both, &store);
    ANY(both);
    (void)invcal_imu_load(&both, &store);
}
