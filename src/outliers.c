/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "judge.h"
#include "sums.h"
#include "vector.h"

#define LEVEL INVCAL_REAL(0.0075)     /* false alarms: about one data set in a hundred */
#define RIVAL_LEVEL INVCAL_REAL(0.06) /* nearly as good as the best: not less likely than this */
#define SLACK INVCAL_REAL(1e-4)       /* of det H'H: with less left nothing checks the group */
#define PI INVCAL_REAL(3.14159265358979324)
#define ROUNDED (256 * INVCAL_EPSILON) /* of the squares: to less they cannot be taken down */

enum {
    GROUP = 3, /* outliers looked for together: what cannot hide one another */
    N = INVCAL_PARAMETERS
};

/* Groups of one size: the best and the second best, and what is left of the sum of squares. */
typedef struct {
    invcal_mask best; /* to be left out, and what was left out before */
    invcal_mask rival;
    invcal_real squares;
    invcal_real rival_squares;
} contest;

/* The fit of the positions that are not left out, and the search among them. */
typedef struct {
    invcal_positions positions;
    unsigned dof;                /* degrees of freedom of the squares */
    invcal_real promising;       /* squares that a pair leaves at most, see visit */
    contest contests[GROUP + 1]; /* of groups of 0 ... GROUP */
    invcal_sums sums;            /* their number; L^-1 of their normal equations, and p behind it */
} search;

static invcal_mask bit(unsigned i)
{
    return (invcal_mask)((invcal_mask)1 << i);
}

/* ---- the fit ---------------------------------------------------------------------------------- */

/* Position k as y = L^-1 h, and its residual r = J + h p behind it. Returns m = 1 - h K h' = 1 - |y|^2. */
static INVCAL_INLINE invcal_real whiten(const search *s, unsigned k, invcal_row *row)
{
    const invcal_real *l = s->sums.sum;

    (void)invcal_observe_often(s->positions.nominal, &s->positions.raw[3 * (size_t)k], row);
    row->h[INVCAL_J] += invcal_dot(&l[INVCAL_PACKED(N, 0)], row->h, N);
    return 1 - invcal_leverage_often(l, row->h);
}

/* What is known of the noise besides the residuals: the rounding errors of readings and sums, so
 * that exact readings have no outliers, and the noise stated, as one residual more. */
static invcal_real known_squares(const invcal_positions *p)
{
    const invcal_real rounding = 8 * INVCAL_EPSILON;

    return invcal_number(p->count) * rounding * rounding + p->noise * p->noise;
}

/* Sums, solution, squares: of the rows themselves, for a downdate would keep the rounding errors of
 * an outlier; and of the residuals, for J'J - p'H'Hp cancels. */
static INVCAL_APART invcal_status fit(search *s)
{
    invcal_real squares = known_squares(&s->positions);
    invcal_real condition;
    invcal_row row;

    invcal_status status = invcal_positions_sum(&s->positions, &s->sums);
    if (status == INVCAL_OK) {
        invcal_sums_system(&s->sums);
        status = invcal_determine(s->sums.sum, N + 1, row.h, &condition); /* p and L^-1 */
    }
    if (status != INVCAL_OK) {
        return status;
    }
    for (unsigned k = 0; k < s->positions.count; k++) {
        if (!(s->positions.left_out >> k & 1u)) {
            (void)whiten(s, k, &row);
            squares += row.h[INVCAL_J] * row.h[INVCAL_J];
        }
    }
    const unsigned spare = s->sums.count - N;
    s->dof = spare + (s->positions.noise > 0);
    s->promising = squares * invcal_number(spare) / invcal_number(s->sums.count);
    const contest nobody = {s->positions.left_out, s->positions.left_out, squares, squares};
    for (unsigned k = 0; k <= GROUP; k++) {
        s->contests[k] = nobody;
    }
    return INVCAL_OK;
}

/* ---- the best group of each size ------------------------------------------------------------ */

/* One position after another is left out. Position k is at first
 *
 *     y = L^-1 h,   r = J + h p,   m = 1 - h K h' = 1 - |y|^2.
 *
 * Leaving it out takes r^2 / m from the squares, and leaves m of det H'H. Behind each position i that
 * was left out before, with M = I - H K H' (Cholesky of M, row by row)
 *
 *     r + e r(i) / sqrt(m(i)),   m - e^2,   e = -M(k,i) / sqrt(m(i)) = y y(i) / sqrt(m(i)),
 *
 * and e goes on as one more element of y. */
