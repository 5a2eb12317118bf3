/* SPDX-License-Identifier: MIT */
#include "plan/turns.h"
#include "invcal/result.h"
#include "text/json_write.h"
#include "text/number.h"

static void write_turn(json_writer *w, const char *name, const invcal_turn *turn,
                       const invcal_real from[3])
{
    char words[TURNS_WORDS_MAX];

    const double axis[3] = {turn->axis[0] + 0.0, turn->axis[1] + 0.0,
                            turn->axis[2] + 0.0}; /* no -0 */

    json_object(w, name);
    json_vector(w, "axis", axis);
    json_number(w, "degrees", turns_degrees(turn));
    json_vector(w, "up", turn->up);
    json_text(w, "words", turns_words(turn, from, words));
}

static void write_turns(json_writer *w, const turns_plan *p)
{
    const invcal_real *up = p->start;

    json_vector(w, "start", p->start);
    json_list(w, "turns");
    for (unsigned i = 0; i < p->count; i++) {
        const turns_step *step = &p->step[i];
        write_turn(w, NULL, &step->turn, up);
        json_number(w, "open", step->open);
        json_names(w, "improves", step->improves, INVCAL_IMU_PARAMETERS, invcal_parameter_text);
        json_object_end(w);
        up = step->turn.up;
    }
    json_list_end(w);
    write_turn(w, "next", &p->next, up);
    json_object_end(w);
}

/* Of each parameter; null if it is undetermined. */
static void write_each(json_writer *w, const char *name, const turns_plan *p, double times)
{
    json_object(w, name);
    for (unsigned i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        json_number(w, invcal_parameter_text(i),
                    p->is_determined ? times * p->sigma[i] : NUMBER_UNKNOWN);
    }
    json_object_end(w);
}

void turns_json(FILE *file, const turns_plan *p)
{
    const turns_request *r = &p->request;
    json_writer w;

    json_begin(&w, file);
    json_text(&w, "invcal", INVCAL_VERSION);
    if (!p->is_determined) {
        json_text(&w, "error", "undetermined");
        json_text(&w, "reason", p->refusal);
    }
    json_text(&w, "moves", p->program);
    json_number(&w, "noise", r->noise);
    json_number(&w, "rate_noise", r->rate_noise);
    json_number(&w, "instability", r->instability);
    json_number(&w, "seconds", p->seconds);
    write_turns(&w, p);
    json_number(&w, "rank", p->rank);
    json_number(&w, "condition", p->is_determined ? p->condition : NUMBER_UNKNOWN);
    write_each(&w, "sigma", p, 1);
    write_each(&w, "expected", p, r->noise);
    json_names(&w, "undetermined", p->is_determined ? 0 : p->open, INVCAL_IMU_PARAMETERS,
               invcal_parameter_text);
    json_names(&w, "weak", p->is_determined ? p->open : 0, INVCAL_IMU_PARAMETERS,
               invcal_parameter_text);
    json_end(&w);
}
