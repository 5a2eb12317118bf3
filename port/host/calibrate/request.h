/* SPDX-License-Identifier: MIT
 *
 * calibrate/request.h: the command lines of `invcal calibrate` and `invcal watch`, read and
 * checked.
 */
#ifndef CALIBRATE_REQUEST_H
#define CALIBRATE_REQUEST_H

#include "cli/options.h"
#include "cli/unit_style.h"
#include "fit/case_frame.h"
#include "fit/fit.h"
#include "fit/gyro.h"
#include "fit/sensors.h"
#include "fit/thermal_fit.h"
#include "result/record.h"
#include "stand/stand.h"
#include "text/unit.h"

/* The options of both commands: each accepts those of the other, to say which command they belong
 * to. */
enum {
    OPT_COLUMNS,
    OPT_POSITIONS,
    OPT_GRAVITY,
    OPT_LATITUDE,
    OPT_HEIGHT,
    OPT_FRAME,
    OPT_CASE,
    OPT_ZERO,
    OPT_LSB,
    OPT_NOMINAL,
    OPT_NOMINAL_NAME,
    OPT_SENSOR,
    OPT_UNIT,
    OPT_UNITS,
    OPT_NOISE,
    OPT_PRIOR,
    OPT_SIX_FACES,
    OPT_MAGNETOMETER,
    OPT_WITH,
    OPT_THERMAL,
    OPT_SLOPE,
    OPT_RATE,
    OPT_GYRO,
    OPT_GYRO_LSB,
    OPT_GYRO_AXES,
    OPT_ACCELEROMETER_ONLY,
    OPT_CLIP,
    OPT_ROBUST,
    OPT_QUADRATIC,
    OPT_CUBIC,
    OPT_STAND,
    OPT_STAND_SENSE,
    OPT_STAND_ZERO,
    OPT_PLAN,
    OPT_TARGET,
    OPT_MEAN_SIGMA,
    OPT_ALLAN,
    OPT_KEEP_ALL,
    OPT_TOLERANCE,
    OPT_NEED,
    OPT_STRICT,
    OPT_DEVICE,
    OPT_SERIAL,
    OPT_OPERATOR,
    OPT_DATE,
    OPT_NOTE,
    OPT_OUT,
    OPT_REPORT,
    OPT_JSON,
    OPT_JSON_LINES,
    OPT_QUIET,
    OPT_COUNT
};

#define REQUEST_COMMAND_MAX 2000u

typedef struct {
    const option_syntax *syntax; /* of the command: calibrate or watch */
    int is_live;                 /* watch */
    const char *file;
    const char *value[OPT_COUNT]; /* as given; null: not given */
    double zero[3];               /* --zero */
    double lsb[3];                /* --lsb */
    sensor_choice sensor; /* --sensor: zero and scale where those options do not state them */
    double rate;          /* 0: not given */
    double clip[2];
    reading_unit unit; /* --unit */
    unit_style units;  /* --units */
    double target[3];
    double need;            /* field units; 0: not given */
    display_unit need_unit; /* the unit that it was stated in */
    double mean_sigma;
    double tolerance[3];
    char command[REQUEST_COMMAND_MAX]; /* the command line, for the report */
    double place[2];                   /* latitude, height */
    reading_unit field_unit;           /* as stated, for a magnetometer only */
    double field_sigma; /* standard deviation of the length of the field, field units */
    thermal_options thermal;
    gyro_options gyro;
    const design *program; /* --plan, which watch follows; or null */
    unsigned degree;       /* 2: --quadratic, 3: --cubic, else 0 */
    stand_options stand;
    case_axes up_axes;            /* --case; count 0: not given */
    int wants_accelerometer_axes; /* --frame accelerometer, for a magnetometer */
    record record;
    fit_settings settings; /* nominal is set later, as is noise unless stated */
} request;

/* Reads the command line. Returns EXIT_GOOD; EXIT_USAGE or EXIT_FILE after a message. */
int request_read(int argc, char **argv, int is_live, request *r);

/* Prints what is wrong with an option (OPT_...). Returns EXIT_USAGE. */
int request_usage(const request *r, unsigned which, const char *what);

#endif
