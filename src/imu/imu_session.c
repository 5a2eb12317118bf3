/* SPDX-License-Identifier: MIT
 *
 * Keeps moves and session of both sensors over a reset. The lasting end of the one and the lasting
 * beginning of the other are adjacent in invcal_imu_session, so they are saved as one run of bytes,
 * and are of the same instant.
 *
 * Bytes put back are checked in full. Where the segments of a move begin is known only from the
 * lengths of all moves before it: one wrong length would lead beyond the table.
 */
#include <stddef.h>

#include "rotation.h"
#include "../session/session.h"

/* The bytes of the moves to keep; the session follows. */
#define OF_MOVES ((uint32_t)(offsetof(invcal_imu_session, session) - INVCAL_IMU_SESSION_FROM))

/* Returns whether the rests are in order of time, and the segments those of their moves. */
static int are_moves(const invcal_moves *m)
{
    unsigned segments = 0;
    uint16_t when = 0;

    for (unsigned i = 0; i < m->count; i++) {
        const invcal_still *rest = &m->rest[i];
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

static void remember(const invcal_imu_session *both, both_settings *begun)
{
    begun->nominal = both->moves.nominal;
    begun->rate = both->moves.rate;
    begun->low = both->moves.low;
    begun->between = both->moves.between;
    invcal_copy(begun->session, &both->session, sizeof begun->session);
}

static invcal_status check_moves(const invcal_moves *m, const both_settings *begun, uint32_t size)
{
    if (size < OF_MOVES || m->layout != INVCAL_MOVES_LAYOUT ||
        !invcal_is_same((const uint8_t *)&m->nominal, (const uint8_t *)&begun->nominal,
                        (unsigned)sizeof m->nominal) ||
        !invcal_is_same((const uint8_t *)&m->rate, (const uint8_t *)&begun->rate,
                        (unsigned)sizeof m->rate)) {
        return INVCAL_OTHER_SETTINGS;
    }
    return m->count > INVCAL_MAX_MOVES || m->first > INVCAL_MAX_SEGMENTS || !are_moves(m) ||
                   !invcal_are_finite(m->bias)
               ? INVCAL_DAMAGED
               : INVCAL_OK;
}

static int both_are_begun(const invcal_imu_session *both)
{
    return both->moves.layout == INVCAL_MOVES_LAYOUT && invcal_session_is_begun(&both->session);
}

/* As invcal_session_take, of both: all is taken over, or nothing. */
static invcal_status take(invcal_imu_session *both, const both_settings *begun,
                          invcal_status status, uint32_t size)
{
    invcal_moves *m = &both->moves;

    if (status == INVCAL_OK) {
        status = check_moves(m, begun, size);
    }
    status = invcal_session_take(&both->session, begun->session, status, size - OF_MOVES);
    if (status == INVCAL_OK) {
        invcal_moves_restart(m);
    } else {
        invcal_moves_empty(m, &begun->nominal, begun->rate);
    }
    m->low = begun->low;
    m->between = begun->between;
    return status;
}

uint32_t invcal_imu_session_size(const invcal_imu_session *both)
{
    INVCAL_ASSERT(both);
    return OF_MOVES + invcal_session_size(&both->session);
}

invcal_status invcal_imu_session_resume(invcal_imu_session *both, const uint8_t *bytes,
                                        uint32_t size)
{
    invcal_status status = INVCAL_OK;
    both_settings begun;

    INVCAL_ASSERT(both && bytes);
    if (!both_are_begun(both)) {
        return INVCAL_NOT_BEGUN;
    }
    if (size > INVCAL_IMU_SESSION_SIZE) {
        status = INVCAL_NO_SPACE;
        size = 0;
    }
    remember(both, &begun);
    invcal_copy((uint8_t *)both + INVCAL_IMU_SESSION_FROM, bytes, (size_t)size);
    return take(both, &begun, status, size);
}

/* ---- in a memory ----------------------------------------------------------------------------- */

invcal_status invcal_imu_session_save(const invcal_imu_session *both, const invcal_store *store)
{
    INVCAL_ASSERT(both);
    return invcal_store_save(store, (const uint8_t *)both + INVCAL_IMU_SESSION_FROM,
                             invcal_imu_session_size(both));
}

invcal_status invcal_imu_session_load(invcal_imu_session *both, const invcal_store *store)
{
    uint32_t size = 0;
    both_settings begun;

    INVCAL_ASSERT(both);
    if (!both_are_begun(both)) {
        return INVCAL_NOT_BEGUN;
    }
    remember(both, &begun);
    const invcal_status status = invcal_store_load(store, (uint8_t *)both + INVCAL_IMU_SESSION_FROM,
                                                   INVCAL_IMU_SESSION_SIZE, &size);
    return take(both, &begun, status, size);
}
