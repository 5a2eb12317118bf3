/* SPDX-License-Identifier: MIT */
#include "fit/gyro.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/result.h"
#include "cli/command.h"
#include "maths/matrix.h"
#include "maths/median.h"
#include "text/number.h"
#include "session/rests.h"

#define COUNT_BITS 24      /* of the largest reading found; others may be 128 times as large */
#define RAIL_RUN_MIN 5u    /* equal readings in a row at the end of the range */
#define RAIL_STEPS_MIN 4   /* of a reading, from the bias: nearer, it is noise that repeats */
#define UNIT_TOLERANCE 1.3 /* ratio: a smaller one is a scale error */
#define NAMED_UNIT_TOLERANCE 1.15
#define MISFIT_MAX 0.25  /* rad: with a larger one, no axes fit */
#define SIGNAL_MIN 1e-4  /* share of all rotation: an axis with less has no signal */
#define SEEN_MIN 0.02    /* share of rotation about it that the accelerometer must have seen */
#define MOTION_RATIO 4.0 /* over the mean square at rest */
#define RESTS_MIN 2u
#define MEAN_TOLERANCE 1e-12
/* If the unit is unknown, the largest reading in rad/s: so small that the device seems to turn in
 * no rest. */
#define RATE_RANGE_DEFAULT 0.01

/* Too large for the stack. */
static invcal_imu moves;

typedef char axes_text[40];

static const char *axes_words(const int8_t axes[3], axes_text text)
{
    snprintf(text, sizeof(axes_text), "%s%c,%s%c,%s%c", axes[0] < 0 ? "-" : "",
             "xyz"[abs(axes[0]) - 1], axes[1] < 0 ? "-" : "", "xyz"[abs(axes[1]) - 1],
             axes[2] < 0 ? "-" : "", "xyz"[abs(axes[2]) - 1]);
    return text;
}

/* ---- readings ----------------------------------------------------------------------------------- */

/* The size of a count, by the largest of a thousand readings: most likely a single wrong one, which
 * would make all counts coarse, is not among them. */
static double find_count(const gyro_log *log)
{
    const size_t step = log->readings / 1000 + 1;
    double most = 0;

    for (size_t i = 0; i < log->readings; i += step) {
        for (unsigned k = 0; k < 3; k++) {
            most = fmax(most, fabs(log->reading[i].x[k]));
        }
    }
    return most > 0 ? ldexp(1, (int)ceil(log2(most)) - COUNT_BITS) : 1;
}

static int is_whole(const gyro_log *log)
{
    for (size_t i = 0; i < log->readings; i++) {
        for (unsigned k = 0; k < 3; k++) {
            if (fabs(log->reading[i].x[k] - nearbyint(log->reading[i].x[k])) > 0) {
                return 0;
            }
        }
    }
    return 1;
}

/* The end of an axis' range: its extreme reading, if that is repeated in a row more often than any
 * other. side: -1 minimum, 1 maximum. NaN: not reached. */
static double find_rail(const gyro_log *log, unsigned axis, double side)
{
    double end = -HUGE_VAL;
    size_t run = 0;
    size_t at_end = 0;
    size_t elsewhere = 0;

    for (size_t i = 0; i < log->readings; i++) {
        end = fmax(end, side * log->reading[i].x[axis]);
    }
    for (size_t i = 0; i < log->readings; i++) {
        const double x = side * log->reading[i].x[axis];
        const int is_equal = i > 0 && !(fabs(x - side * log->reading[i - 1].x[axis]) > 0);
        run = is_equal ? run + 1 : 1;
        size_t *longest = x < end ? &elsewhere : &at_end;
        *longest = run > *longest ? run : *longest;
    }
    return at_end >= RAIL_RUN_MIN && at_end > elsewhere ? side * end : NUMBER_UNKNOWN;
}

/* Returns 0 if an axis is stuck. */
static int check_readings(gyro_fit *g)
{
    const gyro_log *log = g->log;

    for (unsigned k = 0; k < 3; k++) {
        size_t i = 1;
        while (i < log->readings && !(fabs(log->reading[i].x[k] - log->reading[0].x[k]) > 0)) {
            i++;
        }
        if (i >= log->readings) {
            gyro_refuse(g, "stuck", "the gyroscope's %c never changes", "xyz"[k]);
            gyro_advise(g, "check that it is read, and record again");
            return 0;
        }
        g->rail[0][k] = find_rail(log, k, -1);
        g->rail[1][k] = find_rail(log, k, 1);
    }
    return 1;
}

