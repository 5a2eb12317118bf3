/* SPDX-License-Identifier: MIT
 *
 * unity.h - a small unit-test framework with the API of ThrowTheSwitch Unity.
 *
 * This is an independent implementation of the documented Unity API: a test written for Unity
 * compiles against it, and its output can be read by Unity's parsers. It shares no source with
 * Unity. ./selftest.sh compares it with recordings of the original.
 *
 *     #include "unity.h"
 *     void setUp(void)    { }                      // before each test; both are required
 *     void tearDown(void) { }                      // after each test, whatever happened in it
 *     static void sum_is_two(void) { TEST_ASSERT_EQUAL_INT(2, 1 + 1); }
 *     int main(void)
 *     {
 *         UNITY_BEGIN();
 *         RUN_TEST(sum_is_two);
 *         return UNITY_END() != 0;                 // UNITY_END() is the number of failed tests
 *     }
 *
 * What holds everywhere
 *   Order       expected (or threshold) first, actual second; a delta stands before both, a
 *               length after both.
 *   Arguments   are evaluated once and cast inside the macro; any arithmetic type is accepted.
 *   Failure     prints one line and leaves the test at once by longjmp, also out of nested calls.
 *               A test's second failure is silent.
 *   Message     every TEST_ASSERT_x has a TEST_ASSERT_x_MESSAGE with one more argument, a string.
 *               It replaces the text of a boolean or NULL assertion and follows that of the others.
 *   Output      file:line:name:PASS | FAIL[:text] | IGNORE[: text] | INFO[: text]
 *               then, from UNITY_END(), "N Tests F Failures I Ignored " and "OK" or "FAIL".
 *               The file is that of UNITY_BEGIN(), the line that of the assertion.
 *   Needs       C99 and stdint.h, stddef.h, limits.h; setjmp.h and putchar unless configured
 *               away. No malloc, no printf. The state is the struct `Unity` and one private flag.
 *
 * Configuration: define for every file, or in unity_config.h with UNITY_INCLUDE_CONFIG_H
 *   UNITY_OUTPUT_CHAR(c)        prints one character (an int). Default putchar. If it is a function
 *                               of your own, declare it in unity_config.h.
 *   UNITY_OUTPUT_FLUSH()        after each result and before each jump. Default nothing, or
 *                               fflush(stdout) with UNITY_USE_FLUSH_STDOUT
 *   UNITY_OUTPUT_START(), UNITY_OUTPUT_COMPLETE()   in UNITY_BEGIN and UNITY_END. Default nothing
 *   UNITY_PRINT_EOL()           default '\n'
 *   UNITY_SUPPORT_64            64-bit integers; automatic if long or a pointer has 64 bits
 *   UNITY_LINE_TYPE, UNITY_COUNTER_TYPE   default: the widest unsigned integer
 *   UNITY_EXCLUDE_SETJMP_H      no setjmp: a failed test runs on to its end, silently
 *   UNITY_EXCLUDE_FLOAT         no floating point (and no double)
 *   UNITY_INCLUDE_DOUBLE        the DOUBLE assertions, and 9 printed digits instead of 7
 *   UNITY_FLOAT_PRECISION       relative tolerance of EQUAL_FLOAT (0.00001f), and
 *   UNITY_DOUBLE_PRECISION      of EQUAL_DOUBLE (1e-12); numbers smaller than it print as 0
 *   UNITY_NAN_NOT_EQUAL_NAN     as named. By default NaN equals NaN
 *   UNITY_STRICT                departs from the original in four points; read by unity.c only:
 *                               - a NaN delta fails (the original passes whatever the values);
 *                               - NaN does not equal NaN, nor is an array then accepted unread;
 *                               - a failure in tearDown counts even if the test was ignored; it
 *                                 gets a result line of its own below the IGNORE;
 *                               - a failed comparison of floats ends in ":delta D diff X",
 *                                 the tolerance applied and |E - A|, with all their digits.
 *   A feature that is compiled out (64 bits, float, double) fails at run time, not compile time.
 *
 * Left out on purpose: TEST_PRINTF, TEST_CASE/RANGE/MATRIX, the details stack, command-line
 * filters, colours, times and IDE prefixes; arrays of strings and of memory blocks, inequalities of
 * HEX and CHAR; UNITY_SHORTHAND_AS_x (TEST_ASSERT_EQUAL is always EQUAL_INT), UNITY_FLOAT_TYPE,
 * UNITY_DOUBLE_TYPE, UNITY_EXCLUDE_FLOAT_PRINT; the UNITY_TEST_ASSERT_x(..., line, message) layer
 * except for floats.
 *
 * One deliberate difference: a passing assertion never ends a test. In tearDown, after a failed
 * body, the original stops at the first assertion, even at one that would pass.
 */
#ifndef UNITY_H
#define UNITY_H

#ifdef UNITY_INCLUDE_CONFIG_H
#include "unity_config.h"
#endif

#include <limits.h>
#include <stddef.h>
#include <stdint.h>

/* The guide and the source of the original disagree about this name; both are accepted. */
#if defined(UNITY_EXCLUDE_SETJMP) && !defined(UNITY_EXCLUDE_SETJMP_H)
#define UNITY_EXCLUDE_SETJMP_H
#endif
#ifndef UNITY_EXCLUDE_SETJMP_H
#include <setjmp.h>
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------- types ---------------------------------------- */

#if !defined(UNITY_SUPPORT_64) && (ULONG_MAX > 0xFFFFFFFF || UINTPTR_MAX > 0xFFFFFFFF)
#define UNITY_SUPPORT_64
#endif

/* All integers are compared in these, the widest ones. */
#ifdef UNITY_SUPPORT_64
typedef int64_t  UNITY_INT;
typedef uint64_t UNITY_UINT;
#else
typedef int32_t  UNITY_INT;
typedef uint32_t UNITY_UINT;
#endif

/* All floating-point numbers are passed in this one. Without double it is float, so that no
 * double arithmetic is linked into a small target. */
#ifdef UNITY_INCLUDE_DOUBLE
typedef double UNITY_REAL;
#else
typedef float UNITY_REAL;
#endif

#ifndef UNITY_LINE_TYPE
#define UNITY_LINE_TYPE UNITY_UINT
#endif
#ifndef UNITY_COUNTER_TYPE
#define UNITY_COUNTER_TYPE UNITY_UINT
#endif
#ifndef UNITY_FLOAT_PRECISION
#define UNITY_FLOAT_PRECISION 0.00001f
#endif
#ifndef UNITY_DOUBLE_PRECISION
#define UNITY_DOUBLE_PRECISION 1e-12
#endif

typedef void (*UnityTestFunction)(void);

/* The state of the running suite. The names are those of the original; outside code may read
 * them, and test runners of your own may write them. */
struct UnityState {
    const char        *TestFile;
    const char        *CurrentTestName;
    UNITY_LINE_TYPE    CurrentTestLineNumber; /* of RUN_TEST */
    UNITY_COUNTER_TYPE NumberOfTests;         /* ignored ones included */
    UNITY_COUNTER_TYPE TestFailures;
    UNITY_COUNTER_TYPE TestIgnores;
    UNITY_COUNTER_TYPE CurrentTestFailed;     /* 0 or 1 */
    UNITY_COUNTER_TYPE CurrentTestIgnored;    /* 0 or 1 */
#ifndef UNITY_EXCLUDE_SETJMP_H
    jmp_buf            AbortFrame;            /* where a failing assertion jumps to */
#endif
};
extern struct UnityState Unity;

/* ------------------------------------- running tests ------------------------------------ */

/* Yours: both are required. */
void setUp(void);
void tearDown(void);

/* Yours if your own runner calls them; nothing here does. */
void suiteSetUp(void);
int  suiteTearDown(int failures);
void resetTest(void);
void verifyTest(void);

void UnityBegin(const char *file);            /* zeroes all counters */
int  UnityEnd(void);                          /* prints the summary; returns the failures */
void UnitySetTestFile(const char *file);      /* the file name in the lines that follow */
void UnityDefaultTestRun(UnityTestFunction test, const char *name, UNITY_LINE_TYPE line);
void UnityConcludeTest(void);                 /* counts the current test and ends its line */
void UnityPrint(const char *text);            /* escapes all but printable ASCII; NULL: nothing */
void UnityMessage(const char *message, UNITY_LINE_TYPE line); /* an INFO line, at once */

/* Both end the test; a NULL message prints none. */
void UnityFail(const char *message, UNITY_LINE_TYPE line);
void UnityIgnore(const char *message, UNITY_LINE_TYPE line);

#define UNITY_BEGIN() UnityBegin(__FILE__)
#define UNITY_END()   UnityEnd()

/* RUN_TEST(test) or RUN_TEST(test, line). Runs setUp and the test, then tearDown in any case.
 * Define your own before including this file and the one below is not compiled. */
#ifndef RUN_TEST
#define UNITY_DEFAULT_RUNNER
#define RUN_TEST(...)              UNITY_RUN_(__VA_ARGS__, __LINE__, 0)
#define UNITY_RUN_(test, line, ...) UnityDefaultTestRun(test, #test, (UNITY_LINE_TYPE)(line))
#endif

/* if (TEST_PROTECT()) { ... } runs a block that TEST_ABORT() or a failing assertion leaves. */
#ifndef UNITY_EXCLUDE_SETJMP_H
#define TEST_PROTECT() (setjmp(Unity.AbortFrame) == 0)
#define TEST_ABORT()   longjmp(Unity.AbortFrame, 1)
#else
#define TEST_PROTECT() 1
#define TEST_ABORT()   return
#endif

#define TEST_LINE_NUM   (Unity.CurrentTestLineNumber)
#define TEST_IS_IGNORED (Unity.CurrentTestIgnored)
#define UNITY_NEW_TEST(name) \
    (Unity.CurrentTestName = (name), Unity.CurrentTestLineNumber = UNITY_HERE, \
     Unity.NumberOfTests++)

#define UNITY_HERE ((UNITY_LINE_TYPE)__LINE__)

