/* SPDX-License-Identifier: MIT
 *
 * The page of a program of turns: a work sheet, and the expected accuracy.
 */
#include <math.h>

#include "draw/box.h"
#include "draw/page.h"
#include "draw/svg.h"
#include "plan/facts.h"
#include "plan/turns.h"
#include "text/parameter.h"
#include "text/figure.h"

#define LABEL_HEIGHT 18.0 /* of a number above a box */
#define TEXT_MAX 1600

/* The largest sigma of some parameters, in units. */
static const char *largest_sigma(const turns_plan *p, unsigned bits, char text[TURNS_WORDS_MAX])
{
    char number[FIGURE_MAX];
    double max = 0;
    unsigned which = 0;

    for (unsigned i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        if (bits >> i & 1u && p->sigma[i] > max) {
            max = p->sigma[i];
            which = i;
        }
    }
    const display_unit unit = plan_unit(turns_kind(which), p->request.units);
    snprintf(text, TURNS_WORDS_MAX, "%s %s",
             figure_digits(unit.scale * p->request.noise * max, 3, number), unit.unit);
    return text;
}

#define OFFSETS 7u
#define SCALES (7u << 3)
#define ANGLES (7u << 6)
#define GYRO_SCALE (0x111u << INVCAL_GYRO_XX)
#define GYRO_ANGLES (0xEEu << INVCAL_GYRO_XX)

static void write_verdict(page *p, const turns_plan *plan)
{
    char sentence[TEXT_MAX];
    char next[TEXT_MAX];
    char list[TURNS_LIST_MAX];
    char words[TURNS_WORDS_MAX];
    char scale[TURNS_WORDS_MAX];
    char angles[TURNS_WORDS_MAX];

    snprintf(next, sizeof next, "turn on: %s.",
             turns_words(&plan->next, plan->step[plan->count - 1].turn.up, words));
    if (!plan->is_determined) {
        snprintf(sentence, sizeof sentence,
                 "%u turns determine %u of 18 parameters. Undetermined: %s.", plan->count,
                 plan->rank, parameter_list_imu(plan->open, list, sizeof list));
        page_verdict(p, PAGE_BAD, "✗ Undetermined", sentence, next);
        return;
    }
    if (plan->open) {
        snprintf(sentence, sizeof sentence, "The turns hardly determine %s.",
                 parameter_list_imu(plan->open, list, sizeof list));
        page_verdict(p, PAGE_BAD, "✗ Weak", sentence, next);
        return;
    }
    snprintf(
        sentence, sizeof sentence,
        "%u turns determine all 18 parameters: the scale of the gyroscope to %s, its angles to %s "
        "(one standard deviation).",
        plan->count, largest_sigma(plan, GYRO_SCALE, scale),
        largest_sigma(plan, GYRO_ANGLES, angles));
    page_verdict(p, PAGE_GOOD, "✓ Good", sentence, "turn the device as the work sheet says.");
}

static void write_figures(page *p, const turns_plan *plan)
{
    static const struct {
        unsigned bits;
        const char *what;
    } kinds[] = {{GYRO_SCALE, "scale of the gyroscope"},
                 {GYRO_ANGLES, "angles of the gyroscope"},
                 {OFFSETS, "offsets"},
                 {SCALES, "scale errors"},
                 {ANGLES, "angles"}};
    char text[TURNS_WORDS_MAX];

    page_figures_begin(p);
    for (unsigned i = 0; i < sizeof kinds / sizeof kinds[0] && plan->is_determined; i++) {
        page_figure(p, largest_sigma(plan, kinds[i].bits, text), kinds[i].what);
    }
    snprintf(text, sizeof text, "%u", plan->count);
    page_figure(p, text, "turns");
    page_figure(p, plan_time_text(plan->seconds, text), "total time");
    page_figures_end(p);
}

