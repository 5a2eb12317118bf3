/* SPDX-License-Identifier: MIT
 *
 * Records of any bytes, decoded and loaded: for the proofs of functions that read them.
 */
#ifndef ANY_RECORD_H
#define ANY_RECORD_H

#include "arbitrary.h"
#include "invcal/store.h"

typedef invcal_status record_decoder(const uint8_t *bytes, uint32_t size, invcal_record *out);
typedef invcal_status record_loader(const invcal_store *store, invcal_calibration *calibration);

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

/* ---- the readers ------------------------------------------------------------------------------ */

/* A buffer of exactly that many bytes, which state a length from low to high. */
static void read(record_decoder *decode, record_loader *load, uint32_t size, unsigned low,
                 unsigned high)
{
    uint8_t buffer[INVCAL_RECORD_SIZE_V1 + 2];
    uint8_t *bytes = &buffer[sizeof buffer - size];
    invcal_record record;
    invcal_store store;
    invcal_calibration calibration;

    ANY(buffer);
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(low, high);
        bytes[3] = 0;
    }
    (void)decode(bytes, size, &record);

    ANY(store);
    loaded[0] = size;
    loaded[1] = low;
    loaded[2] = high;
    (void)load(&store, &calibration);
}

/* Sizes near `right`, which fits a byte, and lengths of two bytes. */
static void read_all(record_decoder *decode, record_loader *load, uint32_t right)
{
    const uint32_t sizes[] = {0, 3, 4, 7, 8, 9, 100, right - 1, right, right + 1, right + 2};
    uint8_t bytes[INVCAL_RECORD_SIZE_V1];
    invcal_record record;

    for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        read(decode, load, sizes[i], 0, right - 1);
        read(decode, load, sizes[i], right, right);
        read(decode, load, sizes[i], right + 1, 255);
    }
    ANY(bytes);
    bytes[3] = (uint8_t)BETWEEN(1, 255);
    (void)decode(bytes, right, &record);
}

#endif
