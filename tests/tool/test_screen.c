/* SPDX-License-Identifier: MIT
 *
 * The picture of a live calibration: marks against the closed form of Lambert's projection, covered
 * areas against those of spherical caps, bars against logarithms, words, and no line that is too
 * wide.
 */
#include "watch/frame.h"

#include <math.h>
#include <string.h>

#include "support.h"
#include "unity.h"
#include "watch/map.h"

#define PI 3.14159265358979324
#define LINES 24
#define COLUMNS 80
#define NORMAL 1.959964
#define NOT_A_NUMBER ((double)NAN)

static FILE *file; /* no terminal: no colours */
static watch_state now;
static char frame[CANVAS_BYTES];
static char cell[LINES][COLUMNS + 1][5]; /* one character each */
static unsigned width[LINES];
static unsigned lines;

void setUp(void)
{
    file = tmpfile();
    now = (watch_state){.out = file,
                        .name = "board.csv",
                        .recognised = "CSV with commas; t (s), x y z",
                        .phase = WATCH_MOVING,
                        .last = WATCH_BEGUN,
                        .status = INVCAL_TOO_FEW};
}

void tearDown(void)
{
    fclose(file);
}

/* ---- a frame as cells --------------------------------------------------------------------------- */

static unsigned bytes_of(unsigned char first)
{
    return first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}

static void draw(void)
{
    const char *at = frame_print(&now, "\n", frame);

    memset(cell, 0, sizeof cell);
    memset(width, 0, sizeof width);
    for (lines = 0; *at != '\0'; at++, lines++) {
        TEST_ASSERT_LESS_THAN_UINT(LINES, lines);
        while (*at != '\n') {
            const unsigned n = bytes_of((unsigned char)*at);
            TEST_ASSERT_LESS_THAN_UINT(COLUMNS, width[lines]);
            memcpy(cell[lines][width[lines]++], at, n);
            at += n;
        }
    }
}

static const char *line_text(unsigned line)
{
    static char text[4 * COLUMNS + 1];

    text[0] = '\0';
    for (unsigned i = 0; i < width[line]; i++) {
        strcat(text, cell[line][i]);
    }
    return text;
}

static int says(const char *text)
{
    return strstr(frame, text) != NULL;
}

static unsigned count_of(const char *glyph, unsigned left, unsigned right)
{
    unsigned count = 0;

    for (unsigned line = 5; line < 18; line++) {
        for (unsigned i = left; i < right; i++) {
            count += strcmp(cell[line][i], glyph) == 0;
        }
    }
    return count;
}

/* ---- where -------------------------------------------------------------------------------------- */

/* The discs: 11 lines from the 7th on, 22 columns from the 4th and the 35th on. By colatitude from the
 * middle of the half: 2 sin(theta / 2), over that of the equator. */
static void lambert(const double v[3], unsigned *line, unsigned *at)
{
    const double theta = acos(fmin(1, fabs(v[2])));
    const double radius = 2 * sin(theta / 2) / sqrt(2);
    const double azimuth = atan2(v[1], v[0]);
    const double x = radius * cos(azimuth);
    const double y = radius * sin(azimuth);

    *at = (v[2] < 0 ? 34 : 3) + (unsigned)fmin(21, floor((1 + x) / 2 * 22));
    *line = 6 + (unsigned)fmin(10, floor((1 - y) / 2 * 11));
}

static void marks_are_where_the_projection_puts_them(void)
{
    random_source source = random_start(20);
    unsigned line;
    unsigned at;

    for (unsigned n = 0; n < 500; n++) {
        random_direction(&source, now.up);
        random_direction(&source, now.target);
        now.has_up = n % 3 != 0;
        now.has_target = !now.has_up;
        draw();
        lambert(now.has_up ? now.up : now.target, &line, &at);
        TEST_ASSERT_EQUAL_STRING(now.has_up ? "@" : "X", cell[line][at]);
    }
}

static void a_mark_is_in_one_half_and_in_both_only_near_the_equator(void)
{
    now.has_up = 1;
    for (int degrees = -90; degrees <= 90; degrees += 3) {
        const double height = degrees * PI / 180;
        now.up[0] = cos(height);
        now.up[1] = 0;
        now.up[2] = sin(height);
        draw();
        TEST_ASSERT_EQUAL_UINT(degrees > -6, count_of("@", 0, 30));
        TEST_ASSERT_EQUAL_UINT(degrees < 6, count_of("@", 30, 60));
    }
}

