/* SPDX-License-Identifier: MIT
 *
 * text/random.h: random numbers, the same on all machines for the same seed.
 */
#ifndef RANDOM_H
#define RANDOM_H

#include <stdint.h>

typedef struct {
    uint64_t state;
} random_source;

random_source random_start(uint32_t seed);

/* Uniformly distributed between two bounds. */
double random_uniform(random_source *source, double low, double high);

/* Normally distributed with standard deviation 1. */
double random_normal(random_source *source);

/* A unit vector, uniformly distributed over all directions. */
void random_direction(random_source *source, double direction[3]);

#endif
