/* SPDX-License-Identifier: MIT */
#include "calibrate/request.h"

#include <math.h>
#include <string.h>

#include "invcal/positions.h"
#include "cli/command.h"
#include "cli/input.h"
#include "cli/files.h"
#include "cli/message.h"
#include "cli/output.h"
#include "design/design.h"
#include "fit/gravity.h"
#include "read/columns_option.h"
#include "read/samples.h"
#include "result/need.h"
#include "result/result.h"
#include "text/append.h"

static const option options[OPT_COUNT] = {
    [OPT_COLUMNS] = {"--columns", 1},
    [OPT_POSITIONS] = {"--positions", 0},
    [OPT_GRAVITY] = {"--gravity", 1},
    [OPT_LATITUDE] = {"--latitude", 1},
    [OPT_HEIGHT] = {"--height", 1},
    [OPT_FRAME] = {"--frame", 1},
    [OPT_CASE] = {"--case", 1},
    [OPT_ZERO] = {"--zero", 1},
    [OPT_LSB] = {"--lsb", 1},
    [OPT_NOMINAL] = {"--nominal", 1},
    [OPT_NOMINAL_NAME] = {"--nominal-name", 1},
    [OPT_SENSOR] = {"--sensor", 1},
    [OPT_UNIT] = {"--unit", 1},
    [OPT_UNITS] = {"--units", 1},
    [OPT_NOISE] = {"--noise", 1},
    [OPT_PRIOR] = {"--prior", 1},
    [OPT_SIX_FACES] = {"--six-faces", 0},
    [OPT_MAGNETOMETER] = {"--magnetometer", 0},
    [OPT_WITH] = {"--with", 1},
    [OPT_THERMAL] = {"--thermal", 1},
    [OPT_SLOPE] = {"--slope", 1},
    [OPT_RATE] = {"--rate", 1},
    [OPT_GYRO] = {"--gyro", 1},
    [OPT_GYRO_LSB] = {"--gyro-lsb", 1},
    [OPT_GYRO_AXES] = {"--gyro-axes", 1},
    [OPT_ACCELEROMETER_ONLY] = {"--accelerometer-only", 0},
    [OPT_CLIP] = {"--clip", 1},
    [OPT_ROBUST] = {"--robust", 0},
    [OPT_QUADRATIC] = {"--quadratic", 0},
    [OPT_CUBIC] = {"--cubic", 0},
    [OPT_STAND] = {"--stand", 0},
    [OPT_STAND_SENSE] = {"--stand-sense", 1},
    [OPT_STAND_ZERO] = {"--stand-zero", 1},
    [OPT_PLAN] = {"--plan", 1},
    [OPT_TARGET] = {"--target", 1},
    [OPT_MEAN_SIGMA] = {"--mean-sigma", 1},
    [OPT_ALLAN] = {"--allan", 1},
    [OPT_KEEP_ALL] = {"--keep-all", 0},
    [OPT_TOLERANCE] = {"--tolerance", 1},
    [OPT_NEED] = {"--need", 1},
    [OPT_STRICT] = {"--strict", 0},
    [OPT_DEVICE] = {"--device", 1},
    [OPT_SERIAL] = {"--serial", 1},
    [OPT_OPERATOR] = {"--operator", 1},
    [OPT_DATE] = {"--date", 1},
    [OPT_NOTE] = {"--note", 1},
    [OPT_OUT] = {"--out", 1},
    [OPT_REPORT] = {"--report", 1},
    [OPT_JSON] = {"--json", 0},
    [OPT_JSON_LINES] = {"--json-lines", 0},
    [OPT_QUIET] = {"--quiet", 0},
};
static const char *const operands[] = {"LOG"};
static const option_syntax calibrate_syntax = {"calibrate", options, OPT_COUNT, operands, 1, 0};
static const option_syntax watch_syntax = {"watch", options, OPT_COUNT, operands, 1, 0};

#define ON_EARTH 0.0027    /* of g, from the equator to the poles */
#define LIMIT_MAX 0.5      /* of --tolerance: no sensor needs more */
#define LIMITS_MAX 400     /* longer than any limits that make sense */
#define NEED_MAX_RATIO 0.1 /* of --need to the field */

/* Too large for the stack. */
static design stated_plan;

int request_usage(const request *r, unsigned which, const char *what)
{
    return message_usage(r->syntax->command, "%s: %s", options[which].name, what);
}

