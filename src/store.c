/* SPDX-License-Identifier: MIT */
#include "invcal/store.h"

#include <string.h>

#include "bytes.h"

enum { SLOT_KIND = 0x5C, SLOT_VERSION = 1, SLOT_KIND_VERSION = SLOT_VERSION << 8 | SLOT_KIND };
enum { HEADER = 8, CRC_SIZE = 4, BLANK = 0xFF };
#define CHUNK INVCAL_STORE_GRANULARITY_MAX /* a multiple of every granularity */
#define LARGEST_RECORD UINT32_C(0xFFFF)
#define RESIDUE UINT32_C(0x2144DF1C) /* CRC-32 of anything with its own CRC-32 behind it */

/* What a slot holds; of two, the one with more is loaded. */
typedef enum { UNREADABLE, EMPTY, UNCONFIRMED, CONFIRMED } state;

typedef struct {
    state state;
    uint32_t size;
    uint32_t sequence;
} content;

/* What one call works with. */
typedef struct {
    const invcal_store *store;
    content slot[2];
    uint32_t end; /* of the record looked at or programmed last: there is its confirmation */
    uint8_t chunk[CHUNK];
} desk;

/* Where the CRC ends and the confirmation begins. */
static uint32_t end_of(const invcal_store *store, uint32_t size)
{
    return (size + HEADER + CRC_SIZE + store->granularity - 1) & ~(store->granularity - 1);
}

static int fits(const invcal_store *store, uint32_t size)
{
    return size <= LARGEST_RECORD && end_of(store, size) + store->granularity <= store->slot_size;
}

static int is_usable(const invcal_store *store)
{
    const uint32_t g = store->granularity;

    INVCAL_ASSERT(store->read && store->erase && store->program);
    return g >= 1 && g <= INVCAL_STORE_GRANULARITY_MAX && (g & (g - 1)) == 0 && fits(store, 1);
}

/* Zeros: a driver that reports success and reads too little does no more harm than a bad memory. */
static void open_desk(desk *d, const invcal_store *store)
{
    memset(d, 0, sizeof *d);
    d->store = store;
}

static int read_chunk(desk *d, unsigned slot, uint32_t at, uint32_t count)
{
    return d->store->read(d->store->context, slot, at, d->chunk, count) == 0;
}

static int program_chunk(const desk *d, unsigned slot, uint32_t at, uint32_t count)
{
    return d->store->program(d->store->context, slot, at, d->chunk, count) == 0;
}

/* Any bit will do: programming them began only when the record had been read back. For the same
 * reason a granule that cannot be read says no more than a blank one. */
static state confirmation(desk *d, unsigned slot)
{
    const uint32_t count = d->store->granularity;

    if (read_chunk(d, slot, d->end, count)) {
        for (uint32_t i = 0; i < count; i++) {
            if (d->chunk[i] != BLANK) {
                return CONFIRMED;
            }
        }
    }
    return UNCONFIRMED;
}

static int read_header(const desk *d, content *found)
{
    found->size = invcal_get_u16(d->chunk + 2);
    found->sequence = invcal_get_u32(d->chunk + 4);
    return invcal_get_u16(d->chunk) == SLOT_KIND_VERSION && found->size > 0 &&
           fits(d->store, found->size);
}

/* Reads a slot and judges it. The first bytes of its record, at most capacity, are copied. */
static state look(desk *d, unsigned slot, uint8_t *bytes, uint32_t capacity)
{
    content *found = &d->slot[slot];
    uint32_t crc = 0;
    uint32_t n;

    found->sequence = 0;
    d->end = HEADER;
    /* at most 2050 steps: 8 bytes, then 32 at a time */
    for (uint32_t at = 0; at < d->end; at += n) {
        const uint32_t left = d->end - at;
        n = left < CHUNK ? left : CHUNK;
        if (!read_chunk(d, slot, at, n)) {
            return UNREADABLE;
        }
        crc = invcal_crc32(crc, d->chunk, n);
        if (at == 0) {
            if (!read_header(d, found)) {
                return EMPTY;
            }
            d->end = end_of(d->store, found->size);
            continue;
        }
        for (uint32_t i = 0, to = at - HEADER; i < n && to < capacity; i++, to++) {
            bytes[to] = d->chunk[i];
        }
    }
    return crc == RESIDUE ? confirmation(d, slot) : EMPTY;
}

