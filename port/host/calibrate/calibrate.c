/* SPDX-License-Identifier: MIT
 *
 * invcal calibrate: a log or position means in, a calibration out.
 */
#include "result/result.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "result/calibration_file.h"
#include "read/columns.h"
#include "design/design.h"
#include "fit/fit_drift.h"
#include "fit/gravity.h"
#include "cli/command.h"
#include "cli/files.h"
#include "watch/live.h"
#include "cli/message.h"
#include "read/noise_file.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "report/report.h"

enum {
    POSITIONS,
    GRAVITY,
    LATITUDE,
    HEIGHT,
    FRAME,
    ZERO,
    LSB,
    NOMINAL,
    NOMINAL_NAME,
    UNIT,
    UNITS,
    NOISE,
    PRIOR,
    THERMAL,
    SLOPE,
    RATE,
    CLIP,
    ROBUST,
    QUADRATIC,
    CUBIC,
    STAND,
    STAND_SENSE,
    STAND_ZERO,
    PLAN,
    TARGET,
    MEAN_SIGMA,
    ALLAN,
    KEEP_ALL,
    TOLERANCE,
    NEED,
    OUT,
    REPORT,
    JSON,
    QUIET,
    OPTIONS
};

static const option options[OPTIONS] = {
    [POSITIONS] = {"--positions", 0},
    [GRAVITY] = {"--gravity", 1},
    [LATITUDE] = {"--latitude", 1},
    [HEIGHT] = {"--height", 1},
    [FRAME] = {"--frame", 1},
    [ZERO] = {"--zero", 1},
    [LSB] = {"--lsb", 1},
    [NOMINAL] = {"--nominal", 1},
    [NOMINAL_NAME] = {"--nominal-name", 1},
    [UNIT] = {"--unit", 1},
    [UNITS] = {"--units", 1},
    [NOISE] = {"--noise", 1},
    [PRIOR] = {"--prior", 1},
    [THERMAL] = {"--thermal", 1},
    [SLOPE] = {"--slope", 1},
    [RATE] = {"--rate", 1},
    [CLIP] = {"--clip", 1},
    [ROBUST] = {"--robust", 0},
    [QUADRATIC] = {"--quadratic", 0},
    [CUBIC] = {"--cubic", 0},
    [STAND] = {"--stand", 0},
    [STAND_SENSE] = {"--stand-sense", 1},
    [STAND_ZERO] = {"--stand-zero", 1},
    [PLAN] = {"--plan", 1},
    [TARGET] = {"--target", 1},
    [MEAN_SIGMA] = {"--mean-sigma", 1},
    [ALLAN] = {"--allan", 1},
    [KEEP_ALL] = {"--keep-all", 0},
    [TOLERANCE] = {"--tolerance", 1},
    [NEED] = {"--need", 1},
    [OUT] = {"--out", 1},
    [REPORT] = {"--report", 1},
    [JSON] = {"--json", 0},
    [QUIET] = {"--quiet", 0},
};
static const char *const operands[] = {"LOG"};
static const option_syntax calibrate_syntax = {"calibrate", options, OPTIONS, operands, 1, 0};
static const option_syntax watch_syntax = {"watch", options, OPTIONS, operands, 1, 0};

#define MANY_LEFT_OUT 6 /* more than one position in so many: chance does not take these */
#define ON_EARTH 0.0027 /* of g, from the equator to the poles */
#define COMMAND_MAX 2000u
#define UNEXPLAINED 3.0 /* times the noise: a hand that holds the device comes near it */

/* Too large for the stack. */
static design stated_plan;

/* What the command line asks for. */
typedef struct {
    const option_syntax *syntax; /* whose command it is: calibrate or watch */
    const char *file;
    const char *value[OPTIONS]; /* as it was given; null: it was not */
    double zero[3];             /* of --zero, */
    double lsb[3];              /* --lsb */
    double rate;                /* 0: not given */
    double clip[2];
    reading_unit unit; /* of --unit, */
    told_style told;   /* --units */
    double target[3];
    double need; /* 0: not given */
    double mean_sigma;
    double tolerance[3];
    char command[COMMAND_MAX]; /* the command line, for the report */
    double place[2];           /* latitude, height */
    double field_sigma;        /* what the length of the field may be wrong by, field units */
    thermal_wish thermal;
    unsigned degree; /* of --quadratic, --cubic; else 0 */
    stand_wish stand;
    fit_settings settings; /* all but the nominal, and the noise unless stated */
} request;

static int usage(const request *r, unsigned which, const char *what)
{
    return message_usage(r->syntax->command, "%s: %s", options[which].name, what);
}

/* The field of a place on Earth. */
static int read_place(request *r)
{
    int failure = EXIT_GOOD;

    if (r->value[GRAVITY]) {
        return usage(r, LATITUDE, "tells the field, so leave out --gravity");
    }
    failure = options_numbers(r->syntax, LATITUDE, r->value[LATITUDE], 1, &r->place[0], NULL);
    if (!failure && r->value[HEIGHT]) {
        failure = options_numbers(r->syntax, HEIGHT, r->value[HEIGHT], 1, &r->place[1], NULL);
    }
    if (failure) {
        return failure;
    }
    r->settings.field = gravity_at(r->place[0], r->place[1]);
    r->field_sigma = GRAVITY_SIGMA;
    if (isnan(r->settings.field)) {
        return fabs(r->place[0]) <= 90 ? usage(r, HEIGHT, "is -500 to 10000 m above the sea")
                                       : usage(r, LATITUDE, "is -90 to 90 degrees");
    }
    return EXIT_GOOD;
}

/* G, or G with what it may be wrong by: 9.80665+-0.027, or the sign for that. */
static int read_field(request *r)
{
    static const char *const signs[] = {"+-", "±"};
    const char *text = r->value[GRAVITY];
    char length[64];

    r->field_sigma = 0;
    for (unsigned i = 0; i < 2; i++) {
        const char *sign = strstr(text, signs[i]);
        if (sign && (size_t)(sign - text) < sizeof length) {
            snprintf(length, sizeof length, "%.*s", (int)(sign - text), text);
            const int failure = options_numbers(r->syntax, GRAVITY, sign + strlen(signs[i]), 1,
                                                &r->field_sigma, NULL);
            return failure
                       ? failure
                       : options_numbers(r->syntax, GRAVITY, length, 1, &r->settings.field, NULL);
        }
    }
    return options_numbers(r->syntax, GRAVITY, text, 1, &r->settings.field, NULL);
}

