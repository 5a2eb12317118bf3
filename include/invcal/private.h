/* SPDX-License-Identifier: MIT
 *
 * invcal/private.h: the state of structures of which only the size concerns a program. Nothing here
 * is part of the interface: any release may change it. Do not include it.
 */
#ifndef INVCAL_PRIVATE_H
#define INVCAL_PRIVATE_H

#include "invcal/config.h"

/* allan.h: an averaging time, and its sum. */
typedef struct {
    uint64_t past[2 * INVCAL_PRIVATE_OVERLAP]; /* totals: a ring */
    uint64_t low, high; /* of the squares of all differences; all bits 1: overflow */
    uint32_t m;         /* samples */
    uint32_t count;     /* differences in the sum */
} invcal_private_tau;

/* magnetometer.h: rows, sorted by direction. */
typedef struct {
    invcal_real sum[18][9]; /* over the samples of each cell */
    uint16_t count[18];     /* their number */
} invcal_private_cells;

/* A magnetometer in motion, see magnetometer.c. */
typedef struct {
    invcal_real unit;           /* length 1 of the cells, in the unit of nominal */
    invcal_real p[9];           /* the solution so far; before it, the box of the readings */
    invcal_real squares;        /* sum of squared residuals of samples, over field */
    invcal_real products;       /* sum over blocks of |sum eta r|^2, r being the residual */
    invcal_real before;         /* products over samples, at the last look */
    invcal_real block[3];       /* sum eta r of the current block */
    uint32_t blocked;           /* samples in squares, without those of the current block */
    uint32_t samples;           /* accepted since the first; above 16 million fewer */
    uint32_t due;               /* number of samples at the next look; 0: not begun */
    uint32_t dropped;           /* samples that contradicted the solution so far */
    uint16_t in_block;          /* samples in the current block */
    uint8_t stage;              /* of the solution */
    uint8_t has_step;           /* one was seen */
    invcal_private_cells early; /* of the samples up to the last look */
    invcal_private_cells late;  /* since then: a difference is a step */
} invcal_private_magnetometer;

/* A row of invcal_dip: the nine products of a and m, and 1. */
#define INVCAL_PRIVATE_DIP 10u

#endif
