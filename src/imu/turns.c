/* SPDX-License-Identifier: MIT
 *
 * Plans turns of a gyroscope: what turns made or planned determine, and which one adds most
 * (mathematics_imu.md, "What a program determines"). Equations are those of imu.c. For a steady
 * turn about one axis the integral S has a closed form, so a turn can be judged before it is made.
 * All sums are over the variance of a position mean.
 */
#include <stddef.h>
#include <string.h>

#include "../core/circle.h"
#include "../plan/guidance.h"
#include "../core/sums.h"
#include "turns.h"
#include "../core/vector.h"

#define RADIANS INVCAL_REAL(0.017453292519943296) /* in a degree */
#define MOST_ANGLE INVCAL_REAL(12.57)             /* 720 degrees */
#define QUARTER INVCAL_REAL(1.5707963267948966)
#define USUAL_SECONDS INVCAL_REAL(1.5) /* of a turn */
#define VAGUE INVCAL_REAL(0.01) /* information of a parameter that is known to 10 times the noise */
#define HELD_BY_VAGUE INVCAL_REAL(0.1) /* open: VAGUE gives more than this share */
#define CLEARLY INVCAL_REAL(1.001)     /* if merits differ by less, the first turn wins */
#define NO_ARC INVCAL_REAL(0.09) /* sine squared: candidates are farther apart, and from opposite */
#define NO_SINE INVCAL_REAL(1e-6)     /* sine squared of the same or opposite directions */
#define WEAK_SQUARE INVCAL_REAL(6.25) /* of 2.5 */
#define OPEN_SQUARE INVCAL_REAL(1e6)  /* of 1000 */

enum {
    TURNS_ALL = INVCAL_IMU_PARAMETERS,
    TURNS_GYRO = INVCAL_GYRO_PARAMETERS,
    TURN_ROWS = 3, /* rows: two angles of a turn, the length of the rest after it */
    SIZE = INVCAL_PACKED_SIZE(TURNS_ALL)
};

/* The equations of a turn, each divided by its standard deviation. */
typedef struct {
    invcal_real h[TURN_ROWS][TURNS_ALL];
    unsigned rows;
    invcal_real up[3]; /* after it */
} turn_rows;

/* ---- directions and angles ------------------------------------------------------------------- */

static void scale(invcal_real v[3], invcal_real times)
{
    for (unsigned i = 0; i < 3; i++) {
        v[i] *= times;
    }
}

/* The angle, 0 to 180 degrees, by two corrections of a guess. The error of the guess has a small
 * sine x, and x + x^3/6 is the angle up to its fifth power: 19 degrees become 0.02, and these
 * become 0. */
static invcal_real degrees_of(invcal_real cosine, invcal_real sine)
{
    invcal_real degrees = 90 * (1 - cosine);

    for (unsigned pass = 0; pass < 2; pass++) {
        invcal_real c;
        invcal_real s;
        invcali_circle(degrees, &c, &s);
        const invcal_real x = sine * c - cosine * s;
        degrees += (x + x * x * x / 6) / RADIANS;
    }
    return degrees;
}

/* Returns the square of the sine. If it is below NO_SINE, or not a number, out is lost. */
static invcal_real turn_to(const invcal_real from[3], const invcal_real up[3], invcal_turn *out)
{
    invcali_cross(up, from, out->axis);
    const invcal_real square = invcali_dot3(out->axis, out->axis);

    if (square >= NO_SINE) {
        const invcal_real sine = INVCAL_SQRT(square);
        scale(out->axis, 1 / sine);
        out->angle = degrees_of(invcali_dot3(from, up), sine) * RADIANS;
        memcpy(out->up, up, sizeof out->up);
    }
    return square;
}

invcal_status invcali_turn_to(const invcal_real from[3], const invcal_real up[3], invcal_turn *out)
{
    invcal_turn turn;

    INVCAL_ASSERT(from && up && out);
    if (!invcali_is_unit(from) || !invcali_is_unit(up) || !(turn_to(from, up, &turn) >= NO_SINE)) {
        return INVCAL_BAD_DIRECTION;
    }
    *out = turn;
    return INVCAL_OK;
}

unsigned invcali_tour_face(unsigned i)
{
    /* faces: x up and down, y up and down, z up and down. Each of the twelve edges between them
     * once, and back; then full turns about x and y, and, after a quarter turn, about z */
    static const uint8_t tour[INVCAL_TOUR_FULL + 1] = {4, 0, 2, 4, 1, 2, 5, 0, 3,
                                                       5, 1, 3, 4, 4, 4, 2, 2};

    return tour[i];
}

