/* SPDX-License-Identifier: MIT */
#include "imu.h"

#include <stddef.h>
#include <string.h>

#include "judge.h"
#include "rotation.h"
#include "solve.h"
#include "sums.h"

#define STEP (INVCAL_DOUBLE ? INVCAL_REAL(1e-9) : INVCAL_REAL(3e-6)) /* less is no step any more */
#define SQUARE_OF_5 INVCAL_REAL(25.0)
#define ABSURD_TURN INVCAL_REAL(0.01)    /* residuals of 0.1 rad, squared */
#define SAME_UP INVCAL_REAL(0.9962)      /* cosine of 5 degrees */
#define NO_ANGLE INVCAL_REAL(0.0076)     /* 5 degrees, squared */
#define WEAK_SQUARE INVCAL_REAL(6.25)    /* of sqrt(K) 2.5 */
#define OPEN_SQUARE INVCAL_REAL(1e6)     /* of 1000 */
#define SIGNIFICANT INVCAL_REAL(16.0)    /* 4 sigma, squared */
#define USUAL_NOISE INVCAL_REAL(3e-4)    /* of a mean that nothing is known of */
#define USUAL_DENSITY INVCAL_REAL(8.7e-5)
#define USUAL_INSTABILITY INVCAL_REAL(1e-4)
#define RIDGE INVCAL_REAL(1e-4)          /* of the trace: what is held by it is open */

enum {
    ALL = INVCAL_IMU_PARAMETERS,
    GYRO = INVCAL_GYRO_PARAMETERS,
    PASSES = 6,
    SETTLED = 2,    /* passes after which residuals are those of noise */
    MOST_APART = 3, /* moves left out */
    LEAST_MOVES = 6,
    BIAS = 5,         /* unknowns of a bias: constant, three of up, time */
    LEAST_RESTS = 12, /* for them */
    SERIES_OF_TURN = INVCAL_DOUBLE ? 9 : 5
};

/* ---- a move ------------------------------------------------------------------------------------- */

void invcal_cross(const invcal_real a[3], const invcal_real b[3], invcal_real out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = i < 2 ? i + 1 : 0;
        const unsigned k = 3 - i - j;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* out = C' a */
static void turn_back(const invcal_real c[3][3], const invcal_real a[3], invcal_real out[3])
{
    for (unsigned i = 0; i < 3; i++) {
        out[i] = c[0][i] * a[0] + c[1][i] * a[1] + c[2][i] * a[2];
    }
}

/* By the matrix I + E: S += C J v', C <- C exp([th x]), J the left Jacobian of th. By rows, c [th x] being
 * c x th. The series are those of (1 - cos x)/x^2 and (x - sin x)/x^3. */
static void turn_segment(invcal_replay *r, const invcal_real v[3], const invcal_real th[3])
{
    const invcal_real x = invcal_dot3(th, th);
    invcal_real k = 1;
    invcal_real l = 1;

    for (unsigned n = SERIES_OF_TURN; n > 0; n--) {
        const invcal_real m = invcal_number(2 * n + 1);
        k = 1 - k * x / (m * (m + 1));
        l = 1 - l * x / ((m + 1) * (m + 2));
    }
    k /= 2;
    l /= 6;
    for (unsigned i = 0; i < 3; i++) {
        invcal_real a[3];
        invcal_real b[3];
        invcal_real *c = r->c[i];
        invcal_cross(c, th, a);
        invcal_cross(a, th, b);
        for (unsigned j = 0; j < 3; j++) {
            const invcal_real p = c[j] + k * a[j] + l * b[j];
            c[j] += (1 - x * l) * a[j] + k * b[j];
            for (unsigned n = 0; n < 3; n++) {
                r->s[i][3 * j + n] += p * v[n];
            }
        }
    }
}

/* The bias of a segment beyond that of the move is G times what is up in its middle. */
void invcal_replay_move(const invcal_imu_work *w, const invcal_segment *segment, unsigned count,
                        const invcal_real bias[3], const invcal_real up[3], invcal_replay *r)
{
    invcal_real m[3][3];
    invcal_real cofactors[3][3];

    invcal_zero(r, sizeof *r);
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            m[i][j] = w->x[3 * i + j];
        }
        m[i][i] += 1;
        r->c[i][i] = 1;
    }
    (void)invcal_cofactors((const invcal_real(*)[3])m, cofactors);
    for (; count > 0; count--) {
        const invcal_real time = invcal_number(segment->time / 2u) / w->moves->rate;
        invcal_real v[3];
        invcal_real kappa[3];
        invcal_real f[3];
        invcal_real th[3];
        for (unsigned i = 0; i < 3; i++) {
            v[i] = (invcal_real)segment->v[i] / INVCAL_V_UNIT;
            kappa[i] = (invcal_real)segment->kappa[i] / INVCAL_KAPPA_UNIT;
        }
        turn_back((const invcal_real(*)[3])r->c, up, f);
        invcal_cross(f, v, th); /* on the way: half of it */
        for (unsigned i = 0; i < 3; i++) {
            f[i] += th[i] / 2;
        }
        for (unsigned i = 0; i < 3; i++) {
            v[i] -= time * (bias[i] + invcal_dot3(w->g[i], f));
        }
        for (unsigned i = 0; i < 3; i++) {
            th[i] = invcal_dot3(m[i], v) + invcal_dot3(cofactors[i], kappa);
        }
        turn_segment(r, v, th);
        r->angle += invcal_dot3(th, th);
        r->time += time;
        segment++;
    }
}

