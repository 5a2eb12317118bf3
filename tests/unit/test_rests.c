/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>
#include <string.h>

#include "invcal/expert.h"
#include "session/rests.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- a simulated sensor, and a record of what is found in its stream ------------------------- */

enum { RESTS = ROOM(128, 24) };

typedef struct {
    long begin, end; /* samples */
} window;

typedef struct {
    /* the sensor */
    double rate;   /* samples per second */
    double counts; /* per g */
    double noise;  /* g, each axis */
    double drift;  /* g/s on the x axis */
    int32_t low, high;
    unsigned stuck; /* 1, 2, 3: this axis always reads the same number */
    random_source random;
    /* transforms of its counts, which must not matter */
    int32_t scale;
    int32_t shift[3];
    unsigned order;
    /* the stream */
    invcal_private_rests detector;
    long samples;
    int32_t last[3];
    unsigned rests;
    window truth[RESTS];
    /* what was found */
    unsigned taken, ready, refused[INVCAL_STATUS_END];
    unsigned ready_before; /* since the position before */
    int is_held;           /* READY, and since then neither taken nor refused */
    unsigned seen[INVCAL_REFUSED + 1];
    invcali_rest rest[RESTS];
    uint32_t events; /* a checksum of all of them */
    unsigned progress;
} bench;

static bench b;

static void setup_rails(double rate, double counts, double noise, int32_t low, int32_t high)
{
    memset(&b, 0, sizeof b);
    b.rate = rate;
    b.counts = counts;
    b.noise = noise;
    b.low = low;
    b.high = high;
    b.scale = 1;
    b.random = random_start((uint32_t)(rate + counts));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcali_rests_init(&b.detector, (invcal_real)(unsigned)(rate + 0.5)));
    if (low < high) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_rails(&b.detector, low, high));
    }
}

static void setup(double rate, double counts, double noise)
{
    setup_rails(rate, counts, noise, 0, 0);
}

/* To the last bit of the largest reading, nearly: 4 sigma of noise are in it. */
static void check_mean(const invcali_rest *rest, const invcal_real mean[3])
{
    for (unsigned a = 0; a < 3; a++) {
        const int64_t whole = rest->sum[a] / rest->count;
        const int64_t part = rest->sum[a] - whole * rest->count;
        const double exact = (double)whole + (double)part / rest->count;
        const double largest = fabs(exact) + 4 * sqrt((double)rest->variance);
        TEST_ASSERT_DOUBLE_WITHIN(((double)INVCAL_EPSILON + 4 * DBL_EPSILON) * largest, exact,
                                  (double)mean[a]);
    }
}

/* What can be read after an event: the rest that is READY and held, or was just TAKEN. */
static void note(invcal_event event)
{
    invcali_rest rest;
    invcali_rest before;

    b.events = b.events * 31 + (uint32_t)event;
    b.seen[event]++;
    invcal_real mean[3] = {7, 8, 9};
    memset(&before, 0x5A, sizeof before);
    memcpy(&rest, &before, sizeof rest);
    const int is_there = invcali_rests_get(&b.detector, &rest);
    TEST_ASSERT_EQUAL_INT(is_there, invcali_rests_mean(&b.detector, mean));
    if (event == INVCAL_READY) {
        b.ready++;
        b.ready_before++;
        b.is_held = 1;
        TEST_ASSERT_EQUAL_UINT(1, b.ready_before);
    }
    if (event == INVCAL_TAKEN) {
        if (TEST_RAM < 65536 && b.taken == RESTS) {
            skip_large();
        }
        TEST_ASSERT_TRUE(b.taken < RESTS);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_reason(&b.detector));
        b.rest[b.taken++] = rest;
        b.ready_before = 0;
        b.is_held = 0;
    }
    if (event == INVCAL_REFUSED) {
        TEST_ASSERT_NOT_EQUAL(INVCAL_OK, invcali_rests_reason(&b.detector));
        b.refused[invcali_rests_reason(&b.detector)]++;
        b.ready_before = 0;
        b.is_held = 0;
    }
    TEST_ASSERT_EQUAL_INT(b.is_held || event == INVCAL_TAKEN, is_there);
    if (!is_there) {
        TEST_ASSERT_TRUE(memcmp(&before, &rest, sizeof rest) == 0);
        TEST_ASSERT_TRUE(mean[0] == 7 && mean[1] == 8 && mean[2] == 9);
    } else {
        check_mean(&rest, mean);
    }
}

static void push(const int32_t raw[3])
{
    memcpy(b.last, raw, sizeof b.last);
    b.samples++;
    note(invcali_rests_feed(&b.detector, raw));
    b.progress = invcali_rests_progress(&b.detector);
    TEST_ASSERT_TRUE(b.progress <= 100);
}

static void end_of_stream(void)
{
    const invcal_event event = invcali_rests_finish(&b.detector);

    if (event != INVCAL_MOVING) { /* what was just taken can still be read */
        note(event);
    }
}

static int32_t whole(double x)
{
    return x < -2147483648.0 ? INT32_MIN : x > 2147483647.0 ? INT32_MAX : (int32_t)floor(x + 0.5);
}

