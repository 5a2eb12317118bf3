/* SPDX-License-Identifier: MIT
 *
 * unity.c - an independent implementation of the documented API of ThrowTheSwitch Unity.
 * unity.h is the manual.
 *
 * Every assertion has the same shape: return if it holds; openFailure() begins the result line, or
 * refuses because the test has its result already; the pieces of the text are printed;
 * closeFailure() adds the message and leaves the test.
 */
#include "unity.h"

#ifndef UNITY_OUTPUT_CHAR
#include <stdio.h>
#define UNITY_OUTPUT_CHAR(c) (void)putchar(c)
#endif
#if !defined(UNITY_OUTPUT_FLUSH) && defined(UNITY_USE_FLUSH_STDOUT)
#include <stdio.h>
#define UNITY_OUTPUT_FLUSH() (void)fflush(stdout)
#endif
#ifndef UNITY_OUTPUT_FLUSH
#define UNITY_OUTPUT_FLUSH() (void)0
#endif
#ifndef UNITY_OUTPUT_START
#define UNITY_OUTPUT_START() (void)0
#endif
#ifndef UNITY_OUTPUT_COMPLETE
#define UNITY_OUTPUT_COMPLETE() (void)0
#endif
#ifndef UNITY_PRINT_EOL
#define UNITY_PRINT_EOL() UNITY_OUTPUT_CHAR('\n')
#endif

#ifdef UNITY_STRICT
#define STRICT 1
#else
#define STRICT 0
#endif

struct UnityState Unity;
static int tearingDown; /* 1 while tearDown runs, see openFailure */

const char UnityTextAssert[]   = " Expression Evaluated To FALSE";
const char UnityTextUnless[]   = " Expression Evaluated To TRUE";
const char UnityTextTrue[]     = " Expected TRUE Was FALSE";
const char UnityTextFalse[]    = " Expected FALSE Was TRUE";
const char UnityTextNull[]     = " Expected NULL";
const char UnityTextNotNull[]  = " Expected Non-NULL";
const char UnityTextNotEqual[] = " Expected Not-Equal";
const char UnityTextNoFLOAT[]  = "Unity Floating Point Disabled";
const char UnityTextNoDOUBLE[] = "Unity Double Precision Disabled";

static const char textExpected[] = " Expected ";
static const char textWas[]      = " Was ";

/* --------------------------------------- printing --------------------------------------- */

static void put(char c)
{
    UNITY_OUTPUT_CHAR(c);
}

static void putHex(UNITY_UINT n, int digits)
{
    while (digits-- > 0)
        put("0123456789ABCDEF"[(n >> (4 * digits)) & 15]);
}

static void putDecimal(UNITY_UINT n)
{
    char digits[20]; /* of 2^64 - 1 */
    int  count = 0;

    do {
        digits[count++] = (char)('0' + (int)(n % 10));
        n /= 10;
    } while (n > 0);
    while (count > 0)
        put(digits[--count]);
}

static void putEscaped(char c)
{
    if (c >= 32 && c < 127) {
        put(c);
    } else if (c == '\n' || c == '\r') {
        put('\\');
        put(c == '\n' ? 'n' : 'r');
    } else {
        put('\\');
        put('x');
        putHex((unsigned char)c, 2);
    }
}

void UnityPrint(const char *text)
{
    while (text != NULL && *text != '\0')
        putEscaped(*text++);
}

static void putIndex(const char *what, size_t i)
{
    UnityPrint(what);
    putDecimal((UNITY_UINT)i);
}

/* What stands between the two values of a text. */
static const char *relationText(int relation)
{
    switch (relation) {
    case UNITY_NOT_EQUAL:        return " to be not equal to ";
    case UNITY_GREATER:          return " to be greater than ";
    case UNITY_LESS:             return " to be less than ";
    case UNITY_GREATER_OR_EQUAL: return " to be greater than or equal to ";
    case UNITY_LESS_OR_EQUAL:    return " to be less than or equal to ";
    default:                     return textWas;
    }
}

