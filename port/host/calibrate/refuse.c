/* SPDX-License-Identifier: MIT */
#include "calibrate/refuse.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "text/json_write.h"
#include "cli/message.h"
#include "design/parameters.h"
#include "result/faces.h"
#include "stand/tell.h"
#include "text/number.h"

#define REASON_MAX 4000
#define SLOW 25.0         /* samples a second: shorter rests would do, if they were found */
#define LISTED 10u        /* rests that are named */
#define FEW_SAMPLES 1000u /* more rows than anybody has positions */

/* Puts more behind a reason; what is too long is cut off. */
static void add(char *text, const char *format, ...) MESSAGE_FORMAT(2, 3);

static void add(char *text, const char *format, ...)
{
    const size_t length = strlen(text);
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text + length, REASON_MAX - length, format, arguments);
    va_end(arguments);
}

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

/* Without a prior for it a parameter takes a position. */
static unsigned positions_needed(const fit_settings *settings)
{
    unsigned needed = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        needed += !(settings->prior[r] > 0);
    }
    return needed > 0 ? needed : 1;
}

/* A group of a program that was not visited leaves its angle between axes open. */
static unsigned missing_group(const positions *data, const stand_wish *angles, uint16_t bits)
{
    static const unsigned told_by[] = {0, INVCAL_GAMMA_ZY, INVCAL_GAMMA_XZ, INVCAL_GAMMA_XY};
    const unsigned group = stand_missing_group(angles, data);

    return group > 0 && bits >> told_by[group] & 1 ? group : 0;
}

/* What to do about rests that are missing or too short, and what if the rate is a guess. */
static void add_remedy(const rests_summary *log, int is_none, char *text)
{
    const unsigned brief = log->refused[INVCAL_REST_SHORT - INVCAL_REST_SHORT] +
                           log->refused[INVCAL_REST_GAP - INVCAL_REST_SHORT];

    if (!log->is_rate_known) {
        add(text,
            "; the log tells no times, so %.3g samples a second are a guess: state --rate, and "
            "hold each "
            "position still for 3 s or longer, below 25 samples a second for %u samples",
            log->rate, RESTS_SAMPLES);
    } else if (brief > 0 || is_none) {
        add(text, "; hold each position still for %.2g s or longer", rests_least(log->rate) + 1);
    }
    if (log->is_rate_known ? log->rate < SLOW && (brief > 0 || is_none) : is_none) {
        add(text, ", or average each yourself and add --positions");
    }
}

/* The rests that were refused, by their reason, and where. Returns their number. */
static unsigned add_refused(const rests_summary *log, char *text)
{
    unsigned refused = 0;
    unsigned told = 0;

    for (unsigned i = 0; i < RESTS_REASONS; i++) {
        refused += log->refused[i];
    }
    told = refused < RESTS_TOLD ? refused : RESTS_TOLD;
    for (unsigned i = 0; i < RESTS_REASONS; i++) {
        const invcal_status why = (invcal_status)(INVCAL_REST_SHORT + i);
        const char *before = " (near line ";
        if (log->refused[i] > 0) {
            add(text, "; refused %u: %s", log->refused[i], rests_reason_text(why));
        }
        for (unsigned k = 0; k < told; k++) {
            if (log->refusal[k].why == why) {
                add(text, "%s%lu", before, log->refusal[k].line);
                before = ", ";
            }
        }
        add(text, "%s", *before == ',' ? ")" : "");
    }
    return refused;
}

/* Where the rests were, and why others were refused. */
static void add_rests(const positions *data, char *text)
{
    for (unsigned i = 0; i < data->count && i < LISTED; i++) {
        const position_origin *o = &data->origin[i];
        add(text, "%s line %lu, %.3g to %.3g s (%.2g s)", i ? ";" : "; found:", o->line, o->begin,
            o->end, o->end - o->begin);
    }
    const unsigned refused = add_refused(data->rests, text);
    add_remedy(data->rests, data->count + refused == 0, text);
}

