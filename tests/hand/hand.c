/* SPDX-License-Identifier: MIT */
#include "hand.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "invcal/plan.h"

enum { FINE = 200 }; /* parts of a step, to integrate */

static double up[3] = {0.1, -0.05, 0.9937};
static double vector[3], wobble[3]; /* of the turn; rad/s during it */
static unsigned thinking = HAND_THINK, turned = HAND_TURN, turn_steps = HAND_TURN;

/* The sum of twelve uniform numbers. */
double hand_noise(void)
{
    static uint32_t state = 1;
    double sum = -6;

    for (int i = 0; i < 12; i++) {
        state = state * UINT32_C(1664525) + UINT32_C(1013904223);
        sum += (state >> 8) / 16777216.0;
    }
    return sum;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void to_unit(double v[3])
{
    const double length = sqrt(dot(v, v));

    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
}

/* The direction of a cube's faces, edges and corners that has these words, if there is one. */
static int is_direction(const char *text, double direction[3])
{
    char words[INVCAL_TEXT_SIZE];

    for (int n = 0; n < 27; n++) {
        invcal_real v[3];
        if (n == 13) {
            continue; /* 0, 0, 0 */
        }
        direction[0] = n % 3 - 1;
        direction[1] = n / 3 % 3 - 1;
        direction[2] = n / 9 - 1;
        to_unit(direction);
        for (int i = 0; i < 3; i++) {
            v[i] = (invcal_real)direction[i];
        }
        if (strcmp(invcal_direction_text(v, words), text) == 0) {
            return 1;
        }
    }
    return 0;
}

void hand_turns(const double direction[3], unsigned steps)
{
    double to[3];

    for (int i = 0; i < 3; i++) {
        to[i] = direction[i] + 0.07 * hand_noise();
        wobble[i] = 0.3 * hand_noise();
    }
    cross(to, up, vector);
    const double sine = sqrt(dot(vector, vector));
    for (int i = 0; i < 3; i++) {
        vector[i] *= atan2(sine, dot(to, up)) / sine;
    }
    thinking = turned = 0;
    turn_steps = steps;
}

int hand_reads(const char *text, unsigned steps)
{
    double direction[3];
    const int is_read = is_direction(text, direction);

    if (is_read) {
        hand_turns(direction, steps);
    }
    return is_read;
}

/* In the axes of the device, up turns in the opposite sense. */
static void turn(double rate[3])
{
    const double tau = (turned + 0.5) / turn_steps;
    const double window = 16 * tau * tau * (1 - tau) * (1 - tau);

    for (int i = 0; i < 3; i++) {
        rate[i] = window *
                  (30.0 / 16 * vector[i] * HAND_RATE / turn_steps + wobble[i] * sin(15 * tau + i));
    }
    for (int n = 0; n < FINE; n++) {
        double change[3];
        cross(up, rate, change);
        for (int i = 0; i < 3; i++) {
            up[i] += change[i] / (FINE * HAND_RATE);
        }
    }
    to_unit(up);
}

/* A moment to understand the words; then a turn, with some shaking; then rest. */
int hand_moves(double rate[3], double force[3])
{
    const int is_moving = thinking == HAND_THINK && turned < turn_steps;

    memset(rate, 0, 3 * sizeof *rate);
    thinking += thinking < HAND_THINK;
    if (is_moving) {
        turn(rate);
        turned++;
    }
    for (int i = 0; i < 3; i++) {
        force[i] = up[i] + (is_moving ? 0.1 * hand_noise() : 0);
    }
    return is_moving;
}

const double *hand_up(void)
{
    return up;
}