/* One sample of a triad that points along `up`, with a linear acceleration a, g. */
static void sense(const double up[3], const double a[3])
{
    int32_t count[3];
    int32_t raw[3];

    for (unsigned i = 0; i < 3; i++) {
        const double warm = i == 0 ? b.drift * (double)b.samples / b.rate : 0;
        const double noise = b.noise * random_normal(&b.random);
        count[i] = whole((up[i] + a[i] + warm + noise) * b.counts);
        if (b.low < b.high) {
            count[i] = count[i] < b.low ? b.low : count[i] > b.high ? b.high : count[i];
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        raw[i] = (b.stuck == i + 1 ? 55 : count[(i + b.order) % 3]) * b.scale + b.shift[i];
    }
    push(raw);
}

static const double none[3] = {0, 0, 0};
static const double face[6][3] = {{0, 0, 1},       {0.6, 0.8, 0},    {-0.8, 0.36, 0.48},
                                  {0, -0.6, -0.8}, {0.7, 0.1, -0.7}, {-0.5, 0.7, -0.5}};

/* The rest continues. */
static void keep(unsigned k, double seconds)
{
    for (long i = 0; i < (long)(seconds * b.rate); i++) {
        sense(face[k], none);
    }
    b.truth[b.rests - 1].end = b.samples;
}

static void hold(unsigned k, double seconds)
{
    TEST_ASSERT_TRUE(b.rests < RESTS);
    b.truth[b.rests++].begin = b.samples;
    keep(k, seconds);
}

static void knock(unsigned k)
{
    const double a[3] = {0.5, -0.3, 0.2};

    sense(face[k], a);
}

/* A smooth turn (a polynomial of degree five), shaken by a hand. */
static void turn(unsigned from, unsigned to, double seconds)
{
    const long n = (long)(seconds * b.rate);

    for (long i = 0; i < n; i++) {
        const double u = ((double)i + 0.5) / (double)n;
        const double s = u * u * u * (10 - 15 * u + 6 * u * u);
        double up[3];
        double shake[3];
        for (unsigned a = 0; a < 3; a++) {
            up[a] = face[from][a] * (1 - s) + face[to][a] * s;
            shake[a] = 0.1 * sin(3.14159 * u) * sin(9 * u * seconds + a);
        }
        sense(up, shake);
    }
}

static void freeze(double seconds)
{
    const int32_t raw[3] = {b.last[0], b.last[1], b.last[2]};

    for (long i = 0; i < (long)(seconds * b.rate); i++) {
        push(raw);
    }
}

/* Six rests, with moves before and after. */
static void six_rests(double seconds)
{
    turn(5, 0, 2);
    for (unsigned k = 0; k < 6; k++) {
        hold(k, seconds);
        turn(k, (k + 1) % 6, 1);
    }
    end_of_stream();
}

/* Position i lies in the true rest i, and uses most of it. */
static void check_windows(unsigned count, double lost)
{
    TEST_ASSERT_EQUAL_UINT(count, b.taken);
    TEST_ASSERT_EQUAL_UINT(count, b.rests);
    for (unsigned i = 0; i < count; i++) {
        const invcali_rest *r = &b.rest[i];
        TEST_ASSERT_TRUE((long)r->begin >= b.truth[i].begin);
        TEST_ASSERT_TRUE((long)r->end <= b.truth[i].end);
        TEST_ASSERT_TRUE(r->count <= r->end - r->begin);
        TEST_ASSERT_TRUE((double)r->count >=
                         (double)(b.truth[i].end - b.truth[i].begin) - lost * b.rate);
    }
}

/* ---- finding ---------------------------------------------------------------------------------- */

static void rests_are_found_from_10_hz_to_8_khz(void)
{
    static const double rates[] = {10,  12.5, 20,  26,   32,   50,   100, 104,
                                   200, 400,  833, 1000, 1600, 3200, 8000};

    for (unsigned r = 0; r < 15; r++) {
        setup(rates[r], 16384, 2e-3);
        six_rests(rates[r] < 32 ? 6 : 2.5);
        check_windows(6, rates[r] < 32 ? 4.6 : 1.2);
        TEST_ASSERT_EQUAL_UINT(6, b.ready);
    }
}

static void rests_of_two_seconds_at_either_end_of_a_stream_count(void)
{
    setup(100, 16384, 1e-3);
    for (unsigned k = 0; k < 6; k++) {
        hold(k, 2);
        if (k < 5) {
            turn(k, k + 1, 0.5);
        }
    }
    end_of_stream();
    check_windows(6, 1.2);
}

/* Noise, resolution, rate, rests and moves at random; in every second stream each rest is knocked
 * once. */
static void random_streams_give_all_their_rests_and_nothing_else(void)
{
    static const double rates[] = {50, 100, 200, 400};

    for (uint32_t seed = 0; seed < 40; seed++) {
        random_source random = random_start(1000 + seed);
        const double noise = 2e-4 * pow(25, random_uniform(&random, 0, 1));
        const double counts = 512 * pow(64, random_uniform(&random, 0, 1));
        unsigned at = 0;
        setup(rates[seed % 4], counts, noise);
        b.random = random_start(seed);
        for (unsigned k = 0; k < 15; k++) {
            const unsigned next = (at + 1 + (unsigned)random_uniform(&random, 0, 4.99)) % 6;
            hold(at, random_uniform(&random, 1.3, 3));
            if (seed % 2) {
                knock(at);
            }
            keep(at, random_uniform(&random, 1.3, 2));
            turn(at, next, random_uniform(&random, 0.5, 2));
            at = next;
        }
        end_of_stream();
        check_windows(15, seed % 2 ? 3 : 1.2);
        /* One that has never changed is dismissed as frozen until the motion after it. */
        TEST_ASSERT_EQUAL_UINT(15, b.ready + b.refused[INVCAL_REST_FROZEN]);
        TEST_ASSERT_TRUE(b.ready >= 14);
    }
}

/* 60 minutes in all about a horizontal axis that never stops; noise up to 1 mg. */
static void a_turntable_never_rests(void)
{
    static const double rates[] = {100, 200, 400};

    for (uint32_t seed = 0; seed < 20; seed++) {
        random_source random = random_start(seed);
        const double speed = 0.3 * pow(10, random_uniform(&random, 0, 1)) * 3.14159265 / 180;
        double m[3][3];
        random_rotation(&random, m);
        setup(rates[seed % 3], 500 * pow(32, random_uniform(&random, 0, 1)),
              seed % 2 ? 1e-3 : 2e-5 * pow(50, random_uniform(&random, 0, 1)));
        b.random = random;
        for (long i = 0; i < (long)(180 * b.rate); i++) {
            const double c = cos(speed * (double)i / b.rate);
            const double s = sin(speed * (double)i / b.rate);
            const double up[3] = {c * m[0][0] + s * m[1][0], c * m[0][1] + s * m[1][1],
                                  c * m[0][2] + s * m[1][2]};
            sense(up, none);
        }
        end_of_stream();
        TEST_ASSERT_EQUAL_UINT(0, b.taken);
        TEST_ASSERT_EQUAL_UINT(0, b.ready);
        TEST_ASSERT_TRUE(b.refused[INVCAL_REST_DRIFT] > 0);
    }
}

static void motion_without_a_rest_gives_nothing(void)
{
    setup(100, 16384, 1e-3);
    for (unsigned k = 0; k < 200; k++) {
        turn(k % 6, (k + 1) % 6, 0.5 + 0.007 * k);
    }
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(0, b.taken);
    TEST_ASSERT_EQUAL_UINT(0, b.ready);
}

static void a_swinging_device_does_not_rest(void)
{
    setup(100, 16384, 1e-3);
    hold(0, 3);
    turn(0, 1, 1);
    for (long i = 0; i < 6000; i++) {
        const double swing[3] = {0, 0.1 * sin(0.02 * 6.2832 * (double)i), 0};
        sense(face[1], swing);
    }
    end_of_stream();
    check_windows(1, 1.2);
}

/* ---- what is summed --------------------------------------------------------------------------- */

/* The same stream twice: the second time, the samples of one window are summed here. */
static void sums_are_exact(void)
{
    static const double counts[] = {128, 16384, 134217728.0, 2147483000.0};

    for (unsigned c = 0; c < 4; c++) {
        const double noise = fmin(1e-3, 5e4 / counts[c]);
        setup(100, counts[c], noise);
        hold(1, 4);
        turn(1, 3, 1);
        hold(3, 3);
        end_of_stream();
        check_windows(2, 1.2);
        for (unsigned w = 0; w < 2; w++) {
            const invcali_rest rest = b.rest[w];
            int64_t sum[3] = {0};
            setup(100, counts[c], noise);
            for (long i = 0; i < (long)rest.end; i++) { /* the rests only differ by the face */
                const int first = i < 400;
                if (first || i >= 500) {
                    sense(face[first ? 1 : 3], none);
                } else if (i == 400) {
                    turn(1, 3, 1);
                }
                for (unsigned a = 0; a < 3 && i >= (long)rest.begin; a++) {
                    sum[a] += b.last[a];
                }
            }
            TEST_ASSERT_EQUAL_UINT32(rest.end - rest.begin, rest.count);
            for (unsigned a = 0; a < 3; a++) {
                TEST_ASSERT_EQUAL_INT64(sum[a], rest.sum[a]);
            }
        }
    }
}

static void variance_is_that_of_one_sample(void)
{
    setup(400, 16384, 1e-3);
    hold(1, 20);
    turn(1, 2, 1);
    const double sigma = 1e-3 * 16384;
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    TEST_ASSERT_DOUBLE_WITHIN(0.02 * sigma * sigma, sigma * sigma, (double)b.rest[0].variance);
}

/* Normal noise about three centres. */
static void noisy(random_source *random, const double centre[3], double sigma, int32_t raw[3])
{
    for (unsigned a = 0; a < 3; a++) {
        raw[a] = whole(centre[a] + sigma * random_normal(random));
    }
}

/* What the samples of one block give: their sum, and their variance about its mean. */
typedef struct {
    int64_t sum[3];
    double square, off[3];
    unsigned samples;
} block_sums;

static double add_to_block(block_sums *k, unsigned size, const double centre[3],
                           const int32_t raw[3])
{
    for (unsigned a = 0; a < 3; a++) {
        const double d = (double)((int64_t)raw[a] - (int64_t)centre[a]);
        k->off[a] += d;
        k->square += d * d;
    }
    if (++k->samples < size) {
        return 0;
    }
    double scatter = k->square;
    for (unsigned a = 0; a < 3; a++) {
        scatter -= k->off[a] * k->off[a] / size;
    }
    memset(k, 0, sizeof *k);
    return scatter / (size - 1);
}

/* Samples until the first block gives an event. */
static unsigned block_size(unsigned rate)
{
    invcal_private_rests detector;
    int32_t raw[3] = {7, 0, 0};
    unsigned n = 1;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_init(&detector, (invcal_real)rate));
    while (invcali_rests_feed(&detector, raw) == INVCAL_NOTHING) {
        raw[0] = (int32_t)n++;
    }
    return n;
}

static void a_block_is_an_eighth_of_a_second_or_four_samples(void)
{
    for (unsigned rate = 8; rate <= 8000; rate += 1 + rate / 20) {
        const unsigned n = block_size(rate);
        TEST_ASSERT_TRUE(n >= 4 && (n == 4 || 11 * n < 2 * rate));
        TEST_ASSERT_TRUE(11 * n >= rate);
    }
}

/* A rest of 24 blocks, and again, to sum what has been found. Returns 0 if chance has disturbed it:
 * of four samples that happens. */
static unsigned check_rest(unsigned rate, const double centre[3], double sigma, uint32_t seed)
{
    const unsigned size = block_size(rate);
    random_source random = random_start(seed);
    block_sums k = {{0}, 0, {0}, 0};
    int64_t sum[3] = {0};
    double variance = 0;
    int32_t raw[3];

    setup(rate, 1, 0);
    for (unsigned i = 0; i < 24 * size; i++) {
        noisy(&random, centre, sigma, raw);
        push(raw);
    }
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    const invcali_rest *r = &b.rest[0];
    if (r->end - r->begin != r->count || r->end + 2 * size != 24 * size) {
        TEST_ASSERT_EQUAL_UINT(4, size);
        return 0;
    }
    random = random_start(seed);
    for (unsigned i = 0; i < 24 * size; i++) { /* the newest two count for the variance, too */
        noisy(&random, centre, sigma, raw);
        variance += i < r->begin ? 0 : add_to_block(&k, size, centre, raw);
        for (unsigned a = 0; a < 3 && i >= r->begin && i < r->end; a++) {
            sum[a] += raw[a];
        }
    }
    for (unsigned a = 0; a < 3; a++) {
        TEST_ASSERT_EQUAL_INT64(sum[a], r->sum[a]);
    }
    variance /= 3.0 * (r->count / size + 2);
    TEST_ASSERT_DOUBLE_WITHIN((3e-7 + 1000 * DBL_EPSILON) * variance + 0.01, variance,
                              (double)r->variance);
    return 1;
}

