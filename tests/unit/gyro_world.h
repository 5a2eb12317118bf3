/* SPDX-License-Identifier: MIT
 *
 * A gyroscope and an accelerometer in a hand: the truth in double, with its own mathematics, for
 * the tests of gyro.h.
 */
#ifndef GYRO_WORLD_H
#define GYRO_WORLD_H

#include <math.h>
#include <string.h>

#include "imu/imu.h"
#include "invcal/gyro_store.h"
#include "invcal/result.h"
#include "support.h"
#include "unity.h"

#define DEGREE (3.14159265358979324 / 180)
#define COUNTS 1e5 /* of the gyroscope per rad/s: rounding does not matter */

enum { WORLD_BLOCK = 16, WORLD_RESTS = 40, WORLD_LATE = 64 };

static inline void world_unit(double m[3][3])
{
    memset(m, 0, 9 * sizeof(double));
    m[0][0] = m[1][1] = m[2][2] = 1;
}

/* c <- c a */
static inline void world_turn(double c[3][3], const double a[3][3])
{
    double old[3][3];

    memcpy(old, c, sizeof old);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            c[i][j] = old[i][0] * a[0][j] + old[i][1] * a[1][j] + old[i][2] * a[2][j];
        }
    }
}

/* What was up before the turn c, after it. */
static inline void world_up(const double c[3][3], const double before[3], double after[3])
{
    for (int j = 0; j < 3; j++) {
        after[j] = c[0][j] * before[0] + c[1][j] * before[1] + c[2][j] * before[2];
    }
}

/* ---- the world ---------------------------------------------------------------------------------- */

typedef struct {
    /* the sensors */
    double m[3][3];     /* true rate = m nominal rate */
    triad_truth triad;  /* accelerometer */
    double bias[3];     /* rad/s */
    double g[3][3];     /* its g-sensitivity */
    double density;     /* rad/s/sqrt(Hz) */
    double instability; /* rad/s */
    double mean_noise;  /* of a rest, over field */
    double rate;        /* samples per second */
    double wobble;      /* of the hand */
    int axes[3];        /* gyroscope axis i measures |axes[i]| - 1 */
    random_source random;
    int late; /* samples by which the gyroscope is late; negative: the accelerometer */
    /* the state */
    int32_t queue[WORLD_LATE][3];
    int resting[WORLD_LATE];
    double up[3];
    double flicker[4][3];
    double c[3][3]; /* of the move */
    invcal_imu imu; /* its detector of rests is as world_block wants it */
    int samples, hold, quiet;
    double mean[WORLD_RESTS][3];
    int count;
    /* kept for others: space for that many samples, or null; and where each rest began */
    int32_t (*log)[3];
    int capacity;
    int begin[WORLD_RESTS];
} world;

static inline void world_begin(world *w, double rate, uint32_t seed)
{
    invcal_calibration nominal;

    memset(w, 0, sizeof *w);
    world_unit(w->m);
    w->random = random_start(seed);
    w->rate = rate;
    w->up[2] = 1;
    w->density = 0.005 * DEGREE;
    w->instability = 20 * DEGREE / 3600;
    w->mean_noise = 3e-4;
    w->wobble = 0.15;
    for (int i = 0; i < 3; i++) {
        w->axes[i] = i + 1;
    }
    nominal = unit_nominal();
    for (int i = 0; i < 3; i++) {
        nominal.matrix[i][i] = (invcal_real)(1 / COUNTS);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_init(&w->imu.session, sizeof w->imu.session, 1,
                                                         (invcal_real)rate));
    TEST_ASSERT_EQUAL_INT(
        INVCAL_OK, invcal_imu_init_nominal(&w->imu, sizeof w->imu, &nominal, (invcal_real)rate));
    memset(&w->imu.session.rests, 0, sizeof w->imu.session.rests);
    w->imu.session.rests.bits = 4;
    world_unit(w->c);
}

static inline void world_without_noise(world *w)
{
    w->density = w->instability = w->mean_noise = 0;
}

