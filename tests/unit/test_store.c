/* SPDX-License-Identifier: MIT
 *
 * The store on a simulated NOR flash that enforces its rules, loses power at any byte of any
 * operation, and has cells that are worn, torn or dead.
 */
#include <string.h>

#include "invcal/store.h"
#include "support.h"
#include "unity.h"

#include "core/bytes.h"

/* ---- the memory ------------------------------------------------------------------------------- */

enum { SLOT = 512, MARGIN = 16 };
#define NEVER 1000000L

/* The result of an interrupted erasure: bytes from the start, from the end, any, or any bits. */
enum { FROM_START, FROM_END, ANY_BYTES, ANY_BITS, TEARS };

typedef struct {
    uint8_t bytes[2][SLOT];
    uint8_t used[2][SLOT]; /* programmed since it was erased */
    uint8_t torn[2][SLOT]; /* bits that read differently each time: half programmed */
    uint8_t high[2][SLOT]; /* worn cells that stay 1, */
    uint8_t low[2][SLOT];  /* and 0 */
    invcal_store store;    /* the driver of this memory */
    random_source random;
    long power; /* bytes that are still erased or programmed before power fails */
    int tear;
    int unsteady;                         /* torn bits keep changing */
    int dead;                             /* no power */
    int reads, erases, programs;          /* calls so far */
    int bad_read, bad_erase, bad_program; /* the call that fails; 0: none */
    int deaf_erase, deaf_program;         /* they do nothing, and report success */
    int lying_read;                       /* the call that reads one bit wrong */
    int unreadable[2];
    int rules_broken;
} memory;

static memory flash; /* of the running test */

static uint8_t any_bits(void)
{
    return (uint8_t)random_uniform(&flash.random, 0, 256);
}

static int is_within(unsigned slot, uint32_t offset, uint32_t size)
{
    return slot < 2 && size > 0 && size <= 32 && offset <= flash.store.slot_size &&
           size <= flash.store.slot_size - offset;
}

static int flash_read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    flash.rules_broken += context != &flash || !is_within(slot, offset, size);
    flash.reads++;
    if (flash.rules_broken || flash.dead || flash.unreadable[slot] ||
        flash.reads == flash.bad_read) {
        memset(bytes, 0xA5, size); /* a driver may leave anything */
        return 7;
    }
    for (uint32_t i = 0; i < size; i++) {
        const uint32_t at = offset + i;
        bytes[i] = (uint8_t)((flash.bytes[slot][at] | flash.high[slot][at]) &
                             ~(unsigned)flash.low[slot][at]);
        if (flash.unsteady) {
            bytes[i] = (uint8_t)(bytes[i] ^ (flash.torn[slot][at] & any_bits()));
        }
    }
    if (flash.reads == flash.lying_read) {
        bytes[any_bits() % size] ^= (uint8_t)(1u << any_bits() % 8);
    }
    return 0;
}

/* Power fails in an erasure when `done` bytes of all are erased. */
static void tear_erasure(unsigned slot, uint32_t done)
{
    const uint32_t all = flash.store.slot_size;

    for (uint32_t i = 0; i < all; i++) {
        uint8_t *byte = &flash.bytes[slot][i];
        const int hit = random_uniform(&flash.random, 0, all) < done;
        if (flash.tear == FROM_START ? i < done : flash.tear == FROM_END ? all - i <= done : hit) {
            *byte = (uint8_t)(*byte | (flash.tear == ANY_BITS ? any_bits() : 0xFFu));
        }
    }
}

static int flash_erase(void *context, unsigned slot)
{
    const int all = (int)flash.store.slot_size;

    flash.rules_broken += context != &flash || slot > 1;
    flash.erases++;
    if (flash.rules_broken || flash.dead || flash.erases == flash.bad_erase) {
        return -1;
    }
    if (flash.deaf_erase) {
        return 0;
    }
    if (flash.power < all) {
        tear_erasure(slot, (uint32_t)flash.power);
        flash.dead = 1;
        return -1;
    }
    flash.power -= all;
    memset(flash.bytes[slot], 0xFF, flash.store.slot_size);
    memset(flash.used[slot], 0, SLOT);
    memset(flash.torn[slot], 0, SLOT);
    flash.unreadable[slot] = 0; /* error correction accepts a blank slot */
    return 0;
}

static int flash_program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                         uint32_t size)
{
    const uint32_t g = flash.store.granularity;

    flash.rules_broken +=
        context != &flash || !is_within(slot, offset, size) || offset % g != 0 || size % g != 0;
    flash.programs++;
    if (flash.rules_broken || flash.dead || flash.programs == flash.bad_program) {
        return 1;
    }
    for (uint32_t i = 0; i < size && !flash.deaf_program; i++) {
        uint8_t *byte = &flash.bytes[slot][offset + i];
        const uint8_t cleared = (uint8_t)(*byte & ~(unsigned)bytes[i]);
        flash.rules_broken += flash.used[slot][offset + i];
        flash.used[slot][offset + i] = 1;
        if (flash.power-- == 0) {
            *byte = (uint8_t)(*byte & ~(unsigned)(cleared & any_bits()));
            flash.torn[slot][offset + i] = cleared;
            flash.dead = 1;
            return 1;
        }
        *byte = (uint8_t)(*byte & bytes[i]);
    }
    return 0;
}

/* A blank memory, with the slots as large as SLOT allows. */
static void new_flash(uint32_t granularity)
{
    memset(&flash, 0, sizeof flash);
    memset(flash.bytes, 0xFF, sizeof flash.bytes);
    flash.store.read = flash_read;
    flash.store.erase = flash_erase;
    flash.store.program = flash_program;
    flash.store.context = &flash;
    flash.store.slot_size = SLOT;
    flash.store.granularity = granularity;
    flash.random = random_start(granularity);
    flash.power = NEVER;
}