/* ---- equations ---------------------------------------------------------------------------------- */

/* Length 1; returns what it was. */
static invcal_real normalise(invcal_real v[3])
{
    const invcal_real length = INVCAL_SQRT(invcal_dot3(v, v));

    for (unsigned i = 0; i < 3; i++) {
        v[i] /= length;
    }
    return length;
}

static void add_row(invcal_imu_work *w, invcal_real h[ALL + 1], invcal_real y, invcal_real weight)
{
    h[w->n] = -y;
    invcal_rank_one(w->sum, h, w->n + 1, weight);
}

/* The length of a rest. */
static void add_rest(invcal_imu_work *w, const invcal_real up[3], invcal_real excess)
{
    invcal_real h[ALL + 1];

    invcal_zero(h, sizeof h);
    memcpy(&h[GYRO], up, 3 * sizeof *up);
    invcal_products(up, &h[GYRO]);
    add_row(w, h, excess, 1 / w->rests.variance);
    w->rests.squares += excess * excess / w->rests.variance;
    w->rests.rows++;
}

/* The two angles across the way up of a move: with b across it, b'y = b'S de + (g1 D(u1) + g0 D(u0)) dp,
 * g1 = C'(u0 x b), g0 = b x a. */
static void add_angles(invcal_imu_work *w, const invcal_replay *r, const invcal_real a[3],
                       const invcal_real up[2][3], const invcal_real y[3], invcal_real weight)
{
    const invcal_real(*c)[3] = (const invcal_real(*)[3])r->c;
    invcal_real h[ALL + 1 + INVCAL_PARAMETERS];
    invcal_real *g0 = &h[ALL + 1];
    invcal_real b[2][3] = {{0, 0, 0}, {0, 0, 0}};
    unsigned least = 0;

    for (unsigned i = 1; i < 3; i++) {
        least = INVCAL_FABS(up[0][i]) < INVCAL_FABS(up[0][least]) ? i : least;
    }
    b[1][least] = 1;
    invcal_cross(up[0], b[1], b[0]);
    (void)normalise(b[0]);
    invcal_cross(up[0], b[0], b[1]);
    for (unsigned k = 0; k < 2; k++) {
        for (unsigned i = 0; i < GYRO; i++) {
            h[i] = b[k][0] * r->s[0][i] + b[k][1] * r->s[1][i] + b[k][2] * r->s[2][i];
        }
        invcal_cross(up[0], b[k], g0);
        turn_back(c, g0, &h[GYRO]);
        invcal_products(up[1], &h[GYRO]);
        invcal_cross(b[k], a, g0);
        invcal_products(up[0], g0);
        for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
            h[GYRO + i] += g0[i];
        }
        add_row(w, h, invcal_dot3(b[k], y), weight);
    }
}

