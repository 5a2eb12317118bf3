/* SPDX-License-Identifier: MIT */
#include "result/calibration_file.h"

#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "fit/fit.h"
#include "cli/input.h"
#include "read/json_read.h"
#include "maths/matrix.h"
#include "cli/message.h"
#include "text/number.h"
#include "core/solve.h"

typedef int (*number_reader)(json_reader *r, double *out);
typedef int (*member_reader)(json_reader *r, const char *name, void *into);

/* The members that are read. */
typedef enum { OFFSET_AND_MATRIX, CORRECTION, EVERYTHING } reading_depth;

/* State of reading a file. */
typedef struct {
    calibration_file *file;
    reading_depth depth;
    int has_offset;
    int has_matrix;
} reading;

/* Moves to element `index` of a list that must have `count`, or past its end. */
static int expect_element(json_reader *r, unsigned index, unsigned count)
{
    const int more = json_element(r, index);

    if (more < 0) {
        return EXIT_FILE;
    }
    return more == (index < count) ? EXIT_GOOD : json_error(r, "a list of 3 expected");
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

/* A number; null is NUMBER_UNKNOWN. */
static int read_figure(json_reader *r, double *out)
{
    *out = NUMBER_UNKNOWN;
    return json_peek(r) == 'n' ? json_skip(r) : json_read_number(r, out);
}

static int read_sigma(json_reader *r, double out[3])
{
    return read_three(r, read_figure, out);
}

static int read_nine(json_reader *r, number_reader read, double out[3][3])
{
    int failure = json_enter(r, '[');

    for (unsigned i = 0; i < 3 && !failure; i++) {
        failure = expect_element(r, i, 3);
        failure = failure ? failure : read_three(r, read, out[i]);
    }
    return failure ? failure : expect_element(r, 3, 3);
}

static int read_matrix(json_reader *r, double out[3][3])
{
    return read_nine(r, json_read_number, out);
}

/* A list of texts, joined with commas, cut to the size of `out`. */
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
    char name[24]; /* no known name is longer */
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

    c->has_cross_terms = c->has_cross_terms || is(name, "matrix");
    return is(name, "zero")        ? read_sigma(r, c->zero)
           : is(name, "lsb")       ? read_sigma(r, c->lsb)
           : is(name, "zero_from") ? json_read_text(r, c->zero_from, sizeof c->zero_from)
           : is(name, "lsb_from")  ? json_read_text(r, c->lsb_from, sizeof c->lsb_from)
           : is(name, "sensor")    ? json_read_text(r, c->sensor, sizeof c->sensor)
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

/* ---- temperature ------------------------------------------------------------------------------ */

/* State of reading a thermal calibration. */
typedef struct {
    calibration_file *file;
    double degree;
    unsigned rows;
    unsigned seen;
    char frame[CALIBRATION_FILE_WORD];
} thermal_reading;

static int read_row_member(json_reader *r, const char *name, void *into)
{
    double *row = into;

    return is(name, "delta")   ? read_vector(r, &row[INVCAL_DELTA_X])
           : is(name, "dk")    ? read_vector(r, &row[INVCAL_DK_X])
           : is(name, "gamma") ? read_vector(r, &row[INVCAL_GAMMA_XY])
                               : json_skip(r);
}

/* A number that is missing in a row remains NUMBER_UNKNOWN, which is_usable detects. */
static int read_coefficients(json_reader *r, thermal_reading *t)
{
    int more = 0;
    int failure = json_enter(r, '[');

    for (t->rows = 0; !failure && (more = json_element(r, t->rows)) == 1; t->rows++) {
        if (t->rows == sizeof t->file->thermal.x / sizeof t->file->thermal.x[0]) {
            return json_error(r, "the degree of \"coefficients\" is 2 at most");
        }
        double *row = t->file->thermal.x[t->rows];
        for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
            row[i] = NUMBER_UNKNOWN;
        }
        failure = read_object(r, read_row_member, row);
    }
    return more < 0 ? EXIT_FILE : failure;
}

