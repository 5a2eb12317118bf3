/* SPDX-License-Identifier: MIT
 *
 * Finds what is needed to solve the moves: the delay of the readings, their unit, and their axes.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fit/gyro.h"
#include "maths/median.h"

#define BIN 0.05                  /* seconds */
#define LAG_BINS_MAX 40           /* to either side: 2 s */
#define BINS_MIN 160u             /* needed to show a lag */
#define CORRELATION_MIN 0.4       /* that shows a lag */
#define CORRELATION_GAIN_MIN 0.05 /* over that without a lag */
#define LAG_MIN 0.1               /* seconds: less has no effect */

#define MOVES_MAX 16u   /* the first ones are used */
#define STEPS_MAX 96u   /* of a move */
#define ANGLE_MIN 0.35  /* rad between the up directions: 20 degrees */
#define SCALE_STEP 1.08 /* ratio of a scale to the one below */
#define SCALES_BELOW 3  /* the first estimate */
#define SCALES 18       /* in all: the path of a hand is longer than the arc, never shorter */
#define ASSIGNMENTS 48u /* of gyroscope axes to accelerometer axes, with signs */
#define CLEAR_RATIO 4.0 /* of the mean square misfits of the second best assignment and the best */

/* ---- late readings ------------------------------------------------------------------------------ */

/* A bin of time, with the sums of the readings of both sensors. */
typedef struct {
    double a[3];
    double rate; /* magnitude of the angular rate */
    unsigned count, readings;
} bin;

static size_t reading_at(const gyro_log *log, long lag, size_t index)
{
    const long at = (long)log->sample[index].reading_end + lag;

    return at < 0 ? 0 : (size_t)at > log->readings ? log->readings : (size_t)at;
}

/* The median of up to a thousand readings of an axis. */
static double usual_reading(const gyro_log *log, unsigned axis)
{
    double x[1000];
    const size_t step = log->readings / 1000 + 1;
    unsigned n = 0;

    for (size_t i = 0; i < log->readings && n < 1000; i += step) {
        x[n++] = log->reading[i].x[axis];
    }
    return median_of(x, n);
}

static size_t fill_bins(const gyro_log *log, bin *b, size_t each)
{
    const double middle[3] = {usual_reading(log, 0), usual_reading(log, 1), usual_reading(log, 2)};
    const size_t bins = log->samples / each;
    size_t next = 0;

    for (size_t i = 0; i < bins * each; i++) {
        bin *one = &b[i / each];
        for (unsigned k = 0; k < 3; k++) {
            one->a[k] += log->sample[i].raw[k];
        }
        one->count++;
        for (; next < log->sample[i].reading_end; next++) {
            double square = 0;
            for (unsigned k = 0; k < 3; k++) {
                square += pow(log->reading[next].x[k] - middle[k], 2);
            }
            one->rate += sqrt(square);
            one->readings++;
        }
    }
    return bins;
}

/* The change of the accelerometer's readings around a bin. */
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

    for (size_t i = LAG_BINS_MAX + 1; i + LAG_BINS_MAX + 1 < bins; i++) {
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
    double c[2 * LAG_BINS_MAX + 1];
    long best = -LAG_BINS_MAX;

    for (long k = -LAG_BINS_MAX; k <= LAG_BINS_MAX; k++) {
        c[k + LAG_BINS_MAX] = correlation(b, a, bins, k);
        best = c[k + LAG_BINS_MAX] > c[best + LAG_BINS_MAX] ? k : best;
    }
    const double highest = c[best + LAG_BINS_MAX];
    if (!(highest > CORRELATION_MIN && highest > c[LAG_BINS_MAX] + CORRELATION_GAIN_MIN) ||
        labs(best) == LAG_BINS_MAX) {
        return 0;
    }
    const double left = c[best + LAG_BINS_MAX - 1];
    const double right = c[best + LAG_BINS_MAX + 1];
    return (double)best +
           (left - right) / (2 * (left - 2 * highest + right)); /* vertex of a parabola */
}

