/* SPDX-License-Identifier: MIT */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "allan/noise.h"
#include "core/vector.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* How many samples the longest test of sums takes. A day at 1 kHz and more:
 *     make BUILD=build/day CFLAGS='-O2 -DLONG_RUN=100000000' build/day/float/test_allan */
#ifndef LONG_RUN
#ifdef __linux__
#define LONG_RUN 2000000
#else
#define LONG_RUN 200000 /* an emulator is a hundred times as slow */
#endif
#endif

enum { TAUS = INVCAL_ALLAN_TAUS, OVERLAP = INVCAL_PRIVATE_OVERLAP };

/* ---- exact sums by other means: no totals, no rings, no products of 64 bits ----------------- */

/* 256 bits in 16 digits: any sum fits. */
typedef struct {
    uint32_t digit[16];
} wide;

/* Adds x times 2^(16 place). */
static void wide_add(wide *sum, uint32_t x, unsigned place)
{
    for (; x > 0; place++) {
        sum->digit[place] += x & 0xFFFFu;
        x = (x >> 16) + (sum->digit[place] >> 16);
        sum->digit[place] &= 0xFFFFu;
    }
}

static void wide_add_square(wide *sum, int64_t d)
{
    const uint64_t size = d < 0 ? (uint64_t)-d : (uint64_t)d;

    for (unsigned i = 0; i < 4; i++) {
        for (unsigned j = 0; j < 4; j++) {
            wide_add(sum,
                     (uint32_t)(size >> 16 * i & 0xFFFFu) * (uint32_t)(size >> 16 * j & 0xFFFFu),
                     i + j);
        }
    }
}

static uint64_t wide_part(const wide *sum, unsigned place)
{
    uint64_t part = 0;

    for (unsigned i = 4; i-- > 0;) {
        part = part << 16 | sum->digit[place + i];
    }
    return part;
}

static double wide_value(const wide *sum)
{
    double value = 0;

    for (unsigned i = 16; i-- > 0;) {
        value = value * 65536 + sum->digit[i];
    }
    return value;
}

/* A sample as a function of its number, so that a batch needs no memory. */
typedef int32_t (*stream)(uint32_t i);

static uint32_t scrambled(uint32_t i)
{
    i = (i ^ i >> 16) * 0x7FEB352Du;
    i = (i ^ i >> 15) * 0x846CA68Bu;
    return i ^ i >> 16;
}

static int32_t any_int32(uint32_t i)
{
    const uint32_t x = scrambled(i);
    return x & 0x80000000u ? -(int32_t)(~x) - 1 : (int32_t)x;
}

static int32_t noise_of_12_bits(uint32_t i)
{
    return 33000 + (int32_t)(scrambled(i) >> 20);
}

static int32_t rail_to_rail(uint32_t i) /* for 512 samples each: the largest differences */
{
    return i >> 9 & 1u ? INT32_MAX : INT32_MIN;
}

static int32_t always_full(uint32_t i)
{
    (void)i;
    return INT32_MIN;
}

/* The sum of squares of one averaging time over samples 1 ... n, a window beginning at every
 * stride-th; added to what is there. Three windows' ends run through the stream. */
static uint32_t batch(stream s, uint32_t n, uint32_t m, uint32_t stride, wide *sum)
{
    int64_t newer = 0;
    int64_t older = 0;
    uint32_t count = 0;

    for (uint32_t i = 1; i <= n; i++) {
        newer += s(i);
        if (i > m) {
            newer -= s(i - m);
            older += s(i - m);
        }
        if (i > 2 * m) {
            older -= s(i - 2 * m);
        }
        if (i >= 2 * m && i % stride == 0) {
            wide_add_square(sum, newer - older);
            count++;
        }
    }
    return count;
}

/* The stride that memory allows. */
static uint32_t stride_of(uint32_t m)
{
    uint32_t stride = 1;

    while (m > OVERLAP * stride) {
        stride *= 2;
    }
    return stride;
}

static void feed(invcal_allan *a, stream s, uint32_t n)
{
    for (uint32_t i = 1; i <= n; i++) {
        invcal_allan_feed(a, s(i));
    }
}

/* Whatever was there before. */
static invcal_allan begun(const uint32_t *m, unsigned count, int is_apart)
{
    static invcal_allan a;

    memset(&a, 0xA5, sizeof a);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_init_taus(&a, sizeof a, m, count, is_apart));
    return a;
}

static invcal_allan octaves(void)
{
    static invcal_allan a;

    memset(&a, 0xA5, sizeof a);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_init(&a, sizeof a));
    return a;
}

static void check_sum(const invcal_allan *a, unsigned k, const wide *sum, uint32_t count)
{
    TEST_ASSERT_EQUAL_UINT32(count, a->own[k].count);
    TEST_ASSERT_TRUE(wide_part(sum, 0) == a->own[k].low);
    TEST_ASSERT_TRUE(wide_part(sum, 4) == a->own[k].high);
}

/* ...and that of the output. */
static void check_point(const invcal_allan *a, unsigned k, const wide *sum, uint32_t count)
{
    invcal_allan_point p;

    check_sum(a, k, sum, count);
    if (count == 0) {
        TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_allan_get(a, k, &p));
        return;
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(a, k, &p));
    const double adev = sqrt(wide_value(sum) / 2 / count) / a->own[k].m;
    TEST_ASSERT_EQUAL_UINT32(a->own[k].m, p.m);
    TEST_ASSERT_EQUAL_UINT32(count, p.count);
    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-7, 1e-15) * adev, adev, (double)p.adev);
}

static void check_stream(stream s, uint32_t n)
{
    invcal_allan a = octaves();

    feed(&a, s, n);
    for (unsigned k = 0; k < TAUS; k++) {
        wide sum = {{0}};
        const uint32_t m = UINT32_C(1) << k;
        check_point(&a, k, &sum, batch(s, n, m, stride_of(m), &sum));
    }
}

static void every_octave_is_exact(void)
{
    check_stream(noise_of_12_bits, SOME(20000) + 400);
    for (uint32_t n = 0; n < 10; n++) {
        check_stream(noise_of_12_bits, n);
    }
}