static int read_gravity(request *r)
{
    int failure = EXIT_GOOD;

    if (r->value[LATITUDE]) {
        return read_place(r);
    }
    if (r->value[HEIGHT]) {
        return usage(r, HEIGHT, "alone tells no field; state --latitude, too");
    }
    r->settings.field = 9.80665;
    r->field_sigma = ON_EARTH * r->settings.field;
    if (r->value[GRAVITY]) {
        failure = read_field(r);
    }
    if (!failure && !(r->settings.field > 0)) {
        failure = usage(r, GRAVITY, "the length of a field is above 0");
    }
    if (!failure && !(r->field_sigma >= 0 && r->field_sigma < r->settings.field)) {
        failure = usage(r, GRAVITY, "a standard deviation is not negative, and below the length");
    }
    return failure;
}

static int read_frame(request *r)
{
    const char *name = r->value[FRAME] ? r->value[FRAME] : "symmetric";

    r->settings.is_triangular = strcmp(name, "triangular") == 0;
    r->stand.is_frame = strcmp(name, "stand") == 0;
    return r->settings.is_triangular || r->stand.is_frame || strcmp(name, "symmetric") == 0
               ? EXIT_GOOD
               : usage(r, FRAME, "is symmetric, triangular or stand");
}

static int read_nominal(request *r)
{
    int failure = EXIT_GOOD;
    int single = 0;

    if (r->value[NOMINAL] && (r->value[ZERO] || r->value[LSB])) {
        return usage(r, NOMINAL, "holds zero and scale, so leave out --zero and --lsb");
    }
    if (r->value[NOMINAL_NAME] && strlen(r->value[NOMINAL_NAME]) > CALIBRATE_NAME_MAX) {
        return usage(r, NOMINAL_NAME, "is a word of at most 14 bytes");
    }
    if (r->value[ZERO]) {
        failure = options_numbers(r->syntax, ZERO, r->value[ZERO], 3, r->zero, NULL);
    }
    if (!failure && r->value[LSB]) {
        failure = options_numbers(r->syntax, LSB, r->value[LSB], 3, r->lsb, &single);
        r->lsb[1] = single ? r->lsb[0] : r->lsb[1];
        r->lsb[2] = single ? r->lsb[0] : r->lsb[2];
    }
    for (unsigned i = 0; i < 3 && !failure && r->value[LSB]; i++) {
        failure = fabs(r->lsb[i]) > 0 ? EXIT_GOOD : usage(r, LSB, "a scale is not 0");
    }
    return failure;
}

static int read_unit(request *r)
{
    if (r->value[UNIT] && !unit_parse(r->value[UNIT], &r->unit)) {
        return message_usage(r->syntax->command, "--unit %s: is g, mg, m/s2 or counts",
                             r->value[UNIT]);
    }
    if (r->value[UNITS] && !told_parse(r->value[UNITS], &r->told)) {
        return message_usage(r->syntax->command, "--units %s: is everyday or ins", r->value[UNITS]);
    }
    return EXIT_GOOD;
}

static int read_noise(request *r)
{
    int failure = EXIT_GOOD;

    if (r->value[NOISE]) {
        failure = options_numbers(r->syntax, NOISE, r->value[NOISE], 1, &r->settings.noise, NULL);
        if (!failure && !(r->settings.noise > 0)) {
            failure = usage(r, NOISE, "a standard deviation is above 0");
        }
        r->settings.noise /= r->settings.field;
    }
    return failure;
}

static int read_prior(request *r)
{
    double sigma[3]; /* of each delta, dk, gamma */
    int failure = EXIT_GOOD;

    if (!r->value[PRIOR]) {
        return EXIT_GOOD;
    }
    if (!r->value[NOMINAL] && !(r->value[ZERO] && r->value[LSB])) {
        return usage(r, PRIOR,
                     "says how far the nominal calibration may be wrong, so state that: "
                     "--zero and --lsb, or --nominal");
    }
    failure = options_numbers(r->syntax, PRIOR, r->value[PRIOR], 3, sigma, NULL);
    for (unsigned p = 0; p < INVCAL_PARAMETERS && !failure; p++) {
        r->settings.prior[p] = sigma[p / 3];
        failure =
            sigma[p / 3] >= 0 ? EXIT_GOOD : usage(r, PRIOR, "no standard deviation is negative");
    }
    return failure;
}

static int read_thermal(request *r)
{
    double degree = 0;
    int failure = EXIT_GOOD;

    r->thermal.keep_all = r->value[KEEP_ALL] != NULL;
    if (r->value[THERMAL]) {
        failure = options_numbers(r->syntax, THERMAL, r->value[THERMAL], 1, &degree, NULL);
        r->thermal.degree = degree >= 2 ? 2 : 1;
        if (!failure && fabs(degree - r->thermal.degree) > 0) {
            failure = usage(r, THERMAL, "is 1 (slopes) or 2 (parabolas)");
        }
    }
    if (!failure && r->value[SLOPE]) {
        failure = r->value[THERMAL] ? options_numbers(r->syntax, SLOPE, r->value[SLOPE], 3,
                                                      r->thermal.slope, NULL)
                                    : usage(r, SLOPE, "is known of --thermal, so state that");
        for (unsigned i = 0; i < 3 && !failure; i++) {
            failure = r->thermal.slope[i] >= 0
                          ? EXIT_GOOD
                          : usage(r, SLOPE, "no standard deviation is negative");
        }
    }
    return failure;
}

/* What only a log of samples has. */
static int read_log_options(request *r)
{
    int failure = EXIT_GOOD;

    if (r->value[POSITIONS] && (r->value[RATE] || r->value[CLIP])) {
        return usage(r, r->value[RATE] ? RATE : CLIP, "is of samples; position means have none");
    }
    if (r->value[RATE]) {
        failure = options_numbers(r->syntax, RATE, r->value[RATE], 1, &r->rate, NULL);
        if (!failure && !(r->rate >= SAMPLES_RATE_MIN && r->rate <= SAMPLES_RATE_MAX)) {
            failure = usage(r, RATE, "is 8 to 8000 samples a second");
        }
    }
    if (!failure && r->value[CLIP]) {
        failure = options_numbers(r->syntax, CLIP, r->value[CLIP], 2, r->clip, NULL);
        if (!failure && !(r->clip[0] < r->clip[1])) {
            failure = usage(r, CLIP, "is the least and the greatest reading");
        }
    }
    return failure;
}

