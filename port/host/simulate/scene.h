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
    double zero[3]; /* counts in no field */
    double lsb;     /* field units a count */
    double field;
    double range;          /* readings beyond are clipped */
    double noise;          /* standard deviation of a sample on each axis */
    double instability;    /* of a slow walk of each offset, which forgets in 100 s */
    double drift;          /* of each offset per degree, from 25 degrees C on */
    double temperature[2]; /* degrees C, at the first sample and at the last */
    double rate;           /* samples per second */
    double dwell;
    double move;
    double tremor;          /* standard deviation of what the hand adds below 3 Hz */
    unsigned outliers;      /* positions that are wrong, */
    double outlier_size;    /* along the vertical */
    const gyro_model *gyro; /* or null */
} scene_model;

typedef struct {
    double time;
    double temperature;
    int32_t raw[3];
    int32_t gyro[3]; /* if there is one */
    int position;    /* from 0; -1 on the way */
    double
        alpha; /* what a stand with two axes would read: on the way from one position to the next */
    double beta; /* as time goes by, the shorter way round; degrees */
} scene_sample;

/* What goes on: the caller's, to be begun with scene_begin. */
typedef struct {
    const scene_model *model;
    const design *route;
    random_source random;
    uint64_t index; /* of the next sample */
    uint64_t total; /* samples in all */
    double walk[3]; /* of the offsets */
    double tremor[3];
    double aside[3]; /* where the hand goes on this way, and how it shakes */
    double shake[3];
    double twist; /* about the way up, in this move, rad */
    double up[3];
    gyro_scene gyro;
    int leg;                  /* the position that is left now; -1 before the first */
    double wrong[DESIGN_MAX]; /* of each position */
} scene;

/* Begins with the first sample. The model's numbers are finite; rate, dwell, lsb and field are
 * above 0, nothing is negative that is a size. */
void scene_begin(scene *s, const scene_model *model, const design *route, uint32_t seed);

/* The next sample. Returns 0 after the last. */
int scene_next(scene *s, scene_sample *out);

/* What the triad reads, counts, of an acceleration over the field, with offsets that are off by `extra`. */
void scene_read(const scene_model *model, random_source *random, const double felt[3],
                const double extra[3], int32_t raw[3]);

/* First sample of position i, and the one after its last. */
void scene_interval(const scene *s, unsigned i, uint64_t *begin, uint64_t *end);

/* The calibration that takes out all errors at 25 degrees C. */
invcal_calibration scene_truth(const scene_model *model);

#endif