/* ---- rests -------------------------------------------------------------------------------------- */

/* 1 if position k is kept. */
static int is_kept(const rejection *kept, unsigned k)
{
    return !rejection_has(kept, kept->count, k);
}

/* Feeds the samples of the log again, as rests_read did. */
typedef struct {
    const gyro_log *log;
    const positions *p;
    const rejection *kept;
    invcal_private_rests rests;
    unsigned position; /* rests taken so far */
    size_t i;
} replay;

static void begin_replay(replay *r, const gyro_log *log, unsigned rate, const double *clip,
                         const positions *p, const rejection *kept)
{
    *r = (replay){.log = log, .p = p, .kept = kept};
    (void)invcali_rests_init(&r->rests, rate); /* it accepted the rate before */
    if (clip) {
        (void)invcali_rests_rails(&r->rests, (int32_t)nearbyint(clip[0] / log->unit),
                                  (int32_t)nearbyint(clip[1] / log->unit));
    }
}

/* Returns whether the latest rest is the next position: a live stream that requires longer rests
 * has fewer. */
static int is_position(const replay *r)
{
    const double *mean = &r->p->mean[3 * (size_t)r->position];
    invcali_rest rest;

    if (r->position >= r->p->count || !invcali_rests_get(&r->rests, &rest)) {
        return 0;
    }
    for (unsigned i = 0; i < 3; i++) {
        const double x = (double)rest.sum[i] / rest.count * r->log->unit;
        if (!(fabs(x - mean[i]) <= MEAN_TOLERANCE * fabs(x))) {
            return 0;
        }
    }
    return 1;
}

/* Feeds a sample, or the end. A rest that is left out must not end a move, and is reported as
 * refused. */
static invcal_event replay_step(replay *r)
{
    const gyro_log_sample *s = &r->log->sample[r->i];
    const int is_end = r->i == r->log->samples;

    if (!is_end && s->is_gap) {
        invcali_rests_gap(&r->rests);
    }
    invcal_event event =
        is_end ? invcali_rests_finish(&r->rests) : invcali_rests_feed(&r->rests, s->raw);
    if (event == INVCAL_TAKEN) {
        const int is_one = is_position(r);
        event = is_one && is_kept(r->kept, r->position) ? INVCAL_TAKEN : INVCAL_REFUSED;
        r->position += (unsigned)is_one;
    }
    r->i++;
    return event;
}

/* Finds the kept rests, up to the last INVCAL_MAX_MOVES. */
static void find_rests(gyro_fit *g, replay *r)
{
    while (r->i <= r->log->samples) {
        invcali_rest rest;
        const size_t now = r->i < r->log->samples ? r->i + 1 : r->i;
        if (replay_step(r) != INVCAL_TAKEN || !invcali_rests_get(&r->rests, &rest)) {
            continue;
        }
        if (g->rests == INVCAL_MAX_MOVES) {
            memmove(&g->rest[0], &g->rest[1], (INVCAL_MAX_MOVES - 1) * sizeof g->rest[0]);
            g->rests--;
            g->earlier_rests++;
        }
        /* samples of a partly filled block are not in rests.time, but counted here */
        const uint32_t pending = r->rests.time - rest.end;
        const uint32_t length = rest.end - rest.begin;
        const size_t end = now > pending ? now - pending : 1;
        g->rest[g->rests++] = (gyro_rest){
            .position = r->position - 1, .begin = end > length ? end - length : 0, .end = end};
    }
}

/* The mean reading of a rest, input units; NaN without readings. */
static void mean_of(const gyro_log *log, long lag, const gyro_rest *rest, double mean[3])
{
    const long first = (long)log->sample[rest->begin].reading_end + lag;
    const long last = (long)log->sample[rest->end - 1].reading_end + lag;

    mean[0] = mean[1] = mean[2] = NUMBER_UNKNOWN;
    if (first < 0 || last > (long)log->readings || last <= first) {
        return;
    }
    mean[0] = mean[1] = mean[2] = 0;
    for (long i = first; i < last; i++) {
        for (unsigned k = 0; k < 3; k++) {
            mean[k] += log->reading[i].x[k] / (double)(last - first);
        }
    }
}

