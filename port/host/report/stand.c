/* SPDX-License-Identifier: MIT
 *
 * Results from the angles of a stand: their convention, the mounting of the unit, the parameters by
 * J1, and the paper's series with its closures.
 */
#include <math.h>
#include <string.h>

#include "design/parameters.h"
#include "invcal/plan.h"
#include "report/facts.h"
#include "stand/output.h"

#define CELL 160
#define MILLIONTHS 1e6

enum { GROUPS = INVCAL_PLAN_GROUPS };

/* ---- convention ---------------------------------------------------------------------------------- */

/* "α = alpha", "β = -(beta - 20°)". */
static const char *angle_formula(const stand *s, unsigned i, char text[CELL])
{
    static const char *const symbols[] = {"α", "β"};
    static const char *const headings[] = {"alpha", "beta"};
    const char *sign = s->sense[i] < 0 ? "-" : "";

    if (fabs(s->zero[i]) > 0) {
        snprintf(text, CELL, "%s = %s(%s %s %.6g°)", symbols[i], sign, headings[i],
                 s->zero[i] < 0 ? "+" : "-", fabs(s->zero[i]));
    } else {
        snprintf(text, CELL, "%s = %s%s", symbols[i], sign, headings[i]);
    }
    return text;
}

static void write_convention(page *p, const stand *s)
{
    char text[2][CELL];

    if (strcmp(s->from, "columns") == 0) {
        page_say(p,
                 "%u positions with angles, in degrees: %s, %s, where alpha and beta are the "
                 "columns as the stand shows them.",
                 s->count, angle_formula(s, 0, text[0]), angle_formula(s, 1, text[1]));
    } else {
        page_say(p, "%u positions with angles: those of the program %s, in its order.", s->count,
                 s->from);
    }
    if (s->without_angles > 0) {
        page_say(p, "%u more have no angles, or angles that changed.", s->without_angles);
    }
    page_picture(p,
                 "The unit on the two axes of the stand (the paper's Fig. 1) at α = 0, β = 0, and "
                 "in three poses. Orange: the senses in which the unit turns as α and β increase. "
                 "They are derived from the paper's Table 2, since its Fig. 1 shows none: up is "
                 "(sin α sin β, cos α, sin α cos β) in the axes of the unit.",
                 report_stand_figure, NULL);
}

/* ---- mounting ------------------------------------------------------------------------------------ */

static void write_missets(page *p, const stand *s)
{
    char text[STAND_TEXT_MAX];

    for (unsigned i = 0; i < s->missets; i++) {
        page_say(p, "%s", stand_misset_text(s, &s->misset[i], text));
    }
    if (s->missets > 0) {
        page_say(p, "%s", STAND_MISSET_NOTE);
    } else {
        page_say(p, "No position is misset.");
    }
}

static void write_mounting(page *p, const report_facts *f)
{
    static const char *const axes[] = {"about x", "about y", "about z"};
    static const char *const titles[] = {"mounting", "angle"};
    const mounting *m = &f->result->stand.mounting;
    const display_unit unit = report_unit(f, 2);
    const page_table sheet = {
        "Mounting of the unit on the stand: a rotation that lengths cannot show.", titles, 2, 0};

    page_table_begin(p, &sheet);
    for (unsigned i = 0; i < 3; i++) {
        char number[FIGURE_MAX];
        char text[CELL];
        const char *const cells[] = {axes[i], text};
        snprintf(text, sizeof text, "%s %s",
                 figure_with_sigma(unit.scale * m->angle[i],
                                   unit.scale * stand_coverage(m->dof) * m->sigma[i], FIGURE_SIGNED,
                                   number),
                 unit.unit);
        page_cells(p, &sheet, cells);
    }
    page_table_end(p);
    if (m->scatter >= 0) {
        page_note(p,
                  "Readings and angles agree within %.3g mrad about each axis perpendicular to the "
                  "direction.",
                  1e3 * m->scatter);
    }
    if (*stand_large_angle_text(m)) {
        page_say(p, "%s", stand_large_angle_text(m));
    }
}

/* ---- by J1 --------------------------------------------------------------------------------------- */

