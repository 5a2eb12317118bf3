/* SPDX-License-Identifier: MIT
 *
 * The frame of the case: a known rotation comes back, its sigma has a closed form, and the tilt of
 * a table cancels in pairs.
 */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "invcal/frame.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const double faces[6][3] = {{0, 0, 1},  {1, 0, 0},  {0, 1, 0},
                                   {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}};

/* The reading R' c of a calibrated sensor, c the up direction in the case. */
static void read_turned(const double r[3][3], const double c[3], invcal_real out[3])
{
    for (int j = 0; j < 3; j++) {
        out[j] = (invcal_real)(r[0][j] * c[0] + r[1][j] * c[1] + r[2][j] * c[2]);
    }
}

static invcal_status add(invcal_frame *frame, const double r[3][3], const double up[3],
                         const double stated[3])
{
    const invcal_calibration unit = unit_nominal();
    invcal_real raw[3];
    invcal_real c[3];

    read_turned(r, up, raw);
    for (int i = 0; i < 3; i++) {
        c[i] = (invcal_real)stated[i];
    }
    return invcal_frame_add(frame, &unit, raw, c);
}

static void is_rotation(const double expected[3][3], const invcal_real r[3][3], double tolerance)
{
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(tolerance, expected[i / 3][i % 3], (double)r[i / 3][i % 3]);
    }
}

static void any_rotation_comes_back_from_two_faces_and_from_more(void)
{
    random_source random = random_start(1);

    for (int n = 0; n < SOME(300); n++) {
        invcal_frame frame;
        invcal_rotation found;
        double r[3][3];
        random_rotation(&random, r);
        invcal_frame_init(&frame);
        const int count = 2 + n % 5;
        for (int k = 0; k < count; k++) {
            TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                                  add(&frame, (const double(*)[3])r, faces[k], faces[k]));
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_frame_solve(&frame, &found, NULL));
        is_rotation((const double(*)[3])r, (const invcal_real(*)[3])found.r,
                    FLOAT_OR_DOUBLE(1e-6, 1e-14));
    }
}

/* The covariance is (tr S - S)^-1, S the sum of c c': with two faces, x and z or the like, the angle about the third axis has
 * 1/2 and the others 1; with three faces all have 1/2, with six 1/4. */
static void sigma_is_that_of_closed_form(void)
{
    static const double expected[][3] = {
        {1, 0.70710678, 1}, {0.70710678, 0.70710678, 0.70710678}, {0.5, 0.5, 0.5}};
    static const int counts[] = {2, 3, 6};
    static const double same[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    for (int n = 0; n < 3; n++) {
        invcal_frame frame;
        invcal_frame_quality quality;
        invcal_rotation found;
        invcal_frame_init(&frame);
        for (int k = 0; k < counts[n]; k++) {
            add(&frame, same, faces[k], faces[k]);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_frame_solve(&frame, &found, &quality));
        for (int i = 0; i < 3; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-6, expected[n][i], (double)quality.sigma[i]);
        }
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(6e-4, 3e-8), 0, (double)quality.scatter);
    }
}

/* The directions of many draws with noise s are off by s sigma. */
static void sigma_is_the_scatter_of_the_angles(void)
{
    static const double same[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double noise = 0.01;
    const int runs = SOME(2000);
    random_source random = random_start(2);
    double squares[3] = {0};

    for (int n = 0; n < runs; n++) {
        invcal_frame frame;
        invcal_rotation found;
        invcal_frame_init(&frame);
        for (int k = 0; k < 3; k++) {
            double up[3];
            for (int i = 0; i < 3; i++) {
                up[i] = faces[k][i] + noise * random_normal(&random);
            }
            add(&frame, same, up, faces[k]);
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_frame_solve(&frame, &found, NULL));
        for (int i = 0; i < 3; i++) {
            const double angle = (double)found.r[(i + 2) % 3][(i + 1) % 3];
            squares[i] += angle * angle / runs;
        }
    }
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(6 / sqrt(2.0 * runs) * 0.7071, 0.7071, sqrt(squares[i]) / noise);
    }
}

