/* SPDX-License-Identifier: MIT */
#include "simulate/wave.h"

#include <math.h>
#include <string.h>

#include "maths/matrix.h"
#include "maths/rotation.h"
#include "text/unit.h"

#define TURN 6.283185307179586
#define TURN_RATE 1.2      /* rad/s about each axis, standard deviation */
#define TURN_MEMORY 0.7    /* its correlation time, seconds */
#define TREMOR_RATE 3.0    /* Hz, as in scene.c */
#define NOISE_MEMORY 0.5   /* correlation time of the noise, seconds */
#define WHITE_NOISE 0.2    /* over the correlated noise */
#define MAGNET_SECONDS 2.0 /* time that a magnet takes to pass by */
#define MAGNET_FIELD 1.0   /* of that magnet, over the earth's */

static void cross(const double a[3], const double b[3], double out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
}

static double length_of(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void normalise(double v[3])
{
    const double length = length_of(v);

    for (unsigned i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

static void rotate(const double (*r)[3], const double v[3], double out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        out[i] = r[i][0] * v[0] + r[i][1] * v[1] + r[i][2] * v[2];
    }
}

/* ---- the truth --------------------------------------------------------------------------------- */

/* I + S. */
static void set_response(const wave_model *m, double response[3][3])
{
    for (unsigned i = 0; i < 3; i++) {
        response[i][i] = 1 + m->soft[i];
    }
    response[0][1] = response[1][0] = m->soft[3] / 2;
    response[0][2] = response[2][0] = m->soft[4] / 2;
    response[1][2] = response[2][1] = m->soft[5] / 2;
}

invcal_calibration wave_truth(const wave_model *m)
{
    invcal_calibration sensor = {.offset = {0}};
    invcal_calibration truth;

    set_response(m, sensor.matrix);
    memcpy(truth.offset, m->hard, sizeof truth.offset);
    (void)matrix_inverse(&sensor, truth.matrix); /* small errors: not singular */
    return truth;
}

void wave_axes(const wave_model *m, double r[3][3])
{
    const double angle = length_of(m->turn);
    double axis[3] = {1, 0, 0};

    for (unsigned i = 0; i < 3 && angle > 0; i++) {
        axis[i] = m->turn[i] / angle;
    }
    rotation_about(axis, angle * UNIT_DEGREE, r);
}

/* ---- motion ------------------------------------------------------------------------------------ */

/* One step of a first-order Gauss-Markov process with correlation time `memory`, s. */
static void gauss_markov_step(wave *w, double x[3], double memory, double sigma)
{
    const double decay = exp(-1 / (memory * w->accelerometer->rate));

    for (unsigned i = 0; i < 3; i++) {
        x[i] = decay * x[i] + sigma * sqrt(1 - decay * decay) * random_normal(&w->random);
    }
}

/* In the axes of the device, directions of the world turn in the opposite sense. */
static void turn(wave *w)
{
    const double speed = length_of(w->rate);
    double axis[3];
    double r[3][3];
    double up[3];
    double north[3];
    double side[3];

    for (unsigned i = 0; i < 3; i++) {
        axis[i] = -w->rate[i] / speed;
    }
    rotation_about(axis, speed / w->accelerometer->rate, r);
    rotate((const double(*)[3])r, w->up, up);
    rotate((const double(*)[3])r, w->north, north);
    normalise(up);
    cross(up, north, side);
    cross(side, up, north);
    normalise(north);
    memcpy(w->up, up, sizeof up);
    memcpy(w->north, north, sizeof north);
}

void wave_begin(wave *w, const wave_model *model, const scene_model *accelerometer, uint32_t seed)
{
    double any[3];

    *w = (wave){.model = model, .accelerometer = accelerometer, .random = random_start(seed)};
    random_direction(&w->random, w->up);
    random_direction(&w->random, any);
    cross(w->up, any, w->north);
    normalise(w->north);
    random_direction(&w->random, w->magnet);
    for (unsigned i = 0; i < 3; i++) {
        w->rate[i] = TURN_RATE * random_normal(&w->random);
        w->noise[i] = model->noise * random_normal(&w->random);
    }
}

/* ---- readings ---------------------------------------------------------------------------------- */

static void read_field(wave *w, double time, double out[3])
{
    const wave_model *m = w->model;
    const double dip = m->field[1] * UNIT_DEGREE;
    const double progress = (time - m->magnet) / MAGNET_SECONDS;
    const double nearness = progress > 0 && progress < 1 ? sin(TURN / 2 * progress) : 0;
    double response[3][3];
    double axes[3][3];
    double earth[3];
    double own[3];

    set_response(m, response);
    wave_axes(m, axes);
    for (unsigned i = 0; i < 3; i++) {
        earth[i] = m->field[0] * (cos(dip) * w->north[i] - sin(dip) * w->up[i] +
                                  nearness * MAGNET_FIELD * w->magnet[i]);
    }
    for (unsigned i = 0; i < 3; i++) { /* to the axes of the magnetometer */
        own[i] = axes[0][i] * earth[0] + axes[1][i] * earth[1] + axes[2][i] * earth[2];
    }
    gauss_markov_step(w, w->noise, NOISE_MEMORY, m->noise);
    rotate((const double(*)[3])response, own, out);
    for (unsigned i = 0; i < 3; i++) {
        out[i] += m->hard[i] + w->noise[i] + WHITE_NOISE * m->noise * random_normal(&w->random);
    }
}

int wave_next(wave *w, wave_sample *out)
{
    static const double none[3] = {0, 0, 0};
    const scene_model *a = w->accelerometer;
    double acceleration[3];

    if ((double)w->index >= w->model->seconds * a->rate) {
        return 0;
    }
    out->time = (double)w->index / a->rate;
    gauss_markov_step(w, w->rate, TURN_MEMORY, TURN_RATE);
    turn(w);
    gauss_markov_step(w, w->tremor, 1 / (TURN * TREMOR_RATE), a->tremor);
    for (unsigned i = 0; i < 3; i++) {
        acceleration[i] = w->up[i] + w->tremor[i];
    }
    scene_read(a, &w->random, acceleration, none, out->raw);
    read_field(w, out->time, out->field);
    w->index++;
    return 1;
}