/* Scale errors of that size and misalignments of half of it, in both. */
static inline void world_draw(world *w, double gyro, double accelerometer)
{
    for (int i = 0; i < 9; i++) {
        w->m[i / 3][i % 3] += gyro * random_normal(&w->random) * (i % 4 == 0 ? 1 : 0.5);
    }
    w->triad = triad_random(&w->random, accelerometer);
}

/* What the detector of rests would say about this block, and its state then. */
static inline void world_block(world *w, int is_quiet)
{
    invcal_private_rests *r = &w->imu.session.rests;
    invcal_event event = INVCAL_MOVING;

    if (r->pended == 0) {
        r->begin = r->time;
    }
    r->time += WORLD_BLOCK;
    if (is_quiet) {
        r->pended = 2;
        r->end = r->time;
        w->hold = 0;
        w->quiet++;
        event = w->quiet == 6 ? INVCAL_READY : INVCAL_SETTLING;
    } else if (r->pended > 0) {
        w->hold++;
        if (w->hold == 5) {
            event = w->quiet >= 6 ? INVCAL_TAKEN : INVCAL_REFUSED;
            r->pended = event == INVCAL_TAKEN ? 2 : 0;
        }
    }
    invcali_imu_follow(&w->imu, event);
    if (w->hold == 5) {
        r->pended = 0;
        w->hold = w->quiet = 0;
    }
}

/* A sample, at the true rate omega, by counts. */
static inline void world_sample(world *w, const double omega[3], int is_quiet)
{
    double inverse[3][3];
    double nominal[3];
    int32_t raw[3];

    inverse3((const double(*)[3])w->m, inverse);
    double up[3];
    world_up((const double(*)[3])w->c, w->up, up);
    for (int i = 0; i < 3; i++) {
        double sum = w->bias[i];
        for (int k = 0; k < 4; k++) {
            const double share = exp(-1 / (w->rate * pow(10, k)));
            w->flicker[k][i] = share * w->flicker[k][i] + sqrt(1 - share * share) * 1.2 *
                                                              w->instability *
                                                              random_normal(&w->random);
            sum += w->flicker[k][i];
        }
        for (int j = 0; j < 3; j++) {
            sum += inverse[i][j] * omega[j] + w->g[i][j] * up[j];
        }
        nominal[i] = sum + w->density * sqrt(w->rate) * random_normal(&w->random);
    }
    for (int i = 0; i < 3; i++) {
        const int of = w->axes[i] < 0 ? -w->axes[i] : w->axes[i];
        raw[i] = (int32_t)lround(COUNTS * (w->axes[i] < 0 ? -nominal[of - 1] : nominal[of - 1]));
    }
    if (w->log && w->samples < w->capacity) {
        memcpy(w->log[w->samples], raw, sizeof raw);
    }
    const int now = w->samples % WORLD_LATE;
    memcpy(w->queue[now], raw, sizeof raw);
    w->resting[now] = is_quiet;
    const int gyro = (w->samples + WORLD_LATE - (w->late > 0 ? w->late : 0)) % WORLD_LATE;
    const int accelerometer = (w->samples + WORLD_LATE + (w->late < 0 ? w->late : 0)) % WORLD_LATE;
    invcal_imu_feed_gyro(&w->imu, w->queue[gyro][0], w->queue[gyro][1], w->queue[gyro][2]);
    w->samples++;
    if (w->samples % WORLD_BLOCK == 0) {
        world_block(w, w->resting[accelerometer]);
    }
}

