/* SPDX-License-Identifier: MIT */
#include "optimal.h"

#include <math.h>
#include <string.h>

#include "command.h"
#include "invcal/criteria.h"
#include "invcal/plan.h"

enum { P = INVCAL_PARAMETERS, SUMS = INVCAL_PACKED_SIZE(INVCAL_PARAMETERS) };

#define STARTS 12u  /* local searches; the best is taken */
#define SWEEPS 400u /* at most, over all positions */
#define ASCENT 40u  /* steps of one position, at most */
#define RIDGE 1e-9  /* keeps what n - 1 < 9 positions leave open finite */
#define SETTLED 1e-9
#define PATIENCE 5u /* rounds of weights that bring nothing */
#define MATCH 1e-3

typedef struct {
    unsigned n;
    const double *weight; /* of the nine K(r,r); null: D-optimal */
    double direction[OPTIMAL_MAX][3];
} search;

/* What a direction of row h would add: h'top h / (bottom + h'K h), with K the covariance of the
 * other positions. D-optimal: h'K h, by which det H'H grows; A-optimal: the decrease of
 * trace(W K), which is h'K W K h / (1 + h'K h). */
typedef struct {
    double top[P][P];
    double K[P][P];
    int is_trace; /* A-optimal */
} prospect;

static void row(const double a[3], double h[P])
{
    const double values[P] = {a[0],        a[1],        a[2],        a[0] * a[0], a[1] * a[1],
                              a[2] * a[2], a[0] * a[1], a[0] * a[2], a[1] * a[2]};

    memcpy(h, values, sizeof values);
}

