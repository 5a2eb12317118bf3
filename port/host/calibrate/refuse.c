/* SPDX-License-Identifier: MIT */
#include "calibrate/refuse.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "design/parameters.h"
#include "fit/rejection.h"
#include "result/faces.h"
#include "stand/output.h"
#include "text/append.h"

#define POSITIONS_GOOD 12u    /* positions to recommend */
#define RATE_LOW 25.0         /* samples per second below which rests must be longer than 2 s */
#define LISTED_MAX 10u        /* rests that are listed */
#define REST_FRACTION_MIN 0.1 /* part of the time at rest; below it the device was waved */
#define SAMPLES_FEW 1000u     /* fewer rows than this may be positions */

static const char *status_name(invcal_status status)
{
    switch (status) {
    case INVCAL_NOT_FINITE:
        return "not finite";
    case INVCAL_OUT_OF_RANGE:
        return "out of range";
    case INVCAL_TOO_FEW:
        return "too few";
    case INVCAL_UNDETERMINED:
        return "undetermined";
    case INVCAL_NOT_ELLIPSOID:
        return "not an ellipsoid";
    default:
        return "bad setting";
    }
}

/* Each parameter without a prior takes one position. */
static unsigned positions_needed(const fit_settings *settings)
{
    unsigned needed = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        needed += !(settings->prior[r] > 0);
    }
    return needed > 0 ? needed : 1;
}

/* The group of a program that was not visited, if its angle is among the undetermined parameters;
 * else 0. */
static unsigned missing_group(const positions *data, const stand_options *angles, uint16_t bits)
{
    static const unsigned angle_of_group[] = {0, INVCAL_GAMMA_ZY, INVCAL_GAMMA_XZ, INVCAL_GAMMA_XY};
    const unsigned group = stand_missing_group(angles, data);

    return group > 0 && bits >> angle_of_group[group] & 1 ? group : 0;
}

static unsigned refused_for(const rests_summary *log, invcal_status why)
{
    return log->refused[why - INVCAL_REST_SHORT];
}

/* What to do about rests that are missing or too short, or if the rate is a guess. */
static void add_remedy(const rests_summary *log, int is_none, char text[REFUSAL_MAX])
{
    const unsigned too_short =
        refused_for(log, INVCAL_REST_SHORT) + refused_for(log, INVCAL_REST_GAP);

    if (!log->is_rate_known) {
        append(text, REFUSAL_MAX,
               "%sthe log has no times, so %.3g samples per second are a guess: state --rate, and "
               "hold each position still for 3 s or longer, below 25 samples per second for %u "
               "samples",
               *text ? "; " : "", log->rate, RESTS_SAMPLES);
    } else if (too_short > 0 || is_none) {
        append(text, REFUSAL_MAX, "%shold each position still for %.2g s or longer",
               *text ? "; " : "", rests_min_seconds(log->rate) + 1);
    }
    if (log->is_rate_known ? log->rate < RATE_LOW && (too_short > 0 || is_none) : is_none) {
        append(text, REFUSAL_MAX, ", or average each yourself and add --positions");
    }
}

/* Lists the refused rests by reason, with their lines. Returns their number. */
static unsigned add_refused(const rests_summary *log, char text[REFUSAL_MAX])
{
    unsigned refused = 0;
    unsigned listed = 0;

    for (unsigned i = 0; i < RESTS_REASONS; i++) {
        refused += log->refused[i];
    }
    listed = refused < RESTS_LISTED ? refused : RESTS_LISTED;
    for (unsigned i = 0; i < RESTS_REASONS; i++) {
        const invcal_status why = (invcal_status)(INVCAL_REST_SHORT + i);
        const char *before = " (near line ";
        if (log->refused[i] > 0) {
            append(text, REFUSAL_MAX, "; refused %u: %s", log->refused[i], rests_reason_text(why));
        }
        for (unsigned k = 0; k < listed; k++) {
            if (log->refusal[k].why == why) {
                append(text, REFUSAL_MAX, "%s%lu", before, log->refusal[k].line);
                before = ", ";
            }
        }
        append(text, REFUSAL_MAX, "%s", *before == ',' ? ")" : "");
    }
    return refused;
}

