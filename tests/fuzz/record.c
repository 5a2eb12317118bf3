/* SPDX-License-Identifier: MIT
 *
 * Bytes that may be anything as a record, with temperature or without, or of both sensors, as a session, with
 * moves or without, and as the two slots of a flash memory.
 * What is accepted packs again to the same bytes, and is sane; a session that is accepted goes on
 * being fed. The store finds what was saved before or what is saved now, wherever power fails; load
 * makes of it what decode does.
 * fuzz: more than 20 inputs per second of CPU time
 */
#include <stdlib.h>
#include <string.h>

#include "../positions.h"
#include "core/bytes.h"
#include "drive.h"
#include "invcal/gyro_store.h"
#include "invcal/thermal_store.h"

/* ---- records and sessions --------------------------------------------------------------------- */

enum { RECORD_AT = 4, LEAST = 4 + INVCAL_CRC_SIZE }; /* in a thermal record; of all */

/* Puts the right CRC where the length says that there is one. */
static void repair(uint8_t *bytes, size_t size)
{
    const size_t length = size >= LEAST ? invcali_get_u16(bytes + 2) : 0;

    if (length >= LEAST && length <= size) {
        const uint32_t end = (uint32_t)length - INVCAL_CRC_SIZE;
        invcali_put_u32(bytes + end, invcali_crc32(0, bytes, end));
    }
}

static void look_at_record(const uint8_t *bytes, uint32_t size)
{
    uint8_t again[INVCAL_RECORD_SIZE];
    invcal_record r;

    mark(&r, sizeof r);
    if (invcal_record_decode(bytes, size, &r) != INVCAL_OK) {
        require_mark(&r, sizeof r);
        return;
    }
    require_regular(&r.calibration);
    require_finite(&r.field, 1);
    require_finite(&r.field_sigma, 1);
    require_finite(&r.temperature, 1);
    require_finite(&r.noise, 1);
    require_finite(&r.rms, 1);
    require_finite(&r.condition, 1);
    require_finite(r.sigma, INVCAL_PARAMETERS);
    REQUIRE((r.verdict == INVCAL_WEAK) == (r.weak != 0) && r.verdict <= INVCAL_WEAK);
    REQUIRE(r.weak < 1u << INVCAL_PARAMETERS && r.held < 1u << INVCAL_PARAMETERS);
    REQUIRE(r.temperature_known <= 1 && (r.temperature_known || r.temperature == 0));
    REQUIRE(invcal_record_encode(&r, again) == INVCAL_OK);
    REQUIRE(size >= sizeof again && memcmp(bytes, again, sizeof again) == 0);
}

static void look_at_thermal(const uint8_t *bytes, uint32_t size)
{
    enum { FRAME_AT = 143 }; /* not used any more: encoded as 0 */
    uint8_t again[INVCAL_THERMAL_RECORD_SIZE];
    invcal_thermal t;
    invcal_record about;

    mark(&t, sizeof t);
    mark(&about, sizeof about);
    if (invcal_thermal_decode(bytes, size, &t, &about) != INVCAL_OK) {
        require_mark(&t, sizeof t);
        require_mark(&about, sizeof about);
        return;
    }
    REQUIRE(t.fitted <= t.degree && t.degree <= 2 && t.fallback <= INVCAL_THERMAL_OPEN);
    REQUIRE(t.span > 0 && t.min <= t.max);
    require_regular(&t.nominal);
    require_finite(&t.x[0][0], 3 * INVCAL_PARAMETERS);
    const uint32_t length = 212 + 36 * (t.degree + 1u);
    const uint32_t end = length - INVCAL_CRC_SIZE;
    REQUIRE(invcal_thermal_encode(&t, &about, again) == INVCAL_OK);
    REQUIRE(length <= size && memcmp(bytes, again, FRAME_AT) == 0 && again[FRAME_AT] == 0);
    REQUIRE(memcmp(bytes + FRAME_AT + 1, again + FRAME_AT + 1, end - FRAME_AT - 1) == 0);
    REQUIRE(bytes[FRAME_AT] != 0 || memcmp(bytes + end, again + end, INVCAL_CRC_SIZE) == 0);
    look_at_record(bytes + RECORD_AT, INVCAL_RECORD_SIZE);
}