static void axes_are_named_on_the_side_where_they_are(void)
{
    const struct {
        double up[3];
        unsigned line, column; /* of the name, next to which the mark is */
        const char *name;
        int beside;
    } axis[] = {{{1, 0, 0}, 11, 26, "+x", -2},
                {{-1, 0, 0}, 11, 0, "-x", 3},
                {{1, 0, 0}, 11, 57, "+x", -2},
                {{-1, 0, 0}, 11, 31, "-x", 3}};

    for (unsigned n = 0; n < 4; n++) {
        memcpy(now.up, axis[n].up, sizeof now.up);
        now.has_up = 1;
        draw();
        TEST_ASSERT_EQUAL_CHAR(axis[n].name[0], cell[axis[n].line][axis[n].column][0]);
        TEST_ASSERT_EQUAL_CHAR(axis[n].name[1], cell[axis[n].line][axis[n].column + 1][0]);
        TEST_ASSERT_EQUAL_STRING("@", cell[axis[n].line][(int)axis[n].column + axis[n].beside]);
    }
    TEST_ASSERT_EQUAL_STRING("+", cell[5][13]);
    TEST_ASSERT_EQUAL_STRING("-", cell[17][13]);
    TEST_ASSERT_EQUAL_STRING("y", cell[17][14]);
    now.up[0] = 0;
    now.up[1] = 1;
    draw();
    TEST_ASSERT_EQUAL_STRING("@", cell[6][14]);
}

/* Dots of Braille between two columns. */
static unsigned count_dots(unsigned left, unsigned right)
{
    unsigned count = 0;

    for (unsigned line = 6; line < 17; line++) {
        for (unsigned i = left; i < right; i++) {
            const unsigned char *c = (const unsigned char *)cell[line][i];
            unsigned dots = c[0] == 0xE2 ? (c[1] & 3u) << 6 | (c[2] & 63u) : 0;
            for (; dots; dots &= dots - 1) {
                count++;
            }
        }
    }
    return count;
}

/* The half sphere is pi 22^2 dots, a cap of 20 degrees the (1 - cos 20)-th part of it, wherever it is. */
static void what_is_covered_has_the_area_of_its_cap(void)
{
    const double cap = PI * 22 * 22 * (1 - cos(20 * PI / 180));

    draw();
    const unsigned rim[2] = {count_dots(3, 25), count_dots(34, 56)};
    now.covered = 1;
    for (int tilt = 0; tilt <= 60; tilt += 10) {
        for (int turn = 0; turn < 360; turn += 30) {
            const double a = tilt * PI / 180;
            const double b = turn * PI / 180;
            const double d[3] = {sin(a) * cos(b), sin(a) * sin(b), tilt % 20 ? -cos(a) : cos(a)};
            memcpy(now.direction[0], d, sizeof d);
            draw();
            const unsigned up = count_dots(3, 25) - rim[0];
            const unsigned down = count_dots(34, 56) - rim[1];
            TEST_ASSERT_DOUBLE_WITHIN(0.1 * cap, cap, tilt % 20 ? down : up);
            TEST_ASSERT_EQUAL_UINT(0, tilt % 20 ? up : down);
        }
    }
}

static void all_directions_cover_all_of_it(void)
{
    now.covered = 0;
    for (int x = -1; x <= 1; x++) {
        for (int y = -1; y <= 1; y++) {
            for (int z = -1; z <= 1; z++) {
                const double length = sqrt(x * x + y * y + z * z);
                if (length > 0) {
                    double *d = now.direction[now.covered++];
                    d[0] = x / length;
                    d[1] = y / length;
                    d[2] = z / length;
                }
            }
        }
    }
    draw();
    const double half = PI * 22 * 22;
    TEST_ASSERT_GREATER_THAN_UINT((unsigned)(0.7 * half), count_dots(3, 25));
    TEST_ASSERT_LESS_THAN_UINT((unsigned)(1.02 * half), count_dots(3, 25));
}

/* ---- what to do --------------------------------------------------------------------------------- */

static void degrees_to_go_are_the_angle_between(void)
{
    now.has_up = now.has_target = 1;
    now.target[2] = 1;
    for (int degrees = 11; degrees <= 180; degrees += 13) {
        char text[40];
        now.up[0] = sin(degrees * PI / 180) * 0.6;
        now.up[1] = sin(degrees * PI / 180) * 0.8;
        now.up[2] = cos(degrees * PI / 180);
        draw();
        snprintf(text, sizeof text, "TURN IT       %d degrees to go", degrees);
        TEST_ASSERT_EQUAL_STRING(text, line_text(2));
    }
    now.up[0] = sin(0.1);
    now.up[1] = 0;
    now.up[2] = cos(0.1);
    draw();
    TEST_ASSERT_EQUAL_STRING("THERE         hold it still", line_text(2));
}

