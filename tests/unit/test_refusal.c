/* SPDX-License-Identifier: MIT
 *
 * What must never give a calibration: families of random members, each with noise and without, seen
 * by a triad with errors of up to 5 % and from a random side.
 */
#include <math.h>
#include <string.h>

#include "core/solve.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { MEMBERS = 200 };
enum { ANY = 0x1FF, ANGLES = 0x1C0 }; /* parameters, as bits */
static const double TURN = 6.283185307179586;

typedef void (*family)(random_source *random, int member, double directions[][3], unsigned *count);

static void turn_all(random_source *random, double v[][3], unsigned count)
{
    double rotation[3][3];

    random_rotation(random, rotation);
    for (unsigned i = 0; i < count; i++) {
        const double a[3] = {v[i][0], v[i][1], v[i][2]};
        for (int k = 0; k < 3; k++) {
            v[i][k] = rotation[k][0] * a[0] + rotation[k][1] * a[1] + rotation[k][2] * a[2];
        }
    }
}

/* Directions at height z about the vertical axis. */
static void circle(random_source *random, double z, double v[][3], unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        const double angle = random_uniform(random, 0, TURN);
        v[i][0] = sqrt(1 - z * z) * cos(angle);
        v[i][1] = sqrt(1 - z * z) * sin(angle);
        v[i][2] = z;
    }
}

static void six_faces(random_source *random, int member, double v[][3], unsigned *count)
{
    *count = 6 * (1 + (unsigned)member % 4); /* repeated up to four times */
    memset(v, 0, *count * sizeof v[0]);
    for (unsigned i = 0; i < *count; i++) {
        v[i][i % 3] = i / 3 % 2 ? 1 : -1;
    }
    if (member % 2) {
        turn_all(random, v, *count);
    }
}

static void one_position(random_source *random, int member, double v[][3], unsigned *count)
{
    double only[3];

    *count = 9 + (unsigned)member % 30;
    random_direction(random, only);
    for (unsigned i = 0; i < *count; i++) {
        memcpy(v[i], only, sizeof only);
    }
}

static void one_plane(random_source *random, int member, double v[][3], unsigned *count)
{
    *count = 9 + (unsigned)member % 30;
    circle(random, 0, v, *count);
    if (member % 2) {
        turn_all(random, v, *count);
    }
}

static void one_cone(random_source *random, int member, double v[][3], unsigned *count)
{
    *count = 9 + (unsigned)member % 30;
    circle(random, random_uniform(random, -0.9, 0.9), v, *count);
    if (member % 2) {
        turn_all(random, v, *count);
    }
}

static void two_circles(random_source *random, int member, double v[][3], unsigned *count)
{
    const double z = random_uniform(random, -0.9, 0.9);

    *count = 10 + (unsigned)member % 30;
    circle(random, z, v, *count / 2);
    circle(random, random_uniform(random, -0.9, 0.9), v + *count / 2, *count - *count / 2);
    turn_all(random, v, *count);
}

/* Two planes through the origin: two great circles. */
static void two_great_circles(random_source *random, int member, double v[][3], unsigned *count)
{
    *count = 10 + (unsigned)member % 30;
    circle(random, 0, v, *count / 2);
    turn_all(random, v, *count / 2);
    circle(random, 0, v + *count / 2, *count - *count / 2);
}

static void a_cap_of_one_degree(random_source *random, int member, double v[][3], unsigned *count)
{
    *count = 9 + (unsigned)member % 30;
    for (unsigned i = 0; i < *count; i++) {
        circle(random, cos(random_uniform(random, 0, TURN / 360)), v + i, 1);
    }
    turn_all(random, v, *count);
}

static void fewer_than_nine(random_source *random, int member, double v[][3], unsigned *count)
{
    *count = (unsigned)member % 9;
    for (unsigned i = 0; i < *count; i++) {
        random_direction(random, v[i]);
    }
}

/* Calibrates a set and requires the expected refusal, with outputs untouched. Returns the number of
 * members that were accepted anyway. */
static unsigned assert_refused(const reading_set *set, invcal_status expected)
{
    invcal_calibration calibration;
    invcal_calibration calibration_before;
    invcal_quality quality;
    invcal_quality quality_before;

    memset(&calibration, 7, sizeof calibration);
    memset(&quality, 7, sizeof quality);
    calibration_before = calibration;
    quality_before = quality;
    const invcal_status status = calibrate_set(set, 0, &calibration, &quality);
    if (status == INVCAL_OK) {
        return 1;
    }
    TEST_ASSERT_EQUAL_INT(expected, status);
    TEST_ASSERT_EQUAL_MEMORY(&calibration_before, &calibration, sizeof calibration);
    TEST_ASSERT_EQUAL_MEMORY(&quality_before, &quality, sizeof quality);
    return 0;
}

