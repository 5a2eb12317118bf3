/* SPDX-License-Identifier: MIT
 *
 * fit/dip_frame.h: rotates the calibrated axes of a magnetometer to those of the accelerometer in
 * the same log (invcal_dip of invcal/magnetometer.h).
 *
 * It tries all 24 rotations that permute the axes and keeps the best fit, so that it finds any
 * rotation. The hand's acceleration is not gravity, and a disturbed field is not that of the Earth:
 * only instants with lengths within 10 % of the medians are used. The residuals show how many
 * successive instants have a common error.
 */
#ifndef DIP_FRAME_H
#define DIP_FRAME_H

#include "read/magnetometer_log.h"

/* The result, or why there is none. */
typedef enum {
    DIP_FOUND,
    DIP_NO_ACCELEROMETER, /* the log has none */
    DIP_UNEVEN,           /* its lengths vary too much: it is not calibrated, or was shaken */
    DIP_UNDETERMINED      /* the instants do not determine the rotation */
} dip_answer;

typedef struct {
    dip_answer answer;
    int is_corrected; /* the accelerometer was calibrated; else its readings are used as they are */
    unsigned long used;       /* number of instants used */
    unsigned long of;         /* number of all instants */
    invcal_rotation rotation; /* from the axes of the magnetometer to those of the accelerometer */
    double angle[3];          /* the same as a rotation vector, rad */
    double sigma[3];          /* standard deviations of angle */
    double dip;               /* inclination of the field, rad, positive down */
    double scatter;           /* of a R m, root mean square */
    double alike;             /* number of successive instants with a common error */
    double heading;           /* error of a heading that results from sigma, rad */
} dip_frame;

/* Finds the rotation.
 *
 * log            with a solution.
 * accelerometer  calibration for the units of its columns; null: its readings are used as they are.
 *
 * Returns EXIT_GOOD, also without a result; EXIT_FILE, with a message, if memory is short. */
int dip_frame_find(const magnetometer_log *log, const invcal_calibration *accelerometer,
                   dip_frame *out);

#endif
