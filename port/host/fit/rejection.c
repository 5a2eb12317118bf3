/* SPDX-License-Identifier: MIT */
#include "fit/rejection.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "maths/f_tail.h"
#include "cli/message.h"
#include "text/random.h"

#define ALLOWED 0.007 /* chance to leave out a good one of all */
#define FEWEST 11u    /* positions needed to identify an outlier */
#define ROUNDS                                                                                     \
    20u /* with fewer and fewer wrong ones the noise is less and less; seldom more than 5 */

/* One turn of several: one position of each stretch of so many, at a random place in it, another in each
 * turn. (Every n-th would be the same few directions in a program that is repeated.) */
typedef struct {
    unsigned number;
    unsigned of;
} turn;

/* A reading that is none of this field, though most others are. */
static int is_impossible(const positions *p, unsigned i, const fit_settings *settings)
{
    const double *mean = &p->mean[3 * (size_t)i];
    double u[3];
    invcal_row row;

    invcal_apply(&settings->nominal, mean, u);
    return invcal_observe(&settings->nominal, mean, &row) == INVCAL_OUT_OF_RANGE &&
           sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]) - 1 <= REJECTION_TELLABLE;
}

/* Up to one in eight, if there are enough others. */
static void reject_impossible(rejection *r, const positions *p, const fit_settings *settings)
{
    unsigned count = 0;

    for (unsigned i = 0; i < p->count; i++) {
        count += (unsigned)is_impossible(p, i, settings);
    }
    if (8 * count > p->count || p->count < FEWEST + count) {
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
    const rejected_position wanted = {.position = position};

    return count > 0 && bsearch(&wanted, r->list, count, sizeof *r->list, compare) != NULL;
}

unsigned rejection_drifting(const rejection *r)
{
    unsigned count = 0;

    for (unsigned i = 0; i < r->count; i++) {
        count += r->list[i].drift > 0;
    }
    return count;
}

/* Positions that are compared with each other, and their numbers. */
typedef struct {
    double mean[INVCAL_MAX_POSITIONS][3];
    unsigned number[INVCAL_MAX_POSITIONS];
    unsigned count;
} crowd;

/* What a position reads too much, calibrated. */
static double excess(const invcal_calibration *c, const double *mean)
{
    double v[3];

    invcal_apply(c, mean, v);
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1;
}

/* Those of a turn that are not among the `before` first of the list, which are rejected already. */
static void gather(const rejection *r, const positions *p, turn t, unsigned before, crowd *c)
{
    random_source source = random_start(1); /* the same in each turn */

    c->count = 0;
    for (unsigned first = 0; first < p->count; first += t.of) {
        const unsigned place = (unsigned)random_uniform(&source, 0, t.of);
        const unsigned i = first + (t.number + place) % t.of;
        if (i < p->count && !rejection_has(r, before, i)) {
            c->number[c->count] = i;
            memcpy(c->mean[c->count++], &p->mean[3 * (size_t)i], sizeof c->mean[0]);
        }
    }
}

/* What contradicts the others of its turn. Of one turn among several those that may be wrong count as if
 * they were: all the others decide (reconsider). */
static void find_among(rejection *r, const positions *p, const fit_settings *settings, turn t,
                       unsigned before)
{
    crowd c;
    invcal_calibration calibration;
    invcal_quality q;

    gather(r, p, t, before, &c);
    if (invcal_calibrate_judged(c.mean[0], c.count, &settings->nominal, settings->noise,
                                &calibration, &q) != INVCAL_OK) {
        return;
    }
    const invcal_mask out = t.of > 1 ? q.left_out | q.suspected : q.left_out;
    for (unsigned i = 0; i < c.count; i++) {
        r->suspected += (unsigned)((q.suspected & ~out) >> i & 1u);
        if (out >> i & 1u) {
            rejection_add(r, (rejected_position){.position = c.number[i]});
        }
    }
    if (t.number == 0) {
        r->found = q;
        r->is_judged = 1;
        if (t.of > 1 && q.suspected != 0 && q.verdict == INVCAL_ROUGH) {
            r->found.verdict =
                INVCAL_GOOD; /* for those only; all the others decide which are wrong */
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

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;

    return (x > y) - (x < y);
}

/* The noise of a length among those that are kept by the median of its size, which up to half of them may
 * be wrong without much harm: 1.4826 is 1 over that of a standard normal variable. r->number, which is
 * found again in the end, lends the memory. */
static double robust_noise(rejection *r, const invcal_calibration *c)
{
    for (unsigned k = 0; k < r->kept_count; k++) {
        r->number[k] = fabs(excess(c, &r->kept[3 * (size_t)k]));
    }
    qsort(r->number, r->kept_count, sizeof *r->number, compare_numbers);
    return 1.4826 * r->number[r->kept_count / 2];
}

/* Of many turns each has its false alarms, and what is wrong by little stands out of no turn: left out is,
 * in the end, what contradicts all the others together. What a position that is left out is predicted
 * wrong by, over the noise that the others show, has Student's t distribution; by Bonferroni's inequality
 * the chance that any of n good ones goes beyond a bound is at most n times that of one: S. Weisberg,
 * Applied Linear Regression, 3rd ed. (2005), 9.1.2. (That the calibration itself is uncertain adds 9/n to
 * the variance: nothing for so many.) The first time many wrong ones may hide behind the noise that they
 * themselves make, so that is a robust one. Returns whether others are left out now. */
static int reconsider(rejection *r, const positions *p, const fit_settings *settings, int is_first)
{
    invcal_calibration c;
    invcal_quality q;
    const unsigned before = r->count;
    unsigned next = 0; /* of the list as it was, */
    unsigned wrong = 0;
    unsigned again = 0; /* and how many of it are left out again */

    rejection_finish(r, p);
    if (invcal_calibrate(r->kept, r->kept_count, &settings->nominal, 0, &c, &q) != INVCAL_OK) {
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
        const double t = excess(&c, &p->mean[3 * (size_t)i]) / noise;
        const double chance = p->count * f_tail(1 / (1 + t * t / q.dof), 1, q.dof);
        if (one.drift > 0 || chance <= ALLOWED) {
            again += (unsigned)is_out;
            r->scratch[wrong++] = one;
        }
    }
    r->list = r->scratch;
    r->scratch = was;
    r->count = wrong;
    return wrong != before || again != before;
}

void rejection_search(rejection *r, const positions *p, const fit_settings *settings)
{
    const unsigned turns = (p->count + INVCAL_MAX_POSITIONS - 1) / INVCAL_MAX_POSITIONS;
    const unsigned before = r->count;

    qsort(r->list, before, sizeof *r->list, compare);
    for (unsigned n = 0; n < turns; n++) {
        find_among(r, p, settings, (turn){n, turns}, before);
    }
    int has_changed = turns > 1;
    for (unsigned round = 0; has_changed && round < ROUNDS; round++) {
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

/* Before number j of the list stand its position - j that are kept: those up to `kept` count. */
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
