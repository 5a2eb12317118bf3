/* SPDX-License-Identifier: MIT */
#include "invcal/outlier.h"

#include <string.h>

#include "invcal/fisher.h"
#include "vector.h"

#define LEVEL INVCAL_REAL(0.007)      /* false alarms: about one data set in a hundred */
#define RIVAL_LEVEL INVCAL_REAL(0.05) /* nearly as good as the best: not less likely than this */
#define SLACK INVCAL_REAL(1e-4)       /* of det H'H: with less left nothing checks the group */

enum { GROUP = 3 }; /* outliers looked for together: what cannot hide one another */

/* ---- sets of positions as masks ------------------------------------------------------------ */

static invcal_mask bit(unsigned i)
{
    return (invcal_mask)1 << i;
}

static unsigned size_of(invcal_mask set)
{
    unsigned n = 0;

    while (set != 0) { /* at most one step for each bit of the set */
        set &= set - 1;
        n++;
    }
    return n;
}

/* ---- least squares without some positions --------------------------------------------------- */

/* The positions, and the fit of those that are not left out. */
typedef struct {
    const invcal_real *raw;
    unsigned count;
    const invcal_settings *settings;
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]; /* L of its normal equations */
    invcal_real p[INVCAL_PARAMETERS];                     /* their solution */
    invcal_real squares;                                  /* sum of the squared residuals */
    invcal_observation row; /* the last one read: one for all saves stack */
} fit;

static invcal_status read_position(fit *f, unsigned i)
{
    return invcal_observe(&f->settings->nominal, f->settings->field, &f->raw[3 * (size_t)i],
                          &f->row);
}

static invcal_status sum_rows(fit *f, invcal_mask removed, invcal_normal *normal)
{
    invcal_normal_init(normal);
    for (unsigned i = 0; i < f->count; i++) {
        if (!(removed & bit(i))) {
            const invcal_status status = read_position(f, i);
            if (status != INVCAL_OK) {
                return status;
            }
            (void)invcal_normal_add(normal, &f->row, 1);
        }
    }
    return INVCAL_OK;
}

/* j + h p of a position that was read before. */
static invcal_real residual(fit *f, unsigned i)
{
    (void)read_position(f, i);
    return f->row.j + invcal_dot(f->row.h, f->p, INVCAL_PARAMETERS);
}

/* Summed from the residuals: J'J - p'H'Hp cancels. */
static invcal_real sum_squares(fit *f, invcal_mask removed)
{
    invcal_real squares = 0;

    for (unsigned i = 0; i < f->count; i++) {
        if (!(removed & bit(i))) {
            const invcal_real e = residual(f, i);
            squares += e * e;
        }
    }
    return squares;
}

/* From the rows themselves: a downdate would keep the rounding errors of the outlier. */
static invcal_status solve_without(fit *f, invcal_mask removed)
{
    invcal_normal normal;
    const invcal_status status = sum_rows(f, removed, &normal);

    if (status != INVCAL_OK) {
        return status;
    }
    invcal_normal_matrix(&normal, f->l);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        f->p[r] = -normal.htj[r];
    }
    return invcal_cholesky_factor(f->l, INVCAL_PARAMETERS, INVCAL_PIVOT_FLOOR);
}

static invcal_status fit_without(fit *f, invcal_mask removed)
{
    const invcal_status status = solve_without(f, removed);

    if (status == INVCAL_OK) {
        invcal_cholesky_solve(f->l, INVCAL_PARAMETERS, f->p);
        f->squares = sum_squares(f, removed);
    }
    return status;
}

/* Not every singular set shows in a pivot, but some parameter's variance shows it: times the
 * largest elements of H'H, about the count, it is the condition but for a factor of a few. */
static int is_determined(const fit *f)
{
    const invcal_real most = 1 / ((invcal_real)f->count * INVCAL_PIVOT_FLOOR);
    invcal_real variance[INVCAL_PARAMETERS];

    invcal_cholesky_inverse_diagonal(f->l, INVCAL_PARAMETERS, variance);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (!(variance[r] < most)) {
            return 0;
        }
    }
    return 1;
}

