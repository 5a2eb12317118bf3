/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "live.h"

#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

#include "command.h"
#include "input.h"
#include "invcal/session.h"
#include "message.h"
#include "nominal.h"
#include "paint.h"
#include "samples.h"

#define DEGREES 57.295779513082321
#define RENEW 4u    /* positions whose range says more than the first reading */
#define FAR_OFF 0.7 /* mean of unit vectors that differ less than positions do */

/* All are too large for the stack. */
static samples live_log;
static recording live_recording;
static invcal_session session;

typedef struct {
    positions *p;
    const live_wish *wish;
    rests_summary *summary;
    int is_terminal;
    int is_refused;            /* said of the rest that is going on */
    double lsb;                /* as guessed for zero at 0 */
    invcal_session_what shown; /* of the line that changes */
} stage;

/* ---- what the person sees ---------------------------------------------------------------------- */

/* A line that stays; what was on the changing line goes. */
static void end_line(stage *s)
{
    if (s->is_terminal) {
        fprintf(s->wish->talk, "\r%60s\r", "");
    }
}

/* Where to turn next. Returns 0, with no words, if there is nowhere. */
static int next_words(char words[INVCAL_GUIDANCE_WORDS])
{
    invcal_guidance next;

    words[0] = '\0';
    if (invcal_session_next(&session, &next) != INVCAL_OK) {
        return 0;
    }
    invcal_guidance_words(next.up, words);
    return 1;
}

/* The changing line: only on a terminal, and only if there is news. */
static void show(stage *s, const invcal_event *event)
{
    char words[INVCAL_GUIDANCE_WORDS];

    if (event->what == INVCAL_SESSION_MOVING) {
        s->is_refused = 0;
    }
    if (!s->is_terminal && event->what == INVCAL_SESSION_READY) {
        fprintf(s->wish->talk, "good: move on%s%s\n", next_words(words) ? " to " : "", words);
    }
    if (!s->is_terminal || s->is_refused ||
        (event->what == INVCAL_SESSION_MOVING && s->shown == event->what)) {
        return;
    }
    s->shown = event->what;
    end_line(s);
    if (event->what == INVCAL_SESSION_SETTLING && event->progress < 100) {
        fprintf(s->wish->talk, "  hold still ... %3u %%", event->progress);
    } else if (event->what != INVCAL_SESSION_MOVING) {
        fprintf(s->wish->talk, "  good: move on%s%s", next_words(words) ? " to " : "", words);
    } else {
        fprintf(s->wish->talk, "  moving");
    }
    fflush(s->wish->talk);
}

static void say_next(stage *s)
{
    char words[INVCAL_GUIDANCE_WORDS];

    if (next_words(words)) {
        fprintf(s->wish->talk, "next: %s\n", words);
    }
}

static double largest(const double v[3])
{
    return fmax(v[0], fmax(v[1], v[2]));
}

/* How exactly everything is known, once it can be told. */
static void say_sigma(stage *s)
{
    invcal_solution solution;
    invcal_quality q;

    if (invcal_session_solve(&session, &solution, &q, NULL) != INVCAL_OK || !(q.dof > 0)) {
        return;
    }
    fprintf(s->wish->talk, "; to 95 %%: offsets ± %.2g mg, scales ± %.2g %%, angles ± %.2g deg",
            q.coverage * 1e3 * largest(q.sigma_delta), q.coverage * 1e2 * largest(q.sigma_dk),
            q.coverage * DEGREES * largest(q.sigma_gamma));
}

static void say_end(FILE *talk, const char *word, const char *what)
{
    fprintf(talk, "%s%s%s %s; end the stream (Ctrl-C)\n", paint_on(talk, PAINT_GREEN), word,
            paint_off(talk), what);
}

static void say_taken(stage *s, const invcal_event *event)
{
    end_line(s);
    fprintf(s->wish->talk, "position %u taken", event->positions);
    say_sigma(s);
    if (event->what == INVCAL_SESSION_TAKEN && !event->is_asked) {
        fprintf(s->wish->talk, "; not the one asked for, but used");
    }
    fprintf(s->wish->talk, "\n");
    if (event->what == INVCAL_SESSION_ENOUGH) {
        say_end(s->wish->talk, "enough:", "the target is reached");
    } else if (event->what == INVCAL_SESSION_FINISHED) {
        say_end(s->wish->talk, "finished:", "the program is complete");
    }
}

static void say_refused(stage *s, const invcal_event *event)
{
    if (s->is_refused) {
        s->is_refused = 0; /* it has been left */
        return;
    }
    s->is_refused = event->rest.count == 0;
    end_line(s);
    fprintf(s->wish->talk, "%srefused:%s %s\n", paint_on(s->wish->talk, PAINT_RED),
            paint_off(s->wish->talk),
            event->reason != INVCAL_REST_GOOD ? invcal_rest_reason_text(event->reason)
                                              : invcal_status_text(event->status));
}

