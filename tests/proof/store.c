/* SPDX-License-Identifier: MIT */
#include <limits.h>
#include <stddef.h>

#include "driver.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 8 -eva-slevel 0 -eva-slevel-function main:100

/* One more than a record may have; with an int of 16 bits, as many as there can be. */
#define LARGEST (UINT_MAX > 0xFFFF ? 0x10000 : 0x7FFE)

static uint8_t memory[LARGEST + 1];

/* With a buffer of exactly that many bytes. */
static void use(const invcal_store *store, uint32_t size)
{
    uint8_t *bytes = &memory[sizeof memory - size];
    uint32_t found;

    invcal_store_save(store, bytes, size);
    invcal_store_load(store, bytes, size, &found);
}

/* With any size of the slots; too small or odd ones are refused. */
static void use_all(invcal_store *store)
{
    static const uint32_t size[] = {0, 1, 33, LARGEST - 1, LARGEST};

    ANY(store->slot_size);
    for (unsigned i = 0; i < sizeof size / sizeof *size; i++) {
        use(store, size[i]);
    }
    invcal_store_save(store, memory, 0x10000); /* refused by its size */
    invcal_store_erase(store);
}

void main(void)
{
    invcal_store store = {any_read, any_erase, any_program, NULL, 0, 0};

    ANY(memory);
    for (store.granularity = 1; store.granularity <= INVCAL_STORE_GRANULARITY_MAX + 1;
         store.granularity++) {
        use_all(&store);
    }
    store.granularity = 0;
    use_all(&store);
    store.granularity = BETWEEN(INVCAL_STORE_GRANULARITY_MAX + 2, 0xFFFFFFFF);
    use_all(&store);
}