typedef struct {
    invcal_mask out;     /* those that are left out by now */
    invcal_real squares; /* of the others */
    invcal_real det;     /* of H'H, over that of all */
} left_over;

typedef struct {
    left_over over;
    invcal_real root;  /* of m */
    invcal_real ratio; /* r / root */
    invcal_row y;      /* e behind it: 0 of the first; there is none behind the third */
} member;

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

/* Position k as member d: the group enters the contest of its size. Returns 1 if another may follow: to
 * one always; to two if they leave no more of the squares than (n - 9) / n. Clear groups of three have
 * such a pair, 99 of 100 of them, but only one in ten pairs of a good set is such a one. */
static INVCAL_OFTEN int visit(search *s, const left_over *before, member *group, unsigned d,
                              unsigned k)
{
    member *const x = &group[d];
    const invcal_real min = ROUNDED * s->contests[0].squares;

    if (before->out >> k & 1u) {
        return 0;
    }
    invcal_real m = whiten(s, k, &x->y);
    invcal_real r = x->y.h[INVCAL_J];
    x->y.h[INVCAL_J] = 0;
    for (const member *f = group; f < x; f++) {
        const invcal_real e = invcal_dot(x->y.h, f->y.h, N + 1) / f->root;
        x->y.h[INVCAL_J] = e;
        r += e * f->ratio;
        m -= e * e;
    }
    x->over.det = before->det * m;
    if (!(x->over.det > SLACK)) {
        return 0;
    }
    x->over.out = before->out | bit(k);
    x->root = INVCAL_SQRT(m);
    x->ratio = r / x->root;
    x->over.squares = before->squares - x->ratio * x->ratio;
    enter(&s->contests[d + 1], x->over.out, x->over.squares > min ? x->over.squares : min);
    return d == 0 || x->over.squares <= s->promising;
}

/* All groups of one and two, and those of three with a promising pair. */
static INVCAL_APART void search_groups(search *s, unsigned size)
{
    const unsigned count = s->positions.count;
    const left_over all = {s->positions.left_out, s->contests[0].squares, 1};
    member group[GROUP];

    invcal_zero(group, sizeof group);
    for (unsigned i = 0; i < count; i++) {
        if (!visit(s, &all, group, 0, i) || size < 2) {
            continue;
        }
        for (unsigned j = 0; j < i; j++) {
            if (!visit(s, &group[0].over, group, 1, j) || size < 3) {
                continue;
            }
            for (unsigned k = 0; k < count; k++) {
                (void)visit(s, &group[1].over, group, 2, k);
            }
        }
    }
}

/* ---- how many of them ----------------------------------------------------------------------- */

/* How often chance alone makes one sum of squares so small beside another: m unknowns more take it down
 * to z of itself, and leave dof residuals. The tail of Fisher's F, I_z(dof/2, m/2), m up to three, by
 * its leading terms: with t = dof (1 - z) / 2
 *
 *     z^(dof/2) / sqrt(pi t) (1, sqrt(pi t), 1 + 2 t),
 *
 * which are too large, by 1/(2 t) of the first or, for one residual, by a quarter: on the safe side.
 * Not finite, or above 1, for z of 1 or above. */
static invcal_real chance(invcal_real z, unsigned m, unsigned dof)
{
    const invcal_real root = INVCAL_SQRT(z);
    const invcal_real t = invcal_number(dof) * (1 - z) / 2;
    invcal_real p = 1;

    for (unsigned i = 0; i < dof; i++) {
        p *= root;
    }
    if (m == 2) {
        return p;
    }
    p /= INVCAL_SQRT(PI * t);
    return m == 1 ? p : p * (1 + 2 * t);
}

/* Is leaving out k better than leaving out any fewer, and not by the chance of so many choices? */
static int beats_fewer(const search *s, unsigned k)
{
    invcal_real choices = 1;

    for (unsigned j = k; j-- > 0;) {
        const invcal_real z = s->contests[k].squares / s->contests[j].squares;
        choices *= invcal_number(s->sums.count - j) / invcal_number(k - j);
        if (!(chance(z, k - j, s->dof - k) * choices <= LEVEL)) {
            return 0;
        }
    }
    return 1;
}