static void every_octave_is_exact_for_any_int32(void)
{
    check_stream(any_int32, SOME(20000) + 400);
    check_stream(rail_to_rail, 3000);
    check_stream(always_full, 300);
}

static void a_long_stream_is_exact(void)
{
    check_stream(noise_of_12_bits, LONG_RUN);
}

static void any_list_of_averaging_times_works(void)
{
    static const uint32_t m[] = {1, 3, 4, 6, 8, 12, 16, 24, 64, 96};
    invcal_allan a = begun(m, 10, 0);

    feed(&a, any_int32, 1000);
    for (unsigned k = 0; k < 10; k++) {
        wide sum = {{0}};
        check_point(&a, k, &sum, batch(any_int32, 1000, m[k], stride_of(m[k]), &sum));
    }
}

/* Two averaging times for each stride, or all strides different: all work. */
static void averaging_times_may_be_dense_or_sparse(void)
{
    enum { MANY = TAUS < 17 ? TAUS : 17 }; /* 2^14 times 2^16 is the longest */
    uint32_t dense[MANY];
    uint32_t sparse[MANY];

    for (unsigned k = 0; k < MANY; k++) {
        dense[k] = (k % 2 ? (uint32_t)OVERLAP : 3 * OVERLAP / 4u) << k / 2;
        sparse[k] = (uint32_t)OVERLAP << k;
    }
    for (unsigned is_sparse = 0; is_sparse < 2; is_sparse++) {
        const uint32_t *m = is_sparse ? sparse : dense;
        invcal_allan a = begun(m, MANY, 0);
        feed(&a, any_int32, 3000);
        for (unsigned k = 0; k < MANY; k++) {
            wide sum = {{0}};
            check_point(&a, k, &sum, batch(any_int32, 3000, m[k], stride_of(m[k]), &sum));
        }
    }
}

static void windows_apart_are_every_one_of_an_averaging_time(void)
{
    static const uint32_t m[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 64, 96};
    invcal_allan a = begun(m, 11, 1);

    feed(&a, any_int32, 1000);
    for (unsigned k = 0; k < 11; k++) {
        wide sum = {{0}};
        const uint32_t count = batch(any_int32, 1000, m[k], m[k], &sum);
        check_point(&a, k, &sum, count);
        TEST_ASSERT_EQUAL_UINT32(1000 / m[k] - 1, count);
    }
}

static void unusable_lists_are_refused(void)
{
    static const struct {
        uint32_t m[3];
        unsigned count;
        invcal_status expected;
    } list[] = {{{1, 2, 3}, 3, INVCAL_OK},
                {{1, 2, 3}, 0, INVCAL_BAD_TIME},
                {{1, 2, 3}, TAUS + 1, INVCAL_BAD_TIME},
                {{0, 2, 3}, 3, INVCAL_BAD_TIME},
                {{1, 3, 3}, 3, INVCAL_BAD_TIME},
                {{3, 2, 4}, 3, INVCAL_BAD_TIME},
                {{1, OVERLAP + 1, 3 * OVERLAP}, 3, INVCAL_BAD_TIME},
                {{1, 2, 4 * OVERLAP - 2}, 3, INVCAL_BAD_TIME},
                {{1, 2, INVCAL_ALLAN_LONGEST}, 3, INVCAL_OK},
                {{1, 2, INVCAL_ALLAN_LONGEST + 4}, 3, INVCAL_BAD_TIME},
                {{1, 2, 2 * INVCAL_ALLAN_LONGEST}, 3, INVCAL_BAD_TIME},
                {{1, 2, UINT32_MAX}, 3, INVCAL_BAD_TIME}};
    invcal_allan a;

    for (unsigned i = 0; i < sizeof list / sizeof *list; i++) {
        a = octaves();
        TEST_ASSERT_EQUAL_INT(list[i].expected,
                              invcal_allan_init_taus(&a, sizeof a, list[i].m, list[i].count, 0));
        const unsigned taus = list[i].expected == INVCAL_OK ? 3 : 0; /* 0: not begun */
        TEST_ASSERT_EQUAL_UINT(taus, a.taus);
        feed(&a, always_full, 100);
        TEST_ASSERT_EQUAL_UINT32(taus > 0 ? 99 : 0, a.own[0].count);
    }
}

/* Of a program that was built with other capacities: only that it was not begun is written, at the
 * same place in every build, and no sample is used. */
static void a_stream_of_another_size_takes_nothing(void)
{
    static const size_t sizes[] = {0, sizeof(invcal_allan) - 8, sizeof(invcal_allan) + 8};
    static const uint32_t m[] = {1, 2, 3};
    static const uint8_t fills[] = {0, 0x5A, 0xFF};
    invcal_allan_point p = {.m = 77};
    invcal_noise noise = {.misfit = 77};
    static invcal_allan before;
    static invcal_allan a;

    TEST_ASSERT_TRUE(offsetof(invcal_allan, taus) == 0);
    for (unsigned i = 0; i < 18; i++) {
        const size_t size = sizes[i % 3];
        memset(&a, fills[i / 6], sizeof a);
        memcpy(&before, &a, sizeof before);
        before.taus = 0;
        TEST_ASSERT_EQUAL_INT(INVCAL_OTHER_BUILD, i / 3 % 2
                                                      ? invcal_allan_init(&a, size)
                                                      : invcal_allan_init_taus(&a, size, m, 3, 0));
        TEST_ASSERT_EQUAL_MEMORY(&before, &a, sizeof before);
        feed(&a, always_full, 100);
        TEST_ASSERT_EQUAL_MEMORY(before.own, a.own, sizeof before.own);
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_COUNT, invcal_allan_get(&a, 0, &p));
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_BEGUN, invcal_allan_solve(&a, 1, &noise));
        TEST_ASSERT_TRUE(p.m == 77 && noise.misfit == 77);
    }
}

