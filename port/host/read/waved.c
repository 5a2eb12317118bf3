/* SPDX-License-Identifier: MIT */
#include "read/waved.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "cli/progress.h"
#include "text/number.h"

/* Returns 0 without memory. */
static int add_instant(waved *out, const sample *s, const double field[3])
{
    if (out->instants == out->room) {
        const unsigned long room = 2 * out->room + 1024;
        waved_instant *larger = realloc(out->instant, room * sizeof *larger);
        if (!larger) {
            return 0;
        }
        out->instant = larger;
        out->room = room;
    }
    waved_instant *at = &out->instant[out->instants++];
    memcpy(at->up, s->aside, sizeof at->up);
    memcpy(at->field, field, sizeof at->field);
    return 1;
}

static int feed_all(invcal_magnetometer *m, samples *log, const waved_wish *wish, waved *out)
{
    sample s;
    int more;

    while ((more = samples_next(log, &s)) == 1) {
        const double raw[3] = {s.raw[0] * log->unit, s.raw[1] * log->unit, s.raw[2] * log->unit};
        const invcal_event event = invcal_magnetometer_feed(m, raw);
        out->samples++;
        if (wish->listen) {
            const waved_moment at = {m, log, &s, raw, event};
            wish->listen(&at, wish->who);
        }
        if (event != INVCAL_REFUSED && !add_instant(out, &s, raw)) {
            message("%s: not enough memory for %lu samples", log->table.name, out->samples);
            more = -1;
            break;
        }
        if (!wish->is_live) {
            progress_show(log->table.file, log->table.line, 0);
        }
    }
    progress_end();
    out->seconds = (double)out->samples / log->rate;
    return more < 0 ? EXIT_FILE : EXIT_GOOD;
}

static int take_cells(const invcal_magnetometer *m, const waved *out, unsigned long line,
                      positions *p)
{
    const position_origin origin = {line,           NUMBER_UNKNOWN, NUMBER_UNKNOWN, NUMBER_UNKNOWN,
                                    NUMBER_UNKNOWN, NUMBER_UNKNOWN, NUMBER_UNKNOWN};
    int failure = EXIT_GOOD;

    for (unsigned k = 0; k < INVCAL_CELLS && !failure; k++) {
        double raw[3];
        if (invcal_magnetometer_cell(m, &out->calibration, k, raw) > 0) {
            failure = positions_add(p, raw, &origin);
        }
    }
    return failure;
}

static double find_sample_rms(const waved *log)
{
    double squares = 0;

    for (unsigned long n = 0; n < log->instants; n++) {
        double v[3];
        invcal_apply(&log->calibration, log->instant[n].field, v);
        const double off = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1;
        squares += off * off;
    }
    return sqrt(squares / (double)log->instants);
}

static int read_log(samples *log, positions *p, const waved_wish *wish, waved *out)
{
    invcal_magnetometer m;
    int failure = samples_open(log, wish->path, COLUMNS_MAGNETOMETER, wish->rate, wish->is_live);

    *p = (positions){.name = log->table.name};
    *out = (waved){
        .rate = log->rate, .is_rate_known = log->is_rate_known, .status = INVCAL_BAD_NOMINAL};
    if (!failure && invcal_magnetometer_init(&m, wish->nominal) == INVCAL_OK) {
        failure = feed_all(&m, log, wish, out);
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

int waved_read(positions *p, const waved_wish *wish, waved *out)
{
    samples *log = calloc(1, sizeof *log); /* too large for the stack */

    *p = (positions){.name = wish->path};
    if (!log) {
        message("%s: not enough memory", wish->path);
        return EXIT_FILE;
    }
    const int failure = read_log(log, p, wish, out);
    free(log);
    return failure;
}

void waved_free(waved *log)
{
    free(log->instant);
    log->instant = NULL;
}
