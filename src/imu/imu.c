/* SPDX-License-Identifier: MIT
 *
 * Accelerometer and gyroscope in one least-squares solution (mathematics_imu.md). Unknowns are the
 * nine elements of M, by rows, then delta, dk and gamma of the accelerometer; if that is held, only
 * the first nine.
 *
 * Order: the integral of a move ("Segments"), the bias of each rest ("The bias"), the equations of
 * rests and moves ("Two equations from a move"), Gauss-Newton passes with their weights
 * ("Weights"), the result ("Verdict"). Each pass integrates all segments again with its own M, so
 * no error of linearisation remains in the solution.
 */
#include "imu.h"

#include <stddef.h>
#include <string.h>

#include "../calibrate/judge.h"
#include "rotation.h"
#include "../session/session.h"
#include "../core/solve.h"
#include "../core/sums.h"

/* mathematics_imu.md: "Weights", "Verdict", and "Two equations from a move" for the angles below
 * which one is idle. */
#define STEP (INVCAL_DOUBLE ? INVCAL_REAL(1e-14) : INVCAL_REAL(1e-11)) /* squared: converged */
#define FAR_APART INVCAL_REAL(12.5)      /* 5 sigma, squared, over the variance of two angles */
#define ABSURD_TURN INVCAL_REAL(0.01)    /* residuals of 0.1 rad, squared */
#define SAME_UP INVCAL_REAL(0.9962)      /* cosine of 5 degrees */
#define NO_ANGLE INVCAL_REAL(0.0076)     /* 5 degrees, squared */
#define WEAK_SQUARE INVCAL_REAL(6.25)    /* of 2.5 */
#define OPEN_SQUARE INVCAL_REAL(1e6)     /* of 1000 */
#define BEYOND_4_SIGMA INVCAL_REAL(16.0) /* 4 sigma, squared */
#define IMU_RIDGE INVCAL_REAL(6e-6)      /* of the trace */
#define HELD_BY_RIDGE INVCAL_REAL(0.1)   /* open: the ridge gives more than this share */
#define STATED_ROWS INVCAL_REAL(4.0)     /* residuals that a stated noise counts as */
#define UNSTATED_ROWS INVCAL_REAL(0.01)  /* of a residual; with 0, rounding errors would count */
#define ROUGH_VARIANCE INVCAL_REAL(2.0)  /* times the stated variance: something is wrong */

enum {
    IMU_ALL = INVCAL_IMU_PARAMETERS,
    IMU_GYRO = INVCAL_GYRO_PARAMETERS,
    LEAST_PASSES = 4, /* two steps, an update of the variances, a step */
    PASSES = 10,      /* two steps, three pairs of update and step, two last steps */
    SETTLED = 2,      /* passes after which residuals are those of noise */
    MOST_APART = 3,   /* moves left out */
    LEAST_MOVES = 6,
    BIAS = 5,         /* unknowns of a bias: three of up, time, constant */
    LEAST_RESTS = 12, /* to determine them */
    SERIES_OF_TURN = INVCAL_DOUBLE ? 9 : 5
};

/* ---- a move ---------------------------------------------------------------------------------- */

/* out = C' a */
static void turn_back(invcal_real (*c)[3], const invcal_real a[3], invcal_real out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        out[i] = c[0][i] * a[0] + c[1][i] * a[1] + c[2][i] * a[2];
    }
}

/* With the matrix I + E: S += C J v', C <- C exp([th x]), J the left Jacobian of th. By rows: c [th
 * x] is c x th. The series are those of (1 - cos x)/x^2 and (x - sin x)/x^3. */
static void turn_segment(invcali_replay *r, const invcal_real v[3], const invcal_real th[3])
{
    const invcal_real x = invcali_dot3(th, th);
    invcal_real k = 1;
    invcal_real l = 1;

    for (unsigned n = SERIES_OF_TURN; n > 0; n--) {
        const invcal_real m = invcali_number(2 * n + 1);
        k = 1 - k * x / (m * (m + 1));
        l = 1 - l * x / ((m + 1) * (m + 2));
    }
    k /= 2;
    l /= 6;
    for (unsigned i = 0; i < 3; i++) {
        invcal_real a[3];
        invcal_real b[3];
        invcal_real *c = r->c[i];
        invcali_cross(c, th, a);
        invcali_cross(a, th, b);
        for (unsigned j = 0; j < 3; j++) {
            const invcal_real p = c[j] + k * a[j] + l * b[j];
            c[j] += (1 - x * l) * a[j] + k * b[j];
            for (unsigned n = 0; n < 3; n++) {
                r->s[j][i][n] += p * v[n];
            }
        }
    }
}

