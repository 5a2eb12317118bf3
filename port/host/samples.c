/* SPDX-License-Identifier: MIT */
#include "samples.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "message.h"

#define RATE_GUESS 100.0
#define LARGEST 268435456.0 /* 2^28: room for eight times the first readings */

enum { TIME = 3, TEMPERATURE = 4 };

/* The numbers of the current row. */
static int read_numbers(samples *s, double v[5])
{
    static const column which[5] = {COLUMN_X, COLUMN_Y, COLUMN_Z, COLUMN_TIME, COLUMN_TEMPERATURE};

    v[TIME] = v[TEMPERATURE] = 0;
    for (unsigned i = 0; i < 5; i++) {
        if (s->where.index[which[i]] >= 0 &&
            columns_number(&s->table, &s->where, which[i], &v[i])) {
            return EXIT_FILE;
        }
    }
    return EXIT_GOOD;
}

static int read_ahead(samples *s)
{
    int more = 1;

    while (s->ahead_count < SAMPLES_AHEAD && (more = table_next(&s->table)) == 1) {
        if (read_numbers(s, s->ahead[s->ahead_count])) {
            return EXIT_FILE;
        }
        s->ahead_line[s->ahead_count++] = s->table.line;
    }
    if (more < 0) {
        return EXIT_FILE;
    }
    if (s->ahead_count == 0) {
        message("%s: holds a header, but no sample", s->table.name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

/* 1 if all numbers read so far are whole multiples of unit. */
static int is_whole(const samples *s, double unit)
{
    for (unsigned n = 0; n < s->ahead_count; n++) {
        for (unsigned i = 0; i < 3; i++) {
            const double counts = s->ahead[n][i] / unit;
            if (!(fabs(counts - nearbyint(counts)) <= 1e-9 * fabs(counts) + 1e-6)) {
                return 0;
            }
        }
    }
    return 1;
}

static double largest(const samples *s)
{
    double most = 0;

    for (unsigned n = 0; n < s->ahead_count; n++) {
        for (unsigned i = 0; i < 3; i++) {
            most = fmax(most, fabs(s->ahead[n][i]));
        }
    }
    return most;
}

static double find_unit(const samples *s)
{
    const double most = largest(s);
    double unit = 1;

    for (unsigned decimals = 0; decimals <= 12 && most / unit <= LARGEST; decimals++) {
        if (is_whole(s, unit)) {
            return unit;
        }
        unit = 1 / pow(10, decimals + 1);
    }
    return most > 0 ? exp2(ceil(log2(most)) - 25) : 1;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;

    return (x > y) - (x < y);
}

/* To three digits: clocks are no better, and 99.98 is 100. */
static double round_rate(double rate)
{
    char text[32];

    snprintf(text, sizeof text, "%.3g", rate);
    return strtod(text, NULL);
}

/* The middle of the steps of time, which a few gaps do not move. */
static int find_rate(samples *s)
{
    double step[SAMPLES_AHEAD];
    unsigned n = 0;

    if (!s->has_time || s->ahead_count < 3) {
        s->rate = RATE_GUESS;
        return EXIT_GOOD;
    }
    for (unsigned i = 1; i < s->ahead_count; i++) {
        step[n++] = s->ahead[i][TIME] - s->ahead[i - 1][TIME];
    }
    qsort(step, n, sizeof step[0], compare);
    s->rate = round_rate(1 / step[n / 2]);
    if (!(s->rate >= 1 && s->rate <= 1e5)) {
        message("%s:%lu: times go on by %.6g, which are no seconds: state --rate, or leave the "
                "column out",
                s->table.name, s->ahead_line[0], step[n / 2]);
        return EXIT_FILE;
    }
    s->is_rate_known = s->times_are_seconds = 1;
    return EXIT_GOOD;
}

int samples_open(samples *s, const char *path, double rate)
{
    s->ahead_count = s->next = 0;
    s->count = 0;
    int failure = table_open(&s->table, path);

    failure = failure ? failure : columns_find(&s->table, COLUMNS_LOG, &s->where);
    failure = failure ? failure : read_ahead(s);
    if (failure) {
        return failure;
    }
    s->has_time = s->where.index[COLUMN_TIME] >= 0;
    s->has_temperature = s->where.index[COLUMN_TEMPERATURE] >= 0;
    s->unit = find_unit(s);
    s->rate = rate;
    s->is_rate_known = rate > 0;
    s->times_are_seconds = 0; /* with a given rate they may be of any unit */
    return rate > 0 ? EXIT_GOOD : find_rate(s);
}

static int32_t to_counts(double value, double unit)
{
    return (int32_t)fmax(INT32_MIN, fmin(INT32_MAX, nearbyint(value / unit)));
}

int samples_next(samples *s, sample *out)
{
    double v[5];
    const int is_ahead = s->next < s->ahead_count;

    if (is_ahead) {
        memcpy(v, s->ahead[s->next], sizeof v);
        out->line = s->ahead_line[s->next++];
    } else {
        const int more = table_next(&s->table);
        if (more != 1) {
            return more;
        }
        if (read_numbers(s, v)) {
            return -1;
        }
        out->line = s->table.line;
    }
    for (unsigned i = 0; i < 3; i++) {
        out->raw[i] = to_counts(v[i], s->unit);
    }
    out->time = v[TIME];
    out->temperature = v[TEMPERATURE];
    const double step = v[TIME] - s->last_time;
    out->is_gap = s->has_time && s->count > 0 &&
                  !(step > 0 && (!s->times_are_seconds || step <= 4 / s->rate + 0.1));
    s->last_time = v[TIME];
    s->count++;
    return 1;
}

void samples_close(samples *s)
{
    table_close(&s->table);
}