static void power_up(void)
{
    flash.dead = 0;
    flash.power = NEVER;
}

void setUp(void)
{
    new_flash(8);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, flash.rules_broken, "a rule of the memory was broken");
}

/* ---- records ---------------------------------------------------------------------------------- */

enum { RECORD_MAX = 300 };
enum { BLANK_BUFFER = 0xEE };

static const uint32_t granularities[] = {1, 4, 8, 32};
static const uint32_t sizes[] = {1, 3, 4, 12, 19, 20, 21, 51, 52, 53, 84, 184};
enum { GRANULARITIES = 4, SIZES = 12 };

/* The bytes of record number n, which contain the number: no two are alike. Some look like erased
 * flash at their end, and the first byte shows the number. */
static const uint8_t *record(unsigned n, uint32_t size)
{
    static uint8_t bytes[RECORD_MAX];
    random_source random = random_start(1000 * n + size);

    TEST_ASSERT_TRUE(size <= RECORD_MAX);
    for (uint32_t i = 0; i < size; i++) {
        bytes[i] = (uint8_t)random_uniform(&random, 0, 256);
    }
    if (n % 2 && size > 8) {
        memset(bytes + size - 6, 0xFF, 6);
    }
    bytes[0] = (uint8_t)n;
    return bytes;
}

static void save(unsigned n, uint32_t size)
{
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_save(&flash.store, record(n, size), size));
}

typedef struct {
    invcal_status status;
    uint32_t size;
    uint8_t bytes[RECORD_MAX + MARGIN];
} loaded;

static loaded load(uint32_t capacity)
{
    loaded it;

    memset(it.bytes, BLANK_BUFFER, sizeof it.bytes);
    it.size = 0xABCDEF;
    it.status = invcal_store_load(&flash.store, it.bytes, capacity, &it.size);
    return it;
}

static int is_untouched(const loaded *it, uint32_t from)
{
    for (uint32_t i = from; i < sizeof it->bytes; i++) {
        if (it->bytes[i] != BLANK_BUFFER) {
            return 0;
        }
    }
    return from > 0 || it->size == 0xABCDEF;
}

static int is_record(const loaded *it, unsigned n, uint32_t size)
{
    return it->status == INVCAL_OK && it->size == size && is_untouched(it, size) &&
           memcmp(it->bytes, record(n, size), size) == 0;
}

static void assert_loads(unsigned n, uint32_t size)
{
    const loaded it = load(RECORD_MAX);

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, it.status);
    TEST_ASSERT_TRUE(is_record(&it, n, size));
}

static void assert_refuses(invcal_status expected)
{
    const loaded it = load(RECORD_MAX);

    TEST_ASSERT_EQUAL_INT(expected, it.status);
    TEST_ASSERT_TRUE(is_untouched(&it, 0));
}

static void assert_save(invcal_status expected, unsigned n, uint32_t size)
{
    TEST_ASSERT_EQUAL_INT(expected, invcal_store_save(&flash.store, record(n, size), size));
}

/* ---- the format, written out from the table in store.h ---------------------------------------- */

static uint32_t slow_crc(const uint8_t *bytes, uint32_t count) /* by polynomial division */
{
    uint32_t rest = 0xFFFFFFFFu;

    for (uint32_t i = 0; i < 8 * count; i++) {
        const uint32_t bit = (uint32_t)bytes[i / 8] >> i % 8 & 1u;
        const uint32_t out = rest >> 31 ^ bit;
        rest = rest << 1 ^ (out ? 0x04C11DB7u : 0);
    }
    uint32_t reflected = 0;
    for (unsigned i = 0; i < 32; i++) {
        reflected |= (rest >> i & 1u) << (31 - i);
    }
    return ~reflected;
}

static void put_crc(uint8_t *at, uint32_t crc)
{
    for (unsigned i = 0; i < 4; i++) {
        at[i] = (uint8_t)(crc >> 8 * i);
    }
}

/* Writes the slot of a record. Returns where its confirmation begins. */
static uint32_t write_slot(unsigned slot, uint32_t sequence, unsigned n, uint32_t size,
                           int confirmed)
{
    const uint32_t g = flash.store.granularity;
    uint8_t *b = flash.bytes[slot];
    uint32_t end = 0;

    while (end < 8 + size + 4) {
        end += g;
    }
    memset(b, 0xFF, SLOT);
    b[0] = 0x5C;
    b[1] = 1;
    b[2] = (uint8_t)(size & 0xFF);
    b[3] = (uint8_t)(size >> 8);
    put_crc(b + 4, sequence);
    memcpy(b + 8, record(n, size), size);
    put_crc(b + end - 4, slow_crc(b, end - 4));
    memset(b + end, confirmed ? 0 : 0xFF, g);
    return end;
}

/* The slot that holds record n, or 2. */
static unsigned slot_of(unsigned n)
{
    for (unsigned slot = 0; slot < 2; slot++) {
        if (flash.bytes[slot][0] == 0x5C && flash.bytes[slot][8] == n) {
            return slot;
        }
    }
    return 2;
}

static void the_crc_has_the_check_value_of_the_standard(void)
{
    static const uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};

    TEST_ASSERT_EQUAL_HEX32(0xCBF43926u, invcali_crc32(0, digits, 9));
    TEST_ASSERT_EQUAL_HEX32(0xCBF43926u, slow_crc(digits, 9));
    TEST_ASSERT_EQUAL_HEX32(0xCBF43926u, invcali_crc32(invcali_crc32(0, digits, 4), digits + 4, 5));
    TEST_ASSERT_EQUAL_HEX32(0, invcali_crc32(0, digits, 0));
}

