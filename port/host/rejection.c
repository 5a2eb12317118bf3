/* SPDX-License-Identifier: MIT */
#include "rejection.h"

#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "message.h"

/* Position first, first + step, first + 2 step ... */
typedef struct {
    unsigned first;
    unsigned step;
} choice_of;

static void add(rejection *r, const invcal_outliers *found, choice_of which)
{
    for (unsigned i = 0; i < found->count; i++) {
        rejected_position *at = &r->list[r->count++];
        at->position = which.first + which.step * found->position[i];
        at->error = found->error[i];
        at->w = found->w[i];
    }
    for (unsigned i = 0; i < INVCAL_OUTLIERS_CAPACITY; i++) {
        r->suspected += (unsigned)(found->suspected >> i & 1u);
    }
}

static void find_among(rejection *r, const positions *p, const invcal_settings *settings,
                       choice_of which)
{
    double mean[INVCAL_OUTLIERS_CAPACITY][3];
    invcal_outliers found;
    unsigned count = 0;

    for (unsigned i = which.first; i < p->count; i += which.step) {
        memcpy(mean[count++], &p->mean[3 * (size_t)i], sizeof mean[0]);
    }
    if (invcal_outliers_find(&mean[0][0], count, settings, &found) == INVCAL_OK) {
        add(r, &found, which);
    }
}

static int compare(const void *a, const void *b)
{
    const rejected_position *x = a;
    const rejected_position *y = b;

    return (x->position > y->position) - (x->position < y->position);
}

static void keep_others(rejection *r, const positions *p)
{
    unsigned next = 0;

    for (unsigned i = 0; i < p->count; i++) {
        if (next < r->count && r->list[next].position == i) {
            r->number[next++] = i + 1.0;
        } else {
            memcpy(&r->kept[3 * (size_t)r->kept_count++], &p->mean[3 * (size_t)i],
                   3 * sizeof *r->kept);
        }
    }
}

int rejection_find(rejection *r, const positions *p, const invcal_settings *settings, int none)
{
    const unsigned turns = (p->count + INVCAL_OUTLIERS_CAPACITY - 1) / INVCAL_OUTLIERS_CAPACITY;

    *r = (rejection){0};
    r->list = calloc((size_t)turns * INVCAL_OUTLIERS_MOST + 1, sizeof *r->list);
    r->number = calloc((size_t)turns * INVCAL_OUTLIERS_MOST + 1, sizeof *r->number);
    r->kept = calloc(3 * (size_t)p->count + 1, sizeof *r->kept);
    if (!r->list || !r->number || !r->kept) {
        message("%s: not enough memory for %u positions", p->name, p->count);
        return EXIT_FILE;
    }
    for (unsigned turn = 0; turn < turns && !none; turn++) {
        find_among(r, p, settings, (choice_of){turn, turns});
    }
    qsort(r->list, r->count, sizeof *r->list, compare);
    keep_others(r, p);
    return EXIT_GOOD;
}

void rejection_free(rejection *r)
{
    free(r->list);
    free(r->number);
    free(r->kept);
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
