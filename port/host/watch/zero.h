/* SPDX-License-Identifier: MIT
 *
 * watch/zero.h: zero and scale of the readings of a live stream, for the guidance: as stated, else
 * estimated from the first samples, and later from the positions.
 */
#ifndef WATCH_ZERO_H
#define WATCH_ZERO_H

#include "read/samples.h"
#include "watch/live_program.h"
#include "watch/live_options.h"

typedef struct {
    const live_options *options;
    const samples *log;
    const positions *taken;
    const live_program *followed; /* if the options have a set */
    double lsb;                   /* estimate for a zero of 0 */
} zero_finder;

/* The nominal calibration, over the field, for counts of the log, whose first samples have been
 * read. Keeps the pointers. Returns 1 if it is usable. */
int zero_begin(zero_finder *z, const live_options *options, const samples *log,
               const positions *taken, const live_program *followed, invcal_calibration *out);

/* Returns 1 if the first samples can be from the stated sensor; else 0, why in text, and what to do
 * in remedy. */
int zero_fits_sensor(const live_options *options, const samples *log, char text[SENSORS_TEXT_MAX],
                     char remedy[SENSORS_TEXT_MAX]);

/* 1 if neither zero nor scale of the readings is stated. */
int zero_is_unstated(const zero_finder *z);

/* 1 if, moreover, too few positions have been taken to determine them. */
int zero_is_guess(const zero_finder *z);

/* A position was taken: updates the nominal calibration of the session, whose positions are in
 * counts, so it may change at any time.
 *
 * is_determined  the previous positions determine a calibration: only the scale of sigma depends on
 *                the nominal, which is then that of calibrate. */
void zero_update(const zero_finder *z, int is_determined, invcal_session *session);

#endif
