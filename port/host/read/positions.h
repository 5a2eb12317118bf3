/* SPDX-License-Identifier: MIT
 *
 * read/positions.h: the position means of a file.
 */
#ifndef POSITIONS_H
#define POSITIONS_H

#include <stdint.h>

#include "invcal/invcal.h"
#include "read/columns.h"

#define POSITIONS_MAX 65534u /* what invcal_calibrate takes */

/* Where a mean comes from. What is not known is NaN. */
typedef struct {
    unsigned long line; /* from 1 */
    double begin;       /* of a rest in a log: seconds from the first sample */
    double end;
    double temperature; /* mean, */
    double drift;       /* and how far it went in the rest, K */
    double alpha; /* angles of the stand, degrees; of a rest in which they changed not known */
    double beta;
} position_origin;

struct rests_summary; /* read/rests.h */

typedef struct {
    const char *name;        /* of the file, for messages */
    recognition seen;        /* what the file was taken for */
    uint64_t bytes;          /* its size, */
    uint32_t crc;            /* and its CRC-32 */
    double *mean;            /* 3 count numbers: x y z, ... in input units */
    position_origin *origin; /* count of them */
    unsigned count;
    unsigned capacity;
    int has_temperature;
    const struct rests_summary *rests; /* of a log: what it was found in, as long as that lives */
    int has_angles;                    /* there are columns alpha and beta */
    int has_noise;                     /* the file has std and n of each position */
    double noise_square[3]; /* then for each axis the mean over the positions of std^2 / n: the
                               variance of a position mean, input units squared, finite */
    double scatter;         /* of a log: sum over the positions of the variance of a sample, */
    double quantum;         /* and the smallest step of a reading, input units; 0: not known */
    double floor_square;    /* what rounding to it adds to each noise_square, however long a rest */
} positions;

/* Reads a table of position means ("-": standard input).
 *
 * Returns EXIT_GOOD, with at least one position; EXIT_FILE, with a message, if the file is
 * unreadable, malformed, or holds no position or more than POSITIONS_MAX. Rows that look like the samples
 * of a log give a warning. To be released with positions_free in either case. */
int positions_read(positions *p, const char *path);

/* Adds one. EXIT_GOOD; EXIT_FILE, with a message, above POSITIONS_MAX or without memory. */
int positions_add(positions *p, const double mean[3], const position_origin *origin);

/* The noise of a position mean, the root mean square over axes, where `nominal` makes something of readings in input
 * units. */
double positions_noise(const positions *p, const invcal_calibration *nominal);

void positions_free(positions *p);

#endif
