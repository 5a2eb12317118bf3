/* SPDX-License-Identifier: MIT */
#include "read/positions.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "text/number.h"
#include "read/table.h"
#include "read/temperature.h"

#define REPEAT_DISTANCE 0.02 /* relative to the whole range: 4 degrees */
#define LOG_ROWS_MIN 60u     /* few tables have that many positions */

/* Doubles the capacity. */
static int grow(positions *p)
{
    const unsigned capacity = p->capacity ? p->capacity * 2 : 64;
    double *mean = realloc(p->mean, (size_t)capacity * 3 * sizeof *mean);

    p->mean = mean ? mean : p->mean;
    position_origin *origin = realloc(p->origin, capacity * sizeof *origin);
    p->origin = origin ? origin : p->origin;
    if (!mean || !origin) {
        message("%s: not enough memory for %u positions", p->name, capacity);
        return EXIT_FILE;
    }
    p->capacity = capacity;
    return EXIT_GOOD;
}

int positions_add(positions *p, const double mean[3], const position_origin *origin)
{
    if (p->count == POSITIONS_MAX) {
        message(
            "%s:%lu: more than %u positions: invcal calibrate reads samples without --positions",
            p->name, origin->line, POSITIONS_MAX);
        return EXIT_FILE;
    }
    if (p->count == p->capacity && grow(p)) {
        return EXIT_FILE;
    }
    memcpy(&p->mean[3 * (size_t)p->count], mean, 3 * sizeof *mean);
    p->origin[p->count++] = *origin;
    return EXIT_GOOD;
}

/* Adds std and n of the current row. */
static int add_noise(positions *p, const table *t, const columns *where)
{
    double samples;
    double std;
    int failure = columns_number(t, where, COLUMN_SAMPLES, &samples);

    if (!failure && !(samples >= 1)) {
        message("%s:%lu: column %d (n): the number of samples must be 1 or more", t->name, t->line,
                where->index[COLUMN_SAMPLES] + 1);
        failure = EXIT_FILE;
    }
    for (int i = 0; i < 3 && !failure; i++) {
        const column which = (column)(COLUMN_STD_X + i);
        failure = columns_number(t, where, which, &std);
        if (!failure && !(std >= 0 && std * std <= DBL_MAX / POSITIONS_MAX)) {
            message("%s:%lu: column %d (%s): the standard deviation is negative or too large",
                    t->name, t->line, where->index[which] + 1, column_name(which));
            failure = EXIT_FILE;
        }
        if (!failure) {
            p->noise_square[i] += std * std / samples;
        }
    }
    return failure;
}

static int add_row(positions *p, const table *t, columns *where)
{
    double mean[3];
    position_origin origin = {.line = t->line,
                              .begin = NUMBER_UNKNOWN,
                              .end = NUMBER_UNKNOWN,
                              .temperature = NUMBER_UNKNOWN,
                              .drift = NUMBER_UNKNOWN,
                              .alpha = columns_angle(t, where, COLUMN_ALPHA),
                              .beta = columns_angle(t, where, COLUMN_BETA)};
    int failure = EXIT_GOOD;

    for (int i = 0; i < 3 && !failure; i++) {
        failure = columns_number(t, where, (column)(COLUMN_X + i), &mean[i]);
    }
    failure = failure ? failure : temperature_read(t, where, &origin.temperature);
    failure = failure ? failure : positions_add(p, mean, &origin);
    return failure || !p->has_noise ? failure : add_noise(p, t, where);
}

static int read_rows(positions *p, table *t)
{
    columns where;
    int more = 0;
    int failure = columns_skip_text(t);

    failure = failure ? failure : columns_find(t, COLUMNS_POSITIONS, &where);
    p->has_noise = !failure && where.index[COLUMN_STD_X] >= 0 && where.index[COLUMN_SAMPLES] >= 0;
    p->has_angles = !failure && where.index[COLUMN_ALPHA] >= 0 && where.index[COLUMN_BETA] >= 0;
    p->seen = failure ? p->seen : where.seen;
    while (!failure && (more = table_next(t)) == 1) {
        failure = add_row(p, t, &where);
    }
    p->has_temperature = !failure && where.index[COLUMN_TEMPERATURE] >= 0;
    if (!failure && more == 0 && p->count == 0) {
        message("%s: has a header, but no positions: was anything recorded?", t->name);
        failure = EXIT_FILE;
    }
    return more < 0 ? EXIT_FILE : failure;
}

static double distance(const double *a, const double *b)
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* Consecutive positions are far apart; most consecutive samples of a log are not. */
static int look_like_samples(const positions *p)
{
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    unsigned repeats = 0;

    for (size_t n = 0; n < p->count; n++) {
        for (unsigned i = 0; i < 3; i++) {
            low[i] = fmin(low[i], p->mean[3 * n + i]);
            high[i] = fmax(high[i], p->mean[3 * n + i]);
        }
    }
    for (size_t n = 1; n < p->count; n++) {
        repeats +=
            distance(&p->mean[3 * n - 3], &p->mean[3 * n]) < REPEAT_DISTANCE * distance(low, high);
    }
    return !p->has_noise && p->count >= LOG_ROWS_MIN && repeats > p->count / 2;
}

int positions_read(positions *p, const char *path)
{
    table t;
    int failure = table_open(&t, path);

    *p = (positions){.name = t.name};
    if (!failure) {
        failure = read_rows(p, &t);
    }
    p->bytes = t.bytes;
    p->crc = t.crc;
    table_close(&t);
    for (int i = 0; i < 3 && !failure; i++) {
        p->noise_square[i] /= p->count;
    }
    if (!failure && look_like_samples(p)) {
        message(
            "warning: %s: this looks like a raw log, not like position means: most of its %u "
            "rows repeat the one before; invcal calibrate reads a raw log without --positions%s",
            p->name, p->count,
            p->seen.sensor == COLUMNS_OF_MAGNETOMETER
                ? "; for a magnetometer in motion: --magnetometer"
                : "");
    }
    return failure;
}

double positions_noise(const positions *p, const invcal_calibration *nominal)
{
    double square = 0;

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            square += nominal->matrix[i][j] * nominal->matrix[i][j] * p->noise_square[j] / 3;
        }
    }
    return sqrt(square);
}

void positions_free(positions *p)
{
    free(p->mean);
    free(p->origin);
    p->mean = NULL;
    p->origin = NULL;
}
