/* SPDX-License-Identifier: MIT
 *
 * The page of a program: its accuracy, and a work sheet to follow it.
 */
#include <string.h>

#include "cli/command.h"
#include "invcal/plan.h"
#include "design/parameters.h"
#include "plan/facts.h"
#include "plan/labour.h"
#include "design/weights.h"

#define TEXT_MAX 800
#define OUTLIER_MIN 11u /* positions needed to identify an outlier (outlier.h) */
#define REST_MIN 2.0    /* seconds; shorter rests are not found in a log (invcal/expert.h) */

/* ---- the verdict ------------------------------------------------------------------------------- */

/* "offsets to 0.0183 mg, scale errors to 0.0021 %, angles to 0.003 °" */
static const char *sigmas_text(const plan_facts *f, char text[TEXT_MAX])
{
    char number[PLAN_WORDS_MAX];

    text[0] = '\0';
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        const size_t length = strlen(text);
        snprintf(text + length, TEXT_MAX - length, "%s%s to %s", k > 0 ? ", " : "", plan_kinds[k],
                 plan_sigma_text(k, plan_sigma(&f->set->criteria, k), f->noise, f->request->units,
                                 number));
    }
    return text;
}

/* The axes that are never along gravity, and why; "" if there are none. */
static const char *missing_text(const design *d, char text[TEXT_MAX])
{
    const unsigned missing = plan_missing_axes(d->axes);
    char axes[PLAN_WORDS_MAX];

    text[0] = '\0';
    if (missing) {
        snprintf(text, TEXT_MAX, " Never along gravity: %s; %s.", plan_axes_text(missing, axes),
                 plan_missing_reason(d));
    }
    return text;
}

/* The most informative next position, in words. */
static void next_words(const design *d, char words[INVCAL_TEXT_SIZE])
{
    double up[3];

    design_next(d, up);
    invcal_direction_text(up, words);
}

static void say_weak(page *p, const plan_facts *f)
{
    char sentence[TEXT_MAX];
    char next[TEXT_MAX];
    char list[PLAN_WORDS_MAX];
    char words[INVCAL_TEXT_SIZE];
    unsigned weak = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        weak |= (unsigned)(f->sigma[r] > PLAN_WEAK) << r;
    }
    snprintf(sentence, sizeof sentence,
             "The positions hardly determine %s: a σ above %g times the noise of a position mean "
             "is of little use.",
             parameters_list((uint16_t)weak, list, sizeof list), PLAN_WEAK);
    next_words(f->set, words);
    snprintf(next, sizeof next, "add positions with %s. Begin with: %s.",
             parameters_advice((uint16_t)weak, list, sizeof list), words);
    page_verdict(p, PAGE_BAD, "✗ Weak", sentence, next);
}

static void say_limits_not_met(page *p, const plan_facts *f)
{
    char sentence[TEXT_MAX];
    char worst[FIGURE_MAX];

    snprintf(sentence, sizeof sentence,
             "%u positions determine all nine parameters, but not within the limits: the worst "
             "sigma is %s of its limit.",
             f->set->count,
             figure_digits(choice_worst(&f->set->criteria, f->request->limits), 4, worst));
    page_verdict(p, PAGE_CAUTION, "! Limits not met", sentence,
                 "take more positions; --limits without --optimal finds out how many.");
}

static void say_unchecked(page *p, const plan_facts *f)
{
    char next[TEXT_MAX];
    char words[INVCAL_TEXT_SIZE];

    next_words(f->set, words);
    snprintf(next, sizeof next, "add three or more positions in other directions. Begin with: %s.",
             words);
    page_verdict(p, PAGE_CAUTION, "! No redundancy",
                 "Nine positions for nine parameters: there is no redundancy, and one wrong "
                 "position would spoil the result unnoticed.",
                 next);
}

