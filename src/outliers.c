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

#include "sums.h"
#include "vector.h"

/* The table of mathematics_judgement.md, "Chance". */
#define LEVEL INVCAL_REAL(0.0075) /* one false alarm in a hundred data sets */
#define RIVAL_LEVEL INVCAL_REAL(0.05)
#define OWN_LEVEL INVCAL_REAL(0.02) /* of the residuals alone */
#define PROMISING INVCAL_REAL(9.5)

enum { STATED = 1 }; /* residuals that the stated noise counts as */

/* Groups of one size: the best and the second best, and the remaining sum of squares. */
typedef struct {
    invcal_mask best; /* with those left out before */
    invcal_mask rival;
    invcal_real squares;
    invcal_real rival_squares;
} contest;

/* The search in a fit. */
typedef struct {
    const invcal_fit *fit;
    invcal_real promising; /* max squares left by a pair, see visit */
    contest contests[INVCAL_GROUP + 1];
} search;

static invcal_mask bit(unsigned i)
{
    return (invcal_mask)((invcal_mask)1 << i);
}

/* ---- the best group of each size ------------------------------------------------------------- */

/* Leaving position k out is the same as adding an unknown, with a column that is 1 there and 0
 * elsewhere. */
typedef struct {
    invcal_mask out;     /* those left out so far */
    invcal_real squares; /* of the others */
} left_over;

/* A triple may come up once for each of its pairs; it must not be its own rival. */
static void enter(contest *c, invcal_mask out, invcal_real squares)
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

/* Position k as member d: the group enters the contest of its size. Returns 1 if a member may
 * follow: after one always; after two if they leave at most 1 - 9.5 / n of the squares. 99 of 100
 * clear groups of three have such a pair, but only one in fifteen pairs of a good set is one. */
static INVCAL_OFTEN int visit(search *s, left_over *over, invcal_column group[INVCAL_MORE],
                              unsigned d, unsigned k)
{
    const left_over *before = &over[d];
    left_over *after = &over[d + 1];
    invcal_real *const x = group[d];

    if (before->out >> k & 1u) {
        return 0;
    }
    invcal_fit_row_often(s->fit, k, x); /* H'c = h, c'r = r, */
    x[INVCAL_C] = 0;
    x[INVCAL_C + 1] = 0;
    x[INVCAL_C + d] = 1; /* c'c */
    (void)invcal_fit_append_often(s->fit, group, d);
    after->out = before->out | bit(k);
    after->squares = before->squares - x[INVCAL_REST] * x[INVCAL_REST];
    enter(&s->contests[d + 1], after->out, after->squares);
    return d == 0 || after->squares <= s->promising;
}

/* All groups of one and two, and those of three with a promising pair. */
static INVCAL_NOINLINE void search_groups(search *s, unsigned size)
{
    const unsigned count = s->fit->positions.count;
    left_over over[INVCAL_GROUP + 1];
    invcal_column group[INVCAL_GROUP];

    over[0].out = s->fit->positions.left_out;
    over[0].squares = s->contests[0].squares;
    for (unsigned i = 0; i < count; i++) {
        if (!visit(s, over, group, 0, i) || size < 2) {
            continue;
        }
        for (unsigned j = 0; j < i; j++) {
            if (!visit(s, over, group, 1, j) || size < 3) {
                continue;
            }
            for (unsigned k = 0; k < count; k++) {
                (void)visit(s, over, group, 2, k);
            }
        }
    }
}

/* ---- how many of them ------------------------------------------------------------------------ */

/* Is leaving out k significantly better than any fewer, given the number of choices? If the noise
 * is stated, the residuals alone must confirm it: a systematic error is not noise. */
static int beats_fewer(const search *s, unsigned k, invcal_real *chance)
{
    const contest *c = s->contests;
    invcal_real choices = 1;

    //@ split k;
    for (unsigned j = k; j-- > 0;) {
        choices *= invcal_number(s->fit->sums.count - j) / invcal_number(k - j);
        *chance = choices * invcal_chance(s->fit, c[k].squares, c[j].squares, k - j, k, STATED);
        if (!(*chance <= LEVEL)) {
            return 0;
        }
    }
    return choices * invcal_chance(s->fit, c[k].squares, c[0].squares, k, k, 0) <= OWN_LEVEL;
}

/* Else the data do not show which of the two groups is wrong. */
static int beats_rival(const search *s, unsigned k)
{
    const contest *const c = &s->contests[k];

    return invcal_chance(s->fit, c->squares, c->rival_squares, 1, k, STATED) <= RIVAL_LEVEL;
}

/* The largest clear group. */
static void clear_group(const search *s, unsigned size, invcal_group *found)
{
    const invcal_mask before = s->fit->positions.left_out;
    invcal_real chance = 1;

    for (unsigned k = size; k > 0 && !found->group; k--) { /* at most INVCAL_GROUP times */
        const contest *const c = &s->contests[k];
        if (!beats_fewer(s, k, &chance)) {
            continue;
        }
        if (beats_rival(s, k)) {
            found->group = c->best & ~before;
        } else if (!found->suspected) {
            found->suspected = (c->best | c->rival) & ~before;
        } else {
            continue;
        }
        found->size = k;
        found->squares = c->squares;
        found->chance = chance;
    }
}

void invcal_outliers_search(const invcal_fit *fit, invcal_group *found)
{
    const invcal_mask before = fit->positions.left_out;
    const contest initial = {before, before, fit->squares, fit->squares};
    unsigned size = invcal_fit_spare(fit, INVCAL_SPARE);
    search s;

    found->group = 0;
    found->suspected = 0;
    found->size = 0;
    found->squares = 0;
    found->chance = INVCAL_REAL_MAX;
    size = size < INVCAL_GROUP ? size : INVCAL_GROUP;
    s.fit = fit;
    s.promising = fit->squares * (1 - PROMISING / invcal_number(fit->sums.count));
    for (unsigned k = 0; k <= INVCAL_GROUP; k++) {
        s.contests[k] = initial;
    }
    search_groups(&s, size);
    clear_group(&s, size, found);
}
