/* SPDX-License-Identifier: MIT */
#include "fit/sensors.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "text/append.h"
#include "text/figure.h"
#include "text/nearest.h"
#include "text/unit.h"

#define KEY_MAX 24u
#define RATIO_MAX 1.5       /* no sensor has a larger scale error, and ranges differ by more */
#define RANGE_TOLERANCE 1.2 /* ratio of counts that still match a range */

/* Each row is from the document that it names; "T" is a table there. The sheet does not state what
 * is 0 or missing. ST states sensitivities in mg per count, whose inverse is counts per g; its
 * zero-g level accuracy is a typical value. */
static const sensor sensors[] = {
    {"mpu6050",
     "MPU-6050",
     {{"2g", 16384}, {"4g", 8192}, {"8g", 4096}, {"16g", 2048}},
     0,
     {0.050, 0.050, 0.080},
     0.03,
     0.02,
     SENSOR_OFFSET | SENSOR_SCALE | SENSOR_CROSS_AXIS,
     "",
     "InvenSense PS-MPU-6000A-00 Rev. 3.4, 2013-08-19, 6.2 on p. 13"},
    {"mpu6000",
     "MPU-6000",
     {{"2g", 16384}, {"4g", 8192}, {"8g", 4096}, {"16g", 2048}},
     0,
     {0.050, 0.050, 0.080},
     0.03,
     0.02,
     SENSOR_OFFSET | SENSOR_SCALE | SENSOR_CROSS_AXIS,
     "",
     "InvenSense PS-MPU-6000A-00 Rev. 3.4, 2013-08-19, 6.2 on p. 13"},
    {"mpu9250",
     "MPU-9250",
     {{"2g", 16384}, {"4g", 8192}, {"8g", 4096}, {"16g", 2048}},
     0,
     {0.060, 0.060, 0.080},
     0.03,
     0.02,
     SENSOR_OFFSET | SENSOR_SCALE | SENSOR_CROSS_AXIS,
     "",
     "InvenSense PS-MPU-9250A-01 Rev. 1.0, 2014-01-17, T2 on p. 9"},
    /* the offset is at board level; it is 25 mg before soldering */
    {"icm20948",
     "ICM-20948",
     {{"2g", 16384}, {"4g", 8192}, {"8g", 4096}, {"16g", 2048}},
     0,
     {0.050, 0.050, 0.050},
     0.005,
     0.02,
     SENSOR_OFFSET | SENSOR_SCALE | SENSOR_CROSS_AXIS,
     "",
     "InvenSense DS-000189 Rev. 1.3, 2017-06-02, T2 on p. 12"},
    {"lsm6ds3",
     "LSM6DS3",
     {{"2g", 1000 / 0.061}, {"4g", 1000 / 0.122}, {"8g", 1000 / 0.244}, {"16g", 1000 / 0.488}},
     0,
     {0.040, 0.040, 0.040},
     0,
     0,
     SENSOR_OFFSET,
     "",
     "ST DocID026899 Rev. 8, 2016-02, T3 Mechanical characteristics"},
    {"lsm6dso",
     "LSM6DSO",
     {{"2g", 1000 / 0.061}, {"4g", 1000 / 0.122}, {"8g", 1000 / 0.244}, {"16g", 1000 / 0.488}},
     0,
     {0.020, 0.020, 0.020},
     0,
     0,
     SENSOR_OFFSET,
     "",
     "ST DS12140 Rev. 2, 2019-01, T2 Mechanical characteristics"},
    /* 1, 2, 4, 12 mg per digit of 12 bits, the upper ones of 16 */
    {"lis3dh",
     "LIS3DH",
     {{"2g", 16 * 1000.0 / 1},
      {"4g", 16 * 1000.0 / 2},
      {"8g", 16 * 1000.0 / 4},
      {"16g", 16 * 1000.0 / 12}},
     0,
     {0.040, 0.040, 0.040},
     0,
     0,
     SENSOR_OFFSET,
     "16-bit counts as in the registers, left-justified",
     "ST DocID17530 Rev. 2, 2016-12, T4 Mechanical characteristics"},
    /* sensitivity 230 ... 282 at 2 g, also 10 % or 11 % at the others */
    {"adxl345",
     "ADXL345",
     {{"2g", 256}, {"4g", 128}, {"8g", 64}, {"16g", 32}},
     0,
     {0.150, 0.150, 0.250},
     0.10,
     0.01,
     SENSOR_CROSS_AXIS,
     "in full resolution, the scale of 2g applies to every range",
     "Analog Devices ADXL345 Rev. E, 2015, T1 Specifications"},
    /* sensitivity 235520 ... 276480 at 2 g */
    {"adxl355",
     "ADXL355",
     {{"2g", 256000}, {"4g", 128000}, {"8g", 64000}},
     0,
     {0.075, 0.075, 0.075},
     0.08,
     0.01,
     SENSOR_CROSS_AXIS,
     "20-bit counts",
     "Analog Devices ADXL354/ADXL355 Rev. 0, 2016, Specifications"},
    /* sensitivity 15729 ... 17039 at 2 g; the offset is after soldering */
    {"bmi160",
     "BMI160",
     {{"2g", 16384}, {"4g", 8192}, {"8g", 4096}, {"16g", 2048}},
     0,
     {0.040, 0.040, 0.040},
     0.04,
     0,
     SENSOR_OFFSET,
     "",
     "Bosch BST-BMI160-DS000-07 Rev. 0.8, 2015-02, 1 Specification"},
    {"bmi270",
     "BMI270",
     {{"2g", 16384}, {"4g", 8192}, {"8g", 4096}, {"16g", 2048}},
     2,
     {0.020, 0.020, 0.020},
     0.004,
     0.01,
     SENSOR_OFFSET | SENSOR_SCALE | SENSOR_CROSS_AXIS,
     "",
     "Bosch BST-BMI270-DS000-05 Rev. 1.3, 2020-11, 1 Specification"},
    {"bno055",
     "BNO055",
     {{"m/s2", 100 * UNIT_STANDARD_GRAVITY}, {"mg", 1000}},
     0,
     {0.150, 0.150, 0.150},
     0.04,
     0.02,
     0,
     "counts of 0.01 m/s2 or of 1 mg, at any range",
     "Bosch BST-BNO055-DS000-14 Rev. 1.4, 2016-06, T0-2"},
    /* raw counts differ between devices: 4.8 of the document, Test and Calibration Certificate */
    {"xsens-mti",
     "Xsens MTi",
     {{"m/s2", UNIT_STANDARD_GRAVITY}},
     0,
     {0, 0, 0},
     0,
     0,
     0,
     "calibrated output; for raw counts see the unit's certificate",
     "Xsens MT0100P.N, MTi and MTx User Manual, 4.5.2 on p. 18"},
};

