/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "core/bytes.h"

// eva: -eva-auto-loop-unroll 10 -eva-slevel-function invcali_crc32:0
// dead: bits_of 2
// dead: -DINVCAL_DOUBLE=1 bits_of 1
// The test for double is decided at compile time.

/* From a buffer of exactly that many bytes. */
static void unseal(uint32_t size)
{
    uint8_t buffer[300];
    uint8_t *bytes = &buffer[sizeof buffer - size];

    ANY(buffer);
    (void)invcali_unseal(bytes, size, INVCAL_RECORD_KIND);
    if (size >= 8) {
        invcali_seal(bytes, INVCAL_RECORD_KIND, BETWEEN(8, size));
    }
}

void main(void)
{
    uint8_t bytes[36];
    invcal_real reals[9];

    //@ loop unroll 12;
    for (uint32_t size = 0; size < 12; size++) {
        unseal(size);
    }
    unseal(300);
    (void)invcali_swap(BETWEEN(0, 255));
    ANY(bytes);
    ANY(reals);
    (void)invcali_get_reals(bytes, reals, 9);
    ANY(reals);
    (void)invcali_put_reals(bytes, reals, 9);
}