static void look_at_imu(const uint8_t *bytes, uint32_t size)
{
    uint8_t again[INVCAL_IMU_RECORD_SIZE];
    invcal_imu_result r;
    invcal_record about;

    mark(&r, sizeof r);
    if (invcal_imu_decode(bytes, size, &r, &about) != INVCAL_OK) {
        require_mark(&r, sizeof r);
        return;
    }
    require_regular(&r.gyro);
    require_finite(&r.move_noise, 1);
    require_finite(&r.move_rms, 1);
    require_finite(&r.move_max, 1);
    require_finite(r.sigma, INVCAL_IMU_PARAMETERS);
    require_finite(r.slope[0], 12);
    require_finite(r.slope_sigma[0], 12);
    REQUIRE(r.verdict <= INVCAL_WEAK && r.weak < 1u << INVCAL_IMU_PARAMETERS && r.g_is_used <= 1);
    REQUIRE(r.weak >> INVCAL_PARAMETERS == 0 || r.verdict == INVCAL_WEAK);
    look_at_record(bytes + RECORD_AT, INVCAL_RECORD_SIZE);
    REQUIRE(invcal_imu_encode(&r, &about, again) == INVCAL_OK);
    REQUIRE(size >= sizeof again && memcmp(bytes, again, sizeof again) == 0);
}

/* A memory that holds both. */
static uint8_t slots[2][INVCAL_STORE_BYTES(INVCAL_IMU_SIZE, 1)];

static int read_slot(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    memcpy(bytes, &slots[slot][offset], size);
    return 0;
}

static int erase_slot(void *context, unsigned slot)
{
    (void)context;
    memset(slots[slot], 0xFF, sizeof slots[slot]);
    return 0;
}

static int program_slot(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                        uint32_t size)
{
    (void)context;
    memcpy(&slots[slot][offset], bytes, size);
    return 0;
}

static const invcal_store of_both = {read_slot, erase_slot, program_slot, NULL, sizeof slots[0], 1};

/* Head, rests and as many segments as there are bytes, in front of a session with two means; what is accepted is
 * solved, and fed what is behind. */
static void look_at_both(const uint8_t *bytes, uint32_t size)
{
    static invcal_imu both;
    static invcal_imu saved;
    const invcal_calibration gyro = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const uint32_t from = offsetof(invcal_imu, own.layout);
    const uint32_t room = offsetof(invcal_imu, session) - from;
    invcal_imu_result imu;
    invcal_turn turn;
    int32_t raw[3];

    memset(&both, 0, sizeof both);
    REQUIRE(invcal_session_init(&both.session, sizeof both.session, 100, 50) == INVCAL_OK);
    REQUIRE(invcal_imu_init_nominal(&both, sizeof both, &gyro, 50) == INVCAL_OK);
    both.session.count = 2;
    both.session.mean[0].v[0] = both.session.mean[1].v[1] = 100;
    const uint32_t layout = both.own.layout; /* or almost nothing would be accepted */
    saved = both;
    memcpy((uint8_t *)&saved + from, bytes, size < room ? size : room);
    saved.own.layout = layout;
    saved.nominal = both.nominal;
    saved.own.rate = both.own.rate;
    REQUIRE(invcal_imu_save(&saved, &of_both) == INVCAL_OK);
    if (invcal_imu_load(&both, &of_both) != INVCAL_OK) {
        REQUIRE(both.session.count == 0 && both.rests == 0);
        return;
    }
    REQUIRE(both.rests <= INVCAL_MAX_MOVES && both.own.used <= INVCAL_MAX_SEGMENTS);
    (void)invcal_imu_solve(&both, NULL, &imu);
    invcal_imu_next(&both, &turn);
    source s = {bytes, size};
    while (s.left > 0) {
        for (unsigned i = 0; i < 3; i++) {
            raw[i] = take_byte(&s) - 128;
        }
        invcal_imu_feed_gyro(&both, raw[0], raw[1], raw[2]);
        (void)invcal_imu_feed(&both, raw[0], raw[1], raw[2]);
    }
}

