/* SPDX-License-Identifier: MIT */
#include "design/design.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/positions.h"
#include "maths/angles.h"
#include "read/angles_file.h"
#include "cli/command.h"
#include "design/grid.h"
#include "cli/message.h"
#include "text/number.h"
#include "design/optimal.h"
#include "design/order.h"
#include "design/parameters.h"
#include "read/positions.h"
#include "design/weights.h"
#include "plan/guidance.h"

#define SAME 1e-9 /* directions that differ by less */

const char *design_axis_name(unsigned axis)
{
    static const char *const names[INVCAL_AXES] = {"+x", "-x", "+y", "-y", "+z", "-z"};

    return names[axis];
}

design_labour design_labour_of(unsigned count, const design_cost *cost)
{
    return (design_labour){cost->warm_up, count * cost->settle, (count - 1.0) * cost->move,
                           count * cost->dwell};
}

double design_seconds(unsigned count, const design_cost *cost)
{
    const design_labour l = design_labour_of(count, cost);

    return l.warm_up + l.settling + l.turning + l.recording;
}

double design_begins(const design *d, unsigned n, const design_cost *cost)
{
    double share = 0;

    for (unsigned i = 0; i < n; i++) {
        share += d->position[i].share;
    }
    return cost->warm_up + n * (cost->settle + cost->move) + share * cost->dwell;
}

double design_noise(const design_cost *cost)
{
    return cost->noise / sqrt(cost->dwell);
}

int design_has_groups(const design *d)
{
    return d->count > 0 && d->position[0].group > 0;
}

static const invcal_calibration unit = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/* The directions as readings of a perfect triad; until the next call. */
static invcal_positions readings(const design *d)
{
    static invcal_vector up[DESIGN_MAX];

    for (unsigned n = 0; n < d->count; n++) {
        memcpy(up[n].v, d->position[n].vertical, sizeof up[n].v);
    }
    return (invcal_positions){.mean = up, .count = d->count, .nominal = &unit};
}

void design_next(const design *d, double up[3])
{
    const invcal_positions given = readings(d);

    invcali_next(&given, up);
}

/* The same in threes. */
static const double (*directions(const design *d))[3]
{
    return (const double(*)[3])readings(d).mean;
}

static const double *shares(const design *d)
{
    static double share[DESIGN_MAX];

    for (unsigned n = 0; n < d->count; n++) {
        share[n] = d->position[n].share;
    }
    return share;
}

unsigned design_distinct(const design *d)
{
    unsigned distinct = 0;

    for (unsigned n = 0; n < d->count; n++) {
        const double *v = d->position[n].vertical;
        unsigned i = 0;
        while (i < n &&
               !(hypot(hypot(v[0] - d->position[i].vertical[0], v[1] - d->position[i].vertical[1]),
                       v[2] - d->position[i].vertical[2]) < SAME)) {
            i++;
        }
        distinct += i == n;
    }
    return distinct;
}

static void refuse(design *d)
{
    char list[128];
    char advice[128];

    snprintf(d->refusal, sizeof d->refusal,
             "the positions leave parameters undetermined%s%s; add positions with %s",
             d->undetermined ? ": " : "", parameters_list(d->undetermined, list, sizeof list),
             parameters_advice(d->undetermined, advice, sizeof advice));
}

/* Range and axes of the positions that are held at all. */
static void find_coverage(design *d)
{
    int is_first = 1;

    d->axes = 0;
    for (unsigned n = 0; n < d->count; n++) {
        const double *v = d->position[n].vertical;
        if (!(d->position[n].share > 0)) {
            continue;
        }
        d->axes |= invcali_axis_up(v);
        for (unsigned i = 0; i < 3; i++) {
            d->range[i][0] = is_first || v[i] < d->range[i][0] ? v[i] : d->range[i][0];
            d->range[i][1] = is_first || v[i] > d->range[i][1] ? v[i] : d->range[i][1];
        }
        is_first = 0;
    }
}

