/* SPDX-License-Identifier: MIT
 *
 * invcal_calibrate: what it calls good, and what it names. Its outliers are in
 * test_outliers.c.
 *
 * When may it say "good"? Of thousands of simulated sensors with one fault each, the share that is
 * called good and yet wrong by more than 5 sigma. -DDRAWS=10000 gives it to a tenth of a per cent.
 */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "expected.h"
#include "invcal/expert.h"
#include "invcal/result.h"
#include "support.h"
#include "unity.h"

#ifndef JUDGED_DRAWS
#define JUDGED_DRAWS 300
#endif

void setUp(void)
{
}

void tearDown(void)
{
}

enum { N = INVCAL_PARAMETERS, CAPACITY = INVCAL_MAX_POSITIONS };
enum { DRIFT = 1 << INVCAL_DRIFT, HYSTERESIS = 1 << INVCAL_HYSTERESIS, ALL = 0x1E };
static const double SIGMA = 1e-4;

static invcal_mask bit(unsigned i)
{
    return (invcal_mask)1 << i;
}

static unsigned size_of(invcal_mask set)
{
    unsigned n = 0;

    for (; set > 0; set &= set - 1) {
        n++;
    }
    return n;
}

/* ---- directions in the order in which they are visited --------------------------------------- */

typedef struct {
    const char *name;
    const double (*fixed)[3]; /* null: random ones */
    unsigned count;
    unsigned times; /* of visits to each */
} program;

static const program programs[] = {
    {"12 random", NULL, 12, 1},
    {"14 random", NULL, 14, 1},
    {"the paper's 18", expected_plan18, 18, 1},
    {"faces and edges", expected_faces_and_edges, 18, 1},
    {"18 random", NULL, 18, 1},
    {"24 random", NULL, 24, 1},
    {"38 random", NULL, 38, 1},
};
enum { R12, R14, P18, E18, R18, R24, R38, PROGRAMS };

/* Faces and edges in their usual order hide a drift; taking every fifth one next does not. */
enum { STRIDE = 5 };

static void choose_directions(const program *p, random_source *random, double v[][3])
{
    const unsigned some = p->count / p->times;

    for (unsigned i = 0; i < p->count; i++) {
        if (i >= some) {
            memcpy(v[i], v[i - some], sizeof v[i]);
        } else if (p->fixed) {
            const unsigned next = p->fixed == expected_faces_and_edges ? i * STRIDE % some : i;
            memcpy(v[i], p->fixed[next], sizeof v[i]);
        } else {
            random_direction(random, v[i]);
        }
    }
}

/* ---- a sensor with a fault ------------------------------------------------------------------- */

typedef enum {
    SOUND,
    DRIFTS,                /* in any direction, by `size` from the first position to the last */
    STEPS,                 /* the same, all at once, somewhere in the middle third */
    IS_QUADRATIC,          /* one axis: an error of `size` where it points up or down, */
    IS_CUBIC,              /* and here of either sign */
    HAS_HYSTERESIS,        /* each axis: `size` more or less, as it was turned to get there */
    IS_NOISY,              /* ten times as noisy as stated */
    IS_NOISY_NOW_AND_THEN, /* a quarter of the positions is */
    READS_WRONG            /* this many positions, by `size` of either sign */
} fault;

typedef struct {
    fault what;
    double size;
    unsigned some; /* positions that are wrong */
} faulty;

/* A draw of it. */
typedef struct {
    triad_truth truth;
    reading_set set;
    invcal_mask wrong;
} sample;

/* What is common to one draw of a fault. */
typedef struct {
    double direction[3];
    unsigned axis;
    double sign;
    unsigned step;
} chosen;

static double sign_of(random_source *random)
{
    return random_uniform(random, -1, 1) < 0 ? -1 : 1;
}

static double error_on(const faulty *f, const chosen *c, const program *p, unsigned i,
                       unsigned axis, double x, double before)
{
    const double on_axis = axis == c->axis ? c->sign * f->size : 0;

    switch (f->what) {
    case DRIFTS:
        return f->size * c->direction[axis] * (i / (p->count - 1.0) - 0.5);
    case STEPS:
        return f->size * c->direction[axis] * (i < c->step ? -0.5 : 0.5);
    case IS_QUADRATIC:
        return on_axis * (x * x - 1.0 / 3);
    case IS_CUBIC:
        return on_axis * x * (x * x - 0.6);
    case HAS_HYSTERESIS:
        return i == 0 || fabs(x - before) <= 1e-3 ? 0 : x > before ? f->size : -f->size;
    default:
        return 0;
    }
}

static double noise_of(const faulty *f, random_source *random)
{
    return f->what == IS_NOISY                                                       ? 10 * SIGMA
           : f->what == IS_NOISY_NOW_AND_THEN && random_uniform(random, 0, 1) < 0.25 ? 10 * SIGMA
                                                                                     : SIGMA;
}

/* Some positions read too much or too little. */
static void spoil(const faulty *f, random_source *random, sample *s)
{
    while (size_of(s->wrong) < f->some) {
        const unsigned i = (unsigned)random_uniform(random, 0, s->set.count);
        if (!(s->wrong & bit(i))) {
            const double u[3] = {(double)s->set.u[i][0], (double)s->set.u[i][1],
                                 (double)s->set.u[i][2]};
            const double stretch = 1 + sign_of(random) * f->size / length3(u);
            for (int k = 0; k < 3; k++) {
                s->set.u[i][k] = (invcal_real)(u[k] * stretch);
            }
            s->wrong |= bit(i);
        }
    }
}

