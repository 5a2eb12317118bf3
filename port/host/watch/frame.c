/* SPDX-License-Identifier: MIT */
#include "watch/frame.h"

#include <math.h>

#include "invcal/magnetometer.h"
#include "invcal/plan.h"
#include "text/figure.h"
#include "watch/map.h"

#define TEXT_MAX 512
#define NEAR_TARGET 10.0                    /* degrees */
#define POSITION_COSINE 0.93969262078590838 /* of 20 degrees: the area that a position covers; */
#define CELL_COSINE 0.86602540378443865     /* of 30 degrees: a cell of a magnetometer */
#define LEVEL_SINE 0.1                      /* of the height above the equator */
#define POSITIONS_MIN 9u                    /* of a calibration */
#define INSTRUCTION_TEXT 14u                /* column of the text after an instruction */
#define TEXT_COLUMN 10u                     /* column of other texts */
#define HALF_WIDTH 31u                      /* columns of a half of the sphere, with its axes */
#define PANEL_COLUMN 60u                    /* of the uncertainties */
#define BAR_WIDTH 19u                       /* columns */
#define BAR_START 1e-5                      /* of a bar: over the field, of the scale, rad */
#define DECADES 4.0                         /* from BAR_START to its end */

/* Lines of the screen. */
enum {
    TITLE_LINE = 0,
    LOG_LINE = 1,
    PHASE_LINE = 2,
    LAST_LINE = 3,
    MAP_LINE = 5,
    NOW_LINE = 18,
    NEXT_LINE = 19,
    VERDICT_LINE = 21
};

static unsigned put(canvas *c, unsigned line, unsigned left, int colour, const char *text)
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
    const unsigned at = canvas_text(c, TITLE_LINE, 0, from - 2, PAINT_BOLD, "invcal watch: ");
    (void)canvas_text(c, TITLE_LINE, at, from - 2, PAINT_BOLD, now->name);
    (void)put(c, TITLE_LINE, from, PAINT_BOLD, right);
    if (now->skipped > 0) {
        snprintf(skipped, sizeof skipped, "%lu malformed line%s skipped", now->skipped,
                 now->skipped == 1 ? "" : "s");
    }
    const unsigned end = CANVAS_COLUMNS - canvas_width(skipped);
    (void)canvas_text(c, LOG_LINE, 0, *skipped ? end - 2 : end, CANVAS_PLAIN, now->recognised);
    (void)put(c, LOG_LINE, end, PAINT_YELLOW, skipped);
}

/* ---- the instruction --------------------------------------------------------------------------- */

/* A bar that fills `share` of `width`, to an eighth of a column; `rest` fills the empty part. */
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

static void draw_instruction(canvas *c, int colour, const char *instruction, const char *text)
{
    (void)canvas_text(c, PHASE_LINE, 0, INSTRUCTION_TEXT, colour, instruction);
    (void)put(c, PHASE_LINE, INSTRUCTION_TEXT, CANVAS_PLAIN, text);
}

static void draw_moving(canvas *c, const watch_state *now)
{
    const double to_go = watch_degrees_to_go(now);
    char text[TEXT_MAX] = "";

    if (to_go >= 0) {
        snprintf(text, sizeof text, "%s%.0f degrees to go",
                 now->is_good ? "with Ctrl-C, or go on: " : "", to_go);
    }
    if (!now->has_target) {
        draw_instruction(c, PAINT_GREEN, "FINISHED", "the program is complete: stop with Ctrl-C");
    } else if (to_go >= 0 && to_go <= NEAR_TARGET) {
        draw_instruction(c, PAINT_BOLD, "THERE", "hold it still");
    } else if (now->is_good) {
        draw_instruction(c, PAINT_GREEN, "YOU MAY STOP", text);
    } else {
        draw_instruction(c, PAINT_BOLD, "TURN IT", text);
    }
}

static void draw_waving(canvas *c, const watch_state *now)
{
    if (now->is_good) {
        draw_instruction(c, PAINT_GREEN, "YOU MAY STOP", "with Ctrl-C, or go on");
    } else if (now->covered < INVCAL_CELLS) {
        draw_instruction(c, PAINT_BOLD, "TURN IT",
                         "so that @ passes through the white part, in any order");
    } else {
        draw_instruction(c, PAINT_BOLD, "GO ON", "turn it slowly to all sides");
    }
}

static void draw_phase(canvas *c, const watch_state *now)
{
    char text[TEXT_MAX];

    if (now->phase == WATCH_ENDED) {
        draw_instruction(c, PAINT_BOLD, "ENDED", "the stream has ended");
    } else if (now->is_magnetometer) {
        draw_waving(c, now);
    } else if (now->is_refused) {
        draw_instruction(c, PAINT_RED, "NOT GOOD", "");
        canvas_wrapped(c, PHASE_LINE, 2, INSTRUCTION_TEXT, CANVAS_PLAIN, now->refusal);
    } else if (now->phase == WATCH_READY) {
        draw_instruction(c, PAINT_GREEN, "MOVE ON", now->good);
    } else if (now->phase == WATCH_SETTLING) {
        snprintf(text, sizeof text, "%3u %%", now->progress);
        draw_instruction(c, PAINT_YELLOW, "HOLD STILL", text);
        draw_bar(c, PHASE_LINE, INSTRUCTION_TEXT + 7, 40, now->progress / 100.0, PAINT_YELLOW, "·");
    } else {
        draw_moving(c, now);
    }
}

