/* SPDX-License-Identifier: MIT
 *
 * Residuals of the moves, by integrating sample by sample: the library keeps segments, and reports
 * only the worst move.
 */
#include <math.h>
#include <string.h>

#include "fit/gyro.h"

#define RANGE_MIN 2.0 /* K */
#define RESTS_MIN 6u

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
}

/* C <- C exp([th x]), by rows. */
static void turn_by(double c[3][3], const double th[3])
{
    const double x = sqrt(dot(th, th));
    const double s = x > 1e-6 ? sin(x) / x : 1;
    const double k = x > 1e-6 ? (1 - cos(x)) / (x * x) : 0.5;

    for (unsigned i = 0; i < 3; i++) {
        double a[3];
        double b[3];
        cross(c[i], th, a);
        cross(a, th, b);
        for (unsigned j = 0; j < 3; j++) {
            c[i][j] += s * a[j] + k * b[j];
        }
    }
}

/* The calibrated acceleration of a sample, over the field. */
static void acceleration_at(const gyro_fit *g, size_t index, double out[3])
{
    const gyro_log *log = g->log;
    double raw[3];

    for (unsigned k = 0; k < 3; k++) {
        raw[k] = log->sample[index].raw[k] * log->unit;
    }
    invcal_apply(&g->imu.accelerometer, raw[0], raw[1], raw[2], out);
}

/* The bias: the mean of both rests, corrected for the difference in acceleration. */
static void bias_at(const gyro_fit *g, const gyro_rest *rest, const double f[3], double out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        out[i] = (rest[0].bias[i] + rest[1].bias[i]) / 2;
        for (unsigned k = 0; k < 3 && g->imu.g_is_used; k++) {
            out[i] += g->imu.slope[i][k] * (f[k] - (rest[0].up[k] + rest[1].up[k]) / 2);
        }
    }
}

/* The rotation matrix of the whole move, and the angle of its path. */
static void integrate(const gyro_fit *g, long lag, const gyro_rest *rest, double c[3][3],
                      double *angle)
{
    const gyro_log *log = g->log;
    size_t next;
    size_t last;

    gyro_between(log, lag, rest, &next, &last);
    for (size_t i = rest[0].end; i < rest[1].begin; i++) {
        double f[3];
        double bias[3];
        acceleration_at(g, i, f);
        bias_at(g, rest, f, bias);
        for (; next < last && (long)next < (long)log->sample[i].reading_end + lag; next++) {
            double u[3];
            double th[3];
            gyro_axes(g->axes, log->reading[next].x, u);
            for (unsigned k = 0; k < 3; k++) {
                u[k] = (g->rate_unit * u[k] - bias[k]) / log->rate;
            }
            for (unsigned k = 0; k < 3; k++) {
                th[k] = dot(g->m[k], u);
            }
            turn_by(c, th);
            *angle += sqrt(dot(th, th));
        }
    }
}

/* The angle between the up direction at the beginning, and that at the end, rotated back. */
static double residual(const double (*c)[3], const gyro_rest *rest)
{
    double a[3];
    double y[3];

    for (unsigned i = 0; i < 3; i++) {
        a[i] = dot(c[i], rest[1].up);
    }
    cross(a, rest[0].up, y);
    return atan2(sqrt(dot(y, y)), dot(a, rest[0].up));
}

/* The noise density of the quietest rest, rad/s/sqrt(Hz). */
static double density(const gyro_fit *g, long lag)
{
    const gyro_log *log = g->log;
    double lowest = HUGE_VAL;

    for (unsigned i = 0; i < g->rests; i++) {
        double square = 0;
        size_t n = 0;
        for (size_t k = g->rest[i].begin; k < g->rest[i].end; k++) {
            const long at = (long)log->sample[k].reading_end + lag - 1;
            for (unsigned j = 0; j < 3 && at >= 0 && at < (long)log->readings; j++, n++) {
                double x[3];
                gyro_axes(g->axes, log->reading[at].x, x);
                square += pow(g->rate_unit * x[j] - g->rest[i].bias[j], 2);
            }
        }
        lowest = n > 30 && isfinite(square) ? fmin(lowest, square / (double)n / log->rate) : lowest;
    }
    return lowest < HUGE_VAL ? sqrt(lowest) : 0;
}

