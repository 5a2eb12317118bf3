/* SPDX-License-Identifier: MIT */
#include "thermal_rows.h"

#include <math.h>
#include <string.h>

#include "thermal_fit.h"

enum { N = INVCAL_PARAMETERS };

int thermal_row(const invcal_thermal_calibration *c, const double raw[3], double temperature,
                double *row, double *residual)
{
    const double t = (temperature - c->reference) / c->span;
    invcal_solution here;
    invcal_thermal_place place;
    invcal_observation observed;

    if (invcal_thermal_at(c, temperature, &here, &place) != INVCAL_OK ||
        invcal_observe(&here.calibration, c->field, raw, &observed) != INVCAL_OK) {
        return 0;
    }
    memcpy(row, observed.h, sizeof observed.h);
    for (unsigned i = N; i < N * (c->fitted + 1u); i++) {
        row[i] = row[i - N] * t;
    }
    *residual = sqrt(1 + 2 * observed.j) - 1;
    return 1;
}

static void add_prior(const invcal_thermal_calibration *c, const invcal_settings *settings,
                      const invcal_thermal_settings *thermal, double noise, double *sum)
{
    for (unsigned i = 0; i < N * (c->fitted + 1u); i++) {
        const unsigned r = i % N;
        const double prior = i < N       ? settings->prior[r]
                             : i < 2 * N ? thermal->slope[r] * c->span
                                         : thermal->curvature[r] * c->span * c->span;
        if (prior > 0) {
            sum[INVCAL_PACKED(i, i)] += noise / prior * (noise / prior);
        }
    }
}

int thermal_rows_factor(const invcal_thermal_calibration *c, const rejection *kept,
                        const invcal_settings *settings, const invcal_thermal_settings *thermal,
                        double noise, double *l)
{
    const unsigned count = N * (c->fitted + 1u);
    double row[THERMAL_COEFFICIENTS];
    double residual;

    memset(l, 0, INVCAL_PACKED_SIZE(THERMAL_COEFFICIENTS) * sizeof *l);
    for (unsigned n = 0; n < kept->kept_count; n++) {
        if (!thermal_row(c, &kept->kept[3 * (size_t)n], kept->temperature[n], row, &residual)) {
            continue;
        }
        for (unsigned i = 0; i < count; i++) {
            for (unsigned j = 0; j <= i; j++) {
                l[INVCAL_PACKED(i, j)] += row[i] * row[j];
            }
        }
    }
    if (thermal) {
        add_prior(c, settings, thermal, noise, l);
    }
    return invcal_cholesky_factor(l, count, INVCAL_PIVOT_FLOOR) == INVCAL_OK;
}
