/* SPDX-License-Identifier: MIT
 *
 * Texts that table and page share.
 */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "cli/input.h"
#include "compare/compare.h"
#include "design/parameters.h"
#include "text/figure.h"
#include "text/unit.h"
#include "text/utf8.h"

#define LISTED_MAX 5u /* devices in a sentence */

display_unit compare_drift_unit(const compare_result *r, unsigned p)
{
    return p >= INVCAL_GAMMA_XY ? unit_style_angle(r->units)
           : p >= INVCAL_DK_X   ? unit_style_scale(r->units)
                                : unit_style_field(r->units, r->is_gravity);
}

display_unit compare_page_unit(const compare_result *r, unsigned p)
{
    const display_unit degrees = {FIGURE_DEGREES, "°"};

    return p >= INVCAL_GAMMA_XY && r->units == UNIT_STYLE_EVERYDAY ? degrees
                                                                   : compare_drift_unit(r, p);
}

display_unit compare_value_unit(const compare_result *r, unsigned p, char name[COMPARE_NAME_MAX])
{
    if (p >= INVCAL_GAMMA_XY) {
        return unit_style_angle(r->units);
    }
    snprintf(name, COMPARE_NAME_MAX, "%s%s", unit_words(unit_of_name(r->unit)),
             p < INVCAL_DK_X ? ""
             : r->is_gravity ? " per m/s²"
                             : " per field unit");
    return (display_unit){1, name};
}

const char *compare_cut(const char *from, unsigned columns, char text[COMPARE_NAME_MAX])
{
    size_t end = 0;  /* of text */
    size_t last = 0; /* where its last character begins */
    unsigned count = 0;

    while (*from != '\0' && count < columns && end + 8 < COMPARE_NAME_MAX) {
        const unsigned length = utf8_length(from);
        const unsigned char first = (unsigned char)*from;
        last = end;
        if (length == 0 || first < ' ' || first == 0x7f || first == 0xc2) {
            text[end++] = '?';
        } else {
            memcpy(&text[end], from, length);
            end += length;
        }
        from += length > 0 ? length : 1;
        count++;
    }
    text[end] = '\0';
    if (*from != '\0') {
        memcpy(&text[last], "…", sizeof "…");
    }
    return text;
}

static const char *serial_of(const compare_result *r, unsigned k)
{
    return r->item[k].record.text[RECORD_SERIAL];
}

unsigned compare_serials(const compare_result *r, unsigned device, char text[COMPARE_NAME_MAX])
{
    const compare_device *d = &r->device[device];
    unsigned count = 0;

    text[0] = '\0';
    for (unsigned k = d->first; k < d->first + d->count; k++) {
        const size_t length = strlen(text);
        unsigned same = d->first;
        while (strcmp(serial_of(r, same), serial_of(r, k)) != 0) {
            same++;
        }
        if (same == k && *serial_of(r, k) != '\0') {
            snprintf(text + length, COMPARE_NAME_MAX - length, "%s%s", count > 0 ? ", " : "",
                     serial_of(r, k));
            count++;
        }
    }
    return count;
}

const char *compare_device_name(const compare_result *r, unsigned device, unsigned columns,
                                char text[COMPARE_NAME_MAX])
{
    char list[COMPARE_NAME_MAX];
    char name[COMPARE_NAME_MAX + 16];
    const unsigned count = compare_serials(r, device, list);

    snprintf(name, sizeof name, "serial%s %s", count > 1 ? "s" : "", list);
    return count > 0 ? compare_cut(name, columns, text)
                     : compare_file_name(compare_newest(r, device), columns, text);
}

const char *compare_file_name(const compare_item *item, unsigned columns,
                              char text[COMPARE_NAME_MAX])
{
    return compare_cut(input_file_name(input_name(item->path)), columns, text);
}

unsigned compare_number(const compare_result *r, const compare_item *item)
{
    return (unsigned)(item - &r->item[r->device[item->device].first]) + 1;
}

const char *compare_date(const compare_item *item)
{
    return item->record.text[RECORD_DATE];
}

/* ---- the verdict ------------------------------------------------------------------------------- */

/* The last drift of a device; null if it has one calibration only. */
static const compare_drift *last_drift(const compare_result *r, unsigned device)
{
    const compare_device *d = &r->device[device];

    return d->count > 1 ? &r->drift[d->first + d->count - 1] : NULL;
}

static uint16_t changed_bits(const compare_result *r, unsigned device)
{
    const compare_drift *d = last_drift(r, device);

    return d ? d->changed : 0;
}

/* Changed since the first calibration, but not in the last step. */
static uint16_t drifted_bits(const compare_result *r, unsigned device)
{
    return (uint16_t)(r->device[device].whole.changed & ~changed_bits(r, device));
}

int compare_has_changed(const compare_result *r, unsigned device)
{
    return changed_bits(r, device) != 0 || drifted_bits(r, device) != 0;
}

static uint16_t outlier_bits(const compare_result *r, unsigned device)
{
    return r->devices > 1 ? r->fleet.outliers[device] : 0;
}

