/* SPDX-License-Identifier: MIT
 *
 * text/unit.h: the unit that readings are in.
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
    UNIT_MICROTESLA, /* of a magnetometer: these alone, and counts */
    UNIT_NANOTESLA,
    UNIT_GAUSS,
    UNIT_MILLIGAUSS
} reading_unit;

/* Who says so. A heading or an option states a unit; a guess by size is for words alone, unless it is sure. */
typedef enum {
    UNIT_FROM_NONE,
    UNIT_FROM_HEADER,
    UNIT_FROM_OPTION,
    UNIT_FROM_SIZE,
    UNIT_FROM_SENSOR /* counts of a sensor that is stated */
} unit_origin;

/* Reads "g", "mg", "m/s^2" in its spellings, "counts", "raw" or "LSB", in any case.
 * Returns 1; 0, with *out left alone, if it is none of them. */
int unit_parse(const char *text, reading_unit *out);

/* The same of a magnetometer: "uT", "nT", "G" and "gauss", "mG", "counts". */
int unit_parse_magnetic(const char *text, reading_unit *out);

/* The unit with this name (unit_name); UNIT_UNKNOWN for any other text. */
reading_unit unit_of_name(const char *name);
/* Of a rate of turn: "rad/s", "deg/s" (dps, °/s), or m in front for a thousandth, in their spellings. Returns
 * rad/s in one of them; 0 for others. And what people call it, and JSON: "rad/s", "mrad/s", "deg/s", "mdeg/s",
 * "counts". */
#define UNIT_DEGREE 0.017453292519943296 /* rad */
double unit_parse_turn(const char *text);
const char *unit_turn_words(double radians);
const char *unit_turn_name(double radians);

/* Reads "s", "ms", "us", "ns" in their spellings. Returns how many make a second; 0 for others. */
double unit_parse_time(const char *text);

/* degrees C = scale value + zero */
typedef struct {
    double scale; /* 0: not a unit of temperature */
    double zero;
} temperature_unit;

/* Reads degrees C, F, and K in any spelling that ends with the letter or the name, with m in front
 * for a thousandth: "°C", "degC", "m°C", "Fahrenheit". */
temperature_unit unit_parse_temperature(const char *text);

/* 1 if a field of this length is gravity in m/s^2: nothing else on earth is 9.8. */
int unit_is_gravity(double field);

/* m/s^2 per unit of a field of this length: 1 if it is gravity in m/s^2 (9.7 ... 9.9), 9.80665 in
 * g (0.99 ... 1.01), a thousandth of that in mg; else 0: no gravity, or in no unit of it. */
double unit_field_si(double field);

/* The unit that most of these readings at rest look like, by their length; else counts.
 *
 * reading  3 count numbers: x y z, ...
 * field    length of the field: if it is no gravity, nothing is known. */
reading_unit unit_by_size(const double *reading, unsigned count, double field);

/* 1 if readings of that size can be nothing else: nine in ten are as long as gravity in g or m/s^2, to 15 %,
 * and they do not all point one way, as with a zero far off. No sensor counts so coarsely. Of mg it is never
 * sure: there are sensors of 1000 or 1024 counts a g. */
int unit_is_sure(reading_unit u, const double *reading, unsigned count);

/* Field units per unit, for a field that is gravity; 0 if the field or the unit does not give it. */
double unit_scale(reading_unit u, double field);

/* For JSON: "g", "mg", "m/s^2", "counts", "uT", "nT", "gauss", "mgauss", "unknown". */
const char *unit_name(reading_unit u);

/* For people: "g", "mg", "m/s²", "counts", "µT", "nT", "gauss", "mgauss", "input units". */
const char *unit_words(reading_unit u);

/* "none", "header", "option", "size", "sensor". */
const char *unit_origin_name(unit_origin origin);

#endif
