/* SPDX-License-Identifier: MIT
 *
 * fit/dip_frame.h: the calibrated axes of a magnetometer turned to those of the accelerometer in the same log
 * (invcal_dip of invcal/magnetometer.h).
 *
 * It tries all 24 exchanges of axes and keeps the best fit, so that it finds any rotation. The hand's acceleration is
 * not gravity, and a disturbed field is not that of the earth: only instants with lengths within 10 % of the usual ones
 * count. The residuals show how many in a row have a common error.
 */
#ifndef DIP_FRAME_H
#define DIP_FRAME_H

#include "read/waved.h"

/* Why there may be none. */
typedef enum {
    DIP_TOLD,
    DIP_NO_ACCELEROMETER, /* the log has none */
    DIP_UNEVEN,           /* its lengths differ too much: it is not calibrated, or was shaken */
    DIP_OPEN              /* the instants leave the rotation undetermined */
} dip_answer;

typedef struct {
    dip_answer answer;
    int is_corrected; /* a calibration corrected the accelerometer; else its readings were used as they are */
    unsigned long used;    /* instants that count, */
    unsigned long of;      /* of this many */
    double rotation[3][3]; /* of the axes of the magnetometer to those of the accelerometer */
    double angle[3];       /* the same as a rotation vector, rad, */
    double sigma[3];       /* and its standard deviations */
    double dip;            /* how steeply the field points down, rad; negative: up */
    double scatter;        /* of a R m, root mean square */
    double alike;          /* instants in a row with a common error */
    double heading;        /* error of a heading that results from sigma, rad */
} dip_frame;

/* Finds it.
 *
 * log            with a solution.
 * accelerometer  calibration of the units of its columns; null: its readings are used as they are.
 *
 * Returns EXIT_GOOD, whatever the result; EXIT_FILE, with a message, without memory. */
int dip_frame_find(const waved *log, const invcal_calibration *accelerometer, dip_frame *out);

#endif