/* A magnetometer has no positions, and a field of any length. */
static int read_magnetometer(request *r)
{
    static const unsigned others[] = {
        OPT_POSITIONS, OPT_LATITUDE,  OPT_HEIGHT,   OPT_CASE,     OPT_UNIT,   OPT_NOISE,
        OPT_PRIOR,     OPT_SIX_FACES, OPT_THERMAL,  OPT_CLIP,     OPT_ROBUST, OPT_QUADRATIC,
        OPT_CUBIC,     OPT_STAND,     OPT_PLAN,     OPT_KEEP_ALL, OPT_SENSOR, OPT_MEAN_SIGMA,
        OPT_ALLAN,     OPT_GYRO,      OPT_GYRO_LSB, OPT_GYRO_AXES};

    if (!r->value[OPT_MAGNETOMETER]) {
        return r->value[OPT_WITH] ? request_usage(r, OPT_WITH, "needs --magnetometer")
               : r->wants_accelerometer_axes
                   ? request_usage(r, OPT_FRAME, "accelerometer needs --magnetometer")
                   : EXIT_GOOD;
    }
    for (unsigned i = 0; i < sizeof others / sizeof others[0]; i++) {
        if (r->value[others[i]]) {
            return message_usage(r->syntax->command,
                                 "%s: cannot be combined with %s: leave one out",
                                 options[OPT_MAGNETOMETER].name, options[others[i]].name);
        }
    }
    if (!r->value[OPT_GRAVITY]) {
        r->settings.field = 1;
        r->field_sigma = 0;
    }
    return EXIT_GOOD;
}

/* Normal gravity at a place. */
static int read_place(request *r)
{
    int failure = EXIT_GOOD;

    if (r->value[OPT_GRAVITY]) {
        return request_usage(r, OPT_LATITUDE, "states the field: leave out --gravity");
    }
    failure =
        options_numbers(r->syntax, OPT_LATITUDE, r->value[OPT_LATITUDE], 1, &r->place[0], NULL);
    if (!failure && r->value[OPT_HEIGHT]) {
        failure =
            options_numbers(r->syntax, OPT_HEIGHT, r->value[OPT_HEIGHT], 1, &r->place[1], NULL);
    }
    if (failure) {
        return failure;
    }
    r->settings.field = gravity_at(r->place[0], r->place[1]);
    r->field_sigma = GRAVITY_SIGMA;
    if (isnan(r->settings.field)) {
        return fabs(r->place[0]) <= 90
                   ? request_usage(r, OPT_HEIGHT, "must be -500 to 10000 m above sea level")
                   : request_usage(r, OPT_LATITUDE, "must be -90 to 90 degrees");
    }
    return EXIT_GOOD;
}

/* Cuts the unit of a magnetic field off a number: 48.5uT. */
static void split_unit(char *text, reading_unit *unit)
{
    char *end = text + strlen(text);

    while (end > text && !strchr("0123456789.", end[-1])) {
        end--;
    }
    if (end > text && *end != '\0' && unit_parse_magnetic(end, unit) && *unit != UNIT_COUNTS) {
        *end = '\0';
    }
}

/* G, or G with its standard deviation: 9.80665+-0.027, or with ±. */
static int read_field(request *r)
{
    static const char *const signs[] = {"+-", "±"};
    char text[128]; /* any longer text is invalid */
    char length[64];

    snprintf(text, sizeof text, "%s", r->value[OPT_GRAVITY]);
    if (r->value[OPT_MAGNETOMETER]) {
        split_unit(text, &r->field_unit);
    }
    r->field_sigma = 0;
    for (unsigned i = 0; i < 2; i++) {
        const char *sign = strstr(text, signs[i]);
        if (sign && (size_t)(sign - text) < sizeof length) {
            snprintf(length, sizeof length, "%.*s", (int)(sign - text), text);
            const int failure = options_numbers(r->syntax, OPT_GRAVITY, sign + strlen(signs[i]), 1,
                                                &r->field_sigma, NULL);
            return failure ? failure
                           : options_numbers(r->syntax, OPT_GRAVITY, length, 1, &r->settings.field,
                                             NULL);
        }
    }
    return options_numbers(r->syntax, OPT_GRAVITY, text, 1, &r->settings.field, NULL);
}

static int read_gravity(request *r)
{
    int failure = EXIT_GOOD;

    if (r->value[OPT_LATITUDE]) {
        return read_place(r);
    }
    if (r->value[OPT_HEIGHT]) {
        return request_usage(r, OPT_HEIGHT, "needs --latitude");
    }
    r->settings.field = 9.80665;
    r->field_sigma = ON_EARTH * r->settings.field;
    if (r->value[OPT_GRAVITY]) {
        failure = read_field(r);
    }
    if (!failure && !(r->settings.field > 0)) {
        failure = request_usage(r, OPT_GRAVITY, "the length of the field must be above 0");
    }
    if (!failure && !(r->field_sigma >= 0 && r->field_sigma < r->settings.field)) {
        failure = request_usage(
            r, OPT_GRAVITY,
            "the standard deviation must not be negative, and must be below the length");
    }
    return failure;
}

