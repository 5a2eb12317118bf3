/* SPDX-License-Identifier: MIT
 *
 * design/design.h: a set of positions to visit, whatever it comes from, and what it is worth.
 */
#ifndef DESIGN_H
#define DESIGN_H

#include "design/criteria.h"
#include "invcal/plan.h"

#define DESIGN_MAX (INVCAL_PLAN_GROUPS * INVCAL_PLAN_PER_GROUP_MAX)

typedef struct {
    unsigned group; /* of a stand program, 1 ... 3; else 0 */
    double alpha;   /* stand angles, degrees */
    double beta;
    double vertical[3]; /* up, in the instrument frame */
    double share;       /* of the dwell, times their number: 1 if all are held equally long */
} design_position;

typedef struct {
    char name[80];    /* "3 x 6", "icosahedron" */
    invcal_plan plan; /* of a stand program; else per_group is 0 */
    int is_stand;     /* its angles are those of a stand, to be set as they are */
    int has_shares;   /* positions are not held equally long */
    double dwell;     /* seconds in a position, the mean, if it comes with them; else 0 */
    unsigned count;
    invcal_sums sums; /* H'H */
    int is_solvable;
    char refusal[400];     /* if it is not solvable: why, for people, */
    uint16_t undetermined; /* and the parameters that it leaves open */
    criteria criteria;
    double equal_log_det; /* ln det H'H if all were held equally long; or has_shares is 0 */
    uint8_t axes;         /* that point along gravity: bits of INVCAL_AXIS_PLUS_X ... */
    double hidden;        /* by how much sigma grows if a drift is to be separated, in this order */
    double range[3][2];   /* what each axis feels, least and most, over the field */
    design_position position[DESIGN_MAX];
} design; /* large: not for the stack */

/* What sets of positions are called on the command line, as a part of help texts. */
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

/* Makes and judges a set from its word. `command` is for messages.
 *
 * Returns EXIT_GOOD; EXIT_DATA, without a message, if it is not solvable: see d->refusal (a
 * program of fewer than 5 positions in a group has count 0); with a message EXIT_USAGE for an
 * unknown word or a wrong number, EXIT_FILE. */
int design_make(design *d, const char *command, const char *word);

/* The file that the word of a set names, or null. A word that is null has none. */
const char *design_file(const char *word);

/* Makes and judges the set of a stand program. `plan` is usable. */
void design_stand(design *d, const invcal_plan *plan);

/* Makes and judges a set of unit vectors. */
void design_directions(design *d, const char *name, double (*direction)[3], unsigned count);

/* Makes and judges `count` directions, balanced to the limits (optimal_within); with_axes: the axes, up
 * and down, among them. */
void design_balanced(design *d, unsigned count, const double limits[3], int with_axes);

/* Shares the dwell among the positions of a set that is solvable so that det H'H is the largest
 * (weights.h), and judges it again. */
void design_weigh(design *d);

/* How many directions there are: positions that point the same way count once. */
unsigned design_distinct(const design *d);

/* Are they in groups, as those of a stand program and of stand-12 are? */
int design_has_groups(const design *d);

/* The direction that would add most to a set, a unit vector. */
void design_next(const design *d, double up[3]);

/* The name of an axis, "+x" ... "-z". */
const char *design_axis_name(unsigned axis);

/* What a position costs and, if the user states it, what its mean is worth. */
typedef struct {
    double noise;   /* standard deviation of a mean over one second, over the field; 0: unknown */
    double warm_up; /* seconds once, before the first position */
    double dwell;   /* seconds in a position, the mean of all */
    double settle;  /* and those before, that count for nothing */
    double move;    /* seconds between two */
} design_cost;

/* What the labour of so many positions consists of, as the paper counts it. Seconds. */
typedef struct {
    double warm_up;
    double settling;
    double turning;
    double recording;
} design_labour;

design_labour design_labour_of(unsigned count, const design_cost *cost);

/* All of it. */
double design_seconds(unsigned count, const design_cost *cost);

/* When position n of a set begins, counted from 0: seconds from the start of the warm-up. */
double design_begins(const design *d, unsigned n, const design_cost *cost);

/* Standard deviation of a position mean over the field: noise / sqrt(dwell). */
double design_noise(const design_cost *cost);

#endif
