/* SPDX-License-Identifier: MIT
 *
 * fit/dip_frame.h: the calibrated axes of a magnetometer turned to those of the accelerometer that was logged
 * beside it (invcal_dip of invcal/magnetometer.h).
 *
 * Of 24 ways in which axes are exchanged the one from which the rotation fits best counts, so that any rotation
 * is found. What the hand accelerates is no gravity, and a disturbed field is none: instants count whose lengths are
 * within 10 % of the usual ones. How many in a row err as one is told by the residuals themselves.
 */
#ifndef DIP_FRAME_H
#define DIP_FRAME_H

#include "read/waved.h"

/* Why there may be none. */
typedef enum {
    DIP_TOLD,
    DIP_NO_ACCELEROMETER, /* the log has none */
    DIP_UNEVEN,           /* its lengths differ too much: it is not calibrated, or was shaken */
    DIP_OPEN              /* the instants leave the rotation open */
} dip_answer;

typedef struct {
    dip_answer answer;
    int is_corrected;      /* the accelerometer, by a calibration; else it was taken as it reads */
    unsigned long used;    /* instants that told it, */
    unsigned long of;      /* of so many */
    double rotation[3][3]; /* of the axes of the magnetometer to those of the accelerometer */
    double angle[3];       /* the same as a rotation vector, rad, */
    double sigma[3];       /* and its standard deviations */
    double dip;            /* how steeply the field points down, rad; negative: up */
    double scatter;        /* of a R m, root mean square */
    double alike;          /* instants in a row that err as one */
    double heading;        /* what sigma leaves of the error of a heading, rad */
} dip_frame;

/* Finds it.
 *
 * log            with its pairs, and a solution.
 * accelerometer  of the units of its columns; null: it is taken as it reads.
 *
 * Returns EXIT_GOOD, whatever the answer; EXIT_FILE, with a message, without memory. */
int dip_frame_find(const waved *log, const invcal_calibration *accelerometer, dip_frame *out);

#endif
