/* SPDX-License-Identifier: MIT
 *
 * stand/mounting.h: the rotation of a unit on a stand, from readings in known directions, by the
 * full vector (stand/full_vector.h).
 *
 * Lengths never show this rotation. The full vector depends on the angles of the stand in first
 * order, so its residuals also show errors of the stand: see misset.h.
 */
#ifndef MOUNTING_H
#define MOUNTING_H

#include "core/system.h"

/* A position with a known direction. */
typedef struct {
    unsigned number; /* in the file, from 0 */
    double alpha;    /* outer angle as in the paper, degrees */
    double beta;     /* inner angle */
    double eta[3];   /* up, in the frame of the stand */
    double raw[3];   /* input units */
    int is_left_out; /* misset: not used in fits */
} mounting_position;

typedef struct {
    invcal_calibration stand; /* input units to multiples of the field, in the frame of the stand */
    double turn[3][3];        /* rotation from the frame of the stand to that of the unit */
    double angle[3];          /* the same as a rotation vector, rad */
    double sigma[3];          /* standard deviations of `angle` */
    double scatter; /* of a direction about each of two axes across it, rad; NaN: no redundancy */
    double dof;     /* degrees of freedom of `scatter` */
    double k[INVCAL_PACKED_SIZE(4)]; /* inverse of the system of (eta 1): see mounting_leverage */
} mounting;

/* Finds the mounting from the positions that are not left out.
 *
 * nominal  input units to multiples of the field.
 *
 * sigma has a relative error of the size of the sensor's errors: 2 % if these are 2 %.
 *
 * Returns as full_vector_solve. */
invcal_status mounting_fit(const mounting_position *p, unsigned count,
                           const invcal_calibration *nominal, mounting *out);

/* Leverage: the part of its own error by which a position pulls the fit; 4 / n on average. */
double mounting_leverage(const mounting *m, const double eta[3]);

/* The direction of a reading, in the frame of the stand, a unit vector. */
void mounting_direction(const mounting *m, const double raw[3], double direction[3]);

/* Squared distance between that and the stated direction; for small errors, the squared angle in
 * rad. */
double mounting_squared_error(const mounting *m, const mounting_position *p);

/* Turns a direction from the frame of the stand to that of the unit. */
void mounting_turn(const mounting *m, const double eta[3], double out[3]);

#endif
