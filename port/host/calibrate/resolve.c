/* SPDX-License-Identifier: MIT */
#include "calibrate/resolve.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "calibrate/refuse.h"
#include "cli/command.h"
#include "cli/message.h"
#include "maths/median.h"
#include "result/calibration_file.h"
#include "text/figure.h"
#include "text/number.h"

#define FIELD_TOLERANCE 0.1   /* of an earlier calibration: fields on earth differ by less */
#define READINGS_RATIO 1.5    /* readings over the field: no sensor has a larger scale error */
#define IMPOSSIBLE_RATIO 10.0 /* the library refuses readings beyond it */
#define MEANT_RATIO 1.15      /* readings that still match a scale: g is 1.23 times 8 */
#define RANGES_RATIO 32.0     /* from 2 g to 64 g */

/* The numbers are too large or too small to calculate with. */
static int refuse_nominal(const request *r, calibrate_result *result)
{
    const fit_reason all = {0, (1u << INVCAL_PARAMETERS) - 1};

    if (r->value[OPT_LSB]) {
        return request_usage(r, OPT_LSB, "the scale is too small or too large");
    }
    return calibrate_refuse(result, &r->stand, INVCAL_UNDETERMINED, &all);
}

void resolve_unit(const request *r, positions *data)
{
    recognition *seen = &data->seen;

    if (r->value[OPT_UNIT]) {
        seen->unit = r->unit;
        seen->unit_from = UNIT_FROM_OPTION;
    } else if (seen->unit == UNIT_UNKNOWN && !seen->states_foreign_unit) {
        seen->unit = unit_by_size(data->mean, data->count, r->settings.field);
        seen->unit_from = seen->unit != UNIT_UNKNOWN ? UNIT_FROM_SIZE : UNIT_FROM_NONE;
        if (r->sensor.type && !unit_is_sure(seen->unit, data->mean, data->count)) {
            seen->unit = UNIT_COUNTS;
            seen->unit_from = UNIT_FROM_SENSOR;
        }
    }
}

/* The scale of the unit, if it is stated or the size of the readings is conclusive; else 0. */
static double scale_of_unit(const request *r, const positions *data)
{
    const recognition *seen = &data->seen;
    const int is_known =
        seen->unit_from != UNIT_FROM_SIZE || unit_is_sure(seen->unit, data->mean, data->count);

    return is_known ? unit_scale(seen->unit, r->settings.field) : 0;
}

/* Zero and scale that are not stated: from the unit, the data sheet, or, as a starting point only,
 * the range of the data. Returns 0 if there is no scale. */
static int find_nominal(const request *r, const positions *data, nominal_choice *n, double zero[3],
                        double lsb[3])
{
    const double unit = scale_of_unit(r, data);
    const double sheet = r->sensor.type ? sensors_scale(&r->sensor, r->settings.field) : 0;

    if (!(unit > 0) && !(sheet > 0)) {
        n->zero = n->lsb = NOMINAL_RANGE;
        return nominal_from_range(data, r->settings.field, zero, lsb);
    }
    n->zero = n->lsb = unit > 0 ? NOMINAL_UNIT : NOMINAL_SENSOR;
    for (unsigned i = 0; i < 3; i++) {
        zero[i] = 0;
        lsb[i] = unit > 0 ? unit : sheet;
    }
    return 1;
}

/* Refuses readings that the stated sensor cannot have at the stated range. */
static int check_sensor(const request *r, calibrate_result *result)
{
    const positions *data = result->data;
    const nominal_choice *n = &result->nominal;
    const invcal_calibration *c = &n->calibration;
    char reason[SENSORS_TEXT_MAX];
    char remedy[SENSORS_TEXT_MAX];
    double sum = 0;

    if (n->lsb != NOMINAL_SENSOR) {
        return EXIT_GOOD;
    }
    /* the geometric mean, as single readings may be far off */
    for (unsigned k = 0; k < data->count; k++) {
        double v[3];
        invcal_apply(c, data->mean[3 * (size_t)k], data->mean[3 * (size_t)k + 1],
                     data->mean[3 * (size_t)k + 2], v);
        sum += log(sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / r->settings.field);
    }
    return sensors_fit(&r->sensor, exp(sum / data->count), reason, remedy)
               ? EXIT_GOOD
               : calibrate_refuse_readings(result, reason, remedy);
}

