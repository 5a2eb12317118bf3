/* SPDX-License-Identifier: MIT
 *
 * watch/zero.h: zero and scale of the readings of a live stream, for the guidance: as stated, else guessed from
 * the first samples and found again from the positions.
 */
#ifndef WATCH_ZERO_H
#define WATCH_ZERO_H

#include "read/samples.h"
#include "watch/live_program.h"
#include "watch/wish.h"

typedef struct {
    const live_wish *wish;
    const samples *log;
    const positions *taken;
    const live_program *followed; /* if the wish has a set */
    double lsb;                   /* as guessed for zero at 0 */
} zero_finder;

/* The nominal calibration, over the field, for counts of the log, of which the first samples have been read.
 * Keeps what is handed over. Returns 1 if it is usable. */
int zero_begin(zero_finder *z, const live_wish *wish, const samples *log, const positions *taken,
               const live_program *followed, invcal_calibration *out);

/* Could the first samples be those of the sensor that was stated? Returns 0 if not, and why in text. */
int zero_fits_sensor(const live_wish *wish, const samples *log, char text[SENSORS_TEXT_MAX]);

/* Nothing states the zero of the readings, nor the scale. */
int zero_is_free(const zero_finder *z);

/* And too few positions have been taken to determine them. */
int zero_is_guess(const zero_finder *z);

/* A position was taken: the table of the session is in counts, it takes another nominal at any time.
 *
 * is_determined  the positions before it determine a calibration: the guidance needs no nominal, but sigma are relative
 *                to its scale. It is then that of calibrate. */
void zero_renew(const zero_finder *z, int is_determined, invcal_session *session);

#endif
