/* SPDX-License-Identifier: MIT
 *
 * invcal/private.h: state of which only the size concerns a program. Nothing here is part of the
 * interface: any release may change it. The module of each structure describes its members.
 */
#ifndef INVCAL_PRIVATE_H
#define INVCAL_PRIVATE_H

#include "invcal/config.h"

/* An axis of the rest detector: src/session/rests.h. */
typedef struct {
    int32_t first;
    uint32_t sum;
    int32_t origin, place;
    struct {
        uint64_t total;
        int32_t pending[2], once, lag;
    } rest;
} invcal_private_axis;

/* The rest detector. */
typedef struct {
    uint8_t stage, flags, hold, drift, pended, skip, reason, taken, seen, run, least, bits;
    uint16_t dwell, blocks, pace;
    int16_t noise, wander, reach, other;
    uint16_t missing;
    uint32_t span, quantum, time;
    int32_t low;
    uint32_t between;
    uint64_t square;
    uint32_t begin, end;
    uint64_t variance;
    invcal_private_axis axis[3];
} invcal_private_rests;

/* An averaging time: src/allan/noise.h. */
typedef struct {
    uint64_t past[2 * INVCAL_PRIVATE_OVERLAP], low, high;
    uint32_t m, count;
} invcal_private_tau;

/* Rows of a magnetometer, by direction: src/magnetometer/cells.h. */
typedef struct {
    invcal_real sum[18][9];
    uint16_t count[18];
} invcal_private_cells;

/* A magnetometer in motion. */
typedef struct {
    invcal_real unit, p[9], squares, products, before, block[3];
    uint32_t blocked, samples, due, dropped;
    uint16_t in_block;
    uint8_t stage, has_step;
    invcal_private_cells early, late;
} invcal_private_magnetometer;

#define INVCAL_PRIVATE_DIP 10u /* numbers in a row of invcal_dip */

/* A segment of a move: src/imu/imu.h. */
typedef struct {
    int16_t v[3], kappa[3];
    uint16_t time;
} invcal_private_segment;

/* A rest, and the move that led to it. */
typedef struct {
    int16_t bias[3];
    uint16_t when;
    int8_t move;
} invcal_private_still;

/* Rests and moves. */
typedef struct {
    invcal_real rho[3], v[3], still[3];
    uint32_t still_samples, samples;
    uint16_t missing, cut, fixed, used;
    uint8_t marks, fault, spoilt;
    uint32_t layout;
    int32_t low;
    uint32_t between;
    uint16_t blocks, first;
    invcal_real rate, bias[3];
    invcal_private_still rest[INVCAL_MAX_MOVES];
    invcal_private_segment segment[INVCAL_MAX_SEGMENTS];
} invcal_private_moves;

#endif