/* The bias of the move is the mean of two rests. That of a segment differs by G times (up at its
 * middle less the mean of up in both rests). */
void invcali_replay_move(const invcali_imu_work *w, const invcal_private_segment *segment,
                         unsigned count, const invcal_real bias[3], const invcal_real up[2][3],
                         invcali_replay *r)
{
    const invcal_real(*m)[3] = (const invcal_real(*)[3])w->parameter;
    invcal_real cofactors[3][3];
    invcal_real v[3];
    invcal_real f[3];
    invcal_real th[3];

    invcali_zero(r, sizeof *r);
    for (unsigned i = 0; i < 3; i++) {
        r->c[i][i] = 1;
    }
    (void)invcali_cofactors(m, cofactors);
    for (unsigned n = 0; n < count; n++) {
        //@ assert \valid_read(segment); // of this move
        const invcal_real time = invcali_number(segment->time / 2u) / w->imu->own.rate;
        invcali_zero(v, sizeof v);
        invcali_unpack(segment->v, INVCAL_V_UNIT, v);
        turn_back(r->c, up[0], f);
        invcali_cross(f, v, th); /* half of it leads to the middle of the segment */
        for (unsigned i = 0; i < 3; i++) {
            f[i] += (th[i] - up[0][i] - up[1][i]) / 2;
        }
        for (unsigned i = 0; i < 3; i++) {
            const invcal_real g_bias = w->out->g_is_used ? invcali_dot3(w->out->slope[i], f) : 0;
            v[i] -= time * (bias[i] + g_bias);
        }
        invcali_zero(f, sizeof f);
        invcali_unpack(segment->kappa, INVCAL_KAPPA_UNIT, f);
        for (unsigned i = 0; i < 3; i++) {
            th[i] = invcali_dot3(m[i], v) + invcali_dot3(cofactors[i], f);
        }
        turn_segment(r, v, th);
        r->angle += invcali_dot3(th, th);
        r->time += time;
        segment++;
    }
}

/* ---- bias ------------------------------------------------------------------------------------ */

/* The row of b = b0 + G up + drift t for an axis: (up, t, 1, -b). Returns 0 if the device turned in
 * that rest or in the one before. */
static int has_bias_row(const invcali_imu_work *w, unsigned rest, unsigned axis,
                        invcal_real h[BIAS + 1])
{
    const invcal_private_moves *m = &w->imu->own;
    const invcal_private_still *at = &m->rest[rest];
    const unsigned start = m->rest[w->begin].when;
    const unsigned end = m->rest[w->imu->rests - 1u].when;

    invcali_correct(&w->out->accelerometer, w->mean[rest - w->begin].v, h);
    h[3] = invcali_number(at->when - start) / invcali_number(end - start);
    h[4] = 1;
    h[BIAS] = -w->bias[rest][axis];
    return at->move != -INVCAL_REST_DRIFT;
}

/* Sets the slopes of an axis from L^-1 and p; square: mean square of a residual. */
static void set_slopes(invcal_imu_result *out, unsigned axis, const invcal_real *a,
                       invcal_real square)
{
    const invcal_real *p = &a[INVCAL_PACKED(BIAS, 0)];

    for (unsigned i = 0; i < 4; i++) {
        const invcal_real variance = square * invcali_variance(a, BIAS, i);
        out->slope[axis][i] = p[i];
        out->slope_sigma[axis][i] = INVCAL_SQRT(variance);
        if (i < 3 && p[i] * p[i] > BEYOND_4_SIGMA * variance) {
            out->g_is_used = 1;
        }
    }
}

/* Least squares over all rests. The measured bias of a rest has noise of variance s^2. The fit has
 * less, but misses how the bias wanders apart from up and time, with variance W. Residuals have
 * variance s^2 + W; half the squares of their changes from rest to rest give s^2. Of the variance
 * of the mean of two residuals, s^2/2 + W, s^2/2 is noise. That share of the residual is subtracted
 * from the bias, which is the best linear estimate for the move between two rests. */
