/* SPDX-License-Identifier: MIT
 *
 * Finds rests in a stream of raw samples (mathematics.md, "From samples to positions"), in
 * integers. Per sample: add_small or add_any. Per block of about 1/8 s: decide, which measures its
 * variance and mean, judges them against the noise and place of the rest, and lets the rest agree
 * or disagree; then its event, if any, is announced.
 *
 * Block means count from `origin`, in 1/1024 count: so they fit 32 bits wherever in the range of
 * int32 the rest is.
 */
#include "rests.h"

#include "../core/vector.h"

/* Every constant is a time, a ratio or a probability; none has a unit of the sensor.
 *
 * Distances and noise are squared, and summed over the three axes, throughout. They are compared as
 * levels, logarithms to base 2: a factor becomes a difference, and 16 bits hold the range of
 * int32. */
#define OCTAVE 128            /* a factor of 2 */
#define ONE (32 * OCTAVE)     /* the level of 1 count^2 */
#define NONE 0                /* not known yet: less than any level */
#define BEYOND (127 * OCTAVE) /* more than any level */

/* Times. A block is about 1/8 s: shorter than a move, long enough for some samples. */
enum {
    BITS_MIN = 2,  /* 4 samples: three axes then give nine degrees of freedom to a variance */
    LEAST = 4,     /* min blocks of a position, or more if they last less than 0.6 s */
    TRIM = 2,      /* newest blocks held back: motion begins before it is detected, 0.3 s */
    HOLD = 4,      /* more blocks in a row that disagree end a rest: knocks are shorter */
    ELSEWHERE = 2, /* the same if the device already rests elsewhere */
    RELEARN = 4,   /* blocks in a row of another, steady noise are a new noise level, 0.6 s; twice
                      as many after a position at the old one: a hand's fumbling is shorter */
    FREEZE = 8,    /* blocks in a row without any noise: the sensor is not read, 1.2 s */
    FADE = 4,      /* forgetting factor of the trend: 1 << FADE blocks, 2 s, a short rest */
    DRIFTING = 10  /* blocks in a row of a rest that drifts, until it is refused: 1.5 s */
};

/* Noise. The level is a quantile: the steps up and down balance with 30 % of the blocks below, so a
 * third of all blocks at rest is enough to learn it. */
enum {
    RISE = 18,              /* 1.1 */
    FALL = 41,              /* 1 / 0.8 */
    FAR_BELOW = 4 * OCTAVE, /* motion before it: no noise is that uneven */
    QUIET = 297,            /* 5 times the level: chance is 2e-4 for 9 degrees of freedom */
    HARD = 331,             /* 6 times the limit: motion, not hand tremor */
    ALIKE = 203,            /* max ratio of block variances at one noise level: 3 */
    HIDDEN = -2 * OCTAVE,   /* readings that toggle between two counts vary by up to 1/4 count^2
                               on each axis: they hide a smaller noise */
    ALIVE = 576             /* 24: where noise is nearly three counts an axis, none stands still */
};

/* Place. A block mean belongs to the rest within the largest of */
enum {
    OF_NOISE = OCTAVE,       /* 2 times the variance of a sample: chance is 4e-3 for 4 samples, */
    OF_WANDER = 594,         /* 5 usual steps of a hand: 25, */
    OF_REACH = -16 * OCTAVE, /* 1/256 of the reach: 8 mg of 2 g, */
    OF_QUANTUM = 203         /* one count on each axis: 3. */
};

/* Drift: a slope beyond chance, and fast. */
enum {
    BEYOND_CHANCE = 69,             /* 8 / 5.5, see is_drifting */
    PER_SECOND = -2313,             /* 2 log2 of 125 / 65536, see pace */
    NOISE_PER_SECOND = 203,         /* 3 sigma of an axis in a second: 9/3 */
    REACH_PER_SECOND = -19 * OCTAVE /* 1/720 of the reach in a second */
};

