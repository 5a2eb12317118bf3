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
    invcal_sums sums;            /* their number; L^-1 of their normal equations, and p behind it */
    unsigned dof;                /* degrees of freedom of the squares */
    contest contests[GROUP + 1]; /* of groups of 0 ... GROUP */
} search;

static invcal_mask bit(unsigned i)
{
    return (invcal_mask)1 << i;
}

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

/* y = L^-1 h of position k, so that h K h' = |y|^2. Returns its residual J + h p. */
static INVCAL_INLINE invcal_real whiten(const search *s, unsigned k, invcal_real y[N])
{
    const invcal_real *row = &s->sums.sum[INVCAL_PACKED(N, 0)]; /* p; then the rows of L^-1 */
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

/* What is known of the noise besides the residuals: the rounding errors of readings and sums, so
 * that exact readings have no outliers, and the noise stated, as one residual more. */
static invcal_real known_squares(const invcal_positions *p)
{
    const invcal_real rounding = 8 * INVCAL_EPSILON;

    return (invcal_real)p->count * rounding * rounding + p->noise * p->noise;
}

/* Sums, solution, squares: of the rows themselves, for a downdate would keep the rounding errors of
 * an outlier; and of the residuals, for J'J - p'H'Hp cancels. */
static INVCAL_APART invcal_status fit(search *s)
{
    invcal_real squares = known_squares(&s->positions);
    invcal_real condition;
    invcal_real y[N];

    invcal_status status = invcal_positions_sum(&s->positions, &s->sums);
    if (status == INVCAL_OK) {
        invcal_sums_system(&s->sums);
        status = invcal_determine(s->sums.sum, N + 1, y, &condition); /* p and L^-1 */
    }
    if (status != INVCAL_OK) {
        return status;
    }
    for (unsigned k = 0; k < s->positions.count; k++) {
        if (!(s->positions.left_out >> k & 1u)) {
            const invcal_real r = whiten(s, k, y);
            squares += r * r;
        }
    }
    s->dof = s->sums.count - N + (s->positions.noise > 0);
    const contest nobody = {s->positions.left_out, s->positions.left_out, squares, squares};
    for (unsigned k = 0; k <= GROUP; k++) {
        s->contests[k] = nobody;
    }
    return INVCAL_OK;
}

/* ---- the best group of each size ------------------------------------------------------------ */

/* A position among those that are not left out, at first
 *
 *     y = L^-1 h,   r = J + h p,   m = 1 - h K h' = 1 - |y|^2.
 *
 * Leaving it out takes r^2 / m from the squares, and leaves m of det H'H. After position i has been
 * left out, there are (M = I - H K H'; Gram and Schmidt)
 *
 *     y + c y(i),   r + c r(i),   m - c^2 m(i),   c = -M(k,i) / m(i) = y y(i) / m(i). */
typedef struct {
    invcal_real y[N];
    invcal_real r;
    invcal_real m;
} member;

/* A group, its last member still moving. */
typedef struct {
    member fixed[GROUP - 1];
    unsigned char next[GROUP]; /* one more than what each member tries next */
    invcal_mask out;           /* the fixed members, and what was left out before */
} group;

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

/* May another member follow? One that is alone always takes another; two do if they leave no more of
 * the squares than (n - 9) / n: clear groups of three have such a pair, 99 of 100 of them, but only one
 * in ten pairs of a good set is such a one. */
static int is_promising(const search *s, unsigned members, invcal_real squares)
{
    const unsigned n = s->sums.count;

    return members == 1 ||
           (invcal_real)n * squares <= (invcal_real)(n - N) * s->contests[0].squares;
}

/* Position k as member d: the group enters the contest of its size. Returns 1 if k is fixed now, as
 * another may follow. */
static INVCAL_INLINE int visit(search *s, group *g, unsigned size, unsigned d, unsigned k)
{
    invcal_real squares = s->contests[0].squares;
    const invcal_real min = ROUNDED * squares;
    invcal_real left = 1;
    invcal_real c = 0;
    member x;

    x.r = whiten(s, k, x.y);
    x.m = 1 - dot(x.y, x.y, N);
    for (unsigned i = 0; i < d; i++) {
        const member *const f = &g->fixed[i];
        //@ assert \initialized(f); // d of them have been fixed
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
    enter(&s->contests[d + 1], g->out | bit(k), squares > min ? squares : min);
    if (d + 1 >= size || !is_promising(s, d + 1, squares)) {
        return 0;
    }
    if (d > 0) {
        INVCAL_UNROLL_ROWS
        for (unsigned n = 0; n < N; n++) {
            x.y[n] += c * g->fixed[0].y[n];
        }
    }
    g->fixed[d] = x;
    return 1;
}

/* All groups of one and two, and those of three with a promising pair. As an odometer counts:
 * member 0 > member 1, and member 2 any other. */
static INVCAL_APART void search_groups(search *s, unsigned size)
{
    group g;
    unsigned d = 0;

    g.out = s->positions.left_out;
    g.next[0] = (unsigned char)s->positions.count;
    while (d > 0 || g.next[0] > 0) { /* at most two steps for each group */
        if (g.next[d] == 0) {        /* all tried: the member before moves on */
            d--;
            //@ split d;
            g.out ^= bit(g.next[d]);
        } else {
            const unsigned k = --g.next[d];
            if (!(g.out >> k & 1u) && visit(s, &g, size, d, k)) {
                g.out |= bit(k);
                d++;
                //@ split d;
                g.next[d] = (unsigned char)(d == 1 ? k : s->positions.count);
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
    const invcal_real t = (invcal_real)dof * (1 - z) / 2;
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
        choices *= (invcal_real)(s->sums.count - j) / (invcal_real)(k - j);
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
    invcal_real y[N];
    const invcal_real r = whiten(s, k, y);
    const invcal_real leverage = dot(y, y, N);
    const int is_removed = (s->positions.left_out & bit(k)) != 0;
    const invcal_real m = is_removed ? 1 : 1 - leverage;

    out->sigma = INVCAL_SQRT(s->contests[0].squares / (invcal_real)s->dof);
    out->checked = is_removed || m < 0 ? 0 : m;
    out->error = 0;
    out->w = 0;
    if (m > SLACK) {
        out->error = r / m;
        out->w = out->error / (out->sigma * INVCAL_SQRT(is_removed ? 1 + leverage : 1 / m));
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
