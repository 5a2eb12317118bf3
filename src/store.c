/* SPDX-License-Identifier: MIT */
#include "invcal/store.h"

#include <string.h>

#include "bytes.h"

enum { SLOT_KIND = 0x5C, SLOT_VERSION = 1, SLOT_KIND_VERSION = SLOT_VERSION << 8 | SLOT_KIND };
enum { HEADER = 8, BLANK = 0xFF };
#define CHUNK INVCAL_STORE_GRANULARITY_MAX /* a multiple of every granularity */
#define LARGEST UINT32_C(0xFFFF)           /* size of what is stored */

/* What a slot holds; of two, the one with more is loaded. */
typedef enum { UNREADABLE, EMPTY, UNCONFIRMED, CONFIRMED } state;

/* What one call works with. */
typedef struct {
    const invcal_store *store;
    unsigned slot; /* the one that is looked at, erased and programmed */
    unsigned kept; /* the one that is loaded, and so must survive */
    state state[2];
    uint32_t sequence[2];
    uint32_t size;     /* of what was looked at last */
    uint32_t end;      /* of the same: there is its confirmation */
    uint8_t *bytes;    /* for what is looked at, */
    uint32_t capacity; /* if it is no more than this */
    uint8_t chunk[CHUNK];
} work;

/* Finds the end of so much: behind the CRC. Returns whether a slot holds it. */
static int find_end(work *w, uint32_t size)
{
    const uint32_t g = w->store->granularity;

    w->end = (size + HEADER + INVCAL_CRC_SIZE + g - 1) & ~(g - 1);
    return size - 1 < LARGEST && w->end + g <= w->store->slot_size;
}

static int read_chunk(work *w, uint32_t at, uint32_t count)
{
    return w->store->read(w->store->context, w->slot, at, w->chunk, count) == 0;
}

static int program_chunk(const work *w, uint32_t at, uint32_t count)
{
    return w->store->program(w->store->context, w->slot, at, w->chunk, count) == 0;
}

static int read_header(work *w)
{
    w->size = invcal_get_u16(w->chunk + 2);
    w->sequence[w->slot] = invcal_get_u32(w->chunk + 4);
    return invcal_get_u16(w->chunk) == SLOT_KIND_VERSION && find_end(w, w->size);
}

/* Any bit will do: programming them began only when all else had been read back. For the same
 * reason a granule that cannot be read says no more than a blank one. */
static state confirmation(work *w)
{
    const uint32_t count = w->store->granularity;

    if (read_chunk(w, w->end, count)) {
        for (uint32_t i = 0; i < count; i++) {
            if (w->chunk[i] != BLANK) {
                return CONFIRMED;
            }
        }
    }
    return UNCONFIRMED;
}

/* Reads the slot, copies what it holds to w->bytes, and judges it. */
static state look(work *w)
{
    if (!read_chunk(w, 0, HEADER)) {
        return UNREADABLE;
    }
    if (!read_header(w)) {
        return EMPTY;
    }
    const uint32_t copied = w->size <= w->capacity ? w->size : 0;
    uint32_t crc = invcal_crc32(0, w->chunk, HEADER);
    for (uint32_t at = HEADER; at < w->end; at += CHUNK) { /* at most 2049 steps */
        const uint32_t left = w->end - at;
        const uint32_t n = left < CHUNK ? left : CHUNK;
        if (!read_chunk(w, at, n)) {
            return UNREADABLE;
        }
        crc = invcal_crc32(crc, w->chunk, n);
        /* cppcheck-suppress knownConditionTrueFalse ; read_header has set w->end */
        for (uint32_t i = 0, to = at - HEADER; i < n && to < copied; i++, to++) {
            w->bytes[to] = w->chunk[i];
        }
    }
    return crc == INVCAL_CRC_RESIDUE ? confirmation(w) : EMPTY;
}

