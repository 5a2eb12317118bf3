/* SPDX-License-Identifier: MIT
 *
 * apply/thermal_correction.h: a calibration file at the temperature of each reading.
 */
#ifndef THERMAL_CORRECTION_H
#define THERMAL_CORRECTION_H

#include "result/calibration_file.h"

#define THERMAL_CORRECTION_STEP                                                                    \
    0.01 /* K: it is made again when the temperature has moved by more;
                                        1e-5 of the field at 1 mg/K */

#define THERMAL_CORRECTION_MARGIN                                                                  \
    0.01 /* of the range seen, beyond which a warning is due: single readings of the very log that
            it was made from lie outside the means of its rests */

typedef struct {
    const calibration_file *file;
    invcal_calibration now;
    double at; /* the temperature that `now` is for; NaN: none yet */
    unsigned long readings;
    unsigned long below; /* readings colder than the range seen and its margin, */
    unsigned long above; /* and warmer; outside the range what holds at the edge */
    double coldest;
    double warmest;
} thermal_correction;

/* The file must outlive it. Without thermal terms its calibration holds at all temperatures. */
void thermal_correction_begin(thermal_correction *c, const calibration_file *file);

/* The calibration for a reading at this temperature (finite). */
const invcal_calibration *thermal_correction_at(thermal_correction *c, double temperature);

/* Says in one line on stderr if readings were outside the range seen and its margin. */
void thermal_correction_end(const thermal_correction *c, const char *log);

#endif
