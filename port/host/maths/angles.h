/* SPDX-License-Identifier: MIT
 *
 * maths/angles.h: the two angles of a stand, degrees, and the direction that they point up.
 *
 *     eta(alpha, beta) = (sin alpha sin beta, cos alpha, sin alpha cos beta)
 *
 * alpha is the angle of the outer axis, beta that of the inner (invcal/plan.h). Of each direction there are
 * two pairs, (alpha, beta) and (-alpha, beta + 180); with y up or down beta is free.
 */
#ifndef ANGLES_H
#define ANGLES_H

typedef struct {
    double alpha; /* outer axis */
    double beta;  /* inner axis */
} stand_angles;

/* The direction up, in the frame of the instrument. Multiples of 90 degrees give components that are
 * exactly 0 and 1. */
void angles_direction(double alpha, double beta, double up[3]);

/* Where a vector in the axes of the instrument points, in axes that stay: x along the outer axis, y up. Its
 * second element is the product with the direction. */
void angles_vector(double alpha, double beta, const double v[3], double out[3]);

/* The angles of a direction of any length: alpha from 0 to 180, beta above -180 to 180, 0 where it is
 * free. */
stand_angles angles_of(const double up[3]);

/* The same, but of the two pairs the nearer to `near`; where beta is free, that of `near`. */
stand_angles angles_near(const double up[3], stand_angles near);

/* The shorter way round from one angle to another, above -180 to 180. */
double angles_turn(double from, double to);

/* "alpha 90, beta 0 deg", to 0.01 degrees. */
#define ANGLES_TEXT_MAX 80
const char *angles_text(stand_angles a, char text[ANGLES_TEXT_MAX]);

/* "turn alpha +60, beta -90 deg"; "" if there is nothing to turn. */
const char *angles_turn_text(stand_angles from, stand_angles to, char text[ANGLES_TEXT_MAX]);

#endif