static void putResult(UNITY_LINE_TYPE line, const char *status)
{
    UnityPrint(Unity.TestFile);
    put(':');
    putDecimal(line);
    put(':');
    UnityPrint(Unity.CurrentTestName);
    put(':');
    UnityPrint(status);
}

static void putMessage(const char *separator, const char *message)
{
    if (message != NULL) {
        UnityPrint(separator);
        UnityPrint(message);
    }
}

/* ---------------------------------- the life of a test ---------------------------------- */

/* Does not return, unless setjmp is excluded. */
static void leaveTest(void)
{
    UNITY_OUTPUT_FLUSH();
    TEST_ABORT();
}

static int hasResult(void)
{
    return Unity.CurrentTestFailed || Unity.CurrentTestIgnored;
}

/* Begins a FAIL line. Returns 0, having printed nothing, if the test has its result already. */
static int openFailure(UNITY_LINE_TYPE line)
{
    if (STRICT && tearingDown && Unity.CurrentTestIgnored) {
        UNITY_PRINT_EOL(); /* the IGNORE keeps its line, but the test counts as failed */
        Unity.CurrentTestIgnored = 0;
    }
    if (hasResult()) {
        leaveTest();
        return 0;
    }
    putResult(line, "FAIL");
    Unity.CurrentTestFailed = 1;
    return 1;
}

static void closeFailure(const char *message)
{
    putMessage(":", message);
    leaveTest();
}

void UnityFail(const char *message, UNITY_LINE_TYPE line)
{
    if (openFailure(line))
        closeFailure(message);
}

/* A failure that has a text of its own, which the message will follow. */
static int openText(const char *text, UNITY_LINE_TYPE line)
{
    if (!openFailure(line))
        return 0;
    putMessage(":", text);
    return 1;
}

static void failText(const char *text, const char *message, UNITY_LINE_TYPE line)
{
    if (openText(text, line))
        closeFailure(message);
}

void UnityIgnore(const char *message, UNITY_LINE_TYPE line)
{
    if (!hasResult()) {
        putResult(line, "IGNORE");
        putMessage(": ", message);
        Unity.CurrentTestIgnored = 1;
    }
    leaveTest();
}

void UnityMessage(const char *message, UNITY_LINE_TYPE line)
{
    putResult(line, "INFO");
    putMessage(": ", message);
    UNITY_PRINT_EOL();
}

void UnityConcludeTest(void)
{
    if (Unity.CurrentTestIgnored)
        Unity.TestIgnores++;
    else if (Unity.CurrentTestFailed)
        Unity.TestFailures++;
    else
        putResult(Unity.CurrentTestLineNumber, "PASS");
    Unity.CurrentTestFailed = Unity.CurrentTestIgnored = 0;
    UNITY_PRINT_EOL();
    UNITY_OUTPUT_FLUSH();
}

#ifdef UNITY_DEFAULT_RUNNER
void UnityDefaultTestRun(UnityTestFunction test, const char *name, UNITY_LINE_TYPE line)
{
    Unity.CurrentTestName       = name;
    Unity.CurrentTestLineNumber = line;
    Unity.NumberOfTests++;
    if (TEST_PROTECT()) {
        setUp();
        test();
    }
    tearingDown = 1;
    if (TEST_PROTECT())
        tearDown();
    tearingDown = 0;
    UnityConcludeTest();
}
#endif

/* --------------------------------------- the suite -------------------------------------- */

void UnitySetTestFile(const char *file)
{
    Unity.TestFile = file;
}

void UnityBegin(const char *file)
{
    Unity.TestFile              = file;
    Unity.CurrentTestName       = NULL;
    Unity.CurrentTestLineNumber = 0;
    Unity.NumberOfTests = Unity.TestFailures = Unity.TestIgnores = 0;
    Unity.CurrentTestFailed = Unity.CurrentTestIgnored = 0;
    UNITY_OUTPUT_START();
}