static void draw(const faulty *f, const program *p, random_source *random, sample *s)
{
    double v[MAX_POSITIONS][3];
    chosen c;

    choose_directions(p, random, v);
    for (int r = 0; r < N; r++) {
        s->truth.x[r] = 0.02 * random_normal(random);
    }
    random_direction(random, c.direction);
    c.axis = (unsigned)random_uniform(random, 0, 3);
    c.sign = sign_of(random);
    c.step = p->count / 3 + (unsigned)random_uniform(random, 0, p->count - 2 * (p->count / 3));
    for (unsigned i = 0; i < p->count; i++) {
        double u[3];
        triad_read(&s->truth, v[i], u);
        const double noise = noise_of(f, random);
        for (unsigned k = 0; k < 3; k++) {
            u[k] += error_on(f, &c, p, i, k, v[i][k], i > 0 ? v[i - 1][k] : v[i][k]);
            s->set.u[i][k] = (invcal_real)(u[k] + noise * random_normal(random));
        }
    }
    s->set.count = p->count;
    s->wrong = 0;
    spoil(f, random, s);
}

static invcal_status judge(const reading_set *set, double stated, invcal_calibration *out,
                           invcal_quality *quality)
{
    const invcal_calibration nominal = unit_nominal();

    return invcal_calibrate(POSITIONS_OF(set->u[0], set->count, &nominal, (invcal_real)stated), out,
                            quality);
}

/* ---- what comes of it, as shares of the draws ------------------------------------------------ */

typedef struct {
    double wrong; /* good, and some parameter is beyond 5 sigma */
    double alarm; /* not good, and not for being weak; or something was left out */
    double exact; /* just those are left out that are wrong */
} shares;

static int is_beyond_5_sigma(const triad_truth *truth, const invcal_calibration *c,
                             const invcal_quality *q)
{
    const invcal_calibration nominal = unit_nominal();
    const triad_truth found = truth_of(c, &nominal);

    for (unsigned r = 0; r < N; r++) {
        if (!(fabs(found.x[r] - truth->x[r]) <= 5 * (double)q->sigma[r])) {
            return 1;
        }
    }
    return 0;
}

static shares try_often(const faulty *f, const program *p, double stated, uint32_t seed)
{
    random_source random = random_start(seed);
    shares s = {0, 0, 0};

    for (unsigned i = 0; i < JUDGED_DRAWS; i++) {
        invcal_calibration c;
        invcal_quality q;
        sample one;
        draw(f, p, &random, &one);
        if (judge(&one.set, stated, &c, &q) != INVCAL_OK) {
            continue;
        }
        s.wrong += q.verdict == INVCAL_GOOD && is_beyond_5_sigma(&one.truth, &c, &q);
        s.alarm += (q.verdict != INVCAL_GOOD && q.verdict != INVCAL_WEAK) || q.left_out != 0;
        s.exact += q.left_out == one.wrong;
    }
    s.wrong /= JUDGED_DRAWS;
    s.alarm /= JUDGED_DRAWS;
    s.exact /= JUDGED_DRAWS;
    return s;
}

/* ---- the tables ------------------------------------------------------------------------------ */

enum { NO_FIGURE = -1 };

/* A share that is to be no more than `most` per cent: 3 sigma of so many draws above it, and one
 * draw, for what hardly ever comes. A figure of 0 is less than half of its last place. */
static void assert_at_most(double most, double share, const char *what, const char *where)
{
    char message[100];
    const double p = fmax(most / 100, 0.0005);
    const double bound = p + 3 * sqrt(p * (1 - p) / JUDGED_DRAWS) + 1.0 / JUDGED_DRAWS;

    (void)strcpy(message, what);
    (void)strcat(message, ", ");
    (void)strcat(message, where);
    TEST_ASSERT_TRUE_MESSAGE(share <= bound, message);
}

typedef struct {
    const char *name;
    faulty fault;
    double most[PROGRAMS]; /* per cent */
} row;

static void assert_table(const row *rows, unsigned count, double stated, uint32_t seed)
{
    for (unsigned i = 0; i < count; i++) {
        for (unsigned k = 0; k < PROGRAMS && programs[k].count <= CAPACITY; k++) {
            if (rows[i].most[k] >= 0) {
                const shares s = try_often(&rows[i].fault, &programs[k], stated, seed + 10 * i + k);
                assert_at_most(rows[i].most[k], s.wrong, rows[i].name, programs[k].name);
            }
        }
    }
}

