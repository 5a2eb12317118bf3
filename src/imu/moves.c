/* SPDX-License-Identifier: MIT
 *
 * Turns a stream of gyroscope samples into segments of moves (mathematics_imu.md, "Segments").
 * Whether the device was at rest is known only when the detector of the accelerometer reports it,
 * up to seven blocks of 1/8 s later. So the newest segments wait as they are, then each is merged
 * into its move, or added to the bias of a rest and dropped once that is taken.
 *
 * segment[]: from 0 those of complete moves; from `first` those of the current one, merged; from
 * `fixed` to used - 1 those still waiting.
 */
#include <stddef.h>

#include "imu.h"
#include "rotation.h"
#include "../session/session.h"
#include "../core/solve.h"

/* mathematics_imu.md, "Segments". */
#define MERGED_LIMIT INVCAL_REAL(0.1218)   /* 20 degrees, squared: of a segment */
#define UNMERGED_LIMIT INVCAL_REAL(0.0110) /* 6 degrees, squared: of one that is not merged */
#define LONGEST_MOVE INVCAL_REAL(10.0)     /* seconds */

enum {
    LATE = 8,            /* blocks that are not merged: a rest is TAKEN 7 blocks after its end */
    CUT_OFF = 2,         /* last blocks of a rest, which are ignored: TRIM of rests.c */
    MOST_CHANGE = 2288,  /* bias from rest to rest, 0.5 degrees/s: above it, one was no rest */
    SPARE = 24,          /* segments kept free for those that are not merged */
    MOST_SEGMENTS = 127, /* of a move: seven turns */
    MOST_SAMPLES = INT16_MAX,
    NOWHERE = UINT16_MAX,
    SPOILT = INT16_MIN /* v[0] of an unusable segment; kappa[0] is the reason */
};

/* ---- rotations ------------------------------------------------------------------------------- */

/* The rotation rho, then th, as one rotation vector: Baker-Campbell-Hausdorff to fourth order,
 * accurate to 1e-6 for the 20 degrees of a segment. */
static INVCAL_OFTEN void turn(invcal_real rho[3], const invcal_real th[3])
{
    const invcal_real k = INVCAL_REAL(0.5) + invcali_dot3(rho, th) / 24;
    invcal_real a[3];
    invcal_real b[3];
    invcal_real c[3];

    invcali_cross(rho, th, a);
    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        c[i] = (rho[i] - th[i]) / 12;
    }
    invcali_cross(c, a, b);
    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        rho[i] += th[i] + k * a[i] + b[i];
    }
}

/* ---- segments -------------------------------------------------------------------------------- */

/* Rounds x. Returns 0 if it is too large. */
static int pack(invcal_real x, int16_t *out)
{
    if (x > -32767 && x < 32767) {
        //@ assert \is_finite(x); // no NaN lies between two numbers
        x += x < 0 ? INVCAL_REAL(-0.5) : INVCAL_REAL(0.5);
        *out = (int16_t)x;
        return 1;
    }
    *out = 0;
    return 0;
}

/* Packs v and the coning kappa = rho - v: from these two the segment can be integrated again with
 * another M.
 * Returns 0 if either is too large. */
static int pack_segment(const invcal_real rho[3], const invcal_real v[3],
                        invcal_private_segment *out)
{
    int fits = 1;

    for (unsigned i = 0; i < 3; i++) {
        fits &= pack(v[i] / INVCAL_V_UNIT, &out->v[i]) &
                pack((rho[i] - v[i]) / INVCAL_KAPPA_UNIT, &out->kappa[i]);
    }
    return fits;
}

INVCAL_NOINLINE void invcali_unpack(const int16_t packed[3], invcal_real unit, invcal_real out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        out[i] += (invcal_real)packed[i] * unit;
    }
}