static void sums_are_exact_and_variance_too_for_any_offset_and_noise(void)
{
    static const double centres[][3] = {
        {0, 0, 0}, {33000, -7, 2e6}, {1.9e9, -1.9e9, 40}, {-2147000000.0, 2147000000.0, 0}};
    static const double sigmas[] = {0.4, 10, 300, 1500, 6000, 65000};
    static const unsigned rates[] = {20, 100, 1000, 8000};
    unsigned checked = 0;

    needs_53_bits();
    for (unsigned c = 0; c < 4; c++) {
        for (unsigned n = 0; n < 6; n++) {
            for (unsigned r = 0; r < 4; r++) {
                checked += check_rest(rates[r], centres[c], sigmas[n], 10 * c + n);
            }
        }
    }
    TEST_ASSERT_TRUE(checked >= 90); /* of 96 */
}

/* Every sample but the first of a block is as far off as it may be, on all axes, up and down. */
static void push_extremes(int32_t base, int32_t distance, unsigned size, unsigned blocks)
{
    for (unsigned i = 0; i < blocks * size; i++) {
        const int32_t d = i % size == 0 ? 0 : (i & 1) != 0 ? distance : -distance;
        const int32_t raw[3] = {base + d, base - d, base / 2 + d};
        push(raw);
    }
}

#define WIDE 524288

static void nothing_overflows_at_the_largest_distance(void)
{
    static const int32_t bases[] = {0, INT32_MAX - WIDE, INT32_MIN + WIDE};
    static const unsigned rates[] = {8, 100, 8000};

    for (unsigned k = 0; k < 9; k += SLOW(1, 4)) {
        const unsigned size = block_size(rates[k % 3]);
        setup(rates[k % 3], 1, 0);
        push_extremes(bases[k / 3], WIDE - 1, size, 30);
        end_of_stream();
        TEST_ASSERT_EQUAL_UINT(1, b.taken);
        const invcali_rest *r = &b.rest[0];
        const int64_t blocks = r->count / size;
        const int64_t off = WIDE - 1; /* one more is up than down */
        const double d = (WIDE - 1.0) * (WIDE - 1.0);
        TEST_ASSERT_EQUAL_INT64(bases[k / 3] * (int64_t)r->count + blocks * off, r->sum[0]);
        TEST_ASSERT_EQUAL_INT64(bases[k / 3] * (int64_t)r->count - blocks * off, r->sum[1]);
        TEST_ASSERT_EQUAL_INT64(bases[k / 3] / 2 * (int64_t)r->count + blocks * off, r->sum[2]);
        TEST_ASSERT_DOUBLE_WITHIN((1e-6 + 100 * DBL_EPSILON) * d,
                                  d - d / ((double)size * (size - 1)), (double)r->variance);
    }
}

/* Blocks that all read the same differences to their first sample: exact whatever their size, also
 * where many are added quickly, and where one among them is large. */
static void check_pattern(unsigned rate, int32_t large, int32_t others)
{
    const double centre[3] = {1000, -70000, 5};
    const unsigned size = block_size(rate);
    block_sums k = {{0}, 0, {0}, 0};
    int64_t sum[3] = {0};
    double variance = 0;

    setup(rate, 1, 0);
    for (unsigned i = 0; i < 24 * size; i++) {
        const unsigned n = i % size;
        const int32_t d = n < 2 ? (int32_t)n : n == 2 ? large : (n & 1) != 0 ? others : -others;
        const int32_t raw[3] = {1000 + d, -70000 - d, 5 + d / 2};
        push(raw);
        variance = i < size ? add_to_block(&k, size, centre, raw) : variance;
        for (unsigned a = 0; a < 3 && i < size; a++) {
            sum[a] += raw[a];
        }
    }
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    for (unsigned a = 0; a < 3; a++) {
        TEST_ASSERT_EQUAL_INT64(sum[a] * (b.rest[0].count / size), b.rest[0].sum[a]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(3e-7 * variance, variance / 3, (double)b.rest[0].variance);
}

static void no_square_is_lost_in_a_block_of_any_size(void)
{
    static const unsigned rates[] = {8, 50, 100, 400, 1000, 8000};
    static const int32_t others[] = {1000, 2047, 4095, 8191, 16383, 60000, 500000};

    needs_53_bits();
    for (unsigned r = 0; r < 6; r++) {
        for (unsigned k = 0; k < 7; k++) {
            check_pattern(rates[r], others[k], others[k]);
            check_pattern(rates[r], 65535, others[k]);
            check_pattern(rates[r], 524287, others[k]);
        }
    }
}

static void samples_too_far_from_the_first_are_not_a_rest(void)
{
    static const int32_t value[][2] = {{0, WIDE},
                                       {0, -WIDE},
                                       {INT32_MIN, INT32_MAX},
                                       {INT32_MAX, INT32_MIN},
                                       {INT32_MAX - 5, INT32_MIN + 5},
                                       {INT32_MIN + 5, INT32_MAX - 5}};

    for (unsigned k = 0; k < 18; k++) {
        setup(50, 1, 0);
        for (unsigned i = 0; i < 400; i++) {
            int32_t raw[3] = {0, 0, 0};
            raw[k % 3] = value[k / 3][i & 1];
            push(raw);
        }
        end_of_stream();
        TEST_ASSERT_EQUAL_UINT(0, b.ready + b.taken);
        TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_REFUSED]);
    }
}

/* Samples before a gap are not in the sums of the block that begins after it. */
static void a_dropped_block_leaves_nothing_in_the_next(void)
{
    const int32_t other[3] = {INT32_MIN, 70000, -1};
    static bench plain;

    for (unsigned dropped = 0; dropped < 2; dropped++) {
        plain = b;
        setup(100, 16384, 1e-3);
        hold(1, 1.28); /* 8 blocks */
        for (unsigned i = 0; i < 15 * dropped; i++) {
            push(other);
        }
        invcali_rests_gap(&b.detector);
        keep(1, 1.28);
        end_of_stream();
    }
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    TEST_ASSERT_EQUAL_UINT32(plain.rest[0].count, b.rest[0].count);
    for (unsigned a = 0; a < 3; a++) {
        TEST_ASSERT_EQUAL_INT64(plain.rest[0].sum[a], b.rest[0].sum[a]);
    }
    TEST_ASSERT_TRUE(plain.rest[0].variance == b.rest[0].variance);
    TEST_ASSERT_EQUAL_UINT32(plain.rest[0].end, b.rest[0].end);
}

/* Where counts go in steps of 64, that is known after half a minute, and samples are added as
 * quickly as any: the sums stay exact, and rails are noticed. */
static void a_coarse_sensor_is_summed_and_clipped_after_minutes_too(void)
{
    setup_rails(100, 256, 4e-3, -230, 230);
    b.scale = 64;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_rails(&b.detector, -230 * 64, 230 * 64));
    for (unsigned k = 0; k < 12; k++) {
        hold(k % 2 ? 1 : 5, 6);
        turn(k % 2 ? 1 : 5, k % 2 ? 5 : 1, 1);
    }
    check_windows(12, 1.2);
    for (unsigned i = 0; i < 12; i++) {
        for (unsigned a = 0; a < 3; a++) {
            TEST_ASSERT_DOUBLE_WITHIN(2e-3, face[i % 2 ? 1 : 5][a],
                                      (double)b.rest[i].sum[a] / b.rest[i].count / 256 / 64);
            TEST_ASSERT_EQUAL_INT(0, b.rest[i].sum[a] % 64);
        }
    }
    hold(0, 3); /* 1 g: beyond 0.9 */
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(12, b.taken);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_CLIPPED]);
}

/* Every mean in this file is compared with its sum; here are counts that no invcal_real holds. */
static void means_hold_all_bits_there_are(void)
{
    static const double counts[] = {100, 33102, 16777217.0, 2147483000.0};
    static const double noise[] = {1, 100, 10000};

    for (unsigned i = 0; i < 12; i += SLOW(1, 5)) {
        setup(SLOW(400, 100), counts[i % 4], noise[i / 4] / counts[i % 4]);
        for (unsigned k = 1; k < 6; k++) {
            hold(k, 2 + k);
            turn(k, (k + 1) % 6, 1);
        }
        end_of_stream();
        TEST_ASSERT_TRUE(b.taken >= 1);
    }
}

/* ---- what must not matter ------------------------------------------------------------------- */

static void record(int32_t scale, int32_t shift, unsigned order, bench *out)
{
    setup(100, 4096, 1.5e-3);
    b.scale = scale;
    b.order = order;
    for (unsigned a = 0; a < 3; a++) {
        b.shift[a] = shift * ((int32_t)a + 1);
    }
    turn(5, 0, 1);
    for (unsigned k = 0; k < 6; k++) {
        hold(k, 2);
        knock(k);
        keep(k, 1 + 0.3 * k);
        turn(k, (k + 1) % 6, 1);
    }
    end_of_stream();
    check_windows(6, 2.5);
    *out = b;
}

