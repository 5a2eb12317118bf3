/* SPDX-License-Identifier: MIT
 *
 * invcal plan: chooses positions, and predicts the accuracy of a calibration from them.
 */
#include "plan/results.h"

#include <math.h>
#include <string.h>

#include "invcal/plan.h"
#include "cli/command.h"
#include "cli/files.h"
#include "cli/message.h"
#include "read/noise_file.h"
#include "design/optimal.h"
#include "cli/options.h"
#include "cli/output.h"
#include "plan/labour.h"
#include "plan/programs.h"
#include "plan/turns.h"
#include "text/figure.h"

enum {
    PER_GROUP,
    START,
    FACES,
    EDGES,
    ICOSAHEDRON,
    STAND_12,
    STAND_24,
    OPTIMAL,
    GRID,
    ANGLES,
    DIRECTIONS,
    SWEEP,
    COMPARE,
    PROGRAMS,
    MOVES,
    RATE_NOISE,
    INSTABILITY,
    LIMITS,
    BUDGET,
    SPARE,
    NEED_AXES,
    WEIGHTS,
    BOUND,
    NOISE,
    ALLAN,
    WARM_UP,
    DWELL,
    SETTLE,
    MOVE,
    SVG,
    REPORT,
    CSV,
    UNITS,
    JSON,
    QUIET,
    OPTIONS
};

static const option options[OPTIONS] = {
    [PER_GROUP] = {"--per-group", 1},
    [START] = {"--start", 1},
    [FACES] = {"--faces", 0},
    [EDGES] = {"--edges", 0},
    [ICOSAHEDRON] = {"--icosahedron", 0},
    [STAND_12] = {"--stand-12", 0},
    [STAND_24] = {"--stand-24", 0},
    [OPTIMAL] = {"--optimal", 1},
    [GRID] = {"--grid", 1},
    [ANGLES] = {"--angles", 1},
    [DIRECTIONS] = {"--directions", 1},
    [SWEEP] = {"--sweep", 1},
    [COMPARE] = {"--compare", 0},
    [PROGRAMS] = {"--programs", 0},
    [MOVES] = {"--moves", 1},
    [RATE_NOISE] = {"--rate-noise", 1},
    [INSTABILITY] = {"--instability", 1},
    [LIMITS] = {"--limits", 1},
    [BUDGET] = {"--budget", 1},
    [SPARE] = {"--spare", 1},
    [NEED_AXES] = {"--need-axes", 0},
    [WEIGHTS] = {"--weights", 0},
    [BOUND] = {"--bound", 1},
    [NOISE] = {"--noise", 1},
    [ALLAN] = {"--allan", 1},
    [WARM_UP] = {"--warm-up", 1},
    [DWELL] = {"--dwell", 1},
    [SETTLE] = {"--settle", 1},
    [MOVE] = {"--move", 1},
    [SVG] = {"--svg", 1},
    [REPORT] = {"--report", 1},
    [CSV] = {"--csv", 0},
    [UNITS] = {"--units", 1},
    [JSON] = {"--json", 0},
    [QUIET] = {"--quiet", 0},
};
static const char *const operands[] = {
    "SET", "a second SET for --compare (one alone is an option: --edges)"};
static const option_syntax syntax = {"plan", options, OPTIONS, operands, 2, 2};

#define WORD_MAX 4200u
#define COMMAND_MAX 2000u
#define ROWS_MAX (INVCAL_PLAN_PER_GROUP_MAX - INVCAL_PLAN_PER_GROUP_MIN + 1)

/* The command line. */
typedef struct {
    const char *operand[2];
    const char *value[OPTIONS];
    char word[WORD_MAX];       /* name of the set (DESIGN_WORDS) */
    int has_set;               /* a set was named */
    double limits[3];          /* over the noise of a position mean */
    choice_request choice;     /* its limits point to those above, or are null */
    char command[COMMAND_MAX]; /* the command line, for the report */
} request;

/* Too large for the stack. */
static design sets[2];
static plan_programs programs;
static labour tradeoff;
static turns_plan turns;

/* Defaults with --moves: consumer sensors. */
#define TURNS_NOISE 3e-4       /* of a position mean */
#define TURNS_RATE_NOISE 0.005 /* degrees/s/sqrt(Hz) */
#define TURNS_INSTABILITY 20.0 /* degrees/h */
#define TURNS_REST 2.0         /* seconds */
#define TURNS_SECONDS 1.5

static int usage(unsigned which, const char *what)
{
    return message_usage(syntax.command, "%s: %s", options[which].name, what);
}

