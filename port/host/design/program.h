/* SPDX-License-Identifier: MIT
 *
 * design/program.h: following a set of positions, at a stand or by hand: which one is to be next, and which
 * one of them a rest was at.
 *
 * A rest is known by its direction alone, so two positions of the same direction count as one.
 */
#ifndef PROGRAM_H
#define PROGRAM_H

#include "design/design.h"

#define PROGRAM_NOWHERE DESIGN_MAX /* no position of the set */
#define PROGRAM_TEXT_MAX 256

typedef struct {
    const design *set;
    unsigned char visited[DESIGN_MAX]; /* 0: not; 1: not needed, its direction was; 2 */
    unsigned asked; /* the first that has not been visited; set->count: there is none */
    int has_rest;   /* there has been one */
    int is_again;   /* the last one was where none was needed, after one of the same direction */
    unsigned here;  /* the position that the last rest was at, or PROGRAM_NOWHERE */
    double up[3];   /* the direction of that rest */
} program;          /* large: not for the stack */

/* Begins with the first position. */
void program_begin(program *p, const design *set);

/* Which position a direction belongs to: the one asked for, if it is within 20 degrees of that, and no
 * other is nearer by 3 degrees or more (a stand's tilt, and offsets that are not known yet, turn a
 * direction by as much); else the nearest within 20 degrees; else PROGRAM_NOWHERE.
 *
 * up  of a length above 0. */
unsigned program_find(const program *p, const double up[3]);

/* A rest was at a position, or nowhere. */
void program_visit(program *p, unsigned position, const double up[3]);

/* Zero and scale by least squares, if the first rests were at the first positions, in order: mean = zero +
 * length * vertical. For readings with an unknown zero.
 *
 * mean    3 count numbers, input units.
 * count   from 2 to that of the set.
 * length  of the field, input units.
 *
 * Returns 1; 0, for positions that are all one direction, within a tenth of the field. */
int program_scale(const program *p, const double *mean, unsigned count, double zero[3],
                  double *length);

/* What is to be next: "position 2 of 18: alpha 90, beta 0 deg; turn alpha +60 deg; +z up". The turn
 * is that from the last rest, if there was one. "" if all have been visited. */
const char *program_next_text(const program *p, char text[PROGRAM_TEXT_MAX]);

/* The same in short, "alpha 90, beta 0 deg". */
const char *program_angles_text(const program *p, char text[PROGRAM_TEXT_MAX]);

/* Where a rest was that was not asked for: "that is position 3 (alpha 150, beta 0 deg), not 2"; or "that
 * is alpha 47, beta 3 deg, no position of the program; 2 was asked for". */
const char *program_wrong_text(const program *p, unsigned asked, char text[PROGRAM_TEXT_MAX]);

/* The numbers of those that have not been visited: "2, 5, 17". Returns text. */
const char *program_missing_text(const program *p, char text[PROGRAM_TEXT_MAX]);

#endif