static int read_frame(request *r)
{
    const char *name = r->value[OPT_FRAME] ? r->value[OPT_FRAME] : "symmetric";

    r->settings.is_triangular = strcmp(name, "triangular") == 0;
    r->stand.is_frame = strcmp(name, "stand") == 0;
    r->wants_accelerometer_axes = strcmp(name, "accelerometer") == 0;
    return r->settings.is_triangular || r->stand.is_frame || r->wants_accelerometer_axes ||
                   strcmp(name, "symmetric") == 0
               ? EXIT_GOOD
               : request_usage(r, OPT_FRAME,
                               "must be symmetric, triangular or stand; for a magnetometer also "
                               "accelerometer");
}

/* The axes of the case that pointed up. */
static int read_case(request *r)
{
    if (!r->value[OPT_CASE]) {
        return EXIT_GOOD;
    }
    if (r->value[OPT_FRAME]) {
        return request_usage(r, OPT_CASE, "determines the frame: leave out --frame");
    }
    if (r->value[OPT_THERMAL]) {
        return request_usage(r, OPT_CASE,
                             "cannot be combined with --thermal: leave out --case, or calibrate at "
                             "one temperature without --thermal");
    }
    return case_parse(r->value[OPT_CASE], &r->up_axes)
               ? EXIT_GOOD
               : request_usage(r, OPT_CASE,
                               "give the axis of the case that pointed up in each of the first "
                               "positions, such as +z,-x,.,+y; a dot where unknown");
}

static int read_nominal(request *r)
{
    int failure = EXIT_GOOD;
    int single = 0;

    if (r->value[OPT_NOMINAL] && (r->value[OPT_ZERO] || r->value[OPT_LSB])) {
        return request_usage(r, OPT_NOMINAL, "states zero and scale: leave out --zero and --lsb");
    }
    if (r->value[OPT_NOMINAL_NAME] && strlen(r->value[OPT_NOMINAL_NAME]) > CALIBRATE_NAME_MAX) {
        return request_usage(r, OPT_NOMINAL_NAME, "must be a word of at most 14 bytes");
    }
    if (r->value[OPT_ZERO]) {
        failure = options_numbers(r->syntax, OPT_ZERO, r->value[OPT_ZERO], 3, r->zero, NULL);
    }
    if (!failure && r->value[OPT_LSB]) {
        failure = options_numbers(r->syntax, OPT_LSB, r->value[OPT_LSB], 3, r->lsb, &single);
        r->lsb[1] = single ? r->lsb[0] : r->lsb[1];
        r->lsb[2] = single ? r->lsb[0] : r->lsb[2];
    }
    for (unsigned i = 0; i < 3 && !failure && r->value[OPT_LSB]; i++) {
        failure =
            fabs(r->lsb[i]) > 0 ? EXIT_GOOD : request_usage(r, OPT_LSB, "a scale must not be 0");
    }
    return failure;
}

/* The data sheet, for what no other option states. */
static int read_sensor(request *r)
{
    char text[SENSORS_TEXT_MAX];

    if (!r->value[OPT_SENSOR]) {
        return EXIT_GOOD;
    }
    if (r->value[OPT_NOMINAL]) {
        return request_usage(r, OPT_SENSOR,
                             "and --nominal both state zero and scale: leave one out");
    }
    if (!sensors_choose(r->value[OPT_SENSOR], &r->sensor, text)) {
        return request_usage(r, OPT_SENSOR, text);
    }
    return unit_scale(UNIT_G, r->settings.field) > 0
               ? EXIT_GOOD
               : request_usage(r, OPT_SENSOR,
                               "is an accelerometer, but the field (--gravity) is not gravity in "
                               "m/s2, g or mg");
}

/* The command line states zero and scale, whatever the file says. */
static int states_nominal(const request *r)
{
    return r->value[OPT_NOMINAL] || r->value[OPT_SENSOR] ||
           (r->value[OPT_ZERO] && r->value[OPT_LSB]) || unit_scale(r->unit, r->settings.field) > 0;
}

static int read_unit(request *r)
{
    if (r->value[OPT_UNIT] && !unit_parse(r->value[OPT_UNIT], &r->unit)) {
        return message_usage(r->syntax->command, "--unit %s: must be g, mg, m/s2 or counts",
                             r->value[OPT_UNIT]);
    }
    if (r->value[OPT_UNITS] && !unit_style_parse(r->value[OPT_UNITS], &r->units)) {
        return message_usage(r->syntax->command, "--units %s: must be everyday or ins",
                             r->value[OPT_UNITS]);
    }
    return EXIT_GOOD;
}

