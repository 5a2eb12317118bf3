/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/expert.h"

// eva: -eva-auto-loop-unroll 12 -eva-slevel 20
// config: -D__OPTIMIZE__=1

/* As many as thermal.h asks for at its largest. */
enum { MOST = 27 };

/* In a buffer of exactly so many elements. */
static void solve(unsigned n, unsigned rows)
{
    static invcal_real buffer[INVCAL_PACKED_SIZE(MOST + 1)];
    invcal_real *a = &buffer[INVCAL_PACKED_SIZE(MOST + 1) - INVCAL_PACKED_SIZE(rows)];
    invcal_real floor;
    invcal_real h[INVCAL_PARAMETERS];

    ANY(buffer);
    ANY(floor);
    ANY(h);
    (void)invcal_trace(a, n);
    (void)invcal_largest_diagonal(a, n);
    invcal_add_ridge(a, n, floor);
    (void)invcal_factor(a, n, rows, floor);
    if (rows > n) {
        invcal_back_substitute(a, n);
    }
    invcal_invert(a, n);
    (void)invcal_variance(a, n, BETWEEN(0, n - 1));
    if (n == INVCAL_PARAMETERS) {
        (void)invcal_leverage(a, h);
    }
}

void main(void)
{
    //@ loop unroll MOST;
    for (unsigned n = 1; n <= MOST; n++) {
        solve(n, n);
        solve(n, n + 1);
    }
}