static void fit_bias(invcali_imu_work *w, unsigned axis)
{
    const unsigned end = w->imu->rests;
    unsigned count = 0;
    invcal_real changes = 0;
    invcal_real last = 0;
    invcal_real a[INVCAL_PACKED_SIZE(BIAS + 1)];
    invcal_real h[BIAS + 1];
    invcal_real residual[INVCAL_MAX_MOVES];

    invcali_zero(a, sizeof a);
    //@ loop unroll INVCAL_MAX_MOVES;
    for (unsigned i = w->begin; i < end; i++) {
        if (has_bias_row(w, i, axis, h)) {
            invcali_rank_one(a, h, BIAS + 1, 1);
            count++;
        }
    }
    if (count < LEAST_RESTS || invcali_factor(a, BIAS, BIAS + 1, INVCAL_FLOOR) != INVCAL_OK) {
        return;
    }
    invcali_back_substitute(a, BIAS);
    const invcal_real *p = &a[INVCAL_PACKED(BIAS, 0)];
    //@ loop unroll INVCAL_MAX_MOVES;
    for (unsigned i = w->begin; i < end; i++) {
        const int is_rest = has_bias_row(w, i, axis, h);
        residual[i] = invcali_dot(p, h, BIAS) + h[BIAS];
        if (is_rest) {
            changes += (residual[i] - last) * (residual[i] - last);
            last = residual[i];
        }
    }
    /* the remainder of the constant, which rounding may make negative */
    const invcal_real square = INVCAL_FABS(p[BIAS]) / invcali_number(count - BIAS);
    const invcal_real noise = changes / invcali_number(4 * count); /* s^2/2 */
    /* W of less than 0, by chance, is 0: the residuals are all noise */
    const invcal_real share = square > 2 * noise ? noise / (square - noise) : 1;
    //@ loop unroll INVCAL_MAX_MOVES;
    for (unsigned i = w->begin; i < end; i++) {
        w->bias[i][axis] += share * residual[i];
    }
    w->g_bias[axis] = invcali_dot3(p, h); /* of the last rest */
    invcali_invert(a, BIAS);
    set_slopes(w->out, axis, a, square);
}

static void find_bias(invcali_imu_work *w)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        fit_bias(w, axis);
    }
}

/* ---- equations ------------------------------------------------------------------------------- */

INVCAL_NOINLINE static void scale_by(invcal_real v[3], invcal_real times)
{
    for (unsigned i = 0; i < 3; i++) {
        v[i] *= times;
    }
}

/* The right side comes after the unknowns. If there are nine, it overwrites what the accelerometer
 * would add. */
static void add_row(invcali_imu_work *w, invcal_real h[IMU_ALL + 1], invcal_real y,
                    invcal_real weight)
{
    h[w->n] = -y;
    invcali_rank_one(w->pass.sum, h, w->n + 1, weight);
}

/* Adds the length of up in a rest: up D(up) dp = |a| - 1. */
static void add_rest(invcali_imu_work *w, const invcal_real up[3], invcal_real excess)
{
    const invcal_real weight = 1 / w->noise_square;
    invcal_real h[IMU_ALL + 1];

    invcali_zero(h, sizeof h);
    memcpy(&h[IMU_GYRO], up, 3 * sizeof *up);
    invcali_products(up, &h[IMU_GYRO]);
    add_row(w, h, excess, weight / w->variance[INVCAL_OF_RESTS]);
    w->pass.squares[INVCAL_OF_RESTS] += weight * excess * excess;
    w->pass.kind[INVCAL_OF_RESTS]++;
}

/* Adds the angles of a move perpendicular to up. For each axis, with b its perpendicular part,
 * b'y = b'S de + (g1 D(u1) + g0 D(u0)) dp, g1 = C'(u0 x b), g0 = b x a. The three rows have rank
 * two. */
static void add_angles(invcali_imu_work *w, invcali_replay *r, const invcal_real a[3],
                       const invcal_real up[2][3], const invcal_real y[3], invcal_real weight)
{
    invcal_real h[IMU_ALL + 1];
    invcal_real g[INVCAL_PARAMETERS];
    invcal_real b[3];

    for (unsigned k = 0; k < 3; k++) {
        for (unsigned i = 0; i < 3; i++) {
            b[i] = (i == k ? 1 : 0) - up[0][k] * up[0][i];
        }
        for (unsigned i = 0; i < 3; i++) {
            turn_back(r->s[i], b, &h[3 * (size_t)i]);
        }
        invcali_cross(up[0], b, g);
        turn_back(r->c, g, &h[IMU_GYRO]);
        invcali_products(up[1], &h[IMU_GYRO]);
        invcali_cross(b, a, g);
        invcali_products(up[0], g);
        for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
            h[IMU_GYRO + i] += g[i];
        }
        add_row(w, h, invcali_dot3(b, y), weight);
    }
}