/* Merges b into a, which precedes it, if that gives at most 20 degrees. */
static int merge(invcal_private_segment *a, const invcal_private_segment *b)
{
    const unsigned samples = (a->time / 2u) + (b->time / 2u);
    invcal_real of[3][3]; /* rotations of a and of b; v of both */
    invcal_private_segment both;

    invcali_zero(of, sizeof of);
    invcali_unpack(a->v, INVCAL_V_UNIT, of[0]);
    invcali_unpack(a->v, INVCAL_V_UNIT, of[2]);
    invcali_unpack(b->v, INVCAL_V_UNIT, of[1]);
    invcali_unpack(b->v, INVCAL_V_UNIT, of[2]);
    if (invcali_dot3(of[2], of[2]) > MERGED_LIMIT || samples > MOST_SAMPLES) {
        return 0;
    }
    invcali_unpack(a->kappa, INVCAL_KAPPA_UNIT, of[0]);
    invcali_unpack(b->kappa, INVCAL_KAPPA_UNIT, of[1]);
    turn(of[0], of[1]);
    both.time = (uint16_t)(2 * samples);
    if (!pack_segment(of[0], of[2], &both)) {
        return 0;
    }
    *a = both;
    return 1;
}

/* Removes segments from..to - 1. */
static void remove_segments(invcal_private_moves *m, unsigned from, unsigned to)
{
    /* at most INVCAL_MAX_SEGMENTS steps */
    while (to < m->used && to < INVCAL_MAX_SEGMENTS && /* uncovered: a guard for the proof */
           from < INVCAL_MAX_SEGMENTS) {               /* uncovered: the same */
        for (unsigned i = 0; i < 3; i++) {
            m->segment[from].v[i] = m->segment[to].v[i];
            m->segment[from].kappa[i] = m->segment[to].kappa[i];
        }
        m->segment[from].time = m->segment[to].time;
        from++;
        to++;
    }
    m->used = (uint16_t)from;
}

static void set_fault(invcal_private_moves *m, unsigned status)
{
    if (m->fault == INVCAL_OK) {
        m->fault = (uint8_t)status;
    }
}

/* Closes the current segment. Its rounding error is carried to the next. If the table is full, the
 * oldest segment that is not merged is lost, and with it the moves to which that one and this one
 * belong. */
INVCAL_NOINLINE static void close_segment(invcal_private_moves *m, unsigned mark)
{
    if (m->used >= INVCAL_MAX_SEGMENTS && m->fixed < INVCAL_MAX_SEGMENTS) {
        m->marks = (uint8_t)(m->marks - (m->segment[m->fixed].time & 1u));
        remove_segments(m, m->fixed, m->fixed + 1u);
        set_fault(m, INVCAL_NO_SPACE);
        m->spoilt = INVCAL_NO_SPACE;
    }
    if (m->used >= INVCAL_MAX_SEGMENTS) { /* resumed from stored bytes */
        return;
    }
    invcal_private_segment *s = &m->segment[m->used];
    m->used++;
    s->time = (uint16_t)(2u * m->missing + mark);
    if (!pack_segment(m->rho, m->v, s) && m->spoilt == INVCAL_OK) {
        m->spoilt = INVCAL_MOUNTING;
    }
    for (unsigned i = 0; i < 3; i++) {
        m->v[i] -= (invcal_real)s->v[i] * INVCAL_V_UNIT;
        if (m->spoilt != INVCAL_OK) {
            m->v[i] = 0;
        }
        m->rho[i] = m->v[i];
    }
    if (m->spoilt != INVCAL_OK) {
        s->v[0] = SPOILT;
        s->kappa[0] = m->spoilt;
    }
    m->marks = (uint8_t)(m->marks + mark);
    m->missing = 0;
    m->spoilt = INVCAL_OK;
}

/* ---- rests and moves ------------------------------------------------------------------------- */

/* The device is not at rest. */
INVCAL_NOINLINE static void forget_rest(invcal_private_moves *m)
{
    m->cut = NOWHERE;
    m->still_samples = 0;
    invcali_zero(m->still, sizeof m->still);
}

/* Why a move cannot use the oldest segment that is not merged. */
static unsigned find_reason(const invcal_private_moves *m)
{
    const invcal_private_segment *s = &m->segment[m->fixed];

    return s->v[0] == SPOILT                                  ? (unsigned)s->kappa[0]
           : (invcal_real)m->samples > LONGEST_MOVE * m->rate ? INVCAL_MOVE_LONG
           : m->fixed + SPARE >= INVCAL_MAX_SEGMENTS          ? INVCAL_NO_SPACE
                                                              : INVCAL_OK;
}

