/* SPDX-License-Identifier: MIT
 *
 * export/text.h: numbers and comments in the languages of other systems.
 */
#ifndef EXPORT_TEXT_H
#define EXPORT_TEXT_H

#include "export/format.h"
#include "text/number.h"

/* In front of each line of a comment. In C the caller opens and closes it. */
#define EXPORT_COMMENT_C " * "
#define EXPORT_COMMENT "# "

/* One line of a comment. File names and texts of a file may hold anything: whatever could end a
 * comment or a line, or is no printable ASCII, becomes '_'. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void export_comment(FILE *file, const char *prefix, const char *format, ...);

/* Where the calibration comes from, and how good it is. */
void export_heading(FILE *file, const char *prefix, const export_job *job);

/* How good its gyroscope is, if there is one; for formats that hold it. */
void export_gyro_heading(FILE *file, const char *prefix, const export_job *job);

/* The unit of the field, and so of what the full calibration gives: "m/s^2", "g", "mg", or "units
 * of the field" where it is no gravity. */
const char *export_field_unit(const export_job *job);

/* The bias of the gyroscope in rad/s of the driver, if the file holds one and its readings have a unit. Returns
 * whether it is so. */
int export_gyro_bias(const export_job *job, double bias[3]);

/* Says that the gyroscope, if there is one, is not exported, and why: a warning, and the same as a comment. */
#define EXPORT_NO_UNIT "its readings are counts; log them in rad/s or degrees/s"
void export_gyro_tell(const export_job *job, const char *why);
void export_gyro_comment(FILE *file, const char *prefix, const export_job *job, const char *why);

/* Says that this format has no place for the gyroscope's g-sensitivity, if there is one. */
void export_comment_no_g(FILE *file, const char *prefix, const export_job *job);

/* Numbers that a format is going to write: what products of a calibration's own come to, in a double or,
 * with is_float, in a float. EXIT_GOOD; EXIT_DATA, with a message, if one is beyond the range of it. */
int export_check_range(const export_job *job, const double *x, unsigned n, int is_float);

#endif
