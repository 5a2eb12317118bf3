/* SPDX-License-Identifier: MIT */
#include "design/criteria.h"

#include <math.h>
#include <string.h>

#include "maths/eigen.h"
#include "maths/matrix.h"
#include "core/sums.h"

enum { P = INVCAL_PARAMETERS, SUMS = INVCAL_PACKED_SIZE(INVCAL_PARAMETERS) };

void criteria_add(invcal_sums *design, const double vertical[3])
{
    criteria_add_weighted(design, vertical, 1);
}

void criteria_add_weighted(invcal_sums *design, const double vertical[3], double weight)
{
    const double x = vertical[0];
    const double y = vertical[1];
    const double z = vertical[2];
    const invcali_row row = {{x, y, z, x * x, y * y, z * z, x * y, x * z, y * z, 0}};

    invcali_sums_add_row(design, &row, weight);
}

void criteria_information(const invcal_sums *design, double hth[SUMS])
{
    memcpy(hth, design->sum, SUMS * sizeof *hth);
}

static double largest_root(const double *K, unsigned first)
{
    double largest = 0;

    for (unsigned r = first; r < first + 3; r++) {
        largest = fmax(largest, sqrt(K[INVCAL_PACKED(r, r)]));
    }
    return largest;
}

int criteria_evaluate(const invcal_sums *design, criteria *out)
{
    double a[SUMS];
    double value[P];
    double log_det = 0;

    criteria_information(design, a);
    const double condition = eigen_condition(a, P);
    eigenvalues(a, P, value);
    for (unsigned r = 0; r < P; r++) {
        log_det += log(value[r]);
    }
    /* Good pivots do not exclude an undetermined combination of parameters. */
    if (!(condition * INVCAL_FLOOR < 1) || !matrix_invert_packed(a, P)) {
        return 0;
    }
    const criteria c = {design->count,
                        largest_root(a, INVCAL_DELTA_X),
                        largest_root(a, INVCAL_DK_X),
                        largest_root(a, INVCAL_GAMMA_XY),
                        condition,
                        log_det};
    if (!isfinite(c.sigma_delta + c.sigma_dk + c.sigma_gamma)) {
        return 0;
    }
    *out = c;
    return 1;
}