static void check_same(const bench *one, const bench *two, int exactly)
{
    TEST_ASSERT_EQUAL_UINT(one->taken, two->taken);
    if (exactly) {
        TEST_ASSERT_EQUAL_UINT32(one->events, two->events);
    }
    for (unsigned i = 0; i < one->taken; i++) {
        const invcali_rest *p = &one->rest[i];
        const invcali_rest *q = &two->rest[i];
        TEST_ASSERT_EQUAL_UINT32(p->begin, q->begin);
        TEST_ASSERT_EQUAL_UINT32(p->end, q->end);
        TEST_ASSERT_EQUAL_UINT32(p->count, q->count);
        for (unsigned a = 0; a < 3; a++) {
            const unsigned axis = (a + two->order) % 3;
            const int64_t from = (int64_t)one->shift[axis] * p->count;
            const int64_t moved = q->sum[a] - (int64_t)two->shift[a] * q->count;
            TEST_ASSERT_EQUAL_INT64((p->sum[axis] - from) * two->scale, moved);
        }
    }
}

static void unit_offset_and_order_of_the_axes_do_not_matter(void)
{
    static const struct {
        int32_t scale;
        int32_t shift;
        unsigned order;
        int exactly;
    } row[] = {{2, 0, 0, 1}, {64, 0, 0, 1},       {128, 0, 0, 1},        {1000, 0, 0, 0},
               {3, 0, 0, 0}, {1, 12345678, 0, 1}, {1, -700000000, 0, 1}, {1, 0, 1, 0},
               {1, 0, 2, 0}, {-1, 0, 0, 1},       {1000, -77777, 2, 0}};
    static bench plain;
    static bench other;

    record(1, 0, 0, &plain);
    for (unsigned i = 0; i < 11; i++) {
        record(row[i].scale, row[i].shift, row[i].order, &other);
        check_same(&plain, &other, row[i].exactly);
    }
}

static void a_copy_of_the_state_behaves_the_same(void)
{
    static bench half;
    invcal_private_rests copy;

    setup(100, 4096, 1.5e-3);
    hold(1, 3);
    turn(1, 2, 0.7);
    hold(2, 1.13);
    memcpy(&copy, &b.detector, sizeof copy);
    half = b;
    keep(2, 2);
    turn(2, 3, 1);
    const uint32_t events = b.events;
    const invcali_rest last = b.rest[b.taken - 1];
    TEST_ASSERT_EQUAL_UINT(2, b.taken);
    b = half;
    memset(&b.detector, 0x5A, sizeof b.detector);
    memcpy(&b.detector, &copy, sizeof copy);
    keep(2, 2);
    turn(2, 3, 1);
    TEST_ASSERT_EQUAL_UINT32(events, b.events);
    TEST_ASSERT_EQUAL_INT64(last.sum[0], b.rest[1].sum[0]);
    TEST_ASSERT_EQUAL_UINT32(last.end, b.rest[1].end);
}

/* ---- rests that are no positions ------------------------------------------------------------- */

static unsigned all_refused(void)
{
    unsigned n = 0;

    for (unsigned i = 0; i < INVCAL_STATUS_END; i++) {
        n += b.refused[i];
    }
    return n;
}

/* Holds a device that creeps along x at 4 mg/s, 0.2 degrees/s, between two times. */
static void creep(unsigned k, double from, double to)
{
    for (double t = from; t < to; t += 1 / b.rate) {
        const double a[3] = {0.004 * t, 0, 0};
        sense(face[k], a);
    }
}

static void a_slow_turn_is_refused_for_drift_while_it_lasts(void)
{
    setup(100, 16384, 5e-4);
    hold(0, 3);
    turn(0, 1, 1);
    hold(1, 3);
    turn(1, 2, 1);
    creep(2, 0, 2);
    TEST_ASSERT_EQUAL_UINT(0, all_refused());
    creep(2, 2, 4);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_DRIFT]);
    creep(2, 4, 12);
    TEST_ASSERT_TRUE(b.refused[INVCAL_REST_DRIFT] >= 2);
    turn(2, 3, 1);
    hold(3, 3);
    end_of_stream();
    check_windows(3, 1.2);
    TEST_ASSERT_EQUAL_UINT(3, b.ready);
    TEST_ASSERT_EQUAL_UINT(b.refused[INVCAL_REST_DRIFT], all_refused());
}

/* A rest that has been READY is not refused until it has crept for 1.5 s. */
static void a_position_that_creeps_as_it_is_left_is_one(void)
{
    for (int tenths = 5; tenths < 40; tenths += 4) {
        setup(100, 16384, 5e-4);
        hold(0, 3);
        turn(0, 1, 1);
        hold(1, 3);
        TEST_ASSERT_EQUAL_UINT(2, b.ready);
        creep(1, 0, tenths / 10.0);
        turn(1, 2, 1);
        hold(2, 3);
        end_of_stream();
        TEST_ASSERT_EQUAL_UINT(3, b.ready);
        TEST_ASSERT_EQUAL_UINT(0, all_refused());
    }
}

static void a_sensor_that_warms_up_is_at_rest(void)
{
    static const double noises[] = {5e-4, 5e-5, 2e-5};

    for (unsigned n = 0; n < 3; n++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            setup(100, n == 2 ? 131072 : 16384, noises[n]);
            b.drift = sign * 2e-4;
            six_rests(5);
            check_windows(6, 1.2);
        }
    }
}

/* 54 mg in total: the rest is expected where its trend leads. */
static void a_warming_sensor_may_rest_for_minutes_at_first(void)
{
    setup(100, 16384, 2e-4);
    b.drift = 3e-4;
    hold(1, 180);
    turn(1, 2, 1);
    hold(2, 3);
    turn(2, 3, 1);
    check_windows(2, 1.2);
    TEST_ASSERT_EQUAL_UINT(0, all_refused());
}

/* The events in that many seconds of shaking, and none before. */
static void shake(double seconds)
{
    memset(b.seen, 0, sizeof b.seen);
    for (long i = 0; i < (long)(seconds * b.rate); i++) {
        const double t = (double)i / b.rate;
        const double a[3] = {t * sin(90 * t), (0.5 + t) * cos(7 * t), 0};
        sense(face[1], a);
    }
}

/* Six blocks a second: motion, also where a rest is disturbed for a moment, and goes on. */
static void what_is_shaken_is_moving_and_does_not_settle(void)
{
    setup(100, 16384, 5e-4);
    hold(1, 3);
    shake(0.3);
    TEST_ASSERT_TRUE(b.seen[INVCAL_MOVING] >= 1 && b.seen[INVCAL_MOVING] <= 2);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SETTLING] + b.taken);
    keep(1, 2);
    shake(2);
    TEST_ASSERT_EQUAL_UINT(1, b.seen[INVCAL_TAKEN]);
    shake(1);
    TEST_ASSERT_TRUE(b.seen[INVCAL_MOVING] >= 6);
    TEST_ASSERT_EQUAL_UINT(0, b.seen[INVCAL_SETTLING]);
}

/* Three rests of a sensor of 100 counts/g, in units of a tenth of a count; from the second second of
 * the middle one on it is moved by some counts, for a while. */
static void rest_moved_by(double x, double y, double seconds)
{
    const double a[3] = {x / 100, y / 100, 0};

    setup(100, 100, 2e-3);
    b.scale = 10;
    hold(0, 3);
    turn(0, 1, 1);
    hold(1, 2);
    for (long i = 0; i < (long)(seconds * b.rate); i++) {
        sense(face[1], a);
    }
    keep(1, 2);
    turn(1, 2, 1);
    hold(2, 3);
    end_of_stream();
}

/* One count on two axes is near; three counts on one are not, but no blow either, and pass if they
 * last no longer than a hand's unrest. */
static void a_few_counts_for_a_while_do_not_end_a_rest(void)
{
    rest_moved_by(1, 1, 2);
    check_windows(3, 1.2);
    TEST_ASSERT_EQUAL_UINT(0, all_refused());
    rest_moved_by(3, 0, 0.3);
    check_windows(3, 1.3);
    TEST_ASSERT_EQUAL_UINT(0, all_refused());
}

static void a_rest_at_a_rail_is_refused_as_clipped(void)
{
    setup_rails(100, 1000, 1e-3, -650, 650);
    hold(2, 3); /* -0.8 g on x */
    turn(2, 5, 1);
    hold(5, 3); /* 0.7 g on y */
    turn(5, 1, 1);
    hold(1, 3); /* 0.8 g on y */
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(0, b.taken);
    TEST_ASSERT_EQUAL_UINT(3, b.refused[INVCAL_REST_CLIPPED]);
    TEST_ASSERT_EQUAL_UINT(3, all_refused());
    setup_rails(100, 1000, 1e-3, -900, 900); /* now it fits */
    hold(2, 3);
    turn(2, 5, 1);
    hold(5, 3);
    turn(5, 1, 1);
    hold(1, 3);
    end_of_stream();
    check_windows(3, 1.2);
}

