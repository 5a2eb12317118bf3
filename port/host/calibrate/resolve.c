/* SPDX-License-Identifier: MIT */
#include "calibrate/resolve.h"

#include <math.h>

#include "calibrate/refuse.h"
#include "cli/command.h"
#include "cli/message.h"
#include "result/calibration_file.h"
#include "text/number.h"

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
        invcal_apply(c, &data->mean[3 * (size_t)k], v);
        sum += log(sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / r->settings.field);
    }
    return sensors_fit(&r->sensor, exp(sum / data->count), reason, remedy)
               ? EXIT_GOOD
               : calibrate_refuse_readings(result, reason, remedy);
}

int resolve_nominal(const request *r, calibrate_result *result)
{
    const positions *data = result->data;
    nominal_choice *n = &result->nominal;
    double zero[3];
    double lsb[3];

    if (r->value[OPT_NOMINAL]) {
        n->zero = n->lsb = NOMINAL_EARLIER;
        return calibration_file_read(r->value[OPT_NOMINAL], &n->calibration);
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

/* The mean length of the readings, counts, from the nominal zero. */
static double mean_length(const positions *data, const invcal_calibration *nominal)
{
    double sum = 0;

    for (unsigned n = 0; n < data->count; n++) {
        double square = 0;
        for (unsigned i = 0; i < 3; i++) {
            const double d = data->mean[3 * (size_t)n + i] - nominal->offset[i];
            square += d * d;
        }
        sum += sqrt(square) / data->count;
    }
    return sum;
}

/* Near enough to 1 for a nominal zero and scale. */
static int is_about_one(double x)
{
    return x > 0.4 && x < 2.5;
}

int resolve_check_scale(const request *r, const positions *data, const nominal_choice *nominal)
{
    const double field = r->settings.field;
    const double lsb = fabs(nominal->calibration.matrix[0][0]);
    const double counts = mean_length(data, &nominal->calibration);
    char numerator[NUMBER_TEXT_MAX];

    if (nominal->lsb != NOMINAL_GIVEN || is_about_one(counts * lsb / field) ||
        !(is_about_one(counts / lsb) || is_about_one(counts / (lsb * field)))) {
        return EXIT_GOOD;
    }
    const double meant = is_about_one(counts / lsb) ? field : 1;
    return message_usage(r->syntax->command,
                         "--lsb is field per count, not counts per field: with %.6g these readings "
                         "are %.3g times the field; use --lsb %s/%.6g, which is %.6g",
                         lsb, counts * lsb / field, number_text(meant, numerator), lsb,
                         meant / lsb);
}

int resolve_magnetometer(const request *r, nominal_choice *n)
{
    invcal_calibration c = {.offset = {0}};

    n->zero = r->value[OPT_ZERO] ? NOMINAL_GIVEN : NOMINAL_UNIT;
    n->lsb = r->value[OPT_LSB] ? NOMINAL_GIVEN : NOMINAL_UNIT;
    if (r->value[OPT_NOMINAL]) {
        n->zero = n->lsb = NOMINAL_EARLIER;
        return calibration_file_read(r->value[OPT_NOMINAL], &n->calibration);
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
        message("%s: the noise from its std columns is larger than the field (--gravity)",
                data->name);
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