static int read_noise(request *r)
{
    int failure = EXIT_GOOD;

    if (r->value[OPT_NOISE]) {
        failure =
            options_numbers(r->syntax, OPT_NOISE, r->value[OPT_NOISE], 1, &r->settings.noise, NULL);
        if (!failure && !(r->settings.noise > 0)) {
            failure = request_usage(r, OPT_NOISE, "the standard deviation must be above 0");
        }
        r->settings.noise /= r->settings.field;
    }
    return failure;
}

/* A prior on the angles alone: that of a data sheet, or of --prior 0,0,G. */
static int read_six_faces(request *r)
{
    static const unsigned others[] = {OPT_ROBUST, OPT_QUADRATIC, OPT_CUBIC, OPT_THERMAL};
    double sigma[3] = {0, 0, INVCAL_CROSS_AXIS};
    int failure = EXIT_GOOD;

    for (unsigned i = 0; i < sizeof others / sizeof others[0]; i++) {
        if (r->value[others[i]]) {
            return message_usage(r->syntax->command,
                                 "%s: cannot be combined with %s: leave one out",
                                 options[OPT_SIX_FACES].name, options[others[i]].name);
        }
    }
    if (r->value[OPT_PRIOR]) {
        failure = options_numbers(r->syntax, OPT_PRIOR, r->value[OPT_PRIOR], 3, sigma, NULL);
    }
    if (!failure && (fabs(sigma[0]) + fabs(sigma[1]) > 0 || !(sigma[2] > 0 && sigma[2] < 1))) {
        failure = request_usage(r, OPT_PRIOR,
                                "with --six-faces, only the angles: 0,0,G with G from 0 to 1");
    }
    r->settings.is_six_faces = 1;
    for (unsigned p = INVCAL_GAMMA_XY; p < INVCAL_PARAMETERS; p++) {
        r->settings.prior[p] = sigma[2];
    }
    return failure;
}

static int read_prior(request *r)
{
    double sigma[3]; /* of each delta, dk, gamma */
    int failure = EXIT_GOOD;

    if (r->value[OPT_SIX_FACES] || !r->value[OPT_PRIOR]) {
        return r->value[OPT_SIX_FACES] ? read_six_faces(r) : EXIT_GOOD;
    }
    if (!states_nominal(r)) {
        return request_usage(r, OPT_PRIOR,
                             "needs the nominal calibration: state --sensor, --unit, --zero and "
                             "--lsb, or --nominal");
    }
    failure = options_numbers(r->syntax, OPT_PRIOR, r->value[OPT_PRIOR], 3, sigma, NULL);
    for (unsigned p = 0; p < INVCAL_PARAMETERS && !failure; p++) {
        r->settings.prior[p] = sigma[p / 3];
        failure = sigma[p / 3] >= 0
                      ? EXIT_GOOD
                      : request_usage(r, OPT_PRIOR, "a standard deviation must not be negative");
    }
    return failure;
}

static int read_thermal(request *r)
{
    double degree = 0;
    int failure = EXIT_GOOD;

    r->thermal.keep_all = r->value[OPT_KEEP_ALL] != NULL;
    if (r->value[OPT_THERMAL]) {
        failure = options_numbers(r->syntax, OPT_THERMAL, r->value[OPT_THERMAL], 1, &degree, NULL);
        r->thermal.degree = degree >= 2 ? 2 : 1;
        if (!failure && fabs(degree - r->thermal.degree) > 0) {
            failure = request_usage(r, OPT_THERMAL, "must be 1 (slopes) or 2 (parabolas)");
        }
    }
    if (!failure && r->value[OPT_SLOPE]) {
        failure = r->value[OPT_THERMAL] ? options_numbers(r->syntax, OPT_SLOPE, r->value[OPT_SLOPE],
                                                          3, r->thermal.slope, NULL)
                                        : request_usage(r, OPT_SLOPE, "needs --thermal");
        for (unsigned i = 0; i < 3 && !failure; i++) {
            failure =
                r->thermal.slope[i] >= 0
                    ? EXIT_GOOD
                    : request_usage(r, OPT_SLOPE, "a standard deviation must not be negative");
        }
    }
    return failure;
}