/* A rest of 20 blocks of 16 that toggle about `at`; one sample in the midst of it reads `odd`. */
static unsigned clipped_with(int32_t low, int32_t high, const int32_t at[3], unsigned sample,
                             unsigned axis, int32_t odd)
{
    setup(100, 1, 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_rails(&b.detector, low, high));
    for (unsigned i = 0; i < 20 * 16; i++) {
        int32_t raw[3] = {at[0] + (int32_t)(i & 1), at[1] - (int32_t)(i & 1), at[2]};
        if (i == 12 * 16 + sample) {
            raw[axis] = odd;
        }
        push(raw);
    }
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(1, b.taken + b.refused[INVCAL_REST_CLIPPED]);
    return b.refused[INVCAL_REST_CLIPPED];
}

static void a_sample_at_a_rail_or_beyond_is_clipped_on_any_axis_at_any_time(void)
{
    static const int32_t rails[][2] = {
        {-2048, 2047}, {-32768, 32767}, {0, 65535}, {7, 11}, {INT32_MIN, INT32_MAX}};

    for (unsigned k = 0; k < 5; k++) {
        const int32_t low = rails[k][0];
        const int32_t high = rails[k][1];
        const int32_t at[3] = {low + 1, high - 1, low + 2};
        for (unsigned i = 0; i < 48; i += 1 + i % 3) {
            const unsigned axis = i % 3;
            const int32_t rail = axis == 1 ? high : low;
            const int32_t beyond = axis == 1 ? 1 : -1;
            TEST_ASSERT_EQUAL_UINT(0, clipped_with(low, high, at, i / 3, axis, rail - beyond));
            TEST_ASSERT_EQUAL_UINT(1, clipped_with(low, high, at, i / 3, axis, rail));
            if (k < 4) {
                TEST_ASSERT_EQUAL_UINT(1, clipped_with(low, high, at, i / 3, axis, rail + beyond));
            }
        }
    }
}

/* Blocks that begin at any distance from a rail, and come to a count from it, or reach it. */
static unsigned clipped_from(int32_t distance, int32_t reached)
{
    const int32_t low = -131072;
    const int32_t high = 131071;

    setup(100, 1, 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_rails(&b.detector, low, high));
    for (unsigned i = 0; i < 20 * 16; i++) {
        const int32_t d = i % 16 == 0 ? distance : reached;
        const int32_t raw[3] = {low + d, high - d - (int32_t)(i & 1), (int32_t)(i & 1)};
        push(raw);
    }
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(1, b.taken + b.refused[INVCAL_REST_CLIPPED]);
    return b.refused[INVCAL_REST_CLIPPED];
}

static void a_rail_is_seen_from_any_distance(void)
{
    for (int32_t distance = 1; distance <= 65536; distance *= 2) {
        for (int32_t off = -1; off <= 1; off++) {
            const int begins_there = distance + off == 0;
            TEST_ASSERT_EQUAL_UINT(begins_there, clipped_from(distance + off, 1));
            TEST_ASSERT_EQUAL_UINT(1, clipped_from(distance + off, 0));
        }
    }
}

static void the_ends_of_int32_clip_where_no_rails_are_given(void)
{
    setup(100, 2147483000.0, 1e-5);
    hold(0, 3); /* 1 g: at the end */
    turn(0, 1, 1);
    hold(1, 3);
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_CLIPPED]);
}

static void a_sensor_that_never_speaks_is_frozen_and_says_so_once(void)
{
    static const int32_t dead[2][3] = {{0, 0, 0}, {100, 200, 16000}};

    for (unsigned k = 0; k < 2; k++) {
        setup(100, 16384, 1e-3);
        for (unsigned i = 0; i < 3000; i++) {
            push(dead[k]);
        }
        end_of_stream();
        TEST_ASSERT_EQUAL_UINT(0, b.taken);
        TEST_ASSERT_EQUAL_UINT(0, b.ready);
        TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_FROZEN]);
        TEST_ASSERT_EQUAL_UINT(1, all_refused());
    }
}

/* Its noise would be some counts, but it has none: not read, or at a rail that was not stated. */
static void an_axis_that_stands_still_amid_noise_is_refused_as_frozen(void)
{
    for (unsigned axis = 1; axis <= 3; axis++) {
        setup(100, 16384, 3e-4); /* 5 counts */
        b.stuck = axis;
        six_rests(3);
        TEST_ASSERT_EQUAL_UINT(0, b.taken);
        TEST_ASSERT_EQUAL_UINT(6, b.refused[INVCAL_REST_FROZEN]);
        TEST_ASSERT_EQUAL_UINT(6, all_refused());
    }
}

/* A noise of 3 counts on each of two axes: 18 of 27. A third that has none may be one whose noise is
 * a tenth of a count. */
static void where_there_is_little_noise_an_axis_may_stand_still(void)
{
    for (int32_t scale = 1; scale <= 64; scale += 63) { /* counts in steps of 64: the same */
        setup(100, 16384, 1.83e-4);
        b.stuck = 2;
        b.scale = scale;
        six_rests(3);
        check_windows(6, 1.6);
        TEST_ASSERT_EQUAL_UINT(0, all_refused());
    }
}

static void zeros_at_power_up_do_no_harm(void)
{
    setup(100, 16384, 1e-3);
    freeze(3);
    six_rests(3);
    check_windows(6, 1.6);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_FROZEN]);
}

static void a_sensor_that_freezes_in_motion_gives_no_rest(void)
{
    setup(100, 16384, 1e-3);
    hold(0, 3);
    turn(0, 1, 1);
    hold(1, 3);
    turn(1, 2, 0.5);
    freeze(6);
    turn(2, 3, 1);
    hold(3, 3);
    end_of_stream();
    check_windows(3, 1.2);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_FROZEN]);
}

static void a_sensor_that_freezes_in_a_rest_ends_it(void)
{
    setup(100, 16384, 1e-3);
    hold(0, 3);
    turn(0, 1, 1);
    hold(1, 3);
    freeze(6);
    turn(1, 3, 1);
    hold(3, 3);
    end_of_stream();
    check_windows(3, 1.2);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_FROZEN]);
}

static void lost_samples_do_not_end_a_rest_that_goes_on(void)
{
    setup(100, 16384, 1e-3);
    hold(0, 3);
    invcali_rests_gap(&b.detector);
    keep(0, 3);
    turn(0, 1, 1);
    hold(1, 3);
    end_of_stream();
    check_windows(2, 2);
    TEST_ASSERT_TRUE(b.rest[0].end - b.rest[0].begin > 480);
    TEST_ASSERT_EQUAL_UINT(2, b.ready);
}

static void lost_samples_before_it_is_ready_do_not_refuse_a_rest(void)
{
    setup(100, 16384, 1e-3);
    hold(0, 1);
    TEST_ASSERT_EQUAL_UINT(0, b.ready);
    invcali_rests_gap(&b.detector);
    keep(0, 3);
    TEST_ASSERT_EQUAL_UINT(1, b.ready);
    turn(0, 1, 1);
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    TEST_ASSERT_EQUAL_UINT(0, all_refused());
}

static void lost_samples_may_hide_a_motion(void)
{
    setup(100, 16384, 1e-3);
    for (unsigned k = 0; k < 5; k++) {
        hold(k, 3);
        invcali_rests_gap(&b.detector);
    }
    end_of_stream();
    check_windows(5, 1.4);
}

static void a_rest_cut_short_by_lost_samples_is_refused_for_the_gap(void)
{
    setup(100, 16384, 1e-3);
    hold(0, 3);
    turn(0, 1, 1);
    hold(1, 1.3);
    TEST_ASSERT_EQUAL_UINT(1, b.ready);
    invcali_rests_gap(&b.detector);
    turn(1, 2, 1);
    hold(2, 3);
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(2, b.taken);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_GAP]);
    TEST_ASSERT_EQUAL_UINT(1, all_refused());
}

static void a_short_rest_is_refused_as_short(void)
{
    setup(100, 16384, 1e-3);
    hold(0, 3);
    turn(0, 1, 1);
    hold(1, 1.25);
    turn(1, 2, 1);
    hold(2, 3);
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(2, b.taken);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_SHORT]);
    TEST_ASSERT_EQUAL_UINT(1, all_refused());
}

static void the_same_place_again_is_refused_once(void)
{
    setup(100, 16384, 1e-3);
    hold(0, 3);
    turn(0, 1, 0.6);
    turn(1, 0, 0.6);
    hold(0, 5);
    TEST_ASSERT_EQUAL_UINT(99, b.progress);
    turn(0, 2, 1);
    hold(2, 3);
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(2, b.taken);
    TEST_ASSERT_EQUAL_UINT(2, b.ready);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_SAME]);
    TEST_ASSERT_EQUAL_UINT(1, all_refused());
}

/* ---- rests that are positions all the same ---------------------------------------------------- */