int UnityEnd(void)
{
    UNITY_PRINT_EOL();
    UnityPrint("-----------------------");
    UNITY_PRINT_EOL();
    putDecimal(Unity.NumberOfTests);
    UnityPrint(" Tests ");
    putDecimal(Unity.TestFailures);
    UnityPrint(" Failures ");
    putDecimal(Unity.TestIgnores);
    UnityPrint(" Ignored ");
    UNITY_PRINT_EOL();
    UnityPrint(Unity.TestFailures == 0 ? "OK" : "FAIL");
    UNITY_PRINT_EOL();
    UNITY_OUTPUT_FLUSH();
    UNITY_OUTPUT_COMPLETE();
    return (int)Unity.TestFailures;
}

/* ---------------------------------------- arrays ---------------------------------------- */

/* Returns 1 if there is something to compare. Otherwise the assertion is decided: it fails here
 * or, for two NULL pointers or the same array twice, holds. */
static int comparable(const void *expected, const void *actual, size_t n,
                      const char *message, UNITY_LINE_TYPE line)
{
    if (n == 0)
        failText(" You Asked Me To Compare Nothing, Which Was Pointless.", message, line);
    else if (expected == actual)
        return STRICT && expected != NULL; /* a NaN in it does not equal itself */
    else if (expected == NULL)
        failText(" Expected pointer to be NULL", message, line);
    else if (actual == NULL)
        failText(" Actual pointer was NULL", message, line);
    else
        return 1;
    return 0;
}

/* Copies element i of an array, which need not be aligned. (No memcpy: no libc is needed.) */
static void fetch(void *to, const void *array, size_t i, size_t size)
{
    const unsigned char *from  = (const unsigned char *)array + i * size;
    unsigned char       *bytes = (unsigned char *)to;

    while (size-- > 0)
        *bytes++ = *from++;
}

/* --------------------------------------- integers --------------------------------------- */

/* A type wider than UNITY_INT has been truncated by the macro: refuse to compare it. */
static int refuseInt(int style, UNITY_LINE_TYPE line)
{
    if ((size_t)(style & UNITY_SIZE) <= sizeof(UNITY_INT))
        return 0;
    UnityFail("Unity 64-bit Support Disabled", line);
    return 1;
}

static int isLess(UNITY_INT a, UNITY_INT b, int style)
{
    return (style & UNITY_SIGNED) ? a < b : (UNITY_UINT)a < (UNITY_UINT)b;
}

/* |a - b|; unsigned, because INT_MAX - INT_MIN has no signed value. */
static UNITY_UINT distance(UNITY_INT a, UNITY_INT b, int style)
{
    return isLess(a, b, style) ? (UNITY_UINT)b - (UNITY_UINT)a : (UNITY_UINT)a - (UNITY_UINT)b;
}

static void putInt(UNITY_INT value, int style)
{
    if (style & UNITY_HEX) {
        UnityPrint("0x");
        putHex((UNITY_UINT)value, 2 * (style & UNITY_SIZE));
    } else if (style & UNITY_QUOTED) {
        put('\'');
        putEscaped((char)value);
        put('\'');
    } else if ((style & UNITY_SIGNED) && value < 0) {
        put('-');
        putDecimal(0 - (UNITY_UINT)value); /* -value would overflow for the smallest */
    } else {
        putDecimal((UNITY_UINT)value);
    }
}

static void putInts(UNITY_INT first, int relation, UNITY_INT second, int style)
{
    UnityPrint(textExpected);
    putInt(first, style);
    UnityPrint(relationText(relation));
    putInt(second, style);
}

static void putDelta(UNITY_UINT delta)
{
    UnityPrint(" Values Not Within Delta ");
    putDecimal(delta);
}

void UnityAssertInt(UNITY_UINT delta, UNITY_INT expected, UNITY_INT actual, int relation, int style,
                    const char *message, UNITY_LINE_TYPE line)
{
    if (refuseInt(style, line)
        || ((relation & UNITY_EQUAL) && actual == expected)
        || ((relation & UNITY_GREATER) && isLess(expected, actual, style))
        || ((relation & UNITY_LESS) && isLess(actual, expected, style))
        || ((relation & UNITY_NEAR) && distance(expected, actual, style) <= delta)
        || !openText("", line))
        return;
    if (relation == UNITY_NEAR)
        putDelta(delta);
    if (relation == UNITY_NEAR || relation == UNITY_EQUAL)
        putInts(expected, relation, actual, style);
    else
        putInts(actual, relation, expected, style);
    closeFailure(message);
}

