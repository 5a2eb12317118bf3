/* SPDX-License-Identifier: MIT
 *
 * calibration_file.h: reads what `invcal calibrate --out` wrote.
 */
#ifndef CALIBRATION_FILE_H
#define CALIBRATION_FILE_H

#include "invcal/calibration.h"

/* Reads a JSON object with "offset", 3 numbers in input units, and "matrix", 3 rows of 3 numbers
 * in field units per input unit; other members do not matter. "-" is the standard input.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if the file is unreadable or malformed, or the
 * matrix is singular. */
int calibration_file_read(const char *path, invcal_calibration *out);

#endif
