/* SPDX-License-Identifier: MIT */
#include "design/order.h"

#include <math.h>
#include <string.h>

#include "invcal/expert.h"

enum { NINE = INVCAL_PARAMETERS, ALL = NINE + 3 };

/* A drift is a column tau eta: what it shares with the columns eta_b and eta_b eta_c of the nine are
 * products of two and three of x, y, z, weighed with tau. */
enum { MOMENTS = 16 };
#define SHOWN 25.0  /* what the squares of these moments weigh against radians of turning */
#define ENOUGH 1.15 /* sigma that grows by no more is as good as sigma that does not */
#define BETTER 1e-9

static double tau_of(unsigned k, unsigned count)
{
    return (double)k / (count - 1) - 0.5;
}

double order_hides_drift(const double (*direction)[3], const double *weight, unsigned count)
{
    double a[INVCAL_PACKED_SIZE(ALL)] = {0};
    double nine[INVCAL_PACKED_SIZE(NINE)];
    double most = 0;

    for (unsigned k = 0; k < count; k++) {
        const double x = direction[k][0];
        const double y = direction[k][1];
        const double z = direction[k][2];
        const double t = tau_of(k, count);
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
    if (invcal_factor(nine, NINE, NINE, INVCAL_FLOOR) != INVCAL_OK ||
        invcal_factor(a, ALL, ALL, INVCAL_FLOOR) != INVCAL_OK) {
        return HUGE_VAL;
    }
    invcal_invert(nine, NINE);
    invcal_invert(a, ALL);
    for (unsigned r = 0; r < NINE; r++) {
        most = fmax(most, invcal_variance(a, ALL, r) / invcal_variance(nine, NINE, r));
    }
    return sqrt(most);
}

/* ---- the search ----------------------------------------------------------------------------------- */

typedef struct {
    double (*direction)[3];
    unsigned count;
    double hidden; /* how much of a drift may be: order_hides_drift */
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

static double way_of(const route *r)
{
    double way = 0;

    for (unsigned k = 1; k < r->count; k++) {
        way += angle(r->direction[k - 1], r->direction[k]);
    }
    return way;
}

static double moments_and_way(const route *r)
{
    double sum[MOMENTS] = {0};
    double squares = 0;

    for (unsigned k = 0; k < r->count; k++) {
        double m[MOMENTS];
        moments_of(r->direction[k], m);
        for (unsigned i = 0; i < MOMENTS; i++) {
            sum[i] += tau_of(k, r->count) * m[i];
        }
    }
    for (unsigned i = 0; i < MOMENTS; i++) {
        squares += sum[i] * sum[i];
    }
    return way_of(r) + SHOWN * squares;
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

/* A change is undone by being made again. */
static int improve(const route *r, change *make, cost *of, double *best)
{
    int has_improved = 0;

    for (unsigned i = 1; i < r->count; i++) {
        for (unsigned k = i + 1; k < r->count; k++) {
            make(r, i, k);
            const double now = of(r);
            if (now < *best - BETTER &&
                order_hides_drift((const double(*)[3])r->direction, NULL, r->count) <= r->hidden) {
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

/* First any drift is made to show, then the way is made shorter that shows it as well. */
void order_directions(double (*direction)[3], unsigned count)
{
    route r = {direction, count, HUGE_VAL};

    if (count > 2) {
        search(&r, moments_and_way);
        r.hidden = fmax(ENOUGH, order_hides_drift((const double(*)[3])direction, NULL, count));
        search(&r, way_of);
    }
}
