/* SPDX-License-Identifier: MIT
 *
 * What must be known before the moves can be solved: the delay of the readings, their unit, and their axes.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fit/gyro.h"

#define BIN 0.05      /* seconds */
#define LAGS 40       /* bins to either side: 2 s */
#define ENOUGH 160u   /* bins */
#define TOGETHER 0.4  /* the least correlation that shows a lag, */
#define BETTER 0.05   /* this much above that of no lag, */
#define LEAST_LAG 0.1 /* seconds: less does no harm */

#define MOVES 16u       /* that are tried: the first ones */
#define STEPS 96u       /* of a move */
#define LEAST_TURN 0.35 /* rad between the ways up: 20 degrees */
#define FINER 1.08      /* a scale and the next */
#define BELOW 3         /* scales below the first estimate, */
#define SCALES 18 /* and all of them: the path of a hand is longer than the arc, never shorter */
#define WAYS 48u
#define CLEAR 4.0 /* sum of squares of the second best way over the best */

/* ---- late readings ------------------------------------------------------------------------------ */

/* One bin of time: the mean reading of both. */
typedef struct {
    double a[3];
    double rate; /* of turn, without sign */
    unsigned count, readings;
} bin;

static size_t reading_at(const turns *t, long lag, size_t number)
{
    const long at = (long)t->sample[number].upto + lag;

    return at < 0 ? 0 : (size_t)at > t->readings ? t->readings : (size_t)at;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Of up to a thousand readings of an axis. */
static double median_of(const turns *t, unsigned axis)
{
    double x[1000];
    const size_t step = t->readings / 1000 + 1;
    unsigned n = 0;

    for (size_t i = 0; i < t->readings && n < 1000; i += step) {
        x[n++] = t->reading[i].x[axis];
    }
    qsort(x, n, sizeof x[0], compare);
    return n > 0 ? x[n / 2] : 0;
}

static size_t fill_bins(const turns *t, bin *b, size_t each)
{
    const double middle[3] = {median_of(t, 0), median_of(t, 1), median_of(t, 2)};
    const size_t bins = t->samples / each;
    size_t next = 0;

    for (size_t i = 0; i < bins * each; i++) {
        bin *one = &b[i / each];
        for (unsigned k = 0; k < 3; k++) {
            one->a[k] += t->sample[i].raw[k];
        }
        one->count++;
        for (; next < t->sample[i].upto; next++) {
            double square = 0;
            for (unsigned k = 0; k < 3; k++) {
                square += pow(t->reading[next].x[k] - middle[k], 2);
            }
            one->rate += sqrt(square);
            one->readings++;
        }
    }
    return bins;
}

/* How fast the accelerometer's readings change in a bin. */
static double change(const bin *b, size_t i)
{
    double square = 0;

    for (unsigned k = 0; k < 3; k++) {
        square += pow(b[i + 1].a[k] / b[i + 1].count - b[i - 1].a[k] / b[i - 1].count, 2);
    }
    return sqrt(square);
}

static double correlation(const bin *b, const double *a, size_t bins, long lag)
{
    double n = 0;
    double x = 0;
    double y = 0;
    double xx = 0;
    double yy = 0;
    double xy = 0;

    for (size_t i = LAGS + 1; i + LAGS + 1 < bins; i++) {
        const bin *g = &b[(size_t)((long)i + lag)];
        const double w = g->readings > 0 ? sqrt(g->rate / g->readings) : 0;
        n++;
        x += a[i];
        y += w;
        xx += a[i] * a[i];
        yy += w * w;
        xy += a[i] * w;
    }
    const double var = (xx - x * x / n) * (yy - y * y / n);
    return n > 0 && var > 0 ? (xy - x * y / n) / sqrt(var) : 0;
}

static double best_lag(const bin *b, const double *a, size_t bins)
{
    double c[2 * LAGS + 1];
    long best = -LAGS;

    for (long k = -LAGS; k <= LAGS; k++) {
        c[k + LAGS] = correlation(b, a, bins, k);
        best = c[k + LAGS] > c[best + LAGS] ? k : best;
    }
    const double most = c[best + LAGS];
    if (!(most > TOGETHER && most > c[LAGS] + BETTER) || labs(best) == LAGS) {
        return 0;
    }
    const double left = c[best + LAGS - 1];
    const double right = c[best + LAGS + 1];
    return (double)best + (left - right) / (2 * (left - 2 * most + right)); /* of a parabola */
}

long gyro_lag(const turns *t)
{
    const double sample_rate =
        t->rate * (double)t->samples / (double)(t->readings ? t->readings : 1);
    const size_t each = (size_t)fmax(1, nearbyint(BIN * sample_rate));
    const size_t room = t->samples / each;
    bin *b = room > ENOUGH ? calloc(room, sizeof *b) : NULL;
    double *a = b ? calloc(room, sizeof *a) : NULL;
    double lag = 0;

    if (a) {
        const size_t bins = fill_bins(t, b, each);
        for (size_t i = 1; i + 1 < bins; i++) {
            a[i] = sqrt(change(b, i));
        }
        lag = best_lag(b, a, bins) * (double)each / sample_rate;
    }
    free(a);
    free(b);
    return fabs(lag) > LEAST_LAG ? lround(lag * t->rate) : 0;
}

/* ---- unit and axes ------------------------------------------------------------------------------ */

/* A move in steps: the integral of the readings over each, input units times seconds. */
typedef struct {
    double step[STEPS][3];
    unsigned steps;
    const double *up[2];
    double angle; /* between them */
    double path;  /* of the readings, without sign */
} move;

void gyro_axes(const int8_t axes[3], const double x[3], double out[3])
{
    double turned[3];

    for (unsigned i = 0; i < 3; i++) {
        const int of = abs(axes[i]) - 1;
        turned[i] = axes[i] < 0 ? -x[of] : x[of];
    }
    memcpy(out, turned, sizeof turned);
}

void gyro_between(const turns *t, long lag, const gyro_rest *rest, size_t *first, size_t *last)
{
    *first = reading_at(t, lag, rest[0].end - 1);
    *last = reading_at(t, lag, rest[1].begin > 0 ? rest[1].begin - 1 : 0);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static int fill_move(const turns *t, long lag, const gyro_rest *rest, const double bias[3],
                     const int8_t axes[3], move *m)
{
    size_t first;
    size_t last;

    gyro_between(t, lag, rest, &first, &last);
    *m = (move){.up = {rest[0].up, rest[1].up}};
    m->angle = acos(fmax(-1, fmin(1, dot(m->up[0], m->up[1]))));
    if (last <= first || (double)(last - first) > 10 * t->rate || !(m->angle > LEAST_TURN)) {
        return 0;
    }
    const size_t each = (last - first) / STEPS + 1;
    for (size_t i = first; i < last; i++) {
        double x[3];
        const size_t at = (i - first) / each;
        if (t->reading[i].is_gap) {
            return 0;
        }
        for (unsigned k = 0; k < 3; k++) {
            x[k] = (t->reading[i].x[k] - bias[k]) / t->rate;
        }
        gyro_axes(axes, x, x);
        m->path += sqrt(dot(x, x));
        for (unsigned k = 0; k < 3; k++) {
            m->step[at][k] += x[k];
        }
        m->steps = (unsigned)at + 1;
    }
    return 1;
}

/* v turned by the rotation vector th. */
static void turn_by(const double th[3], double v[3])
{
    const double x = sqrt(dot(th, th));
    const double s = x > 1e-6 ? sin(x) / x : 1;
    const double c = x > 1e-6 ? (1 - cos(x)) / (x * x) : 0.5;
    const double along = c * dot(th, v);
    const double cross[3] = {th[1] * v[2] - th[2] * v[1], th[2] * v[0] - th[0] * v[2],
                             th[0] * v[1] - th[1] * v[0]};

    for (unsigned i = 0; i < 3; i++) {
        v[i] = cos(x) * v[i] + s * cross[i] + along * th[i];
    }
}

/* What turns the way up at the end, back by all steps, into that at the beginning, squared. */
static double misfit(const move *m, const int8_t axes[3], double turn)
{
    double v[3];
    double th[3];

    memcpy(v, m->up[1], sizeof v);
    for (unsigned n = m->steps; n > 0; n--) {
        gyro_axes(axes, m->step[n - 1], th);
        for (unsigned i = 0; i < 3; i++) {
            th[i] *= turn;
        }
        turn_by(th, v);
    }
    return pow(acos(fmax(-1, fmin(1, dot(v, m->up[0])))), 2);
}

/* The mean of the better three quarters: a move between false rests means nothing. */
static double misfit_of_all(const move *m, unsigned moves, const int8_t axes[3], double turn)
{
    const unsigned counted = moves - moves / 4;
    double square[MOVES];
    double sum = 0;

    for (unsigned i = 0; i < moves; i++) {
        square[i] = misfit(&m[i], axes, turn);
    }
    qsort(square, moves, sizeof square[0], compare);
    for (unsigned i = 0; i < counted; i++) {
        sum += square[i];
    }
    return sum / counted;
}

/* Way k of 48. */
static void set_way(unsigned k, int8_t axes[3])
{
    static const int8_t orders[6][3] = {{1, 2, 3}, {2, 3, 1}, {3, 1, 2},
                                        {2, 1, 3}, {1, 3, 2}, {3, 2, 1}};

    for (unsigned i = 0; i < 3; i++) {
        axes[i] = (int8_t)(k / 6 >> i & 1 ? -orders[k % 6][i] : orders[k % 6][i]);
    }
}

/* The best scale of a way: out of a grid, then to a thousandth. Returns its misfit. */
static double best_scale(const move *m, unsigned moves, const int8_t axes[3], double from,
                         int is_fine, double *turn)
{
    double least = HUGE_VAL;
    double width = FINER;

    for (unsigned n = 0; n < SCALES; n++) {
        const double scale = from * pow(FINER, (double)n - BELOW);
        const double square = misfit_of_all(m, moves, axes, scale);
        *turn = square < least ? scale : *turn;
        least = fmin(least, square);
    }
    while (is_fine && width > 1.001) {
        width = sqrt(width);
        const double middle = *turn;
        for (int side = -1; side <= 1; side += 2) {
            const double square = misfit_of_all(m, moves, axes, middle * pow(width, side));
            *turn = square < least ? middle * pow(width, side) : *turn;
            least = fmin(least, square);
        }
    }
    return least;
}

int gyro_search(const turns *t, long lag, const gyro_rest *rest, unsigned rests,
                const double bias[3], const int8_t axes[3], gyro_guess *out)
{
    static move all[MOVES]; /* too large for the stack */
    double ratio[MOVES];
    double square[WAYS];
    double turn = 0;
    unsigned best = 0;
    unsigned moves = 0;
    double next = HUGE_VAL;

    for (unsigned i = 0; i + 1 < rests && moves < MOVES; i++) {
        if (fill_move(t, lag, &rest[i], bias, axes, &all[moves]) && all[moves].path > 0) {
            ratio[moves] = all[moves].angle / all[moves].path;
            moves++;
        }
    }
    out->moves = moves;
    if (moves < 2) {
        return 0;
    }
    qsort(ratio, moves, sizeof ratio[0], compare);
    for (unsigned k = 0; k < WAYS; k++) {
        int8_t way[3];
        set_way(k, way);
        square[k] = best_scale(all, moves, way, ratio[moves / 2], 0, &turn);
        best = square[k] < square[best] ? k : best;
    }
    for (unsigned k = 0; k < WAYS; k++) {
        next = k != best && square[k] < next ? square[k] : next;
    }
    out->is_clear = next > CLEAR * square[best];
    /* an equally good scale is no reason to doubt the axes */
    best = !out->is_clear && square[0] < CLEAR * square[best] ? 0 : best;
    set_way(best, out->axes);
    out->misfit = sqrt(best_scale(all, moves, out->axes, ratio[moves / 2], 1, &out->turn));
    return 1;
}
