/* SPDX-License-Identifier: MIT
 *
 * Reads calibrations, checks that they can be compared, and sorts them by device.
 */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/input.h"
#include "cli/message.h"
#include "compare/compare.h"
#include "text/number.h"
#include "text/unit.h"

#define REASON_MAX 600
#define FIELD_TOLERANCE 1e-6 /* relative, of two statements of one field */
#define FIELD_RATIO_MAX 4.0  /* of the earth's magnetic field at two places */
#define SCALE_RATIO_MAX 1.25 /* of nominal scales: more than any tolerance, less than two ranges */

/* The first file, with which the others must agree. */
typedef struct {
    calibration_file file;
    const char *path;
    double temperature;                 /* at which thermal calibrations are compared */
    char sensor[CALIBRATION_FILE_WORD]; /* the first that is stated, */
    const char *sensor_path;            /* and by which file; null: none so far */
    double lsb[3];                      /* the same of the nominal scales */
    const char *lsb_path;
    compare_result *result;
    int json;
} reference; /* large: not for the stack */

/* Says why two calibrations cannot be compared. Returns EXIT_DATA. */
static int refuse(const reference *x, const char *path, const char *format, ...)
    MESSAGE_FORMAT(3, 4);
static int refuse(const reference *x, const char *path, const char *format, ...)
{
    char text[REASON_MAX];
    json_writer w;
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    message("%s: cannot be compared with %s: %s", input_name(path), input_name(x->path), text);
    if (x->json) {
        json_begin(&w, stdout);
        json_text(&w, "error", "not comparable");
        json_text(&w, "file", path);
        json_text(&w, "other", x->path);
        json_text(&w, "reason", text);
        json_end(&w);
    }
    return EXIT_DATA;
}

/* In one unit. The earth's magnetic field differs from place to place, by a factor of 3 at most. */
static int is_one_field(const calibration_file *a, const calibration_file *b)
{
    const double ratio = a->gravity / b->gravity;

    return (unit_is_gravity(a->gravity) && unit_is_gravity(b->gravity)) ||
           (a->is_magnetometer && b->is_magnetometer && ratio < FIELD_RATIO_MAX &&
            ratio > 1 / FIELD_RATIO_MAX) ||
           fabs(ratio - 1) <= FIELD_TOLERANCE;
}

/* A nominal that is not stated is no reason to refuse. */
static int check_sensor(reference *x, const calibration_file *f, const char *path)
{
    if (*f->sensor == '\0') {
        return EXIT_GOOD;
    }
    if (!x->sensor_path) {
        memcpy(x->sensor, f->sensor, sizeof x->sensor);
        x->sensor_path = path;
    }
    if (strcmp(f->sensor, x->sensor) == 0) {
        return EXIT_GOOD;
    }
    x->path = x->sensor_path;
    return refuse(x, path,
                  "they were made with --sensor %s and %s; compare only one sensor in one range",
                  f->sensor, x->sensor);
}

static double greatest_ratio(const double a[3], const double b[3])
{
    double max = 0;

    for (unsigned i = 0; i < 3; i++) {
        max = fmax(max, fmax(fabs(a[i] / b[i]), fabs(b[i] / a[i])));
    }
    return max;
}

/* The same of the scale. The axes of an earlier calibration with cross terms may be others. */
static int check_scale(reference *x, const calibration_file *f, const char *path)
{
    if (!(isfinite(f->lsb[0]) && isfinite(f->lsb[1]) && isfinite(f->lsb[2])) ||
        f->has_cross_terms) {
        return EXIT_GOOD;
    }
    if (!x->lsb_path) {
        memcpy(x->lsb, f->lsb, sizeof x->lsb);
        x->lsb_path = path;
    }
    if (greatest_ratio(f->lsb, x->lsb) <= SCALE_RATIO_MAX) {
        return EXIT_GOOD;
    }
    x->path = x->lsb_path;
    return refuse(x, path,
                  "their nominal scales are %.6g,%.6g,%.6g and %.6g,%.6g,%.6g; compare only one "
                  "sensor in one range",
                  f->lsb[0], f->lsb[1], f->lsb[2], x->lsb[0], x->lsb[1], x->lsb[2]);
}

