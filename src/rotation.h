/* SPDX-License-Identifier: MIT
 *
 * Internal: rotations of the gyroscope's segments.
 */
#ifndef INVCAL_ROTATION_H
#define INVCAL_ROTATION_H

#include "invcal/gyro.h"
#include "vector.h"

#define INVCAL_V_UNIT INVCAL_REAL(32768.0)      /* of segment.v */
#define INVCAL_KAPPA_UNIT INVCAL_REAL(262144.0) /* of segment.kappa, and of a rest's bias */

#endif
