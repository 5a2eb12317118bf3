/* SPDX-License-Identifier: MIT */
#include "invcal/status.h"

/* Texts stand one after the other, each with its end mark: no table of pointers, which would
 * need relocation and so writable memory. */
static const char *nth(const char *texts, unsigned n)
{
    while (n > 0) { /* at most as many steps as there are characters */
        n -= *texts++ == '\0';
    }
    return texts;
}

const char *invcal_status_text(invcal_status status)
{
    static const char texts[] =
        "calibrated\0"
        "a reading is not a finite number\0"
        "a reading is below a tenth or above ten times the field: wrong scale, zero or field\0"
        "a known direction is not a unit vector\0"
        "a setting is not usable: field, noise, weight, prior, nominal calibration or plan\0"
        "exact and linear equations cannot be solved together\0"
        "fewer positions than parameters\0"
        "the positions leave parameters undetermined\0"
        "the readings lie on no ellipsoid: not one sensor at rest in one field\0"
        "nothing is stored\0"
        "the stored bytes are damaged\0"
        "stored in a form that is not known here\0"
        "not enough space\0"
        "the memory cannot be read or written\0"
        "unknown status";
    const unsigned n = (unsigned)status;

    return nth(texts, n < INVCAL_STATUS_COUNT ? n : INVCAL_STATUS_COUNT);
}

const char *invcal_parameter_name(unsigned parameter)
{
    static const char names[] = "delta_x\0delta_y\0delta_z\0"
                                "dk_x\0dk_y\0dk_z\0"
                                "gamma_xy\0gamma_xz\0gamma_zy\0"
                                "?";

    return nth(names, parameter < INVCAL_PARAMETERS ? parameter : INVCAL_PARAMETERS);
}
