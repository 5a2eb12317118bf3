/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "arbitrary.h"
#include "invcal/guidance.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-split-return full -eva-slevel 200 -eva-slevel-merge-after-loop @all
// trusted: 1
// Of the directions the one with the largest gain qualifies, as no gain is a NaN: the pivots of L
// bound it.

void main(void)
{
    invcal_normal normal;
    invcal_real up[3];
    invcal_guidance next;
    char words[INVCAL_GUIDANCE_WORDS];

    ANY(normal);
    ANY(up);
    (void)invcal_guidance_next(&normal, NULL, &next);
    (void)invcal_guidance_next(&normal, up, &next);
    (void)invcal_guidance_of(&normal, up, &next);
    invcal_guidance_words(up, words);
}