/* A number within bounds, if it is stated. */
static int read_number(const request *r, unsigned which, double min, double max, double *out)
{
    if (!r->value[which]) {
        return EXIT_GOOD;
    }
    const int failure = options_numbers(&syntax, which, r->value[which], 1, out, NULL);
    if (!failure && !(*out >= min && *out <= max)) {
        return message_usage(syntax.command, "%s %s: must be within %g ... %g", options[which].name,
                             r->value[which], min, max);
    }
    return failure;
}

static int read_cost(request *r)
{
    design_cost *cost = &r->choice.cost;

    cost->dwell = 5;
    cost->move = 5;
    int failure = read_number(r, NOISE, 1e-12, 1, &cost->noise);
    failure = failure ? failure : read_number(r, WARM_UP, 0, 1e9, &cost->warm_up);
    failure = failure ? failure : read_number(r, DWELL, 1e-3, 1e6, &cost->dwell);
    failure = failure ? failure : read_number(r, SETTLE, 0, 1e6, &cost->settle);
    failure = failure ? failure : read_number(r, MOVE, 0, 1e6, &cost->move);
    failure = failure ? failure : read_number(r, BOUND, 1e-12, 1, &r->choice.bound);
    return failure ? failure : read_number(r, BUDGET, 1e-3, 1e9, &r->choice.budget);
}

/* With --moves. */
static int read_turns(const request *r, turns_request *out)
{
    const design_cost *cost = &r->choice.cost;
    double rate_noise = TURNS_RATE_NOISE;
    double instability = TURNS_INSTABILITY;

    *out = (turns_request){.rest = r->value[DWELL] ? cost->dwell : TURNS_REST,
                           .turn = TURNS_SECONDS,
                           .units = r->choice.units};
    out->noise = cost->noise > 0 ? cost->noise / sqrt(out->rest) : TURNS_NOISE;
    int failure = read_number(r, RATE_NOISE, 0, 10, &rate_noise);
    failure = failure ? failure : read_number(r, INSTABILITY, 0, 1e5, &instability);
    failure = failure ? failure : read_number(r, MOVE, 0.1, TURNS_SECONDS_MAX, &out->turn);
    out->rate_noise = rate_noise / FIGURE_DEGREES;
    out->instability = instability / FIGURE_DEGREES / 3600;
    if (!failure && out->noise + out->rate_noise + out->instability >= 0.5) {
        return usage(NOISE, "too large: with that noise, turns determine nothing");
    }
    return failure;
}

static int read_units(request *r)
{
    const char *text = r->value[UNITS];

    return text && !unit_style_parse(text, &r->choice.units)
               ? message_usage(syntax.command, "--units %s: must be everyday or ins", text)
               : EXIT_GOOD;
}

/* Requirements of a chosen set. */
static int read_demands(request *r)
{
    const unsigned max = OPTIMAL_MAX - INVCAL_PARAMETERS;
    double spare = CHOICE_SPARE;
    const int failure = read_number(r, SPARE, 0, max, &spare);

    if (!failure && floor(spare) < spare) {
        return message_usage(syntax.command, "--spare %s: must be a whole number", r->value[SPARE]);
    }
    r->choice.spare = failure ? 0 : (unsigned)spare;
    r->choice.needs_axes = r->value[NEED_AXES] != NULL;
    return failure;
}

/* With --allan: over the field, since the noise of a position mean is not known yet. */
static int read_field_limits(const request *r)
{
    const int failure =
        options_numbers(&syntax, LIMITS, r->value[LIMITS], 3, tradeoff.limits, NULL);

    for (unsigned i = 0; i < 3 && !failure; i++) {
        if (!(tradeoff.limits[i] >= 1e-9 && tradeoff.limits[i] <= 1)) {
            return usage(LIMITS, "must be within 1e-9 ... 1 of the field, 1 and rad");
        }
    }
    return failure;
}

/* Limits over the noise of a position mean, or, if that is stated, over the field. No limit is
 * above PLAN_WEAK, beyond which invcal calibrate calls a parameter weak. */
static int read_limits(request *r)
{
    const double unit = r->choice.cost.noise > 0 ? design_noise(&r->choice.cost) : 1;

    if (!r->value[LIMITS]) {
        return EXIT_GOOD;
    }
    if (r->value[ALLAN]) {
        return read_field_limits(r);
    }
    const int failure = options_numbers(&syntax, LIMITS, r->value[LIMITS], 3, r->limits, NULL);
    for (unsigned i = 0; i < 3 && !failure; i++) {
        r->limits[i] /= unit;
        if (!(r->limits[i] >= 1e-6 && r->limits[i] <= 1e6)) {
            return usage(LIMITS, "must be within 1e-6 ... 1e6 times the noise of a position mean");
        }
        r->limits[i] = fmin(r->limits[i], PLAN_WEAK);
    }
    r->choice.limits = r->limits;
    return failure;
}

