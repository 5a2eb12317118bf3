/* SPDX-License-Identifier: MIT
 *
 * The page of a comparison.
 */
#include <math.h>
#include <string.h>

#include "compare/compare.h"
#include "design/parameters.h"
#include "draw/page.h"
#include "text/figure.h"

#define DRIFT_COLUMNS 6u
#define FLEET_COLUMNS 6u
#define ITEM_COLUMNS 4u
#define OUTLIER_COLUMNS 4u
#define DEVICES_SHOWN 40u /* of more devices, only histories with a change */

/* A value with as many digits as its sigma has; "?" if there is none. */
static const char *digits(double x, double sigma, figure_sign sign, char text[FIGURE_MAX])
{
    return isfinite(x) ? figure_fixed(x, figure_places(x, sigma), sign, text) : "?";
}

static void write_verdict(page *p, const compare_result *r)
{
    static const page_severity severity[] = {PAGE_GOOD, PAGE_CAUTION, PAGE_CAUTION};
    char word[64];
    char text[COMPARE_TEXT_MAX];
    const compare_outcome outcome = compare_verdict(r);

    snprintf(word, sizeof word, "%s %s", outcome == COMPARE_STEADY ? "✓" : "!",
             compare_verdict_word(r));
    page_verdict(p, severity[outcome], word, compare_sentence(r, text), compare_next(r));
}

/* ---- history ----------------------------------------------------------------------------------- */

static void write_items(page *p, const compare_result *r, const compare_device *d)
{
    static const char *const headings[ITEM_COLUMNS] = {"", "date", "file", "verdict"};
    const page_table sheet = {"The calibrations, oldest first.", headings, ITEM_COLUMNS, 0xe};
    char number[FIGURE_MAX];
    char name[COMPARE_NAME_MAX];
    char verdict[COMPARE_NAME_MAX];

    page_table_begin(p, &sheet);
    for (unsigned k = 0; k < d->count; k++) {
        const compare_item *item = &r->item[d->first + k];
        const char *const cells[ITEM_COLUMNS] = {number, compare_date(item),
                                                 compare_file_name(item, 60, name),
                                                 compare_cut(item->verdict, 20, verdict)};
        snprintf(number, sizeof number, "%u", k + 1);
        page_cells(p, &sheet, cells);
    }
    page_table_end(p);
}

static void write_drift_row(page *p, const page_table *sheet, const compare_result *r,
                            const compare_drift *d, unsigned q)
{
    const compare_item *const item[2] = {d->before, d->now};
    char name[COMPARE_NAME_MAX];
    char text[4][FIGURE_MAX + 64];
    char number[FIGURE_MAX];
    const display_unit value =
        q >= INVCAL_GAMMA_XY ? compare_page_unit(r, q) : compare_value_unit(r, q, name);
    const display_unit drift = compare_page_unit(r, q);
    const char *const cells[DRIFT_COLUMNS] = {parameter_words(q),
                                              text[0],
                                              text[1],
                                              text[2],
                                              text[3],
                                              d->changed >> q & 1 ? "changed" : ""};

    for (unsigned i = 0; i < 2; i++) {
        snprintf(text[i], sizeof text[i], "%s",
                 digits(value.scale * item[i]->x[q], value.scale * d->now->sigma[q], FIGURE_PLAIN,
                        number));
    }
    snprintf(text[2], sizeof text[2], "%s %s",
             figure_with_sigma(drift.scale * d->x[q], drift.scale * d->half_width[q], FIGURE_SIGNED,
                               number),
             drift.unit);
    snprintf(text[3], sizeof text[3], "%s",
             isfinite(d->in_sigma[q]) ? figure_fixed(d->in_sigma[q], 1, FIGURE_SIGNED, number)
                                      : "?");
    page_cells(p, sheet, cells);
}

