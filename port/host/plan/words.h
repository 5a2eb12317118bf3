/* SPDX-License-Identifier: MIT
 *
 * plan/words.h: figures of a set of positions as text, with their units.
 */
#ifndef PLAN_WORDS_H
#define PLAN_WORDS_H

#include "plan/results.h"

#define PLAN_WORDS_MAX 128

/* The names of the axes whose bits are set, "+x -x". Returns text. */
const char *plan_axes_text(unsigned axes, char text[PLAN_WORDS_MAX]);

/* An angle to 0.001 degrees, without needless zeros. Returns text. */
const char *plan_angle_text(double degrees, char text[PLAN_WORDS_MAX]);

/* A length of time: "45 s", "2 min 55 s", "1 h 04 min". Returns text. */
const char *plan_time_text(double seconds, char text[PLAN_WORDS_MAX]);

/* The three kinds of parameters: offsets, scale errors, angles. */
#define PLAN_KINDS 3u
extern const char *const plan_kinds[PLAN_KINDS];

/* Its unit on a page: angles have "°" for degrees. */
display_unit plan_unit(unsigned kind, unit_style style);

/* The largest sigma of a kind, over the noise of a position mean; and of all kinds. */
double plan_sigma(const criteria *c, unsigned kind);
double plan_sigma_largest(const criteria *c);

/* `sigma` over the noise of a position mean, as text: "0.0183 mg", or, if `noise`, over the field,
 * is unknown (0), "0.408". Returns text. */
const char *plan_sigma_text(unsigned kind, double sigma, double noise, unit_style style,
                            char text[PLAN_WORDS_MAX]);

/* The unit of such a text in a heading: "", or, if the noise is unknown, ", × noise". */
const char *plan_noise_suffix(double noise);

/* Why no position of a set points some axis along gravity: a clause. */
const char *plan_missing_reason(const design *d);

#endif
