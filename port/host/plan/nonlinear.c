/* SPDX-License-Identifier: MIT */
#include "plan/nonlinear.h"

#include <stdlib.h>
#include <string.h>

#include "text/figure.h"
#include "fit/nonlinearity.h"
#include "text/number.h"
#include "text/wrapped.h"

#define TEXT_MAX 200
#define SENTENCE_MAX 400
#define INDENT 19 /* of continued lines */

/* With the quadratic terms, and with the cubic ones as well. */
enum { QUADRATIC = 2, CUBIC = 3 };

typedef struct {
    unsigned degree;
    unsigned open; /* bits of what is undetermined; 0: nothing, and the members below are known */
    double sigma;  /* of the highest terms */
    nonlinearity_prospect all;
} prospect;

static prospect prospect_of(const design *d, unsigned degree)
{
    static double direction[DESIGN_MAX][3];
    static double weight[DESIGN_MAX];
    prospect p = {.degree = degree};

    for (unsigned i = 0; i < d->count; i++) {
        memcpy(direction[i], d->position[i].vertical, sizeof direction[i]);
        weight[i] = d->position[i].share;
    }
    (void)nonlinearity_judge((const double(*)[3])direction, weight, d->count, degree, &p.all,
                             &p.open);
    p.sigma = degree == CUBIC ? p.all.cubic : p.all.quadratic;
    return p;
}

static const char *name_of(const prospect *p)
{
    return p->degree == CUBIC ? "cubic" : "quadratic";
}

static unsigned parameters_of(const prospect *p)
{
    return INVCAL_PARAMETERS + 3 * (p->degree - 1);
}

/* "undetermined: cubic x, cubic y". */
static const char *open_text(const prospect *p, char text[TEXT_MAX])
{
    int length = snprintf(text, TEXT_MAX, "undetermined");

    for (unsigned e = 0; e < NONLINEARITY_TERMS; e++) {
        if (p->open >> e & 1) {
            length += snprintf(text + length, TEXT_MAX - (size_t)length, "%s %s",
                               length > 14 ? "," : ":", nonlinearity_name(e));
        }
    }
    return text;
}

/* A note if there are too few positions for calibrate. */
static const char *too_few_text(const prospect *p, const design *d, char text[TEXT_MAX])
{
    const unsigned min = nonlinearity_min_positions(p->degree);

    text[0] = '\0';
    if (d->count < min) {
        snprintf(text, TEXT_MAX, ", but --%s needs %u positions or more", name_of(p), min);
    }
    return text;
}

/* "mg per g²", or "× noise". */
static const char *unit_text(const prospect *p, double noise, unit_style style, char text[TEXT_MAX])
{
    snprintf(text, TEXT_MAX, "× noise");
    if (noise > 0) {
        snprintf(text, TEXT_MAX, "%s per %s", unit_style_field(style, 1).unit,
                 p->degree == CUBIC ? "g³" : "g²");
    }
    return text;
}

static void print_line(FILE *file, const design *d, unsigned degree, double noise, unit_style style)
{
    const prospect p = prospect_of(d, degree);
    char text[TEXT_MAX];
    char size[SENTENCE_MAX] = "";

    if (p.open) {
        wrapped_printf(file, INDENT, "  %-15s%s", name_of(&p), open_text(&p, text));
        return;
    }
    if (noise > 0) {
        snprintf(size, sizeof size, "%12.4g %s", unit_style_field(style, 1).scale * noise * p.sigma,
                 unit_text(&p, noise, style, text));
    }
    wrapped_printf(file, INDENT, "  %-15s%9.4f%s   of %u parameters, condition %.4g%s", name_of(&p),
                   p.sigma, size, parameters_of(&p), p.all.condition, too_few_text(&p, d, text));
}

void plan_nonlinear_print(FILE *file, const design *d, double noise, unit_style style)
{
    wrapped_printf(
        file, 0,
        "sigma of nonlinear terms, if they are estimated too (calibrate --quadratic, --cubic)");
    print_line(file, d, QUADRATIC, noise, style);
    print_line(file, d, CUBIC, noise, style);
}

void plan_nonlinear_json(json_writer *w, const design *d)
{
    json_object(w, "nonlinear");
    for (unsigned degree = QUADRATIC; degree <= CUBIC; degree++) {
        const prospect p = prospect_of(d, degree);
        json_object(w, name_of(&p));
        json_number(w, "parameters", parameters_of(&p));
        json_number(w, "sigma", p.open ? NUMBER_UNKNOWN : p.sigma);
        json_number(w, "condition", p.open ? NUMBER_UNKNOWN : p.all.condition);
        json_names(w, "undetermined", p.open, NONLINEARITY_TERMS, nonlinearity_name);
        json_object_end(w);
    }
    json_object_end(w);
}

/* "quadratic 1.63 × noise, of 12 parameters, condition 39.9", or what is undetermined. */
static const char *report_text(const prospect *p, const design *d, double noise, unit_style style,
                               char text[SENTENCE_MAX])
{
    char number[FIGURE_MAX];
    char condition[FIGURE_MAX];
    char unit[TEXT_MAX];
    char more[TEXT_MAX];

    if (p->open) {
        snprintf(text, SENTENCE_MAX, "%s %s", name_of(p), open_text(p, more));
        return text;
    }
    figure_digits(noise > 0 ? unit_style_field(style, 1).scale * noise * p->sigma : p->sigma, 3,
                  number);
    snprintf(text, SENTENCE_MAX, "%s %s %s, of %u parameters, condition %s%s", name_of(p), number,
             unit_text(p, noise, style, unit), parameters_of(p),
             figure_digits(p->all.condition, 3, condition), too_few_text(p, d, more));
    return text;
}

void plan_nonlinear_report(page *p, const design *d, double noise, unit_style style)
{
    const prospect quadratic = prospect_of(d, QUADRATIC);
    const prospect cubic = prospect_of(d, CUBIC);
    char text[2][SENTENCE_MAX];

    page_note(
        p,
        "σ of nonlinear terms, if they are estimated too (calibrate --quadratic, --cubic): %s; %s.",
        report_text(&quadratic, d, noise, style, text[0]),
        report_text(&cubic, d, noise, style, text[1]));
}
