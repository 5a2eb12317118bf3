/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "read/columns.h"

#include <string.h>
#include <strings.h>

#include "cli/command.h"
#include "cli/message.h"
#include "read/columns_option.h"
#include "text/append.h"
#include "text/clock.h"
#include "text/number.h"
#include "text/plain.h"

#define RAD_PER_DEGREE 0.017453292519943296
#define COLUMNS_LIST_MAX 256
#define COLUMNS_REMEDY_MAX 160

/* The headings of the current table; too large for the stack. */
static heading headings[TABLE_COLUMNS_MAX];

/* ---- x, y and z --------------------------------------------------------------------------------- */

static int is_among(const char *key, const char *const *keys)
{
    while (*keys && strcmp(key, *keys) != 0) {
        keys++;
    }
    return *keys != NULL;
}

/* Phones call acceleration without gravity "linear acceleration". ROS spells that of
 * sensor_msgs/Imu, which includes gravity, in this way. */
static int is_of_ros(const heading *h)
{
    return strncmp(h->name, "linear_acceleration.", strlen("linear_acceleration.")) == 0;
}

static int has_key(const table *t, const char *key)
{
    for (unsigned i = 0; i < t->columns; i++) {
        if (strcmp(headings[i].key, key) == 0) {
            return 1;
        }
    }
    return 0;
}

/* The table of kalibr_bagextractor. Elsewhere alpha is usually an angular acceleration, so that the
 * whole header has to match. */
static int is_of_kalibr(const table *t)
{
    static const char *const names[] = {"omega_x", "omega_y", "omega_z",
                                        "alpha_x", "alpha_y", "alpha_z"};
    int is_same = t->columns == 7 && strncmp(t->field[0], "timestamp", strlen("timestamp")) == 0;

    for (unsigned i = 0; is_same && i < 6; i++) {
        is_same = strcmp(t->field[i + 1], names[i]) == 0;
    }
    return is_same;
}

/* Parses all headings. What ROS calls linear acceleration includes gravity; flat tables of its
 * sensor_msgs/Imu are recognised by the angular velocity next to it. */
static void read_headings(const table *t)
{
    for (unsigned i = 0; i < t->columns; i++) {
        heading_read(t->field[i], &headings[i]);
    }
    for (unsigned i = 0; i < t->columns && has_key(t, "angularvelocity"); i++) {
        if (strncmp(headings[i].name, "linear_acceleration_", strlen("linear_acceleration_")) ==
            0) {
            snprintf(headings[i].key, sizeof headings[i].key, "fieldlinearacceleration");
        }
    }
    for (unsigned i = 1; i < t->columns && is_of_kalibr(t); i++) {
        snprintf(headings[i].key, sizeof headings[i].key, "%s",
                 i < 4 ? "fieldangularvelocity"
                       : "fieldlinearacceleration"); /* the keys of a bag, for their units */
    }
}

/* The sensor of a heading, by its key (heading.h). */
static columns_sensor sensor_of(const heading *h)
{
    static const char *const accelerometers[] = {
        "a",
        "acc",
        "accel",
        "acceleration",
        "accelerometer",
        "accelerometeracceleration",
        "accsmooth",
        "accadc",
        "accraw",
        "rawacc",
        "accelraw",
        "rawaccel",
        "gf",
        "fieldlinearacceleration",
        "arss", /* EuRoC: a_RS_S_x */
        NULL,
    };
    static const char *const magnetometers[] = {"m",       "mag", "magnetometer", "magneticfield",
                                                "compass", NULL};
    static const char *const gyroscopes[] = {
        "g",
        "w",
        "gyr",
        "gyro",
        "gyroscope",
        "gyroraw",
        "gyroadc",
        "gyrorad", /* PX4: gyro_rad[0] */
        "omega",
        "rotationrate",
        "angularrate",
        "angularvelocity",
        "fieldangularvelocity",
        "wrss", /* EuRoC: w_RS_S_x */
        NULL,
    };
    static const char *const anything[] = {"", "xyz", "axis", "mean", NULL};

    const char *key = h->key + (strncmp(h->key, "imu", 3) == 0 ? 3 : 0); /* imu_ax */

    return h->axis < 0                                     ? COLUMNS_OF_UNKNOWN
           : is_of_ros(h) || is_among(key, accelerometers) ? COLUMNS_OF_ACCELEROMETER
           : is_among(key, magnetometers)                  ? COLUMNS_OF_MAGNETOMETER
           : is_among(key, gyroscopes)                     ? COLUMNS_OF_GYROSCOPE
           : is_among(key, anything)                       ? COLUMNS_OF_ANY
                                                           : COLUMNS_OF_UNKNOWN;
}

/* The column of this axis with the same key as column `from`; -1: none. */
static int find_axis(const table *t, unsigned from, int axis)
{
    for (unsigned i = 0; i < t->columns; i++) {
        if (headings[i].axis == axis && strcmp(headings[i].key, headings[from].key) == 0) {
            return (int)i;
        }
    }
    return -1;
}

/* A range of values of columns_sensor. */
typedef struct {
    columns_sensor first;
    columns_sensor last;
} sensor_range;

static int has_sensor(const heading *h, sensor_range which)
{
    return sensor_of(h) >= which.first && sensor_of(h) <= which.last;
}

