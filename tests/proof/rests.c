/* SPDX-License-Identifier: MIT */
#include <limits.h>

#include "history_rests.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 32 -eva-slevel 40
// trusted: 2
// config: -DINVCAL_FAST=1

static void begin(unsigned bits)
{
    int32_t low, high;
    invcal_private_rests rests;

    ANY(low);
    ANY(high);
    if (invcali_rests_init(&rests, BETWEEN(RATE_FROM(bits), RATE_TO(bits))) == INVCAL_OK) {
        check_rests(&rests, bits);
        (void)invcali_rests_rails(&rests, low, high);
        check_rests(&rests, bits);
    }
}

static void feed(unsigned bits)
{
    int32_t raw[3];
    invcal_private_rests rests;

    ANY(raw);
    any_rests(&rests, bits);
    invcali_rests_feed(&rests, raw);
    check_rests(&rests, bits);
}

static void hold(unsigned bits)
{
    invcal_private_rests rests;

    any_rests(&rests, bits);
    invcali_rests_hold(&rests, BETWEEN(0, UINT_MAX));
    invcali_rests_gap(&rests);
    check_rests(&rests, bits);
}

static void finish(unsigned bits)
{
    invcal_private_rests rests;

    any_rests(&rests, bits);
    invcali_rests_finish(&rests);
    check_rests(&rests, bits);
}

static void look(unsigned bits)
{
    invcal_private_rests rests;
    invcali_rest rest;
    invcal_real mean[3];

    any_rests(&rests, bits);
    invcali_rests_progress(&rests);
    invcali_rests_reason(&rests);
    invcali_rests_get(&rests, &rest);
    invcali_rests_mean(&rests, mean);
}

void main(void)
{
    invcal_private_rests rests;

    (void)invcali_rests_init(&rests, BETWEEN(0, UINT_MAX));
    //@ loop unroll 9;
    for (unsigned bits = 2; bits <= 10; bits++) {
        begin(bits);
        feed(bits);
        hold(bits);
        finish(bits);
        look(bits);
    }
}