/* Adds a segment of a rest. */
static void add_still(invcal_private_moves *m, const invcal_private_segment *s)
{
    if (m->cut == NOWHERE) {
        m->cut = m->fixed;
    }
    if (s->v[0] != SPOILT) {
        m->still_samples += s->time / 2u;
        invcali_unpack(s->v, INVCAL_V_UNIT, m->still);
    }
}

/* Decides about the oldest segment that is not merged. It is kept even if it belongs to a rest,
 * since the rest may yet be refused. */
static void settle(invcal_private_moves *m, int is_rest)
{
    invcal_private_segment *s = &m->segment[m->fixed];

    m->marks = (uint8_t)(m->marks - (s->time & 1u));
    m->samples += s->time / 2u;
    const unsigned reason = find_reason(m);
    if (!is_rest || s->v[0] == SPOILT) {
        set_fault(m, reason);
    }
    if (is_rest) {
        add_still(m, s);
    } else {
        forget_rest(m);
    }
    if (reason != INVCAL_OK || (m->fixed > m->first && m->fixed != m->cut && merge(s - 1, s))) {
        remove_segments(m, m->fixed, m->fixed + 1u);
    } else {
        m->fixed++;
    }
}

/* Settles all but the newest blocks. A rest, if any, began `resting` blocks ago. */
static void settle_until(invcal_private_moves *m, uint32_t newest, uint32_t resting)
{
    /* a segment each: at most INVCAL_MAX_SEGMENTS steps */
    while (m->marks > newest && m->fixed < m->used) { /* uncovered: a mark has its segment */
        settle(m, m->marks <= resting);
    }
}

/* From now on the bias of the first rest is subtracted from v. The newest blocks still contain it.
 * They are at rest, so they can be dropped. Time begins. */
static void subtract_bias(invcal_private_moves *m)
{
    const invcal_real pace = m->rate / (invcal_real)m->still_samples;

    for (unsigned i = 0; i < 3; i++) {
        m->bias[i] += m->still[i] * pace;
        m->still[i] = 0;
    }
    m->used = m->fixed;
    m->marks = 0;
    m->blocks = 0;
}

/* The oldest rest goes, and with it the move that begins there, to the next one. */
static void drop_oldest(invcal_imu *imu)
{
    invcal_private_moves *m = &imu->own;
    const unsigned segments = m->rest[1].move > 0 ? (unsigned)m->rest[1].move : 0;

    remove_segments(m, 0, segments);
    m->fixed = (uint16_t)(m->fixed - segments);
    m->first = m->fixed;
    imu->rests--;
    for (unsigned i = 0; i < imu->rests; i++) {
        memcpy(&m->rest[i], &m->rest[i + 1], sizeof m->rest[i]);
    }
    m->rest[0].move = -INVCAL_TOO_FEW;
}

/* Measures the bias of a rest. Returns whether it is far from that of the rest before, too large or
 * unknown: without a sample it is 0 / 0. */
static int measure_bias(const invcal_imu *imu, int16_t bias[3])
{
    const invcal_private_moves *m = &imu->own;
    const invcal_real pace = m->rate / INVCAL_KAPPA_UNIT / (invcal_real)m->still_samples;
    const invcal_private_still *last = &m->rest[imu->rests > 0 ? imu->rests - 1 : 0];
    int is_far = 0;

    for (unsigned i = 0; i < 3; i++) {
        is_far |= !pack(m->still[i] * pace, &bias[i]);
        const int32_t change = (int32_t)bias[i] - last->bias[i];
        is_far |= change > MOST_CHANGE || change < -MOST_CHANGE;
    }
    return is_far;
}