static unsigned undetermined_of(const reading_set *set)
{
    const invcal_calibration nominal = unit_nominal();

    return invcal_undetermined(POSITIONS_OF(&set->u[0][0], set->count, &nominal, 0));
}

/* Every member is refused: for its number if that is below nine, else as expected; and at least
 * one of the parameters `open` is named. */
static void assert_family_refused(family make, invcal_status expected, unsigned open)
{
    random_source random = random_start(1);

    for (int member = 0; member < SOME(MEMBERS); member++) {
        double v[MAX_POSITIONS][3];
        unsigned count;
        reading_set set;
        const triad_truth truth = triad_random(&random, 0.05);
        make(&random, member, v, &count);
        read_positions(&truth, (const double(*)[3])v, count, 0, &random, &set);
        const invcal_status status = count < 9 ? INVCAL_TOO_FEW : expected;
        TEST_ASSERT_EQUAL_UINT(0, assert_refused(&set, status));
        TEST_ASSERT_TRUE((undetermined_of(&set) & open) != 0);
    }
}

static void fewer_than_nine_positions_are_refused(void)
{
    assert_family_refused(fewer_than_nine, INVCAL_TOO_FEW, ANY);
}

static void six_faces_alone_are_refused(void)
{
    assert_family_refused(six_faces, INVCAL_UNDETERMINED, ANGLES);
}

static void one_repeated_position_is_refused(void)
{
    assert_family_refused(one_position, INVCAL_UNDETERMINED, ANY);
}

static void positions_confined_to_a_plane_are_refused(void)
{
    assert_family_refused(one_plane, INVCAL_UNDETERMINED, ANY);
}

static void positions_on_a_cone_are_refused(void)
{
    assert_family_refused(one_cone, INVCAL_UNDETERMINED, ANY);
}

static void positions_on_two_parallel_circles_are_refused(void)
{
    assert_family_refused(two_circles, INVCAL_UNDETERMINED, ANY);
}

static void positions_on_two_great_circles_are_refused(void)
{
    assert_family_refused(two_great_circles, INVCAL_UNDETERMINED, ANY);
}

static void positions_within_a_cap_of_one_degree_are_refused(void)
{
    assert_family_refused(a_cap_of_one_degree, INVCAL_UNDETERMINED, ANY);
}

/* About a cone, scattered by 0.01 to 0.2: conditions of 10^4 to 10^8. */
static void about_a_cone(uint32_t seed, triad_truth *truth, reading_set *set)
{
    random_source random = random_start(seed);
    double v[MAX_POSITIONS][3];

    *truth = triad_random(&random, 0.1);
    const double spread = pow(10, random_uniform(&random, -2, -0.7));
    const unsigned count = 9 + (unsigned)random_uniform(&random, 0, MAX_POSITIONS - 8);
    circle(&random, cos(random_uniform(&random, 0.3, 1.2)), v, count);
    turn_all(&random, v, count);
    for (unsigned i = 0; i < count; i++) {
        double move[3];
        random_direction(&random, move);
        for (int k = 0; k < 3; k++) {
            v[i][k] += spread * move[k];
        }
        const double length = length3(v[i]);
        for (int k = 0; k < 3; k++) {
            v[i][k] /= length;
        }
    }
    read_positions(truth, (const double(*)[3])v, count, 0, &random, set);
}

/* If rounding has made the solution, readings calibrated by it may look well spread: of such sets
 * one in ten thousand came out in float as merely weak, wrong by half the field. The sums show
 * it. */
static void what_rounding_has_determined_is_refused(void)
{
    static const uint32_t seed[] = {5485, 20836, 21174, 25622, 109839};

    needs_53_bits();
    for (unsigned i = 0; i < sizeof seed / sizeof seed[0]; i++) {
        triad_truth truth;
        reading_set set;
        invcal_calibration c;
        invcal_quality q;
        about_a_cone(seed[i], &truth, &set);
        if (calibrate_set(&set, 0, &c, &q) != INVCAL_OK) {
            continue;
        }
        const double bound = (double)(INVCAL_LOSS * INVCAL_EPSILON * q.condition);
        for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
            TEST_ASSERT_DOUBLE_WITHIN(bound, truth.x[r], parameter(&c, r));
        }
    }
}

