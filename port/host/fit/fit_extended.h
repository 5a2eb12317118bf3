/* SPDX-License-Identifier: MIT
 *
 * fit/fit_extended.h: the nine parameters, and errors of the axes in addition: each kind of error has one
 * unknown for each axis, and adds to its reading
 *
 *     extra(a) value(position, eta_a)
 *
 * over the field. Gauss-Newton steps for the others, the closed form of the nine in each.
 */
#ifndef FIT_EXTENDED_H
#define FIT_EXTENDED_H

#include "fit/fit.h"

enum {
    FIT_EXTENDED_KINDS = 2, /* at most */
    FIT_EXTENDED_SPARE = 2  /* positions more than unknowns */
};

typedef struct fit_extension fit_extension;
struct fit_extension {
    unsigned kinds;
    /* What kind k does at a position to an axis along which the field is eta. */
    double (*value)(const fit_extension *self, unsigned position, unsigned kind, double eta);
    const double *tau; /* for its use */
};

/* Calibrates.
 *
 * extra  x y z of each kind in turn, over the field.
 * sigma  their standard deviations.
 *
 * Returns as fit_make; INVCAL_TOO_FEW with fewer positions than unknowns and FIT_EXTENDED_SPARE more;
 * INVCAL_UNDETERMINED, too, if the positions cannot separate them. */
invcal_status fit_extended_make(const double *raw, unsigned count, const fit_settings *settings,
                                const fit_extension *extension, fit_solution *solution,
                                fit_quality *quality, double *extra, double *sigma);

#endif