/* Thermal calibrations are compared at one temperature. */
static int check_model(const reference *x, const calibration_file *f, const char *path)
{
    if (f->has_thermal != x->file.has_thermal) {
        return refuse(
            x, path, "only one of them includes temperature; make both with --thermal, or neither");
    }
    if (f->has_nonlinear != x->file.has_nonlinear) {
        return refuse(x, path,
                      "only one of them includes nonlinearity; make both with --quadratic or "
                      "--cubic, or neither");
    }
    if (f->has_thermal && !(x->temperature >= f->thermal.min && x->temperature <= f->thermal.max)) {
        return refuse(x, path,
                      "it holds from %.4g to %.4g °C, and the other at %.4g °C; calibrate over "
                      "that temperature, too",
                      f->thermal.min, f->thermal.max, x->temperature);
    }
    return EXIT_GOOD;
}

static int check(const reference *x, const calibration_file *f, const char *path)
{
    const calibration_file *other = &x->file;

    if (strcmp(f->frame, other->frame) != 0) {
        return refuse(x, path, "their frames are %s and %s; make both with the same --frame",
                      f->frame, other->frame);
    }
    if (strcmp(f->unit, other->unit) != 0) {
        return refuse(x, path,
                      "the readings are in %s and %s; make both from the same unit, or state it %s",
                      f->unit, other->unit,
                      f->is_magnetometer ? "in the heading, as mx (uT)" : "with --unit");
    }
    if (f->is_field_measured != other->is_field_measured) {
        return refuse(x, path,
                      "only one of them was made with --gravity; the field of the other is the "
                      "length of its readings; make both with --gravity, or neither");
    }
    if (!is_one_field(f, other)) {
        return refuse(x, path, "their fields are %.7g and %.7g; make both with the same --gravity",
                      f->gravity, other->gravity);
    }
    if (x->result->is_same_field && !(fabs(f->gravity / other->gravity - 1) <= FIELD_TOLERANCE)) {
        return refuse(x, path, "--same-field, but the fields are %.9g and %.9g", f->gravity,
                      other->gravity);
    }
    return check_model(x, f, path);
}

/* Sigma of the scales without the uncertainty of the field. */
static void exclude_field_sigma(compare_item *item)
{
    for (unsigned i = 0; i < 3; i++) {
        double *sigma = &item->sigma[INVCAL_DK_X + i];
        const double square = *sigma * *sigma - item->field_sigma[i] * item->field_sigma[i];
        *sigma = square > 0 ? sqrt(square) : NUMBER_UNKNOWN;
        item->field_sigma[i] = 0;
    }
}

static int fill_item(const reference *x, const calibration_file *f, const char *path,
                     compare_item *item)
{
    invcal_calibration c = f->calibration;

    if (f->has_thermal) {
        (void)calibration_file_at(f, x->temperature, &c); /* its range was checked */
    }
    item->path = path;
    item->record = f->record;
    memcpy(item->verdict, f->verdict, sizeof item->verdict);
    compare_parameters(f, &c, item);
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        if (!isfinite(item->x[p])) {
            message("%s: its parameters are out of range", input_name(path));
            return EXIT_FILE;
        }
    }
    if (x->result->is_same_field) {
        exclude_field_sigma(item);
    }
    return EXIT_GOOD;
}

static int read_one(reference *x, const char *path, unsigned k)
{
    static calibration_file file;
    int failure = calibration_file_read_all(path, &file);

    if (failure) {
        return failure;
    }
    if (!(file.gravity > 0) || *file.frame == '\0') {
        message("%s: the field or the frame is missing: not a file of invcal calibrate",
                input_name(path));
        return EXIT_FILE;
    }
    if (k == 0) {
        x->file = file;
        x->path = path;
        x->temperature = file.thermal.reference;
    }
    failure = check(x, &file, path);
    failure = failure ? failure : check_sensor(x, &file, path);
    failure = failure ? failure : check_scale(x, &file, path);
    return failure ? failure : fill_item(x, &file, path, &x->result->item[k]);
}

/* ---- devices ----------------------------------------------------------------------------------- */

static const char *serial_of(const compare_item *item)
{
    return item->record.text[RECORD_SERIAL];
}

