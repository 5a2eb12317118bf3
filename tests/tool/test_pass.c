/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "result/need.h"
#include "result/pass.h"
#include "support.h"
#include "text/number.h"
#include "unity.h"

static calibrate_result result;
static double limits[3];
static char text[PASS_MAX];

static void state(const double *of_kind)
{
    result.has_limits = of_kind != NULL;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        result.limit[r] = of_kind ? of_kind[r / 3] : NOT_A_NUMBER;
    }
}

/* 10 mg, 1 % and 0.01 rad are limits; offsets are 4 mg, scales 0.4 %, angles 4 mrad, and ± of 95 %
 * half of that: each uses 0.6 of its limit. Lengths are right within 0.5 mg, of which 0.3 are the
 * field's. */
void setUp(void)
{
    const double x[] = {4e-3, -4e-3, 4e-3, -4e-3, 4e-3, 4e-3, 4e-3, 4e-3, -4e-3};

    memset(&result, 0, sizeof result);
    limits[0] = limits[1] = limits[2] = 0.01;
    result.settings.field = 9.80665;
    result.quality.verdict = INVCAL_GOOD;
    result.quality.noise = 1e-4;
    result.quality.coverage = 2.5;
    memcpy(result.solution.x, x, sizeof x);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        result.quality.sigma[r] = 0.8e-3;
    }
    state(limits);
    result.accuracy = 0.4e-3;
    result.field_sigma = 0.3e-3 / 1.959964;
    result.need = 9.80665e-3;
    result.need_unit = (display_unit){1e3, "mg"};
}

void tearDown(void)
{
}

static void a_limit_holds_value_and_interval(void)
{
    pass p = pass_judge(&result);

    TEST_ASSERT_TRUE(p.has_criteria && p.is_passed);
    TEST_ASSERT_EQUAL_HEX16(0x1FF, p.limited);
    TEST_ASSERT_EQUAL_HEX16(0, p.failed | p.beyond);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.6, p.used[r]);
    }
    result.solution.x[4] = 8.1e-3; /* 8.1 and 2 make 10.1: perhaps within, but not surely */
    p = pass_judge(&result);
    TEST_ASSERT_FALSE(p.is_passed);
    TEST_ASSERT_EQUAL_HEX16(1u << 4, p.failed);
    TEST_ASSERT_EQUAL_HEX16(0, p.beyond);
    TEST_ASSERT_EQUAL_UINT(4, p.nearest);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1.01, p.used[4]);
    result.solution.x[4] = 12.1e-3; /* at least 10.1 */
    p = pass_judge(&result);
    TEST_ASSERT_EQUAL_HEX16(1u << 4, p.failed & p.beyond);
    result.solution.x[4] = 8e-3; /* 10 of 10 */
    result.quality.sigma[4] = 0.5e-3;
    result.quality.coverage = 4;
    limits[1] = 0.01 + 1e-15;
    TEST_ASSERT_EQUAL_HEX16(0, pass_judge(&result).failed);
}

static void a_need_covers_the_errors_of_lengths_and_of_the_field(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.5, pass_judge(&result).need_used);
    result.need = 0.4 * 9.80665e-3;
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1.25, pass_judge(&result).need_used);
    TEST_ASSERT_FALSE(pass_judge(&result).is_passed);
    result.need = 0;
    TEST_ASSERT_TRUE(isnan(pass_judge(&result).need_used));
    TEST_ASSERT_TRUE(pass_judge(&result).is_passed);
}

static void what_is_unknown_or_not_good_does_not_pass(void)
{
    static const invcal_verdict others[] = {INVCAL_NO_REDUNDANCY, INVCAL_WEAK, INVCAL_ROUGH,
                                            INVCAL_DRIFTING, INVCAL_BENT};

    for (unsigned i = 0; i < sizeof others / sizeof *others; i++) {
        result.quality.verdict = others[i];
        TEST_ASSERT_FALSE(pass_judge(&result).is_passed);
    }
    result.quality.verdict = INVCAL_GOOD;
    result.rejected.suspected = 2; /* contradictory */
    result.rejected.kept_count = 18;
    TEST_ASSERT_FALSE(pass_judge(&result).is_passed);
    result.rejected.suspected = 0;
    TEST_ASSERT_TRUE(pass_judge(&result).is_passed);
    result.quality.noise = 1; /* unknown */
    TEST_ASSERT_FALSE(pass_judge(&result).is_passed);
    TEST_ASSERT_EQUAL_HEX16(0x1FF, pass_judge(&result).failed);
    TEST_ASSERT_EQUAL_HEX16(0, pass_judge(&result).beyond);
    result.need = 0;
    TEST_ASSERT_FALSE(pass_judge(&result).is_passed);
    result.quality.noise = 1e-4;
    result.solution.x[0] = NOT_A_NUMBER;
    TEST_ASSERT_EQUAL_HEX16(1, pass_judge(&result).failed & pass_judge(&result).beyond);
    state(NULL);
    TEST_ASSERT_FALSE(pass_judge(&result).has_criteria || pass_judge(&result).is_passed);
}

