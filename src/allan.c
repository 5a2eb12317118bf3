/* SPDX-License-Identifier: MIT */
#include "invcal/allan.h"

#include <string.h>

#include "vector.h"

enum { RINGS = INVCAL_ALLAN_RINGS };
#define RING (2u * INVCAL_ALLAN_OVERLAP) /* a power of two */

/* ---- sums of 128 bits ------------------------------------------------------------------------ */

/* Adds size^2, at most 2^126. Beyond 128 bits all bits are set, and stay so. */
static void add_square(invcal_allan_tau *sum, uint64_t size)
{
    const uint64_t a = size >> 32;
    const uint64_t b = size & UINT32_MAX;
    uint64_t low = b * b;
    uint64_t high = 0;

    if (a > 0) {
        const uint64_t middle = a * b; /* counts twice, 2^33 of it */
        high = a * a + (middle >> 31);
        low += middle << 33;
        high += low < middle << 33;
    }
    sum->low += low;
    high += sum->low < low;
    sum->high += high;
    if (sum->high < high) {
        sum->low = UINT64_MAX;
        sum->high = UINT64_MAX;
    }
}

static int is_full(const invcal_allan_tau *sum)
{
    return (sum->low & sum->high) == UINT64_MAX;
}

/* sqrt(sum / (2 count)): the upper 62 bits or more, and half the exponent of the rest. */
static invcal_real root_mean(const invcal_allan_tau *sum)
{
    uint64_t low = sum->low;
    uint64_t high = sum->high;
    invcal_real power = 1;

    for (; high > 0; high >>= 2) { /* at most 32 steps */
        low = low >> 2 | high << 62;
        power *= 2;
    }
    return power * INVCAL_SQRT((invcal_real)low / (2 * (invcal_real)sum->count));
}

/* ---- the pyramid ----------------------------------------------------------------------------- */

/* The lowest stage that serves m. Returns 0 if its stride does not divide m. */
static int find_stage(uint32_t m, uint8_t *stage)
{
    uint8_t t = 0;

    if (m < 1 || m > INVCAL_ALLAN_LONGEST) {
        return 0;
    }
    while (m > (uint32_t)INVCAL_ALLAN_OVERLAP << t) { /* at most 30 steps: m is 2^30 or less */
        t++;
    }
    *stage = t;
    return m >> t << t == m;
}

/* Are these averaging times, and is there a ring for every stage? */
static invcal_status check_times(const uint32_t *m, unsigned count)
{
    unsigned rings = 0;
    uint8_t last = 0;
    uint8_t stage;

    for (unsigned k = 0; k < count; k++) {
        if (!find_stage(m[k], &stage) || (k > 0 && m[k] <= m[k - 1])) {
            return INVCAL_BAD_SETTING;
        }
        rings += k == 0 || stage != last;
        last = stage;
        if (rings > RINGS) {
            return INVCAL_NO_SPACE;
        }
    }
    return INVCAL_OK;
}

/* Puts m into the ring of its stage, the last one or a new one. */
static void add_time(invcal_allan *a, uint32_t m)
{
    uint8_t stage = 0;

    (void)find_stage(m, &stage); /* checked before */
    if (a->rings == 0 || stage != a->stage[a->rings - 1]) {
        //@ assert a->rings < RINGS; // as check_times saw; octaves have no more
        a->stage[a->rings++] = stage;
    }
    a->tau[a->taus++].m = m;
    a->end[a->rings - 1] = a->taus;
}

invcal_status invcal_allan_init(invcal_allan *allan, const uint32_t *m, unsigned count,
                                invcal_allan_windows windows)
{
    INVCAL_ASSERT(allan);
    if (count < 1 || count > INVCAL_ALLAN_TAUS ||
        (windows != INVCAL_ALLAN_OVERLAPPING && windows != INVCAL_ALLAN_APART)) {
        return INVCAL_BAD_SETTING;
    }
    const invcal_status status = m != NULL ? check_times(m, count) : INVCAL_OK;
    if (status != INVCAL_OK) {
        return status;
    }
    memset(allan, 0, sizeof *allan);
    allan->windows = (uint8_t)windows;
    for (unsigned k = 0; k < count; k++) {
        add_time(allan, m ? m[k] : UINT32_C(1) << k);
    }
    return INVCAL_OK;
}