static void a_fault_is_hardly_ever_called_good(void)
{
    static const row rows[] = {
        {"drift of 1 mg", {DRIFTS, 1e-3, 0}, {4.2, 2.3, 0.3, 0, 1.2, 0.5, 0}},
        {"drift of 5 mg", {DRIFTS, 5e-3, 0}, {4.0, 0.6, 0, 0, 0, 0, 0}},
        {"step of 2 mg", {STEPS, 2e-3, 0}, {7.9, 4.5, 1.7, 0.3, 1.0, 0, 0}},
        {"cubic 0.2 %", {IS_CUBIC, 2e-3, 0}, {13, 13, 0.8, 0.1, 9.9, 5.2, 0.1}},
        {"cubic 1 %", {IS_CUBIC, 1e-2, 0}, {7.7, 2.6, 0, 0, 0.5, 0.1, 0}},
        {"quadratic 0.2 %", {IS_QUADRATIC, 2e-3, 0}, {24, 15.2, 0, 0.7, 5.3, 0.4, 0}},
        {"hysteresis of 1 mg", {HAS_HYSTERESIS, 1e-3, 0}, {4.5, 1.1, 0, 0.1, 0, 0, 0}},
        {"ten times the noise", {IS_NOISY, 0, 0}, {2.4, 1.5, 0.4, 0.4, 0.5, 0, 0}},
        {"noisy rests", {IS_NOISY_NOW_AND_THEN, 0, 0}, {6.3, 4.5, 1.7, 0.9, 2.9, 0.9, 0.2}},
    };

    assert_table(rows, sizeof rows / sizeof rows[0], SIGMA, 1000);
}

static void nor_is_it_where_no_noise_is_stated(void)
{
    static const row rows[] = {
        {"none", {SOUND, 0, 0}, {6.3, 3.0, 1.4, 1.5, 1.2, 0.5, 0.1}},
        {"drift of 5 mg",
         {DRIFTS, 5e-3, 0},
         {NO_FIGURE, NO_FIGURE, 0.1, NO_FIGURE, 0, 0, NO_FIGURE}},
        {"step of 5 mg",
         {STEPS, 5e-3, 0},
         {NO_FIGURE, NO_FIGURE, 2.6, NO_FIGURE, 2.9, NO_FIGURE, NO_FIGURE}},
        {"cubic 1 %",
         {IS_CUBIC, 1e-2, 0},
         {NO_FIGURE, NO_FIGURE, 0, NO_FIGURE, 11, 2.8, NO_FIGURE}},
        {"quadratic 0.2 %",
         {IS_QUADRATIC, 2e-3, 0},
         {NO_FIGURE, NO_FIGURE, 0.3, NO_FIGURE, NO_FIGURE, 0.7, NO_FIGURE}},
    };

    assert_table(rows, sizeof rows / sizeof rows[0], 0, 2000);
}

/* A sound sensor that is determined is called good. */
static void a_sound_sensor_raises_no_alarm(void)
{
    const faulty none = {SOUND, 0, 0};

    for (unsigned count = 12; count <= CAPACITY; count++) {
        const program random = {"random", NULL, count, 1};
        const shares stated = try_often(&none, &random, SIGMA, 3000 + count);
        const shares silent = try_often(&none, &random, 0, 3100 + count);
        assert_at_most(count > 20 ? 1.9 : 1.6, stated.alarm, "noise stated", random.name);
        assert_at_most(2.8, silent.alarm, "noise not stated", random.name);
    }
    for (unsigned k = P18; k <= E18; k++) {
        const shares stated = try_often(&none, &programs[k], SIGMA, 3200 + k);
        const shares silent = try_often(&none, &programs[k], 0, 3210 + k);
        assert_at_most(1.6, stated.alarm, "noise stated", programs[k].name);
        assert_at_most(2.7, silent.alarm, "noise not stated", programs[k].name);
    }
}

static void exactly_the_wrong_positions_are_left_out(void)
{
    static const struct {
        faulty fault;
        unsigned program;
        double least; /* per cent */
    } rows[] = {
        {{READS_WRONG, 0.005, 1}, P18, 99.8}, {{READS_WRONG, 0.005, 1}, R18, 99.3},
        {{READS_WRONG, 0.005, 1}, R24, 99.5}, {{READS_WRONG, 0.02, 2}, P18, 95.2},
        {{READS_WRONG, 0.02, 2}, R18, 99.9},  {{READS_WRONG, 0.02, 2}, R24, 99.3},
        {{READS_WRONG, 0.02, 3}, P18, 91.7},  {{READS_WRONG, 0.02, 3}, R18, 99.3},
        {{READS_WRONG, 0.02, 3}, R24, 99.6},
    };

    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const program *const p = &programs[rows[i].program];
        const shares s = try_often(&rows[i].fault, p, SIGMA, 4000 + i);
        assert_at_most(100 - rows[i].least, 1 - s.exact, "outliers", p->name);
    }
}

/* A cubic of 1 % repeats itself with the direction: the residuals agree, and would make a tiny
 * noise. */
static void repeated_directions_check_nothing(void)
{
    static const struct {
        program program;
        double most; /* per cent */
    } rows[] = {{{"9 twice", NULL, 18, 2}, 0},
                {{"10 twice", NULL, 20, 2}, 28},
                {{"12 twice", NULL, 24, 2}, 9},
                {{"14 twice", NULL, 28, 2}, 2},
                {{"18 twice", NULL, 36, 2}, 0}};
    const faulty cubic = {IS_CUBIC, 0.01, 0};

    for (unsigned i = 0; i < 5 && rows[i].program.count <= CAPACITY; i++) {
        const shares s = try_often(&cubic, &rows[i].program, SIGMA, 5000 + i);
        assert_at_most(rows[i].most, s.wrong, "cubic 1 %", rows[i].program.name);
    }
}

