/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/thermal_store.h"
#include "thermal/polynomials.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-slevel 200 -eva-slevel-merge-after-loop @all -eva-slevel-function invcali_crc32:0 -eva-split-return full
// stubs: record solve nominal store

/* ---- what other modules do -------------------------------------------------------------------- */

void invcal_record_init(invcal_record *record, const invcal_calibration *calibration,
                        const invcal_quality *quality)
{
    (void)calibration->matrix[2][2];
    (void)quality->verdict;
    ANY(*record);
}

invcal_status invcal_record_encode(const invcal_record *record, uint8_t bytes[INVCAL_RECORD_SIZE])
{
    (void)record->temperature_known;
    Frama_C_make_unknown((char *)bytes, INVCAL_RECORD_SIZE);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_DAMAGED;
}

invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out)
{
    (void)bytes[size - 1];
    if (BETWEEN(0, 1)) {
        ANY(*out);
        return INVCAL_OK;
    }
    return INVCAL_DAMAGED;
}

invcal_status invcali_compose(const invcal_calibration *nominal, invcal_calibration *c)
{
    (void)nominal->matrix[2][2];
    (void)c->matrix[2][2];
    ANY(*c);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

/* For any X. */
invcal_status invcali_triad(const invcal_real x[INVCAL_PARAMETERS], invcal_calibration *triad)
{
    (void)x[INVCAL_PARAMETERS - 1];
    ANY(*triad);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

invcal_status invcali_nominal_check(const invcal_calibration *nominal)
{
    (void)nominal->matrix[2][2];
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

invcal_status invcal_store_save(const invcal_store *s, const uint8_t *bytes, uint32_t size)
{
    (void)s->slot_size;
    (void)bytes[size - 1];
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_IO;
}

invcal_status invcal_store_load(const invcal_store *s, uint8_t *bytes, uint32_t capacity,
                                uint32_t *size)
{
    (void)s->slot_size;
    Frama_C_make_unknown((char *)bytes, capacity);
    if (BETWEEN(0, 1)) {
        *size = (uint32_t)BETWEEN(1, (int)capacity);
        return INVCAL_OK;
    }
    return INVCAL_NO_RECORD;
}

/* ---- the record ------------------------------------------------------------------------------- */

enum { LARGEST = 212 + 36 * 256, DEGREE_AT = 4 + INVCAL_RECORD_SIZE };

/* From a buffer of exactly that many bytes, which state a length (its lower byte from
 * range[0] to range[1], its upper one from range[2] to range[3]) and a degree from least to most. */
static void decode(uint32_t size, const unsigned range[4], unsigned least, unsigned most)
{
    static uint8_t buffer[LARGEST + 1];
    uint8_t *bytes = &buffer[sizeof buffer - size];
    invcal_thermal out;
    invcal_record about;

    ANY(buffer);
    if (size > DEGREE_AT) {
        bytes[DEGREE_AT] = (uint8_t)BETWEEN(least, most);
    }
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(range[0], range[1]);
        bytes[3] = (uint8_t)BETWEEN(range[2], range[3]);
    }
    (void)invcal_thermal_decode(bytes, size, &out, BETWEEN(0, 1) ? &about : NULL);
}

/* The same for all lengths of a range below 512; lengths that fit the buffer separately from the others. */
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

    for (unsigned degree = 0; degree < INVCAL_ROWS; degree++) {
        const unsigned length = 212 + 36 * (degree + 1);
        const unsigned exact[4] = {length % 256, length % 256, length / 256, length / 256};
        decode_lengths(size, next, length - 1);
        for (unsigned stated = 0; stated < INVCAL_ROWS; stated++) {
            decode(size, exact, stated, stated);
        }
        decode(size, exact, INVCAL_ROWS, 255);
        next = length + 1;
    }
    decode_lengths(size, next, 511);
    decode(size, (const unsigned[4]){0, 255, 2, 255}, 0, 255);
}

/* Sizes of no record, and of one of each degree. */
static void decode_any(void)
{
    static const uint32_t size[] = {0, 1, 7, 8, 140, 248, 284, 320};

    for (unsigned i = 0; i < sizeof size / sizeof *size; i++) {
        decode_all(size[i]);
    }
    decode_all(LARGEST);
}

static void encode(unsigned least, unsigned most)
{
    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE];
    const invcal_store store = {NULL, NULL, NULL, NULL, 0, 0};
    invcal_thermal thermal;
    invcal_record about;
    invcal_quality quality;

    ANY(thermal);
    ANY(about);
    ANY(quality);
    thermal.degree = (uint8_t)BETWEEN(least, most);
    (void)invcal_thermal_encode(&thermal, &about, bytes);
    (void)invcal_thermal_save(&thermal, &quality, &store);
}

void main(void)
{
    const invcal_store store = {NULL, NULL, NULL, NULL, 0, 0};
    invcal_thermal out;

    decode_any();
    for (unsigned degree = 0; degree < INVCAL_ROWS; degree++) {
        encode(degree, degree);
    }
    encode(INVCAL_ROWS, 255);
    (void)invcal_thermal_load(&out, &store);
}
