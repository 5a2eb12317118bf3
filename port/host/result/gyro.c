/* SPDX-License-Identifier: MIT
 *
 * The gyroscope in sentences, as a table, and as JSON.
 */
#include "result/gyro.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/result.h"
#include "maths/matrix.h"
#include "maths/median.h"
#include "text/append.h"
#include "text/figure.h"
#include "text/number.h"
#include "text/parameter.h"
#include "text/plain.h"
#include "text/tabular.h"
#include "text/wrapped.h"

#define LABEL 14u
#define LINE_MAX 900

const char *gyro_verdict(const gyro_fit *g)
{
    return invcal_verdict_text(g->imu.verdict);
}

const char *gyro_fault(const gyro_fit *g, char text[GYRO_TEXT_MAX])
{
    char list[PARAMETER_LIST_MAX];

    text[0] = '\0';
    if (g->word) {
        append(text, GYRO_TEXT_MAX, "not calibrated: %s", g->reason);
    } else if (g->has_readings && g->imu.verdict == INVCAL_WEAK) {
        append(text, GYRO_TEXT_MAX, "weak: %s; make more moves, about all three axes",
               parameter_list_imu(g->imu.weak, list, sizeof list));
    } else if (g->has_readings && g->imu.verdict == INVCAL_NO_REDUNDANCY) {
        append(text, GYRO_TEXT_MAX, "without redundancy to check it; make more moves");
    } else if (g->has_readings && g->imu.verdict != INVCAL_GOOD) {
        append(text, GYRO_TEXT_MAX, "%s, as the accelerometer is", gyro_verdict(g));
    }
    return text;
}

const char *gyro_unit_text(const gyro_fit *g, char text[GYRO_LINE_MAX])
{
    static const char *const sources[] = {[UNIT_FROM_HEADER] = "from the header",
                                          [UNIT_FROM_OPTION] = "--gyro-lsb",
                                          [UNIT_FROM_SIZE] = "from the moves"};
    char number[FIGURE_MAX];

    if (g->is_counts || strcmp(unit_angular_rate_words(g->rate_unit), "counts") == 0) {
        snprintf(text, GYRO_LINE_MAX, "counts of 1/%s °/s (%s)",
                 figure_digits(UNIT_DEGREE / g->rate_unit, 3, number), sources[g->rate_unit_from]);
    } else {
        snprintf(text, GYRO_LINE_MAX, "%s (%s)", unit_angular_rate_words(g->rate_unit),
                 sources[g->rate_unit_from]);
    }
    return text;
}

const char *gyro_limit_text(const gyro_fit *g, char text[GYRO_LINE_MAX])
{
    static const char *const words[] = {
        "the up directions from the rests; hold it stiller and longer",
        "its noise; more moves help",
        "its bias, which changes from rest to rest; let it warm up, and turn faster"};
    unsigned max = 0;
    double square = 0;

    for (unsigned i = 0; i < GYRO_PARTS; i++) {
        max = g->part[i] > g->part[max] ? i : max;
        square += g->part[i] * g->part[i];
    }
    if (g->imu.move_rms > 2 * sqrt(square)) {
        snprintf(text, GYRO_LINE_MAX,
                 "something that rests, noise and bias do not explain (%.2g mrad): vibration, an "
                 "uneven clock, or a nonlinear scale",
                 1e3 * sqrt(square));
    } else {
        snprintf(text, GYRO_LINE_MAX, "%s (%.2g mrad of a move)", words[max], 1e3 * g->part[max]);
    }
    return text;
}

/* A rest in which the device turned. */
static void describe_turned(const calibrate_result *r, unsigned rest, double rate,
                            char text[GYRO_LINE_MAX])
{
    const gyro_fit *g = &r->gyro;
    const unsigned position = g->rest[rest].position;
    char number[FIGURE_MAX];
    int is_lost[2] = {0, 0};

    for (unsigned i = 0; i < g->moves; i++) {
        const gyro_move *m = &g->move[i];
        if (m->why == INVCAL_REST_DRIFT && m->turned == rest) {
            is_lost[m->to != rest] = 1;
        }
    }
    snprintf(text, GYRO_LINE_MAX,
             "position %u (line %lu), for the gyroscope, with the move%s%s%s%s: the device turned "
             "at %s °/s in this rest",
             position + 1, r->data->origin[position].line, is_lost[0] && is_lost[1] ? "s" : "",
             is_lost[0] ? " to" : "", is_lost[0] && is_lost[1] ? " and" : "",
             is_lost[1] ? " from it" : " it", figure_digits(rate / UNIT_DEGREE, 2, number));
}