/* ---- sigma ----------------------------------------------------------------------------------- */

/* Random positions of a sound sensor: sigma over the true one, and the share of parameters within
 * their 95 % intervals. */
static void measure_sigma(unsigned positions, unsigned draws, double *sigma, double *covered)
{
    random_source random = random_start(6000 + positions);
    unsigned solved = 0;
    unsigned within = 0;

    *sigma = 0;
    while (solved < draws) {
        const program p = {"random", NULL, positions, 1};
        const faulty none = {SOUND, 0, 0};
        const invcal_calibration nominal = unit_nominal();
        invcal_calibration c;
        invcal_quality q;
        sample one;
        draw(&none, &p, &random, &one);
        if (calibrate_set(&one.set, SIGMA, &c, &q) != INVCAL_OK || q.weak != 0) {
            continue;
        }
        const triad_truth found = truth_of(&c, &nominal);
        for (unsigned r = 0; r < N; r++) {
            const double wide = (double)(invcal_coverage(q.sigma_dof) * q.sigma[r]);
            within += fabs(found.x[r] - one.truth.x[r]) <= wide;
        }
        *sigma += (double)q.noise / SIGMA / draws;
        solved++;
    }
    *covered = within / (9.0 * draws);
}

static void sigma_is_true_and_its_intervals_hold_where_the_noise_stated_is(void)
{
    static const struct {
        unsigned positions;
        double sigma, covered;
    } rows[] = {{10, 1.04, 0.986},
                {12, 1.01, 0.973},
                {15, 1.00, 0.962},
                {18, 0.99, 0.957},
                {24, 0.99, 0.953}};
    const unsigned draws = 10 * JUDGED_DRAWS;

    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        double sigma;
        double covered;
        measure_sigma(rows[i].positions, draws, &sigma, &covered);
        TEST_ASSERT_DOUBLE_WITHIN(0.005 + 0.6 / sqrt(draws), rows[i].sigma, sigma);
        TEST_ASSERT_DOUBLE_WITHIN(0.001 + 0.3 / sqrt(draws), rows[i].covered, covered);
    }
}

/* ---- what it names --------------------------------------------------------------------------- */

/* The error of an axis that points x up and pointed elsewhere before, as quality.size has it. */
static double error_of(unsigned kind, double x, double before, double tau)
{
    switch (kind) {
    case INVCAL_DRIFT:
        return tau;
    case INVCAL_QUADRATIC:
        return x * x;
    case INVCAL_CUBIC:
        return x * x * x;
    default:
        return x - before > 1e-3 ? 0.5 : x - before < -1e-3 ? -0.5 : 0;
    }
}

/* Readings without noise, with an error of one axis. */
static reading_set read_with_error(const program *p, random_source *random, unsigned kind,
                                   unsigned axis, double size)
{
    const triad_truth truth = triad_random(random, 0.03);
    double v[MAX_POSITIONS][3];
    reading_set set;

    choose_directions(p, random, v);
    set.count = p->count;
    for (unsigned i = 0; i < p->count; i++) {
        const double before = i > 0 ? v[i - 1][axis] : v[i][axis];
        const double tau = i / (p->count - 1.0) - 0.5;
        double u[3];
        triad_read(&truth, v[i], u);
        u[axis] += size * error_of(kind, v[i][axis], before, tau);
        for (int k = 0; k < 3; k++) {
            set.u[i][k] = (invcal_real)u[k];
        }
    }
    return set;
}

/* The triad's own errors of 3 % are in the size, too. */
static void an_error_that_all_share_is_named_with_its_axis_and_size(void)
{
    random_source random = random_start(11);

    for (unsigned draw = 0; draw < SOME(96); draw++) {
        const unsigned kind = INVCAL_DRIFT + draw % 4;
        const unsigned axis = draw / 4 % 3;
        const double size = draw / 12 % 2 ? -0.004 : 0.02;
        const program *const p = &programs[kind == INVCAL_HYSTERESIS || draw / 24 % 2 ? R18 : P18];
        const reading_set set = read_with_error(p, &random, kind, axis, size);
        invcal_calibration c;
        invcal_quality q;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, judge(&set, draw / 48 ? SIGMA : 0, &c, &q));
        TEST_ASSERT_EQUAL_UINT(kind, q.systematic);
        TEST_ASSERT_EQUAL_UINT(axis, q.axis);
        TEST_ASSERT_DOUBLE_WITHIN(0.1 * fabs(size), size, (double)q.size);
        TEST_ASSERT_TRUE(q.left_out == 0);
        if (q.weak == 0) {
            TEST_ASSERT_EQUAL_INT(kind == INVCAL_DRIFT ? INVCAL_DRIFTING : INVCAL_BENT, q.verdict);
        }
    }
}

