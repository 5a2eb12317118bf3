/* SPDX-License-Identifier: MIT */
#include "simulate/scene.h"

#include <math.h>
#include <string.h>

#include "maths/matrix.h"

#define TURN 6.283185307179586
#define WALK_MEMORY 100.0 /* seconds */
#define TREMOR_RATE 3.0   /* Hz */
#define REFERENCE 25.0    /* degrees C */
#define BULGE 0.3         /* detour of a move from the shortest arc, rad */
#define TWIST 0.7         /* rad about up, in a move */
#define SHAKE 0.15        /* amplitude of the hand's acceleration, over the field */
#define SHAKE_RATE 4.0    /* Hz */

/* I + S. */
static void set_response(const scene_model *m, double response[3][3])
{
    response[0][1] = response[1][0] = m->gamma[0] / 2;
    response[0][2] = response[2][0] = m->gamma[1] / 2;
    response[2][1] = response[1][2] = m->gamma[2] / 2;
    for (unsigned i = 0; i < 3; i++) {
        response[i][i] = 1 + m->dk[i];
    }
}

invcal_calibration scene_truth(const scene_model *m)
{
    invcal_calibration sensor = {.offset = {0}}; /* field to counts */
    invcal_calibration truth;

    set_response(m, sensor.matrix);
    for (unsigned r = 0; r < 3; r++) {
        truth.offset[r] = m->zero[r] + m->delta[r] * m->field / m->lsb;
        for (unsigned c = 0; c < 3; c++) {
            sensor.matrix[r][c] /= m->lsb;
        }
    }
    (void)matrix_inverse(&sensor, truth.matrix); /* small errors: not singular */
    return truth;
}

static uint64_t dwell_samples(const scene *s)
{
    return (uint64_t)ceil(s->model->dwell * s->model->rate);
}

static uint64_t leg_samples(const scene *s) /* a dwell and the move after it */
{
    return dwell_samples(s) + (uint64_t)ceil(s->model->move * s->model->rate);
}

void scene_interval(const scene *s, unsigned i, uint64_t *begin, uint64_t *end)
{
    *begin = i * leg_samples(s);
    *end = *begin + dwell_samples(s);
}

/* Draws the outliers, without replacement. */
static void choose_outliers(scene *s)
{
    for (unsigned n = 0; n < s->model->outliers && n < s->route->count; n++) {
        unsigned i;
        do {
            i = (unsigned)random_uniform(&s->random, 0, s->route->count);
        } while (fabs(s->wrong[i]) > 0);
        const double sign = random_uniform(&s->random, -1, 1) < 0 ? -1 : 1;
        s->wrong[i] = sign * s->model->outlier_size;
    }
}

