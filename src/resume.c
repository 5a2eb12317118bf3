/* SPDX-License-Identifier: MIT */
#include "invcal/resume.h"

#include <string.h>

#include "bytes.h"
#include "vector.h"

enum { SESSION_KIND = 0xC5, SESSION_VERSION = 1 };
enum { SESSION_REALS_AT = 24, START_AT = 116, TABLE_AT = 164, POSITION_SIZE = 13, SUMS_SIZE = 164 };

/* A session without its table and sums. */
typedef struct {
    invcal_session_setup setup;
    invcal_real temperature;
    invcal_real coldest;
    invcal_real warmest;
    invcal_real hold;
    uint32_t count;
    uint16_t stored;
    uint16_t step;
    uint8_t is_enough;
} head;

static void each_const(invcal_way *w, const invcal_real *x, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        (void)invcal_way_act(w, x[i]);
    }
}

/* In the order of their bytes. */
static void each_head_real(invcal_way *w, head *h)
{
    invcal_settings *settings = &h->setup.settings;

    invcal_way_each(w, settings->nominal.offset, 3);
    for (unsigned i = 0; i < 3; i++) {
        invcal_way_each(w, settings->nominal.matrix[i], 3);
    }
    invcal_way_each(w, &settings->field, 1);
    invcal_way_each(w, &settings->noise, 1);
    invcal_way_each(w, settings->prior, INVCAL_PARAMETERS);
    invcal_way_each(w, h->setup.plan.start, INVCAL_PLAN_GROUPS);
    invcal_way_each(w, h->setup.target, 3);
    invcal_way_each(w, &h->setup.rate, 1);
    invcal_way_each(w, &h->temperature, 1);
    invcal_way_each(w, &h->coldest, 1);
    invcal_way_each(w, &h->warmest, 1);
    invcal_way_each(w, &h->setup.mean_sigma, 1);
    invcal_way_each(w, &h->hold, 1);
}

static void each_sum(invcal_way *w, const invcal_normal *normal)
{
    each_const(w, normal->moment, INVCAL_MOMENTS);
    each_const(w, normal->htj, INVCAL_PARAMETERS);
    each_const(w, &normal->jtj, 1);
}

/* ---- what both directions ask ------------------------------------------------------------------ */

/* Are there positions that only the sums know? */
static int has_sums(const head *h)
{
    return h->count > h->stored;
}

static uint32_t length_of(const head *h)
{
    return (uint32_t)TABLE_AT + (uint32_t)POSITION_SIZE * h->stored +
           (has_sums(h) ? (uint32_t)SUMS_SIZE : 0u) + INVCAL_CRC_SIZE;
}

/* In the background positions go, so the program may have come further than the count. */
static int is_consistent_head(const head *h)
{
    const uint32_t last = (uint32_t)INVCAL_PLAN_GROUPS * h->setup.plan.per_group;

    return h->stored <= h->count && (h->stored > 0 || h->count == 0) && h->step <= last &&
           (h->step <= h->count || h->setup.background) && h->is_enough <= 1 &&
           h->coldest <= h->warmest && h->hold >= 0 && h->hold <= INVCAL_SESSION_HOLD_LONGEST;
}

/* Rounds to float and judges what remains: what passes here passes when it is read. */
static invcal_status settle_head(head *h)
{
    invcal_way w = {INVCAL_TO_FLOAT, NULL, NULL, 1};

    each_head_real(&w, h);
    if (!w.finite) {
        return INVCAL_NOT_FINITE;
    }
    return is_consistent_head(h) ? invcal_settings_check(&h->setup.settings) : INVCAL_BAD_SETTING;
}

static invcal_status row_of(const invcal_settings *settings, const invcal_real mean[3],
                            invcal_observation *row)
{
    return invcal_observe(&settings->nominal, settings->field, mean, row);
}

/* ---- to bytes ---------------------------------------------------------------------------------- */

static void take_head(const invcal_session *session, head *h)
{
    h->setup = session->setup;
    h->setup.background = session->setup.background != 0;
    if (h->setup.plan.per_group == 0) { /* nobody has looked at them */
        memset(h->setup.plan.start, 0, sizeof h->setup.plan.start);
    }
    h->temperature = session->temperature;
    h->coldest = session->coldest;
    h->warmest = session->warmest;
    h->hold = session->hold;
    h->count = session->normal.count;
    h->stored = session->stored;
    h->step = session->step;
    h->is_enough = session->is_enough != 0;
}

