/* SPDX-License-Identifier: MIT
 *
 * Internal: rotations of the gyroscope's segments.
 */
#ifndef INVCAL_ROTATION_H
#define INVCAL_ROTATION_H

#include "invcal/gyro.h"
#include "vector.h"

#define INVCAL_V_UNIT (1 / INVCAL_REAL(32768.0))      /* of segment.v */
#define INVCAL_KAPPA_UNIT (1 / INVCAL_REAL(262144.0)) /* of segment.kappa, and of a rest's bias */

/* out += unit packed */
void invcal_unpack(const int16_t packed[3], invcal_real unit, invcal_real out[3]);

#endif