/* Looks at both slots. Returns the one that is loaded, and so must survive. */
static unsigned survey(desk *d)
{
    const content *a = &d->slot[0];
    const content *b = &d->slot[1];

    for (unsigned slot = 0; slot < 2; slot++) {
        d->slot[slot].state = look(d, slot, NULL, 0);
    }
    if (a->state != b->state) {
        return b->state > a->state;
    }
    const unsigned later = b->sequence - a->sequence < UINT32_C(0x80000000); /* modulo 2^32 */
    return a->state == CONFIRMED ? later : 1 - later;
}

/* Looks again afterwards: there are memories that ignore what they are told. */
static int clear(desk *d, unsigned slot)
{
    return d->store->erase(d->store->context, slot) == 0 && look(d, slot, NULL, 0) == EMPTY;
}

/* Fills chunk after chunk with header, record, padding and CRC, and programs them. */
static int program(desk *d, unsigned slot, uint32_t sequence, const uint8_t *bytes, uint32_t size)
{
    const uint32_t end = end_of(d->store, size);

    invcal_put_u16(d->chunk, SLOT_KIND_VERSION);
    invcal_put_u16(d->chunk + 2, (uint16_t)size);
    invcal_put_u32(d->chunk + 4, sequence);
    uint32_t crc = invcal_crc32(0, d->chunk, HEADER);
    for (uint32_t at = HEADER; at < end; at++) {
        const uint32_t n = at % CHUNK + 1;
        uint8_t *byte = &d->chunk[n - 1];
        if (at < end - CRC_SIZE) {
            *byte = at - HEADER < size ? bytes[at - HEADER] : BLANK;
            crc = invcal_crc32(crc, byte, 1);
        } else {
            *byte = (uint8_t)(crc & 0xFFu);
            crc >>= 8;
        }
        if ((n == CHUNK || at + 1 == end) && !program_chunk(d, slot, at + 1 - n, n)) {
            return 0;
        }
    }
    return 1;
}

static int confirm(desk *d, unsigned slot)
{
    memset(d->chunk, 0, CHUNK);
    return program_chunk(d, slot, d->end, d->store->granularity) &&
           confirmation(d, slot) == CONFIRMED;
}

invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size)
{
    INVCAL_ASSERT(store && bytes);
    desk d;

    open_desk(&d, store);
    if (!is_usable(store) || size == 0) {
        return INVCAL_BAD_SETTING;
    }
    if (!fits(store, size)) {
        return INVCAL_NO_SPACE;
    }
    const unsigned kept = survey(&d);
    const unsigned slot = 1 - kept;
    const int done = d.slot[kept].state != UNREADABLE && clear(&d, slot) &&
                     program(&d, slot, d.slot[kept].sequence + 1, bytes, size) &&
                     look(&d, slot, NULL, 0) > EMPTY && confirm(&d, slot);
    return done ? INVCAL_OK : INVCAL_IO;
}

invcal_status invcal_store_load(const invcal_store *store, uint8_t *bytes, uint32_t capacity,
                                uint32_t *size)
{
    INVCAL_ASSERT(store && bytes && size);
    desk d;

    open_desk(&d, store);
    if (!is_usable(store)) {
        return INVCAL_BAD_SETTING;
    }
    const unsigned slot = survey(&d);
    if (d.slot[slot].state <= EMPTY) {
        return d.slot[1 - slot].state == UNREADABLE ? INVCAL_IO : INVCAL_NO_RECORD;
    }
    const uint32_t found = d.slot[slot].size;
    if (found > capacity) {
        return INVCAL_NO_SPACE;
    }
    if (look(&d, slot, bytes, found) <= EMPTY || d.slot[slot].size != found) {
        return INVCAL_IO;
    }
    *size = found;
    return INVCAL_OK;
}

invcal_status invcal_store_erase(const invcal_store *store)
{
    INVCAL_ASSERT(store);
    desk d;

    open_desk(&d, store);
    if (!is_usable(store)) {
        return INVCAL_BAD_SETTING;
    }
    const unsigned last = survey(&d);
    return clear(&d, 1 - last) && clear(&d, last) ? INVCAL_OK : INVCAL_IO;
}