/* Adds a move. Its residual is the rotation from a to up0: 3 / (2 + cos) times the sine is the
 * angle up to its fifth power. Its variance is 2 sigma_a^2 + N^2 T + (N^2 / (2 s) + (1.5 B)^2) T^2:
 * the directions of up in both rests, the random walk of the angle, the bias of rests of 1 s. */
static void add_move(invcali_imu_work *w, unsigned rest, const invcal_private_segment *segment,
                     const invcal_real up[2][3])
{
    const invcal_private_still *at = &w->imu->own.rest[rest];
    const invcal_real density = w->rate_noise * w->rate_noise;
    const invcal_real wander = INVCAL_REAL(2.25) * w->instability * w->instability;
    invcali_replay r;
    invcal_real bias[3];
    invcal_real a[3];
    invcal_real y[3];

    for (unsigned i = 0; i < 3; i++) {
        bias[i] = (w->bias[rest - 1][i] + w->bias[rest][i]) / 2;
    }
    invcali_replay_move(w, segment, (unsigned)at->move, bias, up, &r);
    if (r.angle < NO_ANGLE && invcali_dot3(up[0], up[1]) > SAME_UP) {
        w->idle |= (uint32_t)1 << rest;
        return;
    }
    for (unsigned i = 0; i < 3; i++) {
        a[i] = invcali_dot3(r.c[i], up[1]);
    }
    invcali_cross(a, up[0], y);
    scale_by(y, 3 / (2 + invcali_dot3(a, up[0])));
    const invcal_real time_square = r.time * r.time;
    const invcal_real variance =
        2 * w->noise_square + density * (r.time + time_square / 2) + wander * time_square;
    const invcal_real square = invcali_dot3(y, y);
    add_angles(w, &r, a, up, y, 1 / (variance * w->variance[INVCAL_OF_MOVES]));
    w->pass.squares[INVCAL_OF_MOVES] += square / variance;
    w->pass.kind[INVCAL_OF_MOVES] += 2;
    w->pass.variances += 2 * variance;
    w->pass.residuals += square;
    if (!(square / variance <= w->pass.worst_square)) {
        w->pass.worst_square = square / variance;
        w->pass.worst_residual = square;
        w->out->worst = (uint8_t)rest;
    }
}

/* Adds a row per parameter: its nominal value, with the standard deviation of the prior. */
static void add_prior(invcali_imu_work *w)
{
    invcal_real h[IMU_ALL + 1];

    for (unsigned i = 0; w->prior && i < w->n; i++) {
        const invcal_real sigma = w->prior[invcali_imu_parameter(i)];
        const invcal_real weight = sigma > 0 ? 1 / (sigma * sigma) : 0;
        if (weight > 0) { /* not if infinite, either */
            const invcal_real ideal = i < IMU_GYRO && i % 4 == 0 ? 1 : 0;
            invcali_zero(h, sizeof h);
            h[i] = 1;
            add_row(w, h, ideal - w->parameter[i], weight);
            w->pass.rows++;
        }
    }
}

invcal_status invcali_imu_sum(invcali_imu_work *w)
{
    const invcal_private_moves *m = &w->imu->own;
    const invcal_vector *mean = w->mean;
    unsigned first = 0;
    invcal_real up[2][3];

    invcali_zero(&w->pass, sizeof w->pass);
    w->idle = 0;
    //@ loop unroll INVCAL_MAX_MOVES;
    for (unsigned i = 0; i < w->imu->rests; i++) {
        const unsigned segments = m->rest[i].move > 0 ? (unsigned)m->rest[i].move : 0;
        if (i >= w->begin) {
            invcali_correct(&w->out->accelerometer, mean->v, up[1]);
            const invcal_real length = INVCAL_SQRT(invcali_dot3(up[1], up[1]));
            scale_by(up[1], 1 / length);
            if (!(length >= INVCAL_REAL(0.1) && length <= 10)) {
                return INVCAL_OUT_OF_RANGE;
            }
            if (w->n == IMU_ALL) {
                add_rest(w, up[1], length - 1);
            }
            if (i > w->begin && segments > 0 && (w->left_out >> i & 1u) == 0) {
                /* the segments of all moves are in the table */
                //@ assert first < INVCAL_MAX_SEGMENTS;
                add_move(w, i, &m->segment[first], (const invcal_real(*)[3])up);
            }
            memcpy(up[0], up[1], sizeof up[0]);
            mean++;
        }
        first += segments;
    }
    w->pass.rows = w->pass.kind[INVCAL_OF_RESTS] + w->pass.kind[INVCAL_OF_MOVES];
    add_prior(w);
    return INVCAL_OK;
}

