/* SPDX-License-Identifier: MIT */
#include "design/bound.h"

#include <math.h>
#include <string.h>

#include "design/covariance.h"
#include "maths/matrix.h"
#include "core/system.h"

enum { P = INVCAL_PARAMETERS };

void bound_find(const design *d, double bound[P])
{
    double K[INVCAL_PACKED_SIZE(P)];

    criteria_information(&d->sums, K);
    (void)matrix_invert_packed(K, P); /* it is solvable */
    memset(bound, 0, P * sizeof *bound);
    for (unsigned i = 0; i < d->count; i++) {
        double h[P];
        covariance_row(d->position[i].vertical, h);
        for (unsigned r = 0; r < P; r++) {
            double element = 0;
            for (unsigned c = 0; c < P; c++) {
                element += K[INVCAL_PACKED(r > c ? r : c, r > c ? c : r)] * h[c];
            }
            bound[r] += d->position[i].share * fabs(element);
        }
    }
}

double bound_largest(const double bound[P], unsigned kind)
{
    const double *b = &bound[3 * (size_t)kind];

    return fmax(b[0], fmax(b[1], b[2]));
}
