/* SPDX-License-Identifier: MIT */
#include "invcal/eigen.h"

#include <string.h>

#include "vector.h"

/* More sweeps than any 3x3 matrix needs: convergence is quadratic. */
enum { MAX_SWEEPS = 10 };

/* Turns the axes p and q so that m(p,q) becomes zero; r is the third axis.
 * t = tan of the angle, the smaller root of t^2 + 2 t theta - 1 = 0. */
static void rotate(invcal_real m[3][3], invcal_real v[3][3], unsigned p, unsigned q)
{
    const unsigned r = 3 - p - q;
    const invcal_real theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
    const invcal_real root = INVCAL_SQRT(theta * theta + 1);
    const invcal_real t = 1 / (theta < 0 ? theta - root : theta + root);
    const invcal_real c = 1 / INVCAL_SQRT(t * t + 1);
    const invcal_real s = t * c;
    const invcal_real rp = m[r][p];
    const invcal_real rq = m[r][q];

    m[p][p] -= t * m[p][q];
    m[q][q] += t * m[p][q];
    m[p][q] = 0;
    m[q][p] = 0;
    m[p][r] = c * rp - s * rq;
    m[r][p] = m[p][r];
    m[q][r] = s * rp + c * rq;
    m[r][q] = m[q][r];
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real ip = v[i][p];
        const invcal_real iq = v[i][q];
        v[i][p] = c * ip - s * iq;
        v[i][q] = s * ip + c * iq;
    }
}

