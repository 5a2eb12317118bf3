/* SPDX-License-Identifier: MIT
 *
 * How to use the result: offset and matrix, the constant in C, the commands.
 */
#include <string.h>

#include "cli/input.h"
#include "cli/options.h"
#include "report/facts.h"
#include "text/constant.h"

#define CELL 64
#define COMMAND_MAX (3 * MESSAGE_MAX)

/* A file as an operand: quoted if a shell needs it, and never taken for an option. */
static const char *operand(const char *path, char text[MESSAGE_MAX])
{
    char plain[MESSAGE_MAX];

    snprintf(plain, sizeof plain, "%s%s", path[0] == '-' ? "./" : "", path);
    return options_quoted(plain, text, MESSAGE_MAX);
}

static const char *file_of(const report_facts *f, char text[MESSAGE_MAX])
{
    return f->invocation->saved ? operand(f->invocation->saved, text) : "CAL.json";
}

/* calibrated x = matrix xx (x - offset x) + matrix xy (y - offset y) + ... */
static void write_matrix(page *p, const report_facts *f, const invcal_calibration *c)
{
    static const char *const axes[] = {"x", "y", "z"};
    static const char *const titles[] = {"axis", "offset", "matrix: x", "y", "z"};
    char caption[4 * CELL];
    const page_table sheet = {caption, titles, 5, 0};

    snprintf(caption, sizeof caption,
             "Corrected reading = matrix · (reading - offset). Offset: %s; matrix: %s per unit of "
             "the offset; axes: %s.",
             calibrate_input_unit(f->result), calibrate_field_unit(f->result),
             calibrate_frame(f->result));
    page_table_begin(p, &sheet);
    for (unsigned i = 0; i < 3; i++) {
        char text[4][CELL];
        const char *const cells[] = {axes[i], text[0], text[1], text[2], text[3]};
        snprintf(text[0], CELL, "%.9g", c->offset[i]);
        for (unsigned j = 0; j < 3; j++) {
            snprintf(text[1 + j], CELL, "%.9g", c->matrix[i][j]);
        }
        page_cells(p, &sheet, cells);
    }
    page_table_end(p);
}

static void write_apply(page *p, const report_facts *f)
{
    const char *log = f->invocation->log;
    char command[COMMAND_MAX];
    char file[MESSAGE_MAX];
    char text[MESSAGE_MAX];

    if (!f->invocation->saved) {
        page_say(p, "Save it:");
        snprintf(command, sizeof command, "%s --out CAL.json", f->invocation->command);
        page_code(p, command);
    }
    page_say(p, "Correct the readings of a log:");
    snprintf(command, sizeof command, "invcal apply %s %s > calibrated.csv", file_of(f, file),
             input_is_stdin(log) ? "LOG" : operand(log, text));
    page_code(p, command);
}

static void write_constant(page *p, const report_facts *f, const invcal_calibration *c)
{
    char command[COMMAND_MAX];
    char file[MESSAGE_MAX];

    if (f->result->degree > 0) {
        page_say(p, "It cannot be exported as a constant: no format corrects quadratic and cubic "
                    "errors; use invcal apply.");
        return;
    }
    page_say(p,
             "As a constant for a firmware with this library, "
             "invcal_apply(&calibration, raw[0], raw[1], raw[2], calibrated)%s:",
             f->result->temperature == CALIBRATE_THERMAL ? ", valid at the reference temperature"
                                                         : "");
    if (constant_fits(c->offset, (const double(*)[3])c->matrix)) {
        page_code_begin(p);
        constant_write(p->file, "calibration", c->offset, (const double(*)[3])c->matrix);
        page_code_end(p);
        page_say(
            p, "The same as a file (for the formats of other systems, see invcal export --help):");
    }
    snprintf(command, sizeof command, "invcal export %s --format c --out calibration.h",
             file_of(f, file));
    page_code(p, command);
}

void report_use(page *p, const report_facts *f)
{
    const calibrate_result *r = f->result;
    const invcal_calibration c = fit_in_field_units(&r->solution.calibration, r->settings.field);

    page_section(p, "Use it");
    write_matrix(p, f, &c);
    write_apply(p, f);
    write_constant(p, f, &c);
}
