/* SPDX-License-Identifier: MIT
 *
 * maths/rotation.h: rotation matrices and rotation vectors.
 */
#ifndef ROTATION_H
#define ROTATION_H

/* The rotation vector of a rotation matrix, rad: by its quaternion, whose largest element is
 * computed first, so that half a turn is as accurate as none (Shepperd's method). */
void rotation_vector(const double (*r)[3], double angle[3]);

/* The rotation by an angle, rad, about a unit vector. */
void rotation_about(const double axis[3], double angle, double r[3][3]);

#endif
