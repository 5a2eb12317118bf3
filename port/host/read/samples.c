/* SPDX-License-Identifier: MIT */
#include "read/samples.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "maths/median.h"
#include "read/temperature.h"

#define RATE_DEFAULT 100.0
#define COUNT_BITS 22               /* of the largest of the first readings, with its fraction */
#define UNIT_EXPONENT_DEFAULT (-14) /* of a power of two, if only zeros have been read */
#define SKIPPED_MAX 100u

enum { TIME = 3, TEMPERATURE = 4, ALPHA = 5, BETA = 6, ACCELEROMETER = 7, GYRO = 10 };

/* The numbers of the current row. */
static int read_numbers(samples *s, double v[SAMPLES_NUMBERS])
{
    static const column which[4] = {COLUMN_X, COLUMN_Y, COLUMN_Z, COLUMN_TIME};

    if (columns_check_instance(&s->table, &s->where)) {
        return EXIT_FILE;
    }
    v[TIME] = v[TEMPERATURE] = v[GYRO] = v[GYRO + 1] = v[GYRO + 2] = 0;
    for (unsigned i = 0; i < 4; i++) {
        if (s->where.index[which[i]] >= 0 &&
            columns_number(&s->table, &s->where, which[i], &v[i])) {
            return EXIT_FILE;
        }
    }
    if (temperature_read(&s->table, &s->where, &v[TEMPERATURE])) {
        return EXIT_FILE;
    }
    v[ALPHA] = columns_angle(&s->table, &s->where, COLUMN_ALPHA);
    v[BETA] = columns_angle(&s->table, &s->where, COLUMN_BETA);
    for (unsigned i = 0; i < 3; i++) {
        v[ACCELEROMETER + i] = columns_accelerometer(&s->table, &s->where, i);
    }
    return s->where.gyro[0] >= 0 ? columns_gyro(&s->table, &s->where, &v[GYRO]) : EXIT_GOOD;
}

/* If the first line was cut, the second has more columns, and determines them. Returns 1 if so. */
static int realign(samples *s)
{
    if (s->count > 0 || s->ahead_count > 1 || s->table.has_header ||
        s->table.found <= s->table.columns) {
        return 0;
    }
    s->table.columns = s->table.found;
    s->ahead_count = 0;
    return columns_find(&s->table, s->kind, &s->where) == EXIT_GOOD;
}

/* The numbers of the next valid row. 1, 0 at the end, -1. */
static int next_row(samples *s, double v[SAMPLES_NUMBERS])
{
    for (unsigned skipped = 0; skipped < SKIPPED_MAX; skipped++) {
        const int more = table_next(&s->table);
        if (more != 0 && !s->is_live && s->count + s->ahead_count > 0 &&
            columns_is_cut(&s->table, &s->where)) {
            columns_warn_cut(&s->table, "last", s->table.line);
            s->skipped++;
            return 0;
        }
        if (more == 0 || (more == 1 && read_numbers(s, v) == EXIT_GOOD)) {
            return more;
        }
        if (!s->is_live) {
            return -1;
        }
        s->skipped++;
        s->is_broken = 1;
        if (more < 0 && realign(s) && read_numbers(s, v) == EXIT_GOOD) {
            return 1;
        }
    }
    message("%s:%lu: %u lines in a row cannot be read: is it the right file, and are x, y, z the "
            "right columns? --columns states them",
            s->table.name, s->table.line, SKIPPED_MAX);
    return -1;
}

