/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "fisher.h"
#include "judge.h"
#include "sums.h"
#include "vector.h"

#define LEVEL INVCAL_REAL(0.007)      /* false alarms: about one data set in a hundred */
#define RIVAL_LEVEL INVCAL_REAL(0.05) /* nearly as good as the best: not less likely than this */
#define SLACK INVCAL_REAL(1e-4)       /* of det H'H: with less left nothing checks the group */

/* A sum of squares is what others have been taken from: less of it than this is rounding. */
#define CANCELLED (256 * INVCAL_EPSILON)

enum {
    GROUP = 3, /* outliers looked for together: what cannot hide one another */
    N = INVCAL_PARAMETERS
};

/* Groups of one size: what the best and the second best leave of the sum of squares. */
typedef struct {
    invcal_mask best; /* these are left out; those that were before as well */
    invcal_mask rival;
    invcal_real squares;
    invcal_real rival_squares;
} contest;

/* The fit of the positions that are not left out, and the search among them. */
typedef struct {
    invcal_positions positions;
    unsigned dof;
    invcal_sums sums;            /* L^-1 of their normal equations, and p behind it */
    contest contests[GROUP + 1]; /* of groups of 0 ... GROUP */
} search;

/* ---- the fit ---------------------------------------------------------------------------------- */

