/* SPDX-License-Identifier: MIT
 *
 * The work sheet: the positions in order, to be ticked off.
 */
#include <math.h>

#include "draw/box.h"
#include "invcal/plan.h"
#include "draw/svg.h"
#include "maths/angles.h"
#include "plan/facts.h"

#define COLUMNS 9u        /* the last one only if positions are not held equally long */
#define UNFOLDED_MAX 100u /* a table of more positions is folded */
#define CHECKBOX "☐"
#define LABEL_HEIGHT 12.0 /* height of a number above a box */

/* Elapsed time: "2:55", "1:04:00"; with tenths if dwell or move have fractions. */
static void elapsed_text(double seconds, int has_tenths, char text[PLAN_WORDS_MAX])
{
    const unsigned long long tenths = (unsigned long long)(10 * seconds + 0.5);
    const unsigned long long whole = tenths / 10;
    char minutes[PLAN_WORDS_MAX / 2];
    char fraction[8] = "";

    if (whole < 3600) {
        snprintf(minutes, sizeof minutes, "%llu", whole / 60);
    } else {
        snprintf(minutes, sizeof minutes, "%llu:%02llu", whole / 3600, whole / 60 % 60);
    }
    if (has_tenths) {
        snprintf(fraction, sizeof fraction, ".%llu", tenths % 10);
    }
    snprintf(text, PLAN_WORDS_MAX, "%s:%02llu%s", minutes, whole % 60, fraction);
}

static int has_fraction(double x)
{
    return fabs(x - nearbyint(x)) > 0;
}

/* "α +60°, β +90°", to 0.01 degrees, since the exact angles are next to it. */
static void turn_text(const design_position *from, const design_position *to,
                      char text[PLAN_WORDS_MAX])
{
    const double change[2] = {angles_turn(from->alpha, to->alpha),
                              angles_turn(from->beta, to->beta)};
    int length = 0;

    snprintf(text, PLAN_WORDS_MAX, "none");
    for (unsigned i = 0; i < 2; i++) {
        char angle[PLAN_WORDS_MAX];
        plan_angle_text(nearbyint(100 * change[i]) / 100, angle);
        if (fabs(change[i]) >= 0.005) {
            length += snprintf(text + length, PLAN_WORDS_MAX - (size_t)length, "%s%s %s%.20s°",
                               length > 0 ? ", " : "", i == 0 ? "α" : "β", change[i] > 0 ? "+" : "",
                               angle);
        }
    }
}

/* The angle between two directions. */
static void free_turn(const double from[3], const double to[3], char text[PLAN_WORDS_MAX])
{
    const double sine =
        hypot(hypot(from[1] * to[2] - from[2] * to[1], from[2] * to[0] - from[0] * to[2]),
              from[0] * to[1] - from[1] * to[0]);
    const double cosine = from[0] * to[0] + from[1] * to[1] + from[2] * to[2];

    snprintf(text, PLAN_WORDS_MAX, "%.0f°", FIGURE_DEGREES * atan2(sine, cosine));
}

/* alpha, beta, turn, up in words, group. */
static void stand_cells(const design *d, unsigned n, char (*text)[PLAN_WORDS_MAX])
{
    const design_position *at = &d->position[n];

    plan_angle_text(at->alpha, text[0]);
    plan_angle_text(at->beta, text[1]);
    snprintf(text[2], PLAN_WORDS_MAX, "start");
    if (n > 0) {
        turn_text(at - 1, at, text[2]);
    }
    invcal_direction_text(at->vertical, text[3]);
    snprintf(text[4], PLAN_WORDS_MAX, "%s", "");
    if (at->group > 0) {
        snprintf(text[4], PLAN_WORDS_MAX, "%u", at->group);
    }
}

/* Turn, up in words and as x y z. */
static void free_cells(const design *d, unsigned n, char (*text)[PLAN_WORDS_MAX])
{
    const double *up = d->position[n].vertical;

    snprintf(text[0], PLAN_WORDS_MAX, "start");
    if (n > 0) {
        free_turn(d->position[n - 1].vertical, up, text[0]);
    }
    invcal_direction_text(up, text[1]);
    for (unsigned i = 0; i < 3; i++) {
        char number[FIGURE_MAX];
        snprintf(text[2 + i], PLAN_WORDS_MAX, "%s", figure_fixed(up[i], 3, FIGURE_SIGNED, number));
    }
}

