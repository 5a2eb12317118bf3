/* SPDX-License-Identifier: MIT */
#include "invcal/still.h"

#include <string.h>

#include "vector.h"

/* Every constant is a time, a ratio or a probability; none has a unit of the sensor.
 * Distances and noise are squared, and sums over the three axes, throughout. */

/* Times. A block is 1/8 s: shorter than a move, long enough to hold some samples. */
#define BLOCKS_PER_SECOND INVCAL_REAL(8.0)
enum {
    BLOCK_MIN = 4,  /* samples: three axes then give nine degrees of freedom to a variance */
    DWELL = 5,      /* committed blocks that make a position, 0.6 s */
    DWELL_MIN = 4,  /* the same where blocks of BLOCK_MIN samples last longer */
    TRIM = 2,       /* newest blocks held back: motion begins before it is noticed, 0.25 s */
    HOLD = 4,       /* more blocks in a row that disagree end a rest, 0.6 s: knocks are shorter */
    ELSEWHERE = 2,  /* the same where the device rests elsewhere already, 0.4 s */
    RELEARN = 4,    /* blocks in a row of another, steady noise are a new noise level, 0.5 s; */
    RECONSIDER = 8, /* after a position at the old one, 1 s: a hand's fumbling is shorter */
    FREEZE = 8,     /* blocks in a row without any noise: the sensor is not read, 1 s */
    SETTLED = 24,   /* blocks after which a trend is known well enough to be followed, 3 s */
    DRIFTING = 12   /* blocks in a row of a rest that drifts, until it is refused: 1.5 s */
};

/* The trend forgets: 16 blocks count, 2 s, as long as a short rest. */
#define FADE INVCAL_REAL(0.9375)

/* Noise. The level is a quantile: 1.1 up and 0.8 down balance where 30 % of the blocks lie below,
 * so a third of all blocks at rest is enough to learn it. */
#define RISE INVCAL_REAL(1.1)
#define FALL INVCAL_REAL(0.8)
#define FAR_BELOW (INVCAL_REAL(1.0) / 16) /* the first block moved: no noise is that uneven */
#define DROP INVCAL_REAL(0.25)            /* then fall faster */
#define QUIET 5 /* times the level: chance is 2e-4 for 9 degrees of freedom, 2e-8 for 18 */
#define HARD 6  /* times what is allowed, 2.4 times the distance: motion, not a hand's unrest */
#define ALIKE 3 /* variances of blocks of one noise level differ less */

/* Place. A block mean belongs to the rest within the largest of */
#define NEAR_NOISE 2   /* the variance of a sample: chance is 7e-4 for 4 samples, nil from 8 on, */
#define NEAR_WANDER 25 /* 5 usual steps of a hand, */
#define NEAR_REACH (INVCAL_REAL(1.0) / INVCAL_REAL(65536.0)) /* 1/256 of the reach: 8 mg of 2 g, */
#define NEAR_QUANTUM 3                                       /* one count on each axis. */

/* Quantisation. Readings that toggle between two counts have a variance of up to 1/4 on each axis;
 * a noise that is smaller than that hides in them. */
#define COARSE (INVCAL_REAL(1.0) / 4)

/* Where noise is three counts an axis, none of the three can stand still for a rest. */
#define ALIVE 27

/* Drift: a slope beyond chance, and fast over the dwell time, 5/8 s: */
#define MANY_SCATTERS 12 /* times the scatter: chi^2 of 36 for three axes, P = 7e-8; */
#define DRIFT_NOISE (INVCAL_REAL(75.0) / 64) /* 3 sigma of an axis in a second: 9/3 (5/8)^2; */
#define DRIFT_REACH INVCAL_REAL(6.1e-7)      /* 1/800 of the reach in a second: (5/8/800)^2 */

/* A rest is looked for; going on; said to be READY; said to be refused. */
enum { IDLE, SETTLING, ANNOUNCED, DISMISSED };

