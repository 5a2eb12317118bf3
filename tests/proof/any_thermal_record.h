/* SPDX-License-Identifier: MIT
 *
 * Thermal records of any bytes, decoded: for the proofs of functions that read them.
 */
#ifndef ANY_THERMAL_RECORD_H
#define ANY_THERMAL_RECORD_H

#include "arbitrary.h"
#include "invcal/thermal.h"

/* A function that decodes records, and by how much they are longer than those of the present version. */
typedef invcal_status thermal_decoder(const uint8_t *bytes, uint32_t size,
                                      invcal_thermal_record *out);
typedef struct {
    thermal_decoder *decode;
    unsigned longer;
} version;

enum { LARGEST = INVCAL_THERMAL_RECORD_BYTES(255u) + INVCAL_RECORD_SIZE_V1 - INVCAL_RECORD_SIZE };

/* From a buffer of exactly that many bytes, of any version, which state a length (its lower byte from
 * range[0] to range[1], its upper one from range[2] to range[3]) and a degree from least to most. */
static void decode(version of, uint32_t size, const unsigned range[4], unsigned least,
                   unsigned most)
{
    static uint8_t buffer[LARGEST + 1];
    const uint32_t degree_at = 4 + INVCAL_RECORD_SIZE + of.longer;
    uint8_t *bytes = &buffer[sizeof buffer - size];
    invcal_thermal_record record;

    ANY(buffer);
    if (size > degree_at) {
        bytes[degree_at] = (uint8_t)BETWEEN(least, most);
    }
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(range[0], range[1]);
        bytes[3] = (uint8_t)BETWEEN(range[2], range[3]);
    }
    (void)of.decode(bytes, size, &record);
}

/* The same for all lengths of a range below 512; lengths that fit the buffer separately from the others. */
static void decode_lengths(version of, uint32_t size, unsigned low, unsigned high)
{
    while (low <= high) {
        unsigned last = low | 255;
        last = last > size && low <= size ? size : last;
        last = last < high ? last : high;
        const unsigned range[4] = {low % 256, last % 256, low / 256, low / 256};
        decode(of, size, range, 0, 255);
        low = last + 1;
    }
}

/* The length of each degree that this build reads, with any degree; and all other lengths. */
static void decode_all(version of, uint32_t size)
{
    unsigned next = 0;

    for (unsigned degree = 0; degree <= INVCAL_THERMAL_DEGREE; degree++) {
        const unsigned length = INVCAL_THERMAL_RECORD_BYTES(degree) + of.longer;
        const unsigned exact[4] = {length % 256, length % 256, length / 256, length / 256};
        decode_lengths(of, size, next, length - 1);
        for (unsigned stated = 0; stated <= INVCAL_THERMAL_DEGREE; stated++) {
            decode(of, size, exact, stated, stated);
        }
        decode(of, size, exact, INVCAL_THERMAL_DEGREE + 1, 255);
        next = length + 1;
    }
    decode_lengths(of, size, next, 511);
    decode(of, size, (const unsigned[4]){0, 255, 2, 255}, 0, 255);
}

/* Sizes of no record, and of one of each degree. */
static void decode_any(version of)
{
    static const uint32_t size[] = {0, 1, 7, 8, 140, 248, 284, 320};

    for (unsigned i = 0; i < sizeof size / sizeof *size; i++) {
        decode_all(of, size[i] > 8 ? size[i] + of.longer : size[i]);
    }
    decode_all(of, LARGEST);
}

#endif
