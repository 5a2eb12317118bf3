/* SPDX-License-Identifier: MIT */
#include "cli/command.h"
#include "export/text.h"
#include "text/constant.h"
#include "cli/message.h"

#define IDENTIFIER_MAX 80

/* Every number must fit into a float, the type of the plain arrays and of this library's default
 * build. */
static int check_range(const export_job *job)
{
    const invcal_calibration *c = &job->file.calibration;
    const invcal_calibration *g = &job->file.gyro;

    if (!constant_fits(c->offset, (const double(*)[3])c->matrix) ||
        (job->file.has_gyro && !constant_fits(g->offset, (const double(*)[3])g->matrix)) ||
        (job->file.has_gyro_g && !constant_fits(g->offset, (const double(*)[3])job->file.gyro_g))) {
        message("%s: its numbers exceed the range of a float; calibrate in other units",
                job->source);
        return EXIT_DATA;
    }
    return EXIT_GOOD;
}

static const char *name_of(const export_job *job)
{
    return job->name ? job->name : "calibration";
}

static void begin(FILE *file, const export_job *job)
{
    fputs("/*\n", file);
    export_heading(file, EXPORT_COMMENT_C, job);
    export_gyro_heading(file, EXPORT_COMMENT_C, job);
    fputs(" *\n", file);
}

static void write_use_of_g(FILE *file, const export_job *job)
{
    if (job->file.has_gyro_g) {
        export_comment(file, EXPORT_COMMENT_C, "Then subtract the gyroscope's g-sensitivity:");
        export_comment(file, EXPORT_COMMENT_C,
                       "  rate[i] -= the sum over j = 0, 1, 2 of %s_gyro_g[i][j] calibrated[j]",
                       name_of(job));
    }
}

/* invcal/invcal.h: calibrated = matrix (raw - offset), raw and offset in input units, matrix
 * in field units per input unit: the members of the file, as they are. */
static void write_c(FILE *file, const export_job *job)
{
    const invcal_calibration *c = &job->file.calibration;
    const char *name = name_of(job);

    begin(file, job);
    export_comment(file, EXPORT_COMMENT_C,
                   "Use: invcal_apply(&%s, raw[0], raw[1], raw[2], calibrated);", name);
    export_comment(file, EXPORT_COMMENT_C, "raw in %s, calibrated in %s.", export_input_unit(job),
                   export_field_unit(job));
    if (job->file.has_gyro) {
        export_comment(file, EXPORT_COMMENT_C,
                       "     invcal_apply(&%s_gyro, raw[0], raw[1], raw[2], rate); in rad/s", name);
    }
    write_use_of_g(file, job);
    fprintf(file, " */\n#ifndef INVCAL_EXPORT_%s_H\n#define INVCAL_EXPORT_%s_H\n\n", name, name);
    fprintf(file, "#include \"invcal/invcal.h\"\n\n");
    constant_write(file, name, c->offset, (const double(*)[3])c->matrix);
    if (job->file.has_gyro) {
        char gyro[IDENTIFIER_MAX];
        snprintf(gyro, sizeof gyro, "%s_gyro", name);
        constant_write(file, gyro, job->file.gyro.offset,
                       (const double(*)[3])job->file.gyro.matrix);
    }
    if (job->file.has_gyro_g) {
        char g[IDENTIFIER_MAX];
        snprintf(g, sizeof g, "%s_gyro_g", name);
        constant_write_matrix(file, g, (const double(*)[3])job->file.gyro_g);
    }
    fputs("\n#endif\n", file);
}

static void write_matrix(FILE *file, const char *name, const char *which, const double (*m)[3])
{
    fprintf(file, "static const float %s%s[3][3] = {\n", name, which);
    for (unsigned i = 0; i < 3; i++) {
        fputs("    ", file);
        constant_row(file, m[i], 0, "", "f");
        fputs(i < 2 ? ",\n" : "};\n", file);
    }
}

static void write_offset(FILE *file, const char *name, const char *which, const double offset[3])
{
    fprintf(file, "static const float %s%s[3] = ", name, which);
    constant_row(file, offset, 0, "", "f");
    fputs(";\n", file);
}

/* The same without the library: two arrays of float, for any C compiler. */
static void write_arrays(FILE *file, const export_job *job)
{
    const invcal_calibration *c = &job->file.calibration;
    const char *name = name_of(job);

    begin(file, job);
    export_comment(file, EXPORT_COMMENT_C, "Use, for i = 0, 1, 2, the sum over j = 0, 1, 2:");
    export_comment(file, EXPORT_COMMENT_C,
                   "  calibrated[i] = SUM %s_matrix[i][j] (raw[j] - %s_offset[j])", name, name);
    export_comment(file, EXPORT_COMMENT_C, "raw in %s, calibrated in %s.", export_input_unit(job),
                   export_field_unit(job));
    if (job->file.has_gyro) {
        export_comment(file, EXPORT_COMMENT_C,
                       "The same with %s_gyro_offset and %s_gyro_matrix, in rad/s.", name, name);
    }
    write_use_of_g(file, job);
    fputs(" */\n", file);
    write_offset(file, name, "_offset", c->offset);
    write_matrix(file, name, "_matrix", (const double(*)[3])c->matrix);
    if (job->file.has_gyro) {
        write_offset(file, name, "_gyro_offset", job->file.gyro.offset);
        write_matrix(file, name, "_gyro_matrix", (const double(*)[3])job->file.gyro.matrix);
    }
    if (job->file.has_gyro_g) {
        write_matrix(file, name, "_gyro_g", (const double(*)[3])job->file.gyro_g);
    }
}

const export_format export_c = {"c", EXPORT_NAMED, check_range, write_c};
const export_format export_c_arrays = {"c-arrays", EXPORT_NAMED, check_range, write_arrays};