/* An earlier calibration, of such a sensor and over the same field. A file written by hand need not
 * state these. */
static int read_earlier(const request *r, nominal_choice *n)
{
    const char *path = r->value[OPT_NOMINAL];
    const int is_magnetometer = r->value[OPT_MAGNETOMETER] != NULL;
    static calibration_file file; /* large */
    const int failure = calibration_file_read_correction(path, &file);

    if (failure) {
        return failure;
    }
    if (isfinite(file.gravity) && file.is_magnetometer != is_magnetometer) {
        return message_usage(r->syntax->command, "--nominal %s: is a calibration of %s", path,
                             is_magnetometer ? "an accelerometer" : "a magnetometer");
    }
    if (!is_magnetometer && fabs(file.gravity / r->settings.field - 1) > FIELD_TOLERANCE) {
        return message_usage(r->syntax->command,
                             "--nominal %s: was made with --gravity %.6g, but here it is %.6g",
                             path, file.gravity, r->settings.field);
    }
    n->zero = n->lsb = NOMINAL_EARLIER;
    n->calibration = file.calibration;
    return EXIT_GOOD;
}

int resolve_nominal(const request *r, calibrate_result *result)
{
    const positions *data = result->data;
    nominal_choice *n = &result->nominal;
    double zero[3];
    double lsb[3];

    if (r->value[OPT_NOMINAL]) {
        return read_earlier(r, n);
    }
    n->sensor = r->sensor;
    const int has_scale = find_nominal(r, data, n, zero, lsb);
    n->zero = r->value[OPT_ZERO] ? NOMINAL_GIVEN : n->zero;
    n->lsb = r->value[OPT_LSB] ? NOMINAL_GIVEN : n->lsb;
    if (!has_scale && n->lsb == NOMINAL_RANGE) {
        return refuse_nominal(r, result);
    }
    return nominal_make(r->value[OPT_ZERO] ? r->zero : zero, r->value[OPT_LSB] ? r->lsb : lsb,
                        r->settings.field, &n->calibration)
               ? check_sensor(r, result)
               : refuse_nominal(r, result);
}

/* ---- the size of the readings -------------------------------------------------------------------- */

/* The median length of the readings in field units, which a few outliers do not change; NaN without
 * memory. */
static double median_length(const positions *data, const invcal_calibration *nominal)
{
    double *length = calloc((size_t)data->count + 1, sizeof *length);
    double middle = NUMBER_UNKNOWN;

    for (unsigned k = 0; length && k < data->count; k++) {
        double v[3];
        invcal_apply(nominal, data->mean[3 * (size_t)k], data->mean[3 * (size_t)k + 1],
                     data->mean[3 * (size_t)k + 2], v);
        length[k] = fmin(sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), DBL_MAX); /* no NaN */
    }
    if (length) {
        middle = median_of(length, data->count);
    }
    free(length);
    return middle;
}

/* The geometric mean of the three scales. */
static double scale_of(const invcal_calibration *nominal)
{
    return fabs(cbrt(nominal->matrix[0][0]) * cbrt(nominal->matrix[1][1]) *
                cbrt(nominal->matrix[2][2]));
}

/* No sensor has a larger scale error. */
static int is_about_one(double x)
{
    return x > 1 / READINGS_RATIO && x < READINGS_RATIO;
}

/* How many times the field the readings are by the nominal scale. A wrong zero changes their
 * lengths, and an outlier the radius of their sphere, so the one nearer to 1 counts; if they agree,
 * the radius is more accurate. NaN if there is no sphere: a few positions do not show it. */
static double size_of(const positions *data, const invcal_calibration *nominal, double field)
{
    invcal_calibration fitted;

    if (!nominal_from_sphere(data->mean, data->count, &fitted)) {
        return NUMBER_UNKNOWN;
    }
    const double by_radius = scale_of(nominal) / fitted.matrix[0][0] / field;
    const double by_length = median_length(data, nominal) / field;
    const double nearer = fabs(log(by_radius)) < fabs(log(by_length)) ? by_radius : by_length;
    return !is_about_one(nearer) && is_about_one(by_radius / by_length) ? by_radius : nearer;
}