/* Sets the up direction of each rest, and its mean reading, at first in input units. */
static void fill_rests(gyro_fit *g, long lag, const positions *p, const invcal_calibration *start)
{
    for (unsigned i = 0; i < g->rests; i++) {
        gyro_rest *rest = &g->rest[i];
        invcal_apply(start, p->mean[3 * (size_t)rest->position],
                     p->mean[3 * (size_t)rest->position + 1],
                     p->mean[3 * (size_t)rest->position + 2], rest->up);
        const double length =
            sqrt(rest->up[0] * rest->up[0] + rest->up[1] * rest->up[1] + rest->up[2] * rest->up[2]);
        for (unsigned k = 0; k < 3; k++) {
            rest->up[k] /= length;
        }
        mean_of(g->log, lag, rest, rest->bias);
    }
}

/* The median of all rests, which a single false rest hardly affects. */
static void find_median_bias(const gyro_fit *g, double bias[3])
{
    double x[INVCAL_MAX_MOVES] = {0};

    for (unsigned k = 0; k < 3; k++) {
        unsigned n = 0;
        for (unsigned i = 0; i < g->rests; i++) {
            x[n] = g->rest[i].bias[k];
            n += isfinite(x[n]) != 0;
        }
        bias[k] = median_of(x, n);
    }
}

/* The smallest change of an axis from one reading to the next: one count, or a multiple. */
static double smallest_step(const gyro_log *log, unsigned axis)
{
    double step = HUGE_VAL;

    for (size_t i = 1; i < log->readings; i++) {
        const double change = fabs(log->reading[i].x[axis] - log->reading[i - 1].x[axis]);
        step = change > 0 ? fmin(step, change) : step;
    }
    return step;
}

/* A gyroscope that reads its bias, plus or minus a count, is not clipped. */
static void drop_false_rails(gyro_fit *g, const double bias[3])
{
    for (unsigned k = 0; k < 3; k++) {
        const double least = RAIL_STEPS_MIN * smallest_step(g->log, k);
        for (unsigned side = 0; side < 2; side++) {
            double *rail = &g->rail[side][k];
            *rail = fabs(*rail - bias[k]) <= least ? NUMBER_UNKNOWN : *rail;
        }
    }
}

static int is_unchanged(const gyro_log *log, size_t i)
{
    const double *x = log->reading[i].x;
    const double *y = log->reading[i - 1].x;

    return !(fabs(x[0] - y[0]) > 0 || fabs(x[1] - y[1]) > 0 || fabs(x[2] - y[2]) > 0);
}

/* Returns 0 if no axis has changed since before the last move. */
static int check_end(gyro_fit *g, const positions *p)
{
    const gyro_log *log = g->log;
    size_t from = log->readings - 1;
    size_t at = 0;
    size_t first;
    size_t last;
    unsigned k = 0;

    while (from > 0 && is_unchanged(log, from)) {
        from--;
    }
    gyro_between(log, 0, &g->rest[g->rests - 2], &first, &last);
    if (from > first) {
        return 1;
    }
    while (at < log->samples && log->sample[at].reading_end <= from) {
        at++;
    }
    while (k + 1 < g->rests && g->rest[k + 1].begin <= at) {
        k++;
    }
    const position_origin *o = &p->origin[g->rest[k].position];
    if (log->file || at < g->rest[k].begin) { /* the line is of another file, or before all rests */
        gyro_refuse(g, "stuck", "the gyroscope reads the same from position %u (line %lu) on",
                    g->rest[k].position + 1, o->line);
    } else {
        gyro_refuse(g, "stuck", "the gyroscope reads the same from line %lu on",
                    o->line + (unsigned long)(at - g->rest[k].begin));
    }
    gyro_advise(g, "check how it is read, and record again");
    return 0;
}

/* ---- unit and axes ------------------------------------------------------------------------------ */

/* The mean square of readings about the bias. */
static double mean_square(const gyro_log *log, size_t first, size_t last, const double bias[3])
{
    double sum = 0;

    for (size_t i = first; i < last; i++) {
        for (unsigned k = 0; k < 3; k++) {
            sum += pow(log->reading[i].x[k] - bias[k], 2);
        }
    }
    return last > first ? sum / (double)(last - first) : 0;
}