static void each_phase_has_its_order(void)
{
    now.phase = WATCH_SETTLING;
    now.progress = 50;
    draw();
    TEST_ASSERT_TRUE(says("HOLD STILL     50 %  ████████████████████····················\n"));
    now.phase = WATCH_READY;
    snprintf(now.good, sizeof now.good, "good: move on to -x up");
    draw();
    TEST_ASSERT_TRUE(says("MOVE ON       good: move on to -x up\n"));
    now.is_refused = 1;
    now.last = WATCH_REFUSED;
    now.refusal =
        "a reading is below a tenth or above ten times the field: wrong scale, zero or field";
    draw();
    TEST_ASSERT_TRUE(
        says("NOT GOOD      a reading is below a tenth or above ten times the field: wrong\n"
             "              scale, zero or field\n"));
    now.is_refused = 0;
    now.phase = WATCH_MOVING;
    draw();
    TEST_ASSERT_TRUE(says("\nLast rest refused: a reading is below a tenth"));
    TEST_ASSERT_TRUE(says("FINISHED "));
    now.phase = WATCH_ENDED;
    draw();
    TEST_ASSERT_TRUE(says("ENDED "));
}

static void words_show_now_and_next(void)
{
    now.has_up = now.has_target = 1;
    now.up[0] = now.up[2] = sqrt(0.5);
    snprintf(
        now.next, sizeof now.next,
        "position 13 of 18: alpha 120, beta 90 deg; turn alpha -150, beta +120 deg; +x up, tilt 30 "
        "deg, -y rises");
    draw();
    TEST_ASSERT_EQUAL_STRING("@ now     +z up, tilt 45 deg, +x rises", line_text(18));
    TEST_ASSERT_EQUAL_STRING(
        "X next    position 13 of 18: alpha 120, beta 90 deg; turn alpha -150, beta +120",
        line_text(19));
    TEST_ASSERT_EQUAL_STRING("          deg; +x up, tilt 30 deg, -y rises", line_text(20));
    now.is_guess = 1;
    draw();
    TEST_ASSERT_TRUE(says("(a guess: zero still unknown)\n"));
}

static void the_title_has_time_and_positions(void)
{
    now.seconds = 83.96;
    now.taken = 1;
    now.skipped = 3;
    draw();
    TEST_ASSERT_EQUAL_STRING(
        "invcal watch: board.csv                                       1:23   1 position",
        line_text(0));
    TEST_ASSERT_TRUE(says("CSV with commas; t (s), x y z"));
    TEST_ASSERT_TRUE(says("3 malformed lines skipped\n"));
}

/* ---- how well ----------------------------------------------------------------------------------- */

/* All three of one kind; the second is the worst. */
static void know(double offsets, double scales, double angles)
{
    const double sigma[3] = {offsets / NORMAL, scales / NORMAL, angles / NORMAL};

    now.status = INVCAL_OK;
    now.quality = (invcal_quality){.verdict = INVCAL_GOOD, .dof = 9, .sigma_dof = 65535};
    for (unsigned i = 0; i < 9; i++) {
        now.quality.sigma[i] = sigma[i / 3] * (i % 3 == 1 ? 1 : 0.3);
    }
}

static const char *panel(unsigned line)
{
    static char text[4 * COLUMNS + 1];

    text[0] = '\0';
    for (unsigned i = 60; i < width[line]; i++) {
        strcat(text, cell[line][i]);
    }
    return text;
}

/* 1e-5 is empty, 0.1 full, 19 columns. */
static void bars_are_logarithms_of_the_worst_interval(void)
{
    know(1e-3, 1e-5, 0.1);
    draw();
    TEST_ASSERT_EQUAL_STRING("offsets ± 1.0 mg", panel(6));
    TEST_ASSERT_EQUAL_STRING("█████████▌·········", panel(7));
    TEST_ASSERT_EQUAL_STRING("scales ± 0.0010 %", panel(8));
    TEST_ASSERT_EQUAL_STRING("···················", panel(9));
    TEST_ASSERT_EQUAL_STRING("angles ± 5.7 °", panel(10));
    TEST_ASSERT_EQUAL_STRING("███████████████████", panel(11));
    know(2e-4, 1e-9, 30);
    draw();
    TEST_ASSERT_EQUAL_STRING("offsets ± 0.20 mg", panel(6)); /* log10(20) 19/4 = 6.18 */
    TEST_ASSERT_EQUAL_STRING("██████▏············", panel(7));
    TEST_ASSERT_EQUAL_STRING("···················", panel(9));
    TEST_ASSERT_EQUAL_STRING("███████████████████", panel(11));
    now.units = UNIT_STYLE_INS;
    draw();
    TEST_ASSERT_EQUAL_STRING("offsets ± 200 µg", panel(6));
}

