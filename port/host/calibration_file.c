/* SPDX-License-Identifier: MIT */
#include "calibration_file.h"

#include <string.h>

#include "command.h"
#include "input.h"
#include "json_read.h"
#include "message.h"

/* Goes on to element `index` of a list that must have `count`, or over its end. */
static int expect_element(json_reader *r, unsigned index, unsigned count)
{
    const int more = json_element(r, index);

    if (more < 0) {
        return EXIT_FILE;
    }
    return more == (index < count) ? EXIT_GOOD : json_error(r, "a list of 3 is expected");
}

static int read_vector(json_reader *r, double out[3])
{
    int failure = json_enter(r, '[');

    for (unsigned i = 0; i < 3 && !failure; i++) {
        failure = expect_element(r, i, 3);
        failure = failure ? failure : json_read_number(r, &out[i]);
    }
    return failure ? failure : expect_element(r, 3, 3);
}

static int read_matrix(json_reader *r, double out[3][3])
{
    int failure = json_enter(r, '[');

    for (unsigned i = 0; i < 3 && !failure; i++) {
        failure = expect_element(r, i, 3);
        failure = failure ? failure : read_vector(r, out[i]);
    }
    return failure ? failure : expect_element(r, 3, 3);
}

/* Reads the value of the member with this name, if it is of interest. */
static int read_member(json_reader *r, const char *name, invcal_calibration *c, int *has_offset,
                       int *has_matrix)
{
    const int is_offset = strcmp(name, "offset") == 0;
    const int is_matrix = strcmp(name, "matrix") == 0;

    if ((is_offset && *has_offset) || (is_matrix && *has_matrix)) {
        return json_error(r, "\"offset\" or \"matrix\" is there twice");
    }
    *has_offset = *has_offset || is_offset;
    *has_matrix = *has_matrix || is_matrix;
    return is_offset   ? read_vector(r, c->offset)
           : is_matrix ? read_matrix(r, c->matrix)
                       : json_skip(r);
}

static int read_object(json_reader *r, invcal_calibration *c)
{
    char name[16]; /* longer ones are of no interest */
    int has_offset = 0;
    int has_matrix = 0;
    int more = 0;
    int failure = json_enter(r, '{');

    for (unsigned i = 0; !failure && (more = json_member(r, i, name, sizeof name)) == 1; i++) {
        failure = read_member(r, name, c, &has_offset, &has_matrix);
    }
    if (more < 0 || failure) {
        return EXIT_FILE;
    }
    if (!has_offset || !has_matrix) {
        message("%s:%lu: no member \"%s\": this is no calibration", r->name, r->line,
                has_offset ? "matrix" : "offset");
        return EXIT_FILE;
    }
    return json_finish(r);
}

int calibration_file_read(const char *path, invcal_calibration *out)
{
    json_reader r;
    double inverse[3][3];
    FILE *file = input_open(path);

    if (!file) {
        return EXIT_FILE;
    }
    json_start(&r, file, input_name(path));
    int failure = read_object(&r, out);
    if (!failure && invcal_calibration_inverse(out, inverse) != INVCAL_OK) {
        message("%s: \"matrix\" is singular: this is no calibration", input_name(path));
        failure = EXIT_FILE;
    }
    input_close(file);
    return failure;
}
