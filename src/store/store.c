/* SPDX-License-Identifier: MIT
 *
 * Two slots, of which one always has sound bytes: the format and the guarantee are in store.h. The
 * state of a slot is read from its bytes alone, by look(), and nothing is remembered between calls:
 * so a power cut, whenever it comes, leaves nothing to repair. Each step of a save is read back
 * before the next.
 */
#include "invcal/store.h"

#include <limits.h>

#include "../core/bytes.h"
#include "../core/vector.h"

enum { SLOT_KIND = 0x5C, SLOT_VERSION = 1, SLOT_KIND_VERSION = SLOT_VERSION << 8 | SLOT_KIND };
enum { HEADER = 8, BLANK = 0xFF };
#define CHUNK INVCAL_STORE_GRANULARITY_MAX /* a multiple of every granularity */

/* Max size of the data: a size has two bytes, and offsets are of type unsigned. */
/* cppcheck-suppress misra-c2012-20.9 ; of limits.h */
#if UINT_MAX > 0xFFFF
#define LARGEST 0xFFFFu
#else
#define LARGEST (UINT_MAX - HEADER - INVCAL_CRC_SIZE - 2 * CHUNK)
#endif

/* The state of a slot; of two, the one with the higher state is loaded. */
typedef enum { UNREADABLE, EMPTY, UNCONFIRMED, CONFIRMED } state;

/* The work space of a call. */
typedef struct {
    const invcal_store *store;
    unsigned slot;     /* the one to read, erase and program */
    unsigned size;     /* of the data read last */
    uint32_t sequence; /* of the same; after survey, of the data to load */
    state kept;        /* of the slot to load, which must survive */
    state other;       /* of the other slot */
    uint8_t *bytes;    /* receives the data, */
    uint32_t capacity; /* up to this size */
    uint8_t chunk[CHUNK];
} work;

static INVCAL_ONCE unsigned granularity_of(const work *w)
{
    return (unsigned)w->store->granularity;
}

/* The end of size bytes, after the CRC; 0 if they do not fit a slot. */
INVCAL_NOINLINE static unsigned end_of(const work *w, uint32_t size)
{
    const unsigned g = granularity_of(w);
    const unsigned end = ((unsigned)size + HEADER + INVCAL_CRC_SIZE + g - 1) & ~(g - 1);

    return size - 1 < LARGEST && end + g <= w->store->slot_size ? end : 0;
}

/* Returns 0, or the driver's failure code. */
INVCAL_NOINLINE static int read_chunk(work *w, unsigned at, unsigned count)
{
    return w->store->read(w->store->context, w->slot, at, w->chunk, count);
}

INVCAL_NOINLINE static int program_chunk(const work *w, unsigned at, unsigned count)
{
    return w->store->program(w->store->context, w->slot, at, w->chunk, count);
}

/* Any bit will do: they are programmed only after everything else was read back. For the same
 * reason an unreadable granule counts as a blank one. */
INVCAL_NOINLINE static state confirmation(work *w, unsigned end)
{
    const unsigned count = granularity_of(w);

    if (read_chunk(w, end, count) == 0) {
        for (unsigned i = 0; i < count; i++) {
            if (w->chunk[i] != BLANK) {
                return CONFIRMED;
            }
        }
    }
    return UNCONFIRMED;
}

/* Copies the chunk that begins with byte `first` of the data. */
static INVCAL_ONCE void copy(const work *w, unsigned first, unsigned count)
{
    const unsigned all = w->size <= w->capacity ? w->size : 0;

    for (unsigned i = 0; i < count; i++) {
        const unsigned to = first + i;
        if (to >= all) {
            return;
        }
        w->bytes[to] = w->chunk[i];
    }
}

/* Reads the slot, copies its data to w->bytes, and returns its state. */
INVCAL_NOINLINE static state look(work *w)
{
    if (read_chunk(w, 0, HEADER) != 0) {
        return UNREADABLE;
    }
    w->size = invcali_get_u16(w->chunk + 2);
    w->sequence = invcali_get_u32(w->chunk + 4);
    const unsigned end = end_of(w, w->size);
    if (invcali_get_u16(w->chunk) != SLOT_KIND_VERSION || end == 0) {
        return EMPTY;
    }
    uint32_t crc = invcali_crc32(0, w->chunk, HEADER);
    for (unsigned at = HEADER; at < end; at += CHUNK) { /* at most 2050 steps */
        const unsigned left = end - at;
        const unsigned n = left < CHUNK ? left : CHUNK;
        if (read_chunk(w, at, n) != 0) {
            return UNREADABLE;
        }
        crc = invcali_crc32(crc, w->chunk, n);
        copy(w, at - HEADER, n);
    }
    return crc == INVCAL_CRC_RESIDUE ? confirmation(w, end) : EMPTY;
}

