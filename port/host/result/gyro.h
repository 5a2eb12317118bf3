/* SPDX-License-Identifier: MIT
 *
 * result/gyro.h: the result of the gyroscope, in words, as a table and as JSON.
 */
#ifndef RESULT_GYRO_H
#define RESULT_GYRO_H

#include "result/result.h"

/* Sentences and clauses. Each returns text. */
#define GYRO_LINE_MAX 300
const char *gyro_unit_text(const gyro_fit *g, char text[GYRO_LINE_MAX]);
const char *gyro_limit_text(const gyro_fit *g, char text[GYRO_LINE_MAX]);
const char *gyro_g_text(const gyro_fit *g, char text[GYRO_LINE_MAX]);
const char *gyro_drift_text(const gyro_fit *g, char text[GYRO_LINE_MAX]);
const char *gyro_thermal_text(const gyro_fit *g, char text[GYRO_LINE_MAX]);
const char *gyro_verdict(const gyro_fit *g);

/* A move that does not count, and why; of a rest in which the device turned, all of its moves at once, by the first.
 * "": there is nothing to tell. */
const char *gyro_left_out(const calibrate_result *r, unsigned move, char text[GYRO_LINE_MAX]);

/* What is wrong with a gyroscope that is not good: "not calibrated: ...", "weak: ..."; "" if nothing is. */
const char *gyro_fault(const gyro_fit *g, char text[GYRO_TEXT_MAX]);

/* Standard deviation of the bias about an axis over the rests, rad/s; by the median, as the device may have
 * turned in some. */
double gyro_wander(const gyro_fit *g, unsigned axis);

/* Nothing if there is none. */
void gyro_print(FILE *file, const calibrate_result *r);

/* After the verdict of the accelerometer: the gyroscope, if it is not good, too. */
void gyro_print_last(FILE *file, const calibrate_result *r);
void gyro_json(json_writer *w, const calibrate_result *r);

#endif
