/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/record.h"

// eva: -eva-slevel-function invcal_crc32:0

// dead: invcal_record_encode 1 no finite float is beyond the largest float
// dead: -DINVCAL_DOUBLE=1 invcal_record_encode 0

/* From a buffer of exactly so many bytes, that state a length from low to high. */
static void decode(uint32_t size, unsigned low, unsigned high)
{
    uint8_t buffer[INVCAL_RECORD_SIZE + 2];
    uint8_t *bytes = &buffer[sizeof buffer - size];
    invcal_record record;

    ANY(buffer);
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(low, high);
        bytes[3] = 0;
    }
    invcal_record_decode(bytes, size, &record);
}

void main(void)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record;

    //@ loop unroll INVCAL_RECORD_SIZE + 3;
    for (uint32_t size = 0; size <= INVCAL_RECORD_SIZE + 2; size++) {
        decode(size, 0, INVCAL_RECORD_SIZE - 1);
        decode(size, INVCAL_RECORD_SIZE, INVCAL_RECORD_SIZE);
        decode(size, INVCAL_RECORD_SIZE + 1, 255);
    }
    ANY(bytes);
    bytes[3] = (uint8_t)BETWEEN(1, 255);
    invcal_record_decode(bytes, sizeof bytes, &record);
    ANY(record);
    invcal_record_encode(&record, bytes);
}
