/* SPDX-License-Identifier: MIT */
#include "invcal/store.h"

#include <stddef.h>
#include <string.h>

#include "bytes.h"
#include "solve.h"

enum { SESSION_KIND = 0xC5, SESSION_OLDEST = 2 };
enum { COUNT_AT = 4, RATE_AT = 6, HOLD_AT = 8, LOW_AT = 12, HIGH_AT = 16, SESSION_REALS_AT = 20 };
enum { MEANS_AT = 72, MEAN_SIZE = 12, BEFORE_MEANS = 13 }; /* the last in reals */

/* What a session begins with. */
typedef struct {
    invcal_calibration nominal;
    invcal_real noise;
} session_head;

/* The reals come first in the session, too, and in the same order. */
typedef char
    invcal_session_is_in_order[offsetof(invcal_session, mean) == sizeof(session_head) &&
                                       sizeof(session_head) == BEFORE_MEANS * sizeof(invcal_real)
                                   ? 1
                                   : -1];

static uint32_t length_of(unsigned count)
{
    return MEANS_AT + (uint32_t)MEAN_SIZE * count + INVCAL_CRC_SIZE;
}

static int32_t get_i32(const uint8_t *bytes)
{
    const uint32_t bits = invcal_get_u32(bytes);
    int32_t value;

    memcpy(&value, &bits, sizeof value); /* the conversion would be the compiler's choice */
    return value;
}

/* Could these numbers be a session's? */
static invcal_status check_numbers(const uint8_t *bytes, session_head *h)
{
    const unsigned count = invcal_get_u16(bytes + COUNT_AT);
    invcal_real mean[3];
    invcal_row row;

    (void)invcal_get_reals(bytes + SESSION_REALS_AT, h, BEFORE_MEANS);
    if (!(h->noise >= 0 && h->noise < 1)) {
        return INVCAL_BAD_NOISE;
    }
    invcal_status status = invcal_nominal_check(&h->nominal);
    bytes += MEANS_AT;
    for (unsigned i = 0; i < count && status == INVCAL_OK; i++) {
        (void)invcal_get_reals(bytes, mean, 3);
        status = invcal_observe(&h->nominal, mean, &row);
        bytes += MEAN_SIZE;
    }
    return status;
}

invcal_status invcal_session_encode(const invcal_session *session,
                                    uint8_t bytes[INVCAL_SESSION_SIZE], uint32_t *size)
{
    session_head h;

    INVCAL_ASSERT(session && bytes && size && session->count <= INVCAL_MAX_POSITIONS);
    uint8_t *at = invcal_put_two(bytes + COUNT_AT, session->count, session->rests.rate);
    at = invcal_put_u32(at, session->hold);
    at = invcal_put_u32(at, (uint32_t)session->rests.low);
    at = invcal_put_u32(at, (uint32_t)session->rests.low + session->rests.between + 1u);
    (void)invcal_put_reals(at, session, BEFORE_MEANS + 3u * session->count);
    *size = length_of(session->count);
    invcal_seal(bytes, SESSION_KIND, *size);
    return check_numbers(bytes, &h);
}

invcal_status invcal_session_decode(const uint8_t *bytes, uint32_t size, invcal_session *out)
{
    session_head h;

    INVCAL_ASSERT(bytes && out);
    invcal_status status = invcal_unseal(bytes, size, SESSION_KIND, SESSION_OLDEST);
    if (status != INVCAL_OK) {
        return status;
    }
    const unsigned count = invcal_get_u16(bytes + COUNT_AT);
    if (invcal_get_u16(bytes + 2) != length_of(count)) {
        return INVCAL_DAMAGED;
    }
    if (count > INVCAL_MAX_POSITIONS) {
        return INVCAL_NO_SPACE;
    }
    const int32_t low = get_i32(bytes + LOW_AT);
    const int32_t high = get_i32(bytes + HIGH_AT);
    status = low < high ? check_numbers(bytes, &h) : INVCAL_BAD_RAILS;
    if (status == INVCAL_OK) { /* the first that writes, and only if it accepts */
        status = invcal_session_begin(out, &h.nominal, invcal_get_u16(bytes + RATE_AT));
    }
    if (status == INVCAL_OK) {
        (void)invcal_session_rails(out, low, high);
        invcal_session_hold(out, invcal_get_u32(bytes + HOLD_AT));
        (void)invcal_get_reals(bytes + SESSION_REALS_AT, out, BEFORE_MEANS + 3 * count);
        out->count = (uint8_t)count;
    }
    return status;
}

/* ---- in a memory ------------------------------------------------------------------------------- */

invcal_status invcal_save_session(const invcal_store *store, const invcal_session *session)
{
    uint8_t bytes[INVCAL_SESSION_SIZE];
    uint32_t size = 0;

    const invcal_status status = invcal_session_encode(session, bytes, &size);
    return status == INVCAL_OK ? invcal_store_save(store, bytes, size) : status;
}

invcal_status invcal_load_session(const invcal_store *store, invcal_session *session)
{
    uint8_t bytes[INVCAL_SESSION_SIZE];
    uint32_t size = 0;

    const invcal_status status = invcal_store_load(store, bytes, sizeof bytes, &size);
    return status == INVCAL_OK ? invcal_session_decode(bytes, size, session) : status;
}