/* At rest for that many seconds; the accelerometer's mean. */
static inline void world_rest(world *w, double seconds)
{
    static const double none[3] = {0, 0, 0};
    double u[3];
    double length = 0;

    world_up((const double(*)[3])w->c, w->up, u);
    for (int i = 0; i < 3; i++) {
        length += u[i] * u[i];
    }
    for (int i = 0; i < 3; i++) {
        w->up[i] = u[i] / sqrt(length);
    }
    world_unit(w->c);
    while (w->samples % WORLD_BLOCK != 0) {
        world_sample(w, none, 0);
    }
    w->begin[w->count] = w->samples;
    const int samples = (int)(seconds * w->rate / (double)WORLD_BLOCK + 1) * WORLD_BLOCK;
    for (int i = 0; i < samples; i++) {
        world_sample(w, none, 1);
    }
    triad_read(&w->triad, w->up, u);
    for (int i = 0; i < 3; i++) {
        w->mean[w->count][i] = u[i] + w->mean_noise * random_normal(&w->random);
    }
    w->count++;
}

/* Turns by a vector, wobbling; then rests. The truth has steps of at most a millisecond. */
static inline void world_move(world *w, const double vector[3], double seconds)
{
    const int fine = w->rate < 250 ? (int)(1000 / w->rate) : 4;
    const int samples = (int)(seconds * w->rate);
    const double angle =
        sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    const double peak = 1.875 * fmax(angle, 0.5) / seconds * w->wobble * 0.7;
    double amplitude[3][2], pace[3][2], phase[3][2];

    for (int i = 0; i < 6; i++) {
        amplitude[i / 2][i % 2] = peak * random_normal(&w->random);
        pace[i / 2][i % 2] =
            i % 2 == 0 ? random_uniform(&w->random, 0.5, 1.5) : random_uniform(&w->random, 1.5, 4);
        phase[i / 2][i % 2] = random_uniform(&w->random, 0, 360 * DEGREE);
    }
    world_unit(w->c);
    for (int n = 0; n < samples; n++) {
        double middle[3] = {0, 0, 0};
        double step[3], r[3][3];
        for (int k = 0; k < fine; k++) {
            const double tau = (n + (k + 0.5) / fine) / samples;
            const double window = 16 * tau * tau * (1 - tau) * (1 - tau);
            for (int i = 0; i < 3; i++) {
                double omega = vector[i] / seconds * 30 * tau * tau * (1 - tau) * (1 - tau);
                for (int p = 0; p < 2; p++) {
                    omega += window * amplitude[i][p] *
                             sin(360 * DEGREE * pace[i][p] * tau * seconds + phase[i][p]);
                }
                step[i] = omega / (w->rate * fine);
                middle[i] += omega / fine;
            }
            rotation_by(step, r);
            world_turn(w->c, (const double(*)[3])r);
        }
        world_sample(w, middle, 0);
    }
    world_rest(w, 1.5);
}

static inline void world_end(world *w)
{
    static const double none[3] = {0, 0, 0};

    for (int i = 0; i < 5 * WORLD_BLOCK; i++) {
        world_sample(w, none, 0);
    }
}

/* The means of the rests as the library takes them. */
static inline void world_means(const world *w, invcal_real raw[WORLD_RESTS][3])
{
    for (int i = 0; i < 3 * w->count; i++) {
        raw[i / 3][i % 3] = (invcal_real)w->mean[i / 3][i % 3];
    }
}

/* What is known, and what is found, in the order of the solution: the gyroscope first. */
typedef struct {
    uint8_t held;
    invcal_real noise;                   /* of a mean; 0: unknown */
    invcal_real rate_noise, instability; /* 0: none at all */
    const invcal_real *prior;
} world_settings;

#define WORLD_USUAL {0, 0, INVCAL_REAL(8.7e-5), INVCAL_REAL(1e-4), NULL}

typedef struct {
    invcal_imu_result result;
    invcal_real parameter[INVCAL_GYRO_PARAMETERS]; /* M, by rows */
    invcal_real sigma[INVCAL_IMU_PARAMETERS];
    uint32_t open;
} world_solution;

static inline invcal_positions world_positions(const world *w, invcal_real raw[WORLD_RESTS][3],
                                               const invcal_calibration *nominal)
{
    invcal_positions positions;

    memset(&positions, 0, sizeof positions);
    world_means(w, raw);
    positions.mean = (const invcal_vector *)(const void *)raw;
    positions.count = (unsigned)w->count;
    positions.nominal = nominal;
    return positions;
}