/* Finds the first complete set of x, y and z of such a sensor, starting at column `from`. Returns
 * its first column; the number of columns if there is none. */
static unsigned find_set(const table *t, unsigned from, sensor_range which, int index[3])
{
    for (unsigned i = from; i < t->columns; i++) {
        if (!has_sensor(&headings[i], which)) {
            continue;
        }
        for (int axis = 0; axis < 3; axis++) {
            index[axis] = find_axis(t, i, axis);
        }
        if (index[0] >= 0 && index[1] >= 0 && index[2] >= 0) {
            return i;
        }
    }
    return t->columns;
}

/* Whether a column competes with those found: it has the same key, or belongs to another complete
 * set. */
static int is_duplicate(const table *t, unsigned at, const int index[3])
{
    const heading *h = &headings[at];

    return (int)at != index[h->axis] &&
           (strcmp(h->key, headings[index[0]].key) == 0 ||
            (find_axis(t, at, 0) >= 0 && find_axis(t, at, 1) >= 0 && find_axis(t, at, 2) >= 0));
}

/* As many headings as fit: "time, u, v, w". Returns text. */
static const char *list_names(const table *t, char text[COLUMNS_LIST_MAX])
{
    text[0] = '\0';
    for (unsigned i = 0; i < t->columns; i++) {
        const size_t length = strlen(text);
        if (length + strlen(headings[i].name) + sizeof ", ..." > COLUMNS_LIST_MAX) {
            append(text, COLUMNS_LIST_MAX, ", ...");
            break;
        }
        append(text, COLUMNS_LIST_MAX, "%s%s", i ? ", " : "", headings[i].name);
    }
    return text;
}

static void report_no_axes(const table *t, columns_kind kind)
{
    char names[COLUMNS_LIST_MAX];
    const char *linear = NULL;
    int gyro[3];

    if (kind == COLUMNS_MAGNETOMETER) {
        message("%s:%lu: the header names no columns of a magnetometer (mx my mz; mag_x, ..): "
                "state the three by name or number, such as --columns 2,3,4; there are: %s",
                t->name, t->line, list_names(t, names));
        return;
    }
    for (unsigned i = 0; i < t->columns && !linear; i++) {
        linear = strcmp(headings[i].key, "linearacceleration") == 0 ? headings[i].name : NULL;
    }
    if (!linear && find_set(t, 0, (sensor_range){COLUMNS_OF_GYROSCOPE, COLUMNS_OF_GYROSCOPE},
                            gyro) < t->columns) {
        message("%s:%lu: the header names a gyroscope (%s, ..), but no accelerometer (x, y, z; ax, "
                "ay, az; acc_x, ..), with which it is calibrated: record both in one log. A "
                "gyroscope alone: invcal apply --gyro, invcal allan --columns %s,%s,%s",
                t->name, t->line, headings[gyro[0]].name, headings[gyro[0]].name,
                headings[gyro[1]].name, headings[gyro[2]].name);
    } else if (linear) {
        message("%s:%lu: '%s': linear acceleration has gravity removed by the phone, and cannot be "
                "calibrated; record the accelerometer itself",
                t->name, t->line, linear);
    } else {
        message("%s:%lu: the header names no columns x, y, z (nor ax, ay, az; acc_x, ..): state "
                "the three by name or number, such as --columns 2,3,4; there are: %s",
                t->name, t->line, list_names(t, names));
    }
}

/* Finds the columns of the other sensor, which is not calibrated, if there is one. */
static void find_other_sensor(const table *t, columns_kind kind, columns *out)
{
    const columns_sensor which =
        kind == COLUMNS_MAGNETOMETER ? COLUMNS_OF_ACCELEROMETER : COLUMNS_OF_MAGNETOMETER;
    int other[3];

    if (find_set(t, 0, (sensor_range){which, which}, other) == t->columns) {
        return;
    }
    memcpy(out->seen.other_sensor, headings[other[0]].name, HEADING_NAME_MAX);
    if (kind == COLUMNS_MAGNETOMETER) {
        memcpy(out->accelerometer, other, sizeof other);
    }
}

/* x, y and z have to be of one sensor. A table may hold both an accelerometer and a magnetometer;
 * two of the same kind are ambiguous. */
static int find_xyz(const table *t, columns_kind kind, columns *out)
{
    const int is_magnetic = kind == COLUMNS_MAGNETOMETER;
    const sensor_range meant =
        is_magnetic ? (sensor_range){COLUMNS_OF_MAGNETOMETER, COLUMNS_OF_MAGNETOMETER}
                    : (sensor_range){COLUMNS_OF_ACCELEROMETER, COLUMNS_OF_ACCELEROMETER};
    int *index = &out->index[COLUMN_X];
    const int has_meant = find_set(t, 0, meant, index) < t->columns;
    const sensor_range either =
        !is_magnetic ? (sensor_range){has_meant ? COLUMNS_OF_ANY : COLUMNS_OF_MAGNETOMETER,
                                      COLUMNS_OF_ACCELEROMETER}
                     : (sensor_range){COLUMNS_OF_MAGNETOMETER, COLUMNS_OF_ANY};
    const unsigned first = find_set(t, 0, has_meant ? meant : either, index);

    if (first == t->columns ||
        (!is_magnetic && sensor_of(&headings[first]) == COLUMNS_OF_MAGNETOMETER &&
         has_key(t, "linearacceleration"))) {
        report_no_axes(t, kind);
        return EXIT_FILE;
    }
    for (unsigned i = 0; i < t->columns; i++) {
        if (has_sensor(&headings[i], either) && is_duplicate(t, i, index)) {
            message("%s:%lu: x, y and z are there twice ('%s' and '%s'): choose one set with "
                    "--columns, or delete the other",
                    t->name, t->line, headings[index[headings[i].axis]].name, headings[i].name);
            return EXIT_FILE;
        }
    }
    if (has_meant) {
        find_other_sensor(t, kind, out);
    }
    return EXIT_GOOD;
}