/* Bias of a rest beyond that of the first, rad/s. */
static invcal_real bias_of(const invcal_moves *m, unsigned rest, unsigned axis)
{
    return (invcal_real)m->rest[rest][axis] / INVCAL_KAPPA_UNIT;
}

/* What turns a into up0: 3 / (2 + cos) times the sine is the angle to its fifth power. */
static void add_move(invcal_imu_work *w, unsigned rest, const invcal_segment *segment,
                     const invcal_real up[2][3])
{
    const invcal_moves *m = w->moves;
    invcal_replay r;
    invcal_real bias[3];
    invcal_real a[3];
    invcal_real y[3];

    for (unsigned i = 0; i < 3; i++) {
        a[i] = (up[0][i] + up[1][i]) / 2;
    }
    for (unsigned i = 0; i < 3; i++) {
        bias[i] = (bias_of(m, rest - 1, i) + bias_of(m, rest, i)) / 2 - invcal_dot3(w->g[i], a);
    }
    invcal_replay_move(w, segment, (unsigned)m->move[rest], bias, up[0], &r);
    if (r.angle < NO_ANGLE && invcal_dot3(up[0], up[1]) > SAME_UP) {
        w->idle |= (uint32_t)1 << rest;
        return;
    }
    for (unsigned i = 0; i < 3; i++) {
        a[i] = invcal_dot3(r.c[i], up[1]);
    }
    invcal_cross(a, up[0], y);
    const invcal_real f = 3 / (2 + invcal_dot3(a, up[0]));
    for (unsigned i = 0; i < 3; i++) {
        y[i] *= f;
    }
    const invcal_real density = w->settings->rate_noise * w->settings->rate_noise;
    const invcal_real drift = INVCAL_REAL(1.5) * w->settings->instability;
    const invcal_real variance =
        w->moved.variance * (2 * w->settings->noise * w->settings->noise +
                             r.time * (density + r.time * (density / 2 + drift * drift)));
    const invcal_real square = invcal_dot3(y, y);
    add_angles(w, &r, a, up, y, 1 / variance);
    w->moved.squares += square / variance;
    w->moved.rows += 2;
    w->variances += variance;
    w->residuals += square;
    if (!(square / variance <= w->worst_square)) {
        w->worst_square = square / variance;
        w->worst_residual = square;
        w->worst = rest;
    }
}

/* p is 0 with the standard deviation of the prior. */
static void add_prior(invcal_imu_work *w)
{
    for (unsigned i = 0; i < w->n; i++) {
        const invcal_real sigma = w->settings->prior[i];
        if (sigma > 0) {
            const invcal_real weight = 1 / (sigma * sigma);
            w->sum[INVCAL_PACKED(i, i)] += weight;
            w->sum[INVCAL_PACKED(w->n, i)] += weight * w->x[i];
            w->priors++;
        }
    }
}

invcal_status invcal_imu_sum(invcal_imu_work *w)
{
    const invcal_moves *m = w->moves;
    const invcal_segment *segment = m->segment;
    invcal_real up[2][3];

    invcal_zero(w->sum, sizeof w->sum);
    w->rests.squares = w->moved.squares = w->variances = w->residuals = 0;
    w->rests.rows = w->moved.rows = w->priors = 0;
    w->idle = 0;
    w->worst_square = -1;
    for (unsigned i = 0; i < m->count; i++) {
        const unsigned segments = m->move[i] > 0 ? (unsigned)m->move[i] : 0;
        if (i >= w->begin) {
            invcal_apply(&w->accelerometer, &w->raw[3 * (size_t)(i - w->begin)], up[1]);
            const invcal_real length = normalise(up[1]);
            if (!(length >= INVCAL_REAL(0.1) && length <= 10)) {
                return length <= INVCAL_REAL_MAX ? INVCAL_OUT_OF_RANGE : INVCAL_NOT_FINITE;
            }
            if (w->n == ALL) {
                add_rest(w, up[1], length - 1);
            }
            if (i > w->begin && segments > 0 && (w->left_out >> i & 1u) == 0) {
                add_move(w, i, segment, (const invcal_real(*)[3])up);
            }
            memcpy(up[0], up[1], sizeof up[0]);
        }
        segment += segments;
    }
    add_prior(w);
    return INVCAL_OK;
}

