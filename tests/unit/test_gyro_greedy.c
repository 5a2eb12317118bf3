/* SPDX-License-Identifier: MIT
 *
 * The 24 moves that each add most, against the batch solution. They are longer than quarter turns,
 * and need more segments than tables usually have: compiled here with these. So does an occasional
 * tour, if errors are 10 %.
 */
#undef INVCAL_MAX_SEGMENTS
#define INVCAL_MAX_SEGMENTS 300
#include "gyro_tables.h"
#include "gyro_batch.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- programs ----------------------------------------------------------------------------------- */

/* The information from the shortest turn from up to `to`: its share of A. */
static void add_turn(double a[81], const double up[3], const double to[3])
{
    double axis[3], s[3][9], none[9] = {0}, c[3][3];
    const double y[3] = {0, 0, 0};
    double length = 0, dot = 0;

    for (int i = 0; i < 3; i++) {
        axis[i] = to[(i + 1) % 3] * up[(i + 2) % 3] - to[(i + 2) % 3] * up[(i + 1) % 3];
        length += axis[i] * axis[i];
        dot += to[i] * up[i];
    }
    const double angle = atan2(sqrt(length), dot);
    memset(s, 0, sizeof s);
    for (int n = 0; n < 40; n++) {
        double part[3];
        for (int i = 0; i < 3; i++) {
            part[i] = axis[i] / sqrt(length) * angle * (n + 0.5) / 40;
        }
        rotation_by(part, c);
        for (int i = 0; i < 27; i++) {
            s[i / 9][i % 9] += c[i / 9][i % 9 / 3] * axis[i % 3] / sqrt(length) * angle / 40;
        }
    }
    add_equations(a, none, s, up, y, 1);
}

static double determinant(const double a[81])
{
    double u[81];
    double product = 1;

    memcpy(u, a, sizeof u);
    for (int k = 0; k < 9; k++) {
        product *= u[10 * k];
        for (int i = k + 1; i < 9; i++) {
            const double factor = u[9 * i + k] / u[10 * k];
            for (int j = k; j < 9; j++) {
                u[9 * i + j] -= factor * u[9 * k + j];
            }
        }
    }
    return product;
}

/* The best next one of 26, each time. */
static void greedy(double program[MOVES][3])
{
    double a[81] = {0};
    double up[3] = {0, 0, 1};

    for (int i = 0; i < 9; i++) {
        a[10 * i] = 0.01;
    }
    for (int k = 0; k < MOVES; k++) {
        double best = 0, next[81], to[3];
        for (int n = 0; n < 27; n++) {
            const double x[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
            const double length = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
            double b[81];
            for (int i = 0; i < 3; i++) {
                to[i] = x[i] / length;
            }
            if (n == 13 || fabs(to[0] * up[0] + to[1] * up[1] + to[2] * up[2]) > 0.95) {
                continue;
            }
            memcpy(b, a, sizeof b);
            add_turn(b, up, to);
            const double d = determinant(b);
            if (d > best * (1 + 1e-9)) {
                best = d;
                memcpy(next, b, sizeof next);
                memcpy(program[k], to, sizeof to);
            }
        }
        memcpy(a, next, sizeof a);
        memcpy(up, program[k], sizeof up);
    }
}

/* ---- runs --------------------------------------------------------------------------------------- */

static void on_a_table_errors_are_those_of_the_batch(void)
{
    double program[MOVES][3];

    greedy(program);
    are_as_the_batch((const double(*)[3])program, 100, 3e-4, 8, 1.5e-4);
}

static void in_the_hand_errors_are_those_of_the_batch(void)
{
    double program[MOVES][3];

    greedy(program);
    are_as_the_batch((const double(*)[3])program, 100, 1e-3, 8, 4.2e-4);
}

/* As many as the design has. */
static void sixty_runs_of_it_agree_with_the_batch(void)
{
    double program[MOVES][3];

    greedy(program);
    are_as_the_batch((const double(*)[3])program, 100, 3e-4, 60, 1.1e-4);
}

static void sixty_runs_of_the_tour_agree_with_the_batch(void)
{
    are_as_the_batch(NULL, 100, 3e-4, 60, 1.5e-4);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(on_a_table_errors_are_those_of_the_batch);
    RUN_LONG_TEST(in_the_hand_errors_are_those_of_the_batch);
    RUN_LONG_TEST(sixty_runs_of_it_agree_with_the_batch);
    RUN_LONG_TEST(sixty_runs_of_the_tour_agree_with_the_batch);
    return UNITY_END();
}