static void a_sound_sensor_has_no_error_of_any_size(void)
{
    random_source random = random_start(12);
    const faulty none = {SOUND, 0, 0};
    invcal_calibration c;
    invcal_quality q;
    sample one;

    draw(&none, &programs[P18], &random, &one);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, judge(&one.set, SIGMA, &c, &q));
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, q.verdict);
    TEST_ASSERT_EQUAL_INT(INVCAL_NO_SYSTEMATIC, q.systematic);
    TEST_ASSERT_TRUE(q.size == 0 && q.axis == 0);
    TEST_ASSERT_TRUE(q.left_out == 0 && q.suspected == 0);
}

/* Like a magnetometer with the opposite sign, or a sensor soldered upside down. */
static void signs_are_those_of_the_field_however_the_axes_point(void)
{
    random_source random = random_start(13);
    reading_set set = read_with_error(&programs[P18], &random, INVCAL_DRIFT, 1, 0.004);
    invcal_calibration nominal = unit_nominal();
    invcal_calibration c;
    invcal_quality q;

    nominal.matrix[1][1] = -1;
    for (unsigned i = 0; i < set.count; i++) {
        set.u[i][1] = -set.u[i][1];
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_calibrate(POSITIONS_OF(set.u[0], 18, &nominal, 0), &c, &q));
    TEST_ASSERT_EQUAL_UINT(INVCAL_DRIFT, q.systematic);
    TEST_ASSERT_EQUAL_UINT(1, q.axis);
    TEST_ASSERT_DOUBLE_WITHIN(4e-4, 0.004, (double)q.size);
}

/* Neither hides the other. */
static void an_outlier_and_a_drift_are_told_apart(void)
{
    random_source random = random_start(14);
    unsigned both = 0;
    unsigned good = 0;

    for (unsigned i = 0; i < JUDGED_DRAWS; i++) {
        const faulty drifts = {DRIFTS, 0.005, 0};
        const faulty reads_wrong = {READS_WRONG, 0.1, 1};
        invcal_calibration c;
        invcal_quality q;
        sample one;
        draw(&drifts, &programs[P18], &random, &one);
        spoil(&reads_wrong, &random, &one);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, judge(&one.set, SIGMA, &c, &q));
        both += q.left_out == one.wrong && q.systematic == INVCAL_DRIFT;
        good += q.verdict == INVCAL_GOOD;
    }
    TEST_ASSERT_TRUE(both > 0.82 * JUDGED_DRAWS && good < 0.05 * JUDGED_DRAWS); /* 88 and 2.5 % */
}

static void what_the_order_of_positions_hides_is_unchecked(void)
{
    double as_they_stand[18][3];
    const struct {
        program program;
        unsigned unchecked;
    } rows[] = {
        {programs[P18], HYSTERESIS},
        {programs[E18], HYSTERESIS},
        {{"faces, then edges", (const double(*)[3])as_they_stand, 18, 1}, DRIFT | HYSTERESIS}};
    random_source random = random_start(15);
    const faulty none = {SOUND, 0, 0};

    memcpy(as_they_stand, expected_faces_and_edges, sizeof as_they_stand);
    for (unsigned k = 0; k < 3; k++) {
        invcal_calibration c;
        invcal_quality q;
        sample one;
        draw(&none, &rows[k].program, &random, &one);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, judge(&one.set, SIGMA, &c, &q));
        TEST_ASSERT_EQUAL_HEX8(rows[k].unchecked, q.unchecked);
    }
}

/* Nine unknowns fit whatever nine positions read: nothing remains to show an error. */
static void nine_positions_check_nothing(void)
{
    random_source random = random_start(16);
    const faulty wrong = {READS_WRONG, 0.01, 1};
    const program nine = {"9 random", NULL, 9, 1};

    for (unsigned i = 0; i < SOME(200); i++) {
        invcal_calibration c;
        invcal_quality q;
        sample one;
        draw(&wrong, &nine, &random, &one);
        if (judge(&one.set, i % 2 ? SIGMA : 0, &c, &q) != INVCAL_OK) {
            continue;
        }
        TEST_ASSERT_EQUAL_HEX8(ALL, q.unchecked);
        TEST_ASSERT_EQUAL_INT(q.weak ? INVCAL_WEAK : INVCAL_NO_REDUNDANCY, q.verdict);
        TEST_ASSERT_EQUAL_UINT(0, q.dof);
        TEST_ASSERT_TRUE(q.left_out == 0 && q.suspected == 0);
    }
}

/* ---- directions that count ------------------------------------------------------------------- */

/* All of p18, and the direction of one of them again, off by this many degrees. */
static invcal_quality judge_beside(unsigned position, double degrees, double error)
{
    const double angle = degrees / 57.29577951308232;
    const double *const at = expected_plan18[position];
    random_source random = random_start(17);
    const triad_truth truth = triad_random(&random, 0.03);
    double v[19][3];
    const double across[3] = {at[1], -at[0], 0}; /* at is not along z */
    const double length = length3(across);
    invcal_calibration c;
    invcal_quality q;
    reading_set set;

    memcpy(v, expected_plan18, sizeof expected_plan18);
    for (int k = 0; k < 3; k++) {
        v[18][k] = cos(angle) * at[k] + sin(angle) * across[k] / length;
    }
    read_positions(&truth, (const double(*)[3])v, 19, SIGMA, &random, &set);
    for (int k = 0; k < 3; k++) {
        set.u[position][k] *= (invcal_real)(1 + error);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, judge(&set, SIGMA, &c, &q));
    return q;
}

