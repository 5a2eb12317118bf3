/* SPDX-License-Identifier: MIT
 *
 * fit/sensors.h: data sheets of common accelerometers: scale, and limits of offsets and scale
 * errors.
 */
#ifndef SENSORS_H
#define SENSORS_H

#include <stdio.h>

#include "invcal/invcal.h"

#define SENSORS_RANGES 4u

typedef struct {
    const char *name; /* "4g"; or the unit of the output: "m/s2", "mg" */
    double per_g;     /* counts per g */
} sensor_range;

/* Limits of 0 are not stated. The nominal output of all these sensors is 0 without acceleration. */
typedef struct {
    const char *key;  /* the name for --sensor: "mpu6050" */
    const char *name; /* as in the sheet */
    sensor_range range[SENSORS_RANGES];
    unsigned power_on; /* the range at power-on */
    double offset[3];  /* of zero, g */
    double scale;      /* relative error of the sensitivity */
    double cross_axis; /* sensitivity to the field along another axis */
    unsigned typical;  /* bits SENSOR_OFFSET ...: a typical figure, not a maximum */
    const char *note;  /* on the counts, or "" */
    const char *sheet; /* document, revision, date, place in it */
} sensor;

enum { SENSOR_OFFSET = 1, SENSOR_SCALE = 2, SENSOR_CROSS_AXIS = 4 };

/* A sensor at one of its ranges. */
typedef struct {
    const sensor *type; /* null: none is stated */
    const sensor_range *range;
} sensor_choice;

/* Parses "mpu6050:4g", or "mpu6050" for its range at power-on, ignoring dashes and case. Returns 1;
 * 0, with an error message in text. */
#define SENSORS_TEXT_MAX 240
int sensors_choose(const char *words, sensor_choice *out, char text[SENSORS_TEXT_MAX]);

/* Field units per count; 0 if the field is not gravity. */
double sensors_scale(const sensor_choice *c, double field);

/* The largest deviations of the nine parameters that the sheet allows, offsets over the field,
 * angles in rad; NaN: not stated. The angle between two axes may be twice the cross-axis
 * sensitivity. */
void sensors_limits(const sensor_choice *c, double field, double limit[INVCAL_PARAMETERS]);

/* Whether this sensor can give readings of gravity whose lengths are `ratio` times the expected
 * ones. Returns 1; 0, with the reason in text, which names another range if that matches, and what
 * to do in remedy. */
int sensors_fit(const sensor_choice *c, double ratio, char text[SENSORS_TEXT_MAX],
                char remedy[SENSORS_TEXT_MAX]);

/* "mpu6050:4g"; and the limits in words, which mark those that are typical. Return text. */
const char *sensors_key(const sensor_choice *c, char text[SENSORS_TEXT_MAX]);
const char *sensors_limits_text(const sensor_choice *c, char text[SENSORS_TEXT_MAX]);

/* Prints all sensors. */
void sensors_list(FILE *file);

#endif
