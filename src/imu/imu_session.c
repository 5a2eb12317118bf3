/* SPDX-License-Identifier: MIT
 *
 * Keeps moves and session of both sensors over a reset. The lasting end of the one and the lasting
 * beginning of the other are adjacent in invcal_imu, so they are saved as one run of bytes, and are
 * of the same instant.
 *
 * Bytes put back are checked in full. Where the segments of a move begin is known only from the
 * lengths of all moves before it: one wrong length would lead beyond the table.
 */
#include <stddef.h>

#include "imu.h"
#include "invcal/gyro_store.h"
#include "rotation.h"
#include "../session/session.h"

/* The first byte to keep, and how many before the session, which follows. */
#define FROM offsetof(invcal_imu, own.layout)
#define OF_MOVES ((uint32_t)(offsetof(invcal_imu, session) - FROM))

/* Returns whether the rests are in order of time, and the segments those of their moves. */
static int are_moves(const invcal_imu *imu)
{
    const invcal_private_moves *m = &imu->own;
    unsigned segments = 0;
    uint16_t when = 0;

    for (unsigned i = 0; i < imu->rests; i++) {
        const invcal_private_still *rest = &m->rest[i];
        const int is_good =
            rest->move > 0 ? i > 0 : rest->move > -INVCAL_STATUS_END && rest->move < 0;
        if (!is_good || rest->when < when) {
            return 0;
        }
        when = rest->when;
        segments += rest->move > 0 ? (unsigned)rest->move : 0;
    }
    return when <= m->blocks && segments == m->first;
}

/* What a session of both sensors was begun with. */
typedef struct {
    invcal_calibration nominal; /* of the gyroscope, and so the next three */
    invcal_real rate;
    int32_t low;
    uint32_t between;
    uint8_t session[INVCAL_SESSION_HEAD];
} both_settings;

static void remember(const invcal_imu *both, both_settings *begun)
{
    begun->nominal = both->nominal;
    begun->rate = both->own.rate;
    begun->low = both->own.low;
    begun->between = both->own.between;
    invcali_copy(begun->session, &both->session, sizeof begun->session);
}

static invcal_status check_moves(const invcal_imu *both, const both_settings *begun, uint32_t size)
{
    const invcal_private_moves *m = &both->own;

    if (size < OF_MOVES || m->layout != INVCAL_MOVES_LAYOUT ||
        !invcali_is_same((const uint8_t *)&both->nominal, (const uint8_t *)&begun->nominal,
                         (unsigned)sizeof both->nominal) ||
        !invcali_is_same((const uint8_t *)&m->rate, (const uint8_t *)&begun->rate,
                         (unsigned)sizeof m->rate)) {
        return INVCAL_OTHER_SETTINGS;
    }
    return both->rests > INVCAL_MAX_MOVES || m->first > INVCAL_MAX_SEGMENTS || !are_moves(both) ||
                   !invcali_are_finite(m->bias)
               ? INVCAL_DAMAGED
               : INVCAL_OK;
}

invcal_status invcal_imu_save(const invcal_imu *imu, const invcal_store *store)
{
    INVCAL_ASSERT(imu && store);
    if (!invcali_imu_is_begun(imu)) {
        return INVCAL_NOT_BEGUN;
    }
    return invcal_store_save(store, (const uint8_t *)imu + FROM,
                             OF_MOVES + invcal_session_size(&imu->session));
}

/* As invcali_session_take, of both: all is taken over, or nothing. */
invcal_status invcal_imu_load(invcal_imu *imu, const invcal_store *store)
{
    uint32_t size = 0;
    both_settings begun;

    INVCAL_ASSERT(imu && store);
    if (!invcali_imu_is_begun(imu)) {
        return INVCAL_NOT_BEGUN;
    }
    remember(imu, &begun);
    invcal_status status = invcal_store_load(store, (uint8_t *)imu + FROM, INVCAL_IMU_SIZE, &size);
    if (status == INVCAL_OK) {
        status = check_moves(imu, &begun, size);
    }
    status = invcali_session_take(&imu->session, begun.session, status, size - OF_MOVES);
    if (status == INVCAL_OK) {
        invcali_moves_restart(imu);
    } else {
        invcali_moves_empty(imu, &begun.nominal, begun.rate);
    }
    imu->own.low = begun.low;
    imu->own.between = begun.between;
    return status;
}
