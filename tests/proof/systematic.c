/* SPDX-License-Identifier: MIT */
#include "diagnose/systematic.h"

#include "arbitrary.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 20
// config: -DINVCAL_FAST=1
// config: -DINVCAL_MAX_POSITIONS=64

/* In any fit of at most as many positions as the mask has bits; of any kind, at any step. */
void main(void)
{
    static invcal_vector mean[INVCAL_MAX_POSITIONS];
    invcal_calibration nominal;
    invcali_fit fit;
    invcali_test test;

    ANY(mean);
    ANY(nominal);
    ANY(fit);
    fit.selection.given.mean = mean;
    fit.selection.given.count = BETWEEN(0, INVCAL_MAX_POSITIONS);
    fit.selection.given.nominal = &nominal;
    invcali_test_for(&fit, BETWEEN(0, 0xFFFFFFFF), BETWEEN(0, 0xFFFFFFFF), &test);
    (void)test.rank; /* all of it is initialised */
    (void)test.squares;
    (void)test.size[BETWEEN(0, 2)];
    (void)test.shown;
}
