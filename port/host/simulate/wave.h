/* SPDX-License-Identifier: MIT
 *
 * simulate/wave.h: a device with accelerometer and magnetometer that a hand turns to all sides, without a rest, sample
 * by sample.
 */
#ifndef WAVE_H
#define WAVE_H

#include "simulate/scene.h"

/* The magnetometer, and how it is handled. Magnetic fields in uT. */
typedef struct {
    double
        field[2];   /* length of the earth's, and its dip, degrees: below the horizon if positive */
    double hard[3]; /* hard iron: reading without a field */
    double soft
        [6]; /* soft iron, reading = (I + S) field: scale errors x y z, and angles xy xz zy, as dk and gamma */
    double turn[3]; /* of its axes against the accelerometer's, as a rotation vector, degrees */
    double
        noise; /* standard deviation on each axis of what neighbouring samples share; samples have a fifth of that
                        besides */
    double seconds;
    double magnet; /* when a magnet passes by, s; NaN: never */
} wave_model;

typedef struct {
    double time;
    int32_t raw[3]; /* of the accelerometer */
    double field[3];
} wave_sample;

/* The caller's, to be begun with wave_begin. */
typedef struct {
    const wave_model *model;
    const scene_model *accelerometer; /* dwell, move and what goes with positions do not matter */
    random_source random;
    uint64_t index; /* of the next sample */
    double up[3];   /* in the axes of the accelerometer, */
    double north[3];
    double rate[3]; /* rad/s about these */
    double tremor[3];
    double wander[3]; /* of the field */
    double magnet[3];
} wave;

/* Begins with the first sample. Numbers are finite; rate and seconds are above 0. */
void wave_begin(wave *w, const wave_model *model, const scene_model *accelerometer, uint32_t seed);

/* The next sample. Returns 0 after the last. */
int wave_next(wave *w, wave_sample *out);

/* The calibration that takes out hard and soft iron: uT to uT, in the magnetometer's axes. */
invcal_calibration wave_truth(const wave_model *model);

/* What turns these to the axes of the accelerometer. */
void wave_axes(const wave_model *model, double r[3][3]);

#endif
