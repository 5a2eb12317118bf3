/* SPDX-License-Identifier: MIT
 *
 * Which parameters have changed significantly from one calibration to a later one.
 *
 * The difference of two independent estimates has the variance v = v1 + v2, and the degrees of
 * freedom
 *
 *     v^2 / (v1^2 / n1 + v2^2 / n2)
 *
 * (Welch, Biometrika 34, 1947). Its square over v is Fisher's F with 1 and that many, rounded down.
 * There are nine tests, so each gets a ninth of the false alarms (Bonferroni), which does not
 * require that the nine parameters of a calibration are independent; they are not.
 *
 * A slow drift is below the noise in each step: of three calibrations or more, the newest is tested
 * against the first, too, and each of the two comparisons has half of the false alarms. */
#include <math.h>

#include "compare/compare.h"
#include "invcal/result.h"
#include "maths/f_tail.h"
#include "text/number.h"

static double variance(const compare_item *item, unsigned p)
{
    return item->sigma[p] * item->sigma[p];
}

static unsigned welch(double v1, unsigned n1, double v2, unsigned n2)
{
    const double share = v1 / (v1 + v2);
    const double dof = 1 / (share * share / n1 + (1 - share) * (1 - share) / n2);

    return dof >= 1 ? (unsigned)dof : 1;
}

compare_drift compare_drift_of(const compare_item *before, const compare_item *now, double field,
                               unsigned tests)
{
    compare_drift d = {.before = before, .now = now};
    const double share = COMPARE_FALSE_ALARM / ((double)INVCAL_PARAMETERS * tests);
    unsigned changed = 0;

    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        const double per = compare_divisor(before->x, field, p);
        const double v1 = variance(before, p);
        const double v2 = variance(now, p);
        const double difference = now->x[p] - before->x[p];
        d.x[p] = difference / per;
        d.sigma[p] = sqrt(v1 + v2) / fabs(per);
        d.in_sigma[p] = d.x[p] / d.sigma[p];
        d.chance[p] = d.half_width[p] = NUMBER_UNKNOWN;
        if (v1 + v2 > 0) {
            const unsigned dof = welch(v1, before->dof, v2, now->dof);
            d.half_width[p] = invcal_coverage(dof) * d.sigma[p];
            d.chance[p] = f_tail(1 / (1 + d.in_sigma[p] * d.in_sigma[p] / dof), 1, dof);
        }
        changed |= (unsigned)(d.chance[p] <= share) << p;
    }
    d.changed = (uint16_t)changed;
    return d;
}

static void find_device(compare_result *r, compare_device *d)
{
    const compare_item *item = &r->item[d->first];
    const unsigned tests = d->count > 2 ? 2 : 1;

    for (unsigned k = 1; k < d->count; k++) {
        r->drift[d->first + k] = compare_drift_of(&item[k - 1], &item[k], r->field, tests);
    }
    if (d->count > 2) {
        d->whole = compare_drift_of(item, &item[d->count - 1], r->field, tests);
    }
}

void compare_drifts_find(compare_result *r)
{
    for (unsigned k = 0; k < r->devices; k++) {
        find_device(r, &r->device[k]);
    }
}
