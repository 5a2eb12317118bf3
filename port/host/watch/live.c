/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "watch/live.h"

#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

#include "cli/command.h"
#include "fit/fit.h"
#include "cli/input.h"
#include "watch/live_program.h"
#include "cli/message.h"
#include "fit/nominal.h"
#include "text/paint.h"
#include "read/samples.h"
#include "text/plain.h"

#define RENEW 4u          /* positions whose range says more than the first reading */
#define FAR_OFF 0.7       /* mean of unit vectors that differ less than positions do */
#define HOLD_MAX 60       /* seconds: what the first rest tells is cut off there */
#define HOLD_LONGEST 3600 /* seconds that can be demanded */

/* All are too large for the stack. */
static samples live_log;
static recording live_recording;
static invcal_session session;
static live_program followed; /* if the wish has a set */

typedef struct {
    positions *p;
    const live_wish *wish;
    rests_summary *summary;
    unsigned taken; /* positions */
    int is_enough;  /* the target has been reached */
    int is_terminal;
    int is_refused;     /* said of the rest that is going on */
    double lsb;         /* as guessed for zero at 0 */
    invcal_event shown; /* of the line that changes */
} stage;

/* ---- what the person sees ---------------------------------------------------------------------- */

/* A line that stays; what was on the changing line goes. */
static void end_line(stage *s)
{
    if (s->is_terminal) {
        fprintf(s->wish->talk, "\r%60s\r", "");
    }
}

/* A position is good: it may be left, and for where. Of a program short enough for one line. */
static void say_good(const stage *s, const char *indent)
{
    FILE *talk = s->wish->talk;
    char words[INVCAL_WORDS];

    fputs(indent, talk);
    if (s->wish->set) {
        live_program_say_good(&followed, talk);
    } else {
        (void)invcal_session_next_words(&session, words);
        fprintf(talk, "good: move on%s%s", *words ? " to " : "", words);
    }
}

/* The changing line: only on a terminal, and only if there is news. */
static void show(stage *s, invcal_event event)
{
    if (event == INVCAL_MOVING) {
        s->is_refused = 0;
    }
    if (!s->is_terminal && event == INVCAL_READY) {
        say_good(s, "");
        fprintf(s->wish->talk, "\n");
    }
    if (!s->is_terminal || s->is_refused || (event == INVCAL_MOVING && s->shown == event)) {
        return;
    }
    s->shown = event;
    end_line(s);
    const unsigned progress = invcal_session_progress(&session);
    if (event == INVCAL_SETTLING && progress < 100) {
        fprintf(s->wish->talk, "  hold still ... %3u %%", progress);
    } else if (event != INVCAL_MOVING) {
        say_good(s, "  ");
    } else {
        fprintf(s->wish->talk, "  moving");
    }
    fflush(s->wish->talk);
}

/* Where to turn next, if there is anywhere. */
static void say_next(stage *s)
{
    char text[PROGRAM_TEXT_MAX];

    if (s->wish->set) {
        (void)program_next_text(&followed.now, text);
    } else {
        (void)invcal_session_next_words(&session, text);
    }
    if (*text) {
        fprintf(s->wish->talk, "next: %s\n", text);
    }
}

static double largest(const double v[3])
{
    return fmax(v[0], fmax(v[1], v[2]));
}

static void say_kind(const stage *s, const char *what, double sigma, told_unit unit)
{
    fprintf(s->wish->talk, "%s ± %.2g %s", what, unit.scale * sigma, unit.unit);
}

/* How exactly everything is known, once it can be told. */
static void say_sigma(stage *s)
{
    const told_style told = s->wish->told;
    const told_unit degrees = {told_angle(TOLD_EVERYDAY).scale, "deg"};
    invcal_calibration calibration;
    invcal_quality q;

    if (invcal_session_solve(&session, &calibration, &q) != INVCAL_OK || q.dof == 0) {
        return;
    }
    const double coverage = invcal_coverage(q.dof);
    say_kind(s, "; to 95 %: offsets", coverage * largest(&q.sigma[INVCAL_DELTA_X]),
             told_field(told, 1));
    say_kind(s, ", scales", coverage * largest(&q.sigma[INVCAL_DK_X]), told_scale(told));
    say_kind(s, ", angles", coverage * largest(&q.sigma[INVCAL_GAMMA_XY]),
             told == TOLD_INS ? told_angle(told) : degrees);
}