/* The result of the last rest, until the next one. */
static void draw_last(canvas *c, const watch_state *now)
{
    char text[TEXT_MAX];

    if (now->is_magnetometer) {
        snprintf(text, sizeof text, "Disturbed: %s.", now->disturbed);
        canvas_wrapped(c, LAST_LINE, 2, 0, PAINT_RED, *now->disturbed ? text : "");
        return;
    }
    if (now->is_refused) {
        return;
    }
    if (now->last == WATCH_REFUSED && now->phase != WATCH_READY) {
        snprintf(text, sizeof text, "Last rest refused: %s.", now->refusal);
        canvas_wrapped(c, LAST_LINE, 2, 0, PAINT_RED, text);
    } else if (now->last == WATCH_TAKEN) {
        const int is_odd = now->wrong_count > 0 || *now->gyro.refused;
        snprintf(text, sizeof text, "Position %u taken%s%s.%s%s", now->taken, is_odd ? ": " : "",
                 now->wrong_count > 0 ? now->wrong : now->gyro.refused, *now->gyro.text ? " " : "",
                 now->gyro.text);
        canvas_wrapped(c, LAST_LINE, 2, 0, is_odd ? PAINT_YELLOW : CANVAS_PLAIN, text);
    }
}

/* ---- directions -------------------------------------------------------------------------------- */

/* A direction that is nearly level is marked on the rims of both halves. */
static void draw_mark(canvas *c, const double up[3], int colour, const char *mark)
{
    const map_place at = map_find(up);

    for (unsigned half = 0; half < 2; half++) {
        if (half == at.half || fabs(up[2]) < LEVEL_SINE) {
            canvas_put(c, MAP_LINE + 1 + at.line, HALF_WIDTH * half + 3 + at.column, colour, mark);
        }
    }
}

static void draw_half(canvas *c, const watch_state *now, unsigned half)
{
    const unsigned left = HALF_WIDTH * half;
    const unsigned middle = left + 3 + MAP_COLUMNS / 2 - 1;
    const unsigned equator = MAP_LINE + 1 + MAP_LINES / 2;

    const map_covered covered = {now->direction, now->covered,
                                 now->is_magnetometer ? CELL_COSINE : POSITION_COSINE};

    map_draw(c, MAP_LINE + 1, left + 3, half, &covered);
    (void)put(c, MAP_LINE, left + 3, PAINT_BOLD,
              now->is_magnetometer ? (half ? "-z" : "+z")
              : half               ? "-z up"
                                   : "+z up");
    (void)put(c, MAP_LINE, middle, CANVAS_PLAIN, "+y");
    (void)put(c, MAP_LINE + 1 + MAP_LINES, middle, CANVAS_PLAIN, "-y");
    (void)put(c, equator, left, CANVAS_PLAIN, "-x");
    (void)put(c, equator, left + 4 + MAP_COLUMNS, CANVAS_PLAIN, "+x");
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
    char words[INVCAL_TEXT_SIZE] = "unknown";

    if (now->has_up) {
        (void)invcal_direction_text(now->up, words);
    }
    if (now->is_magnetometer) {
        snprintf(words, sizeof words, "%s",
                 now->has_up ? "where the field points" : "still unknown");
    }
    (void)canvas_text(c, NOW_LINE, 0, TEXT_COLUMN, PAINT_YELLOW, "@ now");
    const unsigned at = put(c, NOW_LINE, TEXT_COLUMN, CANVAS_PLAIN, words);
    if (now->is_guess && !now->is_magnetometer) {
        (void)put(c, NOW_LINE, at, CANVAS_PLAIN, "  (a guess: zero still unknown)");
    }
    (void)canvas_text(c, NEXT_LINE, 0, TEXT_COLUMN, PAINT_GREEN, "X next");
    canvas_wrapped(c, NEXT_LINE, 2, TEXT_COLUMN, CANVAS_PLAIN,
                   *now->next ? now->next : "nowhere: the program is complete");
}

/* ---- uncertainties ----------------------------------------------------------------------------- */

static double bar_share(double x)
{
    return log10(x / BAR_START) / DECADES;
}

