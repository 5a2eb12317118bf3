/* SPDX-License-Identifier: MIT */
#include "recording.h"

#include <math.h>

#include "number.h"

void recording_begin(recording *r, const samples *log)
{
    r->blocks = 0;
    r->fill = r->size = 0;
    r->has_temperature = log->has_temperature;
    timeline_begin(&r->outline, log->rate);
}

void recording_sample(recording *r, const samples *log, const sample *s)
{
    double value[TIMELINE_TRACES];

    r->fill = s->is_gap ? 0 : r->fill; /* the block that was begun is lost */
    if (r->fill++ == 0) {
        r->open = (recording_block){.line = s->line, .clock = s->clock};
    }
    r->open.temperature += s->temperature;
    for (unsigned i = 0; i < 3; i++) {
        value[i] = s->raw[i] * log->unit;
    }
    value[3] = s->temperature;
    timeline_add(&r->outline, s->clock, value);
}

void recording_filled(recording *r)
{
    r->block[r->blocks++ % RECORDING_BLOCKS] = r->open;
    r->size = r->size ? r->size : r->fill;
    r->fill = 0;
}

/* The block that begins with sample `index` of those in full blocks, or the oldest remembered. */
static unsigned long block_of(const recording *r, uint32_t index)
{
    const unsigned long block = r->size ? index / r->size : 0;
    const unsigned long oldest = r->blocks > RECORDING_BLOCKS ? r->blocks - RECORDING_BLOCKS : 0;

    return block < oldest ? oldest : block;
}

recording_place recording_find(const recording *r, const invcal_rest *rest)
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
    return (recording_place){
        .line = r->block[first % RECORDING_BLOCKS].line,
        .begin = r->block[first % RECORDING_BLOCKS].clock,
        .end = last < r->blocks ? r->block[last % RECORDING_BLOCKS].clock : r->outline.duration,
        .temperature = is_known ? temperature / (count * r->size) : NUMBER_UNKNOWN,
        .drift = is_known && count > 1 ? fabs(12 * moment / (r->size * (count * count - 1)))
                                       : NUMBER_UNKNOWN,
    };
}
