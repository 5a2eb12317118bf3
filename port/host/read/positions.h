/* SPDX-License-Identifier: MIT
 *
 * read/positions.h: the means of the positions of a file.
 */
#ifndef POSITIONS_H
#define POSITIONS_H

#include <stdint.h>

#include "invcal/invcal.h"
#include "read/columns.h"

#define POSITIONS_MAX 65534u /* as many as invcal_calibrate_plain accepts */

/* Where a mean is from. NaN: not known. */
typedef struct {
    unsigned long line; /* from 1 */
    double begin;       /* of a rest in a log: seconds from the first sample */
    double end;
    double temperature; /* mean, degrees C */
    double drift;       /* of the temperature during the rest, K */
    double alpha;       /* angles of the stand, degrees; not known if they changed in the rest */
    double beta;
} position_origin;

struct rests_summary; /* read/log_rests.h */

typedef struct {
    const char *name;        /* of the file, for messages */
    recognition seen;        /* how its columns were understood */
    uint64_t bytes;          /* its size */
    uint32_t crc;            /* its CRC-32 */
    double *mean;            /* 3 * count numbers: x y z, ... in input units */
    position_origin *origin; /* count of them */
    unsigned count;
    unsigned capacity;
    int has_temperature;
    const struct rests_summary *rests; /* of a log, owned by the caller of rests_read; else null */
    int has_angles;                    /* there are columns alpha and beta */
    int has_noise;                     /* the file has std and n of each position */
    double noise_square[3]; /* if has_noise: the mean over the positions of std^2 / n for each axis,
                             * the variance of a position mean, input units squared, finite */
    double scatter;         /* of a log: sum over the positions of the variance of a sample */
    double quantum;      /* of a log: the smallest step of a reading, input units; 0: not known */
    double floor_square; /* part of noise_square due to rounding to it, however long a rest is */
} positions;

/* Reads a table of position means ("-": standard input).
 *
 * Returns EXIT_GOOD, with at least one position; EXIT_FILE, with a message, if the file is
 * unreadable or malformed, or holds no positions or more than POSITIONS_MAX. Warns about rows that
 * look like the samples of a log. Release it with positions_free in either case. */
int positions_read(positions *p, const char *path);

/* Adds one. EXIT_GOOD; EXIT_FILE, with a message, above POSITIONS_MAX or without memory. */
int positions_add(positions *p, const double mean[3], const position_origin *origin);

/* The noise of a position mean in the units of `nominal`, which converts readings from input units:
 * root mean square over the axes. */
double positions_noise(const positions *p, const invcal_calibration *nominal);

void positions_free(positions *p);

#endif
