/* SPDX-License-Identifier: MIT */
#include "fit/rejection.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/positions.h"
#include "cli/command.h"
#include "cli/message.h"
#include "maths/f_tail.h"
#include "maths/median.h"
#include "text/random.h"
#include "core/sums.h"

#define FALSE_ALARM 0.007 /* chance that any good position is left out */
#define POSITIONS_MIN 11u /* positions needed to identify an outlier */
#define ROUNDS_MAX 20u    /* seldom more than 5 are needed */

/* One of several disjoint subsets of the positions: it has one position, at a random place, of
 * every `count` consecutive ones. (Every n-th position could be the same few directions of a
 * repeated program.) */
typedef struct {
    unsigned number;
    unsigned count; /* of subsets */
} subset;

/* A reading that cannot be of this field. */
static int is_impossible(const positions *p, unsigned i, const fit_settings *settings)
{
    const double *mean = &p->mean[3 * (size_t)i];
    double u[3];
    invcali_row row;

    invcal_apply(&settings->nominal, mean[0], mean[1], mean[2], u);
    return invcali_observe(&settings->nominal, mean, &row) == INVCAL_OUT_OF_RANGE &&
           sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]) - 1 <= REJECTION_LENGTH_MAX;
}

/* Rejects such readings: up to one in eight, if enough others remain. */
static void reject_impossible(rejection *r, const positions *p, const fit_settings *settings)
{
    unsigned count = 0;

    for (unsigned i = 0; i < p->count; i++) {
        count += (unsigned)is_impossible(p, i, settings);
    }
    if (8 * count > p->count || p->count < POSITIONS_MIN + count) {
        return;
    }
    for (unsigned i = 0; i < p->count; i++) {
        if (is_impossible(p, i, settings)) {
            rejection_add(r, (rejected_position){.position = i});
        }
    }
}

void rejection_add(rejection *r, rejected_position one)
{
    r->list[r->count++] = one;
}

void rejection_remove(rejection *r, unsigned position)
{
    unsigned kept = 0;

    for (unsigned i = 0; i < r->count; i++) {
        if (r->list[i].position != position) {
            r->list[kept++] = r->list[i];
        }
    }
    r->count = kept;
}

static int compare(const void *a, const void *b)
{
    const rejected_position *x = a;
    const rejected_position *y = b;

    return (x->position > y->position) - (x->position < y->position);
}

int rejection_has(const rejection *r, unsigned count, unsigned position)
{
    const rejected_position key = {.position = position};

    return count > 0 && bsearch(&key, r->list, count, sizeof *r->list, compare) != NULL;
}

unsigned rejection_drifting(const rejection *r)
{
    unsigned count = 0;

    for (unsigned i = 0; i < r->count; i++) {
        count += r->list[i].drift > 0;
    }
    return count;
}

/* The positions of a subset, and their numbers. */
typedef struct {
    double mean[INVCAL_MAX_POSITIONS][3];
    unsigned number[INVCAL_MAX_POSITIONS];
    unsigned count;
} subset_means;

/* The error of the length of a calibrated position. */
static double length_error(const invcal_calibration *c, const double *mean)
{
    double v[3];

    invcal_apply(c, mean[0], mean[1], mean[2], v);
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1;
}

/* Collects the positions of a subset, except the first `before` of the list, which are rejected
 * already. */
static void gather(const rejection *r, const positions *p, subset s, unsigned before,
                   subset_means *c)
{
    random_source source = random_start(1); /* the same for each subset */

    c->count = 0;
    for (unsigned first = 0; first < p->count; first += s.count) {
        const unsigned place = (unsigned)random_uniform(&source, 0, s.count);
        const unsigned i = first + (s.number + place) % s.count;
        if (i < p->count && !rejection_has(r, before, i)) {
            c->number[c->count] = i;
            memcpy(c->mean[c->count++], &p->mean[3 * (size_t)i], sizeof c->mean[0]);
        }
    }
}

/* Rejects the positions that contradict the others of their subset. If there are several subsets,
 * suspected ones are rejected, too, until reconsider compares them with all others. */
static void judge_subset(rejection *r, const positions *p, const fit_settings *settings, subset s,
                         unsigned before)
{
    subset_means c;
    invcal_calibration calibration;
    invcal_quality q;

    gather(r, p, s, before, &c);
    const invcal_positions given =
        fit_positions(c.mean[0], c.count, &settings->nominal, settings->noise);
    if (invcal_calibrate(&given, &calibration, &q) != INVCAL_OK) {
        return;
    }
    const invcal_mask rejected = s.count > 1 ? q.left_out | q.suspected : q.left_out;
    for (unsigned i = 0; i < c.count; i++) {
        r->suspected += (unsigned)((q.suspected & ~rejected) >> i & 1u);
        if (rejected >> i & 1u) {
            rejection_add(r, (rejected_position){.position = c.number[i]});
        }
    }
    if (s.number == 0) {
        r->found = q;
        r->is_judged = 1;
        if (s.count > 1 && q.suspected != 0 && q.verdict == INVCAL_ROUGH) {
            r->found.verdict =
                INVCAL_GOOD; /* it was rough only for the suspected ones, which reconsider judges */
        }
    }
}

