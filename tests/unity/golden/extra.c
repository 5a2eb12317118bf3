/* SPDX-License-Identifier: MIT
 *
 * What probe.c does not touch: the other integer types, arrays and limits, strings, bits, printed
 * numbers, and the parts that custom runners and custom assertions use. golden-extra-*.txt were checked
 * line by line against the description in unity.h.
 */
#include <limits.h>
#include <math.h>
#include "unity.h"

static int tearDownFails;
void setUp(void) {}
void tearDown(void)
{
    if (tearDownFails) {
        TEST_FAIL_MESSAGE("second");
        UnityPrint("not reached");
    }
}

/* integers */
static void int8_within_delta_wraps(void)     { TEST_ASSERT_INT8_WITHIN(300, 0, 44); } /* 300 is 44 */
static void int8_within_delta_wraps_too(void) { TEST_ASSERT_INT8_WITHIN(300, 0, 45); }
static void int8_within_full_range(void)      { TEST_ASSERT_INT8_WITHIN(254, -128, 127); }
static void int_within_minus_one(void)        { TEST_ASSERT_INT_WITHIN(-1, INT_MIN, INT_MAX); }
static void int64_within_extremes(void)       { TEST_ASSERT_INT64_WITHIN(UINT64_MAX, INT64_MIN, INT64_MAX); }
static void int64_within_too_far(void)        { TEST_ASSERT_INT64_WITHIN(UINT64_MAX - 1, INT64_MIN, INT64_MAX); }
static void uint64_within(void)               { TEST_ASSERT_UINT64_WITHIN_MESSAGE(1, UINT64_MAX, UINT64_MAX - 2, "msg"); }
static void size_within(void)                 { TEST_ASSERT_size_t_WITHIN(1, sizeof(char), 3); }
static void int8_greater(void)                { TEST_ASSERT_GREATER_THAN_INT8(-1, -2); }
static void uint8_greater(void)               { TEST_ASSERT_GREATER_THAN_UINT8(1, -2); }   /* 254 > 1 */
static void uint_less(void)                   { TEST_ASSERT_LESS_THAN_UINT(1, -1); }
static void int16_not_equal(void)             { TEST_ASSERT_NOT_EQUAL_INT16_MESSAGE(-7, -7, "msg"); }
static void int64_less_or_equal(void)         { TEST_ASSERT_LESS_OR_EQUAL_INT64(INT64_MIN, INT64_MAX); }
static void hex64(void)                       { TEST_ASSERT_EQUAL_HEX64(0x0123456789ABCDEFull, 0); }
static void hex8_of_negative(void)            { TEST_ASSERT_EQUAL_HEX8(-1, 0xFF); }
static void character(void)                   { TEST_ASSERT_EQUAL_CHAR('a', '\n'); }
static void pointer(void)                     { TEST_ASSERT_EQUAL_PTR(NULL, (void *)0xBEEF); }

/* bits */
static void bits(void)      { TEST_ASSERT_BITS(0xF0, 0xA5, 0xAA); }
static void bits_not(void)  { TEST_ASSERT_BITS(0xF0, 0xA5, 0x5A); }
static void bits_high(void) { TEST_ASSERT_BITS_HIGH(0x05, 0x04); }
static void bits_low(void)  { TEST_ASSERT_BITS_LOW(0x05, 0x0A); }
static void bit_high(void)  { TEST_ASSERT_BIT_HIGH(31, 0); }
static void bit_low(void)   { TEST_ASSERT_BIT_LOW_MESSAGE(0, 1, "msg"); }

/* arrays: each type is read with its own size and sign */
static const int8_t   a8[]  = {-1, 2, -128}, b8[] = {-1, 2, 127};
static const int16_t  a16[] = {-1, -300, 3}, b16[] = {-1, -302, 3};
static const uint16_t c16[] = {65535, 1, 2}, d16[] = {65535, 1, 3};
static const int32_t  a32[] = {-1, INT32_MIN}, b32[] = {-1, INT32_MAX};
static const int64_t  a64[] = {INT64_MIN, -1}, b64[] = {INT64_MIN, 1};
static const uint32_t c32[] = {7, 7, UINT32_MAX};
static const size_t   sizes[] = {4, 4, 5};
static const char     chars[] = {'a', 'a', 'b'};
static int            one, two;
static int *const     pointers[] = {&one, &one}, *const morePointers[] = {&one, &one};

