/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/expert.h"
#include "invcal/thermal.h"
#include "core/system.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 30
// config: -DINVCAL_FAST=1 -DINVCAL_THERMAL_DEGREE=0
// config: -DINVCAL_THERMAL_DEGREE=2

/* The sizes that the library uses. */
enum { THERMAL = 9 * (1 + INVCAL_THERMAL_DEGREE), IMU = 18, MOST = THERMAL > IMU ? THERMAL : IMU };

/* In a buffer of exactly that many elements. */
static void solve(unsigned n, unsigned rows)
{
    static invcal_real buffer[INVCAL_PACKED_SIZE(MOST + 1)];
    invcal_real *a = &buffer[INVCAL_PACKED_SIZE(MOST + 1) - INVCAL_PACKED_SIZE(rows)];
    invcal_real floor;
    invcal_real h[INVCAL_PARAMETERS];

    ANY(buffer);
    ANY(floor);
    ANY(h);
    (void)invcali_trace(a, n);
    (void)invcali_largest_diagonal(a, n);
    (void)invcali_factor(a, n, rows, floor);
    if (rows > n) {
        invcali_back_substitute(a, n);
    }
    invcali_invert(a, n);
    (void)invcali_variance(a, n, BETWEEN(0, n - 1));
    if (n == INVCAL_PARAMETERS) {
        (void)invcali_leverage(a, h);
    }
}

void main(void)
{
    static const unsigned sizes[] = {1, 2, 3, 5, 9, IMU, THERMAL};

    for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        solve(sizes[i], sizes[i]);
        solve(sizes[i], sizes[i] + 1);
    }
}