void rejection_finish(rejection *r, const positions *p)
{
    unsigned next = 0;

    qsort(r->list, r->count, sizeof *r->list, compare);
    r->kept_count = 0;
    for (unsigned i = 0; i < p->count; i++) {
        if (next < r->count && r->list[next].position == i) {
            r->number[next++] = i + 1.0;
        } else {
            memcpy(&r->kept[3 * (size_t)r->kept_count], &p->mean[3 * (size_t)i],
                   3 * sizeof *r->kept);
            r->temperature[r->kept_count++] = p->origin[i].temperature;
        }
    }
}

int rejection_begin(rejection *r, const positions *p, const fit_settings *settings, int none)
{
    *r = (rejection){0};
    r->list = calloc((size_t)p->count + 1, sizeof *r->list);
    r->scratch = calloc((size_t)p->count + 1, sizeof *r->scratch);
    r->number = calloc((size_t)p->count + 1, sizeof *r->number);
    r->kept = calloc(3 * (size_t)p->count + 1, sizeof *r->kept);
    r->temperature = calloc((size_t)p->count + 1, sizeof *r->temperature);
    if (!r->list || !r->scratch || !r->number || !r->kept || !r->temperature) {
        message("%s: not enough memory for %u positions", p->name, p->count);
        return EXIT_FILE;
    }
    if (!none) {
        reject_impossible(r, p, settings);
    }
    return EXIT_GOOD;
}

/* The noise of a length by the median absolute error of the kept positions, which tolerates up to
 * half of them being wrong: 1.4826 is 1 over that of a standard normal variable. r->number, which
 * rejection_finish fills later, serves as working memory. */
static double robust_noise(rejection *r, const invcal_calibration *c)
{
    for (unsigned k = 0; k < r->kept_count; k++) {
        r->number[k] = fabs(length_error(c, &r->kept[3 * (size_t)k]));
    }
    return 1.4826 * median_of(r->number, r->kept_count);
}

/* Each subset has its false alarms, and may be too small to show a small error. So positions are
 * finally left out if they contradict all others together. The prediction error of a position that
 * is left out, over the noise of the others, has Student's t distribution; by Bonferroni's
 * inequality the chance that any of n good ones exceeds a bound is at most n times that of one: S.
 * Weisberg, Applied Linear Regression, 3rd ed. (2005), 9.1.2. (The uncertainty of the calibration
 * itself adds 9/n to the variance, which is negligible for that many.) In the first round, wrong
 * positions may increase the noise so far that it hides them, so that a robust estimate is used.
 * Returns whether the list has changed. */
static int reconsider(rejection *r, const positions *p, const fit_settings *settings, int is_first)
{
    invcal_calibration c;
    invcal_quality q;
    const unsigned before = r->count;
    unsigned next = 0; /* of the old list */
    unsigned wrong = 0;
    unsigned rejected_again = 0; /* of the old list */

    rejection_finish(r, p);
    const invcal_positions kept = fit_positions(r->kept, r->kept_count, &settings->nominal, 0);
    if (invcal_calibrate_plain(&kept, &c, &q) != INVCAL_OK) {
        return 0;
    }
    const double noise =
        is_first ? robust_noise(r, &c) : q.noise * fit_sensitivity(&c, &settings->nominal);
    rejected_position *const was = r->list;
    for (unsigned i = 0; i < p->count; i++) {
        rejected_position one = {.position = i};
        const int is_out = next < before && was[next].position == i;
        if (is_out) {
            one.drift = was[next++].drift;
        }
        const double t = length_error(&c, &p->mean[3 * (size_t)i]) / noise;
        const double chance = p->count * f_tail(1 / (1 + t * t / q.dof), 1, q.dof);
        if (one.drift > 0 || chance <= FALSE_ALARM) {
            rejected_again += (unsigned)is_out;
            r->scratch[wrong++] = one;
        }
    }
    r->list = r->scratch;
    r->scratch = was;
    r->count = wrong;
    return wrong != before || rejected_again != before;
}

void rejection_search(rejection *r, const positions *p, const fit_settings *settings)
{
    const unsigned subsets = (p->count + INVCAL_MAX_POSITIONS - 1) / INVCAL_MAX_POSITIONS;
    const unsigned before = r->count;

    qsort(r->list, before, sizeof *r->list, compare);
    for (unsigned n = 0; n < subsets; n++) {
        judge_subset(r, p, settings, (subset){n, subsets}, before);
    }
    int has_changed = subsets > 1;
    for (unsigned round = 0; has_changed && round < ROUNDS_MAX; round++) {
        has_changed = reconsider(r, p, settings, round == 0) || round == 0;
    }
}

int rejection_find(rejection *r, const positions *p, const fit_settings *settings, int none)
{
    const int failure = rejection_begin(r, p, settings, none);

    if (failure) {
        return failure;
    }
    if (!none) {
        rejection_search(r, p, settings);
    }
    rejection_finish(r, p);
    return EXIT_GOOD;
}

void rejection_free(rejection *r)
{
    free(r->list);
    free(r->scratch);
    free(r->number);
    free(r->kept);
    free(r->temperature);
    *r = (rejection){0};
}

/* Before element j of the list there are position - j kept ones: counts the elements where these
 * are at most `kept`. */
unsigned rejection_original(const rejection *r, unsigned kept)
{
    unsigned low = 0;
    unsigned high = r->count;

    while (low < high) {
        const unsigned middle = low + (high - low) / 2;
        if (r->list[middle].position - middle <= kept) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return kept + low;
}