static void array_int8(void)          { TEST_ASSERT_EQUAL_INT8_ARRAY(a8, b8, 3); }
static void array_int8_hex(void)      { TEST_ASSERT_EQUAL_HEX8_ARRAY(a8, b8, 3); }
static void array_int8_part(void)     { TEST_ASSERT_EQUAL_INT8_ARRAY(a8, b8, 2); }
static void array_int16(void)         { TEST_ASSERT_EQUAL_INT16_ARRAY(a16, b16, 3); }
static void array_uint16(void)        { TEST_ASSERT_EQUAL_UINT16_ARRAY_MESSAGE(c16, d16, 3, "msg"); }
static void array_int32(void)         { TEST_ASSERT_EQUAL_INT32_ARRAY(a32, b32, 2); }
static void array_int64(void)         { TEST_ASSERT_EQUAL_INT64_ARRAY(a64, b64, 2); }
static void array_within(void)        { TEST_ASSERT_INT16_ARRAY_WITHIN(2, a16, b16, 3); }
static void array_not_within(void)    { TEST_ASSERT_INT16_ARRAY_WITHIN_MESSAGE(1, a16, b16, 3, "msg"); }
static void array_within_nothing(void) { TEST_ASSERT_INT16_ARRAY_WITHIN(1, a16, b16, 0); }
static void array_pointers(void)      { TEST_ASSERT_EQUAL_PTR_ARRAY(pointers, morePointers, 2); }
static void each_uint32(void)         { TEST_ASSERT_EACH_EQUAL_UINT32(7, c32, 3); }
static void each_size(void)           { TEST_ASSERT_EACH_EQUAL_size_t(4, sizes, 2); }
static void each_size_not(void)       { TEST_ASSERT_EACH_EQUAL_size_t(4, sizes, 3); }
static void each_char(void)           { TEST_ASSERT_EACH_EQUAL_CHAR('a', chars, 3); }
static void each_of_null(void)        { TEST_ASSERT_EACH_EQUAL_INT(1, NULL, 3); }
static void each_of_nothing(void)     { TEST_ASSERT_EACH_EQUAL_INT(1, &one, 0); }
static void each_pointer(void)        { TEST_ASSERT_EACH_EQUAL_PTR(&one, pointers, 2); }
static void memory_message(void)      { TEST_ASSERT_EQUAL_MEMORY_MESSAGE("ab", "aB", 2, "msg"); }

/* strings and text */
static void string_shorter(void)      { TEST_ASSERT_EQUAL_STRING("abc", "ab"); }
static void string_both_null(void)    { TEST_ASSERT_EQUAL_STRING(NULL, NULL); }
static void string_from_null(void)    { TEST_ASSERT_EQUAL_STRING_MESSAGE(NULL, "x", "msg"); }
static void string_len(void)          { TEST_ASSERT_EQUAL_STRING_LEN("abcX", "abcY", 2); }
static void string_len_not(void)      { TEST_ASSERT_EQUAL_STRING_LEN("abcd", "aXcd", 3); }
static void escapes(void)             { TEST_FAIL_MESSAGE("\r\n\t~\x7f\xff"); }
static void null_assertions(void)     { TEST_ASSERT_NOT_NULL(a8); TEST_ASSERT_NULL(NULL); TEST_ASSERT_NULL_MESSAGE(&one, "msg"); }

/* printed floats: expected 0, so that every other value fails */
static void shows(float x)            { TEST_ASSERT_EQUAL_FLOAT(0.0f, x); }
static void float_million(void)       { shows(1234567.0f); }
static void float_last_fixed(void)    { shows(9999999.0f); }
static void float_ten_million(void)   { shows(1e7f); }
static void float_odd_large(void)     { shows(8388609.0f); }  /* + 0.5 would round it */
static void float_tie_to_even(void)   { shows(0.00048828125f); }
static void float_last_small(void)    { shows(0.0001f); }
static void float_small(void)         { shows(0.00009765625f); }
static void float_below_ten(void)     { shows(0.01f); }       /* 0.00999999978 */
static void float_negative(void)      { shows(-0.5f); }
static void float_hidden(void)        { shows(-0.000009f); }
static void float_zeros(void)         { shows(100200.0f); }

/* floats are compared in float arithmetic, also where doubles are available; doubles in double */
static const float  numbers[] = {1.0f, 2.0f}, nans[] = {1.0f, NAN};
static const double doubles[] = {1e300, 1.0}, otherDoubles[] = {1e300, 1.0000001};
static void float_difference_rounded(void)  { TEST_ASSERT_FLOAT_WITHIN(16777216.0f, 16777216.0f, -1.0f); }
static void double_difference_exact(void)   { TEST_ASSERT_DOUBLE_WITHIN(16777216.0, 16777216.0, -1.0); }
static void float_infinite_delta(void)      { TEST_ASSERT_FLOAT_ARRAY_WITHIN(INFINITY, numbers, nans, 2); }
static void double_within(void)             { TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-7, 1.0, 1.0000002, "msg"); }
static void double_array(void)              { TEST_ASSERT_EQUAL_DOUBLE_ARRAY(doubles, otherDoubles, 2); }
static void double_each(void)               { TEST_ASSERT_EACH_EQUAL_DOUBLE(1e300, doubles, 2); }
static void double_not_equal(void)          { TEST_ASSERT_NOT_EQUAL_DOUBLE(1e-300, 1e-300); }
static void double_order(void)              { TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(123456789.125, 123456788.5); }
static void double_carry(void)              { TEST_ASSERT_EQUAL_DOUBLE(999999999.9, 0.99999999999); }
static void double_trait(void)              { TEST_ASSERT_DOUBLE_IS_NOT_NEG_INF((double)-INFINITY); }

