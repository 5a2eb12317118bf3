/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "core/vector.h"

void main(void)
{
    invcal_calibration calibration;
    invcal_real raw[3];
    invcal_real field;
    int32_t counts[3];
    invcal_real out[3];

    ANY(calibration);
    ANY(raw);
    ANY(field);
    ANY(counts);
    invcal_apply(&calibration, raw[0], raw[1], raw[2], out);
    invcal_apply(&calibration, (invcal_real)counts[0], (invcal_real)counts[1],
                 (invcal_real)counts[2], out);
    invcali_correct(&calibration, raw, raw);
    (void)invcal_scale(&calibration, field);
    (void)invcali_dot(raw, out, 3); /* without an FPU, invcal_apply calls it */
}