/* What the stream was taken for: whoever sees a wrong column can stop at once. */
static void say_recognised(const stage *s)
{
    recognition seen = s->p->seen;
    char text[COLUMNS_TEXT_MAX];

    if (s->wish->unit != UNIT_UNKNOWN) {
        seen.unit = s->wish->unit;
        seen.unit_from = UNIT_FROM_OPTION;
    }
    fprintf(s->wish->talk, "%s: %s\n", s->p->name, columns_describe(&seen, text, sizeof text));
}

/* ---- what happens ------------------------------------------------------------------------------ */

/* Field units per input unit, if a unit is stated that tells it; else 0. */
static double stated_scale(const live_wish *wish)
{
    const reading_unit stated = wish->unit != UNIT_UNKNOWN ? wish->unit : live_log.where.seen.unit;

    return unit_scale(stated, wish->field);
}

/* With zero where it is, all positions so far point one way, although they were to differ: then it
 * is nowhere near, as in counts that have no sign. */
static int is_zero_far_off(const stage *s)
{
    double sum[3] = {0, 0, 0};

    for (unsigned n = 0; n < s->p->count; n++) {
        for (unsigned i = 0; i < 3; i++) {
            sum[i] += s->p->mean[3 * n + i] * s->lsb / s->wish->field;
        }
    }
    const double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    return length > FAR_OFF * s->p->count;
}

/* Then the middle of the ranges is the better zero, and the widest tells the scale. */
static void renew_nominal(const stage *s)
{
    invcal_calibration nominal;
    double zero[3];
    double lsb[3];

    if (s->wish->nominal || s->wish->zero || s->wish->lsb || stated_scale(s->wish) > 0 ||
        s->p->count < RENEW || !is_zero_far_off(s) ||
        !nominal_from_range(s->p, s->wish->field, zero, lsb)) {
        return;
    }
    const double least = fmin(lsb[0], fmin(lsb[1], lsb[2]));
    for (unsigned i = 0; i < 3; i++) {
        zero[i] /= live_log.unit;
        lsb[i] = least * live_log.unit;
    }
    if (invcal_calibration_nominal(zero, lsb, &nominal) == INVCAL_OK) {
        (void)invcal_session_renew(&session, &nominal); /* else the old one goes on */
    }
}

static int digest(stage *s, const invcal_event *event)
{
    int failure = EXIT_GOOD;

    switch (event->what) {
    case INVCAL_SESSION_TAKEN:
    case INVCAL_SESSION_ENOUGH:
    case INVCAL_SESSION_FINISHED:
        failure = rests_take(s->p, &event->rest, live_log.unit, &live_recording);
        renew_nominal(s);
        say_taken(s, event);
        say_next(s);
        break;
    case INVCAL_SESSION_REFUSED:
        if (event->reason != INVCAL_REST_GOOD) {
            s->summary->refused[event->reason]++;
            timeline_refuse(&live_recording.outline);
        } else if (event->rest.count > 0) { /* the calibration may think otherwise of it */
            failure = rests_take(s->p, &event->rest, live_log.unit, &live_recording);
        }
        say_refused(s, event);
        break;
    case INVCAL_SESSION_NOTHING:
    case INVCAL_SESSION_COVERED:
        break;
    default:
        show(s, event);
        break;
    }
    fflush(s->wish->talk);
    return failure;
}

/* The largest of the first readings stands for the field. */
static double guess_lsb(const live_wish *wish, const double zero[3])
{
    double most = 0;

    for (unsigned n = 0; n < live_log.ahead_count; n++) {
        double square = 0;
        for (unsigned i = 0; i < 3; i++) {
            const double v = live_log.ahead[n][i] - zero[i];
            square += v * v;
        }
        most = fmax(most, square);
    }
    return most > 0 ? wish->field / sqrt(most) : 1;
}

static int32_t rail(double value)
{
    return (int32_t)fmax(INT32_MIN, fmin(INT32_MAX, nearbyint(value / live_log.unit)));
}

/* The nominal calibration for counts of the log. */
static invcal_status set_nominal(const live_wish *wish, invcal_calibration *out)
{
    double zero[3] = {0, 0, 0};
    double scale[3];
    double guess = stated_scale(wish);

    if (wish->nominal) {
        *out = *wish->nominal;
        for (unsigned i = 0; i < 9; i++) {
            out->offset[i / 3] /= i % 3 == 0 ? live_log.unit : 1;
            out->matrix[i / 3][i % 3] *= live_log.unit;
        }
        return INVCAL_OK;
    }
    for (unsigned i = 0; i < 3; i++) {
        zero[i] = wish->zero ? wish->zero[i] : 0;
    }
    guess = guess > 0 ? guess : guess_lsb(wish, zero);
    for (unsigned i = 0; i < 3; i++) {
        scale[i] = (wish->lsb ? wish->lsb[i] : guess) * live_log.unit;
        zero[i] /= live_log.unit;
    }
    return invcal_calibration_nominal(zero, scale, out);
}

