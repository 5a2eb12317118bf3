/* SPDX-License-Identifier: MIT */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "expected.h"
#include "invcal/expert.h"
#include "invcal/plan.h"
#include "positions.h"
#include "support.h"
#include "unity.h"

#ifndef DRAWS
#define DRAWS 2000 /* slow machines may take fewer; the bounds below are for these */
#endif

void setUp(void)
{
}

void tearDown(void)
{
}

enum { N = INVCAL_PARAMETERS, CAPACITY = INVCAL_MAX_POSITIONS };
static const double SIGMA = 1e-4;

static invcal_mask bit(unsigned i)
{
    return (invcal_mask)1 << i;
}

static unsigned size_of(invcal_mask set)
{
    unsigned n = 0;

    for (unsigned i = 0; i < CAPACITY; i++) {
        n += (set & bit(i)) != 0;
    }
    return n;
}

static void assert_set(invcal_mask expected, invcal_mask actual)
{
    TEST_ASSERT_EQUAL_HEX32((uint32_t)expected, (uint32_t)actual);
    TEST_ASSERT_TRUE(expected == actual); /* of 64 bits where there are more positions */
}

/* ---- readings, with errors planted --------------------------------------------------------------- */

static unsigned program_of(unsigned count, double v[][3])
{
    invcal_plan plan = {count / 3, {0, 0, 0}};
    invcal_plan_position position;

    if (count == 18) {
        memcpy(v, expected_plan18, sizeof expected_plan18);
        return count;
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_starts(plan.per_group, plan.start));
    for (unsigned i = 0; i < count; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_plan_position_at(&plan, i, &position));
        for (int k = 0; k < 3; k++) {
            v[i][k] = (double)position.vertical[k];
        }
    }
    return count;
}

static void random_directions(random_source *random, unsigned count, double v[][3])
{
    for (unsigned i = 0; i < count; i++) {
        random_direction(random, v[i]);
    }
}

/* Makes position i read too much by error. */
static void spoil(reading_set *set, unsigned i, double error)
{
    const double u[3] = {(double)set->u[i][0], (double)set->u[i][1], (double)set->u[i][2]};

    for (int k = 0; k < 3; k++) {
        set->u[i][k] = (invcal_real)(u[k] * (1 + error / length3(u)));
    }
}

/* Spoils some positions by an error of low to high, evenly in its logarithm, of either sign. */
static invcal_mask spoil_some(random_source *random, unsigned some, double low, double high,
                              reading_set *set, double *error)
{
    invcal_mask bad = 0;

    while (size_of(bad) < some) {
        const unsigned i = (unsigned)random_uniform(random, 0, set->count);
        if (!(bad & bit(i))) {
            *error = exp(random_uniform(random, log(low), log(high)));
            *error *= random_uniform(random, -1, 1) < 0 ? -1 : 1;
            spoil(set, i, *error);
            bad |= bit(i);
        }
    }
    return bad;
}

static invcal_outliers find(const reading_set *set, double stated)
{
    const invcal_calibration nominal = unit_nominal();
    invcal_outliers out;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_outliers_find(set->u[0], set->count, &nominal,
                                                          (invcal_real)stated, &out));
    return out;
}

/* Root mean square of |calibrated| - 1 over all directions, calibrated without some positions. */
static double error_without(const triad_truth *truth, const reading_set *set, invcal_mask removed)
{
    const invcal_calibration nominal = unit_nominal();
    reading_set left;
    invcal_calibration solution;
    const int points = 200; /* of Fibonacci's spiral */
    double squares = 0;

    left.count = 0;
    for (unsigned i = 0; i < set->count; i++) {
        if (!(removed & bit(i))) {
            memcpy(left.u[left.count++], set->u[i], sizeof set->u[i]);
        }
    }
    invcal_sums sums = sums_of(&left);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_solve(&sums, &nominal, &solution));
    for (int i = 0; i < points; i++) {
        const double z = 1 - (2 * i + 1.0) / points;
        const double angle = 2.399963229728653 * i;
        const double eta[3] = {sqrt(1 - z * z) * cos(angle), sqrt(1 - z * z) * sin(angle), z};
        const double e = calibrated_length(&solution, truth, eta) - 1;
        squares += e * e;
    }
    return sqrt(squares / points);
}

/* ---- how often they are found --------------------------------------------------------------------- */

typedef struct {
    unsigned positions; /* those of a program; 0 for random ones below */
    unsigned random_positions;
    unsigned some;
    double low, high; /* size of the errors */
    double stated;
} experiment;

typedef struct {
    double found;     /* shares of the draws: all that was planted was removed, */
    double innocent;  /* something else was, */
    double suspected; /* something is suspected, */
    double named;     /* all that was planted is removed or suspected */
    double refused;   /* the positions determine too little */
    double error;     /* root mean square error of the calibration afterwards */
} shares;

static shares try_often(const experiment *e, unsigned draws)
{
    random_source random = random_start(e->positions + 100 * e->random_positions + e->some);
    const invcal_calibration nominal = unit_nominal();
    shares s = {0, 0, 0, 0, 0, 0};

    for (unsigned draw = 0; draw < draws; draw++) {
        const triad_truth truth = triad_random(&random, 0.03);
        double v[CAPACITY][3];
        reading_set set;
        invcal_outliers out;
        double error = 0;
        if (e->positions) {
            (void)program_of(e->positions, v);
        } else {
            random_directions(&random, e->random_positions, v);
        }
        read_positions(&truth, (const double(*)[3])v, e->positions + e->random_positions, SIGMA,
                       &random, &set);
        const invcal_mask bad = spoil_some(&random, e->some, e->low, e->high, &set, &error);
        if (invcal_outliers_find(set.u[0], set.count, &nominal, (invcal_real)e->stated, &out) !=
            INVCAL_OK) {
            s.refused++;
            continue;
        }
        assert_set(0, out.removed & out.suspected);
        s.found += (out.removed & bad) == bad;
        s.innocent += (out.removed & ~bad) != 0;
        s.suspected += out.suspected != 0;
        s.named += ((out.removed | out.suspected) & bad) == bad;
        if (e->positions) {
            const double after = error_without(&truth, &set, out.removed);
            s.error += after * after;
        }
    }
    s.found /= draws;
    s.innocent /= draws;
    s.suspected /= draws;
    s.named /= draws;
    s.refused /= draws;
    s.error = sqrt(s.error / draws);
    return s;
}

