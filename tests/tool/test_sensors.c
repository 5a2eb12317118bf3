/* SPDX-License-Identifier: MIT
 *
 * Tests of port/host/fit/sensors.c. Expected values, looked up once more in November 2026:
 *
 *   in the sheets themselves   MPU-6000 and MPU-6050 p. 13, MPU-9250 p. 9, ICM-20948 p. 12 (each the revision of the table); ADXL345
 *                              T1; ADXL354/ADXL355 Rev. 0, T2 on p. 4; LIS3DH T4 (and ST's lis3dh_reg.c); Xsens
 *                              MT0100P.N, 4.5.2 on p. 18; BNO055 Rev. 1.4, T3-17 (units)
 *   in copies of their tables  BMI160: 15729 16384 17039 LSB/g, ACC_RANGE 0x03 after a reset, 40 mg at board level;
 *                              its cross-axis sensitivity was not found, and is not stated. BMI270: 20 mg, 0.4 %,
 *                              1 %, ACC_RANGE 0x02 after a reset. BNO055: at most 150 mg, 4 %, 2 %. LSM6DSO: DS12140
 *                              Rev. 3, T2: 20 mg. LSM6DS3TR: 40 mg; the scales are those of ST's drivers
 */
#include <math.h>
#include <string.h>

#include "fit/sensors.h"
#include "unity.h"

void setUp(void)
{
}
void tearDown(void)
{
}

static sensor_choice choose(const char *words)
{
    sensor_choice c = {NULL, NULL};
    char text[SENSORS_TEXT_MAX];

    TEST_ASSERT_EQUAL_INT_MESSAGE(1, sensors_choose(words, &c, text), words);
    return c;
}

/* m/s^2 a count, from the sheets: 9.80665 / (LSB/g), or mg/LSB. */
static void scale_is(const char *words, double expected)
{
    const sensor_choice c = choose(words);

    TEST_ASSERT_DOUBLE_WITHIN(1e-9 * expected, expected, sensors_scale(&c, 9.80665));
}

static void test_scales(void)
{
    scale_is("mpu6050", 9.80665 / 16384);
    scale_is("mpu6050:2g", 9.80665 / 16384);
    scale_is("mpu6050:4g", 9.80665 / 8192);
    scale_is("mpu6050:8g", 9.80665 / 4096);
    scale_is("mpu6050:16g", 9.80665 / 2048);
    scale_is("MPU-6000", 9.80665 / 16384);
    scale_is("mpu6000:16g", 9.80665 / 2048);
    scale_is("mpu9250:8g", 9.80665 / 4096);
    scale_is("icm20948:16g", 9.80665 / 2048);
    scale_is("lsm6ds3", 9.80665 * 0.061e-3);
    scale_is("lsm6ds3:16g", 9.80665 * 0.488e-3);
    scale_is("lsm6dso:4g", 9.80665 * 0.122e-3);
    scale_is("lis3dh", 9.80665 * 1e-3 / 16);
    scale_is("lis3dh:16g", 9.80665 * 12e-3 / 16);
    scale_is("adxl345", 9.80665 / 256);
    scale_is("adxl345:16g", 9.80665 / 32);
    scale_is("adxl355", 9.80665 / 256000);
    scale_is("adxl355:8g", 9.80665 / 64000);
    scale_is("bmi160:4g", 9.80665 / 8192);
    scale_is("bmi270:2g", 9.80665 / 16384);
    scale_is("bno055", 0.01);
    scale_is("bno055:mg", 9.80665e-3);
    scale_is("xsens-mti", 1);
}

/* Register 0x41 of the BMI270 is 2 after a reset: 8 g. */
static void test_range_at_power_on(void)
{
    scale_is("bmi270", 9.80665 / 4096);
}

static void test_spellings(void)
{
    scale_is("MPU-6050:4G", 9.80665 / 8192);
    scale_is("Xsens MTi:m/s2", 1);
    scale_is("XSENSMTI", 1);
}

static void test_other_field_units(void)
{
    const sensor_choice c = choose("adxl345");

    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1.0 / 256, sensors_scale(&c, 1));
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1000.0 / 256, sensors_scale(&c, 1000));
    TEST_ASSERT_DOUBLE_WITHIN(0, 0, sensors_scale(&c, 50));
}

static void refuses(const char *words, const char *expected)
{
    sensor_choice c;
    char text[SENSORS_TEXT_MAX] = "";

    TEST_ASSERT_EQUAL_INT_MESSAGE(0, sensors_choose(words, &c, text), words);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, expected), text);
}

static void test_unknown(void)
{
    refuses("mpu605", "did you mean mpu6050?");
    refuses("adlx345:2g", "did you mean adxl345?");
    refuses("lis", "did you mean list?");
    refuses("thermometer", "unknown sensor 'thermometer';");
    refuses("", "unknown sensor ''");
    refuses(":2g", "unknown sensor ''");
    refuses("mpu6050:", "MPU-6050 has no '', but 2g, 4g, 8g, 16g");
    refuses("mpu6050:3g", "MPU-6050 has no '3g', but 2g, 4g, 8g, 16g");
    refuses("adxl355:16g", "but 2g, 4g, 8g");
    refuses("mpu60500000000000000000000000000000000000000000000000000000000000000",
            "unknown sensor");
}

