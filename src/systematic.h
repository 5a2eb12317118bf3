/* SPDX-License-Identifier: MIT
 *
 * Internal: tests for errors that positions share. A test puts three columns beside the nine of the fit,
 * one for each axis, that stand for one kind of error.
 */
#ifndef INVCAL_SYSTEMATIC_H
#define INVCAL_SYSTEMATIC_H

#include "fit.h"

/* What the columns of one kind make of a fit. */
typedef struct {
    unsigned rank;       /* of the columns, those that are made of the others not counted */
    invcal_real squares; /* what is left of fit->squares */
    invcal_real size[3]; /* of the error on each axis, over field */
    /* the least share of a column's square that the nine leave: where it is 1 / f^2, sigma of the nine would
     * grow to f of itself at most beside it */
    invcal_real shown;
} invcal_test;

/* kind  an invcal_systematic.
 * step  0; or INVCAL_DRIFT not as a slope, but as a step before this position. */
void invcal_test_for(const invcal_fit *fit, unsigned kind, unsigned step, invcal_test *out);

#endif
