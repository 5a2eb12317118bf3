/* SPDX-License-Identifier: MIT */
#include "design/covariance.h"

#include <math.h>
#include <string.h>

#include "core/system.h"

enum { P = INVCAL_PARAMETERS, SUMS = INVCAL_PACKED_SIZE(INVCAL_PARAMETERS) };

#define RIDGE 1e-9

void covariance_row(const double up[3], double h[P])
{
    const double values[P] = {up[0],         up[1],         up[2],
                              up[0] * up[0], up[1] * up[1], up[2] * up[2],
                              up[0] * up[1], up[0] * up[2], up[1] * up[2]};

    memcpy(h, values, sizeof values);
}

static void add_information(const double (*direction)[3], const double *weight, unsigned count,
                            double a[SUMS])
{
    double h[P];

    for (unsigned i = 0; i < count; i++) {
        const double w = weight ? weight[i] : 1;
        covariance_row(direction[i], h);
        for (unsigned r = 0; r < P; r++) {
            for (unsigned c = 0; c <= r; c++) {
                a[INVCAL_PACKED(r, c)] += w * h[r] * h[c];
            }
        }
    }
}

double covariance_find(const double (*direction)[3], const double *weight, unsigned count,
                       double K[P][P])
{
    double a[SUMS] = {0};
    double log_det = 0;

    add_information(direction, weight, count, a);
    for (unsigned r = 0; r < P; r++) {
        a[INVCAL_PACKED(r, r)] += RIDGE;
    }
    (void)invcali_factor(a, P, P, 0); /* positive definite by the ridge */
    invcali_invert(a, P);
    for (unsigned r = 0; r < P; r++) {
        log_det -= 2 * log(a[INVCAL_PACKED(r, r)]);
        for (unsigned c = 0; c <= r; c++) { /* K = L'^-1 L^-1 */
            double sum = 0;
            for (unsigned i = r; i < P; i++) {
                sum += a[INVCAL_PACKED(i, r)] * a[INVCAL_PACKED(i, c)];
            }
            K[r][c] = K[c][r] = sum;
        }
    }
    return log_det;
}

void covariance_image(double K[P][P], const double *a, double out[P])
{
    for (unsigned r = 0; r < P; r++) {
        out[r] = 0;
        for (unsigned c = 0; c < P; c++) {
            out[r] += K[r][c] * a[c];
        }
    }
}

double covariance_product(double K[P][P], const double *a, const double *b)
{
    double image[P];
    double sum = 0;

    covariance_image(K, a, image);
    for (unsigned r = 0; r < P; r++) {
        sum += image[r] * b[r];
    }
    return sum;
}
