/* SPDX-License-Identifier: MIT
 *
 * Internal: which turns to make, and how accurately turns, made or planned, determine all 18
 * parameters.
 */
#ifndef INVCAL_TURNS_H
#define INVCAL_TURNS_H

#include "imu.h"

enum {
    INVCAL_TOUR = 12,     /* quarter turns of invcali_tour */
    INVCAL_TOUR_FULL = 16 /* all of its turns, full ones included */
};

/* The information in rests and turns, made or planned: 720 bytes (float). */
typedef struct {
    invcal_real up[3];   /* unit vector that points up now */
    invcal_real seconds; /* of a quarter turn or less, others in proportion; 1.5, or set it */
    invcal_real noise;   /* of a position mean, over field */
    invcal_real linear;  /* internal: variance of a turn over that of a mean, per second */
    invcal_real square;  /* internal: the same, per second squared */
    uint8_t n;           /* unknowns: 18; or 9, if the accelerometer is held */
    /* normal equations in the order of a solution, lower triangle by rows, times the square of
     * noise */
    invcal_real sum[INVCAL_IMU_PARAMETERS * (INVCAL_IMU_PARAMETERS + 1) / 2];
} invcali_turns;

/* Begins a plan with one rest.
 *
 * up        unit vector that points up in it.
 * settings  as for invcal_imu_solve, or null.
 * noise     of a position mean, over field; 0: unknown.
 *
 * Returns INVCAL_OK; INVCAL_BAD_DIRECTION, INVCAL_BAD_NOISE, INVCAL_BAD_PRIOR. */
invcal_status invcali_turns_begin(invcali_turns *turns, const invcal_real up[3],
                                  const invcal_imu_settings *settings, invcal_real noise);

/* Begins a plan with the rests and moves measured so far: arguments as for invcali_imu_solve_of.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW without a rest; and as that for its arguments.
 * Cost: a pass of invcal_imu_solve. Stack: about 2,500 bytes. */
invcal_status invcali_turns_after(invcali_turns *turns, const invcal_imu *imu,
                                  const invcal_positions *positions,
                                  const invcal_imu_settings *settings);

/* Finds the shortest turn after which another direction points up. Both are unit vectors.
 *
 * Returns INVCAL_OK; INVCAL_BAD_DIRECTION, also within 0.06 degrees of equal or of opposite
 * directions: no turn is the shortest. */
invcal_status invcali_turn_to(const invcal_real from[3], const invcal_real up[3], invcal_turn *out);

/* The face up before turn i of that program, and after the one before: x up 0, down 1, y 2, 3, z 4,
 * 5. i is at most INVCAL_TOUR_FULL. */
unsigned invcali_tour_face(unsigned i);

/* Turn i of a program that begins with z up. From 0 to INVCAL_TOUR - 1: quarter turns between the
 * six faces, each of the twelve edges once,
 *
 *     +z +x +y +z -x +y -z +x -y -z -x -y +z
 *
 * which determine all 18. Then up to INVCAL_TOUR_FULL - 1 a full turn about x and about y, a
 * quarter turn, and a full turn about z, which halve sigma of the scales. The axis is always
 * horizontal.
 *
 * Returns INVCAL_OK; INVCAL_BAD_ANGLE if there is no turn i. */
invcal_status invcali_tour(unsigned i, invcal_turn *out);

/* Finds the turn that adds most: of the shortest turns to 26 directions (faces, edges and corners
 * of a cube), the one with the largest determinant of the normal equations. Twelve of these are
 * better than the tour, but six faces are easier to find by hand than corners.
 *
 * Cost: 175,000 instructions for 18 unknowns. Stack: about 1,300 bytes. */
void invcali_turns_next(const invcali_turns *turns, invcal_turn *out);

/* Adds a turn and the rest after it. turn->up is ignored.
 *
 * Returns INVCAL_OK; INVCAL_BAD_DIRECTION for the axis; INVCAL_BAD_ANGLE for more than two turns.
 * Cost: 4,300 instructions. Stack: about 450 bytes. */
invcal_status invcali_turns_add(invcali_turns *turns, const invcal_turn *turn);

/* Computes the expected sigma.
 *
 * turn   one more turn, or null: shows its improvement.
 * sigma  out: over the noise of a position mean, in the order of the parameters; 0 for what is held. If
 *        a parameter is undetermined, at most 10, as if each were known to ten times that noise.
 * open   out: bit r: parameter r is undetermined; or, with INVCAL_OK, weak: above 2.5 times the
 *        noise of a turn, as in a result.
 *
 * Returns INVCAL_OK; INVCAL_UNDETERMINED; and as invcali_turns_add for the turn: nothing is written
 * then.
 * Cost: 26,000 instructions. Stack: about 1,200 bytes. */
invcal_status invcali_turns_sigma(const invcali_turns *turns, const invcal_turn *turn,
                                  invcal_real sigma[INVCAL_IMU_PARAMETERS], uint32_t *open);

#endif
