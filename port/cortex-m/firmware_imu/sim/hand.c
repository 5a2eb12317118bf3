/* SPDX-License-Identifier: MIT
 *
 * The person: reads the firmware's output, and turns the device as it says, within some degrees. Power fails
 * in the middle of a move, and while the flash is written; and once the person hurries.
 */
#include <math.h>
#include <string.h>

#include "print.h"
#include "uart.h"
#include "world.h"

/* In steps of 1/200 s. */
enum {
    TURN = 240,     /* from place to place; */
    HURRY = 60,     /* beyond the gyroscope's range */
    RESET_AT = 190, /* of a turn: the rest before has been taken and stored */
    REACTION = 100, /* to the output */
    DONE = 400,     /* calibrated, and switched off and on, */
    AGAIN = 1000,   /* and judged */
    PATIENCE = 60000
};

/* What happens on the way to a place. */
enum { RESET = 1, HURRIES = 2, POWER_CUT = 4 };
static const uint8_t script[] = {[4] = RESET, [6] = HURRIES, [9] = POWER_CUT, [11] = RESET};

static struct {
    uint32_t magic;
    uint32_t time;             /* since power-on, and */
    uint32_t turning, turn;    /* in the current turn, and its duration */
    float up[3];               /* the direction that points up, unit */
    float vector[3];           /* of the turn */
    float wobble[3];           /* on the way, rad/s */
    float wish[3];             /* direction to point up next */
    unsigned place;            /* how many have been visited */
    unsigned programs, cut_at; /* flash programmed since the last place; power fails there */
    unsigned leaving;          /* steps until it is taken up; 0: it is held */
    unsigned done;             /* steps since it has been calibrated; 0: not yet */
} hand SIM_NOINIT;

static void power_on(void)
{
    if (sim_is_new(&hand.magic)) {
        memset((char *)&hand + sizeof hand.magic, 0, sizeof hand - sizeof hand.magic);
        hand.up[2] = 1;
        hand.wish[2] = 1;
    }
}

static int happens(unsigned what)
{
    return hand.place < sizeof script && script[hand.place] & what;
}

static float length_of(const float v[3])
{
    return sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void cross(const float a[3], const float b[3], float out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* ---- reading ---------------------------------------------------------------------------------- */

/* "+z up": only faces are requested. */
static void read_line(const char *line)
{
    if (strncmp(line, "next: ", 6) == 0) {
        memset(hand.wish, 0, sizeof hand.wish);
        hand.wish[(unsigned)(line[7] - 'x') % 3] = line[6] == '-' ? -1.0f : 1.0f;
    } else if (strncmp(line, "good", 4) == 0 || strncmp(line, "refused", 7) == 0) {
        hand.leaving = hand.turning == hand.turn ? REACTION : 0;
    } else if (strncmp(line, "calibration stored", 18) == 0) {
        hand.done = 1;
    }
}

/* The linker puts these in place of uart_put. */
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

/* ---- turning and holding ---------------------------------------------------------------------- */

/* The shortest way to the wish, roughly. */
static void leave(void)
{
    float to[3];

    for (unsigned i = 0; i < 3; i++) {
        to[i] = hand.wish[i] + 0.05f * sim_noise();
        hand.wobble[i] = 0.3f * sim_noise();
    }
    cross(to, hand.up, hand.vector);
    const float sine = length_of(hand.vector);
    const float cosine = to[0] * hand.up[0] + to[1] * hand.up[1] + to[2] * hand.up[2];
    for (unsigned i = 0; i < 3; i++) {
        hand.vector[i] *= atan2f(sine, cosine) / sine;
    }
    hand.place++;
    hand.turning = 0;
    hand.turn = happens(HURRIES) ? HURRY : TURN;
    hand.programs = hand.leaving = 0;
    hand.cut_at = 3 + sim_random() % 80;
    if (happens(HURRIES)) {
        print("world: somebody hurries\n");
    }
}

/* The rate of this step; in the axes of the device, up turns the opposite way, exactly. */
static void turn(float rate[3])
{
    const float tau = ((float)hand.turning + 0.5f) / (float)hand.turn;
    const float window = 16 * tau * tau * (1 - tau) * (1 - tau);
    float axis[3], once[3], twice[3];

    for (unsigned i = 0; i < 3; i++) {
        rate[i] = window * (30.0f / 16 * hand.vector[i] * WORLD_RATE / (float)hand.turn +
                            hand.wobble[i] * sinf(15 * tau + (float)i));
        axis[i] = -rate[i] / WORLD_RATE;
    }
    const float angle = length_of(axis);
    cross(axis, hand.up, once);
    cross(axis, once, twice);
    for (unsigned i = 0; i < 3 && angle > 0; i++) {
        const float half = sinf(angle / 2) / angle;
        hand.up[i] += sinf(angle) / angle * once[i] + 2 * half * half * twice[i];
    }
    hand.turning++;
    if (happens(RESET) && hand.turning == RESET_AT) {
        print("world: reset in a move\n");
        sim_reset();
    }
}

/* Power is switched off and on once more; the stored result must be found. */
static void wait_for_end(void)
{
    hand.done++;
    if (hand.done == DONE) {
        print("world: off and on again\n");
        sim_reset();
    }
    if (hand.done == AGAIN) {
        judge();
    }
}

void hand_turn(float rate[3], float force[3])
{
    power_on();
    if (++hand.time == PATIENCE) {
        print("world: out of patience\n");
        judge();
    }
    memset(rate, 0, 3 * sizeof *rate);
    const int is_moving = hand.turning < hand.turn;
    if (is_moving) {
        turn(rate);
    } else if (hand.leaving > 0 && --hand.leaving == 0 && hand.done == 0) {
        leave();
    }
    for (unsigned i = 0; i < 3; i++) {
        force[i] = hand.up[i] + (is_moving ? 0.05f * sim_noise() : 0);
    }
    if (hand.done > 0) {
        wait_for_end();
    }
}

program_fate hand_program(void)
{
    power_on();
    hand.programs++;
    if (happens(POWER_CUT) && hand.programs == hand.cut_at) {
        print("world: power fails while the flash is programmed\n");
        return PROGRAM_CUT;
    }
    return PROGRAM_GOOD;
}
