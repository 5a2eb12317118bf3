/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/thermal.h"
#include "bytes.h"
#include "polynomials.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-slevel 200 -eva-slevel-merge-after-loop @all -eva-slevel-function invcal_crc32:0 -eva-split-return full
// stubs: record_v1 thermal_record
// config: -DINVCAL_THERMAL_DEGREE=0
// config: -DINVCAL_THERMAL_DEGREE=2

enum {
    BEHIND = INVCAL_RECORD_SIZE_V1 - INVCAL_RECORD_SIZE,
    LARGEST = INVCAL_THERMAL_RECORD_BYTES(255u) + BEHIND
};

/* ---- what other modules do -------------------------------------------------------------------- */

invcal_status invcal_record_from_v1(const uint8_t *old, uint32_t size,
                                    uint8_t bytes[INVCAL_RECORD_SIZE])
{
    (void)old[size - 1];
    Frama_C_make_unknown((char *)bytes, INVCAL_RECORD_SIZE);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_DAMAGED;
}

void invcal_over_field(const uint8_t *record, uint8_t *matrix)
{
    (void)record[INVCAL_RECORD_SIZE_V1 - 1];
    Frama_C_make_unknown((char *)matrix, 36);
}

invcal_status invcal_thermal_check_length(const uint8_t *bytes, unsigned at)
{
    const unsigned length = bytes[2] | (unsigned)bytes[3] << 8;

    for (unsigned degree = 0; degree <= INVCAL_THERMAL_DEGREE; degree++) {
        if (length > at && bytes[at] == degree &&
            length == INVCAL_THERMAL_RECORD_BYTES(degree) + BEHIND) {
            return INVCAL_OK;
        }
    }
    return INVCAL_DAMAGED;
}

invcal_status invcal_thermal_record_decode(const uint8_t *bytes, uint32_t size,
                                           invcal_thermal_record *out)
{
    (void)bytes[size - 1];
    ANY(*out);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_DAMAGED;
}

/* ---- the record ------------------------------------------------------------------------------- */

/* From a buffer of exactly so many bytes, of any version, that state a length (its lower byte from
 * range[0] to range[1], its upper one from range[2] to range[3]) and a degree from least to most. */
static void decode(uint32_t size, const unsigned range[4], unsigned least, unsigned most)
{
    static uint8_t buffer[LARGEST + 1];
    const uint32_t degree_at = 4 + INVCAL_RECORD_SIZE_V1;
    uint8_t *bytes = &buffer[sizeof buffer - size];
    uint8_t now[INVCAL_THERMAL_RECORD_SIZE];

    ANY(buffer);
    if (size > degree_at) {
        bytes[degree_at] = (uint8_t)BETWEEN(least, most);
    }
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(range[0], range[1]);
        bytes[3] = (uint8_t)BETWEEN(range[2], range[3]);
    }
    (void)invcal_thermal_record_from_v1(bytes, size, now);
}

/* The same for all lengths of a range below 512; those that are there apart from those that are not. */
static void decode_lengths(uint32_t size, unsigned low, unsigned high)
{
    while (low <= high) {
        unsigned last = low | 255;
        last = last > size && low <= size ? size : last;
        last = last < high ? last : high;
        const unsigned range[4] = {low % 256, last % 256, low / 256, low / 256};
        decode(size, range, 0, 255);
        low = last + 1;
    }
}

/* The length of each degree that this build reads, with any degree; and all other lengths. */
static void decode_all(uint32_t size)
{
    unsigned next = 0;

    for (unsigned degree = 0; degree <= INVCAL_THERMAL_DEGREE; degree++) {
        const unsigned length = INVCAL_THERMAL_RECORD_BYTES(degree) + BEHIND;
        const unsigned exact[4] = {length % 256, length % 256, length / 256, length / 256};
        decode_lengths(size, next, length - 1);
        for (unsigned stated = 0; stated <= INVCAL_THERMAL_DEGREE; stated++) {
            decode(size, exact, stated, stated);
        }
        decode(size, exact, INVCAL_THERMAL_DEGREE + 1, 255);
        next = length + 1;
    }
    decode_lengths(size, next, 511);
    decode(size, (const unsigned[4]){0, 255, 2, 255}, 0, 255);
}

void main(void)
{
    static const uint32_t size[] = {0, 1, 7, 8, 188, 296, 332, 368, LARGEST};

    for (unsigned i = 0; i < sizeof size / sizeof *size; i++) {
        decode_all(size[i]);
    }
}