/* Whether readings of this size fit a scale that is `factor` times the stated one. */
static int is_meant(double size, double factor)
{
    return size * factor < MEANT_RATIO && size * factor > 1 / MEANT_RATIO;
}

/* The scale that was meant, if the stated one is in g instead of m/s^2, or the reverse, or that of
 * another range, which are factors of 2 apart; 0: none of these. */
static double meant_scale(double lsb, double size, double field)
{
    const double g = unit_field_si(field) > 0 ? UNIT_STANDARD_GRAVITY : 1;
    const double range = exp2(-round(log2(size)));

    return is_meant(size, g)       ? lsb * g
           : is_meant(size, 1 / g) ? lsb / g
           : is_meant(size, range) && range <= RANGES_RATIO && range >= 1 / RANGES_RATIO
               ? lsb * range
               : 0;
}

/* Counts to a power of two, if they are within 5 % of one as most sensors, else to three digits. */
static double round_counts(double counts)
{
    const double power = exp2(round(log2(counts)));
    const double digit = pow(10, floor(log10(counts)) - 2);

    return fabs(counts / power - 1) < 0.05 ? power : round(counts / digit) * digit;
}

/* What a scale in field units is called. */
static const char *scale_unit(double field)
{
    const double si = unit_field_si(field);

    return unit_is_gravity(field) ? "m/s^2" : !(si > 0) ? "field units" : si > 1 ? "g" : "mg";
}

/* The reverse, counts per unit. */
static int refuse_inverse(const request *r, double lsb, double size, double meant)
{
    return message_usage(r->syntax->command,
                         "--lsb is field per count, not counts per field: with %.6g these readings "
                         "are %.3g times the field; use --lsb %.6g/%.6g, which is %.6g",
                         lsb, size, meant, lsb, meant / lsb);
}

static int refuse_scale(const request *r, double lsb, double size)
{
    const double field = r->settings.field;
    const double g = unit_scale(UNIT_G, field) > 0 ? unit_scale(UNIT_G, field) : field;
    const double fitting = lsb / size;
    const double meant = meant_scale(lsb, size, field);
    const int is_in_g =
        unit_is_gravity(field) && fabs(meant / lsb / UNIT_STANDARD_GRAVITY - 1) < 1e-9;
    char times[FIGURE_MAX];

    if (is_about_one(g / fitting / lsb) || is_about_one(1 / fitting / lsb)) {
        return refuse_inverse(r, lsb, size, is_about_one(g / fitting / lsb) ? g : 1);
    }
    figure_digits(size, 3, times);
    return meant > 0
               ? message_usage(r->syntax->command,
                               "with --lsb %s the readings are %s times the field: use --lsb "
                               "%.6g/%.6g (%s per count)%s",
                               r->value[OPT_LSB], times, g, g / meant, scale_unit(field),
                               is_in_g ? ", or --gravity 1 if it is in g" : "")
               : message_usage(r->syntax->command,
                               "with --lsb %s the readings are %s times the field: by the data "
                               "sheet it should be about %.6g/%.6g (%s per count)%s",
                               r->value[OPT_LSB], times, g, round_counts(g / fitting),
                               scale_unit(field),
                               r->value[OPT_GRAVITY] ? ", if --gravity is right" : "");
}

/* The unit in which readings have the length of the field, if they are `size` times that in the
 * stated unit; UNIT_UNKNOWN: none of these. */
static reading_unit fitting_unit(reading_unit stated, double field, double size)
{
    for (unsigned u = UNIT_G; u <= UNIT_MS2; u++) {
        const double ratio = unit_scale((reading_unit)u, field) / unit_scale(stated, field);
        if (u != (unsigned)stated && is_about_one(size * ratio)) {
            return (reading_unit)u;
        }
    }
    return UNIT_UNKNOWN;
}

