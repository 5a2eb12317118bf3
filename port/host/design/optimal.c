/* SPDX-License-Identifier: MIT */
#include "design/optimal.h"

#include <math.h>
#include <string.h>

#include "design/covariance.h"
#include "design/stand_plan.h"

enum { P = INVCAL_PARAMETERS };

#define STARTS 16u      /* descents; the best is taken */
#define STARTS_LARGE 6u /* from LARGE positions on, since local optima are nearly equal there */
#define LARGE 20u
#define STEPS_MAX 300u /* of a descent */
#define MEMORY 8u      /* of L-BFGS: stored steps */
#define DECREASE_MIN 1e-11
#define HALVINGS 50u
#define REACHED 1.0002 /* times the lower bound: the highest power ends at 1.00014 times it */

/* n unit vectors, or as many gradients. */
typedef double vectors[OPTIMAL_MAX][3];

/* The function to minimise: with limits, the norm of the squared ratios K(r,r) / limit^2, in which
 * the largest dominates more, the higher the power; without, -ln det H'H. */
typedef struct {
    unsigned n;
    unsigned fixed;       /* the first `fixed` vectors stay: the axes, or none */
    const double *limits; /* of delta, dk, gamma, or null */
    double power;
} problem;

static double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalise(double v[3])
{
    const double length = sqrt(dot3(v, v));

    for (unsigned i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

/* ---- the function and its gradient ------------------------------------------------------------ */

/* The squared ratios, and the largest. */
static double ratios(const problem *p, double K[P][P], double t[P])
{
    double largest = 0;

    for (unsigned r = 0; r < P; r++) {
        t[r] = K[r][r] / (p->limits[r / 3] * p->limits[r / 3]);
        largest = fmax(largest, t[r]);
    }
    return largest;
}

/* ln of the norm, and M = K W K, where W are its derivatives by K(r,r): a change dh of a row h
 * changes the logarithm by -2 h'M dh. */
static double norm(const problem *p, double K[P][P], double M[P][P])
{
    double t[P];
    double w[P];
    double sum = 0;
    const double largest = ratios(p, K, t);

    for (unsigned r = 0; r < P; r++) {
        sum += pow(t[r] / largest, p->power);
    }
    for (unsigned r = 0; r < P; r++) {
        const double limit = p->limits[r / 3];
        w[r] = pow(t[r] / largest, p->power - 1) / (sum * largest * limit * limit);
    }
    for (unsigned r = 0; r < P; r++) {
        for (unsigned c = 0; c < P; c++) {
            M[r][c] = 0;
            for (unsigned k = 0; k < P; k++) {
                M[r][c] += K[r][k] * w[k] * K[k][c];
            }
        }
    }
    return log(largest) + log(sum) / p->power;
}

/* -2 h'M dh/da, projected on the tangent plane of the sphere. */
static void row_gradient(double M[P][P], const double a[3], double g[3])
{
    double h[P];
    double b[P] = {0};

    covariance_row(a, h);
    for (unsigned r = 0; r < P; r++) {
        for (unsigned c = 0; c < P; c++) {
            b[r] -= 2 * M[r][c] * h[c];
        }
    }
    g[0] = b[0] + 2 * a[0] * b[3] + a[1] * b[6] + a[2] * b[7];
    g[1] = b[1] + 2 * a[1] * b[4] + a[0] * b[6] + a[2] * b[8];
    g[2] = b[2] + 2 * a[2] * b[5] + a[0] * b[7] + a[1] * b[8];
    const double outward = dot3(g, a);
    for (unsigned i = 0; i < 3; i++) {
        g[i] -= outward * a[i];
    }
}

/* For ln det, M is K itself. */
static double evaluate(const problem *p, vectors x, vectors gradient)
{
    double K[P][P];
    double M[P][P];
    const double log_det = covariance_find((const double(*)[3])x, NULL, p->n, K);
    const double f = p->limits ? norm(p, K, M) : -log_det;

    memset(gradient, 0, sizeof(vectors));
    for (unsigned i = p->fixed; i < p->n; i++) {
        row_gradient(p->limits ? M : K, x[i], gradient[i]);
    }
    return f;
}

/* ---- descent: L-BFGS on the product of spheres ------------------------------------------------- */

typedef struct {
    vectors s[MEMORY]; /* steps, */
    vectors y[MEMORY]; /* and the changes of the gradient */
    double sy[MEMORY];
    unsigned count; /* steps so far; the last MEMORY are stored */
} memory;

static double dot(const problem *p, vectors a, vectors b)
{
    double sum = 0;

    for (unsigned i = 0; i < p->n; i++) {
        sum += dot3(a[i], b[i]);
    }
    return sum;
}

/* a += factor b. */
static void add(const problem *p, vectors a, double factor, vectors b)
{
    for (unsigned i = 0; i < p->n; i++) {
        for (unsigned k = 0; k < 3; k++) {
            a[i][k] += factor * b[i][k];
        }
    }
}

/* The search direction d = -(inverse Hessian) gradient, by Nocedal's two-loop recursion. */
static void find_direction(const problem *p, memory *m, vectors gradient, vectors d)
{
    const unsigned kept = m->count < MEMORY ? m->count : MEMORY;
    double alpha[MEMORY];

    memcpy(d, gradient, sizeof(vectors));
    for (unsigned j = 0; j < kept; j++) {
        const unsigned at = (m->count - 1 - j) % MEMORY;
        alpha[at] = dot(p, m->s[at], d) / m->sy[at];
        add(p, d, -alpha[at], m->y[at]);
    }
    double scale = 0.1 / sqrt(dot(p, gradient, gradient) + 1e-300);
    if (kept > 0) {
        const unsigned last = (m->count - 1) % MEMORY;
        scale = m->sy[last] / dot(p, m->y[last], m->y[last]);
    }
    for (unsigned i = 0; i < 3 * p->n; i++) {
        d[i / 3][i % 3] *= scale;
    }
    for (unsigned j = kept; j-- > 0;) {
        const unsigned at = (m->count - 1 - j) % MEMORY;
        add(p, d, alpha[at] - dot(p, m->y[at], d) / m->sy[at], m->s[at]);
    }
    for (unsigned i = 0; i < 3 * p->n; i++) {
        d[i / 3][i % 3] = -d[i / 3][i % 3];
    }
}

/* Stores the step from one point to another, if the curvature along it is positive. */
static void store_step(const problem *p, memory *m, vectors from, vectors g_from, vectors to,
                       vectors g_to)
{
    const unsigned at = m->count % MEMORY;

    memcpy(m->s[at], to, sizeof(vectors));
    add(p, m->s[at], -1, from);
    memcpy(m->y[at], g_to, sizeof(vectors));
    add(p, m->y[at], -1, g_from);
    m->sy[at] = dot(p, m->s[at], m->y[at]);
    if (m->sy[at] > 1e-12 * dot(p, m->y[at], m->y[at])) {
        m->count++;
    }
}

/* One step with backtracking. Returns the decrease; 0 if no step decreases f. */
static double descend(const problem *p, memory *m, vectors x, vectors gradient, double f)
{
    vectors d;
    vectors next;
    vectors next_gradient;

    find_direction(p, m, gradient, d);
    double slope = dot(p, d, gradient);
    if (!(slope < 0)) {
        m->count = 0;
        find_direction(p, m, gradient, d);
        slope = dot(p, d, gradient);
    }
    for (double length = 1; length > 1e-6; length /= 2) {
        memcpy(next, x, sizeof next);
        add(p, next, length, d);
        for (unsigned i = 0; i < p->n; i++) {
            normalise(next[i]);
        }
        const double f_next = evaluate(p, next, next_gradient);
        if (f_next <= f + 1e-4 * length * slope) {
            store_step(p, m, x, gradient, next, next_gradient);
            memcpy(x, next, sizeof next);
            memcpy(gradient, next_gradient, sizeof next_gradient);
            return f - f_next;
        }
    }
    return 0;
}

/* Returns the minimum. */
static double minimise(const problem *p, vectors x)
{
    memory m = {.count = 0};
    vectors gradient = {{0}};
    double f = evaluate(p, x, gradient);
    unsigned idle = 0;

    for (unsigned step = 0; step < STEPS_MAX && idle < 3; step++) {
        const double decrease = descend(p, &m, x, gradient, f);
        f -= decrease;
        idle = decrease > DECREASE_MIN ? 0 : idle + 1;
    }
    return f;
}

/* ---- starting points --------------------------------------------------------------------------- */

/* A spiral from pole to pole: nearly equidistant directions. */
static void spiral(unsigned n, vectors x)
{
    for (unsigned i = 0; i < n; i++) {
        const double z = 1 - (2 * i + 1.0) / n;
        const double r = sqrt(1 - z * z);
        const double turn = 2.399963229728653 * i; /* the golden angle */
        const double a[3] = {r * cos(turn), r * sin(turn), z};
        memcpy(x[i], a, sizeof a);
    }
}

/* Random directions, another set for each seed; a linear congruential generator will do. */
static void scatter(unsigned n, unsigned seed, vectors x)
{
    unsigned long state = seed;

    for (unsigned i = 0; i < n; i++) {
        for (unsigned k = 0; k < 3; k++) {
            state = (state * 1103515245ul + 12345ul) & 0x7ffffffful;
            x[i][k] = (double)state / 0x40000000 - 1;
        }
        normalise(x[i]);
    }
}

/* The paper's program of the same size, so that the result is never worse. */
static void stand_program(unsigned n, vectors x)
{
    const invcal_plan plan = stand_plan_make(n / INVCAL_PLAN_GROUPS);

    for (unsigned i = 0; i < n; i++) {
        const invcal_plan_position position = stand_plan_at(&plan, i);
        memcpy(x[i], position.up, sizeof position.up);
    }
}

static void put_axes(vectors x)
{
    memset(x, 0, OPTIMAL_AXES * sizeof x[0]);
    for (unsigned i = 0; i < OPTIMAL_AXES; i++) {
        x[i][i / 2] = i % 2 == 0 ? 1 : -1;
    }
}

static void begin(const problem *p, unsigned start, vectors x)
{
    const unsigned n = p->n;
    const int is_program =
        n % INVCAL_PLAN_GROUPS == 0 && n >= INVCAL_PLAN_GROUPS * INVCAL_PLAN_PER_GROUP_MIN;

    if (start == 0) {
        spiral(n - p->fixed, x + p->fixed);
    } else if (start == 1 && is_program && p->fixed == 0) {
        stand_program(n, x);
    } else {
        scatter(n - p->fixed, start, x + p->fixed);
    }
    if (p->fixed > 0) {
        put_axes(x);
    }
}

static unsigned starts(unsigned n)
{
    return n < LARGE ? STARTS : STARTS_LARGE;
}

/* ---- the result -------------------------------------------------------------------------------- */

/* Rotates the set so that its first direction is +z and its second is in the xz plane, x > 0. */
static void rotate(unsigned n, vectors x)
{
    double axis[3][3]; /* x, y, z of the new frame */

    memcpy(axis[2], x[0], sizeof axis[2]);
    for (unsigned i = 0; i < 3; i++) {
        axis[0][i] = x[1][i] - dot3(x[0], x[1]) * x[0][i];
    }
    normalise(axis[0]);
    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = (i + 1) % 3;
        const unsigned k = (i + 2) % 3;
        axis[1][i] = axis[2][j] * axis[0][k] - axis[2][k] * axis[0][j];
    }
    for (unsigned m = 0; m < n; m++) {
        double v[3];
        for (unsigned i = 0; i < 3; i++) {
            v[i] = dot3(axis[i], x[m]);
        }
        normalise(v);
        memcpy(x[m], v, sizeof v);
    }
}

/* A short path: from the direction nearest to +z, always to the nearest one of the rest. */
static void order_by_nearest(unsigned n, vectors x, double (*direction)[3])
{
    double last[3] = {0, 0, 1};

    for (unsigned m = 0; m < n; m++) {
        unsigned nearest = 0;
        for (unsigned i = 1; i < n - m; i++) {
            /* rounding does not decide */
            nearest = dot3(last, x[i]) > dot3(last, x[nearest]) + 1e-6 ? i : nearest;
        }
        memcpy(last, x[nearest], sizeof last);
        memcpy(direction[m], last, sizeof last);
        memcpy(x[nearest], x[n - m - 1], sizeof last);
    }
}

void optimal_directions(unsigned n, int with_axes, double (*direction)[3])
{
    const problem p = {.n = n, .fixed = with_axes ? OPTIMAL_AXES : 0};
    vectors best = {{0}};
    vectors x = {{0}};
    double min = HUGE_VAL;

    for (unsigned start = 0; start < starts(n); start++) {
        begin(&p, start, x);
        const double f = minimise(&p, x);
        if (f < min - 1e-9) {
            min = f;
            memcpy(best, x, sizeof best);
        }
    }
    if (!with_axes) {
        rotate(n, best);
    }
    order_by_nearest(n, best, direction);
}

/* The largest sigma / limit. */
static double worst_ratio(const problem *p, vectors x)
{
    double K[P][P];
    double t[P];

    (void)covariance_find((const double(*)[3])x, NULL, p->n, K);
    return sqrt(ratios(p, K, t));
}

/* A lower bound of worst_ratio. H'H averaged over the 48 symmetries of the cube meets the same
 * limits (K is convex in H'H), and with <x^2> = 1/3, b = <x^2 y^2>, <x^4> = 1/3 - 2 b it has n K =
 * 3 for offsets, 3 (1/3 - b) / (1/3 - 3 b) for scale errors, 1 / b for angles. The second rises
 * with b, the third falls: the optimum is where they are equal. */
static double ratio_bound(unsigned n, const double limits[3])
{
    double low = 0;
    double high = 1.0 / 9;
    double scale = 0;

    for (unsigned i = 0; i < HALVINGS; i++) {
        const double b = (low + high) / 2;
        const double angle = sqrt(1 / b) / limits[2];
        scale = sqrt(3 * (1 - 3 * b) / (1 - 9 * b)) / limits[1];
        *(scale < angle ? &low : &high) = b;
    }
    return fmax(sqrt(3) / limits[0], scale) / sqrt(n);
}

double optimal_within(unsigned n, const double limits[3], int with_axes, double (*direction)[3])
{
    static const double powers[] = {1, 3, 10, 40, 200, 1000};
    vectors best = {{0}};
    vectors x = {{0}};
    const double enough = REACHED * ratio_bound(n, limits);
    double min = HUGE_VAL;

    for (unsigned start = 0; start < starts(n) && min > enough; start++) {
        problem p = {n, with_axes ? OPTIMAL_AXES : 0, limits, powers[0]};
        begin(&p, start, x);
        for (unsigned k = 0; k < sizeof powers / sizeof powers[0]; k++) {
            p.power = powers[k];
            (void)minimise(&p, x);
            const double worst = worst_ratio(&p, x);
            if (k == 0 && worst > 2 * min) {
                break; /* too far from the best so far */
            }
            if (worst < min * (1 - 1e-9)) {
                min = worst;
                memcpy(best, x, sizeof best);
            }
        }
    }
    order_by_nearest(n, best, direction);
    return min;
}