/* The program to follow. What it leaves open a prior may tell. */
static int read_program(request *r)
{
    design *set = &stated_plan;

    if (!r->value[PLAN]) {
        return EXIT_GOOD;
    }
    const int failure = design_make(set, r->syntax->command, r->value[PLAN]);
    if (failure == EXIT_DATA) {
        return r->value[PRIOR] && set->count > 0 ? EXIT_GOOD : usage(r, PLAN, set->refusal);
    }
    return failure;
}

/* What only a live stream has. */
static int read_live_options(request *r)
{
    const int is_live = r->syntax == &watch_syntax;
    int failure = EXIT_GOOD;

    for (unsigned o = TARGET; o <= ALLAN && !is_live; o++) {
        if (r->value[o]) {
            return usage(r, o, "is for invcal watch");
        }
    }
    if (is_live && r->value[POSITIONS]) {
        return usage(r, POSITIONS, "is for invcal calibrate; a live stream has samples");
    }
    if (r->value[MEAN_SIGMA]) {
        failure =
            options_numbers(r->syntax, MEAN_SIGMA, r->value[MEAN_SIGMA], 1, &r->mean_sigma, NULL);
        if (!failure && !(r->mean_sigma > 0)) {
            failure = usage(r, MEAN_SIGMA, "a standard deviation is above 0");
        }
    }
    if (!failure && r->value[ALLAN] && !r->value[MEAN_SIGMA]) {
        failure = usage(r, ALLAN, "needs --mean-sigma, how good a mean is wanted");
    }
    if (!failure && r->value[TARGET]) {
        failure = options_numbers(r->syntax, TARGET, r->value[TARGET], 3, r->target, NULL);
        for (unsigned i = 0; i < 3 && !failure; i++) {
            failure = r->target[i] >= 0 ? EXIT_GOOD : usage(r, TARGET, "is not negative");
        }
    }
    return failure || !is_live ? failure : read_program(r);
}

/* What the axes may do beside the nine parameters. */
static int read_degree(request *r)
{
    const unsigned which = r->value[CUBIC] ? CUBIC : QUADRATIC;

    if (r->value[ROBUST] && (r->value[which] || r->value[THERMAL] || r->value[PRIOR])) {
        return usage(r, ROBUST, "is of nine parameters, without a prior");
    }
    if (r->value[ROBUST] && r->syntax == &watch_syntax) {
        return usage(r, ROBUST, "is for invcal calibrate");
    }
    if (!r->value[which]) {
        return EXIT_GOOD;
    }
    r->degree = which == CUBIC ? 3 : 2;
    if (r->value[CUBIC] && r->value[QUADRATIC]) {
        return usage(r, CUBIC, "includes --quadratic: leave that out");
    }
    if (r->value[THERMAL] || r->value[PRIOR]) {
        return usage(r, which,
                     r->value[THERMAL] ? "does not go together with --thermal"
                                       : "does not go together with --prior");
    }
    return r->syntax == &watch_syntax ? usage(r, which, "is for invcal calibrate") : EXIT_GOOD;
}

/* The program whose order was kept, in place of columns. */
static int read_order(request *r)
{
    const int failure = design_make(&stated_plan, r->syntax->command, r->value[PLAN]);

    r->stand.plan = &stated_plan;
    r->stand.is_wanted = 1;
    return failure == EXIT_DATA ? usage(r, PLAN, stated_plan.refusal) : failure;
}

/* How the stand counts. */
static int read_convention(request *r)
{
    double *sense = r->stand.sense;
    int failure = EXIT_GOOD;

    sense[0] = sense[1] = 1;
    if (r->value[STAND_SENSE]) {
        failure = options_numbers(r->syntax, STAND_SENSE, r->value[STAND_SENSE], 2, sense, NULL);
        if (!failure && fabs(fabs(sense[0]) - 1) + fabs(fabs(sense[1]) - 1) > 0) {
            failure = usage(r, STAND_SENSE, "is 1 or -1 for each");
        }
    }
    if (!failure && r->value[STAND_ZERO]) {
        failure =
            options_numbers(r->syntax, STAND_ZERO, r->value[STAND_ZERO], 2, r->stand.zero, NULL);
    }
    return failure;
}

/* What does not go together with the angles of a stand, or not without. */
static int check_stand(const request *r)
{
    const stand_wish *w = &r->stand;
    const unsigned convention = r->value[STAND_SENSE] ? STAND_SENSE : STAND_ZERO;

    if (w->plan && r->value[convention]) {
        return usage(r, convention,
                     "is of columns alpha and beta; --plan states the angles themselves");
    }
    if (!w->is_wanted && (r->value[convention] || w->is_frame)) {
        return usage(r, w->is_frame ? FRAME : convention,
                     "needs the angles of a stand: --stand or --plan");
    }
    return w->is_wanted && r->value[THERMAL]
               ? usage(r, THERMAL, "and the angles of a stand do not go together")
               : EXIT_GOOD;
}

/* What the angles of a stand mean. */
static int read_stand(request *r)
{
    int failure = EXIT_GOOD;

    r->stand.is_wanted = r->value[STAND] != NULL;
    for (unsigned o = STAND; o <= STAND_ZERO; o++) {
        if (r->value[o] && r->syntax == &watch_syntax) {
            return usage(r, o, "is for invcal calibrate");
        }
    }
    if (r->syntax == &calibrate_syntax && r->value[PLAN]) {
        failure = read_order(r);
    }
    failure = failure ? failure : read_convention(r);
    return failure ? failure : check_stand(r);
}

static int read_tolerance(request *r)
{
    int failure = EXIT_GOOD;

    if (!r->value[TOLERANCE]) {
        return EXIT_GOOD;
    }
    if (!r->value[NOMINAL] && !(r->value[ZERO] && r->value[LSB])) {
        return usage(r, TOLERANCE,
                     "says how far from nominal the sensor may be, so state that: "
                     "--zero and --lsb, or --nominal");
    }
    failure = options_numbers(r->syntax, TOLERANCE, r->value[TOLERANCE], 3, r->tolerance, NULL);
    for (unsigned i = 0; i < 3 && !failure; i++) {
        failure = r->tolerance[i] > 0 ? EXIT_GOOD : usage(r, TOLERANCE, "a limit is above 0");
    }
    return failure;
}