static void one_of_18_that_is_wrong_is_found_and_the_calibration_is_as_good_as_without(void)
{
    static const double sizes[] = {0.05, 0.002};

    for (int i = 0; i < 2; i++) {
        const experiment e = {18, 0, 1, sizes[i], sizes[i], 0};
        const shares s = try_often(&e, DRAWS);
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.995, s.found);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.016, s.innocent);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(85e-6, s.error);
    }
}

static void two_of_18_and_three_of_24_are_found_that_hide_one_another(void)
{
    static const experiment e[] = {{18, 0, 2, 0.002, 0.1, 0}, {24, 0, 3, 0.002, 0.1, 0}};

    for (int i = 0; i < 2; i++) {
        const shares s = try_often(&e[i], DRAWS);
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.97, s.found);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.02, s.innocent);
    }
}

static void more_than_three_are_found_group_by_group(void)
{
    static const experiment e[] = {{24, 0, 4, 0.002, 0.1, 0}, {30, 0, 5, 0.002, 0.1, 0}};

    for (int i = 0; i < 2 && e[i].positions <= CAPACITY; i++) {
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.93, try_often(&e[i], DRAWS / 8).found);
    }
}

/* Six faces and twelve edges of a cube as a hand meets them, within 6 degrees on each axis. */
static void faces_and_edges(random_source *random, double v[][3])
{
    unsigned n = 0;

    for (int cell = 0; cell < 27; cell++) {
        const int at[3] = {cell / 9 - 1, cell / 3 % 3 - 1, cell % 3 - 1};
        const int sides = abs(at[0]) + abs(at[1]) + abs(at[2]);
        if (sides == 1 || sides == 2) {
            for (int k = 0; k < 3; k++) {
                v[n][k] = at[k] + 0.1 * random_normal(random);
            }
            const double length = length3(v[n]);
            for (int k = 0; k < 3; k++) {
                v[n][k] /= length;
            }
            n++;
        }
    }
    TEST_ASSERT_EQUAL_UINT(18, n);
}

/* The share of sets in which exactly those are removed that are wrong, by so many times the noise. */
static double share_exact(unsigned some, double times, unsigned draws)
{
    const double noise = 0.0005;
    random_source random = random_start(200 + some);
    unsigned exact = 0;

    for (unsigned draw = 0; draw < draws; draw++) {
        const triad_truth truth = triad_random(&random, 0.03);
        double v[18][3];
        reading_set set;
        double error;
        faces_and_edges(&random, v);
        read_positions(&truth, (const double(*)[3])v, 18, noise, &random, &set);
        const invcal_mask bad =
            spoil_some(&random, some, 0.75 * times * noise, 1.25 * times * noise, &set, &error);
        exact += find(&set, 0).removed == bad;
    }
    return (double)exact / draws;
}

static void of_faces_and_edges_met_by_hand_exactly_the_wrong_ones_are_found(void)
{
    static const double min[3][2] = {{0.985, 0.985}, {0.96, 0.98}, {0.70, 0.95}};

    for (unsigned some = 1; some <= 3; some++) {
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(min[some - 1][0], share_exact(some, 20, 2 * DRAWS));
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(min[some - 1][1], share_exact(some, 100, 2 * DRAWS));
    }
}

static void clean_positions_lose_one_in_a_hundred_sets_or_fewer(void)
{
    static const experiment e[] = {{18, 0, 0, 0, 0, 0},
                                   {24, 0, 0, 0, 0, 0},
                                   {0, 12, 0, 0, 0, 0},
                                   {0, 14, 0, 0, 0, 0},
                                   {0, 16, 0, 0, 0, 0}};

    for (unsigned i = 0; i < sizeof e / sizeof e[0]; i++) {
        const shares s = try_often(&e[i], DRAWS);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(e[i].positions ? 0.015 : 0.02, s.innocent);
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.001, s.innocent); /* by a test, not by none */
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.003, s.suspected);
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.002, s.refused);
    }
}

/* Eleven leave one degree of freedom beside an outlier, which would prove what it likes. */
static void of_eleven_positions_none_is_removed_unless_the_noise_is_stated(void)
{
    const experiment silent = {0, 11, 1, 0.05, 0.05, 0};
    const experiment stated = {0, 11, 1, 0.05, 0.05, 1e-4};
    const shares s = try_often(&silent, DRAWS / 4);

    TEST_ASSERT_TRUE(s.found == 0 && s.innocent == 0 && s.suspected == 0);
    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.3, try_often(&stated, DRAWS / 4).found);
}

static void a_stated_noise_helps_where_few_residuals_are_left(void)
{
    const experiment silent = {0, 12, 1, 0.002, 0.002, 0};
    const experiment stated = {0, 12, 1, 0.002, 0.002, 1e-4};

    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(2 * try_often(&silent, DRAWS / 2).found,
                                        try_often(&stated, DRAWS / 2).found);
}

static void a_stated_noise_may_be_wrong(void)
{
    static const struct {
        double stated;
        double innocent;
    } cases[] = {{1e-3, 0.002}, {1e-4, 0.01}, {5e-5, 0.015}, {1e-5, 0.035}};

    for (int i = 0; i < 4; i++) {
        const experiment clean = {18, 0, 0, 0, 0, cases[i].stated};
        const experiment wrong = {18, 0, 1, 0.01, 0.1, cases[i].stated};
        TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(cases[i].innocent, try_often(&clean, DRAWS / 2).innocent);
        TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(0.99, try_often(&wrong, DRAWS / 4).found);
    }
}

static void the_innocent_are_not_removed_where_two_positions_may_be_the_wrong_one(void)
{
    const experiment e = {0, 12, 1, 0.002, 0.002, 1e-4};
    const shares s = try_often(&e, DRAWS);

    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(0.008, s.innocent);
    TEST_ASSERT_GREATER_OR_EQUAL_DOUBLE(s.found + 0.03, s.named); /* suspected, not removed */
}

/* ---- an independent computation, in double ---------------------------------------------------------- */

typedef struct {
    double l[N][N]; /* Cholesky's factor of H'H */
    double p[N];
    double squares;
} least_squares;