/* ---- the unit of x, y and z ---------------------------------------------------------------------- */

/* The unit of known kinds of logs whose headings do not state it. */
static reading_unit unit_of_system(const table *t, const heading *x)
{
    const char *key = x->key;

    if (strcmp(key, "accsmooth") == 0 || strcmp(key, "accadc") == 0) {
        return UNIT_COUNTS; /* blackbox_decode without --unit-acceleration */
    }
    if (strcmp(key, "fieldlinearacceleration") == 0 || is_of_ros(x)) {
        return UNIT_MS2; /* sensor_msgs/Imu of ROS; gravity is in it */
    }
    if (strcmp(key, "gf") == 0) {
        return UNIT_G; /* gFx: the g-force meter of Physics Toolbox */
    }
    if (strcmp(key, "acc") == 0 && has_key(t, "time") && has_key(t, "gyr")) {
        for (unsigned i = 0; i < t->columns; i++) {
            if (strcasecmp(headings[i].name, "TimeUS") == 0) {
                return UNIT_MS2; /* ArduPilot's IMU message */
            }
        }
    }
    return UNIT_UNKNOWN;
}

/* The topic of PX4 whose readings the calibration of the vehicle has corrected; null: none
 * (VehicleIMU.cpp, Publish()). */
static const char *find_corrected(const table *t, const heading *x)
{
    const int is_combined =
        strcmp(x->key, "accelerometer") == 0 && has_key(t, "accelerometertimestamprelative");
    const int is_filtered = strcmp(x->name, "xyz[0]") == 0 && has_key(t, "timestampsample");

    return is_combined ? "sensor_combined" : is_filtered ? "vehicle_acceleration" : NULL;
}

/* The same of a gyroscope. */
static double rate_unit_of_system(const heading *x)
{
    static const char *const radians[] = {"gyrorad", "angularvelocity", "fieldangularvelocity",
                                          "wrss", NULL};

    /* GyrX is ArduPilot's */
    return is_among(x->key, radians) || strcmp(x->name, "GyrX") == 0 ? 1 : 0;
}

/* Whether x, y and z are in a magnetometer's unit, so that G is gauss. */
static int is_magnetic(const columns *out)
{
    return out->seen.is_magnetometer || out->seen.sensor == COLUMNS_OF_MAGNETOMETER;
}

static int find_unit(const table *t, columns *out)
{
    const int *index = out->index;
    const heading *x = &headings[index[COLUMN_X]];

    for (unsigned i = COLUMN_Y; i <= COLUMN_Z; i++) {
        const heading *h = &headings[index[i]];
        if (h->unit != x->unit || h->magnetic != x->magnetic || h->states_unit != x->states_unit) {
            char one[TABLE_EXCERPT_MAX];
            char other[TABLE_EXCERPT_MAX];
            message("%s:%lu: '%s' and '%s' are in different units: convert one of them", t->name,
                    t->line, table_excerpt(t->field[index[COLUMN_X]], one),
                    table_excerpt(t->field[index[i]], other));
            return EXIT_FILE;
        }
    }
    out->seen.sensor = sensor_of(x);
    out->seen.corrected = find_corrected(t, x);
    out->seen.unit = is_magnetic(out) ? x->magnetic
                     : x->states_unit ? x->unit
                                      : unit_of_system(t, x);
    const int has_other_unit = out->seen.unit != UNIT_UNKNOWN && out->seen.unit != UNIT_COUNTS;
    out->seen.is_gyro =
        !has_other_unit && (x->rate_unit > 0 || sensor_of(x) == COLUMNS_OF_GYROSCOPE);
    if (out->seen.is_gyro) {
        out->seen.rate_unit = x->states_unit ? x->rate_unit : rate_unit_of_system(x);
    }
    out->seen.states_foreign_unit = x->states_unit && out->seen.unit == UNIT_UNKNOWN;
    out->seen.unit_from = out->seen.unit != UNIT_UNKNOWN ? UNIT_FROM_HEADER : UNIT_FROM_NONE;
    return EXIT_GOOD;
}

/* The unit of time in a field like "ms" or "(ms)". */
static double time_unit_of(const char *field)
{
    char bare[HEADING_NAME_MAX];

    field += strspn(field, "([");
    snprintf(bare, sizeof bare, "%.*s", (int)strcspn(field, ")]"), field);
    return unit_parse_time(bare);
}