/* The name of the set that an option states; per-group if there is no such option. */
static void write_word(request *r, int which)
{
    const char *const *value = r->value;
    const char *axes = value[NEED_AXES] ? ":axes" : "";

    if (which < 0 || which == PER_GROUP) {
        snprintf(r->word, sizeof r->word, "per-group:%s%s%s",
                 value[PER_GROUP] ? value[PER_GROUP] : "6", value[START] ? ":" : "",
                 value[START] ? value[START] : "");
    } else if (which == OPTIMAL && value[GRID]) {
        snprintf(r->word, sizeof r->word, "grid:%s:%s%s", value[GRID], value[OPTIMAL], axes);
    } else {
        snprintf(r->word, sizeof r->word, "%s%s%s%s", options[which].name + 2,
                 options[which].takes_value ? ":" : "", value[which], which == OPTIMAL ? axes : "");
    }
}

/* Finds the one option that states a set, and writes the name of the set. */
static int read_set(request *r)
{
    static const unsigned named[] = {PER_GROUP, FACES,   EDGES,  ICOSAHEDRON, STAND_12,
                                     STAND_24,  OPTIMAL, ANGLES, DIRECTIONS};
    const char *const *value = r->value;
    int which = -1;

    for (unsigned i = 0; i < sizeof named / sizeof named[0]; i++) {
        if (!value[named[i]] || (named[i] == FACES && value[EDGES])) {
            continue; /* edges include the faces */
        }
        if (which >= 0) {
            return usage(named[i], "give only one set of positions; --compare takes two");
        }
        which = (int)named[i];
    }
    if (value[START] && which >= 0 && which != PER_GROUP) {
        return usage(START, "needs --per-group");
    }
    if (value[PER_GROUP] && strchr(value[PER_GROUP], ':')) {
        return usage(PER_GROUP, "must be a number; use --start for the angles");
    }
    if (value[OPTIMAL] && strchr(value[OPTIMAL], ':')) {
        return usage(OPTIMAL, "must be a number; see --grid and --need-axes");
    }
    r->has_set = which >= 0 || value[START];
    write_word(r, which);
    return EXIT_GOOD;
}

/* Refuses what --allan cannot be combined with. */
static int check_allan(const request *r)
{
    static const unsigned others[] = {NOISE, DWELL, BUDGET, SWEEP, COMPARE, PROGRAMS, MOVES};

    if (!r->value[LIMITS] || r->has_set) {
        return usage(ALLAN, "chooses the set for --limits; state --limits and no other set");
    }
    for (unsigned i = 0; i < sizeof others / sizeof others[0]; i++) {
        if (r->value[others[i]]) {
            return message_usage(syntax.command,
                                 "%s: cannot be combined with --allan: leave one out",
                                 options[others[i]].name);
        }
    }
    return EXIT_GOOD;
}

/* The option that names its own sets: --sweep, --compare, --programs or --moves; else OPTIONS. */
static unsigned several_option(const request *r)
{
    return r->value[SWEEP]      ? SWEEP
           : r->value[COMPARE]  ? COMPARE
           : r->value[PROGRAMS] ? PROGRAMS
           : r->value[MOVES]    ? MOVES
                                : OPTIONS;
}

/* Refuses what these cannot be combined with. */
static int check_several(const request *r, unsigned several)
{
    static const unsigned single[] = {WEIGHTS, BOUND, CSV};
    static const unsigned all[] = {SWEEP, COMPARE, PROGRAMS, MOVES};
    const char *const *value = r->value;

    if (r->has_set) {
        return usage(several, "names its own sets; leave out the other set");
    }
    for (unsigned i = 0; i < sizeof all / sizeof all[0]; i++) {
        if (value[all[i]] && all[i] != several) {
            return message_usage(syntax.command, "%s: cannot be combined with %s: leave one out",
                                 options[several].name, options[all[i]].name);
        }
    }
    if (value[SWEEP] &&
        (value[NOISE] || value[DWELL] || value[SETTLE] || value[MOVE] || value[WARM_UP])) {
        return usage(
            SWEEP,
            "does not use times or noise; leave out --noise, --dwell, --settle, --move, --warm-up");
    }
    if (value[LIMITS] || value[BUDGET]) {
        return usage(value[LIMITS] ? LIMITS : BUDGET,
                     "chooses a set; leave out --sweep, --compare, --programs and --moves");
    }
    if (value[PROGRAMS] && (value[SVG] || value[REPORT])) {
        return usage(value[SVG] ? SVG : REPORT, "--programs prints a table only");
    }
    for (unsigned i = 0; i < sizeof single / sizeof single[0]; i++) {
        if (value[single[i]]) {
            return message_usage(syntax.command, "%s: needs a single set; leave out %s",
                                 options[single[i]].name, options[several].name);
        }
    }
    return EXIT_GOOD;
}

