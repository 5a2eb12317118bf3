/* SPDX-License-Identifier: MIT */
#include "text/paint.h"
#include "plan/labour.h"
#include "plan/words.h"

static void print_row(FILE *file, const labour *l, unsigned family, const labour_row *row)
{
    const int is_chosen = l->best[l->chosen] == row;
    const told_unit unit = told_field(l->told, 1);
    char time[PLAN_WORDS_MAX] = "";

    fprintf(file, "%s%-20s%10u", is_chosen ? paint_on(file, PAINT_GREEN) : "",
            labour_families[family], row->count);
    if (row->is_possible) {
        plan_time_text(row->seconds, time);
        fprintf(file, "%12.4g%14.4g%*s   %s", row->dwell, unit.scale * row->sigma,
                paint_width(time, 16), time, plan_kinds[row->binds]);
    } else {
        fprintf(file, "%12s%14.4g%16s   %.4g %s are needed", "none", unit.scale * row->sigma, "",
                unit.scale * row->wanted, unit.unit);
    }
    fprintf(file, "%s%s%s\n", row->is_possible && row->is_beyond ? ", dwell not seen" : "",
            is_chosen ? "   chosen" : "", is_chosen ? paint_off(file) : "");
}

void labour_print(FILE *file, const labour *l)
{
    const told_unit field = told_field(l->told, 1);
    const told_unit scale = told_scale(l->told);
    const told_unit angle = told_angle(l->told);
    char mean[PLAN_WORDS_MAX];

    snprintf(mean, sizeof mean, "mean, %s", field.unit);
    fprintf(file,
            "The least time in all, by the noise of %s; %.6g s to settle in each position, %.6g s\n"
            "between two; limits %.4g %s, %.4g %s, %.4g %s\n\n",
            l->noise_name, l->settle, l->move, field.scale * l->limits[0], field.unit,
            scale.scale * l->limits[1], scale.unit, angle.scale * l->limits[2], angle.unit);
    if (l->warm_up > 0) {
        fprintf(file, "%.6g s to warm up, before the first\n\n", l->warm_up);
    }
    fprintf(file, "%s%-20s%10s%12s%*s%16s   %s%s\n", paint_on(file, PAINT_BOLD), "", "positions",
            "dwell, s", paint_width(mean, 14), mean, "time", "what binds", paint_off(file));
    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        unsigned first;
        unsigned end;
        labour_around(l, f, &first, &end);
        for (unsigned i = first; i < end; i++) {
            print_row(file, l, f, &l->row[f][i]);
        }
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