static invcal_real squares_without(fit *f, invcal_mask removed)
{
    return fit_without(f, removed) == INVCAL_OK ? f->squares : INVCAL_REAL_MAX;
}

/* h K h' of the row last read, which is lost. */
static invcal_real leverage(fit *f)
{
    invcal_cholesky_forward(f->l, INVCAL_PARAMETERS, f->row.h);
    return invcal_dot(f->row.h, f->row.h, INVCAL_PARAMETERS);
}

/* 1 - h K h' of the positions in the fit. */
static void check_rows(fit *f, invcal_mask removed, invcal_real *checked)
{
    //@ loop unroll INVCAL_OUTLIERS_CAPACITY;
    for (unsigned i = 0; i < f->count; i++) {
        (void)read_position(f, i);
        const invcal_real left = (removed & bit(i)) != 0 ? 0 : 1 - leverage(f);
        checked[i] = left > 0 ? left : 0; /* rounding makes a 0 negative */
    }
}

/* ---- the best group of each size ------------------------------------------------------------ */

/* The best, the second best, and the sums of squares without them. */
typedef struct {
    invcal_mask best;
    invcal_mask rival;
    invcal_real squares;
    invcal_real rival_squares;
} contest;

static void enter(contest *c, invcal_mask group, invcal_real squares)
{
    if (squares < c->squares) {
        c->rival = c->best;
        c->rival_squares = c->squares;
        c->best = group;
        c->squares = squares;
    } else if (squares < c->rival_squares) {
        c->rival = group;
        c->rival_squares = squares;
    } /* cppcheck-suppress misra-c2012-15.7 ; worse than both */
}

/* A group, its last member still moving. Without members 0 ... d - 1, position k has
 *
 *     residual r - sum c_i e_i  and  1 - leverage  m - sum c_i^2,   c_i = -h_k G_i,
 *
 * where r and m are those with all positions (Gram and Schmidt). Leaving it out too takes
 * residual^2 / (1 - leverage), which is e^2, from the squares, and leaves 1 - leverage of
 * det H'H: whatever the order of the members. */
typedef struct {
    uint8_t member[GROUP];
    invcal_real m[GROUP - 1];                    /* 1 - leverage of each, without those before */
    invcal_real e[GROUP - 1];                    /* its residual / sqrt(m), likewise */
    invcal_real G[GROUP - 1][INVCAL_PARAMETERS]; /* K h / sqrt(m), likewise */
} path;

/* Member d stands still from now on. */
static void descend(const fit *f, const invcal_real *c, unsigned d, invcal_real r, invcal_real m,
                    path *p)
{
    const invcal_real root = INVCAL_SQRT(m);
    invcal_real *G = p->G[d];

    memcpy(G, f->row.h, sizeof p->G[d]);
    invcal_cholesky_solve(f->l, INVCAL_PARAMETERS, G);
    for (unsigned n = 0; n < INVCAL_PARAMETERS; n++) {
        for (unsigned i = 0; i < d; i++) {
            G[n] -= c[i] * p->G[i][n];
        }
        G[n] /= root;
    }
    p->m[d] = m;
    p->e[d] = r / root;
}

/* Member d has moved: its group enters the contest of its size. Returns 1 if more members may
 * follow; 0 if the group is complete, or too little would be left to check it. */