/* Options of logs of samples. */
static int read_log_options(request *r)
{
    int failure = columns_option_parse(r->syntax->command, r->value[OPT_COLUMNS]);

    if (r->value[OPT_THERMAL]) {
        columns_option_require(COLUMN_TEMPERATURE);
    }
    if (!failure && r->value[OPT_POSITIONS] && (r->value[OPT_RATE] || r->value[OPT_CLIP])) {
        return request_usage(r, r->value[OPT_RATE] ? OPT_RATE : OPT_CLIP,
                             "needs samples: leave out --positions");
    }
    if (!failure && r->value[OPT_RATE]) {
        failure = options_numbers(r->syntax, OPT_RATE, r->value[OPT_RATE], 1, &r->rate, NULL);
        if (!failure && !(r->rate >= SAMPLES_RATE_MIN && r->rate <= SAMPLES_RATE_MAX)) {
            failure = request_usage(r, OPT_RATE, "must be 8 to 8000 samples per second");
        }
    }
    if (!failure && r->value[OPT_CLIP]) {
        failure = options_numbers(r->syntax, OPT_CLIP, r->value[OPT_CLIP], 2, r->clip, NULL);
        if (!failure && !(r->clip[0] < r->clip[1])) {
            failure = request_usage(r, OPT_CLIP, "the lower limit must come first");
        }
    }
    return failure;
}

/* "y,-x,z" */
static int parse_axes(const char *text, int8_t axes[3])
{
    unsigned seen = 0;

    for (unsigned i = 0; i < 3; i++) {
        const int is_negative = *text == '-';
        text += is_negative || *text == '+';
        const int axis = *text >= 'x' && *text <= 'z' ? *text++ - 'x' : -1;
        if (axis < 0 || *text != (i < 2 ? ',' : '\0')) {
            return 0;
        }
        text += i < 2;
        seen |= 1u << axis;
        axes[i] = (int8_t)(is_negative ? -axis - 1 : axis + 1);
    }
    return seen == 7;
}

static int read_gyro(request *r)
{
    const char *lsb = r->value[OPT_GYRO_LSB];
    int failure = EXIT_GOOD;

    for (unsigned o = OPT_GYRO; o <= OPT_ACCELEROMETER_ONLY; o++) {
        if (r->value[o] && r->value[OPT_POSITIONS]) {
            return request_usage(r, o, "needs samples: leave out --positions");
        }
        if (r->value[o] && o != OPT_ACCELEROMETER_ONLY && r->value[OPT_ACCELEROMETER_ONLY]) {
            return request_usage(r, o, "needs the gyroscope: leave out --accelerometer-only");
        }
    }
    if (r->value[OPT_GYRO] && r->is_live) {
        return request_usage(r, OPT_GYRO, "is an option of invcal calibrate only");
    }
    if (r->value[OPT_GYRO] && r->value[OPT_COLUMNS]) {
        return request_usage(r, OPT_GYRO,
                             "cannot be combined with --columns: leave out --columns, and name the "
                             "columns x, y, z in a header of each file");
    }
    if (r->value[OPT_GYRO_AXES] && !parse_axes(r->value[OPT_GYRO_AXES], r->gyro.axes)) {
        return request_usage(r, OPT_GYRO_AXES,
                             "give the axes of the gyroscope that turn about x, y and z of the "
                             "accelerometer, such as y,-x,z");
    }
    if (lsb) {
        r->gyro.rate_unit = unit_parse_angular_rate(lsb);
        if (!(r->gyro.rate_unit > 0)) {
            failure = options_numbers(r->syntax, OPT_GYRO_LSB, lsb, 1, &r->gyro.rate_unit, NULL);
            r->gyro.rate_unit *= UNIT_DEGREE;
        }
        if (!failure && !(r->gyro.rate_unit > 1e-12 && r->gyro.rate_unit < 1e6)) {
            failure =
                request_usage(r, OPT_GYRO_LSB,
                              "must be degrees/s per input unit, such as 1/131, or rad/s or deg/s");
        }
    }
    return failure;
}

/* The program that watch follows. A prior may determine what the program does not. */
static int read_program(request *r)
{
    design *set = &stated_plan;

    if (!r->value[OPT_PLAN]) {
        return EXIT_GOOD;
    }
    r->program = set;
    const int failure = design_make(set, r->syntax->command, r->value[OPT_PLAN]);
    if (failure == EXIT_DATA) {
        return r->value[OPT_PRIOR] && set->count > 0 ? EXIT_GOOD
                                                     : request_usage(r, OPT_PLAN, set->refusal);
    }
    return failure;
}

