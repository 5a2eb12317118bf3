/* SPDX-License-Identifier: MIT */
#include "near.h"
#include "arbitrary.h"

void main(void)
{
    invcal_real e[6];
    invcal_real x[3];
    invcal_real low;
    invcal_real high;
    invcal_real y[6];
    invcal_real z[6];

    ANY(e);
    ANY(x);
    ANY(low);
    ANY(high);
    (void)invcal_near_is_between(e, low, high);
    invcal_near_multiply(e, x, y);
    invcal_near_inverse(e, y);
    invcal_near_root(e, y, z);
}
