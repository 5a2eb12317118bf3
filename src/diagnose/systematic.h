/* SPDX-License-Identifier: MIT
 *
 * Internal: tests for systematic errors. A test adds three columns to the nine of the fit, one for
 * each axis, for one kind of error.
 */
#ifndef INVCAL_SYSTEMATIC_H
#define INVCAL_SYSTEMATIC_H

#include "fit.h"

/* The result of adding the columns of one kind to a fit. */
typedef struct {
    unsigned rank;       /* of the columns, without those dependent on the others */
    invcal_real squares; /* the rest of fit->squares */
    invcal_real size[3]; /* of the error on each axis, over field */
    /* the min share of a column's square that the nine leave: if it is 1 / f^2, fitting the column
     * too would make sigma of the nine at most f times as large */
    invcal_real shown;
} invcali_test;

/* kind  an invcal_systematic.
 * step  0; or INVCAL_DRIFT not as a slope, but as a step before this position. */
void invcali_test_for(const invcali_fit *fit, unsigned kind, unsigned step, invcali_test *out);

#endif
