/* SPDX-License-Identifier: MIT */
#include "result/result.h"

#include <math.h>

#define MANY_LEFT_OUT 6 /* more than one position in so many: chance does not take these */
#define UNEXPLAINED 3.0 /* times the noise: a hand that holds the device comes near it */
#define CLOSE 2.0       /* ratio of two lengths in one unit; the units of a field differ by more */

static double time_of(const positions *p, unsigned i)
{
    const position_origin *o = &p->origin[i];

    return isnan(o->begin) ? i : (o->begin + o->end) / 2;
}

double calibrate_tau(const positions *data, unsigned position)
{
    return calibrate_tau_at(data, time_of(data, position));
}

double calibrate_tau_at(const positions *data, double time)
{
    const double first = time_of(data, 0);

    return (time - first) / (time_of(data, data->count - 1) - first) - 0.5;
}

const char *calibrate_frame(const calibrate_result *result)
{
    return result->is_stand_frame           ? "stand"
           : result->is_dip_frame           ? "accelerometer"
           : result->frame.used > 0         ? "case"
           : result->settings.is_triangular ? "triangular"
                                            : "symmetric";
}

int calibrate_is_gravity(const calibrate_result *result)
{
    return !result->magnetometer && unit_is_gravity(result->settings.field);
}

/* A field of a magnetometer is in the unit of its readings if these measure it, or if it is stated about as
 * long as they read it: no two units of a magnetometer are that close. */
static int is_field_in_input_units(const calibrate_result *r)
{
    const double scale = r->nominal.calibration.matrix[0][0];

    return r->magnetometer &&
           (r->is_field_stated
                ? r->nominal.lsb == NOMINAL_RANGE && scale > 1 / CLOSE && scale < CLOSE
                : r->nominal.lsb == NOMINAL_UNIT || r->data->seen.unit != UNIT_UNKNOWN);
}

const char *calibrate_field_unit(const calibrate_result *result)
{
    if (result->field_unit != UNIT_UNKNOWN) {
        return unit_words(result->field_unit);
    }
    if (is_field_in_input_units(result)) {
        return calibrate_input_unit(result);
    }
    return calibrate_is_gravity(result) ? "m/s²" : "field units";
}

display_unit calibrate_told_field(const calibrate_result *result)
{
    return unit_style_field(result->units, calibrate_is_gravity(result));
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
