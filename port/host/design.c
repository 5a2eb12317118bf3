/* SPDX-License-Identifier: MIT */
#include "design.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "message.h"
#include "number.h"
#include "optimal.h"
#include "order.h"
#include "parameters.h"
#include "positions.h"

#define DEGREES 57.295779513082321

const char *design_axis_name(unsigned axis)
{
    static const char *const names[INVCAL_AXES] = {"+x", "-x", "+y", "-y", "+z", "-z"};

    return names[axis];
}

double design_seconds(unsigned count, const design_cost *cost)
{
    return count * (cost->settle + cost->dwell) + (count - 1.0) * cost->move;
}

double design_noise(const design_cost *cost)
{
    return cost->noise / sqrt(cost->dwell);
}

static const invcal_calibration unit = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/* The directions as readings of a perfect triad; until the next call. */
static const double *readings(const design *d)
{
    static double up[3 * DESIGN_MAX];

    for (unsigned n = 0; n < d->count; n++) {
        memcpy(&up[3 * (size_t)n], d->position[n].vertical, sizeof d->position[n].vertical);
    }
    return up;
}

void design_next(const design *d, double up[3])
{
    invcal_next(readings(d), d->count, &unit, up);
}

static double hidden_by(const design *d)
{
    double direction[DESIGN_MAX][3];

    for (unsigned n = 0; n < d->count; n++) {
        memcpy(direction[n], d->position[n].vertical, sizeof direction[n]);
    }
    return d->count > 1 ? order_hides_drift((const double(*)[3])direction, d->count) : HUGE_VAL;
}

static void judge(design *d)
{
    invcal_sums_init(&d->sums);
    d->axes = 0;
    for (unsigned n = 0; n < d->count; n++) {
        const double *v = d->position[n].vertical;
        criteria_add(&d->sums, v);
        d->axes |= invcal_axis_up(v);
        for (unsigned i = 0; i < 3; i++) {
            d->range[i][0] = n == 0 || v[i] < d->range[i][0] ? v[i] : d->range[i][0];
            d->range[i][1] = n == 0 || v[i] > d->range[i][1] ? v[i] : d->range[i][1];
        }
    }
    d->is_solvable = criteria_judge(&d->sums, &d->criteria);
    d->hidden = hidden_by(d);
    d->undetermined = d->is_solvable ? 0 : invcal_undetermined(readings(d), d->count, &unit);
    if (!d->is_solvable) {
        char list[128];
        char advice[128];
        snprintf(d->refusal, sizeof d->refusal,
                 "the positions leave parameters undetermined%s%s; add positions with %s",
                 d->undetermined ? ": " : "", parameters_list(d->undetermined, list, sizeof list),
                 parameters_advice(d->undetermined, advice, sizeof advice));
    }
}

void design_stand(design *d, const invcal_plan *plan)
{
    snprintf(d->name, sizeof d->name, "3 x %u", plan->per_group);
    d->plan = *plan;
    d->count = INVCAL_PLAN_GROUPS * plan->per_group;
    for (unsigned i = 0; i < d->count; i++) {
        invcal_plan_position p;
        (void)invcal_plan_position_at(plan, i, &p); /* the plan is usable */
        d->position[i].group = p.group;
        d->position[i].alpha = p.alpha;
        d->position[i].beta = p.beta;
        memcpy(d->position[i].vertical, p.vertical, sizeof p.vertical);
    }
    judge(d);
}

/* Stand angles of a direction: eta(alpha, beta) = (sin alpha sin beta, cos alpha, sin alpha
 * cos beta), alpha from 0 to 180. */
static void set_angles(design_position *p)
{
    const double *v = p->vertical;
    const double radius = hypot(v[0], v[2]); /* sin alpha */

    p->group = 0;
    p->alpha = DEGREES * atan2(radius, v[1]);
    p->beta = radius > 1e-12 ? DEGREES * atan2(v[0], v[2]) : 0;
}

void design_directions(design *d, const char *name, double (*direction)[3], unsigned count)
{
    snprintf(d->name, sizeof d->name, "%s", name);
    d->plan = (invcal_plan){0};
    d->count = count;
    for (unsigned n = 0; n < count; n++) {
        memcpy(d->position[n].vertical, direction[n], sizeof direction[n]);
        set_angles(&d->position[n]);
    }
    judge(d);
}