static void evaluate(design *d)
{
    invcal_sums_init(&d->sums);
    for (unsigned n = 0; n < d->count; n++) {
        criteria_add_weighted(&d->sums, d->position[n].vertical, d->position[n].share);
    }
    find_coverage(d);
    d->is_solvable = criteria_evaluate(&d->sums, &d->criteria);
    d->criteria.positions = d->count;
    d->drift_factor = order_drift_factor(directions(d), shares(d), d->count);
    const invcal_positions given = readings(d);
    d->undetermined = d->is_solvable ? 0 : invcal_undetermined(&given);
    if (!d->is_solvable) {
        refuse(d);
    }
}

/* `share` of the time, times the number of positions. Keeps ln det H'H for equal ones. */
static void set_shares(design *d, const double *share)
{
    d->equal_log_det = d->is_solvable ? d->criteria.log_det : (double)NAN;
    d->has_shares = 1;
    for (unsigned n = 0; n < d->count; n++) {
        d->position[n].share = share[n];
    }
    evaluate(d);
}

void design_weigh(design *d)
{
    static double share[DESIGN_MAX];

    weights_find(directions(d), d->count, share);
    d->has_shares = 0;
    for (unsigned n = 0; n < d->count; n++) {
        d->position[n].share = 1;
    }
    evaluate(d);
    set_shares(d, share);
}

/* An empty set of this name. */
static void begin(design *d, const char *name)
{
    snprintf(d->name, sizeof d->name, "%s", name);
    d->plan = (invcal_plan){0};
    d->is_stand = 0;
    d->has_shares = 0;
    d->dwell = 0;
    d->count = 0;
}

void design_stand(design *d, const invcal_plan *plan)
{
    char name[sizeof d->name];

    snprintf(name, sizeof name, "3 x %u", plan->per_group);
    begin(d, name);
    d->plan = *plan;
    d->is_stand = 1;
    d->count = INVCAL_PLAN_GROUPS * plan->per_group;
    for (unsigned i = 0; i < d->count; i++) {
        const invcal_plan_position p = stand_plan_at(plan, i);
        d->position[i].group = p.group;
        d->position[i].alpha = p.alpha_deg;
        d->position[i].beta = p.beta_deg;
        d->position[i].share = 1;
        memcpy(d->position[i].vertical, p.up, sizeof p.up);
    }
    evaluate(d);
}

void design_directions(design *d, const char *name, double (*direction)[3], unsigned count)
{
    begin(d, name);
    d->count = count;
    for (unsigned n = 0; n < count; n++) {
        design_position *p = &d->position[n];
        memcpy(p->vertical, direction[n], sizeof direction[n]);
        const stand_angles a = angles_of(p->vertical);
        p->group = 0;
        p->share = 1;
        p->alpha = a.alpha;
        p->beta = a.beta;
    }
    evaluate(d);
}

/* Makes and evaluates a set of a stand's angles. */
static void design_angles(design *d, const char *name, const stand_angles *angle, unsigned count)
{
    begin(d, name);
    d->is_stand = 1;
    d->count = count;
    for (unsigned n = 0; n < count; n++) {
        design_position *p = &d->position[n];
        p->group = 0;
        p->share = 1;
        p->alpha = angle[n].alpha;
        p->beta = angle[n].beta;
        angles_direction(p->alpha, p->beta, p->vertical);
    }
    evaluate(d);
}

void design_balanced(design *d, unsigned count, const double limits[3], int with_axes)
{
    double direction[OPTIMAL_MAX][3];

    (void)optimal_within(count, limits, with_axes, direction);
    order_directions(direction, count);
    design_directions(d, "free directions", direction, count);
}

static unsigned add_direction(double (*direction)[3], unsigned count, double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z);
    const double v[3] = {x / length, y / length, z / length};

    memcpy(direction[count], v, sizeof v);
    return count + 1;
}

static unsigned add_faces(double (*direction)[3], unsigned count)
{
    for (int sign = 1; sign >= -1; sign -= 2) {
        count = add_direction(direction, count, sign, 0, 0);
        count = add_direction(direction, count, 0, sign, 0);
        count = add_direction(direction, count, 0, 0, sign);
    }
    return count;
}

