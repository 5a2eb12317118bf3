/* SPDX-License-Identifier: MIT */
#include "design/order.h"

#include <math.h>
#include <string.h>

#include "core/system.h"

enum { NINE = INVCAL_PARAMETERS, ALL = NINE + 3 };

/* A drift is a column tau eta. Its products with the columns eta_b and eta_b eta_c of the nine are
 * moments: sums of tau times products of two or three of x, y, z. */
enum { MOMENTS = 16 };
#define MOMENT_WEIGHT 25.0   /* radians of turning per sum of the squared moments */
#define DRIFT_FACTOR_OK 1.15 /* a smaller factor is of no further use */
#define IMPROVEMENT_MIN 1e-9

static double tau(unsigned k, unsigned count)
{
    return (double)k / (count - 1) - 0.5;
}

double order_drift_factor(const double (*direction)[3], const double *weight, unsigned count)
{
    double a[INVCAL_PACKED_SIZE(ALL)] = {0};
    double nine[INVCAL_PACKED_SIZE(NINE)];
    double max = 0;

    for (unsigned k = 0; k < count; k++) {
        const double x = direction[k][0];
        const double y = direction[k][1];
        const double z = direction[k][2];
        const double t = tau(k, count);
        const double row[ALL] = {x,     y,     z,     x * x, y * y, z * z,
                                 x * y, x * z, y * z, t * x, t * y, t * z};
        const double w = weight ? weight[k] : 1;
        for (unsigned r = 0; r < ALL; r++) {
            for (unsigned c = 0; c <= r; c++) {
                a[INVCAL_PACKED(r, c)] += w * row[r] * row[c];
            }
        }
    }
    memcpy(nine, a, sizeof nine);
    if (invcali_factor(nine, NINE, NINE, INVCAL_FLOOR) != INVCAL_OK ||
        invcali_factor(a, ALL, ALL, INVCAL_FLOOR) != INVCAL_OK) {
        return HUGE_VAL;
    }
    invcali_invert(nine, NINE);
    invcali_invert(a, ALL);
    for (unsigned r = 0; r < NINE; r++) {
        max = fmax(max, invcali_variance(a, ALL, r) / invcali_variance(nine, NINE, r));
    }
    return sqrt(max);
}

/* ---- the search ----------------------------------------------------------------------------------- */

typedef struct {
    double (*direction)[3];
    unsigned count;
    double max_drift_factor;
} route;

static void moments_of(const double v[3], double m[MOMENTS])
{
    unsigned n = 0;

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = i; j < 3; j++) {
            m[n++] = v[i] * v[j];
            for (unsigned k = j; k < 3; k++) {
                m[n++] = v[i] * v[j] * v[k];
            }
        }
    }
}

static double angle(const double a[3], const double b[3])
{
    const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

    return acos(fmax(-1, fmin(1, dot)));
}

static double path_length(const route *r)
{
    double length = 0;

    for (unsigned k = 1; k < r->count; k++) {
        length += angle(r->direction[k - 1], r->direction[k]);
    }
    return length;
}

static double moments_and_length(const route *r)
{
    double sum[MOMENTS] = {0};
    double squares = 0;

    for (unsigned k = 0; k < r->count; k++) {
        double m[MOMENTS];
        moments_of(r->direction[k], m);
        for (unsigned i = 0; i < MOMENTS; i++) {
            sum[i] += tau(k, r->count) * m[i];
        }
    }
    for (unsigned i = 0; i < MOMENTS; i++) {
        squares += sum[i] * sum[i];
    }
    return path_length(r) + MOMENT_WEIGHT * squares;
}

static void exchange(const route *r, unsigned i, unsigned k)
{
    double v[3];

    memcpy(v, r->direction[i], sizeof v);
    memcpy(r->direction[i], r->direction[k], sizeof v);
    memcpy(r->direction[k], v, sizeof v);
}

static void reverse(const route *r, unsigned i, unsigned k)
{
    for (; i < k; i++, k--) {
        exchange(r, i, k);
    }
}

typedef void change(const route *r, unsigned i, unsigned k);
typedef double cost(const route *r);

/* Each change is its own inverse. */
static int improve(const route *r, change *make, cost *of, double *best)
{
    int has_improved = 0;

    for (unsigned i = 1; i < r->count; i++) {
        for (unsigned k = i + 1; k < r->count; k++) {
            make(r, i, k);
            const double now = of(r);
            if (now < *best - IMPROVEMENT_MIN &&
                order_drift_factor((const double(*)[3])r->direction, NULL, r->count) <=
                    r->max_drift_factor) {
                *best = now;
                has_improved = 1;
            } else {
                make(r, i, k);
            }
        }
    }
    return has_improved;
}

static void search(const route *r, cost *of)
{
    double best = of(r);

    while (improve(r, reverse, of, &best) | improve(r, exchange, of, &best)) {
    }
}

/* First for the drift, then for a shorter path that shows it as well. */
void order_directions(double (*direction)[3], unsigned count)
{
    route r = {direction, count, HUGE_VAL};

    if (count > 2) {
        search(&r, moments_and_length);
        r.max_drift_factor =
            fmax(DRIFT_FACTOR_OK, order_drift_factor((const double(*)[3])direction, NULL, count));
        search(&r, path_length);
    }
}