#define WIDE (INT32_C(1) << 19)     /* counts: more than any noise, or any creep of a rest */
#define NEAR (UINT32_C(1) << 12)    /* counts from the first sample, for the fast sum */
#define FINE 10u                    /* fraction bits of a mean: exact for any block */
#define MOST 65535u                 /* max blocks summed in a rest */
#define SHORTEST UINT32_C(163578)   /* seconds that make a position, 1/2^18: 0.624 */
#define HOUR (UINT32_C(3600) * 125) /* in 1/125 s */

/* The last event of the rest, besides the reasons for REFUSED: READY; none; TAKEN by the newest
 * block. */
enum { HELD = INVCAL_OK, SETTLING = INVCAL_STATUS_END, LEFT = INVCAL_STATUS_END + 1 };

/* Bits of flags, and of `seen`, which is the newest block's. */
enum {
    CLIPPED = 1, /* some sample was at a rail */
    LOST = 2,    /* samples were lost */
    WILD = 4,    /* some sample was too far from the first: the sums are meaningless */
    CHANGED = 8, /* the x axis has changed inside a block; y and z in the next bits */
    ALL_CHANGED = 7 * CHANGED
};

/* ---- numbers --------------------------------------------------------------------------------- */

static INVCAL_ONCE int larger(int a, int b)
{
    return a > b ? a : b;
}