/* Lists the rests that were found and refused. */
static void add_rests(const positions *data, refusal *why)
{
    for (unsigned i = 0; i < data->count && i < LISTED_MAX; i++) {
        const position_origin *o = &data->origin[i];
        append(why->reason, REFUSAL_MAX, "%s line %lu, %.3g to %.3g s (%.2g s)",
               i ? ";" : "; found:", o->line, o->begin, o->end, o->end - o->begin);
    }
    const unsigned refused = add_refused(data->rests, why->reason);
    add_remedy(data->rests, data->count + refused == 0, why->remedy);
}

static void explain_undetermined(const positions *data, const stand_options *angles, refusal *why)
{
    const uint16_t bits = why->undetermined;
    char list[128];
    char advice[128];
    char visit[STAND_TEXT_MAX];
    const unsigned group = missing_group(data, angles, bits);

    snprintf(why->reason, REFUSAL_MAX, "the positions leave parameters undetermined%s%s",
             bits ? ": " : "", parameters_list(bits, list, sizeof list));
    snprintf(why->remedy, REFUSAL_MAX, "%s%s", group > 0 ? "" : "add positions with ",
             group > 0 ? stand_missing_text(angles, group, visit)
                       : parameters_advice(bits, advice, sizeof advice));
    why->wants_positions = group == 0;
}

static void explain_not_finite(refusal *why)
{
    snprintf(why->reason, REFUSAL_MAX, "the reading of position %u is too large",
             why->position + 1);
    snprintf(why->remedy, REFUSAL_MAX, "correct it, or leave it out");
    why->is_of_position = 1;
}

/* A reading that is impossible in this field: its length, and what may be wrong. */
static void explain_out_of_range(const calibrate_result *r, refusal *why)
{
    const nominal_choice *nominal = &r->nominal;
    const int by_range = nominal->zero == NOMINAL_RANGE && nominal->lsb == NOMINAL_RANGE;
    const int by_unit = nominal->lsb == NOMINAL_UNIT;
    const int by_option = by_unit && r->data->seen.unit_from == UNIT_FROM_OPTION;
    double v[3];

    invcal_apply(&r->settings.nominal, r->data->mean[3 * (size_t)why->position],
                 r->data->mean[3 * (size_t)why->position + 1],
                 r->data->mean[3 * (size_t)why->position + 2], v);
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    why->is_of_position = 1;
    if (!(length <= REJECTION_LENGTH_MAX)) {
        explain_not_finite(why);
        return;
    }
    snprintf(why->reason, REFUSAL_MAX, "position %u reads %.3g of the field with %s",
             why->position + 1, length,
             by_range  ? "zero and scale from the range of the data"
             : by_unit ? "the scale of the stated unit"
                       : "the nominal calibration");
    snprintf(why->remedy, REFUSAL_MAX, "%s",
             by_range
                 ? "look for an outlier, add positions in all directions, or state --zero and --lsb"
             : by_option ? "check --unit: counts, for readings of an ADC"
             : by_unit   ? "check the unit in the header, or state --unit"
                         : "check --gravity, the nominal zero and scale, and their units");
    why->wants_positions = by_range;
}

static void explain_too_few(const calibrate_result *r, refusal *why)
{
    const unsigned count = r->data->count;

    snprintf(why->reason, REFUSAL_MAX, "%u position%s too few: %u are needed, 12 or more are good",
             count, count == 1 ? " is" : "s are", positions_needed(&r->settings));
    snprintf(why->remedy, REFUSAL_MAX, "add %u or more in other directions",
             count < POSITIONS_GOOD ? POSITIONS_GOOD - count : 3);
    why->wants_positions = 1;
    if (r->data->rests) {
        add_rests(r->data, why);
    }
}

static void explain(const calibrate_result *r, const stand_options *angles, invcal_status status,
                    refusal *why)
{
    switch (status) {
    case INVCAL_TOO_FEW:
        explain_too_few(r, why);
        break;
    case INVCAL_UNDETERMINED:
        explain_undetermined(r->data, angles, why);
        break;
    case INVCAL_OUT_OF_RANGE:
        explain_out_of_range(r, why);
        break;
    case INVCAL_NOT_FINITE:
        explain_not_finite(why);
        break;
    case INVCAL_NOT_ELLIPSOID:
        snprintf(why->reason, REFUSAL_MAX, "%s", invcal_status_text(status));
        snprintf(why->remedy, REFUSAL_MAX,
                 "check that the positions were at rest and in different directions, and check "
                 "columns, units and --gravity");
        why->wants_positions = 1;
        break;
    default:
        snprintf(why->reason, REFUSAL_MAX, "%s", invcal_status_text(status));
        break;
    }
}