static int read_need(request *r)
{
    int failure = EXIT_GOOD;

    if (r->value[NEED]) {
        failure = options_numbers(r->syntax, NEED, r->value[NEED], 1, &r->need, NULL);
        if (!failure && !(r->need > 0)) {
            failure = usage(r, NEED, "is above 0: what lengths may be wrong by, field units");
        }
    }
    return failure;
}

static int check_files(const request *r)
{
    const named_file inputs[] = {{"LOG", r->file},
                                 {"--nominal", r->value[NOMINAL]},
                                 {"--allan", r->value[ALLAN]},
                                 {"--plan", design_file(r->value[PLAN])}};
    const named_file outputs[] = {{"--out", r->value[OUT]}, {"--report", r->value[REPORT]}};

    return files_check(r->syntax->command, inputs, 4, outputs, 2);
}

static int read_request(int argc, char **argv, const option_syntax *syntax, request *r)
{
    *r = (request){.syntax = syntax};
    int failure = options_parse(r->syntax, argc, argv, r->value, &r->file);

    options_command(syntax->command, argc, argv, r->command, sizeof r->command);
    failure = failure ? failure : check_files(r);
    failure = failure ? failure : read_gravity(r);
    failure = failure ? failure : read_frame(r);
    failure = failure ? failure : read_nominal(r);
    failure = failure ? failure : read_unit(r);
    failure = failure ? failure : read_noise(r);
    failure = failure ? failure : read_thermal(r);
    failure = failure ? failure : read_log_options(r);
    failure = failure ? failure : read_live_options(r);
    failure = failure ? failure : read_degree(r);
    failure = failure ? failure : read_stand(r);
    failure = failure ? failure : read_tolerance(r);
    failure = failure ? failure : read_need(r);
    return failure ? failure : read_prior(r);
}

/* No calculation can be made with numbers so large or so small. */
static int refuse_nominal(const request *r, const positions *data, const nominal_choice *n)
{
    const fit_reason all = {data->count, (1u << INVCAL_PARAMETERS) - 1};

    if (r->value[LSB]) {
        return usage(r, LSB, "is too small or too large a scale for any calculation");
    }
    return calibrate_refuse(data, &r->settings, n, &r->stand, INVCAL_UNDETERMINED, &all,
                            r->value[JSON] != NULL);
}

/* Whoever states the unit knows better than a heading; a size tells words, but no numbers. */
static void settle_unit(const request *r, positions *data)
{
    recognition *seen = &data->seen;

    if (r->value[UNIT]) {
        seen->unit = r->unit;
        seen->unit_from = UNIT_FROM_OPTION;
    } else if (seen->unit == UNIT_UNKNOWN && !seen->states_foreign_unit) {
        seen->unit = unit_by_size(data->mean, data->count, r->settings.field);
        seen->unit_from = seen->unit != UNIT_UNKNOWN ? UNIT_FROM_SIZE : UNIT_FROM_NONE;
    }
}

/* Zero and scale from the data's range, or from the unit if that is stated. Returns 0 if there is
 * no scale. */
static int guess_nominal(const request *r, const positions *data, nominal_choice *n, double zero[3],
                         double lsb[3])
{
    const double field = r->settings.field;
    const int is_stated = !r->value[LSB] && data->seen.unit_from != UNIT_FROM_SIZE;
    const double scale = is_stated ? unit_scale(data->seen.unit, field) : 0;

    if (!(scale > 0)) {
        n->zero = n->lsb = NOMINAL_RANGE;
        return nominal_from_range(data, field, zero, lsb);
    }
    n->zero = n->lsb = NOMINAL_UNIT;
    for (unsigned i = 0; i < 3; i++) {
        zero[i] = 0;
        lsb[i] = scale;
    }
    return 1;
}

/* Zero and scale: given, or of an earlier calibration, or by the unit, or from the data's range. */
static int settle_nominal(const request *r, const positions *data, nominal_choice *n)
{
    double zero[3];
    double lsb[3];

    if (r->value[NOMINAL]) {
        n->zero = n->lsb = NOMINAL_EARLIER;
        return calibration_file_read(r->value[NOMINAL], &n->calibration);
    }
    const int has_scale = guess_nominal(r, data, n, zero, lsb);
    n->zero = r->value[ZERO] ? NOMINAL_GIVEN : n->zero;
    n->lsb = r->value[LSB] ? NOMINAL_GIVEN : n->lsb;
    if (!has_scale && n->lsb == NOMINAL_RANGE) {
        return refuse_nominal(r, data, n);
    }
    return nominal_make(r->value[ZERO] ? r->zero : zero, r->value[LSB] ? r->lsb : lsb,
                        r->settings.field, &n->calibration)
               ? EXIT_GOOD
               : refuse_nominal(r, data, n);
}

/* The noise of a position mean from std and n: the root mean square over axes. */
static double noise_of_file(const positions *data, const invcal_calibration *c)
{
    double square = 0;

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            square += c->matrix[i][j] * c->matrix[i][j] * data->noise_square[j] / 3;
        }
    }
    return sqrt(square);
}

static int settle_noise(const request *r, const positions *data, calibrate_result *result)
{
    result->is_noise_given = r->value[NOISE] != NULL;
    if (!r->value[NOISE] && data->has_noise) {
        result->settings.noise = noise_of_file(data, &result->settings.nominal);
    }
    if (!(result->settings.noise < 1)) {
        if (r->value[NOISE]) {
            return usage(r, NOISE, "is larger than the field (--gravity)");
        }
        message("%s: its std columns tell a noise larger than the field (--gravity)", data->name);
        return EXIT_FILE;
    }
    if (fit_has_prior(&result->settings) && !(result->settings.noise > 0)) {
        return usage(r, PRIOR,
                     "is weighed against the noise of a position mean, so state that: "
                     "--noise, or columns std and n");
    }
    if (r->value[SLOPE] && !(result->settings.noise > 0)) {
        return usage(r, SLOPE,
                     "is weighed against the noise of a position mean, so state that: "
                     "--noise, or columns std and n");
    }
    return EXIT_GOOD;
}

static double residual_of_nominal(const positions *data, const invcal_calibration *nominal)
{
    double squares = 0;

    for (unsigned n = 0; n < data->count; n++) {
        double v[3];
        invcal_apply(nominal, &data->mean[3 * (size_t)n], v);
        const double r = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1;
        squares += r * r;
    }
    return sqrt(squares / data->count);
}