static void say_undetermined(const positions *data, const stand_wish *angles, uint16_t bits,
                             char *text)
{
    char list[128];
    char advice[128];
    char visit[STAND_TEXT_MAX];
    const unsigned group = missing_group(data, angles, bits);

    snprintf(text, REASON_MAX, "the positions leave parameters undetermined%s%s; %s%s",
             bits ? ": " : "", parameters_list(bits, list, sizeof list),
             group > 0 ? "" : "add positions with ",
             group > 0 ? stand_missing_text(angles, group, visit)
                       : parameters_advice(bits, advice, sizeof advice));
}

static void say_too_large(unsigned position, char *text)
{
    snprintf(text, REASON_MAX, "position %u is too large a reading for any calculation",
             position + 1);
}

/* A reading that cannot be one of this field: by how much, and what may be wrong. */
static void say_out_of_range(const positions *data, const fit_settings *settings,
                             const nominal_choice *nominal, unsigned position, char *text)
{
    double v[3];
    const int by_range = nominal->zero == NOMINAL_RANGE && nominal->lsb == NOMINAL_RANGE;
    const int by_unit = nominal->lsb == NOMINAL_UNIT;

    invcal_apply(&settings->nominal, &data->mean[3 * (size_t)position], v);
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length <= REJECTION_TELLABLE)) {
        say_too_large(position, text);
        return;
    }
    snprintf(text, REASON_MAX, "position %u reads %.3g of the field with %s: %s", position + 1,
             length,
             by_range  ? "zero and scale from the data's range"
             : by_unit ? "the scale of the unit that is stated"
                       : "the nominal calibration",
             by_range  ? "look for a wrong position, add positions in all directions, or state "
                         "--zero and --lsb"
             : by_unit ? "check the unit in the header; --unit states another"
                       : "check --gravity, and the nominal zero and scale, and their units");
}

static void say_why(const positions *data, const fit_settings *settings,
                    const nominal_choice *nominal, const stand_wish *angles, invcal_status status,
                    const fit_reason *reason, char *text)
{
    switch (status) {
    case INVCAL_TOO_FEW:
        snprintf(text, REASON_MAX, "%u position%s too few: %u are needed, 12 or more are good",
                 data->count, data->count == 1 ? " is" : "s are", positions_needed(settings));
        if (data->rests) {
            add_rests(data, text);
        }
        break;
    case INVCAL_UNDETERMINED:
        say_undetermined(data, angles, reason->undetermined, text);
        break;
    case INVCAL_OUT_OF_RANGE:
        say_out_of_range(data, settings, nominal, reason->position, text);
        break;
    case INVCAL_NOT_FINITE:
        say_too_large(reason->position, text);
        break;
    case INVCAL_NOT_ELLIPSOID:
        snprintf(text, REASON_MAX,
                 "%s; look for positions that were not at rest or all in one direction, and for "
                 "wrong columns, units or --gravity",
                 invcal_status_text(status));
        break;
    default:
        snprintf(text, REASON_MAX, "%s", invcal_status_text(status));
        break;
    }
}

/* Six faces may be all that there is. */
static void offer_six_faces(const positions *data, const fit_settings *settings,
                            invcal_status status, char *text)
{
    const size_t length = strlen(text);

    if ((status == INVCAL_TOO_FEW || status == INVCAL_UNDETERMINED) &&
        faces_would_do(data, settings)) {
        snprintf(text + length, REASON_MAX - length,
                 ". These do for offsets and scales: --six-faces takes the angles from a data "
                 "sheet. Six more tell everything: %s",
                 FACES_EDGES);
    }
}

int calibrate_refuse(const positions *data, const fit_settings *settings,
                     const nominal_choice *nominal, const stand_wish *angles, invcal_status status,
                     const fit_reason *reason, int json)
{
    char text[REASON_MAX];
    json_writer w;

    /* The first of too few readings may be out of range only because the others are missing. */
    if (data->count < positions_needed(settings)) {
        status = INVCAL_TOO_FEW;
    }
    say_why(data, settings, nominal, angles, status, reason, text);
    offer_six_faces(data, settings, status, text);
    if (status == INVCAL_NOT_FINITE || status == INVCAL_OUT_OF_RANGE) {
        message("%s:%lu: %s", data->name, data->origin[reason->position].line, text);
    } else {
        message("%s: %s", data->name, text);
    }
    if (json) {
        json_begin(&w, stdout);
        json_text(&w, "error", status_name(status));
        json_text(&w, "reason", text);
        json_parameters(&w, "undetermined", reason->undetermined);
        json_end(&w);
    }
    return EXIT_DATA;
}

