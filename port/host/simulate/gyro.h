/* SPDX-License-Identifier: MIT
 *
 * simulate/gyro.h: a simulated gyroscope on the device that scene.h turns. It senses the shortest
 * rotation from up at one sample to up at the next, and a twist about up, which no accelerometer
 * senses.
 */
#ifndef SIMULATE_GYRO_H
#define SIMULATE_GYRO_H

#include "invcal/invcal.h"
#include "text/random.h"

/* The sensor: readings = (I + errors) rate + bias + g a + noise. */
typedef struct {
    double scale[3]; /* scale errors */
    double cross[6]; /* xy xz yx yz zx zy: reading of x from a rate about y, ..., rad */
    double bias[3];  /* degrees/s */
    double g[9];     /* degrees/s per g, by rows */
    double noise;    /* standard deviation of a sample, degrees/s */
    double lsb;      /* degrees/s per count */
    double range;    /* degrees/s at which readings are clipped */
} gyro_model;

/* State of the simulation. */
typedef struct {
    const gyro_model *model;
    random_source random;
    double rate;      /* samples per second */
    double before[3]; /* up at the last sample */
    int is_begun;
} gyro_scene;

void gyro_scene_begin(gyro_scene *s, const gyro_model *model, double rate, uint32_t seed);

/* The next reading, counts.
 *
 * up            true up direction.
 * acceleration  over the field.
 * twist         rad about up since the last sample. */
void gyro_scene_next(gyro_scene *s, const double up[3], const double acceleration[3], double twist,
                     int32_t raw[3]);

/* The calibration that corrects all errors except noise and g-sensitivity: counts to rad/s. */
invcal_calibration gyro_scene_truth(const gyro_model *model);

/* The g-sensitivity of readings corrected by that, rad/s per field. Returns 1 if there is any. */
int gyro_scene_g(const gyro_model *model, double g[3][3]);

#endif