/* Options that need --moves, and those that it does not use. */
static int check_turns(const request *r)
{
    static const unsigned own[] = {RATE_NOISE, INSTABILITY};
    static const unsigned none[] = {SVG, WARM_UP, SETTLE};
    const int is_asked = r->value[MOVES] != NULL;

    for (unsigned i = 0; i < sizeof own / sizeof own[0] && !is_asked; i++) {
        if (r->value[own[i]]) {
            return usage(own[i], "needs --moves");
        }
    }
    for (unsigned i = 0; i < sizeof none / sizeof none[0] && is_asked; i++) {
        if (r->value[none[i]]) {
            return message_usage(syntax.command,
                                 "%s: cannot be combined with --moves: leave one out",
                                 options[none[i]].name);
        }
    }
    return EXIT_GOOD;
}

/* Requirements of a set, and its output. */
static int check_demands(const request *r)
{
    const char *const *value = r->value;
    const int is_choice = value[LIMITS] || value[BUDGET];

    if ((value[NEED_AXES] || value[SPARE]) && !is_choice && !value[OPTIMAL]) {
        return usage(value[NEED_AXES] ? NEED_AXES : SPARE, "needs --limits, --budget or --optimal");
    }
    if (value[GRID] && !value[OPTIMAL]) {
        return usage(GRID, "needs --optimal");
    }
    if (value[GRID] && value[LIMITS]) {
        return usage(GRID, "cannot be combined with --limits: leave one out");
    }
    if (value[WEIGHTS] && is_choice) {
        return usage(WEIGHTS, "needs a named set; leave out --limits, --budget, --allan");
    }
    return value[CSV] && value[JSON] ? usage(CSV, "cannot be combined with --json: leave one out")
                                     : EXIT_GOOD;
}

/* Refuses combinations of options. */
static int check(const request *r)
{
    const char *const *value = r->value;
    const unsigned several = several_option(r);
    int failure = value[ALLAN] ? check_allan(r) : EXIT_GOOD;

    failure = failure || several == OPTIONS ? failure : check_several(r, several);
    failure = failure ? failure : check_turns(r);
    failure = failure ? failure : check_demands(r);
    if (failure || value[ALLAN]) {
        return failure;
    }
    if (!value[COMPARE] && r->operand[0]) {
        return message_usage(
            syntax.command,
            "'%s': one operand too many: a set is an option, such as --edges; only "
            "--compare takes its name",
            r->operand[0]);
    }
    if (value[COMPARE] && !r->operand[0]) {
        return usage(COMPARE, "takes two sets, for example: --compare per-group:8 per-group:6");
    }
    if (value[BUDGET] && r->has_set) {
        return usage(BUDGET, "chooses a set; leave out the other");
    }
    if (value[LIMITS] && r->has_set && !value[OPTIMAL]) {
        return usage(LIMITS, "chooses a set, or works with --optimal N; leave out the other");
    }
    return EXIT_GOOD;
}

static int check_files(const request *r)
{
    const named_file inputs[] = {{"--angles", r->value[ANGLES]},
                                 {"--directions", r->value[DIRECTIONS]},
                                 {"--allan", r->value[ALLAN]},
                                 {"--compare", design_file(r->operand[0])},
                                 {"--compare", design_file(r->operand[1])}};
    const named_file outputs[] = {{"--svg", r->value[SVG]}, {"--report", r->value[REPORT]}};

    return files_check(syntax.command, inputs, 5, outputs, 2);
}

static int read_request(int argc, char **argv, request *r)
{
    *r = (request){0};
    int failure = options_parse(&syntax, argc, argv, r->value, r->operand);

    failure = failure ? failure : check_files(r);
    failure = failure ? failure : read_set(r);
    failure = failure ? failure : check(r);
    failure = failure ? failure : read_cost(r);
    failure = failure ? failure : read_demands(r);
    failure = failure ? failure : read_units(r);
    options_command(syntax.command, argc, argv, r->command, sizeof r->command);
    return failure ? failure : read_limits(r);
}

/* The result: one set, with the choice that led to it if there was one; two sets; a sweep; the
 * known programs; or turns. Other members are null. */
typedef struct {
    const request *request;
    const design *set[2];
    const choice *choice;
    const plan_sweep *sweep;
    const plan_programs *programs;
    const turns_plan *turns;
} result;