/* A second header line, with units only, may follow. */
static void find_unit_row(table *t, columns *out)
{
    const int time = out->index[COLUMN_TIME];
    const int temperature = out->index[COLUMN_TEMPERATURE];
    reading_unit unit[3];

    if (headings[out->index[COLUMN_X]].states_unit || !table_peek(t)) {
        return;
    }
    for (unsigned i = COLUMN_X; i <= COLUMN_Z; i++) {
        const char *text = t->field[out->index[i]];
        const int is_unit =
            is_magnetic(out) ? unit_parse_magnetic(text, &unit[i]) : unit_parse(text, &unit[i]);
        if (!is_unit || unit[i] != unit[COLUMN_X]) {
            return; /* a row of data, valid or not */
        }
    }
    t->pending = 0;
    out->seen.unit_line = t->line;
    out->seen.unit = unit[COLUMN_X];
    out->seen.unit_from = UNIT_FROM_HEADER;
    if (time >= 0 && time_unit_of(t->field[time]) > 0) {
        out->per_second = time_unit_of(t->field[time]);
        out->is_time_unit_known = 1;
    }
    if (temperature >= 0 && unit_parse_temperature(t->field[temperature]).scale > 0) {
        out->degrees = unit_parse_temperature(t->field[temperature]);
    }
}

/* ---- the gyroscope ------------------------------------------------------------------------------ */

/* The first three columns of a gyroscope, if there is one. If there are several, it is unknown
 * which one belongs to the accelerometer, and the first is used. */
static void find_gyro(const table *t, columns *out)
{
    int *index = out->gyro;

    if (find_set(t, 0, (sensor_range){COLUMNS_OF_GYROSCOPE, COLUMNS_OF_GYROSCOPE}, index) ==
        t->columns) {
        index[0] = -1;
        return;
    }
    const heading *x = &headings[index[0]];
    out->seen.rate_unit = x->states_unit ? x->rate_unit : rate_unit_of_system(x);
    if (out->index[COLUMN_X] == index[0]) {
        index[0] = -1; /* --columns says that it is the accelerometer */
    }
}

/* x, y and z of a file with a gyroscope only. */
static int find_gyro_alone(const table *t, columns *out)
{
    find_gyro(t, out);
    if (out->gyro[0] < 0) {
        const int failure = find_xyz(t, COLUMNS_LOG, out);
        out->seen.rate_unit = failure ? 0 : headings[out->index[COLUMN_X]].rate_unit;
        return failure;
    }
    memcpy(out->index, out->gyro, sizeof out->gyro);
    return EXIT_GOOD;
}

/* ---- other columns ------------------------------------------------------------------------------ */

static int is_named(const heading *h, column which)
{
    static const char *const keys[COLUMN_COUNT][6] = {
        [COLUMN_SAMPLES] = {"n", "nsamples", "count"},
        [COLUMN_TIME] = {"t", "time", "timestamp", "elapsed", "elapsedtime", "timeelapsed"},
        [COLUMN_TEMPERATURE] = {"temperature", "temp", "tempc", "tempdegc", "temperaturec"},
        [COLUMN_ALPHA] = {"alpha", "alphadeg", "alpharad"},
        [COLUMN_BETA] = {"beta", "betadeg", "betarad"},
    };

    if (which >= COLUMN_STD_X && which <= COLUMN_STD_Z) {
        return h->axis == (int)which - COLUMN_STD_X && strcmp(h->key, "std") == 0;
    }
    for (unsigned i = 0; i < 6 && keys[which][i] && h->axis < 0; i++) {
        if (strcmp(h->key, keys[which][i]) == 0) {
            return 1;
        }
    }
    return 0;
}

static int report_ambiguous(const table *t, const char *name)
{
    message(
        "%s:%lu: more than one column could be '%s': delete one, or choose with --columns %s=NAME",
        t->name, t->line, name, name);
    return EXIT_FILE;
}

/* One std for all axes: its heading names no axis. */
static int find_std(const table *t, int *index)
{
    *index = -1;
    for (unsigned i = 0; i < t->columns; i++) {
        if (headings[i].axis >= 0 || strcmp(headings[i].key, "std") != 0) {
            continue;
        }
        if (*index >= 0) {
            return report_ambiguous(t, "std");
        }
        *index = (int)i;
    }
    return EXIT_GOOD;
}

/* Finds an optional column. */
static int find_optional(const table *t, column which, int *index)
{
    if (columns_option_has(which)) {
        return columns_option_find(t, headings, which, index);
    }
    *index = -1;
    for (unsigned i = 0; i < t->columns; i++) {
        if (!is_named(&headings[i], which)) {
            continue;
        }
        if (*index >= 0) {
            return report_ambiguous(t, column_name(which));
        }
        *index = (int)i;
    }
    return EXIT_GOOD;
}

/* The time unit if it is the name of the column: `millis`, and seconds_elapsed; else 0. */
static double unit_of_name_itself(const heading *h)
{
    if (strcmp(h->key, "secondselapsed") == 0) {
        return 1;
    }
    return strlen(h->key) > 1 && h->axis < 0 ? unit_parse_time(h->key) : 0;
}

/* Of two clocks, the one that states its unit is used. */
static int find_time(const table *t, columns *out)
{
    int *index = &out->index[COLUMN_TIME];
    unsigned count[2] = {0, 0}; /* without and with a unit */

    *index = -1;
    for (unsigned i = 0; i < t->columns; i++) {
        heading *h = &headings[i];
        h->per_second = unit_of_name_itself(h) > 0 ? unit_of_name_itself(h) : h->per_second;
        const int states = h->per_second > 0;
        if (is_named(h, COLUMN_TIME) || unit_of_name_itself(h) > 0) {
            *index = states >= (count[1] > 0) ? (int)i : *index;
            count[states]++;
        }
    }
    if (columns_option_has(COLUMN_TIME)) {
        return columns_option_find(t, headings, COLUMN_TIME, index);
    }
    return count[count[1] > 0] > 1 ? report_ambiguous(t, column_name(COLUMN_TIME)) : EXIT_GOOD;
}

