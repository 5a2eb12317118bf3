/* SPDX-License-Identifier: MIT */
#include "calibrate/settle.h"

#include <math.h>

#include "calibrate/refuse.h"
#include "cli/command.h"
#include "cli/message.h"
#include "result/calibration_file.h"

/* No calculation can be made with numbers so large or so small. */
static int refuse_nominal(const request *r, const positions *data, const nominal_choice *n)
{
    const fit_reason all = {data->count, (1u << INVCAL_PARAMETERS) - 1};

    if (r->value[ASK_LSB]) {
        return request_usage(r, ASK_LSB, "is too small or too large a scale for any calculation");
    }
    return calibrate_refuse(data, &r->settings, n, &r->stand, INVCAL_UNDETERMINED, &all,
                            r->value[ASK_JSON] != NULL);
}

void settle_unit(const request *r, positions *data)
{
    recognition *seen = &data->seen;

    if (r->value[ASK_UNIT]) {
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
    const int is_stated = !r->value[ASK_LSB] && data->seen.unit_from != UNIT_FROM_SIZE;
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

int settle_nominal(const request *r, const positions *data, nominal_choice *n)
{
    double zero[3];
    double lsb[3];

    if (r->value[ASK_NOMINAL]) {
        n->zero = n->lsb = NOMINAL_EARLIER;
        return calibration_file_read(r->value[ASK_NOMINAL], &n->calibration);
    }
    const int has_scale = guess_nominal(r, data, n, zero, lsb);
    n->zero = r->value[ASK_ZERO] ? NOMINAL_GIVEN : n->zero;
    n->lsb = r->value[ASK_LSB] ? NOMINAL_GIVEN : n->lsb;
    if (!has_scale && n->lsb == NOMINAL_RANGE) {
        return refuse_nominal(r, data, n);
    }
    return nominal_make(r->value[ASK_ZERO] ? r->zero : zero, r->value[ASK_LSB] ? r->lsb : lsb,
                        r->settings.field, &n->calibration)
               ? EXIT_GOOD
               : refuse_nominal(r, data, n);
}

int settle_magnetometer(const request *r, nominal_choice *n)
{
    invcal_calibration c = {.offset = {0}};

    n->zero = r->value[ASK_ZERO] ? NOMINAL_GIVEN : NOMINAL_UNIT;
    n->lsb = r->value[ASK_LSB] ? NOMINAL_GIVEN : NOMINAL_UNIT;
    if (r->value[ASK_NOMINAL]) {
        n->zero = n->lsb = NOMINAL_EARLIER;
        return calibration_file_read(r->value[ASK_NOMINAL], &n->calibration);
    }
    for (unsigned i = 0; i < 3; i++) {
        c.offset[i] = r->value[ASK_ZERO] ? r->zero[i] : 0;
        c.matrix[i][i] = r->value[ASK_LSB] ? r->lsb[i] : 1;
    }
    n->calibration = c;
    return EXIT_GOOD;
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

int settle_noise(const request *r, const positions *data, calibrate_result *result)
{
    result->is_noise_given = r->value[ASK_NOISE] != NULL;
    if (!r->value[ASK_NOISE] && data->has_noise) {
        result->settings.noise = noise_of_file(data, &result->settings.nominal);
    }
    if (!(result->settings.noise < 1)) {
        if (r->value[ASK_NOISE]) {
            return request_usage(r, ASK_NOISE, "is larger than the field (--gravity)");
        }
        message("%s: its std columns tell a noise larger than the field (--gravity)", data->name);
        return EXIT_FILE;
    }
    if (fit_has_prior(&result->settings) && !(result->settings.noise > 0)) {
        return request_usage(r, r->value[ASK_SIX_FACES] ? ASK_SIX_FACES : ASK_PRIOR,
                             "is weighed against the noise of a position mean, so state that: "
                             "--noise, or columns std and n");
    }
    if (r->value[ASK_SLOPE] && !(result->settings.noise > 0)) {
        return request_usage(r, ASK_SLOPE,
                             "is weighed against the noise of a position mean, so state that: "
                             "--noise, or columns std and n");
    }
    return EXIT_GOOD;
}