static void a_knock_is_left_out_of_the_rest(void)
{
    setup(100, 16384, 1e-3);
    hold(1, 2);
    knock(1);
    keep(1, 2);
    turn(1, 2, 1);
    hold(2, 3);
    end_of_stream();
    check_windows(2, 2.2);
    TEST_ASSERT_TRUE(b.rest[0].count < b.rest[0].end - b.rest[0].begin);
    TEST_ASSERT_TRUE(b.rest[0].end > 350);
    for (unsigned a = 0; a < 3; a++) {
        TEST_ASSERT_DOUBLE_WITHIN(5e-4, face[1][a],
                                  (double)b.rest[0].sum[a] / b.rest[0].count / 16384);
    }
}

static void counts_larger_than_the_noise_are_no_obstacle(void)
{
    setup(100, 128, 1e-3); /* 7.8 mg: most rests read the same all the time */
    for (unsigned k = 1; k < 6; k++) {
        hold(k, 4);
        turn(k, (k + 1) % 6, 1);
    }
    end_of_stream();
    check_windows(5, 1.4);
    setup(100, 128, 1e-4);
    hold(1, 20);
    turn(1, 2, 1);
    hold(2, 20);
    end_of_stream();
    check_windows(2, 1.4);
}

/* Up and down by two counts on one axis: 4 counts^2, where a sensor without noise may show 5/4. */
static void two_counts_up_and_down_are_motion_where_there_is_no_noise(void)
{
    setup(100, 128, 1e-5);
    hold(1, 3);
    TEST_ASSERT_EQUAL_UINT(0, b.ready); /* nothing has changed yet */
    turn(1, 2, 1);
    hold(2, 3);
    memset(b.seen, 0, sizeof b.seen);
    for (unsigned i = 0; i < 48; i++) {
        const double a[3] = {(i & 1) != 0 ? 2.0 / 128 : -2.0 / 128, 0, 0};
        sense(face[2], a);
    }
    TEST_ASSERT_TRUE(b.seen[INVCAL_MOVING] >= 2);
    TEST_ASSERT_TRUE(b.seen[INVCAL_SETTLING] <= 1);
}

/* One count on each axis in the midst of a rest without noise: temperature, no motion. */
static void readings_that_toggle_by_one_count_are_one_rest(void)
{
    setup(100, 128, 1e-5);
    hold(1, 3);
    turn(1, 2, 1);
    hold(2, 3);
    turn(2, 3, 1);
    b.truth[b.rests].begin = b.samples;
    for (unsigned i = 0; i < 600; i++) {
        const int32_t up = i >= 300;
        const int32_t raw[3] = {10 + up, -70 - up, 90 + up};
        push(raw);
    }
    b.truth[b.rests++].end = b.samples;
    turn(3, 4, 1);
    hold(4, 3);
    end_of_stream();
    check_windows(4, 1.3);
}

static void a_stream_that_begins_in_motion_learns_soon(void)
{
    static const double rates[] = {50, 100, 400};

    for (unsigned r = 0; r < 3; r++) {
        setup(rates[r], 16384, 5e-4);
        for (double t = 0; t < 1; t += 1 / b.rate) {
            const double shake[3] = {0.5 * sin(9 * t), 0.5 * sin(1 + 7 * t), 0.3 * sin(5 * t)};
            sense(face[0], shake);
        }
        for (unsigned k = 1; k < 6; k++) {
            hold(k, 3);
            turn(k, (k + 1) % 6, 1);
        }
        end_of_stream();
        check_windows(5, 1.8);
    }
}

static void two_minutes_of_rest_are_one_position(void)
{
    setup(100, 16384, 1e-3);
    hold(1, 120);
    TEST_ASSERT_EQUAL_UINT(100, b.progress);
    turn(1, 2, 1);
    hold(2, 3);
    end_of_stream();
    check_windows(2, 1.2);
    TEST_ASSERT_EQUAL_UINT(2, b.ready);
}

static void a_fan_switched_on_is_a_new_noise_level(void)
{
    setup(100, 16384, 3e-4);
    hold(0, 3);
    turn(0, 1, 1);
    hold(1, 3);
    turn(1, 2, 1);
    b.noise = 3e-3;
    for (unsigned k = 2; k < 6; k++) {
        hold(k, 4);
        turn(k, (k + 1) % 6, 1);
    }
    end_of_stream();
    check_windows(6, 2);
    b.noise = 3e-4; /* and away again */
    for (unsigned k = 1; k < 6; k++) {
        hold(k, 4);
        turn(k, (k + 1) % 6, 1);
    }
    check_windows(11, 2);
}

/* ---- how long to hold -------------------------------------------------------------------------- */

/* The seconds that had been measured at READY. */
static double seconds_at_ready(unsigned rate, unsigned milliseconds)
{
    invcali_rest rest = {{0}, 0, 0, 0, 0};
    unsigned before = 0;

    setup(rate, 16384, 1e-3);
    invcali_rests_hold(&b.detector, milliseconds);
    for (unsigned long i = 0; i < 20ul * rate && b.ready == 0; i++) {
        sense(face[1], none);
        TEST_ASSERT_TRUE(b.progress >= before);
        before = b.progress;
    }
    TEST_ASSERT_EQUAL_UINT(100, before);
    TEST_ASSERT_EQUAL_INT(1, invcali_rests_get(&b.detector, &rest));
    return (double)rest.count / rate;
}

static void a_rest_is_held_as_long_as_is_asked_and_no_longer(void)
{
    static const unsigned rates[] = {8, 50, 100, 400};

    for (unsigned r = 0; r < 4; r++) {
        const double shortest = seconds_at_ready(rates[r], 0);
        TEST_ASSERT_TRUE(shortest >= 0.5 && shortest <= (rates[r] < 32 ? 2 : 0.7));
        TEST_ASSERT_TRUE(fabs(seconds_at_ready(rates[r], 300) - shortest) < 1e-9);
        for (unsigned ms = 2500; ms <= 10000; ms += 2500) {
            const double measured = seconds_at_ready(rates[r], ms);
            TEST_ASSERT_TRUE(measured >= ms / 1000.0);
            TEST_ASSERT_TRUE(measured <= ms / 1000.0 + (rates[r] < 32 ? 1 : 0.36));
        }
    }
}

/* Blocks are counted without a division: against exact times, at all rates. */
static void no_time_to_hold_is_cut_short_at_any_rate(void)
{
    invcal_private_rests detector;

    for (uint32_t rate = 8; rate <= 8000; rate += TEST_SHORT) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                              invcali_rests_init(&detector, (invcal_real)(unsigned)rate));
        const uint32_t size = UINT32_C(1) << detector.bits;
        const uint32_t least = 78 * rate / 125 / size + 1; /* 0.624 s */
        TEST_ASSERT_EQUAL_UINT32(least < 4 ? 4 : least, detector.least);
        TEST_ASSERT_EQUAL_UINT32(detector.least, detector.dwell);
        for (uint64_t ms = 1; ms <= 3600000; ms *= 3) {
            invcali_rests_hold(&detector, (uint32_t)ms);
            const uint64_t held = (uint64_t)detector.dwell * size * 1000; /* over rate: ms */
            const uint64_t most = (ms + ms / 1000 + 8) * rate + size * UINT64_C(1000);
            TEST_ASSERT_TRUE(held >= ms * rate);
            TEST_ASSERT_TRUE(detector.dwell == detector.least || held <= most);
        }
    }
}

/* And its place does not count as taken. */
static void a_rest_left_before_its_time_is_refused_as_short(void)
{
    setup(100, 16384, 1e-3);
    invcali_rests_hold(&b.detector, 3000);
    hold(1, 3.5);
    turn(1, 2, 1);
    TEST_ASSERT_EQUAL_UINT(0, b.taken);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_SHORT]);
    turn(2, 1, 1);
    hold(1, 4.6);
    TEST_ASSERT_EQUAL_UINT(1, b.ready);
    turn(1, 3, 1);
    hold(3, 3.5);
    invcali_rests_gap(&b.detector);
    turn(3, 4, 1);
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_GAP]);
    TEST_ASSERT_EQUAL_UINT(2, all_refused());
}

static void the_time_to_hold_may_change_in_the_midst_of_a_rest(void)
{
    invcali_rest rest;

    setup(100, 16384, 1e-3);
    hold(1, 2);
    TEST_ASSERT_EQUAL_UINT(1, b.ready);
    invcali_rests_hold(&b.detector, 500); /* no longer than it has lasted: READY as before */
    TEST_ASSERT_EQUAL_UINT(100, invcali_rests_progress(&b.detector));
    invcali_rests_hold(&b.detector, 4000);
    TEST_ASSERT_EQUAL_INT(0, invcali_rests_get(&b.detector, &rest));
    TEST_ASSERT_TRUE(invcali_rests_progress(&b.detector) > 15);
    TEST_ASSERT_TRUE(invcali_rests_progress(&b.detector) < 50);
    b.ready_before = 0;
    b.is_held = 0;
    keep(1, 2);
    TEST_ASSERT_EQUAL_UINT(1, b.ready);
    keep(1, 1.5);
    TEST_ASSERT_EQUAL_UINT(2, b.ready);
    invcali_rests_hold(&b.detector, 60000);
    b.ready_before = 0;
    b.is_held = 0;
    keep(1, 1);
    TEST_ASSERT_EQUAL_UINT(2, b.ready);
    TEST_ASSERT_TRUE(b.progress < 12);
    invcali_rests_hold(&b.detector, 0);
    keep(1, 0.17);
    TEST_ASSERT_EQUAL_UINT(3, b.ready);
    turn(1, 2, 1);
    check_windows(1, 1.2);
    TEST_ASSERT_EQUAL_UINT(0, all_refused());
}

