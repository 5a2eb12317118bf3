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

#define SIM_NOINIT __attribute__((section(".noinit")))

/* 1 if this memory has just been powered up and holds anything; 0 from then on. */
int sim_is_new(uint32_t *magic);

uint32_t sim_random(void);
float sim_noise(void); /* nearly normal, standard deviation 1 */

/* Resets the processor. Does not return. */
void sim_reset(void);

/* What the triad really is: counts = offset + gain (specific force in g). */
typedef struct {
    float offset[3];
    float gain[3][3];
} sim_triad;
extern const sim_triad sim_truth;

/* So many samples go by while the processor is busy. */
void sim_pass(unsigned samples);

/* A hundredth of a second: the specific force that the hand has the triad feel, g. */
void hand_step(float force[3]);

/* What becomes of the flash's next programming. */
typedef enum {
    PROGRAM_GOOD,
    PROGRAM_WEAK, /* reports a failure; reads right, but will have faded after a reset */
    PROGRAM_CUT   /* power fails in the middle */
} program_fate;
program_fate hand_program(void);

/* Power has failed: weak bits fade. */
void flash_fade(void);

/* Compares what is stored with the truth and ends the run. Does not return. */
void judge(void);

#endif
