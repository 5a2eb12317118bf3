/* SPDX-License-Identifier: MIT */
#include "read/motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "maths/median.h"

#define FIRST_SIZE 16u
#define BLOCKS_MIN 8u
#define CURVATURE_RATIO 15.0 /* over the median, which is 0.67 sigma */
#define VARIANCE_RATIO 25.0  /* over the median */
#define CURVATURE_QUANTA 4.0
#define NOISE_QUANTA 2.0
/* Relative to the length of the reading: less is no significant motion. */
#define CURVATURE_FIELD 1e-4
#define NOISE_FIELD 1e-3

void motion_begin(motion *m)
{
    m->blocks = 0;
    m->size = FIRST_SIZE;
    memset(m->quantum, 0, sizeof m->quantum);
}

/* Halves the number of blocks. */
static void merge_pairs(motion *m)
{
    for (unsigned i = 0; i < m->blocks; i += 2) {
        motion_block merged = m->block[i];
        const motion_block *second = &m->block[i + 1];
        merged.count += second->count;
        for (unsigned k = 0; k < 3; k++) {
            merged.sum[k] += second->sum[k];
            merged.squares[k] += second->squares[k];
        }
        m->block[i / 2] = merged;
    }
    m->blocks /= 2;
    m->size *= 2;
}

static void begin_block(motion *m, const sample *s)
{
    if (m->blocks == MOTION_BLOCKS) {
        merge_pairs(m);
    }
    m->block[m->blocks++] = (motion_block){.line = s->line, .clock = s->clock};
}

static void update_quantum(motion *m, const int32_t raw[3])
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
        update_quantum(m, s->raw);
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

/* The second difference of block means. */
static double curvature(const motion *m, unsigned block, unsigned axis)
{
    return fabs(mean(m, block, axis) - 2 * mean(m, block + 1, axis) + mean(m, block + 2, axis));
}

static double variance(const motion *m, unsigned block, unsigned axis)
{
    const double x = mean(m, block, axis);

    return fmax(0, m->block[block].squares[axis] / m->block[block].count - x * x);
}

typedef double block_statistic(const motion *m, unsigned block, unsigned axis);

static double median(motion *m, block_statistic *statistic, unsigned count, unsigned axis)
{
    for (unsigned i = 0; i < count; i++) {
        m->scratch[i] = statistic(m, i, axis);
    }
    return median_of(m->scratch, count);
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

/* Finds the first of `count` blocks whose statistic is above the limit, unless an earlier place is
 * known. The motion is `offset` blocks after it. */
static void find_above(const motion *m, block_statistic *statistic, unsigned count, unsigned axis,
                       double limit, unsigned offset, motion_place *out, unsigned *first)
{
    for (unsigned i = 0; i < count && i + offset < *first; i++) {
        const motion_block *b = &m->block[i + offset];
        if (!(statistic(m, i, axis) <= limit)) {
            *first = i + offset;
            *out = (motion_place){.axis = axis, .line = b->line, .clock = b->clock};
            out->is_shaking = offset == 0;
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
        const double variance_max =
            fmax(VARIANCE_RATIO * median(m, variance, blocks, k),
                 fmax(pow(NOISE_QUANTA * quantum, 2), pow(NOISE_FIELD * length(m), 2)));
        const double curvature_max =
            fmax(CURVATURE_RATIO * median(m, curvature, blocks - 2, k),
                 fmax(CURVATURE_QUANTA * quantum, CURVATURE_FIELD * length(m)));
        find_above(m, variance, blocks, k, variance_max, 0, out, &first);
        find_above(m, curvature, blocks - 2, k, curvature_max, 2, out, &first);
    }
    return first < MOTION_BLOCKS;
}