typedef uint16_t bits_of(const compare_result *r, unsigned device);

static unsigned count_of(const compare_result *r, bits_of *bits)
{
    unsigned count = 0;

    for (unsigned k = 0; k < r->devices; k++) {
        count += bits(r, k) != 0;
    }
    return count;
}

static int has_every_chance(const compare_drift *d)
{
    int is_known = 1;

    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        is_known = is_known && !isnan(d->chance[p]);
    }
    return is_known;
}

/* The number of devices with a history, and whether all their sigma are known. */
static unsigned histories(const compare_result *r, int *is_known)
{
    unsigned count = 0;

    *is_known = 1;
    for (unsigned k = 0; k < r->devices; k++) {
        const compare_device *d = &r->device[k];
        count += d->count > 1;
        *is_known = *is_known && (d->count < 2 || has_every_chance(last_drift(r, k))) &&
                    (d->count < 3 || has_every_chance(&d->whole));
    }
    return count;
}

/* Two devices without a history: nothing can be said about them. */
static int is_too_few(const compare_result *r)
{
    return r->devices > 1 && r->devices < COMPARE_FLEET_MIN && r->count == r->devices;
}

compare_outcome compare_verdict(const compare_result *r)
{
    int is_known;

    (void)histories(r, &is_known);
    return count_of(r, changed_bits) + count_of(r, drifted_bits) + count_of(r, outlier_bits) > 0
               ? COMPARE_DIFFERENT
           : is_known && !is_too_few(r) ? COMPARE_STEADY
                                        : COMPARE_UNKNOWN;
}

const char *compare_verdict_word(const compare_result *r)
{
    const compare_outcome outcome = compare_verdict(r);

    return outcome == COMPARE_STEADY       ? (r->devices >= COMPARE_FLEET_MIN ? "Alike" : "Steady")
           : outcome == COMPARE_UNKNOWN    ? (is_too_few(r) ? "Too few" : "Unknown")
           : count_of(r, outlier_bits) > 0 ? "Not alike"
           : count_of(r, changed_bits) > 0 ? "Changed"
                                           : "Drifting";
}

static void append(char text[COMPARE_TEXT_MAX], const char *more)
{
    const size_t length = strlen(text);

    snprintf(text + length, COMPARE_TEXT_MAX - length, "%s", more);
}

/* "serial 3 (offset x), serial 5 (scale y), and 2 more" */
static void append_devices(const compare_result *r, bits_of *bits, char text[COMPARE_TEXT_MAX])
{
    char name[COMPARE_NAME_MAX];
    char list[128];
    char one[COMPARE_NAME_MAX + 140];
    unsigned listed = 0;
    const unsigned count = count_of(r, bits);

    for (unsigned k = 0; k < r->devices && listed < LISTED_MAX; k++) {
        if (bits(r, k) != 0) {
            snprintf(one, sizeof one, "%s%s (%s)", listed > 0 ? ", " : "",
                     compare_device_name(r, k, 40, name),
                     parameters_list(bits(r, k), list, sizeof list));
            append(text, one);
            listed++;
        }
    }
    if (count > listed) {
        snprintf(one, sizeof one, ", and %u more", count - listed);
        append(text, one);
    }
}

/* "2026-07-01 (s7.json)", or the name of the file. */
static void append_origin(const compare_item *item, char text[COMPARE_TEXT_MAX])
{
    const char *date = compare_date(item);
    char name[COMPARE_NAME_MAX];
    char one[COMPARE_NAME_MAX + RECORD_MAX + 8];

    compare_file_name(item, 40, name);
    snprintf(one, sizeof one, *date != '\0' ? "%s (%s)" : "%s%s", date, name);
    append(text, one);
}

/* "offset x has moved by +0.394 mg (+11.0 sigma), offset y by ... since 2026-01-01 (s1.json)" */
static void append_whole(const compare_result *r, char text[COMPARE_TEXT_MAX])
{
    const compare_drift *d = &r->device[0].whole;
    unsigned listed = 0;
    char one[COMPARE_NAME_MAX];
    char by[FIGURE_MAX];
    char sigma[FIGURE_MAX];

    for (unsigned p = 0; p < INVCAL_PARAMETERS; p++) {
        const display_unit unit = compare_drift_unit(r, p);
        const double x = unit.scale * d->x[p];
        if (drifted_bits(r, 0) >> p & 1) {
            snprintf(one, sizeof one, "%s%s%s by %s %s (%s sigma)", listed > 0 ? ", " : "",
                     parameter_words(p), listed > 0 ? "" : " has moved",
                     figure_fixed(x, figure_places(x, unit.scale * d->sigma[p]), FIGURE_SIGNED, by),
                     unit.unit, figure_fixed(d->in_sigma[p], 1, FIGURE_SIGNED, sigma));
            append(text, one);
            listed++;
        }
    }
    append(text, " since ");
    append_origin(d->before, text);
}

