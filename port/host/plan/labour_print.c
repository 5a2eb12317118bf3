/* SPDX-License-Identifier: MIT */
#include "text/tabular.h"
#include "text/wrapped.h"
#include "plan/labour.h"
#include "plan/words.h"

static void add_row(const labour *l, unsigned family, const labour_row *row)
{
    const display_unit unit = unit_style_field(l->units, 1);
    char text[PLAN_WORDS_MAX];

    tabular_cell("%s", labour_families[family]);
    tabular_cell("%u", row->count);
    snprintf(text, sizeof text, "%.4g%s", row->dwell, row->is_beyond ? "*" : "");
    tabular_cell("%s", row->is_possible ? text : "none");
    tabular_cell("%.4g", unit.scale * row->sigma);
    if (row->is_possible) {
        tabular_cell("%s", plan_time_text(row->seconds, text));
        tabular_cell("%s", plan_kinds[row->binds]);
    } else {
        tabular_cell("%s", "");
        tabular_cell("needed: %.4g", unit.scale * row->allowed);
    }
    if (l->best[l->chosen] == row) {
        tabular_cell("chosen");
        tabular_row_in(PAINT_GREEN);
    } else {
        tabular_row();
    }
}

/* The rows near the best of each family. Returns 1 if a dwell is longer than the averaging times of
 * the measured noise. */
static int add_rows(const labour *l)
{
    int is_beyond = 0;

    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        unsigned first;
        unsigned end;
        labour_near_best(l, f, &first, &end);
        for (unsigned i = first; i < end; i++) {
            const labour_row *row = &l->row[f][i];
            add_row(l, f, row);
            is_beyond |= row->is_possible && row->is_beyond;
        }
    }
    return is_beyond;
}

void labour_print(FILE *file, const labour *l)
{
    const display_unit field = unit_style_field(l->units, 1);
    const display_unit scale = unit_style_scale(l->units);
    const display_unit angle = unit_style_angle(l->units);

    wrapped_printf(file, 0,
                   "Least total time with the noise of %s; %.6g s to settle in each position, %.6g "
                   "s between positions; limits %.4g %s, %.4g %s, %.4g %s",
                   l->noise_name, l->settle, l->move, field.scale * l->limits[0], field.unit,
                   scale.scale * l->limits[1], scale.unit, angle.scale * l->limits[2], angle.unit);
    putc('\n', file);
    if (l->warm_up > 0) {
        fprintf(file, "%.6g s to warm up before the first\n\n", l->warm_up);
    }
    tabular_begin(file, "lrrrrrl");
    tabular_cell("%s", "");
    tabular_cell("positions");
    tabular_cell("dwell, s");
    tabular_cell("mean, %s", field.unit);
    tabular_cell("time");
    tabular_cell("limited by");
    tabular_row_in(PAINT_BOLD);
    const int is_beyond = add_rows(l);
    tabular_end();
    if (is_beyond) {
        wrapped_line(file, 0, 0, "* longer than the averaging times of the measured noise");
    }
    putc('\n', file);
}

void labour_json(json_writer *w, const labour *l)
{
    static const char *const names[CHOICE_FAMILIES] = {"stand", "free"};

    json_text(w, "noise_file", l->noise_name);
    json_number(w, "dwell", l->best[l->chosen]->dwell);
    json_number(w, "dwell_sigma", l->best[l->chosen]->sigma);
    json_number(w, "settle", l->settle);
    json_number(w, "move", l->move);
    json_list(w, "tradeoff");
    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        for (unsigned i = 0; i < l->rows[f]; i++) {
            const labour_row *row = &l->row[f][i];
            if (row->is_possible) {
                json_object(w, NULL);
                json_text(w, "family", names[f]);
                json_number(w, "positions", row->count);
                json_number(w, "dwell", row->dwell);
                json_number(w, "dwell_sigma", row->sigma);
                json_text(w, "dwell_end", row->is_beyond ? "beyond" : "reached");
                json_number(w, "seconds", row->seconds);
                json_text(w, "binds", plan_kinds[row->binds]);
                json_object_end(w);
            }
        }
    }
    json_list_end(w);
}
