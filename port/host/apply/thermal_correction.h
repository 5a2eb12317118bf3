/* SPDX-License-Identifier: MIT
 *
 * apply/thermal_correction.h: a calibration file at the temperature of each reading.
 */
#ifndef THERMAL_CORRECTION_H
#define THERMAL_CORRECTION_H

#include "result/calibration_file.h"

/* K: a larger change of temperature updates the calibration; 1e-5 of the field at 1 mg/K */
#define THERMAL_CORRECTION_STEP 0.01

/* Part of the range of the calibration by which readings may exceed it without a warning: single
 * readings of its own log exceed the means of the rests. */
#define THERMAL_CORRECTION_MARGIN 0.01

typedef struct {
    const calibration_file *file;
    invcal_calibration current;
    double temperature; /* of `current`; NaN: none yet */
    unsigned long readings;
    unsigned long below; /* readings colder than the range and its margin */
    unsigned long above; /* readings warmer */
    double coldest;
    double warmest;
} thermal_correction;

/* The file must outlive c. Without thermal terms, its calibration is used at all temperatures. */
void thermal_correction_begin(thermal_correction *c, const calibration_file *file);

/* The calibration for a reading at this temperature, which is finite; outside the range that at its
 * edge. */
const invcal_calibration *thermal_correction_at(thermal_correction *c, double temperature);

/* Prints a warning if readings were outside the range and its margin. */
void thermal_correction_end(const thermal_correction *c, const char *log);

#endif
