/* SPDX-License-Identifier: MIT */
#include "stand/misset.h"

#include <math.h>
#include <stdlib.h>

#include "maths/angles.h"
#include "maths/f_tail.h"
#include "text/number.h"

#define SIGNIFICANCE 0.01   /* chance of such an outlier among all positions, by noise alone */
#define ANGLE_MIN 5e-6      /* rad, one arc second: smaller errors are not reported */
#define LEFT_OUT_PART 4u    /* at most one position in 4 is left out */
#define BATCH_PART 1000u    /* of 1000 positions or more, one in 1000 is left out in each pass */
#define WORK_MAX 1000000u   /* positions fitted in a row that reveal no further outlier */
#define TRACED_MAX 1000u    /* misset positions that are compared with all others */
#define SAME_DIRECTION 0.15 /* of the distance to another position: the reading is that one's */
#define DISTINCT 0.2        /* positions this far apart, as unit vectors, can be told apart */
#define SIN_ALPHA_MIN 0.01  /* below it beta turns the unit about the vertical */

/* Reduction of the sum of squares by removing a position: its own residual, and its pull on the
 * others. */
static double share_of(const mounting *m, const mounting_position *p)
{
    return mounting_squared_error(m, p) / (1 - mounting_leverage(m, p->eta));
}

/* The position whose removal reduces the sum of squares most; count if there is none. */
static unsigned find_worst(const mounting_position *p, unsigned count, const mounting *m)
{
    unsigned worst = count;
    double largest = ANGLE_MIN * ANGLE_MIN;

    for (unsigned i = 0; i < count; i++) {
        const double share = p[i].is_left_out ? 0 : share_of(m, &p[i]);
        if (share > largest) {
            largest = share;
            worst = i;
        }
    }
    return worst;
}

/* Whether noise alone would hardly ever lower the sum of squares by that much; m is without the
 * position. */
static int is_significant(const mounting *m, double left, double squares)
{
    const double kept = m->dof / 2 + 5; /* positions, with that one */

    return kept * f_tail(left / squares, 2, (unsigned)m->dof) < SIGNIFICANCE;
}

static double squares_of(const mounting *m)
{
    return m->scatter * m->scatter * m->dof;
}

/* Leaves out the worst position, and updates m. Returns 0 if there is none. */
static int leave_out(mounting_position *p, unsigned count, const invcal_calibration *nominal,
                     mounting *m, unsigned *which)
{
    mounting without;

    *which = find_worst(p, count, m);
    if (*which == count || !(m->dof >= 4)) {
        return 0;
    }
    p[*which].is_left_out = 1;
    if (mounting_fit(p, count, nominal, &without) == INVCAL_OK && without.dof > 0) {
        *m = without;
        return 1;
    }
    p[*which].is_left_out = 0;
    return 0;
}

/* Removing the outliers of thousands of positions one by one would take long: leaves out in the
 * same pass those whose share is at least half the largest. None of fewer than BATCH_PART
 * positions. */
static void leave_out_similar(mounting_position *p, unsigned count,
                              const invcal_calibration *nominal, double largest, mounting *m,
                              misset *list, unsigned *found)
{
    const double squares = m->scatter * m->scatter * m->dof;
    const double kept = m->dof / 2 + 4;
    const unsigned before = *found;
    mounting without;

    for (unsigned i = 0; i < count && *found < before + count / BATCH_PART; i++) {
        const double share = p[i].is_left_out ? 0 : share_of(m, &p[i]);
        if (share > largest / 2 && *found < count / LEFT_OUT_PART &&
            kept * f_tail((squares - share) / squares, 2, (unsigned)m->dof) < SIGNIFICANCE) {
            p[i].is_left_out = 1;
            list[(*found)++].index = i;
        }
    }
    if (*found > before && mounting_fit(p, count, nominal, &without) == INVCAL_OK) {
        *m = without;
    }
}

static double distance_between(const double a[3], const double b[3])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* The position whose direction it reads; count if there is none. */
static unsigned find_other(const mounting_position *p, unsigned count, unsigned i,
                           const double direction[3])
{
    for (unsigned k = 0; k < count; k++) {
        const double distance = distance_between(p[k].eta, p[i].eta);
        if (distance > DISTINCT &&
            distance_between(direction, p[k].eta) < SAME_DIRECTION * distance) {
            return k;
        }
    }
    return count;
}

