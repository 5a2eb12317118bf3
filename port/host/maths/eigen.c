/* SPDX-License-Identifier: MIT */
#include "maths/eigen.h"

#include <float.h>
#include <math.h>

#include "core/system.h"

enum { SWEEPS = 12 }; /* more than any such matrix needs: convergence is quadratic */

/* Rotates the axes p and q so that a(p,q) becomes 0: t is the tangent of the angle, the smaller
 * root of t^2 + 2 t theta - 1 = 0. */
static void rotate(double a[EIGEN_MAX][EIGEN_MAX], unsigned n, unsigned p, unsigned q)
{
    const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double root = sqrt(theta * theta + 1);
    const double t = 1 / (theta < 0 ? theta - root : theta + root);
    const double c = 1 / sqrt(t * t + 1);
    const double s = t * c;

    a[p][p] -= t * a[p][q];
    a[q][q] += t * a[p][q];
    a[p][q] = a[q][p] = 0;
    for (unsigned r = 0; r < n; r++) {
        if (r != p && r != q) {
            const double rp = a[r][p];
            const double rq = a[r][q];
            a[r][p] = a[p][r] = c * rp - s * rq;
            a[r][q] = a[q][r] = s * rp + c * rq;
        }
    }
}

void eigenvalues(const double *a, unsigned n, double *value)
{
    double m[EIGEN_MAX][EIGEN_MAX];

    for (unsigned r = 0; r < n; r++) {
        for (unsigned c = 0; c <= r; c++) {
            m[r][c] = m[c][r] = a[INVCAL_PACKED(r, c)];
        }
    }
    for (unsigned sweep = 0; sweep < SWEEPS; sweep++) {
        for (unsigned q = 1; q < n; q++) {
            for (unsigned p = 0; p < q; p++) {
                /* An element below a hundredth of the rounding error of the diagonal changes
                 * nothing. A NaN is rotated, too, and so reaches the values. */
                if (!(fabs(m[p][q]) <= DBL_EPSILON / 100 * (fabs(m[p][p]) + fabs(m[q][q])))) {
                    rotate(m, n, p, q);
                }
            }
        }
    }
    for (unsigned r = 0; r < n; r++) {
        value[r] = m[r][r];
    }
}

double eigen_condition(const double *a, unsigned n)
{
    double value[EIGEN_MAX];
    double min = HUGE_VAL;
    double max = 0;

    eigenvalues(a, n, value);
    for (unsigned r = 0; r < n; r++) {
        if (!(value[r] > 0)) {
            return HUGE_VAL;
        }
        min = fmin(min, value[r]);
        max = fmax(max, value[r]);
    }
    return min > n * DBL_EPSILON * max ? max / min : HUGE_VAL;
}
