/* SPDX-License-Identifier: MIT
 *
 * Internal: the paper's row, of the observation room, for those who ask what a direction would
 * tell before anything is measured there.
 */
#ifndef INVCAL_ROW_H
#define INVCAL_ROW_H

#include "invcal/observation.h"

/* h(a) = (x y z x^2 y^2 z^2 xy xz yz) */
void invcal_row(const invcal_real a[3], invcal_real h[INVCAL_PARAMETERS]);

#endif
