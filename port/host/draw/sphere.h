/* SPDX-License-Identifier: MIT
 *
 * draw/sphere.h: directions on the two halves of the sphere, z up and z down, in Lambert's
 * equal-area projection, both seen from +z, with numbers that do not overlap.
 *
 * A half is drawn into a box of SPHERE_WIDTH by SPHERE_HEIGHT pixels whose upper left corner is
 * the origin: a picture of its own, or a part of one (svg_group_begin).
 */
#ifndef SPHERE_H
#define SPHERE_H

#include <stdio.h>

#include "draw/svg.h"

#define SPHERE_WIDTH 336.0
#define SPHERE_HEIGHT 348.0
#define SPHERE_NUMBERED 48u /* more directions than this are not numbered */
#define SPHERE_EQUATOR 1e-9 /* |z| up to this is on the equator, which belongs to the upper half */

/* The meaning of a mark, shown by its colour and shape. */
typedef enum {
    SPHERE_POSITION, /* of any group, or the first one */
    SPHERE_GROUP_2,
    SPHERE_GROUP_3,
    SPHERE_LEFT_OUT,
    SPHERE_NEXT,
    SPHERE_KINDS
} sphere_kind;

typedef struct {
    double up[3]; /* unit vector */
    sphere_kind kind;
} sphere_mark;

/* A quantity that depends on direction, shown by colours: class k where it is below threshold[k],
 * the last class elsewhere. */
#define SPHERE_CLASSES 6u
typedef struct {
    double (*value)(const void *context, const double up[3]);
    const void *context;
    double threshold[SPHERE_CLASSES - 1];
    unsigned classes; /* 1 ... SPHERE_CLASSES */
} sphere_shading;

#define SPHERE_LABEL_MAX 24
#define SPHERE_OCCUPIED_MAX (2 * SPHERE_NUMBERED + 16)

/* A rectangle in the picture: its centre, and half of its sides. */
typedef struct {
    double x, y;
    double w, h;
} sphere_box;

/* A spot of the picture with one mark or several, which share a label. */
typedef struct {
    double x, y;
    unsigned half;
    double radius; /* of its marker */
    sphere_kind kind;
    char label[SPHERE_LABEL_MAX];
    sphere_box place; /* of the label */
    svg_anchor anchor;
    int is_labelled; /* a place was found for the label */
} sphere_spot;

typedef struct {
    const sphere_mark *mark;
    unsigned count;
    const sphere_shading *shading; /* or null */
    unsigned unlabelled[2];        /* spots of each half whose number has no place */
    /* private */
    unsigned spots;
    unsigned spot_of[SPHERE_NUMBERED]; /* index of the spot of each mark */
    sphere_spot spot[SPHERE_NUMBERED];
    unsigned occupied_count;
    sphere_box occupied[SPHERE_OCCUPIED_MAX]; /* by markers and texts of the half being arranged */
} sphere;

/* Places marks and labels. Marks are numbered from 1 in their order; those of SPHERE_NEXT have
 * letters instead, or no label if there is only one. `mark` and `shading` must outlive s. */
void sphere_arrange(sphere *s, const sphere_mark *mark, unsigned count,
                    const sphere_shading *shading);

/* Draws the upper (0) or lower (1) half, with its caption. */
void sphere_draw(FILE *file, const sphere *s, unsigned half);

/* The marker of a kind, for legends. */
void sphere_marker(FILE *file, sphere_kind kind, double x, double y);

#endif