/* Keeps the move, which ended where the rest began. */
static void keep_move(invcal_imu *imu)
{
    invcal_private_moves *m = &imu->own;
    const unsigned end = m->cut != NOWHERE ? m->cut : m->fixed;
    const unsigned segments = end - m->first;
    int16_t bias[3];

    const int has_turned = measure_bias(imu, bias);
    set_fault(m, segments == 0              ? INVCAL_MOVE_GAP
                 : segments > MOST_SEGMENTS ? INVCAL_MOUNTING
                 : has_turned               ? INVCAL_REST_DRIFT
                                            : INVCAL_OK);
    const unsigned kept = m->fault == INVCAL_OK ? segments : 0;
    remove_segments(m, m->first + kept, m->fixed);
    m->first = (uint16_t)(m->first + kept);
    m->fixed = m->first;
    const int move = m->fault == INVCAL_OK ? (int)segments : -(int)m->fault;
    if (imu->rests == INVCAL_MAX_MOVES) {
        drop_oldest(imu);
    }
    invcal_private_still *rest = &m->rest[imu->rests];
    imu->rests++;
    memcpy(rest->bias, bias, sizeof bias);
    rest->when = m->blocks;
    rest->move = (int8_t)move;
    m->samples = 0;
    m->fault = INVCAL_OK;
    forget_rest(m);
}

void invcali_moves_restart(invcal_imu *imu)
{
    invcal_private_moves *m = &imu->own;

    invcali_zero(m, offsetof(invcal_private_moves, layout));
    m->fixed = m->first;
    m->used = m->first;
    /* no move leads to the first rest, so nothing before it is kept */
    m->fault = imu->rests > 0 ? INVCAL_MOVE_GAP : INVCAL_TOO_FEW;
}

void invcali_moves_empty(invcal_imu *imu, const invcal_calibration *nominal, invcal_real rate)
{
    invcali_copy(&imu->nominal, nominal, sizeof *nominal);
    invcali_zero(&imu->own, sizeof imu->own);
    imu->rests = 0;
    imu->own.layout = INVCAL_MOVES_LAYOUT;
    imu->own.rate = rate;
    invcali_moves_restart(imu);
}

/* ---- settings -------------------------------------------------------------------------------- */

static void set_limits(invcal_private_moves *m, int32_t low, int32_t high)
{
    m->low = low;
    m->between = (uint32_t)high - (uint32_t)low - 1;
}

/* In another build the session is elsewhere: at the end of the program's structure. Where its layout
 * and its reason are in it is the same in every build. By bytes, as any size may be given. */
static void refuse_session(invcal_imu *imu, size_t size)
{
    if (size > offsetof(invcal_imu, own.rate) + sizeof imu->session) {
        uint8_t *session = (uint8_t *)imu + (size - sizeof imu->session);
        uint8_t *at = session + offsetof(invcal_session, layout);
        uint32_t layout;
        memcpy(&layout, at, sizeof layout);
        if (layout == INVCAL_SESSION_LAYOUT) {
            memset(at, 0, sizeof layout);
            session[offsetof(invcal_session, reason)] = INVCAL_OTHER_BUILD;
        }
    }
}

static invcal_status check_begin(const invcal_imu *imu, const invcal_calibration *nominal,
                                 invcal_real rate)
{
    if (!invcali_session_is_begun(&imu->session)) {
        return INVCAL_NOT_BEGUN;
    }
    if (!(rate >= INVCAL_LEAST_RATE && rate <= INVCAL_MOST_RATE)) {
        return INVCAL_BAD_RATE;
    }
    return invcali_nominal_check(nominal);
}

/* What it writes of another build is at the same place in every build. */
invcal_status invcal_imu_init_nominal(invcal_imu *imu, size_t size,
                                      const invcal_calibration *nominal, invcal_real rate)
{
    INVCAL_ASSERT(imu && nominal);
    imu->own.layout = 0;
    imu->own.fault = INVCAL_OTHER_BUILD;
    if (size != sizeof *imu) {
        refuse_session(imu, size);
        return INVCAL_OTHER_BUILD;
    }
    const invcal_status status = check_begin(imu, nominal, rate);
    if (status == INVCAL_OK) {
        invcali_moves_empty(imu, nominal, rate);
        set_limits(&imu->own, INT32_MIN, INT32_MAX);
    } else {
        imu->own.fault = INVCAL_OK;
    }
    if (status != INVCAL_NOT_BEGUN) { /* else it knows better */
        imu->session.reason = (uint8_t)status;
    }
    return status;
}

