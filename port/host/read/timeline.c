/* SPDX-License-Identifier: MIT */
#include "read/timeline.h"

#include <float.h>
#include <math.h>

static const timeline_bin empty = {
    {FLT_MAX, FLT_MAX, FLT_MAX, FLT_MAX},
    {-FLT_MAX, -FLT_MAX, -FLT_MAX, -FLT_MAX},
};

static void widen(timeline_bin *bin, const float *low, const float *high)
{
    for (unsigned i = 0; i < TIMELINE_TRACES; i++) {
        bin->low[i] = fminf(bin->low[i], low[i]);
        bin->high[i] = fmaxf(bin->high[i], high[i]);
    }
}

void timeline_begin(timeline *t, double rate)
{
    t->bins = t->refusals = 0;
    t->width = 1 / rate;
    t->duration = 0;
}

/* Halves the number of bins. */
static void merge_pairs(timeline *t)
{
    for (unsigned i = 0; i < t->bins; i += 2) {
        timeline_bin merged = t->bin[i];
        if (i + 1 < t->bins) {
            widen(&merged, t->bin[i + 1].low, t->bin[i + 1].high);
        }
        t->bin[i / 2] = merged;
    }
    t->bins = (t->bins + 1) / 2;
    t->width *= 2;
}

void timeline_add(timeline *t, double time, const double value[TIMELINE_TRACES])
{
    float v[TIMELINE_TRACES];

    while (time >= TIMELINE_BINS * t->width) {
        merge_pairs(t);
    }
    const unsigned at = (unsigned)(time / t->width);
    while (t->bins <= at) {
        t->bin[t->bins++] = empty;
    }
    for (unsigned i = 0; i < TIMELINE_TRACES; i++) {
        v[i] = (float)value[i];
    }
    widen(&t->bin[at], v, v);
    t->duration = time;
}

void timeline_refuse(timeline *t)
{
    if (t->refusals < TIMELINE_EVENTS) {
        t->refused[t->refusals++] = t->duration;
    }
}

int timeline_range(const timeline *t, unsigned trace, unsigned from, unsigned to, double *low,
                   double *high)
{
    *low = HUGE_VAL;
    *high = -HUGE_VAL;
    for (unsigned i = from; i < to && i < t->bins; i++) {
        *low = fmin(*low, (double)t->bin[i].low[trace]);
        *high = fmax(*high, (double)t->bin[i].high[trace]);
    }
    return *low <= *high;
}