/* ------------------------------------- basic outcomes ----------------------------------- */

#define TEST_FAIL()            UnityFail(NULL, UNITY_HERE)
#define TEST_FAIL_MESSAGE(m)   UnityFail(m, UNITY_HERE)
#define TEST_IGNORE()          UnityIgnore(NULL, UNITY_HERE)
#define TEST_IGNORE_MESSAGE(m) UnityIgnore(m, UNITY_HERE)
#define TEST_MESSAGE(m)        UnityMessage(m, UNITY_HERE)
#define TEST_PASS()            TEST_ABORT()
#define TEST_PASS_MESSAGE(m)   do { UnityMessage(m, UNITY_HERE); TEST_ABORT(); } while (0)

/* --------------------------------- booleans and pointers -------------------------------- */

/* The texts stand in unity.c, once, instead of in every file that uses them. */
extern const char UnityTextAssert[], UnityTextUnless[], UnityTextTrue[], UnityTextFalse[];
extern const char UnityTextNull[], UnityTextNotNull[], UnityTextNotEqual[];

#define UNITY_CHECK(c, text)               ((c) ? (void)0 : UnityFail(text, UNITY_HERE))
/* A pointer is tested as a number: compilers warn if an array is compared with NULL. */
#define UNITY_IS_NULL(p)                   ((uintptr_t)(p) == 0)

#define TEST_ASSERT(c)                     UNITY_CHECK(c, UnityTextAssert)
#define TEST_ASSERT_MESSAGE(c, m)          UNITY_CHECK(c, m)
#define TEST_ASSERT_UNLESS(c)              UNITY_CHECK(!(c), UnityTextUnless)
#define TEST_ASSERT_UNLESS_MESSAGE(c, m)   UNITY_CHECK(!(c), m)
#define TEST_ASSERT_TRUE(c)                UNITY_CHECK(c, UnityTextTrue)
#define TEST_ASSERT_TRUE_MESSAGE(c, m)     UNITY_CHECK(c, m)
#define TEST_ASSERT_FALSE(c)               UNITY_CHECK(!(c), UnityTextFalse)
#define TEST_ASSERT_FALSE_MESSAGE(c, m)    UNITY_CHECK(!(c), m)
#define TEST_ASSERT_NULL(p)                UNITY_CHECK(UNITY_IS_NULL(p), UnityTextNull)
#define TEST_ASSERT_NULL_MESSAGE(p, m)     UNITY_CHECK(UNITY_IS_NULL(p), m)
#define TEST_ASSERT_NOT_NULL(p)            UNITY_CHECK(!UNITY_IS_NULL(p), UnityTextNotNull)
#define TEST_ASSERT_NOT_NULL_MESSAGE(p, m) UNITY_CHECK(!UNITY_IS_NULL(p), m)

/* -------------------------------------- integers ---------------------------------------- *
 *
 * Values are cast to the named width: EQUAL_INT8(256, 0) passes. INT, UINT and size_t are cast to
 * UNITY_INT or UNITY_UINT, so that EQUAL_INT(-1, 0xFFFFFFFFu) fails where these have 64 bits. In
 * arrays INT, UINT and size_t mean exactly these types. HEX types are unsigned and print as
 * 0x and 2 digits per byte, CHAR prints as 'c', PTR as HEX of a pointer's width.
 *
 * WITHIN includes its limit and cannot overflow; D is cast to the unsigned type of the width, so
 * that a delta of -1 accepts everything.
 *
 * Arrays: length 0 fails, two identical pointers pass unread, one NULL pointer fails.
 */

/* The relation that ACTUAL must have to the value before it; the bits may be combined. */
enum {
    UNITY_EQUAL            = 1,
    UNITY_GREATER          = 2,
    UNITY_LESS             = 4,
    UNITY_NOT_EQUAL        = UNITY_GREATER | UNITY_LESS,
    UNITY_GREATER_OR_EQUAL = UNITY_GREATER | UNITY_EQUAL,
    UNITY_LESS_OR_EQUAL    = UNITY_LESS | UNITY_EQUAL,
    UNITY_NEAR             = 8, /* equal within a delta, which is printed */
    UNITY_BYTES            = 16 /* in arrays: equal memory */
};

/* How an integer is stored (the size of an array's element in bytes, its sign) and printed. */
enum {
    UNITY_SIZE         = 0x0F, /* mask */
    UNITY_SIGNED       = 0x10,
    UNITY_HEX          = 0x20,
    UNITY_QUOTED       = 0x40,
    UNITY_STYLE_INT    = (int)sizeof(int) | UNITY_SIGNED,
    UNITY_STYLE_INT8   = 1 | UNITY_SIGNED,
    UNITY_STYLE_INT16  = 2 | UNITY_SIGNED,
    UNITY_STYLE_INT32  = 4 | UNITY_SIGNED,
    UNITY_STYLE_INT64  = 8 | UNITY_SIGNED,
    UNITY_STYLE_UINT   = (int)sizeof(unsigned),
    UNITY_STYLE_UINT8  = 1,
    UNITY_STYLE_UINT16 = 2,
    UNITY_STYLE_UINT32 = 4,
    UNITY_STYLE_UINT64 = 8,
    UNITY_STYLE_size_t = (int)sizeof(size_t),
    UNITY_STYLE_HEX8   = 1 | UNITY_HEX,
    UNITY_STYLE_HEX16  = 2 | UNITY_HEX,
    UNITY_STYLE_HEX32  = 4 | UNITY_HEX,
    UNITY_STYLE_HEX64  = 8 | UNITY_HEX,
    UNITY_STYLE_CHAR   = 1 | UNITY_QUOTED | (CHAR_MIN < 0 ? UNITY_SIGNED : 0),
    UNITY_STYLE_PTR    = (int)sizeof(void *) | UNITY_HEX
};

/* First to the named width, then to the common type. */
#define UNITY_AS_INT(x)    ((UNITY_INT)(x))
#define UNITY_AS_INT8(x)   ((UNITY_INT)(int8_t)(x))
#define UNITY_AS_INT16(x)  ((UNITY_INT)(int16_t)(x))
#define UNITY_AS_INT32(x)  ((UNITY_INT)(int32_t)(x))
#define UNITY_AS_INT64(x)  ((UNITY_INT)(int64_t)(x))
#define UNITY_AS_UINT(x)   ((UNITY_INT)(UNITY_UINT)(x))
#define UNITY_AS_UINT8(x)  ((UNITY_INT)(uint8_t)(x))
#define UNITY_AS_UINT16(x) ((UNITY_INT)(uint16_t)(x))
#define UNITY_AS_UINT32(x) ((UNITY_INT)(uint32_t)(x))
#define UNITY_AS_UINT64(x) ((UNITY_INT)(uint64_t)(x))
#define UNITY_AS_size_t(x) UNITY_AS_UINT(x)
#define UNITY_AS_HEX8(x)   UNITY_AS_UINT8(x)
#define UNITY_AS_HEX16(x)  UNITY_AS_UINT16(x)
#define UNITY_AS_HEX32(x)  UNITY_AS_UINT32(x)
#define UNITY_AS_HEX64(x)  UNITY_AS_UINT64(x)
#define UNITY_AS_CHAR(x)   ((UNITY_INT)(char)(x))
#define UNITY_AS_PTR(x)    ((UNITY_INT)(uintptr_t)(x))

void UnityAssertInt(UNITY_UINT delta, UNITY_INT expected, UNITY_INT actual, int relation, int style,
                    const char *message, UNITY_LINE_TYPE line);
void UnityAssertIntArray(UNITY_UINT delta, const void *expected, const void *actual, size_t n,
                         int relation, int style, const char *message, UNITY_LINE_TYPE line);
void UnityAssertEachInt(UNITY_INT expected, const void *actual, size_t n, int style,
                        const char *message, UNITY_LINE_TYPE line);
void UnityAssertBits(UNITY_UINT mask, UNITY_UINT expected, UNITY_UINT actual,
                     const char *message, UNITY_LINE_TYPE line);

