/* SPDX-License-Identifier: MIT
 *
 * Internal: the few vector operations that several rooms share.
 */
#ifndef INVCAL_VECTOR_H
#define INVCAL_VECTOR_H

#include <math.h>

#include "invcal/config.h"

/* False for NaN too. */
static inline int invcal_is_finite(invcal_real x)
{
    return INVCAL_FABS(x) <= INVCAL_REAL_MAX;
}

static inline int invcal_is_positive(invcal_real x)
{
    return x > 0 && x <= INVCAL_REAL_MAX;
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
