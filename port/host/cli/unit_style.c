/* SPDX-License-Identifier: MIT */
#include "cli/unit_style.h"

#include <string.h>

#define DEGREES 57.295779513082321 /* in a radian */
#define ARCSECONDS (3600 * DEGREES)

int unit_style_parse(const char *text, unit_style *out)
{
    static const char *const words[] = {"everyday", "ins"};

    for (unsigned i = 0; i < 2; i++) {
        if (strcmp(text, words[i]) == 0) {
            *out = (unit_style)i;
            return 1;
        }
    }
    return 0;
}

static display_unit micro(int is_gravity)
{
    return (display_unit){1e6, is_gravity ? "µg" : "ppm of the field"};
}

display_unit unit_style_field(unit_style style, int is_gravity)
{
    return style == UNIT_STYLE_INS ? micro(is_gravity)
           : is_gravity            ? (display_unit){1e3, "mg"}
                                   : (display_unit){1e2, "% of the field"};
}

display_unit unit_style_page_field(unit_style style, int is_gravity)
{
    return style == UNIT_STYLE_INS ? micro(is_gravity)
                                   : (display_unit){1e3, is_gravity ? "mg" : "‰ of the field"};
}

display_unit unit_style_scale(unit_style style)
{
    return style == UNIT_STYLE_INS ? (display_unit){1e6, "ppm"} : (display_unit){1e2, "%"};
}

display_unit unit_style_angle(unit_style style)
{
    return style == UNIT_STYLE_INS ? (display_unit){ARCSECONDS, "arcsec"}
                                   : (display_unit){DEGREES, "degrees"};
}
