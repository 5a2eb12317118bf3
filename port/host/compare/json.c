/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "compare/compare.h"
#include "text/json_write.h"

/* Values, unlike json_nine, which writes deviations. */
static void write_values(json_writer *w, const char *name, const double x[INVCAL_PARAMETERS])
{
    json_object(w, name);
    json_vector(w, "offset", &x[INVCAL_DELTA_X]);
    json_vector(w, "scale", &x[INVCAL_DK_X]);
    json_vector(w, "angle", &x[INVCAL_GAMMA_XY]);
    json_object_end(w);
}

static void write_item(json_writer *w, const compare_item *item)
{
    json_object(w, NULL);
    json_text(w, "file", item->path);
    record_json(w, &item->record);
    json_text(w, "verdict", item->verdict);
    write_values(w, "values", item->x);
    write_values(w, "sigma", item->sigma);
    json_object_end(w);
}

static void write_drift(json_writer *w, const char *name, const compare_drift *d)
{
    json_object(w, name);
    json_text(w, "from", d->before->path);
    json_text(w, "to", d->now->path);
    json_nine(w, "drift", d->x);
    json_nine(w, "sigma", d->sigma);
    json_nine(w, "interval95", d->half_width);
    json_nine(w, "chance", d->chance);
    json_parameters(w, "changed", d->changed);
    json_object_end(w);
}

static void write_device(json_writer *w, const compare_result *r, unsigned device)
{
    const compare_device *d = &r->device[device];
    const compare_item *newest = compare_newest(r, device);
    char serials[COMPARE_NAME_MAX];

    json_object(w, NULL);
    if (compare_serials(r, device, serials) == 1) {
        json_text(w, "serial", serials);
    }
    json_list(w, "calibrations");
    for (unsigned k = d->first; k < d->first + d->count; k++) {
        write_item(w, &r->item[k]);
    }
    json_list_end(w);
    json_list(w, "drifts");
    for (unsigned k = d->first + 1; k < d->first + d->count; k++) {
        write_drift(w, NULL, &r->drift[k]);
    }
    json_list_end(w);
    if (d->count > 2) {
        write_drift(w, "since_first", &d->whole);
    }
    if (r->devices > 1) {
        double away[INVCAL_PARAMETERS];
        for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
            away[p] =
                (newest->x[p] - r->fleet.median[p]) / compare_divisor(r->fleet.median, r->field, p);
        }
        json_nine(w, "deviation", away);
        json_parameters(w, "outside", r->fleet.outliers[device]);
    }
    json_object_end(w);
}

static void write_fleet(json_writer *w, const compare_result *r)
{
    double spread[INVCAL_PARAMETERS];
    double deviation[INVCAL_PARAMETERS];

    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        const double per = fabs(compare_divisor(r->fleet.median, r->field, p));
        spread[p] = r->fleet.spread[p] / per;
        deviation[p] = r->fleet.deviation[p] / per;
    }
    json_object(w, "fleet");
    write_values(w, "median", r->fleet.median);
    json_nine(w, "spread", spread);
    json_nine(w, "standard_deviation", deviation);
    json_object_end(w);
}

void compare_json(FILE *file, const compare_result *r)
{
    json_writer w;

    json_begin(&w, file);
    json_text(&w, "invcal", INVCAL_VERSION);
    json_number(&w, "gravity", r->field);
    json_text(&w, "unit", *r->unit != '\0' ? r->unit : "unknown");
    json_number(&w, "false_alarm", COMPARE_FALSE_ALARM);
    json_list(&w, "devices");
    for (unsigned k = 0; k < r->devices; k++) {
        write_device(&w, r, k);
    }
    json_list_end(&w);
    if (r->devices > 1) {
        write_fleet(&w, r);
    }
    json_end(&w);
}
