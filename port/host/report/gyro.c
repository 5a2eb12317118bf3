/* SPDX-License-Identifier: MIT
 *
 * The gyroscope: its calibration, the residual of each move, how its bias changes.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/chart.h"
#include "maths/matrix.h"
#include "report/facts.h"
#include "result/gyro.h"
#include "text/constant.h"
#include "text/number.h"

#define CELL 64
#define LEFT 68.0
#define RIGHT 14.0
#define TOP 48.0
#define PLOT 170.0
#define AXIS 40.0
#define MILLI 1e3

/* ---- figures ------------------------------------------------------------------------------------ */

static void add_row(page *p, const page_table *sheet, const char *name, double x, double spread,
                    figure_sign sign, const char *unit)
{
    char number[FIGURE_MAX];
    const char *const cells[] = {name, figure_with_sigma(x, spread, sign, number), unit};

    page_cells(p, sheet, cells);
}

static void write_parameters(page *p, const report_facts *f)
{
    static const char *const titles[] = {"parameter", "value ±", "unit"};
    static const char *const axes[] = {"x", "y", "z"};
    const page_table sheet = {"Scale errors, and cross-axis terms (what the first axis reads of "
                              "turns about the second), in the axes of the accelerometer.",
                              titles, 3, 4};
    const gyro_fit *g = &f->result->gyro;
    const display_unit scale = unit_style_scale(f->result->units);
    const display_unit angle = unit_style_angle(f->result->units);
    invcal_calibration m = {.offset = {0}};
    double inverse[3][3];
    char name[CELL];

    memcpy(m.matrix, g->m, sizeof m.matrix);
    (void)matrix_inverse(&m, inverse); /* close to a unit matrix */
    page_table_begin(p, &sheet);
    for (unsigned i = 0; i < 9; i++) {
        const unsigned r = i < 3 ? i : (i - 3) / 2;
        const unsigned c = i < 3 ? i : ((i - 3) % 2 + ((i - 3) % 2 >= r));
        const double spread = g->interval * g->imu.sigma[INVCAL_GYRO_XX + 3 * r + c];
        const display_unit unit = i < 3 ? scale : angle;
        snprintf(name, sizeof name, i < 3 ? "scale error %s" : "cross %s%s", axes[r], axes[c]);
        if (i < 3 && g->is_counts) {
            const double counts = UNIT_DEGREE / g->rate_unit * inverse[r][r];
            snprintf(name, sizeof name, "scale %s", axes[r]);
            add_row(p, &sheet, name, counts, counts * spread, FIGURE_PLAIN, "counts per °/s");
        } else {
            add_row(p, &sheet, name, unit.scale * (inverse[r][c] - (r == c)), unit.scale * spread,
                    FIGURE_SIGNED, unit.unit);
        }
    }
    page_table_end(p);
}

static void write_figures(page *p, const gyro_fit *g)
{
    char text[CELL];
    char number[FIGURE_MAX];

    page_figures_begin(p);
    snprintf(text, sizeof text, "%s mrad", figure_digits(MILLI * g->imu.move_rms, 3, number));
    page_figure(p, text, "rms residual of a move on an axis");
    snprintf(text, sizeof text, "%u", g->imu.moves);
    page_figure(p, text, "moves used");
    snprintf(text, sizeof text, "%u", g->moves - g->imu.moves);
    page_figure(p, text, "left out");
    page_figures_end(p);
}

/* ---- moves -------------------------------------------------------------------------------------- */

static double largest_residual(const gyro_fit *g)
{
    double max = 0;

    for (unsigned i = 0; i < g->moves; i++) {
        max = g->move[i].why == INVCAL_OK ? fmax(max, g->move[i].residual) : max;
    }
    return MILLI * max;
}

static void draw_moves(FILE *file, const void *data, double width)
{
    const report_facts *f = data;
    const gyro_fit *g = &f->result->gyro;
    const double step = (width - LEFT - RIGHT) / g->moves;
    const ruler x = {0, 1, LEFT, width - RIGHT, 0, 0};
    const ruler y =
        chart_ruler(0, largest_residual(g) > 0 ? largest_residual(g) : 1, TOP + PLOT, TOP, 5);
    double taken = 0;

    svg_begin_inline(file, width, TOP + PLOT + AXIS, "Residuals of the moves",
                     "Difference between the up directions before and after each move, the latter "
                     "rotated back by the calibrated gyroscope, in mrad.");
    svg_text(file, "ink heading", SVG_START, 0, 14, "residual of each move, mrad");
    chart_ticks_y(file, &y, &x);
    svg_rectangle(file, "c1 bar", LEFT, 22, 16, 12);
    svg_text(file, "ink small", SVG_START, LEFT + 22, 32, "used");
    svg_marker(file, "c2 full", SVG_CROSS, LEFT + 96, 28, 4.5);
    svg_text(file, "ink small", SVG_START, LEFT + 106, 32, "left out");
    for (unsigned i = 0; i < g->moves; i++) {
        const gyro_move *m = &g->move[i];
        const double middle = LEFT + (i + 0.5) * step;
        char text[16];
        if (m->why == INVCAL_OK && isfinite(m->residual)) {
            const double top = chart_pixel(&y, MILLI * m->residual);
            svg_rectangle(file, "c1 bar", middle - 0.35 * step, top, 0.7 * step, TOP + PLOT - top);
        } else {
            svg_marker(file, "c2 full", SVG_CROSS, middle, TOP + PLOT - 7, 4.5);
        }
        snprintf(text, sizeof text, "%u", g->rest[m->to].position + 1);
        if (middle - 10 > taken) {
            svg_text(file, "soft small", SVG_MIDDLE, middle, TOP + PLOT + 15, text);
            taken = middle + 10;
        }
    }
    svg_text(file, "soft small", SVG_MIDDLE, (LEFT + width - RIGHT) / 2, TOP + PLOT + AXIS - 6,
             "position at the end of the move");
    svg_end(file);
}