static int read_thermal_member(json_reader *r, const char *name, void *into)
{
    static const char *const names[] = {
        "degree", "reference",      "span",           "least",        "greatest",
        "field",  "nominal_offset", "nominal_matrix", "coefficients", "frame"};
    thermal_reading *t = into;
    invcal_thermal *c = &t->file->thermal;
    double *const number[] = {&t->degree, &c->reference, &c->span,
                              &c->min,    &c->max,       &t->file->thermal_field};
    unsigned k = 0;

    while (k < 10 && !is(name, names[k])) {
        k++;
    }
    t->seen |= k < 10 ? 1u << k : 0;
    return k < 6    ? json_read_number(r, number[k])
           : k == 6 ? read_vector(r, c->nominal.offset)
           : k == 7 ? read_matrix(r, c->nominal.matrix)
           : k == 8 ? read_coefficients(r, t)
           : k == 9 ? json_read_text(r, t->frame, sizeof t->frame)
                    : json_skip(r);
}

int calibration_file_at(const calibration_file *file, double temperature, invcal_calibration *out)
{
    invcal_calibration c;
    invcal_thermal_place place;

    if (invcal_thermal_at(&file->thermal, temperature, &c, &place) != INVCAL_OK) {
        return 0;
    }
    if (file->is_triangular) {
        invcali_make_triangular(&c, &file->thermal.nominal);
    }
    *out = fit_in_field_units(&c, file->thermal_field);
    return 1;
}

/* Complete, and valid at both ends of its range. */
static int is_usable(const thermal_reading *t)
{
    const invcal_thermal *c = &t->file->thermal;
    invcal_calibration out;

    return t->seen == (1u << 10) - 1 && c->span > 0 && c->min <= c->max && t->rows >= 1 &&
           !(t->degree < t->rows - 1.0) && !(t->degree > t->rows - 1.0) &&
           t->file->thermal_field > 0 && calibration_file_at(t->file, c->min, &out) &&
           calibration_file_at(t->file, c->max, &out);
}

static int read_thermal(json_reader *r, calibration_file *file)
{
    thermal_reading t = {.file = file};
    const int failure = read_object(r, read_thermal_member, &t);

    if (failure) {
        return failure;
    }
    file->has_thermal = 1;
    file->thermal.fitted = file->thermal.degree = (uint8_t)(t.rows > 0 ? t.rows - 1 : 0);
    file->thermal.nominal = fit_over_field(&file->thermal.nominal, file->thermal_field);
    file->is_triangular = is(t.frame, "triangular");
    return is_usable(&t) ? EXIT_GOOD
                         : json_error(r, "\"thermal\" is incomplete or invalid; write the file "
                                         "again with invcal calibrate --thermal");
}

/* ---- nonlinearity ----------------------------------------------------------------------------- */

static int read_nonlinear_member(json_reader *r, const char *name, void *into)
{
    calibration_nonlinear *n = into;

    return is(name, "quadratic")        ? read_vector(r, n->term[0])
           : is(name, "cubic")          ? read_vector(r, n->term[1])
           : is(name, "field")          ? json_read_number(r, &n->field)
           : is(name, "nominal_matrix") ? read_matrix(r, n->nominal.matrix)
                                        : json_skip(r);
}

/* Missing members remain 0. */
static int read_nonlinear(json_reader *r, calibration_file *file)
{
    double inverse[3][3];
    const int failure = read_object(r, read_nonlinear_member, &file->nonlinear);

    if (failure) {
        return failure;
    }
    file->has_nonlinear = 1;
    return file->nonlinear.field > 0 && matrix_inverse(&file->nonlinear.nominal, inverse)
               ? EXIT_GOOD
               : json_error(r, "\"nonlinearity\" is incomplete; write the file again with invcal "
                               "calibrate --quadratic or --cubic");
}

/* ---- gyroscope -------------------------------------------------------------------------------- */

