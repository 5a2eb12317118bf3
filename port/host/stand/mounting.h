/* SPDX-License-Identifier: MIT
 *
 * stand/mounting.h: how a unit sits on a stand: readings against known directions, by the full vector
 * (invcal/expert.h, "Known directions").
 *
 * This is the one rotation that lengths never show. The stand's angles count to the first order here, so
 * the residuals between readings and directions show errors of the stand as well: see misset.h.
 */
#ifndef MOUNTING_H
#define MOUNTING_H

#include "invcal/expert.h"

/* A position with a known direction. */
typedef struct {
    unsigned number; /* in the file, from 0 */
    double alpha;    /* angles as the paper counts them, degrees */
    double beta;
    double eta[3];   /* up, in the frame of the stand */
    double raw[3];   /* input units */
    int is_left_out; /* of all that follows: misset */
} mounting_position;

typedef struct {
    invcal_calibration stand; /* raw to over the field, in the frame of the stand */
    double turn[3][3];        /* a direction of the stand's frame, in that of the unit */
    double angle[3];          /* the same as a rotation vector, rad, */
    double sigma[3];          /* and its standard deviations */
    double scatter; /* of a direction about each of two axes across it, rad; NaN: no redundancy */
    double dof;     /* behind it */
    double k[INVCAL_PACKED_SIZE(4)]; /* inverse of the system of (eta 1): see mounting_leverage */
} mounting;

/* Finds it, from the positions that are not left out.
 *
 * nominal  raw to over the field.
 *
 * sigma is right to the size of the sensor's errors: 2 % of itself at 2 %.
 *
 * Returns as invcal_full_vector_solve. */
invcal_status mounting_fit(const mounting_position *p, unsigned count,
                           const invcal_calibration *nominal, mounting *out);

/* How much of its own error a position draws the fit along: 4 / n on average. */
double mounting_leverage(const mounting *m, const double eta[3]);

/* The direction of a reading, in the frame of the stand, a unit vector. */
void mounting_direction(const mounting *m, const double raw[3], double direction[3]);

/* Squared distance of that from the direction stated; the angle in rad, if it is small. */
double mounting_off(const mounting *m, const mounting_position *p);

/* A direction of the stand's frame in the frame of the unit. */
void mounting_turn(const mounting *m, const double eta[3], double out[3]);

#endif