typedef void result_writer(FILE *file, const result *found);

static void write_svg(FILE *file, const result *found)
{
    if (found->sweep) {
        plan_svg_sweep(file, found->sweep);
    } else if (found->set[1]) {
        plan_svg_comparison(file, found->set[0], found->set[1], &found->request->choice);
    } else if (found->request->choice.labour) {
        labour_svg(file, found->request->choice.labour);
    } else {
        plan_svg_directions(file, found->set[0]);
    }
}

static void write_report(FILE *file, const result *found)
{
    const char *command = found->request->command;

    if (found->turns) {
        turns_report(file, found->turns, command);
    } else if (found->sweep) {
        plan_report_sweep(file, found->sweep, command);
    } else if (found->set[1]) {
        plan_report_comparison(file, found->set[0], found->set[1], &found->request->choice,
                               command);
    } else {
        plan_report(file, found->set[0], &found->request->choice, found->choice, command);
    }
}

static void print_json(FILE *file, const result *found)
{
    if (found->turns) {
        turns_json(file, found->turns);
    } else if (found->programs) {
        plan_programs_json(file, found->programs, &found->request->choice);
    } else if (found->sweep) {
        plan_json_sweep(file, found->sweep);
    } else if (found->set[1]) {
        plan_json_comparison(file, found->set[0], found->set[1], &found->request->choice);
    } else {
        plan_json(file, found->set[0], &found->request->choice, found->choice);
    }
}

static void print_result(FILE *file, const result *found)
{
    if (found->request->value[JSON]) {
        print_json(file, found);
    } else if (found->request->value[CSV]) {
        plan_csv(file, found->set[0], &found->request->choice.cost);
    } else if (found->request->value[QUIET]) {
        return;
    } else if (found->turns) {
        turns_print(file, found->turns);
    } else if (found->programs) {
        plan_programs_print(file, found->programs, &found->request->choice);
    } else if (found->sweep) {
        plan_print_sweep(file, found->sweep);
    } else if (found->set[1]) {
        plan_print_comparison(file, found->set[0], found->set[1], &found->request->choice);
    } else {
        plan_print(file, found->set[0], &found->request->choice, found->choice);
    }
}

/* Writes a file, if it is requested, under a temporary name. */
static int begin_file(output *out, const char *path, result_writer *write, const result *found)
{
    if (!path) {
        return EXIT_GOOD;
    }
    const int failure = output_begin(out, path);
    if (failure) {
        return failure;
    }
    write(out->file, found);
    return output_finish(out);
}

/* Files get their names only after everything has been written. */
static int deliver(const result *found)
{
    const char *const *value = found->request->value;
    output files[2] = {{0}};
    int failure = begin_file(&files[0], value[SVG], write_svg, found);

    failure = failure ? failure : begin_file(&files[1], value[REPORT], write_report, found);
    if (!failure) {
        print_result(stdout, found);
        failure = output_flush();
    }
    return output_end(files, 2, failure);
}

/* A refusal, with the set if there is one to show. */
static int refuse(const request *r, const design *d, const char *reason)
{
    if (d && d->count > 0 && !r->value[COMPARE] && !r->value[CSV]) {
        const result found = {.request = r, .set = {d}};
        print_result(stdout, &found);
    } else if (r->value[JSON]) {
        plan_json_refusal(stdout, reason, d ? d->undetermined : 0);
    }
    if (d && d->count > 0) {
        message("%s: %s", d->name, reason);
    } else {
        message("%s", reason);
    }
    return EXIT_DATA;
}

/* --spare and --optimal N. */
static int check_spare(const request *r, const design *d)
{
    if (r->value[SPARE] && d->count < choice_min_count(&r->choice)) {
        return message_usage(syntax.command, "--spare %s: --optimal %s has a redundancy of only %u",
                             r->value[SPARE], r->value[OPTIMAL], d->count - INVCAL_PARAMETERS);
    }
    return EXIT_GOOD;
}

static int show(request *r)
{
    const result found = {.request = r, .set = {&sets[0]}};
    int failure = design_make(&sets[0], syntax.command, r->word);

    if (failure == EXIT_DATA) {
        return refuse(r, &sets[0], sets[0].refusal);
    }
    failure = failure ? failure : check_spare(r, &sets[0]);
    if (failure) {
        return failure;
    }
    if (r->choice.limits) { /* with --optimal: as many positions, optimal for the limits */
        design_balanced(&sets[0], sets[0].count, r->limits, r->choice.needs_axes);
    }
    if (sets[0].dwell > 0 && !r->value[DWELL]) {
        r->choice.cost.dwell = sets[0].dwell;
    }
    if (sets[0].is_solvable && r->value[WEIGHTS]) {
        design_weigh(&sets[0]);
    }
    return sets[0].is_solvable ? deliver(&found) : refuse(r, &sets[0], sets[0].refusal);
}