/* ---- bias --------------------------------------------------------------------------------------- */

/* b = b0 + G up + drift t over all rests, axis by axis. */
static void find_bias(invcal_imu_work *w, invcal_imu *out)
{
    const invcal_moves *m = w->moves;
    const unsigned count = m->count - w->begin;
    const invcal_real freedom = invcal_number(count) - BIAS;
    const invcal_real span = invcal_number(m->when[m->count - 1] - m->when[w->begin]);
    invcal_real a[INVCAL_PACKED_SIZE(BIAS + 1)];
    invcal_real h[BIAS + 1];

    if (count < LEAST_RESTS) {
        return;
    }
    for (unsigned axis = 0; axis < 3; axis++) {
        invcal_zero(a, sizeof a);
        for (unsigned i = w->begin; i < m->count; i++) {
            invcal_apply(&w->accelerometer, &w->raw[3 * (size_t)(i - w->begin)], h);
            h[3] = invcal_number(m->when[i] - m->when[w->begin]) / span;
            h[4] = 1;
            h[BIAS] = -bias_of(m, i, axis);
            invcal_rank_one(a, h, BIAS + 1, 1);
        }
        if (invcal_factor(a, BIAS, BIAS + 1, INVCAL_FLOOR) != INVCAL_OK) {
            return;
        }
        invcal_back_substitute(a, BIAS);
        const invcal_real *p = &a[INVCAL_PACKED(BIAS, 0)];
        const invcal_real variance = p[BIAS] > 0 ? p[BIAS] / freedom : 0;
        invcal_invert(a, BIAS);
        for (unsigned i = 0; i < 4; i++) {
            const invcal_real square = variance * invcal_variance(a, BIAS, i);
            invcal_real *value = i < 3 ? &out->g_sensitivity[axis][i] : &out->drift[axis];
            *(i < 3 ? &out->g_sigma[axis][i] : &out->drift_sigma[axis]) = INVCAL_SQRT(square);
            *value = p[i];
            out->g_is_used |= i < 3 && p[i] * p[i] > SIGNIFICANT * square;
        }
    }
    if (out->g_is_used) {
        memcpy(w->g, out->g_sensitivity, sizeof w->g);
    }
}

/* ---- solution ----------------------------------------------------------------------------------- */

static invcal_status check(const invcal_imu_settings *s, const invcal_calibration *accelerometer)
{
    for (unsigned i = 0; i < ALL; i++) {
        if (!(s->prior[i] >= 0 && s->prior[i] <= INVCAL_REAL_MAX)) {
            return INVCAL_BAD_PRIOR;
        }
    }
    return s->noise < 1 && invcal_is_positive(s->noise) && invcal_is_positive(s->rate_noise) &&
                   invcal_is_positive(s->instability)
               ? invcal_nominal_check(accelerometer)
               : INVCAL_BAD_NOISE;
}

invcal_status invcal_imu_begin(invcal_imu_work *w, const invcal_real *raw, unsigned count,
                               const invcal_calibration *accelerometer, const invcal_moves *moves,
                               const invcal_imu_settings *settings)
{
    invcal_zero(w, sizeof *w);
    if (settings) {
        w->given = *settings;
    }
    invcal_imu_settings *s = &w->given;
    s->noise = s->noise == 0 ? USUAL_NOISE : s->noise;
    s->rate_noise = s->rate_noise == 0 ? USUAL_DENSITY : s->rate_noise;
    s->instability = s->instability == 0 ? USUAL_INSTABILITY : s->instability;
    w->settings = s;
    w->n = s->held ? GYRO : ALL;
    w->moves = moves;
    w->accelerometer = *accelerometer;
    const unsigned both = count < moves->count ? count : moves->count;
    w->begin = moves->count - both;
    w->raw = raw + 3 * (size_t)(count - both);
    w->rests.variance = s->noise * s->noise;
    w->moved.variance = 1;
    return check(s, accelerometer);
}

