/* SPDX-License-Identifier: MIT
 *
 * Searches for positions that contradict the others, in groups of up to three
 * (mathematics_judgement.md, "Outliers"). To leave one out is to add an unknown, its error: one
 * more row below the Cholesky factor instead of another solution ("One fit for all of them"). All
 * single ones and pairs are tried, and triples that contain a promising pair.
 *
 * Then the largest group that chance does not explain wins, if no other of its size is nearly as
 * good ("Chance").
 */
#include "outliers.h"

#include <stddef.h>

#include "../core/sums.h"
#include "../core/vector.h"

/* The table of mathematics_judgement.md, "Chance". */
#define LEVEL INVCAL_REAL(0.0075) /* one false alarm in a hundred data sets */
#define RIVAL_LEVEL INVCAL_REAL(0.05)
#define OWN_LEVEL INVCAL_REAL(0.02) /* of the residuals alone */
#define PROMISING INVCAL_REAL(9.5)

enum { STATED = 1 }; /* residuals that the stated noise counts as */

/* Groups of one size: the best and the second best, and the remaining sum of squares. */
typedef struct {
    invcali_set best;
    invcali_set rival;
    invcal_real squares;
    invcal_real rival_squares;
} contest;

/* Leaving position k out is the same as adding an unknown, its error: a column that is 1 there and
 * 0 elsewhere. Of two such columns the nine unknowns leave the product -h_i K h_k, of one with
 * itself 1 - h_k K h_k. So each position is weighed once, and a group costs only the products of
 * its rows. */
typedef struct {
    invcal_real unexplained; /* the part of c'c that the nine leave */
#ifndef __AVR__              /* where memory is short, the position is read again */
    invcal_real rest;        /* c'r: the residual */
    invcal_real u[3];        /* the corrected reading */
#endif
} single;

/* A member of a group, by what the nine and the member before it leave of its column. */
typedef struct {
    invcali_set out;                      /* it and those before it */
    invcal_real squares;                  /* of the others */
    invcal_real reciprocal;               /* of c'c */
    invcal_real v[INVCAL_PARAMETERS + 1]; /* its product with column k is -h_k v; then c'r */
} member;

/* The search in a fit. */
typedef struct {
    const invcali_fit *fit;
    unsigned size;         /* max members of a group */
    invcal_real promising; /* max squares left by a pair, see visit */
    contest contests[INVCAL_GROUP + 1];
    single alone[INVCAL_MAX_POSITIONS];
    member group[INVCAL_GROUP]; /* nobody, the first, the second; the third needs no more than v */
} search;

static invcali_set bit(unsigned i)
{
    return (invcali_set)((invcali_set)1 << i);
}

/* ---- the best group of each size ------------------------------------------------------------- */

/* A triple may come up once for each of its pairs; it must not be its own rival. */
static INVCAL_ONCE void enter(contest *c, invcali_set out, invcal_real squares)
{
    if (out == c->best || !(squares < c->rival_squares)) {
        return;
    }
    if (squares < c->squares) {
        c->rival = c->best;
        c->rival_squares = c->squares;
        c->best = out;
        c->squares = squares;
    } else {
        c->rival = out;
        c->rival_squares = squares;
    }
}

/* The row of position k and its residual, as invcali_fit_row. */
static INVCAL_ONCE void recall_row(const search *s, unsigned k,
                                   invcal_real row[INVCAL_PARAMETERS + 1])
{
#ifdef __AVR__
    invcali_fit_row(s->fit, k, row);
#else
    memcpy(row, s->alone[k].u, sizeof s->alone[k].u);
    invcali_row_of(row);
    row[INVCAL_J] = s->alone[k].rest;
#endif
}

/* h becomes v = K h = L^-T (L^-1 h), from L^-1. */
static INVCAL_ONCE void make_weights(const invcal_real *inverse, invcal_real v[INVCAL_PARAMETERS])
{
    (void)invcali_leverage(inverse, v);
    invcali_transposed(inverse, INVCAL_PARAMETERS, v);
}

/* Position k as member d, from 1: the group enters the contest of its size. Returns 1 if a member
 * may follow: after one always; after two if they leave at most 1 - 9.5 / n of the squares. 99 of
 * 100 clear groups of three have such a pair, but only one in fifteen pairs of a good set is one. */
