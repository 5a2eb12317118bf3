/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "watch/wave.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "magnetometer/cells.h"
#include "invcal/plan.h"
#include "invcal/result.h"
#include "cli/command.h"
#include "watch/interrupt.h"
#include "watch/lines.h"
#include "watch/screen.h"

#define TICK_SECONDS 0.1 /* of the log, from one WATCH_TICK to the next, at least */
#define SAMPLES_MIN 100  /* before directions are shown */

static watch_state now; /* large */

typedef struct {
    const live_options *options;
    watch_view update;
    double reported_at; /* seconds of the log at the last WATCH_TICK */
    int has_begun;
    int is_goal_reached;
} state;

/* The direction of a reading. Returns 0 if it has none. */
static int find_direction(const invcal_calibration *c, const double raw[3], double out[3])
{
    invcal_apply(c, raw[0], raw[1], raw[2], out);
    const double length = hypot(hypot(out[0], out[1]), out[2]);
    for (unsigned i = 0; i < 3; i++) {
        out[i] /= length;
    }
    return length > 0 && length < HUGE_VAL;
}

/* The cells with samples, and where they point. */
static void find_covered(const invcal_magnetometer *m)
{
    now.covered = 0;
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        double raw[3];
        if (invcali_magnetometer_cell(m, &m->own_work, k, raw) > 0) {
            now.covered += (unsigned)find_direction(&m->own_work, raw, now.direction[now.covered]);
        }
    }
    now.taken = now.covered;
}

/* North of the magnetic equator the field points down, so the opposite of the target is up. */
static void find_target(const invcal_magnetometer *m)
{
    char words[INVCAL_TEXT_SIZE];

    invcal_magnetometer_next(m, now.target);
    const double up[3] = {-now.target[0], -now.target[1], -now.target[2]};
    now.has_target = 1;
    snprintf(now.next, sizeof now.next, "hold it %s, and swing it around",
             invcal_direction_text(up, words));
}

/* A target of 0 means no limit. */
static int reaches_target(const live_options *options, double field)
{
    const double *sigma = now.quality.sigma;
    int reaches =
        !(options->need > 0) || now.accuracy <= options->need / (options->field > 0 ? 1 : field);

    for (unsigned k = 0; k < INVCAL_PARAMETERS; k++) {
        const double target = options->target[k / 3];
        reaches = reaches && (!(target > 0) || sigma[k] <= target);
    }
    return reaches;
}

/* Solves the samples so far. */
static void solve(const state *s, const invcal_magnetometer *m)
{
    invcal_calibration calibration;
    invcal_magnetometer_found found = {.field = 0};

    now.status = invcal_magnetometer_solve(m, &calibration, &now.quality, &found);
    now.accuracy =
        now.status == INVCAL_OK ? invcal_accuracy(&now.quality, s->options->field_sigma) : 0;
    now.disturbed = now.status == INVCAL_OK ? invcal_disturbance_text(found.disturbance) : "";
    now.is_guess = now.status != INVCAL_OK;
    now.need = s->options->field > 0 || !(found.field > 0) ? s->options->need
                                                           : s->options->need / found.field;
    now.is_good = now.status == INVCAL_OK && now.quality.verdict == INVCAL_GOOD &&
                  found.gap_deg == 0 && reaches_target(s->options, found.field);
}

/* ---- the stream --------------------------------------------------------------------------------- */

static void begin(state *s, const magnetometer_moment *at)
{
    s->has_begun = 1;
    interrupt_stream(at->log->table.file);
    now.name = at->log->table.name;
    (void)columns_describe(&at->log->where.seen, now.recognised, sizeof now.recognised);
    solve(s, at->magnetometer);
    find_target(at->magnetometer);
    s->update(&now, WATCH_BEGUN);
}

static void take(state *s, const magnetometer_moment *at)
{
    find_covered(at->magnetometer);
    solve(s, at->magnetometer);
    find_target(at->magnetometer);
    now.last = WATCH_TAKEN;
    now.outcome = WATCH_USED;
    s->update(&now, WATCH_TAKEN);
}

/* A tenth of a second has passed. */
static void tick(state *s, const magnetometer_moment *at)
{
    const char *before = now.disturbed;

    s->reported_at = at->latest->clock;
    now.has_up = at->magnetometer->own.samples >= SAMPLES_MIN &&
                 find_direction(&at->magnetometer->own_work, at->raw, now.up);
    find_covered(at->magnetometer);
    solve(s, at->magnetometer);
    find_target(at->magnetometer);
    if (strcmp(now.disturbed, before) != 0 && *now.disturbed != '\0') {
        now.refusal = now.disturbed;
        s->update(&now, WATCH_REFUSED);
    }
    if (now.is_good && !s->is_goal_reached) {
        s->is_goal_reached = 1;
        now.outcome = WATCH_GOAL_REACHED;
        s->update(&now, WATCH_TAKEN);
    }
    s->update(&now, WATCH_TICK);
}

static void on_sample(const magnetometer_moment *at, void *argument)
{
    state *const s = argument;

    if (!s->has_begun) {
        begin(s, at);
    }
    now.seconds = at->latest->clock;
    now.skipped = at->log->skipped;
    if (at->event == INVCAL_TAKEN && at->magnetometer->own.samples >= SAMPLES_MIN) {
        take(s, at);
    }
    if (at->latest->clock - s->reported_at >= TICK_SECONDS) {
        tick(s, at);
    }
}

int wave_read(positions *p, const char *path, const invcal_calibration *nominal,
              const live_options *options, magnetometer_log *out)
{
    state s = {.options = options, .reported_at = -HUGE_VAL};
    const magnetometer_log_options how = {path, options->rate, nominal, 1, on_sample, &s};

    s.update = screen_is_possible(options->out) ? screen_update : lines_update;
    if (isatty(fileno(options->out))) {
        fprintf(options->out, "waiting for samples\n");
        fflush(options->out);
    }
    interrupt_catch(path);
    now = (watch_state){.out = options->out,
                        .units = options->units,
                        .is_magnetometer = 1,
                        .disturbed = "",
                        .phase = WATCH_MOVING,
                        .status = INVCAL_TOO_FEW,
                        .need = options->need};
    memcpy(now.target_sigma, options->target, sizeof now.target_sigma);
    const int failure = magnetometer_log_read(p, &how, out);
    interrupt_stream(NULL);
    if (s.has_begun) {
        now.phase = WATCH_ENDED;
        s.update(&now, failure ? WATCH_BROKEN : WATCH_ENDED);
    }
    return failure;
}