static void what_is_not_known_yet_is_not_shown(void)
{
    invcal_allan a = octaves();
    invcal_allan_point p = {.m = 77};
    invcal_noise noise = {.misfit = 77};

    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_allan_get(&a, 0, &p));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_COUNT, invcal_allan_get(&a, TAUS, &p));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_COUNT, invcal_allan_get(&a, UINT_MAX, &p));
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_allan_solve(&a, 1, &noise));
    feed(&a, always_full, 1000);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_allan_solve(&a, 1, &noise));
    TEST_ASSERT_EQUAL_UINT32(77, p.m);
    TEST_ASSERT_TRUE(noise.misfit == 77);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(&a, 2, &p));
    TEST_ASSERT_TRUE(p.adev == 0);
}

/* ---- gaps, and the ends of all numbers ------------------------------------------------------- */

static void no_difference_reaches_across_a_gap(void)
{
    static const uint32_t pieces[] = {700, 3, 1, 0, 64, 129};
    invcal_allan a = octaves();
    wide sum[10];
    uint32_t count[10] = {0};

    memset(sum, 0, sizeof sum);
    for (unsigned i = 0; i < 6; i++) {
        feed(&a, any_int32, pieces[i]);
        invcal_allan_gap(&a);
        for (unsigned k = 0; k < 10; k++) {
            const uint32_t m = UINT32_C(1) << k;
            count[k] += batch(any_int32, pieces[i], m, stride_of(m), &sum[k]);
        }
    }
    for (unsigned k = 0; k < 10; k++) {
        check_point(&a, k, &sum[k], count[k]);
    }
}

static void totals_may_pass_any_power_of_two(void)
{
    static const uint64_t ends[] = {0, UINT64_C(1) << 63, UINT64_C(1) << 32, UINT64_C(1) << 31};

    for (unsigned i = 0; i < 4; i++) {
        for (int64_t before = -60000; before <= 60000; before += 60000) {
            invcal_allan a = octaves();
            a.own_total = ends[i] + (uint64_t)before;
            invcal_allan_gap(&a);
            feed(&a, i & 1 ? any_int32 : noise_of_12_bits, 300);
            for (unsigned k = 0; k < 8; k++) {
                wide sum = {{0}};
                const uint32_t m = UINT32_C(1) << k;
                const uint32_t count =
                    batch(i & 1 ? any_int32 : noise_of_12_bits, 300, m, stride_of(m), &sum);
                check_sum(&a, k, &sum, count);
            }
        }
    }
}

/* As if there had been 2^32 - 4096 samples, all 0: their number passes 2^32, which acts as a
 * gap. */
static int32_t nothing_first(uint32_t i)
{
    return i <= 1024 ? 0 : any_int32(i);
}

static int32_t behind_4096(uint32_t i)
{
    return nothing_first(i + 4096);
}

static void the_number_of_samples_may_pass_32_bits(void)
{
    invcal_allan a = octaves();

    a.samples = UINT32_MAX - 4095;
    feed(&a, nothing_first, 4096 + 2000);
    for (unsigned k = 0; k < 9; k++) {
        wide sum = {{0}};
        const uint32_t m = UINT32_C(1) << k;
        const uint32_t stride = stride_of(m);
        (void)batch(nothing_first, 4095, m, stride, &sum);
        const uint32_t count = batch(behind_4096, 2000, m, stride, &sum);
        check_sum(&a, k, &sum, 4095 / stride + count);
    }
}

static void a_sum_that_does_not_fit_is_not_offered(void)
{
    invcal_allan a = octaves();
    invcal_allan_point p;

    a.own[0].low = UINT64_MAX - 1;
    a.own[0].high = UINT64_MAX;
    a.own[1].low = UINT64_MAX;
    feed(&a, rail_to_rail, 600);
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_SPACE, invcal_allan_get(&a, 0, &p));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(&a, 1, &p));
    feed(&a, noise_of_12_bits, 600);
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_SPACE, invcal_allan_get(&a, 0, &p));
}

static void counting_stops_before_it_would_overflow(void)
{
    invcal_allan a = octaves();

    a.own[0].count = UINT32_MAX - 10;
    feed(&a, noise_of_12_bits, 12);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, a.own[0].count);
    const uint64_t sum = a.own[0].low;
    feed(&a, noise_of_12_bits, 12);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, a.own[0].count);
    TEST_ASSERT_TRUE(sum == a.own[0].low);
}

static void the_deviation_is_right_for_sums_of_any_size(void)
{
    invcal_allan a = octaves();
    invcal_allan_point p;
    double expected = sqrt(7.0 / 6);

    a.own[0].count = 3;
    for (unsigned bit = 0; bit < 126; bit += 2) { /* 7 times a power of 4 */
        a.own[0].low = bit < 64 ? UINT64_C(7) << bit : 0;
        a.own[0].high = bit > 63 ? UINT64_C(7) << (bit - 64) : bit == 62 ? 1 : 0;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(&a, 0, &p));
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-7, 1e-15) * expected, expected,
                                  (double)p.adev);
        expected *= 2;
    }
    a.own[0].low = 0;
    a.own[0].high = 0;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(&a, 0, &p));
    TEST_ASSERT_TRUE(p.adev == 0);
}

/* ---- confidence ------------------------------------------------------------------------------ */

/* Of white noise, exactly: 2 E^2 / Var of the sum of squares of Gaussian differences, whose
 * covariances R(j) are those of the weights (1 ... 1, -1 ... -1): with n of them
 *     edf = n^2 R(0)^2 / (sum over i, j of R(i - j)^2). */
static double exact_edf(int32_t lag, int32_t stride, int32_t n)
{
    double sum = n;

    for (int32_t j = 1; j < n && j * stride < 2 * lag; j++) {
        int32_t r = 0;
        for (int32_t i = 0; i + j * stride < 2 * lag; i++) {
            r += (i < lag) == (i + j * stride < lag) ? 1 : -1;
        }
        const double share = (double)r / (2 * lag);
        sum += 2 * (double)(n - j) * share * share;
    }
    return (double)n * n / sum;
}

