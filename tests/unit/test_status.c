/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "status.h"
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
    for (int a = 0; a < INVCAL_STATUS_END; a++) {
        const char *text = invcal_status_text((invcal_status)a);
        TEST_ASSERT_TRUE(strlen(text) > 3);
        TEST_ASSERT_TRUE(strcmp(text, "unknown status") != 0);
        for (int b = 0; b < a; b++) {
            TEST_ASSERT_TRUE(strcmp(text, invcal_status_text((invcal_status)b)) != 0);
        }
    }
}

static void a_text_belongs_to_its_status(void)
{
    TEST_ASSERT_EQUAL_STRING("done", invcal_status_text(INVCAL_OK));
    TEST_ASSERT_EQUAL_STRING("the readings do not lie on an ellipsoid",
                             invcal_status_text(INVCAL_NOT_ELLIPSOID));
    TEST_ASSERT_EQUAL_STRING("nothing new: the same place as before",
                             invcal_status_text(INVCAL_REST_SAME));
    TEST_ASSERT_EQUAL_STRING("the nominal calibration is invalid",
                             invcal_status_text(INVCAL_BAD_NOMINAL));
    TEST_ASSERT_EQUAL_STRING("the direction is not a unit vector",
                             invcal_status_text(INVCAL_BAD_DIRECTION));
    TEST_ASSERT_EQUAL_STRING("the memory cannot be read or written", invcal_status_text(INVCAL_IO));
}

static void an_unknown_status_has_a_text_too(void)
{
    TEST_ASSERT_EQUAL_STRING("unknown status", invcal_status_text(INVCAL_STATUS_END));
    TEST_ASSERT_EQUAL_STRING("unknown status", invcal_status_text((invcal_status)-1));
    TEST_ASSERT_EQUAL_STRING("unknown verdict", invcal_verdict_text((invcal_verdict)-1));
    TEST_ASSERT_EQUAL_STRING("unknown verdict", invcal_verdict_text((invcal_verdict)6));
}

/* A mean that is not finite was refused for the same reason as one that is too large. */
static void any_other_refusal_is_a_reading_far_from_the_field(void)
{
    const char *far_away = invcal_refusal_text(INVCAL_OUT_OF_RANGE);

    TEST_ASSERT_EQUAL_STRING(far_away, invcal_refusal_text(INVCAL_NOT_FINITE));
    TEST_ASSERT_EQUAL_STRING(far_away, invcal_refusal_text(INVCAL_STATUS_END));
    TEST_ASSERT_TRUE(strcmp(far_away, invcal_refusal_text(INVCAL_REST_SAME)) != 0);
    TEST_ASSERT_EQUAL_STRING("", invcal_refusal_text(INVCAL_OK));
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
    TEST_ASSERT_EQUAL_STRING("rough", invcal_verdict_text(INVCAL_ROUGH));
    TEST_ASSERT_EQUAL_STRING("drifting", invcal_verdict_text(INVCAL_DRIFTING));
    TEST_ASSERT_EQUAL_STRING("bent", invcal_verdict_text(INVCAL_BENT));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(every_status_has_a_text_of_its_own);
    RUN_TEST(a_text_belongs_to_its_status);
    RUN_TEST(an_unknown_status_has_a_text_too);
    RUN_TEST(any_other_refusal_is_a_reading_far_from_the_field);
    RUN_TEST(parameters_are_named_in_the_order_of_the_paper);
    RUN_TEST(verdicts_are_named_as_in_the_report);
    return UNITY_END() != 0;
}