/* State of reading a gyroscope. */
typedef struct {
    calibration_file *file;
    int has_offset;
    int has_matrix;
    int is_refused;
} gyro_reading;

static int read_gyro_member(json_reader *r, const char *name, void *into)
{
    gyro_reading *g = into;

    char unit[CALIBRATION_FILE_WORD];

    if (is(name, "unit")) {
        const int failure = json_read_text(r, unit, sizeof unit);
        g->file->gyro_is_counts = failure || is(unit, "counts");
        return failure;
    }
    g->has_offset = g->has_offset || is(name, "offset");
    g->has_matrix = g->has_matrix || is(name, "matrix");
    g->is_refused = g->is_refused || is(name, "error");
    g->file->has_gyro_g = g->file->has_gyro_g || is(name, "g_correction");
    return is(name, "offset")         ? read_vector(r, g->file->gyro.offset)
           : is(name, "matrix")       ? read_matrix(r, g->file->gyro.matrix)
           : is(name, "lsb")          ? json_read_number(r, &g->file->gyro_lsb)
           : is(name, "g_correction") ? read_matrix(r, g->file->gyro_g)
           : is(name, "sigma")        ? read_nine(r, read_figure, g->file->gyro_sigma)
           : is(name, "verdict")
               ? json_read_text(r, g->file->gyro_verdict, sizeof g->file->gyro_verdict)
               : json_skip(r);
}

/* A gyroscope that was refused counts as none. */
static int read_gyro(json_reader *r, calibration_file *file)
{
    gyro_reading g = {.file = file};
    double inverse[3][3];
    const int failure = read_object(r, read_gyro_member, &g);

    if (failure || g.is_refused) {
        return failure;
    }
    file->has_gyro = 1;
    return g.has_offset && g.has_matrix && matrix_inverse(&file->gyro, inverse)
               ? EXIT_GOOD
               : json_error(r, "\"gyroscope\" is incomplete, or its matrix is singular; write the "
                               "file again with invcal calibrate");
}

/* ---- the members ------------------------------------------------------------------------------ */

static int read_record_member(json_reader *r, const char *name, void *into)
{
    char text[RECORD_MAX + 1]; /* one more, to detect a text that is too long */
    char what[RECORD_MAX];

    for (unsigned k = 0; k < RECORD_TEXTS; k++) {
        if (is(name, record_name((record_text)k))) {
            const int failure = json_read_text(r, text, sizeof text);
            const char *problem = failure ? NULL : record_set(into, (record_text)k, text);
            if (problem) {
                snprintf(what, sizeof what, "\"%s\" of \"record\" %s", name, problem);
                return json_error(r, what);
            }
            return failure;
        }
    }
    return json_skip(r);
}

static int read_magnetometer_member(json_reader *r, const char *name, void *into)
{
    calibration_file *c = into;
    char text[CALIBRATION_FILE_WORD];

    if (!is(name, "field")) {
        return json_skip(r);
    }
    const int failure = json_read_text(r, text, sizeof text);
    c->is_field_measured = !failure && is(text, "measured");
    return failure;
}

/* The number that a member sets, or null. */
static double *number_of(const char *name, calibration_file *c)
{
    const struct {
        const char *name;
        double *number;
    } all[] = {{"gravity", &c->gravity},
               {"gravity_sigma", &c->gravity_sigma},
               {"interval95", &c->interval},
               {"positions", &c->positions},
               {"suspected", &c->suspected}};

    for (unsigned k = 0; k < sizeof all / sizeof *all; k++) {
        if (is(name, all[k].name)) {
            return all[k].number;
        }
    }
    return NULL;
}