static void degrees_of_freedom_are_those_of_white_noise(void)
{
    static const uint32_t lengths[] = {40, 100, 333, 1000, 5000};
    static const uint32_t octave[] = {1, 2, 4, 8, 16, 32, 64, 128};

    for (unsigned i = 0; i < 5; i++) {
        for (int is_apart = 0; is_apart < 2; is_apart++) {
            invcal_allan a = begun(octave, 8, is_apart);
            feed(&a, noise_of_12_bits, lengths[i]);
            invcal_allan_point p;
            for (unsigned k = 0; k < 8 && invcal_allan_get(&a, k, &p) == INVCAL_OK; k++) {
                const uint32_t stride = is_apart ? p.m : stride_of(p.m);
                const double exact = exact_edf((int32_t)p.m, (int32_t)stride, (int32_t)p.count);
                TEST_ASSERT_DOUBLE_WITHIN((exact > 10 ? 0.03 : 0.1) * exact, exact, (double)p.edf);
                TEST_ASSERT_DOUBLE_WITHIN(1e-5, 1 / sqrt(2 * (double)p.edf), (double)p.relative);
            }
        }
    }
}

/* ---- simulated noise ------------------------------------------------------------------------- */

/* White noise; a random walk; and flicker noise as a sum of first-order processes of equal
 * variance v, their correlation times 1, 2, 4 ... samples. */
enum { PROCESSES = 22, HOLD = 16 };
typedef struct {
    random_source random;
    double white; /* counts */
    double step;  /* of the walk, per sample */
    double slow;  /* sqrt(v) */
    double walk;
    double state[PROCESSES];
    uint32_t time;
} source;

static source source_of(uint32_t seed, double white, double slow, double step)
{
    source s;

    memset(&s, 0, sizeof s);
    s.random = random_start(seed);
    s.white = white;
    s.slow = slow;
    s.step = step;
    for (unsigned i = 0; i < PROCESSES && slow > 0; i++) {
        s.state[i] = slow * random_normal(&s.random);
    }
    return s;
}

/* A process with a long correlation time takes a step every 1/16 of it. */
static double flicker(source *s)
{
    double sum = 0;

    for (unsigned i = 0; i < PROCESSES; i++) {
        const uint32_t time = UINT32_C(1) << i;
        const uint32_t hold = time > HOLD ? time / HOLD : 1;
        if (s->time % hold == 0) {
            const double kept = exp(-(double)hold / time);
            s->state[i] =
                kept * s->state[i] + s->slow * sqrt(1 - kept * kept) * random_normal(&s->random);
        }
        sum += s->state[i];
    }
    return sum;
}

static double reading(source *s)
{
    double x = s->white > 0 ? s->white * random_normal(&s->random) : 0;

    if (s->step > 0) {
        s->walk += s->step * random_normal(&s->random);
        x += s->walk;
    }
    if (s->slow > 0) {
        x += flicker(s);
    }
    s->time++;
    return x;
}

static void feed_noise(invcal_allan *a, source *s, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        invcal_allan_feed(a, (int32_t)floor(reading(s) + 0.5));
    }
}

#define RATE 100.0

static invcal_noise noise_of(const invcal_allan *a)
{
    invcal_noise noise;

    memset(&noise, 0xA5, sizeof noise);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_solve(a, (invcal_real)RATE, &noise));
    return noise;
}

/* What the coefficients must be. White noise of variance s^2 at rate f has density s^2 / f; a
 * random walk of steps q has K^2 = q^2 f. Flicker from its Allan variance: the mean of m samples
 * of one process has, with r = exp(-1 / time), the variance
 *     v (m (1 + r) / (1 - r) - 2 r (1 - r^m) / (1 - r)^2) / m^2
 * and neighbouring means the covariance v r (1 - r^m)^2 / (1 - r)^2 / m^2; their difference, summed
 * over all processes, is the plateau. In the limit of many processes it is 2 v. */
static double plateau(double v, double m)
{
    double sum = 0;

    for (unsigned i = 0; i < PROCESSES; i++) {
        const double r = exp(-1 / (double)(UINT32_C(1) << i));
        const double rest = 1 - pow(r, m);
        const double mean = m * (1 + r) / (1 - r) - 2 * r * rest / ((1 - r) * (1 - r));
        sum += v * (mean - r * rest * rest / ((1 - r) * (1 - r))) / (m * m);
    }
    return sum;
}

static double white_of(const source *s)
{
    return s->white / sqrt(RATE);
}

static double instability_of(const source *s)
{
    return s->slow * sqrt(2 / (2 * log(2.0) / acos(-1.0)));
}

static double walk_of(const source *s)
{
    return s->step * sqrt(RATE);
}

static void check_noise(const invcal_noise *noise, const source *s, double tolerance)
{
    const double expected[] = {white_of(s), instability_of(s), walk_of(s)};

    for (unsigned i = 0; i < INVCAL_NOISE_KINDS; i++) {
        TEST_ASSERT_EQUAL_INT(expected[i] > 0, noise->visible >> i & 1);
        TEST_ASSERT_DOUBLE_WITHIN(tolerance * expected[i], expected[i],
                                  (double)noise->coefficient[i]);
        TEST_ASSERT_EQUAL_INT(expected[i] > 0, noise->relative[i] > 0);
        TEST_ASSERT_TRUE(expected[i] > 0 || noise->relative[i] == 0);
    }
}

/* log2 of the ratio of deviations an octave apart, from index a to index b. */
static double slope(const invcal_allan *allan, unsigned a, unsigned b)
{
    invcal_allan_point p, q;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(allan, a, &p));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(allan, b, &q));
    return log((double)q.adev / (double)p.adev) / log((double)q.m / (double)p.m);
}