/* The errors of the triad are corrected: 5 degrees are those of the field. */
static void within_5_degrees_of_another_a_position_checks_nothing(void)
{
    for (unsigned i = 0; i < 18; i++) {
        if (fabs(expected_plan18[i][2]) > 0.99) {
            continue;
        }
        TEST_ASSERT_EQUAL_UINT(9, judge_beside(i, 0, 0).dof);
        TEST_ASSERT_EQUAL_UINT(9, judge_beside(i, 4.7, 0).dof);
        const invcal_quality far_off = judge_beside(i, 5.3, 0);
        TEST_ASSERT_EQUAL_UINT(10, far_off.dof);
        TEST_ASSERT_EQUAL_UINT(14, far_off.sigma_dof);
    }
}

/* A visit that was left out does not count. */
static void a_direction_is_not_repeated_after_one_that_was_left_out(void)
{
    const invcal_quality q = judge_beside(6, 1, 0.05);

    TEST_ASSERT_TRUE(q.left_out == bit(6));
    TEST_ASSERT_EQUAL_UINT(18, q.positions);
    TEST_ASSERT_EQUAL_UINT(9, q.dof);
    TEST_ASSERT_EQUAL_INT(INVCAL_GOOD, q.verdict);
}

/* Eighteen positions, nine residuals, and no check of the nine parameters. */
static void nine_directions_give_no_redundancy_however_often_they_are_visited(void)
{
    const program twice = {"9 twice", NULL, 18, 2};
    random_source random = random_start(18);
    const faulty none = {SOUND, 0, 0};
    unsigned solved = 0;

    for (unsigned i = 0; i < SOME(100); i++) {
        invcal_calibration c;
        invcal_quality q;
        sample one;
        draw(&none, &twice, &random, &one);
        if (judge(&one.set, SIGMA, &c, &q) == INVCAL_OK && q.weak == 0 && q.left_out == 0) {
            TEST_ASSERT_EQUAL_UINT(0, q.dof);
            TEST_ASSERT_TRUE(q.sigma_dof == 13 || q.sigma_dof == 9); /* but noise shows */
            TEST_ASSERT_TRUE(q.verdict == INVCAL_NO_REDUNDANCY || q.verdict >= INVCAL_ROUGH);
            solved += q.verdict == INVCAL_NO_REDUNDANCY;
        }
    }
    TEST_ASSERT_TRUE(solved > 25 || TEST_SHORT > 1);
}

/* ---- what is very wrong ---------------------------------------------------------------------- */

/* Then all positions together may not lie on an ellipsoid. */
static void one_that_is_wrong_by_half_the_field_is_left_out(void)
{
    static const struct {
        unsigned program;
        double least; /* share that is found */
    } rows[] = {{R12, 0.78}, {R18, 0.97}, {P18, 0.99}};
    const faulty wrong = {READS_WRONG, 0.5, 1};

    for (unsigned k = 0; k < 3; k++) {
        random_source random = random_start(19 + k);
        unsigned found = 0;
        unsigned hopeless = 0; /* for a calibration of all */
        unsigned saved = 0;    /* of these */
        unsigned missed = 0;   /* not found, and yet called good */
        for (unsigned i = 0; i < JUDGED_DRAWS; i++) {
            invcal_calibration c;
            invcal_quality q;
            sample one;
            draw(&wrong, &programs[rows[k].program], &random, &one);
            const int is_ellipsoid = calibrate_set(&one.set, SIGMA, &c, &q) != INVCAL_NOT_ELLIPSOID;
            const invcal_status status = judge(&one.set, SIGMA, &c, &q);
            const int is_found = status == INVCAL_OK && q.left_out == one.wrong;
            TEST_ASSERT_TRUE(status == INVCAL_OK || status == INVCAL_NOT_ELLIPSOID ||
                             status == INVCAL_UNDETERMINED);
            found += (unsigned)is_found;
            missed += !is_found && status == INVCAL_OK && q.verdict == INVCAL_GOOD;
            hopeless += !is_ellipsoid;
            saved += !is_ellipsoid && is_found;
        }
        TEST_ASSERT_TRUE(found >= rows[k].least * JUDGED_DRAWS);
        TEST_ASSERT_TRUE(hopeless > JUDGED_DRAWS / 5 && saved > 0.9 * hopeless);
        assert_at_most(0.2, (double)missed / JUDGED_DRAWS, "half the field",
                       programs[rows[k].program].name);
    }
}

/* Chance takes one in a hundred: more than one in six is something else. Each error is four times
 * the next, so that they are found one by one. */