/* In the rests; the median, as a single reading may be wrong. */
static double square_at_rest(const gyro_fit *g, long lag, const double bias[3])
{
    double square[INVCAL_MAX_MOVES];

    for (unsigned i = 0; i < g->rests; i++) {
        const gyro_rest itself[2] = {{.end = g->rest[i].begin + 1}, {.begin = g->rest[i].end}};
        size_t first;
        size_t last;
        gyro_between(g->log, lag, itself, &first, &last);
        square[i] = mean_square(g->log, first, last, bias);
    }
    return median_of(square, g->rests);
}

/* Whether the readings are much larger between the rests than in them. */
static int has_turned(const gyro_fit *g, long lag, const double bias[3])
{
    double square[INVCAL_MAX_MOVES];

    for (unsigned i = 0; i + 1 < g->rests; i++) {
        size_t first;
        size_t last;
        gyro_between(g->log, lag, &g->rest[i], &first, &last);
        square[i] = mean_square(g->log, first, last, bias);
    }
    return median_of(square, g->rests - 1) > MOTION_RATIO * square_at_rest(g, lag, bias);
}

/* A gyroscope axis without signal, although the accelerometer saw turns about it; -1: none. */
static int find_dead_axis(const gyro_fit *g, long lag, const double bias[3])
{
    double turned[3] = {0};
    double seen[3] = {0};

    for (unsigned i = 0; i + 1 < g->rests; i++) {
        const double *a = g->rest[i].up;
        const double *b = g->rest[i + 1].up;
        size_t first;
        size_t last;
        gyro_between(g->log, lag, &g->rest[i], &first, &last);
        double all = 0;
        double square[3];
        for (unsigned k = 0; k < 3; k++) {
            const unsigned m = (k + 1) % 3;
            const unsigned n = (k + 2) % 3;
            double sum = 0;
            for (size_t j = first; j < last; j++) {
                sum += g->log->reading[j].x[k] - bias[k];
            }
            square[k] = sum * sum;
            all += square[k];
            seen[k] += pow(a[m] * b[n] - a[n] * b[m], 2);
        }
        for (unsigned k = 0; k < 3 && all > 0; k++) { /* equal weights, as a move may be wrong */
            turned[k] += square[k] / all;
        }
    }
    for (unsigned k = 0; k < 3; k++) {
        if (turned[k] <= SIGNAL_MIN * (turned[0] + turned[1] + turned[2]) &&
            seen[k] > SEEN_MIN * (seen[0] + seen[1] + seen[2])) {
            return (int)k;
        }
    }
    return -1;
}

static int is_within(double a, double b, double times)
{
    return a < b * times && b < a * times;
}

static double name_unit(double turn)
{
    static const double units[] = {1, UNIT_DEGREE, 1e-3, 1e-3 * UNIT_DEGREE};

    for (unsigned i = 0; i < 4; i++) {
        if (is_within(turn, units[i], NAMED_UNIT_TOLERANCE)) {
            return units[i];
        }
    }
    return 0;
}

/* The unit, as stated or found from the moves. Returns 0 if they contradict each other. */
static int choose_unit(gyro_fit *g, const gyro_options *options, const gyro_guess *guess)
{
    const double header = g->log->rate_unit;
    const double named = guess->moves < 2 ? 0 : name_unit(guess->rate_unit);
    const int is_stated = options->rate_unit > 0 || header > 0;

    g->rate_unit = options->rate_unit > 0 ? options->rate_unit : header;
    g->rate_unit_from = options->rate_unit > 0 ? UNIT_FROM_OPTION : UNIT_FROM_HEADER;
    if (!is_stated) {
        g->is_counts = !(named > 0) || is_whole(g->log);
        g->rate_unit = g->is_counts ? guess->rate_unit : named;
        g->rate_unit_from = UNIT_FROM_SIZE;
        return 1;
    }
    if (guess->moves < 2 || !guess->is_clear ||
        is_within(guess->rate_unit, g->rate_unit, UNIT_TOLERANCE)) {
        return 1;
    }
    gyro_refuse(
        g, "unit",
        "the stated unit of the gyroscope is %s (%.6g rad/s), but the accelerometer saw turns "
        "%.3g times as large",
        options->rate_unit > 0 ? "--gyro-lsb" : unit_angular_rate_words(header), g->rate_unit,
        guess->rate_unit / g->rate_unit);
    if (named > 0) {
        gyro_advise(g, "its unit is %s: state --gyro-lsb %s", unit_angular_rate_words(named),
                    fabs(named - 1) < 1e-9             ? "rad/s"
                    : fabs(named - UNIT_DEGREE) < 1e-9 ? "deg/s"
                    : named < 1e-4                     ? "0.001"
                                                       : "0.0572958");
    } else {
        gyro_advise(g, "state --gyro-lsb %.3g, in degrees/s", guess->rate_unit / UNIT_DEGREE);
    }
    return 0;
}

