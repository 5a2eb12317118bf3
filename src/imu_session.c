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
#include "solve.h"

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

static invcal_status resume_moves(invcal_moves *m)
{
    const invcal_status status = invcal_nominal_check(&m->nominal);

    if (status != INVCAL_OK) {
        return status;
    }
    if (!(m->rate >= INVCAL_LEAST_RATE && m->rate <= INVCAL_MOST_RATE)) {
        return INVCAL_BAD_RATE;
    }
    if (m->between >= (uint32_t)INT32_MAX - (uint32_t)m->low) {
        return INVCAL_BAD_LIMITS;
    }
    if (m->count > INVCAL_MAX_MOVES || m->first > INVCAL_MAX_SEGMENTS || !are_moves(m) ||
        !invcal_are_finite(m->bias)) {
        return INVCAL_DAMAGED;
    }
    invcal_moves_restart(m);
    return INVCAL_OK;
}

uint32_t invcal_imu_session_size(const invcal_imu_session *both)
{
    INVCAL_ASSERT(both);
    return OF_MOVES + invcal_session_size(&both->session);
}

invcal_status invcal_imu_session_resume(invcal_imu_session *both, uint32_t size)
{
    INVCAL_ASSERT(both);
    if (size < OF_MOVES || both->moves.layout != INVCAL_MOVES_LAYOUT) {
        return INVCAL_OTHER_VERSION;
    }
    const invcal_status status = resume_moves(&both->moves);
    return status == INVCAL_OK ? invcal_session_resume(&both->session, size - OF_MOVES) : status;
}

/* ---- in a memory ----------------------------------------------------------------------------- */

invcal_status invcal_save_imu_session(const invcal_store *store, const invcal_imu_session *both)
{
    return invcal_store_save(store, (const uint8_t *)both + INVCAL_IMU_SESSION_FROM,
                             invcal_imu_session_size(both));
}

invcal_status invcal_load_imu_session(const invcal_store *store, invcal_imu_session *both)
{
    uint32_t size = 0;

    const invcal_status status = invcal_store_load(store, (uint8_t *)both + INVCAL_IMU_SESSION_FROM,
                                                   INVCAL_IMU_SESSION_SIZE, &size);
    return status == INVCAL_OK ? invcal_imu_session_resume(both, size) : status;
}
