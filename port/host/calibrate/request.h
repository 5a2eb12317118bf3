/* SPDX-License-Identifier: MIT
 *
 * calibrate/request.h: what is asked of `invcal calibrate` and `invcal watch`, read from the command line
 * and checked.
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

/* The options of `invcal calibrate` and `invcal watch`: each takes what the other has, or says whose it is. */
enum {
    ASK_COLUMNS,
    ASK_POSITIONS,
    ASK_GRAVITY,
    ASK_LATITUDE,
    ASK_HEIGHT,
    ASK_FRAME,
    ASK_CASE,
    ASK_ZERO,
    ASK_LSB,
    ASK_NOMINAL,
    ASK_NOMINAL_NAME,
    ASK_SENSOR,
    ASK_UNIT,
    ASK_UNITS,
    ASK_NOISE,
    ASK_PRIOR,
    ASK_SIX_FACES,
    ASK_MAGNETOMETER,
    ASK_WITH,
    ASK_THERMAL,
    ASK_SLOPE,
    ASK_RATE,
    ASK_GYRO,
    ASK_GYRO_LSB,
    ASK_GYRO_AXES,
    ASK_ACCELEROMETER_ONLY,
    ASK_CLIP,
    ASK_ROBUST,
    ASK_QUADRATIC,
    ASK_CUBIC,
    ASK_STAND,
    ASK_STAND_SENSE,
    ASK_STAND_ZERO,
    ASK_PLAN,
    ASK_TARGET,
    ASK_MEAN_SIGMA,
    ASK_ALLAN,
    ASK_KEEP_ALL,
    ASK_TOLERANCE,
    ASK_NEED,
    ASK_STRICT,
    ASK_DEVICE,
    ASK_SERIAL,
    ASK_OPERATOR,
    ASK_DATE,
    ASK_NOTE,
    ASK_OUT,
    ASK_REPORT,
    ASK_JSON,
    ASK_JSON_LINES,
    ASK_QUIET,
    ASK_OPTIONS
};

#define REQUEST_COMMAND_MAX 2000u

/* What the command line asks for. */
typedef struct {
    const option_syntax *syntax; /* of the command: calibrate or watch */
    int is_live;                 /* watch */
    const char *file;
    const char *value[ASK_OPTIONS]; /* as it was given; null: it was not */
    double zero[3];                 /* of --zero, */
    double lsb[3];                  /* --lsb */
    sensor_choice sensor;           /* of --sensor, for what they do not state */
    double rate;                    /* 0: not given */
    double clip[2];
    reading_unit unit; /* of --unit, */
    unit_style units;  /* --units */
    double target[3];
    double need;            /* field units; 0: not given */
    display_unit need_unit; /* what it was stated in */
    double mean_sigma;
    double tolerance[3];
    char command[REQUEST_COMMAND_MAX]; /* the command line, for the report */
    double place[2];                   /* latitude, height */
    reading_unit field_unit;           /* as stated; of a magnetometer alone */
    double field_sigma; /* what the length of the field may be wrong by, field units */
    thermal_options thermal;
    gyro_options gyro;
    const design *program; /* of --plan, which watch follows; or null */
    unsigned degree;       /* of --quadratic, --cubic; else 0 */
    stand_wish stand;
    case_axes ways_up;            /* of --case; none: its count is 0 */
    int wants_accelerometer_axes; /* of --frame, for a magnetometer */
    record record;
    fit_settings settings; /* all but the nominal, and the noise unless stated */
} request;

/* Reads it. Returns EXIT_GOOD; EXIT_USAGE or EXIT_FILE after a message. */
int request_read(int argc, char **argv, int is_live, request *r);

/* Says what is wrong with an option (ASK_...). Returns EXIT_USAGE. */
int request_usage(const request *r, unsigned which, const char *what);

#endif
