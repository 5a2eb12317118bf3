/* SPDX-License-Identifier: MIT */
#include "vector.h"

/* Of a loop that is not volatile gcc makes a call of memset. */
void(invcal_zero)(void *object, size_t size)
{
    volatile uint8_t *at = object;

    for (; size > 0; size--) { /* at most 3400 steps: the largest structure */
        *at++ = 0;
    }
}
