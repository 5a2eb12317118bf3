/* SPDX-License-Identifier: MIT */
#include "read/log_rests.h"

#include <math.h>
#include <stdlib.h>

#include "cli/command.h"
#include "cli/message.h"
#include "cli/progress.h"
#include "read/samples.h"

#define PI 3.14159265358979324

#define SECONDS_MIN 2.0 /* of a rest, see invcal/expert.h */

/* A log, read with one assumption about its rate. */
typedef struct {
    positions p;
    rests_summary summary;
    invcal_private_rests rests;
    double unit;
    double clock_scale; /* seconds at the assumed rate per second of the log's clock */
    recording *recording;
} trial;

/* If the rate is unknown, all of these are tried in one pass; the last one also works for lower
 * rates. */
static const unsigned assumed_rate[] = {100, 50, 25};

#define RATES (sizeof assumed_rate / sizeof assumed_rate[0])
#define POSITIONS_ENOUGH INVCAL_PARAMETERS /* with these, lower rates need not be tried */

/* Too large for the stack. */
static recording log_recording;

double rests_min_seconds(double rate)
{
    return fmax(SECONDS_MIN, RESTS_SAMPLES / rate);
}

const char *rests_reason_text(invcal_status reason)
{
    switch (reason) {
    case INVCAL_REST_SHORT:
        return "too short: hold still longer";
    case INVCAL_REST_CLIPPED:
        return "at the end of the range";
    case INVCAL_REST_FROZEN:
        return "readings, or those of an axis, never change: is the sensor read?";
    case INVCAL_REST_GAP:
        return "too short: samples lost";
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
    unsigned listed = 0;

    for (unsigned i = 0; i < RESTS_REASONS; i++) {
        listed += summary->refused[i];
    }
    if (listed < RESTS_LISTED) {
        summary->refusal[listed] = (rests_refusal){log->outline.duration, log->open.line, reason};
    }
    summary->refused[reason - INVCAL_REST_SHORT]++;
    timeline_refuse(&log->outline);
}

int rests_take(positions *p, const invcali_rest *rest, double unit, const recording *log)
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

/* The variance of a mean that rounding to steps of q leaves, however many samples it has, if their
 * noise is s (the first terms of a Fourier series). */
static double floor_square(double q, double s)
{
    double sum = 0;

    for (unsigned k = 1; k <= 5; k++) {
        sum += exp(-4 * PI * PI * k * k * s * s / (q * q)) / (k * k);
    }
    return q * q / (2 * PI * PI) * sum;
}

/* The noise s of samples of variance v = s^2 + q^2/12 - floor^2(s), by bisection, as v increases
 * with s. */
static double noise_of(double q, double v)
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

void rests_noise(positions *p)
{
    for (unsigned i = 0; i < 3 && p->count > 0; i++) {
        p->noise_square[i] /= p->count;
        if (p->quantum > 0) {
            const double s = noise_of(p->quantum, p->scatter / p->count);
            p->floor_square = floor_square(p->quantum, s);
            p->noise_square[i] += p->floor_square;
        }
    }
}

void rests_end(positions *p, const samples *log, rests_summary *summary)
{
    rests_noise(p);
    p->bytes = log->table.bytes;
    p->crc = log->table.crc;
    summary->gaps = log->gaps;
    summary->skipped = log->skipped;
    summary->seconds = (double)summary->samples / summary->rate;
    p->rests = summary;
    p->seen = log->where.seen; /* without the temperature if it was ignored */
    p->has_temperature = log->has_temperature;
    p->has_angles = log->has_angles;
}

static int handle_event(trial *r, invcal_event event)
{
    invcali_rest rest;

    if (event == INVCAL_REFUSED) {
        rests_refuse(&r->summary, invcali_rests_reason(&r->rests), r->recording);
    }
    return event == INVCAL_TAKEN && invcali_rests_get(&r->rests, &rest)
               ? rests_take(&r->p, &rest, r->unit, r->recording)
               : EXIT_GOOD;
}

static int feed(trial *r, const samples *log, sample s)
{
    if (s.is_gap) {
        invcali_rests_gap(&r->rests);
    }
    s.clock *= r->clock_scale;
    r->summary.samples++;
    recording_sample(r->recording, log, &s);
    const invcal_event event = invcali_rests_feed(&r->rests, s.raw);
    if (event == INVCAL_NOTHING) {
        return EXIT_GOOD;
    }
    recording_filled(r->recording);
    return handle_event(r, event);
}

static int read_samples(trial *r, unsigned trials, samples *log, gyro_log *gyro)
{
    sample s;
    int more;
    int failure = EXIT_GOOD;

    while (!failure && (more = samples_next(log, &s)) == 1) {
        for (unsigned k = 0; k < trials && !failure; k++) {
            failure = k == 0 || r->p.count < POSITIONS_ENOUGH ? feed(&r[k], log, s) : EXIT_GOOD;
        }
        failure = failure || !gyro ? failure : gyro_log_add(gyro, log, &s);
        progress_show(log->table.file, log->table.line, r->p.count);
    }
    progress_end();
    failure = failure || more < 0 ? EXIT_FILE : EXIT_GOOD;
    for (unsigned k = 0; k < trials && !failure; k++) {
        failure = handle_event(&r[k], invcali_rests_finish(&r[k].rests));
    }
    return failure;
}

/* `assumed`: rate in samples per second; 0: that of the log. */
static int begin(trial *r, const samples *log, const double *clip, unsigned assumed)
{
    const double rate = assumed > 0 ? assumed : log->rate;

    r->p = (positions){.name = log->table.name, .has_noise = 1};
    r->summary = (rests_summary){.rate = rate,
                                 .is_rate_known = log->is_rate_known,
                                 .track = r->recording,
                                 .unit = log->unit};
    r->unit = log->unit;
    r->clock_scale = log->rate / rate;
    recording_begin(r->recording, log);
    timeline_begin(&r->recording->outline, rate);
    if (invcali_rests_init(&r->rests, assumed > 0 ? assumed : samples_whole_rate(log)) !=
        INVCAL_OK) {
        message("%s: %.6g samples per second: 8 to 8000 are supported", log->table.name, rate);
        return EXIT_FILE;
    }
    if (clip && invcali_rests_rails(&r->rests, samples_count(log, clip[0]),
                                    samples_count(log, clip[1])) != INVCAL_OK) {
        message("%s: --clip: the two limits are equal", log->table.name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

/* The first trial that has found enough positions, or else the first one. */
static unsigned choose(const trial *r, unsigned trials)
{
    for (unsigned k = 0; k < trials; k++) {
        if (r[k].p.count >= POSITIONS_ENOUGH) {
            return k;
        }
    }
    return 0;
}

/* Makes all trials in one pass, the first with log_recording, the rest with `others`. *best: the
 * one to use. */
static int read_log(trial *r, unsigned trials, recording *others, samples *log, const double *clip,
                    gyro_log *gyro, unsigned *best)
{
    int failure = EXIT_GOOD;

    for (unsigned k = 0; k < trials && !failure; k++) {
        r[k].recording = k == 0 ? &log_recording : &others[k - 1];
        failure = begin(&r[k], log, clip, log->is_rate_known ? 0 : assumed_rate[k]);
    }
    failure = failure ? failure : read_samples(r, trials, log, gyro);
    *best = failure ? 0 : choose(r, trials);
    if (*best > 0) {
        log_recording = others[*best - 1];
        r[*best].summary.track = &log_recording;
    }
    return failure;
}

int rests_read(positions *p, const char *path, double rate, const double clip[2], gyro_log *gyro,
               rests_summary *summary)
{
    static samples log; /* too large for the stack */
    trial r[RATES] = {{.p = {.name = NULL}}};
    unsigned best = 0;
    int failure = samples_open(&log, path, gyro ? COLUMNS_IMU : COLUMNS_LOG, rate, 0);
    recording *others = failure || log.is_rate_known ? NULL : calloc(RATES - 1, sizeof *others);
    const unsigned trials = others ? RATES : 1; /* only the first if memory is short */

    r[0].p.name = log.table.name;
    if (!failure && gyro) {
        gyro_log_begin(gyro, &log);
        gyro = log.has_gyro || gyro->file ? gyro : NULL;
    }
    failure = failure ? failure : read_log(r, trials, others, &log, clip, gyro, &best);
    samples_close(&log);
    free(others);
    for (unsigned k = 0; k < trials; k++) {
        if (k != best) {
            positions_free(&r[k].p);
        }
    }
    *p = r[best].p;
    *summary = r[best].summary;
    rests_end(p, &log, summary);
    if (!failure && gyro) {
        gyro->rate = summary->is_rate_known ? gyro->rate : summary->rate;
        failure = gyro->file ? gyro_log_read(gyro, &log, rate, p->name) : EXIT_GOOD;
        gyro_log_end(gyro);
    }
    return failure;
}
