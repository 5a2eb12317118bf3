/* SPDX-License-Identifier: MIT
 *
 * design/design.h: a set of positions to visit, from any source, and the accuracy that it gives.
 */
#ifndef DESIGN_H
#define DESIGN_H

#include "design/criteria.h"
#include "design/stand_plan.h"

#define DESIGN_MAX (INVCAL_PLAN_GROUPS * INVCAL_PLAN_PER_GROUP_MAX)

typedef struct {
    unsigned group; /* of a stand program, 1 ... 3; else 0 */
    double alpha;   /* stand angles, degrees */
    double beta;
    double vertical[3]; /* up, in the instrument frame */
    double share;       /* of the total dwell, times count: 1 if all are held equally long */
} design_position;

typedef struct {
    char name[80];    /* "3 x 6", "icosahedron" */
    invcal_plan plan; /* of a stand program; else per_group is 0 */
    int is_stand;     /* alpha and beta are to be set on a stand */
    int has_shares;   /* positions are not held equally long */
    double dwell;     /* mean seconds in a position, if the source states them; else 0 */
    unsigned count;
    invcal_sums sums; /* H'H */
    int is_solvable;
    char refusal[400];     /* why it is not solvable, in words; */
    uint16_t undetermined; /* and the undetermined parameters */
    criteria criteria;
    double equal_log_det; /* with has_shares: ln det H'H if all were held equally long */
    uint8_t axes;         /* that point along gravity: bits of INVCAL_AXIS_PLUS_X ... */
    double drift_factor;  /* of this order: see order_drift_factor */
    double range[3][2];   /* minimum and maximum reading of each axis, over the field */
    design_position position[DESIGN_MAX];
} design; /* large: not for the stack */

/* The names of sets of positions on the command line, for help texts. */
#define DESIGN_WORDS                                                                               \
    "    per-group:N       3 groups of N positions for a two-axis stand, N from 5\n"               \
    "    per-group:N:A,B,C the same with these start angles, degrees\n"                            \
    "    faces             each axis up and down: 6 positions\n"                                   \
    "    edges             the faces and the 12 edges, midway between two axes: 18 positions\n"    \
    "    icosahedron       its 12 vertices\n"                                                      \
    "    stand-12          the 18 of per-group:6 without the six with an axis along gravity\n"     \
    "    stand-24          3 groups of 8 in steps of 45 degrees: 24 positions, 18 directions\n"    \
    "    optimal:N         N positions, 9 to 144, with the largest determinant\n"                  \
    "    grid:S:N          the same on a stand that stops every S = 15, 30 or 45 degrees\n"        \
    "    angles:FILE       columns alpha, beta and optionally dwell of a table\n"                  \
    "    directions:FILE   columns x y z of a table: up directions, their length is ignored\n"

/* Makes and evaluates a set from its name on the command line, `word`. `command` is for messages.
 *
 * Returns EXIT_GOOD; EXIT_DATA, without a message, if it is not solvable: see d->refusal (a
 * program of fewer than 5 positions in a group has count 0); with a message EXIT_USAGE for an
 * unknown word or a wrong number, EXIT_FILE. */
int design_make(design *d, const char *command, const char *word);

/* The file that the word names, or null; null for a null word. */
const char *design_file(const char *word);

/* Makes and evaluates the set of a stand program. `plan` is valid. */
void design_stand(design *d, const invcal_plan *plan);

/* Makes and evaluates a set of unit vectors. */
void design_directions(design *d, const char *name, double (*direction)[3], unsigned count);

/* Makes and evaluates `count` directions, optimal for the limits (optimal_within); with_axes: the
 * axes, up and down, are among them. */
void design_balanced(design *d, unsigned count, const double limits[3], int with_axes);

/* Distributes the dwell over the positions of a solvable set for the largest det H'H (weights.h),
 * and evaluates it again. */
void design_weigh(design *d);

/* The number of distinct directions. */
unsigned design_distinct(const design *d);

/* 1 if the positions are in groups, as those of a stand program and of stand-12 are. */
int design_has_groups(const design *d);

/* The direction that would add most information to a set, a unit vector. */
void design_next(const design *d, double up[3]);

/* The name of an axis, "+x" ... "-z". */
const char *design_axis_name(unsigned axis);

/* The time that positions take, and the noise of their means, if it is stated. */
typedef struct {
    double noise;   /* standard deviation of a mean over one second, over the field; 0: unknown */
    double warm_up; /* seconds once, before the first position */
    double dwell;   /* mean seconds in a position */
    double settle;  /* seconds before that in each position, not recorded */
    double move;    /* seconds between two positions */
} design_cost;

/* The parts of the total time, as the paper counts them; seconds. */
typedef struct {
    double warm_up;
    double settling;
    double turning;
    double recording;
} design_labour;

design_labour design_labour_of(unsigned count, const design_cost *cost);

/* Their sum. */
double design_seconds(unsigned count, const design_cost *cost);

/* When position n of a set begins, counted from 0: seconds from the start of the warm-up. */
double design_begins(const design *d, unsigned n, const design_cost *cost);

/* Standard deviation of a position mean over the field: noise / sqrt(dwell). */
double design_noise(const design_cost *cost);

#endif