/* Begins a call: reads both slots, then the one to load. */
INVCAL_NOINLINE static invcal_status survey(work *w, const invcal_store *store)
{
    const uint32_t g = store->granularity;

    INVCAL_ASSERT(store->read && store->erase && store->program);
    /* zeros: a driver that reports success and reads too little does no more harm than a worn
     * memory; and nothing is copied yet */
    invcali_zero(w, sizeof *w);
    w->store = store;
    if (g - 1 >= CHUNK || (g & (g - 1)) != 0 || end_of(w, 1) == 0) {
        return INVCAL_BAD_STORE;
    }
    w->kept = look(w);
    const uint32_t sequence = w->sequence;
    w->slot = 1;
    w->other = look(w);
    /* the later of two confirmed slots, the earlier of two others: see store.h */
    const int is_later = w->sequence - sequence < UINT32_C(0x80000000); /* modulo 2^32 */
    if (w->kept == w->other ? is_later == (w->kept == CONFIRMED) : w->kept < w->other) {
        const state kept = w->other;
        w->other = w->kept;
        w->kept = kept;
    } else {
        w->slot = 0;
        w->sequence = sequence;
    }
    return INVCAL_OK;
}

/* Erases the slot, and reads it back: some memories ignore commands. */
INVCAL_NOINLINE static int clear(work *w)
{
    return w->store->erase(w->store->context, w->slot) == 0 && look(w) == EMPTY;
}

/* Fills chunks with header, bytes, padding and CRC, and programs them. */
static INVCAL_ONCE int program(work *w, const uint8_t *bytes, unsigned size, unsigned end,
                               uint32_t sequence)
{
    (void)invcali_put_u32(invcali_put_two(w->chunk, SLOT_KIND_VERSION, size), sequence);
    uint32_t crc = invcali_crc32(invcali_crc32(0, w->chunk, HEADER), bytes, size);
    unsigned i = HEADER;
    unsigned at = HEADER;
    do { /* at most 2050 steps */
        for (; i < CHUNK && at < end; i++, at++) {
            uint8_t *byte = &w->chunk[i];
            if (at - HEADER < size) {
                *byte = bytes[at - HEADER];
            } else if (at < end - INVCAL_CRC_SIZE) {
                *byte = BLANK;
                crc = invcali_crc32(crc, byte, 1);
            } else {
                *byte = (uint8_t)(crc & 0xFFu);
                crc >>= 8;
            }
        }
        if (program_chunk(w, at - i, i) != 0) {
            return 0;
        }
        i = 0;
    } while (at < end);
    return 1;
}

/* The data were read back before: now only the confirmation is. */
static INVCAL_ONCE int confirm(work *w, unsigned end)
{
    invcali_zero(w->chunk, CHUNK);
    return program_chunk(w, end, granularity_of(w)) == 0 && confirmation(w, end) == CONFIRMED;
}

invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size)
{
    work w;

    INVCAL_ASSERT(store && bytes);
    const invcal_status status = survey(&w, store);
    if (status != INVCAL_OK) {
        return status;
    }
    const unsigned end = end_of(&w, size);
    if (end == 0) {
        return size > 0 ? INVCAL_NO_SPACE : INVCAL_BAD_COUNT;
    }
    const uint32_t next = w.sequence + 1;
    w.slot = 1 - w.slot;
    const int done = w.kept != UNREADABLE && clear(&w) &&
                     program(&w, bytes, (unsigned)size, end, next) && look(&w) > EMPTY &&
                     confirm(&w, end);
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
    if (w.kept <= EMPTY) {
        return w.other == UNREADABLE ? INVCAL_IO : INVCAL_NO_RECORD;
    }
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

/* The slot to load goes last: until then a load must not find the older one instead. */
invcal_status invcal_store_erase(const invcal_store *store)
{
    work w;

    INVCAL_ASSERT(store);
    const invcal_status status = survey(&w, store);
    if (status != INVCAL_OK) {
        return status;
    }
    w.slot = 1 - w.slot;
    int done = clear(&w);
    w.slot = 1 - w.slot;
    done = done && clear(&w);
    return done ? INVCAL_OK : INVCAL_IO;
}
