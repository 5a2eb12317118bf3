/* SPDX-License-Identifier: MIT */
#include "history_allan.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 40 -eva-slevel 300 -eva-slevel-function stride_bits:200
// wide: -DINVCAL_ALLAN_TAUS=31 -DINVCAL_PRIVATE_OVERLAP=16384
// config: -DINVCAL_ALLAN_TAUS=1 -DINVCAL_PRIVATE_OVERLAP=1
// trusted: 1
// dead: -DINVCAL_ALLAN_TAUS=1 invcal_allan_init_taus 1 a single averaging time is before no other

static void begin(void)
{
    uint32_t m[INVCAL_ALLAN_TAUS];
    invcal_allan allan;

    (void)invcal_allan_init(&allan, 0); /* another build */
    (void)invcal_allan_init_taus(&allan, 0, m, 1, 0);
    (void)invcal_allan_init(&allan, sizeof allan);
    check_allan(&allan);
    ANY(m);
    (void)invcal_allan_init_taus(&allan, sizeof allan, m, UINT32_BETWEEN(0, UINT32_MAX), 0);
    (void)invcal_allan_init(&allan, sizeof allan);
    for (unsigned k = 0; k < INVCAL_ALLAN_TAUS; k++) { /* what is_usable accepts */
        m[k] = UINT32_BETWEEN(1, INVCAL_ALLAN_LONGEST);
        (void)invcal_allan_init_taus(&allan, sizeof allan, m, k + 1, 1);
    }
    check_allan(&allan);
}

static void push(invcal_allan *allan)
{
    int32_t raw;

    ANY(raw);
    any_allan(allan);
    invcal_allan_feed(allan, raw);
    check_allan(allan);
    invcal_allan_gap(allan);
    check_allan(allan);
}

static void look(invcal_allan *allan)
{
    invcal_allan_point point;
    unsigned index;

    ANY(index);
    any_allan(allan);
    (void)invcal_allan_get(allan, index, &point);
}

void main(void)
{
    static invcal_allan allan;

    begin();
    push(&allan);
    look(&allan);
}
