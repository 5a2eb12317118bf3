/* SPDX-License-Identifier: MIT */
#include "watch/frame.h"

#include <math.h>

#include "invcal/magnetometer.h"
#include "text/figure.h"
#include "watch/map.h"

#define TEXT_MAX 512
#define NEAR 10.0                  /* degrees to go that are near enough */
#define COVERS 0.93969262078590838 /* cosine of 20 degrees, */
#define CELL 0.86602540378443865   /* and of 30, of a cell of a magnetometer */
#define LEVEL 0.1                  /* sine of the height above the equator */
#define LEAST 9u                   /* positions that a calibration takes */
#define ORDER 14u                  /* column of what there is to say of an order, */
#define WORDS 10u                  /* and of the other words */
#define HALF 31u                   /* columns of a half of the sphere, with its axes */
#define PANEL 60u                  /* first column of what is known */
#define BAR 19u                    /* columns of a bar, */
#define DECADES 4.0                /* which goes from */
#define FINEST 1e-5                /* this to 0.1: over the field, of the scale, rad */

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

    snprintf(right, sizeof right, "%lu:%02lu   %u %s%s", seconds / 60, seconds % 60, now->taken,
             now->is_magnetometer ? "of 18 directions" : "position",
             now->is_magnetometer || now->taken == 1 ? "" : "s");
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

/* A share of `width`, to an eighth of a column; `rest` where it is empty. */
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
    (void)canvas_text(c, PHASE, 0, ORDER, colour, order);
    (void)say(c, PHASE, ORDER, CANVAS_PLAIN, text);
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
        draw_order(c, PAINT_GREEN, "FINISHED", "the program is complete: stop with Ctrl-C");
    } else if (to_go >= 0 && to_go <= NEAR) {
        draw_order(c, PAINT_BOLD, "THERE", "hold it still");
    } else if (now->is_good) {
        draw_order(c, PAINT_GREEN, "YOU MAY STOP", text);
    } else {
        draw_order(c, PAINT_BOLD, "TURN IT", text);
    }
}

static void draw_waving(canvas *c, const watch_state *now)
{
    if (now->is_good) {
        draw_order(c, PAINT_GREEN, "YOU MAY STOP", "with Ctrl-C, or go on");
    } else if (now->covered < INVCAL_CELLS) {
        draw_order(c, PAINT_BOLD, "TURN IT",
                   "so that @ passes through the white part, in any order");
    } else {
        draw_order(c, PAINT_BOLD, "GO ON", "turn it slowly to all sides");
    }
}

static void draw_phase(canvas *c, const watch_state *now)
{
    char text[TEXT_MAX];

    if (now->phase == WATCH_ENDED) {
        draw_order(c, PAINT_BOLD, "ENDED", "the stream has ended");
    } else if (now->is_magnetometer) {
        draw_waving(c, now);
    } else if (now->is_refused) {
        draw_order(c, PAINT_RED, "NOT GOOD", "");
        canvas_wrapped(c, PHASE, 2, ORDER, CANVAS_PLAIN, now->refusal);
    } else if (now->phase == WATCH_READY) {
        draw_order(c, PAINT_GREEN, "MOVE ON", now->good);
    } else if (now->phase == WATCH_SETTLING) {
        snprintf(text, sizeof text, "%3u %%", now->progress);
        draw_order(c, PAINT_YELLOW, "HOLD STILL", text);
        draw_bar(c, PHASE, ORDER + 7, 40, now->progress / 100.0, PAINT_YELLOW, "·");
    } else {
        draw_moving(c, now);
    }
}

/* What became of the last rest, as long as there is no later one. */
static void draw_last(canvas *c, const watch_state *now)
{
    char text[TEXT_MAX];

    if (now->is_magnetometer) {
        snprintf(text, sizeof text, "Disturbed: %s.", now->disturbed);
        canvas_wrapped(c, LAST, 2, 0, PAINT_RED, *now->disturbed ? text : "");
        return;
    }
    if (now->is_refused) {
        return;
    }
    if (now->last == WATCH_REFUSED && now->phase != WATCH_READY) {
        snprintf(text, sizeof text, "Last rest refused: %s.", now->refusal);
        canvas_wrapped(c, LAST, 2, 0, PAINT_RED, text);
    } else if (now->last == WATCH_TAKEN) {
        const int is_odd = now->astray > 0 || *now->gyro.refused;
        snprintf(text, sizeof text, "Position %u taken%s%s.%s%s", now->taken, is_odd ? ": " : "",
                 now->astray > 0 ? now->wrong : now->gyro.refused, *now->gyro.text ? " " : "",
                 now->gyro.text);
        canvas_wrapped(c, LAST, 2, 0, is_odd ? PAINT_YELLOW : CANVAS_PLAIN, text);
    }
}

