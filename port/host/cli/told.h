/* SPDX-License-Identifier: MIT
 *
 * cli/told.h: the units of figures for people: everyday ones, or those of inertial navigation.
 * JSON has its own units.
 */
#ifndef TOLD_H
#define TOLD_H

typedef enum {
    TOLD_EVERYDAY, /* mg, %, degrees */
    TOLD_INS       /* µg, ppm, arcsec */
} told_style;

/* A figure times `scale` is in `unit`. */
typedef struct {
    double scale;
    const char *unit;
} told_unit;

/* Reads "everyday" or "ins". Returns 1; 0, with *out left alone, if it is neither. */
int told_parse(const char *text, told_style *out);

/* Of lengths, offsets and residuals over the field, which may be gravity: mg or % of the field; on a
 * page, which has space for it, ‰ of the field instead of the latter. In INS µg, or ppm of it. */
told_unit told_field(told_style style, int is_gravity);
told_unit told_parts(told_style style, int is_gravity);

/* Of scale errors: % or ppm. */
told_unit told_scale(told_style style);

/* Of angles: degrees or arcsec. */
told_unit told_angle(told_style style);

#endif
