/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "invcal/result.h"
#include "support.h"
#include "core/texts.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* Programs store these values and send them: none ever changes. */
static const struct {
    invcal_status status;
    unsigned value;
    const char *text;
} all[] = {
    {INVCAL_OK, 0, "done"},
    {INVCAL_NOT_FINITE, 0x10, "a reading is not a finite number"},
    {INVCAL_TOO_FEW, 0x11, "too few positions"},
    {INVCAL_UNDETERMINED, 0x12, "the positions leave parameters undetermined"},
    {INVCAL_NOT_ELLIPSOID, 0x13, "the readings do not lie on an ellipsoid"},
    {INVCAL_MOUNTING, 0x14, "gyroscope and accelerometer differ: axes, signs or unit"},
    {INVCAL_OUT_OF_RANGE, 0x20, "far from the field: wrong scale or offset"},
    {INVCAL_REST_SHORT, 0x21, "too short: hold still longer"},
    {INVCAL_REST_DRIFT, 0x22, "drifts: turning or settling"},
    {INVCAL_REST_CLIPPED, 0x23, "at the end of the range"},
    {INVCAL_REST_FROZEN, 0x24, "readings never change: sensor not read?"},
    {INVCAL_REST_GAP, 0x25, "too short: samples lost"},
    {INVCAL_REST_SAME, 0x26, "nothing new: same place"},
    {INVCAL_NOT_BEGUN, 0x27, "not begun"},
    {INVCAL_OTHER_BUILD, 0x28, "other build"},
    {INVCAL_BAD_NOMINAL, 0x29, "invalid scale"},
    {INVCAL_BAD_RATE, 0x2A, "invalid rate"},
    {INVCAL_MOVE_GAP, 0x30, "samples were lost in the move"},
    {INVCAL_MOVE_LONG, 0x31, "the move took more than 10 s"},
    {INVCAL_MOVE_APART, 0x32, "the move contradicts the others"},
    {INVCAL_BAD_LIMITS, 0x40, "low is not below high"},
    {INVCAL_BAD_NOISE, 0x41, "the noise is out of range"},
    {INVCAL_BAD_PRIOR, 0x42, "the prior is invalid"},
    {INVCAL_BAD_FIELD, 0x43, "the field is not a length"},
    {INVCAL_BAD_COUNT, 0x44, "the count is out of range"},
    {INVCAL_BAD_DIRECTION, 0x45, "the direction is not a unit vector"},
    {INVCAL_BAD_ANGLE, 0x46, "the angle is out of range"},
    {INVCAL_BAD_TEMPERATURE, 0x47, "the temperature is invalid"},
    {INVCAL_BAD_TIME, 0x48, "the time is out of range"},
    {INVCAL_BAD_STORE, 0x49, "the memory's slot or granularity is invalid"},
    {INVCAL_NO_RECORD, 0x60, "nothing is stored"},
    {INVCAL_DAMAGED, 0x61, "the stored bytes are damaged"},
    {INVCAL_OTHER_VERSION, 0x62, "stored in an unknown format"},
    {INVCAL_OTHER_SETTINGS, 0x63, "stored with other settings"},
    {INVCAL_NO_SPACE, 0x64, "not enough space"},
    {INVCAL_IO, 0x65, "the memory cannot be read or written"},
};
enum { ALL = sizeof all / sizeof all[0] };

static void every_status_has_its_value_and_its_text(void)
{
    for (unsigned i = 0; i < ALL; i++) {
        TEST_ASSERT_EQUAL_HEX32_MESSAGE(all[i].value, (uint32_t)all[i].status, all[i].text);
        TEST_ASSERT_EQUAL_STRING(all[i].text, invcal_status_text(all[i].status));
        for (unsigned k = 0; k < i; k++) {
            TEST_ASSERT_TRUE(strcmp(all[i].text, all[k].text) != 0);
        }
    }
    TEST_ASSERT_EQUAL_HEX32(0x70, INVCAL_STATUS_END);
}

/* The gaps between the groups, too. As far as an enumeration of one byte. */
static void any_other_value_is_unknown(void)
{
    unsigned next = 0;

    for (unsigned value = 0; value < 256; value++) {
        if (next < ALL && value == all[next].value) {
            next++;
        } else {
            TEST_ASSERT_EQUAL_STRING("unknown status", invcal_status_text((invcal_status)value));
        }
    }
    TEST_ASSERT_EQUAL_UINT(ALL, next);
    TEST_ASSERT_EQUAL_STRING("unknown status", invcal_status_text((invcal_status)-1));
}

/* A session stores its reason in a byte, and moves theirs in seven bits. */
static void every_status_fits_where_it_is_stored(void)
{
    for (unsigned i = 0; i < ALL; i++) {
        TEST_ASSERT_TRUE(all[i].status < INVCAL_STATUS_END && -(int)all[i].status >= INT8_MIN);
    }
}