static void more_than_one_in_six_left_out_is_rough(void)
{
    random_source random = random_start(23);
    const faulty none = {SOUND, 0, 0};
    unsigned good[6] = {0};
    unsigned rough[6] = {0};

    for (unsigned i = 0; i < SOME(400); i++) {
        const unsigned some = 1 + i % 5;
        const program *const p = &programs[i / 5 % 2 ? R24 : P18];
        invcal_calibration c;
        invcal_quality q;
        sample one;
        draw(&none, p, &random, &one);
        for (unsigned k = 0; k < some; k++) {
            const faulty wrong = {READS_WRONG, 0.3 / pow(4, k), k + 1};
            spoil(&wrong, &random, &one);
        }
        const invcal_status status = judge(&one.set, SIGMA, &c, &q);
        if (status != INVCAL_OK || q.left_out != one.wrong || q.weak) {
            continue;
        }
        if (6 * some > p->count) {
            TEST_ASSERT_TRUE(q.verdict >= INVCAL_ROUGH);
            rough[some]++;
        } else {
            good[some] += q.verdict == INVCAL_GOOD;
        }
    }
    if (TEST_SHORT == 1) { /* three of 18 and four of 24 may be */
        TEST_ASSERT_TRUE(good[1] > 60 && good[2] > 60 && good[3] > 60 && good[4] > 20);
        TEST_ASSERT_TRUE(rough[4] > 5 && rough[5] > 5);
    }
}

/* ---- refusals -------------------------------------------------------------------------------- */

typedef invcal_status calibrate_function(const invcal_positions *positions, invcal_calibration *out,
                                         invcal_quality *quality);

/* Also by the function that does not look for systematic errors. */
static void assert_refused_by(invcal_status expected, const reading_set *set,
                              const invcal_calibration *nominal, double noise)
{
    static calibrate_function *const calibrate[] = {invcal_calibrate, invcal_calibrate_robust};

    for (unsigned i = 0; i < 2; i++) {
        invcal_calibration out;
        invcal_quality quality;
        memset(&out, 0x5A, sizeof out);
        memset(&quality, 0x5A, sizeof quality);
        const invcal_calibration before = out;
        const invcal_quality unchanged = quality;
        TEST_ASSERT_EQUAL_INT(
            expected, calibrate[i](POSITIONS_OF(set->u[0], set->count, nominal, (invcal_real)noise),
                                   &out, &quality));
        TEST_ASSERT_EQUAL_MEMORY(&before, &out, sizeof out);
        TEST_ASSERT_EQUAL_MEMORY(&unchanged, &quality, sizeof quality);
    }
}

static void assert_refused(invcal_status expected, const reading_set *set)
{
    const invcal_calibration nominal = unit_nominal();

    assert_refused_by(expected, set, &nominal, 0);
}

static reading_set sound_set(unsigned count)
{
    const program p = {"random", NULL, count, 1};
    random_source random = random_start(24);
    const faulty none = {SOUND, 0, 0};
    sample one;

    draw(&none, &p, &random, &one);
    return one.set;
}

static void eight_positions_or_fewer_and_too_many_are_refused(void)
{
    reading_set set = sound_set(MAX_POSITIONS);

    for (set.count = 0; set.count < 9; set.count++) {
        assert_refused(INVCAL_TOO_FEW, &set);
    }
    for (; set.count <= CAPACITY; set.count++) {
        invcal_calibration c;
        invcal_quality q;
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, judge(&set, 0, &c, &q));
        TEST_ASSERT_EQUAL_UINT(set.count, q.positions + size_of(q.left_out));
    }
    for (; set.count <= MAX_POSITIONS; set.count++) {
        assert_refused(INVCAL_BAD_COUNT, &set);
    }
    set.count = UINT_MAX;
    assert_refused(INVCAL_BAD_COUNT, &set);
}

static void invalid_readings_are_refused(void)
{
    const struct {
        double value;
        invcal_status status;
    } bad[] = {{NOT_A_NUMBER, INVCAL_NOT_FINITE},
               {INFINITE, INVCAL_NOT_FINITE},
               {-INFINITE, INVCAL_NOT_FINITE},
               {11, INVCAL_OUT_OF_RANGE},
               {1e30, INVCAL_OUT_OF_RANGE}};

    for (unsigned b = 0; b < sizeof bad / sizeof bad[0]; b++) {
        for (unsigned i = 0; i < 18; i++) {
            reading_set set = sound_set(18);
            set.u[i][i % 3] = (invcal_real)bad[b].value;
            assert_refused(bad[b].status, &set);
        }
    }
    reading_set set = sound_set(18);
    memset(set.u[17], 0, sizeof set.u[17]);
    assert_refused(INVCAL_OUT_OF_RANGE, &set);
}

static void an_unusable_noise_or_nominal_is_refused(void)
{
    static const double bad[] = {-1, NOT_A_NUMBER, INFINITE, 1, 2}; /* 1: as much as the field */
    const reading_set set = sound_set(18);
    invcal_calibration nominal = unit_nominal();

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_refused_by(INVCAL_BAD_NOISE, &set, &nominal, bad[i]);
    }
    memset(nominal.matrix[1], 0, sizeof nominal.matrix[1]);
    assert_refused_by(INVCAL_BAD_NOMINAL, &set, &nominal, 0);
    nominal = unit_nominal();
    nominal.offset[2] = (invcal_real)NAN;
    assert_refused_by(INVCAL_BAD_NOMINAL, &set, &nominal, 0);
}

