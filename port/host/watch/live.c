/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "watch/live.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "invcal/plan.h"
#include "invcal/result.h"
#include "cli/command.h"
#include "cli/message.h"
#include "read/samples.h"
#include "watch/interrupt.h"
#include "watch/lines.h"
#include "watch/live_program.h"
#include "watch/screen.h"
#include "watch/zero.h"
#include "session/rests.h"

#define HOLD_MAX 60      /* seconds: limit of the time from the noise of the first rest */
#define HOLD_LIMIT 3600  /* seconds: limit of the time from an Allan deviation */
#define DOF_MIN 3u       /* degrees of freedom before a goal can be reached */
#define TICK_SECONDS 0.1 /* of the log, from one WATCH_TICK to the next, at least */

/* All are too large for the stack. */
static samples live_log;
static recording live_recording;
static invcal_session session;
static live_program followed; /* if the options have a set */
static watch_state now;       /* for the view */

typedef struct {
    positions *p;
    const live_options *options;
    rests_summary *summary;
    watch_view update;
    gyro_log *gyro; /* readings of the gyroscope; null: there is none, or it is ignored */
    zero_finder zero;
    invcal_calibration known; /* the calibration so far, or the nominal one */
    double reported_at;       /* seconds of the log at the last WATCH_TICK */
    double sum[3];            /* of the readings since then, counts; */
    double summed;            /* and their number */
    int is_goal_reached;
} state;

/* ---- directions -------------------------------------------------------------------------------- */

/* The up direction, a unit vector. Returns 1; 0 if the calibrated length is 0 or not finite. */
static int find_up(const invcal_calibration *known, const double counts[3], double up[3])
{
    double length = 0;

    invcal_apply(known, counts[0], counts[1], counts[2], up);
    for (unsigned i = 0; i < 3; i++) {
        length = hypot(length, up[i]);
    }
    for (unsigned i = 0; i < 3; i++) {
        up[i] /= length;
    }
    return length > 0 && length < HUGE_VAL;
}

static void tick(state *s, const sample *latest)
{
    double counts[3];

    for (unsigned i = 0; i < 3; i++) {
        s->sum[i] += latest->raw[i];
    }
    s->summed++;
    now.seconds = latest->clock;
    if (latest->clock - s->reported_at < TICK_SECONDS) {
        return;
    }
    for (unsigned i = 0; i < 3; i++) {
        counts[i] = s->sum[i] / s->summed;
        s->sum[i] = 0;
    }
    s->summed = 0;
    s->reported_at = latest->clock;
    now.has_up = find_up(&s->known, counts, now.up);
    now.skipped = live_log.skipped;
    s->update(&now, WATCH_TICK);
}

/* Where to turn next. A rest that is READY and still held counts as taken. */
static void find_target(const state *s, int is_ready)
{
    if (!s->options->set) {
        const double *held = is_ready && s->gyro && now.has_up ? now.up : NULL;
        if (!watch_gyro_next(&now.gyro, held, now.target, now.next)) {
            invcal_session_next(&session, now.target);
            (void)invcal_direction_text(now.target, now.next);
        }
        now.has_target = 1;
        snprintf(now.good, sizeof now.good, "good: move on to %s", now.next);
        return;
    }
    const program *p = is_ready ? live_program_predicted(&followed) : &followed.program;
    now.has_target = p->next < p->set->count;
    if (now.has_target) {
        memcpy(now.target, p->set->position[p->next].vertical, sizeof now.target);
    }
    (void)program_next_text(p, now.next);
    (void)live_program_good_text(&followed, p, now.good, sizeof now.good);
}

/* The device moves or rests. A refusal, already reported, ends when it moves. */
static void update_phase(state *s, watch_event event)
{
    now.progress = invcal_session_progress(&session);
    now.phase = event == WATCH_SETTLING && now.progress >= 100 ? WATCH_READY : event;
    if (event == WATCH_MOVING) {
        now.is_refused = 0;
    }
    if (now.phase == WATCH_READY) {
        find_target(s, 1);
    }
    s->update(&now, event);
}

/* ---- how long to hold -------------------------------------------------------------------------- */

static void set_hold(double seconds)
{
    (void)invcal_session_set_hold(&session, seconds); /* at most an hour */
}