void design_balanced(design *d, unsigned count, const double limits[3])
{
    double direction[OPTIMAL_MAX][3];

    (void)optimal_within(count, limits, direction);
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

/* (0 +-a +-b) and with the axes changed round: edges for a = b, for the golden section the
 * corners of an icosahedron. */
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

/* A whole number from `least` to `most`. */
static int read_count(const char *command, const char *what, const char *text, unsigned least,
                      unsigned most, unsigned *out)
{
    double x;
    const number_status status = number_parse(text, &x);

    if (status != NUMBER_OK) {
        return message_usage(command, "%s: '%s' %s", what, text, number_problem(status));
    }
    if (!(x >= least && x <= most && !(floor(x) < x))) {
        return message_usage(command, "%s: '%s': a whole number from %u to %u is expected", what,
                             text, least, most);
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
            command, "per-group: '%s': three start angles with commas between are expected", text);
    }
    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        const number_status status = number_parse(item[g], &start[g]);
        if (status != NUMBER_OK) {
            return message_usage(command, "per-group: start angle '%s' %s", item[g],
                                 number_problem(status));
        }
        if (!(fabs(start[g]) <= 360)) {
            return message_usage(command, "per-group: start angle '%s' is not within -360 ... 360",
                                 item[g]);
        }
    }
    return EXIT_GOOD;
}

/* N or N:A,B,C. */
static int make_stand(design *d, const char *command, const char *text)
{
    invcal_plan plan = {0};
    char count[64];
    const size_t length = strcspn(text, ":");

    snprintf(count, sizeof count, "%.*s", (int)length, text);
    int failure =
        read_count(command, "per-group", count, 1, INVCAL_PLAN_PER_GROUP_MAX, &plan.per_group);
    if (!failure && text[length] == ':') {
        failure = read_starts(command, text + length + 1, plan.start);
    } else if (!failure) {
        (void)invcal_plan_starts(plan.per_group, plan.start); /* judged below */
    }
    if (failure) {
        return failure;
    }
    if (plan.per_group < INVCAL_PLAN_PER_GROUP_MIN) {
        d->count = 0;
        d->is_solvable = 0;
        d->undetermined = (1u << INVCAL_PARAMETERS) - 1;
        snprintf(d->refusal, sizeof d->refusal,
                 "%u position%s in a group %s too few: a group is a series of five coefficients, "
                 "so it takes 5 or more",
                 plan.per_group, plan.per_group == 1 ? "" : "s",
                 plan.per_group == 1 ? "is" : "are");
        return EXIT_DATA;
    }
    design_stand(d, &plan);
    return EXIT_GOOD;
}

static int make_optimal(design *d, const char *command, const char *text)
{
    double direction[OPTIMAL_MAX][3];
    char name[sizeof d->name];
    unsigned n = 0;
    const int failure = read_count(command, "optimal", text, OPTIMAL_MIN, OPTIMAL_MAX, &n);

    if (!failure) {
        snprintf(name, sizeof name, "optimal %u", n);
        optimal_directions(n, direction);
        order_directions(direction, n);
        design_directions(d, name, direction, n);
    }
    return failure;
}

/* Directions of any length, made unit vectors in place. */
static int scale_rows(positions *p)
{
    for (unsigned n = 0; n < p->count; n++) {
        double *v = &p->mean[3 * (size_t)n];
        const double largest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
        if (!(largest > 0)) {
            message("%s:%lu: no direction: its three numbers are 0", p->name, p->origin[n].line);
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

/* The name of a file for tables and pictures: ASCII, the end of it if it is too long, which tells
 * most. Returns name. */
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

static int make_from_file(design *d, const char *path)
{
    positions p;
    int failure = positions_read(&p, path);

    if (!failure && p.count > DESIGN_MAX) {
        message("%s: %u directions, more than %u", p.name, p.count, DESIGN_MAX);
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

/* What stands behind `prefix`, or null if the word does not begin with it. */
static const char *behind(const char *word, const char *prefix)
{
    const size_t length = strlen(prefix);

    return strncmp(word, prefix, length) == 0 ? word + length : NULL;
}

static int make(design *d, const char *command, const char *word)
{
    const char *rest;

    if ((rest = behind(word, "per-group:"))) {
        return make_stand(d, command, rest);
    }
    if ((rest = behind(word, "optimal:"))) {
        return make_optimal(d, command, rest);
    }
    if ((rest = behind(word, "directions:"))) {
        return make_from_file(d, rest);
    }
    if (strcmp(word, "faces") == 0 || strcmp(word, "edges") == 0 ||
        strcmp(word, "icosahedron") == 0) {
        make_solid(d, word);
        return EXIT_GOOD;
    }
    return message_usage(command, "'%s' is no set of positions", word);
}

int design_make(design *d, const char *command, const char *word)
{
    const int failure = make(d, command, word);

    return failure || d->is_solvable ? failure : EXIT_DATA;
}