static void numbers_have_their_least_byte_first(void)
{
    static const uint8_t expected[] = {0x81, 0x02, 0x03, 0xF4, 0x02, 0x81, 0xFE, 0x00};
    uint8_t b[8];

    TEST_ASSERT_TRUE(invcali_put_u32(b, 0xF4030281u) == b + 4);
    TEST_ASSERT_TRUE(invcali_put_two(b + 4, 0x8102u, 0x00FEu) == b + 8);
    TEST_ASSERT_EQUAL_HEX8_ARRAY(expected, b, 8);
    TEST_ASSERT_EQUAL_HEX32(0xF4030281u, invcali_get_u32(b));
    TEST_ASSERT_EQUAL_HEX16(0x8102u, invcali_get_u16(b + 4));
}

static void reals_are_binary32(void)
{
    static const invcal_real x[] = {INVCAL_REAL(-6.5), INVCAL_REAL(1.0), 0}; /* 0xC0D00000 ... */
    static const uint8_t expected[] = {0, 0, 0xD0, 0xC0, 0, 0, 0x80, 0x3F, 0, 0, 0, 0};
    uint8_t b[12];
    invcal_real y[3];

    TEST_ASSERT_TRUE(invcali_put_reals(b, x, 3) == b + 12);
    TEST_ASSERT_EQUAL_HEX8_ARRAY(expected, b, 12);
    TEST_ASSERT_EQUAL_INT(1, invcali_get_reals(b, y, 3));
    TEST_ASSERT_EQUAL_MEMORY(x, y, sizeof x);
    for (uint8_t sign = 0; sign < 2; sign++) {
        b[4] = sign; /* not a number, and infinite */
        b[6] = 0x80;
        b[7] = (uint8_t)(sign ? 0xFF : 0x7F);
        TEST_ASSERT_EQUAL_INT(0, invcali_get_reals(b, y, 3));
        TEST_ASSERT_EQUAL_INT(1, invcali_get_reals(b, y, 1));
    }
}

static void a_slot_holds_the_bytes_of_the_table(void)
{
    for (unsigned g = 0; g < GRANULARITIES; g++) {
        for (unsigned s = 0; s < SIZES; s++) {
            uint8_t first[SLOT];
            uint8_t second[SLOT];
            new_flash(granularities[g]);
            save(1, sizes[s]);
            save(2, sizes[s]);
            const unsigned slot = slot_of(2);
            TEST_ASSERT_TRUE(slot < 2 && slot_of(1) == 1 - slot);
            const uint32_t sequence = invcali_get_u32(flash.bytes[1 - slot] + 4);
            memcpy(first, flash.bytes[1 - slot], SLOT);
            memcpy(second, flash.bytes[slot], SLOT);
            const uint32_t end = write_slot(1 - slot, sequence, 1, sizes[s], 1);
            write_slot(slot, sequence + 1, 2, sizes[s], 1);
            TEST_ASSERT_EQUAL_MEMORY(flash.bytes[1 - slot], first, SLOT);
            TEST_ASSERT_EQUAL_MEMORY(flash.bytes[slot], second, SLOT);
            TEST_ASSERT_EQUAL_UINT32(end + granularities[g],
                                     INVCAL_STORE_BYTES(sizes[s], granularities[g]));
        }
    }
}

/* ---- saving and loading ----------------------------------------------------------------------- */

static void what_was_saved_is_loaded_at_any_size_and_granularity(void)
{
    for (uint32_t g = 1; g <= 32; g *= 2) {
        new_flash(g);
        for (uint32_t size = 1; size <= 200; size++) {
            save(size, size);
            assert_loads(size, size);
        }
    }
}

static void the_last_of_many_saves_is_loaded_also_when_the_sequence_wraps(void)
{
    static const uint32_t start[] = {0, 0x7FFFFFFDu, 0xFFFFFFFDu};

    for (unsigned s = 0; s < 3; s++) {
        for (unsigned slot = 0; slot < 2; slot++) {
            new_flash(4);
            write_slot(slot, start[s], 100, 20, 1);
            for (unsigned n = 0; n < 8; n++) {
                save(n, 10 + 7 * n);
                assert_loads(n, 10 + 7 * n);
                if (n > 0) {
                    TEST_ASSERT_TRUE(slot_of(n - 1) < 2); /* still there */
                }
            }
        }
    }
}

static void of_two_confirmed_records_the_later_is_loaded(void)
{
    static const uint32_t sequence[] = {0, 1, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFEu, 0xFFFFFFFFu};

    for (unsigned i = 0; i < 6; i++) {
        for (unsigned later = 0; later < 2; later++) {
            write_slot(later, sequence[i] + 1, 7, 30, 1);
            write_slot(1 - later, sequence[i], 6, 31, 1);
            assert_loads(7, 30);
        }
    }
}

static void a_confirmed_record_is_loaded_before_one_that_is_not(void)
{
    for (unsigned slot = 0; slot < 2; slot++) {
        for (uint32_t sequence = 0; sequence < 3; sequence++) {
            write_slot(slot, 1, 7, 30, 1);
            write_slot(1 - slot, sequence, 6, 31, 0);
            assert_loads(7, 30);
        }
    }
}

static void a_record_without_confirmation_is_loaded_if_there_is_no_other(void)
{
    for (unsigned slot = 0; slot < 2; slot++) {
        new_flash(8);
        write_slot(slot, 5, 6, 31, 0);
        assert_loads(6, 31);
        write_slot(1 - slot, 6, 7, 31, 0);
        assert_loads(6, 31); /* the earlier: see store.h */
    }
}