/* The noise of the first rest, assumed white, gives the time: T = s^2 / (sigma^2 rate), s^2 the
 * variance of a sample, averaged over the axes. Returns 1 if the rest has been held that long. */
static int is_held_long_enough(const state *s)
{
    const invcal_calibration *c = &session.nominal;
    const double sigma = s->options->mean_sigma / s->options->field;
    invcali_rest rest;
    double square = 0;

    if (!(sigma > 0) || s->options->noise || now.taken > 0 ||
        !invcali_rests_get(&session.rests, &rest)) {
        return 1;
    }
    for (unsigned i = 0; i < 9; i++) {
        square += c->matrix[i / 3][i % 3] * c->matrix[i / 3][i % 3] / 3;
    }
    set_hold(fmin(HOLD_MAX, square * rest.variance / (sigma * sigma) / live_log.rate));
    return invcal_session_progress(&session) == 100;
}

/* Holds each position as long as the slowest axis requires. */
static int hold_by_noise(const live_options *options)
{
    for (unsigned i = 0; i < 3; i++) {
        invcal_dwell d;
        if (invcal_noise_dwell(&options->noise[i], options->mean_sigma / options->field, &d) !=
                INVCAL_OK ||
            d.seconds > HOLD_LIMIT) {
            message("--allan: with this noise, a mean with a sigma of %g takes more than %d s: "
                    "increase --mean-sigma",
                    options->mean_sigma, HOLD_LIMIT);
            return EXIT_USAGE;
        }
        now.hold = fmax(now.hold, d.seconds);
        if (d.end == INVCAL_DWELL_FLOOR) {
            now.hold_floor = fmax(now.hold_floor, d.sigma * options->field);
        }
    }
    set_hold(now.hold);
    return EXIT_GOOD;
}

/* ---- the end of a rest ------------------------------------------------------------------------- */

static int take_rest(state *s)
{
    invcali_rest rest;

    return invcali_rests_get(&session.rests, &rest)
               ? rests_take(s->p, &rest, live_log.unit, &live_recording)
               : EXIT_GOOD;
}

/* Only redundant positions show how steadily the device was held; the noise of the samples does
 * not. */
static int is_checked(void)
{
    return now.status == INVCAL_OK && now.quality.dof >= DOF_MIN;
}

/* The positions so far determine a calibration, which the next one may confirm. */
static int is_determined(void)
{
    return watch_knows_sigma(&now) && now.quality.verdict != INVCAL_WEAK &&
           now.quality.dof + 1u >= DOF_MIN;
}

/* A target of 0 means no limit. */
static int reaches_target(const live_options *options)
{
    double target[3];
    int is_wanted = 0;

    if (!is_checked()) {
        return 0;
    }
    for (unsigned i = 0; i < 3; i++) {
        is_wanted = is_wanted || options->target[i] > 0;
        target[i] = options->target[i] > 0 ? options->target[i] : INVCAL_REAL_MAX;
    }
    if (options->need > 0 && !(invcal_session_is_good(&session) && now.accuracy <= options->need)) {
        return 0;
    }
    return !is_wanted || invcal_reaches(&now.quality, target[0], target[1], target[2]);
}

/* Solves the positions so far. */
static void solve(state *s)
{
    invcal_calibration calibration;

    now.status = invcal_session_solve(&session, &calibration, &now.quality);
    s->known = watch_knows_sigma(&now) && now.quality.verdict != INVCAL_WEAK ? calibration
                                                                             : session.nominal;
    now.accuracy =
        now.status == INVCAL_OK ? invcal_accuracy(&now.quality, s->options->field_sigma) : 0;
    now.covered = 0;
    for (unsigned n = 0; n < session.count; n++) {
        now.covered += (unsigned)find_up(&s->known, session.mean[n].v, now.direction[now.covered]);
    }
    now.is_guess = zero_is_guess(&s->zero);
}

/* A calibration of counts, as one of input units. */
static invcal_calibration of_input_units(const invcal_calibration *of_counts)
{
    invcal_calibration c = *of_counts;

    for (unsigned i = 0; i < 9; i++) {
        c.offset[i % 3] = of_counts->offset[i % 3] * live_log.unit;
        c.matrix[i / 3][i % 3] /= live_log.unit;
    }
    return c;
}

/* Residuals of a few positions may be small by chance, so noise is that of the samples, as at the
 * end. The session ignores a value of 0 or out of range. */