/* The difference that ends at the newest total, number `at` of its ring. */
static void add_difference(invcal_allan *a, unsigned ring, invcal_allan_tau *tau, uint32_t at)
{
    const uint64_t *past = a->past[ring];
    const uint32_t lag = tau->m >> a->stage[ring];
    //@ assert lag > 0; // as append saw

    if (at < 2 * lag || tau->count == UINT32_MAX ||
        (a->windows == INVCAL_ALLAN_APART && at % lag != 0)) {
        return;
    }
    const uint64_t middle = past[(at - lag) % RING];
    const uint64_t d = (a->total - middle) - (middle - past[(at - 2 * lag) % RING]);
    add_square(tau, d >> 63 ? 0 - d : d); /* modulo 2^64, as the totals */
    tau->count++;
}

void invcal_allan_push(invcal_allan *allan, int32_t raw)
{
    unsigned k = 0;

    INVCAL_ASSERT(allan);
    allan->total += (uint64_t)(int64_t)raw;
    allan->samples++;
    for (unsigned r = 0; r < allan->rings; r++) {
        const uint32_t at = allan->samples >> allan->stage[r];
        if (at << allan->stage[r] != allan->samples) {
            break; /* nor do longer strides end here */
        }
        for (; k < allan->end[r]; k++) {
            add_difference(allan, r, &allan->tau[k], at);
        }
        allan->past[r][at % RING] = allan->total;
    }
}

void invcal_allan_gap(invcal_allan *allan)
{
    INVCAL_ASSERT(allan);
    allan->samples = 0;
    for (unsigned r = 0; r < allan->rings; r++) {
        allan->past[r][0] = allan->total;
    }
}

/* ---- one averaging time ---------------------------------------------------------------------- */

static invcal_real freedom_of(invcal_real lag, invcal_real count)
{
    const invcal_real n = count + 2 * lag; /* totals */
    const invcal_real square = 4 * lag * lag;

    return (3 * (n - 1) / (2 * lag) - 2 * (n - 2) / n) * square / (square + 5);
}

invcal_status invcal_allan_get(const invcal_allan *allan, unsigned index, invcal_allan_point *out)
{
    unsigned ring = 0;

    INVCAL_ASSERT(allan && out);
    if (index >= allan->taus) {
        return INVCAL_BAD_SETTING;
    }
    const invcal_allan_tau *tau = &allan->tau[index];
    if (tau->count == 0) {
        return INVCAL_TOO_FEW;
    }
    if (is_full(tau)) {
        return INVCAL_NO_SPACE;
    }
    while (index >= allan->end[ring]) { /* at most the number of rings: taus ends the last */
        //@ assert ring < RINGS - 1; // the last ends at taus
        ring++;
    }
    const uint32_t lag = allan->windows == INVCAL_ALLAN_APART ? 1 : tau->m >> allan->stage[ring];
    out->m = tau->m;
    out->count = tau->count;
    out->adev = root_mean(tau) / (invcal_real)tau->m;
    out->edf = freedom_of((invcal_real)lag, (invcal_real)tau->count);
    out->relative = 1 / INVCAL_SQRT(2 * out->edf);
    return INVCAL_OK;
}

/* ---- what the noise is made of --------------------------------------------------------------- */

enum { KINDS = INVCAL_NOISE_KINDS, ALL = (1 << INVCAL_NOISE_KINDS) - 1 };

#define FLOOR INVCAL_REAL(0.44127120030530317) /* 2 ln 2 / pi */
#define NEAR_FLOOR INVCAL_REAL(0.1025)         /* 1.05^2 - 1 */
#define EDF_MIN 5                              /* with fewer, chance has too long a tail */
#define TRUST INVCAL_REAL(0.0025)              /* variance of the model itself, relative: 5 % */
#define STEPS 12                               /* rounds of reweighting */
#define VISIBLE (INVCAL_REAL(1.0) / 3)         /* relative standard deviation of a term */
#define SHARED 2 /* on that of slow noise, which ties neighbouring tau to each other */
#define POOR 2   /* of misfit: beyond, it is no chance */

