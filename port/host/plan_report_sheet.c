/* SPDX-License-Identifier: MIT
 *
 * The work sheet: position after position, to be followed and ticked off.
 */
#include <math.h>

#include "plan_facts.h"

#define COLUMNS 8u
#define OPEN 100u /* up to here the sheet is unfolded */
#define BOX "☐"

/* Time on a clock: "2:55", "1:04:00"; with tenths where dwell or move have fractions. */
static void clock_text(double seconds, int has_tenths, char text[PLAN_WORDS_MAX])
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

/* The shorter way round, above -180 to 180 degrees. */
static double turn(double from, double to)
{
    const double change = fmod(to - from, 360);

    return change > 180 ? change - 360 : change <= -180 ? change + 360 : change;
}

/* "α +60°, β +90°" */
static void stand_turn(const design_position *from, const design_position *to,
                       char text[PLAN_WORDS_MAX])
{
    const double change[2] = {turn(from->alpha, to->alpha), turn(from->beta, to->beta)};
    int length = 0;

    text[0] = '\0';
    for (unsigned i = 0; i < 2; i++) {
        char angle[PLAN_WORDS_MAX];
        plan_angle_text(change[i], angle);
        if (fabs(change[i]) >= 0.0005) {
            length += snprintf(text + length, PLAN_WORDS_MAX - (size_t)length, "%s%s %s%.20s°",
                               length > 0 ? ", " : "", i == 0 ? "α" : "β", change[i] > 0 ? "+" : "",
                               angle);
        }
    }
    if (length == 0) {
        snprintf(text, PLAN_WORDS_MAX, "none");
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

/* What the stand shows: group, alpha, beta. */
static unsigned stand_cells(const design_position *at, char (*text)[PLAN_WORDS_MAX])
{
    snprintf(text[0], PLAN_WORDS_MAX, "%u", at->group);
    plan_angle_text(at->alpha, text[1]);
    plan_angle_text(at->beta, text[2]);
    return 3;
}

/* Up: x y z. */
static unsigned free_cells(const design_position *at, char (*text)[PLAN_WORDS_MAX])
{
    for (unsigned i = 0; i < 3; i++) {
        char number[FIGURE_MAX];
        snprintf(text[i], PLAN_WORDS_MAX, "%s",
                 figure_fixed(at->vertical[i], 3, FIGURE_SIGNED, number));
    }
    return 3;
}

static void write_row(page *p, const page_table *sheet, const plan_facts *f, unsigned n)
{
    const design_cost *cost = &f->request->cost;
    const design_position *at = &f->set->position[n];
    const int is_stand = f->set->plan.per_group > 0;
    char text[COLUMNS][PLAN_WORDS_MAX];
    const char *cells[COLUMNS];
    unsigned k = 0;

    snprintf(text[k++], PLAN_WORDS_MAX, "%u", n + 1);
    snprintf(text[k++], PLAN_WORDS_MAX, BOX);
    clock_text(n * (cost->dwell + cost->move),
               has_fraction(cost->dwell) || has_fraction(cost->move), text[k++]);
    k += is_stand ? stand_cells(at, &text[k]) : free_cells(at, &text[k]);
    if (n == 0) {
        snprintf(text[k], PLAN_WORDS_MAX, "start");
    } else if (is_stand) {
        stand_turn(at - 1, at, text[k]);
    } else {
        free_turn(at[-1].vertical, at->vertical, text[k]);
    }
    invcal_guidance_words(at->vertical, text[k + 1]);
    for (unsigned i = 0; i < COLUMNS; i++) {
        cells[i] = text[i];
    }
    page_cells(p, sheet, cells);
}

void plan_report_sheet(page *p, const plan_facts *f)
{
    static const char *const stand[COLUMNS] = {"no.",  "done", "begins", "group",
                                               "α, °", "β, °", "turn",   "up, in the hand"};
    static const char *const by_hand[COLUMNS] = {"no.", "done", "begins", "x",
                                                 "y",   "z",    "turn",   "up, in the hand"};
    const int is_stand = f->set->plan.per_group > 0;
    char caption[4 * PLAN_WORDS_MAX];
    char summary[PLAN_WORDS_MAX];
    char dwell[PLAN_WORDS_MAX];
    const page_table sheet = {caption, is_stand ? stand : by_hand, COLUMNS,
                              1u << 1 | 1u << 6 | 1u << 7};

    snprintf(caption, sizeof caption,
             "Hold still for %s from the time at which a position begins (minutes and seconds "
             "from the first). %s Turn: %s.",
             plan_time_text(f->request->cost.dwell, dwell),
             is_stand ? "α: outer axis of the stand, β: inner axis."
                      : "x y z: where up points in the frame of the device.",
             is_stand ? "from the position before" : "angle from the position before");
    snprintf(summary, sizeof summary, "All %u positions%s", f->set->count,
             f->set->count > OPEN ? " (unfold before printing)" : "");
    page_section(p, "Work sheet");
    page_fold_begin(p, summary, f->set->count <= OPEN);
    page_table_begin(p, &sheet);
    for (unsigned n = 0; n < f->set->count; n++) {
        write_row(p, &sheet, f, n);
    }
    page_table_end(p);
    page_fold_end(p);
}
