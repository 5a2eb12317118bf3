/* SPDX-License-Identifier: MIT
 *
 * stand/stand.h: results from the angles of a two-axis stand, in addition to those from lengths.
 *
 * Conventions. With alpha = 0 the y axis of the unit points up, whatever beta; then the unit is
 * turned by the outer angle alpha about its x axis and by the inner angle beta about its y axis:
 *
 *     eta(alpha, beta) = (sin alpha sin beta, cos alpha, sin alpha cos beta)
 *
 * so that alpha = 90, beta = 0 points z up, and alpha = 90, beta = 90 points x up. This follows
 * from Table 2 of the paper; its figure shows no senses. For a stand with other conventions, alpha
 * = sense (reading - zero).
 *
 * If the axes of the stand do not meet in the unit, it moves on a circle as they turn. At rest this
 * has no effect: gravity changes by only 3e-7 per metre of height.
 */
#ifndef STAND_H
#define STAND_H

#include "design/design.h"
#include "stand/group_series.h"
#include "stand/misset.h"
#include "read/positions.h"
#include "fit/rejection.h"

/* --stand, --plan and what belongs to them. */
typedef struct {
    int is_wanted;
    const design *plan; /* positions were visited in its order; null: columns alpha and beta */
    double sense[2];    /* of alpha and beta: 1 or -1 */
    double zero[2];     /* readings of the stand where alpha and beta are 0, degrees */
    int is_frame;       /* rotate the result to the frame of the stand */
} stand_options;

/* The convention with which the angles fit the readings. Alpha reversed is not among them: it has
 * the same effect as a unit mounted half a turn about its y axis away, and readings cannot
 * distinguish the two. */
typedef enum {
    STAND_AS_STATED,
    STAND_BETA_REVERSED,
    STAND_SWAPPED,
    STAND_SWAPPED_REVERSED,
    STAND_STRANGE, /* none of these fits */
    STAND_SCATTERED, /* as stated, but for errors that the noise does not explain, nor a few positions */
    STAND_FEW        /* too few angles, or in one plane, to decide */
} stand_convention;

/* The solution by the vertical composition J1, which uses the directions; independent of that by
 * lengths. */
typedef struct {
    int is_known;
    double x[INVCAL_PARAMETERS];
    double sigma[INVCAL_PARAMETERS]; /* NaN without redundancy */
    double noise;                    /* of J1, over the field */
    unsigned dof;
} stand_vertical;

typedef struct {
    const char *from;        /* "columns", or the name of the plan; null: the angles are not used */
    double sense[2];         /* of the columns alpha and beta, as stated */
    double zero[2];          /* readings of these where alpha and beta are 0, degrees */
    unsigned count;          /* positions with angles that the fit of lengths kept */
    int may_be_radians;      /* no angle of the columns is beyond two turns in radians */
    unsigned without_angles; /* positions without angles, or whose angles changed */
    mounting_position *position;
    stand_convention convention;
    mounting mounting; /* this and what follows: with STAND_AS_STATED only */
    misset *misset;
    unsigned missets;
    stand_vertical vertical;
    group_series series;
} stand;

/* An error of an angle up to this, rad, is resolved into alpha and beta. */
#define STAND_SMALL_ANGLE 0.5

/* Checks that there are angles for these positions. Returns EXIT_GOOD; EXIT_FILE, with a
 * message. */
int stand_check(const stand_options *options, const positions *data);

/* The group of a program, 1 ... 3, that was not visited while the other two were; 0 if there is no
 * such group or there are no angles. No other group determines its angle between axes: zy, xz,
 * xy. */
unsigned stand_missing_group(const stand_options *options, const positions *data);

/* Finds all results.
 *
 * kept     the positions that the fit of lengths kept.
 * raw      their readings: 3 kept_count numbers.
 * nominal  input units to multiples of the field.
 * noise    of a position mean, over the field; NaN: not known.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, without memory. To be released with stand_free. */
int stand_find(stand *s, const stand_options *options, const positions *data, const rejection *kept,
               const double *raw, const invcal_calibration *nominal, double noise);

/* Turns a calibration from the symmetric frame to that of the stand. */
void stand_turn(const stand *s, invcal_calibration *calibration);

void stand_free(stand *s);

/* "as stated", "beta reversed", ... */
const char *stand_convention_name(stand_convention convention);

/* What is wrong with the angles, and what to do: a sentence, until the next call; "" if nothing is. */
#define STAND_ADVICE_MAX 300
const char *stand_advice(const stand *s);

#endif
