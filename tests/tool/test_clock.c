/* SPDX-License-Identifier: MIT
 *
 * Tests of port/host/text/clock.c. Expected values: date -u -d '2026-11-24 12:34:56' +%s and the like, of GNU coreutils.
 */
#include "text/clock.h"
#include "unity.h"

void setUp(void)
{
}
void tearDown(void)
{
}

static void is(double expected, const char *text)
{
    double seconds = -1;

    TEST_ASSERT_EQUAL_INT_MESSAGE(1, clock_parse(text, &seconds), text);
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(3e-7, expected, seconds, text);
}

static void is_none(const char *text)
{
    double seconds = -1;

    TEST_ASSERT_EQUAL_INT_MESSAGE(0, clock_parse(text, &seconds), text);
    TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(-1, seconds, text);
}

static void test_times_of_the_day(void)
{
    is(0, "00:00:00");
    is(45296, "12:34:56");
    is(45296.789, "12:34:56.789");
    is(86399.999999, "23:59:59.999999");
    is(86400, "23:59:60");
}

static void test_dates(void)
{
    is(0, "1970-01-01 00:00:00");
    is(1795523696, "2026-11-24 12:34:56");
    is(1795523696.25, "2026-11-24T12:34:56.25");
    is(951782400, "2000-02-29T00:00:00");
    is(951868800, "2000-03-01 00:00:00");
    is(4107542400, "2100-03-01 00:00:00");
    is(-86400, "1969-12-31 00:00:00");
}

/* The clock as shown. */
static void test_zones(void)
{
    is(1795523696, "2026-11-24T12:34:56Z");
    is(1795523696.5, "2026-11-24T12:34:56.5+02:00");
    is(45296, "12:34:56-05:30");
}

static void test_what_is_none(void)
{
    is_none("");
    is_none("12");
    is_none("12.5");
    is_none("12:34");
    is_none("1:02:03");
    is_none("24:00:00");
    is_none("12:60:00");
    is_none("12:34:61");
    is_none("12:34:56,5");
    is_none("12:34:56.");
    is_none("12:34:56 ");
    is_none("12:34:56x");
    is_none("2026-11-24");
    is_none("2026-11-24 ");
    is_none("2026-13-01 00:00:00");
    is_none("2026-00-01 00:00:00");
    is_none("2026-11-32 00:00:00");
    is_none("0000-11-24 00:00:00");
    is_none("24.11.2026 12:34:56");
    is_none("2026-11-24_12:34:56");
    is_none("12:34:56+2");
    is_none("12:34:56+15:00");
    is_none("12:34:56+02:00Z");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_times_of_the_day);
    RUN_TEST(test_dates);
    RUN_TEST(test_zones);
    RUN_TEST(test_what_is_none);
    return UNITY_END();
}
