/* SPDX-License-Identifier: MIT
 *
 * maths/angles.h: the two angles of a stand, degrees, and the up direction that they give.
 *
 *     eta(alpha, beta) = (sin alpha sin beta, cos alpha, sin alpha cos beta)
 *
 * alpha is the angle of the outer axis, beta that of the inner axis (invcal/plan.h). Each direction
 * has two pairs of angles, (alpha, beta) and (-alpha, beta + 180); with y up or down beta is
 * arbitrary.
 */
#ifndef ANGLES_H
#define ANGLES_H

typedef struct {
    double alpha; /* outer axis */
    double beta;  /* inner axis */
} stand_angles;

/* The up direction in the frame of the instrument. Multiples of 90 degrees give components of
 * exactly 0 and 1. */
void angles_direction(double alpha, double beta, double up[3]);

/* A vector of the instrument's frame in the fixed frame of the stand: x along the outer axis, y up.
 * out[1] is the scalar product of v and the up direction. */
void angles_vector(double alpha, double beta, const double v[3], double out[3]);

/* The angles of a direction, a vector of any length: alpha in 0 ... 180, beta in (-180, 180], 0
 * where it is arbitrary. */
stand_angles angles_of(const double up[3]);

/* The same, but the one of the two pairs that is nearer to `near`; where beta is arbitrary, that of
 * `near`. */
stand_angles angles_near(const double up[3], stand_angles near);

/* The shorter turn from one angle to another, in (-180, 180]. */
double angles_turn(double from, double to);

/* "alpha 90, beta 0°", to 0.01 degrees. */
#define ANGLES_TEXT_MAX 80
const char *angles_text(stand_angles a, char text[ANGLES_TEXT_MAX]);

/* "turn alpha +60, beta -90°"; "" if there is nothing to turn. */
const char *angles_turn_text(stand_angles from, stand_angles to, char text[ANGLES_TEXT_MAX]);

#endif