/* Which parameters exceed what the data sheet allows, by more than their uncertainty. */
static uint16_t beyond(const calibrate_result *result)
{
    const fit_quality *q = &result->quality;
    const double spread = calibrate_knows_noise(result) ? q->coverage : 0;
    unsigned bits = 0;

    for (unsigned p = 0; p < INVCAL_PARAMETERS && result->tolerance; p++) {
        const double least = fabs(result->solution.x[p]) - spread * q->sigma[p];
        bits |= (unsigned)!(least <= result->tolerance[p / 3]) << p;
    }
    return (uint16_t)bits;
}

static int refuse(const request *r, const calibrate_result *result, invcal_status status,
                  const fit_reason *reason)
{
    const int json = r->value[JSON] != NULL;

    if (status == INVCAL_TOO_FEW && rejection_drifting(&result->rejected) > 0) {
        return calibrate_all_drift(result, json);
    }
    return calibrate_refuse(result->data, &result->settings, &result->nominal, &r->stand, status,
                            reason, json);
}

/* What was found among the positions beside outliers. */
static void judge(calibrate_result *result)
{
    const invcal_quality *found = &result->rejected.found;
    fit_quality *q = &result->quality;

    if (!result->rejected.is_judged) {
        return;
    }
    q->systematic = found->systematic;
    q->axis = found->axis;
    q->size = found->size;
    q->unchecked = found->unchecked;
    q->dof -= found->positions - INVCAL_PARAMETERS - found->dof; /* directions visited again */
    if (found->verdict > q->verdict) {
        q->verdict = (invcal_verdict)found->verdict;
    }
}

static double time_of(const positions *p, unsigned i)
{
    const position_origin *o = &p->origin[i];

    return isnan(o->begin) ? i : (o->begin + o->end) / 2;
}

double calibrate_tau(const positions *data, unsigned position)
{
    const double first = time_of(data, 0);

    return (time_of(data, position) - first) / (time_of(data, data->count - 1) - first) - 0.5;
}

/* A drift that was named is fitted, too; what that does not explain was none, but a step perhaps. */
static void fit_drift(calibrate_result *result)
{
    rejection *r = &result->rejected;
    double *tau = calloc((size_t)r->kept_count + 1, sizeof *tau);
    fit_solution solution;
    fit_quality q;

    for (unsigned k = 0; tau && k < r->kept_count; k++) {
        tau[k] = calibrate_tau(result->data, rejection_original(r, k));
    }
    if (tau && isfinite(tau[0]) && !fit_has_prior(&result->settings) &&
        fit_drift_make(r->kept, tau, r->kept_count, &result->settings, &solution, &q, result->drift,
                       result->drift_sigma) == INVCAL_OK) {
        result->is_drift_fitted = q.verdict != INVCAL_ROUGH;
        if (result->is_drift_fitted) {
            result->solution = solution;
            result->quality = q;
        } else {
            r->found.systematic = INVCAL_NO_SYSTEMATIC;
            r->found.verdict = INVCAL_ROUGH;
        }
    }
    free(tau);
}

/* Nine parameters. */
static int solve_plain(const request *r, calibrate_result *result)
{
    fit_reason reason;
    const int failure = rejection_find(&result->rejected, result->data, &result->settings,
                                       r->value[KEEP_ALL] != NULL);

    if (failure) {
        return failure;
    }
    const invcal_status status =
        fit_make(result->rejected.kept, result->rejected.kept_count, &result->settings,
                 &result->solution, &result->quality, &reason);
    if (status != INVCAL_OK) {
        reason.position = rejection_original(&result->rejected, reason.position);
        return refuse(r, result, status, &reason);
    }
    if (result->rejected.is_judged && result->rejected.found.verdict == INVCAL_DRIFTING) {
        fit_drift(result);
    }
    const int open =
        r->degree > 0 ? calibrate_nonlinear(result, r->degree, r->value[JSON] != NULL) : EXIT_GOOD;
    judge(result);
    return open;
}

/* The same at every temperature. */
static int solve_thermal(const request *r, calibrate_result *result)
{
    invcal_status status;
    fit_reason reason;

    if (!result->data->has_temperature) {
        message("%s: has no column of temperature in °C, K or °F, which --thermal needs: name it "
                "temperature, or "
                "leave --thermal out",
                result->data->name);
        return EXIT_FILE;
    }
    const int failure = thermal_fit_make(&result->fit, result->data, &result->settings, &r->thermal,
                                         &result->rejected, &status, &reason);
    if (failure) {
        return failure;
    }
    if (status != INVCAL_OK) {
        return refuse(r, result, status, &reason);
    }
    result->temperature = CALIBRATE_THERMAL;
    result->solution = result->fit.solution;
    result->quality = result->fit.quality;
    return EXIT_GOOD;
}

/* What --thermal would find. It has its own opinion of what contradicts. */
static int probe_temperature(calibrate_result *result)
{
    const thermal_wish wish = {.degree = 1};
    rejection rejected = {0};
    invcal_status status = INVCAL_TOO_FEW;
    fit_reason reason;
    int failure = EXIT_GOOD;

    if (result->data->has_temperature) {
        failure = thermal_fit_make(&result->fit, result->data, &result->settings, &wish, &rejected,
                                   &status, &reason);
        result->temperature = status == INVCAL_OK ? CALIBRATE_PROBED : CALIBRATE_PLAIN;
        rejection_free(&rejected);
    }
    return failure;
}

/* A length that is known so well, apart from what the field may be wrong by. */
static double accuracy_of(const fit_quality *q)
{
    invcal_quality quality = {.sigma_dof = (uint16_t)fmin(UINT16_MAX, q->sigma_dof)};

    memcpy(quality.sigma, q->sigma, sizeof quality.sigma);
    return invcal_accuracy(&quality, 0);
}

/* A field that is wrong makes all three scales wrong alike. */
static void inherit_field(const request *r, calibrate_result *result)
{
    result->field_sigma = r->field_sigma / r->settings.field;
    result->is_field_stated = r->value[GRAVITY] || r->value[LATITUDE];
    for (unsigned p = INVCAL_DK_X; p <= INVCAL_DK_Z; p++) {
        double *sigma = &result->quality.sigma[p];
        *sigma = sqrt(*sigma * *sigma + result->field_sigma * result->field_sigma);
    }
}