static void normalise(double v[3])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

    for (unsigned i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

/* K = (H'H)^-1 of all positions but `without` (n: of all). Returns log det H'H. */
static double covariance(const search *s, unsigned without, double K[P][P])
{
    double a[SUMS] = {0};
    double h[P];
    double log_det = 0;

    for (unsigned i = 0; i < s->n; i++) {
        row(s->direction[i], h);
        for (unsigned r = 0; r < P && i != without; r++) {
            for (unsigned c = 0; c <= r; c++) {
                a[INVCAL_PACKED(r, c)] += h[r] * h[c];
            }
        }
    }
    for (unsigned r = 0; r < P; r++) {
        a[INVCAL_PACKED(r, r)] += RIDGE;
    }
    if (invcal_cholesky_factor(a, P, 0) != INVCAL_OK) {
        return -HUGE_VAL;
    }
    for (unsigned r = 0; r < P; r++) {
        log_det += 2 * log(a[INVCAL_PACKED(r, r)]);
    }
    invcal_cholesky_inverse(a, P);
    for (unsigned r = 0; r < P; r++) {
        for (unsigned c = 0; c <= r; c++) {
            K[r][c] = K[c][r] = a[INVCAL_PACKED(r, c)];
        }
    }
    return log_det;
}

/* What is to become large: log det H'H, or minus trace(W K) and so its negative logarithm. */
static double merit(const search *s)
{
    double K[P][P];
    double trace = 0;
    const double log_det = covariance(s, s->n, K);

    if (!s->weight || !(log_det > -HUGE_VAL)) {
        return log_det;
    }
    for (unsigned r = 0; r < P; r++) {
        trace += s->weight[r] * K[r][r];
    }
    return -log(trace);
}

/* Prepares the exchange of position i. Returns 0 if nothing can be told. */
static int prepare(const search *s, unsigned i, prospect *p)
{
    p->is_trace = s->weight != NULL;
    if (!(covariance(s, i, p->K) > -HUGE_VAL)) {
        return 0;
    }
    if (!p->is_trace) {
        memcpy(p->top, p->K, sizeof p->top);
        return 1;
    }
    for (unsigned r = 0; r < P; r++) {
        for (unsigned c = 0; c <= r; c++) {
            double sum = 0;
            for (unsigned k = 0; k < P; k++) {
                sum += p->K[r][k] * s->weight[k] * p->K[k][c];
            }
            p->top[r][c] = p->top[c][r] = sum;
        }
    }
    return 1;
}

/* f = h'A h and its gradient by the direction. */
static double quadratic(double A[P][P], const double a[3], double gradient[3])
{
    double h[P];
    double b[P];
    double f = 0;

    row(a, h);
    for (unsigned r = 0; r < P; r++) {
        b[r] = 0;
        for (unsigned c = 0; c < P; c++) {
            b[r] += A[r][c] * h[c];
        }
        f += b[r] * h[r];
    }
    gradient[0] = 2 * (b[0] + 2 * a[0] * b[3] + a[1] * b[6] + a[2] * b[7]);
    gradient[1] = 2 * (b[1] + 2 * a[1] * b[4] + a[0] * b[6] + a[2] * b[8]);
    gradient[2] = 2 * (b[2] + 2 * a[2] * b[5] + a[0] * b[7] + a[1] * b[8]);
    return f;
}

static double gain(prospect *p, const double a[3], double gradient[3])
{
    double slope[3];
    const double top = quadratic(p->top, a, gradient);

    if (!p->is_trace) {
        return top;
    }
    const double bottom = 1 + quadratic(p->K, a, slope);
    for (unsigned i = 0; i < 3; i++) {
        gradient[i] = (gradient[i] - top / bottom * slope[i]) / bottom;
    }
    return top / bottom;
}

/* Climbs on the sphere: towards gradient + shift a, where the shift grows until that is uphill
 * (it makes the gain convex, and the step of a convex function is uphill). Returns the gain. */
static double climb(prospect *p, double a[3])
{
    double gradient[3];
    double next_gradient[3];
    double height = gain(p, a, gradient);
    double shift = 0;

    for (unsigned step = 0; step < ASCENT; step++) {
        double b[3];
        for (unsigned i = 0; i < 3; i++) {
            b[i] = gradient[i] + shift * a[i];
        }
        normalise(b);
        const double next = gain(p, b, next_gradient);
        if (next > height) {
            const int is_settled = next - height < 1e-13 * height;
            memcpy(a, b, sizeof b);
            memcpy(gradient, next_gradient, sizeof gradient);
            height = next;
            shift /= 2;
            if (is_settled) {
                break;
            }
        } else {
            shift = 2 * shift + height;
        }
    }
    return height;
}

/* Moves each position in turn to where it is best beside the others. Returns the merit. */
static double improve(search *s)
{
    prospect p;
    double before = -HUGE_VAL;
    double now = merit(s);

    for (unsigned sweep = 0; sweep < SWEEPS && now - before > SETTLED; sweep++) {
        for (unsigned i = 0; i < s->n; i++) {
            if (prepare(s, i, &p)) {
                climb(&p, s->direction[i]);
            }
        }
        before = now;
        now = merit(s);
    }
    return now;
}

/* A spiral from pole to pole: directions of about equal distance. */
static void spiral(search *s)
{
    for (unsigned i = 0; i < s->n; i++) {
        const double z = 1 - (2 * i + 1.0) / s->n;
        const double r = sqrt(1 - z * z);
        const double turn = 2.399963229728653 * i; /* the golden angle */
        const double a[3] = {r * cos(turn), r * sin(turn), z};
        memcpy(s->direction[i], a, sizeof a);
    }
}

/* Scattered directions, another set for each seed: a congruential generator is random enough. */
static void scatter(search *s, unsigned seed)
{
    unsigned long state = seed;

    for (unsigned i = 0; i < s->n; i++) {
        for (unsigned k = 0; k < 3; k++) {
            state = (state * 1103515245ul + 12345ul) & 0x7ffffffful;
            s->direction[i][k] = (double)state / 0x40000000 - 1;
        }
        normalise(s->direction[i]);
    }
}

/* The paper's program of the same size, so that the result is never worse. */
static void stand_program(search *s)
{
    invcal_plan plan = {.per_group = s->n / INVCAL_PLAN_GROUPS};
    invcal_plan_position position;

    (void)invcal_plan_starts(plan.per_group, plan.start);
    for (unsigned i = 0; i < s->n; i++) {
        (void)invcal_plan_position_at(&plan, i, &position);
        memcpy(s->direction[i], position.vertical, sizeof position.vertical);
    }
}

static void begin(search *s, unsigned start)
{
    const unsigned is_program =
        s->n % INVCAL_PLAN_GROUPS == 0 && s->n >= INVCAL_PLAN_GROUPS * INVCAL_PLAN_PER_GROUP_MIN;

    if (start == 0) {
        spiral(s);
    } else if (start == 1 && is_program) {
        stand_program(s);
    } else {
        scatter(s, start);
    }
}

/* Keeps the better of two sets. */
static void keep(const search *s, double found, search *best, double *merit_of_best)
{
    if (found > *merit_of_best) {
        *merit_of_best = found;
        *best = *s;
    }
}

/* The better the start, the better the end: several, and the best is kept. Returns its merit.
 * `again`: s holds a set that was good under other weights, which saves most of them. */
static double search_all(search *s, int again)
{
    search best = *s;
    double merit_of_best = -HUGE_VAL;

    if (again) {
        keep(s, improve(s), &best, &merit_of_best);
    }
    for (unsigned start = 0; start < (again ? STARTS / 4 : STARTS); start++) {
        begin(s, start);
        keep(s, improve(s), &best, &merit_of_best);
    }
    *s = best;
    return merit_of_best;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Turns the set so that its first direction is +z and its second lies in the xz plane, x > 0. */
static void turn(search *s)
{
    double axis[3][3]; /* x, y, z of the new frame */
    const double *a = s->direction[0];
    const double *b = s->direction[1];

    memcpy(axis[2], a, sizeof axis[2]);
    for (unsigned i = 0; i < 3; i++) {
        axis[0][i] = b[i] - dot(a, b) * a[i];
    }
    normalise(axis[0]);
    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = (i + 1) % 3;
        const unsigned k = (i + 2) % 3;
        axis[1][i] = axis[2][j] * axis[0][k] - axis[2][k] * axis[0][j];
    }
    for (unsigned n = 0; n < s->n; n++) {
        double v[3];
        for (unsigned i = 0; i < 3; i++) {
            v[i] = dot(axis[i], s->direction[n]);
        }
        normalise(v);
        memcpy(s->direction[n], v, sizeof v);
    }
}

/* Orders the set for a short way: from the direction nearest to +z always to the nearest left. */
static void travel(search *s, double (*direction)[3])
{
    double here[3] = {0, 0, 1};

    for (unsigned n = 0; n < s->n; n++) {
        unsigned nearest = 0;
        for (unsigned i = 1; i < s->n - n; i++) {
            /* a difference that is no more than rounding must not decide */
            nearest =
                dot(here, s->direction[i]) > dot(here, s->direction[nearest]) + 1e-6 ? i : nearest;
        }
        memcpy(here, s->direction[nearest], sizeof here);
        memcpy(direction[n], here, sizeof here);
        memcpy(s->direction[nearest], s->direction[s->n - n - 1], sizeof here);
    }
}

void optimal_directions(unsigned n, double (*direction)[3])
{
    search s = {.n = n};

    search_all(&s, 0);
    turn(&s);
    travel(&s, direction);
}

/* The largest sigma / limit. */
static double worst_ratio(const search *s, const double limits[3], double ratio[P])
{
    double K[P][P];
    double worst = 0;

    covariance(s, s->n, K);
    for (unsigned r = 0; r < P; r++) {
        ratio[r] = sqrt(K[r][r]) / limits[r / 3];
        worst = ratio[r] > worst ? ratio[r] : worst;
    }
    return worst;
}

/* Each share times the square of its ratio, their sum 1 again. */
static void move_weights(double share[P], const double ratio[P])
{
    double sum = 0;

    for (unsigned r = 0; r < P; r++) {
        share[r] *= ratio[r] * ratio[r];
        sum += share[r];
    }
    for (unsigned r = 0; r < P; r++) {
        share[r] /= sum;
    }
}

/* The worst ratio is at least the root of the weighted mean square, whatever the weights. So
 * A-optimal sets are searched under weights that are moved, more to where the ratio is large,
 * until the two meet (mirror ascent on the dual of the problem) or come no nearer. */
double optimal_within(unsigned n, const double limits[3], double enough, double (*direction)[3])
{
    double share[P]; /* of the squared ratios in the mean; their sum is 1 */
    double weight[P];
    double ratio[P];
    double best = HUGE_VAL;
    double bound = 0;
    unsigned idle = 0; /* rounds without success */
    search s = {.n = n, .weight = weight};

    for (unsigned r = 0; r < P; r++) {
        share[r] = 1.0 / (double)P;
    }
    while (best > enough && best > bound * (1 + MATCH) && idle < PATIENCE) {
        for (unsigned r = 0; r < P; r++) {
            weight[r] = share[r] / (limits[r / 3] * limits[r / 3]);
        }
        const double mean = exp(-search_all(&s, bound > 0) / 2);
        const double worst = worst_ratio(&s, limits, ratio);
        bound = fmax(bound, mean);
        if (enough > 0 && bound > enough) {
            return bound;
        }
        idle = worst < best * (1 - MATCH / 10) ? 0 : idle + 1;
        if (worst < best) {
            search copy = s;
            best = worst;
            travel(&copy, direction);
        }
        move_weights(share, ratio);
    }
    return best;
}
