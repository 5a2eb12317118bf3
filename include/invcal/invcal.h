/* SPDX-License-Identifier: MIT
 *
 * invcal/invcal.h: the whole library. Rooms in the order of the data, each knowing only those
 * before it:
 *
 *     calibration -> observation -> normal -> cholesky -> eigen -> solution -> residual
 *                 -> quality -> calibrate
 *
 *     plan -> criteria, series: which positions to visit, and what they are worth
 */
#ifndef INVCAL_INVCAL_H
#define INVCAL_INVCAL_H

#include "invcal/calibrate.h"
#include "invcal/criteria.h"
#include "invcal/series.h"

#endif
