/* SPDX-License-Identifier: MIT */
#include "calibration_file.h"

#include <stdio.h>
#include <string.h>

#include "command.h"
#include "input.h"
#include "json_read.h"
#include "message.h"
#include "number.h"

typedef int (*number_reader)(json_reader *r, double *out);
typedef int (*member_reader)(json_reader *r, const char *name, void *into);

/* What one file is read into. */
typedef struct {
    calibration_file *file;
    int is_all; /* 0: offset and matrix only */
    int has_offset;
    int has_matrix;
} reading;

/* Goes on to element `index` of a list that must have `count`, or over its end. */
static int expect_element(json_reader *r, unsigned index, unsigned count)
{
    const int more = json_element(r, index);

    if (more < 0) {
        return EXIT_FILE;
    }
    return more == (index < count) ? EXIT_GOOD : json_error(r, "a list of 3 is expected");
}

static int read_three(json_reader *r, number_reader read, double out[3])
{
    int failure = json_enter(r, '[');

    for (unsigned i = 0; i < 3 && !failure; i++) {
        failure = expect_element(r, i, 3);
        failure = failure ? failure : read(r, &out[i]);
    }
    return failure ? failure : expect_element(r, 3, 3);
}

static int read_vector(json_reader *r, double out[3])
{
    return read_three(r, json_read_number, out);
}

/* A figure that was not known was written as null. */
static int read_figure(json_reader *r, double *out)
{
    *out = NUMBER_UNKNOWN;
    return json_peek(r) == 'n' ? json_skip(r) : json_read_number(r, out);
}

static int read_sigma(json_reader *r, double out[3])
{
    return read_three(r, read_figure, out);
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

/* A list of texts, with commas between; what is too long for `out` is cut. */
static int read_names(json_reader *r, char *out, size_t size)
{
    char name[CALIBRATION_FILE_WORD];
    int more = 0;
    int failure = json_enter(r, '[');

    for (unsigned i = 0; !failure && (more = json_element(r, i)) == 1; i++) {
        const size_t length = strlen(out);
        failure = json_read_text(r, name, sizeof name);
        if (!failure) {
            snprintf(out + length, size - length, "%s%s", i > 0 ? ", " : "", name);
        }
    }
    return more < 0 ? EXIT_FILE : failure;
}

static int read_object(json_reader *r, member_reader read, void *into)
{
    char name[16]; /* longer ones are of no interest */
    int more = 0;
    int failure = json_enter(r, '{');

    for (unsigned i = 0; !failure && (more = json_member(r, i, name, sizeof name)) == 1; i++) {
        failure = read(r, name, into);
    }
    return more < 0 ? EXIT_FILE : failure;
}

static int is(const char *name, const char *other)
{
    return strcmp(name, other) == 0;
}

static int read_nominal_member(json_reader *r, const char *name, void *into)
{
    calibration_file *c = into;

    c->is_skewed = c->is_skewed || is(name, "matrix");
    return is(name, "zero")        ? read_vector(r, c->zero)
           : is(name, "lsb")       ? read_vector(r, c->lsb)
           : is(name, "zero_from") ? json_read_text(r, c->zero_from, sizeof c->zero_from)
           : is(name, "lsb_from")  ? json_read_text(r, c->lsb_from, sizeof c->lsb_from)
                                   : json_skip(r);
}

static int read_sigma_member(json_reader *r, const char *name, void *into)
{
    calibration_file *c = into;

    return is(name, "offset")  ? read_sigma(r, c->sigma_offset)
           : is(name, "dk")    ? read_sigma(r, c->sigma_dk)
           : is(name, "gamma") ? read_sigma(r, c->sigma_gamma)
                               : json_skip(r);
}

/* What does not belong to the correction itself. */
static int read_circumstance(json_reader *r, const char *name, calibration_file *c)
{
    if (is(name, "positions") && json_peek(r) == '[') {
        return json_skip(r); /* the truth of a simulation lists them */
    }
    return is(name, "gravity")        ? json_read_number(r, &c->gravity)
           : is(name, "positions")    ? json_read_number(r, &c->positions)
           : is(name, "suspected")    ? json_read_number(r, &c->suspected)
           : is(name, "frame")        ? json_read_text(r, c->frame, sizeof c->frame)
           : is(name, "unit")         ? json_read_text(r, c->unit, sizeof c->unit)
           : is(name, "verdict")      ? json_read_text(r, c->verdict, sizeof c->verdict)
           : is(name, "undetermined") ? read_names(r, c->undetermined, sizeof c->undetermined)
           : is(name, "nominal")      ? read_object(r, read_nominal_member, c)
           : is(name, "sigma")        ? read_object(r, read_sigma_member, c)
                                      : json_skip(r);
}

static int read_member(json_reader *r, const char *name, void *into)
{
    reading *x = into;
    const int is_offset = is(name, "offset");
    const int is_matrix = is(name, "matrix");

    if ((is_offset && x->has_offset) || (is_matrix && x->has_matrix)) {
        return json_error(r, "\"offset\" or \"matrix\" is there twice");
    }
    x->has_offset = x->has_offset || is_offset;
    x->has_matrix = x->has_matrix || is_matrix;
    return is_offset   ? read_vector(r, x->file->calibration.offset)
           : is_matrix ? read_matrix(r, x->file->calibration.matrix)
           : x->is_all ? read_circumstance(r, name, x->file)
                       : json_skip(r);
}

static int read_calibration(json_reader *r, reading *x)
{
    const int failure = read_object(r, read_member, x);

    if (failure) {
        return failure;
    }
    if (!x->has_offset || !x->has_matrix) {
        message("%s:%lu: no member \"%s\": this is no calibration", r->name, r->line,
                x->has_offset ? "matrix" : "offset");
        return EXIT_FILE;
    }
    return json_finish(r);
}

static void forget(calibration_file *c)
{
    *c = (calibration_file){
        .gravity = NUMBER_UNKNOWN, .positions = NUMBER_UNKNOWN, .suspected = NUMBER_UNKNOWN};
    for (unsigned i = 0; i < 3; i++) {
        c->zero[i] = c->lsb[i] = NUMBER_UNKNOWN;
        c->sigma_offset[i] = c->sigma_dk[i] = c->sigma_gamma[i] = NUMBER_UNKNOWN;
    }
}

static int read_path(const char *path, calibration_file *out, int is_all)
{
    json_reader r;
    reading x = {.file = out, .is_all = is_all};
    double inverse[3][3];
    FILE *file = input_open(path);

    forget(out);
    if (!file) {
        return EXIT_FILE;
    }
    json_start(&r, file, input_name(path));
    int failure = read_calibration(&r, &x);
    if (!failure && invcal_calibration_inverse(&out->calibration, inverse) != INVCAL_OK) {
        message("%s: \"matrix\" is singular: this is no calibration", input_name(path));
        failure = EXIT_FILE;
    }
    input_close(file);
    return failure;
}

int calibration_file_read(const char *path, invcal_calibration *out)
{
    calibration_file file;
    const int failure = read_path(path, &file, 0);

    if (!failure) {
        *out = file.calibration;
    }
    return failure;
}

int calibration_file_read_all(const char *path, calibration_file *out)
{
    return read_path(path, out, 1);
}