/* ---- solution -------------------------------------------------------------------------------- */

invcal_status invcali_imu_settings_check(const invcal_imu_settings *s, invcal_real noise)
{
    if (!(noise >= 0 && s->rate_noise >= 0 && s->instability >= 0 &&
          noise + s->rate_noise + s->instability < 1)) {
        return INVCAL_BAD_NOISE;
    }
    for (unsigned i = 0; s->prior && i < IMU_ALL; i++) {
        if (!(s->prior[i] >= 0)) {
            return INVCAL_BAD_PRIOR;
        }
    }
    return INVCAL_OK;
}

invcal_positions invcali_imu_positions(const invcal_imu *imu)
{
    const invcal_session *s = &imu->session;
    const invcal_positions positions = {s->mean, s->count, &s->nominal, s->noise, NULL};

    return positions;
}

invcal_status invcali_imu_begin(invcali_imu_work *w, const invcal_imu *imu,
                                const invcal_positions *positions,
                                const invcal_imu_settings *settings, invcal_imu_result *out)
{
    static const invcal_imu_settings unknown = {0, 0, 0, NULL};
    const invcal_imu_settings *s = settings ? settings : &unknown;
    const unsigned count = positions->count;
    const unsigned both = count < imu->rests ? count : imu->rests;
    const invcal_real noise = positions->noise > 0 ? positions->noise : INVCAL_IMU_MEAN_NOISE;

    invcali_zero(w, sizeof *w);
    invcali_zero(out, sizeof *out);
    w->imu = imu;
    w->out = out;
    w->prior = s->prior;
    w->is_stated = settings != NULL;
    w->has_noise = positions->noise > 0;
    w->noise_square = noise * noise;
    w->rate_noise = s->rate_noise > 0 ? s->rate_noise : INVCAL_IMU_RATE_NOISE;
    w->instability = s->instability > 0 ? s->instability : INVCAL_IMU_INSTABILITY;
    invcali_copy(&out->accelerometer, positions->nominal, sizeof out->accelerometer);
    for (unsigned i = 0; i < IMU_GYRO; i += 4) {
        w->parameter[i] = 1;
    }
    w->n = s->held ? IMU_GYRO : IMU_ALL;
    w->begin = imu->rests - both;
    w->mean = &positions->mean[count - both];
    w->variance[INVCAL_OF_RESTS] = 1;
    w->variance[INVCAL_OF_MOVES] = 1;
    for (unsigned i = 0; i < imu->rests; i++) {
        invcali_unpack(imu->own.rest[i].bias, INVCAL_KAPPA_UNIT, w->bias[i]);
    }
    const invcal_status status = invcali_imu_settings_check(s, positions->noise);
    return status == INVCAL_OK ? invcali_nominal_check(positions->nominal) : status;
}

/* The unknowns of the accelerometer refer to the readings as calibrated so far, so A = (I + S)^-1
 * is multiplied from the left; to first order, since another step follows. */
static invcal_status take_step(invcali_imu_work *w, invcal_real *size)
{
    const invcal_real *p = &w->pass.sum[INVCAL_PACKED(w->n, 0)];
    invcal_calibration before;

    for (unsigned i = 0; i < w->n; i++) {
        w->parameter[i] += p[i];
    }
    *size = invcali_dot(p, p, w->n);
    if (w->n == IMU_GYRO) {
        return INVCAL_OK;
    }
    before = w->out->accelerometer;
    p += IMU_GYRO;
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            w->out->accelerometer.matrix[i][j] =
                i == j ? 1 - p[INVCAL_DK_X + i] : -p[INVCAL_GAMMA_XY + i + j - 1] / 2;
        }
        w->out->accelerometer.offset[i] = p[i];
    }
    return invcali_compose(&before, &w->out->accelerometer);
}