/* Bits of flags: of the stream, */
enum {
    TAKEN = 1, /* there has been a position: `place` is one */
    /* and of the candidate */
    BEGUN = 2,       /* its first block has been left out */
    CLIPPED = 4,     /* some sample was at a rail */
    INTERRUPTED = 8, /* samples were lost in it */
    CHANGED = 16,    /* the x axis has changed inside a block of it; y and z in the next bits */
    ALL_CHANGED = 7 * CHANGED
};

/* What one block shows. */
typedef struct {
    int64_t sum[3];       /* relative to origin */
    invcal_real mean[3];  /* likewise */
    invcal_real variance; /* inside of it */
    invcal_real limit;    /* of a quiet block's variance */
    invcal_real step;     /* distance from the block before */
    int quiet;            /* noise and no more */
    int near;             /* where the rest expects it */
    int hard;             /* far from being quiet, or from near */
} finding;

static invcal_real larger(invcal_real a, invcal_real b)
{
    return a > b ? a : b;
}

static invcal_real distance(const invcal_real a[3], const invcal_real b[3])
{
    const invcal_real d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};

    return invcal_dot(d, d, 3);
}

static uint32_t blocks_of(const invcal_still *s)
{
    return (uint32_t)s->blocks + s->pended;
}

/* Quiet blocks passed over behind motion, 0.4 s: half the dwell, rounded up. */
static unsigned edge_of(const invcal_still *s)
{
    return (s->dwell + 1u) / 2;
}

static invcal_real squared_quantum(const invcal_still *s)
{
    const invcal_real quantum = (invcal_real)s->block.quantum;

    return quantum * quantum;
}

/* The noise, no smaller than what quantisation hides. */
static invcal_real noise_level(const invcal_still *s)
{
    return larger(s->noise, COARSE * squared_quantum(s));
}

/* ---- learning from the stream ------------------------------------------------------------- */

/* Follows a low quantile of x in steps that are ratios. */
static invcal_real follow(invcal_real level, invcal_real x)
{
    if (level < 0) {
        return x;
    }
    if (x < level) {
        return larger(x, level * (x < level * FAR_BELOW ? DROP : FALL));
    }
    return x < level * RISE ? x : level * RISE;
}

static void learn_reach(invcal_still *s, const finding *f)
{
    invcal_real place[3];

    for (unsigned a = 0; a < 3; a++) {
        place[a] = (invcal_real)((int64_t)s->place[a] - s->origin[a]);
    }
    s->reach = larger(s->reach, distance(f->mean, place));
}

/* A quiet block is judged by the noise so far, and then adds to it. */
static void learn_noise(invcal_still *s, finding *f)
{
    if (s->noise < 0) {
        s->noise = f->variance;
    }
    f->limit = QUIET * noise_level(s);
    f->quiet = !s->block.wild && f->variance <= f->limit;
    if (f->quiet) {
        s->noise = follow(s->noise, f->variance);
    }
}

/* A fan is switched on, a table instead of a hand: blocks in a row, not quiet, but of like
 * variance, and nearer to each other than the noise that they would be made of. Returns 1 when
 * the new level is adopted. */
static int learn_new_noise(invcal_still *s, const finding *f)
{
    const invcal_real v = f->variance;

    if (f->quiet || s->block.wild || f->step > v || v > ALIKE * s->other || s->other > ALIKE * v) {
        s->run = 0;
        s->other = v;
        return 0;
    }
    s->run++;
    s->other += (v - s->other) / (invcal_real)(s->run + 1);
    if (s->run < (s->flags & TAKEN ? RECONSIDER : RELEARN)) {
        return 0;
    }
    s->noise = s->other;
    s->run = 0;
    return 1;
}

/* ---- the trend of a rest ------------------------------------------------------------------ */

/* Adds a block mean at time 0; what was there moves to -1, -2 ... and fades. */
static void trend_add(invcal_trend *t, const invcal_real mean[3])
{
    const invcal_real old = FADE * t->weight;
    const invcal_real weight = old + 1;
    const invcal_real share = old / weight;
    const invcal_real dt = 1 - t->mean_t;

    t->var *= FADE;
    t->var_t = FADE * t->var_t + share * dt * dt;
    for (unsigned a = 0; a < 3; a++) {
        const invcal_real d = mean[a] - t->mean[a];
        t->var += share * d * d;
        t->cov[a] = FADE * t->cov[a] + share * d * dt;
        t->mean[a] += d / weight;
    }
    t->mean_t += dt / weight - 1;
    t->weight = weight;
}