static int compare(const request *r)
{
    const result found = {.request = r, .set = {&sets[0], &sets[1]}};

    for (unsigned i = 0; i < 2; i++) {
        const int failure = design_make(&sets[i], syntax.command, r->operand[i]);
        if (failure) {
            return failure == EXIT_DATA ? refuse(r, &sets[i], sets[i].refusal) : failure;
        }
    }
    return deliver(&found);
}

static int show_programs(const request *r)
{
    const result found = {.request = r, .programs = &programs};

    plan_programs_make(&programs);
    return deliver(&found);
}

/* Turns that determine too little are also shown, on the page too. */
static int show_turns(const request *r)
{
    const result found = {.request = r, .turns = &turns};
    turns_request settings = {0};
    int failure = read_turns(r, &settings);

    failure = failure ? failure : turns_make(&turns, r->value[MOVES], &settings);
    if (failure && failure != EXIT_DATA) {
        return failure;
    }
    const int written = deliver(&found);
    if (!written && failure) {
        message("%s: %s", turns.program, turns.refusal);
    }
    return written ? written : failure;
}

static int choose(const request *r)
{
    choice c = {.set = {&sets[0], &sets[1]}};
    const int failure = choice_make(&c, &r->choice);
    const result found = {.request = r, .set = {c.set[c.chosen]}, .choice = &c};

    return failure ? refuse(r, NULL, c.refusal) : deliver(&found);
}

/* Chooses number of positions and dwell. */
static int find_labour(request *r)
{
    const result found = {.request = r, .set = {&sets[0]}};

    tradeoff.noise_name = r->value[ALLAN];
    tradeoff.settle = r->choice.cost.settle;
    tradeoff.move = r->choice.cost.move;
    tradeoff.warm_up = r->choice.cost.warm_up;
    tradeoff.min_count = choice_min_count(&r->choice);
    tradeoff.needs_axes = r->choice.needs_axes;
    tradeoff.units = r->choice.units;
    int failure = noise_file_read(r->value[ALLAN], tradeoff.noise);
    if (failure) {
        return failure;
    }
    failure = labour_find(&tradeoff, &sets[0]);
    if (failure) {
        return refuse(r, NULL, tradeoff.refusal);
    }
    labour_request(&tradeoff, r->limits, &r->choice);
    return deliver(&found);
}

/* FROM:TO, both from 5 to 1000. */
static int read_sweep(const request *r, unsigned *from, unsigned *to)
{
    const char *text = r->value[SWEEP];
    char rest;

    if (strspn(text, "0123456789:") != strlen(text) ||
        /* NOLINTNEXTLINE(cert-err34-c): digits, and too few for an overflow */
        sscanf(text, "%4u:%4u%c", from, to, &rest) != 2 || *from < INVCAL_PLAN_PER_GROUP_MIN ||
        *to > INVCAL_PLAN_PER_GROUP_MAX || *from > *to) {
        return usage(SWEEP,
                     "must be FROM:TO, positions per group, from 5 to 1000, for example 5:16");
    }
    return EXIT_GOOD;
}

static int sweep(const request *r)
{
    static plan_row rows[ROWS_MAX];
    unsigned from = 0;
    unsigned to = 0;
    const int failure = read_sweep(r, &from, &to);

    if (failure) {
        return failure;
    }
    for (unsigned n = from; n <= to; n++) {
        const invcal_plan plan = stand_plan_make(n);
        design_stand(&sets[0], &plan);
        rows[n - from] = (plan_row){n, sets[0].criteria, sets[0].axes};
    }
    plan_programs_make(&programs);
    const plan_sweep s = {rows, to - from + 1, &programs};
    const result found = {.request = r, .sweep = &s};
    return deliver(&found);
}

static int run(int argc, char **argv)
{
    static request r;
    const int failure = read_request(argc, argv, &r);

    if (failure) {
        return failure;
    }
    if (r.value[ALLAN]) {
        return find_labour(&r);
    }
    if (r.value[SWEEP]) {
        return sweep(&r);
    }
    if (r.value[COMPARE]) {
        return compare(&r);
    }
    if (r.value[PROGRAMS]) {
        return show_programs(&r);
    }
    if (r.value[MOVES]) {
        return show_turns(&r);
    }
    return (r.value[LIMITS] || r.value[BUDGET]) && !r.has_set ? choose(&r) : show(&r);
}

