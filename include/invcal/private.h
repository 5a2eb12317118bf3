/* SPDX-License-Identifier: MIT
 *
 * invcal/private.h: state of which only the size concerns a program. Nothing here is part of the
 * interface: any release may change it.
 */
#ifndef INVCAL_PRIVATE_H
#define INVCAL_PRIVATE_H

#include "invcal/config.h"

/* An axis of the rest detector. Means are in 1/1024 counts. */
typedef struct {
    int32_t first;  /* first sample of the block */
    uint32_t sum;   /* of the differences to it, modulo 2^32; then the block's mean from origin */
    int32_t origin; /* what block means are relative to */
    int32_t place;  /* of the last position; before the first one, of the first block */
    struct {
        uint64_t total;     /* sum of the samples, relative to origin, modulo 2^64 */
        int32_t pending[2]; /* means of the blocks held back: lost if motion follows */
        int32_t once;       /* exponential mean of the means */
        int32_t lag;        /* its lead over its own exponential mean */
    } rest;                 /* the current one */
} invcal_private_axis;

/* The rest detector. A level is a logarithm, see rests.c. */
typedef struct {
    uint8_t stage, flags, hold, drift; /* of the current rest, see rests.c */
    uint8_t pended;                    /* its newest blocks, held back, up to 2; 0: none */
    uint8_t skip;                      /* quiet blocks to skip before it begins */
    uint8_t reason;                    /* of the last refusal */
    uint8_t taken;                     /* 1: `place` is that of a position */
    uint8_t seen;                      /* of the block */
    uint8_t run;                       /* blocks in a row of another noise level, or of none */
    uint8_t least;       /* min blocks of a position, however short the time to hold */
    uint8_t bits;        /* a block has 1 << bits samples */
    uint16_t dwell;      /* min blocks with the time to hold */
    uint16_t blocks;     /* summed in the rest, without those held back; at most 1.6 hours */
    uint16_t pace;       /* blocks in 1/125 s, 1/65536 */
    int16_t noise;       /* level, learned from the stream; 0: not known yet */
    int16_t wander;      /* the same */
    int16_t reach;       /* the same */
    int16_t other;       /* candidate for a new noise level */
    uint16_t missing;    /* samples until the block is full; 0: the next one begins a block */
    uint32_t span;       /* twice the largest difference for the fast sum; 0: none */
    uint32_t quantum;    /* smallest change seen inside a block, counts; 0: none yet */
    uint32_t time;       /* samples in full blocks so far, modulo 2^32 */
    int32_t low;         /* lower rail */
    uint32_t between;    /* readings between low and the other rail */
    uint64_t square;     /* of the block: squares of the differences, the three axes together; then
                            their variance */
    uint32_t begin, end; /* of the rest: first block's first sample; after the newest block */
    uint64_t variance;   /* of the rest: sum over its blocks and those held back, 1/64 counts^2 */
    invcal_private_axis axis[3]; /* x, y, z */
} invcal_private_rests;

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

/* At most 20 degrees of a move. For an ideal gyroscope its rotation vector is v + kappa; for
 * another matrix M it is M v + cof(M) kappa. */
typedef struct {
    int16_t v[3];     /* integral of the nominal rate, 2^-15 rad */
    int16_t kappa[3]; /* coning, 2^-18 rad */
    uint16_t time;    /* twice the samples, plus 1 if a block of rests ends with it */
} invcal_private_segment;

/* A rest of gyro.h, and the move that led to it. */
typedef struct {
    int16_t bias[3]; /* minus that of the moves, 2^-18 rad/s */
    uint16_t when;   /* time at which it was taken, in blocks */
    int8_t move;     /* number of segments; or -status */
} invcal_private_still;

/* Rests and moves of gyro.h. */
typedef struct {
    /* lost in a reset; of the same size in every build */
    invcal_real rho[3];     /* rotation vector of the current segment */
    invcal_real v[3];       /* and its integral */
    invcal_real still[3];   /* integral since the rest began */
    uint32_t still_samples; /* and its samples */
    uint32_t samples;       /* samples of the move so far */
    uint16_t missing;       /* samples of the current segment */
    uint16_t cut, fixed;    /* first segment of the rest, first that is not merged */
    uint16_t used;          /* number of segments */
    uint8_t marks;          /* blocks among those not merged */
    uint8_t fault;          /* status of the move; if not begun, why */
    uint8_t spoilt;         /* status of the current segment */
    /* kept over a reset */
    uint32_t layout;                             /* identifies this build */
    int32_t low;                                 /* lower limit */
    uint32_t between;                            /* readings between the limits */
    uint16_t blocks;                             /* since the first READY, up to 2 h */
    uint16_t first;                              /* segments of complete moves; then the next */
    invcal_real rate;                            /* samples per second */
    invcal_real bias[3];                         /* subtracted from v, rad/s: of the first rest */
    invcal_private_still rest[INVCAL_MAX_MOVES]; /* with the moves that led to them */
    invcal_private_segment segment[INVCAL_MAX_SEGMENTS]; /* of all moves, in their order */
} invcal_private_moves;

#endif
