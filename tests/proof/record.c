/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "driver.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 40 -eva-slevel-function main:200,decode:20,invcal_unseal:20,read_record:20

/* From a buffer of exactly so many bytes, that state a length from low to high. */
static void decode(uint32_t size, unsigned low, unsigned high)
{
    uint8_t buffer[INVCAL_RECORD_SIZE_MAX + 2];
    uint8_t *bytes = &buffer[sizeof buffer - size];
    invcal_record record;

    ANY(buffer);
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(low, high);
        bytes[3] = 0;
    }
    (void)invcal_record_decode(bytes, size, &record);
}

/* invcal_load is left out: that what was loaded is initialised as far as it is long, no interval tells. */
static void keep(void)
{
    const invcal_store store = {any_read, any_erase, any_program, NULL, 512, 8};
    invcal_calibration calibration;
    invcal_quality quality;

    ANY(calibration);
    ANY(quality);
    (void)invcal_save(&store, &calibration, &quality);
}

void main(void)
{
    keep();
    uint8_t bytes[INVCAL_RECORD_SIZE_MAX];
    invcal_record record;

    static const uint32_t sizes[] = {0, 3, 4, 7, 8, 9, 100, 135, 136, 137, 183, 184, 185, 186};

    for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const uint32_t size = sizes[i];
        decode(size, 0, INVCAL_RECORD_SIZE - 1);
        decode(size, INVCAL_RECORD_SIZE, INVCAL_RECORD_SIZE);
        decode(size, INVCAL_RECORD_SIZE + 1, INVCAL_RECORD_SIZE_MAX - 1);
        decode(size, INVCAL_RECORD_SIZE_MAX, INVCAL_RECORD_SIZE_MAX);
        decode(size, INVCAL_RECORD_SIZE_MAX + 1, 255);
    }
    ANY(bytes);
    bytes[3] = (uint8_t)BETWEEN(1, 255);
    (void)invcal_record_decode(bytes, sizeof bytes, &record);
    ANY(record);
    (void)invcal_record_encode(&record, bytes);
}