static const char *const help[] = {
    "usage: invcal plan [--per-group N [--start A,B,C] | --faces | --edges | --icosahedron |\n"
    "                    --stand-12 | --stand-24 | --optimal N [--grid S] | --angles FILE |\n"
    "                    --directions FILE] [options]\n"
    "       invcal plan --limits D,K,G [--budget SECONDS] [options]\n"
    "       invcal plan --budget SECONDS [options]\n"
    "       invcal plan --limits D,K,G --allan NOISE.json [--settle T] [--move T] [options]\n"
    "       invcal plan --sweep FROM:TO [--svg FILE] [--report FILE] [--json]\n"
    "       invcal plan --compare SET SET [--svg FILE] [--report FILE] [--json]\n"
    "       invcal plan --programs [--noise S] [--warm-up T] [--dwell T] [--json]\n"
    "       invcal plan --moves PROGRAM [--noise S] [--rate-noise N] [--instability B]\n"
    "                   [--dwell T] [--move T] [--report FILE] [--json]\n"
    "\n"
    "Shows which positions to visit, and how accurately they determine the nine parameters:\n"
    "the standard deviations sigma of offsets, scale errors and angles, over the noise of a\n"
    "position mean; also of quadratic and cubic errors of the axes, if they are estimated too\n"
    "(calibrate --quadratic, --cubic). alpha and beta are the angles of a two-axis stand; x y\n"
    "z is the up direction in the frame of the case, for a device held in the hand.\n"
    "\n"
    "  --per-group N       three groups of N positions for a two-axis stand, N from 5 to\n"
    "                      1000 (the paper's program: Egorov et al. 2019, see the manual);\n"
    "                      default 6, the program of 18 positions\n"
    "  --start A,B,C       start angles of the groups, degrees; default: each axis points up\n"
    "                      and down along gravity, if N is even\n"
    "  --faces             each axis up and down: 6 positions, too few for nine parameters\n"
    "  --edges             the faces and the 12 edges, midway between two axes: 18 positions\n"
    "  --icosahedron       its 12 vertices\n"
    "  --stand-12          the program of 18 without the six positions in which an axis is\n"
    "                      along gravity: a redundancy of three\n"
    "  --stand-24          three groups of eight positions, in steps of 45 degrees: 18\n"
    "                      directions, of which six are visited twice\n"
    "  --optimal N         N positions, 9 to 144, with the largest determinant of H'H\n"
    "                      (D-optimal); with --limits, those whose worst ratio of a sigma to\n"
    "                      its limit is the smallest\n"
    "  --grid S            with --optimal: for a stand that stops every S degrees in alpha\n"
    "                      and beta; S is 15, 30 or 45\n"
    "  --angles FILE       columns alpha and beta of a table, degrees, as written by --csv;\n"
    "                      the mean of a column dwell, seconds, is the default of --dwell\n"
    "  --directions FILE   columns x y z of a table: up directions, whose length is ignored;\n"
    "                      - reads the standard input\n",
    "  --limits D,K,G      choose the smallest set whose sigmas of offsets, scale errors and\n"
    "                      angles are within these limits. Without --noise they are multiples\n"
    "                      of the noise of a position mean; with it, D is over the field\n"
    "                      (0.001 is 1 mg), K a part of the scale (0.001 is 0.1 %) and G in\n"
    "                      rad. No sigma is above 10 times the noise, which invcal calibrate\n"
    "                      would call weak\n"
    "  --budget SECONDS    choose the set with the largest determinant that fits into this\n"
    "                      time; with --limits: only sets that fit. Both choose among the\n"
    "                      sets of --per-group and up to 144 free directions\n"
    "  --spare N           minimum redundancy of a chosen set: positions beyond the nine that\n"
    "                      nine parameters need; default 3. With --optimal: refuse an N\n"
    "                      with fewer\n"
    "  --need-axes         require each axis up and down along gravity, in a chosen set and\n"
    "                      with --optimal\n"
    "  --weights           distribute the time over the positions for the largest det H'H\n"
    "                      (D-optimal); --dwell is then the mean\n"
    "  --bound E           worst-case error of each parameter if no position mean is off by\n"
    "                      more than E of the field: E times the sum of |H+| over its row\n"
    "  --noise S           noise of the mean of one second at rest, over the field (0.0001 is\n"
    "                      0.1 mg). With --moves, the default is 0.3 mg for a position mean\n"
    "  --allan NOISE.json  noise measured by invcal allan --out: chooses the number of\n"
    "                      positions, up to 144, and the seconds in each, 2 or more, for the\n"
    "                      least total time; --limits are then those with --noise\n"
    "  --warm-up T         seconds to wait once, before the first position; default 0\n"
    "  --dwell T           seconds in each position; default 5, with --moves 2\n"
    "  --settle T          seconds to wait before that in each position, which are not\n"
    "                      measured; default 0 (invcal calibrate cuts about 0.75 s off a\n"
    "                      rest)\n"
    "  --move T            seconds from one position to the next; default 5. With --moves: of\n"
    "                      a quarter turn, larger turns in proportion; default 1.5\n"
    "  --sweep FROM:TO     show the sets of --per-group for each N in the range\n"
    "  --compare SET SET   compare two sets, each one of:\n",
    DESIGN_WORDS,
    "  --programs          compare the programs of 15, 18 and 24 positions, six faces and\n"
    "                      twelve edges, stand-12 and the icosahedron with that of 18\n",
    "  --moves tour12|tour16|tour24|faces|greedy12|LIST\n"
    "                      turns of a gyroscope next to the accelerometer, in words, and how\n"
    "                      accurately they determine the 18 parameters of both: tour12,\n"
    "                      twelve quarter turns through the six faces; tour16, with a full\n"
    "                      turn about each axis added; tour24, the twelve and back; faces,\n"
    "                      nine quarter turns and a full one about each axis; greedyN, N\n"
    "                      turns, each the most informative one; or a list such as\n"
    "                      +z,+x,+y-z,x:360: what points up in the first rest, then what\n"
    "                      comes up, or the axis to turn about and degrees\n"
    "  --rate-noise N      with --moves: noise of the gyroscope, degrees/s/sqrt(Hz); default\n"
    "                      0.005\n"
    "  --instability B     with --moves: instability of its bias, degrees/h; default 20\n"
    "  --svg FILE          draw the directions; with --sweep: sigma against the number of\n"
    "                      positions, and those of --programs; with --compare: the ratios of\n"
    "                      the second set to the first; with --allan: total time against the\n"
    "                      number of positions\n"
    "  --report R.html     write a page with the verdict, a work sheet to take to the stand,\n"
    "                      and pictures: one self-contained file, for screen and paper\n"
    "  --csv               print the positions only, for a stand's controller: number, alpha,\n"
    "                      beta, dwell, and up as x, y, z\n"
    "  --units everyday|ins\n"
    "                      units of sigma with --noise, --allan and --bound, in table and\n"
    "                      report: mg, % and degrees (default), or those of inertial\n"
    "                      navigation: ug, ppm and arcsec. Ratios to the noise have no unit\n"
    "  --json              print the result as JSON instead of the table\n"
    "  --quiet             print no table, only errors\n"
    "\n"
    "exit codes: 0 good; 1 the positions or turns do not determine a calibration, or no set\n"
    "meets the limits; 2 usage; 3 a file unreadable or malformed, or the output not writable\n"
    "\n"
    "examples:\n"
    "  invcal plan\n"
    "  invcal plan --limits 0.4,0.6,1 --svg directions.svg\n"
    "  invcal plan --per-group 8 --noise 0.0001 --report program.html\n"
    "  invcal plan --compare per-group:8 per-group:6 --report compared.html\n"
    "  invcal plan --optimal 12 --grid 30 --csv > stand.csv\n"
    "  invcal plan --angles stand.csv --bound 0.0002 --warm-up 600\n"
    "  invcal plan --moves tour12 --report turns.html\n",
    NULL};