/* Begins a call: looks at both slots. */
static invcal_status survey(work *w, const invcal_store *store)
{
    const uint32_t g = store->granularity;

    INVCAL_ASSERT(store->read && store->erase && store->program);
    /* zeros: a driver that reports success and reads too little does no more harm than a worn
     * memory */
    memset(w, 0, sizeof *w);
    w->store = store;
    w->bytes = w->chunk; /* of capacity 0: nothing is copied */
    if (g - 1 >= CHUNK || (g & (g - 1)) != 0 || !find_end(w, 1)) {
        return INVCAL_BAD_STORE;
    }
    w->state[0] = look(w);
    w->slot = 1;
    w->state[1] = look(w);
    /* modulo 2^32 */
    const int is_later = w->sequence[1] - w->sequence[0] < UINT32_C(0x80000000);
    w->kept = w->state[0] == w->state[1] ? is_later == (w->state[0] == CONFIRMED)
                                         : w->state[0] < w->state[1];
    return INVCAL_OK;
}

/* Looks again afterwards: there are memories that ignore what they are told. */
static int clear(work *w)
{
    return w->store->erase(w->store->context, w->slot) == 0 && look(w) == EMPTY;
}

/* Fills chunk after chunk with header, bytes, padding and CRC, and programs them. */
static int program(work *w, const uint8_t *bytes, uint32_t size)
{
    (void)find_end(w, size);
    (void)invcal_put_u32(invcal_put_two(w->chunk, SLOT_KIND_VERSION, size),
                         w->sequence[w->kept] + 1);
    uint32_t crc = invcal_crc32(0, w->chunk, HEADER);
    for (uint32_t at = HEADER; at < w->end; at++) {
        const uint32_t i = at % CHUNK;
        if (at < w->end - INVCAL_CRC_SIZE) {
            w->chunk[i] = at - HEADER < size ? bytes[at - HEADER] : BLANK;
            crc = invcal_crc32(crc, &w->chunk[i], 1);
        } else {
            w->chunk[i] = (uint8_t)(crc & 0xFFu);
            crc >>= 8;
        }
        if ((i == CHUNK - 1 || at == w->end - 1) && !program_chunk(w, at - i, i + 1)) {
            return 0;
        }
    }
    return 1;
}

static int confirm(work *w)
{
    memset(w->chunk, 0, CHUNK);
    return program_chunk(w, w->end, w->store->granularity) && look(w) == CONFIRMED;
}

invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size)
{
    work w;

    INVCAL_ASSERT(store && bytes);
    const invcal_status status = survey(&w, store);
    if (status != INVCAL_OK) {
        return status;
    }
    if (!find_end(&w, size)) {
        return size > 0 ? INVCAL_NO_SPACE : INVCAL_BAD_COUNT;
    }
    w.slot = 1 - w.kept;
    const int done = w.state[w.kept] != UNREADABLE && clear(&w) && program(&w, bytes, size) &&
                     look(&w) > EMPTY && confirm(&w);
    return done ? INVCAL_OK : INVCAL_IO;
}

invcal_status invcal_store_load(const invcal_store *store, uint8_t *bytes, uint32_t capacity,
                                uint32_t *size)
{
    work w;

    INVCAL_ASSERT(store && bytes && size);
    const invcal_status status = survey(&w, store);
    if (status != INVCAL_OK) {
        return status;
    }
    if (w.state[w.kept] <= EMPTY) {
        return w.state[1 - w.kept] == UNREADABLE ? INVCAL_IO : INVCAL_NO_RECORD;
    }
    w.slot = w.kept;
    w.bytes = bytes;
    w.capacity = capacity;
    if (look(&w) <= EMPTY) {
        return INVCAL_IO;
    }
    if (w.size > capacity) {
        return INVCAL_NO_SPACE;
    }
    *size = w.size;
    return INVCAL_OK;
}

invcal_status invcal_store_erase(const invcal_store *store)
{
    work w;

    INVCAL_ASSERT(store);
    const invcal_status status = survey(&w, store);
    if (status != INVCAL_OK) {
        return status;
    }
    w.slot = 1 - w.kept;
    int done = clear(&w);
    w.slot = w.kept;
    done = done && clear(&w);
    return done ? INVCAL_OK : INVCAL_IO;
}
