/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/calibration.h"

void main(void)
{
    invcal_calibration calibration;
    invcal_real zero[3];
    invcal_real scale[3];
    invcal_real inverse[3][3];

    ANY(zero);
    ANY(scale);
    (void)invcal_calibration_nominal(zero, scale, &calibration);
    ANY(calibration);
    invcal_apply(&calibration, zero, scale);
    invcal_apply(&calibration, zero, zero);
    (void)invcal_calibration_inverse(&calibration, inverse);
}
