/* SPDX-License-Identifier: MIT */
#include "invcal/expert.h"

#include <limits.h>
#include <string.h>

#include "vector.h"

/* Every constant is a time, a ratio or a probability; none has a unit of the sensor.
 *
 * Distances and noise are squared, and sums over the three axes, throughout. They are compared as
 * levels, logarithms to base 2: what would be a factor is a difference, and 16 bits hold whatever
 * int32 can bring about. */
#define OCTAVE 128        /* a factor of 2 */
#define ONE (32 * OCTAVE) /* the level of 1 count^2 */
#define NONE 0            /* nothing is known yet: less than any level */

/* Times. A block is about 1/8 s: shorter than a move, long enough to hold some samples. */
enum {
    BITS_MIN = 2,   /* 4 samples: three axes then give nine degrees of freedom to a variance */
    LEAST = 4,      /* blocks that make a position, or more where they last less than 0.6 s */
    TRIM = 2,       /* newest blocks held back: motion begins before it is noticed, 0.3 s */
    HOLD = 4,       /* more blocks in a row that disagree end a rest: knocks are shorter */
    ELSEWHERE = 2,  /* the same where the device rests elsewhere already */
    RELEARN = 4,    /* blocks in a row of another, steady noise are a new noise level, 0.6 s; */
    RECONSIDER = 8, /* after a position at the old one, 1.2 s: a hand's fumbling is shorter */
    SEEK = 255,     /* blocks without a smaller change than the quantum: it is known, 30 s */
    FREEZE = 8,     /* blocks in a row without any noise: the sensor is not read, 1.2 s */
    FADE = 4,       /* the trend forgets: 1 << FADE blocks count, 2 s, as long as a short rest */
    SETTLED = 12,   /* blocks after which a trend is known well enough to be followed, 1.8 s */
    DRIFTING = 10   /* blocks in a row of a rest that drifts, until it is refused: 1.5 s */
};

/* Noise. The level is a quantile: the steps up and down balance where 30 % of the blocks lie below,
 * so a third of all blocks at rest is enough to learn it. */
enum {
    RISE = 18,              /* 1.1 */
    FALL = 41,              /* 1 / 0.8 */
    FAR_BELOW = 2 * OCTAVE, /* what came before moved: no noise is that uneven */
    QUIET = 297,            /* 5 times the level: chance is 2e-4 for 9 degrees of freedom */
    HARD = 331,             /* 6 times what is allowed: motion, not a hand's unrest */
    ALIKE = 203,            /* variances of blocks of one noise level differ less: 3 times */
    HIDDEN = -2 * OCTAVE,   /* readings that toggle between two counts vary by up to 1/4 count^2
                               on each axis: a noise that is smaller hides in them */
    ALIVE = 609             /* 27: where noise is three counts an axis, none can stand still */
};

/* Place. A block mean belongs to the rest within the largest of */
enum {
    OF_NOISE = OCTAVE - QUIET, /* 2 times the variance of a sample: chance is 7e-4 for 4 samples, */
    OF_WANDER = 594,           /* 5 usual steps of a hand: 25, */
    OF_REACH = -16 * OCTAVE,   /* 1/256 of the reach: 8 mg of 2 g, */
    OF_QUANTUM = 203           /* one count on each axis: 3. */
};

/* Drift: a slope beyond chance, and fast. */
enum {
    BEYOND_CHANCE = 69,             /* 8 / 5.5, see is_drifting */
    NOISE_PER_SECOND = 203,         /* 3 sigma of an axis in a second: 9/3 */
    REACH_PER_SECOND = -19 * OCTAVE /* 1/720 of the reach in a second */
};

#define WIDE (INT32_C(1) << 19) /* counts: no noise is so large, and no rest creeps so far */
#define FINE 8                  /* bits behind the point of a mean */
#define TWO_TO_32 INVCAL_REAL(4294967296.0)
#define HOUR (UINT32_C(3600) * 125) /* in 1/125 s */

/* A rest is looked for; one was taken by the newest block; one is going on; is said to be READY; is
 * said to be refused. */
enum { IDLE, LEFT, SETTLING, ANNOUNCED, DISMISSED };

/* Bits of flags: of the stream, */
enum {
    TAKEN = 1, /* there has been a position: `place` is one */
    /* of the candidate, */
    CLIPPED = 2,     /* some sample was at a rail */
    INTERRUPTED = 4, /* samples were lost in it */
    CHANGED = 8,     /* the x axis has changed inside a block of it; y and z in the next bits */
    ALL_CHANGED = 7 * CHANGED
};