invcal_status invcal_imu_init(invcal_imu *imu, size_t size, invcal_real counts, invcal_real rate)
{
    const invcal_real k = 1 / counts;
    invcal_calibration nominal;

    invcali_zero(&nominal, sizeof nominal);
    nominal.matrix[0][0] = k;
    nominal.matrix[1][1] = k;
    nominal.matrix[2][2] = k;

    return invcal_imu_init_nominal(imu, size, &nominal, rate);
}

/* Else nothing is fed: the structure may be shorter than here. */
static int is_begun(const invcal_imu *imu)
{
    return imu->own.layout != 0;
}

invcal_status invcal_imu_set_limits(invcal_imu *imu, int32_t low, int32_t high)
{
    INVCAL_ASSERT(imu);
    if (low >= high) {
        return INVCAL_BAD_LIMITS;
    }
    set_limits(&imu->own, low, high);
    return INVCAL_OK;
}

/* ---- samples --------------------------------------------------------------------------------- */

/* A sample is the rate since the sample before: right end point rule. */
void invcal_imu_feed_gyro(invcal_imu *imu, int32_t x, int32_t y, int32_t z)
{
    INVCAL_ASSERT(imu);
    invcal_private_moves *const m = &imu->own;
    invcal_real th[3];

    const uint32_t first = (uint32_t)m->low + 1u;
    if (!is_begun(imu)) {
        return;
    }
    if ((uint32_t)x - first >= m->between || (uint32_t)y - first >= m->between ||
        (uint32_t)z - first >= m->between) {
        m->spoilt = INVCAL_REST_CLIPPED;
    }
    invcal_apply(&imu->nominal, (invcal_real)x, (invcal_real)y, (invcal_real)z, th);
    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        th[i] = (th[i] - m->bias[i]) / m->rate;
        m->v[i] += th[i];
    }
    turn(m->rho, th);
    m->missing++;
    if (!(invcali_dot3(m->v, m->v) < UNMERGED_LIMIT) || m->missing == MOST_SAMPLES) {
        close_segment(m, 0);
    }
}

void invcali_imu_follow(invcal_imu *imu, invcal_event event)
{
    invcal_private_moves *m = &imu->own;
    const invcal_private_rests *rests = &imu->session.rests;

    close_segment(m, 1);
    m->blocks = (uint16_t)(m->blocks + (m->blocks < UINT16_MAX));
    const unsigned bits = rests->bits;
    /* A refused rest counts as rest until eight blocks of motion have passed. */
    const uint32_t resting = (rests->time - rests->begin) >> bits;
    const int has_rest = event == INVCAL_READY || event == INVCAL_TAKEN;
    settle_until(m, has_rest ? ((rests->time - rests->end) >> bits) + CUT_OFF : LATE, resting);
    if (event == INVCAL_READY && imu->rests == 0 && m->still_samples > 0) {
        subtract_bias(m);
    }
    if (event == INVCAL_TAKEN) {
        keep_move(imu);
    }
}

/* The reason is why it was not begun. */
static invcal_event refuse(invcal_imu *imu)
{
    if (imu->own.fault != INVCAL_OTHER_BUILD && imu->session.reason == INVCAL_OK) {
        imu->session.reason = INVCAL_NOT_BEGUN;
    }
    return INVCAL_REFUSED;
}

invcal_event invcal_imu_feed(invcal_imu *imu, int32_t x, int32_t y, int32_t z)
{
    INVCAL_ASSERT(imu);
    if (imu->own.layout != INVCAL_MOVES_LAYOUT) {
        return refuse(imu);
    }
    const invcal_event event = invcal_session_feed(&imu->session, x, y, z);
    if (event != INVCAL_NOTHING) {
        invcali_imu_follow(imu, event);
    }
    return event;
}

void invcal_imu_gap(invcal_imu *imu)
{
    INVCAL_ASSERT(imu);
    if (is_begun(imu)) {
        invcal_session_gap(&imu->session);
        imu->own.spoilt = INVCAL_MOVE_GAP;
        close_segment(&imu->own, 0);
    }
}

invcal_status invcal_imu_move_reason(const invcal_imu *imu, unsigned rest)
{
    INVCAL_ASSERT(imu && rest < imu->rests);
    return imu->own.rest[rest].move < 0 ? (invcal_status)-imu->own.rest[rest].move : INVCAL_OK;
}
