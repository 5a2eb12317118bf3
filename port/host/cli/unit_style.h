/* SPDX-License-Identifier: MIT
 *
 * cli/unit_style.h: units of the figures that people read: everyday ones, or those of inertial
 * navigation. JSON has its own units.
 */
#ifndef UNIT_STYLE_H
#define UNIT_STYLE_H

typedef enum {
    UNIT_STYLE_EVERYDAY, /* mg, %, degrees */
    UNIT_STYLE_INS       /* µg, ppm, arcsec */
} unit_style;

/* A figure multiplied by `scale` is in `unit`. */
typedef struct {
    double scale;
    const char *unit;
} display_unit;

/* Parses "everyday" or "ins". Returns 1; 0, with *out untouched, if it is neither. */
int unit_style_parse(const char *text, unit_style *out);

/* Of lengths, offsets and residuals relative to the field: mg if that is gravity, else % of the
 * field, or ‰ of the field on a page, which has room for it. In INS style µg, or ppm of the
 * field. */
display_unit unit_style_field(unit_style style, int is_gravity);
display_unit unit_style_page_field(unit_style style, int is_gravity);

/* Of scale errors: %, ppm. */
display_unit unit_style_scale(unit_style style);

/* Of angles: degrees, arcsec. */
display_unit unit_style_angle(unit_style style);

#endif
