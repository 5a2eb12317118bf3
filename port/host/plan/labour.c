/* SPDX-License-Identifier: MIT */
#include "plan/labour.h"

#include <math.h>
#include <string.h>

#include "invcal/plan.h"
#include "cli/command.h"
#include "design/optimal.h"
#include "plan/results.h"

#define PI 3.14159265358979323846
#define HALVINGS 60u
#define GOLDEN 0.61803398874989485
#define LIMIT_TOLERANCE (1 + 1e-9) /* so that rounding does not refuse a limit that is just met */
#define ROWS_AROUND 4u
#define NEAR_DWELL_MAX 0.999 /* times LABOUR_DWELL_MAX: from here on the maximum limits the dwell */

const char *const labour_families[CHOICE_FAMILIES] = {"stand program", "free directions"};

/* ---- noise of a position mean ------------------------------------------------------------------ */

static double r2_log_r(double r)
{
    return r > 0 ? r * r * log(r) : 0;
}

/* Mean square difference of two means that begin r times their length apart, for flicker noise with
 * B^2 / pi = 1. */
static double flicker_step(double r)
{
    return r2_log_r(r + 1) + r2_log_r(r - 1) - 2 * r2_log_r(r);
}

static double flicker_scatter(unsigned n, double apart)
{
    double sum = 0;

    for (unsigned j = 1; j < n; j++) {
        sum += (n - j) * flicker_step(j * apart);
    }
    return sum / ((double)n * (n - 1));
}

/* Square of labour_sigma for one axis; `flicker` is flicker_scatter. */
static double scatter(const invcal_noise *noise, unsigned n, double dwell, double period,
                      double flicker)
{
    const double white = noise->coefficient[INVCAL_NOISE_WHITE];
    const double instability = noise->coefficient[INVCAL_NOISE_INSTABILITY];
    const double walk = noise->coefficient[INVCAL_NOISE_WALK];

    return white * white / dwell + instability * instability / PI * flicker +
           walk * walk * (period * (n + 1) - dwell) / 6;
}

double labour_sigma(const labour *l, unsigned count, double dwell)
{
    const double period = dwell + l->settle + l->move;
    int has_flicker = 0;
    double max = 0;

    for (unsigned i = 0; i < 3; i++) {
        has_flicker = has_flicker || l->noise[i].coefficient[INVCAL_NOISE_INSTABILITY] > 0;
    }
    const double flicker = has_flicker ? flicker_scatter(count, period / dwell) : 0;
    for (unsigned i = 0; i < 3; i++) {
        max = fmax(max, scatter(&l->noise[i], count, dwell, period, flicker));
    }
    return sqrt(max);
}

/* ---- the dwell --------------------------------------------------------------------------------- */

/* The dwell of the smallest sigma, by golden section search: sigma of each axis falls, and, with a
 * random walk, rises again. */
static double best_dwell(const labour *l, unsigned n)
{
    double low = log(LABOUR_DWELL_MIN);
    double high = log(LABOUR_DWELL_MAX);

    for (unsigned i = 0; i < HALVINGS; i++) {
        const double left = high - GOLDEN * (high - low);
        const double right = low + GOLDEN * (high - low);
        if (labour_sigma(l, n, exp(left)) < labour_sigma(l, n, exp(right))) {
            high = right;
        } else {
            low = left;
        }
    }
    return exp((low + high) / 2);
}