static INVCAL_OFTEN int visit(search *s, unsigned d, unsigned k)
{
    const member *const before = &s->group[d - 1];
    member *const m = &s->group[d < INVCAL_GROUP ? d : 0]; /* of the third only v, for a moment */
    invcal_real share = 0;

    if ((before->out | s->fit->selection.left_out) >> k & 1u) {
        return 0;
    }
    const invcali_set out = before->out | bit(k);
    recall_row(s, k, m->v);
    invcal_real left = s->alone[k].unexplained;
    invcal_real rest = m->v[INVCAL_J];
    INVCAL_ROLL
    for (unsigned i = 1; i < d; i++) {
        const invcal_real product = invcali_dot(m->v, s->group[i].v, INVCAL_PARAMETERS);
        share = product * s->group[i].reciprocal;
        rest += share * s->group[i].v[INVCAL_J];
        left -= share * product;
    }
    /* 0: the others explain its column, so that leaving it out changes nothing */
    const invcal_real reciprocal = left > INVCAL_TOLERANCE ? 1 / left : 0;
    const invcal_real squares = before->squares - rest * rest * reciprocal;
    enter(&s->contests[d], out, squares);
    if (d >= s->size || (d > 1 && !(squares <= s->promising))) {
        return 0;
    }
    m->out = out;
    m->squares = squares;
    m->reciprocal = reciprocal;
    m->v[INVCAL_J] = rest;
    make_weights(s->fit->sums.sum, m->v);
    INVCAL_ROLL
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) { /* of the first, share is 0 */
        m->v[r] += share * before->v[r];
    }
    return 1;
}

/* All groups of one and two, and those of three with a promising pair. */
static INVCAL_ONCE void search_groups(search *s)
{
    const invcali_fit *const fit = s->fit;
    const unsigned count = fit->selection.given.count;
    invcal_real *const row = s->group[0].v;

    for (unsigned k = 0; k < count; k++) {
        single *const one = &s->alone[k];
        invcali_fit_row(fit, k, row);
#ifndef __AVR__
        memcpy(one->u, row, sizeof one->u);
        one->rest = row[INVCAL_J];
#endif
        one->unexplained = 1 - invcali_leverage(fit->sums.sum, row);
    }
    for (unsigned i = 0; i < count; i++) {
        if (!visit(s, 1, i)) {
            continue;
        }
        for (unsigned j = 0; j < i; j++) {
            if (!visit(s, 2, j)) {
                continue;
            }
            for (unsigned k = 0; k < count; k++) {
                (void)visit(s, 3, k);
            }
        }
    }
}

/* ---- how many of them ------------------------------------------------------------------------ */

/* Is leaving out k significantly better than any fewer, given the number of choices? If the noise
 * is stated, the residuals alone must confirm it: a systematic error is not noise. */
static INVCAL_ONCE int beats_fewer(const search *s, unsigned k, invcal_real *chance)
{
    const contest *c = s->contests;
    invcal_real choices = 1;

    //@ split k;
    for (unsigned j = k; j-- > 0;) {
        choices *= invcali_number(s->fit->sums.count - j) / invcali_number(k - j);
        *chance = choices * invcali_chance(s->fit, c[k].squares, c[j].squares, k - j, k, STATED);
        if (!(*chance <= LEVEL)) {
            return 0;
        }
    }
    return choices * invcali_chance(s->fit, c[k].squares, c[0].squares, k, k, 0) <= OWN_LEVEL;
}

/* Else the data do not show which of the two groups is wrong. */
static INVCAL_ONCE int beats_rival(const search *s, unsigned k)
{
    const contest *const c = &s->contests[k];

    return invcali_chance(s->fit, c->squares, c->rival_squares, 1, k, STATED) <= RIVAL_LEVEL;
}

/* The largest clear group. */
static INVCAL_ONCE void clear_group(const search *s, invcali_group *found)
{
    invcal_real chance = 1;

    invcali_zero(found, sizeof *found);
    found->chance = INVCAL_REAL_MAX;
    for (unsigned k = s->size; k > 0 && !found->group; k--) { /* at most INVCAL_GROUP times */
        const contest *const c = &s->contests[k];
        if (!beats_fewer(s, k, &chance)) {
            continue;
        }
        if (beats_rival(s, k)) {
            found->group = c->best;
        } else if (!found->suspected) {
            found->suspected = c->best | c->rival;
        } else {
            continue;
        }
        found->size = k;
        found->squares = c->squares;
        found->chance = chance;
    }
}

void invcali_outliers_search(const invcali_fit *fit, invcali_group *found)
{
    search s;

    invcali_zero(&s, sizeof s); /* nobody is out */
    s.fit = fit;
    s.size = invcali_fit_spare(fit, INVCAL_SPARE);
    if (s.size > INVCAL_GROUP) {
        s.size = INVCAL_GROUP;
    }
    s.promising = fit->squares * (1 - PROMISING / invcali_number(fit->sums.count));
    INVCAL_ROLL
    for (unsigned k = 0; k <= INVCAL_GROUP; k++) {
        s.contests[k].squares = fit->squares;
        s.contests[k].rival_squares = fit->squares;
    }
    s.group[0].squares = fit->squares;
    search_groups(&s);
    clear_group(&s, found);
}
