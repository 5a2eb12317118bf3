/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void every_status_has_a_text_of_its_own(void)
{
    for (int a = 0; a < INVCAL_STATUS_COUNT; a++) {
        const char *text = invcal_status_text((invcal_status)a);
        TEST_ASSERT_TRUE(strlen(text) >= 4);
        TEST_ASSERT_TRUE(text[strlen(text) - 1] != '.');
        TEST_ASSERT_TRUE(strcmp(text, "unknown status") != 0);
        for (int b = 0; b < a; b++) {
            TEST_ASSERT_TRUE(strcmp(text, invcal_status_text((invcal_status)b)) != 0);
        }
    }
}

static void a_text_belongs_to_its_status(void)
{
    static const struct {
        invcal_status status;
        const char *text;
    } pairs[] = {
        {INVCAL_OK, "done"},
        {INVCAL_NOT_FINITE, "a reading is not a finite number"},
        {INVCAL_OUT_OF_RANGE, "a reading is far from the field: wrong scale or zero"},
        {INVCAL_TOO_FEW, "too few positions"},
        {INVCAL_UNDETERMINED, "the positions leave parameters undetermined"},
        {INVCAL_NOT_ELLIPSOID, "the readings lie on no ellipsoid"},
        {INVCAL_REST_SHORT, "too short: hold it still longer"},
        {INVCAL_REST_DRIFT, "it creeps: turned slowly, or not settled"},
        {INVCAL_REST_CLIPPED, "at the end of the sensor's range"},
        {INVCAL_REST_FROZEN, "readings never change: is the sensor read?"},
        {INVCAL_REST_GAP, "too short: samples were lost"},
        {INVCAL_REST_SAME, "nothing new: the same place as before"},
        {INVCAL_BAD_NOMINAL, "the nominal calibration is unusable"},
        {INVCAL_BAD_RATE, "the sample rate is out of range"},
        {INVCAL_BAD_RAILS, "the sensor's range is upside down"},
        {INVCAL_BAD_NOISE, "the noise is out of range"},
        {INVCAL_BAD_WEIGHT, "the weight is unusable"},
        {INVCAL_BAD_PRIOR, "the prior is unusable"},
        {INVCAL_BAD_FIELD, "the field is no length"},
        {INVCAL_BAD_COUNT, "too many of them"},
        {INVCAL_BAD_DIRECTION, "the direction is not a unit vector"},
        {INVCAL_BAD_PROGRAM, "there is no such position in a program"},
        {INVCAL_BAD_TEMPERATURE, "the temperature is unusable"},
        {INVCAL_BAD_TAU, "the averaging times are unusable"},
        {INVCAL_BAD_STORE, "the memory's slot or granularity is unusable"},
        {INVCAL_NO_RECORD, "nothing is stored"},
        {INVCAL_DAMAGED, "the stored bytes are damaged"},
        {INVCAL_OTHER_VERSION, "stored in a form that is not known here"},
        {INVCAL_NO_SPACE, "not enough space"},
        {INVCAL_IO, "the memory cannot be read or written"},
    };

    TEST_ASSERT_EQUAL_UINT(INVCAL_STATUS_COUNT, sizeof pairs / sizeof pairs[0]);
    for (unsigned i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        TEST_ASSERT_EQUAL_STRING(pairs[i].text, invcal_status_text(pairs[i].status));
    }
}

static void an_unknown_status_has_a_text_too(void)
{
    TEST_ASSERT_EQUAL_STRING("unknown status", invcal_status_text(INVCAL_STATUS_COUNT));
    TEST_ASSERT_EQUAL_STRING("unknown status", invcal_status_text((invcal_status)-1));
    TEST_ASSERT_EQUAL_STRING("unknown verdict", invcal_verdict_text((invcal_verdict)-1));
    TEST_ASSERT_EQUAL_STRING("unknown verdict", invcal_verdict_text((invcal_verdict)3));
}

static void parameters_are_named_in_the_order_of_the_paper(void)
{
    static const char *const name[] = {"delta_x", "delta_y",  "delta_z",  "dk_x",     "dk_y",
                                       "dk_z",    "gamma_xy", "gamma_xz", "gamma_zy", "?"};

    for (unsigned r = 0; r <= INVCAL_PARAMETERS; r++) {
        TEST_ASSERT_EQUAL_STRING(name[r], invcal_parameter_name(r));
    }
    TEST_ASSERT_EQUAL_STRING("?", invcal_parameter_name(12345));
}

static void verdicts_are_named_as_in_the_report(void)
{
    TEST_ASSERT_EQUAL_STRING("good", invcal_verdict_text(INVCAL_GOOD));
    TEST_ASSERT_EQUAL_STRING("no redundancy", invcal_verdict_text(INVCAL_NO_REDUNDANCY));
    TEST_ASSERT_EQUAL_STRING("weak", invcal_verdict_text(INVCAL_WEAK));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(every_status_has_a_text_of_its_own);
    RUN_TEST(a_text_belongs_to_its_status);
    RUN_TEST(an_unknown_status_has_a_text_too);
    RUN_TEST(parameters_are_named_in_the_order_of_the_paper);
    RUN_TEST(verdicts_are_named_as_in_the_report);
    return UNITY_END() != 0;
}
