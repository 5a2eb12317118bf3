/* SPDX-License-Identifier: MIT */
#include "design/program.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "support.h"
#include "cli/unit_style.h"
#include "unity.h"

static design set;
static program followed;

void setUp(void)
{
}

void tearDown(void)
{
}

static void begin(const char *word)
{
    TEST_ASSERT_EQUAL_INT(EXIT_GOOD, design_make(&set, "test", word));
    program_begin(&followed, &set);
}

/* ---- which position it is ----------------------------------------------------------------------- */

static void each_position_is_found_by_its_direction_even_seven_degrees_off(void)
{
    const char *const sets[] = {"per-group:6", "per-group:9", "edges", "icosahedron", "optimal:20"};

    for (unsigned k = 0; k < sizeof sets / sizeof sets[0]; k++) {
        begin(sets[k]);
        for (unsigned i = 0; i < set.count; i++) {
            const double *v = set.position[i].vertical;
            const double up[3] = {2 * (v[0] + 0.07), 2 * (v[1] - 0.07), 2 * (v[2] + 0.07)};
            TEST_ASSERT_EQUAL_UINT(i, followed.next);
            TEST_ASSERT_EQUAL_UINT(i, program_find(&followed, up));
            program_visit(&followed, i, up);
        }
        TEST_ASSERT_EQUAL_UINT(set.count, followed.next);
    }
}

static void another_position_is_found_whatever_is_asked_for(void)
{
    begin("per-group:6");
    for (unsigned i = 0; i < set.count; i++) {
        TEST_ASSERT_EQUAL_UINT(i, program_find(&followed, set.position[i].vertical));
    }
}

static void what_is_near_no_position_is_nowhere(void)
{
    const double corner[3] = {1, 1, 1};
    const double nothing[3] = {0, 0, 0};
    const double broken[3] = {(double)NAN, 0, 1};

    begin("per-group:6"); /* on three great circles: corners are 35 degrees away */
    TEST_ASSERT_EQUAL_UINT(PROGRAM_NO_POSITION, program_find(&followed, corner));
    TEST_ASSERT_EQUAL_UINT(PROGRAM_NO_POSITION, program_find(&followed, broken));
    (void)program_find(&followed, nothing); /* no direction: any answer, but no harm */
}

/* Steps of 2.5 degrees are smaller than the rotation that a stand and unknown offsets may cause. */
static void the_one_asked_for_is_preferred_within_three_degrees(void)
{
    begin("per-group:144");
    TEST_ASSERT_EQUAL_UINT(0, program_find(&followed, set.position[1].vertical));
    TEST_ASSERT_EQUAL_UINT(2, program_find(&followed, set.position[2].vertical));
}

static void of_positions_with_one_direction_the_missing_one_is_found(void)
{
    begin("per-group:8"); /* 24 positions, 18 directions: number 3 and 13 are +z */
    program_visit(&followed, 2, set.position[2].vertical);
    TEST_ASSERT_EQUAL_UINT(12, program_find(&followed, set.position[2].vertical));
}

static void a_position_that_follows_in_the_same_direction_is_not_needed(void)
{
    begin("per-group:8:-45,0,0"); /* group 1 ends with -z, group 2 begins with it */
    const double *down = set.position[7].vertical;
    program_visit(&followed, 7, down);
    TEST_ASSERT_EQUAL_UINT(1, followed.visited[8]);
    TEST_ASSERT_EQUAL_UINT(0, followed.visited[9]);
    TEST_ASSERT_EQUAL_INT(0, followed.is_repeat);
    TEST_ASSERT_EQUAL_UINT(8, program_find(&followed, down)); /* if the user goes there anyway */
    program_visit(&followed, 8, down);
    TEST_ASSERT_EQUAL_INT(1, followed.is_repeat);
    program_visit(&followed, 8, down);
    TEST_ASSERT_EQUAL_INT(0, followed.is_repeat);
}

static void what_was_visited_out_of_turn_is_not_asked_for_again(void)
{
    char text[PROGRAM_TEXT_MAX];

    begin("per-group:6");
    program_visit(&followed, 1, set.position[1].vertical);
    TEST_ASSERT_EQUAL_UINT(0, followed.next);
    program_visit(&followed, 0, set.position[0].vertical);
    TEST_ASSERT_EQUAL_UINT(2, followed.next);
    TEST_ASSERT_EQUAL_STRING("3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18",
                             program_missing_text(&followed, text));
    begin("per-group:1000");
    TEST_ASSERT_NOT_NULL(strstr(program_missing_text(&followed, text), ", ..."));
}

/* ---- zero and scale ----------------------------------------------------------------------------- */

static void three_positions_determine_zero_and_scale(void)
{
    const double zero[3] = {33000, 32800, 32500};
    double mean[9];
    double found[3];
    double length;

    begin("per-group:6");
    for (unsigned k = 0; k < 9; k++) {
        mean[k] = zero[k % 3] + 16384 * set.position[k / 3].vertical[k % 3];
    }
    TEST_ASSERT_EQUAL_INT(1, program_scale(&followed, mean, 3, found, &length));
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 16384, length);
    for (unsigned i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, zero[i], found[i]);
    }
    mean[4] += 16384; /* that was another position */
    TEST_ASSERT_EQUAL_INT(0, program_scale(&followed, mean, 3, found, &length));
}

/* ---- units --------------------------------------------------------------------------------------- */

static void units_of_navigation_differ_by_exact_factors(void)
{
    unit_style style = UNIT_STYLE_EVERYDAY;

    TEST_ASSERT_EQUAL_INT(0, unit_style_parse("INS", &style));
    TEST_ASSERT_EQUAL_INT(1, unit_style_parse("ins", &style));
    TEST_ASSERT_EQUAL_INT(UNIT_STYLE_INS, style);
    TEST_ASSERT_DOUBLE_WITHIN(0, 1e3 * unit_style_field(UNIT_STYLE_EVERYDAY, 1).scale,
                              unit_style_field(style, 1).scale);
    TEST_ASSERT_DOUBLE_WITHIN(0, 1e4 * unit_style_field(UNIT_STYLE_EVERYDAY, 0).scale,
                              unit_style_field(style, 0).scale);
    TEST_ASSERT_DOUBLE_WITHIN(0, 1e4 * unit_style_scale(UNIT_STYLE_EVERYDAY).scale,
                              unit_style_scale(style).scale);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 3600 * unit_style_angle(UNIT_STYLE_EVERYDAY).scale,
                              unit_style_angle(style).scale);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 648000 / acos(-1), unit_style_angle(style).scale);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(each_position_is_found_by_its_direction_even_seven_degrees_off);
    RUN_TEST(another_position_is_found_whatever_is_asked_for);
    RUN_TEST(what_is_near_no_position_is_nowhere);
    RUN_TEST(the_one_asked_for_is_preferred_within_three_degrees);
    RUN_TEST(of_positions_with_one_direction_the_missing_one_is_found);
    RUN_TEST(a_position_that_follows_in_the_same_direction_is_not_needed);
    RUN_TEST(what_was_visited_out_of_turn_is_not_asked_for_again);
    RUN_TEST(three_positions_determine_zero_and_scale);
    RUN_TEST(units_of_navigation_differ_by_exact_factors);
    return UNITY_END();
}