/* The orientation of the device in each rest. */
static void draw_boxes(FILE *file, const void *data, double width)
{
    const turns_plan *p = data;
    const unsigned columns = (unsigned)(width / BOX_WIDTH);
    const unsigned rows = (p->count + columns) / columns;
    const double height = BOX_HEIGHT + LABEL_HEIGHT;
    char number[16];

    svg_begin_inline(file, width, rows * height, "Orientation of the device",
                     "The device as a box in each rest, as in the words of the work sheet.");
    for (unsigned n = 0; n <= p->count; n++) {
        const double x = n % columns * BOX_WIDTH;
        const double y = (unsigned)(n / columns) * height;
        snprintf(number, sizeof number, "%u", n);
        svg_text(file, "ink heading", SVG_START, x, y + LABEL_HEIGHT, number);
        box_draw(file, x, y + LABEL_HEIGHT, n == 0 ? p->start : p->step[n - 1].turn.up);
    }
    svg_end(file);
}

static void write_sheet(page *p, const turns_plan *plan)
{
    static const char *const heading[] = {"no.", "done", "turn", "open", "improves"};
    static const page_table sheet = {
        "Turn: the shortest way, until this side is up. Open: parameters not determined yet.",
        heading, 5, 1u << 1 | 1u << 2 | 1u << 4};
    const invcal_real *up = plan->start;
    char side[TURNS_UP_MAX];

    page_section(p, "Work sheet");
    page_say(p,
             "Start with %s. Hold still for %.4g s, turn within %.4g s per quarter turn, and hold "
             "still again.",
             turns_up_words(up, side), plan->request.rest, plan->request.turn);
    page_wide_picture(p, "Orientation of the device, seen from the front: 0 is the start.",
                      draw_boxes, plan);
    page_table_begin(p, &sheet);
    for (unsigned i = 0; i < plan->count; i++) {
        const turns_step *step = &plan->step[i];
        char number[FIGURE_MAX];
        char open[FIGURE_MAX];
        char words[TURNS_WORDS_MAX];
        char improved[TURNS_LIST_MAX];
        snprintf(number, sizeof number, "%u", i + 1);
        snprintf(open, sizeof open, "%u", step->open);
        const char *const cells[] = {number, "☐", turns_words(&step->turn, up, words), open,
                                     parameter_list_imu(step->improves, improved, sizeof improved)};
        page_cells(p, &sheet, cells);
        up = step->turn.up;
    }
    page_table_end(p);
}

static void write_sigma(page *p, const turns_plan *plan)
{
    static const char *const heading[] = {"parameter", "σ, × noise", "σ"};
    static const page_table sheet = {
        "One standard deviation, over the noise of a position mean and in "
        "units.",
        heading, 3, 0};
    char text[2][TURNS_WORDS_MAX];
    char number[FIGURE_MAX];

    page_section(p, "Expected accuracy");
    page_table_begin(p, &sheet);
    for (unsigned i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        const char *const cells[] = {parameter_words_imu(i), text[0], text[1]};
        snprintf(text[0], sizeof text[0], "%s", figure_digits(plan->sigma[i], 4, number));
        largest_sigma(plan, 1u << i, text[1]);
        if (plan->open >> i & 1u) {
            page_bad_cells(p, &sheet, cells);
        } else {
            page_cells(p, &sheet, cells);
        }
    }
    page_table_end(p);
    page_note(p, "Gyro angle xy: what the x axis of the gyroscope reads of a turn about y.");
}

void turns_report(FILE *file, const turns_plan *plan, const char *command)
{
    const turns_request *r = &plan->request;
    const display_unit field = unit_style_field(r->units, 1);
    char title[TURNS_LIST_MAX];
    page p;

    snprintf(title, sizeof title, "Program of turns: %s", plan->program);
    page_begin(&p, file, title);
    write_verdict(&p, plan);
    write_figures(&p, plan);
    write_sheet(&p, plan);
    if (plan->is_determined) {
        write_sigma(&p, plan);
    }
    plan_report_origin(&p, command);
    page_fact(&p, "noise", "%.4g %s of a position mean", field.scale * r->noise, field.unit);
    page_fact(&p, "of the gyroscope", "%.4g °/s/√Hz, bias instability %.4g °/h",
              FIGURE_DEGREES * r->rate_noise, 3600 * FIGURE_DEGREES * r->instability);
    page_fact(&p, "rank", "%u of 18", plan->rank);
    if (plan->is_determined) {
        page_fact(&p, "condition", "%.4g", plan->condition);
    }
    page_facts_end(&p);
    page_end(&p);
}
