/* SPDX-License-Identifier: MIT
 *
 * plan/labour.h: the number of positions and the dwell that need the least total time.
 *
 * With more positions, means may be less accurate, so each takes less time, but there are more
 * moves. The noise of the means is from an Allan deviation (invcal/allan.h), for the worst axis.
 * With slow noise it is the scatter of n means about their common mean, of T seconds each at
 * intervals of P = T + settle + move:
 *
 *     N^2 / T + (B^2 / pi) sum (n - j) F(j P / T) / (n (n - 1)) + K^2 (P (n + 1) - T) / 6,
 *     F(r) = (r + 1)^2 ln (r + 1) + (r - 1)^2 ln |r - 1| - 2 r^2 ln r,         j = 1 ... n - 1
 *
 * from the mean square differences of the means of flicker noise and of a random walk. Without dead
 * time (P = T) these are the factors of Barnes, n ln n / (2 (n - 1) ln 2) and n / 2.
 */
#ifndef PLAN_LABOUR_H
#define PLAN_LABOUR_H

#include <stdio.h>

#include "design/choice.h"
#include "invcal/allan.h"
#include "text/json_write.h"
#include "draw/page.h"
#include "design/optimal.h"

#define LABOUR_MAX OPTIMAL_MAX /* positions, of either family */
#define LABOUR_DWELL_MIN 2.0   /* seconds: shorter rests are not found in a log (invcal/expert.h) */
#define LABOUR_RANGE 3u        /* sizes are tried at least up to this many times the best one */
#define LABOUR_DWELL_MAX 1e6   /* seconds in a position; more is never taken */

/* A number of positions. */
typedef struct {
    unsigned count;
    int is_possible; /* a dwell meets the limits */
    int is_beyond;   /* dwell is longer than the averaging times of the measured noise */
    double dwell;    /* the shortest that meets them; if none does, that of the smallest sigma */
    double sigma;    /* of a position mean after it, over the field */
    double allowed;  /* sigma that the limits allow */
    double seconds;  /* total */
    unsigned binds;  /* the limit that is reached: 0 offsets, 1 scale errors, 2 angles */
} labour_row;

typedef struct labour {
    /* given: */
    const char *noise_name; /* of the file */
    invcal_noise noise[3];  /* over the field */
    double limits[3];       /* of the sigma of delta, dk, gamma */
    double settle;          /* seconds in each position before recording */
    double move;            /* seconds between two */
    double warm_up;         /* seconds once */
    unsigned min_count;     /* of positions */
    int needs_axes;         /* as in choice_request */
    unit_style units;       /* units */
    /* found: */
    labour_row row[CHOICE_FAMILIES][LABOUR_MAX]; /* of ascending count */
    unsigned rows[CHOICE_FAMILIES];
    const labour_row *best[CHOICE_FAMILIES]; /* null: none meets the limits */
    unsigned chosen;                         /* family */
    char refusal[400];
} labour; /* large: not for the stack */

/* Standard deviation of position means about their common mean, worst axis, over the field. */
double labour_sigma(const labour *l, unsigned count, double dwell);

/* Finds the best of both families, and makes the chosen set.
 *
 * Returns EXIT_GOOD; EXIT_DATA, without a message: see refusal. */
int labour_find(labour *l, design *set);

/* The result as a request for the output functions of results.h: limits over the noise of a position
 * mean, and cost. */
void labour_request(const labour *l, double limits[3], choice_request *request);

extern const char *const labour_families[CHOICE_FAMILIES];

/* The rows of a family near its best one, or, if there is none, near the last: from *first up to,
 * but not including, *end. */
void labour_near_best(const labour *l, unsigned family, unsigned *first, unsigned *end);

/* A table; members of the open JSON object; the picture of total time against number of positions,
 * as a file and in a page; the section of a page. */
void labour_print(FILE *file, const labour *l);
void labour_json(json_writer *w, const labour *l);
void labour_svg(FILE *file, const labour *l);
void labour_picture(page *p, const labour *l);
void labour_report(page *p, const labour *l);

#endif