/* Does the rest drift? The slope must be beyond chance, as the scatter about it tells, and fast,
 * for the noise and for the reach: a sensor that warms up is slower. */
static int is_drifting(const invcal_still *s)
{
    const invcal_trend *t = &s->trend;

    if (blocks_of(s) < DWELL_MIN) {
        return 0;
    }
    const invcal_real noise = s->variance + COARSE * squared_quantum(s);
    const invcal_real explained = invcal_dot(t->cov, t->cov, 3) / t->var_t;
    const invcal_real scatter =
        larger((t->var - explained) / (t->weight - 2), noise / (invcal_real)s->block.size);
    const invcal_real change = explained / t->var_t * (invcal_real)(s->dwell * s->dwell);

    return explained > MANY_SCATTERS * scatter && change > DRIFT_NOISE * noise &&
           change > DRIFT_REACH * s->reach;
}

/* ---- the candidate ------------------------------------------------------------------------ */

/* Where the block is, relative to origin. */
static void locate(const invcal_still *s, finding *f)
{
    const invcal_block *b = &s->block;
    const invcal_real share = 1 / (invcal_real)b->size;

    for (unsigned a = 0; a < 3; a++) {
        f->sum[a] = b->sum[a] + (int64_t)b->size * ((int64_t)b->first[a] - s->origin[a]);
        f->mean[a] = (invcal_real)f->sum[a] * share;
    }
}

/* From this block on, when `skip` quiet ones have passed. */
static void start(invcal_still *s, finding *f, unsigned skip)
{
    invcal_block_mean(&s->block, s->origin);
    locate(s, f);
    memset(s->total, 0, sizeof s->total);
    memset(&s->trend, 0, sizeof s->trend);
    s->variance = 0;
    s->blocks = 0;
    s->pended = 0;
    s->hold = 0;
    s->drift = 0;
    s->flags &= TAKEN;
    s->skip = (uint8_t)skip;
    s->stage = SETTLING;
}

/* Sums of the blocks committed. */
static void sum_rest(const invcal_still *s, invcal_rest *rest)
{
    rest->count = (uint32_t)s->blocks * s->block.size;
    for (unsigned a = 0; a < 3; a++) {
        rest->sum[a] = s->total[a] + (int64_t)s->origin[a] * (int64_t)rest->count;
    }
    rest->begin = s->begin;
    rest->end = s->end;
    rest->variance = s->variance / 3;
}

/* In whole counts: near enough to compare places. */
static void mean_of(const invcal_rest *rest, int32_t mean[3])
{
    for (unsigned a = 0; a < 3; a++) {
        mean[a] = (int32_t)(rest->sum[a] / (int64_t)rest->count);
    }
}

static int is_same(const invcal_still *s, const invcal_rest *rest)
{
    const invcal_real near = larger(NEAR_REACH * s->reach, NEAR_QUANTUM * squared_quantum(s));
    int32_t mean[3];
    invcal_real d[3];

    mean_of(rest, mean);
    for (unsigned a = 0; a < 3; a++) {
        d[a] = (invcal_real)((int64_t)mean[a] - s->place[a]);
    }
    return (s->flags & TAKEN) && invcal_dot(d, d, 3) < near;
}

/* Has nothing ever changed, or one axis not, among others of a noise that it cannot be without? */
static int is_stuck(const invcal_still *s)
{
    return s->block.quantum == 0 ||
           ((s->flags & ALL_CHANGED) != ALL_CHANGED && s->variance > ALIVE * squared_quantum(s));
}

/* What is wrong with the candidate, drift aside. */
static invcal_rest_reason fault(const invcal_still *s, invcal_rest *rest)
{
    if (s->blocks < s->dwell) {
        return s->flags & INTERRUPTED ? INVCAL_REST_GAP : INVCAL_REST_SHORT;
    }
    sum_rest(s, rest);
    if ((s->flags & CLIPPED) != 0) {
        return INVCAL_REST_CLIPPED;
    }
    if (is_stuck(s)) {
        return INVCAL_REST_FROZEN;
    }
    return is_same(s, rest) ? INVCAL_REST_SAME : INVCAL_REST_GOOD;
}