static void put_head(const head *h, uint8_t *bytes)
{
    bytes[0] = SESSION_KIND;
    bytes[1] = SESSION_VERSION;
    invcal_put_u16(bytes + 2, (uint16_t)length_of(h));
    invcal_put_u16(bytes + 4, h->stored);
    invcal_put_u16(bytes + 6, h->step);
    invcal_put_u32(bytes + 8, h->count);
    invcal_put_u16(bytes + 12, (uint16_t)h->setup.plan.per_group);
    bytes[14] = (uint8_t)h->setup.settings.frame;
    bytes[15] = (uint8_t)(h->setup.background | h->is_enough << 1);
    invcal_put_u32(bytes + 16, (uint32_t)h->setup.low);
    invcal_put_u32(bytes + 20, (uint32_t)h->setup.high);
}

/* Are all means, as they will be stored, readings of the field, and all sums storable? */
static invcal_status check_positions(const invcal_session *session, const head *h)
{
    invcal_way w = {INVCAL_TO_FLOAT, NULL, NULL, 1};
    invcal_status status = INVCAL_OK;
    invcal_observation row;
    invcal_real mean[3];

    //@ loop unroll INVCAL_MAX_POSITIONS;
    for (unsigned i = 0; i < h->stored && status == INVCAL_OK; i++) {
        memcpy(mean, session->mean[i], sizeof mean);
        invcal_way_each(&w, mean, 3);
        status = w.finite ? row_of(&h->setup.settings, mean, &row) : INVCAL_NOT_FINITE;
    }
    if (status == INVCAL_OK && has_sums(h)) {
        each_sum(&w, &session->normal);
        status = w.finite ? INVCAL_OK : INVCAL_NOT_FINITE;
    }
    return status;
}

static void put_positions(invcal_way *w, const invcal_session *session, const head *h)
{
    //@ loop unroll INVCAL_MAX_POSITIONS;
    for (unsigned i = 0; i < h->stored; i++) {
        each_const(w, session->mean[i], 3);
        *w->to++ = session->age[i];
    }
    if (has_sums(h)) {
        each_sum(w, &session->normal);
    }
}

