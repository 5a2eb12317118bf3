/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/store.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 40 -eva-slevel 20 -eva-slevel-function main:400,invcal_crc32:0 -eva-split-return full
// stubs: store record

/* From a buffer of exactly so many bytes, that state a length from low to high. */
static void decode(uint32_t size, unsigned low, unsigned high)
{
    uint8_t buffer[INVCAL_RECORD_SIZE_V1 + 2];
    uint8_t *bytes = &buffer[sizeof buffer - size];
    uint8_t now[INVCAL_RECORD_SIZE];

    ANY(buffer);
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(low, high);
        bytes[3] = 0;
    }
    (void)invcal_record_from_v1(bytes, size, now);
}

/* ---- the store: any failure, or so many bytes ------------------------------------------------- */

static unsigned loaded[3]; /* how many, and the length that they state: from, to */

invcal_status invcal_store_load(const invcal_store *store, uint8_t *bytes, uint32_t capacity,
                                uint32_t *size)
{
    (void)store->slot_size;
    if (loaded[0] > capacity || BETWEEN(0, 1)) {
        return (invcal_status)BETWEEN(INVCAL_BAD_STORE, INVCAL_IO);
    }
    Frama_C_make_unknown((char *)bytes, loaded[0]);
    if (loaded[0] >= 4) {
        bytes[2] = (uint8_t)BETWEEN(loaded[1], loaded[2]);
        bytes[3] = 0;
    }
    *size = loaded[0];
    return INVCAL_OK;
}

/* ---- the record ------------------------------------------------------------------------------- */

invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out)
{
    (void)bytes[size - 1];
    if (BETWEEN(0, 1)) {
        ANY(*out);
        return INVCAL_OK;
    }
    return INVCAL_DAMAGED;
}

static void load(uint32_t size, unsigned low, unsigned high)
{
    invcal_store store;
    invcal_calibration calibration;

    ANY(store);
    loaded[0] = size;
    loaded[1] = low;
    loaded[2] = high;
    (void)invcal_load_v1(&store, &calibration);
}

static void read(uint32_t size, unsigned low, unsigned high)
{
    decode(size, low, high);
    load(size, low, high);
}

void main(void)
{
    uint8_t bytes[INVCAL_RECORD_SIZE_V1];
    uint8_t now[INVCAL_RECORD_SIZE];

    static const uint32_t sizes[] = {0, 3, 4, 7, 8, 9, 100, 136, 183, 184, 185, 186};

    for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const uint32_t size = sizes[i];
        read(size, 0, INVCAL_RECORD_SIZE_V1 - 1);
        read(size, INVCAL_RECORD_SIZE_V1, INVCAL_RECORD_SIZE_V1);
        read(size, INVCAL_RECORD_SIZE_V1 + 1, 255);
    }
    ANY(bytes);
    bytes[3] = (uint8_t)BETWEEN(1, 255);
    (void)invcal_record_from_v1(bytes, sizeof bytes, now);
}