/* The shortest dwell whose sigma is allowed; if there is none, that of the smallest sigma. */
static double find_dwell(const labour *l, unsigned n, double allowed)
{
    double low = LABOUR_DWELL_MIN;

    if (labour_sigma(l, n, low) <= allowed) {
        return low;
    }
    double high = best_dwell(l, n);
    if (!(labour_sigma(l, n, high) <= allowed)) {
        return high;
    }
    for (unsigned i = 0; i < HALVINGS; i++) {
        const double middle = sqrt(low * high);
        if (labour_sigma(l, n, middle) <= allowed) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return high;
}

static double seconds(const labour *l, unsigned count, double dwell)
{
    const design_cost cost = {
        .warm_up = l->warm_up, .dwell = dwell, .settle = l->settle, .move = l->move};

    return design_seconds(count, &cost);
}

/* A number of positions whose sigmas, over the noise of a position mean, are known. */
static labour_row evaluate(const labour *l, unsigned count, const double sigma[3])
{
    labour_row row = {.count = count, .allowed = HUGE_VAL};
    double longest = HUGE_VAL;
    int is_weak = 0;

    for (unsigned k = 0; k < 3; k++) {
        is_weak = is_weak || !(sigma[k] <= PLAN_WEAK);
        if (l->limits[k] / sigma[k] < row.allowed) {
            row.allowed = l->limits[k] / sigma[k];
            row.binds = k;
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        longest = fmin(longest, l->noise[i].longest);
    }
    row.dwell = find_dwell(l, count, row.allowed);
    row.sigma = labour_sigma(l, count, row.dwell);
    row.is_possible = !is_weak && row.sigma <= LIMIT_TOLERANCE * row.allowed;
    row.is_beyond = row.dwell > longest;
    row.seconds = seconds(l, count, row.dwell);
    return row;
}

/* ---- the families ------------------------------------------------------------------------------ */

static void add_row(labour *l, unsigned family, unsigned count, const double sigma[3])
{
    labour_row *row = &l->row[family][l->rows[family]++];

    *row = evaluate(l, count, sigma);
    if (row->is_possible && (!l->best[family] || row->seconds < l->best[family]->seconds)) {
        l->best[family] = row;
    }
}

/* No number from here on takes less time, or needs to be shown. */
static int is_search_done(const labour *l, unsigned family, unsigned count)
{
    const labour_row *best = l->best[family];

    return best && count > LABOUR_RANGE * best->count &&
           seconds(l, count, LABOUR_DWELL_MIN) > best->seconds;
}

/* The paper's programs: their sigmas depend only on N. */
static void try_stands(labour *l)
{
    for (unsigned n = INVCAL_PLAN_PER_GROUP_MIN; INVCAL_PLAN_GROUPS * n <= LABOUR_MAX; n++) {
        const double sigma[3] = {sqrt(1.0 / n), sqrt(7.0 / 5 / n), sqrt(8.0 / n)};
        if (INVCAL_PLAN_GROUPS * n >= l->min_count && n % choice_stand_step(l->needs_axes) == 0) {
            add_row(l, CHOICE_STAND, INVCAL_PLAN_GROUPS * n, sigma);
        }
    }
}

/* Their order does not matter here. */
static void try_directions(labour *l, design *work)
{
    double direction[OPTIMAL_MAX][3];

    for (unsigned n = l->min_count; n <= LABOUR_MAX && !is_search_done(l, CHOICE_FREE, n); n++) {
        (void)optimal_within(n, l->limits, l->needs_axes, direction);
        design_directions(work, "", direction, n);
        if (work->is_solvable) {
            const double sigma[3] = {work->criteria.sigma_delta, work->criteria.sigma_dk,
                                     work->criteria.sigma_gamma};
            add_row(l, CHOICE_FREE, n, sigma);
        }
    }
}

/* The row whose sigma is nearest to the allowed one. */
static const labour_row *find_nearest(const labour *l)
{
    const labour_row *nearest = &l->row[CHOICE_STAND][0];

    for (unsigned f = 0; f < CHOICE_FAMILIES; f++) {
        for (unsigned i = 0; i < l->rows[f]; i++) {
            const labour_row *row = &l->row[f][i];
            nearest = row->sigma / row->allowed < nearest->sigma / nearest->allowed ? row : nearest;
        }
    }
    return nearest;
}

static int refuse(labour *l)
{
    const labour_row *row = find_nearest(l);
    const display_unit unit = unit_style_field(l->units, 1);
    const int is_floor = row->dwell < NEAR_DWELL_MAX * LABOUR_DWELL_MAX;

    snprintf(l->refusal, sizeof l->refusal,
             "no number of positions up to %u and no dwell%s meet the limits%s; %u positions of "
             "%.4g s come closest, with a sigma of the mean of %.3g %s where %.3g %s is needed: "
             "relax the limits, or use a quieter sensor",
             LABOUR_MAX, is_floor ? "" : " up to 1e6 s", is_floor ? ": the noise has a floor" : "",
             row->count, row->dwell, unit.scale * row->sigma, unit.unit, unit.scale * row->allowed,
             unit.unit);
    return EXIT_DATA;
}

int labour_find(labour *l, design *set)
{
    const labour_row *const *best = l->best;

    memset(l->rows, 0, sizeof l->rows);
    l->best[CHOICE_STAND] = NULL;
    l->best[CHOICE_FREE] = NULL;
    try_stands(l);
    try_directions(l, set);
    if (!best[CHOICE_STAND] && !best[CHOICE_FREE]) {
        return refuse(l);
    }
    const int is_free =
        !best[CHOICE_STAND] ||
        (best[CHOICE_FREE] && best[CHOICE_FREE]->seconds < best[CHOICE_STAND]->seconds);
    l->chosen = is_free ? CHOICE_FREE : CHOICE_STAND;
    const unsigned count = best[l->chosen]->count;
    if (is_free) {
        design_balanced(set, count, l->limits, l->needs_axes);
    } else {
        const invcal_plan plan = stand_plan_make(count / INVCAL_PLAN_GROUPS);
        design_stand(set, &plan);
    }
    return EXIT_GOOD;
}

void labour_request(const labour *l, double limits[3], choice_request *request)
{
    const labour_row *row = l->best[l->chosen];

    for (unsigned k = 0; k < 3; k++) {
        limits[k] = l->limits[k] / row->sigma;
    }
    request->limits = limits;
    request->labour = l;
    request->cost.dwell = row->dwell;
    request->cost.noise = row->sigma * sqrt(row->dwell); /* the inverse of design_noise */
}

void labour_near_best(const labour *l, unsigned family, unsigned *first, unsigned *end)
{
    const unsigned rows = l->rows[family];
    const unsigned at = l->best[family] ? (unsigned)(l->best[family] - l->row[family]) : rows;

    *first = at > ROWS_AROUND ? at - ROWS_AROUND : 0;
    *end = at + ROWS_AROUND + 1 < rows ? at + ROWS_AROUND + 1 : rows;
}