static void without_degrees_of_freedom_nothing_is_known(void)
{
    know(1e-3, 1e-3, 1e-3);
    now.quality.dof = 0;
    draw();
    TEST_ASSERT_EQUAL_STRING("offsets unknown", panel(6));
    TEST_ASSERT_EQUAL_STRING("███████████████████", panel(7));
}

static void the_target_is_marked_on_the_bar(void)
{
    know(1e-2, 1e-4, 1e-3);
    now.target_sigma[0] = 1e-3 / NORMAL;     /* 9.5 of 19 columns */
    now.need = 1e-4;                         /* 4.75 */
    now.accuracy = 1e-4 * pow(10, 4 / 19.0); /* 5.75 */
    draw();
    TEST_ASSERT_EQUAL_STRING("█████████|████▎····", panel(7));
    TEST_ASSERT_EQUAL_STRING("████▊··············", panel(9));
    TEST_ASSERT_EQUAL_STRING("lengths ± 0.16 mg", panel(12));
    TEST_ASSERT_EQUAL_STRING("████|▊·············", panel(13));
    TEST_ASSERT_EQUAL_STRING("| target", panel(14));
    TEST_ASSERT_TRUE(says("Good, but the target is not reached yet; go on\n"));
}

/* ---- the verdict -------------------------------------------------------------------------------- */

static void the_verdict_so_far_is_shown(void)
{
    const struct {
        invcal_verdict verdict;
        const char *words;
    } verdict[] = {{INVCAL_GOOD, "so far    Good so far; take a few more positions to confirm it"},
                   {INVCAL_NO_REDUNDANCY, "so far    No redundancy: "},
                   {INVCAL_ROUGH, "so far    Rough: "},
                   {INVCAL_DRIFTING, "so far    Drifting: "},
                   {INVCAL_BENT, "so far    Bent: "},
                   {INVCAL_WEAK, "so far    Weak: "}};

    now.covered = now.taken = 4;
    draw();
    TEST_ASSERT_EQUAL_STRING("so far    4 of at least 9 positions; 12 to 18 are good",
                             line_text(21));
    now.status = INVCAL_UNDETERMINED;
    draw();
    TEST_ASSERT_EQUAL_STRING("so far    These directions leave parameters undetermined; go on",
                             line_text(21));
    now.status = INVCAL_NOT_ELLIPSOID;
    draw();
    TEST_ASSERT_EQUAL_STRING("so far    No result: the readings do not lie on an ellipsoid",
                             line_text(21));
    for (unsigned n = 0; n < 6; n++) {
        know(1, 1, 1);
        now.quality.verdict = verdict[n].verdict;
        draw();
        TEST_ASSERT_TRUE(says(verdict[n].words));
        TEST_ASSERT_FALSE(says("you may stop"));
    }
}

static void when_it_is_good_you_may_stop(void)
{
    know(1e-4, 1e-4, 1e-4);
    now.is_good = 1;
    now.quality.left_out = 5;
    now.has_up = now.has_target = 1;
    now.up[0] = now.target[1] = 1;
    draw();
    TEST_ASSERT_EQUAL_STRING("so far    Good: you may stop (Ctrl-C); 2 left out", line_text(21));
    TEST_ASSERT_EQUAL_STRING("YOU MAY STOP  with Ctrl-C, or go on: 90 degrees to go", line_text(2));
}

/* ---- nothing breaks the screen ------------------------------------------------------------------ */

static void is_sound(void)
{
    draw();
    TEST_ASSERT_EQUAL_UINT(22, lines);
    for (unsigned i = 0; i < lines; i++) {
        TEST_ASSERT_LESS_OR_EQUAL_UINT(79, width[i]);
        if (width[i] > 0) {
            TEST_ASSERT_TRUE(strcmp(cell[i][width[i] - 1], " ") != 0);
        }
    }
    for (const char *c = frame; *c != '\0'; c++) {
        TEST_ASSERT_TRUE(*c == '\n' || (unsigned char)*c >= ' ');
    }
}