static void say_end(FILE *talk, const char *word, const char *what)
{
    fprintf(talk, "%s%s%s %s; end the stream (Ctrl-C)\n", paint_on(talk, PAINT_GREEN), word,
            paint_off(talk), what);
}

/* What a position has brought about. */
typedef enum { USED, ENOUGH, FINISHED } outcome;

static void say_taken(stage *s, outcome what)
{
    end_line(s);
    fprintf(s->wish->talk, "position %u taken", s->taken);
    say_sigma(s);
    fprintf(s->wish->talk, "\n");
    if (s->wish->set) {
        live_program_say_wrong(&followed, s->wish->talk);
    }
    if (what == ENOUGH) {
        say_end(s->wish->talk, "enough:", "what is wanted is reached");
    } else if (what == FINISHED) {
        say_end(s->wish->talk, "finished:", "the program is complete");
    }
}

static void say_refused(stage *s, int is_left)
{
    if (s->is_refused) {
        s->is_refused = 0; /* it has been left */
        return;
    }
    s->is_refused = !is_left;
    end_line(s);
    fprintf(s->wish->talk, "%srefused:%s %s\n", paint_on(s->wish->talk, PAINT_RED),
            paint_off(s->wish->talk), rests_reason_text(invcal_session_reason(&session)));
}

/* What the stream was taken for: whoever sees a wrong column can stop at once. */
static void say_recognised(const stage *s)
{
    recognition seen = s->p->seen;
    char text[COLUMNS_TEXT_MAX];
    char name[PLAIN_MAX];

    if (s->wish->unit != UNIT_UNKNOWN) {
        seen.unit = s->wish->unit;
        seen.unit_from = UNIT_FROM_OPTION;
    }
    fprintf(s->wish->talk, "%s: %s\n", plain_copy(s->p->name, name),
            columns_describe(&seen, text, sizeof text));
}

/* ---- zero and scale ---------------------------------------------------------------------------- */

/* Field units per input unit, if a unit is stated that tells it; else 0. */
static double stated_scale(const live_wish *wish)
{
    const reading_unit stated = wish->unit != UNIT_UNKNOWN ? wish->unit : live_log.where.seen.unit;

    return unit_scale(stated, wish->field);
}

/* Nothing states the zero of the readings, nor the scale. */
static int is_nominal_free(const live_wish *wish)
{
    return !wish->nominal && !wish->zero && !wish->lsb && !(stated_scale(wish) > 0);
}

/* Free hand: with zero where it is, all positions so far point one way, although they were to differ: then it
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

/* Over the field, for counts of the log. Returns 1 if it is usable. */
static int nominal_of_counts(const live_wish *wish, const double zero[3], const double lsb[3],
                             invcal_calibration *out)
{
    double counts[3];
    double zero_counts[3];

    for (unsigned i = 0; i < 3; i++) {
        zero_counts[i] = zero[i] / live_log.unit;
        counts[i] = wish->field / (lsb[i] * live_log.unit);
    }
    return invcal_nominal(zero_counts, counts, out) == INVCAL_OK;
}

/* All positions so far are readings of the field with this nominal. */
static int fits_all(const invcal_calibration *nominal)
{
    return invcal_bad_reading(session.mean[0], session.count, nominal) == session.count;
}

/* Then the middle of the ranges is the better zero, and the widest tells the scale. Returns 1 if so. */
static int find_by_range(const stage *s, double zero[3], double lsb[3])
{
    if (s->p->count < RENEW || !is_zero_far_off(s) ||
        !nominal_from_range(s->p, s->wish->field, zero, lsb)) {
        return 0;
    }
    lsb[0] = lsb[1] = lsb[2] = fmin(lsb[0], fmin(lsb[1], lsb[2]));
    return 1;
}

