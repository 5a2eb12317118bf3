/* SPDX-License-Identifier: MIT */
#include "fit/thermal_rows.h"

#include <math.h>
#include <string.h>

#include "maths/matrix.h"
#include "core/sums.h"

enum { N = INVCAL_PARAMETERS };

unsigned thermal_rows_unknowns(const invcal_thermal *c)
{
    return N * (c->fitted + 1u);
}

int thermal_rows_one(const invcal_thermal *c, const double raw[3], double temperature,
                     thermal_row *out)
{
    const double t = (temperature - c->reference) / c->span;
    invcal_calibration here;
    invcal_thermal_place place;
    invcali_row row;

    if (invcal_thermal_at(c, temperature, &here, &place) != INVCAL_OK ||
        invcali_observe(&here, raw, &row) != INVCAL_OK) {
        return 0;
    }
    memcpy(out->h, row.h, sizeof row.h);
    for (unsigned i = N; i < thermal_rows_unknowns(c); i++) {
        out->h[i] = out->h[i - N] * t;
    }
    out->residual = sqrt(1 + 2 * row.h[INVCAL_J]) - 1;
    out->weight = fit_weight(&here, &c->nominal, row.h);
    return 1;
}

/* H'WH, with the constant times the weight of each row; H'H if the constant is 0. */
static void sum_up(const invcal_thermal *c, const rejection *kept, double constant, double *sum)
{
    const unsigned n = thermal_rows_unknowns(c);
    thermal_row row;

    memset(sum, 0, THERMAL_PACKED * sizeof *sum);
    for (unsigned k = 0; k < kept->kept_count; k++) {
        if (!thermal_rows_one(c, &kept->kept[3 * (size_t)k], kept->temperature[k], &row)) {
            continue;
        }
        const double weight = constant > 0 ? constant * row.weight : 1;
        for (unsigned i = 0; i < n; i++) {
            for (unsigned j = 0; j <= i; j++) {
                sum[INVCAL_PACKED(i, j)] += weight * row.h[i] * row.h[j];
            }
        }
    }
}

int thermal_rows_inverse(const invcal_thermal *c, const rejection *kept,
                         double inverse[THERMAL_PACKED])
{
    const unsigned n = thermal_rows_unknowns(c);

    sum_up(c, kept, 0, inverse);
    if (invcali_factor(inverse, n, n, INVCAL_FLOOR) != INVCAL_OK) {
        return 0;
    }
    invcali_invert(inverse, n);
    return 1;
}

double thermal_rows_leverage(const double *inverse, unsigned n, const double *h)
{
    double sum = 0;

    for (unsigned r = 0; r < n; r++) {
        double y = 0;
        for (unsigned c = 0; c <= r; c++) {
            y += *inverse++ * h[c];
        }
        sum += y * y;
    }
    return sum;
}

int thermal_rows_covariance(const invcal_thermal *c, const rejection *kept,
                            const invcal_thermal_prior *prior, double noise,
                            double covariance[THERMAL_PACKED])
{
    const unsigned n = thermal_rows_unknowns(c);
    invcal_calibration here;
    invcal_thermal_place place;

    if (invcal_thermal_at(c, c->reference, &here, &place) != INVCAL_OK) {
        return 0;
    }
    const double sensitivity = fit_sensitivity(&here, &c->nominal);
    sum_up(c, kept, sensitivity * sensitivity, covariance);
    for (unsigned i = 0; i < n; i++) {
        const unsigned power = i / N;
        const double sigma = prior->sigma[power][i % N] * pow(c->span, power);
        if (sigma > 0) {
            covariance[INVCAL_PACKED(i, i)] += noise / sigma * (noise / sigma);
        }
    }
    return matrix_invert_packed(covariance, n);
}
