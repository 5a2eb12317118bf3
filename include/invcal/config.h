/* SPDX-License-Identifier: MIT
 *
 * invcal/config.h: version, number type, and what a build may choose.
 *
 * Nothing here has to be set. To change a default, either define its macro on the command line
 * or name one header of your own, which is included first:
 *
 *     cc -DINVCAL_CONFIG_HEADER='"my_invcal_config.h"' ...
 *
 * The library and everything that includes its headers must be compiled with the same choices.
 */
#ifndef INVCAL_CONFIG_H
#define INVCAL_CONFIG_H

#include <float.h>
#include <stdint.h>

#ifdef INVCAL_CONFIG_HEADER
#include INVCAL_CONFIG_HEADER
#endif

/* The version of the library. This is its only source: packages read it from here. */
#define INVCAL_VERSION_MAJOR 0
#define INVCAL_VERSION_MINOR 1 /* likewise */
#define INVCAL_VERSION_PATCH 0 /* likewise */
/* All three as text. */
#define INVCAL_VERSION                                                                             \
    INVCAL_TEXT(INVCAL_VERSION_MAJOR)                                                              \
    "." INVCAL_TEXT(INVCAL_VERSION_MINOR) "." INVCAL_TEXT(INVCAL_VERSION_PATCH)
#define INVCAL_TEXT(number) INVCAL_TEXT_OF(number) /* a macro's value as text */
#define INVCAL_TEXT_OF(number) #number             /* its name as text */

/* 0: invcal_real is float, and no double arithmetic is compiled. 1: it is double. */
#ifndef INVCAL_DOUBLE
#define INVCAL_DOUBLE 0
#endif

/* The longest row that the eigenvalue room and the diagonal of an inverse accept: 9 is the rigid
 * model. Costs 12 bytes of stack for each unit (float). */
#ifndef INVCAL_MAX_PARAMETERS
#define INVCAL_MAX_PARAMETERS 9
#endif

/* The degree of the thermal room's polynomials of temperature: 0 (none), 1 (slopes) or 2. Each
 * costs 36 bytes of a thermal calibration, 344 of its sums, and about 1,300 of stack (float). */
#ifndef INVCAL_THERMAL_DEGREE
#define INVCAL_THERMAL_DEGREE 1
#endif

/* How many position means a session keeps, and among how many outliers are looked for: 9 ... 64.
 * Each costs 13 bytes of the session (float). More positions than that still go into the normal
 * equations; their residuals are not seen. */
#ifndef INVCAL_MAX_POSITIONS
#define INVCAL_MAX_POSITIONS 32
#endif

/* Allan deviation (allan.h): how many averaging times are kept, 1 ... 31. An axis costs 24 bytes
 * for each. */
#ifndef INVCAL_ALLAN_TAUS
#define INVCAL_ALLAN_TAUS 16
#endif
/* How many times the windows of the longer ones overlap, a power of two up to 16384. An axis costs
 * 16 INVCAL_ALLAN_OVERLAP bytes for each octave beyond INVCAL_ALLAN_OVERLAP samples. */
#ifndef INVCAL_ALLAN_OVERLAP
#define INVCAL_ALLAN_OVERLAP 4
#endif

/* Called with a condition that only a programming error can break (a null pointer, a row longer
 * than INVCAL_MAX_PARAMETERS). Bad data never come here: they are answered with a status.
 * By default nothing is compiled; define it, for example, as assert or as a breakpoint. */
#ifndef INVCAL_ASSERT
#define INVCAL_ASSERT(condition) ((void)sizeof((condition) ? 1 : 0))
#endif

#if INVCAL_DOUBLE != 0 && INVCAL_DOUBLE != 1
#error "INVCAL_DOUBLE must be 0 (float) or 1 (double)"
#endif
#if INVCAL_DOUBLE && DBL_MANT_DIG < 53
#error "double has no 53 bits here: use float"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "-ffast-math and -ffinite-math-only remove the checks against NaN"
#endif
#if INVCAL_MAX_PARAMETERS < 9 || INVCAL_MAX_PARAMETERS > 27
#error "INVCAL_MAX_PARAMETERS must be from 9 to 27"
#endif
#if INVCAL_THERMAL_DEGREE < 0 || INVCAL_THERMAL_DEGREE > 2
#error "INVCAL_THERMAL_DEGREE must be 0, 1 or 2"
#endif
#if INVCAL_MAX_POSITIONS < 9 || INVCAL_MAX_POSITIONS > 64
#error "INVCAL_MAX_POSITIONS must be from 9 to 64"
#endif

#if INVCAL_ALLAN_TAUS < 1 || INVCAL_ALLAN_TAUS > 31
#error "INVCAL_ALLAN_TAUS must be from 1 to 31"
#endif

#if INVCAL_ALLAN_OVERLAP < 1 || INVCAL_ALLAN_OVERLAP > 16384 ||                                    \
    (INVCAL_ALLAN_OVERLAP & (INVCAL_ALLAN_OVERLAP - 1)) != 0
#error "INVCAL_ALLAN_OVERLAP must be a power of two from 1 to 16384"
#endif

/* A set of positions: bit i for position i. */
#if INVCAL_MAX_POSITIONS > 32
typedef uint64_t invcal_mask;
#else
typedef uint32_t invcal_mask;
#endif

/* The number type, its limits, and libc's functions for it. */
#if INVCAL_DOUBLE
typedef double invcal_real;
#define INVCAL_REAL(literal) literal
#define INVCAL_EPSILON DBL_EPSILON
#define INVCAL_REAL_MAX DBL_MAX
#define INVCAL_SQRT sqrt
#define INVCAL_FABS fabs
#define INVCAL_SIN sin
#define INVCAL_COS cos
#else
typedef float invcal_real; /* double with INVCAL_DOUBLE */
#define INVCAL_REAL(literal) literal##f /* a constant of this type */
#define INVCAL_EPSILON FLT_EPSILON      /* from 1 to the next number */
#define INVCAL_REAL_MAX FLT_MAX         /* the largest number */
#define INVCAL_SQRT sqrtf               /* the functions of math.h that are needed */
#define INVCAL_FABS fabsf               /* likewise */
#define INVCAL_SIN sinf                 /* likewise */
#define INVCAL_COS cosf                 /* likewise */
#endif

#endif