const char *gyro_left_out(const calibrate_result *r, unsigned move, char text[GYRO_LINE_MAX])
{
    const gyro_fit *g = &r->gyro;
    const gyro_move *m = &g->move[move];
    const gyro_rest *rest = &g->rest[m->to];

    text[0] = '\0';
    if (m->why == INVCAL_REST_DRIFT) {
        for (unsigned i = 0; i < move; i++) {
            if (g->move[i].why == INVCAL_REST_DRIFT && g->move[i].turned == m->turned) {
                return text;
            }
        }
        describe_turned(r, m->turned, m->rate, text);
    } else if (m->why != INVCAL_OK) {
        snprintf(text, GYRO_LINE_MAX, "the move from position %u to %u (line %lu): %s",
                 rest[-1].position + 1, rest->position + 1, r->data->origin[rest->position].line,
                 gyro_reason(m->why));
    }
    return text;
}

const char *gyro_g_text(const gyro_fit *g, char text[GYRO_LINE_MAX])
{
    unsigned at = 0;
    double max = 0;
    double bound = 0;
    char number[FIGURE_MAX];

    for (unsigned i = 0; i < 9; i++) {
        const double x = fabs(g->imu.slope[i / 3][i % 3]) / UNIT_DEGREE;
        const double sigma = g->imu.slope_sigma[i / 3][i % 3] / UNIT_DEGREE;
        at = x > max ? i : at;
        max = fmax(max, x);
        bound = fmax(bound, x + 2 * sigma);
    }
    if (!(g->imu.slope_sigma[0][0] > 0)) {
        snprintf(text, GYRO_LINE_MAX, "unknown: needs 12 rests or more");
    } else if (g->imu.g_is_used) {
        const double sigma = g->imu.slope_sigma[at / 3][at % 3] / UNIT_DEGREE;
        snprintf(text, GYRO_LINE_MAX,
                 "about %c, at most %s °/s per g along %c; corrected in the moves", "xyz"[at / 3],
                 figure_with_sigma(g->imu.slope[at / 3][at % 3] / UNIT_DEGREE, sigma, FIGURE_PLAIN,
                                   number),
                 "xyz"[at % 3]);
    } else {
        snprintf(text, GYRO_LINE_MAX, "below %.1g °/s per g: not significant", bound);
    }
    return text;
}

const char *gyro_drift_text(const gyro_fit *g, char text[GYRO_LINE_MAX])
{
    char number[3][FIGURE_MAX];

    if (!(g->imu.slope_sigma[0][3] > 0)) {
        snprintf(text, GYRO_LINE_MAX, "unknown: needs 12 rests or more");
        return text;
    }
    for (unsigned i = 0; i < 3; i++) {
        figure_with_sigma(g->imu.slope[i][3] / UNIT_DEGREE, g->imu.slope_sigma[i][3] / UNIT_DEGREE,
                          FIGURE_SIGNED, number[i]);
    }
    snprintf(text, GYRO_LINE_MAX,
             "of the bias, x %s, y %s, z %s °/s from the first rest to the last", number[0],
             number[1], number[2]);
    return text;
}

const char *gyro_thermal_text(const gyro_fit *g, char text[GYRO_LINE_MAX])
{
    char number[3][FIGURE_MAX];

    for (unsigned i = 0; i < 3; i++) {
        figure_with_sigma(g->thermal[i] / UNIT_DEGREE, g->thermal_sigma[i] / UNIT_DEGREE,
                          FIGURE_SIGNED, number[i]);
    }
    snprintf(text, GYRO_LINE_MAX, "bias x %s, y %s, z %s °/s per K, over %.2g K", number[0],
             number[1], number[2], g->range);
    return text;
}

