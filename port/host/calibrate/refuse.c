/* SPDX-License-Identifier: MIT */
#include "calibrate/refuse.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "text/json_write.h"
#include "cli/message.h"
#include "design/parameters.h"
#include "result/faces.h"
#include "stand/tell.h"

#define REASON_MAX 800
#define FEW_SAMPLES 1000u /* more rows than anybody has positions */

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

/* A reading that cannot be one of this field: by how much, and what may be wrong. */
static void say_out_of_range(const positions *data, const fit_settings *settings,
                             const nominal_choice *nominal, unsigned position, char *text)
{
    double v[3];
    const int by_range = nominal->zero == NOMINAL_RANGE && nominal->lsb == NOMINAL_RANGE;
    const int by_unit = nominal->lsb == NOMINAL_UNIT;

    invcal_apply(&settings->nominal, &data->mean[3 * (size_t)position], v);
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
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
        break;
    case INVCAL_UNDETERMINED:
        say_undetermined(data, angles, reason->undetermined, text);
        break;
    case INVCAL_OUT_OF_RANGE:
        say_out_of_range(data, settings, nominal, reason->position, text);
        break;
    case INVCAL_NOT_FINITE:
        snprintf(text, REASON_MAX, "position %u is too large a reading for any calculation",
                 reason->position + 1);
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

int calibrate_no_rest(const positions *data, const rests_summary *log, int json)
{
    char text[REASON_MAX];
    json_writer w;

    snprintf(text, sizeof text,
             "no rest of two seconds in %lu samples, %.6g s at %.6g samples a second%s",
             log->samples, log->seconds, log->rate,
             log->is_rate_known ? "" : " (a guess: state --rate)");
    if (log->gaps > 0) {
        const size_t length = strlen(text);
        snprintf(text + length, sizeof text - length, "; %lu gaps", log->gaps);
    }
    for (unsigned i = 0; i < RESTS_REASONS; i++) {
        if (log->refused[i] > 0) {
            const size_t length = strlen(text);
            snprintf(text + length, sizeof text - length, "; %u: %s", log->refused[i],
                     rests_reason_text((invcal_status)(INVCAL_REST_SHORT + i)));
        }
    }
    if (log->samples < FEW_SAMPLES) {
        const size_t length = strlen(text);
        snprintf(text + length, sizeof text - length,
                 "; if each row is the mean of a position, add --positions");
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

int calibrate_refuse_waved(const positions *data, const waved *log, int json)
{
    char text[REASON_MAX];
    json_writer w;

    if (log->status == INVCAL_TOO_FEW || log->status == INVCAL_UNDETERMINED) {
        snprintf(text, sizeof text,
                 "%lu samples, all in a few directions: wave it for a minute so that every side of "
                 "the case has pointed along the field, which points north and steeply down in "
                 "Europe and North America",
                 log->samples);
    } else {
        snprintf(
            text, sizeof text,
            "the samples lie on no ellipsoid: look for wrong columns, and for iron or a magnet "
            "near by");
    }
    message("%s: %s", data->name, text);
    if (json) {
        json_begin(&w, stdout);
        json_text(&w, "error", status_name(log->status));
        json_text(&w, "reason", text);
        json_parameters(&w, "undetermined", (1u << INVCAL_PARAMETERS) - 1);
        json_end(&w);
    }
    return EXIT_DATA;
}
