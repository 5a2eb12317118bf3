/* SPDX-License-Identifier: MIT
 *
 * stand/misset.h: positions of a stand whose angles are not those stated: misset, swapped or
 * repeated.
 *
 * The lengths of the readings do not depend on the angles. An error e of a direction changes the
 * vertical composition by |e|^2/2 + |X||e|, which is of second order, and the full vector by e. So
 * the position whose removal reduces the scatter of the full vector most is removed, one after the
 * other, since several hide each other; those after the last significant reduction are put back, as
 * in Rosner's generalised ESD test (Technometrics 25, 1983), and then those that fit the others.
 */
#ifndef MISSET_H
#define MISSET_H

#include "stand/mounting.h"

typedef enum {
    MISSET_BY,      /* by some angle */
    MISSET_SWAPPED, /* with another position */
    MISSET_REPEATED /* in the orientation of another position */
} misset_kind;

typedef struct {
    unsigned index; /* of the position */
    misset_kind kind;
    unsigned other; /* index of the other position, unless MISSET_BY */
    double angle;   /* between the stated direction and the reading, rad */
    double alpha;   /* error of alpha, rad, if `angle` is small */
    double beta;    /* error of beta; NaN where beta turns the unit about the vertical */
} misset;

/* Finds misset positions, at most one in four, and sets their is_left_out.
 *
 * m     out: the mounting from the others.
 * list  out: space for `count`.
 * found out: their number; they are in the order of their index.
 *
 * Returns as mounting_fit. */
invcal_status misset_find(mounting_position *p, unsigned count, const invcal_calibration *nominal,
                          mounting *m, misset *list, unsigned *found);

#endif