/* 1.4826: 1 / median of |x|, x standard normal. */
double gyro_bias_spread(const gyro_fit *g, unsigned axis)
{
    double x[INVCAL_MAX_MOVES];
    unsigned n = 0;

    for (unsigned i = 0; i < g->rests; i++) {
        x[n] = g->rest[i].bias[axis];
        n += isfinite(x[n]) != 0; /* else the rest has no readings */
    }
    if (n < 2) {
        return 0;
    }
    const double median = median_of(x, n);
    for (unsigned i = 0; i < n; i++) {
        x[i] = fabs(x[i] - median);
    }
    return 1.4826 * median_of(x, n);
}

/* ---- the table ---------------------------------------------------------------------------------- */

static void add_row(const char *label, const char *which, double value, double sigma,
                    const char *unit)
{
    char text[FIGURE_MAX];
    const int places = figure_places(value, sigma);

    tabular_cell("%s %s", label, which);
    tabular_cell("%s", figure_fixed(value, places, FIGURE_PLAIN, text));
    tabular_cell("± %s", sigma > 0 ? figure_fixed(sigma, places, FIGURE_PLAIN, text) : "?");
    tabular_note("%s", unit);
    tabular_row();
}

static void print_figures(FILE *file, const calibrate_result *r)
{
    const gyro_fit *g = &r->gyro;
    const display_unit scale = unit_style_scale(r->units);
    const display_unit angle = unit_style_angle(r->units);
    const int is_counts =
        strcmp(unit_angular_rate_words(g->rate_unit), "counts") == 0 || g->is_counts;
    char angle_off[FIGURE_MAX];
    invcal_calibration nominal = {.offset = {0}};
    double inverse[3][3];

    memcpy(nominal.matrix, g->m, sizeof nominal.matrix);
    (void)matrix_inverse(&nominal, inverse); /* close to a unit matrix */
    snprintf(angle_off, sizeof angle_off, "%s off axis", angle.unit);
    tabular_begin(file, "lrl");
    tabular_cell("gyroscope");
    tabular_cell("calibrated");
    tabular_cell("± sigma");
    tabular_row_in(PAINT_BOLD);
    for (unsigned i = 0; i < 3; i++) {
        const char axis[] = {"xyz"[i], '\0'};
        const unsigned of = (unsigned)abs(g->axes[i]) - 1;
        const double per = is_counts ? g->rate_unit : UNIT_DEGREE;
        add_row("bias", axis, g->calibration.offset[of] * g->rate_unit / per,
                gyro_bias_spread(g, i) / per,
                is_counts ? "counts; ±: over all rests" : "°/s; ±: over all rests");
    }
    for (unsigned i = 0; i < 3; i++) {
        const char axis[] = {"xyz"[i], '\0'};
        const double m = inverse[i][i]; /* reading per rate, as in data sheets */
        const double counts = UNIT_DEGREE / g->rate_unit * m;
        if (g->is_counts) { /* the nominal unit is not stated */
            add_row("scale", axis, counts, counts * m * g->imu.sigma[INVCAL_GYRO_XX + 4 * i],
                    "counts per °/s");
        } else {
            add_row("scale error", axis, scale.scale * (m - 1),
                    scale.scale * m * m * g->imu.sigma[INVCAL_GYRO_XX + 4 * i], scale.unit);
        }
    }
    for (unsigned i = 0; i < 9; i++) {
        const char pair[] = {"xyz"[i / 3], "xyz"[i % 3], '\0'};
        if (i / 3 != i % 3) {
            add_row("cross", pair, angle.scale * inverse[i / 3][i % 3],
                    angle.scale * g->imu.sigma[INVCAL_GYRO_XX + i], angle_off);
        }
    }
    tabular_end();
    fprintf(file, "\n");
}

static void print_line(FILE *file, const char *label, const char *text)
{
    fprintf(file, "%-14s", label);
    wrapped_line(file, LABEL, LABEL, text);
}

