/* SPDX-License-Identifier: MIT
 *
 * The user: reads what the firmware prints, and turns the device as it says, to within some
 * degrees; makes typical mistakes; and is interrupted by power failures.
 */
#include <math.h>
#include <string.h>

#include "print.h"
#include "sim.h"
#include "uart.h"

/* In steps of 1/200 s. */
enum {
    TURN = 240,       /* from place to place */
    HURRY = 60,       /* the same, beyond the gyroscope's range */
    MOVE_RESET = 190, /* of a turn: when the last rest has been taken and stored */
    TOO_SHORT = 260,  /* hold that is too short */
    REACTION = 100,   /* time, to a message */
    KNOCK_AT = 80,
    KNOCK_END = 88,
    ERASE = 8,        /* of a sector of the flash; */
    SLOW_ERASE = 600, /* of a worn one */
    DONE = 400,       /* from the calibration until power is switched off and on, */
    VERIFY = 1000,    /* and until the result is verified */
    TIMEOUT = 60000
};

static struct {
    uint32_t magic;
    uint32_t time;             /* since power-on */
    uint32_t turning, turn;    /* time in the current turn, and its duration */
    uint32_t held, reset_at;   /* time at the current place; when to reset */
    float up[3];               /* the direction that points up, a unit vector */
    float vector[3];           /* rotation vector of the turn */
    float wobble[3];           /* during the turn, rad/s */
    float target[3];           /* direction to point up next */
    unsigned place;            /* number of places visited */
    unsigned erases;           /* of the flash at this place, */
    unsigned programs, cut_at; /* and programmings; the one at which power fails */
    unsigned leaving;          /* steps until the next turn; 0: it is held */
    unsigned done;             /* steps since the calibration; 0: not calibrated yet */
} hand SIM_NOINIT;

static void power_on(void)
{
    if (sim_is_new(&hand.magic)) {
        memset((char *)&hand + sizeof hand.magic, 0, sizeof hand - sizeof hand.magic);
        hand.up[2] = 1;
        hand.target[2] = 1;
    }
}

static int is_scripted(unsigned what)
{
    return hand.place < HAND_PLACES && hand_script[hand.place] & what;
}