/* Nobody has to wait a minute to learn that the first second was bad. */
static void faults_are_reported_before_the_time_has_passed(void)
{
    setup(100, 16384, 5e-4);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_rails(&b.detector, -16380, 16380));
    invcali_rests_hold(&b.detector, 60000);
    hold(0, 2);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_CLIPPED]);
    turn(0, 1, 1);
    creep(1, 0, 4);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_DRIFT]);
    turn(1, 0, 1);
    hold(0, 2);
    TEST_ASSERT_EQUAL_UINT(2, b.refused[INVCAL_REST_CLIPPED]);
}

/* An hour is the most: 4 samples in a block of half a second, 7200 of them and one. */
static void an_hour_is_the_longest_time_to_hold(void)
{
    if (sizeof(unsigned) < 4) {
        TEST_IGNORE_MESSAGE("65 s is the longest here");
    }
    for (unsigned i = 0; i < 2; i++) {
        setup(8, 16384, 1e-3);
        invcali_rests_hold(&b.detector, i == 0 ? 3600000u : 4294967295u);
        hold(1, 3600);
        TEST_ASSERT_EQUAL_UINT(0, b.ready);
        keep(1, 30);
        TEST_ASSERT_EQUAL_UINT(1, b.ready);
    }
}

/* ---- what is reported meanwhile -------------------------------------------------------------- */

static void progress_rises_to_100_at_ready_and_falls_with_motion(void)
{
    unsigned before = 0;

    setup(100, 16384, 1e-3);
    for (unsigned i = 0; i < 300; i++) {
        sense(face[1], none);
        TEST_ASSERT_TRUE(b.progress >= before);
        TEST_ASSERT_EQUAL_INT(b.ready > 0, b.progress == 100);
        before = b.progress;
    }
    TEST_ASSERT_EQUAL_UINT(100, before);
    turn(1, 2, 1);
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    TEST_ASSERT_TRUE(b.progress < 100);
    turn(2, 3, 1);
    TEST_ASSERT_EQUAL_UINT(0, b.progress);
}

static void the_current_position_can_be_read_from_ready_on(void)
{
    uint32_t count = 0;

    setup(100, 16384, 1e-3);
    for (unsigned i = 0; i < 600; i++) {
        invcali_rest rest;
        memset(&rest, 0, sizeof rest);
        sense(face[1], none);
        TEST_ASSERT_EQUAL_INT(b.ready > 0, invcali_rests_get(&b.detector, &rest));
        TEST_ASSERT_TRUE(rest.count >= count);
        count = rest.count;
        TEST_ASSERT_EQUAL_UINT32(count, rest.end - rest.begin);
        TEST_ASSERT_EQUAL_INT(b.ready > 0, count > 0);
    }
    invcali_rest rest;
    TEST_ASSERT_EQUAL_INT(1, invcali_rests_get(&b.detector, &rest));
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    TEST_ASSERT_EQUAL_UINT32(rest.count, b.rest[0].count);
    TEST_ASSERT_EQUAL_INT64(rest.sum[1], b.rest[0].sum[1]);
    TEST_ASSERT_EQUAL_UINT32(rest.begin, b.rest[0].begin);
    TEST_ASSERT_EQUAL_UINT32(rest.end, b.rest[0].end);
    TEST_ASSERT_TRUE(rest.variance == b.rest[0].variance);
    TEST_ASSERT_EQUAL_INT(1, invcali_rests_get(&b.detector, &rest)); /* until the next sample */
    sense(face[1], none);
    TEST_ASSERT_EQUAL_INT(0, invcali_rests_get(&b.detector, &rest));
}

static void finish_answers_in_every_state(void)
{
    setup(100, 16384, 1e-3);
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVING, invcali_rests_finish(&b.detector));
    hold(0, 0.3);
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVING, invcali_rests_finish(&b.detector));
    setup(100, 16384, 1e-3);
    hold(0, 1.2); /* not enough, but not nothing */
    TEST_ASSERT_EQUAL_UINT(0, b.ready);
    TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcali_rests_finish(&b.detector));
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_SHORT, invcali_rests_reason(&b.detector));
    hold(0, 3);
    TEST_ASSERT_EQUAL_UINT(1, b.ready);
    TEST_ASSERT_EQUAL_INT(INVCAL_TAKEN, invcali_rests_finish(&b.detector));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_reason(&b.detector));
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVING, invcali_rests_finish(&b.detector));
    b.ready_before = 0;
    b.is_held = 0;
    turn(0, 1, 1);
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVING, invcali_rests_finish(&b.detector));
    hold(1, 3); /* the stream may go on */
    sense(face[1], none);
    sense(face[1], none);
    TEST_ASSERT_EQUAL_INT(INVCAL_TAKEN, invcali_rests_finish(&b.detector));
    for (unsigned i = 1; i <= 16; i++) { /* with a block of its own, of 16 samples */
        const invcal_event event = invcali_rests_feed(&b.detector, b.last);
        TEST_ASSERT_EQUAL_INT(i == 16, event != INVCAL_NOTHING);
    }
}

/* At 88 Hz blocks have 8 samples, and 0.62 s are 7 of them. At first 5 are skipped: half of those,
 * and the one that may have begun in motion. 2 are held back, so the eighth leaves a rest of one. */
static void a_rest_of_one_block_is_refused_as_short(void)
{
    setup(88, 16384, 1e-3);
    hold(0, 7.5 / 11);
    TEST_ASSERT_EQUAL_INT(INVCAL_MOVING, invcali_rests_finish(&b.detector));
    setup(88, 16384, 1e-3);
    hold(0, 8.5 / 11);
    TEST_ASSERT_EQUAL_INT(INVCAL_REFUSED, invcali_rests_finish(&b.detector));
    TEST_ASSERT_EQUAL_INT(INVCAL_REST_SHORT, invcali_rests_reason(&b.detector));
}

/* The next begins after as many blocks as after any motion. */
static void a_rest_that_continues_after_finish_is_another_one(void)
{
    setup(100, 16384, 1e-3);
    hold(1, 3);
    end_of_stream();
    turn(1, 2, 1);
    hold(2, 3);
    end_of_stream();
    keep(2, 3);
    turn(2, 3, 1);
    hold(3, 3);
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(3, b.taken);
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_SAME]);
    TEST_ASSERT_EQUAL_UINT(1, all_refused());
    setup(100, 16384, 1e-3);
    hold(1, 1.2);
    end_of_stream(); /* too short */
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_SHORT]);
    keep(1, 3);
    turn(1, 2, 1);
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    TEST_ASSERT_TRUE(b.rest[0].begin >= 112 + 48);
    TEST_ASSERT_TRUE(b.rest[0].begin <= 112 + 64);
}

/* ---- settings and hostile streams ------------------------------------------------------------- */

static void init_refuses_rates_and_rails_out_of_range(void)
{
    static const unsigned rates[] = {0, 1, 7, 8001, 32768, 65535};
    invcal_private_rests detector;
    invcal_private_rests before;

    memset(&detector, 0x5A, sizeof detector);
    memcpy(&before, &detector, sizeof before);
    for (unsigned i = 0; i < 6; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE,
                              invcali_rests_init(&detector, (invcal_real)rates[i]));
    }
    TEST_ASSERT_TRUE(memcmp(&before, &detector, sizeof detector) == 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_init(&detector, 8));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_init(&detector, 8000));
    TEST_ASSERT_EQUAL_UINT(0, invcali_rests_progress(&detector));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_reason(&detector));
    memcpy(&before, &detector, sizeof before);
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_LIMITS, invcali_rests_rails(&detector, 9, 9));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_LIMITS, invcali_rests_rails(&detector, 9, -9));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_LIMITS, invcali_rests_rails(&detector, 0, 0));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_LIMITS, invcali_rests_rails(&detector, INT32_MAX, INT32_MIN));
    TEST_ASSERT_TRUE(memcmp(&before, &detector, sizeof detector) == 0);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_rails(&detector, INT32_MIN, INT32_MAX));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_rests_rails(&detector, 0, 1));
}

