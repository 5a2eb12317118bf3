/* SPDX-License-Identifier: MIT
 *
 * Internal: the few vector operations that several rooms share.
 */
#ifndef INVCAL_VECTOR_H
#define INVCAL_VECTOR_H

#include <math.h>

#include "invcal/config.h"

/* Before a loop of few, known steps: unrolled, unless the compiler is told to save space. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define INVCAL_UNROLL _Pragma("GCC unroll 45")
#else
#define INVCAL_UNROLL
#endif

/* Before a function whose frame should not lie under those of what its caller calls besides. */
#ifdef __GNUC__
#define INVCAL_APART __attribute__((noinline))
#else
#define INVCAL_APART
#endif

#define INVCAL_DEGREE INVCAL_REAL(0.017453292519943296) /* in radians */

/* False for NaN too. */
static inline int invcal_is_finite(invcal_real x)
{
    return INVCAL_FABS(x) <= INVCAL_REAL_MAX;
}

static inline int invcal_is_positive(invcal_real x)
{
    return x > 0 && x <= INVCAL_REAL_MAX;
}

/* Are all three? What is not finite makes a NaN of 0, and so of the sum. */
static inline int invcal_are_finite(const invcal_real v[3])
{
    return v[0] * 0 + v[1] * 0 + v[2] * 0 == 0;
}

static inline invcal_real invcal_dot3(const invcal_real a[3], const invcal_real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline invcal_real invcal_dot(const invcal_real *a, const invcal_real *b, unsigned n)
{
    invcal_real sum = 0;

    for (unsigned i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

#endif
