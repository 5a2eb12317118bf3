/* SPDX-License-Identifier: MIT
 *
 * watch/wish.h: what is asked of a live calibration.
 */
#ifndef WISH_H
#define WISH_H

#include <stdio.h>

#include "design/design.h"
#include "fit/gyro.h"
#include "fit/sensors.h"
#include "invcal/allan.h"
#include "text/unit.h"
#include "cli/unit_style.h"

typedef struct {
    double rate;        /* 0: see samples.h */
    const double *clip; /* null, or least and greatest reading */
    reading_unit unit;  /* stated; UNIT_UNKNOWN: the heading may state it */
    double field;
    const invcal_calibration *nominal; /* for the guidance; null: */
    const double *zero;   /* zero, else 0, and scale, else by the unit or from the first samples; if
                           neither they nor the unit are given, both are found again from the */
    const double *lsb;    /* positions */
    sensor_choice sensor; /* whose readings they are, for a scale that neither lsb nor unit gives */
    const design *set;    /* the program to follow; null: free hand */
    double target[3];     /* sigma that is enough; 0: any */
    double need;          /* what lengths may be wrong by, over the field; 0: anything */
    double field_sigma;   /* what the field may, over itself */
    double stated;        /* noise of a position mean, over the field; 0: that of the samples */
    double mean_sigma;    /* of a position mean that is wanted, field units; 0: any */
    const invcal_noise *noise; /* of three axes, over the field, instead of the noise of the
                                  first rest; null: none. Needs mean_sigma */
    unit_style units;          /* the units of sigma */
    gyro_options gyro;
    FILE *talk; /* where to say it */
} live_wish;

#endif
