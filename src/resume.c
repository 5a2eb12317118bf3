/* SPDX-License-Identifier: MIT */
#include "invcal/resume.h"

#include <string.h>

#include "bytes.h"
#include "vector.h"

enum { KIND = 0xC5, VERSION = 1, CRC_SIZE = 4, SHORTEST = 8 };
enum { REALS_AT = 24, TABLE_AT = 156, POSITION_SIZE = 13, SUMS_SIZE = 220 };
enum { SUMS = INVCAL_PACKED_SIZE(INVCAL_PARAMETERS) };
#define FADING INVCAL_REAL(0.96875) /* of a day: that of session.c */

/* A session without its table and sums. */
typedef struct {
    invcal_session_setup setup;
    invcal_real temperature;
    invcal_real coldest;
    invcal_real warmest;
    uint32_t count;
    uint16_t stored;
    uint16_t step;
    uint8_t is_enough;
} head;

/* ---- one way through many reals, with something to do at each --------------------------------- */

typedef enum { PUT, GET, TO_FLOAT } action; /* as in record.c */
typedef struct {
    action what;
    uint8_t *to;
    const uint8_t *from;
    int finite;
} way;

static invcal_real put(way *w, invcal_real x)
{
    invcal_put_float(w->to, (float)x);
    w->to += 4;
    return x;
}

static invcal_real get(way *w, invcal_real x)
{
    (void)x;
    const invcal_real value = (invcal_real)invcal_get_float(w->from);
    w->from += 4;
    w->finite &= invcal_is_finite(value);
    return value;
}

/* To what will be stored. Compared first: the conversion of a larger number is undefined. */
static invcal_real to_float(way *w, invcal_real x)
{
    if (INVCAL_FABS(x) <= (invcal_real)FLT_MAX) {
        return (invcal_real)(float)x;
    }
    w->finite = 0;
    return x;
}

/* Returns what x becomes. */
static invcal_real act(way *w, invcal_real x)
{
    switch (w->what) {
    case PUT:
        return put(w, x);
    case GET:
        return get(w, x);
    case TO_FLOAT:
        break;
    }
    return to_float(w, x);
}

static void each(way *w, invcal_real *x, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        x[i] = act(w, x[i]);
    }
}

static void each_const(way *w, const invcal_real *x, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        (void)act(w, x[i]);
    }
}

/* In the order of their bytes. */
static void each_real(way *w, head *h)
{
    invcal_settings *settings = &h->setup.settings;

    each(w, settings->nominal.offset, 3);
    for (unsigned i = 0; i < 3; i++) {
        each(w, settings->nominal.matrix[i], 3);
    }
    each(w, &settings->field, 1);
    each(w, &settings->noise, 1);
    each(w, settings->prior, INVCAL_PARAMETERS);
    each(w, h->setup.plan.start, INVCAL_PLAN_GROUPS);
    each(w, h->setup.target, 3);
    each(w, &h->setup.rate, 1);
    each(w, &h->temperature, 1);
    each(w, &h->coldest, 1);
    each(w, &h->warmest, 1);
}

static void each_sum(way *w, const invcal_normal *normal)
{
    each_const(w, normal->hth, SUMS);
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
           (has_sums(h) ? (uint32_t)SUMS_SIZE : 0u) + CRC_SIZE;
}

/* In the background positions go, so the program may have come further than the count. */
static int is_consistent(const head *h)
{
    const uint32_t last = (uint32_t)INVCAL_PLAN_GROUPS * h->setup.plan.per_group;

    return h->stored <= h->count && (h->stored > 0 || h->count == 0) && h->step <= last &&
           (h->step <= h->count || h->setup.background) && h->is_enough <= 1 &&
           h->coldest <= h->warmest;
}

/* Rounds to float and judges what remains: what passes here passes when it is read. */
static invcal_status settle(head *h)
{
    way w = {TO_FLOAT, NULL, NULL, 1};

    each_real(&w, h);
    if (!w.finite) {
        return INVCAL_NOT_FINITE;
    }
    return is_consistent(h) ? invcal_settings_check(&h->setup.settings) : INVCAL_BAD_SETTING;
}

static invcal_status row_of(const invcal_settings *settings, const invcal_real mean[3],
                            invcal_observation *row)
{
    invcal_real u[3];
    const invcal_status status =
        invcal_observation_reading(&settings->nominal, settings->field, mean, u);

    return status == INVCAL_OK ? invcal_observation_exact(u, row) : status;
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
    h->count = session->normal.count;
    h->stored = session->stored;
    h->step = session->step;
    h->is_enough = session->is_enough != 0;
}

static void put_head(const head *h, uint8_t *bytes)
{
    bytes[0] = KIND;
    bytes[1] = VERSION;
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
    way w = {TO_FLOAT, NULL, NULL, 1};
    invcal_status status = INVCAL_OK;
    invcal_observation row;
    invcal_real mean[3];

    for (unsigned i = 0; i < h->stored && status == INVCAL_OK; i++) {
        memcpy(mean, session->mean[i], sizeof mean);
        each(&w, mean, 3);
        status = w.finite ? row_of(&h->setup.settings, mean, &row) : INVCAL_NOT_FINITE;
    }
    if (status == INVCAL_OK && has_sums(h)) {
        each_sum(&w, &session->normal);
        status = w.finite ? INVCAL_OK : INVCAL_NOT_FINITE;
    }
    return status;
}

