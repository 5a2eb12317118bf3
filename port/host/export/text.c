/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "export/text.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "text/unit.h"

#define LINE_MAX_BYTES 512
#define SOURCE_SHOWN 60
#define SAME_UNIT_RATIO 2.0 /* as in result/result.c */

/* Without '*' a comment cannot end, without '\' and '?' (trigraphs) a line cannot continue. */
static int is_safe(char c)
{
    return c >= ' ' && c <= '~' && !strchr("*\\?", c);
}

void export_comment(FILE *file, const char *prefix, const char *format, ...)
{
    char text[LINE_MAX_BYTES];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    for (char *c = text; *c != '\0'; c++) {
        *c = is_safe(*c) ? *c : '_';
    }
    fprintf(file, "%s%s\n", prefix, text);
}

/* The end of a long path. */
static const char *tail(const char *path)
{
    const size_t length = strlen(path);

    return length > SOURCE_SHOWN ? path + length - SOURCE_SHOWN : path;
}

static int is_known(const double x[3])
{
    return fabs(x[0]) <= DBL_MAX && fabs(x[1]) <= DBL_MAX && fabs(x[2]) <= DBL_MAX;
}

static void comment_sigma(FILE *file, const char *prefix, const export_job *job)
{
    const calibration_file *c = &job->file;

    if (!is_known(c->sigma_offset) || !is_known(c->sigma_dk) || !is_known(c->sigma_gamma)) {
        export_comment(file, prefix, "standard deviations: unknown");
        return;
    }
    export_comment(file, prefix, "standard deviations, x y z:");
    export_comment(file, prefix, "  offset        %.2g %.2g %.2g %s", c->sigma_offset[0],
                   c->sigma_offset[1], c->sigma_offset[2], export_input_unit(job));
    export_comment(file, prefix, "  scale errors  %.2g %.2g %.2g", c->sigma_dk[0], c->sigma_dk[1],
                   c->sigma_dk[2]);
    export_comment(file, prefix, "  angles        %.2g %.2g %.2g rad (xy, xz, zy)",
                   c->sigma_gamma[0], c->sigma_gamma[1], c->sigma_gamma[2]);
}

void export_heading(FILE *file, const char *prefix, const export_job *job)
{
    const calibration_file *c = &job->file;

    export_comment(file, prefix, "Made by invcal " INVCAL_VERSION " from %s", tail(job->source));
    export_comment(file, prefix, "verdict: %s", *c->verdict ? c->verdict : "unknown");
    if (c->suspected > 0) {
        export_comment(file, prefix, "%.0f positions contradict one another", c->suspected);
    }
    if (*c->undetermined) {
        export_comment(file, prefix, "poorly determined: %s", c->undetermined);
    }
    if (c->positions <= DBL_MAX) {
        export_comment(file, prefix, "positions: %.0f", c->positions);
    }
    if (c->gravity <= DBL_MAX) {
        export_comment(file, prefix, "%s: %.9g %s", job->si > 0 ? "gravity" : "field", c->gravity,
                       export_field_unit(job));
    }
    if (*c->frame) {
        export_comment(file, prefix, "frame: %s", c->frame);
    }
    comment_sigma(file, prefix, job);
}

void export_gyro_heading(FILE *file, const char *prefix, const export_job *job)
{
    const calibration_file *c = &job->file;

    if (!c->has_gyro) {
        return;
    }
    export_comment(file, prefix, "gyroscope: %s", *c->gyro_verdict ? c->gyro_verdict : "unknown");
    if (!is_known(c->gyro_sigma[0]) || !is_known(c->gyro_sigma[1]) || !is_known(c->gyro_sigma[2])) {
        export_comment(file, prefix, "standard deviations: unknown");
        return;
    }
    export_comment(file, prefix, "standard deviations of its matrix over its scale, by rows:");
    for (unsigned i = 0; i < 3; i++) {
        const double *row = c->gyro_sigma[i];
        export_comment(file, prefix, "  %.2g %.2g %.2g", row[0], row[1], row[2]);
    }
}

/* The file holds the length of the field without its unit: that of the readings if they measure it,
 * or if the scale is about 1. */
static int is_field_in_input_units(const calibration_file *c)
{
    const reading_unit unit = unit_of_name(c->unit);
    const double scale = c->calibration.matrix[0][0];

    return c->is_magnetometer && (unit >= UNIT_MICROTESLA || c->is_field_measured) &&
           scale > 1 / SAME_UNIT_RATIO && scale < SAME_UNIT_RATIO;
}

const char *export_field_unit(const export_job *job)
{
    return job->si > 5                           ? "g" /* 9.80665 m/s^2 */
           : job->si > 0.5                       ? "m/s^2"
           : job->si > 0                         ? "mg"
           : is_field_in_input_units(&job->file) ? export_input_unit(job)
                                                 : "units of the field";
}

const char *export_input_unit(const export_job *job)
{
    const reading_unit unit = unit_of_name(job->file.unit);

    return unit == UNIT_UNKNOWN ? "input units" : unit_name(unit);
}

int export_check_range(const export_job *job, const double *x, unsigned n, int is_float)
{
    for (unsigned i = 0; i < n; i++) {
        if (!(fabs(x[i]) <= (is_float ? (double)FLT_MAX : DBL_MAX))) {
            message("%s: a number of --format %s would exceed the range of a %s; calibrate in "
                    "other units",
                    job->source, job->format, is_float ? "float" : "double");
            return EXIT_DATA;
        }
    }
    return EXIT_GOOD;
}

int export_gyro_bias(const export_job *job, double bias[3])
{
    const calibration_file *c = &job->file;

    for (unsigned i = 0; i < 3; i++) {
        bias[i] = c->gyro.offset[i] * c->gyro_lsb;
    }
    return c->has_gyro && c->gyro_lsb > 0 && !c->gyro_is_counts;
}

void export_gyro_warn(const export_job *job, const char *why)
{
    if (job->file.has_gyro) {
        message("warning: %s: the gyroscope is left out: %s", job->source, why);
    }
}

void export_gyro_comment(FILE *file, const char *prefix, const export_job *job, const char *why)
{
    if (job->file.has_gyro) {
        export_comment(file, prefix, "The gyroscope is left out: %s.", why);
    }
}

void export_comment_no_g(FILE *file, const char *prefix, const export_job *job)
{
    if (job->file.has_gyro_g) {
        export_comment(file, prefix,
                       "This format cannot store the gyroscope's g-sensitivity; --format c can.");
    }
}
