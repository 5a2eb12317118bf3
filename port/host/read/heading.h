/* SPDX-License-Identifier: MIT
 *
 * read/heading.h: parses the heading of a column: name, axis, unit.
 */
#ifndef HEADING_H
#define HEADING_H

#include "text/unit.h"

#define HEADING_NAME_MAX 48

typedef struct {
    char name[HEADING_NAME_MAX]; /* as written, without the unit, truncated */
    char key[HEADING_NAME_MAX];  /* lower-case letters and digits of the name without the axis */
    int axis;                    /* 0, 1, 2; -1: none */
    reading_unit unit;           /* stated, of an accelerometer; else UNIT_UNKNOWN */
    reading_unit magnetic;       /* the same of a magnetometer */
    double rate_unit;            /* stated unit of an angular rate, in rad/s; else 0 */
    double per_second;           /* stated unit of time, units in a second; else 0 */
    temperature_unit degrees;    /* of temperature, stated in brackets; else its scale is 0 */
    int states_unit;             /* a unit is stated; in brackets it may be an unknown one */
} heading;

/* Parses a heading: `ax (g)`, `Acceleration x [m/s^2]`, `acc_x_mg`, `xyz[0]`, `time (us)`,
 * `TimeUS`, ... */
void heading_read(const char *text, heading *out);

#endif
