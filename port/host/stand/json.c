/* SPDX-License-Identifier: MIT */
#include "text/figure.h"
#include "invcal/plan.h"
#include "stand/output.h"
#include "text/number.h"

/* Deviations from nominal, null where that is not stated. */
static void write_deviations(json_writer *w, const char *name, const nominal_choice *nominal,
                             const double x[INVCAL_PARAMETERS])
{
    double known[INVCAL_PARAMETERS];

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        known[r] = nominal_knows(nominal, r) ? x[r] : NUMBER_UNKNOWN;
    }
    json_nine(w, name, known);
}

static void write_missets(json_writer *w, const stand *s)
{
    static const char *const kinds[] = {"misset", "swapped", "repeated"};

    json_list(w, "misset");
    for (unsigned i = 0; i < s->missets; i++) {
        const misset *m = &s->misset[i];
        json_object(w, NULL);
        json_number(w, "position", s->position[m->index].number + 1.0);
        json_text(w, "kind", kinds[m->kind]);
        if (m->kind != MISSET_BY) {
            json_number(w, "other", s->position[m->other].number + 1.0);
        }
        json_number(w, "angle", FIGURE_DEGREES * m->angle);
        if (m->kind == MISSET_BY && m->angle < STAND_SMALL_ANGLE) {
            json_number(w, "alpha", FIGURE_DEGREES * m->alpha);
            json_number(w, "beta", FIGURE_DEGREES * m->beta);
        }
        json_object_end(w);
    }
    json_list_end(w);
}

/* Standard deviations from those over the noise. */
static const double *to_sigma(double noise, const double *root, unsigned n,
                              double sigma[INVCAL_PARAMETERS])
{
    for (unsigned i = 0; i < n; i++) {
        sigma[i] = noise * root[i];
    }
    return sigma;
}

static void write_closures(json_writer *w, const group_series *s, const nominal_choice *nominal)
{
    double sigma[INVCAL_PARAMETERS];

    write_deviations(w, "series_parameters", nominal, s->x);
    json_nine(w, "series_sigma", to_sigma(s->noise, s->x_root, INVCAL_PARAMETERS, sigma));
    json_numbers(w, "closure", s->closure, GROUP_SERIES_CLOSURES);
    json_numbers(w, "closure_sigma",
                 to_sigma(s->noise, s->closure_root, GROUP_SERIES_CLOSURES, sigma),
                 GROUP_SERIES_CLOSURES);
    json_number(w, "closure_f", s->f);
    json_number(w, "closure_dof", s->dof);
    json_number(w, "closure_chance", s->chance);
}

static void write_series(json_writer *w, const group_series *s, const nominal_choice *nominal)
{
    static const double unknown[SERIES_TERMS] = {NUMBER_UNKNOWN, NUMBER_UNKNOWN, NUMBER_UNKNOWN,
                                                 NUMBER_UNKNOWN, NUMBER_UNKNOWN};
    const int is_known = !nominal_is_guess(nominal);
    double sigma[INVCAL_PARAMETERS];

    json_list(w, "series");
    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        json_object(w, NULL);
        json_number(w, "positions", s->count[g]);
        json_numbers(w, "coefficients", is_known ? s->coefficient[g] : unknown, SERIES_TERMS);
        json_numbers(w, "sigma", to_sigma(s->noise, s->root[g], SERIES_TERMS, sigma), SERIES_TERMS);
        json_object_end(w);
    }
    json_list_end(w);
    if (s->has_closures) {
        json_number(w, "series_interval95", stand_series_coverage(s));
        write_closures(w, s, nominal);
    }
}

void stand_json(json_writer *w, const stand *s, const nominal_choice *nominal)
{
    double angle[3];
    double sigma[3];

    json_object(w, "stand");
    json_text(w, "from", s->from);
    json_number(w, "positions", s->count);
    json_numbers(w, "sense", s->sense, 2);
    json_numbers(w, "zero", s->zero, 2);
    json_text(w, "angles", stand_convention_name(s->convention));
    if (s->convention == STAND_AS_STATED) {
        for (unsigned i = 0; i < 3; i++) {
            angle[i] = FIGURE_DEGREES * s->mounting.angle[i];
            sigma[i] = FIGURE_DEGREES * s->mounting.sigma[i];
        }
        json_vector(w, "mounting", angle);
        json_vector(w, "sigma", sigma);
        json_number(w, "interval95", stand_coverage(s->mounting.dof));
        json_number(w, "scatter", FIGURE_DEGREES * s->mounting.scatter);
        if (s->vertical.is_known) {
            write_deviations(w, "vertical", nominal, s->vertical.x);
            json_nine(w, "vertical_sigma", s->vertical.sigma);
            json_number(w, "vertical_interval95", stand_coverage(s->vertical.dof));
        }
        write_missets(w, s);
        write_series(w, &s->series, nominal);
    }
    json_object_end(w);
}