/* What the angles of the stand tell, of readings that a drift is taken from. */
static int find_stand(const request *r, calibrate_result *result)
{
    const rejection *kept = &result->rejected;
    double *raw = calloc(3 * (size_t)kept->kept_count + 1, sizeof *raw);
    int failure = EXIT_FILE;

    for (unsigned k = 0; raw && k < kept->kept_count; k++) {
        calibrate_level(result, rejection_original(kept, k), &raw[3 * (size_t)k]);
    }
    if (raw) {
        failure = stand_find(&result->stand, &r->stand, result->data, kept, raw,
                             &result->settings.nominal);
    }
    free(raw);
    if (!failure && r->stand.is_frame && result->stand.reading != STAND_AS_STATED) {
        message("%s: no frame of the stand: %s", result->data->name,
                stand_advice(result->stand.reading));
        return EXIT_DATA;
    }
    if (!failure && r->stand.is_frame) {
        stand_turn(&result->stand, &result->solution.calibration);
        result->is_stand_frame = 1;
    }
    return failure;
}

const char *calibrate_frame(const calibrate_result *result)
{
    return result->is_stand_frame           ? "stand"
           : result->settings.is_triangular ? "triangular"
                                            : "symmetric";
}

static int solve(const request *r, const positions *data, calibrate_result *result)
{
    result->data = data;
    result->settings = r->settings;
    result->place = r->value[LATITUDE] ? r->place : NULL;
    int failure = stand_check(&r->stand, data);
    result->told = r->told;
    failure = failure ? failure : settle_nominal(r, data, &result->nominal);
    result->settings.nominal = fit_over_field(&result->nominal.calibration, r->settings.field);
    failure = failure ? failure : settle_noise(r, data, result);
    failure = failure             ? failure
              : r->value[THERMAL] ? solve_thermal(r, result)
                                  : solve_plain(r, result);
    failure = failure || r->value[THERMAL] ? failure : probe_temperature(result);
    failure = failure || !r->stand.is_wanted ? failure : find_stand(r, result);
    if (failure) {
        return failure;
    }
    result->is_robust_wanted = r->value[ROBUST] != NULL;
    if (result->is_robust_wanted) {
        calibrate_robust(result);
    }
    result->accuracy = accuracy_of(&result->quality);
    result->need = r->need;
    inherit_field(r, result);
    result->quality.worst = rejection_original(&result->rejected, result->quality.worst);
    result->tolerance = r->value[TOLERANCE] ? r->tolerance : NULL;
    result->beyond = beyond(result);
    result->residual_before = residual_of_nominal(data, &result->settings.nominal);
    return EXIT_GOOD;
}

const char *calibrate_field_unit(const calibrate_result *result)
{
    return unit_is_gravity(result->settings.field) ? "m/s²" : "field units";
}

told_unit calibrate_told_field(const calibrate_result *result)
{
    return told_field(result->told, unit_is_gravity(result->settings.field));
}

const char *calibrate_input_unit(const calibrate_result *result)
{
    return unit_words(result->data->seen.unit);
}

int calibrate_knows_noise(const calibrate_result *result)
{
    return result->settings.noise > 0 || result->quality.noise < 1;
}

double calibrate_times(const calibrate_result *result)
{
    const double expected = result->settings.noise;

    return expected > 0 ? result->quality.noise / expected : 0;
}

double calibrate_unexplained(const calibrate_result *result)
{
    const double times = calibrate_times(result);

    return times >= UNEXPLAINED ? times : 0;
}

int calibrate_has_lost_many(const calibrate_result *result)
{
    const rejection *r = &result->rejected;

    return MANY_LEFT_OUT * (r->count - rejection_drifting(r)) > r->count + r->kept_count;
}

static calibrate_wish wish_of(const request *r)
{
    return (calibrate_wish){
        .nominal_name = r->value[NOMINAL_NAME] ? r->value[NOMINAL_NAME] : "nominal",
        .saved = r->value[OUT],
        .report = r->value[REPORT],
        .command = r->command,
    };
}

static int print(const request *r, const calibrate_result *result)
{
    const calibrate_wish wish = wish_of(r);

    if (r->value[JSON]) {
        calibrate_json(stdout, result);
    } else if (!r->value[QUIET]) {
        calibrate_print(stdout, result, &wish);
    }
    return output_flush();
}

/* Begins a file, if it is asked for, and writes it; it is not in its place yet. */
typedef int file_writer(FILE *file, const request *r, const calibrate_result *result);

static int begin_file(output *out, const char *path, file_writer *write, const request *r,
                      const calibrate_result *result)
{
    if (!path) {
        return EXIT_GOOD;
    }
    int failure = output_begin(out, path);
    failure = failure ? failure : write(out->file, r, result);
    return failure ? failure : output_finish(out);
}

static int write_calibration(FILE *file, const request *r, const calibrate_result *result)
{
    (void)r;
    calibrate_json(file, result);
    return EXIT_GOOD;
}

static int write_report(FILE *file, const request *r, const calibrate_result *result)
{
    const calibrate_wish wish = wish_of(r);

    return report_write(file, result, &wish);
}

/* The files appear only after all else has been written. */
static int deliver(const request *r, const calibrate_result *result)
{
    output files[2] = {{0}};
    int failure = begin_file(&files[0], r->value[OUT], write_calibration, r, result);

    failure = failure ? failure : begin_file(&files[1], r->value[REPORT], write_report, r, result);
    failure = failure ? failure : print(r, result);
    return output_end(files, 2, failure);
}

/* The positions that a live stream rests in. What there is to say of them goes to stdout, beside
 * JSON to stderr, and with --quiet nowhere. */
static int read_live(const request *r, const double *clip, positions *data, rests_summary *log)
{
    invcal_calibration nominal;
    invcal_noise noise[3];
    live_wish wish = {.rate = r->rate, .clip = clip, .unit = r->unit, .field = r->settings.field};

    wish.told = r->told;
    wish.set = r->value[PLAN] ? &stated_plan : NULL;
    if (r->value[NOMINAL]) {
        const int failure = calibration_file_read(r->value[NOMINAL], &nominal);
        if (failure) {
            return failure;
        }
        wish.nominal = &nominal;
    }
    wish.zero = r->value[ZERO] ? r->zero : NULL;
    wish.lsb = r->value[LSB] ? r->lsb : NULL;
    memcpy(wish.target, r->target, sizeof wish.target);
    wish.need = r->need / r->settings.field;
    wish.field_sigma = r->field_sigma / r->settings.field;
    wish.mean_sigma = r->mean_sigma;
    if (r->value[ALLAN]) {
        const int failure = noise_file_read(r->value[ALLAN], noise);
        if (failure) {
            return failure;
        }
        wish.noise = noise;
    }
    FILE *nowhere = r->value[QUIET] ? fopen("/dev/null", "w") : NULL;
    wish.talk = nowhere ? nowhere : r->value[JSON] ? stderr : stdout;
    const int failure = live_read(data, r->file, &wish, log);
    if (nowhere) {
        fclose(nowhere);
    }
    return failure;
}