static void print_source(FILE *file, const gyro_fit *g)
{
    char text[GYRO_LINE_MAX];
    char seen[COLUMNS_TEXT_MAX];
    char name[PLAIN_MAX];

    if (g->log->file) {
        wrapped_printf(file, 0, "%s: %s", plain_copy(g->log->file, name),
                       columns_describe(&g->log->seen, seen, sizeof seen));
    }
    if (!g->word) {
        wrapped_printf(file, 0, "gyroscope: %s, %.6g readings per second%s",
                       gyro_unit_text(g, text), g->log->rate,
                       g->log->is_rate_known ? ""
                                             : " (a guess: its error is an error of the scales)");
    }
    if (fabs(g->lag) > 0) {
        wrapped_printf(file, 0,
                       "The gyroscope's readings are %.2f s %s than the accelerometer's. That is "
                       "corrected here; correct it where both are recorded.",
                       fabs(g->lag), g->lag > 0 ? "later" : "earlier");
    }
}

static void print_moves(FILE *file, const calibrate_result *r)
{
    const gyro_fit *g = &r->gyro;
    const gyro_rest *worst = &g->rest[g->imu.worst + g->rests - g->moves - 1];
    char text[GYRO_LINE_MAX];

    wrapped_printf(file, LABEL,
                   "moves         %u of %u, residual rms %.3g mrad on an axis, max %.3g mrad (to "
                   "position %u), %u degrees of freedom",
                   g->imu.moves, g->moves, 1e3 * g->imu.move_rms, 1e3 * g->imu.move_max,
                   worst->position + 1, g->imu.dof);
    if (g->earlier_rests > 0) {
        wrapped_printf(file, LABEL,
                       "              those between the last %u rests; %u earlier ones are ignored",
                       g->rests, g->earlier_rests);
    }
    for (unsigned i = 0; i < g->moves; i++) {
        if (*gyro_left_out(r, i, text)) {
            wrapped_printf(file, 10, "%sLeft out:%s %s", paint_on(file, PAINT_RED), paint_off(file),
                           text);
        }
    }
    print_line(file, "g-sensitivity", gyro_g_text(g, text));
    print_line(file, "drift", gyro_drift_text(g, text));
    if (g->range > 0) {
        print_line(file, "temperature", gyro_thermal_text(g, text));
    }
    print_line(file, "limited by", gyro_limit_text(g, text));
}

void gyro_print(FILE *file, const calibrate_result *r)
{
    const gyro_fit *g = &r->gyro;
    char text[LINE_MAX + GYRO_TEXT_MAX];

    if (!g->has_readings) {
        return;
    }
    print_source(file, g);
    if (g->word) {
        snprintf(text, sizeof text, " %s%s%s.", g->reason, *g->remedy ? ". Next: " : "", g->remedy);
        fprintf(file, "%sGyroscope not calibrated:%s", paint_on(file, PAINT_RED), paint_off(file));
        wrapped_line(file, strlen("Gyroscope not calibrated:"), 0, text);
        fprintf(file, "\n");
        return;
    }
    print_figures(file, r);
    print_moves(file, r);
    if (r->is_joint) {
        wrapped_printf(file, 0,
                       "The accelerometer is calibrated from rests and moves together: the rests "
                       "alone leave parameters undetermined.");
    }
    if (g->imu.verdict == INVCAL_WEAK) {
        (void)gyro_fault(g, text);
    } else {
        snprintf(text, sizeof text, "%s", gyro_verdict(g));
    }
    print_line(file, "verdict", text);
    fprintf(file, "\n");
}

void gyro_print_last(FILE *file, const calibrate_result *r)
{
    const gyro_fit *g = &r->gyro;
    char text[GYRO_TEXT_MAX];

    if (g->word) {
        wrapped_printf(file, 0, "The gyroscope is %snot calibrated%s. Next, for it: %s.",
                       paint_on(file, PAINT_RED), paint_off(file), g->remedy);
    } else if (*gyro_fault(g, text)) {
        wrapped_printf(file, 0, "The gyroscope is %s.", text);
    }
}

/* ---- JSON --------------------------------------------------------------------------------------- */

static void write_moves(json_writer *w, const calibrate_result *r)
{
    const gyro_fit *g = &r->gyro;
    char why[GYRO_REASON_MAX];

    json_list(w, "moves");
    for (unsigned i = 0; i < g->moves; i++) {
        const gyro_move *m = &g->move[i];
        json_object(w, NULL);
        json_number(w, "from", g->rest[m->to - 1].position + 1.0);
        json_number(w, "to", g->rest[m->to].position + 1.0);
        json_number(w, "seconds", m->seconds);
        json_number(w, "angle", m->angle);
        json_number(w, "residual", m->residual);
        if (m->why != INVCAL_OK) {
            json_text(w, "left_out", gyro_move_reason(g, m, why));
        }
        json_object_end(w);
    }
    json_list_end(w);
}