static void an_unknown_verdict_has_a_text_too(void)
{
    for (unsigned k = 0; k < 256; k++) {
        if (k % 16 != 0 || k > INVCAL_WEAK) {
            TEST_ASSERT_EQUAL_STRING("unknown verdict", invcal_verdict_text((invcal_verdict)k));
        }
    }
}

/* For each bit of quality.unchecked; nothing for what was not found. */
static void every_systematic_error_has_a_text(void)
{
    static const struct {
        invcal_systematic systematic;
        const char *text;
    } known[] = {{INVCAL_NO_SYSTEMATIC, ""},
                 {INVCAL_DRIFT, "drift"},
                 {INVCAL_QUADRATIC, "nonlinearity x^2"},
                 {INVCAL_CUBIC, "nonlinearity x^3"},
                 {INVCAL_HYSTERESIS, "hysteresis"},
                 {(invcal_systematic)5, "unknown error"},
                 {(invcal_systematic)-1, "unknown error"}};

    for (unsigned i = 0; i < sizeof known / sizeof known[0]; i++) {
        TEST_ASSERT_EQUAL_STRING(known[i].text, invcal_systematic_text(known[i].systematic));
    }
}

/* Why a session refuses a sample: in the words that any status has. */
static void a_refusal_has_the_text_of_its_status(void)
{
    static const invcal_status reasons[] = {
        INVCAL_OUT_OF_RANGE, INVCAL_REST_SHORT,  INVCAL_REST_DRIFT, INVCAL_REST_CLIPPED,
        INVCAL_REST_FROZEN,  INVCAL_REST_GAP,    INVCAL_REST_SAME,  INVCAL_NOT_BEGUN,
        INVCAL_OTHER_BUILD,  INVCAL_BAD_NOMINAL, INVCAL_BAD_RATE};

    for (unsigned i = 0; i < sizeof reasons / sizeof reasons[0]; i++) {
        TEST_ASSERT_EQUAL_STRING(invcal_status_text(reasons[i]), invcali_refusal_text(reasons[i]));
    }
}

/* And no other status has one: before the first refusal there is nothing to say. */
static void any_other_status_is_no_refusal(void)
{
    for (unsigned value = 0; value < 256; value++) {
        if (value < 0x20 || value > 0x2A) {
            TEST_ASSERT_EQUAL_STRING("", invcali_refusal_text((invcal_status)value));
        }
    }
    TEST_ASSERT_EQUAL_STRING("", invcali_refusal_text((invcal_status)-1));
}

static void parameters_are_named_in_the_order_of_the_paper(void)
{
    static const char *const name[] = {"delta_x", "delta_y",  "delta_z",  "dk_x",     "dk_y",
                                       "dk_z",    "gamma_xy", "gamma_xz", "gamma_zy", "gyro_xx",
                                       "gyro_xy", "gyro_xz",  "gyro_yx",  "gyro_yy",  "gyro_yz",
                                       "gyro_zx", "gyro_zy",  "gyro_zz",  "?"};

    for (unsigned r = 0; r < sizeof name / sizeof name[0]; r++) {
        TEST_ASSERT_EQUAL_STRING(name[r], invcal_parameter_text(r));
    }
    TEST_ASSERT_EQUAL_STRING("?", invcal_parameter_text(12345));
}

static void verdicts_are_named_as_in_the_report(void)
{
    TEST_ASSERT_EQUAL_STRING("good", invcal_verdict_text(INVCAL_GOOD));
    TEST_ASSERT_EQUAL_STRING("no redundancy", invcal_verdict_text(INVCAL_NO_REDUNDANCY));
    TEST_ASSERT_EQUAL_STRING("weak", invcal_verdict_text(INVCAL_WEAK));
    TEST_ASSERT_EQUAL_STRING("rough", invcal_verdict_text(INVCAL_ROUGH));
    TEST_ASSERT_EQUAL_STRING("drifting", invcal_verdict_text(INVCAL_DRIFTING));
    TEST_ASSERT_EQUAL_STRING("bent", invcal_verdict_text(INVCAL_BENT));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(every_status_has_its_value_and_its_text);
    RUN_TEST(any_other_value_is_unknown);
    RUN_TEST(every_status_fits_where_it_is_stored);
    RUN_TEST(an_unknown_verdict_has_a_text_too);
    RUN_TEST(every_systematic_error_has_a_text);
    RUN_TEST(a_refusal_has_the_text_of_its_status);
    RUN_TEST(any_other_status_is_no_refusal);
    RUN_TEST(parameters_are_named_in_the_order_of_the_paper);
    RUN_TEST(verdicts_are_named_as_in_the_report);
    return UNITY_END() != 0;
}