/* Members that are not part of the correction itself. */
static int read_metadata(json_reader *r, const char *name, calibration_file *c)
{
    double *number = number_of(name, c);

    if (number) {
        /* the truth of a simulation lists positions */
        return number == &c->positions && json_peek(r) == '[' ? json_skip(r)
                                                              : json_read_number(r, number);
    }
    return is(name, "record")         ? read_object(r, read_record_member, &c->record)
           : is(name, "magnetometer") ? read_object(r, read_magnetometer_member, c)
           : is(name, "frame")        ? json_read_text(r, c->frame, sizeof c->frame)
           : is(name, "verdict")      ? json_read_text(r, c->verdict, sizeof c->verdict)
           : is(name, "undetermined") ? read_names(r, c->undetermined, sizeof c->undetermined)
           : is(name, "nominal")      ? read_object(r, read_nominal_member, c)
           : is(name, "sigma")        ? read_object(r, read_sigma_member, c)
                                      : json_skip(r);
}

/* A file of another program may have another member of this name. */
static int is_number(json_reader *r)
{
    const int first = json_peek(r);

    return first >= '0' && first <= '9';
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
    x->file->is_magnetometer = x->file->is_magnetometer || is(name, "magnetometer");
    return is_offset   ? read_vector(r, x->file->calibration.offset)
           : is_matrix ? read_matrix(r, x->file->calibration.matrix)
           : is(name, "thermal") && x->depth >= CORRECTION      ? read_thermal(r, x->file)
           : is(name, "nonlinearity") && x->depth >= CORRECTION ? read_nonlinear(r, x->file)
           : is(name, "gyroscope") && x->depth >= CORRECTION    ? read_gyro(r, x->file)
           : is(name, "unit") && x->depth >= CORRECTION
               ? json_read_text(r, x->file->unit, sizeof x->file->unit)
           : is(name, "gravity") && x->depth == CORRECTION && is_number(r)
               ? json_read_number(r, &x->file->gravity)
           : x->depth == EVERYTHING ? read_metadata(r, name, x->file)
                                    : json_skip(r);
}

static int read_calibration(json_reader *r, reading *x)
{
    const int failure = read_object(r, read_member, x);

    if (failure) {
        return failure;
    }
    if (!x->has_offset || !x->has_matrix) {
        message("%s:%lu: no member \"%s\": not a calibration: make one with invcal calibrate --out",
                r->name, r->line, x->has_offset ? "matrix" : "offset");
        return EXIT_FILE;
    }
    return json_finish(r);
}

static void clear(calibration_file *c)
{
    *c = (calibration_file){.gravity = NUMBER_UNKNOWN,
                            .interval = NUMBER_UNKNOWN,
                            .positions = NUMBER_UNKNOWN,
                            .suspected = NUMBER_UNKNOWN};
    for (unsigned i = 0; i < 3; i++) {
        c->zero[i] = c->lsb[i] = NUMBER_UNKNOWN;
        c->sigma_offset[i] = c->sigma_dk[i] = c->sigma_gamma[i] = NUMBER_UNKNOWN;
        c->gyro_sigma[i][0] = c->gyro_sigma[i][1] = c->gyro_sigma[i][2] = NUMBER_UNKNOWN;
    }
}

static int read_path(const char *path, calibration_file *out, reading_depth depth)
{
    json_reader r;
    reading x = {.file = out, .depth = depth};
    double inverse[3][3];
    FILE *file = input_open(path);

    clear(out);
    if (!file) {
        return EXIT_FILE;
    }
    json_start(&r, file, input_name(path));
    int failure = read_calibration(&r, &x);
    if (!failure && !matrix_inverse(&out->calibration, inverse)) {
        message("%s: \"matrix\" is singular: not a calibration", input_name(path));
        failure = EXIT_FILE;
    }
    input_close(file);
    return failure;
}

int calibration_file_read(const char *path, invcal_calibration *out)
{
    calibration_file file;
    const int failure = read_path(path, &file, OFFSET_AND_MATRIX);

    if (!failure) {
        *out = file.calibration;
    }
    return failure;
}

int calibration_file_read_correction(const char *path, calibration_file *out)
{
    return read_path(path, out, CORRECTION);
}

int calibration_file_read_all(const char *path, calibration_file *out)
{
    return read_path(path, out, EVERYTHING);
}
