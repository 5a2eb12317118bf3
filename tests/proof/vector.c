/* SPDX-License-Identifier: MIT */
#include "core/vector.h"

#include "arbitrary.h"

void main(void)
{
    invcal_real a[3];
    invcal_real b[3];
    uint8_t bytes[64];
    uint8_t copy[64];
    invcal_calibration calibration;

    ANY(a);
    ANY(b);
    ANY(bytes);
    ANY(calibration);
    (void)invcali_is_finite(a[0]);
    (void)invcali_is_positive(a[0]);
    (void)invcali_are_finite(a);
    (void)invcali_is_unit(a);
    (void)invcali_dot3(a, b);
    (void)invcali_number(BETWEEN(0, 0x7FFFFFFF));
    invcali_correct_inline(&calibration, a, b);
    invcali_copy_bytes(copy, bytes, BETWEEN(0, sizeof bytes));
    invcali_zero_bytes(bytes, BETWEEN(0, sizeof bytes));
    invcali_zero_reals(a, BETWEEN(0, 3));
}