static void white_noise_has_slope_minus_half_and_its_coefficient(void)
{
    for (uint32_t seed = 1; seed <= 5; seed++) {
        invcal_allan a = octaves();
        source s = source_of(seed, 300, 0, 0);
        feed_noise(&a, &s, 100000);
        const invcal_noise noise = noise_of(&a);
        check_noise(&noise, &s, 0.02);
        TEST_ASSERT_TRUE((double)noise.misfit < 1.5);
        TEST_ASSERT_DOUBLE_WITHIN(0.03, -0.5, slope(&a, 0, 8));
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1 / RATE, (double)noise.shortest);
        TEST_ASSERT_DOUBLE_WITHIN(1e-3, 163.84, (double)noise.longest);
    }
}

static void a_random_walk_has_slope_half_and_its_coefficient(void)
{
    for (uint32_t seed = 1; seed <= 5; seed++) {
        static const uint32_t m[] = {4, 8, 16, 32, 64, 128, 256, 512};
        invcal_allan a = begun(m, 8, 0);
        source s = source_of(seed, 0, 0, 100);
        feed_noise(&a, &s, 100000);
        const invcal_noise noise = noise_of(&a);
        check_noise(&noise, &s, 0.1);
        TEST_ASSERT_DOUBLE_WITHIN(0.04, 0.5, slope(&a, 0, 5));
    }
}

static void flicker_noise_has_slope_0_and_its_coefficient(void)
{
    static const uint32_t m[] = {64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384};

    for (unsigned k = 0; k < 9; k++) { /* there is a plateau */
        TEST_ASSERT_DOUBLE_WITHIN(0.05, 2, plateau(1, m[k]));
    }
    for (uint32_t seed = 1; seed <= 5; seed++) {
        invcal_allan a = begun(m, 9, 0);
        source s = source_of(seed, 0, 400, 0);
        feed_noise(&a, &s, 400000);
        const invcal_noise noise = noise_of(&a);
        check_noise(&noise, &s, 0.1);
        TEST_ASSERT_DOUBLE_WITHIN(0.05, 0, slope(&a, 0, 5));
    }
}

/* All three, each where it is visible: they cross at 200 and at 1000 samples. */
static source mixed(uint32_t seed)
{
    return source_of(seed, 2000, 100, sqrt(3 * 2e4 / 1000));
}

static void a_mixture_is_taken_apart(void)
{
    for (uint32_t seed = 1; seed <= 2; seed++) {
        invcal_allan a = octaves();
        source s = mixed(seed);
        feed_noise(&a, &s, 1000000);
        const invcal_noise noise = noise_of(&a);
        check_noise(&noise, &s, 0.1);
    }
}

/* White noise of 1000 counts, and what must be distinguished from it. */
static invcal_noise noise_with(double ramp, double wave, uint32_t averaged)
{
    invcal_allan a = octaves();
    random_source random = random_start(3);
    double ring[8] = {0};
    double sum = 0;

    for (uint32_t i = 0; i < 100000; i++) {
        sum -= ring[i % averaged];
        ring[i % averaged] = 1000 * random_normal(&random) / averaged;
        sum += ring[i % averaged];
        invcal_allan_feed(&a, (int32_t)floor(sum + ramp * i + wave * sin(0.1 * i) + 0.5));
    }
    return noise_of(&a);
}

static void misfit_shows_noise_of_other_kinds(void)
{
    TEST_ASSERT_TRUE((double)noise_with(0, 0, 1).misfit < 1.5);
    TEST_ASSERT_TRUE((double)noise_with(0, 0, 2).misfit > 3);
    TEST_ASSERT_TRUE((double)noise_with(0, 0, 8).misfit > 3);
    TEST_ASSERT_TRUE((double)noise_with(0, 3000, 1).misfit > 3);
    TEST_ASSERT_TRUE((double)noise_with(0.1, 0, 1).misfit > 3);
}

/* ...and shows only in its last averaging time. */
static void a_slow_drift_counts_as_a_walk(void)
{
    const invcal_noise noise = noise_with(0.004, 0, 1);

    TEST_ASSERT_EQUAL_INT(1 << INVCAL_NOISE_WHITE | 1 << INVCAL_NOISE_WALK, noise.visible);
    TEST_ASSERT_DOUBLE_WITHIN(0.02 * 100, 100, (double)noise.coefficient[INVCAL_NOISE_WHITE]);
}

/* The scatter of coefficient `kind` over records of one source, over the sigma that each
 * reports. */
static double scatter(double white, double slow, double step, uint32_t samples, unsigned kind)
{
    const unsigned records = 60;
    double sum = 0;
    double squares = 0;
    double reported = 0;

    for (uint32_t seed = 0; seed < records; seed++) {
        invcal_allan a = octaves();
        source s = source_of(100 + seed, white, slow, step);
        feed_noise(&a, &s, samples);
        const invcal_noise noise = noise_of(&a);
        const double expected[] = {white_of(&s), instability_of(&s), walk_of(&s)};
        for (unsigned i = 0; i < INVCAL_NOISE_KINDS; i++) {
            TEST_ASSERT_EQUAL_INT(expected[i] > 0, noise.visible >> i & 1);
        }
        const double ratio = (double)noise.coefficient[kind] / expected[kind];
        sum += ratio / records;
        squares += ratio * ratio / records;
        reported += (double)noise.relative[kind] / records;
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.03, 1, sum);
    return sqrt(squares - sum * sum) / reported;
}

static void relative_is_the_scatter_and_nothing_spurious_is_seen(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(0.3, 1.0, scatter(500, 0, 0, 2000, INVCAL_NOISE_WHITE));
    TEST_ASSERT_DOUBLE_WITHIN(0.3, 0.5, scatter(500, 50, 0, 25000, INVCAL_NOISE_WHITE));
    TEST_ASSERT_DOUBLE_WITHIN(0.3, 0.75, scatter(500, 50, 0, 25000, INVCAL_NOISE_INSTABILITY));
    TEST_ASSERT_DOUBLE_WITHIN(0.3, 1.0, scatter(500, 0, 10, 20000, INVCAL_NOISE_WALK));
}

