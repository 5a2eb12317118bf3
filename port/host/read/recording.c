/* SPDX-License-Identifier: MIT */
#include "read/recording.h"

#include <math.h>

#include "text/number.h"

#define ANGLE_CHANGE 0.02 /* degrees in a rest: the last digit of an encoder may change */

void recording_begin(recording *r, const samples *log)
{
    r->blocks = 0;
    r->fill = r->size = 0;
    r->quantum = 0;
    r->has_temperature = log->has_temperature;
    timeline_begin(&r->outline, log->rate);
}

static void note_step(recording *r, const sample *s)
{
    for (unsigned i = 0; i < 3; i++) {
        const double step = fabs((double)s->raw[i] - r->before[i]);
        if (r->blocks > 0 && step > 0 && !(r->quantum > 0 && r->quantum <= step)) {
            r->quantum = step;
        }
        r->before[i] = s->raw[i];
    }
}

void recording_sample(recording *r, const samples *log, const sample *s)
{
    double value[TIMELINE_TRACES];

    r->fill = s->is_gap ? 0 : r->fill; /* a partly filled block is lost */
    if (r->fill++ == 0) {
        r->open = (recording_block){
            .line = s->line, .clock = s->clock, .angle = {s->angle[0], s->angle[1]}};
    }
    r->has_temperature = log->has_temperature;
    r->open.temperature += s->temperature;
    for (unsigned i = 0; i < 3; i++) {
        value[i] = s->raw[i] * log->unit;
        r->open.sum[i] += s->raw[i];
    }
    note_step(r, s);
    value[3] = s->temperature;
    timeline_add(&r->outline, s->clock, value);
}

void recording_filled(recording *r)
{
    r->block[r->blocks++ % RECORDING_BLOCKS] = r->open;
    r->size = r->size ? r->size : r->fill;
    r->fill = 0;
}

/* The block that begins with sample `index`, counted in full blocks, or the oldest in memory. */
static unsigned long block_of(const recording *r, uint32_t index)
{
    const unsigned long block = r->size ? index / r->size : 0;
    const unsigned long oldest = r->blocks > RECORDING_BLOCKS ? r->blocks - RECORDING_BLOCKS : 0;

    return block < oldest ? oldest : block;
}

/* The variance of the mean of an axis, by batch means. */
static double variance_of_mean(const recording *r, unsigned long first, unsigned long last,
                               unsigned axis)
{
    const double count = (double)(last - first);
    double sum = 0;
    double squares = 0;

    for (unsigned long k = first; k < last; k++) {
        const double mean = r->block[k % RECORDING_BLOCKS].sum[axis] / r->size;
        const double reference = r->block[first % RECORDING_BLOCKS].sum[axis] / r->size;
        sum += mean - reference;
        squares += (mean - reference) * (mean - reference);
    }
    return (squares - sum * sum / count) / (count * (count - 1));
}

/* The angle in the middle of a rest; unknown if it was another one before or after. */
static double angle_of(const recording *r, unsigned long first, unsigned long last, unsigned which)
{
    const double middle = r->block[(first + last) / 2 % RECORDING_BLOCKS].angle[which];
    double largest = 0;

    for (unsigned long k = first; k < last && k < r->blocks; k++) {
        const double off = fabs(r->block[k % RECORDING_BLOCKS].angle[which] - middle);
        largest = off <= largest ? largest : off; /* NaN, too */
    }
    return largest <= ANGLE_CHANGE ? middle : NUMBER_UNKNOWN;
}

unsigned recording_count(const recording *r)
{
    return r->blocks > RECORDING_BLOCKS ? RECORDING_BLOCKS : (unsigned)r->blocks;
}

recording_mean recording_at(const recording *r, unsigned block, double unit)
{
    const unsigned long k = r->blocks - recording_count(r) + block;
    const recording_block *b = &r->block[k % RECORDING_BLOCKS];
    const double next =
        k + 1 < r->blocks ? r->block[(k + 1) % RECORDING_BLOCKS].clock : r->outline.duration;
    recording_mean m = {(b->clock + next) / 2, NUMBER_UNKNOWN, {0}};

    if (r->has_temperature) {
        m.temperature = b->temperature / r->size;
    }
    for (unsigned i = 0; i < 3; i++) {
        m.mean[i] = b->sum[i] / r->size * unit;
    }
    return m;
}

recording_place recording_find(const recording *r, const invcali_rest *rest)
{
    const unsigned long first = block_of(r, rest->begin);
    const unsigned long last = block_of(r, rest->end);
    const double count = (double)(last - first);
    const int is_known = r->has_temperature && last > first;
    double temperature = 0;
    double moment = 0; /* about the middle of the rest */

    for (unsigned long k = first; k < last && k < r->blocks; k++) {
        const double sum = r->block[k % RECORDING_BLOCKS].temperature;
        temperature += sum;
        moment += ((double)(k - first) - (count - 1) / 2) * sum;
    }
    recording_place place = {
        .line = r->block[first % RECORDING_BLOCKS].line,
        .begin = r->block[first % RECORDING_BLOCKS].clock,
        .end = last < r->blocks ? r->block[last % RECORDING_BLOCKS].clock : r->outline.duration,
        .temperature = is_known ? temperature / (count * r->size) : NUMBER_UNKNOWN,
        .drift = is_known && count > 1 ? fabs(12 * moment / (r->size * (count * count - 1)))
                                       : NUMBER_UNKNOWN,
    };
    for (unsigned i = 0; i < 2; i++) {
        place.angle[i] = angle_of(r, first, last, i);
    }
    for (unsigned i = 0; i < 3; i++) {
        const unsigned long end = last < r->blocks ? last : r->blocks;
        place.variance[i] = end > first + 1 ? variance_of_mean(r, first, end, i) : NUMBER_UNKNOWN;
    }
    return place;
}