/* Bytes behind those of the session lead it on, if all its means are readings. */
static void look_at_session(const uint8_t *bytes, uint32_t size)
{
    invcal_session saved;
    invcal_session session;
    invcal_calibration calibration;
    invcal_quality quality;
    invcal_real up[3];

    mark(&saved, sizeof saved);
    memcpy(&saved, bytes, size < INVCAL_SESSION_SIZE ? size : INVCAL_SESSION_SIZE);
    REQUIRE(invcal_session_init(&session, sizeof session, 1, 50) == INVCAL_OK);
    saved.layout = session.layout; /* or almost nothing would get in */
    saved.rate = session.rate;
    saved.nominal = session.nominal;
    const uint32_t length = size < INVCAL_SESSION_SIZE && saved.count <= INVCAL_MAX_POSITIONS
                                ? invcal_session_size(&saved)
                                : size;
    if (length > size ||
        invcal_session_resume(&session, (const uint8_t *)&saved, length) != INVCAL_OK) {
        REQUIRE(session.count == 0);
        return;
    }
    (void)invcal_session_solve(&session, &calibration, &quality);
    invcal_session_next(&session, up);
    require_finite(up, 3);
    if (invcal_bad_reading(POSITIONS_OF(session.mean, session.count, &session.nominal, 0)) ==
        session.count) {
        source s = {bytes + length, size - length};
        drive(&session, NULL, &s);
    }
}

static void unpack(source *s, unsigned how)
{
    const uint32_t size = (uint32_t)s->left;
    uint8_t *bytes = malloc(size + !size); /* its own, so that no byte behind it may be read */

    REQUIRE(bytes);
    memcpy(bytes, s->at, size);
    if (how & 4u && size > RECORD_AT) {
        repair(bytes + RECORD_AT, size - RECORD_AT);
    }
    if (how & 1u) {
        repair(bytes, size);
    }
    look_at_record(bytes, size);
    look_at_thermal(bytes, size);
    look_at_imu(bytes, size);
    look_at_session(bytes, size);
    look_at_both(bytes, size);
    free(bytes);
}

/* A record of any numbers: what packs can be read. */
static void pack(source *s)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record r;

    memset(&r, 0, sizeof r);
    for (unsigned i = 0; i < 3; i++) {
        r.calibration.offset[i] = take_real(s, 10);
        for (unsigned j = 0; j < 3; j++) {
            r.calibration.matrix[i][j] = take_real(s, i == j);
        }
    }
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        r.sigma[i] = take_real(s, 1);
    }
    r.field = take_real(s, 1);
    r.temperature_known = take_byte(s);
    r.temperature = take_real(s, r.temperature_known ? 25 : 0);
    r.condition = take_real(s, 200);
    r.weak = take_byte(s);
    r.verdict = take_byte(s) % 6;
    if (invcal_record_encode(&r, bytes) == INVCAL_OK) {
        look_at_record(bytes, sizeof bytes);
        REQUIRE(invcal_record_decode(bytes, sizeof bytes, &r) == INVCAL_OK);
    }
}

/* ---- the store -------------------------------------------------------------------------------- */

enum { SLOT_MOST = 160 };

/* The flash memory, and what befalls it. */
typedef struct {
    source *s;
    uint32_t slot_size, granularity;
    uint8_t cell[2][SLOT_MOST];
    uint8_t used[2][SLOT_MOST]; /* programmed since the slot was erased: not to be again */
    unsigned steps;             /* erasures and granules until power fails, */
    int is_off;                 /* and then nothing goes any more */
    int misreads;               /* reading may fail */
} flash;

static int flash_read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    flash *f = context;

    REQUIRE(slot < 2 && size <= 32 && offset <= f->slot_size && size <= f->slot_size - offset);
    if (f->is_off || (f->misreads && take_byte(f->s) % 4 == 1)) {
        return -1;
    }
    memcpy(bytes, f->cell[slot] + offset, size);
    return 0;
}

/* Does power fail in this step? */
static int fails(flash *f)
{
    if (f->steps == 0) {
        f->is_off = 1;
    }
    f->steps -= !f->is_off;
    return f->is_off;
}