static int read_ahead(samples *s)
{
    const unsigned limit = s->is_live ? SAMPLES_AHEAD_LIVE : SAMPLES_AHEAD;
    double v[SAMPLES_NUMBERS];
    int more = 1;

    while (s->ahead_count < limit && (more = next_row(s, v)) == 1) {
        memcpy(s->ahead[s->ahead_count], v, sizeof v);
        s->ahead_line[s->ahead_count++] = s->table.line;
    }
    if (more < 0) {
        return EXIT_FILE;
    }
    if (s->ahead_count == 0) {
        message("%s: has a header, but no samples: was anything recorded?", s->table.name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

static double largest_reading(const samples *s)
{
    double largest = 0;

    for (unsigned n = 0; n < s->ahead_count; n++) {
        for (unsigned i = 0; i < 3; i++) {
            largest = fmax(largest, fabs(s->ahead[n][i]));
        }
    }
    return largest;
}

static double find_unit(const samples *s)
{
    const double largest = largest_reading(s);

    return largest > 0 ? fmin(1, ldexp(1, (int)ceil(log2(largest)) - COUNT_BITS))
                       : ldexp(1, UNIT_EXPONENT_DEFAULT);
}

/* To three digits: clocks are no more accurate, and 99.98 means 100. */
static double round_rate(double rate)
{
    char text[32];

    snprintf(text, sizeof text, "%.3g", rate);
    return strtod(text, NULL);
}

/* The mean time step, or the median if gaps have spoilt the mean. Samples that arrive in batches
 * may have equal times. */
static double usual_step(samples *s)
{
    double step[SAMPLES_AHEAD];
    const unsigned n = s->ahead_count - 1;

    for (unsigned i = 0; i < n; i++) {
        step[i] = s->ahead[i + 1][TIME] - s->ahead[i][TIME];
    }
    const double mean = (s->ahead[n][TIME] - s->ahead[0][TIME]) / n;
    const double median = median_of(step, n);
    s->step_max = 2 * step[n - 1 - n / 50]; /* sorted: the largest 2 % may be gaps */
    return median > 0 && mean > 1.5 * median ? median : mean;
}

#define RATE_SLOW 0.2 /* samples per second; fewer are times in another unit, if none is stated */

/* A rate that is not supported, or a unit of time that is not stated. */
static void report_rate(const samples *s, double step)
{
    const int is_known = s->where.is_time_unit_known;

    if (s->rate < SAMPLES_RATE_MIN && step > 0 && (is_known || s->rate >= RATE_SLOW)) {
        message("%s:%lu: %.3g sample%s per second %s too slow: %d are the minimum, 50 are good%s",
                s->table.name, s->ahead_line[0], s->rate, s->rate > 1 || s->rate < 1 ? "s" : "",
                s->rate > 1 || s->rate < 1 ? "are" : "is", SAMPLES_RATE_MIN,
                is_known ? ""
                         : "; if the times are not in seconds, put the unit into the heading "
                           "(t_ms, t_us), or state --rate");
        return;
    }
    message("%s:%lu: the times advance by %.6g, which cannot be seconds (8 to 8000 samples per "
            "second are supported): %sstate --rate",
            s->table.name, s->ahead_line[0], step,
            step > 0 ? "put the unit into the heading (t_ms, t_us), or " : "");
}

static int find_rate(samples *s)
{
    s->rate = RATE_DEFAULT;
    if (!s->has_time || s->ahead_count < 3) {
        return EXIT_GOOD;
    }
    const double step = usual_step(s);
    s->rate = round_rate(1 / step);
    if (!(s->rate >= SAMPLES_RATE_MIN && s->rate <= SAMPLES_RATE_MAX)) {
        report_rate(s, step);
        return EXIT_FILE;
    }
    s->step_max = fmax(s->step_max, 4 / s->rate + 0.1);
    s->is_rate_known = 1;
    return EXIT_GOOD;
}

/* If the first line of a live stream was cut beyond recognition, the second one determines the
 * columns. */
static int find_columns(samples *s)
{
    unsigned long cut = 0;

    if (columns_skip_text(&s->table) || (!s->is_live && table_drop_cut_first(&s->table, &cut))) {
        return EXIT_FILE;
    }
    if (cut > 0) {
        columns_warn_cut(&s->table, "first", cut);
        s->skipped++;
    }
    const int failure = columns_find(&s->table, s->kind, &s->where);

    if (!failure || !s->is_live || s->table.has_header) {
        return failure;
    }
    (void)table_next(&s->table); /* the first line */
    (void)table_next(&s->table); /* the second, which warns of another number of columns */
    s->table.columns = s->table.found > 0 ? s->table.found : s->table.columns;
    s->skipped = 2;
    return columns_find(&s->table, s->kind, &s->where);
}

int samples_open(samples *s, const char *path, columns_kind kind, double rate, int live)
{
    s->ahead_count = s->next = 0;
    s->count = s->gaps = s->skipped = 0;
    s->is_live = live;
    s->kind = kind;
    s->is_broken = 0;
    s->clock = 0;
    s->step_max = HUGE_VAL; /* with a given rate, times may be in any unit */
    int failure = table_open(&s->table, path);

    s->table.is_log = !live;
    s->table.is_forgiving = live;
    failure = failure ? failure : find_columns(s);
    failure = failure ? failure : read_ahead(s);
    if (failure) {
        return failure;
    }
    s->has_time = s->where.index[COLUMN_TIME] >= 0;
    s->has_temperature = s->where.index[COLUMN_TEMPERATURE] >= 0;
    s->has_gyro = s->where.gyro[0] >= 0;
    s->has_angles = s->where.index[COLUMN_ALPHA] >= 0 && s->where.index[COLUMN_BETA] >= 0;
    s->unit = find_unit(s);
    s->rate = rate;
    s->is_rate_known = rate > 0;
    return rate > 0 ? EXIT_GOOD : find_rate(s);
}

unsigned samples_whole_rate(const samples *s)
{
    return (unsigned)fmin(UINT16_MAX, nearbyint(s->rate));
}

int32_t samples_count(const samples *s, double value)
{
    return (int32_t)fmax(INT32_MIN, fmin(INT32_MAX, nearbyint(value / s->unit)));
}

/* By the times, unless their unit is unknown or they jump; else one sample at the rate. */
static double time_passed(const samples *s, double step)
{
    const int is_seconds = s->has_time && s->step_max < HUGE_VAL;

    return is_seconds && step >= 0 && step <= SAMPLES_PAUSE ? step : 1 / s->rate;
}

int samples_next(samples *s, sample *out)
{
    double v[SAMPLES_NUMBERS];
    const int is_ahead = s->next < s->ahead_count;

    if (is_ahead) {
        memcpy(v, s->ahead[s->next], sizeof v);
        out->line = s->ahead_line[s->next++];
    } else {
        const int more = next_row(s, v);
        if (more != 1) {
            return more;
        }
        out->line = s->table.line;
    }
    for (unsigned i = 0; i < 3; i++) {
        out->raw[i] = samples_count(s, v[i]);
    }
    s->has_temperature = s->where.index[COLUMN_TEMPERATURE] >= 0;
    out->time = v[TIME];
    out->temperature = v[TEMPERATURE];
    out->angle[0] = v[ALPHA];
    out->angle[1] = v[BETA];
    memcpy(out->accelerometer, &v[ACCELEROMETER], sizeof out->accelerometer);
    memcpy(out->gyro, &v[GYRO], sizeof out->gyro);
    const double step = v[TIME] - s->last_time;
    out->clock = s->clock += s->count == 0 ? 0 : time_passed(s, step);
    const int jumps = s->has_time && s->count > 0 && !(step >= 0 && step <= s->step_max);
    out->is_gap = jumps || (!is_ahead && s->is_broken);
    s->is_broken = s->is_broken && is_ahead;
    s->gaps += (unsigned long)out->is_gap;
    s->last_time = v[TIME];
    s->count++;
    return 1;
}

void samples_close(samples *s)
{
    table_close(&s->table);
}
