/* SPDX-License-Identifier: MIT */
#include "read/turns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"

void turns_begin(turns *t, const samples *log)
{
    *t = (turns){.file = t->file,
                 .unit = log->unit,
                 .rate = log->rate,
                 .is_rate_known = log->is_rate_known,
                 .turn = log->where.seen.turn,
                 .has_time = log->has_time};
}

/* Room for one more, by doubling. The new place; null, with a message. */
static void *grow(void *all, size_t count, size_t size, const char *name)
{
    const int is_full = (count & (count - 1)) == 0; /* 0, 1, 2, 4, ... */

    if (!is_full) {
        return all;
    }
    void *more = count < UINT32_MAX / 2 ? realloc(all, (count ? 2 * count : 1) * size) : NULL;
    if (!more) {
        message("%s: not enough memory for its moves; use --accelerometer-only", name);
    }
    return more;
}

static int add_reading(turns *t, const samples *log, const sample *s)
{
    turns_reading *more = grow(t->reading, t->readings, sizeof *more, log->table.name);

    if (!more) {
        return EXIT_FILE;
    }
    t->reading = more;
    turns_reading *one = &t->reading[t->readings];
    *one = (turns_reading){.is_gap = s->is_gap};
    memcpy(one->x, s->gyro, sizeof one->x);
    if (t->readings > 0 && !s->is_gap) {
        t->steps++;
        t->time += s->time - t->last;
    }
    t->last = s->time;
    t->readings++;
    return EXIT_GOOD;
}

int turns_add(turns *t, const samples *log, const sample *s)
{
    turns_sample *more = grow(t->sample, t->samples, sizeof *more, log->table.name);

    if (!more) {
        return EXIT_FILE;
    }
    t->sample = more;
    if (!t->file && add_reading(t, log, s)) {
        return EXIT_FILE;
    }
    turns_sample *one = &t->sample[t->samples++];
    *one = (turns_sample){.time = s->time, .upto = (uint32_t)t->readings, .is_gap = s->is_gap};
    memcpy(one->raw, s->raw, sizeof one->raw);
    return EXIT_GOOD;
}

/* The mean step of the clock: samples.h rounds it, which would be an error of the scale. */
void turns_end(turns *t)
{
    if (t->is_rate_known && t->has_time && t->steps > 0 && t->time > 0 &&
        fabs(t->steps / t->time / t->rate - 1) < 0.01) {
        t->rate = t->steps / t->time;
    }
}

/* Which readings come before each sample. */
static int match(turns *t, const samples *file, const double *time, const char *log)
{
    uint32_t next = 0;

    if (t->has_time != file->has_time || (!t->has_time && t->samples != t->readings)) {
        message("%s: does not match %s: both need a column t of the same clock, or neither and the "
                "same number of rows (%lu and %lu)",
                file->table.name, log, (unsigned long)t->readings, (unsigned long)t->samples);
        return EXIT_FILE;
    }
    for (size_t i = 0; i < t->samples; i++) {
        while (t->has_time && time && next < t->readings && time[next] <= t->sample[i].time) {
            next++;
        }
        t->sample[i].upto = t->has_time ? next : (uint32_t)(i + 1);
    }
    if (t->samples == 0 || t->sample[t->samples - 1].upto < t->readings / 2) {
        message("%s: its times are not those of %s: both need the same clock", file->table.name,
                log);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

static int read_all(turns *t, samples *file, double **time)
{
    sample s;
    int more = 0;
    int failure = EXIT_GOOD;

    while (!failure && (more = samples_next(file, &s)) == 1) {
        double *room = grow(*time, t->readings, sizeof *room, file->table.name);
        failure = room ? EXIT_GOOD : EXIT_FILE;
        *time = room ? room : *time;
        if (room) {
            room[t->readings] = s.time;
            failure = add_reading(t, file, &s);
        }
    }
    return more < 0 ? EXIT_FILE : failure;
}

int turns_read(turns *t, samples *file, double rate, const char *log)
{
    double *time = NULL;
    int failure = samples_open(file, t->file, COLUMNS_GYRO, rate, 0);

    if (!failure) {
        t->seen = file->where.seen;
        t->turn = file->where.seen.turn;
        failure = read_all(t, file, &time);
    }
    failure = failure ? failure : match(t, file, time, log);
    if (!failure && file->is_rate_known) {
        t->rate = file->rate;
        t->is_rate_known = 1;
    }
    samples_close(file);
    free(time);
    return failure;
}

void turns_free(turns *t)
{
    free(t->sample);
    free(t->reading);
    *t = (turns){0};
}