#define SENSORS (sizeof sensors / sizeof sensors[0])

/* ---- choosing --------------------------------------------------------------------------------- */

/* Lower-case letters and digits only. */
static void normalise(const char *text, size_t length, char out[KEY_MAX])
{
    size_t n = 0;

    for (size_t i = 0; i < length && n + 1 < KEY_MAX; i++) {
        const unsigned char c = (unsigned char)text[i];
        if (isalnum(c) || c == '.') {
            out[n++] = (char)tolower(c);
        }
    }
    out[n] = '\0';
}

static int matches(const char *key, const char *normalised)
{
    char own[KEY_MAX];

    normalise(key, strlen(key), own);
    return *normalised != '\0' && strcmp(own, normalised) == 0;
}

static void list_ranges(const sensor *type, char *text, size_t size)
{
    for (unsigned k = 0; k < SENSORS_RANGES && type->range[k].name; k++) {
        append(text, size, "%s%s", k > 0 ? ", " : "", type->range[k].name);
    }
}

static int choose_range(const char *words, sensor_choice *out, char text[SENSORS_TEXT_MAX])
{
    char normalised[KEY_MAX];

    normalise(words, strlen(words), normalised);
    for (unsigned k = 0; k < SENSORS_RANGES && out->type->range[k].name; k++) {
        if (matches(out->type->range[k].name, normalised)) {
            out->range = &out->type->range[k];
            return 1;
        }
    }
    snprintf(text, SENSORS_TEXT_MAX, "%s has no '%.40s', but ", out->type->name, words);
    list_ranges(out->type, text, SENSORS_TEXT_MAX);
    return 0;
}

int sensors_choose(const char *words, sensor_choice *out, char text[SENSORS_TEXT_MAX])
{
    const size_t length = strcspn(words, ":");
    char normalised[KEY_MAX];
    char hint[NEAREST_TEXT_MAX];

    normalise(words, length, normalised);
    nearest meant = nearest_begin(normalised, strlen(normalised));
    nearest_offer(&meant, "list");
    for (size_t i = 0; i < SENSORS; i++) {
        if (matches(sensors[i].key, normalised)) {
            *out = (sensor_choice){&sensors[i], &sensors[i].range[sensors[i].power_on]};
            return words[length] == '\0' || choose_range(words + length + 1, out, text);
        }
        nearest_offer(&meant, sensors[i].key);
    }
    snprintf(text, SENSORS_TEXT_MAX, "unknown sensor '%.*s'%s; --sensor list prints the known ones",
             (int)(length < 40 ? length : 40), words, nearest_text(&meant, hint));
    return 0;
}

/* ---- data -------------------------------------------------------------------------------------- */

double sensors_scale(const sensor_choice *c, double field)
{
    return unit_scale(UNIT_G, field) / c->range->per_g;
}