/* Cut off, some bits have changed already. */
static int flash_erase(void *context, unsigned slot)
{
    flash *f = context;

    REQUIRE(slot < 2);
    if (f->is_off) {
        return -1;
    }
    const int is_cut = fails(f);
    for (uint32_t i = 0; i < f->slot_size; i++) {
        f->cell[slot][i] |= is_cut ? take_byte(f->s) : 0xFF;
        f->used[slot][i] = (uint8_t)is_cut;
    }
    return is_cut ? -1 : 0;
}

static int program_granule(flash *f, unsigned slot, uint32_t offset, const uint8_t *bytes)
{
    const int is_cut = fails(f);

    for (uint32_t i = 0; i < f->granularity; i++) {
        uint8_t *cell = &f->cell[slot][offset + i];
        REQUIRE(!f->used[slot][offset + i]);
        *cell &= is_cut ? bytes[i] | take_byte(f->s) : bytes[i];
        f->used[slot][offset + i] = 1;
    }
    return is_cut;
}

static int flash_program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                         uint32_t size)
{
    flash *f = context;

    REQUIRE(slot < 2 && size > 0 && size <= 32);
    REQUIRE(offset % f->granularity == 0 && size % f->granularity == 0);
    REQUIRE(offset <= f->slot_size && size <= f->slot_size - offset);
    for (uint32_t at = 0; at < size; at += f->granularity) {
        if (f->is_off || program_granule(f, slot, offset + at, bytes + at)) {
            return -1;
        }
    }
    return 0;
}

/* The right CRC for what a slot holds, so that it is one of a record. */
static void repair_slot(flash *f, unsigned slot)
{
    uint8_t *cell = f->cell[slot];
    const uint32_t g = f->granularity;

    if (f->slot_size >= 16 && g >= 1 && g <= 32 && (g & (g - 1)) == 0) {
        const uint32_t end = (invcali_get_u16(cell + 2) + 12u + g - 1) & ~(g - 1);
        if (end <= f->slot_size) {
            invcali_put_u32(cell + end - 4, invcali_crc32(0, cell, end - 4));
        }
    }
}

/* What is loaded. */
typedef struct {
    invcal_status status;
    uint32_t size;
    uint8_t bytes[SLOT_MOST];
} content;

static void load(const invcal_store *store, content *c)
{
    memset(c, 0, sizeof *c);
    c->status = invcal_store_load(store, c->bytes, SLOT_MOST, &c->size);
    REQUIRE(c->status == INVCAL_OK || c->size == 0);
    REQUIRE(c->size <= SLOT_MOST);
}

/* What load and load_session make of it: as decode would. */
static void load_as(const invcal_store *store, const content *c)
{
    invcal_calibration calibration;
    invcal_session session;
    invcal_record r;
    invcal_status wanted = c->status;

    mark(&calibration, sizeof calibration);
    if (wanted == INVCAL_OK) {
        wanted = c->size <= INVCAL_RECORD_SIZE ? invcal_record_decode(c->bytes, c->size, &r)
                                               : INVCAL_NO_SPACE;
    }
    REQUIRE(invcal_load(&calibration, store) == wanted);
    if (wanted == INVCAL_OK) {
        REQUIRE(memcmp(&calibration, &r.calibration, sizeof calibration) == 0);
    } else {
        require_mark(&calibration, sizeof calibration);
    }
    REQUIRE(invcal_session_init(&session, sizeof session, 1000, 50) == INVCAL_OK);
    wanted =
        c->status == INVCAL_OK ? invcal_session_resume(&session, c->bytes, c->size) : c->status;
    REQUIRE(invcal_session_load(&session, store) == wanted);
    REQUIRE(wanted == INVCAL_OK || session.count == 0);
}

static int is_same(const content *a, const content *b)
{
    return a->status == b->status && a->size == b->size && memcmp(a->bytes, b->bytes, a->size) == 0;
}

