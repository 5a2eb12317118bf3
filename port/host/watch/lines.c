/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "watch/lines.h"

#include <unistd.h>

#include "text/paint.h"

static watch_news shown; /* on the line that changes */

static int is_terminal(const watch_state *now)
{
    return isatty(fileno(now->talk));
}

/* A line that stays; what was on the changing line goes. */
static void end_line(const watch_state *now)
{
    if (is_terminal(now)) {
        fprintf(now->talk, "\r%60s\r", "");
    }
}

/* The changing line: only on a terminal, and only if there is news. */
static void show(const watch_state *now, watch_news what)
{
    if (now->is_refused || (what == WATCH_MOVING && shown == what)) {
        return;
    }
    shown = what;
    end_line(now);
    if (what == WATCH_MOVING) {
        fprintf(now->talk, "  moving");
    } else if (now->phase == WATCH_READY) {
        fprintf(now->talk, "  %s", now->good);
    } else {
        fprintf(now->talk, "  hold still ... %3u %%", now->progress);
    }
}

static void say_begun(const watch_state *now)
{
    shown = WATCH_BEGUN;
    if (now->hold > 0) {
        fprintf(now->talk, "each position: %.3g s by the noise measured", now->hold);
        if (now->hold_floor > 0) {
            fprintf(now->talk, "; longer does not help: a mean is good to %.2g", now->hold_floor);
        }
        fprintf(now->talk, "\n");
    }
    fprintf(now->talk, "%s: %s\n", now->name, now->recognised);
}

/* Where to turn next, if there is anywhere. */
static void say_next(const watch_state *now)
{
    if (*now->next) {
        fprintf(now->talk, "next: %s\n", now->next);
    }
}

/* How exactly everything is known, once it can be told. */
static void say_sigma(const watch_state *now)
{
    for (unsigned k = 0; k < WATCH_KINDS && watch_knows_sigma(now); k++) {
        const told_unit unit = watch_unit(now, k);
        fprintf(now->talk, "%s%s ± %.2g %s", k == 0 ? "; to 95 %: " : ", ", watch_kinds[k],
                unit.scale * watch_interval(now, k), unit.unit);
    }
}

static void say_wrong(const watch_state *now)
{
    if (now->astray > 0) {
        fprintf(now->talk, "%swrong position:%s %s. It is used all the same\n",
                paint_on(now->talk, PAINT_YELLOW), paint_off(now->talk), now->wrong);
    }
    if (now->astray == WATCH_ASTRAY) {
        fprintf(now->talk,
                "%u wrong in a row: are alpha and beta exchanged, is the sense of one reversed, "
                "or its zero elsewhere?\n",
                WATCH_ASTRAY);
    }
}

static void say_end(const watch_state *now, const char *word, const char *what)
{
    fprintf(now->talk, "%s%s%s %s; end the stream (Ctrl-C)\n", paint_on(now->talk, PAINT_GREEN),
            word, paint_off(now->talk), what);
}

static void say_taken(const watch_state *now)
{
    end_line(now);
    fprintf(now->talk, "position %u taken", now->taken);
    say_sigma(now);
    fprintf(now->talk, "\n");
    say_wrong(now);
    if (now->outcome == WATCH_ENOUGH) {
        say_end(now, "enough:", "what is wanted is reached");
    } else if (now->outcome == WATCH_FINISHED) {
        say_end(now, "finished:", "the program is complete");
    }
}

static void say_refused(const watch_state *now)
{
    end_line(now);
    fprintf(now->talk, "%srefused:%s %s\n", paint_on(now->talk, PAINT_RED), paint_off(now->talk),
            now->refusal);
}

static void say_ended(const watch_state *now)
{
    end_line(now);
    if (*now->missing) {
        fprintf(now->talk, "of the program not visited: %s\n", now->missing);
    }
    fprintf(now->talk, "\n");
}

void lines_tell(const watch_state *now, watch_news what)
{
    switch (what) {
    case WATCH_BEGUN:
        say_begun(now);
        say_next(now);
        break;
    case WATCH_READY:
        if (!is_terminal(now)) {
            fprintf(now->talk, "%s\n", now->good);
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
    case WATCH_PASSED:
        return;
    default:
        break;
    }
    if ((what == WATCH_MOVING || what == WATCH_SETTLING || what == WATCH_READY) &&
        is_terminal(now)) {
        show(now, what);
    }
    fflush(now->talk);
}
