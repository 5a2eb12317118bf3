/* SPDX-License-Identifier: MIT
 *
 * hand.h: the person who holds a device and turns it as its words say, for the simulated boards of the tests. A
 * step is a hundredth of a second.
 */
#ifndef HAND_H
#define HAND_H

enum { HAND_RATE = 100 }; /* steps per second */
enum { HAND_THINK = HAND_RATE / 2, HAND_TURN = 6 * HAND_RATE / 5, HAND_HURRY = HAND_RATE / 4 };

/* Nearly normal, standard deviation 1. */
double hand_noise(void);

/* After HAND_THINK steps turns the device so that this unit vector points up, roughly: by the shortest way, in
 * `steps` steps. */
void hand_turns(const double direction[3], unsigned steps);

/* The same for a direction in words of the library. Returns 1; 0 for any other text. */
int hand_reads(const char *text, unsigned steps);

/* The next step: the angular rate of the device, rad/s about its axes; and the specific force at the end of the step, in
 * g. Returns 1 in a turn, 0 at rest. */
int hand_moves(double rate[3], double force[3]);

/* The present up direction, a unit vector. */
const double *hand_up(void);

#endif