/* The positions of the file, or those that a log or a live stream rests in. */
static int read_positions(const request *r, positions *data, rests_summary *log)
{
    const double *clip = r->value[CLIP] ? r->clip : NULL;

    if (r->value[POSITIONS]) {
        return positions_read(data, r->file);
    }
    const int failure = r->syntax == &watch_syntax ? read_live(r, clip, data, log)
                                                   : rests_read(data, r->file, r->rate, clip, log);
    if (!failure && data->count == 0) {
        return calibrate_no_rest(data, log, r->value[JSON] != NULL);
    }
    return failure;
}

static int run(int argc, char **argv, const option_syntax *syntax)
{
    request r;
    positions data = {.name = NULL};
    rests_summary log;
    calibrate_result result = {.data = NULL};
    int failure = read_request(argc, argv, syntax, &r);

    if (failure) {
        return failure;
    }
    if (r.value[QUIET]) {
        progress_quiet();
    }
    failure = read_positions(&r, &data, &log);
    result.log = r.value[POSITIONS] ? NULL : &log;
    if (!failure) {
        settle_unit(&r, &data);
        failure = solve(&r, &data, &result);
    }
    failure = failure ? failure : deliver(&r, &result);
    stand_free(&result.stand);
    rejection_free(&result.rejected);
    positions_free(&data);
    return failure;
}

static int run_calibrate(int argc, char **argv)
{
    return run(argc, argv, &calibrate_syntax);
}

static int run_watch(int argc, char **argv)
{
    return run(argc, argv, &watch_syntax);
}

static const char *const help[] = {
    "usage: invcal calibrate LOG [options]\n"
    "\n"
    "Calibrates a triad of accelerometers (or magnetometers) that has been held still in a dozen\n"
    "orientations or more, in any order and at any angle. In each it feels one and the same\n"
    "field; only its length must be known, no direction. Result:\n"
    "\n"
    "  calibrated = matrix (raw - offset)\n"
    "\n"
    "LOG is a table of samples, - the standard input; the rests in it, of two seconds or more,\n"
    "are found. Turn briskly from one to the next: a turn of more than five seconds may pass for\n"
    "a rest where it begins and ends slowly. Columns are x y z, or t x y z (t in seconds), or\n"
    "t x y z temperature; the first two also with the three of a gyro behind; or any with a\n"
    "header that names them:\n",
    COLUMNS_NAMES,
    "Separators are semicolons, commas, tabs or blanks; lines beginning with #, % or // are\n"
    "comments. What LOG was taken for is told in the first line of the result.\n"
    "Nine positions are the least, twelve to eighteen in all directions are good. A position\n"
    "that contradicts the others is left out and named, if eleven or more are there to tell.\n"
    "\n"
    "  --positions         each row of LOG is the mean of one position: x y z, or x y z std n\n"
    "                      (standard deviation and number of the samples), or\n"
    "                      x y z std_x std_y std_z n, or with a header\n"
    "  --rate HZ           samples a second; default: by the column t, else 100\n"
    "  --clip LOW,HIGH     the least and the greatest reading of the sensor, in input units:\n"
    "                      rests that touch them are refused\n"
    "  --keep-all          leaves no position out\n",
    "  --gravity G[+-S]    length of the field, in the unit of the result, and what it may be "
    "wrong\n"
    "                      by; default 9.80665+-0.027 (m/s^2), as is true anywhere on Earth. For "
    "a\n"
    "                      magnetometer that of the earth's field, e.g. 48.5 (uT). The scales "
    "inherit\n"
    "                      its error, all alike\n"
    "  --latitude DEG      in place of --gravity: normal gravity there (WGS 84), north positive;\n"
    "                      the real one differs by some 0.0005 m/s^2, which scales all readings\n"
    "                      alike and does nothing else\n"
    "  --height M          above the sea, m; default 0\n"
    "  --frame symmetric|triangular|stand\n"
    "                      symmetric (default): axes as near to the case as can be;\n"
    "                      triangular: only the x sensor feels a field along the x axis;\n"
    "                      stand: turned to the axes of the stand, by its angles\n"
    "  --zero X,Y,Z        nominal reading in no field, in input units;\n"
    "                      default: the middle of each axis' range\n"
    "  --lsb S | SX,SY,SZ  nominal scale, in field units per input unit;\n"
    "                      default: from the range of each axis\n"
    "                      Both come from the unit of the readings (zero 0) where that is stated,\n"
    "                      in the header or by --unit, as g, mg or m/s^2, and G is in m/s^2\n"
    "  --unit U            unit of the readings: g, mg, m/s2 or counts; default: by the header,\n"
    "                      else a guess by their size, which names it, but changes no number\n"
    "  --units everyday|ins\n"
    "                      of figures for people, in the table and the report: mg, % and degrees\n"
    "                      (default), or those of inertial navigation, ug, ppm and arcsec. JSON\n"
    "                      has units of its own\n"
    "  --nominal CAL.json  an earlier calibration in place of --zero and --lsb\n"
    "  --nominal-name WORD heading of the nominal column; default nominal\n",
    "  --noise S           standard deviation of one position mean on each axis, in field units;\n"
    "                      default: from std and n, else not known\n"
    "  --prior D,K,G       standard deviations of what the nominal calibration may be wrong by:\n"
    "                      offsets (over the field: 0.02 is 20 mg), scale errors (0.01 is 1 %),\n"
    "                      angles (rad); up to about 0.2; 0 says nothing. Then fewer\n"
    "                      positions will do. Needs the noise, and --zero and --lsb, or\n"
    "                      --nominal\n"
    "  --robust            a cross-check: does the estimate with the least sum of absolute "
    "residuals\n"
    "                      (l1) of all positions agree with this one, outliers left out?\n"
    "  --quadratic         each axis may read q eta^2 more, too: what 14 positions or more tell of "
    "q\n"
    "  --cubic             and c eta^3: 17 or more. The calibration is what is linear; invcal "
    "apply\n"
    "                      takes the others off before, invcal export has no place for them\n"
    "  --stand             LOG has the angles of a two-axis stand, degrees, in columns alpha "
    "(outer)\n"
    "                      and beta (inner); up is (sin a sin b, cos a, sin a cos b). Tells how "
    "the\n"
    "                      unit is turned on the stand, what its directions make of the "
    "parameters\n"
    "                      (J1), and positions that are misset, swapped or repeated\n"
    "  --plan SET          the same, with no columns: the positions of a program of invcal plan "
    "were\n"
    "                      visited in its order:\n",
    DESIGN_WORDS,
    "  --stand-sense A,B   1 or -1: sense in which the stand counts alpha and beta; default 1,1\n"
    "  --stand-zero A,B    what it reads, degrees, where alpha and beta are 0; default 0,0\n",
    "  --thermal 1|2       offsets, scales and angles as straight lines (1) or parabolas (2) of\n"
    "                      the column temperature: nine positions or more at each of 2 (3)\n"
    "                      temperatures, 5 K (10 K) apart at least. Rests in which it drifted are\n"
    "                      left out. Where the data tell no slopes, there are none, and why\n"
    "  --slope D,K,G       standard deviations of what slopes may be, per K: of offsets (over the\n"
    "                      field), scale errors, angles (rad); 0 says nothing. Needs the noise\n"
    "  --tolerance D,K,G   limits of the data sheet for offsets (over the field), scale errors\n"
    "                      and angles (rad): says which parameters are beyond. Needs --zero\n"
    "                      and --lsb, or --nominal\n"
    "  --need U            what calibrated lengths may be wrong by in 95 % of cases, in the unit\n"
    "                      of --gravity: says whether they are that good, and what is missing\n"
    "  --out CAL.json      write the result to a file, as JSON, for invcal apply\n"
    "  --report R.html     write a page with the verdict, figures and pictures: one file that\n"
    "                      needs nothing else, for screen and paper\n"
    "  --json              print the result as JSON in place of the table\n"
    "  --quiet             print neither table nor progress, only errors\n"
    "\n"
    "exit codes: 0 good; 1 the data cannot be calibrated; 2 usage; 3 LOG unreadable or\n"
    "malformed, or the output not writable\n"
    "\n"
    "example:\n"
    "  invcal calibrate tests/data/xsens_mti_positions.csv --positions --gravity 9.81744 \\\n"
    "      --zero 33123,33276,32360 --lsb 0.0024096,0.0024213,0.0024096 --out cal.json\n",
    NULL};