/* building blocks */
static int  calls;
static int  once(int value)           { calls++; return value; }
static void arguments_once(void)
{
    TEST_ASSERT_EQUAL_INT(once(1), 1);
    TEST_ASSERT_NOT_EQUAL(once(1), 2);
    TEST_ASSERT_INT_WITHIN(once(1), 1, once(1));
    TEST_ASSERT_EQUAL_FLOAT(once(1), once(1));
    TEST_ASSERT_FLOAT_WITHIN(once(1), once(1), once(1));
    TEST_ASSERT_GREATER_OR_EQUAL_FLOAT(once(1), once(1));
    TEST_ASSERT_BITS(once(1), once(1), once(1));
    TEST_ASSERT_EACH_EQUAL_UINT32(once(7), c32, once(2));
    TEST_ASSERT_TRUE(once(1));
    TEST_ASSERT_EQUAL_INT(17, calls);
}
static void in_an_if(void)
{
    if (calls > 0)
        TEST_ASSERT_TRUE(calls > 0);
    else
        TEST_FAIL();
}
static void own_line(void)            { UNITY_TEST_ASSERT_FLOAT_WITHIN(0.5f, 1.0f, 2.0f, 4711, "mine"); }
static void own_file(void)            { UnitySetTestFile("other.c"); TEST_FAIL(); }
static void own_abort(void)           { TEST_ABORT(); }
static void own_line_number(void)     { TEST_ASSERT_EQUAL_INT(31, TEST_LINE_NUM); TEST_ASSERT_FALSE(TEST_IS_IGNORED); }

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(int8_within_delta_wraps);
    RUN_TEST(int8_within_delta_wraps_too);
    RUN_TEST(int8_within_full_range);
    RUN_TEST(int_within_minus_one);
    RUN_TEST(int64_within_extremes);
    RUN_TEST(int64_within_too_far);
    RUN_TEST(uint64_within);
    RUN_TEST(size_within);
    RUN_TEST(int8_greater);
    RUN_TEST(uint8_greater);
    RUN_TEST(uint_less);
    RUN_TEST(int16_not_equal);
    RUN_TEST(int64_less_or_equal);
    RUN_TEST(hex64);
    RUN_TEST(hex8_of_negative);
    RUN_TEST(character);
    RUN_TEST(pointer);
    RUN_TEST(bits);
    RUN_TEST(bits_not);
    RUN_TEST(bits_high);
    RUN_TEST(bits_low);
    RUN_TEST(bit_high);
    RUN_TEST(bit_low);
    RUN_TEST(array_int8);
    RUN_TEST(array_int8_hex);
    RUN_TEST(array_int8_part);
    RUN_TEST(array_int16);
    RUN_TEST(array_uint16);
    RUN_TEST(array_int32);
    RUN_TEST(array_int64);
    RUN_TEST(array_within);
    RUN_TEST(array_not_within);
    RUN_TEST(array_within_nothing);
    RUN_TEST(array_pointers);
    RUN_TEST(each_uint32);
    RUN_TEST(each_size);
    RUN_TEST(each_size_not);
    RUN_TEST(each_char);
    RUN_TEST(each_of_null);
    RUN_TEST(each_of_nothing);
    RUN_TEST(each_pointer);
    RUN_TEST(memory_message);
    RUN_TEST(string_shorter);
    RUN_TEST(string_both_null);
    RUN_TEST(string_from_null);
    RUN_TEST(string_len);
    RUN_TEST(string_len_not);
    RUN_TEST(escapes);
    RUN_TEST(null_assertions);
    RUN_TEST(float_million);
    RUN_TEST(float_last_fixed);
    RUN_TEST(float_ten_million);
    RUN_TEST(float_odd_large);
    RUN_TEST(float_tie_to_even);
    RUN_TEST(float_last_small);
    RUN_TEST(float_small);
    RUN_TEST(float_below_ten);
    RUN_TEST(float_negative);
    RUN_TEST(float_hidden);
    RUN_TEST(float_zeros);
    RUN_TEST(float_difference_rounded);
    RUN_TEST(double_difference_exact);
    RUN_TEST(float_infinite_delta);
    RUN_TEST(double_within);
    RUN_TEST(double_array);
    RUN_TEST(double_each);
    RUN_TEST(double_not_equal);
    RUN_TEST(double_order);
    RUN_TEST(double_carry);
    RUN_TEST(double_trait);
    RUN_TEST(arguments_once);
    RUN_TEST(in_an_if);
    RUN_TEST(own_line);
    RUN_TEST(own_file);
    RUN_TEST(own_abort);
    RUN_TEST(own_line_number, 31);
    UnitySetTestFile(__FILE__);
    tearDownFails = 1;
    RUN_TEST(own_abort);
    RUN_TEST(bits_not);
    tearDownFails = 0;

    UNITY_NEW_TEST("by hand");
    if (TEST_PROTECT())
        TEST_ASSERT_EQUAL_INT(1, two);
    UnityConcludeTest();
    return UNITY_END();
}
