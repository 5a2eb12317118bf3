/* SPDX-License-Identifier: MIT */
#include "plan/turns.h"
#include "text/parameter.h"
#include "plan/words.h"
#include "text/figure.h"
#include "text/tabular.h"
#include "text/wrapped.h"

static void print_turns(FILE *file, const turns_plan *p)
{
    const invcal_real *up = p->start;
    char words[TURNS_WORDS_MAX];
    char improved[TURNS_LIST_MAX];
    char side[TURNS_UP_MAX];

    wrapped_printf(file, 0,
                   "Start with %s. Then turn, always the shortest way:", turns_up_words(up, side));
    tabular_begin(file, "rlrl");
    tabular_heading("no.|turn|open|improves");
    for (unsigned i = 0; i < p->count; i++) {
        const turns_step *step = &p->step[i];
        tabular_cell("%u", i + 1);
        tabular_cell("%s", turns_words(&step->turn, up, words));
        tabular_cell("%u", step->open);
        tabular_cell("%s", parameter_list_imu(step->improves, improved, sizeof improved));
        tabular_row();
        up = step->turn.up;
    }
    tabular_end();
    putc('\n', file);
}

static void print_sigma(FILE *file, const turns_plan *p)
{
    const turns_request *r = &p->request;
    const display_unit field = unit_style_field(r->units, 1);
    char number[FIGURE_MAX];

    wrapped_printf(file, 0,
                   "expected %ssigma%s: times the noise of a position mean, which is %.4g %s; with "
                   "a gyroscope of %.4g degrees/s/sqrt(Hz) and %.4g degrees/h",
                   paint_on(file, PAINT_BOLD), paint_off(file), field.scale * r->noise, field.unit,
                   FIGURE_DEGREES * r->rate_noise, 3600 * FIGURE_DEGREES * r->instability);
    tabular_begin(file, "lrrl");
    for (unsigned i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        const unsigned kind = turns_kind(i);
        const display_unit unit = kind == 0   ? field
                                  : kind == 1 ? unit_style_scale(r->units)
                                              : unit_style_angle(r->units);
        tabular_cell("  %s", parameter_words_imu(i));
        tabular_cell("%.4f", p->sigma[i]);
        tabular_cell("%s", figure_digits(unit.scale * r->noise * p->sigma[i], 3, number));
        tabular_cell("%s", unit.unit);
        tabular_row();
    }
    tabular_end();
    wrapped_printf(file, 0, "condition %.4f (1 is best)", p->condition);
}

void turns_print(FILE *file, const turns_plan *p)
{
    char text[TURNS_WORDS_MAX];
    char list[TURNS_LIST_MAX];

    wrapped_printf(
        file, 0, "%s%s:%s %u turn%s, %u rests; %s: %.4g s in each rest, %.4g s per quarter turn",
        paint_on(file, PAINT_BOLD), p->program, paint_off(file), p->count, p->count == 1 ? "" : "s",
        p->count + 1, plan_time_text(p->seconds, text), p->request.rest, p->request.turn);
    print_turns(file, p);
    if (p->is_determined) {
        print_sigma(file, p);
        if (p->open) {
            wrapped_printf(file, 0, "%sweak:%s %s; turn next: %s", paint_on(file, PAINT_RED),
                           paint_off(file), parameter_list_imu(p->open, list, sizeof list),
                           turns_words(&p->next, p->step[p->count - 1].turn.up, text));
        }
    }
}