static void write_vertical_row(page *p, const page_table *sheet, const report_facts *f, unsigned r)
{
    const stand_vertical *v = &f->result->stand.vertical;
    const display_unit unit = report_unit(f, r / 3);
    const double x = unit.scale * f->result->solution.x[r];
    const double difference = unit.scale * (v->x[r] - f->result->solution.x[r]);
    const double sigma = unit.scale * v->sigma[r];
    const double spread = stand_coverage(v->dof) * sigma;
    const int places = figure_places(unit.scale * v->x[r], spread);
    char by_j1[CELL];
    char number[4][FIGURE_MAX];
    const int is_known = nominal_knows(&f->result->nominal, r);
    const char *const cells[] = {
        parameter_words(r), is_known ? by_j1 : "",
        is_known ? figure_fixed(x, places, FIGURE_SIGNED, number[1]) : "",
        figure_fixed(difference, places + 2, FIGURE_SIGNED, number[2]),
        sigma > 0 ? figure_fixed(difference / sigma, 3, FIGURE_SIGNED, number[3]) : ""};

    snprintf(by_j1, sizeof by_j1, "%s %s",
             figure_with_sigma(unit.scale * v->x[r], spread, FIGURE_SIGNED, number[0]), unit.unit);
    page_cells(p, sheet, cells);
}

static void write_vertical(page *p, const report_facts *f)
{
    static const char *const titles[] = {"parameter", "by J1", "by lengths", "difference",
                                         "over σ"};
    const page_table sheet = {
        "The parameters from the vertical composition J1, which uses the directions, and from the "
        "lengths (the exact row), which do not. σ: standard deviation of J1.",
        titles, 5, 0};

    if (!f->result->stand.vertical.is_known) {
        page_say(p, "J1: these directions leave parameters undetermined.");
        return;
    }
    page_table_begin(p, &sheet);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        write_vertical_row(p, &sheet, f, r);
    }
    page_table_end(p);
    page_note(
        p, "Both use the same readings, with the same noise: a difference comes from the angles%s.",
        f->result->stand.missets > 0 ? ", or from a position that J1 leaves out" : "");
}

/* ---- the paper's series -------------------------------------------------------------------------- */

static void write_group(page *p, const page_table *sheet, const group_series *s, unsigned g)
{
    static const char *const meaning[GROUPS][SERIES_TERMS] = {
        {"(δk_y + δk_z)/2", "Δ_y", "Δ_z", "(δk_y - δk_z)/2", "γ_zy/2"},
        {"(δk_z + δk_x)/2", "-Δ_z", "-Δ_x", "(δk_z - δk_x)/2", "γ_xz/2"},
        {"(δk_y + δk_x)/2", "Δ_y", "Δ_x", "(δk_y - δk_x)/2", "γ_xy/2"}};
    char name[CELL];
    char text[SERIES_TERMS][FIGURE_MAX];
    const char *is[1 + SERIES_TERMS] = {name};
    const char *stands_for[1 + SERIES_TERMS] = {"stands for"};

    snprintf(name, sizeof name, "%u, %u positions", g + 1, s->count[g]);
    for (unsigned t = 0; t < SERIES_TERMS; t++) {
        is[1 + t] = s->is_determined[g] ? figure_with_sigma(MILLIONTHS * s->coefficient[g][t],
                                                            stand_series_coverage(s) * MILLIONTHS *
                                                                s->noise * s->root[g][t],
                                                            FIGURE_SIGNED, text[t])
                                        : "open";
        stands_for[1 + t] = meaning[g][t];
    }
    page_cells(p, sheet, is);
    page_cells(p, sheet, stands_for);
}

/* The coefficients are combinations of deviations from nominal. */
static void write_coefficients(page *p, const group_series *s)
{
    static const char *const titles[] = {"group", "a0", "a1", "b1", "a2", "b2"};
    const page_table sheet = {
        "The paper's series of J1 in each group, a0 + a1 cos θ + b1 sin θ + a2 cos 2θ + b2 sin 2θ, "
        "from the measurement. Millionths: µg, ppm, µrad.",
        titles, 6, 0};

    page_table_begin(p, &sheet);
    for (unsigned g = 0; g < GROUPS; g++) {
        write_group(p, &sheet, s, g);
    }
    page_table_end(p);
}

