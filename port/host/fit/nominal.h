/* SPDX-License-Identifier: MIT
 *
 * fit/nominal.h: the nominal calibration, where it is not given.
 */
#ifndef NOMINAL_H
#define NOMINAL_H

#include "fit/sensors.h"
#include "invcal/invcal.h"
#include "read/positions.h"

typedef enum {
    NOMINAL_GIVEN,   /* by --zero, --lsb */
    NOMINAL_RANGE,   /* from the range of the data */
    NOMINAL_EARLIER, /* by --nominal: an earlier calibration */
    NOMINAL_UNIT,    /* zero 0, and the scale of the unit that is stated, or sure by size */
    NOMINAL_SENSOR   /* by --sensor: of its data sheet */
} nominal_origin;

typedef struct {
    invcal_calibration calibration; /* field units per input unit, as it was stated */
    nominal_origin zero;
    nominal_origin lsb;
    sensor_choice sensor; /* of --sensor, if it was stated */
} nominal_choice;

/* Zero and scale from the box around the data: the middle of each axis' range, and
 * 2 field / range. An axis with less than half of the widest range was not turned through: its
 * own range says nothing, and it takes the scale of the widest.
 *
 * field  length of the field, > 0.
 * zero   input units.
 * lsb    field units per input unit.
 *
 * Returns 1; 0, with lsb left undefined, if there is no range or none that gives usable numbers. */
int nominal_from_range(const positions *p, double field, double zero[3], double lsb[3]);

/* The sphere next to the readings: zero, and one scale for all axes. Scale errors of 3 % turn the ways up by some
 * degrees, no more.
 *
 * raw  means of `count` positions.
 * out  input units to the field's length.
 *
 * Returns 1; 0, with out untouched, if they are fewer than NOMINAL_SPHERE or nearly in a plane: they do not show
 * the zero. */
#define NOMINAL_SPHERE 4u
int nominal_from_sphere(const double *raw, unsigned count, invcal_calibration *out);

/* A calibration in field units from zero and scale. Returns 1; 0, with out untouched, if no
 * calculation can be made with them over this field. */
int nominal_make(const double zero[3], const double lsb[3], double field, invcal_calibration *out);

/* Zero or scale are from the range: how far the sensor is from them means nothing, and is not reported. */
int nominal_is_guess(const nominal_choice *n);

/* Zero or scale are not from the range: there is something to compare with. */
int nominal_is_stated(const nominal_choice *n);

/* Whether a deviation of this parameter from nominal means something: offsets need a zero, scale errors a
 * scale; angles, 90 degrees. */
int nominal_knows(const nominal_choice *n, unsigned parameter);

/* "given", "not stated", "of an earlier calibration", "by the unit", "of the data sheet". */
const char *nominal_origin_text(nominal_origin origin);

/* In a word, for JSON: "given", "range", "earlier", "unit", "sensor". */
const char *nominal_origin_name(nominal_origin origin);

#endif