static double row_of(const reading_set *set, unsigned i, double h[N])
{
    const double x = (double)set->u[i][0];
    const double y = (double)set->u[i][1];
    const double z = (double)set->u[i][2];
    const double row[N] = {x, y, z, x * x, y * y, z * z, x * y, x * z, y * z};

    memcpy(h, row, sizeof row);
    return (x * x + y * y + z * z - 1) / 2;
}

static void solve_lower(const least_squares *s, double x[N])
{
    for (int r = 0; r < N; r++) {
        for (int c = 0; c < r; c++) {
            x[r] -= s->l[r][c] * x[c];
        }
        x[r] /= s->l[r][r];
    }
}

static double residual_of(const least_squares *s, const reading_set *set, unsigned i)
{
    double h[N];
    double e = row_of(set, i, h);

    for (int r = 0; r < N; r++) {
        e += h[r] * s->p[r];
    }
    return e;
}

/* h K h' */
static double leverage_of(const least_squares *s, const reading_set *set, unsigned i)
{
    double h[N];
    double sum = 0;

    (void)row_of(set, i, h);
    solve_lower(s, h);
    for (int r = 0; r < N; r++) {
        sum += h[r] * h[r];
    }
    return sum;
}

static least_squares fit_without(const reading_set *set, invcal_mask removed)
{
    least_squares s = {{{0}}, {0}, 0};
    double h[N];

    for (unsigned i = 0; i < set->count; i++) {
        const double j = row_of(set, i, h);
        for (int r = 0; r < N && !(removed & bit(i)); r++) {
            for (int c = 0; c <= r; c++) {
                s.l[r][c] += h[r] * h[c];
            }
            s.p[r] -= h[r] * j;
        }
    }
    for (int r = 0; r < N; r++) {
        for (int c = 0; c <= r; c++) {
            for (int k = 0; k < c; k++) {
                s.l[r][c] -= s.l[r][k] * s.l[c][k];
            }
            s.l[r][c] = r == c ? sqrt(s.l[r][r]) : s.l[r][c] / s.l[c][c];
        }
    }
    solve_lower(&s, s.p);
    for (int r = N; r-- > 0;) {
        for (int k = r + 1; k < N; k++) {
            s.p[r] -= s.l[k][r] * s.p[k];
        }
        s.p[r] /= s.l[r][r];
    }
    for (unsigned i = 0; i < set->count; i++) {
        if (!(removed & bit(i))) {
            s.squares += pow(residual_of(&s, set, i), 2);
        }
    }
    return s;
}

/* The integral of sin^(dof-1) cos^(m-1), by the midpoint rule in 400 steps. */
static double part(double from, double to, unsigned m, unsigned dof)
{
    double sum = 0;

    for (int i = 0; i < 400; i++) {
        const double angle = from + (to - from) * (i + 0.5) / 400;
        sum += pow(sin(angle), dof - 1.0) * pow(cos(angle), m - 1.0);
    }
    return sum * (to - from);
}

static double tail(double z, unsigned m, unsigned dof)
{
    const double angle = asin(sqrt(z));
    const double below = part(0, angle, m, dof);

    return below / (below + part(angle, 1.5707963267948966, m, dof));
}

/* Sums of squares below this share of that of all positions are rounding. */
static const double ROUNDED = 256 * (double)INVCAL_EPSILON;

/* What is known of the noise besides the residuals. */
static double known_squares(const reading_set *set, double stated)
{
    const double rounding = 8 * (double)INVCAL_EPSILON;

    return set->count * rounding * rounding + stated * stated;
}

/* Does some pair of a group leave no more than this? */
static int has_pair(const double pair[CAPACITY][CAPACITY], unsigned count, invcal_mask group,
                    double most)
{
    for (unsigned i = 0; i < count; i++) {
        for (unsigned j = 0; j < i; j++) {
            if ((group & bit(i)) && (group & bit(j)) && pair[i][j] <= most) {
                return 1;
            }
        }
    }
    return 0;
}

/* Of the groups of k positions beside those removed: the best, the second best, and the squares
 * that they leave. Every group is fitted anew. Of three, only those with a pair that leaves no more
 * than a share of the squares. */
typedef struct {
    invcal_mask best, rival;
    double squares, rival_squares;
} winners;

static winners best_of(const reading_set *set, double stated, invcal_mask removed, unsigned k,
                       double share)
{
    static double pair[CAPACITY][CAPACITY];
    const double known = known_squares(set, stated);
    const double all = fit_without(set, removed).squares + known;
    winners w = {0, 0, INFINITE, INFINITE};

    for (unsigned i = 0; i < set->count && k == 3; i++) {
        for (unsigned j = 0; j < i; j++) {
            const invcal_mask both = bit(i) | bit(j);
            pair[i][j] =
                both & removed ? INFINITE : fit_without(set, removed | both).squares + known;
        }
    }
    for (invcal_mask group = 0; group < bit(set->count); group++) {
        if (size_of(group) == k && !(group & removed) &&
            (k < 3 || has_pair((const double(*)[CAPACITY])pair, set->count, group, share * all))) {
            const double left = fit_without(set, removed | group).squares + known;
            const double squares = left > ROUNDED * all ? left : ROUNDED * all;
            if (squares < w.squares) {
                w = (winners){group, w.best, squares, w.squares};
            } else if (squares < w.rival_squares) {
                w.rival = group;
                w.rival_squares = squares;
            }
        }
    }
    return w;
}

typedef struct {
    const reading_set *set;
    double stated;
    invcal_mask removed;
    invcal_mask suspected;
    int close; /* some decision is within 3 % of its level: rounding may turn it; or hangs on a
                  group that leaves next to nothing to determine the parameters by */
} decision;

/* det H'H without a group over that with it: 1 - h K h' of its members one after the other. */
static double determinant_left(const decision *d, invcal_mask group)
{
    const least_squares with = fit_without(d->set, d->removed);
    const least_squares without = fit_without(d->set, d->removed | group);
    double left = 1;

    for (int r = 0; r < N; r++) {
        left *= pow(without.l[r][r] / with.l[r][r], 2);
    }
    return left;
}

/* Is the chance, times the number of choices, within the level? The library's is a quarter higher at
 * most. */
static int is_below(decision *d, double chance, double level)
{
    d->close |= chance > level / 1.27 && chance < 1.03 * level;
    return chance <= level;
}

