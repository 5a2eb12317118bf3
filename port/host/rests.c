/* SPDX-License-Identifier: MIT */
#include "rests.h"

#include <math.h>

#include "command.h"
#include "message.h"
#include "progress.h"
#include "samples.h"

/* Too large for the stack. */
static rests_lines log_lines;

typedef struct {
    positions *p;
    double unit;
    rests_summary *summary;
} reading;

void rests_lines_sample(rests_lines *lines, unsigned long line, int is_gap)
{
    lines->fill = is_gap ? 0 : lines->fill; /* the block that was begun is lost */
    if (lines->fill++ == 0) {
        lines->start = line;
    }
}

void rests_lines_block(rests_lines *lines)
{
    lines->line[lines->blocks++ % RESTS_BLOCKS] = lines->start;
    lines->size = lines->size ? lines->size : lines->fill;
    lines->fill = 0;
}

static unsigned long line_of(const rests_lines *lines, uint32_t index)
{
    unsigned long block = lines->size ? index / lines->size : 0;

    if (lines->blocks > RESTS_BLOCKS && block < lines->blocks - RESTS_BLOCKS) {
        block = lines->blocks - RESTS_BLOCKS;
    }
    return lines->line[block % RESTS_BLOCKS];
}

int rests_take(positions *p, const invcal_rest *rest, double unit, const rests_lines *lines)
{
    double mean[3];

    invcal_rest_mean(rest, mean);
    for (unsigned i = 0; i < 3; i++) {
        mean[i] *= unit;
        p->noise_square[i] += rest->variance * unit * unit / rest->count;
    }
    return positions_add(p, mean, line_of(lines, rest->begin));
}

void rests_end(positions *p)
{
    for (unsigned i = 0; i < 3 && p->count > 0; i++) {
        p->noise_square[i] /= p->count;
    }
}

static int digest(reading *r, const invcal_still *still, invcal_still_event seen,
                  const invcal_rest *rest)
{
    if (seen == INVCAL_STILL_REFUSED) {
        r->summary->refused[invcal_still_reason(still)]++;
    }
    return seen == INVCAL_STILL_TAKEN ? rests_take(r->p, rest, r->unit, &log_lines) : EXIT_GOOD;
}

static int32_t rail(double value, double unit)
{
    return (int32_t)fmax(INT32_MIN, fmin(INT32_MAX, nearbyint(value / unit)));
}

static int read_samples(reading *r, samples *log, invcal_still *still)
{
    invcal_rest rest;
    sample s;
    int more;
    int failure = EXIT_GOOD;

    while (!failure && (more = samples_next(log, &s)) == 1) {
        if (s.is_gap) {
            invcal_still_gap(still);
        }
        r->summary->samples++;
        rests_lines_sample(&log_lines, s.line, s.is_gap);
        const invcal_still_event seen = invcal_still_push(still, s.raw, &rest);
        if (seen != INVCAL_STILL_NONE) {
            rests_lines_block(&log_lines);
            failure = digest(r, still, seen, &rest);
        }
        progress_show(&log->table, r->p->count);
    }
    progress_end();
    if (failure || more < 0) {
        return EXIT_FILE;
    }
    return digest(r, still, invcal_still_finish(still, &rest), &rest);
}

int rests_read(positions *p, const char *path, double rate, const double clip[2],
               rests_summary *summary)
{
    static samples log; /* too large for the stack */
    invcal_still still;
    int failure = samples_open(&log, path, rate, 0);
    reading r = {p, log.unit, summary};

    *p = (positions){.name = log.table.name, .has_noise = 1, .seen = log.where.seen};
    *summary = (rests_summary){.rate = log.rate, .is_rate_known = log.is_rate_known};
    if (!failure && invcal_still_init(&still, log.rate, clip ? rail(clip[0], log.unit) : 0,
                                      clip ? rail(clip[1], log.unit) : 0) != INVCAL_OK) {
        message("%s: %.6g samples a second: rests are found at 8 to 8000", p->name, log.rate);
        failure = EXIT_FILE;
    }
    failure = failure ? failure : read_samples(&r, &log, &still);
    samples_close(&log);
    summary->gaps = log.gaps;
    summary->seconds = (double)summary->samples / log.rate;
    rests_end(p);
    return failure;
}