/* Relative to the first: tau in its tau, variances in its adev^2. */
typedef struct {
    unsigned count;
    invcal_allan_point first, lowest, last;
    invcal_real tau[INVCAL_ALLAN_TAUS];
    invcal_real variance[INVCAL_ALLAN_TAUS];
    invcal_real model[INVCAL_ALLAN_TAUS];
    invcal_real weight[INVCAL_ALLAN_TAUS]; /* of variance / model */
} curve;

/* The three terms of the model at tau = 1, and their relative standard deviations. */
typedef struct {
    invcal_real term[KINDS];
    invcal_real relative[KINDS];
    unsigned kinds; /* those that are there */
} mixture;

/* Every power of tau is that of the kind before, times tau. */
static void powers(invcal_real tau, invcal_real of[KINDS])
{
    of[INVCAL_NOISE_WHITE] = 1 / tau;
    of[INVCAL_NOISE_INSTABILITY] = 1;
    of[INVCAL_NOISE_WALK] = tau;
}

/* What of the averaging times can be used. */
static void collect(const invcal_allan *a, curve *c)
{
    invcal_allan_point p;

    memset(c, 0, sizeof *c);
    memset(&p, 0, sizeof p);
    //@ loop unroll INVCAL_ALLAN_TAUS;
    for (unsigned k = 0; k < a->taus; k++) {
        if (invcal_allan_get(a, k, &p) != INVCAL_OK || !(p.edf >= EDF_MIN) || !(p.adev > 0)) {
            continue;
        }
        if (c->count == 0) {
            c->first = p;
        }
        if (c->count == 0 || p.adev < c->lowest.adev) {
            c->lowest = p;
        }
        c->last = p;
        const invcal_real ratio = p.adev / c->first.adev;
        c->tau[c->count] = (invcal_real)p.m / (invcal_real)c->first.m;
        c->variance[c->count] = ratio * ratio;
        c->model[c->count] = ratio * ratio;
        c->weight[c->count] = 1 / (2 / p.edf + TRUST);
        c->count++;
    }
}

/* Normal equations of variance / model = sum of term (power / model). */
static void sum_curve(const curve *c, invcal_real h[INVCAL_PACKED_SIZE(KINDS)],
                      invcal_real g[KINDS])
{
    invcal_real row[KINDS];

    memset(h, 0, INVCAL_PACKED_SIZE(KINDS) * sizeof *h);
    memset(g, 0, KINDS * sizeof *g);
    for (unsigned k = 0; k < c->count; k++) {
        powers(c->tau[k], row);
        for (unsigned i = 0; i < KINDS; i++) {
            row[i] /= c->model[k];
            g[i] += c->weight[k] * row[i] * (c->variance[k] / c->model[k]);
            for (unsigned j = 0; j <= i; j++) {
                h[INVCAL_PACKED(i, j)] += c->weight[k] * row[i] * row[j];
            }
        }
    }
}

/* Solves for one set of kinds, in units in which the diagonal is 1. Returns what the solution
 * takes away from the sum of squares; 0 if it is not positive, or undetermined. */
static invcal_real solve_set(const invcal_real h[INVCAL_PACKED_SIZE(KINDS)],
                             const invcal_real g[KINDS], unsigned kinds, mixture *out)
{
    unsigned of[KINDS];
    unsigned n = 0;
    invcal_real l[INVCAL_PACKED_SIZE(KINDS)];
    invcal_real unit[KINDS];
    invcal_real x[KINDS];
    invcal_real variance[KINDS];
    invcal_real gain = 0;

    memset(out, 0, sizeof *out);
    for (unsigned i = 0; i < KINDS; i++) {
        if (kinds >> i & 1u) {
            unit[n] = INVCAL_SQRT(h[INVCAL_PACKED(i, i)]);
            x[n] = g[i] / unit[n];
            of[n++] = i;
        }
    }
    for (unsigned i = 0; i < n; i++) {
        for (unsigned j = 0; j <= i; j++) {
            /* cppcheck-suppress uninitvar ; of and unit are set up to n */
            l[INVCAL_PACKED(i, j)] = h[INVCAL_PACKED(of[i], of[j])] / (unit[i] * unit[j]);
        }
    }
    if (invcal_cholesky_factor(l, n, INVCAL_PIVOT_FLOOR) != INVCAL_OK) {
        return 0;
    }
    invcal_cholesky_solve(l, n, x);
    invcal_cholesky_inverse_diagonal(l, n, variance);
    out->kinds = kinds;
    for (unsigned i = 0; i < n; i++) {
        if (!(x[i] > 0)) {
            return 0;
        }
        out->term[of[i]] = x[i] / unit[i];
        out->relative[of[i]] =
            (of[i] == INVCAL_NOISE_WHITE ? 1 : SHARED) * INVCAL_SQRT(variance[i]) / x[i];
        gain += out->term[of[i]] * g[of[i]];
    }
    return gain;
}