static void one_bit_of_the_confirmation_is_enough(void)
{
    for (uint32_t bit = 0; bit < 64; bit++) {
        write_slot(0, 1, 6, 31, 1);
        const uint32_t end = write_slot(1, 2, 7, 31, 0);
        assert_loads(6, 31);
        flash.bytes[1][end + bit / 8] = (uint8_t)(0xFFu ^ 1u << bit % 8);
        assert_loads(7, 31);
    }
}

static void a_record_may_fill_its_slot(void)
{
    for (unsigned g = 0; g < GRANULARITIES; g++) {
        new_flash(granularities[g]);
        flash.store.slot_size = 6 * granularities[g] + 20;
        flash.store.slot_size -= flash.store.slot_size % granularities[g];
        uint32_t size = 1;
        while (INVCAL_STORE_BYTES(size + 1, granularities[g]) <= flash.store.slot_size) {
            size++;
        }
        TEST_ASSERT_EQUAL_UINT32(flash.store.slot_size, INVCAL_STORE_BYTES(size, granularities[g]));
        save(1, 1);
        save(2, size);
        assert_loads(2, size);
        const int erases = flash.erases;
        assert_save(INVCAL_NO_SPACE, 3, size + 1);
        assert_save(INVCAL_NO_SPACE, 3, size + 32);
        TEST_ASSERT_EQUAL_INT(erases, flash.erases);
        assert_loads(2, size);
    }
}

static void a_size_that_cannot_be_stored_is_refused(void)
{
    static const uint32_t much[] = {0x10000u,    0x10001u,    0x10014u,
                                    0x7FFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFF0u};

    save(1, 20);
    flash.store.slot_size = 0xFFFFFFFFu; /* so that only the size is wrong */
    const int calls = flash.erases + flash.programs;
    for (unsigned i = 0; i < 6; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_NO_SPACE,
                              invcal_store_save(&flash.store, record(2, 20), much[i]));
    }
    assert_save(INVCAL_BAD_COUNT, 2, 0);
    TEST_ASSERT_EQUAL_INT(calls, flash.erases + flash.programs);
    flash.store.slot_size = SLOT;
    assert_loads(1, 20);
}

static void a_buffer_that_is_too_small_stays_untouched(void)
{
    save(1, 50);
    save(2, 40);
    for (uint32_t capacity = 0; capacity < 40; capacity++) {
        const loaded it = load(capacity);
        TEST_ASSERT_EQUAL_INT(INVCAL_NO_SPACE, it.status);
        TEST_ASSERT_TRUE(is_untouched(&it, 0));
    }
    const loaded it = load(40);
    TEST_ASSERT_TRUE(is_record(&it, 2, 40));
}

static void settings_that_cannot_work_are_refused(void)
{
    static const uint32_t bad[] = {0,  3,  5,  6,   7,           12,         31,
                                   33, 48, 64, 128, 0x80000000u, 0xFFFFFFFFu};
    enum { COUNT = sizeof bad / sizeof bad[0] };

    save(1, 20);
    for (unsigned i = 0; i < COUNT + 2; i++) { /* two more: slots too small */
        flash.store.granularity = i < COUNT ? bad[i] : 8;
        flash.store.slot_size = i < COUNT ? SLOT : i == COUNT ? 0 : INVCAL_STORE_BYTES(1, 8) - 1;
        const int calls = flash.reads + flash.erases + flash.programs;
        assert_save(INVCAL_BAD_STORE, 2, 1);
        assert_refuses(INVCAL_BAD_STORE);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_STORE, invcal_store_erase(&flash.store));
        TEST_ASSERT_EQUAL_INT(calls, flash.reads + flash.erases + flash.programs);
    }
    flash.store.granularity = 8;
    flash.store.slot_size = INVCAL_STORE_BYTES(1, 8);
    save(2, 1);
    assert_loads(2, 1);
}

/* ---- nothing and garbage ---------------------------------------------------------------------- */

static void a_memory_without_a_record_says_so_and_accepts_one(void)
{
    for (unsigned kind = 0; kind < 40; kind++) {
        new_flash(4);
        for (unsigned i = 0; i < SLOT; i++) {
            flash.bytes[0][i] = kind == 0 ? 0xFF : kind == 1 ? 0 : any_bits();
        }
        if (kind > 20) { /* looks like one at first */
            write_slot(0, 5, 1, 180, 1);
            flash.bytes[0][8 + kind] ^= 0x10;
        }
        memcpy(flash.bytes[1], flash.bytes[0], SLOT);
        memset(flash.used, 1, sizeof flash.used);
        assert_refuses(INVCAL_NO_RECORD);
        save(1, 50);
        assert_loads(1, 50);
        save(2, 60);
        assert_loads(2, 60);
    }
}

/* Sound by its CRC, but not a record of this version and memory. */
static void a_nonsensical_header_is_not_a_record(void)
{
    static const struct {
        unsigned at;
        uint8_t value;
    } wrong[] = {{0, 0x5D}, {1, 0}, {1, 2}, {2, 0}, {2, 0xF4}, {3, 0xFF}};

    for (unsigned i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        for (uint32_t g = 1; g <= 32; g *= 2) {
            new_flash(g);
            flash.store.slot_size = 256;
            write_slot(0, 5, 1, 20, 1);
            write_slot(1, 6, 2, 20, 1);
            uint8_t *b = flash.bytes[1];
            b[wrong[i].at] = wrong[i].value;
            uint32_t end = 0;
            while (end < 12u + b[2] + 256u * b[3]) {
                end += g;
            }
            if (end + g <= SLOT) {
                put_crc(b + end - 4, slow_crc(b, end - 4));
            }
            assert_loads(1, 20);
        }
    }
}

