/* SPDX-License-Identifier: MIT
 *
 * Tests of port/host/text/unit.c: when a size tells a unit, and when it is sure; names. Readings are made here:
 * positions of a sensor with known zero and scale.
 */
#include "text/unit.h"
#include "unity.h"

#define POSITIONS 18u

void setUp(void)
{
}
void tearDown(void)
{
}

static double reading[3 * POSITIONS];

/* Six faces and twelve edges, read with a zero (alike on three axes) and a scale. */
static void read_all(double zero, double scale)
{
    static const double h = 0.70710678118654752;
    const double up[POSITIONS][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},  {0, -1, 0},  {0, 0, 1},
                                     {0, 0, -1}, {h, h, 0},  {h, -h, 0}, {-h, h, 0},  {-h, -h, 0},
                                     {h, 0, h},  {h, 0, -h}, {-h, 0, h}, {-h, 0, -h}, {0, h, h},
                                     {0, h, -h}, {0, -h, h}, {0, -h, -h}};

    for (unsigned i = 0; i < 3 * POSITIONS; i++) {
        reading[i] = zero + scale * up[i / 3][i % 3];
    }
}

static void test_sure(void)
{
    read_all(0, 9.80665);
    TEST_ASSERT_EQUAL_INT(UNIT_MS2, unit_by_size(reading, POSITIONS, 9.80665));
    TEST_ASSERT_EQUAL_INT(1, unit_is_sure(UNIT_MS2, reading, POSITIONS));
    TEST_ASSERT_EQUAL_INT(0, unit_is_sure(UNIT_G, reading, POSITIONS));
    TEST_ASSERT_EQUAL_INT(0, unit_is_sure(UNIT_COUNTS, reading, POSITIONS));
    TEST_ASSERT_EQUAL_INT(0, unit_is_sure(UNIT_UNKNOWN, reading, POSITIONS));
    read_all(0.03, 1.02);
    TEST_ASSERT_EQUAL_INT(1, unit_is_sure(UNIT_G, reading, POSITIONS));
}

static void test_rates_of_turn(void)
{
    static const char *const radians[] = {"rad/s",    "RAD/S", "rad s^-1",
                                          "rad*s^-1", "radps", "rad/sec"};
    static const char *const degrees[] = {"dps",      "deg/s",     "°/s", "\xb0/s",
                                          "deg s^-1", "degrees/s", "DPS"};
    static const char *const none[] = {"",      "m",      "rad", "deg",    "g",
                                       "m/s^2", "counts", "s",   "rad/s^2"};

    for (unsigned i = 0; i < sizeof radians / sizeof *radians; i++) {
        TEST_ASSERT_EQUAL_DOUBLE(1, unit_parse_angular_rate(radians[i]));
    }
    for (unsigned i = 0; i < sizeof degrees / sizeof *degrees; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, 3.14159265358979324 / 180,
                                  unit_parse_angular_rate(degrees[i]));
    }
    for (unsigned i = 0; i < sizeof none / sizeof *none; i++) {
        TEST_ASSERT_EQUAL_DOUBLE(0, unit_parse_angular_rate(none[i]));
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 3.14159265358979324 / 180e3, unit_parse_angular_rate("mdps"));
    TEST_ASSERT_EQUAL_DOUBLE(1e-3, unit_parse_angular_rate("mrad/s"));
    TEST_ASSERT_EQUAL_STRING("rad/s", unit_angular_rate_words(unit_parse_angular_rate("rad/s")));
    TEST_ASSERT_EQUAL_STRING("°/s", unit_angular_rate_words(unit_parse_angular_rate("dps")));
    TEST_ASSERT_EQUAL_STRING("m°/s", unit_angular_rate_words(unit_parse_angular_rate("mdps")));
    TEST_ASSERT_EQUAL_STRING("counts", unit_angular_rate_words(1.3e-4));
    TEST_ASSERT_EQUAL_STRING("mrad/s", unit_angular_rate_name(1e-3));
    TEST_ASSERT_EQUAL_STRING("deg/s", unit_angular_rate_name(unit_parse_angular_rate("dps")));
    TEST_ASSERT_EQUAL_STRING("mdeg/s", unit_angular_rate_name(unit_parse_angular_rate("mdps")));
    TEST_ASSERT_EQUAL_STRING("counts", unit_angular_rate_name(1.3e-4));
}