/* T is one of the type tags above, U the tag of the unsigned type of the same width. */
#define UNITY_COMPARE(T, relation, e, a, m) \
    UnityAssertInt(0, UNITY_AS_##T(e), UNITY_AS_##T(a), \
                   UNITY_##relation, UNITY_STYLE_##T, m, UNITY_HERE)
#define UNITY_WITHIN(T, U, d, e, a, m) \
    UnityAssertInt((UNITY_UINT)UNITY_AS_##U(d), UNITY_AS_##T(e), UNITY_AS_##T(a), \
                   UNITY_NEAR, UNITY_STYLE_##T, m, UNITY_HERE)
#define UNITY_ARRAY(T, e, a, n, m) \
    UnityAssertIntArray(0, (const void *)(e), (const void *)(a), (size_t)(n), \
                        UNITY_EQUAL, UNITY_STYLE_##T, m, UNITY_HERE)
#define UNITY_ARRAY_WITHIN(T, U, d, e, a, n, m) \
    UnityAssertIntArray((UNITY_UINT)UNITY_AS_##U(d), (const void *)(e), (const void *)(a), \
                        (size_t)(n), UNITY_NEAR, UNITY_STYLE_##T, m, UNITY_HERE)
#define UNITY_EACH(T, e, a, n, m) \
    UnityAssertEachInt(UNITY_AS_##T(e), (const void *)(a), (size_t)(n), \
                       UNITY_STYLE_##T, m, UNITY_HERE)
#define UNITY_BITS(mask, e, a, m) \
    UnityAssertBits((UNITY_UINT)(mask), (UNITY_UINT)(e), (UNITY_UINT)(a), m, UNITY_HERE)

/* Without a type: INT, but NOT_EQUAL is the operator != on the arguments as they are. */
#define TEST_ASSERT_EQUAL(e, a)                       TEST_ASSERT_EQUAL_INT(e, a)
#define TEST_ASSERT_EQUAL_MESSAGE(e, a, m)            TEST_ASSERT_EQUAL_INT_MESSAGE(e, a, m)
#define TEST_ASSERT_NOT_EQUAL(e, a)                   UNITY_CHECK((e) != (a), UnityTextNotEqual)
#define TEST_ASSERT_NOT_EQUAL_MESSAGE(e, a, m)        UNITY_CHECK((e) != (a), m)
#define TEST_ASSERT_GREATER_THAN(t, a)                TEST_ASSERT_GREATER_THAN_INT(t, a)
#define TEST_ASSERT_GREATER_THAN_MESSAGE(t, a, m)     TEST_ASSERT_GREATER_THAN_INT_MESSAGE(t, a, m)
#define TEST_ASSERT_LESS_THAN(t, a)                   TEST_ASSERT_LESS_THAN_INT(t, a)
#define TEST_ASSERT_LESS_THAN_MESSAGE(t, a, m)        TEST_ASSERT_LESS_THAN_INT_MESSAGE(t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL(t, a)            TEST_ASSERT_GREATER_OR_EQUAL_INT(t, a)
#define TEST_ASSERT_GREATER_OR_EQUAL_MESSAGE(t, a, m) TEST_ASSERT_GREATER_OR_EQUAL_INT_MESSAGE(t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL(t, a)               TEST_ASSERT_LESS_OR_EQUAL_INT(t, a)
#define TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(t, a, m)    TEST_ASSERT_LESS_OR_EQUAL_INT_MESSAGE(t, a, m)

/* Only the bits of the mask count; prints both masked values as unsigned decimals. */
#define TEST_ASSERT_BITS(mask, e, a)                  UNITY_BITS(mask, e, a, NULL)
#define TEST_ASSERT_BITS_MESSAGE(mask, e, a, m)       UNITY_BITS(mask, e, a, m)
#define TEST_ASSERT_BITS_HIGH(mask, a)                UNITY_BITS(mask, -1, a, NULL)
#define TEST_ASSERT_BITS_HIGH_MESSAGE(mask, a, m)     UNITY_BITS(mask, -1, a, m)
#define TEST_ASSERT_BITS_LOW(mask, a)                 UNITY_BITS(mask, 0, a, NULL)
#define TEST_ASSERT_BITS_LOW_MESSAGE(mask, a, m)      UNITY_BITS(mask, 0, a, m)
#define TEST_ASSERT_BIT_HIGH(bit, a)                  UNITY_BITS((UNITY_UINT)1 << (bit), -1, a, NULL)
#define TEST_ASSERT_BIT_HIGH_MESSAGE(bit, a, m)       UNITY_BITS((UNITY_UINT)1 << (bit), -1, a, m)
#define TEST_ASSERT_BIT_LOW(bit, a)                   UNITY_BITS((UNITY_UINT)1 << (bit), 0, a, NULL)
#define TEST_ASSERT_BIT_LOW_MESSAGE(bit, a, m)        UNITY_BITS((UNITY_UINT)1 << (bit), 0, a, m)

/* " Expected E Was A" */
#define TEST_ASSERT_EQUAL_INT(e, a)               UNITY_COMPARE(INT, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_INT_MESSAGE(e, a, m)    UNITY_COMPARE(INT, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_INT8(e, a)              UNITY_COMPARE(INT8, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_INT8_MESSAGE(e, a, m)   UNITY_COMPARE(INT8, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_INT16(e, a)             UNITY_COMPARE(INT16, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_INT16_MESSAGE(e, a, m)  UNITY_COMPARE(INT16, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_INT32(e, a)             UNITY_COMPARE(INT32, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_INT32_MESSAGE(e, a, m)  UNITY_COMPARE(INT32, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_INT64(e, a)             UNITY_COMPARE(INT64, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_INT64_MESSAGE(e, a, m)  UNITY_COMPARE(INT64, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_UINT(e, a)              UNITY_COMPARE(UINT, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_UINT_MESSAGE(e, a, m)   UNITY_COMPARE(UINT, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_UINT8(e, a)             UNITY_COMPARE(UINT8, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_UINT8_MESSAGE(e, a, m)  UNITY_COMPARE(UINT8, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_UINT16(e, a)            UNITY_COMPARE(UINT16, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_UINT16_MESSAGE(e, a, m) UNITY_COMPARE(UINT16, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_UINT32(e, a)            UNITY_COMPARE(UINT32, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_UINT32_MESSAGE(e, a, m) UNITY_COMPARE(UINT32, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_UINT64(e, a)            UNITY_COMPARE(UINT64, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_UINT64_MESSAGE(e, a, m) UNITY_COMPARE(UINT64, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_size_t(e, a)            UNITY_COMPARE(size_t, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_size_t_MESSAGE(e, a, m) UNITY_COMPARE(size_t, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_HEX8(e, a)              UNITY_COMPARE(HEX8, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_HEX8_MESSAGE(e, a, m)   UNITY_COMPARE(HEX8, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_HEX16(e, a)             UNITY_COMPARE(HEX16, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_HEX16_MESSAGE(e, a, m)  UNITY_COMPARE(HEX16, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_HEX32(e, a)             UNITY_COMPARE(HEX32, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_HEX32_MESSAGE(e, a, m)  UNITY_COMPARE(HEX32, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_HEX64(e, a)             UNITY_COMPARE(HEX64, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_HEX64_MESSAGE(e, a, m)  UNITY_COMPARE(HEX64, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_CHAR(e, a)              UNITY_COMPARE(CHAR, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_CHAR_MESSAGE(e, a, m)   UNITY_COMPARE(CHAR, EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_PTR(e, a)               UNITY_COMPARE(PTR, EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_PTR_MESSAGE(e, a, m)    UNITY_COMPARE(PTR, EQUAL, e, a, m)

/* " Expected A to be not equal to T" */
#define TEST_ASSERT_NOT_EQUAL_INT(t, a)               UNITY_COMPARE(INT, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_INT_MESSAGE(t, a, m)    UNITY_COMPARE(INT, NOT_EQUAL, t, a, m)
#define TEST_ASSERT_NOT_EQUAL_INT8(t, a)              UNITY_COMPARE(INT8, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_INT8_MESSAGE(t, a, m)   UNITY_COMPARE(INT8, NOT_EQUAL, t, a, m)
#define TEST_ASSERT_NOT_EQUAL_INT16(t, a)             UNITY_COMPARE(INT16, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_INT16_MESSAGE(t, a, m)  UNITY_COMPARE(INT16, NOT_EQUAL, t, a, m)
#define TEST_ASSERT_NOT_EQUAL_INT32(t, a)             UNITY_COMPARE(INT32, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_INT32_MESSAGE(t, a, m)  UNITY_COMPARE(INT32, NOT_EQUAL, t, a, m)
#define TEST_ASSERT_NOT_EQUAL_INT64(t, a)             UNITY_COMPARE(INT64, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_INT64_MESSAGE(t, a, m)  UNITY_COMPARE(INT64, NOT_EQUAL, t, a, m)
#define TEST_ASSERT_NOT_EQUAL_UINT(t, a)              UNITY_COMPARE(UINT, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_UINT_MESSAGE(t, a, m)   UNITY_COMPARE(UINT, NOT_EQUAL, t, a, m)
#define TEST_ASSERT_NOT_EQUAL_UINT8(t, a)             UNITY_COMPARE(UINT8, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_UINT8_MESSAGE(t, a, m)  UNITY_COMPARE(UINT8, NOT_EQUAL, t, a, m)
#define TEST_ASSERT_NOT_EQUAL_UINT16(t, a)            UNITY_COMPARE(UINT16, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_UINT16_MESSAGE(t, a, m) UNITY_COMPARE(UINT16, NOT_EQUAL, t, a, m)
#define TEST_ASSERT_NOT_EQUAL_UINT32(t, a)            UNITY_COMPARE(UINT32, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_UINT32_MESSAGE(t, a, m) UNITY_COMPARE(UINT32, NOT_EQUAL, t, a, m)
#define TEST_ASSERT_NOT_EQUAL_UINT64(t, a)            UNITY_COMPARE(UINT64, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_UINT64_MESSAGE(t, a, m) UNITY_COMPARE(UINT64, NOT_EQUAL, t, a, m)
#define TEST_ASSERT_NOT_EQUAL_size_t(t, a)            UNITY_COMPARE(size_t, NOT_EQUAL, t, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_size_t_MESSAGE(t, a, m) UNITY_COMPARE(size_t, NOT_EQUAL, t, a, m)

/* " Expected A to be greater than T": the threshold comes first */
#define TEST_ASSERT_GREATER_THAN_INT(t, a)               UNITY_COMPARE(INT, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_INT_MESSAGE(t, a, m)    UNITY_COMPARE(INT, GREATER, t, a, m)
#define TEST_ASSERT_GREATER_THAN_INT8(t, a)              UNITY_COMPARE(INT8, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_INT8_MESSAGE(t, a, m)   UNITY_COMPARE(INT8, GREATER, t, a, m)
#define TEST_ASSERT_GREATER_THAN_INT16(t, a)             UNITY_COMPARE(INT16, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_INT16_MESSAGE(t, a, m)  UNITY_COMPARE(INT16, GREATER, t, a, m)
#define TEST_ASSERT_GREATER_THAN_INT32(t, a)             UNITY_COMPARE(INT32, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_INT32_MESSAGE(t, a, m)  UNITY_COMPARE(INT32, GREATER, t, a, m)
#define TEST_ASSERT_GREATER_THAN_INT64(t, a)             UNITY_COMPARE(INT64, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_INT64_MESSAGE(t, a, m)  UNITY_COMPARE(INT64, GREATER, t, a, m)
#define TEST_ASSERT_GREATER_THAN_UINT(t, a)              UNITY_COMPARE(UINT, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_UINT_MESSAGE(t, a, m)   UNITY_COMPARE(UINT, GREATER, t, a, m)
#define TEST_ASSERT_GREATER_THAN_UINT8(t, a)             UNITY_COMPARE(UINT8, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_UINT8_MESSAGE(t, a, m)  UNITY_COMPARE(UINT8, GREATER, t, a, m)
#define TEST_ASSERT_GREATER_THAN_UINT16(t, a)            UNITY_COMPARE(UINT16, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_UINT16_MESSAGE(t, a, m) UNITY_COMPARE(UINT16, GREATER, t, a, m)
#define TEST_ASSERT_GREATER_THAN_UINT32(t, a)            UNITY_COMPARE(UINT32, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_UINT32_MESSAGE(t, a, m) UNITY_COMPARE(UINT32, GREATER, t, a, m)
#define TEST_ASSERT_GREATER_THAN_UINT64(t, a)            UNITY_COMPARE(UINT64, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_UINT64_MESSAGE(t, a, m) UNITY_COMPARE(UINT64, GREATER, t, a, m)
#define TEST_ASSERT_GREATER_THAN_size_t(t, a)            UNITY_COMPARE(size_t, GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_size_t_MESSAGE(t, a, m) UNITY_COMPARE(size_t, GREATER, t, a, m)

/* " Expected A to be less than T" */
#define TEST_ASSERT_LESS_THAN_INT(t, a)               UNITY_COMPARE(INT, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_INT_MESSAGE(t, a, m)    UNITY_COMPARE(INT, LESS, t, a, m)
#define TEST_ASSERT_LESS_THAN_INT8(t, a)              UNITY_COMPARE(INT8, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_INT8_MESSAGE(t, a, m)   UNITY_COMPARE(INT8, LESS, t, a, m)
#define TEST_ASSERT_LESS_THAN_INT16(t, a)             UNITY_COMPARE(INT16, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_INT16_MESSAGE(t, a, m)  UNITY_COMPARE(INT16, LESS, t, a, m)
#define TEST_ASSERT_LESS_THAN_INT32(t, a)             UNITY_COMPARE(INT32, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_INT32_MESSAGE(t, a, m)  UNITY_COMPARE(INT32, LESS, t, a, m)
#define TEST_ASSERT_LESS_THAN_INT64(t, a)             UNITY_COMPARE(INT64, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_INT64_MESSAGE(t, a, m)  UNITY_COMPARE(INT64, LESS, t, a, m)
#define TEST_ASSERT_LESS_THAN_UINT(t, a)              UNITY_COMPARE(UINT, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_UINT_MESSAGE(t, a, m)   UNITY_COMPARE(UINT, LESS, t, a, m)
#define TEST_ASSERT_LESS_THAN_UINT8(t, a)             UNITY_COMPARE(UINT8, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_UINT8_MESSAGE(t, a, m)  UNITY_COMPARE(UINT8, LESS, t, a, m)
#define TEST_ASSERT_LESS_THAN_UINT16(t, a)            UNITY_COMPARE(UINT16, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_UINT16_MESSAGE(t, a, m) UNITY_COMPARE(UINT16, LESS, t, a, m)
#define TEST_ASSERT_LESS_THAN_UINT32(t, a)            UNITY_COMPARE(UINT32, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_UINT32_MESSAGE(t, a, m) UNITY_COMPARE(UINT32, LESS, t, a, m)
#define TEST_ASSERT_LESS_THAN_UINT64(t, a)            UNITY_COMPARE(UINT64, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_UINT64_MESSAGE(t, a, m) UNITY_COMPARE(UINT64, LESS, t, a, m)
#define TEST_ASSERT_LESS_THAN_size_t(t, a)            UNITY_COMPARE(size_t, LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_size_t_MESSAGE(t, a, m) UNITY_COMPARE(size_t, LESS, t, a, m)

/* " Expected A to be greater than or equal to T" */
#define TEST_ASSERT_GREATER_OR_EQUAL_INT(t, a)               UNITY_COMPARE(INT, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT_MESSAGE(t, a, m)    UNITY_COMPARE(INT, GREATER_OR_EQUAL, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT8(t, a)              UNITY_COMPARE(INT8, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT8_MESSAGE(t, a, m)   UNITY_COMPARE(INT8, GREATER_OR_EQUAL, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT16(t, a)             UNITY_COMPARE(INT16, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT16_MESSAGE(t, a, m)  UNITY_COMPARE(INT16, GREATER_OR_EQUAL, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT32(t, a)             UNITY_COMPARE(INT32, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT32_MESSAGE(t, a, m)  UNITY_COMPARE(INT32, GREATER_OR_EQUAL, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT64(t, a)             UNITY_COMPARE(INT64, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT64_MESSAGE(t, a, m)  UNITY_COMPARE(INT64, GREATER_OR_EQUAL, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT(t, a)              UNITY_COMPARE(UINT, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT_MESSAGE(t, a, m)   UNITY_COMPARE(UINT, GREATER_OR_EQUAL, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT8(t, a)             UNITY_COMPARE(UINT8, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT8_MESSAGE(t, a, m)  UNITY_COMPARE(UINT8, GREATER_OR_EQUAL, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT16(t, a)            UNITY_COMPARE(UINT16, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT16_MESSAGE(t, a, m) UNITY_COMPARE(UINT16, GREATER_OR_EQUAL, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT32(t, a)            UNITY_COMPARE(UINT32, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT32_MESSAGE(t, a, m) UNITY_COMPARE(UINT32, GREATER_OR_EQUAL, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT64(t, a)            UNITY_COMPARE(UINT64, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_UINT64_MESSAGE(t, a, m) UNITY_COMPARE(UINT64, GREATER_OR_EQUAL, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_size_t(t, a)            UNITY_COMPARE(size_t, GREATER_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_size_t_MESSAGE(t, a, m) UNITY_COMPARE(size_t, GREATER_OR_EQUAL, t, a, m)

/* " Expected A to be less than or equal to T" */
#define TEST_ASSERT_LESS_OR_EQUAL_INT(t, a)               UNITY_COMPARE(INT, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT_MESSAGE(t, a, m)    UNITY_COMPARE(INT, LESS_OR_EQUAL, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_INT8(t, a)              UNITY_COMPARE(INT8, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT8_MESSAGE(t, a, m)   UNITY_COMPARE(INT8, LESS_OR_EQUAL, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_INT16(t, a)             UNITY_COMPARE(INT16, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT16_MESSAGE(t, a, m)  UNITY_COMPARE(INT16, LESS_OR_EQUAL, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_INT32(t, a)             UNITY_COMPARE(INT32, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT32_MESSAGE(t, a, m)  UNITY_COMPARE(INT32, LESS_OR_EQUAL, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_INT64(t, a)             UNITY_COMPARE(INT64, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT64_MESSAGE(t, a, m)  UNITY_COMPARE(INT64, LESS_OR_EQUAL, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT(t, a)              UNITY_COMPARE(UINT, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT_MESSAGE(t, a, m)   UNITY_COMPARE(UINT, LESS_OR_EQUAL, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT8(t, a)             UNITY_COMPARE(UINT8, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT8_MESSAGE(t, a, m)  UNITY_COMPARE(UINT8, LESS_OR_EQUAL, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT16(t, a)            UNITY_COMPARE(UINT16, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT16_MESSAGE(t, a, m) UNITY_COMPARE(UINT16, LESS_OR_EQUAL, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT32(t, a)            UNITY_COMPARE(UINT32, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT32_MESSAGE(t, a, m) UNITY_COMPARE(UINT32, LESS_OR_EQUAL, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT64(t, a)            UNITY_COMPARE(UINT64, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_UINT64_MESSAGE(t, a, m) UNITY_COMPARE(UINT64, LESS_OR_EQUAL, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_size_t(t, a)            UNITY_COMPARE(size_t, LESS_OR_EQUAL, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_size_t_MESSAGE(t, a, m) UNITY_COMPARE(size_t, LESS_OR_EQUAL, t, a, m)

/* " Values Not Within Delta D Expected E Was A": iff |E - A| > D.
 * The second tag is the type of D. */
#define TEST_ASSERT_INT_WITHIN(d, e, a)               UNITY_WITHIN(INT, UINT, d, e, a, NULL)
#define TEST_ASSERT_INT_WITHIN_MESSAGE(d, e, a, m)    UNITY_WITHIN(INT, UINT, d, e, a, m)
#define TEST_ASSERT_INT8_WITHIN(d, e, a)              UNITY_WITHIN(INT8, UINT8, d, e, a, NULL)
#define TEST_ASSERT_INT8_WITHIN_MESSAGE(d, e, a, m)   UNITY_WITHIN(INT8, UINT8, d, e, a, m)
#define TEST_ASSERT_INT16_WITHIN(d, e, a)             UNITY_WITHIN(INT16, UINT16, d, e, a, NULL)
#define TEST_ASSERT_INT16_WITHIN_MESSAGE(d, e, a, m)  UNITY_WITHIN(INT16, UINT16, d, e, a, m)
#define TEST_ASSERT_INT32_WITHIN(d, e, a)             UNITY_WITHIN(INT32, UINT32, d, e, a, NULL)
#define TEST_ASSERT_INT32_WITHIN_MESSAGE(d, e, a, m)  UNITY_WITHIN(INT32, UINT32, d, e, a, m)
#define TEST_ASSERT_INT64_WITHIN(d, e, a)             UNITY_WITHIN(INT64, UINT64, d, e, a, NULL)
#define TEST_ASSERT_INT64_WITHIN_MESSAGE(d, e, a, m)  UNITY_WITHIN(INT64, UINT64, d, e, a, m)
#define TEST_ASSERT_UINT_WITHIN(d, e, a)              UNITY_WITHIN(UINT, UINT, d, e, a, NULL)
#define TEST_ASSERT_UINT_WITHIN_MESSAGE(d, e, a, m)   UNITY_WITHIN(UINT, UINT, d, e, a, m)
#define TEST_ASSERT_UINT8_WITHIN(d, e, a)             UNITY_WITHIN(UINT8, UINT8, d, e, a, NULL)
#define TEST_ASSERT_UINT8_WITHIN_MESSAGE(d, e, a, m)  UNITY_WITHIN(UINT8, UINT8, d, e, a, m)
#define TEST_ASSERT_UINT16_WITHIN(d, e, a)            UNITY_WITHIN(UINT16, UINT16, d, e, a, NULL)
#define TEST_ASSERT_UINT16_WITHIN_MESSAGE(d, e, a, m) UNITY_WITHIN(UINT16, UINT16, d, e, a, m)
#define TEST_ASSERT_UINT32_WITHIN(d, e, a)            UNITY_WITHIN(UINT32, UINT32, d, e, a, NULL)
#define TEST_ASSERT_UINT32_WITHIN_MESSAGE(d, e, a, m) UNITY_WITHIN(UINT32, UINT32, d, e, a, m)
#define TEST_ASSERT_UINT64_WITHIN(d, e, a)            UNITY_WITHIN(UINT64, UINT64, d, e, a, NULL)
#define TEST_ASSERT_UINT64_WITHIN_MESSAGE(d, e, a, m) UNITY_WITHIN(UINT64, UINT64, d, e, a, m)
#define TEST_ASSERT_size_t_WITHIN(d, e, a)            UNITY_WITHIN(size_t, size_t, d, e, a, NULL)
#define TEST_ASSERT_size_t_WITHIN_MESSAGE(d, e, a, m) UNITY_WITHIN(size_t, size_t, d, e, a, m)

/* " Element i Expected E Was A" */
#define TEST_ASSERT_EQUAL_INT_ARRAY(e, a, n)               UNITY_ARRAY(INT, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_INT_ARRAY_MESSAGE(e, a, n, m)    UNITY_ARRAY(INT, e, a, n, m)
#define TEST_ASSERT_EQUAL_INT8_ARRAY(e, a, n)              UNITY_ARRAY(INT8, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_INT8_ARRAY_MESSAGE(e, a, n, m)   UNITY_ARRAY(INT8, e, a, n, m)
#define TEST_ASSERT_EQUAL_INT16_ARRAY(e, a, n)             UNITY_ARRAY(INT16, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_INT16_ARRAY_MESSAGE(e, a, n, m)  UNITY_ARRAY(INT16, e, a, n, m)
#define TEST_ASSERT_EQUAL_INT32_ARRAY(e, a, n)             UNITY_ARRAY(INT32, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_INT32_ARRAY_MESSAGE(e, a, n, m)  UNITY_ARRAY(INT32, e, a, n, m)
#define TEST_ASSERT_EQUAL_INT64_ARRAY(e, a, n)             UNITY_ARRAY(INT64, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_INT64_ARRAY_MESSAGE(e, a, n, m)  UNITY_ARRAY(INT64, e, a, n, m)
#define TEST_ASSERT_EQUAL_UINT_ARRAY(e, a, n)              UNITY_ARRAY(UINT, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_UINT_ARRAY_MESSAGE(e, a, n, m)   UNITY_ARRAY(UINT, e, a, n, m)
#define TEST_ASSERT_EQUAL_UINT8_ARRAY(e, a, n)             UNITY_ARRAY(UINT8, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_UINT8_ARRAY_MESSAGE(e, a, n, m)  UNITY_ARRAY(UINT8, e, a, n, m)
#define TEST_ASSERT_EQUAL_UINT16_ARRAY(e, a, n)            UNITY_ARRAY(UINT16, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_UINT16_ARRAY_MESSAGE(e, a, n, m) UNITY_ARRAY(UINT16, e, a, n, m)
#define TEST_ASSERT_EQUAL_UINT32_ARRAY(e, a, n)            UNITY_ARRAY(UINT32, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_UINT32_ARRAY_MESSAGE(e, a, n, m) UNITY_ARRAY(UINT32, e, a, n, m)
#define TEST_ASSERT_EQUAL_UINT64_ARRAY(e, a, n)            UNITY_ARRAY(UINT64, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_UINT64_ARRAY_MESSAGE(e, a, n, m) UNITY_ARRAY(UINT64, e, a, n, m)
#define TEST_ASSERT_EQUAL_size_t_ARRAY(e, a, n)            UNITY_ARRAY(size_t, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_size_t_ARRAY_MESSAGE(e, a, n, m) UNITY_ARRAY(size_t, e, a, n, m)
#define TEST_ASSERT_EQUAL_HEX8_ARRAY(e, a, n)              UNITY_ARRAY(HEX8, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_HEX8_ARRAY_MESSAGE(e, a, n, m)   UNITY_ARRAY(HEX8, e, a, n, m)
#define TEST_ASSERT_EQUAL_HEX16_ARRAY(e, a, n)             UNITY_ARRAY(HEX16, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_HEX16_ARRAY_MESSAGE(e, a, n, m)  UNITY_ARRAY(HEX16, e, a, n, m)
#define TEST_ASSERT_EQUAL_HEX32_ARRAY(e, a, n)             UNITY_ARRAY(HEX32, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_HEX32_ARRAY_MESSAGE(e, a, n, m)  UNITY_ARRAY(HEX32, e, a, n, m)
#define TEST_ASSERT_EQUAL_HEX64_ARRAY(e, a, n)             UNITY_ARRAY(HEX64, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_HEX64_ARRAY_MESSAGE(e, a, n, m)  UNITY_ARRAY(HEX64, e, a, n, m)
#define TEST_ASSERT_EQUAL_CHAR_ARRAY(e, a, n)              UNITY_ARRAY(CHAR, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_CHAR_ARRAY_MESSAGE(e, a, n, m)   UNITY_ARRAY(CHAR, e, a, n, m)
#define TEST_ASSERT_EQUAL_PTR_ARRAY(e, a, n)               UNITY_ARRAY(PTR, e, a, n, NULL)
#define TEST_ASSERT_EQUAL_PTR_ARRAY_MESSAGE(e, a, n, m)    UNITY_ARRAY(PTR, e, a, n, m)

/* " Values Not Within Delta D Element i Expected E Was A" */
#define TEST_ASSERT_INT_ARRAY_WITHIN(d, e, a, n)               UNITY_ARRAY_WITHIN(INT, UINT, d, e, a, n, NULL)
#define TEST_ASSERT_INT_ARRAY_WITHIN_MESSAGE(d, e, a, n, m)    UNITY_ARRAY_WITHIN(INT, UINT, d, e, a, n, m)
#define TEST_ASSERT_INT8_ARRAY_WITHIN(d, e, a, n)              UNITY_ARRAY_WITHIN(INT8, UINT8, d, e, a, n, NULL)
#define TEST_ASSERT_INT8_ARRAY_WITHIN_MESSAGE(d, e, a, n, m)   UNITY_ARRAY_WITHIN(INT8, UINT8, d, e, a, n, m)
#define TEST_ASSERT_INT16_ARRAY_WITHIN(d, e, a, n)             UNITY_ARRAY_WITHIN(INT16, UINT16, d, e, a, n, NULL)
#define TEST_ASSERT_INT16_ARRAY_WITHIN_MESSAGE(d, e, a, n, m)  UNITY_ARRAY_WITHIN(INT16, UINT16, d, e, a, n, m)
#define TEST_ASSERT_INT32_ARRAY_WITHIN(d, e, a, n)             UNITY_ARRAY_WITHIN(INT32, UINT32, d, e, a, n, NULL)
#define TEST_ASSERT_INT32_ARRAY_WITHIN_MESSAGE(d, e, a, n, m)  UNITY_ARRAY_WITHIN(INT32, UINT32, d, e, a, n, m)
#define TEST_ASSERT_INT64_ARRAY_WITHIN(d, e, a, n)             UNITY_ARRAY_WITHIN(INT64, UINT64, d, e, a, n, NULL)
#define TEST_ASSERT_INT64_ARRAY_WITHIN_MESSAGE(d, e, a, n, m)  UNITY_ARRAY_WITHIN(INT64, UINT64, d, e, a, n, m)
#define TEST_ASSERT_UINT_ARRAY_WITHIN(d, e, a, n)              UNITY_ARRAY_WITHIN(UINT, UINT, d, e, a, n, NULL)
#define TEST_ASSERT_UINT_ARRAY_WITHIN_MESSAGE(d, e, a, n, m)   UNITY_ARRAY_WITHIN(UINT, UINT, d, e, a, n, m)
#define TEST_ASSERT_UINT8_ARRAY_WITHIN(d, e, a, n)             UNITY_ARRAY_WITHIN(UINT8, UINT8, d, e, a, n, NULL)
#define TEST_ASSERT_UINT8_ARRAY_WITHIN_MESSAGE(d, e, a, n, m)  UNITY_ARRAY_WITHIN(UINT8, UINT8, d, e, a, n, m)
#define TEST_ASSERT_UINT16_ARRAY_WITHIN(d, e, a, n)            UNITY_ARRAY_WITHIN(UINT16, UINT16, d, e, a, n, NULL)
#define TEST_ASSERT_UINT16_ARRAY_WITHIN_MESSAGE(d, e, a, n, m) UNITY_ARRAY_WITHIN(UINT16, UINT16, d, e, a, n, m)
#define TEST_ASSERT_UINT32_ARRAY_WITHIN(d, e, a, n)            UNITY_ARRAY_WITHIN(UINT32, UINT32, d, e, a, n, NULL)
#define TEST_ASSERT_UINT32_ARRAY_WITHIN_MESSAGE(d, e, a, n, m) UNITY_ARRAY_WITHIN(UINT32, UINT32, d, e, a, n, m)
#define TEST_ASSERT_UINT64_ARRAY_WITHIN(d, e, a, n)            UNITY_ARRAY_WITHIN(UINT64, UINT64, d, e, a, n, NULL)
#define TEST_ASSERT_UINT64_ARRAY_WITHIN_MESSAGE(d, e, a, n, m) UNITY_ARRAY_WITHIN(UINT64, UINT64, d, e, a, n, m)
#define TEST_ASSERT_size_t_ARRAY_WITHIN(d, e, a, n)            UNITY_ARRAY_WITHIN(size_t, size_t, d, e, a, n, NULL)
#define TEST_ASSERT_size_t_ARRAY_WITHIN_MESSAGE(d, e, a, n, m) UNITY_ARRAY_WITHIN(size_t, size_t, d, e, a, n, m)

/* " Element i Expected E Was A": one expected value for every element */
#define TEST_ASSERT_EACH_EQUAL_INT(e, a, n)               UNITY_EACH(INT, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_INT_MESSAGE(e, a, n, m)    UNITY_EACH(INT, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_INT8(e, a, n)              UNITY_EACH(INT8, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_INT8_MESSAGE(e, a, n, m)   UNITY_EACH(INT8, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_INT16(e, a, n)             UNITY_EACH(INT16, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_INT16_MESSAGE(e, a, n, m)  UNITY_EACH(INT16, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_INT32(e, a, n)             UNITY_EACH(INT32, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_INT32_MESSAGE(e, a, n, m)  UNITY_EACH(INT32, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_INT64(e, a, n)             UNITY_EACH(INT64, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_INT64_MESSAGE(e, a, n, m)  UNITY_EACH(INT64, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_UINT(e, a, n)              UNITY_EACH(UINT, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_UINT_MESSAGE(e, a, n, m)   UNITY_EACH(UINT, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_UINT8(e, a, n)             UNITY_EACH(UINT8, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_UINT8_MESSAGE(e, a, n, m)  UNITY_EACH(UINT8, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_UINT16(e, a, n)            UNITY_EACH(UINT16, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_UINT16_MESSAGE(e, a, n, m) UNITY_EACH(UINT16, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_UINT32(e, a, n)            UNITY_EACH(UINT32, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_UINT32_MESSAGE(e, a, n, m) UNITY_EACH(UINT32, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_UINT64(e, a, n)            UNITY_EACH(UINT64, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_UINT64_MESSAGE(e, a, n, m) UNITY_EACH(UINT64, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_size_t(e, a, n)            UNITY_EACH(size_t, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_size_t_MESSAGE(e, a, n, m) UNITY_EACH(size_t, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_HEX8(e, a, n)              UNITY_EACH(HEX8, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_HEX8_MESSAGE(e, a, n, m)   UNITY_EACH(HEX8, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_HEX16(e, a, n)             UNITY_EACH(HEX16, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_HEX16_MESSAGE(e, a, n, m)  UNITY_EACH(HEX16, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_HEX32(e, a, n)             UNITY_EACH(HEX32, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_HEX32_MESSAGE(e, a, n, m)  UNITY_EACH(HEX32, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_HEX64(e, a, n)             UNITY_EACH(HEX64, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_HEX64_MESSAGE(e, a, n, m)  UNITY_EACH(HEX64, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_CHAR(e, a, n)              UNITY_EACH(CHAR, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_CHAR_MESSAGE(e, a, n, m)   UNITY_EACH(CHAR, e, a, n, m)
#define TEST_ASSERT_EACH_EQUAL_PTR(e, a, n)               UNITY_EACH(PTR, e, a, n, NULL)
#define TEST_ASSERT_EACH_EQUAL_PTR_MESSAGE(e, a, n, m)    UNITY_EACH(PTR, e, a, n, m)

/* --------------------------------- memory and strings ----------------------------------- *
 *
 * MEMORY: " Memory Mismatch. Byte i Expected 0xHH Was 0xHH"; lengths and pointers as for arrays.
 * STRING: " Expected 'abc' Was 'abd' Character 2 Expected 'c' Was 'd'". Two NULL are equal; one
 * NULL fails. STRING_LEN reads and prints at most n characters.
 */

void UnityAssertString(const char *expected, const char *actual, size_t n,
                       const char *message, UNITY_LINE_TYPE line);

#define UNITY_MEMORY(e, a, n, m) \
    UnityAssertIntArray(0, (const void *)(e), (const void *)(a), (size_t)(n), \
                        UNITY_BYTES, UNITY_STYLE_HEX8, m, UNITY_HERE)
#define UNITY_STRING(e, a, n, m) \
    UnityAssertString((const char *)(e), (const char *)(a), (size_t)(n), m, UNITY_HERE)

#define TEST_ASSERT_EQUAL_MEMORY(e, a, n)                UNITY_MEMORY(e, a, n, NULL)
#define TEST_ASSERT_EQUAL_MEMORY_MESSAGE(e, a, n, m)     UNITY_MEMORY(e, a, n, m)
#define TEST_ASSERT_EQUAL_STRING(e, a)                   UNITY_STRING(e, a, SIZE_MAX, NULL)
#define TEST_ASSERT_EQUAL_STRING_MESSAGE(e, a, m)        UNITY_STRING(e, a, SIZE_MAX, m)
#define TEST_ASSERT_EQUAL_STRING_LEN(e, a, n)            UNITY_STRING(e, a, n, NULL)
#define TEST_ASSERT_EQUAL_STRING_LEN_MESSAGE(e, a, n, m) UNITY_STRING(e, a, n, m)

/* ----------------------------------- floating point ------------------------------------- *
 *
 * P is UNITY_FLOAT_PRECISION or UNITY_DOUBLE_PRECISION.
 *
 * FLOAT_WITHIN(d, e, a)         |e - a| <= |d|. Equal infinities pass, also two NaN (but see
 *                               UNITY_STRICT); an infinite difference fails whatever d is.
 *                               A NaN d passes, except with UNITY_STRICT.
 * FLOAT_NOT_WITHIN(d, e, a)     not so; NaN against a number is not within.
 * EQUAL_FLOAT(e, a)             as FLOAT_WITHIN with d = P e, that is relative to the expected
 *                               value: nothing but 0 equals 0.
 * NOT_EQUAL_FLOAT(e, a)         not so
 * FLOAT_ARRAY_WITHIN(d, e, a, n)  per element |e - a| <= |d| + P |e|: wider than FLOAT_WITHIN.
 *                               An infinite d passes, unread except with UNITY_STRICT; NaN fails.
 * EQUAL_FLOAT_ARRAY(e, a, n)    the same with d = 0
 * EACH_EQUAL_FLOAT(e, a, n)     one expected value for every element
 * GREATER_THAN_FLOAT(t, a), LESS_THAN_FLOAT      strict; NaN fails
 * GREATER_OR_EQUAL_FLOAT(t, a), LESS_OR_EQUAL_FLOAT   that, or as EQUAL_FLOAT(t, a)
 * FLOAT_IS_INF, _IS_NEG_INF, _IS_NAN, _IS_DETERMINATE   +infinity, -infinity, NaN, finite
 *
 * The texts are those of the integers, except that WITHIN prints no delta (UNITY_STRICT does), and
 * NOT_WITHIN " Expected E to be not equal to A". Numbers print like printf's "%.7g" ("%.9g"), the
 * last digit off by one at times (without double, by two beyond 1e-30).
 *
 * UNITY_TEST_ASSERT_x(..., line, m) stands beside each: an assertion of your own, for a vector say,
 * can be built of it and report the line of its caller.
 */

enum { UNITY_KIND_FLOAT, UNITY_KIND_DOUBLE };
enum { UNITY_TRAIT_INF, UNITY_TRAIT_NEG_INF, UNITY_TRAIT_NAN, UNITY_TRAIT_DETERMINATE };

#ifndef UNITY_EXCLUDE_FLOAT

void UnityAssertRealWithin(UNITY_REAL delta, UNITY_REAL expected, UNITY_REAL actual, int kind,
                           int wanted, const char *message, UNITY_LINE_TYPE line);
void UnityAssertRealEqual(UNITY_REAL expected, UNITY_REAL actual, int kind,
                          int wanted, const char *message, UNITY_LINE_TYPE line);
void UnityAssertRealArray(UNITY_REAL delta, const void *expected, const void *actual, size_t n,
                          int kind, const char *message, UNITY_LINE_TYPE line);
void UnityAssertEachReal(UNITY_REAL expected, const void *actual, size_t n,
                         int kind, const char *message, UNITY_LINE_TYPE line);
void UnityAssertRealOrder(UNITY_REAL threshold, UNITY_REAL actual, int relation,
                          int kind, const char *message, UNITY_LINE_TYPE line);
void UnityAssertRealTrait(UNITY_REAL actual, int trait, int kind,
                          int wanted, const char *message, UNITY_LINE_TYPE line);

#define UNITY_AS_FLOAT(x)  ((UNITY_REAL)(float)(x))
#define UNITY_AS_DOUBLE(x) ((UNITY_REAL)(x))

#define UNITY_REAL_WITHIN(T, wanted, d, e, a, line, m) \
    UnityAssertRealWithin(UNITY_AS_##T(d), UNITY_AS_##T(e), UNITY_AS_##T(a), \
                          UNITY_KIND_##T, wanted, m, (UNITY_LINE_TYPE)(line))
#define UNITY_REAL_EQUAL(T, wanted, e, a, line, m) \
    UnityAssertRealEqual(UNITY_AS_##T(e), UNITY_AS_##T(a), \
                         UNITY_KIND_##T, wanted, m, (UNITY_LINE_TYPE)(line))
#define UNITY_REAL_ARRAY(T, d, e, a, n, line, m) \
    UnityAssertRealArray(UNITY_AS_##T(d), (const void *)(e), (const void *)(a), (size_t)(n), \
                         UNITY_KIND_##T, m, (UNITY_LINE_TYPE)(line))
#define UNITY_REAL_EACH(T, e, a, n, line, m) \
    UnityAssertEachReal(UNITY_AS_##T(e), (const void *)(a), (size_t)(n), \
                        UNITY_KIND_##T, m, (UNITY_LINE_TYPE)(line))
#define UNITY_REAL_ORDER(T, relation, t, a, line, m) \
    UnityAssertRealOrder(UNITY_AS_##T(t), UNITY_AS_##T(a), UNITY_##relation, \
                         UNITY_KIND_##T, m, (UNITY_LINE_TYPE)(line))
#define UNITY_REAL_TRAIT(T, trait, wanted, a, line, m) \
    UnityAssertRealTrait(UNITY_AS_##T(a), UNITY_TRAIT_##trait, \
                         UNITY_KIND_##T, wanted, m, (UNITY_LINE_TYPE)(line))

#else /* the arguments are still used, lest the test's variables become unused */

#define UNITY_NO_REAL(T, line) UnityFail(UnityTextNo##T, (UNITY_LINE_TYPE)(line))
#define UNITY_REAL_WITHIN(T, wanted, d, e, a, line, m) \
    ((void)(d), (void)(e), (void)(a), UNITY_NO_REAL(T, line))
#define UNITY_REAL_EQUAL(T, wanted, e, a, line, m) ((void)(e), (void)(a), UNITY_NO_REAL(T, line))
#define UNITY_REAL_ARRAY(T, d, e, a, n, line, m) \
    ((void)(d), (void)(e), (void)(a), (void)(n), UNITY_NO_REAL(T, line))
#define UNITY_REAL_EACH(T, e, a, n, line, m) \
    ((void)(e), (void)(a), (void)(n), UNITY_NO_REAL(T, line))
#define UNITY_REAL_ORDER(T, relation, t, a, line, m) ((void)(t), (void)(a), UNITY_NO_REAL(T, line))
#define UNITY_REAL_TRAIT(T, trait, wanted, a, line, m) ((void)(a), UNITY_NO_REAL(T, line))

#endif
extern const char UnityTextNoFLOAT[], UnityTextNoDOUBLE[];

#define TEST_ASSERT_FLOAT_WITHIN(d, e, a)                         UNITY_REAL_WITHIN(FLOAT, 1, d, e, a, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_WITHIN_MESSAGE(d, e, a, m)              UNITY_REAL_WITHIN(FLOAT, 1, d, e, a, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_WITHIN(d, e, a, line, m)          UNITY_REAL_WITHIN(FLOAT, 1, d, e, a, line, m)
#define TEST_ASSERT_FLOAT_NOT_WITHIN(d, e, a)                     UNITY_REAL_WITHIN(FLOAT, 0, d, e, a, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_NOT_WITHIN_MESSAGE(d, e, a, m)          UNITY_REAL_WITHIN(FLOAT, 0, d, e, a, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_NOT_WITHIN(d, e, a, line, m)      UNITY_REAL_WITHIN(FLOAT, 0, d, e, a, line, m)
#define TEST_ASSERT_EQUAL_FLOAT(e, a)                             UNITY_REAL_EQUAL(FLOAT, 1, e, a, __LINE__, NULL)
#define TEST_ASSERT_EQUAL_FLOAT_MESSAGE(e, a, m)                  UNITY_REAL_EQUAL(FLOAT, 1, e, a, __LINE__, m)
#define UNITY_TEST_ASSERT_EQUAL_FLOAT(e, a, line, m)              UNITY_REAL_EQUAL(FLOAT, 1, e, a, line, m)
#define TEST_ASSERT_NOT_EQUAL_FLOAT(e, a)                         UNITY_REAL_EQUAL(FLOAT, 0, e, a, __LINE__, NULL)
#define TEST_ASSERT_NOT_EQUAL_FLOAT_MESSAGE(e, a, m)              UNITY_REAL_EQUAL(FLOAT, 0, e, a, __LINE__, m)
#define UNITY_TEST_ASSERT_NOT_EQUAL_FLOAT(e, a, line, m)          UNITY_REAL_EQUAL(FLOAT, 0, e, a, line, m)
#define TEST_ASSERT_FLOAT_ARRAY_WITHIN(d, e, a, n)                UNITY_REAL_ARRAY(FLOAT, d, e, a, n, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_ARRAY_WITHIN_MESSAGE(d, e, a, n, m)     UNITY_REAL_ARRAY(FLOAT, d, e, a, n, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_ARRAY_WITHIN(d, e, a, n, line, m) UNITY_REAL_ARRAY(FLOAT, d, e, a, n, line, m)
#define TEST_ASSERT_EQUAL_FLOAT_ARRAY(e, a, n)                    UNITY_REAL_ARRAY(FLOAT, 0, e, a, n, __LINE__, NULL)
#define TEST_ASSERT_EQUAL_FLOAT_ARRAY_MESSAGE(e, a, n, m)         UNITY_REAL_ARRAY(FLOAT, 0, e, a, n, __LINE__, m)
#define UNITY_TEST_ASSERT_EQUAL_FLOAT_ARRAY(e, a, n, line, m)     UNITY_REAL_ARRAY(FLOAT, 0, e, a, n, line, m)
#define TEST_ASSERT_EACH_EQUAL_FLOAT(e, a, n)                     UNITY_REAL_EACH(FLOAT, e, a, n, __LINE__, NULL)
#define TEST_ASSERT_EACH_EQUAL_FLOAT_MESSAGE(e, a, n, m)          UNITY_REAL_EACH(FLOAT, e, a, n, __LINE__, m)
#define UNITY_TEST_ASSERT_EACH_EQUAL_FLOAT(e, a, n, line, m)      UNITY_REAL_EACH(FLOAT, e, a, n, line, m)
#define TEST_ASSERT_GREATER_THAN_FLOAT(t, a)                      UNITY_REAL_ORDER(FLOAT, GREATER, t, a, __LINE__, NULL)
#define TEST_ASSERT_GREATER_THAN_FLOAT_MESSAGE(t, a, m)           UNITY_REAL_ORDER(FLOAT, GREATER, t, a, __LINE__, m)
#define UNITY_TEST_ASSERT_GREATER_THAN_FLOAT(t, a, line, m)       UNITY_REAL_ORDER(FLOAT, GREATER, t, a, line, m)
#define TEST_ASSERT_LESS_THAN_FLOAT(t, a)                         UNITY_REAL_ORDER(FLOAT, LESS, t, a, __LINE__, NULL)
#define TEST_ASSERT_LESS_THAN_FLOAT_MESSAGE(t, a, m)              UNITY_REAL_ORDER(FLOAT, LESS, t, a, __LINE__, m)
#define UNITY_TEST_ASSERT_LESS_THAN_FLOAT(t, a, line, m)          UNITY_REAL_ORDER(FLOAT, LESS, t, a, line, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_FLOAT(t, a)                  UNITY_REAL_ORDER(FLOAT, GREATER_OR_EQUAL, t, a, __LINE__, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_FLOAT_MESSAGE(t, a, m)       UNITY_REAL_ORDER(FLOAT, GREATER_OR_EQUAL, t, a, __LINE__, m)
#define UNITY_TEST_ASSERT_GREATER_OR_EQUAL_FLOAT(t, a, line, m)   UNITY_REAL_ORDER(FLOAT, GREATER_OR_EQUAL, t, a, line, m)
#define TEST_ASSERT_LESS_OR_EQUAL_FLOAT(t, a)                     UNITY_REAL_ORDER(FLOAT, LESS_OR_EQUAL, t, a, __LINE__, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_FLOAT_MESSAGE(t, a, m)          UNITY_REAL_ORDER(FLOAT, LESS_OR_EQUAL, t, a, __LINE__, m)
#define UNITY_TEST_ASSERT_LESS_OR_EQUAL_FLOAT(t, a, line, m)      UNITY_REAL_ORDER(FLOAT, LESS_OR_EQUAL, t, a, line, m)
#define TEST_ASSERT_FLOAT_IS_INF(a)                               UNITY_REAL_TRAIT(FLOAT, INF, 1, a, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_IS_INF_MESSAGE(a, m)                    UNITY_REAL_TRAIT(FLOAT, INF, 1, a, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_IS_INF(a, line, m)                UNITY_REAL_TRAIT(FLOAT, INF, 1, a, line, m)
#define TEST_ASSERT_FLOAT_IS_NOT_INF(a)                           UNITY_REAL_TRAIT(FLOAT, INF, 0, a, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_IS_NOT_INF_MESSAGE(a, m)                UNITY_REAL_TRAIT(FLOAT, INF, 0, a, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_IS_NOT_INF(a, line, m)            UNITY_REAL_TRAIT(FLOAT, INF, 0, a, line, m)
#define TEST_ASSERT_FLOAT_IS_NEG_INF(a)                           UNITY_REAL_TRAIT(FLOAT, NEG_INF, 1, a, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_IS_NEG_INF_MESSAGE(a, m)                UNITY_REAL_TRAIT(FLOAT, NEG_INF, 1, a, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_IS_NEG_INF(a, line, m)            UNITY_REAL_TRAIT(FLOAT, NEG_INF, 1, a, line, m)
#define TEST_ASSERT_FLOAT_IS_NOT_NEG_INF(a)                       UNITY_REAL_TRAIT(FLOAT, NEG_INF, 0, a, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_IS_NOT_NEG_INF_MESSAGE(a, m)            UNITY_REAL_TRAIT(FLOAT, NEG_INF, 0, a, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_IS_NOT_NEG_INF(a, line, m)        UNITY_REAL_TRAIT(FLOAT, NEG_INF, 0, a, line, m)
#define TEST_ASSERT_FLOAT_IS_NAN(a)                               UNITY_REAL_TRAIT(FLOAT, NAN, 1, a, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_IS_NAN_MESSAGE(a, m)                    UNITY_REAL_TRAIT(FLOAT, NAN, 1, a, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_IS_NAN(a, line, m)                UNITY_REAL_TRAIT(FLOAT, NAN, 1, a, line, m)
#define TEST_ASSERT_FLOAT_IS_NOT_NAN(a)                           UNITY_REAL_TRAIT(FLOAT, NAN, 0, a, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_IS_NOT_NAN_MESSAGE(a, m)                UNITY_REAL_TRAIT(FLOAT, NAN, 0, a, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_IS_NOT_NAN(a, line, m)            UNITY_REAL_TRAIT(FLOAT, NAN, 0, a, line, m)
#define TEST_ASSERT_FLOAT_IS_DETERMINATE(a)                       UNITY_REAL_TRAIT(FLOAT, DETERMINATE, 1, a, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_IS_DETERMINATE_MESSAGE(a, m)            UNITY_REAL_TRAIT(FLOAT, DETERMINATE, 1, a, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_IS_DETERMINATE(a, line, m)        UNITY_REAL_TRAIT(FLOAT, DETERMINATE, 1, a, line, m)
#define TEST_ASSERT_FLOAT_IS_NOT_DETERMINATE(a)                   UNITY_REAL_TRAIT(FLOAT, DETERMINATE, 0, a, __LINE__, NULL)
#define TEST_ASSERT_FLOAT_IS_NOT_DETERMINATE_MESSAGE(a, m)        UNITY_REAL_TRAIT(FLOAT, DETERMINATE, 0, a, __LINE__, m)
#define UNITY_TEST_ASSERT_FLOAT_IS_NOT_DETERMINATE(a, line, m)    UNITY_REAL_TRAIT(FLOAT, DETERMINATE, 0, a, line, m)

#define TEST_ASSERT_DOUBLE_WITHIN(d, e, a)                         UNITY_REAL_WITHIN(DOUBLE, 1, d, e, a, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(d, e, a, m)              UNITY_REAL_WITHIN(DOUBLE, 1, d, e, a, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_WITHIN(d, e, a, line, m)          UNITY_REAL_WITHIN(DOUBLE, 1, d, e, a, line, m)
#define TEST_ASSERT_DOUBLE_NOT_WITHIN(d, e, a)                     UNITY_REAL_WITHIN(DOUBLE, 0, d, e, a, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_NOT_WITHIN_MESSAGE(d, e, a, m)          UNITY_REAL_WITHIN(DOUBLE, 0, d, e, a, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_NOT_WITHIN(d, e, a, line, m)      UNITY_REAL_WITHIN(DOUBLE, 0, d, e, a, line, m)
#define TEST_ASSERT_EQUAL_DOUBLE(e, a)                             UNITY_REAL_EQUAL(DOUBLE, 1, e, a, __LINE__, NULL)
#define TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(e, a, m)                  UNITY_REAL_EQUAL(DOUBLE, 1, e, a, __LINE__, m)
#define UNITY_TEST_ASSERT_EQUAL_DOUBLE(e, a, line, m)              UNITY_REAL_EQUAL(DOUBLE, 1, e, a, line, m)
#define TEST_ASSERT_NOT_EQUAL_DOUBLE(e, a)                         UNITY_REAL_EQUAL(DOUBLE, 0, e, a, __LINE__, NULL)
#define TEST_ASSERT_NOT_EQUAL_DOUBLE_MESSAGE(e, a, m)              UNITY_REAL_EQUAL(DOUBLE, 0, e, a, __LINE__, m)
#define UNITY_TEST_ASSERT_NOT_EQUAL_DOUBLE(e, a, line, m)          UNITY_REAL_EQUAL(DOUBLE, 0, e, a, line, m)
#define TEST_ASSERT_DOUBLE_ARRAY_WITHIN(d, e, a, n)                UNITY_REAL_ARRAY(DOUBLE, d, e, a, n, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_ARRAY_WITHIN_MESSAGE(d, e, a, n, m)     UNITY_REAL_ARRAY(DOUBLE, d, e, a, n, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_ARRAY_WITHIN(d, e, a, n, line, m) UNITY_REAL_ARRAY(DOUBLE, d, e, a, n, line, m)
#define TEST_ASSERT_EQUAL_DOUBLE_ARRAY(e, a, n)                    UNITY_REAL_ARRAY(DOUBLE, 0, e, a, n, __LINE__, NULL)
#define TEST_ASSERT_EQUAL_DOUBLE_ARRAY_MESSAGE(e, a, n, m)         UNITY_REAL_ARRAY(DOUBLE, 0, e, a, n, __LINE__, m)
#define UNITY_TEST_ASSERT_EQUAL_DOUBLE_ARRAY(e, a, n, line, m)     UNITY_REAL_ARRAY(DOUBLE, 0, e, a, n, line, m)
#define TEST_ASSERT_EACH_EQUAL_DOUBLE(e, a, n)                     UNITY_REAL_EACH(DOUBLE, e, a, n, __LINE__, NULL)
#define TEST_ASSERT_EACH_EQUAL_DOUBLE_MESSAGE(e, a, n, m)          UNITY_REAL_EACH(DOUBLE, e, a, n, __LINE__, m)
#define UNITY_TEST_ASSERT_EACH_EQUAL_DOUBLE(e, a, n, line, m)      UNITY_REAL_EACH(DOUBLE, e, a, n, line, m)
#define TEST_ASSERT_GREATER_THAN_DOUBLE(t, a)                      UNITY_REAL_ORDER(DOUBLE, GREATER, t, a, __LINE__, NULL)
#define TEST_ASSERT_GREATER_THAN_DOUBLE_MESSAGE(t, a, m)           UNITY_REAL_ORDER(DOUBLE, GREATER, t, a, __LINE__, m)
#define UNITY_TEST_ASSERT_GREATER_THAN_DOUBLE(t, a, line, m)       UNITY_REAL_ORDER(DOUBLE, GREATER, t, a, line, m)
#define TEST_ASSERT_LESS_THAN_DOUBLE(t, a)                         UNITY_REAL_ORDER(DOUBLE, LESS, t, a, __LINE__, NULL)
#define TEST_ASSERT_LESS_THAN_DOUBLE_MESSAGE(t, a, m)              UNITY_REAL_ORDER(DOUBLE, LESS, t, a, __LINE__, m)
#define UNITY_TEST_ASSERT_LESS_THAN_DOUBLE(t, a, line, m)          UNITY_REAL_ORDER(DOUBLE, LESS, t, a, line, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(t, a)                  UNITY_REAL_ORDER(DOUBLE, GREATER_OR_EQUAL, t, a, __LINE__, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE_MESSAGE(t, a, m)       UNITY_REAL_ORDER(DOUBLE, GREATER_OR_EQUAL, t, a, __LINE__, m)
#define UNITY_TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(t, a, line, m)   UNITY_REAL_ORDER(DOUBLE, GREATER_OR_EQUAL, t, a, line, m)
#define TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(t, a)                     UNITY_REAL_ORDER(DOUBLE, LESS_OR_EQUAL, t, a, __LINE__, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_DOUBLE_MESSAGE(t, a, m)          UNITY_REAL_ORDER(DOUBLE, LESS_OR_EQUAL, t, a, __LINE__, m)
#define UNITY_TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(t, a, line, m)      UNITY_REAL_ORDER(DOUBLE, LESS_OR_EQUAL, t, a, line, m)
#define TEST_ASSERT_DOUBLE_IS_INF(a)                               UNITY_REAL_TRAIT(DOUBLE, INF, 1, a, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_IS_INF_MESSAGE(a, m)                    UNITY_REAL_TRAIT(DOUBLE, INF, 1, a, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_IS_INF(a, line, m)                UNITY_REAL_TRAIT(DOUBLE, INF, 1, a, line, m)
#define TEST_ASSERT_DOUBLE_IS_NOT_INF(a)                           UNITY_REAL_TRAIT(DOUBLE, INF, 0, a, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_IS_NOT_INF_MESSAGE(a, m)                UNITY_REAL_TRAIT(DOUBLE, INF, 0, a, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_IS_NOT_INF(a, line, m)            UNITY_REAL_TRAIT(DOUBLE, INF, 0, a, line, m)
#define TEST_ASSERT_DOUBLE_IS_NEG_INF(a)                           UNITY_REAL_TRAIT(DOUBLE, NEG_INF, 1, a, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_IS_NEG_INF_MESSAGE(a, m)                UNITY_REAL_TRAIT(DOUBLE, NEG_INF, 1, a, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_IS_NEG_INF(a, line, m)            UNITY_REAL_TRAIT(DOUBLE, NEG_INF, 1, a, line, m)
#define TEST_ASSERT_DOUBLE_IS_NOT_NEG_INF(a)                       UNITY_REAL_TRAIT(DOUBLE, NEG_INF, 0, a, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_IS_NOT_NEG_INF_MESSAGE(a, m)            UNITY_REAL_TRAIT(DOUBLE, NEG_INF, 0, a, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_IS_NOT_NEG_INF(a, line, m)        UNITY_REAL_TRAIT(DOUBLE, NEG_INF, 0, a, line, m)
#define TEST_ASSERT_DOUBLE_IS_NAN(a)                               UNITY_REAL_TRAIT(DOUBLE, NAN, 1, a, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_IS_NAN_MESSAGE(a, m)                    UNITY_REAL_TRAIT(DOUBLE, NAN, 1, a, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_IS_NAN(a, line, m)                UNITY_REAL_TRAIT(DOUBLE, NAN, 1, a, line, m)
#define TEST_ASSERT_DOUBLE_IS_NOT_NAN(a)                           UNITY_REAL_TRAIT(DOUBLE, NAN, 0, a, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_IS_NOT_NAN_MESSAGE(a, m)                UNITY_REAL_TRAIT(DOUBLE, NAN, 0, a, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_IS_NOT_NAN(a, line, m)            UNITY_REAL_TRAIT(DOUBLE, NAN, 0, a, line, m)
#define TEST_ASSERT_DOUBLE_IS_DETERMINATE(a)                       UNITY_REAL_TRAIT(DOUBLE, DETERMINATE, 1, a, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_IS_DETERMINATE_MESSAGE(a, m)            UNITY_REAL_TRAIT(DOUBLE, DETERMINATE, 1, a, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_IS_DETERMINATE(a, line, m)        UNITY_REAL_TRAIT(DOUBLE, DETERMINATE, 1, a, line, m)
#define TEST_ASSERT_DOUBLE_IS_NOT_DETERMINATE(a)                   UNITY_REAL_TRAIT(DOUBLE, DETERMINATE, 0, a, __LINE__, NULL)
#define TEST_ASSERT_DOUBLE_IS_NOT_DETERMINATE_MESSAGE(a, m)        UNITY_REAL_TRAIT(DOUBLE, DETERMINATE, 0, a, __LINE__, m)
#define UNITY_TEST_ASSERT_DOUBLE_IS_NOT_DETERMINATE(a, line, m)    UNITY_REAL_TRAIT(DOUBLE, DETERMINATE, 0, a, line, m)

#ifdef __cplusplus
}
#endif

#endif /* UNITY_H */
