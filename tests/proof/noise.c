/* SPDX-License-Identifier: MIT */
#include "history_allan.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 40 -eva-slevel 40
// wide: -DINVCAL_ALLAN_TAUS=31 -DINVCAL_PRIVATE_OVERLAP=16384

static invcal_allan allan;

void main(void)
{
    invcal_noise noise;
    invcal_dwell dwell;
    invcal_real x;

    ANY(x);
    any_allan(&allan);
    (void)invcal_allan_solve(&allan, x, &noise);
    ANY(noise);
    (void)invcali_noise_sigma(&noise, x);
    (void)invcal_noise_dwell(&noise, x, &dwell);
}
