/* SPDX-License-Identifier: MIT */
#include "watch/zero.h"

#include <math.h>

#include "fit/fit.h"
#include "fit/nominal.h"

#define RENEW 4u    /* positions whose range says more than the first reading */
#define FAR_OFF 0.7 /* mean of unit vectors that differ less than positions do */

/* Field units per input unit, if the stated unit gives it; else 0. */
static double scale_of_unit(const zero_finder *z)
{
    const reading_unit stated =
        z->wish->unit != UNIT_UNKNOWN ? z->wish->unit : z->log->where.seen.unit;

    return unit_scale(stated, z->wish->field);
}

/* The same, or by the sensor. */
static double stated_scale(const zero_finder *z)
{
    const double unit = scale_of_unit(z);

    return unit > 0 || !z->wish->sensor.type ? unit
                                             : sensors_scale(&z->wish->sensor, z->wish->field);
}

/* The first readings, a geometric mean of them, can be the sensor's that was stated: it would be late to say
 * so at the end. */
int zero_fits_sensor(const live_wish *wish, const samples *log, char text[SENSORS_TEXT_MAX])
{
    const zero_finder z = {.wish = wish, .log = log};
    double sum = 0;

    if (!wish->sensor.type || wish->zero || wish->lsb || scale_of_unit(&z) > 0) {
        return 1;
    }
    for (unsigned n = 0; n < log->ahead_count; n++) {
        const double *v = log->ahead[n];
        sum +=
            log10(sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) * stated_scale(&z) / wish->field);
    }
    return log->ahead_count == 0 ||
           sensors_fit(&wish->sensor, pow(10, sum / log->ahead_count), text);
}

int zero_is_free(const zero_finder *z)
{
    return !z->wish->nominal && !z->wish->zero && !z->wish->lsb && !(stated_scale(z) > 0);
}

int zero_is_guess(const zero_finder *z)
{
    return zero_is_free(z) && z->taken->count < (z->wish->set ? LIVE_PROGRAM_FOLLOWED : RENEW);
}

/* Free hand: with zero where it is, all positions so far point one way, although they were to differ: then it
 * is nowhere near, as in counts that have no sign. */
static int is_far_off(const zero_finder *z)
{
    double sum[3] = {0, 0, 0};

    for (unsigned n = 0; n < z->taken->count; n++) {
        for (unsigned i = 0; i < 3; i++) {
            sum[i] += z->taken->mean[3 * n + i] * z->lsb / z->wish->field;
        }
    }
    const double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    return length > FAR_OFF * z->taken->count;
}

/* Over the field, for counts of the log. Returns 1 if it is usable. */
static int nominal_of_counts(const zero_finder *z, const double zero[3], const double lsb[3],
                             invcal_calibration *out)
{
    double counts[3];
    double zero_counts[3];

    for (unsigned i = 0; i < 3; i++) {
        zero_counts[i] = zero[i] / z->log->unit;
        counts[i] = z->wish->field / (lsb[i] * z->log->unit);
    }
    return invcal_nominal(zero_counts, counts, out) == INVCAL_OK;
}

/* The middle of the ranges is the better zero then, and the widest gives the scale. Returns 1 if so. */
static int find_by_range(const zero_finder *z, double zero[3], double lsb[3])
{
    if (z->taken->count < RENEW || !is_far_off(z) ||
        !nominal_from_range(z->taken, z->wish->field, zero, lsb)) {
        return 0;
    }
    lsb[0] = lsb[1] = lsb[2] = fmin(lsb[0], fmin(lsb[1], lsb[2]));
    return 1;
}

/* Where a program is followed, its directions are more informative, as long as it is. */
static int find_by_program(const zero_finder *z, double zero[3], double lsb[3])
{
    double length;
    const int is_found = live_program_scale(z->followed, zero, &length);

    lsb[0] = lsb[1] = lsb[2] = is_found ? z->wish->field / length : 1;
    return is_found;
}

/* All positions so far are readings of the field with this nominal. */
static int fits_all(const invcal_session *session, const invcal_calibration *nominal)
{
    return invcal_bad_reading(session->mean[0], session->count, nominal) == session->count;
}

static int find(const zero_finder *z, int is_determined, double zero[3], double lsb[3])
{
    return is_determined  ? nominal_from_range(z->taken, z->wish->field, zero, lsb)
           : z->wish->set ? find_by_program(z, zero, lsb)
                          : find_by_range(z, zero, lsb);
}

void zero_renew(const zero_finder *z, int is_determined, invcal_session *session)
{
    invcal_calibration nominal;
    double zero[3];
    double lsb[3];

    if (zero_is_free(z) && find(z, is_determined, zero, lsb) &&
        nominal_of_counts(z, zero, lsb, &nominal) && fits_all(session, &nominal)) {
        session->nominal = nominal; /* else the old one goes on */
    }
}

/* The largest of the first readings stands for the field. */
static double guess_lsb(const zero_finder *z, const double zero[3])
{
    double most = 0;

    for (unsigned n = 0; n < z->log->ahead_count; n++) {
        double square = 0;
        for (unsigned i = 0; i < 3; i++) {
            const double v = z->log->ahead[n][i] - zero[i];
            square += v * v;
        }
        most = fmax(most, square);
    }
    return most > 0 ? z->wish->field / sqrt(most) : 1;
}

int zero_begin(zero_finder *z, const live_wish *wish, const samples *log, const positions *taken,
               const live_program *followed, invcal_calibration *out)
{
    static const double origin[3] = {0, 0, 0};
    const double *zero = wish->zero ? wish->zero : origin;
    double lsb[3];

    *z = (zero_finder){.wish = wish, .log = log, .taken = taken, .followed = followed};
    z->lsb = guess_lsb(z, origin);
    if (wish->nominal) {
        *out = fit_over_field(wish->nominal, wish->field / log->unit);
        for (unsigned i = 0; i < 3; i++) {
            out->offset[i] /= log->unit;
        }
        return 1;
    }
    const double guess = stated_scale(z) > 0 ? stated_scale(z) : guess_lsb(z, zero);
    for (unsigned i = 0; i < 3; i++) {
        lsb[i] = wish->lsb ? wish->lsb[i] : guess;
    }
    return nominal_of_counts(z, zero, lsb, out);
}