/* Does leaving out k more beat leaving out fewer, and is no rival nearly as good? */
static int is_significant(decision *d, const winners *w, unsigned n, unsigned k, int *is_clear)
{
    const unsigned dof = n - 9 - k + (d->stated > 0);

    for (unsigned j = 0; j < k; j++) {
        double chance = tail(w[k].squares / w[j].squares, k - j, dof);
        for (unsigned i = 1; i <= k - j; i++) {
            chance *= (double)(n - k + i) / i;
        }
        if (!is_below(d, chance, 0.0075)) {
            return 0;
        }
    }
    *is_clear = is_below(d, tail(w[k].squares / w[k].rival_squares, 1, dof), 0.06);
    return 1;
}

/* The best three hang on a pair that is within 1 % of its share. */
static int hangs_on_a_pair(const decision *d, unsigned k, double share)
{
    const winners less = best_of(d->set, d->stated, d->removed, k, 0.99 * share);
    const winners more = best_of(d->set, d->stated, d->removed, k, 1.01 * share);

    return less.best != more.best || less.rival != more.rival;
}

/* The rule of the header, by fitting every group. */
static void decide(decision *d)
{
    invcal_mask found;

    do {
        const unsigned out = size_of(d->removed);
        const unsigned n = d->set->count - out;
        const unsigned spare = n - 11 + (d->stated > 0);
        const unsigned most = spare < 3 ? spare : 3;
        winners w[4];
        found = 0;
        d->suspected = 0;
        const double share = (n - 9.0) / n;
        for (unsigned k = 0; k <= most; k++) {
            w[k] = best_of(d->set, d->stated, d->removed, k, share);
            d->close |= k == 3 && hangs_on_a_pair(d, k, share);
            d->close |= !(determinant_left(d, w[k].best) > 1.1e-4);
            d->close |= !(determinant_left(d, w[k].rival) > 1.1e-4);
        }
        for (unsigned k = most; k > 0 && !found; k--) {
            int is_clear;
            if (is_significant(d, w, n, k, &is_clear)) {
                found = is_clear ? w[k].best : 0;
                d->suspected |= is_clear || d->suspected ? 0 : w[k].best | w[k].rival;
            }
        }
        d->removed |= found;
    } while (found);
}

static void the_rule_of_the_header_decides(void)
{
    random_source random = random_start(5);
    unsigned with[5] = {0};
    unsigned rivalled = 0;

    for (unsigned draw = 0; draw < FLOAT_OR_DOUBLE(200, 1000); draw++) { /* float: a few differ */
        const triad_truth truth = triad_random(&random, 0.03);
        const unsigned count = 11 + draw % 5;
        const double size = draw % 3 ? 0.05 : 0.002;
        double v[CAPACITY][3];
        reading_set set;
        double error = 0;
        random_directions(&random, count, v);
        read_positions(&truth, (const double(*)[3])v, count, SIGMA, &random, &set);
        (void)spoil_some(&random, draw / 5 % 4, 0.3 * size, size, &set, &error);
        decision d = {&set, draw % 2 ? 1e-4 : 0, 0, 0, 0};
        decide(&d);
        if (!d.close) {
            const invcal_outliers out = find(&set, d.stated);
            assert_set(d.removed, out.removed);
            TEST_ASSERT_EQUAL_INT(d.suspected != 0, out.suspected != 0);
            if (INVCAL_DOUBLE) { /* float cannot rank what is last in a row of contenders */
                assert_set(d.suspected, out.suspected);
            }
            with[size_of(d.removed)]++;
            rivalled += d.suspected != 0;
        }
    }
    /* All answers have been seen. */
    TEST_ASSERT_TRUE(with[0] > 20 && with[1] > 20 && with[2] > 3 && with[3] > 3 && rivalled > 3);
}

/* ---- what is reported --------------------------------------------------------------------------------- */

static invcal_outlier look_at(const reading_set *set, double stated, invcal_mask removed,
                              unsigned i)
{
    const invcal_calibration nominal = unit_nominal();
    invcal_outlier out;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_outlier_size(set->u[0], set->count, &nominal,
                                                         (invcal_real)stated, removed, i, &out));
    return out;
}

/* Error and w from the fit without this position, whether it was removed or not. */
static void assert_reported(const reading_set *set, double stated, invcal_mask removed)
{
    const least_squares s = fit_without(set, removed);
    const double dof = set->count - 9.0 - size_of(removed) + (stated > 0);
    const double sigma = sqrt((s.squares + stated * stated) / dof);

    for (unsigned i = 0; i < set->count; i++) {
        const invcal_outlier out = look_at(set, stated, removed, i);
        const double checked = removed & bit(i) ? 0 : 1 - leverage_of(&s, set, i);
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-2, 1e-9), 1, (double)out.sigma / sigma);
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-4, 1e-11), checked, (double)out.checked);
        if (removed & bit(i) || checked > 0.02) {
            const least_squares without = fit_without(set, removed | bit(i));
            const double error = residual_of(&without, set, i);
            const double w = error / (sigma * sqrt(1 + leverage_of(&without, set, i)));
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(3e-5, 1e-12), error, (double)out.error);
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-2, 1e-6) * (1 + fabs(w)), w,
                                      (double)out.w);
        }
    }
}

/* Baarda's own: of the fit with this position, and sigma of the fit without. */
static void assert_baarda(const reading_set *set, double stated, invcal_mask removed, unsigned i)
{
    const double dof = set->count - 9.0 - size_of(removed) + (stated > 0);
    const double sigma = sqrt((fit_without(set, removed).squares + stated * stated) / dof);
    const least_squares with = fit_without(set, removed & ~bit(i));
    const double w = residual_of(&with, set, i) / (sigma * sqrt(1 - leverage_of(&with, set, i)));

    TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-2, 1e-6), 1,
                              (double)look_at(set, stated, removed, i).w / w);
}