/* ---- where ------------------------------------------------------------------------------------- */

/* What is nearly level stands on the rims of both halves. */
static void draw_mark(canvas *c, const double up[3], int colour, const char *mark)
{
    const map_place at = map_find(up);

    for (unsigned half = 0; half < 2; half++) {
        if (half == at.half || fabs(up[2]) < LEVEL) {
            canvas_put(c, MAP + 1 + at.line, HALF * half + 3 + at.column, colour, mark);
        }
    }
}

static void draw_half(canvas *c, const watch_state *now, unsigned half)
{
    const unsigned left = HALF * half;
    const unsigned middle = left + 3 + MAP_COLUMNS / 2 - 1;
    const unsigned equator = MAP + 1 + MAP_LINES / 2;

    const map_covered covered = {now->direction, now->covered,
                                 now->is_magnetometer ? CELL : COVERS};

    map_draw(c, MAP + 1, left + 3, half, &covered);
    (void)say(c, MAP, left + 3, PAINT_BOLD,
              now->is_magnetometer ? (half ? "-z" : "+z")
              : half               ? "-z up"
                                   : "+z up");
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
    char words[INVCAL_WORDS] = "unknown";

    if (now->has_up) {
        (void)invcal_words(now->up, words);
    }
    if (now->is_magnetometer) {
        snprintf(words, sizeof words, "%s",
                 now->has_up ? "where the field points" : "still unknown");
    }
    (void)canvas_text(c, NOW, 0, WORDS, PAINT_YELLOW, "@ now");
    const unsigned at = say(c, NOW, WORDS, CANVAS_PLAIN, words);
    if (now->is_guess && !now->is_magnetometer) {
        (void)say(c, NOW, at, CANVAS_PLAIN, "  (a guess: zero still unknown)");
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

/* A figure and its bar. interval  below 0: not known; wanted  0: anything. */
static void draw_known(canvas *c, unsigned line, const char *what, double interval, double wanted,
                       display_unit unit)
{
    const int is_known = interval >= 0;
    const int colour =
        is_known && wanted > 0 && interval <= wanted ? PAINT_GREEN : CANVAS_PLAIN; /* reached */
    char text[TEXT_MAX];
    char number[FIGURE_MAX];

    snprintf(text, sizeof text, is_known ? "%s ± %s %s" : "%s unknown", what,
             figure_digits(unit.scale * interval, 2, number), unit.unit);
    (void)say(c, line, PANEL, colour, text);
    draw_bar(c, line + 1, PANEL, BAR, is_known ? bar_share(interval) : 1, colour, "·");
    if (wanted > 0) {
        const double place = floor(BAR * fmax(0, fmin(1, bar_share(wanted))));
        canvas_put(c, line + 1, PANEL + (unsigned)fmin(place, BAR - 1), PAINT_BOLD, "|");
    }
}

static void draw_panel(canvas *c, const watch_state *now)
{
    const int is_known = watch_knows_sigma(now);
    unsigned line = MAP;

    (void)say(c, line++, PANEL, PAINT_BOLD, "uncertainty, 95 %");
    for (unsigned k = 0; k < WATCH_KINDS; k++, line += 2) {
        draw_known(c, line, watch_kinds[k], is_known ? watch_interval(now, k) : -1,
                   watch_wanted(now, k), watch_unit(now, k));
    }
    if (now->need > 0) {
        draw_known(c, line, "lengths", is_known ? now->accuracy : -1, now->need,
                   watch_unit(now, 0));
        line += 2;
    }
    if (watch_is_anything_wanted(now)) {
        (void)say(c, line, PANEL, CANVAS_PLAIN, "| target");
    }
    (void)say(c, MAP + MAP_LINES, PANEL, CANVAS_PLAIN,
              now->is_magnetometer ? "the field points:" : "which side is up:");
    const unsigned at = say(c, MAP + MAP_LINES + 1, PANEL, CANVAS_PLAIN, "@ now X next ");
    canvas_put(c, MAP + MAP_LINES + 1, at, CANVAS_PLAIN, "⣿");
    (void)say(c, MAP + MAP_LINES + 1, at + 2, CANVAS_PLAIN, "done");
}

/* ---- the verdict so far ------------------------------------------------------------------------ */

static const char *verdict_words(invcal_verdict verdict)
{
    static const char *const words[] = {
        [INVCAL_GOOD] = "Good so far; take a few more positions to confirm it",
        [INVCAL_NO_REDUNDANCY] = "No redundancy: nothing checks the result yet; go on",
        [INVCAL_ROUGH] = "Rough: positions disagree by more than noise; go on",
        [INVCAL_DRIFTING] = "Drifting: let the sensor warm up, or work faster",
        [INVCAL_BENT] = "Bent: an axis is nonlinear or has hysteresis",
        [INVCAL_WEAK] = "Weak: a parameter is still poorly determined; go on",
    };
    return verdict <= INVCAL_WEAK ? words[verdict] : invcal_verdict_text(verdict);
}

/* The same of a magnetometer. */
static const char *waving_words(const watch_state *now)
{
    static const char *const words[] = {
        [INVCAL_GOOD] = "Good so far; turn it to the remaining sides",
        [INVCAL_NO_REDUNDANCY] = "No redundancy: too few samples; go on",
        [INVCAL_ROUGH] = "Rough: disturbed; start again elsewhere",
        [INVCAL_WEAK] = "Weak: whole sides are missing; go on",
    };
    const unsigned verdict = now->quality.verdict;

    return verdict <= INVCAL_WEAK && words[verdict] ? words[verdict] : "Go on";
}

/* Nothing can be solved yet. */
static const char *status_words(const watch_state *now, char text[TEXT_MAX])
{
    if (now->status == INVCAL_TOO_FEW && now->is_magnetometer) {
        snprintf(text, TEXT_MAX, "%u of 18 directions; at least 9, better all", now->covered);
    } else if (now->status == INVCAL_TOO_FEW) {
        snprintf(text, TEXT_MAX, "%u of at least %u positions; 12 to 18 are good", now->covered,
                 LEAST);
    } else if (now->status == INVCAL_UNDETERMINED) {
        snprintf(text, TEXT_MAX, "These directions leave parameters undetermined; go on");
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

static const char *result_words(const watch_state *now, char text[TEXT_MAX])
{
    if (now->is_good) {
        return now->phase == WATCH_ENDED ? "Good" : "Good: you may stop (Ctrl-C)";
    }
    if (now->status != INVCAL_OK) {
        return status_words(now, text);
    }
    return now->quality.verdict == INVCAL_GOOD && watch_is_anything_wanted(now)
               ? "Good, but the target is not reached yet; go on"
           : now->is_magnetometer ? waving_words(now)
                                  : verdict_words(now->quality.verdict);
}

static int result_colour(const watch_state *now)
{
    const unsigned verdict = now->quality.verdict;
    const int is_wrong =
        verdict == INVCAL_ROUGH || verdict == INVCAL_DRIFTING || verdict == INVCAL_BENT;

    return now->is_good                           ? PAINT_GREEN
           : now->status == INVCAL_OK && is_wrong ? PAINT_YELLOW
                                                  : CANVAS_PLAIN;
}

static void draw_verdict(canvas *c, const watch_state *now)
{
    const unsigned left_out = now->status == INVCAL_OK ? count_bits(now->quality.left_out) : 0;
    char text[TEXT_MAX];

    (void)canvas_text(c, SO_FAR, 0, WORDS, PAINT_BOLD, "so far");
    const unsigned at = say(c, SO_FAR, WORDS, result_colour(now), result_words(now, text));
    if (left_out > 0) {
        snprintf(text, sizeof text, "; %u left out", left_out);
        (void)say(c, SO_FAR, at, PAINT_RED, text);
    }
}

/* ---- a frame ----------------------------------------------------------------------------------- */

const char *frame_print(const watch_state *now, const char *line_end, char text[CANVAS_BYTES])
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