/* Begins a new reason; an earlier one is dropped. */
static refusal *begin_refusal(calibrate_result *r, const char *word, uint16_t undetermined)
{
    r->refused = (refusal){.word = word, .undetermined = undetermined};
    return &r->refused;
}

/* Recommends --six-faces if these positions are sufficient for it. */
static void offer_six_faces(const calibrate_result *r, invcal_status status, refusal *why)
{
    if ((status == INVCAL_TOO_FEW || status == INVCAL_UNDETERMINED) &&
        faces_suffice(r->data, &r->settings)) {
        append(why->remedy, REFUSAL_MAX,
               ". These determine offsets and scales: --six-faces takes the angles from a data "
               "sheet. Six more determine everything: %s",
               FACES_EDGES);
    }
}

/* Recommends --magnetometer if the log may be of one that was waved. */
static void offer_magnetometer(const positions *data, refusal *why)
{
    const rests_summary *log = data->rests;
    const columns_sensor of = data->seen.sensor;
    double rested = 0;

    for (unsigned i = 0; i < data->count && log; i++) {
        rested += data->origin[i].end - data->origin[i].begin;
    }
    const int is_waved =
        log && (of == COLUMNS_OF_MAGNETOMETER ||
                (log->samples >= SAMPLES_FEW && of != COLUMNS_OF_ACCELEROMETER &&
                 !data->seen.is_gyro && rested < REST_FRACTION_MIN * log->seconds));
    if (is_waved) {
        append(why->remedy, REFUSAL_MAX, "%sfor a magnetometer in motion: --magnetometer",
               *why->remedy ? "; " : "");
    }
}

int calibrate_refuse(calibrate_result *r, const stand_options *angles, invcal_status status,
                     const fit_reason *reason)
{
    /* With too few positions, one may be out of range only because the others are missing. */
    if (r->data->count < positions_needed(&r->settings)) {
        status = INVCAL_TOO_FEW;
    }
    refusal *why = begin_refusal(r, status_name(status), reason->undetermined);
    why->position = reason->position;
    explain(r, angles, status, why);
    offer_six_faces(r, status, why);
    if (status == INVCAL_TOO_FEW) {
        offer_magnetometer(r->data, why);
    }
    return EXIT_DATA;
}

int calibrate_refuse_readings(calibrate_result *r, const char *reason, const char *remedy)
{
    refusal *why = begin_refusal(r, status_name(INVCAL_OUT_OF_RANGE), 0);

    snprintf(why->reason, REFUSAL_MAX, "%s", reason);
    snprintf(why->remedy, REFUSAL_MAX, "%s", remedy);
    return EXIT_DATA;
}

int calibrate_refuse_drift(calibrate_result *r)
{
    refusal *why = begin_refusal(r, status_name(INVCAL_TOO_FEW), (1u << INVCAL_PARAMETERS) - 1);

    snprintf(
        why->reason, REFUSAL_MAX,
        "the temperature drifted by more than %.2g K in %u of %u rests, and the others are too few",
        r->fit.drift_limit, rejection_drifting(&r->rejected), r->data->count);
    snprintf(why->remedy, REFUSAL_MAX,
             "let the sensor settle before each rest, or keep them with --keep-all");
    return EXIT_DATA;
}

int calibrate_refuse_frame(calibrate_result *r)
{
    refusal *why = begin_refusal(r, "angles", 0);

    snprintf(why->reason, REFUSAL_MAX, "no frame of the stand: %s", stand_advice(&r->stand));
    return EXIT_DATA;
}

