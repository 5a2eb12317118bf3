/* SPDX-License-Identifier: MIT
 *
 * stand/misset.h: positions of a stand whose angles are not those stated: misset, swapped or repeated.
 *
 * Lengths do not see it. The vertical composition sees it to the second order, |e|^2/2 + |X||e| at an error
 * of the direction of e; the full vector to the first. Each position is tried in turn: without the one that
 * leaves least, does the scatter of the others fall by more than chance lets it?
 */
#ifndef MISSET_H
#define MISSET_H

#include "stand/mounting.h"

typedef enum {
    MISSET_BY,      /* some angle */
    MISSET_SWAPPED, /* it is where another one should be, and that one here */
    MISSET_REPEATED /* it is where another one is */
} misset_kind;

typedef struct {
    unsigned index; /* of the position in the list */
    misset_kind kind;
    unsigned other; /* its index, unless MISSET_BY */
    double angle;   /* between what is stated and what was read, rad */
    double
        alpha; /* by how much the angles are too large, rad, where angle is small; of a beta that */
    double beta; /* turns the unit about the vertical NaN */
} misset;

/* Finds them, and leaves them out: more than one in four are not single ones any more.
 *
 * m     out: the mounting from the others.
 * list  out: room for `count`.
 * found out: how many.
 *
 * Returns as mounting_fit. */
invcal_status misset_find(mounting_position *p, unsigned count, const invcal_calibration *nominal,
                          mounting *m, misset *list, unsigned *found);

#endif
