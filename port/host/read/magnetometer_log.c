/* SPDX-License-Identifier: MIT */
#include "read/magnetometer_log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "magnetometer/cells.h"
#include "cli/command.h"
#include "cli/message.h"
#include "cli/progress.h"
#include "text/number.h"

/* Returns 0 if memory is short. */
static int add_instant(magnetometer_log *out, const sample *s, const double field[3])
{
    if (out->instants == out->capacity) {
        const unsigned long capacity = 2 * out->capacity + 1024;
        magnetometer_instant *larger = realloc(out->instant, capacity * sizeof *larger);
        if (!larger) {
            return 0;
        }
        out->instant = larger;
        out->capacity = capacity;
    }
    magnetometer_instant *at = &out->instant[out->instants++];
    memcpy(at->up, s->accelerometer, sizeof at->up);
    memcpy(at->field, field, sizeof at->field);
    return 1;
}

static int feed_all(invcal_magnetometer *m, samples *log, const magnetometer_log_options *options,
                    magnetometer_log *out)
{
    sample s;
    int more;

    while ((more = samples_next(log, &s)) == 1) {
        const double raw[3] = {s.raw[0] * log->unit, s.raw[1] * log->unit, s.raw[2] * log->unit};
        const invcal_event event = invcal_magnetometer_feed(m, raw[0], raw[1], raw[2]);
        out->samples++;
        if (options->listen) {
            const magnetometer_moment at = {m, log, &s, raw, event};
            options->listen(&at, options->context);
        }
        if (event != INVCAL_REFUSED && !add_instant(out, &s, raw)) {
            message("%s: not enough memory for %lu samples", log->table.name, out->samples);
            more = -1;
            break;
        }
        if (!options->is_live) {
            progress_show(log->table.file, log->table.line, 0);
        }
    }
    progress_end();
    out->seconds = (double)out->samples / log->rate;
    return more < 0 ? EXIT_FILE : EXIT_GOOD;
}

static int take_cells(const invcal_magnetometer *m, const magnetometer_log *out, unsigned long line,
                      positions *p)
{
    const position_origin origin = {line,           NUMBER_UNKNOWN, NUMBER_UNKNOWN, NUMBER_UNKNOWN,
                                    NUMBER_UNKNOWN, NUMBER_UNKNOWN, NUMBER_UNKNOWN};
    int failure = EXIT_GOOD;

    for (unsigned k = 0; k < INVCAL_CELLS && !failure; k++) {
        double raw[3];
        if (invcali_magnetometer_cell(m, &out->calibration, k, raw) > 0) {
            failure = positions_add(p, raw, &origin);
        }
    }
    return failure;
}

static double find_sample_rms(const magnetometer_log *log)
{
    double squares = 0;

    for (unsigned long n = 0; n < log->instants; n++) {
        double v[3];
        invcal_apply(&log->calibration, log->instant[n].field[0], log->instant[n].field[1],
                     log->instant[n].field[2], v);
        const double off = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1;
        squares += off * off;
    }
    return sqrt(squares / (double)log->instants);
}

static int read_log(samples *log, positions *p, const magnetometer_log_options *options,
                    magnetometer_log *out)
{
    invcal_magnetometer m;
    int failure =
        samples_open(log, options->path, COLUMNS_MAGNETOMETER, options->rate, options->is_live);

    *p = (positions){.name = log->table.name};
    *out = (magnetometer_log){
        .rate = log->rate, .is_rate_known = log->is_rate_known, .status = INVCAL_BAD_NOMINAL};
    if (!failure && invcal_magnetometer_init(&m, options->nominal) == INVCAL_OK) {
        failure = feed_all(&m, log, options, out);
        out->status = invcal_magnetometer_solve(&m, &out->calibration, &out->quality, &out->found);
        invcal_magnetometer_next(&m, out->next);
    }
    samples_close(log);
    p->seen = log->where.seen;
    p->bytes = log->table.bytes;
    p->crc = log->table.crc;
    if (failure || out->status != INVCAL_OK) {
        return failure;
    }
    out->sample_rms = find_sample_rms(out);
    return take_cells(&m, out, log->table.first_line, p);
}

int magnetometer_log_read(positions *p, const magnetometer_log_options *options,
                          magnetometer_log *out)
{
    samples *log = calloc(1, sizeof *log); /* too large for the stack */

    *p = (positions){.name = options->path};
    if (!log) {
        message("%s: not enough memory", options->path);
        return EXIT_FILE;
    }
    const int failure = read_log(log, p, options, out);
    free(log);
    return failure;
}

void magnetometer_log_free(magnetometer_log *log)
{
    free(log->instant);
    log->instant = NULL;
}