static void state_noise(const state *s)
{
    const invcal_calibration nominal = of_input_units(&session.nominal);
    positions so_far = *s->p;

    rests_noise(&so_far);
    (void)invcal_session_set_noise(
        &session, s->options->stated > 0 ? s->options->stated : positions_noise(&so_far, &nominal));
}

/* With a gyroscope, waits until it is determined, too. */
static int is_good(state *s)
{
    const invcal_calibration start = of_input_units(&s->known);

    if (s->gyro && s->p->count > 0) {
        double up[3];
        const double *last = &s->p->mean[3 * (size_t)(s->p->count - 1)];
        (void)find_up(&start, last, up);
        watch_gyro_take(&now.gyro, s->gyro, &s->options->gyro, samples_whole_rate(&live_log),
                        s->options->clip, s->p, &start, up);
    }
    return now.gyro.is_good ||
           (is_checked() && invcal_session_is_good(&session) && *now.gyro.text == '\0');
}

static watch_outcome find_outcome(state *s, int is_complete)
{
    const int is_wanted = watch_has_goal(&now);
    const int is_good_now = is_good(s);

    now.is_good = is_wanted ? reaches_target(s->options) : is_good_now;
    if (is_complete) {
        return WATCH_FINISHED;
    }
    if (!s->is_goal_reached && is_wanted && now.is_good) {
        s->is_goal_reached = 1;
        return WATCH_GOAL_REACHED;
    }
    return WATCH_USED;
}

static int take(state *s)
{
    const int failure = take_rest(s);

    now.taken++;
    now.last = WATCH_TAKEN;
    zero_update(&s->zero, is_determined(), &session);
    state_noise(s);
    solve(s);
    now.outcome = find_outcome(s, s->options->set && live_program_take(&followed));
    if (s->options->set) {
        now.wrong_count = followed.wrong_count;
        (void)live_program_wrong_text(&followed, now.wrong);
    }
    find_target(s, 0);
    now.phase = WATCH_MOVING;
    s->update(&now, WATCH_TAKEN);
    return failure;
}

/* A rest may be refused while it is held, and again when it is left; only the first is reported. */
static void report_refused(state *s, int is_left)
{
    if (now.is_refused) {
        now.is_refused = 0;
        return;
    }
    now.is_refused = !is_left;
    now.refusal = rests_reason_text(invcal_session_reason(&session));
    now.last = WATCH_REFUSED;
    if (is_left) {
        now.phase = WATCH_MOVING;
    }
    find_target(s, 0);
    s->update(&now, WATCH_REFUSED);
}

static int refuse(state *s)
{
    const invcal_status reason = invcal_session_reason(&session);
    const int is_rest = reason < INVCAL_REST_SHORT || reason > INVCAL_REST_SAME;
    const int is_left = is_rest && invcal_session_progress(&session) == 0;
    int failure = EXIT_GOOD;

    if (!is_rest) {
        rests_refuse(s->summary, reason, &live_recording);
    } else if (is_left) { /* the final calibration may still use it */
        failure = take_rest(s);
    }
    report_refused(s, is_left);
    return failure;
}

static int handle_event(state *s, invcal_event event)
{
    switch (event) {
    case INVCAL_TAKEN:
        return take(s);
    case INVCAL_REFUSED:
        return refuse(s);
    case INVCAL_READY:
        update_phase(s, is_held_long_enough(s) ? WATCH_READY : WATCH_SETTLING);
        break;
    case INVCAL_SETTLING:
        update_phase(s, WATCH_SETTLING);
        break;
    case INVCAL_MOVING:
        update_phase(s, WATCH_MOVING);
        break;
    default:
        break;
    }
    return EXIT_GOOD;
}

/* ---- the stream -------------------------------------------------------------------------------- */