/* The rest is over. A faint one is not worth a word, and nothing is refused twice. */
static invcal_still_event finish(invcal_still *s, invcal_rest *out)
{
    const int said = s->stage == DISMISSED;
    const int drifts = is_drifting(s) && s->stage != ANNOUNCED;
    invcal_rest rest;
    invcal_rest_reason why = fault(s, &rest);

    s->stage = IDLE;
    if (why == INVCAL_REST_GOOD && drifts) {
        why = INVCAL_REST_DRIFT;
    }
    if (s->blocks < edge_of(s) || (said && s->reason == (uint8_t)why)) {
        return INVCAL_STILL_MOVING;
    }
    s->reason = (uint8_t)why;
    if (why != INVCAL_REST_GOOD) {
        return INVCAL_STILL_REFUSED;
    }
    mean_of(&rest, s->place);
    s->flags |= TAKEN;
    *out = rest;
    return INVCAL_STILL_TAKEN;
}

/* ---- decisions ---------------------------------------------------------------------------- */

/* The oldest pending block is safe: no motion came within TRIM blocks behind it. The first of a
 * rest is left out, it may have begun in motion. */
static void commit(invcal_still *s)
{
    const uint32_t trimmed = s->time - (uint32_t)TRIM * s->block.size;

    if (!(s->flags & BEGUN)) {
        s->flags |= BEGUN;
        s->begin = trimmed;
    } else if (s->blocks < UINT16_MAX) {
        for (unsigned a = 0; a < 3; a++) {
            //@ assert -UINT16_MAX * 0x80000000 <= s->total[a]; // as many as blocks at most
            //@ assert s->total[a] <= UINT16_MAX * 0x7FFFFFFF;
            s->total[a] += s->pending[0][a];
        }
        s->end = trimmed;
        s->blocks++;
    } /* cppcheck-suppress misra-c2012-15.7 ; full: it has blocks enough */
    memcpy(s->pending[0], s->pending[1], sizeof s->pending[0]);
    s->pended--;
}

static void add_reading(invcal_still *s, const finding *f)
{
    if (s->pended == TRIM) {
        commit(s);
    }
    for (unsigned a = 0; a < 3; a++) {
        s->pending[s->pended][a] = (int32_t)f->sum[a]; /* fits: see expect */
        if (s->block.sum[a] != 0) {                    /* of differences to the first sample */
            s->flags = (uint8_t)(s->flags | (unsigned)CHANGED << a);
        }
    }
    s->pended++;
    trend_add(&s->trend, f->mean);
    s->variance += (f->variance - s->variance) / (invcal_real)blocks_of(s);
}

static invcal_still_event drifting(invcal_still *s, finding *f)
{
    s->drift++;
    if (s->drift < DRIFTING) {
        return INVCAL_STILL_SETTLING;
    }
    start(s, f, edge_of(s));
    s->reason = INVCAL_REST_DRIFT;
    return INVCAL_STILL_REFUSED;
}

/* Is there news of the candidate? */
static invcal_still_event announce_still(invcal_still *s, finding *f)
{
    invcal_rest rest;

    if (s->blocks < s->dwell) {
        return INVCAL_STILL_SETTLING;
    }
    if (is_drifting(s)) {
        return drifting(s, f);
    }
    s->drift = 0;
    if (s->stage == ANNOUNCED) {
        return INVCAL_STILL_SETTLING;
    }
    const invcal_rest_reason why = fault(s, &rest);
    if (s->stage == DISMISSED && s->reason == (uint8_t)why) {
        return INVCAL_STILL_SETTLING;
    }
    s->reason = (uint8_t)why;
    s->stage = why == INVCAL_REST_GOOD ? ANNOUNCED : DISMISSED;
    return why == INVCAL_REST_GOOD ? INVCAL_STILL_READY : INVCAL_STILL_REFUSED;
}

