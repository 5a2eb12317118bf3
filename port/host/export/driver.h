/* SPDX-License-Identifier: MIT
 *
 * export/driver.h: a calibration as seen from a driver that delivers m/s^2.
 *
 * PX4, ArduPilot and ROS correct readings that their driver has converted to m/s^2; a calibration
 * file corrects readings in the unit of its log. To convert between them, the driver's zero and
 * scale must be known; they are never guessed.
 */
#ifndef EXPORT_DRIVER_H
#define EXPORT_DRIVER_H

#include "export/format.h"

/* Fills in job->driver.
 *
 * zero, lsb  what the command line states, lsb in m/s^2 per input unit; null: from the file, by
 *            the unit of its readings or a nominal calibration that was given.
 *
 * Returns EXIT_GOOD; EXIT_USAGE, with a message, if the driver's scale is unknown, or
 * out of range. */
int export_driver(export_job *job, const double *zero, const double *lsb);

#endif