static unsigned device_by_serial(const compare_result *r, unsigned k)
{
    unsigned other = 0;

    while (strcmp(serial_of(&r->item[other]), serial_of(&r->item[k])) != 0) {
        other++;
    }
    return other;
}

/* Sets the device of each item, for now to the number of the device's first item. */
static int assign_devices(compare_result *r, compare_grouping grouping)
{
    unsigned unnamed = 0;
    unsigned first = 0;

    for (unsigned k = r->count; k-- > 0;) {
        if (*serial_of(&r->item[k]) == '\0') {
            first = k;
            unnamed++;
        }
    }
    if (grouping == COMPARE_BY_SERIAL && unnamed > 0 && !(unnamed == 2 && r->count == 2)) {
        return message_usage("compare",
                             "%s: has no serial number: state --as history or --as fleet, or "
                             "calibrate with --serial",
                             input_name(r->item[first].path));
    }
    for (unsigned k = 0; k < r->count; k++) {
        r->item[k].device = grouping == COMPARE_HISTORY ? 0
                            : grouping == COMPARE_FLEET ? k
                                                        : device_by_serial(r, k);
    }
    return EXIT_GOOD;
}

static int by_argument(const void *a, const void *b)
{
    const compare_item *one = a;
    const compare_item *other = b;
    const unsigned x = one->device == other->device ? one->argument : one->device;
    const unsigned y = one->device == other->device ? other->argument : other->device;

    return (x > y) - (x < y);
}

static int by_date(const void *a, const void *b)
{
    const compare_item *one = a;
    const compare_item *other = b;
    const int order = strcmp(one->record.text[RECORD_DATE], other->record.text[RECORD_DATE]);

    return order != 0 ? order : by_argument(a, b);
}

/* One device, from item `first` on; sorted by date, if all have one. */
static void add_device(compare_result *r, unsigned first)
{
    compare_device *d = &r->device[r->devices];

    *d = (compare_device){.first = first, .is_dated = 1};
    for (unsigned k = first; k < r->count && r->item[k].device == r->item[first].device; k++) {
        d->count++;
        d->is_dated = d->is_dated && *r->item[k].record.text[RECORD_DATE] != '\0';
    }
    if (d->is_dated) {
        qsort(&r->item[first], d->count, sizeof *r->item, by_date);
    }
    for (unsigned k = first; k < first + d->count; k++) {
        r->item[k].device = r->devices;
    }
    r->devices++;
}

static void sort_items(compare_result *r)
{
    qsort(r->item, r->count, sizeof *r->item, by_argument);
    for (unsigned k = 0; k < r->count; k += r->device[r->devices - 1].count) {
        add_device(r, k);
    }
}

static int find(compare_result *r, compare_grouping grouping)
{
    const int failure = assign_devices(r, grouping);

    if (failure) {
        return failure;
    }
    sort_items(r);
    compare_drifts_find(r);
    if (r->devices > 1 && !compare_fleet_find(r)) {
        message("not enough memory for %u devices", r->devices);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

int compare_read(compare_result *r, const char *const *paths, compare_grouping grouping, int json)
{
    static reference x;
    int failure = EXIT_GOOD;

    x = (reference){.result = r, .json = json};
    r->count = 0;
    while (paths[r->count]) {
        r->count++;
    }
    r->item = calloc((size_t)r->count + 1, sizeof *r->item);
    r->device = calloc((size_t)r->count + 1, sizeof *r->device);
    r->drift = calloc((size_t)r->count + 1, sizeof *r->drift);
    if (!r->item || !r->device || !r->drift) {
        message("not enough memory for %u files", r->count);
        return EXIT_FILE;
    }
    for (unsigned k = 0; k < r->count && !failure; k++) {
        failure = read_one(&x, paths[k], k);
        r->item[k].argument = k;
    }
    if (failure) {
        return failure;
    }
    r->field = x.file.gravity;
    r->is_gravity = unit_is_gravity(r->field);
    memcpy(r->unit, x.file.unit, sizeof r->unit);
    return find(r, grouping);
}

void compare_release(compare_result *r)
{
    free(r->item);
    free(r->device);
    free(r->drift);
    free(r->fleet.outliers);
}