static invcal_still_event agree(invcal_still *s, finding *f)
{
    if (s->block.clipped) {
        s->flags |= CLIPPED;
    }
    if (s->skip > 0) {
        s->skip--;
        return INVCAL_STILL_SETTLING;
    }
    s->hold = 0;
    add_reading(s, f);
    return announce_still(s, f);
}

/* A knock passes, motion does not; and another place is quiet, but not near. What comes next
 * after a hard blow is not trusted. */
static invcal_still_event disagree(invcal_still *s, finding *f, invcal_rest *out)
{
    const int elsewhere = f->quiet && f->hard;

    s->hold++;
    if (f->hard) {
        s->skip = (uint8_t)edge_of(s);
    }
    if (s->hold <= (elsewhere ? ELSEWHERE : HOLD)) {
        return INVCAL_STILL_MOVING;
    }
    const invcal_still_event event = finish(s, out);
    if (f->quiet) {
        start(s, f, edge_of(s));
    }
    return event;
}

/* Where would the rest have this block? A settled one may drift slowly: its trend is followed. */
static void expect(const invcal_still *s, finding *f)
{
    const invcal_trend *t = &s->trend;
    const invcal_real ahead = blocks_of(s) >= SETTLED ? (1 - t->mean_t) / t->var_t : 0;
    const invcal_real level =
        larger(larger(NEAR_NOISE * noise_level(s), NEAR_WANDER * s->wander),
               larger(NEAR_REACH * s->reach, NEAR_QUANTUM * squared_quantum(s)));
    invcal_real expected[3];
    int fits = 1;

    for (unsigned a = 0; a < 3; a++) {
        expected[a] = t->mean[a] + t->cov[a] * ahead;
        fits &= f->sum[a] >= INT32_MIN && f->sum[a] <= INT32_MAX;
    }
    const invcal_real jump = t->weight > 0 ? distance(f->mean, expected) : 0;
    f->near = fits && jump <= level;
    f->hard = s->block.wild || !fits || f->variance > HARD * f->limit || jump > HARD * level;
}

static invcal_still_event judge_moment(invcal_still *s, finding *f, invcal_rest *out)
{
    const int fresh = learn_new_noise(s, f);

    f->quiet |= fresh;
    if (s->stage == IDLE) {
        if (!f->quiet) {
            return INVCAL_STILL_MOVING;
        }
        start(s, f, fresh ? 0 : edge_of(s));
    }
    expect(s, f);
    if (f->quiet && s->pended > 0 && s->hold == 0) {
        s->wander = follow(s->wander, f->step);
    }
    return f->quiet && f->near ? agree(s, f) : disagree(s, f, out);
}

/* No noise at all, though the stream has shown some that would not allow it; or three axes that
 * read the same number: no triad does. */
static int is_frozen(const invcal_still *s, invcal_real variance)
{
    const int32_t *first = s->block.first;
    const int known = s->noise > squared_quantum(s);

    return !(variance > 0) && (known || (first[0] == first[1] && first[1] == first[2]));
}

static invcal_still_event freeze(invcal_still *s, invcal_rest *out)
{
    if (s->frozen < UINT8_MAX) {
        s->frozen++;
    }
    if (s->stage != IDLE && ++s->hold > HOLD) {
        return finish(s, out);
    }
    if (s->frozen != FREEZE) {
        return INVCAL_STILL_MOVING;
    }
    s->reason = INVCAL_REST_FROZEN;
    return INVCAL_STILL_REFUSED;
}

/* A block is full. */
INVCAL_APART static invcal_still_event decide(invcal_still *s, invcal_rest *out)
{
    finding f;

    s->time += s->block.size;
    f.variance = invcal_block_variance(&s->block);
    if (is_frozen(s, f.variance)) {
        return freeze(s, out);
    }
    s->frozen = 0;
    if (s->noise < 0) {
        invcal_block_mean(&s->block, s->place);
        memcpy(s->origin, s->place, sizeof s->origin);
    }
    locate(s, &f);
    f.step = distance(f.mean, s->newest);
    learn_reach(s, &f);
    learn_noise(s, &f);
    const invcal_still_event event = judge_moment(s, &f, out);
    memcpy(s->newest, f.mean, sizeof s->newest);
    return event;
}

