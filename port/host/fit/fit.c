/* SPDX-License-Identifier: MIT */
#include "fit/fit.h"

#include <math.h>
#include <string.h>

#include "invcal/expert.h"
#include "invcal/result.h"
#include "maths/eigen.h"
#include "maths/matrix.h"
#include "core/solve.h"
#include "core/sums.h"

#define ANGLES (7u << INVCAL_GAMMA_XY)

invcal_positions fit_positions(const double *raw, unsigned count, const invcal_calibration *nominal,
                               double noise)
{
    return (invcal_positions){.mean = (const invcal_vector *)raw, /* three numbers each, too */
                              .count = count,
                              .nominal = nominal,
                              .noise = noise};
}

int fit_has_prior(const fit_settings *settings)
{
    int has_prior = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        has_prior = has_prior || settings->prior[r] > 0;
    }
    return has_prior;
}

double fit_coverage(const fit_quality *quality, unsigned parameter)
{
    return quality->from_prior >> parameter & 1 ? FIT_NORMAL : quality->coverage;
}

uint16_t fit_held(const fit_settings *settings, const fit_quality *quality)
{
    return settings->is_six_faces ? quality->from_prior : 0;
}

invcal_calibration fit_in_field_units(const invcal_calibration *calibration, double field)
{
    invcal_calibration c = *calibration;

    (void)invcal_scale(&c, field); /* cannot fail: field is positive */
    return c;
}

invcal_calibration fit_over_field(const invcal_calibration *calibration, double field)
{
    invcal_calibration c = *calibration;

    for (unsigned i = 0; i < 9; i++) {
        c.matrix[i / 3][i % 3] /= field;
    }
    return c;
}

fit_solution fit_solution_of(const invcal_calibration *symmetric, const fit_settings *settings)
{
    fit_solution s = {.calibration = *symmetric, .symmetric = *symmetric};

    invcal_deviation(symmetric, &settings->nominal, s.x);
    if (settings->is_triangular) {
        invcali_make_triangular(&s.calibration, &settings->nominal);
    }
    return s;
}

/* A of calibrated = A (u - delta), u the nominal reading. */
static void correction_of(const invcal_calibration *symmetric, const invcal_calibration *nominal,
                          double a[3][3])
{
    double inverse[3][3];

    (void)matrix_inverse(nominal, inverse); /* a solution implies that it exists */
    for (unsigned i = 0; i < 3; i++) {
        const double *m = symmetric->matrix[i];
        for (unsigned j = 0; j < 3; j++) {
            a[i][j] = m[0] * inverse[0][j] + m[1] * inverse[1][j] + m[2] * inverse[2][j];
        }
    }
}

/* Noise of u appears in the length of a calibrated reading along eta multiplied by |A eta|. */
double fit_weight(const invcal_calibration *symmetric, const invcal_calibration *nominal,
                  const double eta[3])
{
    double a[3][3];
    double square = 0;

    correction_of(symmetric, nominal, a);
    for (unsigned i = 0; i < 3; i++) {
        const double x = a[i][0] * eta[0] + a[i][1] * eta[1] + a[i][2] * eta[2];
        square += x * x;
    }
    return 1 / square;
}

double fit_sensitivity(const invcal_calibration *symmetric, const invcal_calibration *nominal)
{
    double a[3][3];
    double square = 0;

    correction_of(symmetric, nominal, a);
    for (unsigned i = 0; i < 9; i++) {
        square += a[i / 3][i % 3] * a[i / 3][i % 3] / 3;
    }
    return sqrt(square);
}

void fit_information(const double *raw, unsigned count, const fit_settings *settings,
                     const fit_solution *solution, double noise,
                     double information[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)])
{
    const invcal_calibration *nominal = &settings->nominal;
    const double sensitivity = fit_sensitivity(&solution->symmetric, nominal);
    invcal_sums sums;
    invcali_row row;

    invcal_sums_init(&sums);
    for (unsigned n = 0; n < count; n++) { /* none can fail, as none did in the solution */
        (void)invcali_observe(&solution->symmetric, &raw[3 * (size_t)n], &row);
        invcali_sums_add_row(&sums, &row,
                             sensitivity * sensitivity *
                                 fit_weight(&solution->symmetric, nominal, row.h));
    }
    memcpy(information, sums.sum, INVCAL_PACKED_SIZE(INVCAL_PARAMETERS) * sizeof *information);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (settings->prior[r] > 0) {
            const double ratio = noise / settings->prior[r];
            information[INVCAL_PACKED(r, r)] += ratio * ratio;
        }
    }
}

fit_quality fit_quality_of(const invcal_quality *q, const fit_settings *settings,
                           const fit_solution *solution)
{
    const double sensitivity = fit_sensitivity(&solution->symmetric, &settings->nominal);
    fit_quality out = {.coverage = invcal_coverage(q->sigma_dof),
                       .noise = q->noise < 1 ? sensitivity * q->noise : 1,
                       .dof = q->dof,
                       .sigma_dof = q->sigma_dof,
                       .rms = q->rms,
                       .max = q->max,
                       .worst = q->worst,
                       .weak = q->weak,
                       .from_prior = q->held,
                       .unchecked = q->unchecked,
                       .verdict = q->verdict};

    memcpy(out.sigma, q->sigma, sizeof out.sigma);
    invcal_sigma_offset(q, &settings->nominal, out.sigma_offset);
    return out;
}

/* If parameters are undetermined, the shape of the fit means nothing: report that first. Six faces
 * never determine the angles. */
invcal_status fit_explain(const double *raw, unsigned count, const fit_settings *settings,
                          invcal_status status, fit_reason *reason)
{
    const invcal_positions given = fit_positions(raw, count, &settings->nominal, settings->noise);
    fit_reason why = {invcal_bad_reading(&given), invcal_undetermined(&given)};

    if (settings->is_six_faces) {
        why.undetermined = (uint16_t)(why.undetermined & ~ANGLES);
    }
    if (reason) {
        *reason = why;
    }
    return status == INVCAL_NOT_ELLIPSOID && why.undetermined &&
                   (settings->is_six_faces || !fit_has_prior(settings))
               ? INVCAL_UNDETERMINED
               : status;
}

static invcal_status solve(const double *raw, unsigned count, const fit_settings *settings,
                           invcal_calibration *c, invcal_quality *q)
{
    const invcal_positions given = fit_positions(raw, count, &settings->nominal, settings->noise);

    if (settings->is_six_faces) {
        return invcal_calibrate_faces(&given, settings->prior[INVCAL_GAMMA_XY], c, q);
    }
    return fit_has_prior(settings) ? invcal_calibrate_prior(&given, settings->prior, c, q)
                                   : invcal_calibrate_plain(&given, c, q);
}

invcal_status fit_make(const double *raw, unsigned count, const fit_settings *settings,
                       fit_solution *solution, fit_quality *quality, fit_reason *reason)
{
    double information[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_calibration c;
    invcal_quality q;

    const invcal_status status = solve(raw, count, settings, &c, &q);
    if (status != INVCAL_OK) {
        return fit_explain(raw, count, settings, status, reason);
    }
    *solution = fit_solution_of(&c, settings);
    *quality = fit_quality_of(&q, settings, solution);
    fit_information(raw, count, settings, solution, quality->noise, information);
    quality->condition = eigen_condition(information, INVCAL_PARAMETERS);
    return INVCAL_OK;
}
