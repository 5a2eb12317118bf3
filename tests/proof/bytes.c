/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "bytes.h"

void main(void)
{
    uint8_t bytes[300];
    const uint32_t size = BETWEEN(0, sizeof bytes);
    invcal_way way = {INVCAL_GET, bytes, bytes, 1};
    invcal_real reals[9];

    ANY(bytes);
    ANY(reals);
    ANY(way.what);
    invcal_is_sound(bytes, size);
    invcal_are_zero(bytes, size);
    invcal_way_each(&way, reals, 9);
}