/* (0 +-a +-b) and its cyclic permutations: edges for a = b, for the golden section the vertices of
 * an icosahedron. */
static unsigned add_pairs(double (*direction)[3], unsigned count, double a, double b)
{
    for (int i = 0; i < 4; i++) {
        const double p = i & 1 ? -a : a;
        const double q = i & 2 ? -b : b;
        count = add_direction(direction, count, 0, p, q);
        count = add_direction(direction, count, q, 0, p);
        count = add_direction(direction, count, p, q, 0);
    }
    return count;
}

static void make_solid(design *d, const char *name)
{
    double direction[18][3];
    unsigned count = 0;

    if (strcmp(name, "icosahedron") == 0) {
        count = add_pairs(direction, 0, 1, (1 + sqrt(5)) / 2);
    } else {
        count = add_faces(direction, 0);
    }
    if (strcmp(name, "edges") == 0) {
        count = add_pairs(direction, count, 1, 1);
    }
    order_directions(direction, count);
    design_directions(d, name, direction, count);
}

/* A whole number from `min` to `max`. */
static int read_count(const char *command, const char *what, const char *text, unsigned min,
                      unsigned max, unsigned *out)
{
    double x;
    const number_status status = number_parse(text, &x);

    if (status != NUMBER_OK) {
        return message_usage(command, "%s: '%s' %s", what, text, number_problem(status));
    }
    if (!(x >= min && x <= max && !(floor(x) < x))) {
        return message_usage(command, "%s: '%s': a whole number from %u to %u expected", what, text,
                             min, max);
    }
    *out = (unsigned)x;
    return EXIT_GOOD;
}

/* A,B,C in degrees. */
static int read_starts(const char *command, const char *text, double start[3])
{
    char item[3][64];
    char rest;

    if (sscanf(text, "%63[^,],%63[^,],%63[^,]%c", item[0], item[1], item[2], &rest) != 3) {
        return message_usage(
            command, "per-group: '%s': three start angles expected, separated by commas", text);
    }
    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        const number_status status = number_parse(item[g], &start[g]);
        if (status != NUMBER_OK) {
            return message_usage(command, "per-group: start angle '%s' %s", item[g],
                                 number_problem(status));
        }
        if (!(fabs(start[g]) <= 360)) {
            return message_usage(
                command, "per-group: start angle '%s' is out of range, -360 ... 360", item[g]);
        }
    }
    return EXIT_GOOD;
}

/* N or N:A,B,C. */
static int make_stand(design *d, const char *command, const char *text)
{
    invcal_plan plan = {0};
    unsigned per_group;
    char count[64];
    const size_t length = strcspn(text, ":");

    snprintf(count, sizeof count, "%.*s", (int)length, text);
    int failure = read_count(command, "per-group", count, 1, INVCAL_PLAN_PER_GROUP_MAX, &per_group);
    if (!failure && text[length] == ':') {
        plan.per_group = per_group;
        failure = read_starts(command, text + length + 1, plan.start_deg);
    } else if (!failure) {
        plan = stand_plan_make(per_group); /* per_group is checked below */
    }
    if (failure) {
        return failure;
    }
    if (per_group < INVCAL_PLAN_PER_GROUP_MIN) {
        d->count = 0;
        d->is_solvable = 0;
        d->undetermined = (1u << INVCAL_PARAMETERS) - 1;
        snprintf(d->refusal, sizeof d->refusal,
                 "%u position%s in a group %s too few: a group determines five coefficients, so it "
                 "needs 5 or more",
                 per_group, per_group == 1 ? "" : "s", per_group == 1 ? "is" : "are");
        return EXIT_DATA;
    }
    design_stand(d, &plan);
    return EXIT_GOOD;
}