/* A figure and its bar. interval  below 0: unknown; wanted  0: no limit. */
static void draw_uncertainty(canvas *c, unsigned line, const char *what, double interval,
                             double wanted, display_unit unit)
{
    const int is_known = interval >= 0;
    const int colour =
        is_known && wanted > 0 && interval <= wanted ? PAINT_GREEN : CANVAS_PLAIN; /* reached */
    char text[TEXT_MAX];
    char number[FIGURE_MAX];

    snprintf(text, sizeof text, is_known ? "%s ± %s %s" : "%s unknown", what,
             figure_digits(unit.scale * interval, 2, number), unit.unit);
    (void)put(c, line, PANEL_COLUMN, colour, text);
    draw_bar(c, line + 1, PANEL_COLUMN, BAR_WIDTH, is_known ? bar_share(interval) : 1, colour, "·");
    if (wanted > 0) {
        const double place = floor(BAR_WIDTH * fmax(0, fmin(1, bar_share(wanted))));
        canvas_put(c, line + 1, PANEL_COLUMN + (unsigned)fmin(place, BAR_WIDTH - 1), PAINT_BOLD,
                   "|");
    }
}

static void draw_panel(canvas *c, const watch_state *now)
{
    const int is_known = watch_knows_sigma(now);
    unsigned line = MAP_LINE;

    (void)put(c, line++, PANEL_COLUMN, PAINT_BOLD, "uncertainty, 95 %");
    for (unsigned k = 0; k < WATCH_KINDS; k++, line += 2) {
        draw_uncertainty(c, line, watch_kinds[k], is_known ? watch_interval(now, k) : -1,
                         watch_goal(now, k), watch_unit(now, k));
    }
    if (now->need > 0) {
        draw_uncertainty(c, line, "lengths", is_known ? now->accuracy : -1, now->need,
                         watch_unit(now, 0));
        line += 2;
    }
    if (watch_has_goal(now)) {
        (void)put(c, line, PANEL_COLUMN, CANVAS_PLAIN, "| target");
    }
    (void)put(c, MAP_LINE + MAP_LINES, PANEL_COLUMN, CANVAS_PLAIN,
              now->is_magnetometer ? "the field points:" : "which side is up:");
    const unsigned at =
        put(c, MAP_LINE + MAP_LINES + 1, PANEL_COLUMN, CANVAS_PLAIN, "@ now X next ");
    canvas_put(c, MAP_LINE + MAP_LINES + 1, at, CANVAS_PLAIN, "⣿");
    (void)put(c, MAP_LINE + MAP_LINES + 1, at + 2, CANVAS_PLAIN, "done");
}

/* ---- the verdict so far ------------------------------------------------------------------------ */

static const char *verdict_words(invcal_verdict verdict)
{
    switch (verdict) {
    case INVCAL_GOOD:
        return "Good so far; take a few more positions to confirm it";
    case INVCAL_NO_REDUNDANCY:
        return "No redundancy: nothing checks the result yet; go on";
    case INVCAL_ROUGH:
        return "Rough: positions disagree by more than noise; go on";
    case INVCAL_DRIFTING:
        return "Drifting: let the sensor warm up, or work faster";
    case INVCAL_BENT:
        return "Bent: an axis is nonlinear or has hysteresis";
    case INVCAL_WEAK:
        return "Weak: a parameter is still poorly determined; go on";
    default:
        return invcal_verdict_text(verdict);
    }
}

/* The same for a magnetometer. */
static const char *waving_words(invcal_verdict verdict)
{
    switch (verdict) {
    case INVCAL_GOOD:
        return "Good so far; turn it to the remaining sides";
    case INVCAL_NO_REDUNDANCY:
        return "No redundancy: too few samples; go on";
    case INVCAL_ROUGH:
        return "Rough: disturbed; start again elsewhere";
    case INVCAL_WEAK:
        return "Weak: whole sides are missing; go on";
    default:
        return "Go on";
    }
}

/* If there is no solution yet. */
static const char *status_words(const watch_state *now, char text[TEXT_MAX])
{
    if (now->status == INVCAL_TOO_FEW && now->is_magnetometer) {
        snprintf(text, TEXT_MAX, "%u of 18 directions; at least 9, better all", now->covered);
    } else if (now->status == INVCAL_TOO_FEW) {
        snprintf(text, TEXT_MAX, "%u of at least %u positions; 12 to 18 are good", now->covered,
                 POSITIONS_MIN);
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
    return now->quality.verdict == INVCAL_GOOD && watch_has_goal(now)
               ? "Good, but the target is not reached yet; go on"
           : now->is_magnetometer ? waving_words(now->quality.verdict)
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

    (void)canvas_text(c, VERDICT_LINE, 0, TEXT_COLUMN, PAINT_BOLD, "so far");
    const unsigned at =
        put(c, VERDICT_LINE, TEXT_COLUMN, result_colour(now), result_words(now, text));
    if (left_out > 0) {
        snprintf(text, sizeof text, "; %u left out", left_out);
        (void)put(c, VERDICT_LINE, at, PAINT_RED, text);
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
    return canvas_print(&c, now->out, line_end, text);
}