static INVCAL_INLINE invcal_real dot(const invcal_real *a, const invcal_real *b, unsigned n)
{
    invcal_real sum = a[0] * b[0];

    INVCAL_UNROLL_ROWS
    for (unsigned i = 1; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

/* y = L^-1 h of position k: h K h' is then |y|^2. Returns its residual J + h p. */
static INVCAL_INLINE invcal_real whiten(const search *s, unsigned k, invcal_real y[N])
{
    const invcal_real *row = &s->sums.sum[INVCAL_PACKED(N, 0)]; /* p, then those of L^-1 */
    const invcal_real *raw = &s->positions.raw[3 * (size_t)k];

#ifdef INVCAL_FAST
    invcal_correct(s->positions.nominal, raw, y);
    invcal_row_inline(y, y);
#else
    invcal_apply(s->positions.nominal, raw, y);
    invcal_row_of(y, y);
#endif
    const invcal_real j = (y[INVCAL_DK_X] + y[INVCAL_DK_Y] + y[INVCAL_DK_Z] - 1) / 2;
    const invcal_real residual = j + dot(row, y, N);
    INVCAL_UNROLL_ROWS
    for (unsigned r = N; r > 0; r--) {
        row -= r;
        y[r - 1] = dot(row, y, r);
    }
    return residual;
}

/* The sums to p and L^-1. */
static invcal_status determine(invcal_sums *sums)
{
    invcal_real *a = sums->sum;

    invcal_sums_system(sums);
    const invcal_real trace = invcal_trace(a, N);
    const invcal_status status = invcal_factor(a, N, N + 1, INVCAL_FLOOR);
    if (status != INVCAL_OK) {
        return status;
    }
    invcal_back_substitute(a, N);
    invcal_invert(a, N);
    return invcal_is_resolved(invcal_condition(a, N, trace)) ? INVCAL_OK : INVCAL_UNDETERMINED;
}

/* What is known of the noise besides the residuals: the rounding errors of readings and sums, so
 * that exact readings have no outliers, and the noise stated, as one residual more. */
static invcal_real known_squares(const invcal_positions *p)
{
    const invcal_real rounding = 8 * INVCAL_EPSILON;

    return (invcal_real)p->count * rounding * rounding + p->noise * p->noise;
}

/* From the rows themselves: a downdate would keep the rounding errors of the outlier. The squares
 * are summed from the residuals: J'J - p'H'Hp cancels. */
static INVCAL_APART invcal_status fit(search *s)
{
    contest *const none = &s->contests[0];
    invcal_real y[N];
    invcal_status status = invcal_positions_sum(&s->positions, &s->sums);

    if (status == INVCAL_OK) {
        s->dof = s->sums.count - N + (s->positions.noise > 0);
        status = determine(&s->sums);
    }
    none->best = none->rival = s->positions.left_out;
    none->squares = known_squares(&s->positions);
    for (unsigned k = 0; k < s->positions.count; k++) {
        if (status == INVCAL_OK && !(none->best >> k & 1u)) {
            const invcal_real r = whiten(s, k, y);
            none->squares += r * r;
        }
    }
    none->rival_squares = none->squares;
    return status;
}

/* ---- the best group of each size ------------------------------------------------------------ */

/* A position, some others left out. Without any of them
 *
 *     r = J + h p,   m = 1 - h K h' = 1 - |y|^2,
 *
 * and leaving out i takes (M = I - H K H', Gram and Schmidt)
 *
 *     c r(i) from r,   c^2 m(i) from m,   c = M(k,i) / m(i) = -y y(i) / m(i).
 *
 * Leaving out this one too takes r^2 / m from the squares, and leaves m of det H'H: whatever the order
 * of the members. */
typedef struct {
    invcal_real y[N];
    invcal_real r;
    invcal_real m;
} member;

/* A group, its last member still moving. */
typedef struct {
    member fixed[GROUP - 1];
    unsigned char next[GROUP]; /* 1 + the position that each member tries next */
    invcal_mask out;           /* the fixed members, and what was left out before */
} group;

static void enter(contest *c, invcal_mask out, invcal_real squares)
{
    if (squares < c->squares && out != c->best) {
        c->rival = c->best;
        c->rival_squares = c->squares;
        c->best = out;
        c->squares = squares;
    } else if (squares < c->rival_squares && out != c->best) {
        c->rival = out;
        c->rival_squares = squares;
    } /* cppcheck-suppress misra-c2012-15.7 ; worse than both, or here already */
}

/* Is a group worth another member? A single one always, a pair if it explains its share. */
static int is_promising(const search *s, unsigned members, invcal_real squares)
{
    const invcal_real share = (invcal_real)(s->sums.count - N) / (invcal_real)s->sums.count;

    return members == 1 || squares <= share * s->contests[0].squares;
}

/* Position k as member d: its group enters the contest of its size. Returns 1 if it is fixed, and one
 * more may follow. */
static INVCAL_INLINE int visit(search *s, group *g, unsigned size, unsigned d, unsigned k)
{
    invcal_real squares = s->contests[0].squares;
    const invcal_real floor = CANCELLED * squares;
    invcal_real left = 1;
    invcal_real c = 0;
    member x;

    x.r = whiten(s, k, x.y);
    x.m = 1 - dot(x.y, x.y, N);
    for (unsigned i = 0; i < d; i++) {
        const member *const f = &g->fixed[i];
        c = dot(x.y, f->y, N) / f->m;
        x.r += c * f->r;
        x.m -= c * c * f->m;
        left *= f->m;
        squares -= f->r * f->r / f->m;
    }
    if (!(left * x.m > SLACK)) {
        return 0;
    }
    squares -= x.r * x.r / x.m;
    enter(&s->contests[d + 1], g->out | (invcal_mask)1 << k, squares > floor ? squares : floor);
    if (d + 1 >= size || !is_promising(s, d + 1, squares)) {
        return 0;
    }
    for (unsigned n = 0; n < N && d > 0; n++) {
        x.y[n] += c * g->fixed[0].y[n];
    }
    g->fixed[d] = x;
    return 1;
}

/* All groups of one and two positions, and of three that a promising pair is in. As an odometer
 * counts: member 0 > member 1, and member 2 any other. */
static INVCAL_APART void run(search *s, unsigned size)
{
    group g;
    unsigned d = 0;

    for (unsigned k = 1; k <= size; k++) {
        s->contests[k] = s->contests[0];
    }
    g.out = s->positions.left_out;
    g.next[0] = (unsigned char)s->positions.count;
    while (d > 0 || g.next[0] > 0) {
        if (g.next[d] == 0) { /* all tried: the member before moves on */
            d--;
            g.out ^= (invcal_mask)1 << g.next[d];
        } else {
            const unsigned k = --g.next[d];
            if (!(g.out >> k & 1u) && visit(s, &g, size, d, k)) {
                g.out |= (invcal_mask)1 << k;
                d++;
                g.next[d] = (unsigned char)(d == 1 ? k : s->positions.count);
            }
        }
    }
}

/* ---- how many of them ----------------------------------------------------------------------- */

/* Is leaving out k better than leaving out any fewer, and not by chance, of so many choices? */
static int beats_fewer(const search *s, unsigned k)
{
    const unsigned dof = s->dof - k;
    invcal_real choices = 1;

    for (unsigned j = k; j-- > 0;) {
        const invcal_real z = s->contests[k].squares / s->contests[j].squares;
        choices *= (invcal_real)(s->sums.count - j) / (invcal_real)(k - j);
        if (!(invcal_fisher_tail(z, k - j, dof) * choices <= LEVEL)) {
            return 0;
        }
    }
    return 1;
}

static int is_clear(const search *s, unsigned k)
{
    const contest *const c = &s->contests[k];

    return invcal_fisher_tail(c->squares / c->rival_squares, 1, s->dof - k) <=
           RIVAL_LEVEL;
}

/* The size of the largest group that is clear, or 0. suspected: the two of the largest contest without
 * a clear winner, or 0. */
static INVCAL_APART unsigned judge(const search *s, unsigned size, invcal_mask *suspected)
{
    *suspected = 0;
    for (unsigned k = size; k > 0; k--) {
        if (beats_fewer(s, k)) {
            if (is_clear(s, k)) {
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

static invcal_status start(search *s, const invcal_real *raw, unsigned count, const invcal_calibration *nominal, invcal_real noise)
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
    do {
        const unsigned size = largest_group(&s);
        run(&s, size);
        found = judge(&s, size, &suspected);
        out->removed = s.positions.left_out;
        s.positions.left_out = s.contests[found].best;
    } while (found > 0 && fit(&s) == INVCAL_OK);
    out->suspected = suspected;
    return INVCAL_OK;
}