/* Options of a live stream. */
static int read_live_options(request *r)
{
    int failure = EXIT_GOOD;

    for (unsigned o = OPT_TARGET; o <= OPT_ALLAN && !r->is_live; o++) {
        if (r->value[o]) {
            return request_usage(r, o, "is an option of invcal watch only");
        }
    }
    if (r->is_live && r->value[OPT_POSITIONS]) {
        return request_usage(r, OPT_POSITIONS,
                             "is an option of invcal calibrate only: a live stream has samples");
    }
    if (r->value[OPT_MEAN_SIGMA]) {
        failure = options_numbers(r->syntax, OPT_MEAN_SIGMA, r->value[OPT_MEAN_SIGMA], 1,
                                  &r->mean_sigma, NULL);
        if (!failure && !(r->mean_sigma > 0)) {
            failure = request_usage(r, OPT_MEAN_SIGMA, "the standard deviation must be above 0");
        }
    }
    if (!failure && r->value[OPT_ALLAN] && !r->value[OPT_MEAN_SIGMA]) {
        failure = request_usage(r, OPT_ALLAN, "needs --mean-sigma");
    }
    if (!failure && r->value[OPT_TARGET]) {
        failure = options_numbers(r->syntax, OPT_TARGET, r->value[OPT_TARGET], 3, r->target, NULL);
        for (unsigned i = 0; i < 3 && !failure; i++) {
            failure = r->target[i] >= 0 ? EXIT_GOOD
                                        : request_usage(r, OPT_TARGET, "must not be negative");
        }
    }
    return failure || !r->is_live ? failure : read_program(r);
}

/* --quadratic and --cubic. */
static int read_degree(request *r)
{
    const unsigned which = r->value[OPT_CUBIC] ? OPT_CUBIC : OPT_QUADRATIC;

    for (unsigned i = 0; i < 3 && r->value[OPT_ROBUST]; i++) {
        const unsigned others[] = {which, OPT_THERMAL, OPT_PRIOR};
        if (r->value[others[i]]) {
            return message_usage(r->syntax->command,
                                 "--robust: needs nine free parameters: leave out %s",
                                 options[others[i]].name);
        }
    }
    if (r->value[OPT_ROBUST] && r->is_live) {
        return request_usage(r, OPT_ROBUST, "is an option of invcal calibrate only");
    }
    if (!r->value[which]) {
        return EXIT_GOOD;
    }
    r->degree = which == OPT_CUBIC ? 3 : 2;
    if (r->value[OPT_CUBIC] && r->value[OPT_QUADRATIC]) {
        return request_usage(r, OPT_CUBIC, "includes --quadratic: leave --quadratic out");
    }
    if (r->value[OPT_THERMAL] || r->value[OPT_PRIOR]) {
        return request_usage(r, which,
                             r->value[OPT_THERMAL]
                                 ? "cannot be combined with --thermal: leave one out"
                                 : "cannot be combined with --prior: leave one out");
    }
    return r->is_live ? request_usage(r, which, "is an option of invcal calibrate only")
                      : EXIT_GOOD;
}

/* The program in whose order the positions were visited, instead of columns. */
static int read_plan_order(request *r)
{
    const int failure = design_make(&stated_plan, r->syntax->command, r->value[OPT_PLAN]);

    r->stand.plan = &stated_plan;
    r->stand.is_wanted = 1;
    return failure == EXIT_DATA ? request_usage(r, OPT_PLAN, stated_plan.refusal) : failure;
}

/* Sense and zero of the stand's angles. */
static int read_convention(request *r)
{
    double *sense = r->stand.sense;
    int failure = EXIT_GOOD;

    sense[0] = sense[1] = 1;
    if (r->value[OPT_STAND_SENSE]) {
        failure =
            options_numbers(r->syntax, OPT_STAND_SENSE, r->value[OPT_STAND_SENSE], 2, sense, NULL);
        if (!failure && fabs(fabs(sense[0]) - 1) + fabs(fabs(sense[1]) - 1) > 0) {
            failure = request_usage(r, OPT_STAND_SENSE, "must be 1 or -1 for each");
        }
    }
    if (!failure && r->value[OPT_STAND_ZERO]) {
        failure = options_numbers(r->syntax, OPT_STAND_ZERO, r->value[OPT_STAND_ZERO], 2,
                                  r->stand.zero, NULL);
    }
    return failure;
}

/* Options that cannot be combined with the angles of a stand, or need them. */
static int check_stand(const request *r)
{
    const stand_options *w = &r->stand;
    const unsigned convention = r->value[OPT_STAND_SENSE] ? OPT_STAND_SENSE : OPT_STAND_ZERO;

    if (w->plan && r->value[convention]) {
        return request_usage(r, convention,
                             "needs columns alpha and beta, not --plan, which states the angles");
    }
    if (!w->is_wanted && (r->value[convention] || w->is_frame)) {
        return request_usage(r, w->is_frame ? OPT_FRAME : convention,
                             "needs the angles of a stand: --stand or --plan");
    }
    return w->is_wanted && r->value[OPT_THERMAL]
               ? request_usage(
                     r, OPT_THERMAL,
                     "cannot be combined with the angles of a stand: leave out --thermal, or "
                     "--stand and --plan")
               : EXIT_GOOD;
}

