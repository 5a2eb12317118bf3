/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/thermal_record.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-split-return full -eva-slevel 200 -eva-slevel-merge-after-loop @all -eva-slevel-function invcal_crc32:0
// config: -DINVCAL_THERMAL_DEGREE=0
// config: -DINVCAL_THERMAL_DEGREE=2
// trusted: 2
// What has been settled fits into floats, and is put: proved of the record in its own room.

enum { DEGREE_AT = 188, LARGEST = INVCAL_THERMAL_RECORD_BYTES(255u) };

/* From a buffer of exactly so many bytes, that state a length (its lower byte from low to high, its
 * upper one from low2 to high2) and a degree from least to most. */
static void decode(uint32_t size, const unsigned range[4], unsigned least, unsigned most)
{
    static uint8_t buffer[LARGEST + 1];
    uint8_t *bytes = &buffer[sizeof buffer - size];
    invcal_thermal_record record;

    ANY(buffer);
    if (size > DEGREE_AT) {
        bytes[DEGREE_AT] = (uint8_t)BETWEEN(least, most);
    }
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(range[0], range[1]);
        bytes[3] = (uint8_t)BETWEEN(range[2], range[3]);
    }
    (void)invcal_thermal_record_decode(bytes, size, &record);
}

/* The length of each degree that this build reads, with any degree; and all other lengths. */
static void decode_all(uint32_t size)
{
    unsigned next = 0;

    for (unsigned degree = 0; degree <= INVCAL_THERMAL_DEGREE; degree++) {
        const unsigned at = INVCAL_THERMAL_RECORD_BYTES(degree) - 256;
        const unsigned between[4] = {next, at - 1, 1, 1};
        const unsigned exact[4] = {at, at, 1, 1};
        decode(size, between, 0, 255);
        for (unsigned stated = 0; stated <= INVCAL_THERMAL_DEGREE; stated++) {
            decode(size, exact, stated, stated);
        }
        decode(size, exact, INVCAL_THERMAL_DEGREE + 1, 255);
        next = at + 1;
    }
    decode(size, (const unsigned[4]){0, 255, 0, 0}, 0, 255);
    decode(size, (const unsigned[4]){next, 255, 1, 1}, 0, 255);
    decode(size, (const unsigned[4]){0, 255, 2, 255}, 0, 255);
}

static void encode(unsigned least, unsigned most)
{
    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE];
    invcal_thermal_record record;
    uint32_t length;

    ANY(record);
    record.thermal.degree = (uint8_t)BETWEEN(least, most);
    (void)invcal_thermal_record_encode(&record, bytes, &length);
}

void main(void)
{
    static const uint32_t size[] = {0, 1, 7, 8, 187, 295, 296, 331, 332, 367, 368, LARGEST};

    for (unsigned i = 0; i < sizeof size / sizeof *size; i++) {
        decode_all(size[i]);
    }
    for (unsigned degree = 0; degree <= INVCAL_THERMAL_DEGREE; degree++) {
        encode(degree, degree);
    }
    encode(INVCAL_THERMAL_DEGREE + 1, 255);
}
