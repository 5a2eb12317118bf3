/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "driver.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 46 -eva-slevel 5 -eva-slevel-function main:500,keep:20,decode_short:20,decode:20,invcal_unseal:20,invcal_crc32:0,invcal_rests_init:40,invcal_nominal_check:40,invcal_cofactors:20,check_numbers:100,invcal_get_reals:250,invcal_put_reals:250
// eva: -eva-split-return auto

enum { HEAD = 76, EACH = 12 };

static invcal_session session;

/* From a buffer of exactly so many bytes, that state a length (its lower byte from low to high, its
 * upper one from low2 to high2) and so many positions. */
static void decode(uint32_t size, const unsigned range[4], unsigned count)
{
    static uint8_t buffer[INVCAL_SESSION_SIZE + EACH];
    uint8_t *bytes = &buffer[sizeof buffer - size];

    ANY(buffer);
    if (size >= HEAD) {
        bytes[4] = (uint8_t)count;
        bytes[5] = (uint8_t)(count >> 8);
    }
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(range[0], range[1]);
        bytes[3] = (uint8_t)BETWEEN(range[2], range[3]);
    }
    (void)invcal_session_decode(bytes, size, &session);
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

/* invcal_load_session is left out: that what was loaded is initialised as far as it is long, no interval tells. */
static void keep(unsigned count)
{
    const invcal_store store = {any_read, any_erase, any_program, NULL, 1024, 8};

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
        keep(count);
    }
    decode_whole(INVCAL_MAX_POSITIONS + 1);
}