/* ArduPilot's temperature is T, which would otherwise be a time. */
static void find_short_temperature(const table *t, columns *out)
{
    for (unsigned i = 0; i < t->columns && out->index[COLUMN_TEMPERATURE] < 0 &&
                         !columns_option_has(COLUMN_TEMPERATURE);
         i++) {
        if (strcmp(t->field[i], "T") == 0 && out->index[COLUMN_TIME] >= 0 &&
            out->index[COLUMN_TIME] != (int)i) {
            out->index[COLUMN_TEMPERATURE] = (int)i;
        }
    }
}

/* PX4 and Betaflight's explorer have microseconds without stating it; ROS and Kalibr
 * nanoseconds. */
static void find_time_unit(const table *t, columns *out)
{
    const int at = out->index[COLUMN_TIME];
    const int is_micro = has_key(t, "timestampsample") || has_key(t, "loopiteration") ||
                         has_key(t, "accelerometertimestamprelative") ||
                         (has_key(t, "deviceid") && has_key(t, "errorcount"));

    out->per_second = 1;
    if (at >= 0) {
        const double stated = headings[at].per_second;
        const int is_nano = t->field[at][0] == '%' || is_of_kalibr(t);
        out->per_second = stated > 0 ? stated : is_nano ? 1e9 : is_micro ? 1e6 : 1;
        out->is_time_unit_known = stated > 0 || is_nano || is_micro;
    }
}

/* Without a stated unit it is in degrees C; in an unknown unit, such as counts, it is ignored. */
static void find_temperature_unit(columns *out)
{
    int *at = &out->index[COLUMN_TEMPERATURE];

    out->degrees = (temperature_unit){1, 0};
    if (*at >= 0 && headings[*at].states_unit) {
        out->degrees = headings[*at].degrees;
        *at = out->degrees.scale > 0 ? *at : -1;
    }
}

/* Degrees, unless the heading says rad. */
static void find_angle_units(const table *t, columns *out)
{
    for (unsigned i = 0; i < 2; i++) {
        const int at = out->index[COLUMN_ALPHA + i];
        out->per_degree[i] = at >= 0 && strstr(t->field[at], "rad") ? RAD_PER_DEGREE : 1;
    }
}

/* ---- the whole table ---------------------------------------------------------------------------- */

static void remember_names(const table *t, columns *out)
{
    recognition *seen = &out->seen;
    unsigned used[TABLE_COLUMNS_MAX] = {0};

    for (unsigned c = 0; c < COLUMN_COUNT; c++) {
        seen->name[c][0] = '\0';
        if (out->index[c] >= 0) {
            memcpy(seen->name[c], headings[out->index[c]].name, HEADING_NAME_MAX);
            used[out->index[c]] = 1;
        }
    }
    for (unsigned i = 0; i < 3 && out->gyro[i] >= 0; i++) {
        memcpy(seen->gyro[i], headings[out->gyro[i]].name, HEADING_NAME_MAX);
        used[out->gyro[i]] = 1;
    }
    for (unsigned i = 0; i < t->columns; i++) {
        seen->ignored += !used[i] && *t->field[i] != '\0';
    }
    snprintf(seen->chosen, sizeof seen->chosen, "%s", columns_option_text());
    seen->header_line = t->first_line;
    seen->preamble = t->preamble;
}

/* Whether the header names x, y and z of any sensor. */
static int names_axes(const table *t)
{
    int index[3];

    read_headings(t);
    return find_set(t, 0, (sensor_range){COLUMNS_OF_GYROSCOPE, COLUMNS_OF_ACCELEROMETER}, index) <
           t->columns;
}

int columns_skip_text(table *t)
{
    return table_skip_text(t, names_axes);
}

/* ArduPilot interleaves the rows of all its sensors, with their number in column I. */
static int find_instance(const table *t)
{
    for (unsigned i = 0; i < t->columns && has_key(t, "gyr"); i++) {
        if (strcmp(t->field[i], "I") == 0) {
            return (int)i;
        }
    }
    return -1;
}

static int find_by_header(table *t, columns_kind kind, columns *out)
{
    int *index = out->index;
    int std;

    read_headings(t);
    int failure = columns_option_has(COLUMN_X)
                      ? columns_option_find_axes(t, headings, &index[COLUMN_X])
                  : kind == COLUMNS_GYRO ? find_gyro_alone(t, out)
                                         : find_xyz(t, kind, out);
    if (!failure && kind == COLUMNS_IMU) {
        find_gyro(t, out);
    }
    failure = failure ? failure : find_std(t, &std);
    failure = failure ? failure : find_unit(t, out);
    for (unsigned c = COLUMN_STD_X; c < COLUMN_COUNT && !failure; c++) {
        failure = c == COLUMN_TIME ? find_time(t, out) : find_optional(t, (column)c, &index[c]);
    }
    if (failure) {
        return failure;
    }
    if (index[COLUMN_STD_X] < 0 || index[COLUMN_STD_Y] < 0 || index[COLUMN_STD_Z] < 0) {
        /* unless all three exist, one column serves all axes */
        index[COLUMN_STD_X] = index[COLUMN_STD_Y] = index[COLUMN_STD_Z] = std;
    }
    for (unsigned c = COLUMN_STD_X; c <= COLUMN_SAMPLES && kind != COLUMNS_POSITIONS; c++) {
        index[c] = -1; /* a log has no means */
    }
    find_short_temperature(t, out);
    out->instance = find_instance(t);
    find_time_unit(t, out);
    find_temperature_unit(out);
    find_angle_units(t, out);
    remember_names(t, out);
    find_unit_row(t, out);
    return EXIT_GOOD;
}