/* Estimates the variance of each kind from its residuals: (4 + squares) / (4 + dof). The expected
 * variance counts as some more of them. Unknowns are shared out to the kinds by their rows. */
static void weigh_kinds(invcali_imu_work *w)
{
    for (unsigned k = 0; k < INVCAL_KINDS; k++) {
        const invcal_real stated =
            k == INVCAL_OF_MOVES || w->has_noise ? STATED_ROWS : UNSTATED_ROWS;
        const invcal_real dof =
            invcali_number(w->pass.kind[k] * (w->pass.rows - w->n)) / invcali_number(w->pass.rows);
        if (dof + stated >= 1) {
            w->variance[k] = (stated + w->pass.squares[k]) / (stated + dof);
        }
    }
}

/* Leaves out a move that is far from the others, or else updates the variances. It does so more
 * than once, since wrong weights of one kind disturb the residuals of the other; a step comes
 * between. Returns 0 if there is nothing to change. */
static int adapt(invcali_imu_work *w)
{
    const unsigned moves = w->pass.kind[INVCAL_OF_MOVES] / 2;
    const invcal_real others = w->pass.squares[INVCAL_OF_MOVES] - w->pass.worst_square;

    w->is_adapted = !w->is_adapted && w->passes >= SETTLED && w->passes < PASSES - 3 + 2 * w->apart;
    if (!w->is_adapted) {
        return 0;
    }
    if (moves > LEAST_MOVES && w->apart < MOST_APART &&
        w->pass.worst_square * invcali_number(moves - 1) > FAR_APART * others) {
        w->left_out |= (uint32_t)1 << w->out->worst;
        w->apart++;
    } else {
        weigh_kinds(w);
    }
    return 1;
}

/* A Gauss-Newton pass: sums all equations, then takes a step unless the equations change first.
 * Biases are fitted after the first step: their rows need up, and so a calibrated accelerometer. */
static invcal_status make_pass(invcali_imu_work *w, invcal_real *size)
{
    if (w->passes == 1) {
        find_bias(w);
    }
    invcal_status status = invcali_imu_sum(w);
    if (status == INVCAL_OK && (w->pass.kind[INVCAL_OF_MOVES] == 0 || w->pass.rows < w->n)) {
        status = INVCAL_TOO_FEW;
    }
    if (status != INVCAL_OK || adapt(w)) {
        return status;
    }
    status = invcali_factor(w->pass.sum, w->n, w->n + 1, INVCAL_FLOOR);
    if (status == INVCAL_OK) {
        invcali_back_substitute(w->pass.sum, w->n);
        status = take_step(w, size);
    }
    return status;
}

/* No error of the sensors explains residuals of 0.1 rad: the two do not turn alike. Where there is
 * too little information, steps never become small. */
static invcal_status iterate(invcali_imu_work *w)
{
    unsigned most = PASSES;
    invcal_real size = 1;

    while (w->passes < most + 2 * w->apart) { /* at most 16 */
        const invcal_status status = make_pass(w, &size);
        if (status != INVCAL_OK) { /* after the first pass it means divergence */
            return w->passes > 0 ? INVCAL_MOUNTING : status;
        }
        if (size < STEP) {
            most = LEAST_PASSES;
        }
        w->passes++;
    }
    w->pass.residuals /= invcali_number(w->pass.kind[INVCAL_OF_MOVES]);
    if (!(w->pass.residuals < ABSURD_TURN)) {
        return INVCAL_MOUNTING;
    }
    /* most was lowered if a step was small enough */
    return most < PASSES ? INVCAL_OK : INVCAL_UNDETERMINED;
}

/* Computes sigma. Parameters whose K exceeds `most` are open. Returns the largest K. */
static invcal_real judge_imu(invcali_imu_work *w, invcal_real most)
{
    invcal_real largest = 0;

    invcali_invert(w->pass.sum, w->n);
    for (unsigned i = 0; i < w->n; i++) {
        const invcal_real k = invcali_variance(w->pass.sum, w->n, i);
        const unsigned parameter = invcali_imu_parameter(i);
        w->out->sigma[parameter] = INVCAL_SQRT(k);
        if (!(k <= most)) {
            w->out->weak |= (uint32_t)1 << parameter;
        }
        largest = k <= largest ? largest : k;
    }
    return largest;
}