/* Where a program is followed, its directions tell more, as long as it is. */
static int find_by_program(const stage *s, double zero[3], double lsb[3])
{
    double length;
    const int is_found = live_program_scale(&followed, zero, &length);

    lsb[0] = lsb[1] = lsb[2] = is_found ? s->wish->field / length : 1;
    return is_found;
}

/* The table of the session is in counts: it takes another nominal at any time. */
static void renew_nominal(const stage *s)
{
    invcal_calibration nominal;
    double zero[3];
    double lsb[3];

    if (is_nominal_free(s->wish) &&
        (s->wish->set ? find_by_program(s, zero, lsb) : find_by_range(s, zero, lsb)) &&
        nominal_of_counts(s->wish, zero, lsb, &nominal) && fits_all(&nominal)) {
        session.nominal = nominal; /* else the old one goes on */
    }
}

/* ---- how long to stay -------------------------------------------------------------------------- */

static void hold(double seconds)
{
    invcal_session_hold(&session, (uint32_t)ceil(1000 * seconds));
}

/* The first rest tells the noise: T = s^2 / (sigma^2 rate), s^2 that of a sample, the mean over the
 * axes. That is white noise. Returns whether the rest has been held as long. */
static int is_held_long_enough(const stage *s)
{
    const invcal_calibration *c = &session.nominal;
    const double sigma = s->wish->mean_sigma / s->wish->field;
    invcal_rest rest;
    double square = 0;

    if (!(sigma > 0) || s->wish->noise || s->taken > 0 ||
        !invcal_rests_get(&session.rests, &rest)) {
        return 1;
    }
    for (unsigned i = 0; i < 9; i++) {
        square += c->matrix[i / 3][i % 3] * c->matrix[i / 3][i % 3] / 3;
    }
    hold(fmin(HOLD_MAX, square * rest.variance / (sigma * sigma) / live_log.rate));
    return invcal_session_progress(&session) == 100;
}

/* ---- what becomes of a rest -------------------------------------------------------------------- */

static int take_rest(stage *s)
{
    invcal_rest rest;

    return invcal_rests_get(&session.rests, &rest)
               ? rests_take(s->p, &rest, live_log.unit, &live_recording)
               : EXIT_GOOD;
}

/* A target that is 0 is any. */
static int reaches_target(const stage *s)
{
    double target[3];
    int is_wanted = 0;

    for (unsigned i = 0; i < 3; i++) {
        is_wanted = is_wanted || s->wish->target[i] > 0;
        target[i] = s->wish->target[i] > 0 ? s->wish->target[i] : INVCAL_REAL_MAX;
    }
    if (s->wish->need > 0 && !invcal_session_meets(&session, s->wish->need, s->wish->field_sigma)) {
        return 0;
    }
    return is_wanted ? invcal_session_reaches(&session, target) : s->wish->need > 0;
}

static outcome judge_position(stage *s, int is_complete)
{
    if (is_complete) {
        return FINISHED;
    }
    if (!s->is_enough && reaches_target(s)) {
        s->is_enough = 1;
        return ENOUGH;
    }
    return USED;
}

static int take(stage *s)
{
    const int failure = take_rest(s);

    s->taken++;
    renew_nominal(s);
    say_taken(s, judge_position(s, s->wish->set && live_program_take(&followed)));
    say_next(s);
    return failure;
}

static int refuse(stage *s)
{
    const invcal_status reason = invcal_session_reason(&session);
    const int is_rest = reason < INVCAL_REST_SHORT || reason > INVCAL_REST_SAME;
    const int is_left = is_rest && invcal_session_progress(&session) == 0;
    int failure = EXIT_GOOD;

    if (!is_rest) {
        rests_refuse(s->summary, reason, &live_recording);
    } else if (is_left) { /* the calibration may think otherwise of it */
        failure = take_rest(s);
    }
    say_refused(s, is_left);
    return failure;
}

