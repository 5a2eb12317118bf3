/* SPDX-License-Identifier: MIT */
#include "watch/gyro.h"

#include <math.h>
#include <string.h>

#define RESTS_MIN 5u      /* with fewer, neither unit nor axes can be found */
#define CERTAIN_RESTS 12u /* from here on, an error is certain */
#define DOF_MIN 6u        /* redundant equations */
#define NEAR_COSINE 0.97  /* of 14 degrees */

/* Errors that more moves do not correct, and that are reported at once. */
static int is_mistake(const char *word)
{
    return strcmp(word, "axes") == 0 || strcmp(word, "unit") == 0 || strcmp(word, "stuck") == 0;
}

/* Half the 95 % interval of the worst of these parameters. */
static double worst_interval(const gyro_fit *g, int is_scale)
{
    double max = 0;

    for (unsigned i = 0; i < INVCAL_GYRO_PARAMETERS; i++) {
        max = (i % 4 == 0) == is_scale ? fmax(max, g->imu.sigma[INVCAL_GYRO_XX + i]) : max;
    }
    return g->interval * max;
}

/* ---- moves ------------------------------------------------------------------------------------- */

static unsigned count_moves(const gyro_fit *g)
{
    unsigned count = 0;

    for (unsigned i = 0; i < g->moves; i++) {
        count += g->move[i].why == INVCAL_OK;
    }
    return count;
}

static int is_reported(const watch_gyro *w, unsigned position)
{
    for (unsigned i = 0; w->reported[i] != 0; i++) {
        if (w->reported[i] == position) {
            return 1;
        }
    }
    return 0;
}

/* Refused moves that have not been reported yet. */
static void find_refused(watch_gyro *w, const gyro_fit *g)
{
    unsigned now[INVCAL_MAX_MOVES + 1] = {0};
    unsigned count = 0;
    char why[GYRO_REASON_MAX];

    w->refused[0] = '\0';
    for (unsigned i = 0; i < g->moves; i++) {
        const gyro_rest *rest = &g->rest[g->move[i].to];
        const size_t length = strlen(w->refused);
        if (g->move[i].why == INVCAL_OK) {
            continue;
        }
        now[count++] = rest->position + 1;
        if (!is_reported(w, rest->position + 1)) {
            snprintf(w->refused + length, sizeof w->refused - length,
                     "%sthe move from position %u to %u is refused: %s", length > 0 ? "; " : "",
                     rest[-1].position + 1, rest->position + 1,
                     gyro_move_reason(g, &g->move[i], why));
        }
    }
    memcpy(w->reported, now, sizeof now);
}

/* ---- turns ------------------------------------------------------------------------------------- */

/* Adds a rest, and the shortest turn to it. If that is not unique, begins again with this rest. */
static void add_rest(watch_gyro *w, const double up[3])
{
    invcal_turn turn;

    if (!w->has_turns || invcali_turn_to(w->turns.up, up, &turn) != INVCAL_OK ||
        invcali_turns_add(&w->turns, &turn) != INVCAL_OK) {
        w->has_turns = invcali_turns_begin(&w->turns, up, NULL, 0) == INVCAL_OK;
    }
}

/* Replaces a direction by the nearest face, edge or corner of a cube, if it is near one. */
static void snap(double up[3])
{
    double best[3] = {0, 0, 0};
    double max = NEAR_COSINE;

    for (int i = 0; i < 27; i++) {
        const int v[3] = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        const double length = sqrt((double)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
        const double cosine = (v[0] * up[0] + v[1] * up[1] + v[2] * up[2]) / length;
        for (unsigned k = 0; k < 3 && cosine > max; k++) { /* NaN is not */
            best[k] = v[k] / length;
        }
        max = cosine > max ? cosine : max;
    }
    if (max > NEAR_COSINE) {
        memcpy(up, best, sizeof best);
    }
}

int watch_gyro_next(const watch_gyro *w, const double *held, double target[3],
                    char text[TURNS_WORDS_MAX])
{
    watch_gyro soon = *w;
    invcal_turn turn;

    if (held) {
        add_rest(&soon, held);
    }
    if (!soon.has_turns || w->is_mistake) {
        return 0;
    }
    snap(soon.turns.up);
    invcali_turns_next(&soon.turns, &turn);
    memcpy(target, turn.up, sizeof turn.up);
    (void)turns_words(&turn, soon.turns.up, text);
    return 1;
}

/* ---- the verdict so far ------------------------------------------------------------------------ */

static void write_verdict(watch_gyro *w, const gyro_fit *g, unsigned rests)
{
    char moves[80];

    w->is_mistake = g->word && (rests >= CERTAIN_RESTS || is_mistake(g->word));
    snprintf(moves, sizeof moves, "gyroscope: %u of %u moves", count_moves(g), g->moves);
    if (w->is_mistake) {
        snprintf(w->text, sizeof w->text, "gyroscope: %.*s", WATCH_GYRO_MAX - 20, g->reason);
    } else if (g->word) {
        snprintf(w->text, sizeof w->text, "%s, too few so far; turn about all three axes",
                 g->moves > 0 ? moves : "gyroscope: no moves");
    } else {
        snprintf(w->text, sizeof w->text, "%s; scale ± %.2g %%, cross ± %.2g degrees%s", moves,
                 100 * worst_interval(g, 1), worst_interval(g, 0) / UNIT_DEGREE,
                 g->imu.weak ? "; turn about other axes, too" : "");
        w->is_good = g->imu.verdict == INVCAL_GOOD && g->imu.dof >= DOF_MIN;
    }
}

void watch_gyro_take(watch_gyro *w, const gyro_log *t, const gyro_options *options, unsigned rate,
                     const double *clip, const positions *p, const invcal_calibration *start,
                     const double up[3])
{
    static gyro_fit g; /* large */
    const rejection none = {0};

    w->text[0] = '\0';
    w->refused[0] = '\0';
    w->is_good = 0;
    if (t->readings == 0 || p->count < RESTS_MIN ||
        gyro_make(&g, t, options, rate, clip, p, &none, start) || !g.has_readings) {
        add_rest(w, up);
        return;
    }
    find_refused(w, &g);
    write_verdict(w, &g, p->count);
    if (gyro_turns(&g, p, start, &w->turns)) {
        w->has_turns = 1;
    } else {
        add_rest(w, up);
    }
}