invcal_status invcali_tour(unsigned i, invcal_turn *out)
{
    invcal_real from[3] = {0, 0, 0};

    INVCAL_ASSERT(out);
    if (i >= INVCAL_TOUR_FULL) {
        return INVCAL_BAD_ANGLE;
    }
    const unsigned was = invcali_tour_face(i);
    const unsigned is = invcali_tour_face(i + 1);
    invcali_zero(out, sizeof *out);
    from[was / 2] = was % 2 == 0 ? 1 : -1;
    out->up[is / 2] = is % 2 == 0 ? 1 : -1;
    out->angle = QUARTER;
    if (was != is) {
        invcali_cross(out->up, from, out->axis);
    } else {
        out->axis[(i + 1) / 2 % 3] = 1; /* 12: x; 13: y; 15: z */
        out->angle = 4 * QUARTER;
    }
    return INVCAL_OK;
}

/* ---- the information in a turn --------------------------------------------------------------- */

/* The variance of each of the two angles of a turn, over that of a position mean: as in add_move of
 * imu.c, with a time in proportion to the angle, but at least that of a quarter turn. */
static invcal_real variance_of(const invcali_turns *turns, invcal_real angle)
{
    const invcal_real quarters = INVCAL_FABS(angle) / QUARTER;
    const invcal_real time = quarters > 1 ? quarters * turns->seconds : turns->seconds;

    return 2 + time * (turns->linear + time * turns->square);
}

/* C' v, with C the rotation about n: cos v + (1 - cos) (n'v) n - sin n x v. */
static void rotate_back(const invcal_real n[3], invcal_real cosine, invcal_real sine,
                        const invcal_real v[3], invcal_real out[3])
{
    invcal_real across[3];
    const invcal_real along = (1 - cosine) * invcali_dot3(n, v);

    invcali_cross(n, v, across);
    for (unsigned i = 0; i < 3; i++) {
        out[i] = cosine * v[i] + along * n[i] - sine * across[i];
    }
}

/* Unit vectors perpendicular to up and to each other (Duff and others, 2017). */
static void find_across(const invcal_real up[3], invcal_real b[2][3])
{
    const invcal_real sign = up[2] < 0 ? -1 : 1;
    const invcal_real a = -1 / (sign + up[2]);
    const invcal_real c = up[0] * up[1] * a;

    b[0][0] = 1 + sign * up[0] * up[0] * a;
    b[0][1] = sign * c;
    b[0][2] = -sign * up[0];
    b[1][0] = c;
    b[1][1] = sign + up[1] * up[1] * a;
    b[1][2] = -up[1];
}

static void make_rest_row(invcal_real h[TURNS_ALL], const invcal_real up[3])
{
    invcali_zero(h, TURNS_GYRO * sizeof *h);
    memcpy(&h[TURNS_GYRO], up, 3 * sizeof *up);
    invcali_products(up, &h[TURNS_GYRO]);
}

/* The rows of imu.c for a turn exactly about one axis n: then S = J th n', with
 * J th = sin + (th - sin) n n' + (1 - cos) [n x]. */
INVCAL_NOINLINE static void make_turn_rows(const invcali_turns *turns, const invcal_turn *turn,
                                           turn_rows *out)
{
    const invcal_real *n = turn->axis;
    const invcal_real angle = turn->angle;
    const invcal_real root = 1 / INVCAL_SQRT(variance_of(turns, angle));
    invcal_real cosine;
    invcal_real sine;
    invcal_real across[2][3];
    invcal_real g[INVCAL_PARAMETERS];

    invcali_circle(angle / RADIANS, &cosine, &sine);
    rotate_back(n, cosine, sine, turns->up, out->up);
    find_across(turns->up, across);
    for (unsigned k = 0; k < 2; k++) {
        const invcal_real *b = across[k];
        invcal_real *h = out->h[k];
        const invcal_real along = (angle - sine) * invcali_dot3(b, n);
        invcali_cross(b, n, g);
        for (unsigned i = 0; i < 3; i++) {
            const invcal_real q = sine * b[i] + along * n[i] + (1 - cosine) * g[i];
            for (unsigned j = 0; j < 3; j++) {
                h[3 * i + j] = root * q * n[j];
            }
        }
        invcali_cross(turns->up, b, g);
        rotate_back(n, cosine, sine, g, &h[TURNS_GYRO]);
        invcali_products(out->up, &h[TURNS_GYRO]);
        scale(g, -1);
        invcali_products(turns->up, g);
        for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
            h[TURNS_GYRO + i] = root * (h[TURNS_GYRO + i] + g[i]);
        }
    }
    make_rest_row(out->h[2], out->up);
    out->rows = turns->n == TURNS_ALL ? TURN_ROWS : 2;
}