/* Readings that are not in the stated unit. */
static int check_unit(const request *r, double size, calibrate_result *result)
{
    const recognition *seen = &result->data->seen;
    const reading_unit fitting = fitting_unit(seen->unit, r->settings.field, size);
    const int is_stated = seen->unit_from == UNIT_FROM_OPTION;
    const char *name = fitting == UNIT_MS2 ? "m/s2" : fitting == UNIT_MG ? "mg or counts" : "g";
    char times[FIGURE_MAX];
    char reason[REFUSAL_MAX];
    char remedy[REFUSAL_MAX];

    if (fitting == UNIT_UNKNOWN && size > 1 / IMPOSSIBLE_RATIO && size < IMPOSSIBLE_RATIO) {
        return EXIT_GOOD; /* a poor sensor */
    }
    snprintf(reason, sizeof reason, "the readings are %s times the field in %s unit, %s",
             figure_digits(size, 3, times), is_stated ? "the stated" : "the header's",
             unit_words(seen->unit));
    snprintf(remedy, sizeof remedy, "%s %s",
             is_stated ? "check --unit:" : "check the header, or state --unit",
             fitting == UNIT_UNKNOWN ? "counts" : name);
    return calibrate_refuse_readings(result, reason, remedy);
}

int resolve_check_size(const request *r, calibrate_result *result)
{
    const nominal_choice *nominal = &result->nominal;
    const int is_given = nominal->lsb == NOMINAL_GIVEN;

    if (!is_given && nominal->lsb != NOMINAL_UNIT) {
        return EXIT_GOOD;
    }
    const double size = size_of(result->data, &nominal->calibration, r->settings.field);
    return isnan(size) || is_about_one(size) ? EXIT_GOOD
           : is_given ? refuse_scale(r, scale_of(&nominal->calibration), size)
                      : check_unit(r, size, result);
}

int resolve_magnetometer(const request *r, nominal_choice *n)
{
    invcal_calibration c = {.offset = {0}};

    n->zero = r->value[OPT_ZERO] ? NOMINAL_GIVEN : NOMINAL_UNIT;
    n->lsb = r->value[OPT_LSB] ? NOMINAL_GIVEN : NOMINAL_UNIT;
    if (r->value[OPT_NOMINAL]) {
        return read_earlier(r, n);
    }
    for (unsigned i = 0; i < 3; i++) {
        c.offset[i] = r->value[OPT_ZERO] ? r->zero[i] : 0;
        c.matrix[i][i] = r->value[OPT_LSB] ? r->lsb[i] : 1;
    }
    n->calibration = c;
    return EXIT_GOOD;
}

void resolve_limits(const request *r, calibrate_result *result)
{
    double *limit = result->limit;

    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        limit[p] = NUMBER_UNKNOWN;
    }
    if (r->sensor.type) {
        sensors_limits(&r->sensor, r->settings.field, limit);
    }
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        limit[p] = r->value[OPT_TOLERANCE] ? r->tolerance[p / 3] : limit[p];
        result->has_limits = result->has_limits || limit[p] > 0;
    }
}

int resolve_noise(const request *r, const positions *data, calibrate_result *result)
{
    result->is_noise_given = r->value[OPT_NOISE] != NULL;
    if (!r->value[OPT_NOISE] && data->has_noise) {
        result->settings.noise = positions_noise(data, &result->settings.nominal);
    }
    if (!(result->settings.noise < 1)) {
        if (r->value[OPT_NOISE]) {
            return request_usage(r, OPT_NOISE, "is larger than the field (--gravity)");
        }
        message("%s: the noise %s is larger than the field (--gravity)", data->name,
                data->rests ? "of its rests" : "from its std columns");
        return EXIT_FILE;
    }
    if (fit_has_prior(&result->settings) && !(result->settings.noise > 0)) {
        return request_usage(
            r, r->value[OPT_SIX_FACES] ? OPT_SIX_FACES : OPT_PRIOR,
            "needs the noise of a position mean: state --noise, or columns std and n");
    }
    if (r->value[OPT_SLOPE] && !(result->settings.noise > 0)) {
        return request_usage(
            r, OPT_SLOPE,
            "needs the noise of a position mean: state --noise, or columns std and n");
    }
    return EXIT_GOOD;
}