/* Finds the open parameters: those that only a small ridge determines. */
static void name_open(invcali_imu_work *w)
{
    (void)invcali_imu_sum(w); /* it succeeded before */
    const invcal_real ridge = IMU_RIDGE * invcali_trace(w->pass.sum, w->n);
    for (unsigned i = 0; i < w->n; i++) {
        w->pass.sum[INVCAL_PACKED(i, i)] += ridge;
    }
    (void)invcali_factor(w->pass.sum, w->n, w->n, 0);
    (void)judge_imu(w, HELD_BY_RIDGE / ridge);
}

/* The offset is the bias of the last rest, without the effect of acceleration if the moves were
 * corrected. */
static void deliver(invcali_imu_work *w)
{
    invcal_imu_result *out = w->out;
    const invcal_private_moves *m = &w->imu->own;
    const invcal_real *last = w->bias[w->imu->rests - 1u];

    for (unsigned i = 0; i < 3; i++) {
        out->gyro.offset[i] = m->bias[i] + last[i] - (out->g_is_used ? w->g_bias[i] : 0);
    }
    memcpy(out->gyro.matrix, w->parameter, sizeof out->gyro.matrix);
    (void)invcali_compose(&w->imu->nominal, &out->gyro);
    out->move_rms = INVCAL_SQRT(w->pass.residuals);
    out->move_max = INVCAL_SQRT(w->pass.worst_residual);
    out->moves = (uint8_t)(w->pass.kind[INVCAL_OF_MOVES] / 2);
    out->dof = (uint16_t)(w->pass.rows - w->n);
    if (out->weak != 0) {
        out->verdict = INVCAL_WEAK;
    } else if (w->is_stated && (w->variance[INVCAL_OF_MOVES] > ROUGH_VARIANCE ||
                                (w->has_noise && w->variance[INVCAL_OF_RESTS] > ROUGH_VARIANCE))) {
        out->verdict = INVCAL_ROUGH;
    } else if (out->dof == 0) {
        out->verdict = INVCAL_NO_REDUNDANCY;
    } /* cppcheck-suppress misra-c2012-15.7 ; good */
}

static invcal_status conclude(invcali_imu_work *w)
{
    invcal_imu_result *out = w->out;
    const invcal_real of_moves = w->variance[INVCAL_OF_MOVES] * w->pass.variances /
                                 invcali_number(w->pass.kind[INVCAL_OF_MOVES]);
    const invcal_real of_rests = w->variance[INVCAL_OF_RESTS] * w->noise_square;
    /* a parameter may be known from rests, from moves, or from both */
    const invcal_real of_either = of_moves > of_rests ? of_moves : of_rests;

    if (!(judge_imu(w, WEAK_SQUARE * of_either) <= OPEN_SQUARE * of_either)) {
        return INVCAL_UNDETERMINED;
    }
    out->noise = INVCAL_SQRT(of_rests);
    out->move_noise = INVCAL_SQRT(of_moves);
    deliver(w);
    return INVCAL_OK;
}

invcal_status invcali_imu_solve_of(const invcal_imu *imu, const invcal_positions *positions,
                                   const invcal_imu_settings *settings, invcal_imu_result *out)
{
    invcali_imu_work w;

    invcal_status status = invcali_imu_begin(&w, imu, positions, settings, out);
    if (status == INVCAL_OK) {
        status = iterate(&w);
        if (status == INVCAL_UNDETERMINED) {
            name_open(&w);
        } else if (status == INVCAL_OK) {
            status = conclude(&w);
        } /* cppcheck-suppress misra-c2012-15.7 ; there is nothing to add */
    }
    out->left_out = w.left_out;
    out->idle = w.idle;
    return status;
}

invcal_status invcal_imu_solve(const invcal_imu *imu, const invcal_imu_settings *settings,
                               invcal_imu_result *out)
{
    INVCAL_ASSERT(imu && out);
    if (imu->own.layout != INVCAL_MOVES_LAYOUT) { /* so was the session, then */
        return INVCAL_NOT_BEGUN;
    }
    const invcal_positions positions = invcali_imu_positions(imu);
    return invcali_imu_solve_of(imu, &positions, settings, out);
}