static void any_wrong_bit_in_a_record_brings_back_the_other_or_none(void)
{
    for (unsigned g = 0; g < GRANULARITIES; g++) {
        for (unsigned both = 0; both < 2; both++) {
            new_flash(granularities[g]);
            save(1, 30);
            save(2, 41);
            const unsigned slot = slot_of(2);
            const uint32_t end = INVCAL_STORE_BYTES(41, granularities[g]) - granularities[g];
            if (!both) {
                memset(flash.bytes[1 - slot], 0xFF, SLOT);
            }
            for (uint32_t bit = 0; bit < 8 * end; bit++) {
                flash.bytes[slot][bit / 8] ^= (uint8_t)(1u << bit % 8);
                if (both) {
                    assert_loads(1, 30);
                } else {
                    assert_refuses(INVCAL_NO_RECORD);
                }
                flash.bytes[slot][bit / 8] ^= (uint8_t)(1u << bit % 8);
            }
            for (uint32_t bit = 8 * end; bit < 8 * SLOT; bit++) { /* after it, none matters */
                flash.bytes[slot][bit / 8] ^= (uint8_t)(1u << bit % 8);
                assert_loads(2, 41);
                flash.bytes[slot][bit / 8] ^= (uint8_t)(1u << bit % 8);
            }
        }
    }
}

static void a_record_without_its_last_bytes_brings_back_the_other(void)
{
    for (unsigned g = 0; g < GRANULARITIES; g++) {
        for (unsigned fill = 0; fill < 2; fill++) {
            new_flash(granularities[g]);
            save(1, 30);
            save(2, 41);
            const unsigned slot = slot_of(2);
            uint8_t whole[SLOT];
            uint32_t last = INVCAL_STORE_BYTES(41, granularities[g]) - granularities[g];
            memcpy(whole, flash.bytes[slot], SLOT);
            while (last-- > 0) { /* the confirmation stays */
                flash.bytes[slot][last] = (uint8_t)(fill ? 0 : 0xFF);
                if (memcmp(whole, flash.bytes[slot], SLOT) == 0) {
                    assert_loads(2, 41);
                } else {
                    assert_loads(1, 30);
                }
            }
        }
    }
}

/* ---- power cuts ------------------------------------------------------------------------------- */

/* How many bytes a save erases and programs. */
static int work_of(uint32_t size)
{
    return (int)(flash.store.slot_size + INVCAL_STORE_BYTES(size, flash.store.granularity));
}

/* Saves record n with that much power. Returns whether it was enough. */
static int save_until(int power, unsigned n, uint32_t size)
{
    flash.power = power;
    const invcal_status status = invcal_store_save(&flash.store, record(n, size), size);
    const int enough = power >= work_of(size);

    TEST_ASSERT_EQUAL_INT(enough ? INVCAL_OK : INVCAL_IO, status);
    TEST_ASSERT_EQUAL_INT(!enough, flash.dead);
    power_up();
    return enough;
}

/* Which of the records first ... last is loaded: any of them, whole. */
static unsigned loaded_one_of(unsigned first, unsigned last, const uint32_t size[])
{
    const loaded it = load(RECORD_MAX);

    for (unsigned n = first; n <= last; n++) {
        if (is_record(&it, n, size[n])) {
            return n;
        }
    }
    TEST_FAIL_MESSAGE("neither the old nor the new record");
    return 0;
}

static const uint32_t series[][4] = {{1, 1, 1, 1},     {20, 20, 20, 20}, {184, 184, 184, 184},
                                     {5, 184, 21, 52}, {180, 3, 90, 4},  {44, 45, 43, 52}};
enum { SERIES = 6 };

/* Saves 0 and 1, and cuts the power in 2 at every byte; then saves 3 and cuts again. In between,
 * what is loaded stays the same. */
static void cut_everywhere(uint32_t granularity, const uint32_t size[4], int tear)
{
    const int all = (int)(3 * flash.store.slot_size);
    memory before;
    int found_old = 0;
    int found_new = 0;

    new_flash(granularity);
    flash.store.slot_size = 256;
    flash.tear = tear;
    save(0, size[0]);
    save(1, size[1]);
    before = flash;
    for (int power = 0; power <= work_of(size[2]); power++) {
        const random_source random = flash.random; /* continues */
        flash = before;
        flash.random = random;
        const int enough = save_until(power, 2, size[2]);
        const unsigned found = loaded_one_of(1, 2, size);
        TEST_ASSERT_TRUE(found == 2 || !enough);
        found_old += found == 1;
        found_new += found == 2;
        TEST_ASSERT_EQUAL_UINT(found, loaded_one_of(1, 2, size));
        for (int again = 0; again < 3; again++) {
            const memory cut = flash;
            uint32_t left[4] = {0, 0, 0, 0};
            left[2] = size[found];
            const int second = (int)random_uniform(&flash.random, 0, work_of(size[3]));
            save_until(again == 0 ? second : again == 1 ? work_of(size[3]) - 2 : all, 3, size[3]);
            const loaded it = load(RECORD_MAX);
            TEST_ASSERT_TRUE(is_record(&it, found, left[2]) || is_record(&it, 3, size[3]));
            save(4, 33);
            assert_loads(4, 33);
            flash = cut;
            (void)any_bits();
        }
    }
    TEST_ASSERT_TRUE(found_old >= work_of(size[2]) - (int)granularity);
    TEST_ASSERT_TRUE(found_new >= 1);
}

static void a_power_cut_at_any_byte_leaves_the_old_record_or_the_new_one(void)
{
    for (unsigned g = 0; g < GRANULARITIES; g++) {
        for (unsigned s = 0; s < SERIES; s++) {
            for (int tear = 0; tear < TEARS; tear++) {
                cut_everywhere(granularities[g], series[s], tear);
            }
        }
    }
}

/* Torn bits keep changing. So what is found may change as well, but never to a record older than
 * the last that was saved in full, whatever happens to the next save too. */