/* If there is only one device: what has changed, and since when. */
static void say_history(const compare_result *r, char text[COMPARE_TEXT_MAX])
{
    char list[128] = "nothing";
    int is_known;

    (void)histories(r, &is_known);
    if (changed_bits(r, 0) != 0) {
        (void)parameters_list(changed_bits(r, 0), list, sizeof list);
    }
    snprintf(text, COMPARE_TEXT_MAX, "%s %s %s since ", list, strchr(list, ',') ? "have" : "has",
             is_known || changed_bits(r, 0) != 0 ? "changed significantly"
                                                 : "changed as far as is known (some have no ±)");
    text[0] = (char)toupper((unsigned char)text[0]);
    append_origin(compare_newest(r, 0) - 1, text);
    if (drifted_bits(r, 0) != 0) {
        append(text, changed_bits(r, 0) != 0 ? ", and " : ", but ");
        append_whole(r, text);
    }
    append(text, ".");
}

static void say_histories(const compare_result *r, char text[COMPARE_TEXT_MAX])
{
    int is_known;
    const unsigned count = histories(r, &is_known);
    char one[COMPARE_NAME_MAX];

    if (count == 0) {
        return;
    }
    snprintf(one, sizeof one, " Of %u device%s with an earlier calibration ", count,
             count == 1 ? "" : "s");
    append(text, one);
    if (count_of(r, changed_bits) + count_of(r, drifted_bits) == 0) {
        append(text, is_known ? "none has changed significantly."
                              : "none is known to have changed; some have no ±.");
        return;
    }
    if (count_of(r, changed_bits) > 0) {
        snprintf(one, sizeof one, "%u changed significantly: ", count_of(r, changed_bits));
        append(text, one);
        append_devices(r, changed_bits, text);
    }
    if (count_of(r, drifted_bits) > 0) {
        snprintf(one, sizeof one, "%s since the first, %u changed: ",
                 count_of(r, changed_bits) > 0 ? ";" : "none has changed since that one, but",
                 count_of(r, drifted_bits));
        append(text, one);
        append_devices(r, drifted_bits, text);
    }
    append(text, ".");
}

static void say_fleet(const compare_result *r, char text[COMPARE_TEXT_MAX])
{
    const unsigned count = count_of(r, outlier_bits);
    char one[COMPARE_NAME_MAX];

    if (r->devices < COMPARE_FLEET_MIN) {
        append(text, "Two devices are too few to identify an outlier.");
    } else if (count == 0) {
        snprintf(one, sizeof one, "None of %u devices is an outlier.", r->devices);
        append(text, one);
    } else {
        snprintf(one, sizeof one, "Outliers, of %u devices: ", r->devices);
        append(text, one);
        append_devices(r, outlier_bits, text);
        append(text, ".");
    }
}

const char *compare_sentence(const compare_result *r, char text[COMPARE_TEXT_MAX])
{
    text[0] = '\0';
    if (r->devices > 1) {
        say_fleet(r, text);
        say_histories(r, text);
    } else if (r->count > 1) {
        say_history(r, text);
    }
    return text;
}

const char *compare_next(const compare_result *r)
{
    int is_known;

    if (count_of(r, outlier_bits) > 0) {
        return "calibrate each outlier again; if it remains an outlier, the device is different.";
    }
    if (count_of(r, changed_bits) + count_of(r, drifted_bits) > 0) {
        return "use the newest calibration, look for a cause (temperature, a knock, stress in the "
               "mounting, or another unit under this serial number), and calibrate again soon to "
               "see if it continues.";
    }
    if (is_too_few(r)) {
        return "compare three devices or more; or, if both files are of one device, state --as "
               "history.";
    }
    (void)histories(r, &is_known);
    return is_known ? "nothing to do; use the newest calibration of each device."
                    : "calibrate with more positions, or state --noise, to get a ±.";
}

const char *compare_drift_rule(void)
{
    return "A parameter has changed if chance alone would change any of the nine by as much in at "
           "most 5 % of cases: Student's t with the degrees of freedom of both calibrations "
           "(Welch), and a ninth of the 5 % for each (Bonferroni). Of three calibrations or more "
           "the newest is also compared with the first; each comparison then has half of the 5 %.";
}

const char *compare_fleet_rule(void)
{
    return "A device is an outlier if Rosner's generalised ESD test finds it: the farthest are "
           "tested one after another, a quarter of all at most, so that several cannot mask each "
           "other. In a fleet of equal devices it finds any, in any of the nine parameters, in 5 % "
           "of cases. A device whose own ± (95 %) reaches the median is not an outlier. The spread "
           "is 1.4826 times the median distance from the median.";
}

double compare_field_part(const compare_result *r)
{
    double max = 0;

    for (unsigned k = 0; k < r->count; k++) {
        const compare_item *item = &r->item[k];
        for (unsigned i = 0; i < 3; i++) {
            if (item->field_sigma[i] > item->sigma[INVCAL_DK_X + i] / 2) {
                max = fmax(max, item->field_sigma[i] / fabs(item->x[INVCAL_DK_X + i]));
            }
        }
    }
    return max;
}
