/* SPDX-License-Identifier: MIT */
#include "invcal/store.h"

#include <stddef.h>
#include <string.h>

#include "bytes.h"
#include "judge.h"

enum { KIND = 0xC5, FIRST_VERSION = 2 };
enum { REALS_AT = 20, HEAD_REALS = 13, MEANS_AT = 72, MEAN_SIZE = 12 };

static unsigned length_of(unsigned count)
{
    return MEANS_AT + MEAN_SIZE * count + INVCAL_CRC_SIZE;
}

static int32_t get_i32(const uint8_t *bytes)
{
    const uint32_t bits = invcal_get_u32(bytes);
    int32_t value;

    memcpy(&value, &bits, sizeof value);
    return value;
}

/* What stands first in a session, too. */
typedef struct {
    invcal_calibration nominal;
    invcal_real noise;
} head;

/* Could these bytes be those of a session? */
static invcal_status check(const uint8_t *bytes, head *h)
{
    const unsigned count = invcal_get_u16(bytes + 4);
    invcal_status status = INVCAL_OK;
    invcal_real mean[3];
    invcal_row row;

    (void)invcal_get_reals(bytes + REALS_AT, h, HEAD_REALS);
    if (!(h->noise >= 0 && h->noise < 1)) {
        return INVCAL_BAD_NOISE;
    }
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
    head h;
    const unsigned length = length_of(session->count);

    INVCAL_ASSERT(session && bytes && size);
    uint8_t *at = invcal_put_two(bytes + 4, session->count, session->rests.rate);
    at = invcal_put_u32(at, session->hold);
    at = invcal_put_u32(at, (uint32_t)session->rests.low);
    at = invcal_put_u32(at, (uint32_t)session->rests.high);
    (void)invcal_put_reals(at, session, HEAD_REALS + 3u * session->count);
    invcal_seal(bytes, KIND, length);
    *size = length;
    return check(bytes, &h);
}

invcal_status invcal_session_decode(const uint8_t *bytes, uint32_t size, invcal_session *out)
{
    head h;

    INVCAL_ASSERT(bytes && out);
    const invcal_status status = invcal_unseal(bytes, size, KIND, FIRST_VERSION);
    if (status != INVCAL_OK) {
        return status;
    }
    const unsigned count = invcal_get_u16(bytes + 4);
    if (invcal_get_u16(bytes + 2) != length_of(count)) {
        return INVCAL_DAMAGED;
    }
    if (count > INVCAL_MAX_POSITIONS) {
        return INVCAL_NO_SPACE;
    }
    const int32_t low = get_i32(bytes + 12);
    const int32_t high = get_i32(bytes + 16);
    if (check(bytes, &h) != INVCAL_OK || low >= high ||
        invcal_session_begin(out, &h.nominal, invcal_get_u16(bytes + 6)) != INVCAL_OK) {
        return INVCAL_DAMAGED;
    }
    (void)invcal_session_rails(out, low, high);
    invcal_session_hold(out, invcal_get_u32(bytes + 8));
    (void)invcal_get_reals(bytes + REALS_AT, out, HEAD_REALS + 3 * count);
    out->count = (uint8_t)count;
    return INVCAL_OK;
}

invcal_status invcal_save_session(const invcal_store *store, const invcal_session *session)
{
    uint8_t bytes[INVCAL_SESSION_SIZE];
    uint32_t size;

    const invcal_status status = invcal_session_encode(session, bytes, &size);
    return status == INVCAL_OK ? invcal_store_save(store, bytes, size) : status;
}

invcal_status invcal_load_session(const invcal_store *store, invcal_session *session)
{
    uint8_t bytes[INVCAL_SESSION_SIZE];
    uint32_t size;

    const invcal_status status = invcal_store_load(store, bytes, sizeof bytes, &size);
    return status == INVCAL_OK ? invcal_session_decode(bytes, size, session) : status;
}
