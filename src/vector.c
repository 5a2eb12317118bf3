/* SPDX-License-Identifier: MIT
 *
 * The loop for builds optimised for size: see invcal_zero in vector.h.
 */
#include "vector.h"

/* Volatile: gcc would turn the loop into a call of memset. */
void invcal_zero_bytes(void *object, size_t size)
{
    volatile uint8_t *at = (volatile uint8_t *)object;

    for (size_t i = 0; i < size; i++) {
        at[i] = 0;
    }
}