/* The best set within those allowed, with the weights of the model so far: least squares under the
 * condition that no term is negative. */
static void solve_best(const curve *c, unsigned allowed, mixture *best)
{
    invcal_real h[INVCAL_PACKED_SIZE(KINDS)];
    invcal_real g[KINDS];
    invcal_real gain = 0;
    mixture other;

    memset(best, 0, sizeof *best);
    sum_curve(c, h, g);
    for (unsigned kinds = 1; kinds <= ALL; kinds++) {
        if ((kinds & ~allowed) != 0) {
            continue;
        }
        const invcal_real found = solve_set(h, g, kinds, &other);
        if (found > gain) {
            gain = found;
            *best = other;
        }
    }
}

static invcal_real model_at(const mixture *x, invcal_real tau)
{
    invcal_real of[KINDS];

    powers(tau, of);
    return invcal_dot(x->term, of, KINDS);
}

/* Variances scatter in proportion to what they estimate, so the model, not the measured curve,
 * must weigh them: it is found in turns with its weights. */
static void fit_mixture(curve *c, unsigned allowed, mixture *x)
{
    for (unsigned step = 0; step < STEPS; step++) {
        solve_best(c, allowed, x);
        for (unsigned k = 0; k < c->count && x->kinds; k++) {
            c->model[k] = model_at(x, c->tau[k]);
        }
    }
}

/* The kind that stands out least, if it does not stand out; else KINDS. */
static unsigned hidden_kind(const mixture *x)
{
    invcal_real most = VISIBLE;
    unsigned which = KINDS;

    for (unsigned i = 0; i < KINDS; i++) {
        if (x->relative[i] > most) {
            most = x->relative[i];
            which = i;
        }
    }
    return which;
}

static invcal_real misfit(const curve *c)
{
    invcal_real sum = 0;

    for (unsigned k = 0; k < c->count; k++) {
        const invcal_real d = c->variance[k] / c->model[k] - 1;
        sum += c->weight[k] * d * d;
    }
    return INVCAL_SQRT(sum / (invcal_real)c->count);
}

/* Kinds that do not stand out are left out, one by one, as long as the others explain the curve. */
static void fit_visible(curve *c, mixture *x)
{
    mixture fewer;

    fit_mixture(c, ALL, x);
    invcal_real before = misfit(c);
    for (unsigned i = hidden_kind(x); i < KINDS; i = hidden_kind(x)) { /* at most KINDS */
        fit_mixture(c, x->kinds & ~(1u << i), &fewer);
        const invcal_real after = misfit(c);
        if (after > POOR && after > 2 * before) {
            fit_mixture(c, x->kinds, x);
            return;
        }
        before = after;
        *x = fewer;
    }
}

/* Terms at the first tau, relative to its variance, to coefficients. A term's relative standard
 * deviation is twice that of its root. */
static void name_coefficients(const mixture *x, invcal_real adev, invcal_real tau,
                              invcal_noise *noise)
{
    const invcal_real unit[KINDS] = {tau, 1 / FLOOR, 3 / tau};

    for (unsigned i = 0; i < KINDS; i++) {
        noise->coefficient[i] = adev * INVCAL_SQRT(x->term[i] * unit[i]);
        noise->relative[i] = x->relative[i] / 2;
    }
    noise->visible = (uint8_t)x->kinds;
}

