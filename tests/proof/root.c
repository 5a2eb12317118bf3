/* SPDX-License-Identifier: MIT */
#include "core/vector.h"

#include "arbitrary.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 30

/* Of any float. */
void main(void)
{
    float x;

    ANY(x);
    (void)invcali_root(x);
}
