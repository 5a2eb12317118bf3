/* SPDX-License-Identifier: MIT
 *
 * fit/nominal.h: the nominal calibration, stated or estimated.
 */
#ifndef NOMINAL_H
#define NOMINAL_H

#include "fit/sensors.h"
#include "invcal/invcal.h"
#include "read/positions.h"

typedef enum {
    NOMINAL_GIVEN,   /* by --zero, --lsb */
    NOMINAL_RANGE,   /* from the range of the data */
    NOMINAL_EARLIER, /* an earlier calibration: --nominal */
    NOMINAL_UNIT,    /* zero 0, and the scale of the unit, which is stated, or sure by size */
    NOMINAL_SENSOR   /* from the data sheet: --sensor */
} nominal_origin;

typedef struct {
    invcal_calibration calibration; /* field units per input unit, as stated */
    nominal_origin zero;
    nominal_origin lsb;
    sensor_choice sensor; /* of --sensor, if given */
} nominal_choice;

/* Zero and scale from the range of each axis: its middle, and 2 field / range. If the range of an
 * axis is less than half of the widest one, the axis was not turned through the field: it gets the
 * scale of the widest.
 *
 * field  length of the field, > 0.
 * zero   input units.
 * lsb    field units per input unit.
 *
 * Returns 1; 0, with lsb undefined, if the ranges are zero or give no finite scale. */
int nominal_from_range(const positions *p, double field, double zero[3], double lsb[3]);

/* Fits a sphere to the readings: zero, and one scale for all axes. Scale errors of 3 % change up
 * directions by a few degrees at most.
 *
 * raw  means of `count` positions.
 * out  from input units to readings over the field.
 *
 * Returns 1; 0, with out untouched, if there are fewer than NOMINAL_SPHERE, or nearly in a plane,
 * so that they do not show the zero. */
#define NOMINAL_SPHERE 4u
int nominal_from_sphere(const double *raw, unsigned count, invcal_calibration *out);

/* A calibration in field units from zero and scale. Returns 1; 0, with out untouched, if they are
 * unusable with this field. */
int nominal_make(const double zero[3], const double lsb[3], double field, invcal_calibration *out);

/* Zero or scale are from the range: deviations from nominal are meaningless, and not reported. */
int nominal_is_guess(const nominal_choice *n);

/* Zero or scale are not from the range: deviations from nominal mean something. */
int nominal_is_stated(const nominal_choice *n);

/* Whether the deviation of this parameter from nominal means something: offsets need a zero, scale
 * errors a scale; for angles, nominal is 90 degrees. */
int nominal_knows(const nominal_choice *n, unsigned parameter);

/* "given", "not stated", "from an earlier calibration", "from the unit", "from the data sheet". */
const char *nominal_origin_text(nominal_origin origin);

/* For JSON: "given", "range", "earlier", "unit", "sensor". */
const char *nominal_origin_name(nominal_origin origin);

#endif
