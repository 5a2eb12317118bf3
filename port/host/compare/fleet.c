/* SPDX-License-Identifier: MIT
 *
 * A fleet: median, spread, and outliers.
 *
 * Of m values, the one that is farthest from their mean, by R of their standard deviations, is so
 * by chance in
 *
 *     m P(F(1, m - 2) > (m - 2) m R^2 / ((m - 1)^2 - m R^2))
 *
 * of cases at most (Grubbs). Several outliers increase the deviation and so mask each other:
 * therefore the farthest is removed and the next one tested, up to a quarter of all, and all up to
 * the last one that is significant are outliers (Rosner, Technometrics 25, 1983; NIST handbook
 * 1.3.5.17.3). From 25 devices on, the rate of false alarms is that of the first step; with fewer,
 * the other steps add up to a half of it (simulated: 1.5 times with 8, 1.3 with 20), so these are
 * tested at two thirds of the level. Each of the nine parameters has a ninth of the alarms. */
#include <math.h>
#include <stdlib.h>

#include "compare/compare.h"
#include "invcal/result.h"
#include "maths/f_tail.h"

#define MAD_TO_SIGMA 1.4826 /* standard deviation over the median of |x - median|, if normal */

#define LARGE_FLEET 25u /* devices: from here on, only the first step adds false alarms */

typedef struct {
    double x;
    unsigned number;
} entry;

static int by_size(const void *a, const void *b)
{
    const entry *one = a;
    const entry *other = b;

    return (one->x > other->x) - (one->x < other->x);
}

static void sort(entry *f, const double *x, unsigned n)
{
    for (unsigned i = 0; i < n; i++) {
        f[i] = (entry){x[i], i};
    }
    qsort(f, n, sizeof *f, by_size);
}

static double middle(const entry *f, unsigned n)
{
    return f[(n - 1) / 2].x / 2 + f[n / 2].x / 2;
}

/* Mean and standard deviation of f[0] ... f[n - 1]. */
static double spread_of(const entry *f, unsigned n, double *mean)
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

/* Removes the farthest of the n sorted values from *f on: the first or the last of them. Returns
 * the probability that one is so far by chance. */
static double remove_farthest(const entry **f, unsigned *n, unsigned *which)
{
    const double m = *n;
    double mean;
    const double deviation = spread_of(*f, *n, &mean);
    const int is_first = mean - (*f)[0].x > (*f)[*n - 1].x - mean;
    const entry *out = is_first ? &(*f)[0] : &(*f)[*n - 1];
    const double r = (out->x - mean) / deviation;

    *which = out->number;
    *f += is_first;
    --*n;
    return m * f_tail(1 - m * r * r / ((m - 1) * (m - 1)), 1, (unsigned)m - 2);
}

/* The values are sorted. */
static unsigned find_outliers(const entry *f, unsigned n, double alarm, unsigned *which)
{
    const unsigned max = n / 4 > 1 ? n / 4 : 1;
    const double level = max > 1 && n < LARGE_FLEET ? alarm * 2 / 3 : alarm;
    unsigned found = 0;

    for (unsigned k = 0; k < max && n >= COMPARE_FLEET_MIN; k++) {
        if (remove_farthest(&f, &n, &which[k]) <= level) {
            found = k + 1;
        }
    }
    return found;
}

unsigned compare_outliers(const double *x, unsigned n, double alarm, unsigned *which)
{
    entry *f = calloc((size_t)n + 1, sizeof *f);
    unsigned found = 0;

    if (f) {
        sort(f, x, n);
        found = find_outliers(f, n, alarm, which);
    }
    free(f);
    return found;
}

const compare_item *compare_newest(const compare_result *r, unsigned device)
{
    return &r->item[r->device[device].first + r->device[device].count - 1];
}

/* A device whose own 95 % interval reaches the median is not an outlier. */
static int exceeds_own_interval(const compare_result *r, unsigned device, unsigned p)
{
    const compare_item *item = compare_newest(r, device);
    const double away = fabs(item->x[p] - r->fleet.median[p]);

    return !(away <= invcal_coverage(item->dof) * item->sigma[p]);
}

static void find_parameter(compare_result *r, unsigned p, double *x, entry *f, unsigned *which)
{
    compare_fleet *fleet = &r->fleet;
    const unsigned n = r->devices;
    double mean;
    double max = -1;

    for (unsigned k = 0; k < n; k++) {
        x[k] = compare_newest(r, k)->x[p];
    }
    sort(f, x, n);
    fleet->median[p] = middle(f, n);
    fleet->deviation[p] = spread_of(f, n, &mean);
    const unsigned found =
        find_outliers(f, n, COMPARE_FALSE_ALARM / (double)INVCAL_PARAMETERS, which);
    for (unsigned k = 0; k < found; k++) {
        if (exceeds_own_interval(r, which[k], p)) {
            fleet->outliers[which[k]] = (uint16_t)(fleet->outliers[which[k]] | 1u << p);
        }
    }
    for (unsigned k = 0; k < n; k++) {
        x[k] = fabs(x[k] - fleet->median[p]);
        if (x[k] > max) {
            max = x[k];
            fleet->farthest[p] = k;
        }
    }
    sort(f, x, n);
    fleet->spread[p] = MAD_TO_SIGMA * middle(f, n);
}

int compare_fleet_find(compare_result *r)
{
    const size_t n = r->devices;
    double *x = calloc(n + 1, sizeof *x);
    entry *f = calloc(n + 1, sizeof *f);
    unsigned *which = calloc(n + 1, sizeof *which);

    r->fleet.outliers = calloc(n + 1, sizeof *r->fleet.outliers);
    const int has_memory = x && f && which && r->fleet.outliers;
    for (unsigned p = 0; p < INVCAL_PARAMETERS && has_memory; p++) {
        find_parameter(r, p, x, f, which);
    }
    free(x);
    free(f);
    free(which);
    return has_memory;
}
