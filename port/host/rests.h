/* SPDX-License-Identifier: MIT
 *
 * rests.h: the positions in a log of samples.
 */
#ifndef RESTS_H
#define RESTS_H

#include "invcal/still.h"
#include "positions.h"

enum { RESTS_REASONS = INVCAL_REST_SAME + 1 };

/* What was seen besides the positions. */
typedef struct {
    unsigned long samples;
    double seconds;
    double rate;
    int is_rate_known;
    unsigned long gaps;              /* in the times, or of lines that were skipped */
    unsigned long skipped;           /* malformed lines of a live stream */
    unsigned refused[RESTS_REASONS]; /* rests, by their reason */
} rests_summary;

/* Which line of the log each block of invcal_still began with: where samples were lost or lines
 * skipped, counting does not tell. The last RESTS_BLOCKS are remembered, half an hour. */
#define RESTS_BLOCKS 16384u
typedef struct {
    unsigned long line[RESTS_BLOCKS];
    unsigned long blocks; /* full ones so far */
    unsigned long start;  /* line of the one that is being filled, */
    unsigned fill;        /* and its samples so far */
    unsigned size;        /* samples of a block; 0: not known yet */
} rests_lines;

/* Before each sample is fed; after each that has filled a block. All bytes zero at the beginning. */
void rests_lines_sample(rests_lines *lines, unsigned long line, int is_gap);
void rests_lines_block(rests_lines *lines);

/* Adds a rest to the positions, with its line. `unit` is that of a count. Returns as
 * positions_add. */
int rests_take(positions *p, const invcal_rest *rest, double unit, const rests_lines *lines);

/* All rests are taken: makes noise_square a mean. */
void rests_end(positions *p);

/* Finds the rests in a log ("-": standard input), in fixed memory but for the positions.
 *
 * rate  samples a second; 0: see samples.h.
 * clip  null, or the least and the greatest reading of the sensor, input units.
 *
 * Returns EXIT_GOOD, also without any rest; EXIT_FILE, with a message. The positions are to be
 * released with positions_free in either case; their lines are those of the first samples. */
int rests_read(positions *p, const char *path, double rate, const double clip[2],
               rests_summary *summary);

#endif
