/* SPDX-License-Identifier: MIT */
#include "read/gyro_log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"

void gyro_log_begin(gyro_log *g, const samples *log)
{
    *g = (gyro_log){.file = g->file,
                    .unit = log->unit,
                    .rate = log->rate,
                    .is_rate_known = log->is_rate_known,
                    .rate_unit = log->where.seen.rate_unit,
                    .has_time = log->has_time};
}

/* Makes room for one more element, by doubling. Returns the array; null, with a message. */
static void *grow(void *array, size_t count, size_t size, const char *name)
{
    const int is_full = (count & (count - 1)) == 0; /* 0, 1, 2, 4, ... */

    if (!is_full) {
        return array;
    }
    void *larger = count < UINT32_MAX / 2 ? realloc(array, (count ? 2 * count : 1) * size) : NULL;
    if (!larger) {
        message("%s: not enough memory for its moves; use --accelerometer-only", name);
    }
    return larger;
}

static int add_reading(gyro_log *g, const samples *log, const sample *s)
{
    gyro_log_reading *larger = grow(g->reading, g->readings, sizeof *larger, log->table.name);

    if (!larger) {
        return EXIT_FILE;
    }
    g->reading = larger;
    gyro_log_reading *reading = &g->reading[g->readings];
    *reading = (gyro_log_reading){.is_gap = s->is_gap};
    memcpy(reading->x, s->gyro, sizeof reading->x);
    if (g->readings > 0 && !s->is_gap) {
        g->steps++;
        g->time += s->time - g->last;
    }
    g->last = s->time;
    g->readings++;
    return EXIT_GOOD;
}

int gyro_log_add(gyro_log *g, const samples *log, const sample *s)
{
    gyro_log_sample *larger = grow(g->sample, g->samples, sizeof *larger, log->table.name);

    if (!larger) {
        return EXIT_FILE;
    }
    g->sample = larger;
    if (!g->file && add_reading(g, log, s)) {
        return EXIT_FILE;
    }
    gyro_log_sample *added = &g->sample[g->samples++];
    *added = (gyro_log_sample){
        .time = s->time, .reading_end = (uint32_t)g->readings, .is_gap = s->is_gap};
    memcpy(added->raw, s->raw, sizeof added->raw);
    return EXIT_GOOD;
}

/* By the mean step of the clock: samples.h rounds the rate, which would be an error of the
 * scales. */
void gyro_log_end(gyro_log *g)
{
    if (g->is_rate_known && g->has_time && g->steps > 0 && g->time > 0 &&
        fabs(g->steps / g->time / g->rate - 1) < 0.01) {
        g->rate = g->steps / g->time;
    }
}

/* Finds the readings before each sample. */
static int match_samples(gyro_log *g, const samples *file, const double *time, const char *log)
{
    uint32_t next = 0;

    if (g->has_time != file->has_time || (!g->has_time && g->samples != g->readings)) {
        message("%s: does not match %s: both need a column t of the same clock, or neither and the "
                "same number of rows (%lu and %lu)",
                file->table.name, log, (unsigned long)g->readings, (unsigned long)g->samples);
        return EXIT_FILE;
    }
    for (size_t i = 0; i < g->samples; i++) {
        while (g->has_time && time && next < g->readings && time[next] <= g->sample[i].time) {
            next++;
        }
        g->sample[i].reading_end = g->has_time ? next : (uint32_t)(i + 1);
    }
    if (g->samples == 0 || g->sample[g->samples - 1].reading_end < g->readings / 2) {
        message("%s: its times are not those of %s: both need the same clock", file->table.name,
                log);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

static int read_all(gyro_log *g, samples *file, double **time)
{
    sample s;
    int more = 0;
    int failure = EXIT_GOOD;

    while (!failure && (more = samples_next(file, &s)) == 1) {
        double *larger = grow(*time, g->readings, sizeof *larger, file->table.name);
        failure = larger ? EXIT_GOOD : EXIT_FILE;
        *time = larger ? larger : *time;
        if (larger) {
            larger[g->readings] = s.time;
            failure = add_reading(g, file, &s);
        }
    }
    return more < 0 ? EXIT_FILE : failure;
}

int gyro_log_read(gyro_log *g, samples *file, double rate, const char *log)
{
    double *time = NULL;
    int failure = samples_open(file, g->file, COLUMNS_GYRO, rate, 0);

    if (!failure) {
        g->seen = file->where.seen;
        g->rate_unit = file->where.seen.rate_unit;
        failure = read_all(g, file, &time);
    }
    failure = failure ? failure : match_samples(g, file, time, log);
    if (!failure && file->is_rate_known) {
        g->rate = file->rate;
        g->is_rate_known = 1;
    }
    samples_close(file);
    free(time);
    return failure;
}

void gyro_log_free(gyro_log *g)
{
    free(g->sample);
    free(g->reading);
    *g = (gyro_log){0};
}