static void errors_w_leverage_and_sigma_are_those_of_the_definition(void)
{
    random_source random = random_start(6);
    unsigned total = 0;

    for (unsigned draw = 0; draw < SOME(200); draw++) {
        const triad_truth truth = triad_random(&random, 0.03);
        const unsigned count = 18 + draw % 7;
        const double stated = draw % 2 ? 1e-4 : 0;
        double v[CAPACITY][3];
        reading_set set;
        double error = 0;
        random_directions(&random, count, v);
        read_positions(&truth, (const double(*)[3])v, count, SIGMA, &random, &set);
        (void)spoil_some(&random, draw % 4, 0.005, 0.1, &set, &error);
        const invcal_mask removed = find(&set, stated).removed;
        assert_reported(&set, stated, removed);
        for (unsigned i = 0; i < count; i++) {
            if (removed & bit(i)) {
                assert_baarda(&set, stated, removed, i);
                total++;
            }
        }
    }
    TEST_ASSERT_TRUE(total > SOME(200));
}

static void the_error_reported_is_the_one_that_was_planted(void)
{
    random_source random = random_start(7);

    for (int draw = 0; draw < SOME(200); draw++) {
        const triad_truth truth = triad_random(&random, 0.03);
        double v[CAPACITY][3];
        reading_set set;
        double error = 0;
        (void)program_of(24, v);
        read_positions(&truth, (const double(*)[3])v, 24, SIGMA, &random, &set);
        const invcal_mask bad = spoil_some(&random, 1, 0.002, 0.05, &set, &error);
        unsigned wrong = 0;
        while (!(bad & bit(wrong))) {
            wrong++;
        }
        for (int is_removed = 0; is_removed < 2; is_removed++) { /* the same, found or not */
            const invcal_outlier out = look_at(&set, 0, is_removed ? bad : 0, wrong);
            /* Nominal readings deviate by some 5 %, and noise by 6 sigma. */
            TEST_ASSERT_DOUBLE_WITHIN(0.12 * fabs(error) + 8e-4, error, (double)out.error);
            TEST_ASSERT_TRUE((out.w > 0) == (error > 0));
        }
    }
}

static void what_is_checked_by_all_positions_together_is_their_redundancy(void)
{
    random_source random = random_start(8);

    for (unsigned count = 11; count <= CAPACITY; count++) {
        const triad_truth truth = triad_random(&random, 0.03);
        double v[CAPACITY][3];
        reading_set set;
        double sum = 0;
        random_directions(&random, count, v);
        read_positions(&truth, (const double(*)[3])v, count, SIGMA, &random, &set);
        const invcal_mask removed = find(&set, 0).removed;
        for (unsigned i = 0; i < count; i++) {
            const double checked = (double)look_at(&set, 0, removed, i).checked;
            TEST_ASSERT_TRUE(checked >= 0 && checked <= 1);
            sum += checked;
        }
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-3, 1e-9), count - 9.0 - size_of(removed), sum);
    }
}

/* ---- what must not matter ------------------------------------------------------------------------------ */

/* Two outliers among 24, in positions 3 and 22; of noise that is none of the one set in a hundred
 * from which a good one is taken too. */
static reading_set set_with_two(void)
{
    random_source random = random_start(19);
    const triad_truth truth = triad_random(&random, 0.03);
    double v[CAPACITY][3];
    reading_set set;

    (void)program_of(24, v);
    read_positions(&truth, (const double(*)[3])v, 24, SIGMA, &random, &set);
    spoil(&set, 3, 0.004);
    spoil(&set, 22, -0.03);
    return set;
}

static void the_order_of_positions_does_not_matter(void)
{
    const reading_set set = set_with_two();
    const invcal_outliers expected = find(&set, 0);
    random_source random = random_start(10);

    assert_set(bit(3) | bit(22), expected.removed);
    for (int draw = 0; draw < SOME(50); draw++) {
        unsigned from[CAPACITY]; /* where each comes from */
        reading_set permuted;
        permuted.count = 24;
        for (unsigned i = 0; i < 24; i++) {
            const unsigned other = (unsigned)random_uniform(&random, 0, i + 1.0);
            from[i] = i;
            from[i] = from[other];
            from[other] = i;
        }
        for (unsigned i = 0; i < 24; i++) {
            memcpy(permuted.u[i], set.u[from[i]], sizeof set.u[0]);
        }
        invcal_mask wanted = 0;
        for (unsigned i = 0; i < 24; i++) {
            wanted |= from[i] == 3 || from[i] == 22 ? bit(i) : 0;
        }
        assert_set(wanted, find(&permuted, 0).removed);
        for (unsigned i = 0; i < 24; i++) {
            const invcal_outlier here = look_at(&permuted, 0, wanted, i);
            const invcal_outlier there = look_at(&set, 0, expected.removed, from[i]);
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-2, 1e-9), 1,
                                      (double)(here.sigma / there.sigma));
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(2e-5, 1e-12), (double)there.checked,
                                      (double)here.checked);
            TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-5, 1e-12), (double)there.error,
                                      (double)here.error);
        }
    }
}

static void units_do_not_matter(void)
{
    const reading_set set = set_with_two();
    const invcal_mask expected = find(&set, 1e-4).removed;
    const invcal_real zero[3] = {500, -300, 100};
    const invcal_real counts[3] = {1000, -1000, 1000};
    invcal_real raw[3 * CAPACITY];
    invcal_calibration nominal;
    invcal_outliers out;
    invcal_outlier one;

    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_nominal(zero, counts, &nominal));
    for (unsigned i = 0; i < 24; i++) {
        for (unsigned k = 0; k < 3; k++) {
            const double u = (double)set.u[i][k];
            raw[3 * i + k] = (invcal_real)((double)counts[k] * u + (double)zero[k]);
        }
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK,
                          invcal_outliers_find(raw, 24, &nominal, (invcal_real)1e-4, &out));
    assert_set(expected, out.removed);
    for (unsigned i = 0; i < 24; i++) {
        const invcal_outlier same = look_at(&set, 1e-4, expected, i);
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_outlier_size(raw, 24, &nominal, (invcal_real)1e-4,
                                                             expected, i, &one));
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-2, 1e-9), 1, (double)(one.sigma / same.sigma));
        TEST_ASSERT_DOUBLE_WITHIN(FLOAT_OR_DOUBLE(1e-5, 1e-12), (double)same.error,
                                  (double)one.error);
    }
}

/* ---- classes of input ---------------------------------------------------------------------------------- */

