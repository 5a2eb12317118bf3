/* SPDX-License-Identifier: MIT */
#include "cli/command.h"
#include "export/text.h"
#include "cli/message.h"

/* A float must hold every number: this library's usual build and the plain arrays are float. */
static int check_range(const export_job *job)
{
    const invcal_calibration *c = &job->file.calibration;
    int fits = 1;

    for (unsigned i = 0; i < 3; i++) {
        fits = fits && export_fits_float(c->offset[i]);
        for (unsigned j = 0; j < 3; j++) {
            fits = fits && export_fits_float(c->matrix[i][j]);
        }
    }
    if (!fits) {
        message("%s: has numbers beyond the range of a float; calibrate in other units",
                job->source);
        return EXIT_DATA;
    }
    return EXIT_GOOD;
}

static const char *name_of(const export_job *job)
{
    return job->name ? job->name : "calibration";
}

/* {x, y, z}, each between `before` and `after`. */
static void write_row(FILE *file, const double x[3], int is_double, const char *before,
                      const char *after)
{
    char text[NUMBER_TEXT_MAX];

    for (unsigned i = 0; i < 3; i++) {
        fprintf(file, "%s%s%s%s", i == 0 ? "{" : ", ", before,
                export_literal(x[i], is_double, text), after);
    }
    putc('}', file);
}

static void begin(FILE *file, const export_job *job)
{
    fputs("/*\n", file);
    export_heading(file, EXPORT_COMMENT_C, job);
    fputs(" *\n", file);
}

/* invcal/invcal.h: calibrated = matrix (raw - offset), raw and offset in input units, matrix
 * in field units per input unit: the members of the file, as they are. INVCAL_REAL gives each
 * number the suffix of the build, so that all digits count in double, and none is a double in
 * float. A suffix needs a point or an exponent in front of it. The initialiser is positional for
 * C++, which has no designated one before 2020. */
static void write_c(FILE *file, const export_job *job)
{
    const invcal_calibration *c = &job->file.calibration;
    const char *name = name_of(job);

    begin(file, job);
    export_comment(file, EXPORT_COMMENT_C, "Use: invcal_apply(&%s, raw, calibrated);", name);
    export_comment(file, EXPORT_COMMENT_C, "raw in input units, calibrated in %s.",
                   export_field_unit(job));
    fprintf(file, " */\n#ifndef INVCAL_EXPORT_%s_H\n#define INVCAL_EXPORT_%s_H\n\n", name, name);
    fprintf(file, "#include \"invcal/invcal.h\"\n\n");
    fprintf(file, "static const invcal_calibration %s = {\n    ", name);
    write_row(file, c->offset, 1, "INVCAL_REAL(", ")");
    fputs(",\n    {", file);
    for (unsigned i = 0; i < 3; i++) {
        fputs(i == 0 ? "" : ",\n     ", file);
        write_row(file, c->matrix[i], 1, "INVCAL_REAL(", ")");
    }
    fputs("}};\n\n#endif\n", file);
}

/* The same without the library: two arrays of float, which any C compiler takes. */
static void write_arrays(FILE *file, const export_job *job)
{
    const invcal_calibration *c = &job->file.calibration;
    const char *name = name_of(job);

    begin(file, job);
    export_comment(file, EXPORT_COMMENT_C, "Use, for i = 0, 1, 2, the sum over j = 0, 1, 2:");
    export_comment(file, EXPORT_COMMENT_C,
                   "  calibrated[i] = SUM %s_matrix[i][j] (raw[j] - %s_offset[j])", name, name);
    export_comment(file, EXPORT_COMMENT_C, "raw in input units, calibrated in %s.",
                   export_field_unit(job));
    fprintf(file, " */\nstatic const float %s_offset[3] = ", name);
    write_row(file, c->offset, 0, "", "f");
    fprintf(file, ";\nstatic const float %s_matrix[3][3] = {\n", name);
    for (unsigned i = 0; i < 3; i++) {
        fputs("    ", file);
        write_row(file, c->matrix[i], 0, "", "f");
        fputs(i < 2 ? ",\n" : "};\n", file);
    }
}

const export_format export_c = {"c", EXPORT_NAMED, check_range, write_c};
const export_format export_c_arrays = {"c-arrays", EXPORT_NAMED, check_range, write_arrays};