static int visit(fit *f, const invcal_real *checked, unsigned d, unsigned size, path *p,
                 contest *contests)
{
    const unsigned k = p->member[d];
    invcal_mask group = bit(k);
    invcal_real squares = f->squares;
    invcal_real left = 1; /* of det H'H */
    invcal_real c[GROUP - 1] = {0};
    invcal_real r = residual(f, k);
    invcal_real m = checked[k];

    for (unsigned i = 0; i < d; i++) {
        c[i] = -invcal_dot(f->row.h, p->G[i], INVCAL_PARAMETERS);
        r -= c[i] * p->e[i];
        m -= c[i] * c[i];
        group |= bit(p->member[i]);
        squares -= p->e[i] * p->e[i];
        left *= p->m[i];
    }
    if (!(left * m > SLACK)) {
        return 0;
    }
    enter(&contests[d + 1], group, squares - r * r / m);
    if (d + 1 < size) {
        descend(f, c, d, r, m, p);
    }
    return d + 1 < size;
}

/* All groups of up to size positions, as an odometer counts: member 0 > member 1 > ... */
static void search(fit *f, const invcal_real *checked, unsigned size, contest *contests)
{
    path p;
    unsigned d = 0;

    memset(&p, 0, sizeof p);
    p.member[0] = (uint8_t)f->count;
    /* at most 2 (C(n,1) + C(n,2) + C(n,3)) steps: 10,976 for n = 32 positions */
    while (d > 0 || p.member[0] > 0) {
        //@ assert d < size; // it rises as visit says, and falls from 1 at least
        //@ split d;
        if (p.member[d] == 0) { /* all tried: the member before moves on */
            d--;
        } else {
            p.member[d]--;
            if (visit(f, checked, d, size, &p, contests)) {
                //@ assert d + 1 < size; // as visit says
                p.member[d + 1] = p.member[d];
                d++;
            }
        }
    }
}

/* ---- how many of them ----------------------------------------------------------------------- */

/* What is known of the noise besides the residuals: the rounding errors of readings and sums, so
 * that exact readings have no outliers, and the noise stated, as one residual more. */
static invcal_real known_squares(const fit *f)
{
    const invcal_real rounding = 8 * INVCAL_EPSILON;
    const invcal_real stated = f->settings->noise / f->settings->field;

    return (invcal_real)f->count * rounding * rounding + stated * stated;
}

static unsigned degrees_of_freedom(const fit *f, invcal_mask removed)
{
    return f->count - size_of(removed) - INVCAL_PARAMETERS + (f->settings->noise > 0);
}

static invcal_real binomial(unsigned n, unsigned k)
{
    invcal_real c = 1;

    for (unsigned i = 1; i <= k; i++) {
        c *= (invcal_real)(n - k + i) / (invcal_real)i;
    }
    return c;
}

typedef enum {
    CHANCE,   /* the best of so many choices owes as much to chance */
    RIVALLED, /* something is wrong, but another group of this size explains it nearly as well */
    CLEAR
} judgement;

/* Is leaving out k more than those removed better than leaving out any fewer? */
static judgement judge_group(const fit *f, invcal_mask removed, const contest *contests, unsigned k)
{
    const invcal_real known = known_squares(f);
    const invcal_real squares = contests[k].squares + known;
    const unsigned n = f->count - size_of(removed);
    const unsigned dof = degrees_of_freedom(f, removed) - k;

    for (unsigned j = 0; j < k; j++) {
        const invcal_real p =
            invcal_fisher_tail(squares / (contests[j].squares + known), k - j, dof);
        if (!(p * binomial(n - j, k - j) <= LEVEL)) {
            return CHANCE;
        }
    }
    return invcal_fisher_tail(squares / (contests[k].rival_squares + known), 1, dof) <= RIVAL_LEVEL
               ? CLEAR
               : RIVALLED;
}

/* Puts the two in order again by fits without them: squares - r^2 / m cancels. */
static contest settle_contest(fit *f, invcal_mask removed, const contest *c)
{
    contest settled = {0, 0, INVCAL_REAL_MAX, INVCAL_REAL_MAX};

    enter(&settled, c->best, squares_without(f, removed | c->best));
    enter(&settled, c->rival, squares_without(f, removed | c->rival));
    return settled;
}