static void exact_readings_have_no_outliers(void)
{
    random_source random = random_start(11);

    for (int draw = 0; draw < SOME(400); draw++) {
        const unsigned count = 11 + (unsigned)draw % (CAPACITY - 10);
        const triad_truth truth = triad_random(&random, draw % 2 ? 0.1 : 0.01);
        double v[CAPACITY][3];
        reading_set set;
        if (draw % 3) {
            random_directions(&random, count, v);
        } else {
            (void)program_of(24, v);
        }
        read_positions(&truth, (const double(*)[3])v, draw % 3 ? count : 24, 0, &random, &set);
        const invcal_outliers out = find(&set, 0);
        assert_set(0, out.removed);
        assert_set(0, out.suspected);
        const double sigma = (double)look_at(&set, 0, 0, 0).sigma;
        TEST_ASSERT_TRUE(sigma > 0 && sigma < FLOAT_OR_DOUBLE(1e-5, 1e-14));
    }
}

static void among_exact_readings_an_error_just_above_rounding_is_found(void)
{
    random_source random = random_start(12);

    for (unsigned i = 0; i < SOME(24); i++) {
        const triad_truth truth = triad_random(&random, 0.03);
        double v[CAPACITY][3];
        reading_set set;
        (void)program_of(24, v);
        read_positions(&truth, (const double(*)[3])v, 24, 0, &random, &set);
        spoil(&set, i, FLOAT_OR_DOUBLE(5e-5, 1e-13));
        assert_set(bit(i), find(&set, 0).removed);
        /* But not if the noise stated explains it. */
        assert_set(0, find(&set, FLOAT_OR_DOUBLE(5e-5, 1e-13)).removed);
    }
}

static void every_position_of_a_full_set_can_be_named(void)
{
    random_source random = random_start(13);

    for (unsigned i = 0; i < CAPACITY; i++) {
        const triad_truth truth = triad_random(&random, 0.03);
        const unsigned other = (i + 17) % CAPACITY;
        double v[CAPACITY][3];
        reading_set set;
        random_directions(&random, CAPACITY, v);
        read_positions(&truth, (const double(*)[3])v, CAPACITY, 1e-6, &random, &set);
        spoil(&set, i, 0.05);
        spoil(&set, other, -0.03);
        const invcal_outliers out = find(&set, 0);
        assert_set(bit(i) | bit(other), out.removed & (bit(i) | bit(other)));
        TEST_ASSERT_TRUE(size_of(out.removed) <= 3);
    }
}

static void no_more_than_six_are_named(void)
{
    random_source random = random_start(14);

    for (int draw = 0; draw < SOME(20); draw++) {
        const triad_truth truth = triad_random(&random, 0.03);
        double v[CAPACITY][3];
        reading_set set;
        double error = 0;
        random_directions(&random, CAPACITY, v);
        read_positions(&truth, (const double(*)[3])v, CAPACITY, SIGMA, &random, &set);
        (void)spoil_some(&random, 4 + (unsigned)draw % 9, 0.01, 0.5, &set, &error);
        TEST_ASSERT_TRUE(size_of(find(&set, 0).removed) <= INVCAL_OUTLIERS_MOST);
    }
}

static void equal_positions_check_one_another(void)
{
    random_source random = random_start(15);
    const triad_truth truth = triad_random(&random, 0.03);
    double v[CAPACITY][3];
    reading_set set;

    for (unsigned i = 0; i < 20; i++) { /* ten directions, each twice */
        if (i < 10) {
            random_direction(&random, v[i]);
        } else {
            memcpy(v[i], v[i - 10], sizeof v[i]);
        }
    }
    read_positions(&truth, (const double(*)[3])v, 20, SIGMA, &random, &set);
    assert_set(0, find(&set, 0).removed);
    /* One of two: the ten directions leave one residual to tell which, and it does not suffice;
     * but that it is one of these two is certain. */
    spoil(&set, 4, 0.02);
    const invcal_outliers out = find(&set, 0);
    assert_set(0, (out.removed | out.suspected) & ~(bit(4) | bit(14)));
    TEST_ASSERT_TRUE((out.removed | out.suspected) & bit(4));
    /* With a third the majority decides. */
    memcpy(set.u[20], set.u[14], sizeof set.u[20]);
    set.count = 21;
    assert_set(bit(4), find(&set, 0).removed);
}

static void a_position_that_nothing_checks_is_not_blamed(void)
{
    random_source random = random_start(16);
    const triad_truth truth = triad_random(&random, 0.03);
    double v[CAPACITY][3];
    reading_set set;

    for (unsigned i = 0; i < 18; i++) { /* all but one on the plane z = 0 and the cone z = 0.6 */
        const double z = i < 9 ? 0 : 0.6;
        const double angle = 0.7 * i;
        v[i][0] = sqrt(1 - z * z) * cos(angle);
        v[i][1] = sqrt(1 - z * z) * sin(angle);
        v[i][2] = z;
    }
    v[17][0] = v[17][1] = 0;
    v[17][2] = -1; /* alone tells z^2 from z */
    read_positions(&truth, (const double(*)[3])v, 18, 1e-6, &random, &set);
    spoil(&set, 17, 0.02);
    const invcal_outliers out = find(&set, 0);
    assert_set(0, out.removed & bit(17));
    const invcal_outlier one = look_at(&set, 0, out.removed, 17);
    TEST_ASSERT_TRUE((double)one.checked < 1e-4 && one.error == 0 && one.w == 0);
}

/* Directions within a band about the equator, so narrow that the condition is next to its limit: some
 * that are wrong cannot be left out, for the others would leave parameters open. */
static void what_the_others_are_not_determined_without_is_suspected_and_stays(void)
{
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(21);
    unsigned stayed = 0;

    for (unsigned draw = 0; draw < SOME(2000); draw++) {
        const triad_truth truth = triad_random(&random, 0.03);
        const double width = FLOAT_OR_DOUBLE(0.1, 0.02);
        double v[14][3];
        reading_set set;
        invcal_outliers out;
        invcal_outlier one;
        random_directions(&random, 14, v);
        for (unsigned i = 0; i < 14; i++) {
            v[i][2] *= width;
            const double length = length3(v[i]);
            for (int k = 0; k < 3; k++) {
                v[i][k] /= length;
            }
        }
        read_positions(&truth, (const double(*)[3])v, 14, FLOAT_OR_DOUBLE(1e-5, 1e-9), &random,
                       &set);
        spoil(&set, draw % 14, 0.02);
        if (invcal_outliers_find(set.u[0], 14, &nominal, 0, &out) == INVCAL_OK) {
            TEST_ASSERT_EQUAL_INT(
                INVCAL_OK, invcal_outlier_size(set.u[0], 14, &nominal, 0, out.removed, 0, &one));
            stayed += out.suspected != 0 &&
                      invcal_outlier_size(set.u[0], 14, &nominal, 0, out.removed | out.suspected, 0,
                                          &one) == INVCAL_UNDETERMINED;
        }
    }
    TEST_ASSERT_TRUE(stayed > SOME(10));
}

