/* SPDX-License-Identifier: MIT
 *
 * One round of the choice between outliers and systematic errors (mathematics_judgement.md,
 * "Choosing between hypotheses"). outliers.c proposes a group, systematic.c tests the four kinds of
 * systematic error, both against the same fit. The result is a group to leave out, the name of an
 * error, a verdict of rough, or nothing.
 *
 * Before two or more positions are left out, a drift and a step must be ruled out: either makes
 * good positions look like outliers, and without those a wrong calibration would look good.
 */
#include "diagnosis.h"

#include <stddef.h>

#include "outliers.h"
#include "systematic.h"
#include "../core/vector.h"

/* Levels and ratios of mathematics_judgement.md: "Chance", "Choosing between hypotheses" and, for
 * SHOWN, which is 1 / 1.5^2, "What cannot be tested". */
#define SIGNIFICANT INVCAL_REAL(0.002)
#define UNSTATED INVCAL_REAL(0.004) /* the same, if no noise is stated */
#define NAMEABLE INVCAL_REAL(0.02)  /* of the residuals alone */
#define FAVOUR INVCAL_REAL(7.4)     /* by which outliers may be less likely, and yet win */
#define AMBIGUOUS INVCAL_REAL(0.3)
#define SHOWN INVCAL_REAL(0.44444) /* sigma grows 1.5 times at most */

/* Of all kinds of systematic errors. */
typedef struct {
    unsigned kind;       /* of the most significant one that can be named, or none */
    invcal_real squares; /* left by it */
    invcal_real chance;  /* its probability by chance alone */
    int is_significant;  /* is any, even if it cannot be named? */
    unsigned unchecked;  /* as in invcal_quality */
    invcal_real least;   /* squares left by the best of all with spare degrees of freedom */
} diagnosis;

/* Tests a kind. Returns 1 if its columns leave enough degrees of freedom for it to be named. */
static INVCAL_OFTEN int test(const invcali_fit *fit, diagnosis *d, unsigned kind, unsigned step,
                             invcali_test *t)
{
    invcali_test_for(fit, kind, step, t);
    const int has_spare = fit->sums.count >= INVCAL_PARAMETERS + INVCAL_SPARE + t->rank;
    if (has_spare && t->squares < d->least) {
        d->least = t->squares;
    }
    return has_spare;
}

static INVCAL_NOINLINE invcal_real chance_of(const invcali_fit *fit, const invcali_test *t,
                                             unsigned stated)
{
    return invcali_chance(fit, t->squares, fit->squares, t->rank, t->rank, stated);
}

/* Significant by the stated noise or by the residuals alone: then the verdict is no longer good. A
 * name needs the latter, since the noise may be stated too small. */
static INVCAL_ONCE void try_kind(const invcali_fit *fit, diagnosis *d, unsigned kind)
{
    const invcal_real level = fit->selection.given.noise > 0 ? SIGNIFICANT : UNSTATED;
    invcali_test t;
    const int may_be_named = test(fit, d, kind, 0, &t);
    const invcal_real own = chance_of(fit, &t, 0);
    const invcal_real chance = chance_of(fit, &t, INVCAL_STATED);

    if (!(t.shown >= SHOWN)) {
        d->unchecked |= 1u << kind;
    }
    if (t.rank > 0 && (own <= level || chance <= level)) {
        d->is_significant = 1;
        if (may_be_named && own <= NAMEABLE && t.squares < d->squares) {
            d->kind = kind;
            d->squares = t.squares;
            d->chance = chance;
        }
    }
}

static INVCAL_ONCE void try_kinds(const invcali_fit *fit, diagnosis *d)
{
    d->kind = INVCAL_NO_SYSTEMATIC;
    d->squares = INVCAL_REAL_MAX;
    d->chance = 1;
    d->is_significant = 0;
    d->unchecked = 0;
    d->least = INVCAL_REAL_MAX;
    INVCAL_ROLL
    for (unsigned kind = INVCAL_DRIFT; kind <= INVCAL_HYSTERESIS; kind++) {
        try_kind(fit, d, kind);
    }
}

/* A systematic error, or a step, may look like two or more outliers. Each test may lower d->least;
 * with that of the four kinds it is then what the best rival of the group leaves. */
static INVCAL_ONCE int is_ambiguous(const invcali_fit *fit, diagnosis *d, const invcali_group *g)
{
    const unsigned n = fit->selection.given.count;
    invcali_test t;

    /* at most 2/3 INVCAL_MAX_POSITIONS */
    for (unsigned step = 1; 3 * (n - step) >= n; step++) {
        if (3 * step >= n) { /* in the middle third */
            (void)test(fit, d, INVCAL_DRIFT, step, &t);
        }
    }
    return invcali_chance(fit, g->squares, d->least, 1, g->size, INVCAL_STATED) > AMBIGUOUS;
}

/* If both probabilities underflow in float, no position is blamed. */
static INVCAL_ONCE int is_likelier(const invcali_group *g, const diagnosis *d)
{
    return g->chance < d->chance * FAVOUR;
}

/* Names the error, with its largest size. */
static INVCAL_ONCE void name(const invcali_fit *fit, unsigned kind, invcal_quality *q)
{
    invcali_test t;

    invcali_test_for(fit, kind, 0, &t);
    q->systematic = (uint8_t)kind;
    invcali_raise(q, kind == INVCAL_DRIFT ? INVCAL_DRIFTING : INVCAL_BENT);
    INVCAL_ROLL
    for (unsigned a = 0; a < 3; a++) {
        if (INVCAL_FABS(t.size[a]) > INVCAL_FABS(q->size)) {
            q->size = t.size[a];
            q->axis = (uint8_t)a;
        }
    }
}

/* Returns the positions to leave out. */
static INVCAL_NOINLINE invcali_set choose(const invcali_fit *fit, const invcali_group *g,
                                          invcal_quality *q)
{
    diagnosis d;

    try_kinds(fit, &d);
    q->unchecked = (uint8_t)d.unchecked;
    q->suspected = g->suspected;
    if (is_likelier(g, &d)) {
        if (g->group && (g->size < 2 || !is_ambiguous(fit, &d, g))) {
            return g->group;
        }
        invcali_raise(q, INVCAL_ROUGH);
    } else if (d.kind != INVCAL_NO_SYSTEMATIC) {
        name(fit, d.kind, q);
    } else if (d.is_significant) {
        invcali_raise(q, INVCAL_ROUGH);
    } /* cppcheck-suppress misra-c2012-15.7 ; nothing is wrong */
    return 0;
}

invcali_set invcali_diagnose(const invcali_selection *selection, const invcal_calibration *c,
                             invcal_quality *q)
{
    invcali_set out = 0;
    invcali_group g;
    invcali_fit fit;

    fit.selection = *selection;
    fit.selection.given.nominal = c;
    if (invcali_fit_solve(&fit) == INVCAL_OK) { /* uncovered: else c was determined by rounding */
        invcali_outliers_search(&fit, &g);
        out = q != NULL ? choose(&fit, &g, q) : g.group;
    }
    return out;
}
