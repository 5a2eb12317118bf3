/* SPDX-License-Identifier: MIT
 *
 * maths/f_tail.h: the probability that chance alone makes one sum of squares that small relative to
 * another.
 */
#ifndef F_TAIL_H
#define F_TAIL_H

/* P(F > f) of Fisher's F with m and dof degrees of freedom, both at least 1.
 *
 * z  1 / (1 + f m / dof). If m additional unknowns lower the sum of the squared residuals from S to
 *    s and leave dof degrees of freedom, z is s / S. Returns 1 for z >= 1 and NaN, 0 for z <= 0. */
double f_tail(double z, unsigned m, unsigned dof);

#endif