void invcal_eigen3_decompose(const invcal_real m[6], invcal_eigen3 *out)
{
    static const unsigned char pair[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    invcal_real a[3][3] = {{m[0], m[1], m[3]}, {m[1], m[2], m[4]}, {m[3], m[4], m[5]}};

    INVCAL_ASSERT(out);
    memset(out->vector, 0, sizeof out->vector);
    for (unsigned i = 0; i < 3; i++) {
        out->vector[i][i] = 1;
    }
    for (unsigned i = 0; i < 3 * MAX_SWEEPS; i++) {
        const unsigned p = pair[i % 3][0];
        const unsigned q = pair[i % 3][1];
        const invcal_real scale = INVCAL_FABS(a[p][p]) + INVCAL_FABS(a[q][q]);
        /* An element below a hundredth of the rounding error of its row changes nothing; a NaN
         * is rotated too, and so shows in the values. */
        if (!(INVCAL_FABS(a[p][q]) <= INVCAL_EPSILON / 100 * scale)) {
            rotate(a, out->vector, p, q);
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        out->value[i] = a[i][i];
    }
}

/* y = A x for a packed symmetric A of n rows. */
static void multiply(const invcal_real *a, unsigned n, const invcal_real *x, invcal_real *y)
{
    for (unsigned r = 0; r < n; r++) {
        const invcal_real *row = &a[INVCAL_PACKED(r, 0)];
        y[r] = invcal_dot(row, x, r + 1);
        for (unsigned c = 0; c < r; c++) {
            y[c] += row[c] * x[r];
        }
    }
}

/* One step of Householder: mirrors row k of a, left of the diagonal, onto its last element, and
 * the rows above likewise. Returns that element, the off-diagonal of the tridiagonal form. The
 * diagonal elements of a are at most 1. */
static invcal_real mirror(invcal_real *a, unsigned k)
{
    invcal_real *v = &a[INVCAL_PACKED(k, 0)];
    invcal_real w[INVCAL_MAX_PARAMETERS];
    const invcal_real length = INVCAL_SQRT(invcal_dot(v, v, k));

    if (length <= INVCAL_EPSILON * INVCAL_EPSILON) {
        return 0; /* nothing stands left of the diagonal */
    }
    if (k == 1) {
        return v[0]; /* it stands where it belongs */
    }
    const invcal_real image = v[k - 1] > 0 ? -length : length;
    v[k - 1] -= image;
    const invcal_real half = invcal_dot(v, v, k) / 2;
    /* (I - v v'/half) A (I - v v'/half) = A - v w' - w v', w = A v/half - v (v'A v)/(2 half^2) */
    multiply(a, k, v, w);
    const invcal_real share = invcal_dot(v, w, k) / (2 * half);
    for (unsigned i = 0; i < k; i++) {
        w[i] = (w[i] - share * v[i]) / half;
    }
    for (unsigned r = 0; r < k; r++) {
        for (unsigned c = 0; c <= r; c++) {
            a[INVCAL_PACKED(r, c)] -= v[r] * w[c] + w[r] * v[c];
        }
    }
    return image;
}

/* A matrix of the same eigenvalues with nothing but a diagonal and the elements beside it. */
typedef struct {
    invcal_real d[INVCAL_MAX_PARAMETERS];  /* diagonal */
    invcal_real e2[INVCAL_MAX_PARAMETERS]; /* squares beside it: e2[i] couples i - 1 and i */
    invcal_real scale;                     /* that all has been divided by, lest it overflows */
    invcal_real bound;                     /* no eigenvalue is larger */
} tridiagonal;

/* Returns 0 if a holds what is no number, or has no positive trace. */
static int reduce(invcal_real *a, unsigned n, tridiagonal *t)
{
    invcal_real trace = 0;
    invcal_real coupling = 0;

    t->scale = invcal_largest_diagonal(a, n);
    for (unsigned i = 0; i < INVCAL_PACKED_SIZE(n); i++) {
        a[i] /= t->scale; /* 0/0 is a NaN, and is found below */
    }
    for (unsigned k = n; k-- > 0;) {
        const invcal_real e = k > 0 ? mirror(a, k) : 0;
        t->e2[k] = e * e;
        t->d[k] = a[INVCAL_PACKED(k, k)];
        trace += t->d[k];
        coupling += t->e2[k];
    }
    t->bound = 2 * trace;
    return invcal_is_positive(trace) && invcal_is_finite(coupling);
}

/* Laguerre's step from an x beyond all eigenvalues x(i) towards the nearest, which it never passes
 * but by rounding:
 *
 *     n / (S1 +- sqrt((n - 1) (n S2 - S1^2))),  S1 = sum 1/(x - x(i)), S2 of the squares.
 *
 * The characteristic polynomial is the product of the pivots q of x - A; with a = q'/q and
 * b = q''/q, S1 is the sum of a, S2 that of a^2 - b. Beyond all eigenvalues every pivot has the
 * sign: 1 above, -1 below. Returns 0 if one has not. */
static int step_towards(const tridiagonal *t, unsigned n, invcal_real sign, invcal_real x,
                        invcal_real *step)
{
    invcal_real s1 = 0;
    invcal_real s2 = 0;
    invcal_real q = 1;
    invcal_real a = 0;
    invcal_real b = 0;

    for (unsigned i = 0; i < n; i++) {
        const invcal_real c = t->e2[i] / q;
        q = x - t->d[i] - c;
        if (!(sign * q > 0)) {
            return 0;
        }
        b = c * (b - 2 * a * a) / q;
        a = (1 + c * a) / q;
        s1 += a;
        s2 += a * a - b;
    }
    const invcal_real radicand = (invcal_real)(n - 1) * ((invcal_real)n * s2 - s1 * s1);
    const invcal_real root = radicand > 0 ? INVCAL_SQRT(radicand) : 0;
    *step = (invcal_real)n / (s1 + sign * root);
    return 1;
}

/* The largest eigenvalue (sign 1) or the smallest (sign -1), from an x beyond all. Where rounding
 * has led past it, the interval is halved: pivots tell the side even where steps have lost all
 * digits. */
static invcal_real extreme(const tridiagonal *t, unsigned n, invcal_real sign, invcal_real x)
{
    enum { MAX_STEPS = 100 }; /* eigenvalues that are equal cost one or two bits a step */
    invcal_real beyond = x;   /* the nearest x known that is */
    invcal_real past = x;     /* the nearest known that is not, */
    int is_passed = 0;        /* if there is one */
    invcal_real step;

    for (unsigned i = 0; i < MAX_STEPS; i++) {
        if (step_towards(t, n, sign, x, &step)) {
            beyond = x;
            x -= step;
        } else {
            past = x;
            is_passed = 1;
        }
        if (is_passed && !(sign * (x - past) > 0)) {
            x = beyond + (past - beyond) / 2;
        }
        if (x == beyond || (is_passed && x == past)) {
            break;
        }
    }
    return beyond;
}

invcal_real invcal_condition(invcal_real *a, unsigned n)
{
    tridiagonal t;

    INVCAL_ASSERT(a && n >= 1 && n <= INVCAL_MAX_PARAMETERS);
    if (!reduce(a, n, &t)) {
        return INVCAL_REAL_MAX;
    }
    const invcal_real largest = extreme(&t, n, 1, t.bound);
    const invcal_real smallest = extreme(&t, n, -1, 0);
    return smallest > (invcal_real)n * INVCAL_EPSILON * largest ? largest / smallest
                                                                : INVCAL_REAL_MAX;
}

invcal_real invcal_largest_eigenvalue(invcal_real *a, unsigned n)
{
    tridiagonal t;

    INVCAL_ASSERT(a && n >= 1 && n <= INVCAL_MAX_PARAMETERS);
    return reduce(a, n, &t) ? t.scale * extreme(&t, n, 1, t.bound) : INVCAL_REAL_MAX;
}