/* The fraction of "0,05", split at its comma: no whole number begins with a zero. */
static int is_fraction(const char *text)
{
    return text[0] == '0' && text[1] != '\0' && strspn(text, "0123456789") == strlen(text);
}

static int is_cut_at_commas(const table *t)
{
    return t->separator == ',' && t->columns == 6 &&
           (is_fraction(t->field[1]) || is_fraction(t->field[3]) || is_fraction(t->field[5]));
}

/* The last three of six or seven columns. */
static void find_gyro_by_count(const table *t, columns_kind kind, columns *out)
{
    static const char *const names[] = {"gx", "gy", "gz"};
    const int has_gyro = t->columns > 5;

    for (unsigned i = 0; i < 3 && kind == COLUMNS_IMU && has_gyro; i++) {
        out->gyro[i] = (int)(t->columns - 3 + i);
        snprintf(out->seen.gyro[i], HEADING_NAME_MAX, "%s", names[i]);
    }
    for (unsigned i = 0; i < 3 && kind == COLUMNS_GYRO && has_gyro; i++) {
        out->index[COLUMN_X + i] = (int)(t->columns - 3 + i);
    }
    out->seen.ignored = has_gyro && kind != COLUMNS_IMU ? 3 : 0;
}

/* Which three of six or more columns are its own is not known without a header. */
static int report_unnamed_magnetometer(const table *t)
{
    message("%s:%lu: %u columns without a header: which are the magnetometer's? state them by "
            "number, such as --columns %u,%u,%u%s, or name them in a header",
            t->name, t->line, t->columns, t->columns - 2, t->columns - 1, t->columns,
            t->columns % 3 == 1 ? ",t=1" : "");
    return EXIT_FILE;
}

/* Without a header, the number of columns decides. In a layout, each letter is a column. */
static int find_by_count(const table *t, columns_kind kind, columns *out)
{
    static const char *const layouts[2][5] = {{"xyz", "xyzsn", "xyzabcn"},
                                              {"xyz", "txyz", "txyzT", "xyz...", "txyz..."}};
    static const char letters[] = "xyzabcntTAB"; /* in the order of `column`; '.': a rate */

    if (kind == COLUMNS_MAGNETOMETER && t->columns > 5 && !is_cut_at_commas(t)) {
        return report_unnamed_magnetometer(t);
    }
    for (unsigned i = 0; i < 5 && !is_cut_at_commas(t); i++) {
        const char *layout = layouts[kind != COLUMNS_POSITIONS][i];
        if (!layout || strlen(layout) != t->columns) {
            continue;
        }
        for (unsigned c = 0; c < COLUMN_COUNT; c++) {
            const char *place = strchr(layout, letters[c]);
            const int is_std = c >= COLUMN_STD_X && c <= COLUMN_STD_Z;
            const char *one = is_std && !place ? strchr(layout, 's') : NULL; /* for all axes */
            place = one ? one : place;
            out->index[c] = place ? (int)(place - layout) : -1;
            snprintf(out->seen.name[c], HEADING_NAME_MAX, "%s",
                     one     ? "std"
                     : place ? column_name((column)c)
                             : "");
        }
        find_gyro_by_count(t, kind, out);
        return EXIT_GOOD;
    }
    message("%s:%lu: %u column%s, separated by %s, without a header: expected are %s, or a header "
            "that names them; --columns 2,3,4 states x, y, z by number%s",
            t->name, t->line, t->columns, t->columns == 1 ? "" : "s", table_separator(t),
            kind == COLUMNS_POSITIONS
                ? "3 (x y z), 5 (x y z std n), 7 (x y z std_x std_y std_z n)"
                : "3 (x y z), 4 (t x y z), 5 (t x y z temperature), 6 or 7 (with a gyro's three)",
            t->separator == ',' && (t->columns == 6 || t->columns == 8)
                ? "; if these are decimal commas, save the table with decimal points"
                : "");
    return EXIT_FILE;
}

/* Without a header, by the numbers that --columns states. */
static int find_by_number(const table *t, columns *out)
{
    recognition *seen = &out->seen;

    if (!columns_option_has(COLUMN_X)) {
        message("%s:%lu: there is no header: --columns must state x, y and z, too", t->name,
                t->line);
        return EXIT_FILE;
    }
    int failure = columns_option_find_axes(t, headings, &out->index[COLUMN_X]);
    seen->ignored = t->columns;
    for (unsigned c = 0; c < COLUMN_COUNT && !failure; c++) {
        int *index = &out->index[c];
        *index = c > COLUMN_Z ? -1 : *index;
        if (columns_option_has((column)c)) {
            failure = columns_option_find(t, headings, (column)c, index);
        }
        if (*index >= 0) {
            snprintf(seen->name[c], HEADING_NAME_MAX, "%s", column_name((column)c));
            seen->ignored--;
        }
    }
    snprintf(seen->chosen, sizeof seen->chosen, "%s", columns_option_text());
    return failure;
}