/* The angles of a stand. */
static int read_stand(request *r)
{
    int failure = EXIT_GOOD;

    r->stand.is_wanted = r->value[OPT_STAND] != NULL;
    for (unsigned o = OPT_STAND; o <= OPT_STAND_ZERO; o++) {
        if (r->value[o] && r->is_live) {
            return request_usage(r, o, "is an option of invcal calibrate only");
        }
    }
    if (!r->is_live && r->value[OPT_PLAN]) {
        failure = read_plan_order(r);
    }
    failure = failure ? failure : read_convention(r);
    return failure ? failure : check_stand(r);
}

/* What the unit at the end of a limit is: over the field, or rad; 1 without one, 0 if it is unknown.
 *
 * field   its length, if it is an offset's limit that may be in units of gravity; else 0.
 * digits  out: length of the number. */
static double limit_unit(const char *text, int is_angle, double field, size_t *digits)
{
    static const struct {
        const char *name;
        double rad;
    } angles[] = {{"deg", UNIT_DEGREE}, {"°", UNIT_DEGREE}, {"rad", 1}};
    display_unit unit = {1, NULL};

    for (unsigned i = 0; i < sizeof angles / sizeof *angles && is_angle; i++) {
        const char *end = strstr(text, angles[i].name);
        if (end && strcmp(end, angles[i].name) == 0) {
            for (*digits = (size_t)(end - text); *digits > 0 && text[*digits - 1] == ' ';) {
                --*digits;
            }
            return angles[i].rad;
        }
    }
    const need_ending ending = need_parse(text, field, digits, &unit);
    return ending == NEED_PLAIN ? 1 : ending == NEED_UNIT ? 1 / unit.scale : 0;
}

/* Separates the units of "50mg,3%,2deg" from the numbers. Returns 1; 0 if a unit is unknown. */
static int split_limits(const request *r, char numbers[LIMITS_MAX], double units[3])
{
    const double field = r->value[OPT_MAGNETOMETER] ? 0 : r->settings.field;
    const char *rest = r->value[OPT_TOLERANCE];
    char item[LIMITS_MAX];

    numbers[0] = '\0';
    for (unsigned i = 0; rest; i++) {
        size_t digits = strcspn(rest, ",");
        const int is_last = rest[digits] == '\0';
        snprintf(item, sizeof item, "%.*s", (int)digits, rest);
        rest = is_last ? NULL : rest + digits + 1;
        if (i < 3 && *item != '\0') {
            units[i] = limit_unit(item, i == 2, i == 0 ? field : 0, &digits);
            if (!(units[i] > 0)) {
                return 0;
            }
        }
        append(numbers, LIMITS_MAX, "%.*s%s", (int)digits, item, is_last ? "" : ",");
    }
    return 1;
}

static int read_tolerance(request *r)
{
    char numbers[LIMITS_MAX];
    double units[3] = {1, 1, 1};
    int failure = EXIT_GOOD;

    if (!r->value[OPT_TOLERANCE]) {
        return EXIT_GOOD;
    }
    if (!states_nominal(r)) {
        return request_usage(r, OPT_TOLERANCE,
                             "needs the nominal calibration: state --sensor, --unit, --zero and "
                             "--lsb, or --nominal");
    }
    const int is_split = split_limits(r, numbers, units);
    if (is_split) {
        failure = options_numbers(r->syntax, OPT_TOLERANCE, numbers, 3, r->tolerance, NULL);
    }
    for (unsigned i = 0; i < 3 && is_split && !failure; i++) {
        r->tolerance[i] *= units[i];
        failure = r->tolerance[i] > 0 ? EXIT_GOOD
                                      : request_usage(r, OPT_TOLERANCE, "a limit must be above 0");
    }
    if (!failure && !(is_split && r->tolerance[0] < LIMIT_MAX && r->tolerance[1] < LIMIT_MAX &&
                      r->tolerance[2] < LIMIT_MAX)) {
        failure = message_usage(
            r->syntax->command,
            "--tolerance %s: offsets are over the field (0.05 is 50 mg), scale errors as ratios "
            "(0.03 is 3 %%), angles in rad, each below %.1f; or state the units, as 50mg,3%%,2deg",
            r->value[OPT_TOLERANCE], LIMIT_MAX);
    }
    return failure;
}