static void write_drift(page *p, const compare_result *r, const compare_drift *d)
{
    static const char *const headings[DRIFT_COLUMNS] = {"parameter", "before", "now",
                                                        "drift",     "in σ",   "remark"};
    char caption[COMPARE_NAME_MAX + 64];
    char offset[COMPARE_NAME_MAX];
    const page_table sheet = {caption, headings, DRIFT_COLUMNS, 1u << 5};

    (void)compare_value_unit(r, INVCAL_DELTA_X, offset);
    snprintf(caption, sizeof caption,
             "From %u to %u. Offsets before and now in %s; ± of the drift: 95 %%.",
             compare_number(r, d->before), compare_number(r, d->now), offset);
    page_table_begin(p, &sheet);
    for (unsigned q = 0; q < INVCAL_PARAMETERS; q++) {
        write_drift_row(p, &sheet, r, d, q);
    }
    page_table_end(p);
}

static void write_history(page *p, const compare_result *r, unsigned device)
{
    const compare_device *d = &r->device[device];
    static const char offsets[] = "Offsets: differences from the oldest calibration. "
                                  "Whiskers: 95 % interval of each calibration alone.";
    static const char *const captions[3] = {offsets, "Scales, the same.",
                                            "Angles off square, the same."};
    compare_picture picture = {r, device, 0};
    char name[COMPARE_NAME_MAX];
    char heading[COMPARE_NAME_MAX + 16];

    snprintf(heading, sizeof heading, "Drift of %s", compare_device_name(r, device, 60, name));
    page_section(p, heading);
    write_items(p, r, d);
    for (picture.kind = 0; picture.kind < 3; picture.kind++) {
        page_picture(p, captions[picture.kind], compare_draw_history, &picture);
    }
    for (unsigned k = 1; k < d->count; k++) {
        write_drift(p, r, &r->drift[d->first + k]);
    }
    if (d->count > 2) {
        write_drift(p, r, &d->whole);
    }
}

/* Of many devices, only those that have changed. */
static void write_histories(page *p, const compare_result *r)
{
    for (unsigned k = 0; k < r->devices; k++) {
        if (r->device[k].count > 1 && (r->devices <= DEVICES_SHOWN || compare_has_changed(r, k))) {
            write_history(p, r, k);
        }
    }
}

/* ---- fleet ------------------------------------------------------------------------------------- */

static void write_fleet_row(page *p, const page_table *sheet, const compare_result *r, unsigned q)
{
    const compare_fleet *f = &r->fleet;
    const display_unit drift = compare_page_unit(r, q);
    const double per = fabs(compare_divisor(f->median, r->field, q)) / drift.scale;
    const unsigned far = f->farthest[q];
    const double away =
        (compare_newest(r, far)->x[q] - f->median[q]) / compare_divisor(f->median, r->field, q);
    char name[COMPARE_NAME_MAX];
    char device[COMPARE_NAME_MAX];
    char text[4][FIGURE_MAX + 64];
    char number[FIGURE_MAX];
    const display_unit value =
        q >= INVCAL_GAMMA_XY ? compare_page_unit(r, q) : compare_value_unit(r, q, name);
    const char *const cells[FLEET_COLUMNS] = {
        parameter_words(q), text[0], text[1], text[2], device, text[3]};

    snprintf(text[0], sizeof text[0], "%s %s",
             digits(value.scale * f->median[q], value.scale * f->spread[q], FIGURE_PLAIN, number),
             value.unit);
    snprintf(text[1], sizeof text[1], "%s %s", figure_digits(f->spread[q] / per, 3, number),
             drift.unit);
    snprintf(text[2], sizeof text[2], "%s %s", figure_digits(f->deviation[q] / per, 3, number),
             drift.unit);
    compare_device_name(r, far, 30, device);
    snprintf(text[3], sizeof text[3], "%s%s %s", drift.scale * away > 0 ? "+" : "",
             figure_digits(drift.scale * away, 3, number), drift.unit);
    page_cells(p, sheet, cells);
}