void sensors_limits(const sensor_choice *c, double field, double limit[INVCAL_PARAMETERS])
{
    const double over_field = unit_scale(UNIT_G, field) / field;

    for (unsigned i = 0; i < 3; i++) {
        const double most[3] = {c->type->offset[i] * over_field, c->type->scale,
                                2 * c->type->cross_axis};
        for (unsigned kind = 0; kind < 3; kind++) {
            limit[3 * kind + i] = most[kind] > 0 ? most[kind] : (double)NAN;
        }
    }
}

int sensors_fit(const sensor_choice *c, double ratio, char text[SENSORS_TEXT_MAX],
                char remedy[SENSORS_TEXT_MAX])
{
    const double counts = ratio * c->range->per_g;
    char key[SENSORS_TEXT_MAX];
    char number[FIGURE_MAX];

    if (ratio < RATIO_MAX && ratio > 1 / RATIO_MAX) {
        return 1;
    }
    snprintf(text, SENSORS_TEXT_MAX, "the readings are %s times too %s for %.40s",
             figure_digits(ratio > 1 ? ratio : 1 / ratio, 2, number), ratio > 1 ? "large" : "small",
             sensors_key(c, key));
    for (unsigned k = 0; k < SENSORS_RANGES && c->type->range[k].name; k++) {
        const double other = counts / c->type->range[k].per_g;
        if (other < RANGE_TOLERANCE && other > 1 / RANGE_TOLERANCE) {
            append(text, SENSORS_TEXT_MAX, ": they match %s:%s", c->type->key,
                   c->type->range[k].name);
            snprintf(remedy, SENSORS_TEXT_MAX,
                     "state that range, or set the sensor to the stated one");
            return 0;
        }
    }
    append(text, SENSORS_TEXT_MAX, ", at any of its ranges: a broken unit, or another sensor");
    snprintf(remedy, SENSORS_TEXT_MAX, "state --zero and --lsb if it is right");
    return 0;
}

const char *sensors_key(const sensor_choice *c, char text[SENSORS_TEXT_MAX])
{
    snprintf(text, SENSORS_TEXT_MAX, "%s:%s", c->type->key, c->range->name);
    return text;
}

/* Appends a limit: "offsets ±50, ±50, ±80 mg". */
static void append_limit(const sensor *s, unsigned which, char *text, size_t size)
{
    const double *offset = s->offset;

    if (which == SENSOR_SCALE) {
        append(text, size, "scale ±%.3g %%", 100 * s->scale);
    } else if (which == SENSOR_CROSS_AXIS) {
        append(text, size, "cross-axis ±%.3g %%", 100 * s->cross_axis);
    } else if (offset[2] > offset[0]) {
        append(text, size, "offsets ±%.3g, ±%.3g, ±%.3g mg", 1000 * offset[0], 1000 * offset[1],
               1000 * offset[2]);
    } else {
        append(text, size, "offsets ±%.3g mg", 1000 * offset[0]);
    }
}

const char *sensors_limits_text(const sensor_choice *c, char text[SENSORS_TEXT_MAX])
{
    const sensor *s = c->type;
    const unsigned stated = (s->offset[0] > 0 ? SENSOR_OFFSET : 0u) |
                            (s->scale > 0 ? SENSOR_SCALE : 0u) |
                            (s->cross_axis > 0 ? SENSOR_CROSS_AXIS : 0u);
    const unsigned groups[2] = {stated & ~s->typical, stated & s->typical};

    snprintf(text, SENSORS_TEXT_MAX, "%s", stated ? "" : "not stated");
    for (unsigned g = 0; g < 2; g++) {
        const char *before = g == 1 ? "typical: " : "";
        for (unsigned which = SENSOR_OFFSET; which <= SENSOR_CROSS_AXIS; which *= 2) {
            if (groups[g] & which) {
                append(text, SENSORS_TEXT_MAX, "%s%s", *text ? "; " : "", before);
                append_limit(s, which, text, SENSORS_TEXT_MAX);
                before = "";
            }
        }
    }
    return text;
}

void sensors_list(FILE *file)
{
    char text[SENSORS_TEXT_MAX];

    fprintf(file,
            "Data sheets known to --sensor NAME[:RANGE]. Counts per g; *: range at power-on.\n"
            "Zero is 0 counts. Typical: the sheet states no maximum. Limits that the sheet\n"
            "does not state are not checked. Angles between axes may be twice the cross-axis\n"
            "sensitivity.\n");
    for (size_t i = 0; i < SENSORS; i++) {
        const sensor *s = &sensors[i];
        const sensor_choice c = {s, s->range};
        fprintf(file, "\n%-12s", s->key);
        for (unsigned k = 0; k < SENSORS_RANGES && s->range[k].name; k++) {
            fprintf(file, "%s%s%s %.6g", k > 0 ? ", " : "", s->range[k].name,
                    k == s->power_on ? "*" : "", s->range[k].per_g);
        }
        fprintf(file, "\n            %s\n", sensors_limits_text(&c, text));
        if (*s->note) {
            fprintf(file, "            %s\n", s->note);
        }
        fprintf(file, "            %s\n", s->sheet);
    }
}
