/* SPDX-License-Identifier: MIT
 *
 * sim.h: what the parts of the simulated world know of each other. The firmware knows nothing of
 * it. On a board delete this folder, and write spi_transfer and the three functions of flash.h.
 *
 * The world keeps its state in .noinit: it goes on while the processor is reset.
 */
#ifndef SIM_H
#define SIM_H

#include <stdint.h>

#include "invcal/store.h"

#define SIM_NOINIT __attribute__((section(".noinit")))
#define SIM_RATE 200.0f /* steps per second: the gyroscope's rate, twice the accelerometer's */

/* 1 if this memory has just been powered up and holds anything; 0 from then on. */
int sim_is_new(uint32_t *magic);

uint32_t sim_random(void);
float sim_noise(void); /* nearly normal, standard deviation 1 */

/* Resets the processor. Does not return. */
void sim_reset(void);

/* What a triad really is: counts = offset + gain (specific force in g, or rate in rad/s). */
typedef struct {
    float offset[3];
    float gain[3][3];
} sim_triad;
extern const sim_triad sim_truth;
extern const sim_triad sim_gyro_truth;

/* So many steps go by while the processor is busy. */
void sim_pass(unsigned steps);

/* A step: the rate of the hand, rad/s, and the specific force at its end, g. */
void hand_step(float rate[3], float force[3]);

/* What becomes of the flash's next programming. */
typedef enum {
    PROGRAM_GOOD,
    PROGRAM_WEAK, /* reports a failure; reads right, but will have faded after a reset */
    PROGRAM_CUT   /* power fails in the middle */
} program_fate;
program_fate hand_program(void);

/* How many steps the flash takes to erase a sector. */
unsigned hand_erase(void);

/* Power has failed: weak bits fade. */
void flash_fade(void);

/* Compares what is stored with the truth and ends the run. Does not return. */
void judge(void);

/* One number beside its truth. Returns 1 if it is good. */
int judge_one(const char *name, float truth, float stored, float sigma);

/* ---- what differs from firmware to firmware: accelerometer.c, both.c ------------------------------ */

/* What happens at a place, or on the way to it. */
enum {
    LEAVES_TOO_SOON = 1,
    TURNS_BACK = 2, /* puts it down where it was taken up */
    KNOCKS = 4,
    PULLS = 8,    /* at the cable, all the time it is held */
    HURRIES = 16, /* beyond the gyroscope's range */
    RESET = 32,   /* while it is held */
    RESET_IN_MOVE = 64,
    WEAK_FLASH = 128,
    SLOW_FLASH = 256, /* longer than the queue of the chip */
    POWER_CUT = 512
};
enum { HAND_PLACES = 16 };
extern const uint16_t hand_script[HAND_PLACES];

/* Loads what is stored of the accelerometer; what else is stored, judge_rest judges. */
invcal_status judge_load(invcal_record *record);
int judge_rest(void);

#endif
