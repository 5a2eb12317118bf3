/* SPDX-License-Identifier: MIT
 *
 * The loss from keeping segments instead of samples, and whether sigma is honest: simulated logs
 * against the batch solution, which integrates every sample, in double and with its own
 * mathematics.
 */
#ifndef GYRO_BATCH_H
#define GYRO_BATCH_H

#include <math.h>
#include <string.h>

#include "gyro_world.h"
#include "unity.h"

enum { UNKNOWNS = 9, OF_BIAS = 5, MOVES = 24, SAMPLES = ROOM(60000, 1) };

static world w;
static int32_t samples[SAMPLES][3];
static world_solution imu;

/* A x = b by elimination; A becomes its inverse. No pivots: A is positive definite. */
static void solve(double *a, double *x, int n)
{
    for (int k = 0; k < n; k++) {
        const double pivot = 1 / a[n * k + k];
        a[n * k + k] = 1;
        for (int j = 0; j < n; j++) {
            a[n * k + j] *= pivot;
        }
        x[k] *= pivot;
        for (int i = 0; i < n; i++) {
            const double factor = a[n * i + k];
            if (i == k) {
                continue;
            }
            a[n * i + k] = 0;
            for (int j = 0; j < n; j++) {
                a[n * i + j] -= factor * a[n * k + j];
            }
            x[i] -= factor * x[k];
        }
    }
}

/* A += weight S'(1 - up up')S, b += weight S'y: S of a move, three rows of nine. */
static void add_equations(double a[81], double b[9], double s[3][9], const double up[3],
                          const double y[3], double weight)
{
    for (int i = 0; i < 9; i++) {
        const double along = s[0][i] * up[0] + s[1][i] * up[1] + s[2][i] * up[2];
        b[i] += weight * (s[0][i] * y[0] + s[1][i] * y[1] + s[2][i] * y[2]);
        for (int j = 0; j < 9; j++) {
            const double other = s[0][j] * up[0] + s[1][j] * up[1] + s[2][j] * up[2];
            a[9 * i + j] += weight * (s[0][i] * s[0][j] + s[1][i] * s[1][j] + s[2][i] * s[2][j] -
                                      along * other);
        }
    }
}

/* ---- the batch ---------------------------------------------------------------------------------- */

static void direction(int rest, double up[3])
{
    double length = 0;

    for (int i = 0; i < 3; i++) {
        length += w.mean[rest][i] * w.mean[rest][i];
    }
    for (int i = 0; i < 3; i++) {
        up[i] = w.mean[rest][i] / sqrt(length);
    }
}

/* Rotation by the samples from..to - 1, and how errors of m rotate it. */
static void integrate(const double m[3][3], const double bias[3], int from, int to, double c[3][3],
                      double s[3][9])
{
    double step[3][3], u[3], th[3];

    world_unit(c);
    memset(s, 0, 27 * sizeof(double));
    for (int n = from; n < to; n++) {
        for (int i = 0; i < 3; i++) {
            u[i] = (samples[n][i] / COUNTS - bias[i]) / w.rate;
        }
        double before[3][3];
        memcpy(before, c, sizeof before);
        for (int i = 0; i < 3; i++) {
            th[i] = m[i][0] * u[0] + m[i][1] * u[1] + m[i][2] * u[2];
        }
        rotation_by(th, step);
        world_turn(c, (const double(*)[3])step);
        for (int i = 0; i < 27; i++) {
            s[i / 9][i % 9] += (before[i / 9][i % 9 / 3] + c[i / 9][i % 9 / 3]) / 2 * u[i % 3];
        }
    }
}

/* Biases of the rests, rad/s: the part of what they read beside a fit over (up, time, 1) that changes from rest
 * to rest as noise does is taken out. */
static void find_biases(double bias[][3])
{
    const int count = w.imu.rests;
    double h[WORLD_RESTS][OF_BIAS], off[WORLD_RESTS];

    for (int axis = 0; axis < 3; axis++) {
        double a[OF_BIAS * OF_BIAS] = {0}, p[OF_BIAS] = {0};
        double squares = 0, changes = 0;
        for (int k = 0; k < count; k++) {
            direction(k, h[k]);
            h[k][3] = (double)w.imu.own.rest[k].when / w.imu.own.rest[count - 1].when;
            h[k][4] = 1;
            bias[k][axis] = (double)w.imu.own.bias[axis] + w.imu.own.rest[k].bias[axis] / 262144.0;
            for (int i = 0; i < OF_BIAS * OF_BIAS; i++) {
                a[i] += h[k][i / OF_BIAS] * h[k][i % OF_BIAS];
            }
            for (int i = 0; i < OF_BIAS; i++) {
                p[i] += h[k][i] * bias[k][axis];
            }
        }
        solve(a, p, OF_BIAS);
        for (int k = 0; k < count; k++) {
            off[k] = -bias[k][axis];
            for (int i = 0; i < OF_BIAS; i++) {
                off[k] += h[k][i] * p[i];
            }
            squares += off[k] * off[k] / (count - OF_BIAS);
            changes += pow(off[k] - (k > 0 ? off[k - 1] : 0), 2) / (4 * count);
        }
        for (int k = 0; k < count; k++) {
            bias[k][axis] += off[k] * fmin(1, changes / fmax(squares - changes, changes));
        }
    }
}

/* Gauss and Newton over all samples of the moves, the accelerometer known. Returns in sigma what the weights
 * say. */
