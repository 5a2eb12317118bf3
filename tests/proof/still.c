/* SPDX-License-Identifier: MIT */
#include "history_still.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 16 -eva-slevel 40 -eva-slevel-function invcal_rest_reason_text:400
// eva: -eva-split-return-function invcal_still_init:0,invcal_block_init:0,invcal_still_push:4,decide:4,judge_moment:4,agree:4,announce_still:4,disagree:4,freeze:4,finish:4,invcal_still_finish:4,fault:0
// trusted: 8
// The sums of a block are proved in its own room; the total is one of so many blocks at most.

/* At a rate from low to high, which is too little to tell anything of others. */
static void begin_at(invcal_real low, invcal_real high)
{
    int32_t least, greatest;
    invcal_still still;

    ANY(least);
    ANY(greatest);
    if (invcal_still_init(&still, Frama_C_float_interval(low, high), least, greatest) ==
        INVCAL_OK) {
        check_still(&still);
    }
}

static void any_begin(void)
{
    invcal_real rate;
    invcal_still still;

    ANY(rate);
    (void)invcal_still_init(&still, rate, 0, 0);
    //@ loop unroll 10;
    for (unsigned high = 16; high <= 8192; high *= 2) {
        begin_at((invcal_real)(high / 2), (invcal_real)high);
    }
}

static void any_push(void)
{
    int32_t raw[3];
    invcal_still still;
    invcal_rest rest;

    ANY(raw);
    any_still(&still);
    invcal_still_push(&still, raw, &rest);
    check_still(&still);
}

static void any_gap(void)
{
    invcal_still still;

    any_still(&still);
    invcal_still_gap(&still);
    check_still(&still);
}

static void any_finish(void)
{
    invcal_still still;
    invcal_rest rest;

    any_still(&still);
    invcal_still_finish(&still, &rest);
    check_still(&still);
}

static void any_look(void)
{
    invcal_still still;
    invcal_rest rest;
    invcal_real mean[3];

    any_still(&still);
    invcal_still_progress(&still);
    invcal_still_reason(&still);
    invcal_still_current(&still, &rest);
    ANY(rest);
    invcal_rest_mean(&rest, mean);
}

static void any_texts(void)
{
    for (unsigned n = 0; n <= INVCAL_REST_SAME; n++) {
        invcal_rest_reason_text((invcal_rest_reason)n);
    }
    invcal_rest_reason_text((invcal_rest_reason)BETWEEN(INVCAL_REST_SAME + 1, UINT32_MAX));
}

void main(void)
{
    any_texts();
    any_begin();
    any_push();
    any_gap();
    any_finish();
    any_look();
}