static float dot(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const float a[3], const float b[3], float out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

static void to_unit(float v[3])
{
    const float length = sqrtf(dot(v, v));

    for (unsigned i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

/* ---- reading ---------------------------------------------------------------------------------- */

/* "+z up, tilt 45 deg, +x rises": only faces, edges and corners of the case are requested, so the
 * direction is the sum of the axes named. */
static void parse_direction(const char *words)
{
    float v[3] = {0, 0, 0};

    for (const char *at = words; (at = strpbrk(at, "+-")) != NULL; at += 2) {
        if (at[1] < 'x' || at[1] > 'z') {
            return;
        }
        v[at[1] - 'x'] = *at == '+' ? 1.0f : -1.0f;
    }
    to_unit(v);
    memcpy(hand.target, v, sizeof hand.target);
}

static void read_line(const char *line)
{
    if (strncmp(line, "next: ", 6) == 0) {
        parse_direction(line + 6);
    } else if (strncmp(line, "good", 4) == 0 || strncmp(line, "refused", 7) == 0) {
        /* during a turn, the place has been left already */
        hand.leaving = hand.turning == hand.turn ? REACTION : 0;
    } else if (strncmp(line, "calibration stored", 18) == 0) {
        hand.done = 1;
    }
}

/* The linker replaces uart_put by these (--wrap). */
void __real_uart_put(char c);
void __wrap_uart_put(char c);
void __wrap_uart_put(char c)
{
    static char line[80];
    static unsigned length;

    __real_uart_put(c);
    if (c == '\n') {
        line[length] = '\0';
        length = 0;
        power_on();
        read_line(line);
    } else if (length < sizeof line - 1) {
        line[length++] = c;
    }
}

/* ---- turning and holding: of libm only sqrtf, which gives the same bits on every machine --------- */

/* The arc cosine, to a degree: four times the arc sine of a quarter of the angle. */
static float angle_of(float cosine)
{
    const float half = sqrtf((1 + cosine) / 2);
    const float square = (1 - half) / 2;

    return 4 * sqrtf(square) * (1 + square / 6 + 0.075f * square * square);
}

/* The shortest turn to the target, with an error; or a full turn. */
static void plan_turn(void)
{
    float to[3];

    for (unsigned i = 0; i < 3; i++) {
        to[i] = hand.target[i] + 0.05f * sim_noise();
        hand.wobble[i] = is_scripted(TURNS_BACK) ? 0 : 0.3f * sim_noise();
    }
    to_unit(to);
    cross(to, hand.up, hand.vector);
    to_unit(hand.vector);
    const float angle = is_scripted(TURNS_BACK) ? 6.2831853f : angle_of(dot(to, hand.up));
    for (unsigned i = 0; i < 3; i++) {
        hand.vector[i] *= angle;
    }
}

static void start_turn(void)
{
    hand.place++;
    plan_turn();
    hand.turn = is_scripted(HURRIES) ? HURRY : TURN;
    hand.turning = hand.held = hand.erases = hand.programs = hand.leaving = 0;
    hand.reset_at = 60 + sim_random() % 200;
    hand.cut_at = 3 + sim_random() % 4;
    if (is_scripted(HURRIES)) {
        print("world: somebody hurries\n");
    }
}

/* The rate of this step. In the axes of the device, up rotates in the opposite sense, by at most
 * 0.05 rad per step, for which two terms of the sine are exact. */
static void turn(float rate[3])
{
    const float tau = ((float)hand.turning + 0.5f) / (float)hand.turn;
    const float window = 16 * tau * tau * (1 - tau) * (1 - tau);
    float axis[3], once[3], twice[3];

    for (unsigned i = 0; i < 3; i++) {
        rate[i] = window * (30.0f / 16 * hand.vector[i] * SIM_RATE / (float)hand.turn +
                            hand.wobble[i] * (tau - (float)i / 2));
        axis[i] = -rate[i] / SIM_RATE;
    }
    const float square = dot(axis, axis);
    cross(axis, hand.up, once);
    cross(axis, once, twice);
    for (unsigned i = 0; i < 3; i++) {
        hand.up[i] += (1 - square / 6) * once[i] + (0.5f - square / 24) * twice[i];
    }
    hand.turning++;
    if (is_scripted(RESET_IN_MOVE) && hand.turning == MOVE_RESET) {
        print("world: reset in a move\n");
        sim_reset();
    }
}

static void hold(float force[3])
{
    hand.held++;
    if (is_scripted(PULLS) && hand.held == 1) {
        print("world: somebody pulls at the cable\n");
    }
    for (unsigned i = 0; i < 3 && is_scripted(PULLS); i++) {
        force[i] *= 1.05f;
    }
    if (is_scripted(KNOCKS) && hand.held >= KNOCK_AT && hand.held < KNOCK_END) {
        force[0] += 6 * sim_noise(); /* beyond 4 g */
    }
    if (is_scripted(RESET) && hand.held == hand.reset_at) {
        print("world: reset\n");
        sim_reset();
    }
    if ((is_scripted(LEAVES_TOO_SOON) && hand.held == TOO_SHORT) ||
        (hand.leaving > 0 && --hand.leaving == 0)) {
        start_turn();
    }
}

/* Power is switched off and on; then what is stored must be found. */
static void wait_for_end(void)
{
    hand.done++;
    if (hand.done == DONE) {
        print("world: off and on again\n");
        sim_reset();
    }
    if (hand.done == VERIFY) {
        verify();
    }
}

void hand_step(float rate[3], float force[3])
{
    power_on();
    if (++hand.time == TIMEOUT) {
        print("world: out of patience\n");
        verify();
    }
    const int is_moving = hand.turning < hand.turn;
    memset(rate, 0, 3 * sizeof *rate);
    if (is_moving) {
        turn(rate);
    }
    for (unsigned i = 0; i < 3; i++) {
        force[i] = hand.up[i] + (is_moving ? 0.05f * sim_noise() : 0);
    }
    if (hand.done > 0) {
        wait_for_end();
    } else if (!is_moving) {
        hold(force);
    }
}

/* ---- the flash -------------------------------------------------------------------------------- */

unsigned hand_erase(void)
{
    power_on();
    if (is_scripted(SLOW_FLASH) && hand.erases++ == 0) {
        print("world: the flash takes 3 s\n");
        return SLOW_ERASE;
    }
    return ERASE;
}

program_fate hand_program(void)
{
    power_on();
    hand.programs++;
    if (is_scripted(WEAK_FLASH) && hand.programs == 4) {
        return PROGRAM_WEAK;
    }
    if (is_scripted(POWER_CUT) && hand.programs == hand.cut_at) {
        print("world: power fails while the flash is programmed\n");
        return PROGRAM_CUT;
    }
    return PROGRAM_GOOD;
}
