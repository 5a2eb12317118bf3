/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "maths/angles.h"
#include "text/number.h"
#include "plan/results.h"

#define DECIMALS 1e9

/* As printed: x, y, z are computed from it. */
static double rounded(double degrees)
{
    return nearbyint(DECIMALS * degrees) / DECIMALS + 0.0;
}

void plan_csv(FILE *file, const design *d, const design_cost *cost)
{
    char text[2][NUMBER_TEXT_MAX];

    fprintf(file, "number,alpha,beta,dwell,x,y,z\n");
    for (unsigned i = 0; i < d->count; i++) {
        const design_position *p = &d->position[i];
        const double alpha = rounded(p->alpha);
        const double beta = rounded(p->beta);
        double up[3];
        angles_direction(alpha, beta, up);
        fprintf(file, "%u,%s,%s,%.9g", i + 1, number_text(alpha, text[0]),
                number_text(beta, text[1]), p->share * cost->dwell);
        for (unsigned k = 0; k < 3; k++) {
            fprintf(file, ",%.9f", nearbyint(DECIMALS * up[k]) / DECIMALS + 0.0);
        }
        putc('\n', file);
    }
}
