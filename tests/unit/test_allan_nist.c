/* SPDX-License-Identifier: MIT
 *
 * The Allan deviation with more overlap than the library's default: the same source, compiled
 * again under other names. In a double library it has other names already.
 */
#undef INVCAL_ALLAN_TAUS
#undef INVCAL_PRIVATE_OVERLAP
#define INVCAL_ALLAN_TAUS 8
#define INVCAL_PRIVATE_OVERLAP 128
#include "invcal/double.h"

#undef invcal_allan_init
#define invcal_allan_init wide_allan_init
#undef invcal_allan_init_taus
#define invcal_allan_init_taus wide_allan_begin
#undef invcal_allan_feed
#define invcal_allan_feed wide_allan_push
#undef invcal_allan_gap
#define invcal_allan_gap wide_allan_gap
#undef invcal_allan_get
#define invcal_allan_get wide_allan_get
#include "../../src/allan/allan.c"

#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* NIST SP 1065, section 12.4: n -> 16807 n mod 2147483647 from 1234567890, y = n / 2147483647. */
enum { POINTS = 1000 };
static const uint32_t modulus = 2147483647;

static const uint32_t taus[] = {1, 10, 100};
/* Table 31: Allan and overlapping Allan deviation at tau = 1, 10, 100. */
static const double apart[] = {2.922319e-01, 9.965736e-02, 3.897804e-02};
static const double overlapping[] = {2.922319e-01, 9.159953e-02, 3.241343e-02};

static invcal_allan a;

static void feed(int is_apart)
{
    uint32_t n = 1234567890;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_init_taus(&a, sizeof a, taus, 3, is_apart));
    for (unsigned i = 0; i < POINTS; i++) {
        invcal_allan_feed(&a, (int32_t)n);
        n = (uint32_t)(UINT64_C(16807) * n % modulus);
    }
}

/* Seven digits are published: half of the last is up to 1.7e-7 of the value. */
static void check(const double *expected, unsigned index, uint32_t count)
{
    invcal_allan_point p;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_allan_get(&a, index, &p));
    TEST_ASSERT_EQUAL_UINT32(count, p.count);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6 * expected[index], expected[index],
                              (double)p.adev / (double)modulus);
}

static void the_overlapping_deviation_is_that_of_nist(void)
{
    feed(0);
    for (unsigned i = 0; i < 3; i++) {
        check(overlapping, i, POINTS + 1 - 2 * taus[i]);
    }
}

static void the_deviation_with_windows_apart_is_that_of_nist(void)
{
    feed(1);
    for (unsigned i = 0; i < 3; i++) {
        check(apart, i, POINTS / taus[i] - 1);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_overlapping_deviation_is_that_of_nist);
    RUN_TEST(the_deviation_with_windows_apart_is_that_of_nist);
    return UNITY_END();
}
