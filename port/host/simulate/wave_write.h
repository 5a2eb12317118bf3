/* SPDX-License-Identifier: MIT
 *
 * simulate/wave_write.h: the log of a device that is waved, and its truth.
 */
#ifndef WAVE_WRITE_H
#define WAVE_WRITE_H

#include <stdio.h>

#include "simulate/wave.h"

/* Prints all samples, with a header. Returns an exit code. */
int wave_write_log(wave *w);

void wave_write_truth(FILE *file, const wave *w);

#endif
