/* SPDX-License-Identifier: MIT */
#include "stand/misset.h"

#include <math.h>

#include "maths/angles.h"
#include "maths/f_tail.h"
#include "text/number.h"

#define CHANCE 0.01 /* that one of all positions stands out so far */
#define FINEST 5e-6 /* rad, one arc second: what is less is no misset angle */
#define ONE_IN 4u   /* positions, at most, are left out */
#define TOGETHER                                                                                   \
    1000u /* positions or more, of which several are left out at a time, one in so many */
#define TRACED 1000u /* misset positions, of which is looked for where they belong */
#define AT_ANOTHER                                                                                 \
    0.15             /* of the way between two directions: the reading is that of the other one */
#define SMALL 0.2    /* rad: an error that is resolved into alpha and beta */
#define UPRIGHT 0.01 /* sine of alpha below which beta turns the unit about the vertical */

/* What the scatter loses without a position: its own part, and what it draws the others along by. */
static double share_of(const mounting *m, const mounting_position *p)
{
    return mounting_off(m, p) / (1 - mounting_leverage(m, p->eta));
}

/* The position that leaves least; count if there is none. */
static unsigned worst_one(const mounting_position *p, unsigned count, const mounting *m)
{
    unsigned worst = count;
    double most = FINEST * FINEST;

    for (unsigned i = 0; i < count; i++) {
        const double share = p[i].is_left_out ? 0 : share_of(m, &p[i]);
        if (share > most) {
            most = share;
            worst = i;
        }
    }
    return worst;
}

/* Leaves out the position that stands out, and m is that without it; 0 if none does. */
static int leave_out(mounting_position *p, unsigned count, const invcal_calibration *nominal,
                     mounting *m, unsigned *which)
{
    const double squares = m->scatter * m->scatter * m->dof;
    mounting without;

    *which = worst_one(p, count, m);
    if (*which == count || !(m->dof >= 4)) {
        return 0;
    }
    p[*which].is_left_out = 1;
    if (mounting_fit(p, count, nominal, &without) == INVCAL_OK && without.dof > 0) {
        const double left = without.scatter * without.scatter * without.dof;
        const double kept = m->dof / 2 + 4; /* positions */
        if (kept * f_tail(left / squares, 2, (unsigned)without.dof) < CHANCE) {
            *m = without;
            return 1;
        }
    }
    p[*which].is_left_out = 0;
    return 0;
}

/* Of thousands of positions those go together that stand out at least half as far as the one that was
 * left out, `most`, and by themselves: one alone would take as long as all. Of fewer none does. Adds them
 * to the list. */
static void leave_out_alike(mounting_position *p, unsigned count, const invcal_calibration *nominal,
                            double most, mounting *m, misset *list, unsigned *found)
{
    const double squares = m->scatter * m->scatter * m->dof;
    const double kept = m->dof / 2 + 4;
    const unsigned before = *found;
    mounting without;

    for (unsigned i = 0; i < count && *found < before + count / TOGETHER; i++) {
        const double share = p[i].is_left_out ? 0 : share_of(m, &p[i]);
        if (share > most / 2 && *found < count / ONE_IN &&
            kept * f_tail((squares - share) / squares, 2, (unsigned)m->dof) < CHANCE) {
            p[i].is_left_out = 1;
            list[(*found)++].index = i;
        }
    }
    if (*found > before && mounting_fit(p, count, nominal, &without) == INVCAL_OK) {
        *m = without;
    }
}

static double apart(const double a[3], const double b[3])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* The position whose direction it reads; count if there is none. */
static unsigned find_other(const mounting_position *p, unsigned count, unsigned i,
                           const double direction[3])
{
    for (unsigned k = 0; k < count; k++) {
        const double distance = apart(p[k].eta, p[i].eta);
        if (distance > SMALL && apart(direction, p[k].eta) < AT_ANOTHER * distance) {
            return k;
        }
    }
    return count;
}

/* e = d eta/d alpha a + d eta/d beta b: the two are orthogonal, of length 1 and sin alpha. */
static void find_angles(const mounting_position *p, const double direction[3], misset *out)
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
    out->beta = fabs(sa) > UPRIGHT ? out->beta : NUMBER_UNKNOWN;
}

static void describe(const mounting_position *p, unsigned count, const mounting *m, misset *out)
{
    double direction[3];

    mounting_direction(m, p[out->index].raw, direction);
    out->angle = 2 * asin(fmin(1, apart(direction, p[out->index].eta) / 2));
    out->other = find_other(p, count, out->index, direction);
    out->kind = out->other < count ? MISSET_REPEATED : MISSET_BY;
    find_angles(&p[out->index], direction, out);
}

/* Two that are each where the other should be. */
static void pair(misset *list, unsigned found)
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

invcal_status misset_find(mounting_position *p, unsigned count, const invcal_calibration *nominal,
                          mounting *m, misset *list, unsigned *found)
{
    const invcal_status status = mounting_fit(p, count, nominal, m);
    unsigned which;

    *found = 0;
    while (status == INVCAL_OK && *found < count / ONE_IN) {
        const mounting before = *m;
        if (!leave_out(p, count, nominal, m, &which)) {
            break;
        }
        list[(*found)++].index = which;
        leave_out_alike(p, count, nominal, share_of(&before, &p[which]), m, list, found);
    }
    for (unsigned i = 0; i < *found; i++) {
        describe(p, i < TRACED ? count : 0, m, &list[i]);
    }
    pair(list, *found < TRACED ? *found : TRACED);
    return status;
}
