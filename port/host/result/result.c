/* SPDX-License-Identifier: MIT */
#include "result/result.h"

#include <math.h>

#define LEFT_OUT_PART 6     /* more than one position in 6 is not chance */
#define NOISE_RATIO_MIN 3.0 /* smaller ratios may be the tremor of a hand */
#define SAME_UNIT_RATIO 2.0 /* lengths in one unit differ by less, those in two units by more */

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

/* The field of a magnetometer is in the unit of its readings if they measure it, or if the stated
 * length is about the measured one: no two units of a magnetic field are that close. */
static int is_field_in_input_units(const calibrate_result *r)
{
    const double scale = r->nominal.calibration.matrix[0][0];

    return r->magnetometer &&
           (r->is_field_stated
                ? r->nominal.lsb == NOMINAL_RANGE && scale > 1 / SAME_UNIT_RATIO &&
                      scale < SAME_UNIT_RATIO
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

display_unit calibrate_display_unit(const calibrate_result *result)
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

double calibrate_noise_ratio(const calibrate_result *result)
{
    const double expected = result->settings.noise;

    return expected > 0 ? result->quality.noise / expected : 0;
}

double calibrate_unexplained(const calibrate_result *result)
{
    const double times = calibrate_noise_ratio(result);

    return times >= NOISE_RATIO_MIN ? times : 0;
}

int calibrate_many_left_out(const calibrate_result *result)
{
    const rejection *r = &result->rejected;

    return LEFT_OUT_PART * (r->count - rejection_drifting(r)) > r->count + r->kept_count;
}