/* The 18 positions of the paper without those on the axes. */
static void make_stand_12(design *d, const char *name)
{
    const invcal_plan plan = stand_plan_make(6);
    unsigned count = 0;

    design_stand(d, &plan);
    for (unsigned n = 0; n < d->count; n++) {
        if (!invcali_axis_up(d->position[n].vertical)) {
            d->position[count++] = d->position[n];
        }
    }
    begin(d, name);
    d->is_stand = 1;
    d->count = count;
    evaluate(d);
}

/* Three groups in steps of 45 degrees. */
static void make_stand_24(design *d, const char *name)
{
    const invcal_plan plan = stand_plan_make(8);

    design_stand(d, &plan);
    snprintf(d->name, sizeof d->name, "%s", name);
}

/* N or N:axes. */
static int read_optimal(const char *command, const char *what, const char *text, unsigned *n,
                        int *with_axes)
{
    char count[64];
    const size_t length = strcspn(text, ":");

    *with_axes = strcmp(text + length, ":axes") == 0;
    snprintf(count, sizeof count, "%.*s", *with_axes ? (int)length : (int)sizeof count, text);
    return read_count(command, what, count, OPTIMAL_MIN, OPTIMAL_MAX, n);
}

static int make_optimal(design *d, const char *command, const char *text)
{
    double direction[OPTIMAL_MAX][3];
    char name[sizeof d->name];
    unsigned n = 0;
    int with_axes = 0;
    const int failure = read_optimal(command, "optimal", text, &n, &with_axes);

    if (!failure) {
        snprintf(name, sizeof name, "optimal %u", n);
        optimal_directions(n, with_axes, direction);
        order_directions(direction, n);
        design_directions(d, name, direction, n);
    }
    return failure;
}

/* The nearest stop of a stand. */
static double at_stop(double degrees, unsigned step)
{
    return angles_turn(0, step * nearbyint(degrees / step));
}

static void find_on_grid(design *d, unsigned n, unsigned step, int with_axes)
{
    double direction[OPTIMAL_MAX][3];
    stand_angles angle[OPTIMAL_MAX];
    char name[sizeof d->name];

    snprintf(name, sizeof name, "optimal %u, stops every %u", n, step);
    grid_directions(n, step, with_axes, direction);
    order_directions(direction, n);
    for (unsigned i = 0; i < n; i++) {
        const stand_angles a = angles_of(direction[i]);
        angle[i] = (stand_angles){at_stop(a.alpha, step), at_stop(a.beta, step)};
    }
    design_angles(d, name, angle, n);
}

/* S:N or S:N:axes. */
static int make_grid(design *d, const char *command, const char *text)
{
    static const char *const steps[] = {"15:", "30:", "45:"};
    unsigned n = 0;
    int with_axes = 0;

    for (unsigned i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        if (strncmp(text, steps[i], 3) == 0) {
            const int failure = read_optimal(command, "optimal", text + 3, &n, &with_axes);
            if (!failure) {
                find_on_grid(d, n, 15 * (i + 1), with_axes);
            }
            return failure;
        }
    }
    return message_usage(command,
                         "grid: '%.*s': STEP:N expected, with a step of 15, 30 or 45 degrees",
                         (int)strcspn(text, ":"), text);
}

/* Directions of any length, made unit vectors in place. */
static int scale_rows(positions *p)
{
    for (unsigned n = 0; n < p->count; n++) {
        double *v = &p->mean[3 * (size_t)n];
        const double largest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
        if (!(largest > 0)) {
            message("%s:%lu: not a direction: all three numbers are 0", p->name, p->origin[n].line);
            return EXIT_FILE;
        }
        const double x = v[0] / largest;
        const double y = v[1] / largest;
        const double z = v[2] / largest;
        const double length = sqrt(x * x + y * y + z * z);
        v[0] = x / length;
        v[1] = y / length;
        v[2] = z / length;
    }
    return EXIT_GOOD;
}

/* The name of a file for tables and pictures: in ASCII, and only its end if it is too long. Returns
 * name. */