static int beats_rival(const search *s, unsigned k)
{
    const contest *const c = &s->contests[k];

    return chance(c->squares / c->rival_squares, 1, s->dof - k) <= RIVAL_LEVEL;
}

/* The size of the largest clear group, or 0. suspected: the two of the largest contest without a
 * clear winner, or 0. */
static INVCAL_APART unsigned clear_group(const search *s, unsigned size, invcal_mask *suspected)
{
    *suspected = 0;
    for (unsigned k = size; k > 0; k--) {
        if (beats_fewer(s, k)) {
            if (beats_rival(s, k)) {
                return k;
            }
            if (!*suspected) {
                *suspected = (s->contests[k].best | s->contests[k].rival) & ~s->positions.left_out;
            }
        }
    }
    return 0;
}

/* Two degrees of freedom are left: one alone tells nothing. */
static unsigned largest_group(const search *s)
{
    const unsigned spare = s->dof - 2;
    const unsigned more = s->sums.count + INVCAL_OUTLIERS_MOST - s->positions.count;
    const unsigned size = spare < more ? spare : more;

    return size < GROUP ? size : GROUP;
}

static invcal_status start(search *s, const invcal_real *raw, unsigned count,
                           const invcal_calibration *nominal, invcal_real noise)
{
    if (count > INVCAL_MAX_POSITIONS) {
        return INVCAL_BAD_COUNT;
    }
    s->positions.raw = raw;
    s->positions.count = count;
    s->positions.left_out = 0;
    s->positions.nominal = nominal;
    s->positions.noise = noise;
    return invcal_positions_check(&s->positions);
}

invcal_status invcal_outliers_find(const invcal_real *raw, unsigned count,
                                   const invcal_calibration *nominal, invcal_real noise,
                                   invcal_outliers *out)
{
    invcal_mask suspected;
    unsigned found;
    search s;

    INVCAL_ASSERT((raw || count == 0) && nominal && out);
    invcal_status status = start(&s, raw, count, nominal, noise);
    if (status == INVCAL_OK) {
        status = count < INVCAL_OUTLIERS_FEWEST ? INVCAL_TOO_FEW : fit(&s);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    do { /* at most INVCAL_OUTLIERS_MOST + 1 steps: the largest group may hide the next */
        const unsigned size = largest_group(&s);
        //@ split size;
        search_groups(&s, size);
        found = clear_group(&s, size, &suspected);
        out->removed = s.positions.left_out;
        s.positions.left_out = s.contests[found].best;
    } while (found > 0 && fit(&s) == INVCAL_OK);
    /* a group that the others are not determined without cannot be spared */
    out->suspected = suspected | (s.positions.left_out & ~out->removed);
    return INVCAL_OK;
}

/* What the fit tells of position k. If it took part, 1 / m is what 1 + h K h' would be without it. */
static INVCAL_APART void tell(const search *s, unsigned k, invcal_outlier *out)
{
    invcal_row row;
    const invcal_real checked = whiten(s, k, &row);
    const int is_removed = (s->positions.left_out & bit(k)) != 0;
    const invcal_real m = is_removed ? 1 : checked;

    out->sigma = INVCAL_SQRT(s->contests[0].squares / invcal_number(s->dof));
    out->checked = is_removed || m < 0 ? 0 : m;
    out->error = 0;
    out->w = 0;
    if (m > SLACK) {
        out->error = row.h[INVCAL_J] / m;
        out->w = out->error / (out->sigma * INVCAL_SQRT(is_removed ? 2 - checked : 1 / m));
    }
}

invcal_status invcal_outlier_size(const invcal_real *raw, unsigned count,
                                  const invcal_calibration *nominal, invcal_real noise,
                                  invcal_mask removed, unsigned position, invcal_outlier *out)
{
    search s;

    INVCAL_ASSERT((raw || count == 0) && nominal && out);
    invcal_status status = start(&s, raw, count, nominal, noise);
    s.positions.left_out = removed;
    if (status == INVCAL_OK) {
        status = position < count ? fit(&s) : INVCAL_BAD_COUNT;
    }
    if (status == INVCAL_OK && s.sums.count + (noise > 0) <= N) {
        status = INVCAL_TOO_FEW;
    }
    if (status == INVCAL_OK) {
        tell(&s, position, out);
    }
    return status;
}
