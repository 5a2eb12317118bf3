/* SPDX-License-Identifier: MIT
 *
 * read/noise_file.h: reads the output of `invcal allan --out`.
 */
#ifndef NOISE_FILE_H
#define NOISE_FILE_H

#include "invcal/allan.h"

/* Reads the noise of the three axes, relative to the field: white noise in 1/sqrt(Hz), bias
 * instability in 1, rate random walk in sqrt(Hz); and the range of averaging times. Other members
 * are ignored. "-" is the standard input.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if the file is unreadable, malformed, or without
 * the length of the field. */
int noise_file_read(const char *path, invcal_noise noise[3]);

#endif
