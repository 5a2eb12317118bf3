/* SPDX-License-Identifier: MIT
 *
 * world.h: the interface between chip and hand of this world, besides ../../firmware/sim/sim.h.
 */
#ifndef WORLD_H
#define WORLD_H

#include "sim.h"

#define WORLD_RATE                                                                                 \
    200.0f /* steps per second: one of the gyroscope, half a one of the accelerometer */

/* The true gyroscope: counts = offset + gain (rate in rad/s). */
extern const sim_triad gyro_truth;

/* A step: the rate of the hand, rad/s, and the specific force at its end, g. */
void hand_turn(float rate[3], float force[3]);

#endif