int calibrate_refuse_no_rest(calibrate_result *r)
{
    const rests_summary *log = r->log;
    refusal *why = begin_refusal(r, "no rest", (1u << INVCAL_PARAMETERS) - 1);
    char duration[16];

    snprintf(duration, sizeof duration, "%.2g", rests_min_seconds(log->rate));
    append(why->reason, REFUSAL_MAX,
           "no rest of %s seconds in %lu sample%s, %.6g s at %.6g samples per second%s",
           strcmp(duration, "2") == 0 ? "two" : duration, log->samples,
           log->samples == 1 ? "" : "s", log->seconds, log->rate,
           log->is_rate_known ? "" : " (a guess)");
    if (log->gaps > 0) {
        append(why->reason, REFUSAL_MAX, "; %lu gap%s", log->gaps, log->gaps == 1 ? "" : "s");
    }
    add_rests(r->data, why);
    if (log->samples < SAMPLES_FEW) {
        snprintf(why->remedy, REFUSAL_MAX,
                 "if each row is the mean of a position, add --positions; if each is a sample, "
                 "%srecord for longer, and hold each position still for %.2g s or longer",
                 log->is_rate_known ? "" : "state --rate, ", rests_min_seconds(log->rate) + 1);
    }
    offer_magnetometer(r->data, why);
    why->wants_positions = 1;
    return EXIT_DATA;
}

int calibrate_refuse_case(calibrate_result *r, invcal_status status)
{
    refusal *why = begin_refusal(r, "angles", 0);

    append(why->reason, REFUSAL_MAX, "--case: %s",
           status == INVCAL_TOO_FEW ? "it states none of the positions that were kept"
           : r->frame.is_level && status == INVCAL_UNDETERMINED
               ? "the stated axis is nearly opposite to the measured one"
           : r->frame.is_level ? "the stated axis did not point up in all of these positions"
                               : "the stated axes do not fit the positions, or an axis of the "
                                 "log is inverted or exchanged");
    append(why->remedy, REFUSAL_MAX,
           "state the axes in the order of the log, in a right-handed frame");
    return EXIT_DATA;
}

int calibrate_refuse_axes(calibrate_result *r)
{
    const dip_frame *d = &r->dip;
    refusal *why = begin_refusal(r, "angles", 0);

    if (d->answer == DIP_NO_ACCELEROMETER) {
        append(why->reason, REFUSAL_MAX,
               "the log has no columns of an accelerometer (ax ay az) next to those of the "
               "magnetometer");
    } else if (d->answer == DIP_UNEVEN) {
        append(why->reason, REFUSAL_MAX,
               "the accelerometer reads its usual length, within 10 %%, in only %lu of %lu samples",
               d->used, d->of);
        append(why->remedy, REFUSAL_MAX,
               "correct it with its own calibration (--with CAL.json), and turn slowly");
    } else {
        append(why->reason, REFUSAL_MAX,
               "the log does not determine the rotation between its axes and the accelerometer's");
        append(why->remedy, REFUSAL_MAX, "turn about all axes, slowly");
    }
    return EXIT_DATA;
}

/* The axis, 0 to 2, whose readings are all the same; -1: none. */
static int find_constant_axis(const magnetometer_log *log)
{
    for (int axis = 0; axis < 3; axis++) {
        unsigned long n = 0;
        while (n < log->instants && log->instant[n].field[axis] <= log->instant[0].field[axis] &&
               log->instant[n].field[axis] >= log->instant[0].field[axis]) {
            n++;
        }
        if (n > 1 && n == log->instants) {
            return axis;
        }
    }
    return -1;
}

int calibrate_refuse_magnetometer(calibrate_result *r)
{
    const magnetometer_log *log = r->magnetometer;
    refusal *why = begin_refusal(r, status_name(log->status), (1u << INVCAL_PARAMETERS) - 1);

    if (log->status == INVCAL_TOO_FEW || log->status == INVCAL_UNDETERMINED) {
        const int constant = find_constant_axis(log);
        append(why->reason, REFUSAL_MAX, "%lu samples, all in a few directions", log->samples);
        if (constant >= 0) {
            append(why->reason, REFUSAL_MAX, ": %c never changes", "xyz"[constant]);
            append(why->remedy, REFUSAL_MAX, "check its column and the sensor; ");
        }
        append(why->remedy, REFUSAL_MAX,
               "wave it for a minute until every side of the case has pointed along the field, "
               "which points north and steeply down in Europe and North America");
    } else {
        append(why->reason, REFUSAL_MAX, "the samples do not lie on an ellipsoid");
        append(why->remedy, REFUSAL_MAX, "check the columns, and look for iron or a magnet nearby");
    }
    return EXIT_DATA;
}
