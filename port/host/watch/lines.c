/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "watch/lines.h"

#include <unistd.h>

#include "text/paint.h"
#include "text/plain.h"
#include "text/wrapped.h"

#define SIGMA_MAX 200

static watch_event shown; /* on the overwritten line */

static int is_terminal(const watch_state *now)
{
    return isatty(fileno(now->out));
}

/* Clears the overwritten line; a permanent one follows. */
static void end_line(const watch_state *now)
{
    if (is_terminal(now)) {
        fprintf(now->out, "\r%60s\r", "");
    }
}

/* The overwritten line, only on a terminal. */
static void show(const watch_state *now, watch_event event)
{
    if (now->is_refused || (event == WATCH_MOVING && shown == event)) {
        return;
    }
    shown = event;
    end_line(now);
    if (event == WATCH_MOVING) {
        fprintf(now->out, "  moving");
    } else if (now->phase == WATCH_READY) {
        fprintf(now->out, "  %s", now->good);
    } else {
        fprintf(now->out, "  hold still ... %3u %%", now->progress);
    }
}

static void say_begun(const watch_state *now)
{
    char limit[80] = "";
    char name[PLAIN_MAX];

    shown = WATCH_BEGUN;
    if (now->hold > 0) {
        if (now->hold_floor > 0) {
            snprintf(limit, sizeof limit, "; longer does not help: the sigma of a mean is %.2g",
                     now->hold_floor);
        }
        wrapped_printf(now->out, 2, "hold each position for %.3g s, from the measured noise%s",
                       now->hold, limit);
    }
    wrapped_printf(now->out, 0, "%s: %s", plain_copy(now->name, name), now->recognised);
    if (now->is_magnetometer) {
        wrapped_printf(now->out, 0, "turn it slowly until every side has pointed along the field");
    }
}

/* Where to turn next, if there is a next position. */
static void say_next(const watch_state *now)
{
    if (*now->next) {
        wrapped_printf(now->out, 6, "next: %s", now->next);
    }
}

/* The uncertainties, once they are known; else "". */
static const char *sigma_text(const watch_state *now, char text[SIGMA_MAX])
{
    size_t used = 0;

    text[0] = '\0';
    for (unsigned k = 0; k < WATCH_KINDS && watch_knows_sigma(now) && used < SIGMA_MAX; k++) {
        const display_unit unit = watch_unit(now, k);
        used += (size_t)snprintf(text + used, SIGMA_MAX - used, "%s%s ± %.2g %s",
                                 k == 0 ? "; 95 %: " : ", ", watch_kinds[k],
                                 unit.scale * watch_interval(now, k), unit.unit);
    }
    return text;
}

static void say_wrong(const watch_state *now)
{
    if (now->wrong_count > 0) {
        wrapped_printf(now->out, 2, "%swrong position:%s %s. It is used anyway",
                       paint_on(now->out, PAINT_YELLOW), paint_off(now->out), now->wrong);
    }
    if (now->wrong_count == WATCH_WRONG_HINT) {
        wrapped_printf(now->out, 2,
                       "%u wrong in a row: check for alpha and beta exchanged, a reversed sense, "
                       "or a shifted zero",
                       WATCH_WRONG_HINT);
    }
}

static void say_end(const watch_state *now, const char *word, const char *what)
{
    fprintf(now->out, "%s%s%s %s; end the stream (Ctrl-C)\n", paint_on(now->out, PAINT_GREEN), word,
            paint_off(now->out), what);
}

static void say_taken(const watch_state *now)
{
    char text[SIGMA_MAX];

    end_line(now);
    if (now->is_magnetometer) {
        wrapped_printf(now->out, 2, "%u of 18 directions%s", now->taken, sigma_text(now, text));
    } else {
        wrapped_printf(now->out, 2, "position %u taken%s", now->taken, sigma_text(now, text));
    }
    say_wrong(now);
    if (*now->gyro.text) {
        wrapped_line(now->out, 0, 2, now->gyro.text);
    }
    if (*now->gyro.refused) {
        wrapped_printf(now->out, 2, "%sgyroscope:%s %s", paint_on(now->out, PAINT_YELLOW),
                       paint_off(now->out), now->gyro.refused);
    }
    if (now->outcome == WATCH_GOAL_REACHED) {
        say_end(now, "enough:", watch_has_goal(now) ? "the target is reached" : "it is good");
    } else if (now->outcome == WATCH_FINISHED) {
        say_end(now, "finished:", "the program is complete");
    }
}

static void say_refused(const watch_state *now)
{
    end_line(now);
    wrapped_printf(now->out, 2, "%s%s%s %s", paint_on(now->out, PAINT_RED),
                   now->is_magnetometer ? "disturbed:" : "refused:", paint_off(now->out),
                   now->refusal);
}

static void say_ended(const watch_state *now)
{
    end_line(now);
    if (*now->missing) {
        wrapped_printf(now->out, 2, "positions of the program not visited: %s", now->missing);
    }
    fprintf(now->out, "\n");
}

void lines_update(const watch_state *now, watch_event event)
{
    switch (event) {
    case WATCH_BEGUN:
        say_begun(now);
        say_next(now);
        break;
    case WATCH_READY:
        if (!is_terminal(now)) {
            wrapped_line(now->out, 0, 2, now->good);
        }
        break;
    case WATCH_TAKEN:
        say_taken(now);
        say_next(now);
        break;
    case WATCH_REFUSED:
        say_refused(now);
        break;
    case WATCH_ENDED:
        say_ended(now);
        break;
    case WATCH_BROKEN:
        end_line(now);
        break;
    case WATCH_TICK:
        return;
    default:
        break;
    }
    if ((event == WATCH_MOVING || event == WATCH_SETTLING || event == WATCH_READY) &&
        is_terminal(now)) {
        show(now, event);
    }
    fflush(now->out);
}
