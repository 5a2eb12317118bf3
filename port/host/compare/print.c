/* SPDX-License-Identifier: MIT
 *
 * The tables.
 */
#include <math.h>
#include <string.h>

#include "compare/compare.h"
#include "design/parameters.h"
#include "text/figure.h"
#include "text/number.h"
#include "text/paint.h"
#include "text/tabular.h"
#include "text/wrapped.h"

#define DEVICES_LISTED 40u /* of more devices, only histories with a change */

/* A value with as many digits as its sigma has; "?" if there is none. */
static const char *digits(double x, double sigma, figure_sign sign, char text[FIGURE_MAX])
{
    if (!isfinite(x)) {
        return "?";
    }
    return figure_fixed(x, figure_places(x, sigma), sign, text);
}

static const char *short_digits(double x, char text[FIGURE_MAX])
{
    return isfinite(x) ? figure_digits(x, 3, text) : "?";
}

/* ---- drift ------------------------------------------------------------------------------------- */

static void add_item(const compare_result *r, unsigned k, unsigned number)
{
    char name[COMPARE_NAME_MAX];
    char verdict[COMPARE_NAME_MAX];
    const compare_item *item = &r->item[k];

    tabular_cell("%u", number);
    tabular_cell(" %s", compare_date(item));
    tabular_cell(" %s", compare_file_name(item, 30, name));
    tabular_note("%s", compare_cut(item->verdict, 13, verdict));
    tabular_row();
}

static void add_drift(const compare_result *r, const compare_drift *d, unsigned p)
{
    char name[COMPARE_NAME_MAX];
    char text[FIGURE_MAX];
    const display_unit value = compare_value_unit(r, p, name);
    const display_unit drift = compare_drift_unit(r, p);
    const double sigma = drift.scale * d->sigma[p];
    const double per = value.scale * d->now->sigma[p];

    tabular_cell("%s", parameter_words(p));
    tabular_cell("%s", digits(value.scale * d->before->x[p], per, FIGURE_PLAIN, text));
    tabular_cell("%s", digits(value.scale * d->now->x[p], per, FIGURE_PLAIN, text));
    tabular_cell("%s", digits(drift.scale * d->x[p], sigma, FIGURE_SIGNED, text));
    tabular_cell("± %s", digits(sigma, sigma, FIGURE_PLAIN, text));
    tabular_cell("%s", isfinite(d->in_sigma[p])
                           ? figure_fixed(d->in_sigma[p], 1, FIGURE_SIGNED, text)
                           : "?");
    tabular_note("%s", d->changed >> p & 1 ? "changed" : "");
    tabular_row();
}

static void print_drift(FILE *file, const compare_result *r, const compare_drift *d)
{
    putc('\n', file);
    tabular_begin(file, "lrrrlr");
    tabular_cell("%u to %u", compare_number(r, d->before), compare_number(r, d->now));
    tabular_cell("before");
    tabular_cell("now");
    tabular_cell("drift");
    tabular_cell("± sigma");
    tabular_cell("in sigma");
    tabular_row_in(PAINT_BOLD);
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        add_drift(r, d, p);
    }
    tabular_end();
}

static void print_history(FILE *file, const compare_result *r, unsigned device)
{
    const compare_device *d = &r->device[device];
    char name[COMPARE_NAME_MAX];

    wrapped_printf(file, 0, "%s: %u calibrations, by %s", compare_device_name(r, device, 40, name),
                   d->count, d->is_dated ? "date" : "the order of the files");
    tabular_begin(file, "rll");
    for (unsigned k = 0; k < d->count; k++) {
        add_item(r, d->first + k, k + 1);
    }
    tabular_end();
    for (unsigned k = 1; k < d->count; k++) {
        print_drift(file, r, &r->drift[d->first + k]);
    }
    if (d->count > 2) {
        print_drift(file, r, &d->whole);
    }
    fprintf(file, "\n");
}

/* Of many devices, only those that have changed. */
static void print_histories(FILE *file, const compare_result *r)
{
    for (unsigned k = 0; k < r->devices; k++) {
        if (r->device[k].count > 1 && (compare_has_changed(r, k) || r->devices <= DEVICES_LISTED)) {
            print_history(file, r, k);
        }
    }
}

/* ---- fleet ------------------------------------------------------------------------------------- */

/* Distance of a device from the median, in spreads. */
static double spreads(const compare_result *r, unsigned device, unsigned p)
{
    return (compare_newest(r, device)->x[p] - r->fleet.median[p]) / r->fleet.spread[p];
}