/* Rounding would make less than nothing of it, now and then. */
static void what_nothing_checks_is_checked_by_zero(void)
{
    random_source random = random_start(17);
    double v[14][3];
    reading_set set;

    for (unsigned k = 0; k < SOME(200); k++) {
        const triad_truth truth = triad_random(&random, 0.03);
        const double turned = random_uniform(&random, 0, 1);
        for (unsigned i = 0; i < 14; i++) { /* ten on a plane leave four unknowns to the others */
            const double z = i < 10 ? 0 : i == 10 ? 1 : i == 11 ? -1 : 0.8;
            v[i][0] = sqrt(1 - z * z) * cos(turned + i);
            v[i][1] = sqrt(1 - z * z) * sin(turned + i);
            v[i][2] = z;
        }
        read_positions(&truth, (const double(*)[3])v, 14, 1e-6, &random, &set);
        for (unsigned i = 10; i < 14; i++) {
            const invcal_outlier one = look_at(&set, 0, 0, i);
            TEST_ASSERT_TRUE(one.checked >= 0 && (double)one.checked < 1e-4);
            TEST_ASSERT_TRUE(one.error == 0 && one.w == 0);
        }
    }
}

/* Real sensors: the first positions of recordings, in g, and one of them spoiled. */
static void assert_real(const double positions[][3], unsigned count, double zero, double scale)
{
    reading_set set;

    set.count = count;
    for (unsigned i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            set.u[i][k] = (invcal_real)((positions[i][k] - zero) * scale);
        }
    }
    assert_set(0, find(&set, 0).removed);
    unsigned found = 0;
    for (unsigned i = 0; i < count; i++) {
        reading_set spoiled = set;
        spoil(&spoiled, i, 0.02);
        const invcal_mask removed = find(&spoiled, 0).removed;
        assert_set(removed, removed & bit(i)); /* no other */
        found += removed == bit(i);
    }
    TEST_ASSERT_TRUE(found >= count - 1);
}

static void real_positions_have_no_outliers_but_those_that_are_made(void)
{
    assert_real(xsens_mti_positions, CAPACITY < 32 ? CAPACITY : 32, 32768, 2.4446e-4);
    assert_real(mpu9150_0_positions, 24, 0, 1 / 9.81);
    assert_real(mpu9150_1_positions, 24, 0, 1 / 9.81);
}

/* ---- refusals -------------------------------------------------------------------------------------------- */

static void assert_refused_by(invcal_status expected, const reading_set *set,
                              const invcal_calibration *nominal, double noise)
{
    invcal_outliers out;
    invcal_outliers before;
    invcal_outlier one;
    invcal_outlier unchanged;

    memset(&out, 0x5A, sizeof out);
    before = out;
    TEST_ASSERT_EQUAL_INT(
        expected, invcal_outliers_find(set->u[0], set->count, nominal, (invcal_real)noise, &out));
    TEST_ASSERT_EQUAL_MEMORY(&before, &out, sizeof out);
    if (set->count >= INVCAL_OUTLIERS_FEWEST) {
        memset(&one, 0x5A, sizeof one);
        unchanged = one;
        TEST_ASSERT_EQUAL_INT(expected, invcal_outlier_size(set->u[0], set->count, nominal,
                                                            (invcal_real)noise, 0, 0, &one));
        TEST_ASSERT_EQUAL_MEMORY(&unchanged, &one, sizeof one);
    }
}

static void assert_refused(invcal_status expected, const reading_set *set)
{
    const invcal_calibration nominal = unit_nominal();

    assert_refused_by(expected, set, &nominal, 0);
}

static void ten_positions_or_fewer_and_more_than_there_may_be_are_refused(void)
{
    random_source random = random_start(17);
    double v[MAX_POSITIONS][3];
    reading_set set;
    const triad_truth truth = triad_random(&random, 0.03);

    random_directions(&random, MAX_POSITIONS, v);
    read_positions(&truth, (const double(*)[3])v, MAX_POSITIONS, SIGMA, &random, &set);
    for (set.count = 0; set.count < INVCAL_OUTLIERS_FEWEST; set.count++) {
        assert_refused(INVCAL_TOO_FEW, &set);
    }
    for (; set.count <= CAPACITY; set.count++) {
        (void)find(&set, 0);
    }
    for (; set.count <= MAX_POSITIONS; set.count++) {
        assert_refused(INVCAL_BAD_COUNT, &set);
    }
    set.count = UINT_MAX;
    assert_refused(INVCAL_BAD_COUNT, &set);
}

/* An error is told only of a position that is there, and by residuals that are. */
static void a_size_without_a_position_or_without_a_residual_is_refused(void)
{
    const invcal_calibration nominal = unit_nominal();
    random_source random = random_start(18);
    const triad_truth truth = triad_random(&random, 0.03);
    double v[12][3];
    reading_set set;
    invcal_outlier out;
    invcal_outlier before;

    random_directions(&random, 12, v);
    read_positions(&truth, (const double(*)[3])v, 12, SIGMA, &random, &set);
    memset(&out, 0x5A, sizeof out);
    before = out;
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_COUNT,
                          invcal_outlier_size(set.u[0], 12, &nominal, 0, 0, 12, &out));
    TEST_ASSERT_EQUAL_INT(INVCAL_BAD_COUNT,
                          invcal_outlier_size(set.u[0], 12, &nominal, 0, 0, UINT_MAX, &out));
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW,
                          invcal_outlier_size(set.u[0], 12, &nominal, 0, 7, 0, &out));
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED,
                          invcal_outlier_size(set.u[0], 12, &nominal, 0, 15, 0, &out));
    TEST_ASSERT_EQUAL_INT(INVCAL_UNDETERMINED,
                          invcal_outlier_size(set.u[0], 12, &nominal, 0, 0xFFF, 0, &out));
    TEST_ASSERT_EQUAL_MEMORY(&before, &out, sizeof out);
    /* Nine, and the noise stated. */
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_outlier_size(set.u[0], 12, &nominal, (invcal_real)SIGMA, 7, 0, &out));
    TEST_ASSERT_DOUBLE_WITHIN(0.1 * SIGMA, SIGMA, (double)out.sigma);
}

