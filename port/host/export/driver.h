/* SPDX-License-Identifier: MIT
 *
 * export/driver.h: a calibration as seen from a driver that delivers m/s^2.
 *
 * PX4, ArduPilot and ROS correct readings that their driver has brought to m/s^2 by a scale of
 * its own; a calibration file corrects whatever its log held. The driver's scale leads from one
 * to the other, and is never guessed.
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
