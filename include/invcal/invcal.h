/* SPDX-License-Identifier: MIT
 *
 * invcal/invcal.h: the whole library. Rooms in the order of the data, each knowing only those
 * before it:
 *
 *     calibration -> observation -> normal -> cholesky -> eigen -> solution -> residual
 *                 -> quality -> calibrate
 *
 *     plan -> criteria, series: which positions to visit, and what they are worth
 *     block -> still: samples to rest positions
 *     fisher -> outlier, guidance: positions that are wrong, and the one to take next
 *     allan: noise and how long to stay;  gravity: the field at a place
 *     thermal: a calibration for every temperature
 *     session: the whole procedure
 *     record, thermal_record, resume -> store: what survives a reset
 */
#ifndef INVCAL_INVCAL_H
#define INVCAL_INVCAL_H

#include "invcal/allan.h"
#include "invcal/calibrate.h"
#include "invcal/criteria.h"
#include "invcal/gravity.h"
#include "invcal/record.h"
#include "invcal/resume.h"
#include "invcal/series.h"
#include "invcal/store.h"
#include "invcal/thermal_record.h"

#endif
