/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/invcal.h"
#include "invcal/plan.h"

// eva: -eva-auto-loop-unroll 32 -eva-slevel 2000
// trusted: 1

void main(void)
{
    invcal_real up[3];
    char text[INVCAL_TEXT_SIZE];

    ANY(up);
    (void)invcal_direction_text(up, text);
}
