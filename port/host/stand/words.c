/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "text/figure.h"
#include "invcal/result.h"
#include "stand/output.h"

double stand_coverage(double dof)
{
    return invcal_coverage((unsigned)fmax(0, fmin(1e6, dof)));
}

double stand_series_coverage(const group_series *s)
{
    return stand_coverage((double)s->dof +
                          (double)GROUP_SERIES_CLOSURES); /* which also show the noise */
}

const char *stand_large_angle_text(const mounting *m)
{
    const double *a = m->angle;

    return a[0] * a[0] + a[1] * a[1] + a[2] * a[2] > STAND_SMALL_ANGLE * STAND_SMALL_ANGLE
               ? "The unit appears to be mounted at a large angle. If it is not, check the sense "
                 "and the zero of the angles: --stand-sense, --stand-zero."
               : "";
}

const char *stand_misset_text(const stand *s, const misset *m, char text[STAND_TEXT_MAX])
{
    const mounting_position *p = &s->position[m->index];
    const int used = snprintf(text, STAND_TEXT_MAX, "Misset: position %u (alpha %.6g, beta %.6g) ",
                              p->number + 1, p->alpha, p->beta);
    const size_t left = STAND_TEXT_MAX - (size_t)used;
    const unsigned other = s->position[m->other < s->count ? m->other : 0].number + 1;

    if (m->kind == MISSET_SWAPPED) {
        snprintf(text + used, left, "is swapped with position %u.", other);
    } else if (m->kind == MISSET_REPEATED) {
        snprintf(text + used, left, "reads like position %u: repeated, or not turned.", other);
    } else if (m->angle < STAND_SMALL_ANGLE && isnan(m->beta)) {
        snprintf(text + used, left, "is off by %.3g mrad.", 1e3 * m->angle);
    } else if (m->angle < STAND_SMALL_ANGLE) {
        snprintf(text + used, left, "is off by %.3g mrad: alpha by %+.3g, beta by %+.3g degrees.",
                 1e3 * m->angle, FIGURE_DEGREES * m->alpha, FIGURE_DEGREES * m->beta);
    } else {
        snprintf(text + used, left, "is off by %.3g degrees.", FIGURE_DEGREES * m->angle);
    }
    return text;
}

const char *stand_missing_text(const stand_options *options, unsigned group,
                               char text[STAND_TEXT_MAX])
{
    static const char *const names[] = {"alpha", "beta"};
    const unsigned constant =
        group != 2; /* index of the constant angle: alpha in group 2, beta in 1 and 3 */
    const double angle = group == 1 ? 0 : group == 2 ? -90 : 90;

    snprintf(text, STAND_TEXT_MAX,
             "group %u (%s %.6g, %s all round) was not visited, and no other group determines it: "
             "visit it at five positions or more, in equal steps",
             group, names[constant],
             options->zero[constant] + options->sense[constant] * angle + 0.0, names[!constant]);
    return text;
}