static void no_text_is_too_long_or_does_harm(void)
{
    char name[400];

    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    now.name = name;
    now.seconds = 1e300;
    now.taken = now.covered = 64;
    now.skipped = 1000000;
    now.last = WATCH_TAKEN;
    now.wrong_count = 1;
    now.phase = WATCH_READY;
    memset(now.recognised, 'r', sizeof now.recognised - 1);
    memset(now.wrong, 'w', sizeof now.wrong - 1);
    memset(now.next, 'n', sizeof now.next - 1);
    memset(now.good, 'g', sizeof now.good - 1);
    is_sound();
    TEST_ASSERT_TRUE(says("1000000 malformed lines skipped\n"));
    now.name = "\033[2Jx\303\244\346\226\207\314\201\302\233\377y";
    is_sound();
    TEST_ASSERT_TRUE(says("invcal watch: ?[2Jxä????y "));
    know(NOT_A_NUMBER, HUGE_VAL, 1e30);
    now.accuracy = NOT_A_NUMBER;
    now.need = NOT_A_NUMBER;
    now.has_up = now.has_target = 1;
    now.up[0] = now.target[2] = NOT_A_NUMBER;
    now.direction[0][0] = NOT_A_NUMBER;
    is_sound();
}

/* A magnetometer: the white part of the map is still open, a cell covers 30 degrees around it, and
 * there are different words. */
static void a_magnetometer_turns_through_the_white_part(void)
{
    now.is_magnetometer = 1;
    now.disturbed = "";
    now.has_target = 1;
    now.target[2] = 1;
    draw();
    TEST_ASSERT_TRUE(says("TURN IT       so that @ passes through the white part"));
    TEST_ASSERT_TRUE(says("0 of 18 directions"));
    TEST_ASSERT_TRUE(says("the field points:"));
    TEST_ASSERT_FALSE(says("position"));
    TEST_ASSERT_FALSE(says("which side is up"));
    const unsigned none = count_of("⣿", 3, 25);
    now.direction[0][2] = 1;
    now.covered = now.taken = 1;
    draw();
    /* 0.134 of the half is within 30 degrees, of 190 characters 25; those on its rim are lit in part */
    TEST_ASSERT_UINT_WITHIN(8, 22, count_of("⣿", 3, 25) - none);
    TEST_ASSERT_TRUE(says("1 of 18 directions"));
    now.covered = 18;
    draw();
    TEST_ASSERT_TRUE(says("GO ON"));
    now.status = INVCAL_OK;
    now.quality.dof = 9;
    now.quality.sigma_dof = 9;
    now.quality.sigma[0] = 0.01;
    now.is_good = 1;
    now.disturbed = "samples contradict the others";
    draw();
    TEST_ASSERT_TRUE(says("YOU MAY STOP"));
    TEST_ASSERT_TRUE(says("Disturbed: samples contradict the others."));
    TEST_ASSERT_TRUE(says("offsets ± 2.3 %"));
    now.is_good = 0;
    now.quality.verdict = INVCAL_WEAK;
    draw();
    TEST_ASSERT_TRUE(says("Weak: whole sides are missing; go on"));
    now.quality.verdict = INVCAL_ROUGH;
    draw();
    TEST_ASSERT_TRUE(says("Rough: disturbed"));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_magnetometer_turns_through_the_white_part);
    RUN_TEST(marks_are_where_the_projection_puts_them);
    RUN_TEST(a_mark_is_in_one_half_and_in_both_only_near_the_equator);
    RUN_TEST(axes_are_named_on_the_side_where_they_are);
    RUN_TEST(what_is_covered_has_the_area_of_its_cap);
    RUN_TEST(all_directions_cover_all_of_it);
    RUN_TEST(degrees_to_go_are_the_angle_between);
    RUN_TEST(each_phase_has_its_order);
    RUN_TEST(words_show_now_and_next);
    RUN_TEST(the_title_has_time_and_positions);
    RUN_TEST(bars_are_logarithms_of_the_worst_interval);
    RUN_TEST(without_degrees_of_freedom_nothing_is_known);
    RUN_TEST(the_target_is_marked_on_the_bar);
    RUN_TEST(the_verdict_so_far_is_shown);
    RUN_TEST(when_it_is_good_you_may_stop);
    RUN_TEST(no_text_is_too_long_or_does_harm);
    return UNITY_END();
}