static void random_bits_and_alternating_extremes_are_not_a_rest(void)
{
    for (unsigned kind = 0; kind < 3; kind++) {
        setup(kind == 2 ? 8000 : 100, 1, 0);
        for (uint32_t i = 0; i < 100000; i++) {
            int32_t raw[3];
            for (unsigned a = 0; a < 3; a++) {
                const int32_t end = (i + (kind == 2 ? a : 0)) & 1 ? INT32_MAX : INT32_MIN;
                raw[a] = kind ? end : whole(random_uniform(&b.random, -2147483648.0, 2147483647.0));
            }
            push(raw);
        }
        end_of_stream();
        TEST_ASSERT_EQUAL_UINT(0, b.taken);
        TEST_ASSERT_EQUAL_UINT(0, b.ready);
    }
}

/* The sensor jumps between ends and rests, with noise of one count, anywhere in int32. */
static void jumps_through_all_of_int32_overflow_nothing(void)
{
    static const int32_t at[] = {INT32_MIN + 40, INT32_MAX - 40, 0, -1000000000, 2000000000, 5};

    setup(200, 1, 0);
    for (unsigned k = 0; k < 6; k++) {
        b.truth[b.rests].begin = b.samples;
        for (unsigned i = 0; i < 600; i++) {
            int32_t raw[3];
            for (unsigned a = 0; a < 3; a++) {
                raw[a] = at[(k + a) % 6] + (int32_t)random_uniform(&b.random, -9, 9);
            }
            push(raw);
        }
        b.truth[b.rests++].end = b.samples;
    }
    end_of_stream();
    check_windows(6, 1.5);
}

static void ten_million_equal_samples_and_life_after(void)
{
    const int32_t raw[3] = {100, 200, 16000};

    setup(100, 16384, 1e-3);
    for (unsigned long i = 0; i < 10000000; i++) {
        note(invcali_rests_feed(&b.detector, raw));
    }
    TEST_ASSERT_EQUAL_UINT(1, b.refused[INVCAL_REST_FROZEN]);
    TEST_ASSERT_EQUAL_UINT(0, b.taken);
    turn(5, 1, 1);
    for (unsigned k = 1; k < 5; k++) {
        hold(k, 3);
        turn(k, k + 1, 1);
    }
    TEST_ASSERT_TRUE(b.taken >= 4);
    TEST_ASSERT_TRUE((long)b.rest[b.taken - 1].begin - 10000000 >= b.truth[3].begin);
}

/* At 8 Hz a block has 4 samples: 65535 blocks are soon full. */
static void a_rest_stops_growing_before_its_counters_overflow(void)
{
    setup(8, 16384, 1e-3);
    hold(1, 33000);
    invcali_rest rest;
    TEST_ASSERT_EQUAL_INT(1, invcali_rests_get(&b.detector, &rest));
    TEST_ASSERT_EQUAL_UINT32(65535u * 4, rest.count);
    keep(1, 100);
    end_of_stream();
    TEST_ASSERT_EQUAL_UINT(1, b.taken);
    TEST_ASSERT_EQUAL_UINT32(rest.count, b.rest[0].count);
    for (unsigned a = 0; a < 3; a++) {
        TEST_ASSERT_EQUAL_INT64(rest.sum[a], b.rest[0].sum[a]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-5, face[1][a], (double)rest.sum[a] / rest.count / 16384);
    }
}

/* After 2^32 samples, a week at 8 kHz, indices begin again; nothing else depends on them. */
static void the_count_of_samples_may_wrap(void)
{
    static bench plain;

    setup(100, 16384, 1e-3);
    six_rests(3);
    plain = b;
    setup(100, 16384, 1e-3);
    b.detector.time = UINT32_MAX - 300;
    six_rests(3);
    TEST_ASSERT_EQUAL_UINT32(plain.events, b.events);
    for (unsigned i = 0; i < 6; i++) {
        TEST_ASSERT_EQUAL_UINT32(plain.rest[i].count, b.rest[i].count);
        TEST_ASSERT_EQUAL_UINT32(plain.rest[i].begin - 301, b.rest[i].begin);
        TEST_ASSERT_EQUAL_UINT32(plain.rest[i].end - 301, b.rest[i].end);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_LONG_TEST(rests_are_found_from_10_hz_to_8_khz);
    RUN_TEST(rests_of_two_seconds_at_either_end_of_a_stream_count);
    RUN_LONG_TEST(random_streams_give_all_their_rests_and_nothing_else);
    RUN_LONG_TEST(a_turntable_never_rests);
    RUN_SLOW_TEST(motion_without_a_rest_gives_nothing);
    RUN_TEST(a_swinging_device_does_not_rest);
    RUN_TEST(sums_are_exact);
    RUN_TEST(variance_is_that_of_one_sample);
    RUN_TEST(a_block_is_an_eighth_of_a_second_or_four_samples);
    RUN_LONG_TEST(sums_are_exact_and_variance_too_for_any_offset_and_noise);
    RUN_TEST(nothing_overflows_at_the_largest_distance);
    RUN_SLOW_TEST(no_square_is_lost_in_a_block_of_any_size);
    RUN_TEST(samples_too_far_from_the_first_are_not_a_rest);
    RUN_TEST(a_dropped_block_leaves_nothing_in_the_next);
    RUN_TEST(a_coarse_sensor_is_summed_and_clipped_after_minutes_too);
    RUN_TEST(means_hold_all_bits_there_are);
    RUN_SLOW_TEST(unit_offset_and_order_of_the_axes_do_not_matter);
    RUN_TEST(a_copy_of_the_state_behaves_the_same);
    RUN_TEST(a_slow_turn_is_refused_for_drift_while_it_lasts);
    RUN_TEST(a_position_that_creeps_as_it_is_left_is_one);
    RUN_LONG_TEST(a_sensor_that_warms_up_is_at_rest);
    RUN_SLOW_TEST(a_warming_sensor_may_rest_for_minutes_at_first);
    RUN_TEST(what_is_shaken_is_moving_and_does_not_settle);
    RUN_TEST(a_few_counts_for_a_while_do_not_end_a_rest);
    RUN_TEST(a_rest_at_a_rail_is_refused_as_clipped);
    RUN_SLOW_TEST(a_sample_at_a_rail_or_beyond_is_clipped_on_any_axis_at_any_time);
    RUN_SLOW_TEST(a_rail_is_seen_from_any_distance);
    RUN_TEST(the_ends_of_int32_clip_where_no_rails_are_given);
    RUN_TEST(a_sensor_that_never_speaks_is_frozen_and_says_so_once);
    RUN_TEST(an_axis_that_stands_still_amid_noise_is_refused_as_frozen);
    RUN_TEST(where_there_is_little_noise_an_axis_may_stand_still);
    RUN_TEST(zeros_at_power_up_do_no_harm);
    RUN_TEST(a_sensor_that_freezes_in_motion_gives_no_rest);
    RUN_TEST(a_sensor_that_freezes_in_a_rest_ends_it);
    RUN_TEST(lost_samples_do_not_end_a_rest_that_goes_on);
    RUN_TEST(lost_samples_before_it_is_ready_do_not_refuse_a_rest);
    RUN_TEST(lost_samples_may_hide_a_motion);
    RUN_TEST(a_rest_cut_short_by_lost_samples_is_refused_for_the_gap);
    RUN_TEST(a_short_rest_is_refused_as_short);
    RUN_TEST(the_same_place_again_is_refused_once);
    RUN_TEST(a_knock_is_left_out_of_the_rest);
    RUN_TEST(counts_larger_than_the_noise_are_no_obstacle);
    RUN_TEST(two_counts_up_and_down_are_motion_where_there_is_no_noise);
    RUN_TEST(readings_that_toggle_by_one_count_are_one_rest);
    RUN_TEST(a_stream_that_begins_in_motion_learns_soon);
    RUN_SLOW_TEST(two_minutes_of_rest_are_one_position);
    RUN_TEST(a_fan_switched_on_is_a_new_noise_level);
    RUN_SLOW_TEST(a_rest_is_held_as_long_as_is_asked_and_no_longer);
    RUN_SLOW_TEST(no_time_to_hold_is_cut_short_at_any_rate);
    RUN_TEST(a_rest_left_before_its_time_is_refused_as_short);
    RUN_TEST(the_time_to_hold_may_change_in_the_midst_of_a_rest);
    RUN_TEST(faults_are_reported_before_the_time_has_passed);
    RUN_LONG_TEST(an_hour_is_the_longest_time_to_hold);
    RUN_TEST(progress_rises_to_100_at_ready_and_falls_with_motion);
    RUN_TEST(the_current_position_can_be_read_from_ready_on);
    RUN_TEST(finish_answers_in_every_state);
    RUN_TEST(a_rest_of_one_block_is_refused_as_short);
    RUN_TEST(a_rest_that_continues_after_finish_is_another_one);
    RUN_TEST(init_refuses_rates_and_rails_out_of_range);
    RUN_SLOW_TEST(random_bits_and_alternating_extremes_are_not_a_rest);
    RUN_TEST(jumps_through_all_of_int32_overflow_nothing);
    RUN_LONG_TEST(ten_million_equal_samples_and_life_after);
    RUN_LONG_TEST(a_rest_stops_growing_before_its_counters_overflow);
    RUN_TEST(the_count_of_samples_may_wrap);
    return UNITY_END();
}
