/* SPDX-License-Identifier: MIT
 *
 * text/unit.h: units of readings, of time and of temperature.
 */
#ifndef UNIT_H
#define UNIT_H

#define UNIT_STANDARD_GRAVITY 9.80665 /* m/s^2, what the unit g stands for */

typedef enum {
    UNIT_UNKNOWN,
    UNIT_G,
    UNIT_MG,
    UNIT_MS2,
    UNIT_COUNTS,
    UNIT_MICROTESLA, /* of a magnetometer, as the following; it may be in counts, too */
    UNIT_NANOTESLA,
    UNIT_GAUSS,
    UNIT_MILLIGAUSS
} reading_unit;

/* Where a unit is from. A heading or an option states it; a guess by size is only for texts, unless
 * it is sure. */
typedef enum {
    UNIT_FROM_NONE,
    UNIT_FROM_HEADER,
    UNIT_FROM_OPTION,
    UNIT_FROM_SIZE,
    UNIT_FROM_SENSOR /* counts, of the stated sensor */
} unit_origin;

/* Parses "g", "mg", "m/s^2" in its spellings, "counts", "raw" or "LSB", ignoring case.
 * Returns 1; 0, with *out untouched, if it is none of them. */
int unit_parse(const char *text, reading_unit *out);

/* The same of a magnetometer: "uT", "nT", "G" and "gauss", "mG", "counts". */
int unit_parse_magnetic(const char *text, reading_unit *out);

/* The unit with this name (unit_name); UNIT_UNKNOWN for any other text. */
reading_unit unit_of_name(const char *name);

/* Units of angular rate: "rad/s", "deg/s" (dps, °/s), or with a prefix m, in their spellings.
 * Parsing returns the rad/s in one unit; 0 for other texts. Names for people, "rad/s", "mrad/s",
 * "°/s", "m°/s" or "counts", and for JSON, with "deg/s", "mdeg/s". */
#define UNIT_DEGREE 0.017453292519943296 /* rad */
double unit_parse_angular_rate(const char *text);
const char *unit_angular_rate_words(double rad_per_s);
const char *unit_angular_rate_name(double rad_per_s);

/* Parses "s", "ms", "us", "ns" in their spellings. Returns the units in a second; 0 for other
 * texts. */
double unit_parse_time(const char *text);

/* degrees C = scale value + zero */
typedef struct {
    double scale; /* 0: not a unit of temperature */
    double zero;
} temperature_unit;

/* Parses degrees C, F, and K in any spelling that ends with the letter or the name, also with a
 * prefix m: "°C", "degC", "m°C", "Fahrenheit". */
temperature_unit unit_parse_temperature(const char *text);

/* 1 if a field of this length is gravity in m/s^2: nothing else on earth is 9.8. */
int unit_is_gravity(double field);

/* m/s^2 per unit of a field of this length: 1 if it is gravity in m/s^2 (9.7 ... 9.9), 9.80665 in
 * g (0.99 ... 1.01), a thousandth of that in mg; 0 if it is not gravity in any of these units. */
double unit_field_si(double field);

/* The unit that fits the lengths of most of these readings at rest; counts if none does.
 *
 * reading  3 * count numbers: x y z, ...
 * field    length of the field: if it is not gravity, the unit is unknown. */
reading_unit unit_by_size(const double *reading, unsigned count, double field);

/* 1 if the guess by size is sure: at least 90 % of the readings have the length of gravity in g or
 * m/s^2 within 15 %, and they do not all point in one direction, as with a large offset. No sensor
 * has counts so coarse. mg is never sure: some sensors have 1000 or 1024 counts per g. */
int unit_is_sure(reading_unit u, const double *reading, unsigned count);

/* Field units per unit, if the field is gravity; 0 if it is not, or the unit has no fixed size. */
double unit_scale(reading_unit u, double field);

/* For JSON: "g", "mg", "m/s^2", "counts", "uT", "nT", "gauss", "mgauss", "unknown". */
const char *unit_name(reading_unit u);

/* For people: "g", "mg", "m/s²", "counts", "µT", "nT", "gauss", "mgauss", "input units". */
const char *unit_words(reading_unit u);

/* "none", "header", "option", "size", "sensor". */
const char *unit_origin_name(unit_origin origin);

#endif
