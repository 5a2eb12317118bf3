/* SPDX-License-Identifier: MIT */
#include "history_session.h"
#include "invcal/resume.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 46 -eva-slevel 0 -eva-slevel-function main:500,decode_short:20,decode_whole:20,invcal_resume_decode:5,invcal_still_init:40,invcal_observe:10,scale:10,check_settings:10,invcal_calibration_inverse:40,divide:40
// eva: -eva-split-return-function invcal_still_init:0,invcal_observe:0,scale:0,exact:0,check_reading:0,check_settings:0,invcal_settings_check:0,invcal_calibration_inverse:0,divide:0,invcal_plan_check:0,invcal_session_init:0,row_of:0,settle_head:0,read_head:0
// trusted: 2

enum { HEAD = 168, SUMS = 164, EACH = 13 };

static invcal_session session;

/* From a buffer of exactly so many bytes, that state a length (its lower byte from low to high, its
 * upper one from low2 to high2) and so many positions in the table; of these and more, by `more`:
 * 0 no more, 1 up to 255 in all, 2, 3, 4: the count has its second, third, fourth byte. */
static void decode(uint32_t size, const unsigned range[4], unsigned stored, unsigned more)
{
    static uint8_t buffer[INVCAL_RESUME_SIZE + EACH];
    uint8_t *bytes = &buffer[sizeof buffer - size];

    ANY(buffer);
    if (size >= HEAD) {
        bytes[4] = (uint8_t)stored;
        bytes[5] = (uint8_t)(stored >> 8);
        bytes[8] = (uint8_t)(more == 0   ? BETWEEN(0, stored)
                             : more == 1 ? BETWEEN(stored + 1, 255)
                                         : BETWEEN(0, 255));
        for (unsigned i = 1; i < 4 && more < 2; i++) {
            bytes[8 + i] = 0;
        }
        if (more >= 2) {
            bytes[7 + more] = (uint8_t)BETWEEN(1, 255);
        }
    }
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(range[0], range[1]);
        bytes[3] = (uint8_t)BETWEEN(range[2], range[3]);
    }
    (void)invcal_resume_decode(bytes, size, &session);
}

static void decode_short(uint32_t size)
{
    static const unsigned range[4][4] = {
        {0, 7, 0, 0}, {8, HEAD - 1, 0, 0}, {HEAD, 255, 0, 0}, {0, 255, 1, 255}};

    for (unsigned i = 0; i < 4; i++) {
        decode(size, range[i], 0, 0);
    }
}

static void decode_whole(unsigned stored)
{
    for (unsigned more = 0; more <= 4; more++) {
        const unsigned length = HEAD + EACH * stored + (more ? SUMS : 0);
        const unsigned range[4] = {length % 256, length % 256, length / 256, length / 256};
        decode(length, range, stored, more);
    }
}

static void encode(unsigned stored, uint32_t least, uint32_t most)
{
    uint8_t bytes[INVCAL_RESUME_SIZE];
    uint32_t size;

    any_session(&session);
    session.stored = (uint16_t)stored;
    session.normal.count = BETWEEN(least, most);
    (void)invcal_resume_encode(&session, bytes, &size);
}

void main(void)
{
    decode_short(0);
    decode_short(7);
    decode_short(8);
    decode_short(HEAD - 1);
    decode_short(HEAD);
    decode_short(INVCAL_RESUME_SIZE);
    for (unsigned stored = 0; stored <= INVCAL_MAX_POSITIONS; stored++) {
        decode_whole(stored);
        encode(stored, 0, stored);
        encode(stored, stored + 1, 0xFFFFFFFF);
    }
    decode_whole(INVCAL_MAX_POSITIONS + 1);
    encode(BETWEEN(INVCAL_MAX_POSITIONS + 1, 0xFFFF), 0, 0xFFFFFFFF);
}