static const char *const brief[] = {
    "usage: invcal plan [--per-group N | --edges | --optimal N | ...] [options]\n"
    "       invcal plan --limits D,K,G [--budget SECONDS] [options]\n"
    "       invcal plan --compare SET SET | --sweep FROM:TO | --programs | --moves PROGRAM\n"
    "\n"
    "Shows which positions to visit, and how accurately they determine the nine parameters.\n"
    "\n"
    "  --per-group N       three groups of N positions for a two-axis stand; default 6\n"
    "  --edges             18 positions for a device held in the hand\n"
    "  --optimal N         N positions, 9 to 144, with the largest determinant\n"
    "  --limits D,K,G      the smallest set with sigmas within these limits\n"
    "  --noise S           noise of the mean of one second at rest, over the field\n"
    "  --allan NOISE.json  noise measured by invcal allan: also chooses the dwell\n"
    "  --moves tour12      turns for a gyroscope, in words, and what they determine\n"
    "  --svg FILE          draw the directions; --report R.html: a page with a work sheet\n"
    "  --csv               print the positions only; --json: the result as JSON\n"
    "\n"
    "example:\n"
    "  invcal plan --limits 0.4,0.6,1 --svg directions.svg\n",
    NULL};

const tool_command plan_command = {"plan", "choose positions, and predict the accuracy", help, run,
                                   brief};