static int check_axes(gyro_fit *g, const gyro_options *options, const gyro_guess *guess)
{
    int8_t axes[3];
    axes_text text;

    if (!(guess->misfit < MISFIT_MAX)) {
        gyro_say_misfit(g, guess->misfit);
        return 0;
    }
    if (guess->axes[0] == 1 && guess->axes[1] == 2 && guess->axes[2] == 3) {
        return 1;
    }
    if (!guess->is_clear) {
        gyro_say_unclear(g);
        return 0;
    }
    for (unsigned i = 0; i < 3; i++) {
        const int8_t stated = options->axes[abs(guess->axes[i]) - 1];
        axes[i] = (int8_t)(guess->axes[i] < 0 ? -stated : stated);
    }
    gyro_refuse(g, "axes",
                "the gyroscope's axes are not the accelerometer's: about x, y and z of the "
                "accelerometer turn its %s",
                axes_words(axes, text));
    gyro_advise(g, "state --gyro-axes %s, or correct the driver", text);
    return 0;
}

/* Returns 0 if the moves are refused. */
static int find_unit_and_axes(gyro_fit *g, const gyro_options *options, long lag,
                              const double bias[3])
{
    gyro_guess guess = {0};

    memcpy(g->axes, options->axes, sizeof g->axes);
    if (!has_turned(g, lag, bias)) {
        gyro_refuse(g, "too few", "the gyroscope reads no turns between the rests");
        gyro_advise(g, "record without a break from rest to rest, moves included");
        return 0;
    }
    const int dead = find_dead_axis(g, lag, bias);
    if (dead >= 0) {
        gyro_refuse(
            g, "stuck",
            "the gyroscope's %c reads nothing, though the moves turned the device about all axes",
            "xyz"[dead]);
        gyro_advise(g, "check that this axis is read, and record again");
        return 0;
    }
    const int has_guess = gyro_search(g->log, lag, g->rest, g->rests, bias, g->axes, &guess);
    if (!choose_unit(g, options, &guess)) {
        return 0;
    }
    if (!(g->rate_unit > 0)) {
        gyro_refuse(g, "too few",
                    "too few complete moves between rests to determine the unit of the gyroscope");
        gyro_advise(g, "turn to other sides, each within ten seconds, or state --gyro-lsb");
        return 0;
    }
    return !has_guess || check_axes(g, options, &guess);
}

/* ---- solution ----------------------------------------------------------------------------------- */

static int32_t count_of(double value, double unit)
{
    return (int32_t)fmax(INT32_MIN, fmin(INT32_MAX, nearbyint(value / unit)));
}

/* Sets the ends of the range, common to all axes: the narrowest of their ranges, so that no
 * clipping is missed. */
static void set_rails(const gyro_fit *g, double unit)
{
    double low = -HUGE_VAL;
    double high = HUGE_VAL;

    for (unsigned k = 0; k < 3; k++) {
        const int of = abs(g->axes[k]) - 1;
        const double sign = g->axes[k] < 0 ? -1 : 1;
        for (unsigned side = 0; side < 2; side++) {
            const double rail = sign * g->rail[side][of];
            if (!isnan(rail) && (sign < 0) != (side == 0)) {
                low = fmax(low, rail);
            } else if (!isnan(rail)) {
                high = fmin(high, rail);
            }
        }
    }
    if (low < high) {
        (void)invcal_imu_set_limits(&moves, low > -HUGE_VAL ? count_of(low, unit) : INT32_MIN,
                                    high < HUGE_VAL ? count_of(high, unit) : INT32_MAX);
    }
}

