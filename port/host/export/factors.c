/* SPDX-License-Identifier: MIT */
#include "export/factors.h"

#include <math.h>

#include "cli/command.h"
#include "cli/message.h"
#include "export/text.h"

#define RATIO_MAX 1e3 /* of off-diagonal to diagonal, so that floats suffice */

int export_factors_check(const export_job *job, const invcal_calibration *c, double factor)
{
    const double(*m)[3] = c->matrix;

    for (unsigned j = 0; j < 3; j++) {
        const double column = fabs(m[0][j]) + fabs(m[1][j]) + fabs(m[2][j]);
        if (!(column <= RATIO_MAX * fabs(m[j][j]))) {
            message("%s: the sensor on input %c does not respond along %c, so --format %s cannot "
                    "store it: put the columns in order",
                    job->source, (int)"xyz"[j], (int)"xyz"[j], job -> format);
            return EXIT_DATA;
        }
    }
    const export_factors f = export_factors_of(c, factor);
    return export_check_range(job, f.scale, 3, 0);
}

export_factors export_factors_of(const invcal_calibration *c, double factor)
{
    const double(*m)[3] = c->matrix;
    export_factors f;

    for (unsigned j = 0; j < 3; j++) {
        f.scale[j] = factor * m[j][j];
        for (unsigned i = 0; i < 3; i++) {
            f.misalignment[i][j] = m[i][j] / m[j][j];
        }
    }
    return f;
}