static void solve_batch(double m[3][3], double sigma[9])
{
    double a[81], b[9], biases[WORLD_RESTS][3];

    find_biases(biases);
    world_unit(m);
    for (int pass = 0; pass < 6; pass++) {
        const invcal_private_segment *segment = w.imu.own.segment;
        memset(a, 0, sizeof a);
        memset(b, 0, sizeof b);
        for (int k = 1; k < w.imu.rests; k++) {
            double up[2][3], bias[3], c[3][3], s[3][9], end[3], y[3];
            int length = 0;
            for (int n = 0; n < w.imu.own.rest[k].move; n++) {
                length += segment->time / 2;
                segment++;
            }
            direction(k - 1, up[0]);
            direction(k, up[1]);
            for (int i = 0; i < 3; i++) {
                bias[i] = (biases[k - 1][i] + biases[k][i]) / 2;
            }
            integrate((const double(*)[3])m, bias, w.begin[k] - length, w.begin[k], c, s);
            for (int i = 0; i < 3; i++) {
                end[i] = c[i][0] * up[1][0] + c[i][1] * up[1][1] + c[i][2] * up[1][2];
            }
            for (int i = 0; i < 3; i++) {
                const int p = (i + 1) % 3, q = (i + 2) % 3;
                y[i] = end[p] * up[0][q] - end[q] * up[0][p];
            }
            const double t = length / w.rate;
            const double mean = w.mean_noise;
            add_equations(a, b, s, up[0], y,
                          1 / (2 * mean * mean + t * w.density * w.density * (1 + t / 3) +
                               2.25 * t * t * w.instability * w.instability));
        }
        solve(a, b, UNKNOWNS);
        for (int i = 0; i < 9; i++) {
            m[i / 3][i % 3] += b[i];
        }
    }
    for (int i = 0; i < 9; i++) {
        sigma[i] = sqrt(a[10 * i]);
    }
}

/* ---- runs --------------------------------------------------------------------------------------- */

typedef struct {
    double apart;          /* squares: from the batch, over its sigma */
    double error, optimum; /* of library and batch */
    double chi;            /* of the library, over its sigma */
    int inside, count;     /* of 95 % */
} tally;

static void run(const double (*program)[3], double rate, double error, double mean_noise,
                uint32_t seed, tally *t)
{
    world_settings settings = WORLD_USUAL;
    double m[3][3], sigma[9];

    world_begin(&w, rate, seed);
    w.log = samples;
    w.capacity = SAMPLES;
    w.wobble = 0.25;
    w.mean_noise = mean_noise;
    world_draw(&w, error, 0);
    for (int i = 0; i < 3; i++) {
        w.bias[i] = 0.02 * random_normal(&w.random);
    }
    if (program) {
        world_rest(&w, 1.5);
        for (int k = 0; k < MOVES; k++) {
            world_to(&w, program[k]);
        }
    } else {
        world_tour(&w);
        world_tour(&w);
    }
    world_end(&w);
    settings.held = 1;
    settings.noise = (invcal_real)mean_noise;
    TEST_ASSERT_TRUE(w.samples < SAMPLES);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, world_solve(&w, &settings, &imu));
    TEST_ASSERT_EQUAL_INT(MOVES, imu.result.moves);
    solve_batch(m, sigma);
    for (int i = 0; i < 9; i++) {
        const double found = (double)imu.parameter[i];
        const double truth = w.m[i / 3][i % 3];
        t->apart += pow((found - m[i / 3][i % 3]) / sigma[i], 2);
        t->error += pow(found - truth, 2);
        t->optimum += pow(m[i / 3][i % 3] - truth, 2);
        t->chi += pow((found - truth) / (double)imu.sigma[i], 2);
        t->inside += fabs(found - truth) < 1.96 * (double)imu.sigma[i];
        t->count++;
    }
}

static const double sizes[3] = {0.01, 0.03, 0.1};

/* On a table or in the hand, errors of 1, 3 and 10 %. */
static void compare(const double (*program)[3], double rate, double mean_noise, int runs,
                    tally *all)
{
    for (int k = 0; k < 3; k++) {
        tally t = {0, 0, 0, 0, 0, 0};
        for (int n = 0; n < runs; n++) {
            run(program, rate, sizes[k], mean_noise, 500u + (uint32_t)n, &t);
        }
        /* of a single run, if there is no time for more, which is not much */
        TEST_ASSERT_TRUE(sqrt(t.apart / t.count) < (TEST_SHORT > 1 ? 0.5 : 0.15));
        TEST_ASSERT_TRUE(sqrt(t.error / t.optimum) < (TEST_SHORT > 1 ? 1.5 : 1.1));
        all->error += t.error;
        all->chi += t.chi;
        all->inside += t.inside;
        all->count += t.count;
    }
}

/* O7 and O8, of a program of 24 directions, or of two tours. */
static void are_as_the_batch(const double (*program)[3], double rate, double mean_noise, int runs,
                             double error)
{
    tally all = {0, 0, 0, 0, 0, 0};

    if (SAMPLES == 1) {
        skip_large();
    }
    compare(program, rate, mean_noise, SOME(runs), &all);
    if (SOME(runs) == runs) {
        TEST_ASSERT_TRUE(sqrt(all.error / all.count) < error);
        TEST_ASSERT_DOUBLE_WITHIN(0.15, 1, sqrt(all.chi / all.count));
        TEST_ASSERT_DOUBLE_WITHIN(3, 96, 100.0 * all.inside / all.count);
    }
}

#endif
