/* SPDX-License-Identifier: MIT
 *
 * plan/labour.h: how many positions, and how long in each, for the least time in all.
 *
 * More positions need less exact means, and so less time in each, but more moves. The noise of the
 * means is that of an Allan deviation (invcal/allan.h), the worst axis counts. Of slow noise it is
 * what n means scatter about their common mean by, T seconds each and P = T + settle + move apart:
 *
 *     N^2 / T + (B^2 / pi) sum (n - j) F(j P / T) / (n (n - 1)) + K^2 (P (n + 1) - T) / 6,
 *     F(r) = (r + 1)^2 ln (r + 1) + (r - 1)^2 ln |r - 1| - 2 r^2 ln r,         j = 1 ... n - 1
 *
 * from the mean square differences of the means of flicker noise and of a random walk. Without
 * time lost between (P = T) these are the factors of Barnes, n ln n / (2 (n - 1) ln 2) and n / 2.
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
#define LABOUR_REST 2.0        /* seconds: shorter rests are not found in a log (invcal/still.h) */
#define LABOUR_SHOWN 3u        /* times the best number: so far sizes are looked at, at least */
#define LABOUR_LONGEST 1e6     /* seconds in a position; more is never taken */

/* A number of positions. */
typedef struct {
    unsigned count;
    int is_possible; /* some dwell meets the limits; else dwell is the best there is */
    int is_beyond;   /* longer than the averaging times that the noise is known at */
    double dwell;    /* the shortest that does */
    double sigma;    /* of a position mean after it, over the field */
    double wanted;   /* sigma that the limits allow */
    double seconds;  /* in all */
    unsigned binds;  /* the limit that decides: 0 offsets, 1 scale errors, 2 angles */
} labour_row;

typedef struct labour {
    /* given: */
    const char *noise_name; /* of the file */
    invcal_noise noise[3];  /* over the field */
    double limits[3];       /* of the sigma of delta, dk, gamma */
    double settle;          /* seconds in each position that count for nothing */
    double move;            /* seconds between two */
    double warm_up;         /* seconds once */
    unsigned least;         /* positions, at least */
    int needs_axes;         /* each axis is to stand along gravity, up and down */
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

/* What it comes to, as the tellers of a plan take it: limits over the noise of a position mean,
 * and cost. */
void labour_request(const labour *l, double limits[3], choice_request *request);

extern const char *const labour_families[CHOICE_FAMILIES];

/* The rows of a family around its best one, or, without one, around the last: from *first to
 * before *end. */
void labour_around(const labour *l, unsigned family, unsigned *first, unsigned *end);

/* A table for people; members of the object that is open; the picture, total time against number
 * of positions, as a file of its own and in a page; the section of a page that has it. */
void labour_print(FILE *file, const labour *l);
void labour_json(json_writer *w, const labour *l);
void labour_svg(FILE *file, const labour *l);
void labour_picture(page *p, const labour *l);
void labour_report(page *p, const labour *l);

#endif
