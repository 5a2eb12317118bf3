/* SPDX-License-Identifier: MIT
 *
 * simulate/wave.h: a simulated device with accelerometer and magnetometer that is waved: turned to
 * all sides without a rest, sample by sample.
 */
#ifndef WAVE_H
#define WAVE_H

#include "simulate/scene.h"

/* The magnetometer, and how it is handled. Magnetic fields in uT. */
typedef struct {
    double field[2]; /* of the earth: length, and dip, degrees below the horizon */
    double hard[3];  /* hard iron: reading at zero field */
    double soft[6];  /* soft iron S, reading = (I + S) field: as dk x y z, gamma xy xz zy */
    double turn[3];  /* of its axes relative to the accelerometer's: rotation vector, degrees */
    double noise; /* on each axis, correlated, standard deviation; white noise is a fifth of it */
    double seconds;
    double magnet; /* time when a magnet begins to pass by, s; NaN: never */
} wave_model;

typedef struct {
    double time;
    int32_t raw[3]; /* of the accelerometer */
    double field[3];
} wave_sample;

/* State of the simulation, set up by wave_begin. */
typedef struct {
    const wave_model *model;
    const scene_model *accelerometer; /* its members about positions and moves are not used */
    random_source random;
    uint64_t index; /* of the next sample */
    double up[3];   /* in the axes of the accelerometer, as are the next two */
    double north[3];
    double rate[3]; /* rad/s */
    double tremor[3];
    double noise[3];  /* correlated, of the field */
    double magnet[3]; /* direction of its field */
} wave;

/* Begins before the first sample. Numbers must be finite, rate and seconds above 0. */
void wave_begin(wave *w, const wave_model *model, const scene_model *accelerometer, uint32_t seed);

/* The next sample. Returns 0 after the last. */
int wave_next(wave *w, wave_sample *out);

/* The calibration that corrects hard and soft iron: uT to uT, in the magnetometer's axes. */
invcal_calibration wave_truth(const wave_model *model);

/* The rotation from these to the axes of the accelerometer. */
void wave_axes(const wave_model *model, double r[3][3]);

#endif