void scene_begin(scene *s, const scene_model *model, const design *route, uint32_t seed)
{
    uint64_t begin;

    memset(s, 0, sizeof *s);
    s->model = model;
    s->route = route;
    s->random = random_start(seed);
    s->leg = -1;
    scene_interval(s, route->count - 1, &begin, &s->total);
    choose_outliers(s);
    if (model->gyro) {
        gyro_scene_begin(&s->gyro, model->gyro, model->rate, seed);
    }
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalise(double v[3])
{
    const double length = sqrt(dot(v, v));

    for (unsigned i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

/* A direction between a (share 0) and b (1) on the shortest arc, with a sideways bulge in the
 * middle. */
static void interpolate(const double a[3], const double b[3], const double sideways[3],
                        double share, double v[3])
{
    const double angle = acos(fmax(-1, fmin(1, dot(a, b))));
    const double bulge = BULGE * pow(sin(TURN / 2 * share), 2);
    const double smooth = share * share * (3 - 2 * share);
    double across[3]; /* unit vector at right angles to a, towards b */

    for (unsigned i = 0; i < 3; i++) {
        across[i] = b[i] - dot(a, b) * a[i];
    }
    if (!(dot(across, across) > 1e-12)) { /* b is equal or opposite to a */
        for (unsigned i = 0; i < 3; i++) {
            across[i] = sideways[i] - dot(a, sideways) * a[i];
        }
    }
    normalise(across);
    for (unsigned i = 0; i < 3; i++) {
        v[i] = cos(angle * smooth) * a[i] + sin(angle * smooth) * across[i] + bulge * sideways[i];
    }
    normalise(v);
}

/* One step of a first-order Gauss-Markov process x' = -rate x + noise with standard deviation
 * sigma: drift of the offsets, tremor of the hand. */
static void gauss_markov_step(scene *s, double x[3], double rate, double sigma)
{
    const double decay = exp(-rate / s->model->rate);

    for (unsigned i = 0; i < 3 && sigma > 0; i++) {
        x[i] = decay * x[i] + sigma * sqrt(1 - decay * decay) * random_normal(&s->random);
    }
}

/* An angle between two others, degrees, the shorter way. */
static double interpolate_angle(double from, double to, double share)
{
    return from + share * remainder(to - from, 360);
}

/* The angles of a stand, at a share 0 ... 1 of the move after a position. */
static void read_stand(const scene *s, scene_sample *out, int leg, double share)
{
    const design_position *here = &s->route->position[leg];
    const design_position *next = share > 0 ? here + 1 : here;

    out->alpha = interpolate_angle(here->alpha, next->alpha, share);
    out->beta = interpolate_angle(here->beta, next->beta, share);
}

/* The acceleration of the case, over the field; also updates position, angles and up. */
static void find_acceleration(scene *s, scene_sample *out, double v[3])
{
    const uint64_t into = s->index % leg_samples(s);
    const int leg = (int)(s->index / leg_samples(s));

    out->position = into < dwell_samples(s) ? leg : -1;
    if (leg != s->leg) {
        s->leg = leg;
        random_direction(&s->random, s->sideways);
        random_direction(&s->random, s->shake);
        s->twist = TWIST * s->shake[0];
    }
    const double *here = s->route->position[leg].vertical;
    memcpy(v, here, 3 * sizeof *v);
    memcpy(s->up, here, sizeof s->up);
    read_stand(s, out, leg, 0);
    for (unsigned i = 0; i < 3 && out->position >= 0; i++) {
        v[i] += s->wrong[leg] * here[i];
    }
    if (out->position < 0) {
        const double moved = (double)(into - dwell_samples(s)) + 0.5;
        const double share = moved / (double)(leg_samples(s) - dwell_samples(s));
        const double push =
            SHAKE * pow(sin(TURN / 2 * share), 2) * sin(TURN * SHAKE_RATE * moved / s->model->rate);
        read_stand(s, out, leg, share);
        interpolate(here, s->route->position[leg + 1].vertical, s->sideways, share, v);
        memcpy(s->up, v, sizeof s->up);
        for (unsigned i = 0; i < 3; i++) {
            v[i] += push * s->shake[i];
        }
    }
    gauss_markov_step(s, s->tremor, TURN * TREMOR_RATE, s->model->tremor);
    for (unsigned i = 0; i < 3; i++) {
        v[i] += s->tremor[i];
    }
}

/* A reading in counts: rounded and clipped. */
static int32_t quantise(const scene_model *m, double u, double zero)
{
    const double clipped = fmax(-m->range, fmin(m->range, u));
    const double counts = nearbyint(zero + clipped * m->field / m->lsb);

    return (int32_t)fmax(INT32_MIN, fmin(INT32_MAX, counts));
}

void scene_read(const scene_model *m, random_source *random, const double acceleration[3],
                const double extra[3], int32_t raw[3])
{
    double response[3][3];

    set_response(m, response);
    for (unsigned i = 0; i < 3; i++) {
        const double u = dot(response[i], acceleration) + m->delta[i] + extra[i] +
                         m->noise * random_normal(random);
        raw[i] = quantise(m, u, m->zero[i]);
    }
}

int scene_next(scene *s, scene_sample *out)
{
    const scene_model *m = s->model;
    double v[3];
    double extra[3];

    if (s->index == s->total) {
        return 0;
    }
    const double share = s->total > 1 ? (double)s->index / (double)(s->total - 1) : 0;
    out->time = (double)s->index / m->rate;
    out->temperature = m->temperature[0] + share * (m->temperature[1] - m->temperature[0]);
    find_acceleration(s, out, v);
    gauss_markov_step(s, s->walk, 1 / WALK_MEMORY, m->instability);
    for (unsigned i = 0; i < 3; i++) {
        extra[i] = s->walk[i] + m->drift * (out->temperature - REFERENCE);
    }
    scene_read(m, &s->random, v, extra, out->raw);
    if (m->gyro) {
        const double legs = (double)(leg_samples(s) - dwell_samples(s));
        gyro_scene_next(&s->gyro, s->up, v, out->position < 0 ? s->twist / legs : 0, out->gyro);
    }
    s->index++;
    return 1;
}
