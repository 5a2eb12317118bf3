/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "full_vector.h"
#include "invcal/expert.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50 -eva-split-return full

void main(void)
{
    invcal_full_vector full;
    invcal_calibration nominal;
    invcal_calibration out;
    invcal_real raw[3];
    invcal_real eta[3];
    invcal_real x[INVCAL_PARAMETERS];
    invcal_real mounting[3][3];

    invcal_full_vector_init(&full);
    ANY(nominal);
    ANY(raw);
    ANY(eta);
    (void)invcal_full_vector_add(&full, &nominal, raw, eta);
    ANY(full);
    (void)invcal_full_vector_add(&full, &nominal, raw, eta);
    ANY(full);
    (void)invcal_full_vector_solve(&full, &nominal, &out, x, mounting);
    ANY(full);
    (void)invcal_full_vector_solve(&full, &nominal, &nominal, x, mounting);
}