/* e = d eta/d alpha a + d eta/d beta b: the two are orthogonal, of length 1 and sin alpha. */
static void resolve_angles(const mounting_position *p, const double direction[3], misset *out)
{
    double by_alpha[3];
    double by_beta[3]; /* over sin alpha */

    angles_direction(p->alpha + 90, p->beta, by_alpha);
    angles_direction(90, p->beta + 90, by_beta);
    const double sa = -by_alpha[1];

    out->alpha = out->beta = 0;
    for (unsigned i = 0; i < 3; i++) {
        out->alpha += (direction[i] - p->eta[i]) * by_alpha[i];
        out->beta += (direction[i] - p->eta[i]) * by_beta[i] / sa;
    }
    out->beta = fabs(sa) > SIN_ALPHA_MIN ? out->beta : NUMBER_UNKNOWN;
}

static void describe(const mounting_position *p, unsigned count, const mounting *m, misset *out)
{
    double direction[3];

    mounting_direction(m, p[out->index].raw, direction);
    out->angle = 2 * asin(fmin(1, distance_between(direction, p[out->index].eta) / 2));
    out->other = find_other(p, count, out->index, direction);
    out->kind = out->other < count ? MISSET_REPEATED : MISSET_BY;
    resolve_angles(&p[out->index], direction, out);
}

/* Each in the orientation of the other: swapped. */
static void pair_swapped(misset *list, unsigned found)
{
    for (unsigned i = 0; i < found; i++) {
        for (unsigned k = 0; k < found; k++) {
            if (list[i].kind == MISSET_REPEATED && list[k].kind != MISSET_BY &&
                list[i].other == list[k].index && list[k].other == list[i].index) {
                list[i].kind = MISSET_SWAPPED;
            }
        }
    }
}

/* Takes back what the larger outliers only seemed to make one, while they hid themselves: as long as
 * the position that fits best is none. */
static void take_back(mounting_position *p, unsigned count, const invcal_calibration *nominal,
                      mounting *m, misset *list, unsigned *found)
{
    while (*found > 0) {
        const double left = squares_of(m);
        double least = HUGE_VAL;
        unsigned best = 0;
        for (unsigned i = 0; i < *found; i++) {
            const mounting_position *one = &p[list[i].index];
            const double share =
                mounting_squared_error(m, one) / (1 + mounting_leverage(m, one->eta));
            best = share < least ? i : best;
            least = fmin(share, least);
        }
        if (is_significant(m, left, left + least)) {
            return;
        }
        p[list[best].index].is_left_out = 0;
        if (mounting_fit(p, count, nominal, m) != INVCAL_OK) {
            p[list[best].index].is_left_out = 1; /* cannot happen: it was among them before */
            return;
        }
        list[best] = list[--*found];
    }
}

/* As in Rosner's generalised ESD test: several outliers hide each other, so that none may seem
 * significant before all of them are left out. Leaves out one after the other, and keeps the largest
 * number whose last one is significant. */
static void find_outliers(mounting_position *p, unsigned count, const invcal_calibration *nominal,
                          mounting *m, misset *list, unsigned *found)
{
    mounting best = *m;
    unsigned kept = 0;
    unsigned which;

    while (*found < count / LEFT_OUT_PART && (*found - kept) <= WORK_MAX / count) {
        const mounting before = *m;
        if (!leave_out(p, count, nominal, m, &which)) {
            break;
        }
        list[(*found)++].index = which;
        if (is_significant(m, squares_of(m), squares_of(&before))) {
            leave_out_similar(p, count, nominal, share_of(&before, &p[which]), m, list, found);
            best = *m;
            kept = *found;
        }
    }
    while (*found > kept) {
        p[list[--*found].index].is_left_out = 0;
    }
    *m = best;
}

static int compare(const void *a, const void *b)
{
    const unsigned i = ((const misset *)a)->index;
    const unsigned k = ((const misset *)b)->index;

    return (i > k) - (i < k);
}

invcal_status misset_find(mounting_position *p, unsigned count, const invcal_calibration *nominal,
                          mounting *m, misset *list, unsigned *found)
{
    const invcal_status status = mounting_fit(p, count, nominal, m);

    *found = 0;
    if (status == INVCAL_OK) {
        find_outliers(p, count, nominal, m, list, found);
    }
    if (*found > 1 && *found < TRACED_MAX) {
        take_back(p, count, nominal, m, list, found);
    }
    qsort(list, *found, sizeof *list, compare);
    for (unsigned i = 0; i < *found; i++) {
        describe(p, i < TRACED_MAX ? count : 0, m, &list[i]);
    }
    pair_swapped(list, *found < TRACED_MAX ? *found : TRACED_MAX);
    return status;
}