/* Whether there are columns x, y and z, or --columns states them. */
static int has_axes(const table *t)
{
    int index[3];

    read_headings(t);
    return columns_option_has(COLUMN_X) ||
           find_set(t, 0, (sensor_range){COLUMNS_OF_MAGNETOMETER, COLUMNS_OF_ACCELEROMETER},
                    index) < t->columns;
}

int columns_find(table *t, columns_kind kind, columns *out)
{
    *out = (columns){.per_second = 1,
                     .degrees = {1, 0},
                     .per_degree = {1, 1},
                     .accelerometer = {-1, -1, -1},
                     .gyro = {-1, -1, -1},
                     .instance = -1,
                     .seen = {.separator = table_separator(t),
                              .text_lines = t->text_lines,
                              .is_magnetometer = kind == COLUMNS_MAGNETOMETER}};
    if (table_comment_header(t) && !has_axes(t)) {
        table_drop_header(t);
    }
    const int failure = t->has_header                    ? find_by_header(t, kind, out)
                        : *columns_option_text() != '\0' ? find_by_number(t, out)
                                                         : find_by_count(t, kind, out);

    if (kind == COLUMNS_GYRO) { /* its x, y and z, however they were found */
        memcpy(out->gyro, out->index, sizeof out->gyro);
    }
    for (unsigned c = 0; c < COLUMN_COUNT; c++) {
        out->last = out->index[c] > out->last ? out->index[c] : out->last;
    }
    for (unsigned i = 0; i < 3; i++) {
        out->last = out->accelerometer[i] > out->last ? out->accelerometer[i] : out->last;
        out->last = out->gyro[i] > out->last ? out->gyro[i] : out->last;
    }
    out->seen.time_unit = out->per_second > 1e8   ? "ns"
                          : out->per_second > 1e5 ? "µs"
                          : out->per_second > 1   ? "ms"
                                                  : "s";
    return failure;
}

void columns_warn_cut(const table *t, const char *which, unsigned long line)
{
    message("warning: %s:%lu: the %s line is cut off, and ignored", t->name, line, which);
}

int columns_is_cut(const table *t, const columns *where)
{
    return table_is_cut(t, (unsigned)where->last);
}

/* What to do about it, unless the problem itself says so. An optional column can be ignored;
 * without a header, by stating the others. Returns text. */
static const char *remedy(const table *t, const columns *where, column which, number_status status,
                          char text[COLUMNS_REMEDY_MAX])
{
    const int *index = where->index;
    const int is_time = which == COLUMN_TIME && status == NUMBER_NOT_DECIMAL;

    if (status == NUMBER_COMMA || status == NUMBER_GROUPED) {
        return "";
    }
    if (!is_time && which != COLUMN_TEMPERATURE) {
        return table_remedy(t);
    }
    snprintf(text, COLUMNS_REMEDY_MAX, ": %s, or ignore the column with --columns ",
             is_time ? "convert it to seconds" : "correct the line");
    if (t->has_header) {
        append(text, COLUMNS_REMEDY_MAX, "%s=none", column_name(which));
    } else {
        append(text, COLUMNS_REMEDY_MAX, "%d,%d,%d", index[COLUMN_X] + 1, index[COLUMN_Y] + 1,
               index[COLUMN_Z] + 1);
    }
    return text;
}

int columns_number(const table *t, const columns *where, column which, double *out)
{
    const int index = where->index[which];
    const number_status status = number_parse(t->field[index], out);
    char excerpt[TABLE_EXCERPT_MAX];
    char what[COLUMNS_REMEDY_MAX];

    if (which == COLUMN_TIME && status == NUMBER_NOT_DECIMAL && clock_parse(t->field[index], out)) {
        return EXIT_GOOD; /* in seconds, even if the heading states another unit */
    }
    if (status == NUMBER_EMPTY) {
        message("%s:%lu: column %d (%s) is empty%s", t->name, t->line, index + 1,
                column_name(which), remedy(t, where, which, status, what));
        return EXIT_FILE;
    }
    if (status != NUMBER_OK) {
        message("%s:%lu: column %d (%s): '%s' %s%s", t->name, t->line, index + 1,
                column_name(which), table_excerpt(t->field[index], excerpt), number_problem(status),
                remedy(t, where, which, status, what));
        return EXIT_FILE;
    }
    if (which == COLUMN_TIME) {
        *out /= where->per_second;
    } else if (which == COLUMN_TEMPERATURE) {
        *out = where->degrees.scale * *out + where->degrees.zero;
    }
    return EXIT_GOOD;
}