static void write_g(json_writer *w, const calibrate_result *r)
{
    const gyro_fit *g = &r->gyro;
    double slope[2][3][3];
    double taken[3][3];

    for (unsigned i = 0; i < 9; i++) {
        const int is_known = g->imu.slope_sigma[i / 3][i % 3] > 0;
        slope[0][i / 3][i % 3] = is_known ? g->imu.slope[i / 3][i % 3] : NUMBER_UNKNOWN;
        slope[1][i / 3][i % 3] = is_known ? g->imu.slope_sigma[i / 3][i % 3] : NUMBER_UNKNOWN;
        taken[i / 3][i % 3] = g->g[i / 3][i % 3] / r->settings.field;
    }
    json_object(w, "g_sensitivity");
    json_text(w, "used", g->imu.g_is_used ? "yes" : "no");
    json_matrix(w, "value", (const double(*)[3])slope[0]);
    json_matrix(w, "sigma", (const double(*)[3])slope[1]);
    json_object_end(w);
    if (g->imu.g_is_used) {
        json_matrix(w, "g_correction", (const double(*)[3])taken);
    }
}

static void write_drift(json_writer *w, const gyro_fit *g)
{
    double drift[2][3];

    for (unsigned i = 0; i < 3; i++) {
        const int is_known = g->imu.slope_sigma[i][3] > 0;
        drift[0][i] = is_known ? g->imu.slope[i][3] : NUMBER_UNKNOWN;
        drift[1][i] = is_known ? g->imu.slope_sigma[i][3] : NUMBER_UNKNOWN;
    }
    json_vector(w, "drift", drift[0]);
    json_vector(w, "drift_sigma", drift[1]);
}

void gyro_json(json_writer *w, const calibrate_result *r)
{
    const gyro_fit *g = &r->gyro;
    double nine[2][3][3];
    char text[GYRO_LINE_MAX];

    if (!g->has_readings) {
        return;
    }
    json_object(w, "gyroscope");
    if (g->word) {
        json_text(w, "error", g->word);
        json_text(w, "reason", g->reason);
        json_text(w, "remedy", g->remedy);
        write_moves(w, r);
        json_object_end(w);
        return;
    }
    memcpy(nine[0], g->m, sizeof nine[0]);
    memcpy(nine[1], &g->imu.sigma[INVCAL_GYRO_XX], sizeof nine[1]);
    json_vector(w, "offset", g->calibration.offset);
    json_matrix(w, "matrix", g->calibration.matrix);
    json_text(w, "unit", g->is_counts ? "counts" : unit_angular_rate_words(g->rate_unit));
    json_text(w, "unit_from", unit_origin_name(g->rate_unit_from));
    json_number(w, "lsb", g->rate_unit);
    json_number(w, "rate", g->log->rate);
    json_number(w, "late", g->lag);
    json_matrix(w, "parameters", (const double(*)[3])nine[0]);
    json_matrix(w, "sigma", (const double(*)[3])nine[1]);
    json_number(w, "interval95", g->interval);
    json_number(w, "degrees_of_freedom", g->imu.dof);
    json_number(w, "residual_rms", g->imu.move_rms);
    json_number(w, "residual_max", g->imu.move_max);
    write_moves(w, r);
    write_g(w, r);
    write_drift(w, g);
    json_text(w, "limited_by", gyro_limit_text(g, text));
    if (g->range > 0) {
        json_vector(w, "temperature_slope", g->thermal);
        json_vector(w, "temperature_slope_sigma", g->thermal_sigma);
    }
    json_text(w, "verdict", gyro_verdict(g));
    json_names(w, "undetermined", g->imu.weak, INVCAL_IMU_PARAMETERS, invcal_parameter_text);
    json_text(w, "accelerometer", r->is_joint ? "rests and moves" : "rests");
    json_object_end(w);
}