static void the_line_has_the_margins(void)
{
    TEST_ASSERT_EQUAL_STRING(
        "PASS: |a| within 0.50 of 1.0 mg; offset x up to 6.00 of 10.0 mg (95 %).",
        pass_text(&result, text));
    TEST_ASSERT_EQUAL_STRING("", pass_strict(&result, text));
    result.need = 0.498e-3 * 9.80665; /* less than 0.5 mg, and alike with two digits */
    state(NULL);
    TEST_ASSERT_EQUAL_STRING("FAIL: |a| within 0.500 of 0.498 mg (95 %).",
                             pass_text(&result, text));
    state(limits);
    result.need = 0;
    result.solution.x[8] = -18e-3;
    result.solution.x[3] = 9e-3;
    TEST_ASSERT_EQUAL_STRING("FAIL: angle zy up to 1.15 of 0.573° and 1 more (95 %).",
                             pass_text(&result, text));
    TEST_ASSERT_EQUAL_STRING(text, pass_strict(&result, text));
    result.units = UNIT_STYLE_INS;
    limits[2] = 20e-3;
    state(limits);
    result.solution.x[8] = 0;
    result.solution.x[3] = 0;
    result.solution.x[1] = 0.03;
    TEST_ASSERT_EQUAL_STRING("FAIL: offset y up to 32000 of 10000 µg (95 %).",
                             pass_text(&result, text));
    result.need = 1e-6 * 9.80665; /* the error of the field alone is larger */
    result.need_unit = (display_unit){1e6, "µg"};
    state(NULL);
    TEST_ASSERT_EQUAL_STRING("FAIL: |a| within 500 of 1.0 µg (95 %).", pass_text(&result, text));
    TEST_ASSERT_EQUAL_STRING(
        "FAIL: |a| within 500 of 1.0 µg (95 %). Missing: "
        "the length of the field with a σ of 5e-06 (--gravity G+-S, or --latitude): its error is "
        "an error of all scales.",
        pass_strict(&result, text));
}

static void a_strict_exit_names_the_verdict(void)
{
    state(NULL);
    result.need = 0;
    result.quality.verdict = INVCAL_WEAK;
    result.quality.weak = 1u << 6;
    TEST_ASSERT_EQUAL_STRING("the verdict is weak: angle xy poorly determined",
                             pass_strict(&result, text));
    result.quality.verdict = INVCAL_NO_REDUNDANCY;
    TEST_ASSERT_EQUAL_STRING("the verdict is no redundancy: nothing checks the fit",
                             pass_strict(&result, text));
    result.quality.verdict = INVCAL_BENT;
    result.quality.systematic = INVCAL_QUADRATIC;
    result.quality.axis = 2;
    result.quality.size = 0.003;
    TEST_ASSERT_EQUAL_STRING(
        "the verdict is bent: the z axis has a quadratic error: at both ends, z up and "
        "z down, it reads 3.0 mg more than in the middle.",
        pass_strict(&result, text));
}

static void needs_are_stated_in_units(void)
{
    static const struct {
        const char *text;
        double field;
        need_ending ending;
        size_t digits;
        double scale; /* a fraction of the field */
    } cases[] = {
        {"1mg", 9.81, NEED_UNIT, 1, 1e3},     {"1.5 mg", 9.81, NEED_UNIT, 3, 1e3},
        {"100ug", 9.81, NEED_UNIT, 3, 1e6},   {"100µg", 9.81, NEED_UNIT, 3, 1e6},
        {"0.001g", 9.81, NEED_UNIT, 5, 1},    {"0.1%", 9.81, NEED_UNIT, 3, 100},
        {"0.1%", 48.5, NEED_UNIT, 3, 100},    {"1e-2m/s2", 9.81, NEED_UNIT, 4, 9.81},
        {"1m/s^2", 9.81, NEED_UNIT, 1, 9.81}, {"1 m/s²", 9.81, NEED_UNIT, 1, 9.81},
        {"0.01", 9.81, NEED_PLAIN, 4, 9.81},  {"0.01", 48.5, NEED_PLAIN, 4, 48.5},
        {"1mg", 1, NEED_UNIT, 1, 1e3},        {"1mg", 48.5, NEED_NO_GRAVITY, 0, 0},
        {"1m/s2", 1, NEED_NO_GRAVITY, 0, 0},  {"1uT", 48.5, NEED_NO_UNIT, 0, 0},
        {"mg", 9.81, NEED_NO_UNIT, 0, 0},     {"1m", 9.81, NEED_NO_UNIT, 0, 0},
        {"5mgg", 9.81, NEED_NO_UNIT, 0, 0},   {"2um/s2", 9.81, NEED_NO_UNIT, 0, 0},
        {"", 9.81, NEED_NO_UNIT, 0, 0},
    };

    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        size_t digits = 99;
        display_unit unit = {0, NULL};
        TEST_ASSERT_EQUAL_INT_MESSAGE(cases[i].ending,
                                      need_parse(cases[i].text, cases[i].field, &digits, &unit),
                                      cases[i].text);
        if (cases[i].ending <= NEED_PLAIN) {
            TEST_ASSERT_EQUAL_UINT_MESSAGE(cases[i].digits, digits, cases[i].text);
            TEST_ASSERT_DOUBLE_WITHIN(1e-12, cases[i].scale, unit.scale);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_limit_holds_value_and_interval);
    RUN_TEST(a_need_covers_the_errors_of_lengths_and_of_the_field);
    RUN_TEST(what_is_unknown_or_not_good_does_not_pass);
    RUN_TEST(the_line_has_the_margins);
    RUN_TEST(a_strict_exit_names_the_verdict);
    RUN_TEST(needs_are_stated_in_units);
    return UNITY_END();
}
