/* SPDX-License-Identifier: MIT
 *
 * Many devices: median, spread, and who falls outside.
 *
 * The device that is farthest from the mean of m figures, by R standard deviations of all m, is so by chance in
 *
 *     m P(F(1, m - 2) > (m - 2) m R^2 / ((m - 1)^2 - m R^2))
 *
 * of cases at most (Grubbs). Several may hide each other, for they widen the deviation: so the farthest is
 * taken out and the next one looked at, up to a quarter of all, and those are outside up to the last that
 * chance does not explain (Rosner, Technometrics 25, 1983; NIST handbook 1.3.5.17.3). Over all devices
 * the rate of false alarms is that of the first step, from 25 devices on; of fewer the further steps add up
 * to a half of it (simulated: 1.5 times with 8, 1.3 with 20), so that they are tested at two thirds. Each of
 * nine parameters has a ninth of the alarms. */
#include <math.h>
#include <stdlib.h>

#include "compare/compare.h"
#include "maths/f_tail.h"

#define NORMAL 1.4826 /* standard deviations of a normal family in its median of |x - median| */

#define MANY 25u /* devices: from here on the steps after the first add no false alarms */

typedef struct {
    double x;
    unsigned who;
} figure_of;

static int by_size(const void *a, const void *b)
{
    const figure_of *one = a;
    const figure_of *other = b;

    return (one->x > other->x) - (one->x < other->x);
}

static void sort(figure_of *f, const double *x, unsigned n)
{
    for (unsigned i = 0; i < n; i++) {
        f[i] = (figure_of){x[i], i};
    }
    qsort(f, n, sizeof *f, by_size);
}

static double middle(const figure_of *f, unsigned n)
{
    return f[(n - 1) / 2].x / 2 + f[n / 2].x / 2;
}

/* Mean and standard deviation of f[0] ... f[n - 1]. */
static double spread_of(const figure_of *f, unsigned n, double *mean)
{
    double sum = 0;
    double squares = 0;

    for (unsigned i = 0; i < n; i++) {
        sum += f[i].x - f[0].x;
    }
    *mean = f[0].x + sum / n;
    for (unsigned i = 0; i < n; i++) {
        squares += (f[i].x - *mean) * (f[i].x - *mean);
    }
    return sqrt(squares / (n - 1.0));
}

/* Takes the farthest of the figures *f ... out, which is the first or the last of them in order; returns how
 * often chance alone makes one so far. */
static double take_farthest(const figure_of **f, unsigned *n, unsigned *who)
{
    const double m = *n;
    double mean;
    const double deviation = spread_of(*f, *n, &mean);
    const int is_first = mean - (*f)[0].x > (*f)[*n - 1].x - mean;
    const figure_of *out = is_first ? &(*f)[0] : &(*f)[*n - 1];
    const double r = (out->x - mean) / deviation;

    *who = out->who;
    *f += is_first;
    --*n;
    return m * f_tail(1 - m * r * r / ((m - 1) * (m - 1)), 1, (unsigned)m - 2);
}

/* The figures are in order. */
static unsigned outside(const figure_of *f, unsigned n, double alarm, unsigned *who)
{
    const unsigned most = n / 4 > 1 ? n / 4 : 1;
    const double level = most > 1 && n < MANY ? alarm * 2 / 3 : alarm;
    unsigned found = 0;

    for (unsigned k = 0; k < most && n >= COMPARE_FLEET_LEAST; k++) {
        if (take_farthest(&f, &n, &who[k]) <= level) {
            found = k + 1;
        }
    }
    return found;
}

unsigned compare_outside(const double *x, unsigned n, double alarm, unsigned *who)
{
    figure_of *f = calloc((size_t)n + 1, sizeof *f);
    unsigned found = 0;

    if (f) {
        sort(f, x, n);
        found = outside(f, n, alarm, who);
    }
    free(f);
    return found;
}

const compare_item *compare_newest(const compare_result *r, unsigned device)
{
    return &r->item[r->device[device].first + r->device[device].count - 1];
}

/* One that is known so badly that its own 95 % reach the median is no more outside than that. */
static int is_known(const compare_result *r, unsigned device, unsigned p)
{
    const compare_item *item = compare_newest(r, device);
    const double away = fabs(item->x[p] - r->fleet.median[p]);

    return !(away <= invcal_coverage(item->dof) * item->sigma[p]);
}

static void find_parameter(compare_result *r, unsigned p, double *x, figure_of *f, unsigned *who)
{
    compare_fleet *fleet = &r->fleet;
    const unsigned n = r->devices;
    double mean;
    double most = -1;

    for (unsigned k = 0; k < n; k++) {
        x[k] = compare_newest(r, k)->x[p];
    }
    sort(f, x, n);
    fleet->median[p] = middle(f, n);
    fleet->deviation[p] = spread_of(f, n, &mean);
    const unsigned found = outside(f, n, COMPARE_FALSE_ALARM / (double)INVCAL_PARAMETERS, who);
    for (unsigned k = 0; k < found; k++) {
        if (is_known(r, who[k], p)) {
            fleet->outside[who[k]] = (uint16_t)(fleet->outside[who[k]] | 1u << p);
        }
    }
    for (unsigned k = 0; k < n; k++) {
        x[k] = fabs(x[k] - fleet->median[p]);
        if (x[k] > most) {
            most = x[k];
            fleet->farthest[p] = k;
        }
    }
    sort(f, x, n);
    fleet->spread[p] = NORMAL * middle(f, n);
}

int compare_fleet_find(compare_result *r)
{
    const size_t n = r->devices;
    double *x = calloc(n + 1, sizeof *x);
    figure_of *f = calloc(n + 1, sizeof *f);
    unsigned *who = calloc(n + 1, sizeof *who);

    r->fleet.outside = calloc(n + 1, sizeof *r->fleet.outside);
    const int is_done = x && f && who && r->fleet.outside;
    for (unsigned p = 0; p < INVCAL_PARAMETERS && is_done; p++) {
        find_parameter(r, p, x, f, who);
    }
    free(x);
    free(f);
    free(who);
    return is_done;
}