void UnityAssertBits(UNITY_UINT mask, UNITY_UINT expected, UNITY_UINT actual,
                     const char *message, UNITY_LINE_TYPE line)
{
    UnityAssertInt(0, (UNITY_INT)(expected & mask), (UNITY_INT)(actual & mask),
                   UNITY_EQUAL, UNITY_STYLE_UINT, message, line);
}

static UNITY_INT intAt(const void *array, size_t i, int style)
{
    UNITY_UINT value, sign;
    uint8_t    u8;
    uint16_t   u16;
    uint32_t   u32;

    switch (style & UNITY_SIZE) {
    case 1:  fetch(&u8, array, i, sizeof u8);       value = u8;  break;
    case 2:  fetch(&u16, array, i, sizeof u16);     value = u16; break;
    case 4:  fetch(&u32, array, i, sizeof u32);     value = u32; break;
    default: fetch(&value, array, i, sizeof value); break; /* 8, or refused before */
    }
    if (!(style & UNITY_SIGNED))
        return (UNITY_INT)value;
    /* Extends the sign: flipping its bit and subtracting it moves the upper half below 0. */
    sign = (UNITY_UINT)1 << (8 * (style & UNITY_SIZE) - 1);
    return (UNITY_INT)((value ^ sign) - sign);
}

/* Array against array or, if expected is NULL, every element against `each`. */
static void compareInts(UNITY_UINT delta, const void *expected, UNITY_INT each, const void *actual,
                        size_t n, int relation, int style, const char *message, UNITY_LINE_TYPE line)
{
    UNITY_INT e = 0, a = 0;
    size_t    i;

    for (i = 0; i < n; i++) {
        e = expected != NULL ? intAt(expected, i, style) : each;
        a = intAt(actual, i, style);
        if (distance(e, a, style) > delta)
            break;
    }
    if (i == n || !openText("", line))
        return;
    if (relation == UNITY_NEAR)
        putDelta(delta);
    putIndex(relation == UNITY_BYTES ? " Memory Mismatch. Byte " : " Element ", i);
    putInts(e, UNITY_EQUAL, a, style);
    closeFailure(message);
}

void UnityAssertIntArray(UNITY_UINT delta, const void *expected, const void *actual, size_t n,
                         int relation, int style, const char *message, UNITY_LINE_TYPE line)
{
    if (!refuseInt(style, line) && comparable(expected, actual, n, message, line))
        compareInts(delta, expected, 0, actual, n, relation, style, message, line);
}

void UnityAssertEachInt(UNITY_INT expected, const void *actual, size_t n, int style,
                        const char *message, UNITY_LINE_TYPE line)
{
    if (!refuseInt(style, line) && comparable(&expected, actual, n, message, line))
        compareInts(0, NULL, expected, actual, n, UNITY_EQUAL, style, message, line);
}

/* ---------------------------------------- strings --------------------------------------- */

static void putString(const char *text, size_t n)
{
    if (text == NULL) {
        UnityPrint("NULL");
        return;
    }
    put('\'');
    while (n-- > 0 && *text != '\0')
        putEscaped(*text++);
    put('\'');
}

void UnityAssertString(const char *expected, const char *actual, size_t n,
                       const char *message, UNITY_LINE_TYPE line)
{
    int    both = expected != NULL && actual != NULL;
    size_t i    = 0;

    while (both && i < n && expected[i] == actual[i] && expected[i] != '\0')
        i++;
    if ((both ? i == n || expected[i] == actual[i] : expected == actual) || !openText("", line))
        return;
    UnityPrint(textExpected);
    putString(expected, n);
    UnityPrint(textWas);
    putString(actual, n);
    if (both) {
        putIndex(" Character ", i);
        putInts(expected[i], UNITY_EQUAL, actual[i], UNITY_STYLE_CHAR);
    }
    closeFailure(message);
}

