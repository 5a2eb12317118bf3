/* SPDX-License-Identifier: MIT
 *
 * result/faces.h: six faces determine offsets and scales. The cost of the undetermined angles, and which
 * positions would determine them.
 */
#ifndef FACES_H
#define FACES_H

#include "result/result.h"

#define FACES_MAX 512u

/* 1 if angles are held and nothing else is to be said against the result. */
int faces_are_good(const calibrate_result *result);

/* What is not measured, and what that costs: sentences. Returns text. */
const char *faces_cost(const calibrate_result *result, char text[FACES_MAX]);

/* Half of the interval that holds 95 % of what the held angles do to lengths, over the field: the root mean
 * square over all directions, and in the worst. */
typedef struct {
    double rms;
    double most;
} faces_error;
faces_error faces_error_of(const calibrate_result *result);

/* Their member of the object that is open. */
void faces_json(json_writer *w, const calibrate_result *result);

/* Six positions that determine the angles, after six faces, in words. */
#define FACES_EDGES                                                                                \
    "+x up, tilted by 45 deg so that +y rises, or -y, or +z, or -z; +z up, tilted so that +y "     \
    "rises, or -y"

/* 1 if these positions, which were refused, would do as six faces. */
int faces_would_do(const positions *data, const fit_settings *settings);

#endif