static invcal_status save(flash *f, const invcal_store *store, content *wish)
{
    memset(wish, 0, sizeof *wish);
    wish->size = take_byte(f->s) % SLOT_MOST;
    for (uint32_t i = 0; i < wish->size; i++) {
        wish->bytes[i] = (uint8_t)(take_byte(f->s) + i);
    }
    return invcal_store_save(store, wish->bytes, wish->size);
}

/* A calibration, as its record. */
static invcal_status save_calibration(flash *f, const invcal_store *store, content *wish)
{
    const invcal_quality quality = {.noise = 1, .condition = 200, .positions = 12};
    invcal_calibration calibration = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    invcal_record r;

    memset(wish, 0, sizeof *wish);
    calibration.offset[0] = take_real(f->s, 10);
    invcal_record_init(&r, &calibration, &quality);
    const invcal_status status = invcal_record_encode(&r, wish->bytes);
    wish->size = INVCAL_RECORD_SIZE;
    const invcal_status saved = invcal_save(&calibration, &quality, store);
    REQUIRE(status == INVCAL_OK || saved == status);
    return saved;
}

/* A session with one position. */
static invcal_status save_session(flash *f, const invcal_store *store, content *wish)
{
    invcal_session session;

    memset(wish, 0, sizeof *wish);
    REQUIRE(invcal_session_init(&session, sizeof session, 1000, 50) == INVCAL_OK);
    session.mean[0].v[0] = 1000;
    session.mean[0].v[1] = 20;
    session.mean[0].v[2] = (invcal_real)take_byte(f->s);
    session.count = 1;
    wish->size = invcal_session_size(&session);
    memcpy(wish->bytes, &session, wish->size);
    return invcal_session_save(&session, store);
}

/* One save or erasure, with or without a power cut; what is loaded behind it is what was there, or
 * what was to be there. */
static void change(flash *f, const invcal_store *store)
{
    const unsigned what = take_byte(f->s);
    content before;
    content wish;
    content after;
    invcal_status status;

    load(store, &before);
    f->steps = what & 1u ? take_byte(f->s) : UINT32_MAX;
    f->misreads = (what & 14u) == 14;
    if (what & 16u) {
        memset(&wish, 0, sizeof wish);
        wish.status = INVCAL_NO_RECORD;
        status = invcal_store_erase(store);
    } else if (what & 32u) {
        status = what & 64u ? save_session(f, store, &wish) : save_calibration(f, store, &wish);
    } else {
        status = save(f, store, &wish);
    }
    const int may_be_lost = f->misreads;
    f->is_off = 0;
    f->misreads = 0;
    f->steps = UINT32_MAX;
    load(store, &after);
    if (status == INVCAL_OK) {
        REQUIRE(is_same(&after, &wish));
    } else {
        REQUIRE(may_be_lost || is_same(&after, &before) || is_same(&after, &wish));
    }
    load_as(store, &after);
}

static void use_store(source *s)
{
    flash f = {.s = s, .steps = UINT32_MAX};
    const unsigned setup = take_byte(s);

    f.granularity = setup & 8u ? take_byte(s) : 1u << setup % 6;
    f.slot_size = take_byte(s) % (SLOT_MOST + 1);
    for (unsigned slot = 0; slot < 2; slot++) {
        const unsigned kind = take_byte(s);
        memset(f.cell[slot], 0xFF, SLOT_MOST);
        for (uint32_t i = 0; i < f.slot_size && kind & 1u; i++) {
            f.cell[slot][i] = take_byte(s);
        }
        memset(f.used[slot], kind & 1u, SLOT_MOST);
        if (kind & 2u) {
            repair_slot(&f, slot);
        }
    }
    const invcal_store store = {flash_read, flash_erase, flash_program,
                                &f,         f.slot_size, f.granularity};
    for (unsigned i = 0; i < 8 && s->left > 0; i++) {
        change(&f, &store);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    source s = {data, size};
    const unsigned what = take_byte(&s);

    switch (what & 3u) {
    case 0:
        use_store(&s);
        break;
    case 1:
        pack(&s);
        break;
    default: /* 2, or 3 with a right CRC; 6 and 7 with that of a record inside, too */
        unpack(&s, what);
        break;
    }
    return 0;
}
