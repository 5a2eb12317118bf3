/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/expert.h"
#include "invcal/store.h"
#include "solve.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 46 -eva-slevel 5 -eva-slevel-function main:500,decode_short:20,invcal_load_session_float_24:200,invcal_session_decode_float_24:200,invcal_session_encode:20,decode:20,invcal_unseal:20,invcal_crc32:0,check_numbers:100,invcal_get_reals:250,invcal_put_reals:250
// eva: -eva-split-return full
// stubs: store session nominal sums

enum { HEAD = 76, EACH = 12 };

static invcal_session session;

/* ---- the store: any failure, or so many bytes ------------------------------------------------- */

static unsigned loaded[6]; /* how many, and the length and count that they state */

/* The length's lower byte from low to high, its upper one from low2 to high2, and the count. */
static void state(uint8_t *bytes, uint32_t size, const unsigned range[4], unsigned count)
{
    if (size >= HEAD) {
        bytes[4] = (uint8_t)count;
        bytes[5] = (uint8_t)(count >> 8);
    }
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(range[0], range[1]);
        bytes[3] = (uint8_t)BETWEEN(range[2], range[3]);
    }
}

invcal_status invcal_store_load(const invcal_store *store, uint8_t *bytes, uint32_t capacity,
                                uint32_t *size)
{
    (void)store->slot_size;
    if (loaded[0] > capacity || BETWEEN(0, 1)) {
        return (invcal_status)BETWEEN(INVCAL_BAD_STORE, INVCAL_IO);
    }
    Frama_C_make_unknown((char *)bytes, loaded[0]);
    state(bytes, loaded[0], loaded + 2, loaded[1]);
    *size = loaded[0];
    return INVCAL_OK;
}

invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size)
{
    (void)store->slot_size;
    (void)bytes[size - 1];
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_IO);
}

/* ---- what other modules do -------------------------------------------------------------------- */

invcal_status invcal_nominal_check(const invcal_calibration *nominal)
{
    (void)nominal->offset[2];
    (void)nominal->matrix[2][2];
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

invcal_status invcal_observe(const invcal_calibration *nominal, const invcal_real raw[3],
                             invcal_row *row)
{
    (void)nominal->matrix[2][2];
    (void)raw[2];
    ANY(*row);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_OUT_OF_RANGE;
}

invcal_status invcal_session_begin(invcal_session *s, const invcal_calibration *nominal,
                                   unsigned rate)
{
    (void)nominal->matrix[2][2];
    (void)rate;
    if (BETWEEN(0, 1)) {
        ANY(*s);
        return INVCAL_OK;
    }
    return INVCAL_BAD_RATE;
}

invcal_status invcal_session_rails(invcal_session *s, int32_t low, int32_t high)
{
    (void)low;
    (void)high;
    ANY(s->rests);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_RAILS;
}

void invcal_session_hold(invcal_session *s, uint32_t milliseconds)
{
    s->hold = milliseconds;
    ANY(s->rests);
}

/* ---- the bytes -------------------------------------------------------------------------------- */

/* From a buffer of exactly so many bytes; or from a store that has them. */
static void decode(uint32_t size, const unsigned range[4], unsigned count)
{
    static uint8_t buffer[INVCAL_SESSION_SIZE + EACH];
    uint8_t *bytes = &buffer[sizeof buffer - size];
    invcal_store store;

    ANY(buffer);
    state(bytes, size, range, count);
    (void)invcal_session_decode(bytes, size, &session);
    ANY(store);
    loaded[0] = size;
    loaded[1] = count;
    for (unsigned i = 0; i < 4; i++) {
        loaded[2 + i] = range[i];
    }
    (void)invcal_load_session(&store, &session);
}

static void decode_short(uint32_t size)
{
    static const unsigned range[4][4] = {
        {0, 7, 0, 0}, {8, HEAD - 1, 0, 0}, {HEAD, 255, 0, 0}, {0, 255, 1, 255}};

    for (unsigned i = 0; i < 4; i++) {
        decode(size, range[i], 0);
    }
}

static void decode_whole(unsigned count)
{
    const unsigned length = HEAD + EACH * count;
    const unsigned range[4] = {length % 256, length % 256, length / 256, length / 256};

    decode(length, range, count);
}

static void encode(unsigned count)
{
    uint8_t bytes[INVCAL_SESSION_SIZE];
    uint32_t size;

    ANY(session);
    session.count = (uint8_t)count;
    (void)invcal_session_encode(&session, bytes, &size);
}

static void save(unsigned count)
{
    invcal_store store;

    ANY(store);
    ANY(session);
    session.count = (uint8_t)count;
    (void)invcal_save_session(&store, &session);
}

void main(void)
{
    decode_short(0);
    decode_short(7);
    decode_short(8);
    decode_short(HEAD - 1);
    decode_short(HEAD);
    decode_short(INVCAL_SESSION_SIZE);
    for (unsigned count = 0; count <= INVCAL_MAX_POSITIONS; count++) {
        decode_whole(count);
        encode(count);
        save(count);
    }
    decode_whole(INVCAL_MAX_POSITIONS + 1);
}
