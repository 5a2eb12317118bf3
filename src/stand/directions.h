/* SPDX-License-Identifier: MIT
 *
 * Internal: the paper's second composition, for a comparison.
 */
#ifndef INVCAL_DIRECTIONS_H
#define INVCAL_DIRECTIONS_H

#include "invcal/expert.h"
#include "../core/names.h"

/* invcal_directions_add by the paper's scalar composition, J2 = (|u|^2 - 1)/2, which leaves an error
 * of second order in X: 1e-4 at errors of 1 %, 1e-2 at errors of 10 %. Do not mix the two. */
invcal_status invcali_directions_add_scalar(invcal_directions *directions,
                                            const invcal_calibration *nominal,
                                            const invcal_real mean[3], const invcal_real eta[3]);

#endif
