/* SPDX-License-Identifier: MIT
 *
 * result/gyro.h: the result of the gyroscope as sentences, table and JSON.
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

/* A move that is left out, and why. For a rest in which the device turned, the text of its first
 * move is about all of its moves. "" for other moves. */
const char *gyro_left_out(const calibrate_result *r, unsigned move, char text[GYRO_LINE_MAX]);

/* What is wrong with the gyroscope: "not calibrated: ...", "weak: ..."; "" if it is good or
 * absent. */
const char *gyro_fault(const gyro_fit *g, char text[GYRO_TEXT_MAX]);

/* Standard deviation of the bias about an axis over the rests, rad/s; from the median, as the
 * device may have turned in some of them. */
double gyro_bias_spread(const gyro_fit *g, unsigned axis);

/* The table; nothing if there is no gyroscope. */
void gyro_print(FILE *file, const calibrate_result *r);

/* After the verdict of the accelerometer: a line about a gyroscope that is not good. */
void gyro_print_last(FILE *file, const calibrate_result *r);
void gyro_json(json_writer *w, const calibrate_result *r);

#endif