/* Sums like those of 10^6 differences with exactly the model's variance. */
static invcal_allan exact_curve(double white, double instability, double walk)
{
    invcal_allan a = octaves();

    for (unsigned k = 0; k < TAUS; k++) {
        invcal_private_tau *tau = &a.own[k];
        const double m = tau->m;
        const double variance = white * white / m +
                                2 * log(2.0) / acos(-1.0) * instability * instability +
                                walk * walk * m / 3;
        tau->count = 1000000;
        const double sum = 2 * variance * m * m * tau->count;
        tau->high = (uint64_t)(sum / 18446744073709551616.0);
        tau->low = (uint64_t)(sum - (double)tau->high * 18446744073709551616.0);
    }
    return a;
}

/* Whichever of the three there are come out, and no others. */
static void an_exact_curve_has_the_coefficients_it_was_made_from(void)
{
    static const double made_from[][INVCAL_NOISE_KINDS] = {
        {1e6, 0, 0},   {0, 1e6, 0},   {0, 0, 1e6},     {1e6, 3e5, 0},
        {1e6, 0, 3e3}, {0, 1e6, 3e4}, {1e6, 3e5, 3e3}, {1e6, 1e5, 3e3}};
    const double within = FLOAT_OR_DOUBLE(1e-3, 1e-9);

    needs_53_bits();
    for (unsigned i = 0; i < sizeof made_from / sizeof made_from[0]; i++) {
        const double *c = made_from[i];
        const invcal_allan a = exact_curve(c[0], c[1], c[2]);
        invcal_noise noise;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_solve(&a, 1, &noise));
        for (unsigned kind = 0; kind < INVCAL_NOISE_KINDS; kind++) {
            TEST_ASSERT_EQUAL_INT(c[kind] > 0, noise.visible >> kind & 1);
            TEST_ASSERT_DOUBLE_WITHIN(within * c[kind], c[kind], (double)noise.coefficient[kind]);
        }
        TEST_ASSERT_DOUBLE_WITHIN(1e-3, 0, (double)noise.misfit);
    }
}

/* Observed, not modelled: adev of 2^k samples falls until N^2 / tau and K^2 tau / 3 are equal, at
 * 300. */
static void the_minimum_is_the_lowest_deviation_seen(void)
{
    const invcal_allan a = exact_curve(1e6, 0, sqrt(3) * 1e6 / 300);
    invcal_allan_point p;
    invcal_noise noise;

    needs_53_bits();
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_solve(&a, 100, &noise));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(&a, 8, &p));
    TEST_ASSERT_EQUAL_UINT32(256, p.m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 2.56, (double)noise.best);
    TEST_ASSERT_TRUE(noise.minimum == p.adev);
}

/* White noise alone: adev^2 has the weight 1 / (2 / edf + 5 %^2) in each averaging time, N half the
 * relative standard deviation of its square. */
static void relative_is_that_of_weighted_least_squares(void)
{
    const invcal_allan a = exact_curve(1e6, 0, 0);
    invcal_allan_point p;
    invcal_noise noise;
    double weights = 0;

    needs_53_bits();
    for (unsigned k = 0; k < TAUS; k++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(&a, k, &p));
        weights += 1 / (2 / (double)p.edf + 0.05 * 0.05);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_solve(&a, 1, &noise));
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1 / sqrt(weights) / 2,
                              (double)noise.relative[INVCAL_NOISE_WHITE]);
}

static void unusable_rates_are_refused(void)
{
    /* the last two: white noise, or the times themselves, are beyond the number type */
    const double bad[] = {
        0, -1, NOT_A_NUMBER, INFINITE, 1 / (double)INVCAL_REAL_MAX, 4 / (double)INVCAL_REAL_MAX};
    invcal_allan a = octaves();
    invcal_noise noise = {.misfit = 77};

    feed(&a, noise_of_12_bits, 300);
    for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_RATE, invcal_allan_solve(&a, (invcal_real)bad[i], &noise));
    }
    TEST_ASSERT_TRUE(noise.misfit == 77);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_solve(&a, 1, &noise));
}

/* 4096 equally likely counts: a variance of (4096^2 - 1) / 12. */
static void a_few_samples_show_white_noise(void)
{
    invcal_allan a = octaves();
    invcal_noise noise;

    feed(&a, noise_of_12_bits, 400);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_solve(&a, 100, &noise));
    TEST_ASSERT_EQUAL_INT(1 << INVCAL_NOISE_WHITE, noise.visible);
    TEST_ASSERT_DOUBLE_WITHIN(10, 118.2, (double)noise.coefficient[INVCAL_NOISE_WHITE]);
    TEST_ASSERT_TRUE((double)noise.relative[INVCAL_NOISE_WHITE] < 0.06);
    TEST_ASSERT_TRUE(noise.coefficient[INVCAL_NOISE_INSTABILITY] == 0);
    TEST_ASSERT_TRUE(noise.coefficient[INVCAL_NOISE_WALK] == 0);
}

/* All that one averaging time shows: N = adev sqrt(tau). */
static void one_averaging_time_alone_passes_for_white_noise(void)
{
    const uint32_t m = 4;
    invcal_allan a = begun(&m, 1, 0);
    invcal_allan_point p;

    feed(&a, noise_of_12_bits, 400);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(&a, 0, &p));
    const invcal_noise noise = noise_of(&a);
    const double expected = (double)p.adev * sqrt(4 / RATE);
    TEST_ASSERT_EQUAL_INT(1 << INVCAL_NOISE_WHITE, noise.visible);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6 * expected, expected,
                              (double)noise.coefficient[INVCAL_NOISE_WHITE]);
    TEST_ASSERT_TRUE(noise.coefficient[INVCAL_NOISE_INSTABILITY] == 0);
    TEST_ASSERT_TRUE(noise.coefficient[INVCAL_NOISE_WALK] == 0);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 0, (double)noise.misfit); /* one equation, one unknown */
    TEST_ASSERT_DOUBLE_WITHIN(1e-7, 4 / RATE, (double)noise.best);
    TEST_ASSERT_DOUBLE_WITHIN(1e-7, 4 / RATE, (double)noise.longest);
}

/* From rail to rail with every sample, and hardly a count from pair to pair: the two deviations
 * are 3e9 and 0.05, and the fourth power of their ratio is no float. */