/* Which of the 18 a small ridge holds. */
static uint32_t name_open(invcal_imu_work *w)
{
    uint32_t open = 0;

    (void)invcal_imu_sum(w); /* it was accepted before */
    const invcal_real ridge = RIDGE * invcal_trace(w->sum, w->n) / invcal_number(w->n);
    for (unsigned i = 0; i < w->n; i++) {
        w->sum[INVCAL_PACKED(i, i)] += ridge;
    }
    (void)invcal_factor(w->sum, w->n, w->n, 0);
    invcal_invert(w->sum, w->n);
    for (unsigned i = 0; i < w->n; i++) {
        const int is_held = ridge * invcal_variance(w->sum, w->n, i) <= INVCAL_REAL(0.1);
        open |= (is_held ? (uint32_t)0 : 1) << i;
    }
    return open;
}

/* The unknowns of the accelerometer are those of what it calibrates by now. */
static invcal_status step(invcal_imu_work *w, invcal_real *size)
{
    const invcal_real *p = &w->sum[INVCAL_PACKED(w->n, 0)];
    invcal_calibration triad;

    *size = 0;
    for (unsigned i = 0; i < w->n; i++) {
        w->x[i] += p[i];
        *size += p[i] * p[i];
    }
    if (w->n == GYRO) {
        return INVCAL_OK;
    }
    const invcal_status status = invcal_triad(&p[GYRO], &triad);
    if (status != INVCAL_OK) {
        return status;
    }
    const invcal_calibration before = w->accelerometer;
    w->accelerometer = triad;
    return invcal_behind(&before, &w->accelerometer);
}

/* What the residuals of a kind make of its variance. */
static void weigh(invcal_imu_rows *rows, invcal_real stated, invcal_real share, invcal_quality *q)
{
    const invcal_real dof = share * invcal_number(rows->rows);

    q->dof = invcal_whole(dof);
    invcal_weigh_noise(stated, rows->squares, q);
    if (q->sigma_dof > 0) {
        rows->variance *= q->noise * q->noise;
    }
}

/* From now on with the noise that residuals show, and without a move that is far from the others. */
static int adapt(invcal_imu_work *w, invcal_quality *q)
{
    const unsigned rows = w->rests.rows + w->moved.rows;
    const unsigned moves = w->moved.rows / 2;
    const invcal_real others = w->moved.squares - w->worst_square;

    if (moves > LEAST_MOVES && w->apart < MOST_APART &&
        w->worst_square * invcal_number(moves - 1) > SQUARE_OF_5 * others) {
        w->left_out |= (uint32_t)1 << w->worst;
        w->apart++;
        return 1;
    }
    if (!w->is_weighed && rows + w->priors > w->n) {
        const invcal_real share =
            invcal_number(rows + w->priors - w->n) / invcal_number(rows + w->priors);
        weigh(&w->rests, w->is_stated ? 1 : 0, share, q);
        weigh(&w->moved, 1, share, q);
    }
    w->is_weighed = 1;
    return 0;
}

static invcal_status iterate(invcal_imu_work *w, invcal_quality *q, invcal_imu *out)
{
    invcal_real size = 1;

    for (unsigned pass = 0; pass < PASSES; pass++) {
        if (pass == 1) {
            find_bias(w, out);
        }
        invcal_status status = invcal_imu_sum(w);
        if (status != INVCAL_OK) {
            return status;
        }
        if (w->moved.rows == 0 || w->rests.rows + w->moved.rows + w->priors < w->n) {
            return INVCAL_TOO_FEW;
        }
        out->passes = (uint8_t)(pass + 1);
        const int was_weighed = w->is_weighed;
        const int is_disturbed = pass >= SETTLED && adapt(w, q);
        out->condition = invcal_trace(w->sum, w->n);
        if (invcal_factor(w->sum, w->n, w->n + 1, INVCAL_FLOOR) != INVCAL_OK) {
            out->open = name_open(w);
            return INVCAL_UNDETERMINED;
        }
        invcal_back_substitute(w->sum, w->n);
        status = step(w, &size);
        if (status != INVCAL_OK) {
            return status;
        }
        if (was_weighed && !is_disturbed && size < STEP * STEP) {
            break;
        }
    }
    /* after all passes a step of a tenth of a milliradian is no end */
    return w->residuals < ABSURD_TURN * invcal_number(w->moved.rows) && size < INVCAL_REAL(1e-8)
               ? INVCAL_OK
               : INVCAL_MOUNTING;
}