static void write_row(page *p, const page_table *sheet, const plan_facts *f, unsigned n)
{
    const design_cost *cost = &f->request->cost;
    char text[COLUMNS][PLAN_WORDS_MAX];
    const char *cells[COLUMNS];
    const double dwell = f->set->position[n].share * cost->dwell;

    snprintf(text[0], PLAN_WORDS_MAX, "%u", n + 1);
    snprintf(text[1], PLAN_WORDS_MAX, CHECKBOX);
    elapsed_text(design_begins(f->set, n, cost),
                 has_fraction(cost->settle + cost->dwell) || has_fraction(cost->move) ||
                     has_fraction(cost->warm_up),
                 text[2]);
    plan_time_text(cost->settle + dwell, text[COLUMNS - 1]);
    if (f->set->is_stand) {
        stand_cells(f->set, n, &text[3]);
    } else {
        free_cells(f->set, n, &text[3]);
    }
    for (unsigned i = 0; i < COLUMNS; i++) {
        cells[i] = text[i];
    }
    page_cells(p, sheet, cells);
}

/* The orientation of the device in each position, in the order of the sheet. */
static void draw_boxes(FILE *file, const void *data, double width)
{
    const design *d = data;
    const unsigned columns = (unsigned)(width / BOX_WIDTH);
    const unsigned rows = (d->count + columns - 1) / columns;
    const double height = BOX_HEIGHT + LABEL_HEIGHT;
    char number[16];

    svg_begin_inline(file, width, rows * height, "Orientation of the device",
                     "The device as a box in each position, as in the words of the work sheet.");
    for (unsigned n = 0; n < d->count; n++) {
        const unsigned row = n / columns;
        const double x = n % columns * BOX_WIDTH;
        const double y = row * height;
        snprintf(number, sizeof number, "%u", n + 1);
        svg_text(file, "ink heading", SVG_START, x, y + LABEL_HEIGHT, number);
        box_draw(file, x, y + LABEL_HEIGHT, d->position[n].vertical);
    }
    svg_end(file);
}

/* For a stand, with its angles, or by hand. */
static page_table begin_sheet(const plan_facts *f)
{
    static const char *const stand[COLUMNS] = {"no.",  "done", "begins", "α, °", "β, °",
                                               "turn", "up",   "group",  "stay"};
    static const char *const by_hand[COLUMNS] = {"no.", "done", "begins", "turn", "up",
                                                 "x",   "y",    "z",      "stay"};
    const unsigned columns = f->set->has_shares ? COLUMNS : COLUMNS - 1;

    return f->set->is_stand
               ? (page_table){"α: outer axis of the stand, β: inner axis. Turn: from the position "
                              "before. Begins: elapsed time.",
                              stand, columns, 1u << 1 | 1u << 5 | 1u << 6}
               : (page_table){"Up: where up points, in words and in the frame of the device. Turn: "
                              "from the position before. Begins: elapsed time.",
                              by_hand, columns, 1u << 1 | 1u << 4};
}

void plan_report_sheet(page *p, const plan_facts *f)
{
    char text[PLAN_WORDS_MAX];
    const page_table sheet = begin_sheet(f);

    page_section(p, "Work sheet");
    if (f->request->cost.warm_up > 0) {
        page_say(p, "Switch on, and let the sensor warm up for %s.",
                 plan_time_text(f->request->cost.warm_up, text));
    }
    page_say(p, "Hold still for %s in each position%s.",
             plan_time_text(f->request->cost.settle + f->request->cost.dwell, text),
             f->set->has_shares ? " on average; see the last column" : "");
    if (f->set->count <= UNFOLDED_MAX) {
        page_wide_picture(
            p,
            "Orientation of the device, seen from the front: z is its upper side when it "
            "lies flat, x points right and y away from you.",
            draw_boxes, f->set);
    }
    snprintf(text, sizeof text, "All %u positions", f->set->count);
    page_fold_begin(p, text, f->set->count <= UNFOLDED_MAX);
    page_table_begin(p, &sheet);
    for (unsigned n = 0; n < f->set->count; n++) {
        write_row(p, &sheet, f, n);
    }
    page_table_end(p);
    page_fold_end(p);
}