static int begin_session(state *s)
{
    const live_options *options = s->options;
    const double *clip = options->clip;
    char text[SENSORS_TEXT_MAX];
    char remedy[SENSORS_TEXT_MAX];

    if (!zero_fits_sensor(options, &live_log, text, remedy)) {
        return message_usage("watch", "%s: %s; %s", live_log.table.name, text, remedy);
    }
    if (!zero_begin(&s->zero, options, &live_log, s->p, &followed, &s->known) ||
        invcal_session_init_nominal(&session, sizeof session, &s->known,
                                    samples_whole_rate(&live_log)) != INVCAL_OK ||
        (clip && invcal_session_set_limits(&session, samples_count(&live_log, clip[0]),
                                           samples_count(&live_log, clip[1])) != INVCAL_OK)) {
        message("%s: %.6g samples per second, or the nominal calibration, cannot be used",
                live_log.table.name, live_log.rate);
        return EXIT_FILE;
    }
    return options->noise ? hold_by_noise(options) : EXIT_GOOD;
}

/* Describes the recognised columns: if one is wrong, the user can stop at once. */
static void recognise(const state *s)
{
    recognition seen = s->p->seen;

    if (s->options->unit != UNIT_UNKNOWN) {
        seen.unit = s->options->unit;
        seen.unit_from = UNIT_FROM_OPTION;
    }
    (void)columns_describe(&seen, now.recognised, sizeof now.recognised);
}

static void start(state *s)
{
    recording_begin(&live_recording, &live_log);
    if (s->options->set) {
        live_program_begin(&followed, s->options->set, &session, s->p, live_log.unit,
                           !zero_is_unstated(&s->zero));
    }
    recognise(s);
    solve(s);
    find_target(s, 0);
    s->update(&now, WATCH_BEGUN);
}

static int feed(state *s, const sample *latest)
{
    int failure = EXIT_GOOD;

    if (latest->is_gap) {
        invcal_session_gap(&session);
    }
    s->summary->samples++;
    recording_sample(&live_recording, &live_log, latest);
    if (s->gyro && gyro_log_add(s->gyro, &live_log, latest)) {
        return EXIT_FILE;
    }
    const invcal_event event =
        invcal_session_feed(&session, latest->raw[0], latest->raw[1], latest->raw[2]);
    if (event != INVCAL_NOTHING) {
        recording_filled(&live_recording);
        failure = handle_event(s, event);
    }
    tick(s, latest);
    return failure;
}

static int run(state *s)
{
    sample latest;
    int more = 0;
    int failure = EXIT_GOOD;

    start(s);
    while (!failure && (more = samples_next(&live_log, &latest)) == 1) {
        failure = feed(s, &latest);
    }
    if (!failure && more == 0) {
        failure = handle_event(s, invcal_session_end(&session));
    }
    if (more < 0 || failure) {
        s->update(&now, WATCH_BROKEN);
        return failure ? failure : EXIT_FILE;
    }
    if (s->options->set) {
        (void)live_program_missing_text(&followed, now.missing);
    }
    now.phase = WATCH_ENDED;
    s->update(&now, WATCH_ENDED);
    return EXIT_GOOD;
}

int live_read(positions *p, const char *path, const live_options *options, gyro_log *gyro,
              rests_summary *summary)
{
    state s = {.p = p, .options = options, .summary = summary, .reported_at = -HUGE_VAL};

    s.update = screen_is_possible(options->out) ? screen_update : lines_update;
    if (isatty(fileno(options->out))) {
        fprintf(options->out, "waiting for samples\n");
        fflush(options->out);
    }
    interrupt_catch(path);
    int failure = samples_open(&live_log, path, gyro ? COLUMNS_IMU : COLUMNS_LOG, options->rate, 1);
    interrupt_stream(live_log.table.file);

    *p = (positions){.name = live_log.table.name, .has_noise = 1, .seen = live_log.where.seen};
    *summary = (rests_summary){.rate = live_log.rate,
                               .is_rate_known = live_log.is_rate_known,
                               .track = &live_recording,
                               .unit = live_log.unit};
    now = (watch_state){.out = options->out,
                        .units = options->units,
                        .name = live_log.table.name,
                        .phase = WATCH_MOVING,
                        .need = options->need};
    memcpy(now.target_sigma, options->target, sizeof now.target_sigma);
    if (!failure && gyro) {
        gyro_log_begin(gyro, &live_log);
        s.gyro = live_log.has_gyro ? gyro : NULL;
    }
    failure = failure ? failure : begin_session(&s);
    failure = failure ? failure : run(&s);
    interrupt_stream(NULL);
    samples_close(&live_log);
    rests_end(p, &live_log, summary);
    if (s.gyro) {
        gyro_log_end(gyro);
    }
    return failure;
}