/* The sizes of the parts of a move's error, rad on an axis. */
static void find_parts(gyro_fit *g, long lag)
{
    double seconds = 0;
    double change = 0;
    unsigned count = 0;

    for (unsigned i = 0; i < g->moves; i++) {
        const gyro_rest *rest = &g->rest[g->move[i].to];
        double bias_from[3];
        double bias_to[3];
        if (g->move[i].why != INVCAL_OK || !isfinite(rest->bias[0] + rest[-1].bias[0])) {
            continue;
        }
        bias_at(g, rest - 1, rest->up, bias_to); /* to subtract the effect of orientation */
        bias_at(g, rest - 1, rest[-1].up, bias_from);
        for (unsigned k = 0; k < 3; k++) {
            change += pow(rest->bias[k] - rest[-1].bias[k] - (bias_to[k] - bias_from[k]), 2) / 3;
        }
        seconds += g->move[i].seconds;
        count++;
    }
    if (count > 0) {
        const double time = seconds / count;
        g->part[GYRO_PART_RESTS] = sqrt(2) * g->imu.noise;
        g->part[GYRO_PART_NOISE] = density(g, lag) * sqrt(time);
        g->part[GYRO_PART_BIAS] = sqrt(change / count) / 2 * time;
    }
}

/* Fits a straight line to the bias of each axis over temperature. */
static void find_thermal(gyro_fit *g, const positions *p)
{
    double lowest = HUGE_VAL;
    double highest = -HUGE_VAL;

    for (unsigned i = 0; i < g->rests && p->has_temperature; i++) {
        lowest = fmin(lowest, p->origin[g->rest[i].position].temperature);
        highest = fmax(highest, p->origin[g->rest[i].position].temperature);
    }
    if (!(highest - lowest >= RANGE_MIN) || g->rests < RESTS_MIN) {
        return;
    }
    g->range = highest - lowest;
    for (unsigned axis = 0; axis < 3; axis++) {
        double n = 0;
        double sum[5] = {0}; /* t, b, tt, tb, bb */
        for (unsigned i = 0; i < g->rests; i++) {
            const gyro_rest *rest = &g->rest[i];
            const double t = p->origin[rest->position].temperature - lowest;
            const double level = g->imu.g_is_used ? dot(g->imu.slope[axis], rest->up) : 0;
            const double b = rest->bias[axis] - g->rest[g->rests - 1].bias[axis] - level;
            if (isfinite(t + b)) {
                n++;
                sum[0] += t;
                sum[1] += b;
                sum[2] += t * t;
                sum[3] += t * b;
                sum[4] += b * b;
            }
        }
        const double tt = sum[2] - sum[0] * sum[0] / n;
        const double tb = sum[3] - sum[0] * sum[1] / n;
        const double rest = sum[4] - sum[1] * sum[1] / n - tb * tb / tt;
        g->thermal[axis] = tb / tt;
        g->thermal_sigma[axis] = sqrt(fmax(0, rest) / (n - 2) / tt);
    }
}

void gyro_measure(gyro_fit *g, long lag, const positions *p)
{
    for (unsigned i = 0; i < g->rests; i++) {
        gyro_rest *rest = &g->rest[i];
        double x[3];
        gyro_axes(g->axes, rest->bias, x);
        for (unsigned k = 0; k < 3; k++) {
            rest->bias[k] = g->rate_unit * x[k];
        }
        invcal_apply(&g->imu.accelerometer, p->mean[3 * (size_t)rest->position],
                     p->mean[3 * (size_t)rest->position + 1],
                     p->mean[3 * (size_t)rest->position + 2], rest->up);
        const double length = sqrt(dot(rest->up, rest->up));
        for (unsigned k = 0; k < 3; k++) {
            rest->up[k] /= length;
        }
    }
    for (unsigned i = 0; i < g->moves; i++) {
        gyro_move *m = &g->move[i];
        const gyro_rest *rest = &g->rest[m->to - 1];
        double c[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        m->angle = 0;
        integrate(g, lag, rest, c, &m->angle);
        m->residual = residual((const double(*)[3])c, rest);
    }
    find_parts(g, lag);
    find_thermal(g, p);
}
