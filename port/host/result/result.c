/* SPDX-License-Identifier: MIT */
#include "result/result.h"

#include <math.h>

#define MANY_LEFT_OUT 6 /* more than one position in so many: chance does not take these */
#define UNEXPLAINED 3.0 /* times the noise: a hand that holds the device comes near it */

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

const char *calibrate_field_unit(const calibrate_result *result)
{
    if (result->magnetometer && !result->is_field_stated &&
        result->data->seen.unit != UNIT_UNKNOWN) {
        return calibrate_input_unit(result);
    }
    return calibrate_is_gravity(result) ? "m/s²" : "field units";
}

told_unit calibrate_told_field(const calibrate_result *result)
{
    return told_field(result->told, calibrate_is_gravity(result));
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
