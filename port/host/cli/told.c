/* SPDX-License-Identifier: MIT */
#include "cli/told.h"

#include <string.h>

#define DEGREES 57.295779513082321 /* in a radian */
#define ARCSEC (3600 * DEGREES)

int told_parse(const char *text, told_style *out)
{
    static const char *const words[] = {"everyday", "ins"};

    for (unsigned i = 0; i < 2; i++) {
        if (strcmp(text, words[i]) == 0) {
            *out = (told_style)i;
            return 1;
        }
    }
    return 0;
}

static told_unit micro(int is_gravity)
{
    return (told_unit){1e6, is_gravity ? "µg" : "ppm of the field"};
}

told_unit told_field(told_style style, int is_gravity)
{
    return style == TOLD_INS ? micro(is_gravity)
           : is_gravity      ? (told_unit){1e3, "mg"}
                             : (told_unit){1e2, "% of the field"};
}

told_unit told_parts(told_style style, int is_gravity)
{
    return style == TOLD_INS ? micro(is_gravity)
                             : (told_unit){1e3, is_gravity ? "mg" : "‰ of the field"};
}

told_unit told_scale(told_style style)
{
    return style == TOLD_INS ? (told_unit){1e6, "ppm"} : (told_unit){1e2, "%"};
}

told_unit told_angle(told_style style)
{
    return style == TOLD_INS ? (told_unit){ARCSEC, "arcsec"} : (told_unit){DEGREES, "degrees"};
}