/* The mean length of the readings, counts, from the nominal zero. */
static double mean_length(const positions *data, const invcal_calibration *nominal)
{
    double sum = 0;

    for (unsigned n = 0; n < data->count; n++) {
        double square = 0;
        for (unsigned i = 0; i < 3; i++) {
            const double d = data->mean[3 * (size_t)n + i] - nominal->offset[i];
            square += d * d;
        }
        sum += sqrt(square) / data->count;
    }
    return sum;
}

/* As good as 1, zero and scale being nominal. */
static int is_about_one(double x)
{
    return x > 0.4 && x < 2.5;
}

int calibrate_check_scale(const char *command, const positions *data, const nominal_choice *nominal,
                          double field)
{
    const double lsb = fabs(nominal->calibration.matrix[0][0]);
    const double counts = mean_length(data, &nominal->calibration);
    char numerator[NUMBER_TEXT_MAX];

    if (nominal->lsb != NOMINAL_GIVEN || is_about_one(counts * lsb / field) ||
        !(is_about_one(counts / lsb) || is_about_one(counts / (lsb * field)))) {
        return EXIT_GOOD;
    }
    const double meant = is_about_one(counts / lsb) ? field : 1;
    return message_usage(command,
                         "--lsb is field per count, not counts per field: with %.6g these readings "
                         "are %.3g times the field; you mean --lsb %s/%.6g, which is %.6g",
                         lsb, counts * lsb / field, number_text(meant, numerator), lsb,
                         meant / lsb);
}

int calibrate_all_drift(const calibrate_result *result, int json)
{
    char text[REASON_MAX];
    json_writer w;

    snprintf(
        text, sizeof text,
        "the temperature drifted by more than %.2g K in %u of %u rests, and the others are too "
        "few: let the sensor settle, or take them with --keep-all",
        result->fit.drift_limit, rejection_drifting(&result->rejected), result->data->count);
    message("%s: %s", result->data->name, text);
    if (json) {
        json_begin(&w, stdout);
        json_text(&w, "error", status_name(INVCAL_TOO_FEW));
        json_text(&w, "reason", text);
        json_parameters(&w, "undetermined", (1u << INVCAL_PARAMETERS) - 1);
        json_end(&w);
    }
    return EXIT_DATA;
}

void calibrate_unreadable(void)
{
    json_writer w;

    json_begin(&w, stdout);
    json_text(&w, "error", "unreadable");
    json_text(&w, "reason", message_last());
    json_parameters(&w, "undetermined", (1u << INVCAL_PARAMETERS) - 1);
    json_end(&w);
}

int calibrate_no_rest(const positions *data, const rests_summary *log, int json)
{
    char text[REASON_MAX];
    char least[16];
    json_writer w;

    snprintf(least, sizeof least, "%.2g", rests_least(log->rate));
    snprintf(text, sizeof text,
             "no rest of %s seconds in %lu samples, %.6g s at %.6g samples a second%s",
             strcmp(least, "2") == 0 ? "two" : least, log->samples, log->seconds, log->rate,
             log->is_rate_known ? "" : " (a guess)");
    if (log->gaps > 0) {
        add(text, "; %lu gaps", log->gaps);
    }
    add_rests(data, text);
    if (log->samples < FEW_SAMPLES) {
        add(text, "; if each row is the mean of a position, add --positions");
    }
    message("%s: %s", data->name, text);
    if (json) {
        json_begin(&w, stdout);
        json_text(&w, "error", "no rest");
        json_text(&w, "reason", text);
        json_parameters(&w, "undetermined", (1u << INVCAL_PARAMETERS) - 1);
        json_end(&w);
    }
    return EXIT_DATA;
}
