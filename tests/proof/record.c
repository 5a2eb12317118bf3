/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/store.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 40 -eva-slevel 20 -eva-slevel-function read_all:400,invcali_crc32:0 -eva-split-return full
// stubs: store

/* ---- the store: any failure, or a number of bytes --------------------------------------------- */

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

invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size)
{
    (void)store->slot_size;
    (void)bytes[size - 1];
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_IO);
}

/* ---- the writers ------------------------------------------------------------------------------ */

static void save(void)
{
    invcal_store store;
    invcal_calibration calibration;
    invcal_quality quality;
    invcal_record record;

    ANY(store);
    ANY(calibration);
    ANY(quality);
    (void)invcal_save(&calibration, &quality, &store);
    invcal_record_init(&record, &calibration, &quality);
}

static void encode(void)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record;

    ANY(record);
    (void)invcal_record_encode(&record, bytes);
}

/* ---- the readers ------------------------------------------------------------------------------ */

/* A buffer of exactly that many bytes, which state a length from low to high. */
static void read(uint32_t size, unsigned low, unsigned high)
{
    uint8_t buffer[INVCAL_RECORD_SIZE + 2];
    uint8_t *bytes = &buffer[sizeof buffer - size];
    invcal_record record;
    invcal_store store;
    invcal_calibration calibration;

    ANY(buffer);
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(low, high);
        bytes[3] = 0;
    }
    (void)invcal_record_decode(bytes, size, &record);

    ANY(store);
    loaded[0] = size;
    loaded[1] = low;
    loaded[2] = high;
    (void)invcal_load(&calibration, &store);
}

/* Sizes near the right one, which fits a byte, and lengths of two bytes. */
static void read_all(void)
{
    enum { RIGHT = INVCAL_RECORD_SIZE };
    static const uint32_t sizes[] = {0, 3, 4, 7, 8, 9, 100, RIGHT - 1, RIGHT, RIGHT + 1, RIGHT + 2};
    uint8_t bytes[RIGHT];
    invcal_record record;

    for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        read(sizes[i], 0, RIGHT - 1);
        read(sizes[i], RIGHT, RIGHT);
        read(sizes[i], RIGHT + 1, 255);
    }
    ANY(bytes);
    bytes[3] = (uint8_t)BETWEEN(1, 255);
    (void)invcal_record_decode(bytes, RIGHT, &record);
}

void main(void)
{
    save();
    encode();
    read_all();
}