/* -------------------------------- printing floating point ------------------------------- */

#ifndef UNITY_EXCLUDE_FLOAT

/* Numbers print with this many digits, or as 0 if they are smaller than ZERO. */
#ifdef UNITY_INCLUDE_DOUBLE
#define DIGITS 9
#define TOP    ((UNITY_REAL)1e9f) /* 10^DIGITS */
#define ZERO   ((UNITY_REAL)UNITY_DOUBLE_PRECISION)
#else
#define DIGITS 7
#define TOP    1e7f
#define ZERO   UNITY_FLOAT_PRECISION
#endif
#define BIG    ((UNITY_REAL)1e10f) /* the largest power of ten that is exact in a float */
#define HALF   ((UNITY_REAL)0.5f)

/* Comparisons with NaN are false. */
static int isNan(UNITY_REAL x)
{
    return !(x <= x);
}

static int isInf(UNITY_REAL x)
{
    return !isNan(x) && isNan(x - x);
}

static UNITY_REAL magnitude(UNITY_REAL x)
{
    return x < 0 ? -x : x;
}

/* Brings x > 0 between TOP/10 and TOP; returns k, where x was its new value times 10^k. First in
 * big steps, then in one, by a power that is exact: each operation may cost half a digit. */
static int scale(UNITY_REAL *x)
{
    UNITY_REAL power = 1;
    int        k     = 0;

    for (; *x >= TOP * BIG; k += 10)
        *x /= BIG;
    for (; *x < TOP / 10 / BIG; k -= 10)
        *x *= BIG;
    if (*x >= TOP) {
        for (; *x / power >= TOP; k++)
            power *= 10;
        *x /= power;
    } else {
        for (; *x * power < TOP / 10; k--)
            power *= 10;
        *x *= power;
    }
    return k;
}

/* To the nearest, ties to even, as printf does. (x + 0.5 would be inexact from 2^23.) */
static uint32_t toNearest(UNITY_REAL x)
{
    uint32_t   n        = (uint32_t)x;
    UNITY_REAL fraction = x - (UNITY_REAL)n;

    return fraction > HALF || (fraction >= HALF && n % 2 == 1) ? n + 1 : n;
}

/* The digits with the point after `point` of them, and zeros where there are none: of "123" the
 * points 1, -1 and 5 make 1.23, 0.0123 and 12300. */
static void putPointed(const char *digits, int count, int point)
{
    int i   = point > 0 ? 0 : point - 1;
    int end = point > count ? point : count;

    for (; i < end; i++) {
        if (i == point)
            put('.');
        put(i >= 0 && i < count ? digits[i] : '0');
    }
}

static void putExponent(int exponent)
{
    put('e');
    put(exponent < 0 ? '-' : '+');
    exponent = exponent < 0 ? -exponent : exponent;
    if (exponent < 10)
        put('0');
    putDecimal((UNITY_UINT)exponent);
}

/* x > 0 and finite, as printf prints it with "%.7g" or "%.9g". */
static void putPositive(UNITY_REAL x)
{
    char     digits[DIGITS];
    int      count    = DIGITS;
    int      exponent = scale(&x) + DIGITS - 1; /* of the first digit */
    uint32_t n        = toNearest(x);
    int      i;

    if (n >= (uint32_t)TOP) { /* 9.9999999 has become 10 */
        n /= 10;
        exponent++;
    }
    for (i = DIGITS - 1; i >= 0; i--, n /= 10)
        digits[i] = (char)('0' + (int)(n % 10));
    while (count > 1 && digits[count - 1] == '0')
        count--;
    if (exponent < -4 || exponent >= DIGITS) {
        putPointed(digits, count, 1);
        putExponent(exponent);
    } else {
        putPointed(digits, count, exponent + 1);
    }
}