/* sigma, and what is weak beside a row of its kind. */
static invcal_status judge(invcal_imu_work *w, invcal_quality *q, invcal_imu *out)
{
    const invcal_real of_moves = w->variances * 2 / invcal_number(w->moved.rows);
    invcal_status status = INVCAL_OK;

    invcal_invert(w->sum, w->n);
    out->condition = invcal_condition(w->sum, w->n, out->condition);
    for (unsigned i = 0; i < w->n; i++) {
        const invcal_real k = invcal_variance(w->sum, w->n, i);
        const invcal_real unit = i < GYRO ? of_moves : w->rests.variance;
        out->sigma[i] = INVCAL_SQRT(k);
        if (!(k <= WEAK_SQUARE * unit)) {
            out->open |= (uint32_t)1 << i;
            invcal_raise(q, INVCAL_WEAK);
        }
        if (!(k <= OPEN_SQUARE * unit)) {
            status = INVCAL_UNDETERMINED;
        }
    }
    return status;
}

/* The symmetric frame of the accelerometer: both are turned by what steps have turned it. */
static void deliver(invcal_imu_work *w, invcal_imu *out)
{
    const invcal_moves *m = w->moves;
    const invcal_real count = invcal_number(m->count - w->begin);

    for (unsigned i = 0; i < 3; i++) {
        invcal_real sum = 0;
        for (unsigned k = w->begin; k < m->count; k++) {
            sum += bias_of(m, k, i);
        }
        out->gyro.offset[i] = m->bias[i] * m->rate + sum / count;
        for (unsigned j = 0; j < 3; j++) {
            out->gyro.matrix[i][j] = w->x[3 * i + j];
        }
        out->gyro.matrix[i][i] += 1;
    }
    out->accelerometer = w->accelerometer;
    memcpy(out->parameter, w->x, sizeof out->parameter);
}

invcal_status invcal_imu_solve(const invcal_real *raw, unsigned count,
                               const invcal_calibration *accelerometer, const invcal_moves *moves,
                               const invcal_imu_settings *settings, invcal_imu *out)
{
    invcal_imu_work w;
    invcal_quality q;

    INVCAL_ASSERT((raw || count == 0) && accelerometer && moves && out);
    invcal_zero(out, sizeof *out);
    invcal_judge_begin(&q);
    invcal_status status = invcal_imu_begin(&w, raw, count, accelerometer, moves, settings);
    w.is_stated = settings && settings->noise > 0;
    if (status == INVCAL_OK) {
        status = iterate(&w, &q, out);
    }
    out->left_out = w.left_out;
    out->idle = w.idle;
    if (status == INVCAL_OK) {
        status = judge(&w, &q, out);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    deliver(&w, out);
    const unsigned rows = w.rests.rows + w.moved.rows + w.priors;
    invcal_calibration nominal = moves->nominal;
    (void)invcal_scale(&nominal, moves->rate);
    (void)invcal_behind(&nominal, &out->gyro);
    out->dof = (uint16_t)(rows - w.n);
    invcal_raise(&q, out->dof > 0 ? INVCAL_GOOD : INVCAL_NO_REDUNDANCY);
    out->verdict = q.verdict;
    out->noise = INVCAL_SQRT(w.rests.variance);
    out->move_noise = INVCAL_SQRT(2 * w.variances / invcal_number(w.moved.rows));
    out->move_rms = INVCAL_SQRT(w.residuals / invcal_number(w.moved.rows));
    out->move_max = INVCAL_SQRT(w.worst_residual);
    out->worst = (uint8_t)w.worst;
    out->moves = (uint8_t)(w.moved.rows / 2);
    return INVCAL_OK;
}
