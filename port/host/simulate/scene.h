/* SPDX-License-Identifier: MIT
 *
 * simulate/scene.h: a simulated triad that is carried through a set of positions, sample by sample.
 */
#ifndef SCENE_H
#define SCENE_H

#include "design/design.h"
#include "simulate/gyro.h"
#include "text/random.h"

/* The sensor, and how it is handled. Lengths of time in seconds, accelerations over the field. */
typedef struct {
    double delta[3]; /* true errors, see invcal_solution */
    double dk[3];
    double gamma[3];
    double zero[3]; /* counts at zero field */
    double lsb;     /* field units per count */
    double field;
    double range;          /* at which readings are clipped */
    double noise;          /* standard deviation of a sample on each axis */
    double instability;    /* the same of the slow drift of each offset, correlation time 100 s */
    double drift;          /* of each offset per degree from 25 degrees C */
    double temperature[2]; /* degrees C, at the first sample and at the last */
    double rate;           /* samples per second */
    double dwell;
    double move;
    double tremor;          /* of the hand below 3 Hz, standard deviation */
    unsigned outliers;      /* number of positions with an error along the vertical */
    double outlier_size;    /* size of that error */
    const gyro_model *gyro; /* or null */
} scene_model;

typedef struct {
    double time;
    double temperature;
    int32_t raw[3];
    int32_t gyro[3]; /* if there is one */
    int position;    /* from 0; -1 during a move */
    double alpha;    /* angles of a two-axis stand, degrees; */
    double beta;     /* in a move they are interpolated linearly, the shorter way */
} scene_sample;

/* State of the simulation, set up by scene_begin. */
typedef struct {
    const scene_model *model;
    const design *route;
    random_source random;
    uint64_t index; /* of the next sample */
    uint64_t total; /* number of samples */
    double walk[3]; /* slow drift of the offsets */
    double tremor[3];
    double sideways[3]; /* direction of the detour in this move */
    double shake[3];    /* direction of the hand's acceleration in this move */
    double twist;       /* about up in this move, rad */
    double up[3];
    gyro_scene gyro;
    int leg;                  /* the last position that was reached; -1 before the first */
    double wrong[DESIGN_MAX]; /* error along the vertical at each position */
} scene;

/* Begins before the first sample. The model's numbers must be finite; rate, dwell, lsb and field
 * above 0; standard deviations and sizes not negative. */
void scene_begin(scene *s, const scene_model *model, const design *route, uint32_t seed);

/* The next sample. Returns 0 after the last. */
int scene_next(scene *s, scene_sample *out);

/* The reading of the triad, counts, of an acceleration over the field; `extra` is added to its
 * offsets. */
void scene_read(const scene_model *model, random_source *random, const double acceleration[3],
                const double extra[3], int32_t raw[3]);

/* The first sample of position i, and the one after its last. */
void scene_interval(const scene *s, unsigned i, uint64_t *begin, uint64_t *end);

/* The calibration that corrects all errors at 25 degrees C. */
invcal_calibration scene_truth(const scene_model *model);

#endif
