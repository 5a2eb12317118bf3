/* SPDX-License-Identifier: MIT
 *
 * The records of calibrations: texts, dates, the line for headings.
 */
#include "result/record.h"

#include <string.h>

#include "support.h"
#include "unity.h"

static record r;

void setUp(void)
{
    r = (record){.text = {""}};
}

void tearDown(void)
{
}

static int takes(record_text which, const char *text)
{
    const record before = r;
    const char *problem = record_set(&r, which, text);

    /* either it was added, or nothing has changed */
    TEST_ASSERT_TRUE(problem ? memcmp(&r, &before, sizeof r) == 0
                             : strcmp(r.text[which], text) == 0);
    return problem == NULL;
}

static void dates_are_days_of_the_calendar(void)
{
    static const char *const good[] = {"2026-11-23", "2024-02-29", "2000-02-29", "0000-01-31"};
    static const char *const bad[] = {"2026-02-29", "1900-02-29",  "2026-04-31", "2026-13-01",
                                      "2026-00-10", "2026-01-00",  "2026-1-01",  "26-01-01",
                                      "2026/01/01", "2026-01-011", "2026-01-0x", "-026-01-01",
                                      "23.11.2026", "2026-01-",    "2026-01-1 "};

    for (unsigned i = 0; i < sizeof good / sizeof *good; i++) {
        TEST_ASSERT_TRUE_MESSAGE(takes(RECORD_DATE, good[i]), good[i]);
    }
    for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++) {
        TEST_ASSERT_FALSE_MESSAGE(takes(RECORD_DATE, bad[i]), bad[i]);
        TEST_ASSERT_TRUE_MESSAGE(takes(RECORD_NOTE, bad[i]), bad[i]);
    }
}

static void texts_are_plain(void)
{
    static const char *const bad[] = {"a\nb", "\033[31m", "\x7f", "\xc2\x9b", "\xff", "caf\xe9"};

    TEST_ASSERT_TRUE(takes(RECORD_OPERATOR, "J\xc3\xbcrgen \"<&>' \xf0\x9f\x98\x80 \xc2\xa0"));
    for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++) {
        TEST_ASSERT_FALSE(takes(RECORD_SERIAL, bad[i]));
    }
}

static void texts_are_as_long_as_the_space(void)
{
    char text[RECORD_MAX + 1];

    memset(text, 'a', sizeof text);
    text[159] = '\0';
    TEST_ASSERT_TRUE(takes(RECORD_NOTE, text));
    text[159] = 'a';
    text[160] = '\0';
    TEST_ASSERT_FALSE(takes(RECORD_NOTE, text));
}

static void a_line_has_what_there_is(void)
{
    char text[RECORD_LINE_MAX];

    TEST_ASSERT_TRUE(record_is_empty(&r));
    TEST_ASSERT_EQUAL_STRING("", record_line(&r, text));
    TEST_ASSERT_TRUE(takes(RECORD_DATE, "2026-11-23"));
    TEST_ASSERT_FALSE(record_is_empty(&r));
    TEST_ASSERT_EQUAL_STRING("2026-11-23", record_line(&r, text));
    TEST_ASSERT_TRUE(takes(RECORD_SERIAL, "47"));
    TEST_ASSERT_TRUE(takes(RECORD_NOTE, "not here"));
    TEST_ASSERT_EQUAL_STRING("serial 47 · 2026-11-23", record_line(&r, text));
    TEST_ASSERT_TRUE(takes(RECORD_DEVICE, "ADXL355"));
    TEST_ASSERT_EQUAL_STRING("ADXL355 · serial 47 · 2026-11-23", record_line(&r, text));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(dates_are_days_of_the_calendar);
    RUN_TEST(texts_are_plain);
    RUN_TEST(texts_are_as_long_as_the_space);
    RUN_TEST(a_line_has_what_there_is);
    return UNITY_END();
}
