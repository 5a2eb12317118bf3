/* SPDX-License-Identifier: MIT */
#include "any_record.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 40 -eva-slevel 20 -eva-slevel-function read_all:400,invcal_crc32:0 -eva-split-return full
// stubs: store

invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size)
{
    (void)store->slot_size;
    (void)bytes[size - 1];
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_IO);
}

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

void main(void)
{
    save();
    encode();
    read_all(invcal_record_decode, invcal_load, INVCAL_RECORD_SIZE);
}