/* Holds each position as long as the axis that takes longest. */
static int hold_by_noise(const live_wish *wish)
{
    double longest = 0;
    double floor = 0;

    for (unsigned i = 0; i < 3; i++) {
        invcal_dwell d;
        if (invcal_noise_dwell(&wish->noise[i], wish->mean_sigma / wish->field, &d) != INVCAL_OK ||
            d.seconds > INVCAL_SESSION_HOLD_LONGEST) {
            message("--allan: by this noise a mean as good as %g takes more than %d s: ask for "
                    "less by --mean-sigma",
                    wish->mean_sigma, INVCAL_SESSION_HOLD_LONGEST);
            return EXIT_USAGE;
        }
        longest = fmax(longest, d.seconds);
        floor = d.end == INVCAL_DWELL_FLOOR ? fmax(floor, d.sigma * wish->field) : floor;
    }
    invcal_session_hold(&session, longest);
    fprintf(wish->talk, "each position: %.3g s by the noise measured", longest);
    if (floor > 0) {
        fprintf(wish->talk, "; longer does not help: a mean is good to %.2g", floor);
    }
    fprintf(wish->talk, "\n");
    return EXIT_GOOD;
}

static int begin(const live_wish *wish)
{
    invcal_session_setup setup = {.plan = wish->plan, .rate = live_log.rate};

    setup.settings.field = wish->field;
    memcpy(setup.target, wish->target, sizeof setup.target);
    setup.mean_sigma = wish->mean_sigma;
    setup.low = wish->clip ? rail(wish->clip[0]) : 0;
    setup.high = wish->clip ? rail(wish->clip[1]) : 0;
    if (set_nominal(wish, &setup.settings.nominal) != INVCAL_OK ||
        invcal_session_init(&session, &setup) != INVCAL_OK) {
        message("%s: %.6g samples a second, or the nominal calibration, is not usable",
                live_log.table.name, live_log.rate);
        return EXIT_FILE;
    }
    return wish->noise ? hold_by_noise(wish) : EXIT_GOOD;
}

static int watch(stage *s)
{
    invcal_event event;
    sample now;
    int more = 0;
    int failure = EXIT_GOOD;

    recording_begin(&live_recording, &live_log);
    say_recognised(s);
    say_next(s);
    while (!failure && (more = samples_next(&live_log, &now)) == 1) {
        if (now.is_gap) {
            invcal_session_gap(&session);
        }
        s->summary->samples++;
        recording_sample(&live_recording, &live_log, &now);
        if (invcal_session_feed(&session, now.raw, now.temperature, &event) !=
            INVCAL_SESSION_NOTHING) {
            recording_filled(&live_recording);
            failure = digest(s, &event);
        }
    }
    if (!failure && more == 0) {
        (void)invcal_session_finish(&session, &event);
        failure = digest(s, &event);
    }
    end_line(s);
    if (more < 0 || failure) {
        return failure ? failure : EXIT_FILE;
    }
    fprintf(s->wish->talk, "\n");
    return EXIT_GOOD;
}

/* The stream, and an empty file that takes its place when somebody interrupts. */
static volatile sig_atomic_t stream_file;
static volatile sig_atomic_t empty_file;

/* A read that waits is interrupted and ends the stream, see table.c; the next one finds the end. */
static void stop(int signal_number)
{
    (void)signal_number;
    if (empty_file >= 0 && stream_file >= 0) {
        (void)dup2(empty_file, stream_file);
    }
}

/* A serial port has no end: whoever presses Ctrl-C wants the result. */
static void catch_interrupts(const char *path)
{
    struct sigaction action = {.sa_handler = stop};

    stream_file = input_is_stdin(path) ? STDIN_FILENO : -1;
    empty_file = open("/dev/null", O_RDONLY);
    sigemptyset(&action.sa_mask);
    action.sa_flags = (int)SA_RESETHAND; /* a second one ends everything */
    (void)sigaction(SIGINT, &action, NULL);
    (void)sigaction(SIGTERM, &action, NULL);
}

int live_read(positions *p, const char *path, const live_wish *wish, rests_summary *summary)
{
    stage s = {.p = p, .wish = wish, .summary = summary, .is_terminal = isatty(fileno(wish->talk))};

    if (s.is_terminal) {
        fprintf(wish->talk, "waiting for samples\n");
    }
    catch_interrupts(path);
    int failure = samples_open(&live_log, path, wish->rate, 1);
    stream_file = live_log.table.file ? fileno(live_log.table.file) : -1;

    *p = (positions){.name = live_log.table.name, .has_noise = 1, .seen = live_log.where.seen};
    *summary = (rests_summary){.rate = live_log.rate,
                               .is_rate_known = live_log.is_rate_known,
                               .outline = &live_recording.outline};
    failure = failure ? failure : begin(wish);
    s.lsb = guess_lsb(wish, (const double[3]){0, 0, 0});
    failure = failure ? failure : watch(&s);
    stream_file = -1;
    samples_close(&live_log);
    rests_end(p, &live_log, summary);
    return failure;
}