static void readings_that_are_none_are_refused(void)
{
    static const struct {
        double value;
        invcal_status status;
    } bad[] = {{NOT_A_NUMBER, INVCAL_NOT_FINITE},
               {INFINITE, INVCAL_NOT_FINITE},
               {-INFINITE, INVCAL_NOT_FINITE},
               {11, INVCAL_OUT_OF_RANGE},
               {1e30, INVCAL_OUT_OF_RANGE}};

    for (unsigned b = 0; b < sizeof bad / sizeof bad[0]; b++) {
        for (unsigned i = 0; i < 24; i++) {
            reading_set set = set_with_two();
            set.u[i][i % 3] = (invcal_real)bad[b].value;
            assert_refused(bad[b].status, &set);
        }
    }
    reading_set set = set_with_two();
    memset(set.u[23], 0, sizeof set.u[23]);
    assert_refused(INVCAL_OUT_OF_RANGE, &set);
}

static void an_unusable_noise_or_nominal_is_refused(void)
{
    static const double bad[] = {-1, NOT_A_NUMBER, INFINITE, 1, 2}; /* 1: as much as the field */
    const reading_set set = set_with_two();
    invcal_calibration nominal = unit_nominal();

    for (int i = 0; i < 5; i++) {
        assert_refused_by(INVCAL_BAD_NOISE, &set, &nominal, bad[i]);
    }
    memset(nominal.matrix[1], 0, sizeof nominal.matrix[1]);
    assert_refused_by(INVCAL_BAD_NOMINAL, &set, &nominal, 0);
    nominal = unit_nominal();
    nominal.offset[2] = (invcal_real)NAN;
    assert_refused_by(INVCAL_BAD_NOMINAL, &set, &nominal, 0);
}

static void positions_that_determine_nothing_are_refused(void)
{
    random_source random = random_start(18);

    for (int draw = 0; draw < SOME(300); draw++) {
        const double noise = draw % 2 ? 1e-5 : 0;
        const triad_truth truth = triad_random(&random, 0.03);
        double side[3][3];
        double v[CAPACITY][3];
        reading_set set;
        random_rotation(&random, side);
        for (unsigned i = 0; i < 24; i++) {
            const double angle = random_uniform(&random, 0, 6.283185307179586);
            /* a plane, a cone, two cones: these show in no pivot, now and then */
            const double z = draw % 3 == 0 ? 0 : draw % 3 == 1 || i % 2 ? 0.5 : -0.3;
            for (int k = 0; k < 3; k++) {
                v[i][k] = z * side[2][k] +
                          sqrt(1 - z * z) * (cos(angle) * side[0][k] + sin(angle) * side[1][k]);
            }
        }
        read_positions(&truth, (const double(*)[3])v, 24, noise, &random, &set);
        assert_refused(INVCAL_UNDETERMINED, &set);
        for (unsigned i = 0; i < 24; i++) { /* six faces, four times each */
            memset(v[i], 0, sizeof v[i]);
            v[i][i % 3] = i % 6 < 3 ? 1 : -1;
        }
        read_positions(&truth, (const double(*)[3])v, 24, noise, &random, &set);
        assert_refused(INVCAL_UNDETERMINED, &set);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_LONG_TEST(one_of_18_that_is_wrong_is_found_and_the_calibration_is_as_good_as_without);
    RUN_LONG_TEST(two_of_18_and_three_of_24_are_found_that_hide_one_another);
    RUN_LONG_TEST(of_faces_and_edges_met_by_hand_exactly_the_wrong_ones_are_found);
    RUN_LONG_TEST(more_than_three_are_found_group_by_group);
    RUN_LONG_TEST(clean_positions_lose_one_in_a_hundred_sets_or_fewer);
    RUN_LONG_TEST(of_eleven_positions_none_is_removed_unless_the_noise_is_stated);
    RUN_LONG_TEST(a_stated_noise_helps_where_few_residuals_are_left);
    RUN_LONG_TEST(a_stated_noise_may_be_wrong);
    RUN_LONG_TEST(the_innocent_are_not_removed_where_two_positions_may_be_the_wrong_one);
    RUN_LONG_TEST(the_rule_of_the_header_decides);
    RUN_SLOW_TEST(errors_w_leverage_and_sigma_are_those_of_the_definition);
    RUN_TEST(the_error_reported_is_the_one_that_was_planted);
    RUN_SLOW_TEST(what_is_checked_by_all_positions_together_is_their_redundancy);
    RUN_TEST(the_order_of_positions_does_not_matter);
    RUN_SLOW_TEST(units_do_not_matter);
    RUN_LONG_TEST(exact_readings_have_no_outliers);
    RUN_TEST(among_exact_readings_an_error_just_above_rounding_is_found);
    RUN_LONG_TEST(every_position_of_a_full_set_can_be_named);
    RUN_SLOW_TEST(no_more_than_six_are_named);
    RUN_TEST(equal_positions_check_one_another);
    RUN_TEST(a_position_that_nothing_checks_is_not_blamed);
    RUN_LONG_TEST(what_the_others_are_not_determined_without_is_suspected_and_stays);
    RUN_TEST(what_nothing_checks_is_checked_by_zero);
    RUN_LONG_TEST(real_positions_have_no_outliers_but_those_that_are_made);
    RUN_SLOW_TEST(ten_positions_or_fewer_and_more_than_there_may_be_are_refused);
    RUN_TEST(a_size_without_a_position_or_without_a_residual_is_refused);
    RUN_TEST(readings_that_are_none_are_refused);
    RUN_TEST(an_unusable_noise_or_nominal_is_refused);
    RUN_TEST(positions_that_determine_nothing_are_refused);
    return UNITY_END() != 0;
}
