/* SPDX-License-Identifier: MIT */
#include "fit/dip_frame.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "maths/median.h"
#include "maths/rotation.h"

#define LENGTH_TOLERANCE 0.1 /* relative to the median */
#define BLOCKS 24ul          /* whose sums show the correlation of instants */

enum { PERMUTATIONS = 24 };

/* A direction of the accelerometer and one of the magnetometer, both of length 1. */
typedef struct {
    double up[3];
    double field[3];
} instant;

/* ---- instants ----------------------------------------------------------------------------------- */

static double length_of(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Calibrates all instants, and stores their lengths. Returns the number of finite ones. */
static unsigned long calibrate(const magnetometer_log *log, const invcal_calibration *accelerometer,
                               instant *all, double *length[2])
{
    unsigned long count = 0;

    for (unsigned long n = 0; n < log->instants; n++) {
        instant *at = &all[count];
        memcpy(at->up, log->instant[n].up, sizeof at->up);
        if (accelerometer) {
            invcal_apply(accelerometer, at->up[0], at->up[1], at->up[2], at->up);
        }
        invcal_apply(&log->calibration, log->instant[n].field[0], log->instant[n].field[1],
                     log->instant[n].field[2], at->field);
        length[0][count] = length_of(at->up);
        length[1][count] = length_of(at->field);
        count += isfinite(length[0][count]) && isfinite(length[1][count]);
    }
    return count;
}

/* Keeps the instants whose lengths are near the medians, in their order. Returns their number. */
static unsigned long keep_typical(instant *all, unsigned long count, double *length[2],
                                  double *sorted)
{
    double typical[2];
    unsigned long kept = 0;

    for (unsigned s = 0; s < 2; s++) {
        memcpy(sorted, length[s], count * sizeof *sorted);
        typical[s] = median_of(sorted, count);
    }
    for (unsigned long n = 0; n < count; n++) {
        if (fabs(length[0][n] - typical[0]) <= LENGTH_TOLERANCE * typical[0] &&
            fabs(length[1][n] - typical[1]) <= LENGTH_TOLERANCE * typical[1]) {
            all[kept++] = all[n];
        }
    }
    return kept;
}

/* ---- the rotation ------------------------------------------------------------------------------- */

/* A signed permutation of the axes of the field: component j becomes sign[j] field[from[j]]. */
typedef struct {
    unsigned from[3];
    int sign[3];
} axis_permutation;

/* Number n of the 24 that are rotations. */
static axis_permutation permutation_of(unsigned n)
{
    static const unsigned orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                          {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const unsigned order = n / 4;
    const int first = n & 1 ? -1 : 1;
    const int second = n & 2 ? -1 : 1;
    const int parity = order < 3 ? 1 : -1;
    axis_permutation p = {.sign = {first, second, parity * first * second}};

    memcpy(p.from, orders[order], sizeof p.from);
    return p;
}

/* The sums that the permuted readings would have given. */
static invcal_dip sums_permuted(const invcal_dip *sums, const axis_permutation *p)
{
    invcal_dip out = *sums;
    unsigned from[INVCAL_PRIVATE_DIP];
    int sign[INVCAL_PRIVATE_DIP];

    for (unsigned k = 0; k < INVCAL_PRIVATE_DIP; k++) {
        from[k] = k < 9 ? 3 * (k / 3) + p->from[k % 3] : k;
        sign[k] = k < 9 ? p->sign[k % 3] : 1;
    }
    for (unsigned r = 0; r < INVCAL_PRIVATE_DIP; r++) {
        for (unsigned c = 0; c <= r; c++) {
            const unsigned high = from[r] > from[c] ? from[r] : from[c];
            const unsigned low = from[r] > from[c] ? from[c] : from[r];
            out.own_sum[r * (r + 1) / 2 + c] =
                sign[r] * sign[c] * sums->own_sum[high * (high + 1) / 2 + low];
        }
    }
    return out;
}

/* The best solution over all permutations. Returns 0 if there is none. */
static int find_rotation(const invcal_dip *sums, double alike, invcal_rotation *rotation,
                         invcal_dip_quality *quality)
{
    int is_found = 0;

    for (unsigned n = 0; n < PERMUTATIONS; n++) {
        const axis_permutation p = permutation_of(n);
        const invcal_dip here = sums_permuted(sums, &p);
        invcal_dip_quality q;
        invcal_rotation r;
        if (invcal_dip_solve(&here, alike, &r, &q) != INVCAL_OK ||
            (is_found && !(q.scatter < quality->scatter))) {
            continue;
        }
        is_found = 1;
        *quality = q;
        for (unsigned i = 0; i < 3; i++) {
            for (unsigned j = 0; j < 3; j++) {
                rotation->r[i][p.from[j]] = p.sign[j] * r.r[i][j];
            }
        }
    }
    return is_found;
}

/* The factor by which the squared sums of the angles' gradients over blocks exceed those of
 * independent instants. */
static double find_alike(const instant *all, unsigned long count, const double (*r)[3], double sine)
{
    double block_squares = 0;
    double instant_squares = 0;
    double sum[3] = {0};

    for (unsigned long n = 0; n < count; n++) {
        const double *u = all[n].up;
        const double *m = all[n].field;
        double turned[3];
        for (unsigned i = 0; i < 3; i++) {
            turned[i] = r[i][0] * m[0] + r[i][1] * m[1] + r[i][2] * m[2];
        }
        const double error = u[0] * turned[0] + u[1] * turned[1] + u[2] * turned[2] - sine;
        for (unsigned i = 0; i < 3; i++) {
            const unsigned j = (i + 1) % 3;
            const unsigned k = (i + 2) % 3;
            const double g = error * (turned[j] * u[k] - turned[k] * u[j]);
            sum[i] += g;
            instant_squares += g * g;
        }
        if ((n + 1) % (count / BLOCKS + 1) == 0 || n + 1 == count) {
            block_squares += sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2];
            memset(sum, 0, sizeof sum);
        }
    }
    return instant_squares > 0 ? fmax(1, block_squares / instant_squares) : 1;
}

static dip_answer solve(const instant *all, unsigned long count, dip_frame *out)
{
    invcal_dip sums;
    invcal_dip_quality quality;

    invcal_dip_init(&sums);
    for (unsigned long n = 0; n < count; n++) {
        (void)invcal_dip_add(&sums, all[n].up, all[n].field);
    }
    if (!find_rotation(&sums, 1, &out->rotation, &quality)) {
        return DIP_UNDETERMINED;
    }
    out->alike = find_alike(all, count, (const double(*)[3])out->rotation.r, quality.sine);
    if (!find_rotation(&sums, out->alike, &out->rotation, &quality)) {
        return DIP_UNDETERMINED;
    }
    memcpy(out->sigma, quality.sigma, sizeof out->sigma);
    rotation_vector((const double(*)[3])out->rotation.r, out->angle);
    out->dip = -asin(quality.sine);
    out->scatter = quality.scatter;
    out->heading = quality.heading;
    return DIP_FOUND;
}

int dip_frame_find(const magnetometer_log *log, const invcal_calibration *accelerometer,
                   dip_frame *out)
{
    const size_t size = log->instants + 1;
    instant *all = calloc(size, sizeof *all);
    double *length = calloc(3 * size, sizeof *length);
    const int failure = !all || !length;

    *out = (dip_frame){.answer = DIP_NO_ACCELEROMETER, .is_corrected = accelerometer != NULL};
    if (failure) {
        message("not enough memory for %lu samples", log->instants);
    } else {
        double *of_each[2] = {length, length + size};
        out->of = calibrate(log, accelerometer, all, of_each);
        out->used = out->of > 0 ? keep_typical(all, out->of, of_each, length + 2 * size) : 0;
        if (out->of > 0) {
            out->answer = 2 * out->used < out->of ? DIP_UNEVEN : solve(all, out->used, out);
        }
    }
    free(all);
    free(length);
    return failure ? EXIT_FILE : EXIT_GOOD;
}
