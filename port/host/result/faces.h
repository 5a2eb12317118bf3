/* SPDX-License-Identifier: MIT
 *
 * result/faces.h: --six-faces determines offsets and scales. The cost of not measuring the angles,
 * and the positions that would determine them.
 */
#ifndef FACES_H
#define FACES_H

#include "result/result.h"

#define FACES_MAX 512u

/* 1 if angles are held and the result is good otherwise. */
int faces_are_good(const calibrate_result *result);

/* What is not measured, and the error from that: sentences. Returns text. */
const char *faces_cost(const calibrate_result *result, char text[FACES_MAX]);

/* Half-width of the 95 % interval of the error of lengths from the held angles, over the field:
 * root mean square over all directions, and in the worst direction. */
typedef struct {
    double rms;
    double max;
} faces_error;
faces_error faces_error_of(const calibrate_result *result);

/* Writes the member "six_faces". */
void faces_json(json_writer *w, const calibrate_result *result);

/* Six positions that, added to six faces, determine the angles: in words. */
#define FACES_EDGES                                                                                \
    "+x up, tilted by 45 deg so that +y rises, or -y, or +z, or -z; +z up, tilted so that +y "     \
    "rises, or -y"

/* 1 if positions that were refused are sufficient for --six-faces. */
int faces_suffice(const positions *data, const fit_settings *settings);

#endif