static invcal_status check(const invcal_turn *turn)
{
    if (!invcali_is_unit(turn->axis)) {
        return INVCAL_BAD_DIRECTION;
    }
    return INVCAL_FABS(turn->angle) <= MOST_ANGLE ? INVCAL_OK : INVCAL_BAD_ANGLE;
}

static void add_rows(invcal_real *sum, unsigned n, const turn_rows *rows)
{
    for (unsigned k = 0; k < rows->rows; k++) {
        invcali_rank_one(sum, rows->h[k], n, 1);
    }
}

invcal_status invcali_turns_add(invcali_turns *turns, const invcal_turn *turn)
{
    turn_rows rows;

    INVCAL_ASSERT(turns && turn);
    const invcal_status status = check(turn);
    if (status == INVCAL_OK) {
        make_turn_rows(turns, turn, &rows);
        add_rows(turns->sum, turns->n, &rows);
        scale(rows.up, 1 / INVCAL_SQRT(invcali_dot3(rows.up, rows.up)));
        memcpy(turns->up, rows.up, sizeof turns->up);
    }
    return status;
}

/* ---- beginnings ------------------------------------------------------------------------------ */

static void begin_turns(invcali_turns *turns, unsigned n, invcal_real noise, invcal_real rate_noise,
                        invcal_real instability)
{
    invcali_zero(turns, sizeof *turns);
    turns->n = (uint8_t)n;
    turns->noise = noise;
    turns->seconds = USUAL_SECONDS;
    const invcal_real density = rate_noise / noise;
    const invcal_real wander = INVCAL_REAL(1.5) * instability / noise;
    turns->linear = density * density;
    turns->square = turns->linear / 2 + wander * wander; /* the bias of rests of 1 s */
}

/* prior may be NULL. */
static void add_known(invcali_turns *turns, const invcal_real *prior)
{
    for (unsigned i = 0; prior && i < turns->n; i++) {
        const invcal_real sigma = prior[invcali_imu_parameter(i)];
        if (sigma > 0) {
            const invcal_real known = turns->noise / sigma;
            turns->sum[INVCAL_PACKED(i, i)] += known * known;
        }
    }
}

invcal_status invcali_turns_begin(invcali_turns *turns, const invcal_real up[3],
                                  const invcal_imu_settings *settings, invcal_real noise)
{
    static const invcal_imu_settings unknown = {0, 0, 0, NULL};
    const invcal_imu_settings *s = settings ? settings : &unknown;

    INVCAL_ASSERT(turns && up);
    const invcal_status status =
        invcali_is_unit(up) ? invcali_imu_settings_check(s, noise) : INVCAL_BAD_DIRECTION;
    if (status != INVCAL_OK) {
        return status;
    }
    begin_turns(turns, s->held ? TURNS_GYRO : TURNS_ALL, noise > 0 ? noise : INVCAL_IMU_MEAN_NOISE,
                s->rate_noise > 0 ? s->rate_noise : INVCAL_IMU_RATE_NOISE,
                s->instability > 0 ? s->instability : INVCAL_IMU_INSTABILITY);
    memcpy(turns->up, up, sizeof turns->up);
    if (turns->n == TURNS_ALL) {
        invcal_real h[TURNS_ALL];
        make_rest_row(h, up);
        invcali_rank_one(turns->sum, h, TURNS_ALL, 1);
    }
    add_known(turns, s->prior);
    return INVCAL_OK;
}

invcal_status invcali_turns_after(invcali_turns *turns, const invcal_imu *imu,
                                  const invcal_positions *positions,
                                  const invcal_imu_settings *settings)
{
    invcali_imu_work w;
    invcal_imu_result out;

    INVCAL_ASSERT(turns && imu && positions);
    invcal_status status = invcali_imu_begin(&w, imu, positions, settings, &out);
    const unsigned last = imu->rests - w.begin - 1u; /* of the rests; or too large */
    if (status == INVCAL_OK && last >= INVCAL_MAX_MOVES) {
        status = INVCAL_TOO_FEW;
    }
    if (status == INVCAL_OK) {
        status = invcali_imu_sum(&w);
    }
    if (status == INVCAL_OK) {
        begin_turns(turns, w.n, INVCAL_SQRT(w.noise_square), w.rate_noise, w.instability);
        for (unsigned i = 0; i < SIZE; i++) { /* with 9 unknowns the surplus is never read */
            turns->sum[i] = w.noise_square * w.pass.sum[i];
        }
        invcali_correct(positions->nominal, w.mean[last].v, turns->up);
        scale(turns->up, 1 / INVCAL_SQRT(invcali_dot3(turns->up, turns->up)));
    }
    return status;
}

/* ---- merit and sigma ------------------------------------------------------------------------- */