static void put_positions(way *w, const invcal_session *session, const head *h)
{
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
    way w = {PUT, bytes + REALS_AT, NULL, 1};
    head h;

    take_head(session, &h);
    invcal_status status = h.stored <= INVCAL_MAX_POSITIONS ? settle(&h) : INVCAL_BAD_SETTING;
    if (status == INVCAL_OK) {
        status = check_positions(session, &h);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    put_head(&h, bytes);
    each_real(&w, &h);
    put_positions(&w, session, &h);
    *size = length_of(&h);
    invcal_put_u32(w.to, invcal_crc32(0, bytes, *size - CRC_SIZE));
    return INVCAL_OK;
}

/* ---- from bytes -------------------------------------------------------------------------------- */

/* Are these bytes something with a CRC, of whatever kind and version? */
static int is_sound(const uint8_t *bytes, uint32_t size)
{
    if (size < SHORTEST) {
        return 0;
    }
    const uint16_t length = invcal_get_u16(bytes + 2);
    if (length < SHORTEST || length > size) {
        return 0;
    }
    const uint16_t end = (uint16_t)(length - CRC_SIZE);
    return invcal_crc32(0, bytes, end) == invcal_get_u32(bytes + end);
}

static int32_t get_i32(const uint8_t *bytes)
{
    const uint32_t bits = invcal_get_u32(bytes);
    int32_t value;

    memcpy(&value, &bits, sizeof value); /* the conversion would be the compiler's choice */
    return value;
}

/* Returns 0 if the length is not that of the content. */
static int get_head(const uint8_t *bytes, head *h)
{
    way w = {GET, NULL, bytes + REALS_AT, 1};
    const uint16_t length = invcal_get_u16(bytes + 2);

    if (length < TABLE_AT + CRC_SIZE) {
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
    each_real(&w, h);
    return length == length_of(h);
}

static int are_positions(const uint8_t *bytes, const head *h)
{
    way w = {GET, NULL, bytes + TABLE_AT, 1};
    invcal_observation row;
    invcal_real mean[3] = {0, 0, 0};

    for (unsigned i = 0; i < h->stored; i++) {
        each(&w, mean, 3);
        w.from++;
        if (row_of(&h->setup.settings, mean, &row) != INVCAL_OK) {
            return 0;
        }
    }
    for (unsigned i = 0; has_sums(h) && i < SUMS_SIZE / 4; i++) {
        (void)get(&w, 0);
    }
    return w.finite;
}

static invcal_real weight_of(unsigned age)
{
    invcal_real weight = 1;

    while (age-- > 0) {
        weight *= FADING;
    }
    return weight;
}

/* In the order and with the weights of session.c: in the same number type to the same bits. */
static void sum_up(invcal_session *session)
{
    invcal_observation row;

    for (unsigned i = 0; i < session->stored; i++) {
        (void)row_of(&session->setup.settings, session->mean[i], &row);
        (void)invcal_normal_add(&session->normal, &row, weight_of(session->age[i]));
    }
}

static void get_sums(way *w, invcal_normal *normal, unsigned count)
{
    each(w, normal->hth, SUMS);
    each(w, normal->htj, INVCAL_PARAMETERS);
    each(w, &normal->jtj, 1);
    normal->count = count;
    normal->model = INVCAL_MODEL_ELLIPSOID; /* a session makes no others */
}

/* Into a session that has just begun. All has been checked. */
static void fill(const uint8_t *bytes, const head *h, invcal_session *session)
{
    way w = {GET, NULL, bytes + TABLE_AT, 1};

    session->stored = h->stored;
    session->step = h->step;
    session->temperature = h->temperature;
    session->coldest = h->coldest;
    session->warmest = h->warmest;
    session->is_enough = h->is_enough;
    if (session->coldest < 0 || session->warmest > 0) { /* there was a thermometer */
        session->measured = (unsigned)h->count;
    }
    for (unsigned i = 0; i < h->stored; i++) {
        each(&w, session->mean[i], 3);
        session->age[i] = *w.from++;
    }
    if (has_sums(h)) {
        get_sums(&w, &session->normal, (unsigned)h->count);
    } else {
        sum_up(session);
    }
}

invcal_status invcal_resume_decode(const uint8_t *bytes, uint32_t size, invcal_session *out)
{
    INVCAL_ASSERT(bytes && out);
    head h;

    if (!is_sound(bytes, size)) {
        return INVCAL_DAMAGED;
    }
    if (bytes[0] != KIND || bytes[1] != VERSION) {
        return INVCAL_OTHER_VERSION;
    }
    if (!get_head(bytes, &h)) {
        return INVCAL_DAMAGED;
    }
    if (h.stored > INVCAL_MAX_POSITIONS || (unsigned)h.count != h.count) {
        return INVCAL_NO_SPACE;
    }
    /* invcal_session_init comes last: it is the first that writes, and only if it accepts. */
    if (settle(&h) != INVCAL_OK || !are_positions(bytes, &h) ||
        invcal_session_init(out, &h.setup) != INVCAL_OK) {
        return INVCAL_DAMAGED;
    }
    fill(bytes, &h, out);
    return INVCAL_OK;
}
