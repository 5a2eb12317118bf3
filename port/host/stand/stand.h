/* SPDX-License-Identifier: MIT
 *
 * stand/stand.h: what the angles of a two-axis stand add to the lengths of the readings.
 *
 * Conventions. With alpha = 0 the y axis of the unit points up, whatever beta; then the unit is turned by the
 * outer angle alpha about its x axis and by the inner angle beta about its y axis:
 *
 *     eta(alpha, beta) = (sin alpha sin beta, cos alpha, sin alpha cos beta)
 *
 * so that alpha = 90, beta = 0 points z up, and alpha = 90, beta = 90 points x up. That is what Table 2 of the
 * paper demands; it draws no arrows. For a stand that counts otherwise, state it: alpha = sense (reading - zero).
 *
 * Where the axes of the stand do not meet in the unit, it moves on a circle as they turn. At rest this
 * has no effect: gravity is the same everywhere on the stand, to 3e-7 for each metre of height.
 */
#ifndef STAND_H
#define STAND_H

#include "design/design.h"
#include "stand/group_series.h"
#include "stand/misset.h"
#include "read/positions.h"
#include "fit/rejection.h"

/* What the user says of the angles. */
typedef struct {
    int is_wanted;
    const design *plan; /* positions were visited in its order; null: columns alpha and beta */
    double sense[2];    /* of alpha and beta: 1, or -1 */
    double zero[2];     /* what the stand reads where alpha and beta are 0, degrees */
    int is_frame;       /* the result is to be in the frame of the stand */
} stand_wish;

/* How the angles are to be read so that they fit the readings. An alpha of the other sense is not among
 * them: it is as if the unit sat half a turn about its y axis away, and no reading shows which. */
typedef enum {
    STAND_AS_STATED,
    STAND_BETA_REVERSED,
    STAND_SWAPPED,
    STAND_SWAPPED_REVERSED,
    STAND_STRANGE, /* in none of these ways */
    STAND_FEW      /* too few angles, or in one plane: nothing can be said */
} stand_reading;

/* The vertical composition: an independent solution, whose rows know the direction. */
typedef struct {
    int is_known;
    double x[INVCAL_PARAMETERS];
    double sigma[INVCAL_PARAMETERS]; /* NaN without redundancy */
    double noise;                    /* of J1, over the field */
    unsigned dof;
} stand_vertical;

typedef struct {
    const char *from; /* "columns", or the name of the plan; null: no angles are wanted */
    double sense[2];  /* as stated: of the columns alpha and beta, */
    double zero[2];   /* and what they read where alpha and beta are 0, degrees */
    unsigned count;   /* positions with angles, of those that lengths kept */
    unsigned without; /* positions that have none, or whose angles changed */
    mounting_position *position;
    stand_reading reading;
    mounting mounting; /* what follows: STAND_AS_STATED only */
    misset *misset;
    unsigned missets;
    stand_vertical vertical;
    group_series series;
} stand;

/* An error of an angle up to this, rad, is resolved into alpha and beta. */
#define STAND_SMALL 0.5

/* Are there angles for these positions? Returns EXIT_GOOD; EXIT_FILE or EXIT_USAGE, with a message. */
int stand_check(const stand_wish *wish, const positions *data);

/* Which group of a program was not visited, by its angles, where the two others were: 1 ... 3; 0 if that is not
 * so, or without angles. No other group determines its angle between axes: zy, xz, xy. */
unsigned stand_missing_group(const stand_wish *wish, const positions *data);

/* Finds all of it.
 *
 * kept     what lengths kept,
 * raw      and its readings: 3 kept_count numbers.
 * nominal  raw to over the field.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, without memory. To be released with stand_free. */
int stand_find(stand *s, const stand_wish *wish, const positions *data, const rejection *kept,
               const double *raw, const invcal_calibration *nominal);

/* Turns a calibration in the symmetric frame to the stand. */
void stand_turn(const stand *s, invcal_calibration *calibration);

void stand_free(stand *s);

/* "as stated", "beta reversed", ... */
const char *stand_reading_name(stand_reading reading);

/* What is wrong with the angles and what to do: a sentence; "" if nothing is. */
const char *stand_advice(stand_reading reading);

#endif