static void cells_that_a_cut_left_half_programmed_do_no_harm(void)
{
    static const uint32_t size[4] = {20, 17, 30, 25};

    for (unsigned g = 0; g < GRANULARITIES; g++) {
        for (int first = 0;; first++) {
            memory cut;
            new_flash(granularities[g]);
            flash.store.slot_size = 96;
            flash.unsteady = 1;
            flash.tear = first % TEARS;
            flash.random = random_start((uint32_t)first);
            save(1, size[1]);
            const int enough = save_until(first, 2, size[2]);
            cut = flash;
            for (int second = 0; second <= work_of(size[3]); second += enough ? 7 : 1) {
                const random_source random = flash.random;
                flash = cut;
                flash.random = random;
                save_until(second, 3, size[3]);
                for (int i = 0; i < 4; i++) {
                    loaded_one_of(enough ? 2 : 1, 3, size);
                }
            }
            if (enough) {
                break;
            }
        }
    }
}

/* Nothing is there yet: a cut leaves nothing, or the first record, and never harms the next. */
static void the_first_save_may_be_cut_too(void)
{
    for (unsigned g = 0; g < GRANULARITIES; g++) {
        int enough = 0;
        int found = 0;
        for (int power = 0; !enough; power++) {
            new_flash(granularities[g]);
            flash.tear = power % TEARS;
            enough = save_until(power, 1, 40);
            const loaded it = load(RECORD_MAX);
            if (it.status == INVCAL_NO_RECORD) {
                TEST_ASSERT_TRUE(is_untouched(&it, 0) && !enough);
            } else {
                TEST_ASSERT_TRUE(is_record(&it, 1, 40));
                found++;
            }
            save(2, 50);
            assert_loads(2, 50);
        }
        TEST_ASSERT_TRUE(found >= 1 && found <= 2 + (int)granularities[g]);
    }
}

/* A cut leaves granules that error correction cannot read. */
static void a_slot_that_a_cut_made_unreadable_is_used_again(void)
{
    for (unsigned first = 0; first < 3; first++) { /* 1, 2: the other is blank */
        new_flash(8);
        if (!first) {
            save(1, 40);
            save(2, 41);
        }
        const unsigned slot = first ? first - 1 : 1 - slot_of(2);
        memset(flash.bytes[slot], 0x5A, SLOT);
        memset(flash.used[slot], 1, SLOT);
        flash.unreadable[slot] = 1;
        if (first) {
            assert_refuses(INVCAL_IO); /* anything may be there */
        } else {
            assert_loads(2, 41);
        }
        save(3, 42);
        assert_loads(3, 42);
        TEST_ASSERT_EQUAL_UINT(slot, slot_of(3));
        TEST_ASSERT_EQUAL_UINT(first ? 2 : 1 - slot, slot_of(2));
    }
}

/* ---- forgetting ------------------------------------------------------------------------------- */

static void after_an_erasure_nothing_is_left(void)
{
    for (unsigned saves = 0; saves < 4; saves++) {
        new_flash(8);
        for (unsigned n = 1; n <= saves; n++) {
            save(n, 40 + n);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_erase(&flash.store));
        assert_refuses(INVCAL_NO_RECORD);
        TEST_ASSERT_EACH_EQUAL_HEX8(0xFF, flash.bytes, sizeof flash.bytes);
        save(9, 50);
        assert_loads(9, 50);
    }
}

static void a_cut_while_erasing_leaves_the_last_record_or_none_but_no_older_one(void)
{
    for (unsigned saves = 1; saves < 4; saves++) { /* newest in either slot */
        for (int unsteady = 0; unsteady < 2; unsteady++) {
            int found = 0;
            int none = 0;
            for (int power = 0; power <= 2 * SLOT; power++) {
                new_flash(8);
                flash.tear = power % TEARS;
                flash.unsteady = unsteady;
                for (unsigned n = 1; n <= saves; n++) {
                    save(n, 300);
                }
                flash.power = power;
                const int enough = power == 2 * SLOT;
                TEST_ASSERT_EQUAL_INT(enough ? INVCAL_OK : INVCAL_IO,
                                      invcal_store_erase(&flash.store));
                power_up();
                const loaded it = load(RECORD_MAX);
                TEST_ASSERT_TRUE(is_record(&it, saves, 300) || it.status == INVCAL_NO_RECORD);
                found += it.status == INVCAL_OK;
                none += it.status == INVCAL_NO_RECORD;
                save(8, 20);
                assert_loads(8, 20);
            }
            TEST_ASSERT_TRUE(found >= SLOT && none > SLOT / 4);
        }
    }
}

static void an_erasure_that_fails_brings_no_older_record_back(void)
{
    save(1, 20);
    save(2, 20);
    flash.bad_erase = flash.erases + 1; /* the first: that of the older one */
    TEST_ASSERT_EQUAL_INT(INVCAL_IO, invcal_store_erase(&flash.store));
    assert_loads(2, 20);
    flash.bad_erase = flash.erases + 2;
    TEST_ASSERT_EQUAL_INT(INVCAL_IO, invcal_store_erase(&flash.store));
    assert_loads(2, 20);
    TEST_ASSERT_EQUAL_UINT(2, slot_of(1)); /* gone */
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_store_erase(&flash.store));
    assert_refuses(INVCAL_NO_RECORD);
}

/* ---- failures of the memory ------------------------------------------------------------------- */