/* ---- bias --------------------------------------------------------------------------------------- */

/* Bias of a rest minus that of the last one, degrees/s; is_level: without g-sensitivity. */
static double bias_of(const gyro_fit *g, unsigned i, unsigned axis, int is_level)
{
    const gyro_rest *last = &g->rest[g->rests - 1];
    double x = g->rest[i].bias[axis] - last->bias[axis];

    for (unsigned k = 0; k < 3 && is_level; k++) {
        x -= g->imu.slope[axis][k] * (g->rest[i].up[k] - last->up[k]);
    }
    return x / UNIT_DEGREE;
}

/* The horizontal axis: temperature, or time. */
static double abscissa(const report_facts *f, unsigned i)
{
    const position_origin *o = &f->result->data->origin[f->result->gyro.rest[i].position];

    return f->result->data->has_temperature ? o->temperature : (o->begin + o->end) / 2;
}

static void draw_bias(FILE *file, const void *data, double width)
{
    static const svg_shape shapes[] = {SVG_CIRCLE, SVG_SQUARE, SVG_TRIANGLE};
    static const char *const styles[] = {"c1 full", "c2 full", "c3 full"};
    static const char *const axes[] = {"x", "y", "z"};
    const report_facts *f = data;
    const gyro_fit *g = &f->result->gyro;
    const int is_level = g->imu.g_is_used;
    double range[2][2] = {{HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, -HUGE_VAL}};

    for (unsigned i = 0; i < 3 * g->rests; i++) {
        const double at[2] = {abscissa(f, i / 3), bias_of(g, i / 3, i % 3, is_level)};
        for (unsigned k = 0; k < 2 && isfinite(at[0] + at[1]); k++) {
            range[k][0] = fmin(range[k][0], at[k]);
            range[k][1] = fmax(range[k][1], at[k]);
        }
    }
    if (!(range[0][0] <= range[0][1])) {
        return;
    }
    const ruler x =
        chart_ruler(range[0][0], range[0][1], LEFT, width - RIGHT, width > PAGE_NARROW ? 10 : 5);
    const ruler y = chart_ruler(range[1][0], range[1][1], TOP + PLOT, TOP, 5);
    svg_begin_inline(
        file, width, TOP + PLOT + AXIS, "Bias in the rests",
        "The bias about each axis in each rest, relative to the last rest, in degrees/s.");
    svg_text(file, "ink heading", SVG_START, 0, 14, "bias relative to the last rest, °/s");
    chart_ticks_x(file, &x, &y);
    chart_ticks_y(file, &y, &x);
    for (unsigned k = 0; k < 3; k++) {
        svg_marker(file, styles[k], shapes[k], LEFT + 8 + 60 * k, 28, 4.5);
        svg_text(file, "ink small", SVG_START, LEFT + 18 + 60 * k, 32, axes[k]);
        for (unsigned i = 0; i < g->rests; i++) {
            const double at = abscissa(f, i);
            const double value = bias_of(g, i, k, is_level);
            if (isfinite(at + value)) {
                svg_marker(file, styles[k], shapes[k], chart_pixel(&x, at), chart_pixel(&y, value),
                           4);
            }
        }
    }
    svg_text(file, "soft small", SVG_MIDDLE, (LEFT + width - RIGHT) / 2, TOP + PLOT + AXIS - 6,
             f->result->data->has_temperature ? "temperature, °C"
                                              : "time from the first sample, s");
    svg_end(file);
}