static void limits_are(const char *words, double field, const double expected[INVCAL_PARAMETERS])
{
    const sensor_choice c = choose(words);
    double limit[INVCAL_PARAMETERS];

    sensors_limits(&c, field, limit);
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        if (isnan(expected[p])) {
            TEST_ASSERT_TRUE_MESSAGE(isnan(limit[p]), words);
        } else {
            TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-12, expected[p], limit[p], words);
        }
    }
}

static void test_limits(void)
{
    const double no = (double)NAN;

    limits_are("mpu6050:8g", 9.80665,
               (double[]){0.05, 0.05, 0.08, 0.03, 0.03, 0.03, 0.04, 0.04, 0.04});
    limits_are("mpu6000", 9.80665,
               (double[]){0.05, 0.05, 0.08, 0.03, 0.03, 0.03, 0.04, 0.04, 0.04});
    limits_are("mpu9250", 9.80665,
               (double[]){0.06, 0.06, 0.08, 0.03, 0.03, 0.03, 0.04, 0.04, 0.04});
    limits_are("icm20948", 9.80665,
               (double[]){0.05, 0.05, 0.05, 0.005, 0.005, 0.005, 0.04, 0.04, 0.04});
    limits_are("adxl355", 9.80665,
               (double[]){0.075, 0.075, 0.075, 0.08, 0.08, 0.08, 0.02, 0.02, 0.02});
    limits_are("bmi160", 9.80665, (double[]){0.04, 0.04, 0.04, 0.04, 0.04, 0.04, no, no, no});
    limits_are("bmi270", 9.80665,
               (double[]){0.02, 0.02, 0.02, 0.004, 0.004, 0.004, 0.02, 0.02, 0.02});
    limits_are("adxl345", 9.80665, (double[]){0.15, 0.15, 0.25, 0.1, 0.1, 0.1, 0.02, 0.02, 0.02});
    limits_are("bno055", 9.80665, (double[]){0.15, 0.15, 0.15, 0.04, 0.04, 0.04, 0.04, 0.04, 0.04});
    limits_are("lis3dh", 9.80665, (double[]){0.04, 0.04, 0.04, no, no, no, no, no, no});
    limits_are("xsens-mti", 9.80665, (double[]){no, no, no, no, no, no, no, no, no});
    /* 40 mg over a field of 9.7 m/s^2 */
    limits_are("lsm6ds3", 9.71,
               (double[]){0.04 * 9.80665 / 9.71, 0.04 * 9.80665 / 9.71, 0.04 * 9.80665 / 9.71, no,
                          no, no, no, no, no});
    limits_are("lsm6dso", 1, (double[]){0.02 * 1, 0.02, 0.02, no, no, no, no, no, no});
}

static void fits(const char *words, double ratio, const char *expected)
{
    const sensor_choice c = choose(words);
    char text[SENSORS_TEXT_MAX] = "";
    char remedy[SENSORS_TEXT_MAX] = "";

    TEST_ASSERT_EQUAL_INT_MESSAGE(expected == NULL, sensors_fit(&c, ratio, text, remedy), words);
    TEST_ASSERT_EQUAL_INT_MESSAGE(expected == NULL, remedy[0] == '\0', words);
    if (expected) {
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, expected), text);
    }
}

static void test_other_range(void)
{
    fits("mpu6050:4g", 1, NULL);
    fits("mpu6050:4g", 0.8, NULL);
    fits("mpu6050:4g", 1.3, NULL);
    fits("mpu6050:2g", 0.5, "2.0 times too small for mpu6050:2g: they match mpu6050:4g");
    fits("mpu6050:2g", 0.25 * 0.95, "4.2 times too small for mpu6050:2g: they match mpu6050:8g");
    fits("mpu6050:16g", 8, "8.0 times too large for mpu6050:16g: they match mpu6050:2g");
    fits("mpu6050:16g", 32, "32 times too large for mpu6050:16g, at any of its ranges");
    fits("bno055", 1.02 / 0.980665, NULL);
    fits("mpu6050", (double)NAN, "at any of its ranges");
    fits("mpu6050", 0, "at any of its ranges");
    fits("mpu6050", (double)INFINITY, "at any of its ranges");
}

static void test_words(void)
{
    const sensor_choice c = choose("MPU6050:4g");
    const sensor_choice other = choose("adxl345");
    const sensor_choice none = choose("xsens-mti");
    char text[SENSORS_TEXT_MAX];

    TEST_ASSERT_EQUAL_STRING("mpu6050:4g", sensors_key(&c, text));
    TEST_ASSERT_EQUAL_STRING("typical: offsets ±50, ±50, ±80 mg; scale ±3 %; cross-axis ±2 %",
                             sensors_limits_text(&c, text));
    TEST_ASSERT_EQUAL_STRING("offsets ±150, ±150, ±250 mg; scale ±10 %; typical: cross-axis ±1 %",
                             sensors_limits_text(&other, text));
    TEST_ASSERT_EQUAL_STRING("not stated", sensors_limits_text(&none, text));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_scales);
    RUN_TEST(test_range_at_power_on);
    RUN_TEST(test_spellings);
    RUN_TEST(test_other_field_units);
    RUN_TEST(test_unknown);
    RUN_TEST(test_limits);
    RUN_TEST(test_other_range);
    RUN_TEST(test_words);
    return UNITY_END();
}
