/* SPDX-License-Identifier: MIT
 *
 * watch/live_options.h: the options of a live calibration.
 */
#ifndef LIVE_OPTIONS_H
#define LIVE_OPTIONS_H

#include <stdio.h>

#include "design/design.h"
#include "fit/gyro.h"
#include "fit/sensors.h"
#include "invcal/allan.h"
#include "text/unit.h"
#include "cli/unit_style.h"

typedef struct {
    double rate;        /* 0: see samples.h */
    const double *clip; /* null, or minimum and maximum reading */
    reading_unit unit;  /* as stated; UNIT_UNKNOWN: from the header, if it states one */
    double field;
    const invcal_calibration *nominal; /* for the guidance; null: from zero and lsb */
    const double *zero;                /* null: 0 */
    const double *lsb;    /* null: by the unit, or from the first samples. If neither zero, lsb nor
                             the unit is stated, zero and scale are updated from the positions */
    sensor_choice sensor; /* gives the scale if neither lsb nor unit does */
    const design *set;    /* the program to follow; null: none */
    double target[3];     /* sigma; 0: no limit */
    double need;          /* largest error of lengths, over the field; 0: no limit */
    double field_sigma;   /* of the field, over itself */
    double stated;        /* noise of a position mean, over the field; 0: that of the samples */
    double mean_sigma;    /* required of a position mean, field units; 0: any */
    const invcal_noise *noise; /* of three axes, over the field, instead of the noise of the
                                  first rest; null: none. Needs mean_sigma */
    unit_style units;          /* the units of sigma */
    gyro_options gyro;
    FILE *out;
} live_options;

#endif