static void a_curve_beyond_the_number_type_gives_nothing(void)
{
    const uint32_t m[] = {1, 2};
    invcal_allan a = begun(m, 2, 0);
    invcal_noise noise = {.misfit = 77};

    for (int i = 0; i < 200; i++) {
        invcal_allan_feed(&a, i % 2 ? INT32_MAX : INT32_MIN + (i == 100));
    }
    const invcal_status status = invcal_allan_solve(&a, 100, &noise);
    TEST_ASSERT_EQUAL_INT(FLOAT_OR_DOUBLE(INVCAL_TOO_FEW, INVCAL_OK), status);
    TEST_ASSERT_EQUAL_INT(status != INVCAL_OK, noise.misfit == 77);
    for (unsigned i = 0; i < INVCAL_NOISE_KINDS && status == INVCAL_OK; i++) {
        TEST_ASSERT_TRUE(isfinite(noise.coefficient[i]) && noise.coefficient[i] >= 0);
    }
}

/* ---- dwell ----------------------------------------------------------------------------------- */

static invcal_noise data_sheet(double n, double b, double k)
{
    invcal_noise noise;

    memset(&noise, 0, sizeof noise);
    noise.coefficient[INVCAL_NOISE_WHITE] = (invcal_real)n;
    noise.coefficient[INVCAL_NOISE_INSTABILITY] = (invcal_real)b;
    noise.coefficient[INVCAL_NOISE_WALK] = (invcal_real)k;
    return noise;
}

static void check_dwell(const invcal_noise *noise, double wanted, double seconds, double sigma,
                        invcal_dwell_end end)
{
    const double within = FLOAT_OR_DOUBLE(3e-6, 1e-9);
    invcal_dwell dwell;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_noise_dwell(noise, (invcal_real)wanted, &dwell));
    TEST_ASSERT_EQUAL_INT(end, dwell.end);
    TEST_ASSERT_DOUBLE_WITHIN(within * seconds, seconds, (double)dwell.seconds);
    TEST_ASSERT_DOUBLE_WITHIN(within * sigma, sigma, (double)dwell.sigma);
}

static void dwell_is_the_shortest_time_that_is_enough(void)
{
    const double floor_of_b = sqrt(2 * log(2.0) / acos(-1.0));
    invcal_noise noise = data_sheet(1e-3, 0, 0);

    check_dwell(&noise, 1e-4, 100, 1e-4, INVCAL_DWELL_BEYOND);
    noise.longest = 99;
    check_dwell(&noise, 1e-4, 100, 1e-4, INVCAL_DWELL_BEYOND);
    noise.longest = 101;
    check_dwell(&noise, 1e-4, 100, 1e-4, INVCAL_DWELL_REACHED);
    noise.shortest = (invcal_real)0.01;
    check_dwell(&noise, 1, 0.01, 0.01, INVCAL_DWELL_REACHED);
    noise.coefficient[INVCAL_NOISE_INSTABILITY] = (invcal_real)(6e-4 / floor_of_b);
    check_dwell(&noise, 1e-3, 1 / 0.64, 1e-3, INVCAL_DWELL_REACHED);
    /* 1e-6 / T + 1e-8 T = 2.0e-7 + 0.5e-8: T = 5 or 20 */
    noise = data_sheet(1e-3, 0, sqrt(3e-8));
    noise.longest = 100;
    check_dwell(&noise, sqrt(25e-8), 5, sqrt(25e-8), INVCAL_DWELL_REACHED);
    /* exactly the longest time seen, without rounding */
    noise = data_sheet(1, 0, 0);
    noise.longest = 4;
    check_dwell(&noise, 0.5, 4, 0.5, INVCAL_DWELL_REACHED);
}

static void dwell_ends_at_the_minimum_if_nothing_is_enough(void)
{
    const double floor_of_b = sqrt(2 * log(2.0) / acos(-1.0));
    invcal_noise noise = data_sheet(1e-3, 0, sqrt(3e-8));

    check_dwell(&noise, sqrt(19e-8), 10, sqrt(20e-8), INVCAL_DWELL_FLOOR);
    noise.coefficient[INVCAL_NOISE_INSTABILITY] = (invcal_real)(sqrt(5e-8) / floor_of_b);
    check_dwell(&noise, sqrt(24e-8), 10, sqrt(25e-8), INVCAL_DWELL_FLOOR);
    check_dwell(&noise, sqrt(1e-8), 10, sqrt(25e-8), INVCAL_DWELL_FLOOR);
    noise.coefficient[INVCAL_NOISE_WALK] = 0;
    check_dwell(&noise, sqrt(4e-8), 1e-6 / (5e-8 * 0.1025), 1.05 * sqrt(5e-8), INVCAL_DWELL_FLOOR);
    /* only a walk: the first sample is the best, and may be too bad */
    noise = data_sheet(0, 0, sqrt(3e-8));
    noise.shortest = 1;
    check_dwell(&noise, 2e-4, 1, 1e-4, INVCAL_DWELL_BEYOND);
    check_dwell(&noise, 0.5e-4, 1, 1e-4, INVCAL_DWELL_FLOOR);
}

static void no_dwell_comes_from_invalid_noise(void)
{
    static const double bad[] = {-1, NOT_A_NUMBER, INFINITE};
    invcal_noise noise = data_sheet(1e-3, 1e-4, 1e-5);
    invcal_dwell dwell = {.seconds = 77};

    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, invcal_noise_dwell(&noise, 0, &dwell));
    for (unsigned i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE,
                              invcal_noise_dwell(&noise, (invcal_real)bad[i], &dwell));
        for (unsigned k = 0; k < INVCAL_NOISE_KINDS; k++) {
            invcal_noise other = noise;
            other.coefficient[k] = (invcal_real)bad[i];
            TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE,
                                  invcal_noise_dwell(&other, (invcal_real)1e-4, &dwell));
        }
    }
    for (unsigned k = 0; k < 2; k++) {
        noise.coefficient[INVCAL_NOISE_WHITE] = 0;
        TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE,
                              invcal_noise_dwell(&noise, (invcal_real)1e-4, &dwell));
        noise = data_sheet(0, 0, 0);
    }
    noise.shortest = 1; /* no time is too short, but there is no sigma */
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_NOISE, invcal_noise_dwell(&noise, (invcal_real)1e-4, &dwell));
    TEST_ASSERT_TRUE(dwell.seconds == 77);
    noise = data_sheet(1, 1, 0); /* float cannot hold the square of so small a target */
    noise.shortest = INVCAL_REAL(0.01);
    TEST_ASSERT_TRUE(invcal_noise_dwell(&noise, INVCAL_REAL(1e-20), &dwell) == INVCAL_BAD_NOISE ||
                     dwell.seconds > 1);
}