/* With noise such a set may look determined; then its sigma must be honest. */
static void assert_noisy_family_never_good(family make, double noise)
{
    random_source random = random_start(2);

    for (int member = 0; member < SOME(MEMBERS); member++) {
        double v[MAX_POSITIONS][3];
        unsigned count;
        reading_set set;
        const triad_truth truth = triad_random(&random, 0.05);
        invcal_calibration calibration;
        invcal_quality quality;
        make(&random, member, v, &count);
        read_positions(&truth, (const double(*)[3])v, count, noise, &random, &set);
        if (calibrate_set(&set, noise, &calibration, &quality) == INVCAL_OK) {
            TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, quality.verdict);
            TEST_ASSERT_TRUE(quality.weak != 0);
        }
    }
}

static void noise_does_not_make_them_good(void)
{
    static const family families[] = {six_faces,         one_position, one_plane,          one_cone,
                                      two_great_circles, two_circles,  a_cap_of_one_degree};
    static const double noise[] = {1e-5, 1e-4, 1e-3, 1e-2};

    for (unsigned f = 0; f < sizeof families / sizeof families[0]; f++) {
        for (unsigned i = 0; i < sizeof noise / sizeof noise[0]; i++) {
            assert_noisy_family_never_good(families[f], noise[i]);
        }
    }
}

static void a_plane_names_the_axis_across_it(void)
{
    random_source random = random_start(3);
    const triad_truth none = {{0}};
    double v[18][3];
    reading_set set;

    circle(&random, 0, v, 18);
    read_positions(&none, (const double(*)[3])v, 18, 0, &random, &set);
    TEST_ASSERT_EQUAL_UINT(0, assert_refused(&set, INVCAL_UNDETERMINED));
    TEST_ASSERT_EQUAL_HEX16(1u << INVCAL_DELTA_Z | 1u << INVCAL_DK_Z | 1u << INVCAL_GAMMA_XZ |
                                1u << INVCAL_GAMMA_ZY,
                            undetermined_of(&set));
}

static void six_faces_name_the_three_angles(void)
{
    random_source random = random_start(3);
    const triad_truth none = {{0}};
    double v[MAX_POSITIONS][3];
    unsigned count;
    reading_set set;

    six_faces(&random, 2, v, &count);
    read_positions(&none, (const double(*)[3])v, count, 0, &random, &set);
    TEST_ASSERT_EQUAL_UINT(0, assert_refused(&set, INVCAL_UNDETERMINED));
    TEST_ASSERT_EQUAL_HEX16(ANGLES, undetermined_of(&set));
}

/* Faces and edges without a field between x and y, but for four faces tilted by `tilt` rad:
 * sqrt(K) of gamma_xy is 1 / (2 tilt). */
static invcal_status calibrate_tilted(double tilt, invcal_quality *quality)
{
    static const double side[4][2] = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
    const triad_truth none = {{0}};
    random_source unused = random_start(0);
    double v[18][3] = {{0}};
    reading_set set;
    invcal_calibration calibration;

    for (int i = 0; i < 4; i++) {
        const double *s = side[i];
        const double edge[3][3] = {{s[0], 0, s[1]}, {0, s[0], s[1]}, {s[0], s[1] * tilt, 0}};
        for (int k = 0; k < 3; k++) {
            const double length = length3(edge[k]);
            for (int axis = 0; axis < 3; axis++) {
                v[3 * i + k][axis] = edge[k][axis] / length;
            }
        }
    }
    for (int i = 0; i < 6; i++) {
        v[12 + i][i % 3] = i < 3 ? 1 : -1;
    }
    read_positions(&none, (const double(*)[3])v, 18, 0, &unused, &set);
    return calibrate_set(&set, 1e-6, &calibration, quality);
}

static void a_parameter_beyond_a_thousand_is_refused_and_beyond_ten_weak(void)
{
    invcal_quality quality;

    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED, calibrate_tilted(0.4e-3, &quality)); /* 1250 */
    TEST_ASSERT_EQUAL_INT(FLOAT_OR_DOUBLE(INVCAL_UNDETERMINED, INVCAL_OK),
                          calibrate_tilted(0.6e-3, &quality)); /* 833: float cannot see it */
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_tilted(0.04, &quality)); /* 12.5 */
    TEST_ASSERT_EQUAL_INT(INVCAL_WEAK, quality.verdict);
    TEST_ASSERT_EQUAL_HEX16(1u << INVCAL_GAMMA_XY, quality.weak);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, calibrate_tilted(0.06, &quality)); /* 8.3 */
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, quality.verdict);
}