/* As the library wants them. prior: space for it. */
static inline invcal_imu_settings world_stated(const world_settings *s,
                                               invcal_real prior[INVCAL_IMU_PARAMETERS])
{
    const invcal_real none = INVCAL_REAL(1e-15);
    invcal_imu_settings settings;

    memset(&settings, 0, sizeof settings);
    settings.held = s->held;
    settings.rate_noise = s->rate_noise == 0 ? none : s->rate_noise;
    settings.instability = s->instability == 0 ? none : s->instability;
    for (unsigned i = 0; s->prior && i < INVCAL_IMU_PARAMETERS; i++) {
        prior[invcali_imu_parameter(i)] = s->prior[i];
    }
    settings.prior = s->prior ? prior : NULL;
    return settings;
}

static inline invcal_status world_solve_of(const world *w, const invcal_positions *positions,
                                           const invcal_imu_settings *settings, world_solution *out)
{
    const invcal_status status = invcali_imu_solve_of(&w->imu, positions, settings, &out->result);

    out->open = 0;
    for (unsigned i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        const unsigned at = invcali_imu_parameter(i);
        out->sigma[i] = out->result.sigma[at];
        out->open |= (out->result.weak >> at & 1u) << i;
    }
    for (unsigned i = 0; i < INVCAL_GYRO_PARAMETERS; i++) {
        out->parameter[i] =
            out->result.gyro.matrix[i / 3][i % 3] / w->imu.nominal.matrix[i % 3][i % 3];
    }
    return status;
}

static inline invcal_status world_solve(const world *w, const world_settings *settings,
                                        world_solution *out)
{
    invcal_real raw[WORLD_RESTS][3];
    invcal_real prior[INVCAL_IMU_PARAMETERS];
    const invcal_calibration nominal = unit_nominal();
    invcal_positions positions = world_positions(w, raw, &nominal);
    invcal_imu_settings stated;

    if (settings) {
        stated = world_stated(settings, prior);
        positions.noise = settings->noise;
    }
    return world_solve_of(w, &positions, settings ? &stated : NULL, out);
}

/* All equations of the first pass, without a prior. */
static inline void world_sum(const world *w, const world_settings *settings, invcali_imu_work *work)
{
    static invcal_imu_result out;
    invcal_real raw[WORLD_RESTS][3];
    const invcal_calibration nominal = unit_nominal();
    invcal_positions positions = world_positions(w, raw, &nominal);
    const invcal_imu_settings stated = world_stated(settings, NULL);

    positions.noise = settings->noise;
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_imu_begin(work, &w->imu, &positions, &stated, &out));
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcali_imu_sum(work));
}

/* The shortest turn that makes this direction up. */
static inline void world_to(world *w, const double to[3])
{
    double vector[3];
    double length = 0;
    double dot = 0;

    for (int i = 0; i < 3; i++) { /* the device turns by the vector to x up */
        vector[i] = to[(i + 1) % 3] * w->up[(i + 2) % 3] - to[(i + 2) % 3] * w->up[(i + 1) % 3];
        length += vector[i] * vector[i];
        dot += to[i] * w->up[i];
    }
    const double angle = atan2(sqrt(length), dot);
    for (int i = 0; i < 3; i++) {
        vector[i] *= angle / sqrt(length);
    }
    world_move(w, vector, random_uniform(&w->random, 0.85, 1.2) * fmax(1, angle / 1.6));
}

/* Quarter turns: each of the twelve edges of the octahedron once. */
static inline void world_tour(world *w)
{
    static const char tour[] = "zxyZXyzXYZxYz"; /* small: that axis up, large: down */

    if (w->count == 0) {
        world_rest(w, 1.5);
    }
    for (int k = 1; tour[k] != 0; k++) {
        double to[3] = {0, 0, 0};
        const int is_down = tour[k] < 'a';
        to[(is_down ? tour[k] - 'X' : tour[k] - 'x')] = is_down ? -1 : 1;
        world_to(w, to);
    }
}

#endif
