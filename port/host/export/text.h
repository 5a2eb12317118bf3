/* SPDX-License-Identifier: MIT
 *
 * export/text.h: numbers and comments in the languages of other systems.
 */
#ifndef EXPORT_TEXT_H
#define EXPORT_TEXT_H

#include "export/format.h"
#include "text/number.h"

/* Prefixes of comment lines. In C the caller opens and closes the comment. */
#define EXPORT_COMMENT_C " * "
#define EXPORT_COMMENT "# "

/* One line of a comment. File names and texts may contain any character: those that could end a
 * comment or a line, or are not printable ASCII, become '_'. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void export_comment(FILE *file, const char *prefix, const char *format, ...);

/* A comment: the source of the calibration, and how good it is. */
void export_heading(FILE *file, const char *prefix, const export_job *job);

/* The same for its gyroscope, if there is one; for formats that can store it. */
void export_gyro_heading(FILE *file, const char *prefix, const export_job *job);

/* The unit of the field and of calibrated readings: "m/s^2", "g", "mg"; of a magnetometer that of its
 * readings, or "units of the field" if it is another. */
const char *export_field_unit(const export_job *job);

/* The unit of readings: "counts", "m/s^2", "uT", ..., or "input units" if the file has none. */
const char *export_input_unit(const export_job *job);

/* The bias of the gyroscope, rad/s. Returns 1; 0 if the file has no gyroscope or its readings are
 * counts. */
int export_gyro_bias(const export_job *job, double bias[3]);

/* If there is a gyroscope: a warning that it is not exported, and why; and the same as a
 * comment. */
#define EXPORT_NO_UNIT "its readings are counts; log them in rad/s or degrees/s"
void export_gyro_warn(const export_job *job, const char *why);
void export_gyro_comment(FILE *file, const char *prefix, const export_job *job, const char *why);

/* If there is a g-sensitivity: a comment that this format cannot store it. */
void export_comment_no_g(FILE *file, const char *prefix, const export_job *job);

/* Checks numbers that a format is going to write as doubles or, with is_float, floats. Returns
 * EXIT_GOOD; EXIT_DATA, with a message, if one is out of range. */
int export_check_range(const export_job *job, const double *x, unsigned n, int is_float);

#endif