invcal_status invcal_resume_encode(const invcal_session *session, uint8_t bytes[INVCAL_RESUME_SIZE],
                                   uint32_t *size)
{
    INVCAL_ASSERT(session && bytes && size);
    invcal_way w = {INVCAL_PUT, bytes + SESSION_REALS_AT, NULL, 1};
    head h;

    take_head(session, &h);
    invcal_status status = h.stored <= INVCAL_MAX_POSITIONS ? settle_head(&h) : INVCAL_BAD_SETTING;
    if (status == INVCAL_OK) {
        status = check_positions(session, &h);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    put_head(&h, bytes);
    each_head_real(&w, &h);
    put_positions(&w, session, &h);
    *size = length_of(&h);
    //@ assert \initialized(bytes + (0 .. *size - INVCAL_CRC_SIZE - 1)); // all fitted into floats
    invcal_put_u32(w.to, invcal_crc32(0, bytes, *size - INVCAL_CRC_SIZE));
    return INVCAL_OK;
}

/* ---- from bytes -------------------------------------------------------------------------------- */

static int32_t get_i32(const uint8_t *bytes)
{
    const uint32_t bits = invcal_get_u32(bytes);
    int32_t value;

    memcpy(&value, &bits, sizeof value); /* the conversion would be the compiler's choice */
    return value;
}

/* Returns 0 if the length is not that of the content, or there are angles of no plan. */
static int get_head(const uint8_t *bytes, head *h)
{
    const uint16_t length = invcal_get_u16(bytes + 2);

    if (length < TABLE_AT + INVCAL_CRC_SIZE) {
        return 0;
    }
    h->stored = invcal_get_u16(bytes + 4);
    h->step = invcal_get_u16(bytes + 6);
    h->count = invcal_get_u32(bytes + 8);
    h->setup.plan.per_group = invcal_get_u16(bytes + 12);
    h->setup.settings.frame = (invcal_frame)bytes[14];
    h->setup.background = bytes[15] & 1u;
    h->is_enough = (uint8_t)(bytes[15] >> 1);
    h->setup.low = get_i32(bytes + 16);
    h->setup.high = get_i32(bytes + 20);
    invcal_way w = {INVCAL_GET, NULL, bytes + SESSION_REALS_AT, 1};
    each_head_real(&w, h);
    return length == length_of(h) && (h->setup.plan.per_group > 0 ||
                                      invcal_are_zero(bytes + START_AT, 4 * INVCAL_PLAN_GROUPS));
}

static int are_positions(const uint8_t *bytes, const head *h)
{
    invcal_way w = {INVCAL_GET, NULL, bytes + TABLE_AT, 1};
    invcal_observation row;
    invcal_real mean[3] = {0, 0, 0};

    //@ loop unroll INVCAL_MAX_POSITIONS;
    for (unsigned i = 0; i < h->stored; i++) {
        invcal_way_each(&w, mean, 3);
        w.from++;
        if (row_of(&h->setup.settings, mean, &row) != INVCAL_OK) {
            return 0;
        }
    }
    for (unsigned i = 0; has_sums(h) && i < SUMS_SIZE / 4; i++) {
        (void)invcal_way_act(&w, 0);
    }
    return w.finite;
}

static void get_sums(invcal_way *w, invcal_normal *normal, unsigned count)
{
    invcal_way_each(w, normal->moment, INVCAL_MOMENTS);
    invcal_way_each(w, normal->htj, INVCAL_PARAMETERS);
    invcal_way_each(w, &normal->jtj, 1);
    normal->count = count;
    normal->model = INVCAL_MODEL_ELLIPSOID; /* a session makes no others */
}

/* Into a session that has just begun. All has been checked. */
static void fill(const uint8_t *bytes, const head *h, invcal_session *session)
{
    invcal_way w = {INVCAL_GET, NULL, bytes + TABLE_AT, 1};

    session->stored = h->stored;
    session->step = h->step;
    session->temperature = h->temperature;
    session->coldest = h->coldest;
    session->warmest = h->warmest;
    session->hold = h->hold;
    session->is_enough = h->is_enough;
    if (session->coldest < 0 || session->warmest > 0) { /* there was a thermometer */
        session->measured = (unsigned)h->count;
    }
    //@ loop unroll INVCAL_MAX_POSITIONS;
    for (unsigned i = 0; i < h->stored; i++) {
        invcal_way_each(&w, session->mean[i], 3);
        session->age[i] = *w.from++;
    }
    if (has_sums(h)) {
        get_sums(&w, &session->normal, (unsigned)h->count);
    } else { /* in the order and with the weights of the session: the same bits */
        (void)invcal_session_renew(session, &session->setup.settings.nominal);
    }
}

/* What can be told from the bytes of the head alone. */
static invcal_status read_head(const uint8_t *bytes, uint32_t size, head *h)
{
    if (!invcal_is_sound(bytes, size)) {
        return INVCAL_DAMAGED;
    }
    if (bytes[0] != SESSION_KIND || bytes[1] != SESSION_VERSION) {
        return INVCAL_OTHER_VERSION;
    }
    memset(h, 0, sizeof *h); /* each_real looks at what it replaces */
    if (!get_head(bytes, h)) {
        return INVCAL_DAMAGED;
    }
    if (h->stored > INVCAL_MAX_POSITIONS ||
        (unsigned)h->count != h->count) { /* uncovered: where int has 16 bits */
        return INVCAL_NO_SPACE;
    }
    return INVCAL_OK;
}

invcal_status invcal_resume_decode(const uint8_t *bytes, uint32_t size, invcal_session *out)
{
    INVCAL_ASSERT(bytes && out);
    head h;

    const invcal_status status = read_head(bytes, size, &h);
    if (status != INVCAL_OK) {
        return status;
    }
    /* invcal_session_init comes last: it is the first that writes, and only if it accepts. */
    if (settle_head(&h) != INVCAL_OK || !are_positions(bytes, &h) ||
        invcal_session_init(out, &h.setup) != INVCAL_OK) {
        return INVCAL_DAMAGED;
    }
    fill(bytes, &h, out);
    return INVCAL_OK;
}
