/* SPDX-License-Identifier: MIT */
#define _DEFAULT_SOURCE /* struct winsize */
#include "watch/screen.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include "text/figure.h"
#include "watch/map.h"

#define TEXT_MAX 512
#define NEAR 10.0 /* degrees to go that are near enough */
#define PAUSE                                                                                      \
    0.02          /* seconds of the clock from frame to frame, at least: a file is read faster than
                       anybody sees */
#define LEAST 9u  /* positions that a calibration takes */
#define WORDS 10u /* column of what is said */
#define HALF 31u  /* columns of a half of the sphere, with its axes */
#define PANEL 60u /* first column of what is known */
#define BAR 19u   /* columns of a bar, */
#define DECADES 4.0 /* which goes from */
#define FINEST 1e-5 /* this to 0.1: over the field, of the scale, rad */

/* Where everything stands. */
enum { TITLE = 0, LOG = 1, PHASE = 2, LAST = 3, MAP = 5, NOW = 18, NEXT = 19, SO_FAR = 21 };

static unsigned say(canvas *c, unsigned line, unsigned left, int colour, const char *text)
{
    return canvas_text(c, line, left, CANVAS_COLUMNS, colour, text);
}

/* ---- the log ----------------------------------------------------------------------------------- */

static void draw_title(canvas *c, const watch_state *now)
{
    const unsigned long seconds = (unsigned long)fmin(now->seconds, 1e9);
    char right[TEXT_MAX];
    char skipped[TEXT_MAX] = "";

    snprintf(right, sizeof right, "%lu:%02lu   %u position%s", seconds / 60, seconds % 60,
             now->taken, now->taken == 1 ? "" : "s");
    const unsigned from = CANVAS_COLUMNS - canvas_width(right);
    const unsigned at = canvas_text(c, TITLE, 0, from - 2, PAINT_BOLD, "invcal watch: ");
    (void)canvas_text(c, TITLE, at, from - 2, PAINT_BOLD, now->name);
    (void)say(c, TITLE, from, PAINT_BOLD, right);
    if (now->skipped > 0) {
        snprintf(skipped, sizeof skipped, "%lu malformed line%s skipped", now->skipped,
                 now->skipped == 1 ? "" : "s");
    }
    const unsigned end = CANVAS_COLUMNS - canvas_width(skipped);
    (void)canvas_text(c, LOG, 0, *skipped ? end - 2 : end, CANVAS_PLAIN, now->recognised);
    (void)say(c, LOG, end, PAINT_YELLOW, skipped);
}

/* ---- what to do now ---------------------------------------------------------------------------- */