static const char *plain_name(const char *path, char *name, size_t size)
{
    const size_t length = strlen(path);
    const int is_cut = length >= size;

    snprintf(name, size, "%s%s", is_cut ? "..." : "", is_cut ? path + length + 4 - size : path);
    for (char *c = name; *c != '\0'; c++) {
        *c = *c < ' ' || *c > '~' ? '?' : *c;
    }
    return name;
}

static int make_from_file(design *d, const char *command, const char *path)
{
    (void)command;
    positions p;
    int failure = positions_read(&p, path);

    if (!failure && p.count > DESIGN_MAX) {
        message("%s: %u directions; the maximum is %u", p.name, p.count, DESIGN_MAX);
        failure = EXIT_FILE;
    }
    failure = failure ? failure : scale_rows(&p);
    if (!failure) {
        char name[sizeof d->name];
        design_directions(d, plain_name(path, name, sizeof name), (double(*)[3])p.mean, p.count);
    }
    positions_free(&p);
    return failure;
}

/* A column dwell states the shares of the time, and its mean the dwell of the set. */
static int make_from_angles(design *d, const char *command, const char *path)
{
    (void)command;
    static stand_angles angle[DESIGN_MAX];
    static double dwell[DESIGN_MAX];
    angles_list list = {angle, dwell, DESIGN_MAX, 0};
    char name[sizeof d->name];
    double sum = 0;
    int is_equal = 1;
    const int failure = angles_file_read(&list, path);

    if (failure) {
        return failure;
    }
    design_angles(d, plain_name(path, name, sizeof name), angle, list.count);
    for (unsigned n = 0; n < list.count; n++) {
        sum += dwell[n];
        is_equal = is_equal && !(fabs(dwell[n] - dwell[0]) > 0);
    }
    d->dwell = sum / list.count;
    for (unsigned n = 0; n < list.count && !is_equal; n++) {
        dwell[n] /= d->dwell;
    }
    if (!is_equal) {
        set_shares(d, dwell);
    }
    return EXIT_GOOD;
}

/* A set whose name has no argument. Returns 0 if there is no such name. */
static int make_named(design *d, const char *word)
{
    static const struct {
        const char *word;
        void (*make)(design *d, const char *word);
    } named[] = {{"faces", make_solid},
                 {"edges", make_solid},
                 {"icosahedron", make_solid},
                 {"stand-12", make_stand_12},
                 {"stand-24", make_stand_24}};

    for (unsigned i = 0; i < sizeof named / sizeof named[0]; i++) {
        if (strcmp(word, named[i].word) == 0) {
            named[i].make(d, word);
            return 1;
        }
    }
    return 0;
}

const char *design_file(const char *word)
{
    static const char *const prefixes[] = {"directions:", "angles:"};

    for (unsigned i = 0; i < 2 && word; i++) {
        const size_t length = strlen(prefixes[i]);
        if (strncmp(word, prefixes[i], length) == 0) {
            return word + length;
        }
    }
    return NULL;
}

static int make(design *d, const char *command, const char *word)
{
    static const struct {
        const char *prefix;
        int (*make)(design *d, const char *command, const char *text);
    } prefixed[] = {{"per-group:", make_stand},
                    {"optimal:", make_optimal},
                    {"grid:", make_grid},
                    {"angles:", make_from_angles},
                    {"directions:", make_from_file}};

    for (unsigned i = 0; i < sizeof prefixed / sizeof prefixed[0]; i++) {
        const size_t length = strlen(prefixed[i].prefix);
        if (strncmp(word, prefixed[i].prefix, length) == 0) {
            return prefixed[i].make(d, command, word + length);
        }
    }
    return make_named(d, word)
               ? EXIT_GOOD
               : message_usage(command,
                               "'%s' is not a set of positions: give edges, faces, icosahedron, "
                               "stand-12, stand-24, per-group:N, optimal:N, grid:S:N, "
                               "angles:FILE or directions:FILE",
                               word);
}

int design_make(design *d, const char *command, const char *word)
{
    const int failure = make(d, command, word);

    return failure || d->is_solvable ? failure : EXIT_DATA;
}
