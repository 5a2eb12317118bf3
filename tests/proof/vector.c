/* SPDX-License-Identifier: MIT */
#include "vector.h"

#include "arbitrary.h"

void main(void)
{
    uint8_t bytes[64];

    invcal_zero_bytes(bytes, BETWEEN(0, sizeof bytes));
}