/* A plane, a cone, two cones: these show in no pivot, now and then. Six faces, four times each. */
static void positions_that_determine_nothing_are_refused(void)
{
    random_source random = random_start(25);

    for (int i = 0; i < SOME(300); i++) {
        const double noise = i % 2 ? 1e-5 : 0;
        const triad_truth truth = triad_random(&random, 0.03);
        double side[3][3];
        double v[24][3];
        reading_set set;
        random_rotation(&random, side);
        for (unsigned k = 0; k < 24; k++) {
            const double angle = random_uniform(&random, 0, 6.283185307179586);
            const double z = i % 3 == 0 ? 0 : i % 3 == 1 || k % 2 ? 0.5 : -0.3;
            for (int a = 0; a < 3; a++) {
                v[k][a] = z * side[2][a] +
                          sqrt(1 - z * z) * (cos(angle) * side[0][a] + sin(angle) * side[1][a]);
            }
        }
        read_positions(&truth, (const double(*)[3])v, 24, noise, &random, &set);
        assert_refused(INVCAL_UNDETERMINED, &set);
        for (unsigned k = 0; k < 24; k++) {
            memset(v[k], 0, sizeof v[k]);
            v[k][k % 3] = k % 6 < 3 ? 1 : -1;
        }
        read_positions(&truth, (const double(*)[3])v, 24, noise, &random, &set);
        assert_refused(INVCAL_UNDETERMINED, &set);
    }
}

/* Scattered about the edge of a hyperboloid, and leaving one out or two does not help. */
static void what_is_not_an_ellipsoid_without_one_either_is_refused(void)
{
    random_source random = random_start(26);
    reading_set set;

    for (set.count = 0; set.count < 18;) {
        double d[3];
        random_direction(&random, d);
        const double square = d[0] * d[0] + d[1] * d[1] - 0.5 * d[2] * d[2];
        if (square > 0.06) {
            for (int k = 0; k < 3; k++) {
                set.u[set.count][k] = (invcal_real)(d[k] / sqrt(square));
            }
            set.count++;
        }
    }
    assert_refused(INVCAL_NOT_ELLIPSOID, &set);
}

/* About a band so narrow that the others may not be determined without those that are to be left
 * out: no calibration may be half made. */
static void a_refusal_leaves_nothing_behind(void)
{
    random_source random = random_start(27);
    unsigned refused = 0;

    for (unsigned i = 0; i < SOME(2000); i++) {
        const triad_truth truth = triad_random(&random, 0.03);
        const unsigned count = 10 + i % 9;
        const double width = exp(random_uniform(&random, -5, -1));
        double v[18][3];
        reading_set set;
        for (unsigned k = 0; k < count; k++) {
            random_direction(&random, v[k]);
            v[k][2] *= width;
            const double length = length3(v[k]);
            for (int a = 0; a < 3; a++) {
                v[k][a] /= length;
            }
        }
        read_positions(&truth, (const double(*)[3])v, count, 1e-3, &random, &set);
        set.u[i % count][i % 3] += (invcal_real)random_uniform(&random, -0.6, 0.6);
        invcal_calibration c;
        invcal_quality q;
        memset(&c, 0x5A, sizeof c);
        memset(&q, 0x5A, sizeof q);
        const invcal_calibration before = c;
        const invcal_quality unchanged = q;
        if (judge(&set, i % 2 ? 1e-3 : 0, &c, &q) != INVCAL_OK) {
            TEST_ASSERT_EQUAL_MEMORY(&before, &c, sizeof c);
            TEST_ASSERT_EQUAL_MEMORY(&unchanged, &q, sizeof q);
            refused++;
        }
    }
    TEST_ASSERT_TRUE(refused > SOME(100));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_LONG_TEST(a_fault_is_hardly_ever_called_good);
    RUN_LONG_TEST(nor_is_it_where_no_noise_is_stated);
    RUN_LONG_TEST(a_sound_sensor_raises_no_alarm);
    RUN_LONG_TEST(exactly_the_wrong_positions_are_left_out);
    RUN_LONG_TEST(repeated_directions_check_nothing);
    RUN_LONG_TEST(sigma_is_true_and_its_intervals_hold_where_the_noise_stated_is);
    RUN_TEST(an_error_that_all_share_is_named_with_its_axis_and_size);
    RUN_TEST(a_sound_sensor_has_no_error_of_any_size);
    RUN_TEST(signs_are_those_of_the_field_however_the_axes_point);
    RUN_LONG_TEST(an_outlier_and_a_drift_are_told_apart);
    RUN_TEST(what_the_order_of_positions_hides_is_unchecked);
    RUN_TEST(nine_positions_check_nothing);
    RUN_SLOW_TEST(within_5_degrees_of_another_a_position_checks_nothing);
    RUN_TEST(a_direction_is_not_repeated_after_one_that_was_left_out);
    RUN_TEST(nine_directions_give_no_redundancy_however_often_they_are_visited);
    RUN_LONG_TEST(one_that_is_wrong_by_half_the_field_is_left_out);
    RUN_TEST(more_than_one_in_six_left_out_is_rough);
    RUN_SLOW_TEST(eight_positions_or_fewer_and_too_many_are_refused);
    RUN_SLOW_TEST(invalid_readings_are_refused);
    RUN_TEST(an_unusable_noise_or_nominal_is_refused);
    RUN_TEST(positions_that_determine_nothing_are_refused);
    RUN_TEST(what_is_not_an_ellipsoid_without_one_either_is_refused);
    RUN_LONG_TEST(a_refusal_leaves_nothing_behind);
    return UNITY_END() != 0;
}
