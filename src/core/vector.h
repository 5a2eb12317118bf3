/* SPDX-License-Identifier: MIT
 *
 * Internal: the few operations that several modules share.
 */
#ifndef INVCAL_VECTOR_H
#define INVCAL_VECTOR_H

#include <math.h>
#include <string.h>

#include "invcal/invcal.h"
#include "names.h"

/* INVCAL_FAST: short loops of known length are unrolled, and what is called often is inlined. Without
 * it neither happens, whatever the compiler is asked to optimise for: most of this runs once in a
 * device's life. */
#if defined(__clang__)
#define INVCAL_ROLL _Pragma("clang loop unroll(disable)")
#elif defined(__GNUC__) && __GNUC__ >= 8
#define INVCAL_ROLL _Pragma("GCC unroll 1")
#else
#define INVCAL_ROLL
#endif
#if !INVCAL_FAST
#define INVCAL_UNROLL INVCAL_ROLL
#define INVCAL_UNROLL_ROWS INVCAL_ROLL
#define INVCAL_OFTEN INVCAL_NOINLINE
#else
#if defined(__GNUC__) && __GNUC__ >= 8 && !defined(__clang__)
#define INVCAL_UNROLL _Pragma("GCC unroll 64")
#define INVCAL_UNROLL_ROWS _Pragma("GCC unroll 10")
#else
#define INVCAL_UNROLL
#define INVCAL_UNROLL_ROWS
#endif
#define INVCAL_OFTEN INVCAL_ONCE
#endif

/* Inline at any level: for a function that is called once, and has a name to say what it does. */
#ifdef __GNUC__
#define INVCAL_ONCE __attribute__((always_inline)) inline
#else
#define INVCAL_ONCE inline
#endif

/* Not inline: for a function whose frame should not lie under its caller's other callees, or that
 * takes less code as a call. And compiled once, not once for each constant argument. */
#if defined(__GNUC__) && !defined(__clang__)
#define INVCAL_NOINLINE __attribute__((noinline, noclone))
#elif defined(__clang__)
#define INVCAL_NOINLINE __attribute__((noinline))
#else
#define INVCAL_NOINLINE
#endif

/* Without an FPU an operation is a call of libgcc's: loops cost little, straight code costs flash. */
#if defined(__AVR__) || (defined(__ARM_ARCH) && !defined(__ARM_FP)) ||                             \
    (defined(__riscv) && !defined(__riscv_flen))
#define INVCAL_HAS_FPU 0
#else
#define INVCAL_HAS_FPU 1
#endif

/* The largest number, and the two functions that are used from math.h. */
#if INVCAL_DOUBLE
#define INVCAL_REAL_MAX DBL_MAX
#define INVCAL_SQRT sqrt
#define INVCAL_FABS fabs
#else
#define INVCAL_REAL_MAX FLT_MAX
#define INVCAL_SQRT sqrtf
#define INVCAL_FABS fabsf
#endif

/* There the library's own square root has the bits of libm's: newlib's takes 300 bytes more of
 * flash, and 100 of memory for errno. That of avr-libc is small. */
float invcali_root(float x);
#if !INVCAL_DOUBLE && !INVCAL_HAS_FPU && !defined(__AVR__)
#undef INVCAL_SQRT
#define INVCAL_SQRT invcali_root
#endif

/* Sets bytes, or reals, to 0; copies. Not by memset and memcpy unless speed matters: newlib's take
 * 160 and 310 bytes. */
void invcali_zero_bytes(void *object, size_t size);
void invcali_zero_reals(invcal_real *x, unsigned count);
void invcali_copy_bytes(void *to, const void *from, size_t size);
#if INVCAL_FAST || defined(__FRAMAC__)
#define invcali_zero(object, size) ((void)memset(object, 0, size))
#define invcali_zero_array(x, count) ((void)memset(x, 0, (count) * sizeof *(x)))
#define invcali_copy(to, from, size) ((void)memcpy(to, from, size))
#else
#define invcali_zero invcali_zero_bytes
#define invcali_zero_array invcali_zero_reals
#define invcali_copy invcali_copy_bytes
#endif

#define INVCAL_NORMAL INVCAL_REAL(1.959964) /* sigma to 95 %, if the noise is known */

/* Converts a count below 2^31: as signed, as raw counts are, so that one conversion serves all. */
static inline invcal_real invcali_number(unsigned n)
{
    return (invcal_real)(int32_t)n;
}

/* False for NaN too. */
static inline int invcali_is_finite(invcal_real x)
{
    return INVCAL_FABS(x) <= INVCAL_REAL_MAX;
}

static inline int invcali_is_positive(invcal_real x)
{
    return x > 0 && x <= INVCAL_REAL_MAX;
}

/* The dot product of n >= 1 elements. */
static INVCAL_ONCE invcal_real invcali_dot_inline(const invcal_real *a, const invcal_real *b,
                                                  unsigned n)
{
    invcal_real sum = 0;

    INVCAL_UNROLL_ROWS
    do { /* at most the triangle of all unknowns: see invcali_condition */
        sum += *a++ * *b++;
    } while (--n > 0);
    return sum;
}
#if INVCAL_FAST
static INVCAL_ONCE invcal_real invcali_dot(const invcal_real *a, const invcal_real *b, unsigned n)
{
    return invcali_dot_inline(a, b, n);
}
#else
invcal_real invcali_dot(const invcal_real *a, const invcal_real *b, unsigned n);
#endif

/* a x b; out must be neither of them. Inline as above. */
#if INVCAL_FAST
static INVCAL_ONCE void invcali_cross(const invcal_real *a, const invcal_real *b,
                                      invcal_real *restrict out)
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}
#else
void invcali_cross(const invcal_real *a, const invcal_real *b, invcal_real *restrict out);
#endif

static inline invcal_real invcali_dot3(const invcal_real a[3], const invcal_real b[3])
{
    return invcali_dot(a, b, 3);
}

/* Are all three finite? Times 0, a number that is not finite gives NaN, and so does the sum. */
static inline int invcali_are_finite(const invcal_real v[3])
{
    return v[0] * 0 + v[1] * 0 + v[2] * 0 >= 0;
}

/* A unit vector, within 1e-4 of its length? */
static inline int invcali_is_unit(const invcal_real v[3])
{
    return INVCAL_FABS(invcali_dot3(v, v) - 1) <= INVCAL_REAL(2e-4);
}

/* calibrated = matrix (raw - offset). */
static INVCAL_ONCE void invcali_correct_inline(const invcal_calibration *c,
                                               const invcal_real raw[3], invcal_real out[3])
{
    const invcal_real u[3] = {raw[0] - c->offset[0], raw[1] - c->offset[1], raw[2] - c->offset[2]};

    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real *const row = c->matrix[i];
        out[i] =
            INVCAL_HAS_FPU ? row[0] * u[0] + row[1] * u[1] + row[2] * u[2] : invcali_dot3(row, u);
    }
}
/* Inline for frequent callers if speed matters. */
#if INVCAL_FAST
static INVCAL_ONCE void invcali_correct(const invcal_calibration *c, const invcal_real raw[3],
                                        invcal_real out[3])
{
    invcali_correct_inline(c, raw, out);
}
#else
void invcali_correct(const invcal_calibration *c, const invcal_real raw[3], invcal_real out[3]);
#endif

#endif