static void write_outliers(page *p, const compare_result *r)
{
    static const char *const headings[OUTLIER_COLUMNS] = {"device", "parameter", "from the median",
                                                          "in spreads"};
    const page_table sheet = {"Outliers.", headings, OUTLIER_COLUMNS, 1u << 1};
    char name[COMPARE_NAME_MAX];
    char text[2][FIGURE_MAX + 64];
    char number[FIGURE_MAX];

    page_table_begin(p, &sheet);
    for (unsigned k = 0; k < r->devices; k++) {
        const compare_item *item = compare_newest(r, k);
        for (unsigned q = 0; q < INVCAL_PARAMETERS; q++) {
            const char *const cells[OUTLIER_COLUMNS] = {compare_device_name(r, k, 40, name),
                                                        parameter_words(q), text[0], text[1]};
            const display_unit drift = compare_page_unit(r, q);
            const double away = item->x[q] - r->fleet.median[q];
            const double in_unit =
                drift.scale * away / compare_divisor(r->fleet.median, r->field, q);
            if (r->fleet.outliers[k] >> q & 1) {
                snprintf(text[0], sizeof text[0], "%s%s %s", in_unit > 0 ? "+" : "",
                         figure_digits(in_unit, 3, number), drift.unit);
                snprintf(text[1], sizeof text[1], "%s",
                         digits(away / r->fleet.spread[q], 1, FIGURE_SIGNED, number));
                page_cells(p, &sheet, cells);
            }
        }
    }
    page_table_end(p);
}

static int has_outliers(const compare_result *r)
{
    for (unsigned k = 0; k < r->devices; k++) {
        if (r->fleet.outliers[k] != 0) {
            return 1;
        }
    }
    return 0;
}

static void write_fleet(page *p, const compare_result *r)
{
    static const char *const headings[FLEET_COLUMNS] = {"parameter", "median",   "spread",
                                                        "deviation", "farthest", "from the median"};
    const page_table sheet = {"The newest calibration of each device.", headings, FLEET_COLUMNS,
                              1u << 4};
    const compare_picture picture = {r, 0, 0};

    page_section(p, "The fleet");
    if (has_outliers(r)) {
        write_outliers(p, r);
    }
    page_table_begin(p, &sheet);
    for (unsigned q = 0; q < INVCAL_PARAMETERS; q++) {
        write_fleet_row(p, &sheet, r, q);
    }
    page_table_end(p);
    page_picture(p,
                 "Each device's distance from the median, in spreads; beyond ±10 at the edge. "
                 "Crosses are outliers.",
                 compare_draw_fleet, &picture);
}

/* ---- the page ---------------------------------------------------------------------------------- */

static void write_origin(page *p, const compare_result *r)
{
    const double part = compare_field_part(r);
    const display_unit scale = unit_style_scale(r->units);

    page_section(p, "How it was made");
    page_facts_begin(p);
    page_fact(p, "files", "%u, of %u device%s", r->count, r->devices, r->devices == 1 ? "" : "s");
    page_literal(p, "command", r->command);
    page_fact(p, "invcal", "%s", INVCAL_VERSION);
    if (r->count > r->devices) {
        page_fact(p, "drift", "%s", compare_drift_rule());
    }
    if (r->devices > 1) {
        page_fact(p, "fleet", "%s", compare_fleet_rule());
    }
    if (part > 0) {
        page_fact(p, "field",
                  "the ± of the scales includes %.2g %s for the field (--gravity); --same-field "
                  "leaves it out if all were made in one place",
                  scale.scale * part, scale.unit);
    }
    page_facts_end(p);
}

static void title_of(const compare_result *r, char *text, size_t size)
{
    char name[COMPARE_NAME_MAX];

    if (r->devices > 1) {
        snprintf(text, size, "%u devices compared", r->devices);
    } else {
        snprintf(text, size, "Calibrations of %s compared",
                 compare_serials(r, 0, name) > 0 ? compare_device_name(r, 0, 60, name)
                                                 : "a device");
    }
}

void compare_report(FILE *file, const compare_result *r)
{
    char title[COMPARE_NAME_MAX + 64];
    char head[RECORD_LINE_MAX];
    char serials[COMPARE_NAME_MAX];
    page p;

    title_of(r, title, sizeof title);
    page_begin_headed(&p, file, title,
                      r->devices > 1 || compare_serials(r, 0, serials) > 1
                          ? ""
                          : record_line(&compare_newest(r, 0)->record, head));
    write_verdict(&p, r);
    if (r->devices > 1) {
        write_fleet(&p, r);
    }
    write_histories(&p, r);
    write_origin(&p, r);
    page_end(&p);
}
