/* SPDX-License-Identifier: MIT
 *
 * design/program.h: progress through a set of positions, on a stand or by hand: which one is next,
 * and at which one a rest was.
 *
 * A rest is known by its direction alone, so two positions of the same direction count as one.
 */
#ifndef PROGRAM_H
#define PROGRAM_H

#include "design/design.h"

#define PROGRAM_NO_POSITION DESIGN_MAX /* no position of the set */
#define PROGRAM_TEXT_MAX 256

typedef struct {
    const design *set;
    unsigned char visited[DESIGN_MAX]; /* 0: no; 1: not needed, its direction was; 2: yes */
    unsigned next;                     /* the first that has not been visited; set->count: none */
    int has_rest;                      /* there has been one */
    int is_repeat; /* the last one was at a position not needed: its direction was visited before */
    unsigned current; /* the position of the last rest, or PROGRAM_NO_POSITION */
    double up[3];     /* the direction of that rest */
} program;            /* large: not for the stack */

/* Begins with the first position. */
void program_begin(program *p, const design *set);

/* The position that a direction belongs to: the requested one, if that is within 20 degrees and no
 * other is nearer by 3 degrees or more (a stand's tilt, and offsets not known yet, turn a direction
 * by that much); else the nearest within 20 degrees; else PROGRAM_NO_POSITION.
 *
 * up  of a length above 0. */
unsigned program_find(const program *p, const double up[3]);

/* Records a rest at a position, or at PROGRAM_NO_POSITION. */
void program_visit(program *p, unsigned position, const double up[3]);

/* Zero and scale by least squares, assuming that the first rests were at the first positions, in
 * order: mean = zero + length * vertical. For readings with an unknown zero.
 *
 * mean    3 * count numbers, input units.
 * count   from 2 to that of the set.
 * length  of the field, input units.
 *
 * Returns 1 if the residuals are below a tenth of the field; else, and if all positions have one
 * direction, 0. */
int program_scale(const program *p, const double *mean, unsigned count, double zero[3],
                  double *length);

/* The next position: "position 2 of 18: alpha 90, beta 0 deg; turn alpha +60 deg; +z up". The turn
 * is that from the last rest, if there was one. "" if all have been visited. */
const char *program_next_text(const program *p, char text[PROGRAM_TEXT_MAX]);

/* The same in short, "alpha 90, beta 0 deg". */
const char *program_angles_text(const program *p, char text[PROGRAM_TEXT_MAX]);

/* A rest that was not at the requested position: "that is position 3 (alpha 150, beta 0 deg), not
 * 2"; or "that is alpha 47, beta 3 deg, not a position of the program; go to 2". */
const char *program_wrong_text(const program *p, unsigned requested, char text[PROGRAM_TEXT_MAX]);

/* The numbers of those that have not been visited: "2, 5, 17". Returns text. */
const char *program_missing_text(const program *p, char text[PROGRAM_TEXT_MAX]);

#endif
