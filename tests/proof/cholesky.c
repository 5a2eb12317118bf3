/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/cholesky.h"

void main(void)
{
    invcal_real a[INVCAL_PACKED(INVCAL_CHOLESKY_MAX, 0)];
    invcal_real x[INVCAL_CHOLESKY_MAX];
    invcal_real floor;
    const unsigned n = BETWEEN(1, INVCAL_CHOLESKY_MAX);

    ANY(a);
    ANY(x);
    ANY(floor);
    //@ split n;
    invcal_cholesky_factor(a, n, floor);
    invcal_cholesky_forward(a, n, x);
    invcal_cholesky_solve(a, n, x);
    invcal_cholesky_invert(a, n);
    invcal_cholesky_inverse(a, n);
    if (n <= INVCAL_MAX_PARAMETERS) {
        invcal_cholesky_inverse_diagonal(a, n, x);
    }
}