/* Each call in turn fails while record 3 is saved over 1 and 2. */
static void a_callback_that_fails_leaves_the_old_record_or_the_new_one(void)
{
    enum { READ, ERASE, PROGRAM };

    for (int kind = READ; kind <= PROGRAM; kind++) {
        invcal_status status = INVCAL_IO;
        int refused = 0;
        for (int call = 1; call < 60; call++) {
            new_flash(8);
            save(1, 100);
            save(2, 101);
            flash.bad_read = kind == READ ? flash.reads + call : 0;
            flash.bad_erase = kind == ERASE ? flash.erases + call : 0;
            flash.bad_program = kind == PROGRAM ? flash.programs + call : 0;
            status = invcal_store_save(&flash.store, record(3, 102), 102);
            refused += status == INVCAL_IO;
            flash.bad_read = 0;
            flash.bad_erase = 0;
            flash.bad_program = 0;
            if (status == INVCAL_OK) {
                assert_loads(3, 102);
            } else {
                const loaded it = load(RECORD_MAX);
                TEST_ASSERT_EQUAL_INT(INVCAL_IO, status);
                TEST_ASSERT_TRUE(is_record(&it, 2, 101) ||
                                 (kind == READ && is_record(&it, 3, 102)));
            }
            save(4, 103);
            assert_loads(4, 103);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, status); /* there are no more calls */
        TEST_ASSERT_EQUAL_INT(kind == READ ? 1 + 5 + 1 : kind == ERASE ? 1 : 5, refused);
    }
}

/* The memory has executed the command, but reports a failure. */
static int erase_but_fail(void *context, unsigned slot)
{
    (void)flash_erase(context, slot);
    return 1;
}

static int program_but_fail(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                            uint32_t size)
{
    (void)flash_program(context, slot, offset, bytes, size);
    return -1;
}

static void a_failure_is_believed_even_if_the_bytes_are_right(void)
{
    save(1, 20);
    flash.store.erase = erase_but_fail;
    assert_save(INVCAL_IO, 2, 20);
    assert_loads(1, 20);
    TEST_ASSERT_EQUAL_INT(INVCAL_IO, invcal_store_erase(&flash.store));
    assert_loads(1, 20);
    flash.store.erase = flash_erase;
    flash.store.program = program_but_fail;
    assert_save(INVCAL_IO, 2, 20);
    assert_loads(1, 20);
}

static void if_one_slot_cannot_be_read_the_other_is_loaded(void)
{
    for (unsigned slot = 0; slot < 2; slot++) {
        new_flash(8);
        save(1, 100);
        save(2, 101);
        flash.unreadable[slot] = 1;
        if (slot == slot_of(2)) {
            assert_loads(1, 100);
        } else {
            assert_loads(2, 101);
        }
        flash.unreadable[1 - slot] = 1;
        assert_refuses(INVCAL_IO);
        const int calls = flash.erases + flash.programs;
        assert_save(INVCAL_IO, 3, 10);
        TEST_ASSERT_EQUAL_INT(calls, flash.erases + flash.programs);
        flash.unreadable[0] = 0;
        flash.unreadable[1] = 0;
        assert_loads(2, 101);
        flash.unreadable[slot] = 1;
        memset(flash.bytes[1 - slot], 0x55, SLOT);
        assert_refuses(INVCAL_IO); /* garbage in the one that can be read */
    }
}

static void one_read_that_fails_or_lies_never_gives_a_wrong_record(void)
{
    for (int lies = 0; lies < 2; lies++) {
        int refused = 0;
        int older = 0;
        for (int call = 1; call < 40; call++) {
            new_flash(8);
            flash.random = random_start((uint32_t)call);
            save(1, 100);
            save(2, 101);
            flash.bad_read = lies ? 0 : flash.reads + call;
            flash.lying_read = lies ? flash.reads + call : 0;
            const loaded it = load(RECORD_MAX);
            if (it.status == INVCAL_OK) {
                older += is_record(&it, 1, 100);
                TEST_ASSERT_TRUE(is_record(&it, 1, 100) || is_record(&it, 2, 101));
            } else {
                TEST_ASSERT_EQUAL_INT(INVCAL_IO, it.status);
                TEST_ASSERT_TRUE(it.size == 0xABCDEF && is_untouched(&it, 101));
                refused++;
            }
        }
        TEST_ASSERT_TRUE(refused >= 5 && older >= 5);
    }
}

/* The second read finds another size: it must not write beyond the buffer. */
static int read_that_grows(void *context, unsigned slot, uint32_t offset, uint8_t *bytes,
                           uint32_t size)
{
    const int failed = flash_read(context, slot, offset, bytes, size);

    if (offset == 0 && flash.reads > 14) {
        bytes[2] = 250;
    }
    return failed;
}

static void a_record_that_grows_while_it_is_loaded_does_not_overrun_the_buffer(void)
{
    save(1, 100);
    flash.reads = 0;
    flash.store.read = read_that_grows;
    for (int first = 0; first < 15; first++) {
        flash.reads = first;
        const loaded it = load(120);
        TEST_ASSERT_TRUE(is_record(&it, 1, 100) || it.status != INVCAL_OK);
        TEST_ASSERT_TRUE(is_untouched(&it, 100));
    }
}

/* Between the first and the second read, somebody else saves. */
static int read_that_finds_another(void *context, unsigned slot, uint32_t offset, uint8_t *bytes,
                                   uint32_t size)
{
    if (flash.reads == 0) {
        write_slot(slot, 9, 5, 60, 1);
    }
    flash.reads--;
    const int failed = flash_read(context, slot, offset, bytes, size);
    flash.reads--;
    return failed;
}

static void a_record_exchanged_while_it_is_loaded_is_loaded_whole_or_not_at_all(void)
{
    int refused = 0;

    for (int first = 20; first > 0; first--) {
        new_flash(8);
        save(1, 100);
        flash.reads = first;
        flash.store.read = read_that_finds_another;
        const loaded it = load(RECORD_MAX);
        TEST_ASSERT_TRUE(is_record(&it, 1, 100) || is_record(&it, 5, 60) || it.status != INVCAL_OK);
        refused += it.status == INVCAL_IO;
    }
    TEST_ASSERT_TRUE(refused > 0);
}

