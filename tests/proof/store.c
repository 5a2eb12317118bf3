/* SPDX-License-Identifier: MIT */
#include <limits.h>
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/store.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 8 -eva-slevel 0 -eva-slevel-function main:100

/* A driver that answers anything, and a memory that reads as anything, each time anew; or as
 * nothing, whatever the answer. */
static int read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    (void)slot;
    (void)offset;
    if (Frama_C_int_interval(0, 1)) {
        Frama_C_make_unknown((char *)bytes, size);
    }
    return Frama_C_int_interval(-1, 1);
}

static int erase(void *context, unsigned slot)
{
    (void)context;
    (void)slot;
    return Frama_C_int_interval(-1, 1);
}

static uint8_t sink;

static int program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                   uint32_t size)
{
    (void)context;
    (void)slot;
    (void)offset;
    for (uint32_t i = 0; i < size; i++) {
        sink ^= bytes[i];
    }
    return Frama_C_int_interval(-1, 1);
}

/* One more than a record may have; with an int of 16 bits, all that there may be. */
#define LARGEST (UINT_MAX > 0xFFFF ? 0x10000 : 0x7FFE)

static uint8_t memory[LARGEST + 1];

/* With a buffer of exactly so many bytes. */
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
    invcal_store_save(store, memory, 0x10000); /* refused unseen */
    invcal_store_erase(store);
}

void main(void)
{
    invcal_store store = {read, erase, program, NULL, 0, 0};

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