/* A need that every sensor meets is one in another unit. */
static int check_need(const request *r, need_ending ending)
{
    const int is_of_readings = r->value[OPT_MAGNETOMETER] && !r->value[OPT_GRAVITY];

    if (!(r->need > 0)) {
        return request_usage(r, OPT_NEED, "must be above 0: the acceptable error of lengths");
    }
    if (r->need <= NEED_MAX_RATIO * r->settings.field || (is_of_readings && ending == NEED_PLAIN)) {
        return EXIT_GOOD;
    }
    return message_usage(
        r->syntax->command, "--need %s: is more than a tenth of the field%s", r->value[OPT_NEED],
        ending == NEED_PLAIN && !r->value[OPT_MAGNETOMETER] ? ": state the unit, as 2mg" : "");
}

static int read_need(request *r)
{
    const char *text = r->value[OPT_NEED];
    const int is_magnetometer = r->value[OPT_MAGNETOMETER] != NULL;
    char number[64];
    size_t digits;

    if (!text) {
        return EXIT_GOOD;
    }
    const need_ending ending =
        need_parse(text, is_magnetometer ? 0 : r->settings.field, &digits, &r->need_unit);
    if (ending == NEED_NO_UNIT) {
        return message_usage(r->syntax->command,
                             "--need %s: must be a number followed by %s, or a number in the unit "
                             "of %s",
                             text, is_magnetometer ? "%" : "mg, g, ug, m/s2 or %",
                             is_magnetometer && !r->value[OPT_GRAVITY] ? "the readings"
                                                                       : "--gravity");
    }
    if (ending == NEED_NO_GRAVITY) {
        return message_usage(r->syntax->command,
                             "--need %s: the field (--gravity) is not gravity: state %% of it, or "
                             "a number in its unit",
                             text);
    }
    if (ending == NEED_PLAIN) {
        r->need_unit.scale = r->settings.field;
    }
    snprintf(number, sizeof number, "%.*s", (int)fmin((double)digits, sizeof number - 1), text);
    const int failure = options_numbers(r->syntax, OPT_NEED, number, 1, &r->need, NULL);
    r->need *= r->settings.field / r->need_unit.scale;
    return failure ? failure : check_need(r, ending);
}

/* The record. Its texts are in the order of the options. */
static int read_record(request *r)
{
    for (unsigned k = 0; k < RECORD_TEXTS; k++) {
        const char *text = r->value[OPT_DEVICE + k];
        const char *problem = text ? record_set(&r->record, (record_text)k, text) : NULL;
        if (problem) {
            return message_usage(r->syntax->command, "%s '%s': %s", options[OPT_DEVICE + k].name,
                                 text, problem);
        }
    }
    return EXIT_GOOD;
}

/* --json-lines implies --json. */
static void read_json_lines(request *r)
{
    if (r->value[OPT_JSON_LINES]) {
        r->value[OPT_JSON] = r->value[OPT_JSON_LINES];
    }
}

static int check_files(const request *r)
{
    const named_file inputs[] = {{"LOG", r->file},
                                 {"--nominal", r->value[OPT_NOMINAL]},
                                 {"--with", r->value[OPT_WITH]},
                                 {"--gyro", r->value[OPT_GYRO]},
                                 {"--allan", r->value[OPT_ALLAN]},
                                 {"--plan", design_file(r->value[OPT_PLAN])}};
    const named_file outputs[] = {{"--out", r->value[OPT_OUT]}, {"--report", r->value[OPT_REPORT]}};

    return files_check(r->syntax->command, inputs, sizeof inputs / sizeof inputs[0], outputs, 2);
}

int request_read(int argc, char **argv, int is_live, request *r)
{
    const option_syntax *syntax = is_live ? &watch_syntax : &calibrate_syntax;

    *r = (request){.syntax = syntax, .is_live = is_live};
    int failure = options_parse(r->syntax, argc, argv, r->value, &r->file);

    options_command(syntax->command, argc, argv, r->command, sizeof r->command);
    failure = failure ? failure : check_files(r);
    failure = failure ? failure : read_gravity(r);
    failure = failure ? failure : read_frame(r);
    failure = failure ? failure : read_magnetometer(r);
    failure = failure ? failure : read_case(r);
    failure = failure ? failure : read_nominal(r);
    failure = failure ? failure : read_sensor(r);
    failure = failure ? failure : read_unit(r);
    failure = failure ? failure : read_noise(r);
    failure = failure ? failure : read_thermal(r);
    failure = failure ? failure : read_log_options(r);
    failure = failure ? failure : read_gyro(r);
    failure = failure ? failure : read_live_options(r);
    failure = failure ? failure : read_degree(r);
    failure = failure ? failure : read_stand(r);
    failure = failure ? failure : read_tolerance(r);
    failure = failure ? failure : read_need(r);
    failure = failure ? failure : read_record(r);
    read_json_lines(r);
    return failure ? failure : read_prior(r);
}
