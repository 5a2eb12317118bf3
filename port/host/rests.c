/* SPDX-License-Identifier: MIT */
#include "rests.h"

#include <math.h>

#include "command.h"
#include "message.h"
#include "progress.h"
#include "samples.h"

/* Too large for the stack. */
static recording log_recording;

typedef struct {
    positions *p;
    double unit;
    rests_summary *summary;
} reading;

int rests_take(positions *p, const invcal_rest *rest, double unit, const recording *log)
{
    const recording_place place = recording_find(log, rest);
    const position_origin origin = {place.line, place.begin, place.end, place.temperature,
                                    place.drift};
    double mean[3];

    invcal_rest_mean(rest, mean);
    for (unsigned i = 0; i < 3; i++) {
        mean[i] *= unit;
        p->noise_square[i] += rest->variance * unit * unit / rest->count;
    }
    return positions_add(p, mean, &origin);
}

void rests_end(positions *p, const samples *log, rests_summary *summary)
{
    for (unsigned i = 0; i < 3 && p->count > 0; i++) {
        p->noise_square[i] /= p->count;
    }
    p->bytes = log->table.bytes;
    p->crc = log->table.crc;
    summary->gaps = log->gaps;
    summary->skipped = log->skipped;
    summary->seconds = (double)summary->samples / log->rate;
    p->has_temperature = log->has_temperature;
}

static int digest(reading *r, const invcal_still *still, invcal_still_event seen,
                  const invcal_rest *rest)
{
    if (seen == INVCAL_STILL_REFUSED) {
        r->summary->refused[invcal_still_reason(still)]++;
        timeline_refuse(&log_recording.outline);
    }
    return seen == INVCAL_STILL_TAKEN ? rests_take(r->p, rest, r->unit, &log_recording) : EXIT_GOOD;
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

    recording_begin(&log_recording, log);
    while (!failure && (more = samples_next(log, &s)) == 1) {
        if (s.is_gap) {
            invcal_still_gap(still);
        }
        r->summary->samples++;
        recording_sample(&log_recording, log, &s);
        const invcal_still_event seen = invcal_still_push(still, s.raw, &rest);
        if (seen != INVCAL_STILL_NONE) {
            recording_filled(&log_recording);
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
    *summary = (rests_summary){
        .rate = log.rate, .is_rate_known = log.is_rate_known, .outline = &log_recording.outline};
    if (!failure && invcal_still_init(&still, log.rate, clip ? rail(clip[0], log.unit) : 0,
                                      clip ? rail(clip[1], log.unit) : 0) != INVCAL_OK) {
        message("%s: %.6g samples a second: rests are found at 8 to 8000", p->name, log.rate);
        failure = EXIT_FILE;
    }
    failure = failure ? failure : read_samples(&r, &log, &still);
    samples_close(&log);
    rests_end(p, &log, summary);
    return failure;
}