static void say_good(page *p, const plan_facts *f)
{
    const design *d = f->set;
    char sentence[3 * TEXT_MAX];
    char next[TEXT_MAX];
    char sigmas[TEXT_MAX];
    char missing[TEXT_MAX];

    snprintf(sentence, sizeof sentence,
             "%u positions determine all nine parameters: %s%s (one standard deviation). "
             "Redundancy %u: %s.%s",
             d->count, sigmas_text(f, sigmas),
             f->noise > 0 ? "" : " times the noise of a position mean",
             d->count - INVCAL_PARAMETERS,
             d->count < OUTLIER_MIN ? "checks the result, but cannot identify an outlier"
                                    : "checks the result and identifies an outlier",
             missing_text(d, missing));
    snprintf(next, sizeof next,
             "%s as the work sheet says%s, and log throughout. Then: invcal calibrate LOG.",
             d->is_stand ? "turn the stand" : "turn the device",
             f->request->cost.dwell < REST_MIN
                 ? ", holding two seconds or more, since shorter rests are not found in a log"
                 : "");
    page_verdict(p, PAGE_GOOD, "✓ Good", sentence, next);
}

static void write_verdict(page *p, const plan_facts *f)
{
    const criteria *c = &f->set->criteria;

    if (!(plan_sigma_largest(c) <= PLAN_WEAK)) {
        say_weak(p, f);
    } else if (f->request->limits && !(choice_worst(c, f->request->limits) <= 1 + 1e-9)) {
        say_limits_not_met(p, f);
    } else if (f->set->count == INVCAL_PARAMETERS) {
        say_unchecked(p, f);
    } else {
        say_good(p, f);
    }
}

static void write_figures(page *p, const plan_facts *f)
{
    char text[PLAN_WORDS_MAX];
    char what[PLAN_WORDS_MAX];

    page_figures_begin(p);
    snprintf(text, sizeof text, "%u", f->set->count);
    page_figure(p, text, "positions");
    page_figure(p, plan_time_text(design_seconds(f->set->count, &f->request->cost), text), "time");
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        snprintf(what, sizeof what, "σ of %s%s", plan_kinds[k], plan_noise_suffix(f->noise));
        plan_sigma_text(k, plan_sigma(&f->set->criteria, k), f->noise, f->request->units, text);
        page_figure(p, text, what);
    }
    page_figures_end(p);
}

/* ---- the candidates ---------------------------------------------------------------------------- */

static void write_candidate(page *p, const page_table *sheet, const plan_facts *f, const design *d)
{
    char text[7][PLAN_WORDS_MAX];
    const char *const cells[] = {text[0], text[1], text[2], text[3], text[4], text[5], text[6]};

    snprintf(text[0], PLAN_WORDS_MAX, "%s%s", d->name, d == f->set ? ", chosen" : "");
    snprintf(text[1], PLAN_WORDS_MAX, "%u", d->count);
    plan_time_text(design_seconds(d->count, &f->request->cost), text[2]);
    for (unsigned k = 0; k < PLAN_KINDS; k++) {
        plan_sigma_text(k, plan_sigma(&d->criteria, k), f->noise, f->request->units, text[3 + k]);
    }
    if (f->request->limits) {
        figure_digits(choice_worst(&d->criteria, f->request->limits), 4, text[6]);
    }
    page_cells(p, sheet, cells);
}

static void write_choice(page *p, const plan_facts *f)
{
    static const char *const heading[] = {"set",          "positions", "time",           "offsets",
                                          "scale errors", "angles",    "worst σ / limit"};
    const page_table sheet = {f->noise > 0 ? "The best set of each family; σ."
                                           : "The best set of each family; σ, × noise.",
                              heading, f->request->limits ? 7 : 6, 0};

    page_section(p, "Why this set");
    page_say(p, "%s: %s.",
             f->request->limits ? "The smallest within the limits"
                                : "The largest determinant in the time",
             f->set->name);
    page_table_begin(p, &sheet);
    for (unsigned k = 0; k < CHOICE_FAMILIES; k++) {
        if (f->choice->is_found[k]) {
            write_candidate(p, &sheet, f, f->choice->set[k]);
        }
    }
    page_table_end(p);
    for (unsigned k = 0; k < CHOICE_FAMILIES; k++) {
        if (!f->choice->is_found[k]) {
            page_note(p, "No %s %s.", k == CHOICE_STAND ? "stand program" : "free directions",
                      f->request->budget > 0 ? "fit into the time" : "meet the limits");
        }
    }
}