const tool_command calibrate_command = {"calibrate", "a log, or position means, to a calibration",
                                        help, run_calibrate};

static const char *const watch_help[] = {
    "usage: invcal watch LOG [options]\n"
    "\n"
    "Leads through a calibration while the samples come in: tells when to hold still and when to\n"
    "move on, where to turn next, and how exactly everything is known by now. At the end of the\n"
    "stream it prints what invcal calibrate prints of the same samples.\n"
    "\n"
    "LOG is a stream of samples, as a rule - for the standard input: a serial port, or invcal\n"
    "simulate. Its columns are those of invcal calibrate. Ctrl-C ends it, with the result.\n"
    "Malformed lines are told and skipped.\n"
    "\n"
    "  --plan SET          follows a set of positions, with the angles of a stand; a rest in "
    "another\n"
    "                      position is named, and used. Default: the direction that tells most, "
    "from\n"
    "                      what has been taken. One of\n",
    DESIGN_WORDS,
    "  --mean-sigma S      holds each position until its mean is as good, in field units, by the\n"
    "                      noise of the first rest; default: 2 seconds\n"
    "  --allan NOISE.json  the same by all that invcal allan --out has found in a long rest:\n"
    "                      what does not average out, too\n"
    "  --target D,K,G      sigma of offsets (over the field), scale errors and angles (rad) that\n"
    "                      is enough; 0: any\n"
    "  --zero X,Y,Z        nominal reading in no field; default for the guidance: 0, from the\n"
    "                      fourth position on the middle of each axis' range; with --plan, where\n"
    "                      that is far off, what its first three positions tell\n"
    "  --lsb S | SX,SY,SZ  nominal scale; default for the guidance: by the unit that is\n"
    "                      stated, else from the first samples\n",
    "\n"
    "These are the options of invcal calibrate, whose help says more of them:\n"
    "\n"
    "  --gravity G         length of the field; default 9.80665 (m/s^2)\n"
    "  --latitude DEG      normal gravity there in its place,\n"
    "  --height M          so high above the sea, m\n"
    "  --frame symmetric|triangular\n"
    "                      of the result; default symmetric\n"
    "  --unit g|mg|m/s2|counts\n"
    "                      of the readings\n"
    "  --units everyday|ins\n"
    "                      of figures for people: mg, % and degrees, or ug, ppm and arcsec\n"
    "  --nominal CAL.json  an earlier calibration in place of --zero and --lsb\n"
    "  --nominal-name WORD heading of the nominal column; default nominal\n"
    "  --noise S           standard deviation of one position mean, in field units\n"
    "  --prior D,K,G       standard deviations of what the nominal may be wrong by\n"
    "  --thermal 1|2       straight lines or parabolas of temperature\n"
    "  --slope D,K,G       standard deviations of what slopes may be, per K\n"
    "  --rate HZ           samples a second; default: by the column t, else 100\n"
    "  --clip LOW,HIGH     the least and the greatest reading of the sensor\n"
    "  --keep-all          leaves no position out\n"
    "  --need U            what calibrated lengths may be wrong by in 95 % of cases, in the unit\n"
    "                      of --gravity: says when that is reached\n"
    "  --tolerance D,K,G   limits of the data sheet: says which parameters are beyond\n"
    "  --out CAL.json      write the result to a file, as JSON, for invcal apply\n"
    "  --report R.html     write a page with the verdict, figures and pictures\n"
    "  --json              print the result as JSON in place of the table, the guidance on\n"
    "                      stderr\n"
    "  --quiet             print neither guidance nor table, only errors\n"
    "\n"
    "exit codes: 0 good; 1 the data cannot be calibrated; 2 usage; 3 LOG unreadable or\n"
    "malformed, or the output not writable\n"
    "\n"
    "example:\n"
    "  invcal simulate --plan edges | invcal watch -\n",
    NULL};

const tool_command watch_command = {"watch", "lead through a calibration, live", watch_help,
                                    run_watch};