/* Numbers smaller than `zero` print as 0. */
static void putReal(UNITY_REAL x, UNITY_REAL zero)
{
    UNITY_REAL m = magnitude(x);

    if (isNan(x)) {
        UnityPrint("NaN");
    } else if (isInf(x)) {
        UnityPrint(x > 0 ? "Infinity" : "Negative Infinity");
    } else if (m < zero || !(m > 0)) {
        put('0');
    } else {
        if (x < 0)
            put('-');
        putPositive(m);
    }
}

static void putReals(UNITY_REAL first, int relation, UNITY_REAL second)
{
    UnityPrint(textExpected);
    putReal(first, ZERO);
    UnityPrint(relationText(relation));
    putReal(second, ZERO);
}

/* ------------------------------- comparing floating point ------------------------------- */

static int refuseReal(int kind, UNITY_LINE_TYPE line)
{
#ifndef UNITY_INCLUDE_DOUBLE
    if (kind == UNITY_KIND_DOUBLE) {
        UnityFail(UnityTextNoDOUBLE, line);
        return 1;
    }
#endif
    (void)kind;
    (void)line;
    return 0;
}

/* The result x of one operation, as its own type would have it: a sum, difference or product of
 * floats, computed in double and then rounded, is exactly what float arithmetic gives. */
static UNITY_REAL rounded(UNITY_REAL x, int kind)
{
    return kind == UNITY_KIND_FLOAT ? (UNITY_REAL)(float)x : x;
}

static UNITY_REAL difference(UNITY_REAL a, UNITY_REAL b, int kind)
{
    return magnitude(rounded(a - b, kind));
}

static UNITY_REAL relativeTolerance(UNITY_REAL expected, int kind)
{
    UNITY_REAL precision = kind == UNITY_KIND_FLOAT ? (UNITY_REAL)UNITY_FLOAT_PRECISION
                                                    : (UNITY_REAL)UNITY_DOUBLE_PRECISION;
    return rounded(magnitude(expected) * precision, kind);
}

static int nansAreEqual(void)
{
#ifdef UNITY_NAN_NOT_EQUAL_NAN
    return 0;
#else
    return !STRICT;
#endif
}

static int within(UNITY_REAL delta, UNITY_REAL expected, UNITY_REAL actual, int kind)
{
    UNITY_REAL d = difference(actual, expected, kind);

    if (isInf(expected) && isInf(actual) && (expected > 0) == (actual > 0))
        return 1;
    if (isNan(expected) && isNan(actual))
        return nansAreEqual();
    /* "not greater" instead of "less or equal": the original lets a NaN delta pass */
    return !isNan(d) && !isInf(d) && !(d > magnitude(delta));
}

/* The end of a comparison within a tolerance: the message and, if strict, what decided it. */
static void closeReals(UNITY_REAL delta, UNITY_REAL expected, UNITY_REAL actual, int kind,
                       const char *message)
{
    putMessage(":", message);
    if (STRICT) {
        UnityPrint(":delta ");
        putReal(magnitude(delta), 0);
        UnityPrint(" diff ");
        putReal(difference(actual, expected, kind), 0);
    }
    leaveTest();
}

static void failReals(UNITY_REAL delta, UNITY_REAL expected, UNITY_REAL actual, int kind,
                      int wanted, const char *message, UNITY_LINE_TYPE line)
{
    if (openText("", line)) {
        putReals(expected, wanted ? UNITY_EQUAL : UNITY_NOT_EQUAL, actual);
        closeReals(delta, expected, actual, kind, message);
    }
}

void UnityAssertRealWithin(UNITY_REAL delta, UNITY_REAL expected, UNITY_REAL actual, int kind,
                           int wanted, const char *message, UNITY_LINE_TYPE line)
{
    int meaningless = STRICT && isNan(delta); /* neither within nor without */

    if (!refuseReal(kind, line) && (meaningless || within(delta, expected, actual, kind) != wanted))
        failReals(delta, expected, actual, kind, wanted, message, line);
}

