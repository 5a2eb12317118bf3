/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/thermal.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-slevel 200 -eva-slevel-merge-after-loop @all -eva-slevel-function invcal_crc32:0
// eva: -eva-split-return-function invcal_unseal:0,read_thermal:0,check_length:0,check_thermal:0,invcal_record_encode:0,read_record:0,invcal_nominal_check:0
// config: -DINVCAL_THERMAL_DEGREE=0
// config: -DINVCAL_THERMAL_DEGREE=2

enum { BEHIND = INVCAL_RECORD_SIZE_MAX - INVCAL_RECORD_SIZE, LARGEST = INVCAL_THERMAL_RECORD_BYTES(255u) + BEHIND };

/* From a buffer of exactly so many bytes, of any version, that state a length (its lower byte from
 * range[0] to range[1], its upper one from range[2] to range[3]) and, where version `version` has it,
 * a degree from least to most. */
static void decode(uint32_t size, const unsigned range[4], unsigned version, unsigned least,
                   unsigned most)
{
    static uint8_t buffer[LARGEST + 1];
    const uint32_t degree_at = 4 + (version == 1 ? INVCAL_RECORD_SIZE_MAX : INVCAL_RECORD_SIZE);
    uint8_t *bytes = &buffer[sizeof buffer - size];
    invcal_thermal_record record;

    ANY(buffer);
    if (size > degree_at) {
        bytes[degree_at] = (uint8_t)BETWEEN(least, most);
    }
    if (size >= 4) {
        bytes[1] = (uint8_t)version;
        bytes[2] = (uint8_t)BETWEEN(range[0], range[1]);
        bytes[3] = (uint8_t)BETWEEN(range[2], range[3]);
    }
    (void)invcal_thermal_record_decode(bytes, size, &record);
}

/* The length of each degree that this build reads, with any degree; and all other lengths. */
static void decode_version(uint32_t size, unsigned version)
{
    const unsigned more = version == 1 ? BEHIND : 0;
    unsigned next = 0;

    for (unsigned degree = 0; degree <= INVCAL_THERMAL_DEGREE; degree++) {
        const unsigned length = INVCAL_THERMAL_RECORD_BYTES(degree) + more;
        const unsigned between[4] = {next, length % 256 - 1, length / 256, length / 256};
        const unsigned exact[4] = {length % 256, length % 256, length / 256, length / 256};
        decode(size, between, version, 0, 255);
        for (unsigned stated = 0; stated <= INVCAL_THERMAL_DEGREE; stated++) {
            decode(size, exact, version, stated, stated);
        }
        decode(size, exact, version, INVCAL_THERMAL_DEGREE + 1, 255);
        next = length % 256 + 1;
    }
    decode(size, (const unsigned[4]){0, 255, 0, 0}, version, 0, 255);
    decode(size, (const unsigned[4]){next, 255, 1, 1}, version, 0, 255);
    decode(size, (const unsigned[4]){0, 255, 2, 255}, version, 0, 255);
}

static void encode(unsigned least, unsigned most)
{
    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE];
    invcal_thermal_record record;

    ANY(record);
    record.thermal.degree = (uint8_t)BETWEEN(least, most);
    (void)invcal_thermal_record_encode(&record, bytes);
}

static void init(void)
{
    invcal_thermal thermal;
    invcal_quality quality;
    invcal_thermal_record record;

    ANY(thermal);
    ANY(quality);
    (void)invcal_thermal_record_init(&record, &thermal, &quality);
}

void main(void)
{
    static const uint32_t size[] = {0, 1, 7, 8, 140, 188, 248, 284, 296, 320, 332, 368, LARGEST};

    for (unsigned i = 0; i < sizeof size / sizeof *size; i++) {
        decode_version(size[i], 1);
        decode_version(size[i], 2);
    }
    decode(LARGEST, (const unsigned[4]){0, 255, 0, 255}, 3, 0, 255);
    for (unsigned degree = 0; degree <= INVCAL_THERMAL_DEGREE; degree++) {
        encode(degree, degree);
    }
    encode(INVCAL_THERMAL_DEGREE + 1, 255);
    init();
}
