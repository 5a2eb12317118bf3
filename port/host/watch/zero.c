/* SPDX-License-Identifier: MIT */
#include "watch/zero.h"

#include <math.h>

#include "invcal/positions.h"
#include "fit/fit.h"
#include "fit/nominal.h"

#define RANGE_POSITIONS 4u /* positions whose range is more informative than the first samples */
#define FAR_MEAN 0.7       /* length of the mean of unit vectors: they hardly differ */

/* Field units per input unit, if the stated unit gives it; else 0. */
static double scale_of_unit(const zero_finder *z)
{
    const reading_unit stated =
        z->options->unit != UNIT_UNKNOWN ? z->options->unit : z->log->where.seen.unit;

    return unit_scale(stated, z->options->field);
}

/* The same, or from the sensor. */
static double stated_scale(const zero_finder *z)
{
    const double unit = scale_of_unit(z);

    return unit > 0 || !z->options->sensor.type
               ? unit
               : sensors_scale(&z->options->sensor, z->options->field);
}

/* Compares the geometric mean of the first readings, since at the end it would be late to say
 * so. */
int zero_fits_sensor(const live_options *options, const samples *log, char text[SENSORS_TEXT_MAX],
                     char remedy[SENSORS_TEXT_MAX])
{
    const zero_finder z = {.options = options, .log = log};
    double sum = 0;

    if (!options->sensor.type || options->zero || options->lsb || scale_of_unit(&z) > 0) {
        return 1;
    }
    for (unsigned n = 0; n < log->ahead_count; n++) {
        const double *v = log->ahead[n];
        sum += log10(sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) * stated_scale(&z) /
                     options->field);
    }
    return log->ahead_count == 0 ||
           sensors_fit(&options->sensor, pow(10, sum / log->ahead_count), text, remedy);
}

int zero_is_unstated(const zero_finder *z)
{
    return !z->options->nominal && !z->options->zero && !z->options->lsb && !(stated_scale(z) > 0);
}

int zero_is_guess(const zero_finder *z)
{
    return zero_is_unstated(z) &&
           z->taken->count < (z->options->set ? LIVE_PROGRAM_FOLLOWED : RANGE_POSITIONS);
}

/* Without a program: with a zero of 0, all positions so far have about one direction, although they
 * should differ. So the zero is far from 0, as in unsigned counts. */
static int is_far_off(const zero_finder *z)
{
    double sum[3] = {0, 0, 0};

    for (unsigned n = 0; n < z->taken->count; n++) {
        for (unsigned i = 0; i < 3; i++) {
            sum[i] += z->taken->mean[3 * n + i] * z->lsb / z->options->field;
        }
    }
    const double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    return length > FAR_MEAN * z->taken->count;
}

/* Over the field, for counts of the log. Returns 1 if it is usable. */
static int nominal_of_counts(const zero_finder *z, const double zero[3], const double lsb[3],
                             invcal_calibration *out)
{
    double counts[3];
    double zero_counts[3];

    for (unsigned i = 0; i < 3; i++) {
        zero_counts[i] = zero[i] / z->log->unit;
        counts[i] = z->options->field / (lsb[i] * z->log->unit);
    }
    return invcal_nominal(zero_counts, counts, out) == INVCAL_OK;
}

/* If it is, zero is the middle of the ranges, and the widest gives the scale. Returns 1 if so. */
static int find_by_range(const zero_finder *z, double zero[3], double lsb[3])
{
    if (z->taken->count < RANGE_POSITIONS || !is_far_off(z) ||
        !nominal_from_range(z->taken, z->options->field, zero, lsb)) {
        return 0;
    }
    lsb[0] = lsb[1] = lsb[2] = fmin(lsb[0], fmin(lsb[1], lsb[2]));
    return 1;
}

/* The directions of a program are more informative, as long as it is followed. */
static int find_by_program(const zero_finder *z, double zero[3], double lsb[3])
{
    double length;
    const int is_found = live_program_scale(z->followed, zero, &length);

    lsb[0] = lsb[1] = lsb[2] = is_found ? z->options->field / length : 1;
    return is_found;
}

/* 1 if, with this nominal, all positions so far are possible readings of the field. */
static int fits_all(const invcal_session *session, const invcal_calibration *nominal)
{
    const invcal_positions given = {
        .mean = session->mean, .count = session->count, .nominal = nominal};

    return invcal_bad_reading(&given) == session->count;
}

static int find(const zero_finder *z, int is_determined, double zero[3], double lsb[3])
{
    return is_determined     ? nominal_from_range(z->taken, z->options->field, zero, lsb)
           : z->options->set ? find_by_program(z, zero, lsb)
                             : find_by_range(z, zero, lsb);
}

void zero_update(const zero_finder *z, int is_determined, invcal_session *session)
{
    invcal_calibration nominal;
    double zero[3];
    double lsb[3];

    if (zero_is_unstated(z) && find(z, is_determined, zero, lsb) &&
        nominal_of_counts(z, zero, lsb, &nominal) && fits_all(session, &nominal)) {
        session->nominal = nominal; /* else the old one stays */
    }
}

/* Assumes that the largest of the first readings is the field. */
static double guess_lsb(const zero_finder *z, const double zero[3])
{
    double max = 0;

    for (unsigned n = 0; n < z->log->ahead_count; n++) {
        double square = 0;
        for (unsigned i = 0; i < 3; i++) {
            const double v = z->log->ahead[n][i] - zero[i];
            square += v * v;
        }
        max = fmax(max, square);
    }
    return max > 0 ? z->options->field / sqrt(max) : 1;
}

int zero_begin(zero_finder *z, const live_options *options, const samples *log,
               const positions *taken, const live_program *followed, invcal_calibration *out)
{
    static const double origin[3] = {0, 0, 0};
    const double *zero = options->zero ? options->zero : origin;
    double lsb[3];

    *z = (zero_finder){.options = options, .log = log, .taken = taken, .followed = followed};
    z->lsb = guess_lsb(z, origin);
    if (options->nominal) {
        *out = fit_over_field(options->nominal, options->field / log->unit);
        for (unsigned i = 0; i < 3; i++) {
            out->offset[i] /= log->unit;
        }
        return 1;
    }
    const double guess = stated_scale(z) > 0 ? stated_scale(z) : guess_lsb(z, zero);
    for (unsigned i = 0; i < 3; i++) {
        lsb[i] = options->lsb ? options->lsb[i] : guess;
    }
    return nominal_of_counts(z, zero, lsb, out);
}