/* A table that leans by t to any side: each face twice, half a turn about the vertical in between. */
static void the_tilt_of_a_table_cancels_in_pairs(void)
{
    const double t = 0.5 * 3.14159265358979324 / 180;
    random_source random = random_start(3);
    invcal_frame frame;
    invcal_frame_quality quality;
    invcal_rotation found;
    double r[3][3];

    random_rotation(&random, r);
    invcal_frame_init(&frame);
    for (int k = 0; k < 3; k++) {
        for (int half = 0; half < 2; half++) {
            const double lean = half == 0 ? sin(t) : -sin(t);
            double up[3] = {0, 0, 0};
            up[k == 0 ? 2 : k - 1] = cos(t);
            up[k == 0 ? 0 : k == 1 ? 1 : 2] += 0.6 * lean;
            up[k == 0 ? 1 : k == 1 ? 2 : 0] += 0.8 * lean;
            TEST_ASSERT_EQUAL_INT(INVCAL_OK, add(&frame, (const double(*)[3])r, up, faces[k]));
        }
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_frame_solve(&frame, &found, &quality));
    is_rotation((const double(*)[3])r, (const invcal_real(*)[3])found.r,
                FLOAT_OR_DOUBLE(1e-6, 1e-12));
    TEST_ASSERT_DOUBLE_WITHIN(3e-5, t, (double)quality.scatter);
}

static void one_way_up_is_refused_and_so_is_its_opposite_or_a_mirror(void)
{
    static const double same[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const double mirror[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    invcal_rotation found = {{{7, 7, 7}, {7, 7, 7}, {7, 7, 7}}};
    invcal_frame frame;

    invcal_frame_init(&frame);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_frame_solve(&frame, &found, NULL));
    add(&frame, same, faces[0], faces[0]);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_frame_solve(&frame, &found, NULL));
    add(&frame, same, faces[0], faces[0]);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_frame_solve(&frame, &found, NULL));
    add(&frame, same, faces[3], faces[3]);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_frame_solve(&frame, &found, NULL));
    invcal_frame_init(&frame);
    for (int k = 0; k < 3; k++) {
        add(&frame, mirror, faces[k], faces[k]);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_frame_solve(&frame, &found, NULL));
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_TRUE(found.r[i / 3][i % 3] == 7); /* untouched */
    }
}

/* Two faces at an angle t have the squared product (9/4 sin^2 t)^2 of singular values: 0.18 at 25.74 degrees. */
static void two_faces_may_be_26_degrees_apart(void)
{
    static const double same[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    for (int n = 0; n < 2; n++) {
        const double t = (n == 0 ? 25.5 : 26.0) * 3.14159265358979324 / 180;
        const double other[3] = {sin(t), 0, cos(t)};
        invcal_rotation found;
        invcal_frame frame;
        invcal_frame_init(&frame);
        add(&frame, same, faces[0], faces[0]);
        add(&frame, same, other, other);
        TEST_ASSERT_EQUAL_INT(n == 0 ? INVCAL_UNDETERMINED : INVCAL_OK,
                              invcal_frame_solve(&frame, &found, NULL));
    }
}

static void bad_input_leaves_the_sums_as_they_were(void)
{
    static const double same[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const double diagonal[3] = {1, 1, 0};
    static const double far[3] = {3, 0, 0};
    static const double little[3] = {0.4, 0, 0};
    const double nothing[3] = {NOT_A_NUMBER, 0, 0};
    invcal_frame frame;
    invcal_frame before;

    invcal_frame_init(&frame);
    add(&frame, same, faces[0], faces[0]);
    before = frame;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_DIRECTION, add(&frame, same, faces[0], diagonal));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_DIRECTION, add(&frame, same, faces[0], nothing));
    TEST_ASSERT_EQUAL_INT(INVCAL_NOT_FINITE, add(&frame, same, nothing, faces[0]));
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, add(&frame, same, far, faces[0]));
    TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, add(&frame, same, little, faces[0]));
    TEST_ASSERT_EQUAL_MEMORY(&before, &frame, sizeof frame);
    frame.count = UINT_MAX;
    add(&frame, same, faces[0], faces[0]);
    TEST_ASSERT_TRUE(frame.count == UINT_MAX);
}

/* A trim turns the up direction to where it should be, and nothing about it. */
static void a_single_face_is_levelled_the_shortest_way(void)
{
    const double t = 0.3;
    const double lean[3][3] = {{cos(t), 0, sin(t)}, {0, 1, 0}, {-sin(t), 0, cos(t)}};
    static const invcal_real up[3] = {0, 0, 1};
    static const invcal_real down[3] = {0, 0, -1};
    invcal_rotation found;
    invcal_frame frame;

    invcal_frame_init(&frame);
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_frame_level(&frame, up, &found));
    add(&frame, lean, faces[0], faces[0]);
    add(&frame, lean, faces[0], faces[0]);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_frame_level(&frame, up, &found));
    is_rotation(lean, (const invcal_real(*)[3])found.r, FLOAT_OR_DOUBLE(3e-7, 1e-15));
    invcal_frame_init(&frame);
    add(&frame, lean, faces[3], faces[0]);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_frame_level(&frame, up, &found));
    invcal_frame_init(&frame);
    add(&frame, lean, faces[3], faces[3]);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_frame_level(&frame, down, &found));
    is_rotation(lean, (const invcal_real(*)[3])found.r, FLOAT_OR_DOUBLE(3e-7, 1e-15));
}

