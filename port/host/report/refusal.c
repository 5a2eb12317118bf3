/* SPDX-License-Identifier: MIT
 *
 * The page about data that were refused: what is missing, where the positions lie, which to add.
 */
#include "result/refusal.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/input.h"
#include "design/parameters.h"
#include "report/facts.h"
#include "report/report.h"

#define TEXT_MAX 400
#define LEGEND_HEIGHT 28.0
#define LEGEND_STEP 84.0

/* Too large for the stack. */
static sphere map;

/* What is known without a calibration. */
typedef struct {
    report_facts facts; /* only result, invocation, count, is_gravity, has_up, position and mark */
    refusal_view view;
    refusal_direction add[REFUSAL_DIRECTIONS];
    unsigned add_count;
    unsigned mark_count;
} refused;

/* ---- what is known ------------------------------------------------------------------------------- */

static void find_positions(refused *d)
{
    report_facts *f = &d->facts;
    invcal_calibration view;

    d->view = refusal_find_view(f->result, &view);
    const double mean = refusal_mean_length(f->result, &view);
    for (unsigned n = 0; n < f->count && d->view != REFUSAL_NO_VIEW; n++) {
        report_position *at = &f->position[n];
        sphere_mark *mark = &f->mark[d->mark_count];
        at->is_left_out = refusal_is_wrong(f->result, n);
        at->length = refusal_length(f->result, &view, n) / mean;
        if (refusal_up(f->result, &view, n, at->up)) {
            memcpy(mark->up, at->up, sizeof mark->up);
            mark->kind = at->is_left_out ? SPHERE_LEFT_OUT : SPHERE_POSITION;
            d->mark_count++;
        } else {
            memset(at->up, 0, sizeof at->up);
        }
    }
    f->has_up = d->view != REFUSAL_NO_VIEW;
    d->add_count = refusal_additions(f->result, d->add);
    for (unsigned n = 0; n < d->add_count; n++) {
        sphere_mark *mark = &f->mark[d->mark_count++];
        memcpy(mark->up, d->add[n].up, sizeof mark->up);
        mark->kind = SPHERE_NEXT;
    }
}

static int find_facts(refused *d, const calibrate_result *result,
                      const calibrate_invocation *invocation)
{
    const unsigned count = result->data->count;

    *d = (refused){.facts = {.result = result, .invocation = invocation, .count = count}};
    d->facts.is_gravity = calibrate_is_gravity(result);
    d->facts.position = calloc((size_t)count + 1, sizeof *d->facts.position);
    d->facts.mark = calloc((size_t)count + REFUSAL_DIRECTIONS, sizeof *d->facts.mark);
    if (!d->facts.position || !d->facts.mark) {
        message("%s: not enough memory for a page of %u positions", result->data->name, count);
        return EXIT_FILE;
    }
    find_positions(d);
    return EXIT_GOOD;
}

/* ---- the sections ------------------------------------------------------------------------------ */

/* A clause with a capital letter, without a full stop. */
static const char *capitalised(const char *clause, char text[REFUSAL_MAX + 4])
{
    snprintf(text, REFUSAL_MAX + 4, "%c%s", toupper((unsigned char)clause[0]), clause + 1);
    return text;
}

static void write_verdict(page *p, const refused *d)
{
    const calibrate_result *r = d->facts.result;
    const int has_criteria = r->need > 0 || r->has_limits;
    const page_answer answer = {has_criteria ? "FAIL: there is no calibration." : NULL, 0};
    char word[64];
    char reason[REFUSAL_MAX + 8];
    char next[REFUSAL_MAX + 8];
    char text[REFUSAL_MAX + 4];

    snprintf(word, sizeof word, "✗ No calibration: %s", r->refused.word);
    snprintf(reason, sizeof reason, "%s.", capitalised(r->refused.reason, text));
    snprintf(next, sizeof next, "%s.",
             *r->refused.remedy ? r->refused.remedy : "correct what the sentence above names");
    page_verdict_with_answer(p, PAGE_BAD, word, &answer, reason, next);
    if (d->facts.invocation->saved) {
        page_say(p, "%s was not written.", d->facts.invocation->saved);
    }
}

static void write_missing(page *p, const refused *d)
{
    const calibrate_result *r = d->facts.result;
    const int is_open = r->refused.undetermined && r->refused.wants_positions;
    char list[128];
    char number[16];

    page_figures_begin(p);
    snprintf(number, sizeof number, "%u", d->facts.count);
    page_figure(p, number, r->log ? "positions, rests of the log" : "positions");
    if (is_open) {
        snprintf(number, sizeof number, "%u of 9", parameters_count(r->refused.undetermined));
        page_figure(p, number, "parameters undetermined");
    }
    if (d->add_count > 0) {
        snprintf(number, sizeof number, "%u", d->add_count);
        page_figure(p, number, "positions to add");
    }
    page_figures_end(p);
    if (is_open && strcmp(r->refused.word, "undetermined") != 0) { /* else the verdict says so */
        page_say(p, "Undetermined: %s.",
                 parameters_list(r->refused.undetermined, list, sizeof list));
    }
}