/* The effect of orientation on the bias. */
static void write_g(page *p, const gyro_fit *g)
{
    static const char *const titles[] = {"°/s per g", "along x", "along y", "along z"};
    static const char *const axes[] = {"about x", "about y", "about z"};
    const page_table sheet = {"The bias against orientation (g-sensitivity).", titles, 4, 0};

    page_table_begin(p, &sheet);
    for (unsigned i = 0; i < 3; i++) {
        char text[3][FIGURE_MAX];
        const char *const cells[] = {axes[i], text[0], text[1], text[2]};
        for (unsigned k = 0; k < 3; k++) {
            figure_with_sigma(g->imu.slope[i][k] / UNIT_DEGREE,
                              g->interval * g->imu.slope_sigma[i][k] / UNIT_DEGREE, FIGURE_SIGNED,
                              text[k]);
        }
        page_cells(p, &sheet, cells);
    }
    page_table_end(p);
}

/* ---- the section -------------------------------------------------------------------------------- */

static void write_moves(page *p, const report_facts *f)
{
    const gyro_fit *g = &f->result->gyro;
    char text[GYRO_LINE_MAX];

    for (unsigned i = 0; i < g->moves; i++) {
        if (*gyro_left_out(f->result, i, text)) {
            page_say(p, "Left out: %s.", text);
        }
    }
    page_picture(p,
                 "The gyroscope must turn the up direction of one rest into that of the next; this "
                 "is the residual, perpendicular to it.",
                 draw_moves, f);
    page_picture(p,
                 g->imu.g_is_used ? "Its bias in the rests, g-sensitivity removed."
                                  : "Its bias in the rests.",
                 draw_bias, f);
}

static void write_constant(page *p, const calibrate_result *r)
{
    const gyro_fit *g = &r->gyro;
    const invcal_calibration *c = &g->calibration;
    double taken[3][3];

    for (unsigned i = 0; i < 9; i++) {
        taken[i / 3][i % 3] = g->g[i / 3][i % 3] / r->settings.field;
    }

    page_say(p, "As a constant, for invcal_apply(&calibration_gyro, raw[0], raw[1], raw[2], rate), "
                "rad/s; invcal "
                "export writes both:");
    if (constant_fits(c->offset, (const double(*)[3])c->matrix)) {
        page_code_begin(p);
        constant_write(p->file, "calibration_gyro", c->offset, (const double(*)[3])c->matrix);
        page_code_end(p);
    }
    if (g->imu.g_is_used) {
        page_say(p, "Then subtract its g-sensitivity: rate[i] -= the sum over j of "
                    "calibration_gyro_g[i][j] calibrated[j].");
        page_code_begin(p);
        constant_write_matrix(p->file, "calibration_gyro_g", (const double(*)[3])taken);
        page_code_end(p);
    }
}

void report_gyro_summary(page *p, const report_facts *f)
{
    const gyro_fit *g = &f->result->gyro;
    char number[FIGURE_MAX];

    if (g->has_readings && g->word) {
        page_say(p, "The gyroscope is not calibrated: %s.", g->reason);
    } else if (g->has_readings) {
        page_say(p, "The gyroscope is calibrated, too (%s): %u moves, residual %s mrad rms.",
                 gyro_verdict(g), g->imu.moves, figure_digits(MILLI * g->imu.move_rms, 2, number));
    }
}

void report_gyro(page *p, const report_facts *f)
{
    const gyro_fit *g = &f->result->gyro;
    char text[GYRO_LINE_MAX];

    if (!g->has_readings) {
        return;
    }
    page_section(p, "The gyroscope");
    if (g->word) {
        page_say(p, "Not calibrated: %s.", g->reason);
        page_say(p, "Next: %s.", g->remedy);
        return;
    }
    page_say(p, "Verdict: %s.%s Limited by: %s.", gyro_verdict(g),
             f->result->is_joint ? " The accelerometer is calibrated from rests and moves "
                                   "together: the rests alone leave parameters undetermined."
                                 : "",
             gyro_limit_text(g, text));
    if (fabs(g->lag) > 0) {
        page_say(p, "Its readings are %.2f s %s than the accelerometer's, which is corrected here.",
                 fabs(g->lag), g->lag > 0 ? "later" : "earlier");
    }
    write_figures(p, g);
    write_parameters(p, f);
    write_moves(p, f);
    if (g->imu.slope_sigma[0][0] > 0) {
        write_g(p, g);
    }
    page_facts_begin(p);
    if (g->log->file) {
        page_fact(p, "file", "%s", g->log->file);
    }
    page_fact(p, "readings", "in %s, %.6g per second%s", gyro_unit_text(g, text), g->log->rate,
              g->log->is_rate_known ? "" : " (a guess: its error is an error of the scales)");
    page_fact(p, "g-sensitivity", "%s", gyro_g_text(g, text));
    page_fact(p, "drift", "%s", gyro_drift_text(g, text));
    if (g->range > 0) {
        page_fact(p, "temperature", "%s, one standard deviation", gyro_thermal_text(g, text));
    }
    page_fact(p, "degrees of freedom", "%u", g->imu.dof);
    page_facts_end(p);
    write_constant(p, f->result);
}
