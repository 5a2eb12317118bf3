/* SPDX-License-Identifier: MIT
 *
 * The person: reads what the firmware prints, and turns the device as it says, within some degrees;
 * and does a few things that people do. Power fails now and then, too.
 */
#include <math.h>
#include <string.h>

#include "print.h"
#include "sim.h"
#include "uart.h"

/* In samples, hundredths of a second. */
enum {
    TURN = 150,      /* from place to place */
    TOO_SHORT = 130, /* held by one who is in a hurry */
    REACTION = 50,   /* to what is read */
    KNOCK_AT = 40,
    KNOCK_END = 44,
    DONE = 200,  /* calibrated, and switched off and on, */
    AGAIN = 500, /* and judged */
    PATIENCE = 20000
};

/* What happens at a place, or with the flash on the way to it. */
enum {
    LEAVES_TOO_SOON = 1,
    TURNS_BACK = 2, /* puts it down where it was taken up */
    KNOCKS = 4,
    RESET = 8,
    WEAK_FLASH = 16,
    POWER_CUT = 32,
    PULLS = 64 /* at the cable, all the time it is held */
};
static const uint8_t script[] = {
    [2] = LEAVES_TOO_SOON, [5] = WEAK_FLASH | RESET, [7] = TURNS_BACK, [8] = PULLS,
    [9] = KNOCKS,          [11] = POWER_CUT,
};

static struct {
    uint32_t magic;
    uint32_t time;             /* since power-on, and */
    uint32_t turning, held;    /* in the present turn, at the present place; samples */
    uint32_t reset_at;         /* of held */
    float from[3], to[3];      /* directions that point up, unit */
    float wish[3];             /* the one asked for */
    unsigned place;            /* how many have been visited */
    unsigned programs, cut_at; /* flash programmed since the last place; power fails there */
    unsigned leaving;          /* samples until it is taken up; 0: it is held */
    unsigned done;             /* samples since it has been calibrated; 0: not yet */
} hand SIM_NOINIT;

static void power_on(void)
{
    static const float up[3] = {0, 0, 1};

    if (sim_is_new(&hand.magic)) {
        memset((char *)&hand + sizeof hand.magic, 0, sizeof hand - sizeof hand.magic);
        memcpy(hand.to, up, sizeof up);
        memcpy(hand.wish, up, sizeof up);
        hand.turning = TURN;
    }
}

static int happens(unsigned what)
{
    return hand.place < sizeof script && script[hand.place] & what;
}

static void to_unit(float v[3])
{
    const float length = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

    for (unsigned i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

/* ---- reading ---------------------------------------------------------------------------------- */

/* "+z up, tilt 45 deg, +x rises": faces, edges and corners of the case are all that is asked for, so
 * the sum of the axes named is the direction. */
static void understand(const char *words)
{
    float v[3] = {0, 0, 0};

    for (const char *at = words; (at = strpbrk(at, "+-")) != NULL; at += 2) {
        if (at[1] < 'x' || at[1] > 'z') {
            return;
        }
        v[at[1] - 'x'] = *at == '+' ? 1.0f : -1.0f;
    }
    to_unit(v);
    memcpy(hand.wish, v, sizeof hand.wish);
}

static void read_line(const char *line)
{
    if (strncmp(line, "next: ", 6) == 0) {
        understand(line + 6);
    } else if (strncmp(line, "good", 4) == 0 || strncmp(line, "refused", 7) == 0) {
        hand.leaving = hand.held > 0 ? REACTION : 0; /* on the way it has been left already */
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

static void leave(void)
{
    memcpy(hand.from, hand.to, sizeof hand.to);
    hand.place++;
    for (unsigned i = 0; i < 3 && !happens(TURNS_BACK); i++) {
        hand.to[i] = hand.wish[i] + 0.08f * sim_noise();
    }
    to_unit(hand.to);
    hand.turning = hand.held = hand.programs = hand.leaving = 0;
    hand.reset_at = 30 + sim_random() % 100;
    hand.cut_at = 3 + sim_random() % 4;
}

/* In an arc, so that opposite directions are reached too, and shaking. */
static void turn(float force[3])
{
    static const float aside[3] = {0.5f, -0.3f, 0.4f};
    const float part = (float)++hand.turning / TURN;

    for (unsigned i = 0; i < 3; i++) {
        force[i] = (1 - part) * hand.from[i] + part * hand.to[i] + 4 * part * (1 - part) * aside[i];
    }
    to_unit(force);
    for (unsigned i = 0; i < 3; i++) {
        force[i] += 0.1f * sim_noise();
    }
}

static void hold(float force[3])
{
    memcpy(force, hand.to, sizeof hand.to);
    hand.held++;
    if (happens(PULLS) && hand.held == 1) {
        print("world: somebody pulls at the cable\n");
    }
    for (unsigned i = 0; i < 3 && happens(PULLS); i++) {
        force[i] *= 1.05f;
    }
    if (happens(KNOCKS) && hand.held >= KNOCK_AT && hand.held < KNOCK_END) {
        force[0] += 6 * sim_noise(); /* beyond 4 g */
    }
    if (happens(RESET) && hand.held == hand.reset_at) {
        print("world: reset\n");
        sim_reset();
    }
    if ((happens(LEAVES_TOO_SOON) && hand.held == TOO_SHORT) ||
        (hand.leaving > 0 && --hand.leaving == 0)) {
        leave();
    }
}

/* Power is switched off and on once more; what is stored then must be found. */
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

void hand_step(float force[3])
{
    power_on();
    if (++hand.time == PATIENCE) {
        print("world: out of patience\n");
        judge();
    }
    if (hand.turning < TURN) {
        turn(force);
    } else if (hand.done > 0) {
        memcpy(force, hand.to, sizeof hand.to);
    } else {
        hold(force);
    }
    if (hand.done > 0) {
        wait_for_end();
    }
}

program_fate hand_program(void)
{
    power_on();
    hand.programs++;
    if (happens(WEAK_FLASH) && hand.programs == 4) {
        return PROGRAM_WEAK;
    }
    if (happens(POWER_CUT) && hand.programs == hand.cut_at) {
        print("world: power fails while the flash is programmed\n");
        return PROGRAM_CUT;
    }
    return PROGRAM_GOOD;
}
