/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/cholesky.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 28 -eva-slevel-merge-after-loop @all
// config: -DINVCAL_MAX_PARAMETERS=27

void main(void)
{
    invcal_real a[INVCAL_PACKED(INVCAL_CHOLESKY_MAX, 0)];
    invcal_real x[INVCAL_CHOLESKY_MAX];
    invcal_real floor;
    const unsigned n = BETWEEN(1, INVCAL_CHOLESKY_MAX);
    const unsigned m = BETWEEN(1, INVCAL_MAX_PARAMETERS);

    ANY(a);
    ANY(x);
    ANY(floor);
    (void)invcal_largest_diagonal(a, n);
    (void)invcal_cholesky_factor(a, n, floor);
    invcal_cholesky_forward(a, n, x);
    invcal_cholesky_invert(a, n);
    invcal_cholesky_inverse(a, n);
    //@ split m;
    invcal_cholesky_inverse_diagonal(a, m, x);
    //@ merge m;
    //@ split n;
    invcal_cholesky_solve(a, n, x);
}
