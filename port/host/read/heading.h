/* SPDX-License-Identifier: MIT
 *
 * read/heading.h: what the heading of one column says: name, axis, unit.
 */
#ifndef HEADING_H
#define HEADING_H

#include "text/unit.h"

#define HEADING_NAME_MAX 48

typedef struct {
    char name[HEADING_NAME_MAX]; /* as it was written, but without its unit, and cut if long */
    char key[HEADING_NAME_MAX];  /* the name in small letters and digits alone, without its axis;
                                    empty for x, y and z themselves */
    int axis;                    /* 0, 1, 2; -1: none */
    reading_unit unit;           /* of a reading, if it is stated and known; */
    reading_unit magnetic;       /* if it is one of a magnetometer */
    double turn;                 /* of a rate of turn, rad/s in one unit, if it is stated; else 0 */
    double per_second;           /* of a time, if it is stated; else 0 */
    temperature_unit degrees;    /* of a temperature, if it is stated in brackets */
    int states_unit;             /* some unit is there, in brackets maybe an unknown one */
} heading;

/* Takes a heading apart: `ax (g)`, `Acceleration x [m/s^2]`, `acc_x_mg`, `xyz[0]`, `time (us)`,
 * `TimeUS`, ... */
void heading_read(const char *text, heading *out);

#endif
