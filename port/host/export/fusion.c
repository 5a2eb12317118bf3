/* SPDX-License-Identifier: MIT */
#include "cli/command.h"
#include "export/factors.h"
#include "export/text.h"
#include "text/constant.h"
#include "cli/message.h"
#include "text/unit.h"

#define IN_DEGREES (1 / UNIT_DEGREE)

/* Flat braces, as in Fusion's own examples: they fit all versions of its unions. */
static void write_values(FILE *file, const char *type, const char *name, const char *part,
                         const double *x, unsigned n)
{
    char text[NUMBER_TEXT_MAX];

    fprintf(file, "static const %s %s%s = {", type, name, part);
    for (unsigned i = 0; i < n; i++) {
        fprintf(file, "%s%sf",
                i == 0       ? ""
                : i % 3 == 0 ? ",\n    "
                             : ", ",
                constant_literal(x[i], 0, text));
    }
    fputs("};\n", file);
}

static int check(const export_job *job)
{
    const invcal_calibration *c = &job->file.calibration;
    int fits = 1;

    for (unsigned i = 0; i < 3; i++) {
        fits = fits && constant_fits_float(c->offset[i]) && constant_fits_float(c->matrix[i][i]) &&
               constant_fits_float(c->matrix[i][i] / job->file.gravity);
    }
    if (!fits) {
        message("%s: its numbers exceed the range of a float; calibrate in other units",
                job->source);
        return EXIT_DATA;
    }
    if (job->file.has_gyro) {
        const int failure = export_factors_check(job, &job->file.gyro, IN_DEGREES);
        if (failure) {
            return failure;
        }
    }
    return job->si > 0 ? export_factors_check(job, c, job->si)
                       : export_check_range(job, c->matrix[0], 9, 1);
}

/* x-io Fusion, Fusion/FusionModel.h (in earlier versions FusionCalibration.h,
 * FusionCalibrationInertial()):
 *
 *     FusionModelInertial(uncalibrated, M, s, b) = M ((uncalibrated - b) o s)   (o: axis by axis)
 *
 * The result must be in g, as the filter subtracts 1 for gravity (FusionAhrs.c): so the matrix is
 * divided by the length of the field, which makes a calibrated reading at rest 1. Then b = offset
 * in input units, and matrix / field = M diag(s) column by column, M with ones on its diagonal. */
static void write_inertial(FILE *file, const export_job *job, const char *name)
{
    const export_factors f = export_factors_of(&job->file.calibration, 1 / job->file.gravity);

    export_comment(file, EXPORT_COMMENT_C,
                   "FusionModelInertial(raw, %sMisalignment, %sSensitivity, %sOffset)", name, name,
                   name);
    export_comment(file, EXPORT_COMMENT_C, "raw in %s, result in g: 1 at rest here.",
                   export_input_unit(job));
    fputs(" */\n", file);
    write_values(file, "FusionMatrix", name, "Misalignment", f.misalignment[0], 9);
    write_values(file, "FusionVector", name, "Sensitivity", f.scale, 3);
    write_values(file, "FusionVector", name, "Offset", job->file.calibration.offset, 3);
}

/* The same for the gyroscope; the filter expects degrees/s. */
static void write_gyro(FILE *file, const export_job *job)
{
    const export_factors f = export_factors_of(&job->file.gyro, IN_DEGREES);

    fputs("/* FusionModelInertial(raw, gyroscopeMisalignment, gyroscopeSensitivity, "
          "gyroscopeOffset)\n"
          " * raw in input units, result in degrees/s.\n",
          file);
    export_gyro_heading(file, EXPORT_COMMENT_C, job);
    export_comment_no_g(file, EXPORT_COMMENT_C, job);
    fputs(" */\n", file);
    write_values(file, "FusionMatrix", "gyroscope", "Misalignment", f.misalignment[0], 9);
    write_values(file, "FusionVector", "gyroscope", "Sensitivity", f.scale, 3);
    write_values(file, "FusionVector", "gyroscope", "Offset", job->file.gyro.offset, 3);
}

/* FusionModelMagnetic(uncalibrated, softIronMatrix, hardIronOffset) = matrix (uncalibrated -
 * offset), as here. Only the direction of the result matters: it is in the unit of the field. */
static void write_magnetic(FILE *file, const export_job *job, const char *name)
{
    const invcal_calibration *c = &job->file.calibration;

    export_comment(file, EXPORT_COMMENT_C,
                   "FusionModelMagnetic(raw, %sSoftIronMatrix, %sHardIronOffset)", name, name);
    export_comment(file, EXPORT_COMMENT_C, "raw in %s; only the direction of the result matters.",
                   export_input_unit(job));
    fputs(" */\n", file);
    write_values(file, "FusionMatrix", name, "SoftIronMatrix", c->matrix[0], 9);
    write_values(file, "FusionVector", name, "HardIronOffset", c->offset, 3);
}

static void write_file(FILE *file, const export_job *job)
{
    fputs("/*\n", file);
    export_heading(file, EXPORT_COMMENT_C, job);
    fputs(" *\n", file);
    if (job->si > 0) {
        write_inertial(file, job, job->name ? job->name : "accelerometer");
    } else {
        write_magnetic(file, job, job->name ? job->name : "magnetometer");
    }
    if (job->file.has_gyro) {
        write_gyro(file, job);
    }
}

const export_format export_fusion = {"fusion", EXPORT_NAMED | EXPORT_GRAVITY, check, write_file};