/* The best groups of 1 ... size beside those removed. The fit is lost. */
static void compete(fit *f, invcal_mask removed, unsigned size, invcal_real *checked,
                    contest *contests)
{
    const contest none = {0, 0, INVCAL_REAL_MAX, INVCAL_REAL_MAX};

    for (unsigned k = 0; k <= size; k++) {
        contests[k] = none;
    }
    contests[0].squares = f->squares;
    check_rows(f, removed, checked);
    if (size > 0) {
        search(f, checked, size, contests);
    }
    for (unsigned k = 1; k <= size; k++) {
        contests[k] = settle_contest(f, removed, &contests[k]);
    }
}

/* The largest group beside those removed that is clear, or 0. suspected: the two of the largest
 * contest without a clear winner, or 0. The fit is lost. */
static invcal_mask find_group(fit *f, invcal_mask removed, invcal_real *checked,
                              invcal_mask *suspected)
{
    const unsigned out = size_of(removed);
    const unsigned spare = degrees_of_freedom(f, removed) - 2; /* one alone tells nothing */
    const unsigned room = INVCAL_OUTLIERS_MOST - out;
    contest contests[GROUP + 1];
    unsigned size = spare < room ? spare : room;

    size = size < GROUP ? size : GROUP;
    //@ split size;
    compete(f, removed, size, checked, contests);
    for (*suspected = 0; size > 0; size--) { /* at most GROUP steps */
        const judgement found = judge_group(f, removed, contests, size);
        if (found == CLEAR) {
            break;
        }
        if (found == RIVALLED && !*suspected) {
            *suspected = contests[size].best | contests[size].rival;
        }
    }
    return contests[size].best;
}

/* ---- the report ----------------------------------------------------------------------------- */

/* What find_group has not written. With e and K of the fit without the outliers
 *
 *     w = e / (sigma sqrt(1 + h K h')),
 *
 * the same number as Baarda's residual / (sigma sqrt(1 - h K h')) of the fit with this one. */
static void report(fit *f, invcal_mask removed, invcal_outliers *out)
{
    const invcal_real squares = f->squares + known_squares(f);

    out->removed = removed;
    out->count = 0;
    out->sigma = INVCAL_SQRT(squares / (invcal_real)degrees_of_freedom(f, removed));
    for (unsigned i = 0; i < f->count; i++) {
        if ((removed & bit(i)) != 0) {
            const invcal_real e = residual(f, i);
            //@ assert out->count < INVCAL_OUTLIERS_MOST; // find_group leaves room for no more
            out->position[out->count] = i;
            out->error[out->count] = e;
            out->w[out->count] = e / (out->sigma * INVCAL_SQRT(1 + leverage(f)));
            out->count++;
        }
    }
}

invcal_status invcal_outliers_find(const invcal_real *raw, unsigned count,
                                   const invcal_settings *settings, invcal_outliers *out)
{
    invcal_mask removed = 0;
    invcal_mask found;
    fit f;

    INVCAL_ASSERT((raw || count == 0) && settings && out);
    if (count > INVCAL_OUTLIERS_CAPACITY || invcal_settings_check(settings) != INVCAL_OK) {
        return INVCAL_BAD_SETTING;
    }
    if (count < INVCAL_OUTLIERS_FEWEST) {
        return INVCAL_TOO_FEW;
    }
    f.raw = raw;
    f.count = count;
    f.settings = settings;
    const invcal_status status = fit_without(&f, 0);
    if (status != INVCAL_OK) {
        return status;
    }
    if (!is_determined(&f)) {
        return INVCAL_UNDETERMINED;
    }
    /* group by group: the largest may hide the next. Nothing fails from here on. As each takes one
     * or more, there are at most INVCAL_OUTLIERS_MOST + 1 steps. */
    do {
        found = find_group(&f, removed, out->checked, &out->suspected);
        removed |= found;
        (void)fit_without(&f, removed); /* solvable: it was solved to judge the group */
    } while (found != 0);
    report(&f, removed, out);
    return INVCAL_OK;
}