static void feed(const gyro_fit *g, const gyro_log_reading *r, double unit)
{
    double x[3];
    int32_t raw[3];

    if (r->is_gap) {
        invcal_imu_gap(&moves);
    }
    gyro_axes(g->axes, r->x, x);
    for (unsigned k = 0; k < 3; k++) {
        raw[k] = count_of(x[k], unit);
    }
    invcal_imu_feed_gyro(&moves, raw[0], raw[1], raw[2]);
}

/* Records all moves again, in the structure of the library. */
static invcal_status make_moves(gyro_fit *g, replay *r, long lag, const double bias[3], double unit)
{
    invcal_calibration nominal = {.offset = {0}};
    const gyro_log *log = g->log;
    size_t next = 0;
    double zero[3];

    gyro_axes(g->axes, bias, zero);
    for (unsigned k = 0; k < 3; k++) {
        nominal.offset[k] = zero[k] / unit;
        nominal.matrix[k][k] =
            g->rate_unit > 0 ? g->rate_unit * unit : ldexp(RATE_RANGE_DEFAULT, -COUNT_BITS);
    }
    moves.rests = 0;
    invcal_status status = invcal_session_init(&moves.session, sizeof moves.session, 1, log->rate);
    if (status == INVCAL_OK) {
        status = invcal_imu_init_nominal(&moves, sizeof moves, &nominal, log->rate);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    set_rails(g, unit);
    while (r->i <= log->samples) {
        const long reading_end =
            r->i < log->samples ? (long)log->sample[r->i].reading_end + lag : 0;
        while ((long)next < reading_end && next < log->readings) {
            feed(g, &log->reading[next++], unit);
        }
        const invcal_event event = replay_step(r);
        if (event != INVCAL_NOTHING) {
            moves.session.rests = r->rests;
            invcali_imu_follow(&moves, event);
        }
    }
    return INVCAL_OK;
}

/* Of the two rests of a move, finds the one in which the device turned: its bias is farther from
 * the median. */
static void find_turned(const gyro_fit *g, const double bias[3], gyro_move *m)
{
    m->rate = -1;
    for (unsigned k = m->to - 1; k <= m->to; k++) {
        double square = 0;
        for (unsigned i = 0; i < 3; i++) {
            square += pow(g->rate_unit * (g->rest[k].bias[i] - bias[i]), 2);
        }
        if (sqrt(square) > m->rate) {
            m->turned = k;
            m->rate = sqrt(square);
        }
    }
}

/* Lists the moves with the rests they led to, and whether they are used. The last rests of
 * moves.rest and g->rest are the same. */
static void list_moves(gyro_fit *g, long lag, const double bias[3])
{
    const unsigned first = g->rests - moves.rests;

    g->moves = 0;
    for (unsigned i = 1; i < moves.rests && g->rests >= moves.rests; i++) {
        gyro_move *m = &g->move[g->moves++];
        size_t begin;
        size_t end;
        *m = (gyro_move){.to = first + i, .angle = NUMBER_UNKNOWN, .residual = NUMBER_UNKNOWN};
        gyro_between(g->log, lag, &g->rest[m->to - 1], &begin, &end);
        m->seconds = end > begin ? (double)(end - begin) / g->log->rate : 0;
        m->why = invcal_imu_move_reason(&moves, i);
        if (m->why == INVCAL_OK && (g->imu.left_out >> i & 1)) {
            m->why = INVCAL_MOVE_APART;
        } else if (m->why == INVCAL_OK && (g->imu.idle >> i & 1)) {
            m->why = INVCAL_REST_SAME;
        } else if (m->why == INVCAL_REST_DRIFT) {
            find_turned(g, bias, m);
        }
    }
}

/* The g-sensitivity of the calibrated rate; that of the library is of the nominal rate. */
static void calibrate_g(gyro_fit *g)
{
    for (unsigned i = 0; i < 9; i++) {
        const double *m = g->m[i / 3];
        for (unsigned k = 0; k < 3; k++) {
            g->g[i / 3][i % 3] += m[k] * g->imu.slope[k][i % 3];
        }
    }
}

/* Converts the calibration to the raw axes of the gyroscope and to input units. */
static void finish(gyro_fit *g, double unit)
{
    const invcal_calibration c = g->imu.gyro;

    for (unsigned i = 0; i < 9; i++) {
        g->m[i / 3][i % 3] = c.matrix[i / 3][i % 3] / moves.nominal.matrix[i % 3][i % 3];
    }
    if (g->imu.g_is_used) {
        calibrate_g(g);
    }
    for (unsigned k = 0; k < 3; k++) {
        const unsigned of = (unsigned)abs(g->axes[k]) - 1;
        const double sign = g->axes[k] < 0 ? -1 : 1;
        g->calibration.offset[of] = sign * c.offset[k] * unit;
        for (unsigned i = 0; i < 3; i++) {
            g->calibration.matrix[i][of] = sign * c.matrix[i][k] / unit;
        }
    }
    g->interval = invcal_coverage(g->imu.dof);
}

/* The means of the rests; raw: space for them. */
static invcal_positions positions_of(const gyro_fit *g, const positions *p,
                                     const invcal_calibration *start,
                                     invcal_vector raw[INVCAL_MAX_MOVES])
{
    for (unsigned i = 0; i < g->rests; i++) {
        memcpy(raw[i].v, &p->mean[3 * (size_t)g->rest[i].position], sizeof raw[i].v);
    }
    return (invcal_positions){.mean = raw, .count = g->rests, .nominal = start};
}

static invcal_status solve(gyro_fit *g, const positions *p, const invcal_calibration *start)
{
    invcal_vector raw[INVCAL_MAX_MOVES];
    const invcal_positions rests = positions_of(g, p, start, raw);

    return invcali_imu_solve_of(&moves, &rests, NULL, &g->imu);
}

int gyro_turns(const gyro_fit *g, const positions *p, const invcal_calibration *start,
               invcali_turns *out)
{
    invcal_vector raw[INVCAL_MAX_MOVES];
    const invcal_positions rests = positions_of(g, p, start, raw);

    return g->moves > 0 && invcali_turns_after(out, &moves, &rests, NULL) == INVCAL_OK;
}

/* The delay of the readings; 0 unless the rests are quieter with it. Fills rests and bias
 * accordingly. */
static long find_lag(gyro_fit *g, const positions *p, const invcal_calibration *start,
                     double bias[3])
{
    long lag = gyro_find_lag(g->log);

    fill_rests(g, 0, p, start);
    find_median_bias(g, bias);
    if (lag != 0 && square_at_rest(g, 0, bias) > MOTION_RATIO * square_at_rest(g, lag, bias)) {
        fill_rests(g, lag, p, start);
        find_median_bias(g, bias);
        return lag;
    }
    return 0;
}

int gyro_make(gyro_fit *g, const gyro_log *log, const gyro_options *options, unsigned rate,
              const double *clip, const positions *p, const rejection *kept,
              const invcal_calibration *start)
{
    static replay r; /* too large for the stack */
    gyro_options with_axes = *options;
    double bias[3];

    *g = (gyro_fit){.has_readings = log->readings > 0, .log = log};
    for (int8_t i = 0; i < 3 && options->axes[0] == 0; i++) {
        with_axes.axes[i] = (int8_t)(i + 1);
    }
    if (!g->has_readings || !check_readings(g)) {
        return EXIT_GOOD;
    }
    const double unit = find_count(log);
    begin_replay(&r, log, rate, clip, p, kept);
    find_rests(g, &r);
    if (g->rests < RESTS_MIN) {
        gyro_say_status(g, INVCAL_TOO_FEW);
        return EXIT_GOOD;
    }
    if (!check_end(g, p)) {
        return EXIT_GOOD;
    }
    if (!start) {
        gyro_say_no_start(g);
        return EXIT_GOOD;
    }
    const long lag = find_lag(g, p, start, bias);
    g->lag = (double)lag / log->rate;
    drop_false_rails(g, bias);
    const int fits = find_unit_and_axes(g, &with_axes, lag, bias);
    begin_replay(&r, log, rate, clip, p, kept);
    invcal_status status = make_moves(g, &r, lag, bias, unit);
    status = status == INVCAL_OK && fits ? solve(g, p, start) : status;
    list_moves(g, lag, bias);
    if (!fits) {
        gyro_add_reasons(g);
        return EXIT_GOOD;
    }
    if (status != INVCAL_OK) {
        gyro_say_status(g, status);
        return EXIT_GOOD;
    }
    finish(g, unit);
    gyro_measure(g, lag, p);
    return EXIT_GOOD;
}