/* A part of `columns`, to an eighth of one; `rest` where it is empty. */
static void draw_bar(canvas *c, unsigned line, unsigned left, unsigned width, double share,
                     int colour, const char *rest)
{
    static const char *const eighth[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉", "█"};
    const unsigned filled = (unsigned)floor(8 * width * fmax(0, fmin(1, share)) + 0.5);

    for (unsigned i = 0; i < width; i++) {
        const unsigned here = filled > 8 * i ? filled - 8 * i : 0;
        const char *glyph = here == 0 ? rest : eighth[here < 8 ? here : 8];
        canvas_put(c, line, left + i, here == 0 ? CANVAS_PLAIN : colour, glyph);
    }
}

static void draw_order(canvas *c, int colour, const char *order, const char *text)
{
    (void)canvas_text(c, PHASE, 0, WORDS + 4, colour, order);
    (void)say(c, PHASE, WORDS + 4, CANVAS_PLAIN, text);
}

static void draw_moving(canvas *c, const watch_state *now)
{
    const double to_go = watch_to_go(now);
    char text[TEXT_MAX] = "";

    if (to_go >= 0) {
        snprintf(text, sizeof text, "%s%.0f degrees to go",
                 now->is_good ? "with Ctrl-C, or go on: " : "", to_go);
    }
    if (!now->has_target) {
        draw_order(c, PAINT_GREEN, "FINISHED", "the program is complete: end it with Ctrl-C");
    } else if (to_go >= 0 && to_go <= NEAR) {
        draw_order(c, PAINT_BOLD, "THERE", "hold it still");
    } else if (now->is_good) {
        draw_order(c, PAINT_GREEN, "YOU MAY STOP", text);
    } else {
        draw_order(c, PAINT_BOLD, "TURN IT", text);
    }
}

static void draw_phase(canvas *c, const watch_state *now)
{
    char text[TEXT_MAX];

    if (now->phase == WATCH_ENDED) {
        draw_order(c, PAINT_BOLD, "ENDED", "the stream has come to its end");
    } else if (now->is_refused) {
        draw_order(c, PAINT_RED, "NOT GOOD", now->refusal);
    } else if (now->phase == WATCH_READY) {
        draw_order(c, PAINT_GREEN, "MOVE ON", now->good);
    } else if (now->phase == WATCH_SETTLING) {
        snprintf(text, sizeof text, "%3u %%", now->progress);
        draw_order(c, PAINT_YELLOW, "HOLD STILL", text);
        draw_bar(c, PHASE, WORDS + 11, 40, now->progress / 100.0, PAINT_YELLOW, "·");
    } else {
        draw_moving(c, now);
    }
}

/* What became of the last rest. */
static void draw_last(canvas *c, const watch_state *now)
{
    char text[TEXT_MAX];
    int colour = CANVAS_PLAIN;

    if (now->last == WATCH_REFUSED && !now->is_refused) {
        colour = PAINT_RED;
        snprintf(text, sizeof text, "The last rest is refused: %s.", now->refusal);
    } else if (now->last == WATCH_TAKEN && now->astray > 0) {
        colour = PAINT_YELLOW;
        snprintf(text, sizeof text, "Position %u is taken: %s.", now->taken, now->wrong);
    } else if (now->last == WATCH_TAKEN) {
        snprintf(text, sizeof text, "Position %u is taken.", now->taken);
    } else {
        return;
    }
    canvas_wrapped(c, LAST, 2, 0, colour, text);
}

/* ---- where ------------------------------------------------------------------------------------- */

static void draw_mark(canvas *c, const double up[3], int colour, const char *mark)
{
    const map_place at = map_find(up);

    canvas_put(c, MAP + 1 + at.line, HALF * at.half + 3 + at.column, colour, mark);
}

static void draw_half(canvas *c, const watch_state *now, unsigned half)
{
    const unsigned left = HALF * half;
    const unsigned middle = left + 3 + MAP_COLUMNS / 2 - 1;
    const unsigned equator = MAP + 1 + MAP_LINES / 2;

    map_draw(c, MAP + 1, left + 3, half, now->direction, now->covered);
    (void)say(c, MAP, left + 3, PAINT_BOLD, half ? "-z up" : "+z up");
    (void)say(c, MAP, middle, CANVAS_PLAIN, "+y");
    (void)say(c, MAP + 1 + MAP_LINES, middle, CANVAS_PLAIN, "-y");
    (void)say(c, equator, left, CANVAS_PLAIN, "-x");
    (void)say(c, equator, left + 4 + MAP_COLUMNS, CANVAS_PLAIN, "+x");
}

static void draw_sphere(canvas *c, const watch_state *now)
{
    draw_half(c, now, 0);
    draw_half(c, now, 1);
    if (now->has_target) {
        draw_mark(c, now->target, PAINT_GREEN, "X");
    }
    if (now->has_up) {
        draw_mark(c, now->up, PAINT_YELLOW, "@");
    }
}

static void draw_where(canvas *c, const watch_state *now)
{
    char words[INVCAL_WORDS] = "not known";

    if (now->has_up) {
        (void)invcal_words(now->up, words);
    }
    (void)canvas_text(c, NOW, 0, WORDS, PAINT_YELLOW, "@ now");
    const unsigned at = say(c, NOW, WORDS, CANVAS_PLAIN, words);
    if (now->is_guess) {
        (void)say(c, NOW, at, CANVAS_PLAIN, "  (a guess: zero not known yet)");
    }
    (void)canvas_text(c, NEXT, 0, WORDS, PAINT_GREEN, "X next");
    canvas_wrapped(c, NEXT, 2, WORDS, CANVAS_PLAIN,
                   *now->next ? now->next : "nowhere: the program is complete");
}

/* ---- how well everything is known -------------------------------------------------------------- */

static double bar_share(double x)
{
    return log10(x / FINEST) / DECADES;
}

static void draw_known(canvas *c, unsigned line, const char *what, double interval, double wanted,
                       told_unit unit)
{
    const int is_known = interval > 0;
    const int is_reached = is_known && wanted > 0 && interval <= wanted;
    char text[TEXT_MAX];
    char number[FIGURE_MAX];

    snprintf(text, sizeof text, "%s %s %s", what, is_known ? "±" : "not known",
             is_known ? figure_digits(unit.scale * interval, 2, number) : "");
    const unsigned at =
        canvas_text(c, line, PANEL, CANVAS_COLUMNS, is_reached ? PAINT_GREEN : CANVAS_PLAIN, text);
    if (is_known) {
        (void)say(c, line, at + 1, is_reached ? PAINT_GREEN : CANVAS_PLAIN, unit.unit);
    }
    draw_bar(c, line + 1, PANEL, BAR, is_known ? bar_share(interval) : 1,
             is_reached ? PAINT_GREEN : CANVAS_PLAIN, "·");
    if (wanted > 0) {
        const double place = floor(BAR * fmax(0, fmin(1, bar_share(wanted))));
        canvas_put(c, line + 1, PANEL + (unsigned)fmin(place, BAR - 1), PAINT_BOLD, "|");
    }
}

static void draw_panel(canvas *c, const watch_state *now)
{
    unsigned line = MAP;
    int is_anything_wanted = now->need > 0;

    (void)say(c, line++, PANEL, PAINT_BOLD, "uncertainty, 95 %");
    for (unsigned k = 0; k < WATCH_KINDS; k++, line += 2) {
        draw_known(c, line, watch_kinds[k], watch_knows_sigma(now) ? watch_interval(now, k) : 0,
                   watch_wanted(now, k), watch_unit(now, k));
        is_anything_wanted = is_anything_wanted || now->target_sigma[k] > 0;
    }
    if (now->need > 0) {
        draw_known(c, line, "lengths", watch_knows_sigma(now) ? now->accuracy : 0, now->need,
                   watch_unit(now, 0));
        line += 2;
    }
    if (is_anything_wanted) {
        (void)say(c, line, PANEL, CANVAS_PLAIN, "| what is wanted");
    }
    (void)say(c, MAP + MAP_LINES, PANEL, CANVAS_PLAIN, "which side is up:");
    (void)say(c, MAP + MAP_LINES + 1, PANEL, CANVAS_PLAIN, "@ now X next ⣿ done");
    canvas_put(c, MAP + MAP_LINES + 1, PANEL + 13, CANVAS_PLAIN,
               "⣿"); /* wide, for all that is known */
}

/* ---- the verdict so far ------------------------------------------------------------------------ */

static const char *verdict_words(invcal_verdict verdict)
{
    static const char *const words[] = {
        [INVCAL_GOOD] = "Good so far; a few positions more have to confirm it",
        [INVCAL_NO_REDUNDANCY] = "No redundancy: nothing checks the result as yet; go on",
        [INVCAL_ROUGH] = "Rough: positions disagree by more than noise; go on",
        [INVCAL_DRIFTING] = "Drifting: the sensor drifts; let it warm up, or be quicker",
        [INVCAL_BENT] = "Bent: an axis is not linear, or has hysteresis",
        [INVCAL_WEAK] = "Weak: some parameter is badly determined as yet; go on",
    };
    return verdict <= INVCAL_WEAK ? words[verdict] : invcal_verdict_text(verdict);
}

/* Nothing can be solved yet. */
static const char *status_words(const watch_state *now, char text[TEXT_MAX])
{
    if (now->status == INVCAL_TOO_FEW) {
        snprintf(text, TEXT_MAX, "%u of at least %u positions; 12 to 18 are good", now->covered,
                 LEAST);
    } else if (now->status == INVCAL_UNDETERMINED) {
        snprintf(text, TEXT_MAX, "These directions leave parameters open; go on");
    } else {
        snprintf(text, TEXT_MAX, "No result: %s", invcal_status_text(now->status));
    }
    return text;
}

static unsigned count_bits(invcal_mask bits)
{
    unsigned count = 0;

    for (; bits; bits &= bits - 1) {
        count++;
    }
    return count;
}

static int is_good_but_for_the_target(const watch_state *now)
{
    const invcal_quality *q = &now->quality;

    return now->status == INVCAL_OK && q->verdict == INVCAL_GOOD;
}

static void draw_verdict(canvas *c, const watch_state *now)
{
    const unsigned left_out = now->status == INVCAL_OK ? count_bits(now->quality.left_out) : 0;
    char text[TEXT_MAX];
    char tail[TEXT_MAX] = "";
    unsigned at = WORDS;

    (void)canvas_text(c, SO_FAR, 0, WORDS, PAINT_BOLD, "so far");
    if (left_out > 0) {
        snprintf(tail, sizeof tail, "; %u position%s left out", left_out, left_out == 1 ? "" : "s");
    }
    if (now->is_good) {
        at = say(c, SO_FAR, at, PAINT_GREEN, "Good: you may stop (Ctrl-C)");
    } else {
        at = say(c, SO_FAR, at, is_good_but_for_the_target(now) ? PAINT_GREEN : CANVAS_PLAIN,
                 now->status == INVCAL_OK ? verdict_words(now->quality.verdict)
                                          : status_words(now, text));
    }
    (void)say(c, SO_FAR, at, CANVAS_PLAIN, tail);
}

/* ---- a frame ----------------------------------------------------------------------------------- */

const char *screen_frame(const watch_state *now, const char *line_end, char text[CANVAS_BYTES])
{
    static canvas c; /* large */

    canvas_clear(&c);
    draw_title(&c, now);
    draw_phase(&c, now);
    draw_last(&c, now);
    draw_sphere(&c, now);
    draw_panel(&c, now);
    draw_where(&c, now);
    draw_verdict(&c, now);
    return canvas_print(&c, now->talk, line_end, text);
}

/* ---- the terminal ------------------------------------------------------------------------------ */

static int is_large_enough(FILE *talk)
{
    struct winsize size;

    return ioctl(fileno(talk), TIOCGWINSZ, &size) == 0 && size.ws_row > CANVAS_LINES &&
           size.ws_col > CANVAS_COLUMNS;
}

int screen_is_possible(FILE *talk)
{
    const char *terminal = getenv("TERM");

    return talk == stdout && isatty(fileno(talk)) && terminal && *terminal != '\0' &&
           strcmp(terminal, "dumb") != 0 && strcmp(terminal, "linux") != 0 && is_large_enough(talk);
}

/* In one write, unless a signal comes between. */
static void put_out(FILE *talk, const char *text)
{
    size_t left = strlen(text);

    fflush(talk);
    while (left > 0) {
        const ssize_t written = write(fileno(talk), text, left);
        if (written < 0 && errno != EINTR) {
            return; /* what is printed at the end tells */
        }
        text += written > 0 ? written : 0;
        left -= written > 0 ? (size_t)written : 0;
    }
}

#define HOME "\033[H"
#define CLEAR_LINE "\033[K"
#define CLEAR_BELOW "\033[J"
#define HIDE_CURSOR "\033[?25l"
#define SHOW_CURSOR "\033[?25h"

static double clock_seconds(void)
{
    struct timespec t;

    return clock_gettime(CLOCK_MONOTONIC, &t) == 0 ? (double)t.tv_sec + 1e-9 * (double)t.tv_nsec
                                                   : 0;
}

static struct {
    int is_ringing; /* with the next frame */
    int has_rung;   /* for the rest that goes on */
    int is_good;    /* has been told */
    double drawn;   /* seconds of the clock */
} told;

/* A bell for each turn of things: the person looks at the device. */
static void listen(const watch_state *now, watch_news what)
{
    const int is_ready = now->phase == WATCH_READY && !now->is_refused && !told.has_rung;
    const int is_good = now->is_good && !told.is_good;

    told.is_ringing = told.is_ringing || is_ready || is_good || what == WATCH_REFUSED;
    told.has_rung = what != WATCH_TAKEN && what != WATCH_REFUSED && (told.has_rung || is_ready);
    told.is_good = now->is_good;
}

static void draw(const watch_state *now)
{
    static char frame[CANVAS_BYTES];
    static char text[CANVAS_BYTES + 64];

    snprintf(text, sizeof text, HIDE_CURSOR HOME "%s" CLEAR_BELOW SHOW_CURSOR "%s",
             is_large_enough(now->talk) ? screen_frame(now, CLEAR_LINE "\n", frame)
                                        : "the window is too small: 80 columns, 24 lines" CLEAR_LINE
                                          "\n",
             told.is_ringing ? "\a" : "");
    put_out(now->talk, text);
    told.is_ringing = 0;
    told.drawn = clock_seconds();
}

/* What stood on the screen is scrolled up, not drawn upon. */
static void begin(FILE *talk)
{
    memset(&told, 0, sizeof told);
    for (unsigned i = 0; i <= CANVAS_LINES; i++) {
        fputc('\n', talk);
    }
    put_out(talk, HOME CLEAR_BELOW);
}

void screen_tell(const watch_state *now, watch_news what)
{
    if (what == WATCH_BEGUN) {
        begin(now->talk);
    }
    listen(now, what);
    if (what == WATCH_ENDED ||
        (what == WATCH_PASSED && (told.is_ringing || clock_seconds() - told.drawn >= PAUSE))) {
        draw(now);
    }
    if (what == WATCH_ENDED && *now->missing) {
        fprintf(now->talk, "of the program not visited: %s\n", now->missing);
    }
    if (what == WATCH_ENDED) {
        fprintf(now->talk, "\n");
    }
}
