/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "stand/output.h"
#include "invcal/plan.h"
#include "invcal/result.h"
#include "text/figure.h"
#include "text/tabular.h"
#include "text/wrapped.h"

#define LABEL 14u /* columns before a line's text */

static void print_mounting(FILE *file, const mounting *m, display_unit unit)
{
    char text[FIGURE_MAX];

    tabular_begin(file, "lrl");
    for (unsigned i = 0; i < 3; i++) {
        const double angle = unit.scale * m->angle[i];
        const double sigma = unit.scale * m->sigma[i];
        const int places = figure_places(angle, sigma);
        tabular_cell("mounting %c", "xyz"[i]);
        tabular_cell("%s", figure_fixed(angle, places, FIGURE_PLAIN, text));
        tabular_cell("± %s", sigma >= 0 ? figure_fixed(sigma, places, FIGURE_PLAIN, text) : "?");
        tabular_note("%s, of the unit on the stand", unit.unit);
        tabular_row();
    }
    tabular_end();
    if (*stand_large_angle_text(m)) {
        wrapped_line(file, 0, 0, stand_large_angle_text(m));
    }
}

static void print_vertical(FILE *file, const stand_vertical *v, const nominal_choice *nominal,
                           const double x[INVCAL_PARAMETERS], const display_unit unit[3])
{
    static const char *const names[] = {"offset x", "offset y", "offset z", "scale x", "scale y",
                                        "scale z",  "angle xy", "angle xz", "angle zy"};
    char text[FIGURE_MAX];

    if (!v->is_known) {
        fprintf(file, "J1            these directions leave parameters undetermined\n");
        return;
    }
    tabular_begin(file, "lrlrr");
    tabular_heading("|by J1|± sigma|by lengths|difference");
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const double scale = unit[r / 3].scale;
        const double sigma = scale * v->sigma[r];
        const int places = figure_places(scale * v->x[r], sigma);
        const int is_known = nominal_knows(nominal, r);
        tabular_cell("%s", names[r]);
        tabular_cell("%s",
                     is_known ? figure_fixed(scale * v->x[r], places, FIGURE_PLAIN, text) : "");
        tabular_cell("± %s", sigma >= 0 ? figure_fixed(sigma, places, FIGURE_PLAIN, text) : "?");
        tabular_cell("%s", is_known ? figure_fixed(scale * x[r], places, FIGURE_PLAIN, text) : "");
        tabular_cell("%s", figure_fixed(scale * (v->x[r] - x[r]), places, FIGURE_SIGNED, text));
        tabular_note("%s", unit[r / 3].unit);
        tabular_row();
    }
    tabular_end();
}

static void print_missets(FILE *file, const stand *s)
{
    char text[STAND_TEXT_MAX];

    for (unsigned i = 0; i < s->missets; i++) {
        wrapped_line(file, 0, 0, stand_misset_text(s, &s->misset[i], text));
    }
    if (s->missets > 0) {
        wrapped_line(file, 0, 0, STAND_MISSET_NOTE);
    }
}

/* The closure that is the most sigma from zero. */
static unsigned worst_closure(const group_series *s)
{
    unsigned worst = 0;

    for (unsigned r = 1; r < GROUP_SERIES_CLOSURES; r++) {
        if (fabs(s->closure[r]) / s->closure_root[r] >
            fabs(s->closure[worst]) / s->closure_root[worst]) {
            worst = r;
        }
    }
    return worst;
}

static void print_coefficients(FILE *file, const group_series *s)
{
    tabular_begin(file, "lrrrrr");
    tabular_heading("|a0|a1|b1|a2|b2");
    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        if (s->is_determined[g]) {
            tabular_cell("group %u", g + 1);
            for (unsigned i = 0; i < SERIES_TERMS; i++) {
                tabular_cell("%+.3e", s->coefficient[g][i]);
            }
            tabular_row();
        }
    }
    tabular_end();
}

static void print_series(FILE *file, const group_series *s, int has_nominal)
{
    static const char *const groups[] = {"2 and 3", "1 and 3", "1 and 2"};

    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        if (!s->is_determined[g]) {
            wrapped_printf(file, LABEL,
                           "group %u       %s: %u positions do not determine its five coefficients",
                           g + 1, s->count[g] == 0 ? "missing" : "incomplete", s->count[g]);
        }
    }
    if (has_nominal) {
        print_coefficients(file, s);
    }
    if (s->has_closures) {
        const unsigned r = worst_closure(s);
        const double sigma = s->noise * s->closure_root[r];
        char times[FIGURE_MAX] = "";
        if (sigma > 0) {
            snprintf(times, sizeof times, ", %.1f sigma", fabs(s->closure[r]) / sigma);
        }
        wrapped_printf(file, LABEL, "closure       %s of groups %s is worst: %.2e%s%s",
                       invcal_parameter_text(r), groups[r % 3], s->closure[r], times,
                       s->chance < STAND_SIGNIFICANCE ? ": the groups contradict each other" : "");
    }
}

void stand_print(FILE *file, const stand *s, const nominal_choice *nominal,
                 const double x[INVCAL_PARAMETERS], const display_unit unit[3])
{
    char text[STAND_TEXT_MAX];

    text[0] = '\0';
    if (s->without_angles > 0) {
        snprintf(text, sizeof text, ", %u without, or with changing angles", s->without_angles);
    }
    wrapped_printf(file, LABEL, "stand         %u positions with angles (%s)%s", s->count, s->from,
                   text);
    if (s->convention == STAND_AS_STATED || s->convention == STAND_SCATTERED) {
        wrapped_printf(file, LABEL,
                       "directions    %.3g mrad about each axis between readings and angles",
                       1e3 * s->mounting.scatter);
    }
    if (s->convention != STAND_AS_STATED) {
        snprintf(text, sizeof text, "Stand: %s", stand_advice(s));
        wrapped_line(file, 0, 0, text);
        fprintf(file, "\n");
        return;
    }
    print_mounting(file, &s->mounting, unit[2]);
    print_missets(file, s);
    print_vertical(file, &s->vertical, nominal, x, unit);
    print_series(file, &s->series, !nominal_is_guess(nominal));
    fprintf(file, "\n");
}
