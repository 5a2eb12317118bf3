/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "result/result.h"
#include "text/figure.h"
#include "text/number.h"
#include "stand/tell.h"

static void print_mounting(FILE *file, const mounting *m, told_unit unit)
{
    char value[FIGURE_MAX];
    char sigma[FIGURE_MAX];

    for (unsigned i = 0; i < 3; i++) {
        const double angle = unit.scale * m->angle[i];
        const double one = unit.scale * m->sigma[i];
        const int places = figure_places(angle, one);
        fprintf(file, "mounting %c    %14s ± %-10s %s, of the unit on the stand\n", "xyz"[i],
                figure_fixed(angle, places, FIGURE_PLAIN, value),
                one >= 0 ? figure_fixed(one, places, FIGURE_PLAIN, sigma) : "?", unit.unit);
    }
    if (*stand_turned_far(m)) {
        calibrate_print_wrapped(file, 0, stand_turned_far(m));
    }
}

static void print_vertical(FILE *file, const stand_vertical *v, const nominal_choice *nominal,
                           const double x[INVCAL_PARAMETERS], const told_unit unit[3])
{
    static const char *const names[] = {"offset x", "offset y", "offset z", "scale x", "scale y",
                                        "scale z",  "angle xy", "angle xz", "angle zy"};

    if (!v->is_known) {
        fprintf(file, "J1            these directions leave parameters open\n");
        return;
    }
    fprintf(file, "%-14s%14s ± %-10s%14s%14s\n", "", "by J1", "sigma", "by lengths", "difference");
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        char text[4][FIGURE_MAX];
        const double scale = unit[r / 3].scale;
        const int places = figure_places(scale * v->x[r], scale * v->sigma[r]);
        const int is_known = nominal_knows(nominal, r);
        fprintf(file, "%-14s%14s ± %-10s%14s%14s  %s\n", names[r],
                is_known ? figure_fixed(scale * v->x[r], places, FIGURE_PLAIN, text[0]) : "",
                v->sigma[r] >= 0 ? figure_fixed(scale * v->sigma[r], places, FIGURE_PLAIN, text[1])
                                 : "?",
                is_known ? figure_fixed(scale * x[r], places, FIGURE_PLAIN, text[2]) : "",
                figure_fixed(scale * (v->x[r] - x[r]), places, FIGURE_SIGNED, text[3]),
                unit[r / 3].unit);
    }
}

static void print_missets(FILE *file, const stand *s)
{
    char text[STAND_TEXT_MAX];

    for (unsigned i = 0; i < s->missets; i++) {
        calibrate_print_wrapped(file, 0, stand_misset_text(s, &s->misset[i], text));
    }
    if (s->missets > 0) {
        calibrate_print_wrapped(file, 0, STAND_MISSET_HARM);
    }
}

/* Which closure is worst, in sigma. */
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

static void print_series(FILE *file, const group_series *s, int has_nominal)
{
    static const char *const groups[] = {"2 and 3", "1 and 3", "1 and 2"};

    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        if (!s->is_determined[g]) {
            fprintf(file, "group %u       %s: %u positions do not tell its five coefficients\n",
                    g + 1, s->count[g] == 0 ? "missing" : "incomplete", s->count[g]);
        } else if (has_nominal) {
            fprintf(file, "group %u       a0 %+.3e  a1 %+.3e  b1 %+.3e  a2 %+.3e  b2 %+.3e\n",
                    g + 1, s->coefficient[g][0], s->coefficient[g][1], s->coefficient[g][2],
                    s->coefficient[g][3], s->coefficient[g][4]);
        }
    }
    if (s->is_closed_over) {
        const unsigned r = worst_closure(s);
        const double sigma = s->noise * s->closure_root[r];
        fprintf(file, "closure       %s of groups %s differs most, by %.2e",
                invcal_parameter_name(r), groups[r % 3], s->closure[r]);
        if (sigma > 0) {
            fprintf(file, ", %.1f sigma", fabs(s->closure[r]) / sigma);
        }
        fprintf(file, "%s\n",
                s->chance < STAND_UNLIKELY ? ": the groups contradict each other" : "");
    }
}

void stand_print(FILE *file, const stand *s, const nominal_choice *nominal,
                 const double x[INVCAL_PARAMETERS], const told_unit unit[3])
{
    char text[STAND_TEXT_MAX];

    fprintf(file, "stand         %u positions with angles (%s)", s->count, s->from);
    if (s->without > 0) {
        fprintf(file, ", %u without, or with angles that changed", s->without);
    }
    fprintf(file, "\n");
    if (s->reading != STAND_AS_STATED) {
        snprintf(text, sizeof text, "Stand: %s", stand_advice(s->reading));
        calibrate_print_wrapped(file, 0, text);
        fprintf(file, "\n");
        return;
    }
    fprintf(file, "directions    %14.3g mrad about each axis between readings and angles\n",
            1e3 * s->mounting.scatter);
    print_mounting(file, &s->mounting, unit[2]);
    print_missets(file, s);
    print_vertical(file, &s->vertical, nominal, x, unit);
    print_series(file, &s->series, !nominal_is_guess(nominal));
    fprintf(file, "\n");
}
