/* SPDX-License-Identifier: MIT */
#include "simulate/gyro.h"

#include <math.h>
#include <string.h>

#include "maths/matrix.h"
#include "maths/rotation.h"
#include "text/unit.h"

/* I + errors. */
static void set_response(const gyro_model *m, double r[3][3])
{
    static const unsigned row[6] = {0, 0, 1, 1, 2, 2};
    static const unsigned column[6] = {1, 2, 0, 2, 0, 1};

    for (unsigned i = 0; i < 3; i++) {
        r[i][i] = 1 + m->scale[i];
    }
    for (unsigned i = 0; i < 6; i++) {
        r[row[i]][column[i]] = m->cross[i];
    }
}

invcal_calibration gyro_scene_truth(const gyro_model *m)
{
    invcal_calibration sensor = {.offset = {0}}; /* rad/s to counts */
    invcal_calibration truth;

    set_response(m, sensor.matrix);
    for (unsigned i = 0; i < 9; i++) {
        sensor.matrix[i / 3][i % 3] /= m->lsb * UNIT_DEGREE;
    }
    for (unsigned i = 0; i < 3; i++) {
        truth.offset[i] = m->bias[i] / m->lsb;
    }
    (void)matrix_inverse(&sensor, truth.matrix); /* small errors: not singular */
    return truth;
}

int gyro_scene_g(const gyro_model *m, double g[3][3])
{
    const invcal_calibration truth = gyro_scene_truth(m);
    double max = 0;

    for (unsigned i = 0; i < 9; i++) {
        g[i / 3][i % 3] = 0;
        for (unsigned k = 0; k < 3; k++) {
            g[i / 3][i % 3] += truth.matrix[i / 3][k] * m->g[3 * k + i % 3] / m->lsb;
        }
        max = fmax(max, fabs(m->g[i]));
    }
    return max > 0;
}

void gyro_scene_begin(gyro_scene *s, const gyro_model *model, double rate, uint32_t seed)
{
    *s = (gyro_scene){.model = model, .random = random_start(seed + 0x9e3779b9u), .rate = rate};
}

/* The rotation vector that turns `up` back to `before`, after a twist about it. */
static void turn_between(const double before[3], const double up[3], double twist, double th[3])
{
    double axis[3];
    double back[3][3];
    double about[3][3];
    double both[3][3];
    double sine = 0;
    double cosine = 0;

    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = (i + 1) % 3;
        const unsigned k = (i + 2) % 3;
        axis[i] = up[j] * before[k] - up[k] * before[j];
        sine += axis[i] * axis[i];
        cosine += up[i] * before[i];
    }
    sine = sqrt(sine);
    for (unsigned i = 0; i < 3; i++) {
        axis[i] = sine > 0 ? axis[i] / sine : up[i];
    }
    rotation_about(axis, atan2(sine, cosine), back);
    rotation_about(up, twist, about);
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            both[i][j] =
                back[i][0] * about[0][j] + back[i][1] * about[1][j] + back[i][2] * about[2][j];
        }
    }
    rotation_vector((const double(*)[3])both, th);
}

void gyro_scene_next(gyro_scene *s, const double up[3], const double acceleration[3], double twist,
                     int32_t raw[3])
{
    const gyro_model *m = s->model;
    double response[3][3];
    double th[3] = {0, 0, 0};

    if (s->is_begun) {
        turn_between(s->before, up, twist, th);
    }
    memcpy(s->before, up, sizeof s->before);
    s->is_begun = 1;
    set_response(m, response);
    for (unsigned i = 0; i < 3; i++) {
        double u = m->bias[i] + m->noise * random_normal(&s->random);
        for (unsigned k = 0; k < 3; k++) {
            u += response[i][k] * th[k] * s->rate / UNIT_DEGREE + m->g[3 * i + k] * acceleration[k];
        }
        const double counts = nearbyint(fmax(-m->range, fmin(m->range, u)) / m->lsb);
        raw[i] = (int32_t)fmax(INT32_MIN, fmin(INT32_MAX, counts));
    }
}