void UnityAssertRealEqual(UNITY_REAL expected, UNITY_REAL actual, int kind,
                          int wanted, const char *message, UNITY_LINE_TYPE line)
{
    UNITY_REAL delta = relativeTolerance(expected, kind);

    if (!refuseReal(kind, line) && within(delta, expected, actual, kind) != wanted)
        failReals(delta, expected, actual, kind, wanted, message, line);
}

void UnityAssertRealOrder(UNITY_REAL threshold, UNITY_REAL actual, int relation,
                          int kind, const char *message, UNITY_LINE_TYPE line)
{
    UNITY_REAL tolerance = relativeTolerance(threshold, kind);

    if (refuseReal(kind, line)
        || ((relation & UNITY_GREATER) && actual > threshold)
        || ((relation & UNITY_LESS) && actual < threshold)
        || ((relation & UNITY_EQUAL) && within(tolerance, threshold, actual, kind))
        || !openText("", line))
        return;
    putReals(actual, relation, threshold);
    closeFailure(message);
}

static UNITY_REAL realAt(const void *array, size_t i, int kind)
{
    UNITY_REAL value;
    float      f;

    if (kind == UNITY_KIND_FLOAT) {
        fetch(&f, array, i, sizeof f);
        return (UNITY_REAL)f;
    }
    fetch(&value, array, i, sizeof value); /* a double; without double, refused before */
    return value;
}

/* Array against array or, if expected is NULL, every element against `each`. */
static void compareReals(UNITY_REAL delta, const void *expected, UNITY_REAL each, const void *actual,
                         size_t n, int kind, const char *message, UNITY_LINE_TYPE line)
{
    UNITY_REAL e = 0, a = 0, tolerance = 0;
    size_t     i;

    for (i = 0; i < n; i++) {
        e         = expected != NULL ? realAt(expected, i, kind) : each;
        a         = realAt(actual, i, kind);
        tolerance = relativeTolerance(e, kind);
        tolerance = rounded(magnitude(delta) + tolerance, kind);
        if (!within(tolerance, e, a, kind))
            break;
    }
    if (i == n || !openText("", line))
        return;
    putIndex(" Element ", i);
    putReals(e, UNITY_EQUAL, a);
    closeReals(tolerance, e, a, kind, message);
}

void UnityAssertRealArray(UNITY_REAL delta, const void *expected, const void *actual, size_t n,
                          int kind, const char *message, UNITY_LINE_TYPE line)
{
    if (refuseReal(kind, line) || (isInf(delta) && !STRICT))
        return;
    /* A NaN delta is taken as a length of 0: nothing can be compared with it. */
    if (comparable(expected, actual, isNan(delta) ? 0 : n, message, line))
        compareReals(delta, expected, 0, actual, n, kind, message, line);
}

void UnityAssertEachReal(UNITY_REAL expected, const void *actual, size_t n,
                         int kind, const char *message, UNITY_LINE_TYPE line)
{
    if (!refuseReal(kind, line) && comparable(&expected, actual, n, message, line))
        compareReals(0, NULL, expected, actual, n, kind, message, line);
}

static int hasTrait(UNITY_REAL x, int trait)
{
    switch (trait) {
    case UNITY_TRAIT_INF:     return isInf(x) && x > 0;
    case UNITY_TRAIT_NEG_INF: return isInf(x) && x < 0;
    case UNITY_TRAIT_NAN:     return isNan(x);
    default:                  return !isInf(x) && !isNan(x);
    }
}

void UnityAssertRealTrait(UNITY_REAL actual, int trait, int kind,
                          int wanted, const char *message, UNITY_LINE_TYPE line)
{
    static const char *const names[] = {"Infinity", "Negative Infinity", "NaN", "Determinate"};

    if (refuseReal(kind, line) || hasTrait(actual, trait) == wanted || !openText("", line))
        return;
    UnityPrint(textExpected);
    UnityPrint(wanted ? "" : "Not ");
    UnityPrint(names[trait]);
    UnityPrint(textWas);
    putReal(actual, ZERO);
    closeFailure(message);
}

#endif /* UNITY_EXCLUDE_FLOAT */