invcal_status invcal_allan_noise(const invcal_allan *allan, invcal_real rate, invcal_real lsb,
                                 invcal_noise *noise)
{
    curve c;
    mixture x;
    invcal_noise n;

    INVCAL_ASSERT(allan && noise);
    if (!invcal_is_positive(rate) || !invcal_is_positive(lsb)) {
        return INVCAL_BAD_SETTING;
    }
    collect(allan, &c);
    if (c.count == 0) {
        return INVCAL_TOO_FEW;
    }
    fit_visible(&c, &x);
    if (x.kinds == 0) {
        return INVCAL_TOO_FEW;
    }
    name_coefficients(&x, c.first.adev * lsb, (invcal_real)c.first.m / rate, &n);
    n.misfit = misfit(&c);
    n.minimum = c.lowest.adev * lsb;
    n.best = (invcal_real)c.lowest.m / rate;
    n.shortest = (invcal_real)c.first.m / rate;
    n.longest = (invcal_real)c.last.m / rate;
    if (!invcal_are_finite(n.coefficient) || !invcal_is_finite(n.longest)) {
        return INVCAL_BAD_SETTING; /* or minimum: it is no larger than the first deviation */
    }
    *noise = n;
    return INVCAL_OK;
}

/* ---- how long to stay ------------------------------------------------------------------------ */

/* The terms of the model at tau = 1 s. */
static void terms_of(const invcal_noise *noise, invcal_real term[KINDS])
{
    const invcal_real unit[KINDS] = {1, FLOOR, INVCAL_REAL(1.0) / 3};

    for (unsigned i = 0; i < KINDS; i++) {
        term[i] = noise->coefficient[i] * noise->coefficient[i] * unit[i];
    }
}

invcal_real invcal_noise_sigma(const invcal_noise *noise, invcal_real tau)
{
    invcal_real term[KINDS];
    invcal_real of[KINDS];

    INVCAL_ASSERT(noise);
    terms_of(noise, term);
    powers(tau, of);
    return INVCAL_SQRT(invcal_dot(term, of, KINDS));
}

static int are_coefficients(const invcal_real c[KINDS])
{
    return c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && invcal_are_finite(c);
}

/* In units of the wanted variance: a / T + b + c T <= 1. The smaller root of c T^2 - (1 - b) T + a,
 * or, if there is none, the minimum. Returns 1 for a root. */
static int solve_dwell(const invcal_real term[KINDS], invcal_real *seconds)
{
    const invcal_real a = term[INVCAL_NOISE_WHITE];
    const invcal_real b = term[INVCAL_NOISE_INSTABILITY];
    const invcal_real c = term[INVCAL_NOISE_WALK];
    const invcal_real room = 1 - b;
    const invcal_real square = room * room - 4 * a * c;

    if (room > 0 && square >= 0) {
        *seconds = 2 * a / (room + INVCAL_SQRT(square));
        return 1;
    }
    *seconds = c > 0 ? INVCAL_SQRT(a / c) : a / (NEAR_FLOOR * b);
    return 0;
}

invcal_status invcal_noise_dwell(const invcal_noise *noise, invcal_real sigma, invcal_dwell *out)
{
    invcal_noise relative;
    invcal_real term[KINDS];
    invcal_real seconds;

    INVCAL_ASSERT(noise && out);
    if (!invcal_is_positive(sigma) || !are_coefficients(noise->coefficient)) {
        return INVCAL_BAD_SETTING;
    }
    for (unsigned i = 0; i < KINDS; i++) {
        relative.coefficient[i] = noise->coefficient[i] / sigma;
    }
    terms_of(&relative, term);
    int is_reached = solve_dwell(term, &seconds);
    if (!(seconds > noise->shortest)) {
        seconds = noise->shortest;
        is_reached = invcal_noise_sigma(&relative, seconds) <= 1;
    }
    const invcal_real reached = invcal_noise_sigma(noise, seconds);
    if (!invcal_is_positive(seconds) || !invcal_is_positive(reached)) {
        return INVCAL_BAD_SETTING;
    }
    out->seconds = seconds;
    out->sigma = reached;
    out->end = !is_reached                 ? INVCAL_DWELL_FLOOR
               : seconds <= noise->longest ? INVCAL_DWELL_REACHED
                                           : INVCAL_DWELL_BEYOND;
    return INVCAL_OK;
}