/* ---- cost and origin --------------------------------------------------------------------------- */

static void write_cost(page *p, const plan_facts *f)
{
    const design_cost *cost = &f->request->cost;
    const design *d = f->set;
    char text[3][PLAN_WORDS_MAX];

    page_section(p, "Cost");
    page_facts_begin(p);
    page_fact(p, "time", "%s: %s in each of %u positions, %s between positions",
              plan_time_text(design_seconds(d->count, cost), text[0]),
              plan_time_text(cost->dwell, text[1]), d->count, plan_time_text(cost->move, text[2]));
    if (cost->settle > 0) {
        page_fact(p, "to settle", "%s in each, before recording",
                  plan_time_text(cost->settle, text[0]));
    }
    if (cost->warm_up > 0) {
        page_fact(p, "to warm up", "%s once, before the first position",
                  plan_time_text(cost->warm_up, text[0]));
    }
    if (f->request->budget > 0) {
        page_fact(p, "budget", "%s", plan_time_text(f->request->budget, text[0]));
    }
    page_fact(p, "redundancy", "%u: positions beyond the nine that nine parameters need",
              d->count - INVCAL_PARAMETERS);
    page_facts_end(p);
    page_note(p, "With twice the time in each position, or the whole set twice, every σ is 0.71 "
                 "times as large, if the noise is white.");
}

void plan_report_origin(page *p, const char *command)
{
    page_section(p, "How it was made");
    page_facts_begin(p);
    page_literal(p, "command", command);
    page_fact(p, "invcal", "%s", INVCAL_VERSION);
}

static void write_origin(page *p, const plan_facts *f, const char *command)
{
    const design *d = f->set;
    const display_unit unit = unit_style_field(f->request->units, 1);
    char text[3][PLAN_WORDS_MAX];

    plan_report_origin(p, command);
    page_fact(p, "set", "%s, %u positions", d->name, d->count);
    if (d->plan.per_group > 0) {
        for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
            plan_angle_text(d->plan.start_deg[g], text[g]);
        }
        page_fact(p, "start angles", "%s°, %s°, %s°", text[0], text[1], text[2]);
    }
    if (f->request->labour) {
        page_fact(p, "noise", "%s: %.4g %s for a position mean", f->request->labour->noise_name,
                  unit.scale * f->noise, unit.unit);
    } else if (f->noise > 0) {
        page_fact(p, "stated noise", "%.4g %s for one second, %.4g %s for a position mean",
                  unit.scale * f->request->cost.noise, unit.unit, unit.scale * f->noise, unit.unit);
    } else {
        page_fact(p, "noise",
                  "unknown, so σ is in multiples of the noise of a position mean; state --noise");
    }
    page_fact(p, "condition", "%.4g", d->criteria.condition);
    page_fact(p, "ln det H'H", "%.6g", d->criteria.log_det);
    if (d->has_shares) {
        page_fact(p, "shares of the time",
                  "not equal: with equal ones ln det H'H is %.6g; for any %u positions it is at "
                  "most %.6g",
                  d->equal_log_det, d->count, weights_bound(d->count));
    }
    page_facts_end(p);
}

void plan_report(FILE *file, const design *d, const choice_request *request, const choice *c,
                 const char *command)
{
    char title[TEXT_MAX];
    plan_facts f;
    page p;

    plan_facts_find(&f, d, request, c);
    snprintf(title, sizeof title, "Program of positions: %s", d->name);
    page_begin(&p, file, title);
    write_verdict(&p, &f);
    write_figures(&p, &f);
    plan_report_sheet(&p, &f);
    plan_report_sphere(&p, &f);
    plan_report_sigma(&p, &f);
    if (request->bound > 0) {
        plan_report_bound(&p, &f);
    }
    plan_report_coverage(&p, &f);
    if (c) {
        write_choice(&p, &f);
    }
    if (request->labour) {
        labour_report(&p, request->labour);
    }
    write_cost(&p, &f);
    write_origin(&p, &f, command);
    page_end(&p);
}
