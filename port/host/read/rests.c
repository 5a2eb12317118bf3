/* SPDX-License-Identifier: MIT */
#include "read/rests.h"

#include <math.h>

#include "cli/command.h"
#include "cli/message.h"
#include "cli/progress.h"
#include "read/samples.h"

#define PI 3.14159265358979324

/* Too large for the stack. */
static recording log_recording;

typedef struct {
    positions *p;
    double unit;
    rests_summary *summary;
} reading;

const char *rests_reason_text(invcal_status reason)
{
    switch (reason) {
    case INVCAL_REST_SHORT:
        return "too short: hold it still longer";
    case INVCAL_REST_DRIFT:
        return "readings creep: turned slowly, or not settled";
    case INVCAL_REST_CLIPPED:
        return "at the end of the sensor's range";
    case INVCAL_REST_FROZEN:
        return "readings, or those of an axis, never change: is the sensor read?";
    case INVCAL_REST_GAP:
        return "too short: samples were lost";
    case INVCAL_REST_SAME:
        return "the same place as before";
    case INVCAL_OUT_OF_RANGE:
        return "a reading is below a tenth or above ten times the field: wrong scale, zero or "
               "field";
    default:
        return invcal_status_text(reason);
    }
}

void rests_refuse(rests_summary *summary, invcal_status reason, recording *log)
{
    summary->refused[reason - INVCAL_REST_SHORT]++;
    timeline_refuse(&log->outline);
}

int rests_take(positions *p, const invcal_rest *rest, double unit, const recording *log)
{
    const recording_place place = recording_find(log, rest);
    const position_origin origin = {.line = place.line,
                                    .begin = place.begin,
                                    .end = place.end,
                                    .temperature = place.temperature,
                                    .drift = place.drift,
                                    .alpha = place.angle[0],
                                    .beta = place.angle[1]};
    const double white = rest->variance / rest->count;
    double mean[3];

    for (unsigned i = 0; i < 3; i++) {
        const double variance = isnan(place.variance[i]) ? white : place.variance[i];
        mean[i] = (double)rest->sum[i] / rest->count * unit;
        p->noise_square[i] += variance * unit * unit;
    }
    p->scatter += rest->variance * unit * unit;
    p->quantum = log->quantum * unit;
    return positions_add(p, mean, &origin);
}

/* What rounding to steps of q leaves in a mean, however many samples it has: of noise s the cells of the
 * quantiser average all but this (the first terms of a Fourier series). */
static double floor_square(double q, double s)
{
    double sum = 0;

    for (unsigned k = 1; k <= 5; k++) {
        sum += exp(-4 * PI * PI * k * k * s * s / (q * q)) / (k * k);
    }
    return q * q / (2 * PI * PI) * sum;
}

/* The noise s behind samples of variance v = s^2 + q^2/12 - floor^2(s): by bisection, as v grows with s. */
static double noise_behind(double q, double v)
{
    double low = 0;
    double high = sqrt(v);

    for (unsigned i = 0; i < 60; i++) {
        const double s = (low + high) / 2;
        if (s * s + q * q / 12 - floor_square(q, s) < v) {
            low = s;
        } else {
            high = s;
        }
    }
    return (low + high) / 2;
}

void rests_end(positions *p, const samples *log, rests_summary *summary)
{
    for (unsigned i = 0; i < 3 && p->count > 0; i++) {
        p->noise_square[i] /= p->count;
        if (p->quantum > 0) {
            const double s = noise_behind(p->quantum, p->scatter / p->count);
            p->noise_square[i] += floor_square(p->quantum, s);
        }
    }
    p->bytes = log->table.bytes;
    p->crc = log->table.crc;
    summary->gaps = log->gaps;
    summary->skipped = log->skipped;
    summary->seconds = (double)summary->samples / log->rate;
    p->has_temperature = log->has_temperature;
    p->has_angles = log->has_angles;
}

static int digest(reading *r, const invcal_rests *rests, invcal_event event)
{
    invcal_rest rest;

    if (event == INVCAL_REFUSED) {
        rests_refuse(r->summary, invcal_rests_reason(rests), &log_recording);
    }
    return event == INVCAL_TAKEN && invcal_rests_get(rests, &rest)
               ? rests_take(r->p, &rest, r->unit, &log_recording)
               : EXIT_GOOD;
}

static int read_samples(reading *r, samples *log, invcal_rests *rests)
{
    sample s;
    int more;
    int failure = EXIT_GOOD;

    recording_begin(&log_recording, log);
    while (!failure && (more = samples_next(log, &s)) == 1) {
        if (s.is_gap) {
            invcal_rests_gap(rests);
        }
        r->summary->samples++;
        recording_sample(&log_recording, log, &s);
        const invcal_event event = invcal_rests_feed(rests, s.raw);
        if (event != INVCAL_NOTHING) {
            recording_filled(&log_recording);
            failure = digest(r, rests, event);
        }
        progress_show(log->table.file, log->table.line, r->p->count);
    }
    progress_end();
    if (failure || more < 0) {
        return EXIT_FILE;
    }
    return digest(r, rests, invcal_rests_finish(rests));
}

static int begin(invcal_rests *rests, const samples *log, const double *clip)
{
    if (invcal_rests_init(rests, samples_whole_rate(log)) != INVCAL_OK) {
        message("%s: %.6g samples a second: rests are found at 8 to 8000", log->table.name,
                log->rate);
        return EXIT_FILE;
    }
    if (clip && invcal_rests_rails(rests, samples_count(log, clip[0]),
                                   samples_count(log, clip[1])) != INVCAL_OK) {
        message("%s: --clip: the two are the same reading", log->table.name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

int rests_read(positions *p, const char *path, double rate, const double clip[2],
               rests_summary *summary)
{
    static samples log; /* too large for the stack */
    invcal_rests rests;
    int failure = samples_open(&log, path, rate, 0);
    reading r = {p, log.unit, summary};

    *p = (positions){.name = log.table.name, .has_noise = 1, .seen = log.where.seen};
    *summary = (rests_summary){.rate = log.rate,
                               .is_rate_known = log.is_rate_known,
                               .track = &log_recording,
                               .unit = log.unit};
    failure = failure ? failure : begin(&rests, &log, clip);
    failure = failure ? failure : read_samples(&r, &log, &rests);
    samples_close(&log);
    rests_end(p, &log, summary);
    return failure;
}