/* ---- the room's door ---------------------------------------------------------------------- */

invcal_status invcal_still_init(invcal_still *still, invcal_real rate, int32_t low, int32_t high)
{
    INVCAL_ASSERT(still);
    const int is_rate = rate >= INVCAL_STILL_RATE_MIN && rate <= INVCAL_STILL_RATE_MAX;
    const int are_rails = low < high || (low == 0 && high == 0);
    if (!is_rate || !are_rails) {
        return INVCAL_BAD_SETTING;
    }
    //@ assert \is_finite(rate); // it has been compared
    const int unknown = low == high;
    const unsigned eighth = (unsigned)(rate / BLOCKS_PER_SECOND + INVCAL_REAL(0.5));
    const unsigned size = eighth > BLOCK_MIN ? eighth : BLOCK_MIN;
    const unsigned dwell = (DWELL * eighth + size / 2) / size;
    memset(still, 0, sizeof *still);
    still->noise = -1;
    still->wander = -1;
    still->dwell = (uint8_t)(dwell > DWELL_MIN ? dwell : DWELL_MIN);
    return invcal_block_init(&still->block, size, unknown ? INT32_MIN : low,
                             unknown ? INT32_MAX : high);
}

invcal_still_event invcal_still_push(invcal_still *still, const int32_t raw[3], invcal_rest *out)
{
    INVCAL_ASSERT(still && raw && out);
    if (!invcal_block_add(&still->block, raw)) {
        return INVCAL_STILL_NONE;
    }
    return decide(still, out);
}

void invcal_still_gap(invcal_still *still)
{
    INVCAL_ASSERT(still);
    invcal_block_drop(&still->block);
    still->flags |= INTERRUPTED;
}

invcal_still_event invcal_still_finish(invcal_still *still, invcal_rest *out)
{
    INVCAL_ASSERT(still && out);
    invcal_block_drop(&still->block);
    return still->stage != IDLE ? finish(still, out) : INVCAL_STILL_MOVING;
}

unsigned invcal_still_progress(const invcal_still *still)
{
    INVCAL_ASSERT(still);
    if (still->stage == IDLE) {
        return 0;
    }
    if (still->stage == ANNOUNCED) {
        return 100;
    }
    return still->blocks < still->dwell ? 100u * still->blocks / still->dwell : 99;
}

invcal_rest_reason invcal_still_reason(const invcal_still *still)
{
    INVCAL_ASSERT(still);
    return (invcal_rest_reason)still->reason;
}

int invcal_still_current(const invcal_still *still, invcal_rest *out)
{
    INVCAL_ASSERT(still && out);
    if (still->stage != ANNOUNCED) {
        return 0;
    }
    sum_rest(still, out);
    return 1;
}

void invcal_rest_mean(const invcal_rest *rest, invcal_real mean[3])
{
    INVCAL_ASSERT(rest && mean);
    const int64_t n = rest->count;

    for (unsigned a = 0; a < 3; a++) {
        mean[a] = 0;
        if (n > 0) {
            const int64_t whole = rest->sum[a] / n;
            mean[a] = (invcal_real)whole + (invcal_real)(rest->sum[a] % n) / (invcal_real)n;
        }
    }
}

/* Texts one after the other: a table of pointers would need relocation. */
const char *invcal_rest_reason_text(invcal_rest_reason reason)
{
    enum { UNKNOWN = INVCAL_REST_SAME + 1 };
    static const char texts[] = "good\0"
                                "too short: hold it still longer\0"
                                "readings creep: turned slowly, or not settled\0"
                                "at the end of the sensor's range\0"
                                "readings, or those of an axis, never change: is the sensor read?\0"
                                "too short: samples were lost\0"
                                "the same place as before\0"
                                "unknown reason";
    const char *text = texts;

    /* at most as many steps as there are characters */
    for (unsigned n = (unsigned)reason < UNKNOWN ? (unsigned)reason : UNKNOWN; n > 0;) {
        n -= *text++ == '\0';
    }
    return text;
}
