/* SPDX-License-Identifier: MIT
 *
 * What UNITY_STRICT changes, and what it must not. Beside the assertions stands what the original
 * makes of them. golden-strict.txt was checked line by line against the description in unity.h.
 */
#include <math.h>
#include "unity.h"

static int tearDownFails;
void setUp(void) {}
void tearDown(void) { if (tearDownFails) TEST_FAIL_MESSAGE("in tearDown"); }

static const float numbers[] = {1.0f, 2.0f}, others[] = {1.0f, 2.5f};
static const float nans[] = {1.0f, NAN}, alsoNans[] = {1.0f, NAN};

/* a NaN delta fails */
static void nan_delta(void)             { TEST_ASSERT_FLOAT_WITHIN(NAN, 1.0f, 99.0f); }  /* PASS */
static void nan_delta_equal(void)       { TEST_ASSERT_FLOAT_WITHIN(NAN, 1.0f, 1.0f); }   /* PASS */
static void nan_delta_infinite(void)    { TEST_ASSERT_FLOAT_WITHIN(NAN, INFINITY, INFINITY); } /* PASS */
static void nan_delta_not_within(void)  { TEST_ASSERT_FLOAT_NOT_WITHIN(NAN, 1.0f, INFINITY); } /* PASS */
static void nan_delta_array(void)       { TEST_ASSERT_FLOAT_ARRAY_WITHIN(NAN, numbers, numbers, 2); } /* FAIL */

/* NaN does not equal NaN */
static void nan_within(void)            { TEST_ASSERT_FLOAT_WITHIN(0.1f, NAN, NAN); }          /* PASS */
static void nan_equal(void)             { TEST_ASSERT_EQUAL_FLOAT(NAN, NAN); }                 /* PASS */
static void nan_not_equal(void)         { TEST_ASSERT_NOT_EQUAL_FLOAT(NAN, NAN); }             /* FAIL */
static void nan_less_or_equal(void)     { TEST_ASSERT_LESS_OR_EQUAL_FLOAT(NAN, NAN); }         /* PASS */
static void nan_in_arrays(void)         { TEST_ASSERT_EQUAL_FLOAT_ARRAY(nans, alsoNans, 2); }  /* PASS */
static void nan_in_same_array(void)     { TEST_ASSERT_EQUAL_FLOAT_ARRAY(nans, nans, 2); }      /* PASS */
static void nan_in_infinite_delta(void) { TEST_ASSERT_FLOAT_ARRAY_WITHIN(INFINITY, numbers, nans, 2); } /* PASS */
static void nan_is_nan(void)            { TEST_ASSERT_FLOAT_IS_NAN(NAN); }                     /* PASS */

/* what must stay as it is */
static void same_array(void)            { TEST_ASSERT_EQUAL_FLOAT_ARRAY(numbers, numbers, 2); }
static void no_arrays(void)             { TEST_ASSERT_EQUAL_FLOAT_ARRAY(NULL, NULL, 2); }
static void infinite_delta(void)        { TEST_ASSERT_FLOAT_ARRAY_WITHIN(INFINITY, numbers, others, 2); }
static void infinities(void)            { TEST_ASSERT_EQUAL_FLOAT(INFINITY, INFINITY); }
static void inclusive(void)             { TEST_ASSERT_FLOAT_WITHIN(0.25f, 1.0f, 1.25f); }

/* delta and difference are appended, small ones in full */
static void within(void)                { TEST_ASSERT_FLOAT_WITHIN(0.25f, 1.0f, -0.5f); }
static void within_message(void)        { TEST_ASSERT_FLOAT_WITHIN_MESSAGE(-0.25f, 1.0f, 1.5f, "msg"); }
static void not_within(void)            { TEST_ASSERT_FLOAT_NOT_WITHIN(0.5f, 1.0f, 1.25f); }
static void equal(void)                 { TEST_ASSERT_EQUAL_FLOAT(2.0f, 2.5f); }
static void not_equal(void)             { TEST_ASSERT_NOT_EQUAL_FLOAT(1.0f, 1.0f); }
static void small(void)                 { TEST_ASSERT_FLOAT_WITHIN(1e-9f, 0.0f, 1e-7f); }
static void against_infinity(void)      { TEST_ASSERT_FLOAT_WITHIN(1.0f, 1.0f, INFINITY); }
static void arrays(void)                { TEST_ASSERT_FLOAT_ARRAY_WITHIN(0.25f, numbers, others, 2); }
static void each(void)                  { TEST_ASSERT_EACH_EQUAL_FLOAT_MESSAGE(1.0f, numbers, 2, "msg"); }
static void order(void)                 { TEST_ASSERT_LESS_THAN_FLOAT(1.0f, 2.0f); }

/* a failing tearDown counts, also after IGNORE */
static void ignored(void)               { TEST_IGNORE_MESSAGE("later"); TEST_FAIL_MESSAGE("silent"); }
static void failed(void)                { TEST_FAIL_MESSAGE("body"); }
static void passed(void)                { TEST_PASS(); }

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(nan_delta);
    RUN_TEST(nan_delta_equal);
    RUN_TEST(nan_delta_infinite);
    RUN_TEST(nan_delta_not_within);
    RUN_TEST(nan_delta_array);
    RUN_TEST(nan_within);
    RUN_TEST(nan_equal);
    RUN_TEST(nan_not_equal);
    RUN_TEST(nan_less_or_equal);
    RUN_TEST(nan_in_arrays);
    RUN_TEST(nan_in_same_array);
    RUN_TEST(nan_in_infinite_delta);
    RUN_TEST(nan_is_nan);
    RUN_TEST(same_array);
    RUN_TEST(no_arrays);
    RUN_TEST(infinite_delta);
    RUN_TEST(infinities);
    RUN_TEST(inclusive);
    RUN_TEST(within);
    RUN_TEST(within_message);
    RUN_TEST(not_within);
    RUN_TEST(equal);
    RUN_TEST(not_equal);
    RUN_TEST(small);
    RUN_TEST(against_infinity);
    RUN_TEST(arrays);
    RUN_TEST(each);
    RUN_TEST(order);
    (void)UNITY_END();

    UNITY_BEGIN();
    RUN_TEST(ignored);
    tearDownFails = 1;
    RUN_TEST(ignored);
    RUN_TEST(failed);
    RUN_TEST(passed);
    tearDownFails = 0;
    RUN_TEST(passed);
    return UNITY_END();
}
