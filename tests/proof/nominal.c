/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/positions.h"
#include "core/solve.h"

void main(void)
{
    invcal_calibration nominal;
    invcal_real zero[3];
    invcal_real counts[3];

    ANY(zero);
    ANY(counts);
    (void)invcal_nominal(zero, counts, &nominal);
    ANY(nominal);
    (void)invcali_nominal_check(&nominal);
}
