/* SPDX-License-Identifier: MIT
 *
 * sim.h: interfaces of the simulated world, which the firmware does not know. On a board, delete
 * this folder, and write spi_transfer and the three functions of flash.h.
 *
 * The state of the world is in .noinit, so it survives a reset of the processor.
 */
#ifndef SIM_H
#define SIM_H

#include <stdint.h>

#include "invcal/store.h"

#define SIM_NOINIT __attribute__((section(".noinit")))
#define SIM_RATE 200.0f /* steps per second: the gyroscope's rate, twice the accelerometer's */

/* 1 after power-on, when the memory is undefined; 0 from then on. */
int sim_is_new(uint32_t *magic);

uint32_t sim_random(void);
float sim_noise(void); /* nearly normal, standard deviation 1 */

/* Resets the processor. Does not return. */
void sim_reset(void);

/* True parameters of a triad: counts = offset + gain (specific force in g, or rate in rad/s). */
typedef struct {
    float offset[3];
    float gain[3][3];
} sim_triad;
extern const sim_triad sim_truth;
extern const sim_triad sim_gyro_truth;

/* Advances the world while the processor is busy. */
void sim_pass(unsigned steps);

/* One step: the rate, rad/s, and the specific force at its end, g. */
void hand_step(float rate[3], float force[3]);

/* The result of the flash's next programming. */
typedef enum {
    PROGRAM_GOOD,
    PROGRAM_WEAK, /* reports a failure; reads correctly until a reset */
    PROGRAM_CUT   /* power fails in the middle */
} program_fate;
program_fate hand_program(void);

/* The number of steps that erasing a sector takes. */
unsigned hand_erase(void);

/* A reset: weak bits are lost. */
void flash_fade(void);

/* Compares what is stored with the truth and ends the run. Does not return. */
void verify(void);

/* Prints one number and its true value. Returns 1 if it is good. */
int verify_parameter(const char *name, float truth, float stored, float sigma);

/* ---- what differs from firmware to firmware: accelerometer.c, both.c ------------------------------ */

/* What happens at a place, or in the turn to it. */
enum {
    LEAVES_TOO_SOON = 1,
    TURNS_BACK = 2, /* a full turn, back to the same place */
    KNOCKS = 4,
    PULLS = 8,    /* at the cable, as long as it is held */
    HURRIES = 16, /* beyond the gyroscope's range */
    RESET = 32,   /* while it is held */
    RESET_IN_MOVE = 64,
    WEAK_FLASH = 128,
    SLOW_FLASH = 256, /* longer than the queue of the chip */
    POWER_CUT = 512
};
enum { HAND_PLACES = 16 };
extern const uint16_t hand_script[HAND_PLACES];

/* Loads the record of the accelerometer; verify_others checks what else is stored. */
invcal_status load_record(invcal_record *record);
int verify_others(void);

#endif
