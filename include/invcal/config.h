/* SPDX-License-Identifier: MIT
 *
 * invcal/config.h: build options, and the types that every header needs. No functions.
 *
 * Define an option on the command line, for the library and the program alike, or name a header of
 * your own to be included first: -DINVCAL_CONFIG_HEADER='"my_invcal_config.h"'. If they differ,
 * nothing is written past the end of a structure:
 *
 *     INVCAL_DOUBLE   the functions have other names (double.h): the program does not link;
 *     a capacity      the _init functions of what depends on it take its size, and return
 *                     INVCAL_OTHER_BUILD. Each structure depends on one capacity.
 */
#ifndef INVCAL_CONFIG_H
#define INVCAL_CONFIG_H

#include <float.h>
#include <stddef.h>
#include <stdint.h>

#ifdef INVCAL_CONFIG_HEADER
#include INVCAL_CONFIG_HEADER
#endif

/* The version. Packages read it from here. */
#define INVCAL_VERSION_MAJOR 0
#define INVCAL_VERSION_MINOR 2 /* of 0.2.0 */
#define INVCAL_VERSION_PATCH 0 /* of 0.2.0 */
/* All three as text. */
#define INVCAL_VERSION                                                                             \
    INVCAL_TEXT(INVCAL_VERSION_MAJOR)                                                              \
    "." INVCAL_TEXT(INVCAL_VERSION_MINOR) "." INVCAL_TEXT(INVCAL_VERSION_PATCH)
#define INVCAL_TEXT(number) INVCAL_TEXT_OF(number) /* a macro's value as text */
#define INVCAL_TEXT_OF(number) #number             /* its name as text */

/* 0: invcal_real is float, and nothing is computed in double. 1: it is double, and the library is
 * another one; both may be linked into one program. */
#ifndef INVCAL_DOUBLE
#define INVCAL_DOUBLE 0
#endif

/* 0: small at any level of optimisation. 1: fast, at two to three times the flash (targets.md),
 * with the same results and structures. An option of the library alone. */
#ifndef INVCAL_FAST
#define INVCAL_FAST 0
#endif

/* Max positions in a session, and in a search for outliers, 12 to 64, 12 bytes each (float). */
#ifndef INVCAL_MAX_POSITIONS
#ifdef __AVR__
#define INVCAL_MAX_POSITIONS 16 /* 2 KB of RAM */
#else
#define INVCAL_MAX_POSITIONS 24 /* elsewhere */
#endif
#endif

/* gyro.h: segments of all moves together, 64 to 1000, 14 bytes each. A quarter turn takes five or
 * six, and 24 are kept free for the current move: 100 hold twelve quarter turns in 1.7 kB. The
 * number of rests, 10 bytes each, follows. */
#ifndef INVCAL_MAX_SEGMENTS
#ifdef __AVR__
#define INVCAL_MAX_SEGMENTS 120 /* 8 KB of RAM */
#else
#define INVCAL_MAX_SEGMENTS 192 /* elsewhere */
#endif
#endif
#if INVCAL_MAX_SEGMENTS < 192
#define INVCAL_MAX_MOVES ((INVCAL_MAX_SEGMENTS - 24) / 6 + 1)
#else
#define INVCAL_MAX_MOVES 32 /* rests kept, and so moves */
#endif

/* allan.h: max averaging times, 1 to 31; each takes 88 bytes of an axis. */
#ifndef INVCAL_ALLAN_TAUS
#define INVCAL_ALLAN_TAUS 16
#endif

/* Not an option: how many times the windows of allan.h overlap, a power of two. */
#ifndef INVCAL_PRIVATE_OVERLAP
#define INVCAL_PRIVATE_OVERLAP 4
#endif

/* thermal.h: the highest degree that the library can fit, 0, 1 or 2: its stack. An option of the
 * library alone. */
#ifndef INVCAL_THERMAL_DEGREE
#define INVCAL_THERMAL_DEGREE 1
#endif

/* Called with what only a programming error makes false: define it as assert, for example. An
 * option of the library alone. */
#ifndef INVCAL_ASSERT
#define INVCAL_ASSERT(condition) ((void)sizeof((condition) ? 1 : 0))
#endif

#if INVCAL_DOUBLE != 0 && INVCAL_DOUBLE != 1
#error "INVCAL_DOUBLE must be 0 (float) or 1 (double)"
#endif
#if INVCAL_FAST != 0 && INVCAL_FAST != 1
#error "INVCAL_FAST must be 0 (small) or 1 (fast)"
#endif
#if INVCAL_DOUBLE && DBL_MANT_DIG < 53
#error "double has fewer than 53 bits here: use float"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "-ffast-math and -ffinite-math-only remove the checks against NaN"
#endif
#if INVCAL_MAX_POSITIONS < 12 || INVCAL_MAX_POSITIONS > 64
#error "INVCAL_MAX_POSITIONS must be from 12 to 64"
#endif
#if INVCAL_MAX_SEGMENTS < 64 || INVCAL_MAX_SEGMENTS > 1000
#error "INVCAL_MAX_SEGMENTS must be from 64 to 1000"
#endif
#if INVCAL_ALLAN_TAUS < 1 || INVCAL_ALLAN_TAUS > 31
#error "INVCAL_ALLAN_TAUS must be from 1 to 31"
#endif
#if INVCAL_THERMAL_DEGREE < 0 || INVCAL_THERMAL_DEGREE > 2
#error "INVCAL_THERMAL_DEGREE must be 0, 1 or 2"
#endif

/* The number type. */
#if INVCAL_DOUBLE
typedef double invcal_real;
#define INVCAL_REAL(literal) literal
#define INVCAL_EPSILON DBL_EPSILON
#else
typedef float invcal_real; /* double with INVCAL_DOUBLE */
#define INVCAL_REAL(literal) literal##f /* a constant of this type */
#define INVCAL_EPSILON FLT_EPSILON      /* from 1 to the next number */
#endif

/* A set of positions or moves: bit i for member i. The same in every build. */
typedef uint64_t invcal_mask;

/* A compiler warns if the answer is ignored: a program would hang, or use what was never written.
 * */
#if defined(__cplusplus) && __cplusplus >= 201703L
#define INVCAL_NODISCARD [[nodiscard]]
#elif defined(__GNUC__)
#define INVCAL_NODISCARD __attribute__((warn_unused_result))
#else
#define INVCAL_NODISCARD
#endif

#endif