/* Every cell of the slot in turn, in every bit, cannot be programmed or cannot be erased. */
static void a_worn_cell_is_noticed_and_the_old_record_stays(void)
{
    for (unsigned g = 0; g < GRANULARITIES; g++) {
        int refused[2] = {0, 0};
        for (uint32_t bit = 0; bit < 8 * 128; bit++) {
            for (int low = 0; low < 2; low++) {
                new_flash(granularities[g]);
                flash.store.slot_size = 128;
                save(1, 50);
                save(2, 51);
                uint8_t *worn = (low ? flash.low : flash.high)[slot_of(1)];
                worn[bit / 8] = (uint8_t)(1u << bit % 8);
                const invcal_status status = invcal_store_save(&flash.store, record(3, 52), 52);
                if (status == INVCAL_OK) {
                    assert_loads(3, 52);
                } else {
                    TEST_ASSERT_EQUAL_INT(INVCAL_IO, status);
                    assert_loads(2, 51);
                    refused[low]++;
                }
            }
        }
        /* about every second cell of 64 or more bytes */
        TEST_ASSERT_TRUE(refused[0] > 200 && refused[0] < 400);
        TEST_ASSERT_TRUE(refused[1] > 200 && refused[1] < 600);
    }
}

static void a_confirmation_that_cannot_be_programmed_is_noticed(void)
{
    for (unsigned g = 0; g < GRANULARITIES; g++) {
        const uint32_t end = INVCAL_STORE_BYTES(52, granularities[g]) - granularities[g];
        new_flash(granularities[g]);
        save(1, 50);
        save(2, 51);
        memset(flash.high[slot_of(1)] + end, 0xFF, granularities[g]);
        assert_save(INVCAL_IO, 3, 52);
        assert_loads(2, 51);
    }
}

/* A protected memory may accept every command and do nothing. */
static void a_memory_that_ignores_commands_is_noticed(void)
{
    for (int deaf = 1; deaf < 4; deaf++) {
        for (int cut = 0; cut < 2; cut++) {
            new_flash(8);
            save(1, 50);
            save(2, 51);
            if (cut) { /* the other slot holds 3, not confirmed */
                save_until(work_of(52) - 8, 3, 52);
                memset(flash.bytes[slot_of(3)] + 64, 0xFF, 8);
            }
            memset(flash.used, 0, sizeof flash.used); /* only the result matters here */
            flash.deaf_erase = deaf & 1;
            flash.deaf_program = deaf & 2;
            assert_save(INVCAL_IO, 4, 52);
            assert_loads(2, 51);
            TEST_ASSERT_EQUAL_INT(deaf & 1 ? INVCAL_IO : INVCAL_OK,
                                  invcal_store_erase(&flash.store));
            if (deaf & 1) {
                assert_loads(2, 51);
            }
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_crc_has_the_check_value_of_the_standard);
    RUN_TEST(numbers_have_their_least_byte_first);
    RUN_TEST(reals_are_binary32);
    RUN_TEST(a_slot_holds_the_bytes_of_the_table);
    RUN_SLOW_TEST(what_was_saved_is_loaded_at_any_size_and_granularity);
    RUN_TEST(the_last_of_many_saves_is_loaded_also_when_the_sequence_wraps);
    RUN_TEST(of_two_confirmed_records_the_later_is_loaded);
    RUN_TEST(a_confirmed_record_is_loaded_before_one_that_is_not);
    RUN_TEST(a_record_without_confirmation_is_loaded_if_there_is_no_other);
    RUN_TEST(one_bit_of_the_confirmation_is_enough);
    RUN_TEST(a_record_may_fill_its_slot);
    RUN_TEST(a_size_that_cannot_be_stored_is_refused);
    RUN_TEST(a_buffer_that_is_too_small_stays_untouched);
    RUN_TEST(settings_that_cannot_work_are_refused);
    RUN_TEST(a_memory_without_a_record_says_so_and_accepts_one);
    RUN_TEST(a_nonsensical_header_is_not_a_record);
    RUN_SLOW_TEST(any_wrong_bit_in_a_record_brings_back_the_other_or_none);
    RUN_TEST(a_record_without_its_last_bytes_brings_back_the_other);
    RUN_LONG_TEST(a_power_cut_at_any_byte_leaves_the_old_record_or_the_new_one);
    RUN_LONG_TEST(cells_that_a_cut_left_half_programmed_do_no_harm);
    RUN_SLOW_TEST(the_first_save_may_be_cut_too);
    RUN_TEST(a_slot_that_a_cut_made_unreadable_is_used_again);
    RUN_TEST(after_an_erasure_nothing_is_left);
    RUN_LONG_TEST(a_cut_while_erasing_leaves_the_last_record_or_none_but_no_older_one);
    RUN_TEST(an_erasure_that_fails_brings_no_older_record_back);
    RUN_TEST(a_callback_that_fails_leaves_the_old_record_or_the_new_one);
    RUN_TEST(a_failure_is_believed_even_if_the_bytes_are_right);
    RUN_TEST(if_one_slot_cannot_be_read_the_other_is_loaded);
    RUN_TEST(one_read_that_fails_or_lies_never_gives_a_wrong_record);
    RUN_TEST(a_record_that_grows_while_it_is_loaded_does_not_overrun_the_buffer);
    RUN_TEST(a_record_exchanged_while_it_is_loaded_is_loaded_whole_or_not_at_all);
    RUN_LONG_TEST(a_worn_cell_is_noticed_and_the_old_record_stays);
    RUN_TEST(a_confirmation_that_cannot_be_programmed_is_noticed);
    RUN_TEST(a_memory_that_ignores_commands_is_noticed);
    return UNITY_END() != 0;
}
