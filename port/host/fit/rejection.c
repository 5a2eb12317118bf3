/* SPDX-License-Identifier: MIT */
#include "fit/rejection.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "maths/f_tail.h"
#include "cli/message.h"

#define ALLOWED 0.007 /* chance to leave out a good one of all */
#define FEWEST 11u    /* positions for an outlier to be told from the others */

/* Position first, first + step, first + 2 step ... */
typedef struct {
    unsigned first;
    unsigned step;
} choice_of;

/* A reading that is none of this field, though most others are. */
static int is_impossible(const positions *p, unsigned i, const fit_settings *settings)
{
    invcal_row row;

    return invcal_observe(&settings->nominal, &p->mean[3 * (size_t)i], &row) == INVCAL_OUT_OF_RANGE;
}

/* Up to one in eight, if enough others are there to tell. */
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

/* Among the first `count` of the list. */
static int is_among(const rejection *r, unsigned count, unsigned position)
{
    for (unsigned i = 0; i < count; i++) {
        if (r->list[i].position == position) {
            return 1;
        }
    }
    return 0;
}

int rejection_has(const rejection *r, unsigned position)
{
    return is_among(r, r->count, position);
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

/* `before` of them, the first of the list, are rejected already. */
static void find_among(rejection *r, const positions *p, const fit_settings *settings,
                       choice_of which, unsigned before)
{
    crowd c = {.count = 0};
    invcal_calibration calibration;
    invcal_quality q;

    for (unsigned i = which.first; i < p->count; i += which.step) {
        if (!is_among(r, before, i)) {
            c.number[c.count] = i;
            memcpy(c.mean[c.count++], &p->mean[3 * (size_t)i], sizeof c.mean[0]);
        }
    }
    if (invcal_calibrate_judged(c.mean[0], c.count, &settings->nominal, settings->noise,
                                &calibration, &q) != INVCAL_OK) {
        return;
    }
    for (unsigned i = 0; i < c.count; i++) {
        r->suspected += (unsigned)(q.suspected >> i & 1u);
        if (q.left_out >> i & 1u) {
            rejection_add(r, (rejected_position){.position = c.number[i]});
        }
    }
    if (which.first == 0) {
        r->found = q;
        r->is_judged = 1;
    }
}

static int compare(const void *a, const void *b)
{
    const rejected_position *x = a;
    const rejected_position *y = b;

    return (x->position > y->position) - (x->position < y->position);
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
    r->number = calloc((size_t)p->count + 1, sizeof *r->number);
    r->kept = calloc(3 * (size_t)p->count + 1, sizeof *r->kept);
    r->temperature = calloc((size_t)p->count + 1, sizeof *r->temperature);
    if (!r->list || !r->number || !r->kept || !r->temperature) {
        message("%s: not enough memory for %u positions", p->name, p->count);
        return EXIT_FILE;
    }
    if (!none) {
        reject_impossible(r, p, settings);
    }
    return EXIT_GOOD;
}

/* Of many turns each has its false alarms: those come back that do not contradict all the others
 * together, Bonferroni's inequality and Student's t. */
static void reconsider(rejection *r, const positions *p, const fit_settings *settings,
                       unsigned before)
{
    invcal_calibration c;
    invcal_quality q;

    rejection_finish(r, p);
    if (invcal_calibrate(r->kept, r->kept_count, &settings->nominal, 0, &c, &q) != INVCAL_OK) {
        return;
    }
    const double noise = q.noise * fit_sensitivity(&c, &settings->nominal);
    for (unsigned k = r->count; k-- > before;) {
        const double t = excess(&c, &p->mean[3 * (size_t)r->list[k].position]) / noise;
        if (!(f_tail(1 / (1 + t * t / q.dof), 1, q.dof) * p->count <= ALLOWED)) {
            rejection_remove(r, r->list[k].position);
        }
    }
}

void rejection_search(rejection *r, const positions *p, const fit_settings *settings)
{
    const unsigned turns = (p->count + INVCAL_MAX_POSITIONS - 1) / INVCAL_MAX_POSITIONS;
    const unsigned before = r->count;

    for (unsigned turn = 0; turn < turns; turn++) {
        find_among(r, p, settings, (choice_of){turn, turns}, before);
    }
    if (turns > 1 && r->count > before) {
        reconsider(r, p, settings, before);
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
    free(r->number);
    free(r->kept);
    free(r->temperature);
    *r = (rejection){0};
}

unsigned rejection_original(const rejection *r, unsigned kept)
{
    unsigned i = kept;

    for (unsigned n = 0; n < r->count && r->list[n].position <= i; n++) {
        i++;
    }
    return i;
}