static void write_series(page *p, const report_facts *f)
{
    const group_series *s = &f->result->stand.series;

    if (f->has_before) {
        write_coefficients(p, s);
    }
    for (unsigned g = 0; g < GROUPS; g++) {
        if (!s->is_determined[g]) {
            page_say(p, "Group %u is %s: %u positions do not determine its five coefficients.",
                     g + 1, s->count[g] == 0 ? "missing" : "incomplete", s->count[g]);
        }
    }
}

static void write_closure_row(page *p, const page_table *sheet, const report_facts *f, unsigned r)
{
    static const char *const groups[] = {"2 and 3", "1 and 3", "1 and 2"};
    static const char *const only[] = {"3", "2", "1"};
    const group_series *s = &f->result->stand.series;
    const display_unit unit = report_unit(f, r / 3);
    const double coverage = stand_series_coverage(s);
    const double spread = coverage * unit.scale * s->noise * s->x_root[r];
    const int places = figure_places(unit.scale * s->x[r], spread);
    char value[CELL];
    char number[5][FIGURE_MAX];
    const char *cells[] = {parameter_words(r), value, "", "", "", "", ""};

    snprintf(value, sizeof value, "%s %s",
             figure_with_sigma(unit.scale * s->x[r], spread, FIGURE_SIGNED, number[0]), unit.unit);
    if (!nominal_knows(&f->result->nominal, r)) {
        value[0] = '\0';
    }
    cells[2] = r < GROUP_SERIES_CLOSURES ? groups[r % 3] : only[r % 3];
    if (r < GROUP_SERIES_CLOSURES) {
        const double closure = unit.scale * s->closure[r];
        const double sigma = unit.scale * s->noise * s->closure_root[r];
        for (unsigned i = 0; i < 2; i++) {
            cells[3 + i] = nominal_knows(&f->result->nominal, r)
                               ? figure_fixed(unit.scale * s->by_group[r][i], places, FIGURE_SIGNED,
                                              number[1 + i])
                               : "";
        }
        cells[5] = figure_with_sigma(closure, coverage * sigma, FIGURE_SIGNED, number[3]);
        cells[6] = sigma > 0 ? figure_fixed(closure / sigma, 2, FIGURE_SIGNED, number[4]) : "";
    }
    page_cells(p, sheet, cells);
}

static void write_chance(page *p, const group_series *s)
{
    if (s->dof > 0) {
        page_say(p,
                 "All six closures together: F = %.3g with 6 and %u degrees of freedom; by chance "
                 "as large in %.3g %% of cases%s.",
                 s->f, s->dof, 100 * s->chance,
                 s->chance < STAND_SIGNIFICANCE ? ": the groups contradict each other" : "");
    } else {
        page_say(p,
                 "The groups have no redundancy: only the closures themselves show their scatter.");
    }
}

static void write_closures(page *p, const report_facts *f)
{
    static const char *const titles[] = {"parameter", "from series", "groups", "first",
                                         "second",    "closure",     "over σ"};
    const page_table sheet = {
        "The nine parameters from the fifteen coefficients. Two groups determine six of them; "
        "closure: second minus first; σ: its standard deviation.",
        titles, 7, 0};

    page_table_begin(p, &sheet);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        write_closure_row(p, &sheet, f, r);
    }
    page_table_end(p);
    write_chance(p, &f->result->stand.series);
    page_note(p, "The series are in the axes of the stand, the parameters above in those of the "
                 "unit: they differ by the product of mounting and parameters.");
}

/* ---- the section --------------------------------------------------------------------------------- */

void report_stand(page *p, const report_facts *f)
{
    const stand *s = &f->result->stand;

    if (!s->from) {
        return;
    }
    page_section(p, "At the stand");
    if (s->convention != STAND_AS_STATED) {
        page_say(p, "! %c%s", stand_advice(s)[0] - 'a' + 'A', stand_advice(s) + 1);
    }
    write_convention(p, s);
    if (s->convention == STAND_AS_STATED) {
        write_missets(p, s);
        write_mounting(p, f);
        write_vertical(p, f);
        write_series(p, f);
        if (s->series.has_closures) {
            write_closures(p, f);
        }
    }
}
