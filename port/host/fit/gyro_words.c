/* SPDX-License-Identifier: MIT
 *
 * Why there is no calibration of the gyroscope, and what to do, in words.
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "fit/gyro.h"
#include "fit/nominal.h"
#include "text/append.h"
#include "text/figure.h"
#include "text/parameter.h"

static const char more_moves[] =
    "make more moves, about each of the three axes: twelve quarter turns "
    "through the six faces determine everything";
static const char check_both[] =
    "check that both are of one device and one clock, and that no readings "
    "are clipped or lost";

void gyro_refuse(gyro_fit *g, const char *word, const char *format, ...)
{
    va_list arguments;

    g->word = word;
    va_start(arguments, format);
    vsnprintf(g->reason, sizeof g->reason, format, arguments);
    va_end(arguments);
}

void gyro_advise(gyro_fit *g, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(g->remedy, sizeof g->remedy, format, arguments);
    va_end(arguments);
}

const char *gyro_reason(invcal_status why)
{
    return why == INVCAL_MOVE_APART   ? "contradicts the others"
           : why == INVCAL_REST_DRIFT ? "the device turned in a rest"
           : why == INVCAL_REST_SAME  ? "no turn"
                                      : invcal_status_text(why);
}

const char *gyro_move_reason(const gyro_fit *g, const gyro_move *m, char text[GYRO_REASON_MAX])
{
    char number[FIGURE_MAX];

    if (m->why == INVCAL_REST_DRIFT) {
        snprintf(text, GYRO_REASON_MAX, "the device turned at %s °/s in the rest at position %u",
                 figure_digits(m->rate / UNIT_DEGREE, 2, number), g->rest[m->turned].position + 1);
    } else {
        snprintf(text, GYRO_REASON_MAX, "%s", gyro_reason(m->why));
    }
    return text;
}

static unsigned count_why(const gyro_fit *g, invcal_status why)
{
    unsigned count = 0;

    for (unsigned i = 0; i < g->moves; i++) {
        count += g->move[i].why == why;
    }
    return count;
}

void gyro_add_reasons(gyro_fit *g)
{
    for (unsigned i = 0; i < g->moves; i++) {
        const invcal_status why = g->move[i].why;
        int is_first = why != INVCAL_OK;
        for (unsigned k = 0; k < i; k++) {
            is_first = is_first && g->move[k].why != why;
        }
        if (is_first) {
            append(g->reason, sizeof g->reason, "; unusable %u: %s", count_why(g, why),
                   gyro_reason(why));
        }
    }
}

/* Advice for the reason that most moves share, if any is unusable; else, or after it, to make
 * more. */
static void advise_moves(gyro_fit *g)
{
    static const struct {
        invcal_status why;
        const char *text;
    } known[] = {
        {INVCAL_REST_CLIPPED, "turn more slowly, or choose a larger range of the gyroscope"},
        {INVCAL_MOVE_GAP, "record all samples of the moves"},
        {INVCAL_MOVE_LONG, "take at most ten seconds for a move"},
        {INVCAL_REST_DRIFT, "keep the device still in each rest, on a table"},
    };
    unsigned most = 0;
    const char *first = NULL;

    for (unsigned k = 0; k < sizeof known / sizeof *known; k++) {
        const unsigned count = count_why(g, known[k].why);
        first = count > most ? known[k].text : first;
        most = count > most ? count : most;
    }
    gyro_advise(g, "%s%s%s", first ? first : "", first ? "; " : "", more_moves);
}

void gyro_refuse_open(gyro_fit *g)
{
    char list[PARAMETER_LIST_MAX];

    gyro_refuse(g, "undetermined", "the moves leave parameters undetermined: %s",
                parameter_list_imu(g->imu.weak, list, sizeof list));
    gyro_add_reasons(g);
    advise_moves(g);
}

void gyro_say_no_start(gyro_fit *g)
{
    gyro_refuse(
        g, "too few",
        "the %u rest%s between the moves %s not show the accelerometer's zero, and so not which "
        "way was up",
        g->rests, g->rests == 1 ? "" : "s", g->rests == 1 ? "does" : "do");
    gyro_advise(g,
                "%s turn about all three axes, to other sides, or state --zero and --lsb of the "
                "accelerometer",
                g->rests < NOMINAL_SPHERE ? "hold it still in four directions or more, and"
                                          : "the rests are nearly in a plane:");
}

/* No convergence, or residuals that no noise has. The search found these axes to fit: that leaves
 * moves which are too few, or a part of them that are wrong. */
static void say_apart(gyro_fit *g, invcal_status status)
{
    const unsigned used = count_why(g, INVCAL_OK);

    if (status == INVCAL_MOUNTING && used < INVCAL_TOUR) {
        gyro_refuse(g, "undetermined", "%u usable move%s do%s not determine both sensors", used,
                    used == 1 ? "" : "s", used == 1 ? "es" : "");
        gyro_add_reasons(g);
        advise_moves(g);
        return;
    }
    gyro_refuse(g, "apart", "%s", invcal_status_text(status));
    gyro_add_reasons(g);
    gyro_advise(g, "%s", check_both);
}

void gyro_say_status(gyro_fit *g, invcal_status status)
{
    const unsigned used = count_why(g, INVCAL_OK);

    switch (status) {
    case INVCAL_TOO_FEW:
        gyro_refuse(g, "too few", "%u usable move%s between rests %s too few", used,
                    used == 1 ? "" : "s", used == 1 ? "is" : "are");
        gyro_add_reasons(g);
        advise_moves(g);
        break;
    case INVCAL_UNDETERMINED:
        gyro_refuse_open(g);
        break;
    default:
        say_apart(g, status);
        break;
    }
}

void gyro_say_misfit(gyro_fit *g, double misfit)
{
    const int is_sure = g->rests > INVCAL_TOUR;

    gyro_refuse(
        g, is_sure ? "apart" : "undetermined",
        "the turns of the gyroscope differ from those of the accelerometer by %.2g degrees in a "
        "move, for any assignment of its axes%s",
        misfit / UNIT_DEGREE, is_sure ? "" : "; these moves are too few to show why");
    gyro_advise(g, "%s", is_sure ? check_both : more_moves);
}

void gyro_say_unclear(gyro_fit *g)
{
    gyro_refuse(
        g, "axes",
        "the gyroscope's axes are not the accelerometer's, and these moves do not show which "
        "they are");
    gyro_advise(g, "%s, or state --gyro-axes", more_moves);
}
