/* SPDX-License-Identifier: MIT */
#include "result/refusal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/plan.h"
#include "invcal/positions.h"
#include "result/gyro.h"
#include "plan/guidance.h"

#define POSITIONS_GOOD 12u /* minimum with redundancy */
#define SIGMA_MAX 4.0 /* of a parameter that counts as determined, over that of a position mean */

static const invcal_calibration identity = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

int refusal_is_wrong(const calibrate_result *r, unsigned position)
{
    return (r->refused.is_of_position && r->refused.position == position) ||
           rejection_has(&r->rejected, r->rejected.count, position);
}

/* ---- where they point -------------------------------------------------------------------------- */

double refusal_length(const calibrate_result *r, const invcal_calibration *view, unsigned position)
{
    double v[3];

    invcal_apply(view, r->data->mean[3 * (size_t)position], r->data->mean[3 * (size_t)position + 1],
                 r->data->mean[3 * (size_t)position + 2], v);
    return length(v);
}

/* Means of the lengths and of their squares. */
static void average(const calibrate_result *r, const invcal_calibration *view, double *mean,
                    double *square)
{
    unsigned count = 0;

    *mean = *square = 0;
    for (unsigned n = 0; n < r->data->count; n++) {
        const double one = refusal_length(r, view, n);
        if (!r->refused.is_of_position || r->refused.position != n) {
            *mean += one;
            *square += one * one;
            count++;
        }
    }
    *mean /= count;
    *square /= count;
}

double refusal_mean_length(const calibrate_result *r, const invcal_calibration *view)
{
    double mean;
    double square;

    average(r, view, &mean, &square);
    return mean;
}

/* Variance of the lengths over the square of their mean. */
static double length_variance(const calibrate_result *r, const invcal_calibration *view)
{
    double mean;
    double square;

    average(r, view, &mean, &square);
    return square / (mean * mean) - 1;
}

refusal_view refusal_find_view(const calibrate_result *r, invcal_calibration *view)
{
    const invcal_calibration *nominal = &r->settings.nominal;
    const int has_nominal = fabs(nominal->matrix[0][0]) > 0;

    if (has_nominal && r->nominal.zero != NOMINAL_RANGE) {
        *view = *nominal;
        return REFUSAL_BY_NOMINAL;
    }
    const double by_zero = length_variance(r, &identity);
    const double by_range = has_nominal ? length_variance(r, nominal) : HUGE_VAL;
    *view = by_range < by_zero ? *nominal : identity;
    return by_range < by_zero   ? REFUSAL_BY_RANGE
           : by_zero < HUGE_VAL ? REFUSAL_BY_ZERO
                                : REFUSAL_NO_VIEW;
}

int refusal_up(const calibrate_result *r, const invcal_calibration *view, unsigned position,
               double up[3])
{
    double v[3];

    invcal_apply(view, r->data->mean[3 * (size_t)position], r->data->mean[3 * (size_t)position + 1],
                 r->data->mean[3 * (size_t)position + 2], v);
    const double size = length(v);
    for (unsigned i = 0; i < 3; i++) {
        up[i] = v[i] / size;
    }
    return size > 0 && size < HUGE_VAL;
}

/* ---- which to add ------------------------------------------------------------------------------ */

/* Up directions: those of the positions, then those to add. */
typedef struct {
    double (*up)[3];
    unsigned count;
} directions;

static int determines_nine(const directions *d)
{
    const invcal_positions given = fit_positions(d->up[0], d->count, &identity, 0);
    double root[INVCAL_PARAMETERS];
    int is_determined = d->count >= POSITIONS_GOOD;

    invcali_prospect(&given, NULL, root);
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        is_determined = is_determined && root[p] <= SIGMA_MAX;
    }
    return is_determined;
}

static int determines_nonlinearity(const directions *d, unsigned degree)
{
    nonlinearity_prospect p;

    return d->count >= nonlinearity_min_positions(degree) &&
           nonlinearity_judge((const double(*)[3])d->up, NULL, d->count, degree, &p, NULL);
}

/* Of the axes and the directions midway between two of them, the one farthest from all that are
 * there. */
static void find_gap(const directions *d, double out[3])
{
    double farthest = HUGE_VAL; /* as a cosine */

    for (unsigned n = 0; n < 27; n++) {
        const unsigned step[3] = {n % 3, n / 3 % 3, n / 9};
        const double v[3] = {step[0] - 1.0, step[1] - 1.0, step[2] - 1.0};
        const double size = length(v);
        double nearest = -2;
        if (!(size > 0.5 && size < 1.5)) {
            continue;
        }
        for (unsigned k = 0; k < d->count; k++) {
            const double *u = d->up[k];
            nearest = fmax(nearest, (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / size);
        }
        if (nearest < farthest - 1e-9) {
            farthest = nearest;
            for (unsigned i = 0; i < 3; i++) {
                out[i] = v[i] / size;
            }
        }
    }
}

static void find_direction(const directions *d, unsigned degree, double out[3])
{
    const invcal_positions given = fit_positions(d->up[0], d->count, &identity, 0);

    if (degree > 0) {
        find_gap(d, out);
    } else {
        invcali_next(&given, out);
    }
}

static directions find_directions(const calibrate_result *r)
{
    directions d = {calloc((size_t)r->data->count + REFUSAL_DIRECTIONS + 1, sizeof *d.up), 0};
    invcal_calibration view;

    if (d.up && refusal_find_view(r, &view) != REFUSAL_NO_VIEW) {
        for (unsigned n = 0; n < r->data->count; n++) {
            d.count +=
                (unsigned)(!refusal_is_wrong(r, n) && refusal_up(r, &view, n, d.up[d.count]));
        }
    }
    return d;
}

unsigned refusal_additions(const calibrate_result *r, refusal_direction out[REFUSAL_DIRECTIONS])
{
    const unsigned degree = r->refused.degree;
    unsigned count = 0;

    if (!r->refused.wants_positions) {
        return 0;
    }
    directions d = find_directions(r);
    while (d.up && count < REFUSAL_DIRECTIONS &&
           !(degree > 0 ? determines_nonlinearity(&d, degree) : determines_nine(&d))) {
        find_direction(&d, degree, out[count].up);
        memcpy(d.up[d.count++], out[count].up, sizeof *d.up);
        (void)invcal_direction_text(out[count].up, out[count].words);
        count++;
    }
    free(d.up);
    return count;
}

/* ---- report -------------------------------------------------------------------------------------- */

const char *refusal_text(const calibrate_result *r, char text[REFUSAL_TEXT_MAX])
{
    snprintf(text, REFUSAL_TEXT_MAX, "%s%s%s", r->refused.reason, *r->refused.remedy ? "; " : "",
             r->refused.remedy);
    return text;
}

void refusal_json(FILE *file, const calibrate_result *r)
{
    refusal_direction add[REFUSAL_DIRECTIONS];
    const unsigned count = refusal_additions(r, add);
    json_writer w;

    json_begin(&w, file);
    json_text(&w, "error", r->refused.word);
    json_text(&w, "reason", r->refused.reason);
    json_text(&w, "next", r->refused.remedy);
    json_parameters(&w, "undetermined", r->refused.undetermined);
    json_list(&w, "add");
    for (unsigned n = 0; n < count; n++) {
        json_object(&w, NULL);
        json_vector(&w, "up", add[n].up);
        json_text(&w, "words", add[n].words);
        json_object_end(&w);
    }
    json_list_end(&w);
    if (r->gyro.word) {
        gyro_json(&w, r);
    }
    json_end(&w);
}
