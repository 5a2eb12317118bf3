/* SPDX-License-Identifier: MIT */
#include "read/rests.h"

#include <math.h>
#include <stdlib.h>

#include "cli/command.h"
#include "cli/message.h"
#include "cli/progress.h"
#include "read/samples.h"

#define PI 3.14159265358979324

#define LEAST_SECONDS 2.0 /* of a rest, see invcal/expert.h */

/* One log, read as one of some rate. */
typedef struct {
    positions p;
    rests_summary summary;
    invcal_rests rests;
    double unit;
    double slower; /* seconds of it in a second of the log's clock */
    recording *recording;
} reading;

/* Where the rate is unknown, these are tried at once; the last is good for all that are slower. */
static const unsigned guess[] = {100, 50, 25};

#define GUESSES (sizeof guess / sizeof guess[0])
#define ENOUGH INVCAL_PARAMETERS /* positions, so that no other guess is wanted */

/* Too large for the stack. */
static recording log_recording;

double rests_least(double rate)
{
    return fmax(LEAST_SECONDS, RESTS_SAMPLES / rate);
}

const char *rests_reason_text(invcal_status reason)
{
    switch (reason) {
    case INVCAL_REST_SHORT:
        return "too short: hold it still longer";
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
    unsigned told = 0;

    for (unsigned i = 0; i < RESTS_REASONS; i++) {
        told += summary->refused[i];
    }
    if (told < RESTS_TOLD) {
        summary->refusal[told] = (rests_refusal){log->outline.duration, log->open.line, reason};
    }
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

void rests_noise(positions *p)
{
    for (unsigned i = 0; i < 3 && p->count > 0; i++) {
        p->noise_square[i] /= p->count;
        if (p->quantum > 0) {
            const double s = noise_behind(p->quantum, p->scatter / p->count);
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
    p->seen = log->where.seen; /* without a temperature that is ignored */
    p->has_temperature = log->has_temperature;
    p->has_angles = log->has_angles;
}

static int digest(reading *r, invcal_event event)
{
    invcal_rest rest;

    if (event == INVCAL_REFUSED) {
        rests_refuse(&r->summary, invcal_rests_reason(&r->rests), r->recording);
    }
    return event == INVCAL_TAKEN && invcal_rests_get(&r->rests, &rest)
               ? rests_take(&r->p, &rest, r->unit, r->recording)
               : EXIT_GOOD;
}

static int feed(reading *r, const samples *log, sample s)
{
    if (s.is_gap) {
        invcal_rests_gap(&r->rests);
    }
    s.clock *= r->slower;
    r->summary.samples++;
    recording_sample(r->recording, log, &s);
    const invcal_event event = invcal_rests_feed(&r->rests, s.raw);
    if (event == INVCAL_NOTHING) {
        return EXIT_GOOD;
    }
    recording_filled(r->recording);
    return digest(r, event);
}

static int read_samples(reading *r, unsigned readings, samples *log, turns *gyro)
{
    sample s;
    int more;
    int failure = EXIT_GOOD;

    while (!failure && (more = samples_next(log, &s)) == 1) {
        for (unsigned k = 0; k < readings && !failure; k++) {
            failure = k == 0 || r->p.count < ENOUGH ? feed(&r[k], log, s) : EXIT_GOOD;
        }
        failure = failure || !gyro ? failure : turns_add(gyro, log, &s);
        progress_show(log->table.file, log->table.line, r->p.count);
    }
    progress_end();
    failure = failure || more < 0 ? EXIT_FILE : EXIT_GOOD;
    for (unsigned k = 0; k < readings && !failure; k++) {
        failure = digest(&r[k], invcal_rests_finish(&r[k].rests));
    }
    return failure;
}

/* `guessed`: samples per second; 0: the log's own. */
static int begin(reading *r, const samples *log, const double *clip, unsigned guessed)
{
    const double rate = guessed > 0 ? guessed : log->rate;

    r->p = (positions){.name = log->table.name, .has_noise = 1};
    r->summary = (rests_summary){.rate = rate,
                                 .is_rate_known = log->is_rate_known,
                                 .track = r->recording,
                                 .unit = log->unit};
    r->unit = log->unit;
    r->slower = log->rate / rate;
    recording_begin(r->recording, log);
    timeline_begin(&r->recording->outline, rate);
    if (invcal_rests_init(&r->rests, guessed > 0 ? guessed : samples_whole_rate(log)) !=
        INVCAL_OK) {
        message("%s: %.6g samples per second: 8 to 8000 are supported", log->table.name, rate);
        return EXIT_FILE;
    }
    if (clip && invcal_rests_rails(&r->rests, samples_count(log, clip[0]),
                                   samples_count(log, clip[1])) != INVCAL_OK) {
        message("%s: --clip: the two limits are equal", log->table.name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

/* The first that has found enough, or else the first. */
static unsigned choose(const reading *r, unsigned readings)
{
    for (unsigned k = 0; k < readings; k++) {
        if (r[k].p.count >= ENOUGH) {
            return k;
        }
    }
    return 0;
}

/* All readings at once, the first in log_recording, the others in theirs. `best` is to be taken. */
static int read_log(reading *r, unsigned readings, recording *others, samples *log,
                    const double *clip, turns *gyro, unsigned *best)
{
    int failure = EXIT_GOOD;

    for (unsigned k = 0; k < readings && !failure; k++) {
        r[k].recording = k == 0 ? &log_recording : &others[k - 1];
        failure = begin(&r[k], log, clip, log->is_rate_known ? 0 : guess[k]);
    }
    failure = failure ? failure : read_samples(r, readings, log, gyro);
    *best = failure ? 0 : choose(r, readings);
    if (*best > 0) {
        log_recording = others[*best - 1];
        r[*best].summary.track = &log_recording;
    }
    return failure;
}

int rests_read(positions *p, const char *path, double rate, const double clip[2], turns *gyro,
               rests_summary *summary)
{
    static samples log; /* too large for the stack */
    reading r[GUESSES] = {{.p = {.name = NULL}}};
    unsigned best = 0;
    int failure = samples_open(&log, path, gyro ? COLUMNS_IMU : COLUMNS_LOG, rate, 0);
    recording *others = failure || log.is_rate_known ? NULL : calloc(GUESSES - 1, sizeof *others);
    const unsigned readings = others ? GUESSES : 1; /* without the memory the first has to do */

    r[0].p.name = log.table.name;
    if (!failure && gyro) {
        turns_begin(gyro, &log);
        gyro = log.has_gyro || gyro->file ? gyro : NULL;
    }
    failure = failure ? failure : read_log(r, readings, others, &log, clip, gyro, &best);
    samples_close(&log);
    free(others);
    for (unsigned k = 0; k < readings; k++) {
        if (k != best) {
            positions_free(&r[k].p);
        }
    }
    *p = r[best].p;
    *summary = r[best].summary;
    rests_end(p, &log, summary);
    if (!failure && gyro) {
        gyro->rate = summary->is_rate_known ? gyro->rate : summary->rate;
        failure = gyro->file ? turns_read(gyro, &log, rate, p->name) : EXIT_GOOD;
        turns_end(gyro);
    }
    return failure;
}
