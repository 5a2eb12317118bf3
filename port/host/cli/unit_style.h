/* SPDX-License-Identifier: MIT
 *
 * cli/unit_style.h: the units of figures for people: everyday ones, or those of inertial navigation.
 * JSON has its own units.
 */
#ifndef UNIT_STYLE_H
#define UNIT_STYLE_H

typedef enum {
    UNIT_STYLE_EVERYDAY, /* mg, %, degrees */
    UNIT_STYLE_INS       /* µg, ppm, arcsec */
} unit_style;

/* A figure times `scale` is in `unit`. */
typedef struct {
    double scale;
    const char *unit;
} display_unit;

/* Reads "everyday" or "ins". Returns 1; 0, with *out left alone, if it is neither. */
int unit_style_parse(const char *text, unit_style *out);

/* Of lengths, offsets and residuals over the field, which may be gravity: mg or % of the field; on a
 * page, which has space for it, ‰ of the field instead of the latter. In INS µg, or ppm of it. */
display_unit unit_style_field(unit_style style, int is_gravity);
display_unit unit_style_page_field(unit_style style, int is_gravity);

/* Of scale errors: % or ppm. */
display_unit unit_style_scale(unit_style style);

/* Of angles: degrees or arcsec. */
display_unit unit_style_angle(unit_style style);

#endif
