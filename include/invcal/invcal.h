/* SPDX-License-Identifier: MIT
 *
 * invcal/invcal.h: the whole library. Rooms in the order of the data, each knowing only those
 * before it:
 *
 *     calibration -> observation -> normal -> cholesky -> eigen -> solution -> residual
 *                 -> quality -> calibrate
 */
#ifndef INVCAL_INVCAL_H
#define INVCAL_INVCAL_H

#include "invcal/calibrate.h"

#endif
