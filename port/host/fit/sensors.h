/* SPDX-License-Identifier: MIT
 *
 * fit/sensors.h: what the data sheets of common accelerometers say: scale, and how far a good one may be off.
 */
#ifndef SENSORS_H
#define SENSORS_H

#include <stdio.h>

#include "invcal/invcal.h"

#define SENSORS_RANGES 4u

typedef struct {
    const char *name; /* "4g"; or the unit that is put out: "m/s2", "mg" */
    double per_g;     /* counts */
} sensor_range;

/* Limits: 0 is not stated. All sensors of the table put out 0 in no field. */
typedef struct {
    const char *key;  /* as it is asked for: "mpu6050" */
    const char *name; /* as the sheet writes it */
    sensor_range range[SENSORS_RANGES];
    unsigned power_on; /* which of them holds at power-on */
    double offset[3];  /* of zero, g */
    double scale;      /* of the sensitivity, over itself */
    double cross_axis; /* of the field along another axis that an axis feels */
    unsigned typical; /* of which the sheet gives a typical figure, no maximum: SENSOR_OFFSET ... */
    const char *note; /* on its counts, or "" */
    const char *sheet; /* document, revision, date, place in it */
} sensor;

enum { SENSOR_OFFSET = 1, SENSOR_SCALE = 2, SENSOR_CROSS_AXIS = 4 };

/* A sensor at one of its ranges. */
typedef struct {
    const sensor *type; /* null: none is stated */
    const sensor_range *range;
} sensor_choice;

/* Reads "mpu6050:4g", or "mpu6050" for its range at power-on; dashes and the case of letters do not count.
 * Returns 1; 0, with what is wrong in text. */
#define SENSORS_TEXT_MAX 240
int sensors_choose(const char *words, sensor_choice *out, char text[SENSORS_TEXT_MAX]);

/* Field units per count; 0 if the field is no gravity. */
double sensors_scale(const sensor_choice *c, double field);

/* The largest deviations of the nine parameters that the sheet allows, offsets over the field, angles in rad;
 * NaN: it does not say. The angle between two axes may have what each feels of the other. */
void sensors_limits(const sensor_choice *c, double field, double limit[INVCAL_PARAMETERS]);

/* Readings of gravity whose lengths are `ratio` times what they should be can be of this sensor: 1. Else 0,
 * and how far they are from it, and of which other range they may be, in text. */
int sensors_fit(const sensor_choice *c, double ratio, char text[SENSORS_TEXT_MAX]);

/* "mpu6050:4g"; the limits in a sentence, which names those that are typical. Return text. */
const char *sensors_key(const sensor_choice *c, char text[SENSORS_TEXT_MAX]);
const char *sensors_limits_text(const sensor_choice *c, char text[SENSORS_TEXT_MAX]);

/* All of the table, for people. */
void sensors_list(FILE *file);

#endif