static void no_position_leaves_everything_open(void)
{
    const invcal_calibration nominal = unit_nominal();
    const invcal_calibration unreal = {{(invcal_real)NAN, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const invcal_real raw[6] = {0, 0, 1, 0, 0, (invcal_real)NAN};

    TEST_ASSERT_EQUAL_HEX16(ANY, invcal_undetermined(POSITIONS_OF(raw, 0, &nominal, 0)));
    TEST_ASSERT_EQUAL_HEX16(ANY, invcal_undetermined(POSITIONS_OF(raw, 2, &unreal, 0)));
    TEST_ASSERT_EQUAL_HEX16(ANY, invcal_undetermined(POSITIONS_OF(&raw[3], 1, &nominal, 0)));
}

/* Eight positions leave one combination open, and those that are not readings do not count. */
static void positions_that_are_not_readings_are_skipped(void)
{
    const invcal_calibration nominal = unit_nominal();
    invcal_real raw[8][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1}, {-1, 0, 0},
                             {0, -1, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}};

    TEST_ASSERT_EQUAL_HEX16(ANGLES, invcal_undetermined(POSITIONS_OF(&raw[0][0], 8, &nominal, 0)));
    raw[6][0] = 1000;
    raw[7][1] = (invcal_real)NAN;
    TEST_ASSERT_EQUAL_HEX16(ANGLES, invcal_undetermined(POSITIONS_OF(&raw[0][0], 8, &nominal, 0)));
    raw[2][2] = 0;
    TEST_ASSERT_TRUE(invcal_undetermined(POSITIONS_OF(&raw[0][0], 8, &nominal, 0)) &
                     (1u << INVCAL_DELTA_Z | 1u << INVCAL_DK_Z));
}

static void nothing_is_open_in_a_good_set(void)
{
    random_source random = random_start(4);
    const triad_truth truth = triad_random(&random, 0.1);
    double v[MAX_POSITIONS][3];
    reading_set set;

    for (int i = 0; i < 60; i++) {
        random_direction(&random, v[i]);
    }
    read_positions(&truth, (const double(*)[3])v, 60, 1e-3, &random, &set);
    TEST_ASSERT_EQUAL_HEX16(0, undetermined_of(&set));
}

/* Points on quadrics that are no ellipsoids: a u_x^2 + b u_y^2 + c u_z^2 = 1, some of a b c not
 * positive; found by scaling random directions onto the surface. */
static void readings_on_no_ellipsoid_are_refused(void)
{
    static const double form[][3] = {{1, 1, -1},   {1, -1, -1},   {1.5, 0.7, -0.3},
                                     {1, 1, -0.1}, {1, 0.8, 0.0}, {1, 1, -1e-2}};
    random_source random = random_start(5);
    unsigned delivered = 0;

    for (int member = 0; member < SOME(MEMBERS); member++) {
        const double *q = form[(unsigned)member % (sizeof form / sizeof form[0])];
        double rotation[3][3];
        reading_set set;
        invcal_calibration calibration;
        invcal_quality quality;
        random_rotation(&random, rotation);
        set.count = 20 + (unsigned)member % 40;
        for (unsigned i = 0; i < set.count;) {
            double d[3];
            random_direction(&random, d);
            const double square = q[0] * d[0] * d[0] + q[1] * d[1] * d[1] + q[2] * d[2] * d[2];
            const double radius = 1 / sqrt(square);
            if (square > 0 && radius < 5) {
                for (int k = 0; k < 3; k++) {
                    const double *r = rotation[k];
                    set.u[i][k] = (invcal_real)(radius * (r[0] * d[0] + r[1] * d[1] + r[2] * d[2]));
                }
                i++;
            }
        }
        const invcal_status status = calibrate_set(&set, 0, &calibration, &quality);
        TEST_ASSERT_TRUE(status == INVCAL_OK || status == INVCAL_NOT_ELLIPSOID);
        delivered += status == INVCAL_OK;
    }
    TEST_ASSERT_EQUAL_UINT(0, delivered);
}

/* Random clouds, and points on a cube: an ellipsoid fits, badly. */
static void clouds_and_cubes_are_refused(void)
{
    random_source random = random_start(6);

    for (int member = 0; member < SOME(MEMBERS); member++) {
        reading_set set;
        invcal_calibration calibration;
        invcal_quality quality;
        set.count = 40;
        for (unsigned i = 0; i < set.count; i++) {
            double d[3];
            random_direction(&random, d);
            const double largest = fmax(fabs(d[0]), fmax(fabs(d[1]), fabs(d[2])));
            const double radius = member % 2 ? random_uniform(&random, 0.3, 1.7)
                                             : random_uniform(&random, 1, 1.5) / largest;
            for (int k = 0; k < 3; k++) {
                set.u[i][k] = (invcal_real)(radius * d[k]);
            }
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_NOT_ELLIPSOID, calibrate_set(&set, 0, &calibration, &quality));
    }
}

static void one_bad_number_in_any_position_is_refused_and_its_position_named(void)
{
    const double bad[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 1e30, 1e4};
    random_source random = random_start(7);

    for (unsigned position = 0; position < 18; position++) {
        for (unsigned b = 0; b < sizeof bad / sizeof bad[0]; b++) {
            const triad_truth truth = triad_random(&random, 0.05);
            const invcal_calibration nominal = unit_nominal();
            double v[18][3];
            reading_set set;
            invcal_calibration calibration;
            invcal_quality quality;
            for (int i = 0; i < 18; i++) {
                random_direction(&random, v[i]);
            }
            read_positions(&truth, (const double(*)[3])v, 18, 0, &random, &set);
            set.u[position][position % 3] = (invcal_real)bad[b];
            TEST_ASSERT_EQUAL_INT(b < 3 ? INVCAL_NOT_FINITE : INVCAL_OUT_OF_RANGE,
                                  calibrate_set(&set, 0, &calibration, &quality));
            TEST_ASSERT_EQUAL_UINT(position,
                                   invcal_bad_reading(POSITIONS_OF(&set.u[0][0], 18, &nominal, 0)));
            set.u[17 - position][0] = (invcal_real)NAN; /* the first is named */
            TEST_ASSERT_EQUAL_UINT(position < 9 ? position : 17 - position,
                                   invcal_bad_reading(POSITIONS_OF(&set.u[0][0], 18, &nominal, 0)));
        }
    }
}

static void zero_and_subnormal_readings_are_refused(void)
{
    static const double length[] = {0, 1e-40, 1e-20, 1e-3};
    random_source random = random_start(8);

    for (unsigned i = 0; i < sizeof length / sizeof length[0]; i++) {
        reading_set set;
        invcal_calibration calibration;
        invcal_quality quality;
        set.count = 18;
        for (unsigned k = 0; k < 18; k++) {
            double d[3];
            random_direction(&random, d);
            for (int axis = 0; axis < 3; axis++) {
                set.u[k][axis] = (invcal_real)(length[i] * d[axis]);
            }
        }
        TEST_ASSERT_EQUAL_INT(INVCAL_OUT_OF_RANGE, calibrate_set(&set, 0, &calibration, &quality));
    }
}

static void where_every_reading_is_one_none_is_named(void)
{
    const invcal_calibration nominal = unit_nominal();
    const invcal_calibration wrong = {{0, 0, 0}, {{1, 0, 0}, {0, 20, 0}, {0, 0, 1}}};
    const invcal_real raw[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    TEST_ASSERT_EQUAL_UINT(3, invcal_bad_reading(POSITIONS_OF(raw, 3, &nominal, 0)));
    TEST_ASSERT_EQUAL_UINT(0, invcal_bad_reading(POSITIONS_OF(raw, 0, &nominal, 0)));
    TEST_ASSERT_EQUAL_UINT(1, invcal_bad_reading(POSITIONS_OF(raw, 3, &wrong, 0)));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(fewer_than_nine_positions_are_refused);
    RUN_TEST(six_faces_alone_are_refused);
    RUN_TEST(one_repeated_position_is_refused);
    RUN_TEST(positions_confined_to_a_plane_are_refused);
    RUN_TEST(positions_on_a_cone_are_refused);
    RUN_TEST(positions_on_two_parallel_circles_are_refused);
    RUN_TEST(positions_on_two_great_circles_are_refused);
    RUN_TEST(positions_within_a_cap_of_one_degree_are_refused);
    RUN_TEST(what_rounding_has_determined_is_refused);
    RUN_TEST(noise_does_not_make_them_good);
    RUN_TEST(a_plane_names_the_axis_across_it);
    RUN_TEST(six_faces_name_the_three_angles);
    RUN_TEST(a_parameter_beyond_a_thousand_is_refused_and_beyond_ten_weak);
    RUN_TEST(no_position_leaves_everything_open);
    RUN_TEST(positions_that_are_not_readings_are_skipped);
    RUN_TEST(nothing_is_open_in_a_good_set);
    RUN_TEST(readings_on_no_ellipsoid_are_refused);
    RUN_TEST(clouds_and_cubes_are_refused);
    RUN_TEST(one_bad_number_in_any_position_is_refused_and_its_position_named);
    RUN_TEST(zero_and_subnormal_readings_are_refused);
    RUN_TEST(where_every_reading_is_one_none_is_named);
    return UNITY_END() != 0;
}