/* MMA8451: 1024 counts a g at 8 g. */
static void test_mg_is_never_sure(void)
{
    read_all(0, 1024);
    TEST_ASSERT_EQUAL_INT(UNIT_MG, unit_by_size(reading, POSITIONS, 9.80665));
    TEST_ASSERT_EQUAL_INT(0, unit_is_sure(UNIT_MG, reading, POSITIONS));
}

/* Ratios of an analog sensor at half of its supply: lengths about sqrt(3)/2, all one way. */
static void test_zero_far_off(void)
{
    read_all(0.55, 0.09);
    TEST_ASSERT_EQUAL_INT(UNIT_G, unit_by_size(reading, POSITIONS, 9.80665));
    TEST_ASSERT_EQUAL_INT(0, unit_is_sure(UNIT_G, reading, POSITIONS));
}

/* One wrong position of 18 may be; three are too many. */
static void test_wrong_ones(void)
{
    read_all(0, 9.80665);
    reading[0] = 40;
    TEST_ASSERT_EQUAL_INT(1, unit_is_sure(UNIT_MS2, reading, POSITIONS));
    reading[4] = reading[8] = 40;
    TEST_ASSERT_EQUAL_INT(0, unit_is_sure(UNIT_MS2, reading, POSITIONS));
}

static void test_scale(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 9.80665, unit_scale(UNIT_G, 9.81744));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1, unit_scale(UNIT_MS2, 9.81744));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1, unit_scale(UNIT_G, 1));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1e-3, unit_scale(UNIT_MG, 1));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1 / 9.80665, unit_scale(UNIT_MS2, 1));
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1000, unit_scale(UNIT_G, 1000));
    TEST_ASSERT_DOUBLE_WITHIN(0, 0, unit_scale(UNIT_G, 48.5));
    TEST_ASSERT_DOUBLE_WITHIN(0, 0, unit_scale(UNIT_COUNTS, 9.80665));
}

/* G is gauss in the heading of a magnetometer, g in that of an accelerometer; a name comes back. */
static void test_magnetic(void)
{
    static const struct {
        const char *text;
        reading_unit unit;
        const char *words;
    } of[] = {{"uT", UNIT_MICROTESLA, "µT"},     {"µT", UNIT_MICROTESLA, "µT"},
              {"μT", UNIT_MICROTESLA, "µT"},     {"nT", UNIT_NANOTESLA, "nT"},
              {"G", UNIT_GAUSS, "gauss"},        {"Gauss", UNIT_GAUSS, "gauss"},
              {"mG", UNIT_MILLIGAUSS, "mgauss"}, {"counts", UNIT_COUNTS, "counts"}};
    reading_unit unit = UNIT_UNKNOWN;

    for (unsigned i = 0; i < sizeof of / sizeof of[0]; i++) {
        TEST_ASSERT_EQUAL_INT(1, unit_parse_magnetic(of[i].text, &unit));
        TEST_ASSERT_EQUAL_INT(of[i].unit, unit);
        TEST_ASSERT_EQUAL_STRING(of[i].words, unit_words(unit));
        TEST_ASSERT_EQUAL_INT(unit, unit_of_name(unit_name(unit)));
        TEST_ASSERT_TRUE(unit == UNIT_COUNTS || !(unit_scale(unit, 9.80665) > 0));
    }
    TEST_ASSERT_EQUAL_INT(0, unit_parse_magnetic("m/s^2", &unit));
    TEST_ASSERT_EQUAL_INT(UNIT_UNKNOWN, unit_of_name("unknown"));
    TEST_ASSERT_EQUAL_INT(UNIT_MG, unit_of_name("mg"));
    TEST_ASSERT_EQUAL_INT(1, unit_parse("G", &unit));
    TEST_ASSERT_EQUAL_INT(UNIT_G, unit);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_sure);
    RUN_TEST(test_rates_of_turn);
    RUN_TEST(test_mg_is_never_sure);
    RUN_TEST(test_zero_far_off);
    RUN_TEST(test_wrong_ones);
    RUN_TEST(test_scale);
    RUN_TEST(test_magnetic);
    return UNITY_END();
}
