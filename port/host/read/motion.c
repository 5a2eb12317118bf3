/* SPDX-License-Identifier: MIT */
#include "read/motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define FIRST_SIZE 16u
#define BLOCKS_MIN 8u
#define BEND 15.0     /* times the median, which is 0.67 sigma */
#define VARIANCE 25.0 /* times the median */
#define BEND_QUANTA 4.0
#define SHAKE_QUANTA 2.0
/* Over the length of the reading: less is no motion that matters. */
#define BEND_FIELD 1e-4
#define SHAKE_FIELD 1e-3

void motion_begin(motion *m)
{
    m->blocks = 0;
    m->size = FIRST_SIZE;
    memset(m->quantum, 0, sizeof m->quantum);
}

/* Each two blocks become one. */
static void halve(motion *m)
{
    for (unsigned i = 0; i < m->blocks; i += 2) {
        motion_block both = m->block[i];
        const motion_block *second = &m->block[i + 1];
        both.count += second->count;
        for (unsigned k = 0; k < 3; k++) {
            both.sum[k] += second->sum[k];
            both.squares[k] += second->squares[k];
        }
        m->block[i / 2] = both;
    }
    m->blocks /= 2;
    m->size *= 2;
}

static void begin_block(motion *m, const sample *s)
{
    if (m->blocks == MOTION_BLOCKS) {
        halve(m);
    }
    m->block[m->blocks++] = (motion_block){.line = s->line, .clock = s->clock};
}

static void watch_quantum(motion *m, const int32_t raw[3])
{
    for (unsigned k = 0; k < 3; k++) {
        const int64_t step = llabs((int64_t)raw[k] - m->last[k]);
        if (step > 0 && (m->quantum[k] == 0 || step < m->quantum[k])) {
            m->quantum[k] = step;
        }
    }
}

void motion_add(motion *m, const sample *s)
{
    if (m->blocks == 0) {
        memcpy(m->origin, s->raw, sizeof m->origin);
    } else {
        watch_quantum(m, s->raw);
    }
    if (m->blocks == 0 || m->block[m->blocks - 1].count == m->size) {
        begin_block(m, s);
    }
    motion_block *now = &m->block[m->blocks - 1];
    for (unsigned k = 0; k < 3; k++) {
        const int64_t x = (int64_t)s->raw[k] - m->origin[k];
        now->sum[k] += x;
        now->squares[k] += (double)x * (double)x;
    }
    now->count++;
    memcpy(m->last, s->raw, sizeof m->last);
}

int motion_is_frozen(const motion *m, unsigned axis)
{
    return m->quantum[axis] == 0;
}

static double mean(const motion *m, unsigned block, unsigned axis)
{
    return (double)m->block[block].sum[axis] / m->block[block].count;
}

static double bend(const motion *m, unsigned block, unsigned axis)
{
    return fabs(mean(m, block, axis) - 2 * mean(m, block + 1, axis) + mean(m, block + 2, axis));
}

static double variance(const motion *m, unsigned block, unsigned axis)
{
    const double x = mean(m, block, axis);

    return fmax(0, m->block[block].squares[axis] / m->block[block].count - x * x);
}

typedef double quantity(const motion *m, unsigned block, unsigned axis);

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;

    return (x > y) - (x < y);
}

static double median(motion *m, quantity *of, unsigned count, unsigned axis)
{
    for (unsigned i = 0; i < count; i++) {
        m->scratch[i] = of(m, i, axis);
    }
    qsort(m->scratch, count, sizeof m->scratch[0], compare);
    return m->scratch[count / 2];
}

static double length(const motion *m)
{
    double square = 0;

    for (unsigned k = 0; k < 3; k++) {
        const double x = m->origin[k] + mean(m, 0, k);
        square += x * x;
    }
    return sqrt(square);
}

/* The first of `count` blocks whose quantity is above the limit, unless an earlier place is known.
 * `ahead`: so many blocks on it shows. */
static void search(const motion *m, quantity *of, unsigned count, unsigned axis, double limit,
                   unsigned ahead, motion_place *out, unsigned *first)
{
    for (unsigned i = 0; i < count && i + ahead < *first; i++) {
        const motion_block *b = &m->block[i + ahead];
        if (!(of(m, i, axis) <= limit)) {
            *first = i + ahead;
            *out = (motion_place){.axis = axis, .line = b->line, .clock = b->clock};
            out->is_shaking = ahead == 0;
        }
    }
}

int motion_find(motion *m, motion_place *out)
{
    const int is_last_full = m->blocks > 0 && m->block[m->blocks - 1].count == m->size;
    const unsigned blocks = m->blocks - (is_last_full ? 0 : 1);
    unsigned first = MOTION_BLOCKS;

    if (m->blocks == 0 || blocks < BLOCKS_MIN) {
        return 0;
    }
    for (unsigned k = 0; k < 3; k++) {
        const double quantum = (double)m->quantum[k];
        const double shake =
            fmax(VARIANCE * median(m, variance, blocks, k),
                 fmax(pow(SHAKE_QUANTA * quantum, 2), pow(SHAKE_FIELD * length(m), 2)));
        const double most = fmax(BEND * median(m, bend, blocks - 2, k),
                                 fmax(BEND_QUANTA * quantum, BEND_FIELD * length(m)));
        search(m, variance, blocks, k, shake, 0, out, &first);
        search(m, bend, blocks - 2, k, most, 2, out, &first);
    }
    return first < MOTION_BLOCKS;
}