static void add_fleet(const compare_result *r, unsigned p)
{
    const compare_fleet *f = &r->fleet;
    const display_unit drift = compare_drift_unit(r, p);
    const double per = fabs(compare_divisor(f->median, r->field, p)) / drift.scale;
    const unsigned far = f->farthest[p];
    char name[COMPARE_NAME_MAX];
    char text[FIGURE_MAX];
    const display_unit value = compare_value_unit(r, p, name);
    const double away = spreads(r, far, p);

    tabular_cell("%s", parameter_words(p));
    tabular_cell(
        "%s", digits(value.scale * f->median[p], value.scale * f->spread[p], FIGURE_PLAIN, text));
    tabular_cell("%s", short_digits(f->spread[p] / per, text));
    tabular_cell("%s", short_digits(f->deviation[p] / per, text));
    tabular_cell("%s", compare_device_name(r, far, 18, name));
    tabular_cell("%s", isfinite(away) ? figure_fixed(away, 1, FIGURE_SIGNED, text) : "?");
    tabular_note("%s", f->outliers[far] >> p & 1 ? "outside" : "");
    tabular_row();
}

static void print_outlier(FILE *file, const compare_result *r, unsigned device, unsigned p)
{
    const display_unit drift = compare_drift_unit(r, p);
    const compare_item *item = compare_newest(r, device);
    const double away =
        (item->x[p] - r->fleet.median[p]) / compare_divisor(r->fleet.median, r->field, p);
    char name[COMPARE_NAME_MAX];
    char text[FIGURE_MAX];

    wrapped_printf(
        file, 4, "%sOutlier:%s %s, %s: %s%s %s from the median", paint_on(file, PAINT_RED),
        paint_off(file), compare_device_name(r, device, 20, name), parameter_words(p),
        drift.scale * away > 0 ? "+" : "", figure_digits(drift.scale * away, 3, text), drift.unit);
}

static void print_fleet(FILE *file, const compare_result *r)
{
    fprintf(file, "%u devices, the newest calibration of each\n", r->devices);
    putc('\n', file);
    tabular_begin(file, "lrrrrr");
    tabular_heading("|median|spread|deviation|farthest|spreads");
    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        add_fleet(r, p);
    }
    tabular_end();
    fprintf(file, "\n");
    for (unsigned k = 0; k < r->devices; k++) {
        for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
            if (r->fleet.outliers[k] >> p & 1) {
                print_outlier(file, r, k, p);
            }
        }
    }
}

/* ---- the output -------------------------------------------------------------------------------- */

static void print_units(FILE *file, const compare_result *r)
{
    char offset[COMPARE_NAME_MAX];
    char scale[COMPARE_NAME_MAX];
    char text[COMPARE_TEXT_MAX];
    const char *angle = compare_drift_unit(r, INVCAL_GAMMA_XY).unit;

    (void)compare_value_unit(r, INVCAL_DELTA_X, offset);
    (void)compare_value_unit(r, INVCAL_DK_X, scale);
    snprintf(
        text, sizeof text,
        "Values: offsets in %s, scales in %s, angles in %s off square. Differences: offsets in "
        "%s, scales in %s, angles in %s.",
        offset, scale, angle, compare_drift_unit(r, INVCAL_DELTA_X).unit,
        compare_drift_unit(r, INVCAL_DK_X).unit, angle);
    wrapped_line(file, 0, 0, text);
}

static void print_field(FILE *file, const compare_result *r)
{
    const double part = compare_field_part(r);
    char text[COMPARE_TEXT_MAX];

    if (part > 0) {
        const display_unit scale = unit_style_scale(r->units);
        snprintf(text, sizeof text,
                 "The ± of the scales includes %.2g %s for the field (--gravity). If all were made "
                 "in one place, --same-field leaves it out.",
                 scale.scale * part, scale.unit);
        wrapped_line(file, 0, 0, text);
    }
}

void compare_print(FILE *file, const compare_result *r)
{
    static const paint colour[] = {PAINT_GREEN, PAINT_YELLOW, PAINT_YELLOW};
    char text[COMPARE_TEXT_MAX];
    char word[32];

    print_histories(file, r);
    if (r->devices > 1) {
        print_fleet(file, r);
    }
    print_units(file, r);
    print_field(file, r);
    if (r->count > r->devices) {
        wrapped_line(file, 0, 0, compare_drift_rule());
    }
    if (r->devices > 1) {
        wrapped_line(file, 0, 0, compare_fleet_rule());
    }
    snprintf(word, sizeof word, "%s:", compare_verdict_word(r));
    fprintf(file, "\n%s%s%s ", paint_on(file, colour[compare_verdict(r)]), word, paint_off(file));
    wrapped_line(file, strlen(word) + 1, 0, compare_sentence(r, text));
    fprintf(file, "Next: ");
    wrapped_line(file, 6, 0, compare_next(r));
}