/* Turns the sums, plus a vague prior of each parameter, into L^-1. */
static invcal_status invert_sums(invcal_real *a, unsigned n, invcal_real vague, invcal_real floor)
{
    for (unsigned i = 0; i < n; i++) {
        a[INVCAL_PACKED(i, i)] += vague;
    }
    const invcal_status status = invcali_factor(a, n, n, floor);
    if (status == INVCAL_OK) {
        invcali_invert(a, n);
    }
    return status;
}

/* det(A + H'H) / det A = det(I + Y Y'), Y' = L^-1 H': three rows need a 3x3 determinant only. rows
 * is lost. */
static invcal_real merit_of(const invcal_real *inverse, unsigned n, turn_rows *rows)
{
    invcal_real gram[INVCAL_PACKED_SIZE(TURN_ROWS)];
    invcal_real root = 1;
    invcal_real *at = gram;

    for (unsigned k = 0; k < rows->rows; k++) {
        invcal_real *h = rows->h[k];
        for (unsigned r = n; r > 0; r--) {
            h[r - 1] = invcali_dot(&inverse[INVCAL_PACKED(r - 1, 0)], h, r);
        }
        for (unsigned i = 0; i <= k; i++) {
            *at++ = invcali_dot(rows->h[i], h, n) + (i == k ? 1 : 0);
        }
    }
    (void)invcali_factor(gram, rows->rows, rows->rows, 0); /* positive definite */
    for (unsigned k = 0; k < rows->rows; k++) {
        root *= gram[INVCAL_PACKED(k, k)];
    }
    return 1 / (root * root);
}

void invcali_turns_next(const invcali_turns *turns, invcal_turn *out)
{
    invcal_real inverse[SIZE];
    turn_rows rows;
    invcal_turn turn;
    invcal_real up[3];
    invcal_real best = 0;

    INVCAL_ASSERT(turns && out);
    memcpy(inverse, turns->sum, sizeof inverse);
    (void)invert_sums(inverse, turns->n, VAGUE, 0); /* positive definite */
    invcali_zero(&turn, sizeof turn);
    *out = turn;
    for (unsigned n = 0; n < INVCAL_DIRECTIONS; n++) {
        invcali_direction(n, up);
        if (turn_to(turns->up, up, &turn) >= NO_ARC) {
            make_turn_rows(turns, &turn, &rows);
            const invcal_real merit = merit_of(inverse, turns->n, &rows);
            if (!(merit <= CLEARLY * best)) { /* the last one, if all are NaN */
                best = merit;
                *out = turn;
            }
        }
    }
}

/* Returns the largest K; those above `most` are open. */
static invcal_real find_sigma(const invcal_real *inverse, unsigned n, invcal_real most,
                              invcal_real sigma[TURNS_ALL], uint32_t *open)
{
    invcal_real largest = 0;

    invcali_zero(sigma, TURNS_ALL * sizeof *sigma);
    *open = 0;
    for (unsigned i = 0; i < n; i++) {
        const invcal_real k = invcali_variance(inverse, n, i);
        const unsigned parameter = invcali_imu_parameter(i);
        sigma[parameter] = INVCAL_SQRT(k);
        if (!(k <= most)) {
            *open |= (uint32_t)1 << parameter;
        }
        largest = k <= largest ? largest : k;
    }
    return largest;
}

invcal_status invcali_turns_sigma(const invcali_turns *turns, const invcal_turn *turn,
                                  invcal_real sigma[INVCAL_IMU_PARAMETERS], uint32_t *open)
{
    invcal_real a[SIZE];
    turn_rows rows;
    invcal_status status = INVCAL_UNDETERMINED;

    INVCAL_ASSERT(turns && sigma && open);
    const invcal_real one = variance_of(turns, QUARTER);
    rows.rows = 0;
    if (turn != NULL) {
        const invcal_status usable = check(turn);
        if (usable != INVCAL_OK) {
            return usable;
        }
        make_turn_rows(turns, turn, &rows);
    }
    memcpy(a, turns->sum, sizeof a);
    add_rows(a, turns->n, &rows);
    if (invert_sums(a, turns->n, 0, INVCAL_FLOOR) == INVCAL_OK &&
        find_sigma(a, turns->n, WEAK_SQUARE * one, sigma, open) <= OPEN_SQUARE * one) {
        status = INVCAL_OK;
    }
    if (status != INVCAL_OK) {
        memcpy(a, turns->sum, sizeof a);
        add_rows(a, turns->n, &rows);
        (void)invert_sums(a, turns->n, VAGUE, 0);
        (void)find_sigma(a, turns->n, HELD_BY_VAGUE / VAGUE, sigma, open);
    }
    return status;
}