/* Also if that is not a face: (2 1 2) / 3 is perpendicular to the axis (1 0 -1) of the turn, so
 * that no other turn is shorter. Not by other faces: their directions do not agree on one. */
static void any_orientation_is_levelled_the_shortest_way(void)
{
    const double turn[3] = {0.3, 0, -0.3};
    static const double up[3] = {2.0 / 3, 1.0 / 3, 2.0 / 3};
    const invcal_real stated[3] = {(invcal_real)up[0], (invcal_real)up[1], (invcal_real)up[2]};
    invcal_rotation found;
    invcal_frame frame;
    double r[3][3];

    rotation_by(turn, r);
    invcal_frame_init(&frame);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, add(&frame, (const double(*)[3])r, up, up));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_frame_level(&frame, stated, &found));
    is_rotation((const double(*)[3])r, (const invcal_real(*)[3])found.r,
                FLOAT_OR_DOUBLE(5e-7, 1e-15));
    invcal_frame_init(&frame);
    for (int k = 0; k < 3; k++) { /* by three faces, each along its axis */
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, add(&frame, (const double(*)[3])r, faces[k], faces[k]));
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_frame_level(&frame, stated, &found));
}

/* Two directions 2 t apart have a mean of length cos t: 0.9 at 25.84 degrees. Three of which one is
 * opposite: 1/3. */
static void rests_that_contradict_each_other_are_not_levelled(void)
{
    static const double same[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const invcal_real up[3] = {0, 0, 1};
    static const double apart[] = {0, 10, 51.5, 52, 90, 120, 180};
    invcal_frame frame;

    for (int n = 0; n < 7; n++) {
        const double t = apart[n] * 3.14159265358979324 / 180;
        const double other[3] = {sin(t), 0, cos(t)};
        invcal_rotation found = {{{7, 7, 7}, {7, 7, 7}, {7, 7, 7}}};
        invcal_frame_init(&frame);
        add(&frame, same, faces[0], faces[0]);
        add(&frame, same, other, faces[0]);
        TEST_ASSERT_EQUAL_INT(n < 3 ? INVCAL_OK : INVCAL_UNDETERMINED,
                              invcal_frame_level(&frame, up, &found));
        TEST_ASSERT_TRUE(n < 3 || found.r[0][0] == 7); /* untouched */
    }
    invcal_rotation found;
    invcal_frame_init(&frame);
    add(&frame, same, faces[0], faces[0]);
    add(&frame, same, faces[0], faces[0]);
    add(&frame, same, faces[3], faces[0]);
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, invcal_frame_level(&frame, up, &found));
}

/* Half and twice the field are the limits. */
static void lengths_at_the_limit_count(void)
{
    static const double same[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const double half[3] = {0.5, 0, 0};
    static const double twice[3] = {0, 2, 0};
    invcal_frame frame;

    invcal_frame_init(&frame);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, add(&frame, same, half, faces[1]));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, add(&frame, same, twice, faces[2]));
    TEST_ASSERT_EQUAL_UINT(2, frame.count);
}

static void a_calibration_is_turned_from_the_left(void)
{
    static const invcal_rotation all_axes = {{{2, -1, 2}, {2, 2, -1}, {-1, 2, 2}}};
    invcal_calibration c = {{1, 2, 3}, {{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}};
    static const double expected[3][3] = {{12, 15, 20}, {3, 6, 8}, {21, 24, 29}};

    invcal_rotate(&c, &all_axes);
    is_rotation(expected, (const invcal_real(*)[3])c.matrix, 0);
    TEST_ASSERT_TRUE(c.offset[0] == 1 && c.offset[1] == 2 && c.offset[2] == 3);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(any_rotation_comes_back_from_two_faces_and_from_more);
    RUN_TEST(sigma_is_that_of_closed_form);
    RUN_TEST(sigma_is_the_scatter_of_the_angles);
    RUN_TEST(the_tilt_of_a_table_cancels_in_pairs);
    RUN_TEST(one_way_up_is_refused_and_so_is_its_opposite_or_a_mirror);
    RUN_TEST(two_faces_may_be_26_degrees_apart);
    RUN_TEST(bad_input_leaves_the_sums_as_they_were);
    RUN_TEST(a_single_face_is_levelled_the_shortest_way);
    RUN_TEST(any_orientation_is_levelled_the_shortest_way);
    RUN_TEST(rests_that_contradict_each_other_are_not_levelled);
    RUN_TEST(lengths_at_the_limit_count);
    RUN_TEST(a_calibration_is_turned_from_the_left);
    return UNITY_END();
}