long gyro_find_lag(const gyro_log *log)
{
    const double sample_rate =
        log->rate * (double)log->samples / (double)(log->readings ? log->readings : 1);
    const size_t each = (size_t)fmax(1, nearbyint(BIN * sample_rate));
    const size_t capacity = log->samples / each;
    bin *b = capacity > BINS_MIN ? calloc(capacity, sizeof *b) : NULL;
    double *a = b ? calloc(capacity, sizeof *a) : NULL;
    double lag = 0;

    if (a) {
        const size_t bins = fill_bins(log, b, each);
        for (size_t i = 1; i + 1 < bins; i++) {
            a[i] = sqrt(change(b, i));
        }
        lag = best_lag(b, a, bins) * (double)each / sample_rate;
    }
    free(a);
    free(b);
    return fabs(lag) > LAG_MIN ? lround(lag * log->rate) : 0;
}

/* ---- unit and axes ------------------------------------------------------------------------------ */

/* A move in steps: the integral of the readings over each, input units times seconds. */
typedef struct {
    double step[STEPS_MAX][3];
    unsigned steps;
    const double *up[2];
    double angle; /* between them */
    double path;  /* sum of the magnitudes of the readings */
    /* Rotates the up direction at the end back to that at the beginning: by all steps, and by all
     * the other way. Row n is where unit vector n goes. */
    double back[2][3][3];
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

void gyro_between(const gyro_log *log, long lag, const gyro_rest *rest, size_t *first, size_t *last)
{
    *first = reading_at(log, lag, rest[0].end - 1);
    *last = reading_at(log, lag, rest[1].begin > 0 ? rest[1].begin - 1 : 0);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static int fill_move(const gyro_log *log, long lag, const gyro_rest *rest, const double bias[3],
                     const int8_t axes[3], move *m)
{
    size_t first;
    size_t last;

    gyro_between(log, lag, rest, &first, &last);
    *m = (move){.up = {rest[0].up, rest[1].up}};
    m->angle = acos(fmax(-1, fmin(1, dot(m->up[0], m->up[1]))));
    if (last <= first || (double)(last - first) > 10 * log->rate || !(m->angle > ANGLE_MIN)) {
        return 0;
    }
    const size_t each = (last - first) / STEPS_MAX + 1;
    for (size_t i = first; i < last; i++) {
        double x[3];
        const size_t at = (i - first) / each;
        if (log->reading[i].is_gap) {
            return 0;
        }
        for (unsigned k = 0; k < 3; k++) {
            x[k] = (log->reading[i].x[k] - bias[k]) / log->rate;
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

/* Rotates three vectors by the rotation vector th. */
static void rotate(const double th[3], double all[3][3])
{
    const double x = sqrt(dot(th, th));
    const double cosine = cos(x);
    const double s = x > 1e-6 ? sin(x) / x : 1;
    const double c = x > 1e-6 ? (1 - cosine) / (x * x) : 0.5;

    for (unsigned n = 0; n < 3; n++) {
        double *v = all[n];
        const double along = c * dot(th, v);
        const double cross[3] = {th[1] * v[2] - th[2] * v[1], th[2] * v[0] - th[0] * v[2],
                                 th[0] * v[1] - th[1] * v[0]};
        for (unsigned i = 0; i < 3; i++) {
            v[i] = cosine * v[i] + s * cross[i] + along * th[i];
        }
    }
}

/* The rotations of all moves with this scale. */
static void set_scale(move *m, unsigned moves, double scale)
{
    static const double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    for (unsigned k = 0; k < moves; k++) {
        memcpy(m[k].back[0], identity, sizeof identity);
        memcpy(m[k].back[1], identity, sizeof identity);
        for (unsigned n = m[k].steps; n > 0; n--) {
            const double *x = m[k].step[n - 1];
            rotate((const double[3]){scale * x[0], scale * x[1], scale * x[2]}, m[k].back[0]);
            rotate((const double[3]){-scale * x[0], -scale * x[1], -scale * x[2]}, m[k].back[1]);
        }
    }
}

/* Assignment k of ASSIGNMENTS. */
static void set_assignment(unsigned k, int8_t axes[3])
{
    static const int8_t orders[6][3] = {{1, 2, 3}, {2, 3, 1}, {3, 1, 2},
                                        {2, 1, 3}, {1, 3, 2}, {3, 2, 1}};

    for (unsigned i = 0; i < 3; i++) {
        axes[i] = (int8_t)(k / 6 >> i & 1 ? -orders[k % 6][i] : orders[k % 6][i]);
    }
}

static int is_mirrored(unsigned k)
{
    const unsigned signs = k / 6;

    return ((signs ^ signs >> 1 ^ signs >> 2) & 1) != (k % 6 >= 3);
}

/* The squared angle between the up direction at the beginning, and that at the end, rotated back.
 * An assignment P makes P R P' of a rotation R, so that P' may be applied to the up directions
 * instead; a mirrored one rotates the other way, too. */
static double misfit(const move *m, unsigned assignment)
{
    const double(*back)[3] = m->back[is_mirrored(assignment)];
    int8_t axes[3];
    double up[2][3];
    double cosine = 0;

    set_assignment(assignment, axes);
    for (unsigned i = 0; i < 3; i++) {
        const int to = abs(axes[i]) - 1;
        up[0][to] = axes[i] < 0 ? -m->up[0][i] : m->up[0][i];
        up[1][to] = axes[i] < 0 ? -m->up[1][i] : m->up[1][i];
    }
    for (unsigned n = 0; n < 3; n++) {
        cosine += up[1][n] * dot(back[n], up[0]);
    }
    return pow(acos(fmax(-1, fmin(1, cosine))), 2);
}

/* The mean over the best three quarters of the moves: some may be between false rests. */
static double misfit_of_all(const move *m, unsigned moves, unsigned assignment)
{
    const unsigned counted = moves - moves / 4;
    double square[MOVES_MAX];
    double sum = 0;

    for (unsigned i = 0; i < moves; i++) {
        square[i] = misfit(&m[i], assignment);
    }
    sort_numbers(square, moves);
    for (unsigned i = 0; i < counted; i++) {
        sum += square[i];
    }
    return sum / counted;
}

/* Refines a scale to a thousandth. Returns its misfit. */
static double refine(move *m, unsigned moves, unsigned assignment, double least, double *scale)
{
    double width = SCALE_STEP;

    while (width > 1.001) {
        width = sqrt(width);
        const double middle = *scale;
        for (int side = -1; side <= 1; side += 2) {
            const double tried = middle * pow(width, side);
            set_scale(m, moves, tried);
            const double square = misfit_of_all(m, moves, assignment);
            *scale = square < least ? tried : *scale;
            least = fmin(least, square);
        }
    }
    return least;
}

/* The best scale of a grid for each assignment, and its misfit. */
static void try_scales(move *m, unsigned moves, double from, double least[ASSIGNMENTS],
                       double scale[ASSIGNMENTS])
{
    for (unsigned k = 0; k < ASSIGNMENTS; k++) {
        least[k] = HUGE_VAL;
        scale[k] = from;
    }
    for (unsigned n = 0; n < SCALES; n++) {
        const double tried = from * pow(SCALE_STEP, (double)n - SCALES_BELOW);
        set_scale(m, moves, tried);
        for (unsigned k = 0; k < ASSIGNMENTS; k++) {
            const double square = misfit_of_all(m, moves, k);
            if (square < least[k]) {
                least[k] = square;
                scale[k] = tried;
            }
        }
    }
}

int gyro_search(const gyro_log *log, long lag, const gyro_rest *rest, unsigned rests,
                const double bias[3], const int8_t axes[3], gyro_guess *out)
{
    static move all[MOVES_MAX]; /* too large for the stack */
    double ratio[MOVES_MAX];
    double least[ASSIGNMENTS];
    double scale[ASSIGNMENTS] = {0};
    unsigned best = 0;
    unsigned moves = 0;
    double second = HUGE_VAL;

    for (unsigned i = 0; i + 1 < rests && moves < MOVES_MAX; i++) {
        if (fill_move(log, lag, &rest[i], bias, axes, &all[moves]) && all[moves].path > 0) {
            ratio[moves] = all[moves].angle / all[moves].path;
            moves++;
        }
    }
    out->moves = moves;
    if (moves < 2) {
        return 0;
    }
    try_scales(all, moves, median_of(ratio, moves), least, scale);
    for (unsigned k = 0; k < ASSIGNMENTS; k++) {
        best = least[k] < least[best] ? k : best;
    }
    for (unsigned k = 0; k < ASSIGNMENTS; k++) {
        second = k != best && least[k] < second ? least[k] : second;
    }
    out->is_clear = second > CLEAR_RATIO * least[best];
    /* unless they are clear, the stated axes are kept if they fit nearly as well */
    best = !out->is_clear && least[0] < CLEAR_RATIO * least[best] ? 0 : best;
    set_assignment(best, out->axes);
    out->misfit = sqrt(refine(all, moves, best, least[best], &scale[best]));
    out->rate_unit = scale[best];
    return 1;
}