static INVCAL_ONCE uint32_t smaller(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

/* A number modulo 2^32 as a signed one. */
static INVCAL_ONCE int32_t as_signed(uint32_t x)
{
    return x <= INT32_MAX ? (int32_t)x : -(int32_t)~x - 1;
}

/* |x| of a number modulo 2^32. */
static INVCAL_ONCE uint32_t size_of(uint32_t x)
{
    return x <= INT32_MAX ? x : 0u - x;
}

/* x / 2^bits, towards 0: the same for both signs. */
INVCAL_OFTEN static int32_t shifted(int32_t x, unsigned bits)
{
    const uint32_t size = size_of((uint32_t)x) >> bits;

    return as_signed(x < 0 ? 0u - size : size);
}

/* The index of the highest set bit of x, from 0; 0 for 0 too. Without an instruction for it, the
 * compiler's is a large function. */
static INVCAL_ONCE unsigned top_of(uint32_t x)
{
#ifdef __ARM_FEATURE_CLZ
    return 31u - (unsigned)__builtin_clz(x | 1);
#else
    unsigned top = 0;

    for (; x > 255; x >>= 8) { /* at most 3 steps */
        top += 8;
    }
    for (; x > 1; x >>= 1) { /* at most 7 steps */
        top++;
    }
    return top;
#endif
}

/* The logarithm to base 2, OCTAVE for a factor of 2; linear between powers of two, so up to 6 %
 * low. 0 counts as 1/2. */
INVCAL_OFTEN static int octaves(uint32_t x)
{
    const unsigned top = top_of(x);

    return ((int)top - 1) * OCTAVE + (int)(x << (31 - top) >> 24);
}

/* Adds d^2, where d is a number modulo 2^32. Without a 64-bit product of the processor, the
 * compiler's is a large function. */
INVCAL_OFTEN static void add_squared(uint64_t *sum, uint32_t d)
{
#ifdef __ARM_ARCH_6M__
    const uint32_t x = size_of(d);
    const uint32_t low = x & 0xFFFFu;
    const uint32_t high = x >> 16;

    *sum += ((uint64_t)(high * high) << 32) + low * low + ((uint64_t)(high * low) << 17);
#else
    const int64_t x = as_signed(d);

    *sum += (uint64_t)(x * x);
#endif
}

/* The level of a square whose unit is 1/2^20: a variance, the square of a mean. */
INVCAL_OFTEN static int level_of(uint64_t square)
{
    int level = ONE - 2 * FINE * OCTAVE;

    for (; square > UINT32_MAX; square >>= 4) { /* at most 8 steps */
        level += 4 * OCTAVE;
    }
    return level + octaves((uint32_t)square);
}

/* The level of the distance of the rest from the previous position. */
INVCAL_OFTEN static int distance_from_place(const invcal_private_rests *s)
{
    uint64_t square = 0;

    INVCAL_ROLL
    for (unsigned a = 0; a < 3; a++) {
        add_squared(&square, (uint32_t)s->axis[a].origin - (uint32_t)s->axis[a].place);
    }
    return level_of(square) + 2 * (int)FINE * OCTAVE;
}

/* Takes the rest as the place of the last position, or of the first rest. */
INVCAL_NOINLINE static void mark_place(invcal_private_rests *s)
{
    INVCAL_ROLL
    for (unsigned a = 0; a < 3; a++) {
        s->axis[a].place = s->axis[a].origin;
    }
}

/* ---- a block --------------------------------------------------------------------------------- */

/* After motion 0.5 s of quiet blocks are skipped: half the min of a position, rounded up, and the
 * one that may have begun in motion. */
static INVCAL_ONCE void skip(invcal_private_rests *s)
{
    s->skip = (uint8_t)((s->least + 3u) / 2);
}

/* There is no rest: look for the next one. */
INVCAL_NOINLINE static void clear_rest(invcal_private_rests *s)
{
    s->blocks = 0;
    s->pended = 0;
    s->stage = SETTLING;
    s->hold = 0;
    s->drift = 0;
    skip(s);
}

/* The samples of a block. */
static INVCAL_ONCE uint16_t samples_of(const invcal_private_rests *s)
{
    return (uint16_t)(1u << s->bits);
}

/* Drops the block: the next sample begins another. */
static INVCAL_ONCE void drop(invcal_private_rests *s)
{
    s->missing = 0;
    s->span = 0;
}

#if INVCAL_FAST
/* The fast sum is for a first sample far from the rails, with the quantum known. */
static uint32_t fast_span(const invcal_private_rests *s, const int32_t raw[3])
{
    uint32_t span = s->quantum == 1 ? 2 * NEAR : 0;

    for (unsigned a = 0; a < 3; a++) {
        const uint32_t above = (uint32_t)raw[a] - (uint32_t)s->low - 1u;
        if (above >= s->between || smaller(above, s->between - 1u - above) < NEAR) {
            span = 0;
        }
    }
    return span;
}
#endif

/* Differences are to the first sample. */
static INVCAL_ONCE void begin(invcal_private_rests *s, const int32_t raw[3])
{
    if (s->stage == LEFT) {
        clear_rest(s);
    }
    s->missing = samples_of(s);
    s->square = 0;
    s->seen = 0;
    s->span = 0;
    for (unsigned a = 0; a < 3; a++) {
        s->axis[a].first = raw[a];
        s->axis[a].sum = 0;
    }
#if INVCAL_FAST
    s->span = fast_span(s, raw);
#endif
}

/* Any sample: the first of a block, one far from it or near a rail, or one that may reduce the
 * quantum. */
INVCAL_NOINLINE static void add_any(invcal_private_rests *s, const int32_t raw[3])
{
    if (s->missing == 0) {
        begin(s, raw);
    }
    unsigned seen = s->seen;
    for (unsigned a = 0; a < 3; a++) {
        const uint32_t d = (uint32_t)raw[a] - (uint32_t)s->axis[a].first;
        const uint32_t size = raw[a] < s->axis[a].first ? 0u - d : d;
        s->axis[a].sum += d;
        add_squared(&s->square, d);
        if ((uint32_t)raw[a] - (uint32_t)s->low - 1u >= s->between) {
            seen |= CLIPPED;
        }
        if (size >= WIDE) {
            seen |= WILD;
        }
        if (size - 1u < s->quantum - 1u) { /* 0, no change or none yet, counts as more than any */
            s->quantum = size;
        }
    }
    s->seen = (uint8_t)seen;
}

#if INVCAL_FAST
/* Adds a sample whose differences d are all small: -span/2 <= d < span/2, tested at once, since
 * d + span/2 has no bit from that of span upwards. Returns 0 if they are not. Modulo 2^32, as
 * unsigned arithmetic is everywhere. */
static int add_small(invcal_private_rests *s, const int32_t raw[3])
{
    const uint32_t span = s->span;
    const uint32_t half = span / 2;
    const uint32_t x = (uint32_t)raw[0] - (uint32_t)s->axis[0].first;
    const uint32_t y = (uint32_t)raw[1] - (uint32_t)s->axis[1].first;
    const uint32_t z = (uint32_t)raw[2] - (uint32_t)s->axis[2].first;

    if (((x + half) | (y + half) | (z + half)) >= span) {
        return 0;
    }
    s->axis[0].sum += x;
    s->axis[1].sum += y;
    s->axis[2].sum += z;
    s->square += x * x + y * y + z * z;
    return 1;
}
#endif

/* The block's mean, from its first sample, and instead of the squares its variance, 1/2^20
 * counts^2, without n / (n - 1). Integers, so nothing cancels, and it is never below 0: Cauchy and
 * Schwarz. */
static INVCAL_ONCE void measure(invcal_private_rests *s)
{
    const unsigned up = 2 * FINE - s->bits; /* 10 to 18 */
    const uint32_t low = (uint32_t)s->square;
    const uint32_t high = (uint32_t)(s->square >> 32);
    uint64_t square = 0;

    INVCAL_ROLL
    for (unsigned a = 0; a < 3; a++) {
        s->axis[a].sum <<= FINE - s->bits;
        if (s->axis[a].sum != 0) {
            s->seen = (uint8_t)(s->seen | (unsigned)CHANGED << a);
        }
        add_squared(&square, s->axis[a].sum);
    }
    s->square = ((uint64_t)(high << up | low >> (32 - up)) << 32 | low << up) - square;
}

/* ---- learning from the stream ---------------------------------------------------------------- */

/* The level of the quantum; that of 1/2 count until it is known. */
static INVCAL_ONCE int quantum_level(const invcal_private_rests *s)
{
    return 2 * octaves(s->quantum) + ONE;
}

/* Places that differ by less are the same. */
INVCAL_OFTEN static int resolution_level(const invcal_private_rests *s)
{
    return larger(s->reach + OF_REACH, quantum_level(s) + OF_QUANTUM);
}

/* Follows a low quantile. */
INVCAL_OFTEN static int follow(int level, int x)
{
    if (level != NONE && x > level + RISE) {
        return level + RISE;
    }
    return larger(x, level - FALL);
}

/* A block is compared with the noise so far, at least that hidden by the quantum, and a quiet one
 * updates it. A block with far less noise, so that there was motion before, sets the level and
 * restarts the rest; but once there are enough blocks for a position, a single one changes
 * little. */
static INVCAL_ONCE void learn_noise(invcal_private_rests *s, int level, int hidden)
{
    int noise = larger(s->noise, hidden);

    if (s->noise == NONE || (s->blocks < s->least && level < noise - FAR_BELOW)) {
        noise = level;
        clear_rest(s);
    }
    s->noise = (int16_t)(level <= noise + QUIET ? follow(noise, level) : noise);
}

/* A fan is switched on, or the device moves from a hand to a table: blocks in a row, not quiet, but
 * of similar variance, and closer to where they are expected (without a rest, where the previous
 * block was) than their noise. Then that is the new noise. */
static INVCAL_ONCE void learn_new_noise(invcal_private_rests *s, int level, int jump)
{
    const int d = level - s->other;

    if (level <= s->noise + QUIET || d > ALIKE || d < -ALIKE || jump > level) {
        s->run = 0;
        s->other = (int16_t)level;
        return;
    }
    s->run++;
    if (s->run >= (unsigned)RELEARN << s->taken) {
        s->noise = s->other;
        s->run = 0;
        s->skip = 1;
    }
}

/* ---- the trend of a rest --------------------------------------------------------------------- */

/* Measures the mean of an axis from origin; without a rest, origin moves to it, in whole counts.
 * Returns the distance of the block from the trend of the rest, which may drift slowly. */
static INVCAL_ONCE uint32_t locate_axis(invcal_private_axis *x, int has_rest)
{
    uint32_t off = (uint32_t)x->first - (uint32_t)x->origin;
    const uint32_t d = x->sum + (off << FINE) - (uint32_t)x->rest.once - (uint32_t)x->rest.lag;

    if (!has_rest) {
        off = 0u - (uint32_t)shifted(as_signed(x->sum), FINE);
        x->origin = as_signed((uint32_t)x->first - off);
    }
    x->sum += off << FINE;
    return d;
}

/* The level of that distance, all axes together. */
static INVCAL_ONCE int locate(invcal_private_rests *s)
{
    uint64_t square = 0;
    int is_beyond = 0;

    INVCAL_ROLL
    for (unsigned a = 0; a < 3; a++) {
        invcal_private_axis *const x = &s->axis[a];
        is_beyond |= (uint32_t)x->first - (uint32_t)x->origin + WIDE >= 2 * WIDE;
        add_squared(&square, locate_axis(x, s->pended > 0));
    }
    return is_beyond ? BEYOND : level_of(square);
}

/* The blocks of the rest, with those held back. */
static INVCAL_ONCE uint32_t blocks_of(const invcal_private_rests *s)
{
    return (uint32_t)s->blocks + s->pended;
}

/* Brown's double exponential smoothing: an exponential mean, and the exponential mean of that. On a
 * slope the first lags, the second lags again: that lag gives the slope. */
static INVCAL_ONCE void add_mean(invcal_private_axis *x, unsigned bits, unsigned fade)
{
    x->rest.total += (uint64_t)(int64_t)shifted(x->rest.pending[0], bits);
    x->rest.pending[0] = x->rest.pending[1];
    x->rest.pending[1] = as_signed(x->sum);
    const uint32_t once = (uint32_t)x->rest.once;
    const uint32_t step = (uint32_t)shifted(as_signed(x->sum - once), fade);
    const uint32_t lag = (uint32_t)x->rest.lag + step;
    x->rest.once = as_signed(once + step);
    x->rest.lag = as_signed(lag - (uint32_t)shifted(as_signed(lag), fade));
}

/* The rest has one more block: the oldest one held back is safe now, since no motion followed it.
 * The first blocks have nearly equal weights. */
static INVCAL_ONCE void add_block(invcal_private_rests *s)
{
    const unsigned fade = (unsigned)smaller(top_of(2 * blocks_of(s) + 1), FADE);

    if (s->pended < TRIM) {
        s->pended++;
    } else {
        s->blocks++;
    }
    s->end = s->time;
    s->variance += s->square >> (2 * FINE - 6);
    INVCAL_ROLL
    for (unsigned a = 0; a < 3; a++) {
        add_mean(&s->axis[a], FINE - s->bits, fade);
    }
}

/* Does the rest drift? The slope must be significant against noise and a hand's wander, and fast,
 * for the noise and for the reach: a sensor that warms up is slower.
 *
 * On a slope of one per block the lag is g: 15 in the end, and a quarter of the number of blocks,
 * within 20 %, until then. If block means scatter by v, the variance of the slope b is
 * v / (5.5 g^3), within 30 %, so chance is less than 1e-4 (chi^2 of 24 for three axes) above
 * b^2 g^3 = 8 / 5.5 v. The wander includes the slope, up to 8 b^2 before the trend is known: so an
 * eighth of it counts as v. */
static INVCAL_ONCE int is_drifting(const invcal_private_rests *s)
{
    const int g = octaves(smaller(blocks_of(s), 60)) - 2 * OCTAVE;
    uint64_t lag = 0;
    INVCAL_ROLL
    for (unsigned a = 0; a < 3; a++) {
        add_squared(&lag, (uint32_t)s->axis[a].rest.lag);
    }
    const int slope = level_of(lag) - 2 * g;
    const int speed = slope + 2 * octaves(s->pace) + PER_SECOND;
    const int scatter = larger(s->noise - s->bits * OCTAVE, s->wander - 3 * OCTAVE);

    return slope + 3 * g > scatter + BEYOND_CHANCE &&
           speed > larger(s->noise + NOISE_PER_SECOND, s->reach + REACH_PER_SECOND);
}

/* ---- events of a rest ------------------------------------------------------------------------ */

/* Has nothing ever changed, or one axis not, although the others are too noisy for that? */
static INVCAL_ONCE int is_stuck(const invcal_private_rests *s)
{
    return s->quantum == 0 ||
           ((s->flags & ALL_CHANGED) != ALL_CHANGED && s->noise > quantum_level(s) + ALIVE);
}

/* What is wrong with it? */
INVCAL_NOINLINE static invcal_status fault(const invcal_private_rests *s)
{
    if (s->blocks >= s->least) {
        if (s->drift > 0 && s->stage != HELD) {
            return INVCAL_REST_DRIFT;
        }
        if ((s->flags & CLIPPED) != 0) {
            return INVCAL_REST_CLIPPED;
        }
        if (is_stuck(s)) {
            return INVCAL_REST_FROZEN;
        }
        if (s->taken && distance_from_place(s) < resolution_level(s)) {
            return INVCAL_REST_SAME;
        }
        if (s->blocks >= s->dwell) {
            return INVCAL_OK;
        }
    }
    return (s->flags & LOST) != 0 ? INVCAL_REST_GAP : INVCAL_REST_SHORT;
}

static INVCAL_ONCE invcal_event report(invcal_private_rests *s, invcal_status why,
                                       invcal_event event)
{
    s->reason = (uint8_t)why;
    return event;
}

/* The rest is over. A very short one is not reported. */
INVCAL_NOINLINE static invcal_event finish(invcal_private_rests *s)
{
    const invcal_status why = fault(s);
    invcal_event event = INVCAL_MOVING;

    if (why == INVCAL_OK) {
        mark_place(s);
        s->taken = 1;
        s->stage = LEFT;
        return report(s, why, INVCAL_TAKEN);
    }
    if (s->blocks >= s->least / 4 && s->stage != (uint8_t)why) { /* nothing twice */
        event = report(s, why, INVCAL_REFUSED);
    }
    clear_rest(s);
    return event;
}

/* Drift and shortness are not reported yet: the rest may settle, or become long enough. */
static INVCAL_ONCE int is_news(const invcal_private_rests *s, invcal_status why)
{
    return s->stage != HELD && s->stage != (uint8_t)why && why != INVCAL_REST_DRIFT &&
           why != INVCAL_REST_SHORT && why != INVCAL_REST_GAP;
}

/* Is there a new event of the rest? */
static INVCAL_ONCE invcal_event announce(invcal_private_rests *s)
{
    if (s->blocks >= s->least) {
        s->drift = is_drifting(s) ? (uint8_t)(s->drift + 1u) : 0;
    }
    if (s->drift == DRIFTING) {
        clear_rest(s);
        return report(s, INVCAL_REST_DRIFT, INVCAL_REFUSED);
    }
    const invcal_status why = fault(s);
    if (!is_news(s, why)) {
        return INVCAL_SETTLING;
    }
    s->stage = (uint8_t)why;
    return report(s, why, why == INVCAL_OK ? INVCAL_READY : INVCAL_REFUSED);
}

/* ---- decisions ------------------------------------------------------------------------------- */

/* A knock passes, motion does not; another place is quiet, but elsewhere. After a shock blocks are
 * not trusted at once, nor after any motion as long as there is no position. */
INVCAL_NOINLINE static invcal_event disagree(invcal_private_rests *s, int is_quiet, int excess)
{
    if (excess > HARD || (!is_quiet && s->blocks < s->least)) {
        skip(s);
    }
    s->hold++;
    return s->hold <= (is_quiet ? ELSEWHERE : HOLD) ? INVCAL_MOVING : finish(s);
}

/* The block belongs to the rest. */
static INVCAL_ONCE invcal_event agree(invcal_private_rests *s)
{
    s->flags |= s->seen;
    if (s->skip > 0) {
        s->skip--;
        return INVCAL_SETTLING;
    }
    s->hold = 0;
    if (s->blocks < MOST) {
        add_block(s);
    }
    return announce(s);
}

/* No noise, although there was some before; or the same number on all three axes, which no triad
 * delivers: the sensor is not being read. */
static INVCAL_ONCE int is_dead(const invcal_private_rests *s, int quantum)
{
    return s->square == 0 && (s->noise > quantum || (s->axis[0].first == s->axis[1].first &&
                                                     s->axis[1].first == s->axis[2].first));
}

/* A rest may begin with this block. */
static INVCAL_ONCE void look_for(invcal_private_rests *s)
{
    INVCAL_ROLL
    for (unsigned a = 0; a < 3; a++) {
        invcali_zero(&s->axis[a].rest, sizeof s->axis[a].rest);
    }
    s->variance = 0;
    s->flags = 0;
    if (s->reach == NONE) {
        mark_place(s);
    }
    s->reach = (int16_t)larger(s->reach, distance_from_place(s));
}

/* The block is alive. Returns by how much it exceeds the limits of the rest, and whether it is
 * quiet. */
static INVCAL_ONCE int judge(invcal_private_rests *s, int quantum, int *is_quiet)
{
    const int level = larger(level_of(s->square), quantum + HIDDEN);
    int jump = locate(s);

    learn_noise(s, level, quantum + HIDDEN);
    learn_new_noise(s, level, jump);
    const int excess = level - s->noise - QUIET;
    const int limit =
        larger(resolution_level(s), larger(s->noise + OF_NOISE, s->wander + OF_WANDER));
    *is_quiet = excess <= 0;
    if (s->pended == 0) {
        look_for(s);
        jump = NONE;
    } else if (*is_quiet && jump < BEYOND) {
        s->wander = (int16_t)follow(s->wander, jump);
    } /* cppcheck-suppress misra-c2012-15.7 ; there is nothing to learn */
    return larger(excess, jump - limit);
}

/* Has it been dead long enough to report, and was this not reported yet? */
static INVCAL_ONCE int is_frozen(invcal_private_rests *s)
{
    s->run++;
    return s->run >= FREEZE && s->reason != INVCAL_REST_FROZEN;
}

/* A block is full. Is it quiet, and where it is expected? */
INVCAL_NOINLINE static invcal_event decide(invcal_private_rests *s)
{
    const int quantum = quantum_level(s);
    int is_quiet = 0;
    int excess = BEYOND;

    if (s->pended == 0) {
        s->begin = s->time;
    }
    drop(s);
    s->time += samples_of(s);
    if ((s->seen & WILD) == 0) {
        measure(s);
        if (!is_dead(s, quantum)) {
            excess = judge(s, quantum, &is_quiet);
        } else if (is_frozen(s)) {
            return report(s, INVCAL_REST_FROZEN, INVCAL_REFUSED);
        } /* cppcheck-suppress misra-c2012-15.7 ; it disagrees */
    }
    return excess <= 0 ? agree(s) : disagree(s, is_quiet, excess);
}

/* ---- sums and means -------------------------------------------------------------------------- */

static INVCAL_ONCE int is_readable(const invcal_private_rests *s)
{
    return s->stage == HELD || s->stage == LEFT;
}

/* The sum of the raw samples. */
static int64_t sum_of(const invcal_private_rests *s, unsigned a)
{
    const int64_t off = (int64_t)s->axis[a].rest.total;

    //@ assert -UINT16_MAX * (2 * WIDE << s->bits) <= off; // so many at most
    //@ assert off <= UINT16_MAX * (2 * WIDE << s->bits);
    return off + (int64_t)s->axis[a].origin * (int32_t)((uint32_t)s->blocks << s->bits);
}

/* The compiler's own conversion of 64 bits takes many times the code. */
static invcal_real as_real(uint64_t x)
{
    return (invcal_real)(uint32_t)(x >> 32) * INVCAL_REAL(4294967296.0) + (invcal_real)(uint32_t)x;
}

/* ---- public functions ------------------------------------------------------------------------ */

invcal_status invcali_rests_init(invcal_private_rests *rests, invcal_real rate)
{
    INVCAL_ASSERT(rests);
    if (!(rate >= INVCAL_RATE_MIN && rate <= INVCAL_RATE_MAX)) {
        return INVCAL_BAD_RATE;
    }
    const uint32_t whole = (uint32_t)rate;
    invcali_zero(rests, sizeof *rests);
    rests->bits = BITS_MIN;
    while (11u << rests->bits < whole) { /* at most 8 steps: a block is 1/11 to 2/11 s */
        rests->bits++;
    }
    /* blocks in 1/125 s, times 65536: 33555 / 2^6 is 65536 / 125 */
    rests->pace = (uint16_t)((whole * UINT32_C(33555) >> (6 + rests->bits)) + 1);
    const uint32_t least = (whole * SHORTEST >> (18 + rests->bits)) + 1;
    rests->least = (uint8_t)(least > LEAST ? least : LEAST);
    rests->dwell = rests->least;
    clear_rest(rests);
    return invcali_rests_rails(rests, INT32_MIN, INT32_MAX);
}

invcal_status invcali_rests_rails(invcal_private_rests *rests, int32_t low, int32_t high)
{
    INVCAL_ASSERT(rests);
    if (low >= high) {
        return INVCAL_BAD_LIMITS;
    }
    rests->low = low;
    rests->between = (uint32_t)high - (uint32_t)low - 1;
    return INVCAL_OK;
}

void invcali_rests_hold(invcal_private_rests *rests, uint32_t milliseconds)
{
    INVCAL_ASSERT(rests);
    const uint32_t time = smaller(milliseconds / 8 + 1, HOUR);
    const uint32_t blocks = (time * rests->pace >> 16) + 1;
    rests->dwell = (uint16_t)(blocks > rests->least ? blocks : rests->least);
    if (rests->stage == HELD && rests->blocks < rests->dwell) {
        rests->stage = SETTLING;
    }
}

invcal_event invcali_rests_feed(invcal_private_rests *rests, const int32_t raw[3])
{
    INVCAL_ASSERT(rests && raw);
#if INVCAL_FAST
    if (!add_small(rests, raw)) {
        add_any(rests, raw);
    }
#else
    add_any(rests, raw);
#endif
    rests->missing--;
    return rests->missing > 0 ? INVCAL_NOTHING : decide(rests);
}

void invcali_rests_gap(invcal_private_rests *rests)
{
    INVCAL_ASSERT(rests);
    drop(rests);
    rests->flags |= LOST;
}

invcal_event invcali_rests_finish(invcal_private_rests *rests)
{
    INVCAL_ASSERT(rests);
    drop(rests);
    return rests->stage == LEFT ? INVCAL_MOVING : finish(rests);
}

unsigned invcali_rests_progress(const invcal_private_rests *rests)
{
    INVCAL_ASSERT(rests);
    if (rests->blocks == 0 || rests->stage == LEFT) {
        return 0;
    }
    if (rests->stage == HELD) {
        return 100;
    }
    const uint32_t percent = 100 * (uint32_t)rests->blocks / rests->dwell;
    return (unsigned)smaller(percent, 99);
}

invcal_status invcali_rests_reason(const invcal_private_rests *rests)
{
    INVCAL_ASSERT(rests);
    return (invcal_status)rests->reason;
}

int invcali_rests_get(const invcal_private_rests *rests, invcali_rest *out)
{
    INVCAL_ASSERT(rests && out);
    if (!is_readable(rests)) {
        return 0;
    }
    const uint32_t size = samples_of(rests);
    const uint32_t degrees = blocks_of(rests) * 3 * (size - 1); /* of freedom */
    out->count = (uint32_t)rests->blocks * size;
    for (unsigned a = 0; a < 3; a++) {
        out->sum[a] = sum_of(rests, a);
    }
    out->begin = rests->begin;
    out->end = rests->end - TRIM * size;
    out->variance = as_real(rests->variance) * (invcal_real)size / 64 / (invcal_real)degrees;
    return 1;
}

/* In two parts, as in as_real: a total has less than 48 bits and a sign. */
int invcali_rests_mean(const invcal_private_rests *rests, invcal_real mean[3])
{
    INVCAL_ASSERT(rests && mean);
    if (!is_readable(rests)) {
        return 0;
    }
    const invcal_real count = (invcal_real)((int32_t)((uint32_t)rests->blocks << rests->bits));
    INVCAL_ROLL
    for (unsigned a = 0; a < 3; a++) {
        const uint64_t total = rests->axis[a].rest.total;
        const invcal_real high = (invcal_real)as_signed((uint32_t)(total >> 16));
        mean[a] = (invcal_real)rests->axis[a].origin +
                  (high * 65536 + (invcal_real)(int32_t)(total & 65535)) / count;
    }
    return 1;
}