/* Positions one after the other, each the mean of n samples, in sessions of `positions`: the
 * variance about the mean of the session, counts^2. */
static double variance_of_means(source *s, uint32_t n, unsigned positions, unsigned sessions)
{
    double total = 0;

    for (unsigned k = 0; k < sessions; k++) {
        double sum = 0;
        double squares = 0;
        double origin = 0;
        for (unsigned i = 0; i < positions; i++) {
            double mean = 0;
            for (uint32_t j = 0; j < n; j++) {
                mean += reading(s) / n;
            }
            origin = i == 0 ? mean : origin;
            sum += mean - origin;
            squares += (mean - origin) * (mean - origin);
        }
        total += (squares - sum * sum / positions) / (positions - 1);
    }
    return total / sessions;
}

/* Of two: half the square of their difference, which is the definition; the model is not. */
static void means_are_as_good_as_dwell_says(void)
{
    invcal_allan a = octaves();
    source s = mixed(9);
    invcal_dwell dwell;

    feed_noise(&a, &s, 500000);
    const invcal_noise noise = noise_of(&a);
    for (double wanted = 225; wanted < 950; wanted *= 2) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_noise_dwell(&noise, (invcal_real)wanted, &dwell));
        TEST_ASSERT_EQUAL_INT(INVCAL_DWELL_REACHED, dwell.end);
        const double samples = (double)dwell.seconds * RATE;
        const double variance = variance_of_means(&s, (uint32_t)(samples + 0.5), 2, 1500);
        TEST_ASSERT_DOUBLE_WITHIN(0.08 * wanted, wanted, sqrt(variance));
    }
}

/* Over 18 positions slow noise adds: 1, n ln n / (2 (n - 1) ln 2), n / 2 times adev^2. */
static void slow_noise_does_more_over_a_session(void)
{
    const unsigned n = 18;
    const uint32_t samples = 64;
    source white = source_of(3, 1000, 0, 0);
    source slow = source_of(3, 0, 1000, 0);
    source walk = source_of(3, 0, 0, 10);
    const double flickers = n * log((double)n) / (2 * (n - 1) * log(2.0));

    TEST_ASSERT_DOUBLE_WITHIN(0.05, 1, variance_of_means(&white, samples, n, 200) * samples / 1e6);
    TEST_ASSERT_DOUBLE_WITHIN(0.1 * flickers, flickers,
                              variance_of_means(&slow, samples, n, 400) / plateau(1e6, samples));
    TEST_ASSERT_DOUBLE_WITHIN(0.15 * n / 2, n / 2.0,
                              variance_of_means(&walk, samples, n, 600) / (100 * samples / 3.0));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(every_octave_is_exact);
    RUN_TEST(every_octave_is_exact_for_any_int32);
    RUN_LONG_TEST(a_long_stream_is_exact);
    RUN_TEST(any_list_of_averaging_times_works);
    RUN_TEST(averaging_times_may_be_dense_or_sparse);
    RUN_TEST(windows_apart_are_every_one_of_an_averaging_time);
    RUN_TEST(unusable_lists_are_refused);
    RUN_TEST(a_stream_of_another_size_takes_nothing);
    RUN_TEST(what_is_not_known_yet_is_not_shown);
    RUN_TEST(no_difference_reaches_across_a_gap);
    RUN_TEST(totals_may_pass_any_power_of_two);
    RUN_TEST(the_number_of_samples_may_pass_32_bits);
    RUN_TEST(a_sum_that_does_not_fit_is_not_offered);
    RUN_TEST(counting_stops_before_it_would_overflow);
    RUN_TEST(the_deviation_is_right_for_sums_of_any_size);
    RUN_TEST(degrees_of_freedom_are_those_of_white_noise);
    RUN_LONG_TEST(white_noise_has_slope_minus_half_and_its_coefficient);
    RUN_LONG_TEST(a_random_walk_has_slope_half_and_its_coefficient);
    RUN_LONG_TEST(flicker_noise_has_slope_0_and_its_coefficient);
    RUN_LONG_TEST(a_mixture_is_taken_apart);
    RUN_LONG_TEST(misfit_shows_noise_of_other_kinds);
    RUN_LONG_TEST(a_slow_drift_counts_as_a_walk);
    RUN_LONG_TEST(relative_is_the_scatter_and_nothing_spurious_is_seen);
    RUN_TEST(an_exact_curve_has_the_coefficients_it_was_made_from);
    RUN_TEST(the_minimum_is_the_lowest_deviation_seen);
    RUN_TEST(relative_is_that_of_weighted_least_squares);
    RUN_TEST(unusable_rates_are_refused);
    RUN_TEST(a_few_samples_show_white_noise);
    RUN_TEST(one_averaging_time_alone_passes_for_white_noise);
    RUN_TEST(a_curve_beyond_the_number_type_gives_nothing);
    RUN_TEST(dwell_is_the_shortest_time_that_is_enough);
    RUN_TEST(dwell_ends_at_the_minimum_if_nothing_is_enough);
    RUN_TEST(no_dwell_comes_from_invalid_noise);
    RUN_LONG_TEST(means_are_as_good_as_dwell_says);
    RUN_LONG_TEST(slow_noise_does_more_over_a_session);
    return UNITY_END();
}