/* and of the block, in `seen`. */
enum { AT_RAIL = 1, WILD = 2 };

/* What a block does to the rest: nothing that is known yet, or motion; the sensor is not read; it is
 * quiet, but passed over; it belongs to the rest; it ends it. */
typedef enum { MOVED, DEAD, PASSED, ADDED, ENDED } verdict;

/* Where a block is, relative to origin. */
typedef struct {
    int32_t sum[3];
    int32_t mean[3]; /* 1/256 counts */
} location;

/* What it shows. */
typedef struct {
    uint64_t variance; /* inside of it, 1/64 counts^2 */
    int level;         /* of the variance */
    int limit;         /* of a quiet block's level */
    int quiet;         /* noise and no more */
    int fits;          /* not too far from origin */
    int here;          /* where the rest expects it */
    int hard;          /* far from being quiet, or from here */
} finding;

/* ---- numbers ------------------------------------------------------------------------------ */

static int larger(int a, int b)
{
    return a > b ? a : b;
}

static uint32_t smaller(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static uint32_t magnitude(int32_t x)
{
    return x < 0 ? ~(uint32_t)x + 1u : (uint32_t)x;
}

/* What stands for a negative number modulo 2^32 is that number. */
static int32_t as_signed(uint32_t x)
{
    return x <= INT32_MAX ? (int32_t)x : -(int32_t)~x - 1;
}

/* x / 2^bits, towards 0: the same for both signs. */
static int32_t shifted(int32_t x, unsigned bits)
{
    const uint32_t size = magnitude(x) >> bits;

    return x < 0 ? -(int32_t)size : (int32_t)size;
}

/* |a - b| */
static uint32_t between(int32_t a, int32_t b)
{
    return a >= b ? (uint32_t)a - (uint32_t)b : (uint32_t)b - (uint32_t)a;
}

/* The zeros before the first one of x > 0. */
static unsigned zeros_before(uint32_t x)
{
/* cppcheck-suppress misra-c2012-20.9 ; of limits.h */
#if defined(__GNUC__) && UINT_MAX == UINT32_MAX
    return (unsigned)__builtin_clz(x);
#else
    unsigned zeros = 0;

    for (unsigned step = 16; step > 0; step /= 2) { /* at most 5 steps */
        if (x >> (32 - step) == 0) {
            x <<= step;
            zeros += step;
        }
    }
    return zeros;
#endif
}

/* To base 2, in octaves; straight between powers of two, so up to 6 % below. 0 counts as 1/2. */
static int octaves(uint32_t x)
{
    if (x == 0) {
        return -OCTAVE;
    }
    const unsigned zeros = zeros_before(x);
    return (30 - (int)zeros) * OCTAVE + (int)(x << zeros >> 24);
}

static int wide_octaves(uint64_t x)
{
    int level = 0;

    for (; x > UINT32_MAX; x >>= 4) { /* at most 8 steps */
        level += 4 * OCTAVE;
    }
    return level + octaves((uint32_t)x);
}

/* The level of a squared distance; numbers of so many bits behind the point. */
static int level_between(const int32_t a[3], const int32_t b[3], int bits)
{
    const uint32_t d[3] = {between(a[0], b[0]), between(a[1], b[1]), between(a[2], b[2])};
    const unsigned zeros = zeros_before(d[0] | d[1] | d[2] | 1);
    const unsigned shift = zeros < 17 ? 17 - zeros : 0;
    const uint32_t x = d[0] >> shift;
    const uint32_t y = d[1] >> shift;
    const uint32_t z = d[2] >> shift;

    return octaves(x * x + y * y + z * z) + ((int)shift - bits) * 2 * OCTAVE + ONE;
}

/* ---- a block ------------------------------------------------------------------------------ */

/* Its samples. */
static uint32_t samples_of(const invcal_rests *s)
{
    return UINT32_C(1) << s->bits;
}

/* The next sample begins another. */
static void drop(invcal_rests *s)
{
    s->missing = 0;
    s->span = 0;
}

/* Is the reading at a rail or beyond, or closer to one than inset? */
static int is_outside(const invcal_rests *s, int32_t raw, uint32_t inset)
{
    return (uint32_t)raw - (uint32_t)s->low - 1u - inset >= s->between - 2u * inset;
}

static void look_at_rails(invcal_rests *s, int32_t raw)
{
    if (is_outside(s, raw, 0)) {
        s->seen |= AT_RAIL;
    }
}

/* Twice the differences that are added quickly, a power of two: their squares, of three axes and a
 * whole block, stay below 2^32, and they are at most an eighth of what is between the rails. */
static uint32_t widest_span(const invcal_rests *s)
{
    const uint32_t quarter = s->between / 4 | 1u;
    const uint32_t bits = smaller(31 - zeros_before(quarter), (32u - s->bits) / 2);

    return UINT32_C(1) << bits;
}

/* Where all that is close to the first sample is off the rails too, one comparison will tell both.
 * Until the quantum is known, every sample is looked at. */
static void begin(invcal_rests *s, const int32_t raw[3])
{
    const uint32_t span = widest_span(s);

    s->missing = samples_of(s) - 1;
    if (s->quantum > 0 && s->seek > 0) {
        s->seek--;
    }
    s->span = s->seek > 0 ? 0 : (uint16_t)span;
    s->square = 0;
    s->carry = 0;
    s->seen = 0;
    INVCAL_UNROLL
    for (unsigned a = 0; a < 3; a++) {
        s->first[a] = raw[a];
        s->sum[a] = 0;
        if (is_outside(s, raw[a], span / 2)) {
            s->span = 0;
            look_at_rails(s, raw[a]);
        }
    }
    if (s->stage == LEFT) {
        s->stage = IDLE;
    }
}

/* Adds a sample whose differences d are all small: -span/2 <= d < span/2, seen at one blow as
 * d + span/2 has no bit from that of span upwards. Returns 0 if they are not. Modulo 2^32, which
 * unsigned arithmetic does everywhere alike. */
static int add_small(invcal_rests *s, const int32_t raw[3])
{
    const uint32_t span = s->span;
    const uint32_t half = span / 2;
    const uint32_t x = (uint32_t)raw[0] - (uint32_t)s->first[0];
    const uint32_t y = (uint32_t)raw[1] - (uint32_t)s->first[1];
    const uint32_t z = (uint32_t)raw[2] - (uint32_t)s->first[2];

    if (((x + half) | (y + half) | (z + half)) >= span) {
        return 0;
    }
    s->sum[0] += x;
    s->sum[1] += y;
    s->sum[2] += z;
    s->square += x * x + y * y + z * z;
    return 1;
}

/* The same for any reading: at a rail, of a large noise, or in motion; and it learns the quantum. */
static void add_reading(invcal_rests *s, unsigned a, int32_t raw)
{
    const uint32_t d = (uint32_t)raw - (uint32_t)s->first[a];
    const uint32_t size = raw >= s->first[a] ? d : ~d + 1u;

    look_at_rails(s, raw);
    if (size > 0 && (s->quantum == 0 || size < s->quantum)) {
        s->quantum = size;
        s->seek = size > 1 ? SEEK : 0;
    }
    if (size >= WIDE) {
        s->seen |= WILD;
        return;
    }
    const uint64_t square = (uint64_t)size * size + s->square;
    s->sum[a] += d;
    s->square = (uint32_t)square;
    s->carry += (uint32_t)(square >> 32);
}

/* n^2 times the variance, but for n / (n - 1). Integers, so nothing cancels. */
static uint64_t scatter_of(const invcal_rests *s)
{
    uint64_t scatter = ((uint64_t)s->carry << 32 | s->square) << s->bits;

    for (unsigned a = 0; a < 3; a++) {
        const int32_t sum = as_signed(s->sum[a]);
        const int64_t square = (int64_t)sum * sum;
        scatter -= (uint64_t)square; /* never below 0: Cauchy and Schwarz */
    }
    return scatter;
}

static void measure_block(const invcal_rests *s, uint64_t scatter, finding *f)
{
    const unsigned twice = 2u * s->bits;
    const unsigned correction = 3u * OCTAVE / 2 >> s->bits; /* n / (n - 1), nearly */

    f->variance = (scatter << 2) >> (twice - 4);
    f->level = ONE + wide_octaves(scatter) - (int)twice * OCTAVE + (int)correction;
}

/* What a sum of a block makes of a mean, 1/256 counts. */
static int32_t fine_mean(const invcal_rests *s, int32_t sum)
{
    const unsigned bits = s->bits;

    return bits > FINE ? shifted(sum, bits - FINE) : sum * (int32_t)(UINT32_C(1) << (FINE - bits));
}

/* Where is the block? 0 on an axis on which that is too far from origin; returns 0 then, too. */
static int relate(const invcal_rests *s, location *at)
{
    int fits = (s->seen & WILD) == 0;

    INVCAL_UNROLL
    for (unsigned a = 0; a < 3; a++) {
        const uint32_t size = between(s->first[a], s->origin[a]);
        const int32_t sum = as_signed(s->sum[a]);
        //@ assert -(WIDE << s->bits) <= sum <= WIDE << s->bits; // of so many, each less than WIDE
        at->sum[a] = 0;
        if (size < WIDE) {
            const int32_t off = s->first[a] > s->origin[a] ? (int32_t)size : -(int32_t)size;
            at->sum[a] = sum + off * (int32_t)samples_of(s);
        } else {
            fits = 0;
        }
        at->mean[a] = fine_mean(s, at->sum[a]);
    }
    return fits;
}

/* To the mean of this block, in whole counts. */
static void move_origin(invcal_rests *s)
{
    for (unsigned a = 0; a < 3; a++) {
        const int32_t off = shifted(as_signed(s->sum[a]), s->bits);
        s->origin[a] = as_signed((uint32_t)s->first[a] + (uint32_t)off);
    }
    s->reach = (int16_t)larger(s->reach, level_between(s->origin, s->place, 0));
}

/* Quiet blocks passed over behind motion, 0.5 s: half of what makes a position, rounded up, and
 * the one that may have begun in motion. */
static uint8_t edge_of(const invcal_rests *s)
{
    return (uint8_t)((s->least + 3u) / 2);
}

/* ---- learning from the stream ------------------------------------------------------------- */

/* At least one count. */
static int quantum_level(const invcal_rests *s)
{
    return s->quantum > 1 ? 2 * octaves(s->quantum) + ONE : ONE;
}

/* Places that differ by less are one. */
static int resolution_level(const invcal_rests *s)
{
    return larger(s->reach + OF_REACH, quantum_level(s) + OF_QUANTUM);
}

/* The noise, no smaller than what quantisation hides. */
static int noise_level(const invcal_rests *s)
{
    return larger(s->noise, quantum_level(s) + HIDDEN);
}

/* Follows a low quantile. */
static int16_t follow(int level, int x)
{
    if (level == NONE || (x >= level - FALL && x <= level + RISE)) {
        return (int16_t)x;
    }
    return (int16_t)(x > level ? level + RISE : level - FALL);
}

/* A block has so much less noise that what came before it has moved; so much less still, that a rest
 * begins anew. */
static void unlearn(invcal_rests *s, int below)
{
    if (below > FAR_BELOW) {
        s->noise = (int16_t)(s->noise - below + FAR_BELOW);
    }
    if (below > 2 * FAR_BELOW) {
        s->wander = NONE;
        s->skip = edge_of(s);
        s->stage = IDLE;
    }
}

/* A block is judged by the noise so far, and a quiet one adds to it. Where there are blocks enough
 * for a position, an odd one changes little. */
static void learn_noise(invcal_rests *s, finding *f)
{
    const int hidden = quantum_level(s) + HIDDEN;

    if (s->noise == NONE) {
        s->noise = (int16_t)f->level;
    }
    if (s->blocks < s->least) {
        unlearn(s, s->noise - larger(f->level, hidden));
    }
    f->limit = larger(s->noise, hidden) + QUIET;
    f->quiet = (s->seen & WILD) == 0 && f->level <= f->limit;
    if (f->quiet) {
        s->noise = follow(s->noise, f->level);
    }
}

/* A fan is switched on, a table instead of a hand: blocks in a row, not quiet, but of like
 * variance, and closer to origin, which without a candidate is the block before, than the noise
 * that they would be made of. Returns 1 when the new level is adopted. */
static int learn_new_noise(invcal_rests *s, const finding *f, const location *at)
{
    static const int32_t zero[3] = {0, 0, 0};
    const int d = f->level - s->other;

    if (f->quiet || !f->fits || d > ALIKE || d < -ALIKE ||
        level_between(at->mean, zero, FINE) > f->level) {
        s->run = 0;
        s->other = (int16_t)f->level;
        return 0;
    }
    s->run++;
    if (s->run < ((s->flags & TAKEN) != 0 ? RECONSIDER : RELEARN)) {
        return 0;
    }
    s->noise = s->other;
    s->run = 0;
    s->skip = 1;
    return 1;
}

/* ---- the trend of a rest ------------------------------------------------------------------ */

static uint32_t blocks_of(const invcal_rests *s)
{
    return (uint32_t)s->blocks + s->pended;
}

/* Brown's double smoothing: a fading mean, and the fading mean of that. On a slope the first lags
 * behind, the second once more, so their difference tells the slope; `spread` is that of a slope
 * of one a block. The first blocks count alike, nearly. */
static void add_trend(invcal_rests *s, const int32_t mean[3])
{
    const uint32_t blocks = blocks_of(s);
    const unsigned fade = blocks > 0 ? (unsigned)smaller(32 - zeros_before(blocks), FADE) : 0;

    INVCAL_UNROLL
    for (unsigned a = 0; a < 3; a++) {
        s->once[a] += shifted(mean[a] - s->once[a], fade);
        //@ assert -0x10000000 <= s->once[a] <= 0x10000000; // between two that are
        s->twice[a] += shifted(s->once[a] - s->twice[a], fade);
        //@ assert -0x10000000 <= s->twice[a] <= 0x10000000; // as before
    }
    const uint32_t lag = s->lag + (UINT32_C(1) << FINE);
    const uint32_t spread = s->spread + (lag >> fade);
    s->lag = (uint16_t)(lag - (lag >> fade));
    s->spread = (uint16_t)(spread - (spread >> fade));
}

/* Does the rest drift? The slope must be beyond chance, as noise and the steps between blocks tell
 * it, and fast, for the noise and for the reach: a sensor that warms up is slower.
 *
 * Of block means that scatter by v, g = spread, the slope b is known to v / (5.5 g^3), within
 * 30 %, so chance is less than 1e-4 (chi^2 of 24 for three axes) beyond b^2 g^3 = 8 / 5.5 v. A step
 * between two blocks is 2 v, and b^2 more: a quarter of it is taken for v. */
static int is_drifting(const invcal_rests *s)
{
    const int spread = octaves(s->spread) - FINE * OCTAVE;
    const int slope = level_between(s->once, s->twice, FINE) - 2 * spread;
    const int speed = slope + s->pace;
    const int noise = noise_level(s);
    const int scatter = larger(noise - s->bits * OCTAVE, s->wander - 2 * OCTAVE);

    return slope + 3 * spread > scatter + BEYOND_CHANCE && speed > noise + NOISE_PER_SECOND &&
           speed > s->reach + REACH_PER_SECOND;
}

/* ---- the candidate ------------------------------------------------------------------------ */

/* From the next block on, when those to be skipped have passed. */
static void start_candidate(invcal_rests *s)
{
    memset(s->total, 0, sizeof s->total);
    s->variance = 0;
    s->blocks = 0;
    s->pended = 0;
    s->hold = 0;
    s->drift = 0;
    s->flags &= TAKEN;
    s->stage = SETTLING;
}

/* ---- decisions ---------------------------------------------------------------------------- */

/* This pending block is safe: no motion came within TRIM blocks behind it. */
static void commit(invcal_rests *s, const int32_t sum[3])
{
    INVCAL_UNROLL
    for (unsigned a = 0; a < 3; a++) {
        s->total[a] += sum[a];
        //@ assert -UINT16_MAX * (2 * WIDE << s->bits) <= s->total[a]; // as many blocks at most
        //@ assert s->total[a] <= UINT16_MAX * (2 * WIDE << s->bits);
    }
    s->end = s->time - TRIM * samples_of(s);
    s->blocks++;
}

static void add_block(invcal_rests *s, const location *at, uint64_t variance)
{
    int32_t *oldest = s->pending[blocks_of(s) % TRIM];

    add_trend(s, at->mean);
    if (s->blocks == UINT16_MAX) { /* it has blocks enough */
        return;
    }
    if (blocks_of(s) == 0) {
        s->begin = s->time - samples_of(s);
    }
    if (s->pended < TRIM) {
        s->pended++;
    } else {
        commit(s, oldest);
    }
    memcpy(oldest, at->sum, sizeof at->sum);
    s->variance += variance;
    for (unsigned a = 0; a < 3 && (s->flags & ALL_CHANGED) != ALL_CHANGED; a++) {
        if (s->sum[a] != 0) { /* of differences to the first sample */
            s->flags = (uint8_t)(s->flags | (unsigned)CHANGED << a);
        }
    }
}

static verdict agree(invcal_rests *s, const finding *f, const location *at)
{
    if ((s->seen & AT_RAIL) != 0) {
        s->flags |= CLIPPED;
    }
    if (s->skip > 0) {
        s->skip--;
        return PASSED;
    }
    s->hold = 0;
    add_block(s, at, f->variance);
    return ADDED;
}

/* A knock passes, motion does not; and another place is quiet, but not here. What comes next after
 * a hard blow is not trusted. */
static verdict disagree(invcal_rests *s, const finding *f)
{
    s->hold++;
    if (f->hard) {
        s->skip = edge_of(s);
    }
    return s->hold <= (f->quiet && f->hard ? ELSEWHERE : HOLD) ? MOVED : ENDED;
}

/* Where would the rest have this block? A settled one may drift slowly: its trend is followed. */
static void expect(const invcal_rests *s, finding *f, const location *at)
{
    const int level =
        larger(resolution_level(s), larger(f->limit + OF_NOISE, s->wander + OF_WANDER));
    const int is_settled = blocks_of(s) >= SETTLED;
    int32_t expected[3];

    for (unsigned a = 0; a < 3; a++) {
        expected[a] = s->once[a] + is_settled * (s->once[a] - s->twice[a]);
    }
    const int jump = blocks_of(s) > 0 ? level_between(at->mean, expected, FINE) : NONE;
    f->here = f->fits && jump <= level;
    f->hard = !f->fits || f->level > f->limit + HARD || jump > level + HARD;
}

static void learn_wander(invcal_rests *s, const finding *f, const location *at)
{
    const int32_t *newest = s->pending[(blocks_of(s) + 1) % TRIM];

    if (f->quiet && f->fits && s->pended > 0 && s->hold == 0) {
        s->wander = follow(s->wander, level_between(at->sum, newest, s->bits));
    }
}

static verdict judge_moment(invcal_rests *s, finding *f, location *at)
{
    f->quiet |= learn_new_noise(s, f, at);
    if (s->stage == IDLE || blocks_of(s) == 0) {
        move_origin(s);
        f->fits = relate(s, at);
    }
    if (s->stage == IDLE) {
        if (!f->quiet) {
            return MOVED;
        }
        start_candidate(s);
    }
    expect(s, f, at);
    learn_wander(s, f, at);
    return f->quiet && f->here ? agree(s, f, at) : disagree(s, f);
}

/* No noise at all, though the stream has shown some that would not allow it; or three axes that
 * read the same number: no triad does. */
static int is_dead(const invcal_rests *s, uint64_t scatter)
{
    const int32_t *first = s->first;

    return scatter == 0 && (s->seen & WILD) == 0 &&
           (s->noise > quantum_level(s) || (first[0] == first[1] && first[1] == first[2]));
}

/* Apart from what is then done, for the sake of the stack. */
INVCAL_APART static verdict judge(invcal_rests *s)
{
    const uint64_t scatter = scatter_of(s);
    location at;
    finding f;

    if (is_dead(s, scatter)) {
        return DEAD;
    }
    s->frozen = 0;
    if (s->noise == NONE) {
        memcpy(s->place, s->first, sizeof s->place);
    }
    measure_block(s, scatter, &f);
    f.fits = relate(s, &at);
    learn_noise(s, &f);
    return judge_moment(s, &f, &at);
}

/* ---- events ------------------------------------------------------------------------------- */

/* Is this the position taken last? */
static int is_same(const invcal_rests *s)
{
    return (s->flags & TAKEN) != 0 && level_between(s->origin, s->place, 0) < resolution_level(s);
}

/* Has nothing ever changed, or one axis not, among others of a noise that it cannot be without? */
static int is_stuck(const invcal_rests *s)
{
    const int own = wide_octaves(s->variance) - octaves(blocks_of(s)) + ONE - 6 * OCTAVE;

    return s->quantum == 0 ||
           ((s->flags & ALL_CHANGED) != ALL_CHANGED && own > quantum_level(s) + ALIVE);
}

static invcal_status too_short(const invcal_rests *s)
{
    return (s->flags & INTERRUPTED) != 0 ? INVCAL_REST_GAP : INVCAL_REST_SHORT;
}

/* What is wrong with the candidate, drift aside. */
static invcal_status fault(const invcal_rests *s)
{
    if (s->blocks < s->least) {
        return too_short(s);
    }
    if ((s->flags & CLIPPED) != 0) {
        return INVCAL_REST_CLIPPED;
    }
    if (is_stuck(s)) {
        return INVCAL_REST_FROZEN;
    }
    if (is_same(s)) {
        return INVCAL_REST_SAME;
    }
    return s->blocks < s->dwell ? too_short(s) : INVCAL_OK;
}

/* Nothing is refused twice. */
static int is_said(const invcal_rests *s, invcal_status why)
{
    return s->stage == DISMISSED && s->reason == (uint8_t)why;
}

/* The rest is over. A faint one is not worth a word. */
static invcal_event finish(invcal_rests *s)
{
    invcal_status why = fault(s);

    if (why == INVCAL_OK && s->stage != ANNOUNCED && is_drifting(s)) {
        why = INVCAL_REST_DRIFT;
    }
    const int is_nothing = s->blocks < s->least / 4u || is_said(s, why);
    s->stage = IDLE;
    s->skip = edge_of(s);
    if (is_nothing) {
        return INVCAL_MOVING;
    }
    s->reason = (uint8_t)why;
    if (why != INVCAL_OK) {
        return INVCAL_REFUSED;
    }
    memcpy(s->place, s->origin, sizeof s->place);
    s->flags |= TAKEN;
    s->stage = LEFT;
    return INVCAL_TAKEN;
}

static invcal_event drifting(invcal_rests *s)
{
    s->drift++;
    if (s->drift < DRIFTING) {
        return INVCAL_SETTLING;
    }
    move_origin(s);
    start_candidate(s);
    s->skip = edge_of(s);
    s->reason = INVCAL_REST_DRIFT;
    return INVCAL_REFUSED;
}

/* Is there news of the candidate? */
static invcal_event announce(invcal_rests *s)
{
    if (s->blocks < s->least) {
        return INVCAL_SETTLING;
    }
    if (is_drifting(s)) {
        return drifting(s);
    }
    s->drift = 0;
    if (s->stage == ANNOUNCED) {
        return INVCAL_SETTLING;
    }
    const invcal_status why = fault(s);
    if (is_said(s, why) || why == too_short(s)) {
        return INVCAL_SETTLING;
    }
    s->reason = (uint8_t)why;
    s->stage = why == INVCAL_OK ? ANNOUNCED : DISMISSED;
    return why == INVCAL_OK ? INVCAL_READY : INVCAL_REFUSED;
}

static invcal_event freeze(invcal_rests *s)
{
    if (s->frozen < UINT8_MAX) {
        s->frozen++;
    }
    if (s->stage != IDLE && ++s->hold > HOLD) {
        return finish(s);
    }
    if (s->frozen != FREEZE) {
        return INVCAL_MOVING;
    }
    s->reason = INVCAL_REST_FROZEN;
    return INVCAL_REFUSED;
}

/* A block is full. */
INVCAL_APART static invcal_event decide(invcal_rests *s)
{
    invcal_event event = INVCAL_MOVING;

    drop(s);
    s->time += samples_of(s);
    switch (judge(s)) {
    case ADDED:
        event = announce(s);
        break;
    case PASSED:
        event = INVCAL_SETTLING;
        break;
    case ENDED:
        event = finish(s);
        break;
    case DEAD:
        event = freeze(s);
        break;
    default:
        break;
    }
    return event;
}

/* A sample that begins a block, that is not close to its first, or that may tell the quantum. */
INVCAL_APART static invcal_event feed_any(invcal_rests *s, const int32_t raw[3])
{
    if (s->missing == 0) {
        begin(s, raw);
        return INVCAL_NOTHING;
    }
    s->span = 0; /* the squares may be large now */
    for (unsigned a = 0; a < 3; a++) {
        add_reading(s, a, raw[a]);
    }
    s->missing--;
    return s->missing > 0 ? INVCAL_NOTHING : decide(s);
}

/* ---- what is called ----------------------------------------------------------------------- */

invcal_status invcal_rests_init(invcal_rests *rests, unsigned rate)
{
    INVCAL_ASSERT(rests);
    if (rate < INVCAL_RATE_MIN || rate > INVCAL_RATE_MAX) {
        return INVCAL_BAD_RATE;
    }
    memset(rests, 0, sizeof *rests);
    rests->rate = (uint16_t)rate;
    rests->bits = BITS_MIN;
    while (11u << rests->bits < rate) { /* at most 8 steps: a block is 1/11 to 2/11 s */
        rests->bits++;
    }
    const int pace = octaves(rate) - rests->bits * OCTAVE;
    const unsigned blocks = (5 * rate / 8 + (1u << rests->bits) - 1) >> rests->bits;
    rests->pace = (int16_t)(2 * pace);
    rests->least = (uint8_t)(blocks > LEAST ? blocks : LEAST);
    rests->dwell = rests->least;
    rests->skip = edge_of(rests);
    rests->seek = SEEK;
    return invcal_rests_rails(rests, INT32_MIN, INT32_MAX);
}

invcal_status invcal_rests_rails(invcal_rests *rests, int32_t low, int32_t high)
{
    INVCAL_ASSERT(rests);
    if (low >= high) {
        return INVCAL_BAD_RAILS;
    }
    rests->low = low;
    rests->between = (uint32_t)high - (uint32_t)low - 1;
    return INVCAL_OK;
}

void invcal_rests_hold(invcal_rests *rests, uint32_t milliseconds)
{
    INVCAL_ASSERT(rests);
    const uint32_t time = milliseconds / 8 + 1; /* in 1/125 s */
    const uint32_t samples = smaller(time, HOUR) * rests->rate / 125;
    const uint32_t blocks = (samples >> rests->bits) + 1;
    rests->dwell = (uint16_t)(blocks > rests->least ? blocks : rests->least);
    if (rests->stage == ANNOUNCED && rests->blocks < rests->dwell) {
        rests->stage = SETTLING;
    }
}

invcal_event invcal_rests_feed(invcal_rests *rests, const int32_t raw[3])
{
    INVCAL_ASSERT(rests && raw);
    if (!add_small(rests, raw)) {
        return feed_any(rests, raw);
    }
    rests->missing--;
    return rests->missing > 0 ? INVCAL_NOTHING : decide(rests);
}

void invcal_rests_gap(invcal_rests *rests)
{
    INVCAL_ASSERT(rests);
    drop(rests);
    rests->flags |= INTERRUPTED;
}

invcal_event invcal_rests_finish(invcal_rests *rests)
{
    INVCAL_ASSERT(rests);
    drop(rests);
    return rests->stage > LEFT ? finish(rests) : INVCAL_MOVING;
}

unsigned invcal_rests_progress(const invcal_rests *rests)
{
    INVCAL_ASSERT(rests);
    if (rests->stage <= LEFT) {
        return 0;
    }
    if (rests->stage == ANNOUNCED) {
        return 100;
    }
    if (rests->blocks >= rests->dwell) {
        return 99;
    }
    const uint32_t percent = UINT32_C(100) * rests->blocks / rests->dwell;
    return (unsigned)percent;
}

invcal_status invcal_rests_reason(const invcal_rests *rests)
{
    INVCAL_ASSERT(rests);
    return (invcal_status)rests->reason;
}

int invcal_rests_get(const invcal_rests *rests, invcal_rest *out)
{
    INVCAL_ASSERT(rests && out);
    if (rests->stage != ANNOUNCED && rests->stage != LEFT) {
        return 0;
    }
    const uint32_t size = samples_of(rests);
    const uint32_t degrees = blocks_of(rests) * 3 * (size - 1); /* of freedom, less than 2^28 */
    const invcal_real squares = (invcal_real)(uint32_t)(rests->variance >> 32) * TWO_TO_32 +
                                (invcal_real)(uint32_t)rests->variance;
    out->count = rests->blocks * size;
    for (unsigned a = 0; a < 3; a++) {
        out->sum[a] = rests->total[a] + (int64_t)rests->origin[a] * (int64_t)out->count;
    }
    out->begin = rests->begin;
    out->end = rests->end;
    out->variance = squares * (invcal_real)size / 64 / (invcal_real)degrees;
    return 1;
}

/* ---- the mean ----------------------------------------------------------------------------- */

/* 32 more bits of a quotient: of rest and the bits of next behind it, by n > rest. What is left is
 * the rest. A division of 64 bits would be the compiler's, many times as large. */
static uint32_t long_divide(uint32_t *rest, uint32_t next, uint32_t n)
{
    uint32_t quotient = 0;

    for (unsigned i = 0; i < 32; i++) {
        const uint32_t carry = *rest >> 31;
        *rest = *rest << 1 | next >> 31;
        next <<= 1;
        quotient <<= 1;
        if (carry != 0 || *rest >= n) {
            *rest -= n;
            quotient |= 1;
        }
    }
    return quotient;
}

static invcal_real mean_of(int64_t sum, uint32_t n)
{
    const uint64_t size = sum < 0 ? ~(uint64_t)sum + 1u : (uint64_t)sum;
    uint32_t rest = (uint32_t)(size >> 32);

    if (rest >= n) {
        return 0;
    }
    const uint32_t whole = long_divide(&rest, (uint32_t)size, n);
    const invcal_real mean = (invcal_real)whole + (invcal_real)rest / (invcal_real)n;
    return sum < 0 ? -mean : mean;
}

void invcal_rest_mean(const invcal_rest *rest, invcal_real mean[3])
{
    INVCAL_ASSERT(rest && mean);
    for (unsigned a = 0; a < 3; a++) {
        mean[a] = mean_of(rest->sum[a], rest->count);
    }
}