int columns_gyro(const table *t, const columns *where, double out[3])
{
    char excerpt[TABLE_EXCERPT_MAX];

    for (unsigned i = 0; i < 3; i++) {
        const number_status status = number_parse(t->field[where->gyro[i]], &out[i]);
        if (status != NUMBER_OK) {
            message("%s:%lu: column %d (gyroscope's %c): '%s' %s; --accelerometer-only ignores the "
                    "gyroscope",
                    t->name, t->line, where->gyro[i] + 1, "xyz"[i],
                    table_excerpt(t->field[where->gyro[i]], excerpt),
                    status == NUMBER_EMPTY ? "is empty" : number_problem(status));
            return EXIT_FILE;
        }
    }
    return EXIT_GOOD;
}

double columns_angle(const table *t, const columns *where, column which)
{
    const int index = where->index[which];
    double value;

    return index >= 0 && number_parse(t->field[index], &value) == NUMBER_OK
               ? value / where->per_degree[which - COLUMN_ALPHA]
               : NUMBER_UNKNOWN;
}

double columns_accelerometer(const table *t, const columns *where, unsigned axis)
{
    const int index = where->accelerometer[axis];
    double value;

    return index >= 0 && number_parse(t->field[index], &value) == NUMBER_OK ? value
                                                                            : NUMBER_UNKNOWN;
}

int columns_check_instance(const table *t, columns *where)
{
    const char *here = where->instance >= 0 ? t->field[where->instance] : "";

    if (where->first_instance[0] == '\0') {
        snprintf(where->first_instance, sizeof where->first_instance, "%s", here);
    }
    if (strncmp(where->first_instance, here, sizeof where->first_instance - 1) != 0) {
        message(
            "%s:%lu: column %d (I): the rows of several sensors are interleaved: keep those of one",
            t->name, t->line, where->instance + 1);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

/* ---- text --------------------------------------------------------------------------------------- */

static void append_layout(const recognition *seen, char *text, size_t size)
{
    const int is_csv =
        strcmp(seen->separator, "commas") == 0 || strcmp(seen->separator, "semicolons") == 0;

    append(text, size, "%s with %s", is_csv ? "CSV" : "table", seen->separator);
    if (seen->preamble > 0) {
        append(text, size, ", %lu line%s of settings", seen->preamble,
               seen->preamble == 1 ? "" : "s");
    }
    if (seen->text_lines > 0) {
        append(text, size, ", %lu line%s of text before the %s ignored", seen->text_lines,
               seen->text_lines == 1 ? "" : "s", seen->header_line > 0 ? "header" : "readings");
    }
    if (seen->header_line > 0) {
        append(text, size, ", header in line %lu", seen->header_line);
    } else {
        append(text, size, ", no header");
    }
    if (seen->unit_line > 0) {
        append(text, size, ", units in line %lu", seen->unit_line);
    }
}

static void append_unit(const recognition *seen, char *text, size_t size)
{
    const int is_turn = seen->is_gyro && seen->rate_unit > 0;
    static const char *const origin_text[] = {[UNIT_FROM_NONE] = "",
                                              [UNIT_FROM_HEADER] = "",
                                              [UNIT_FROM_OPTION] = " (--unit)",
                                              [UNIT_FROM_SIZE] = " (by their size)",
                                              [UNIT_FROM_SENSOR] = " (--sensor)"};

    if (is_turn || seen->unit != UNIT_UNKNOWN) {
        append(text, size, " in %s%s",
               is_turn ? unit_angular_rate_words(seen->rate_unit) : unit_words(seen->unit),
               origin_text[seen->unit_from]);
    }
}

const char *columns_describe(const recognition *seen, char *text, size_t size)
{
    const char(*name)[HEADING_NAME_MAX] = seen->name;

    text[0] = '\0';
    append_layout(seen, text, size);
    append(text, size, "; ");
    if (*name[COLUMN_TIME] != '\0') {
        append(text, size, "%s (%s), ", name[COLUMN_TIME], seen->time_unit);
    }
    append(text, size, "%s%s %s %s",
           seen->is_gyro                 ? "the gyroscope's "
           : *seen->other_sensor == '\0' ? ""
           : seen->is_magnetometer       ? "the magnetometer's "
                                         : "the accelerometer's ",
           name[COLUMN_X], name[COLUMN_Y], name[COLUMN_Z]);
    append_unit(seen, text, size);
    if (*seen->chosen != '\0') {
        append(text, size, " (--columns %s)", seen->chosen);
    }
    for (unsigned c = COLUMN_STD_X; c < COLUMN_COUNT; c++) {
        const int is_again = c > COLUMN_STD_X && c <= COLUMN_STD_Z &&
                             strcmp(name[c], name[c - 1]) == 0; /* one for all three */
        if (c != COLUMN_TIME && *name[c] != '\0' && !is_again) {
            append(text, size, ", %s", name[c]);
        }
    }
    if (*seen->gyro[0] != '\0') {
        append(text, size, "; gyroscope: %s %s %s%s%s", seen->gyro[0], seen->gyro[1], seen->gyro[2],
               seen->rate_unit > 0 ? " in " : "",
               seen->rate_unit > 0 ? unit_angular_rate_words(seen->rate_unit) : "");
    }
    if (seen->ignored > 0) {
        append(text, size, "; ignored: %u other column%s", seen->ignored,
               seen->ignored == 1 ? "" : "s");
    }
    if (*seen->other_sensor != '\0') {
        append(text, size, ", including %s's (%s ..; --columns chooses)",
               seen->is_magnetometer ? "an accelerometer" : "a magnetometer", seen->other_sensor);
    }
    return plain(text);
}
