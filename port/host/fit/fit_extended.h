/* SPDX-License-Identifier: MIT
 *
 * fit/fit_extended.h: solves for the nine parameters and additional errors of the axes. Each kind
 * of error has one unknown for each axis a, and adds to its reading, over the field,
 *
 *     extra(a) value(position, eta_a)
 *
 * Gauss-Newton steps for the additional unknowns, each with the closed form of the nine.
 */
#ifndef FIT_EXTENDED_H
#define FIT_EXTENDED_H

#include "fit/fit.h"

enum {
    FIT_EXTENDED_KINDS = 2,    /* at most */
    FIT_EXTENDED_REDUNDANT = 2 /* positions required beyond the number of unknowns */
};

typedef struct fit_extension fit_extension;
struct fit_extension {
    unsigned kinds;
    /* The error of a kind at a position, for an axis along which the field is eta, per unit of
     * `extra`. */
    double (*value)(const fit_extension *self, unsigned position, unsigned kind, double eta);
    const double *tau; /* for value */
};

/* Calibrates.
 *
 * extra  out: x y z of each kind in turn, over the field.
 * sigma  out: their standard deviations.
 *
 * Returns as fit_make; INVCAL_TOO_FEW with fewer positions than unknowns plus
 * FIT_EXTENDED_REDUNDANT; INVCAL_UNDETERMINED, too, if the positions cannot separate them. */
invcal_status fit_extended_make(const double *raw, unsigned count, const fit_settings *settings,
                                const fit_extension *extension, fit_solution *solution,
                                fit_quality *quality, double *extra, double *sigma);

#endif
