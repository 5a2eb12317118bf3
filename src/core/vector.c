/* SPDX-License-Identifier: MIT
 *
 * The loops for builds optimised for size: see invcali_zero in vector.h. Volatile: gcc would turn
 * them into calls of memset and memcpy.
 */
#include "vector.h"

void invcali_zero_bytes(void *object, size_t size)
{
    volatile uint8_t *at = (volatile uint8_t *)object;

    for (size_t i = 0; i < size; i++) {
        at[i] = 0;
    }
}

void invcali_zero_reals(invcal_real *x, unsigned count)
{
    volatile invcal_real *const at = x;

    for (unsigned i = 0; i < count; i++) {
        at[i] = 0;
    }
}

void invcali_copy_bytes(void *to, const void *from, size_t size)
{
    volatile uint8_t *at = (volatile uint8_t *)to;
    const uint8_t *source = (const uint8_t *)from;

    for (size_t i = 0; i < size; i++) {
        at[i] = source[i];
    }
}
