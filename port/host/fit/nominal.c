/* SPDX-License-Identifier: MIT */
#include "fit/nominal.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "invcal/positions.h"
#include "maths/eigen.h"
#include "maths/matrix.h"
#include "core/system.h"

#define VARIANCE_MIN 0.02 /* in any direction, over the square of the radius */

int nominal_from_range(const positions *p, double field, double zero[3], double lsb[3])
{
    double half[3]; /* half the range, which cannot overflow */
    double widest = 0;

    for (unsigned i = 0; i < 3; i++) {
        double low = p->mean[i];
        double high = low;
        for (unsigned n = 1; n < p->count; n++) {
            const double x = p->mean[3 * n + i];
            low = x < low ? x : low;
            high = x > high ? x : high;
        }
        zero[i] = low / 2 + high / 2;
        half[i] = high / 2 - low / 2;
        widest = half[i] > widest ? half[i] : widest;
    }
    for (unsigned i = 0; i < 3 && widest > 0; i++) {
        lsb[i] = field / (half[i] < widest / 2 ? widest : half[i]);
        widest = lsb[i] > 0 && lsb[i] <= DBL_MAX ? widest : 0;
    }
    return widest > 0;
}

/* The centre z of least squares of |x - z|^2 - R^2, from the mean m: covariance (z - m) is half the
 * mean of |x - m|^2 (x - m). */
int nominal_from_sphere(const double *raw, unsigned count, invcal_calibration *out)
{
    double mean[3] = {0};
    double covariance[INVCAL_PACKED_SIZE(3)] = {0};
    double inverse[INVCAL_PACKED_SIZE(3)];
    double variance[3];
    double side[3] = {0};
    double square = 0;
    invcal_calibration c = {.offset = {0}};

    for (unsigned n = 0; n < 3 * count; n++) {
        mean[n % 3] += raw[n] / count;
    }
    for (unsigned n = 0; n < count; n++) {
        const double *x = &raw[3 * (size_t)n];
        const double d[3] = {x[0] - mean[0], x[1] - mean[1], x[2] - mean[2]};
        const double length = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        square += length / count;
        for (unsigned i = 0; i < 3; i++) {
            side[i] += length * d[i] / 2 / count;
            for (unsigned j = 0; j <= i; j++) {
                covariance[INVCAL_PACKED(i, j)] += d[i] * d[j] / count;
            }
        }
    }
    eigenvalues(covariance, 3, variance);
    memcpy(inverse, covariance, sizeof inverse);
    if (count < NOMINAL_SPHERE || !matrix_invert_packed(inverse, 3)) {
        return 0;
    }
    for (unsigned i = 0; i < 3; i++) {
        double off = 0;
        for (unsigned j = 0; j < 3; j++) {
            off += inverse[i > j ? INVCAL_PACKED(i, j) : INVCAL_PACKED(j, i)] * side[j];
        }
        c.offset[i] = mean[i] + off;
        square += off * off;
    }
    if (!(fmin(variance[0], fmin(variance[1], variance[2])) >= VARIANCE_MIN * square)) {
        return 0;
    }
    for (unsigned i = 0; i < 3; i++) {
        c.matrix[i][i] = 1 / sqrt(square);
    }
    *out = c;
    return 1;
}

int nominal_make(const double zero[3], const double lsb[3], double field, invcal_calibration *out)
{
    double counts[3];
    invcal_calibration over_field;

    for (unsigned i = 0; i < 3; i++) {
        counts[i] = field / lsb[i];
    }
    if (invcal_nominal(zero, counts, &over_field) != INVCAL_OK) {
        return 0;
    }
    *out = (invcal_calibration){.offset = {zero[0], zero[1], zero[2]}};
    for (unsigned i = 0; i < 3; i++) {
        out->matrix[i][i] = lsb[i];
    }
    return 1;
}

int nominal_is_guess(const nominal_choice *n)
{
    return n->zero == NOMINAL_RANGE || n->lsb == NOMINAL_RANGE;
}

int nominal_is_stated(const nominal_choice *n)
{
    return n->zero != NOMINAL_RANGE || n->lsb != NOMINAL_RANGE;
}

int nominal_knows(const nominal_choice *n, unsigned parameter)
{
    return parameter >= INVCAL_GAMMA_XY ||
           (parameter >= INVCAL_DK_X ? n->lsb : n->zero) != NOMINAL_RANGE;
}

const char *nominal_origin_text(nominal_origin origin)
{
    static const char *const texts[] = {"given", "not stated", "from an earlier calibration",
                                        "from the unit", "from the data sheet"};

    return texts[origin];
}

const char *nominal_origin_name(nominal_origin origin)
{
    static const char *const names[] = {"given", "range", "earlier", "unit", "sensor"};

    return names[origin];
}