static int digest(stage *s, invcal_event event)
{
    int failure = EXIT_GOOD;

    switch (event) {
    case INVCAL_TAKEN:
        failure = take(s);
        break;
    case INVCAL_REFUSED:
        failure = refuse(s);
        break;
    case INVCAL_NOTHING:
        break;
    case INVCAL_READY:
        show(s, is_held_long_enough(s) ? INVCAL_READY : INVCAL_SETTLING);
        break;
    default:
        show(s, event);
        break;
    }
    fflush(s->wish->talk);
    return failure;
}

/* ---- the stream -------------------------------------------------------------------------------- */

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

/* The nominal calibration, over the field, for counts of the log. Returns 1 if it is usable. */
static int set_nominal(const live_wish *wish, invcal_calibration *out)
{
    static const double origin[3] = {0, 0, 0};
    const double *zero = wish->zero ? wish->zero : origin;
    double guess = stated_scale(wish);
    double lsb[3];

    if (wish->nominal) {
        *out = fit_over_field(wish->nominal, wish->field / live_log.unit);
        for (unsigned i = 0; i < 3; i++) {
            out->offset[i] /= live_log.unit;
        }
        return 1;
    }
    guess = guess > 0 ? guess : guess_lsb(wish, zero);
    for (unsigned i = 0; i < 3; i++) {
        lsb[i] = wish->lsb ? wish->lsb[i] : guess;
    }
    return nominal_of_counts(wish, zero, lsb, out);
}

/* Holds each position as long as the axis that takes longest. */
static int hold_by_noise(const live_wish *wish)
{
    double longest = 0;
    double floor = 0;

    for (unsigned i = 0; i < 3; i++) {
        invcal_dwell d;
        if (invcal_noise_dwell(&wish->noise[i], wish->mean_sigma / wish->field, &d) != INVCAL_OK ||
            d.seconds > HOLD_LONGEST) {
            message("--allan: by this noise a mean as good as %g takes more than %d s: ask for "
                    "less by --mean-sigma",
                    wish->mean_sigma, HOLD_LONGEST);
            return EXIT_USAGE;
        }
        longest = fmax(longest, d.seconds);
        floor = d.end == INVCAL_DWELL_FLOOR ? fmax(floor, d.sigma * wish->field) : floor;
    }
    hold(longest);
    fprintf(wish->talk, "each position: %.3g s by the noise measured", longest);
    if (floor > 0) {
        fprintf(wish->talk, "; longer does not help: a mean is good to %.2g", floor);
    }
    fprintf(wish->talk, "\n");
    return EXIT_GOOD;
}

static int begin(const live_wish *wish)
{
    const double *clip = wish->clip;
    invcal_calibration nominal;

    if (!set_nominal(wish, &nominal) ||
        invcal_session_begin(&session, &nominal, samples_whole_rate(&live_log)) != INVCAL_OK ||
        (clip && invcal_session_rails(&session, samples_count(&live_log, clip[0]),
                                      samples_count(&live_log, clip[1])) != INVCAL_OK)) {
        message("%s: %.6g samples a second, or the nominal calibration, is not usable",
                live_log.table.name, live_log.rate);
        return EXIT_FILE;
    }
    return wish->noise ? hold_by_noise(wish) : EXIT_GOOD;
}

static int watch(stage *s)
{
    sample now;
    int more = 0;
    int failure = EXIT_GOOD;

    recording_begin(&live_recording, &live_log);
    if (s->wish->set) {
        live_program_begin(&followed, s->wish->set, &session, s->p, live_log.unit,
                           !is_nominal_free(s->wish));
    }
    say_recognised(s);
    say_next(s);
    while (!failure && (more = samples_next(&live_log, &now)) == 1) {
        if (now.is_gap) {
            invcal_session_gap(&session);
        }
        s->summary->samples++;
        recording_sample(&live_recording, &live_log, &now);
        const invcal_event event = invcal_session_feed(&session, now.raw);
        if (event != INVCAL_NOTHING) {
            recording_filled(&live_recording);
            failure = digest(s, event);
        }
    }
    if (!failure && more == 0) {
        failure = digest(s, invcal_session_finish(&session));
    }
    end_line(s);
    if (more < 0 || failure) {
        return failure ? failure : EXIT_FILE;
    }
    if (s->wish->set) {
        live_program_say_missing(&followed, s->wish->talk);
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