static void draw_half(FILE *file, const refused *d, unsigned half)
{
    unsigned here[2] = {0, 0};
    char text[TEXT_MAX];

    for (unsigned n = 0; n < d->mark_count; n++) {
        const sphere_mark *m = &d->facts.mark[n];
        here[m->kind == SPHERE_NEXT] += (m->up[2] < -SPHERE_EQUATOR) == half;
    }
    snprintf(
        text, sizeof text,
        "A disc: the hemisphere with z %s, seen from +z. It holds %u positions, and %u to add.",
        half ? "down" : "up or level", here[0], here[1]);
    svg_begin_inline(file, SPHERE_WIDTH, SPHERE_HEIGHT,
                     half ? "Positions with z down" : "Positions with z up", text);
    sphere_draw(file, &map, half);
    svg_end(file);
}

static int has_kind(const refused *d, sphere_kind kind)
{
    for (unsigned n = 0; n < d->mark_count; n++) {
        if (d->facts.mark[n].kind == kind) {
            return 1;
        }
    }
    return 0;
}

/* Only of the kinds in the picture. */
static void draw_legend(FILE *file, const refused *d)
{
    static const struct {
        sphere_kind kind;
        const char *word;
    } all[] = {
        {SPHERE_POSITION, "position"}, {SPHERE_NEXT, "to add"}, {SPHERE_LEFT_OUT, "refused"}};
    double x = 14;

    svg_begin_inline(file, SPHERE_WIDTH, LEGEND_HEIGHT, "Legend", "Meaning of the markers.");
    for (unsigned k = 0; k < sizeof all / sizeof *all; k++) {
        if (has_kind(d, all[k].kind)) {
            sphere_marker(file, all[k].kind, x, 14);
            svg_text(file, "ink small", SVG_START, x + 13, 18, all[k].word);
            x += LEGEND_STEP;
        }
    }
    svg_end(file);
}

static void write_map(page *p, const refused *d)
{
    static const char *const how[] = {
        [REFUSAL_BY_NOMINAL] = "from the nominal calibration",
        [REFUSAL_BY_ZERO] = "from the readings without an offset, which is unknown",
        [REFUSAL_BY_RANGE] = "from the middle of the range of each axis, without a calibration",
    };
    char caption[TEXT_MAX];

    if (d->mark_count == 0) {
        return;
    }
    snprintf(caption, sizeof caption, "Up in the axes of the sensor%s%s.",
             d->facts.count > 0 && how[d->view] ? ", " : "",
             d->facts.count > 0 && how[d->view] ? how[d->view] : "");
    sphere_arrange(&map, d->facts.mark, d->mark_count, NULL);
    page_section(p, d->facts.count > 0 ? "Where the positions lie" : "Where to point");
    page_row_begin(p);
    draw_half(p->file, d, 0);
    draw_half(p->file, d, 1);
    draw_legend(p->file, d);
    page_row_end(p, caption);
}

static void write_additions(page *p, const refused *d)
{
    static const char *const titles[] = {"add", "orientation", "x", "y", "z"};
    const page_table sheet = {
        "What must point up, and up in the axes of the sensor. Within ten degrees is close enough.",
        titles, 5, 1u << 1};

    if (d->add_count == 0) {
        return;
    }
    page_section(p, "Positions to add");
    page_say(p, "With these the set determines everything, with redundancy to check it. This order "
                "takes the least turning.");
    page_table_begin(p, &sheet);
    for (unsigned n = 0; n < d->add_count; n++) {
        const refusal_direction *add = &d->add[n];
        char letter[2] = {(char)('a' + n), '\0'};
        char number[3][FIGURE_MAX];
        const char *const cells[] = {letter, add->words,
                                     figure_fixed(add->up[0], 2, FIGURE_SIGNED, number[0]),
                                     figure_fixed(add->up[1], 2, FIGURE_SIGNED, number[1]),
                                     figure_fixed(add->up[2], 2, FIGURE_SIGNED, number[2])};
        page_cells(p, &sheet, cells);
    }
    page_table_end(p);
}

int report_refusal(FILE *file, const calibrate_result *result,
                   const calibrate_invocation *invocation)
{
    refused d;
    page p;
    char title[TEXT_MAX];
    const int failure = find_facts(&d, result, invocation);

    if (!failure) {
        snprintf(title, sizeof title, "Calibration of %.300s", input_file_name(result->data->name));
        page_begin(&p, file, title);
        write_verdict(&p, &d);
        write_missing(&p, &d);
        write_map(&p, &d);
        write_additions(&p, &d);
        report_timeline(&p, &d.facts);
        report_numbers(&p, &d.facts);
        page_section(&p, "How it was made");
        page_facts_begin(&p);
        report_file(&p, &d.facts);
        page_facts_end(&p);
        page_end(&p);
    }
    report_facts_release(&d.facts);
    return failure;
}
