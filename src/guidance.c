/* SPDX-License-Identifier: MIT */
#include "invcal/guidance.h"

#include <stddef.h>
#include <string.h>

#include "row.h"
#include "triad.h"
#include "vector.h"

#define EQUAL INVCAL_REAL(0.01) /* gains that differ by less are equal */
#define MOVED INVCAL_REAL(0.9)  /* cosine of 26 degrees: nearer is the same position again */
#define FIRST INVCAL_REAL(1e-3) /* of cosines that differ by less, the first counts */
#define FALLS INVCAL_REAL(0.1)  /* a sigma that falls by this share improves */

/* ---- the 26 directions ---------------------------------------------------------------------- */

enum { CODES = 27, CODE_KINDS = 3 }; /* sign triples; faces, edges and corners have 1, 2, 3 signs */

/* The n-th direction of KINDS CODES: the triples z slowest, +1 first, then 0, then -1; first for
 * faces, then edges, then corners. Returns 0 where the triple is of another kind. */
static int direction(unsigned n, invcal_real up[3])
{
    const unsigned kind = n / CODES + 1;
    const int sign[3] = {1 - (int)(n / 3 % 3), 1 - (int)(n % 3), 1 - (int)(n % CODES / 9)};
    unsigned signs = 0;

    for (unsigned i = 0; i < 3; i++) {
        signs += sign[i] != 0;
        up[i] = (invcal_real)sign[i] / INVCAL_SQRT((invcal_real)kind);
    }
    return signs == kind;
}

/* ---- what they are worth --------------------------------------------------------------------- */

/* L L' = H'H + ridge I, with a row more if there is one. */
static invcal_status factor_with(const invcal_normal *normal, const invcal_real *more,
                                 invcal_real *l)
{
    invcal_normal_matrix(normal, l);
    const invcal_real largest = invcal_largest_diagonal(l, INVCAL_PARAMETERS);
    const invcal_real ridge = INVCAL_RIDGE * (largest > 1 ? largest : 1);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        for (unsigned c = 0; more && c <= r; c++) {
            l[INVCAL_PACKED(r, c)] += more[r] * more[c];
        }
        l[INVCAL_PACKED(r, r)] += ridge;
    }
    return invcal_cholesky_factor(l, INVCAL_PARAMETERS, INVCAL_EPSILON);
}

/* h K h'. */
static invcal_real gain_of(const invcal_real *l, const invcal_real up[3])
{
    invcal_real h[INVCAL_PARAMETERS];

    invcal_row(up, h);
    invcal_cholesky_forward(l, INVCAL_PARAMETERS, h);
    return invcal_dot(h, h, INVCAL_PARAMETERS);
}

static invcal_real largest_gain(const invcal_real *l)
{
    invcal_real up[3];
    invcal_real most = 0;

    for (unsigned n = 0; n < CODE_KINDS * CODES; n++) {
        if (direction(n, up)) {
            const invcal_real gain = gain_of(l, up);
            most = gain > most ? gain : most;
        }
    }
    return most;
}

/* ---- the choice ----------------------------------------------------------------------------- */

/* Of those with a gain of least or more the nearest, but rather any other than the same again. */
static void choose_codes(const invcal_real *l, invcal_real least, const invcal_real *current,
                         invcal_guidance *next)
{
    const invcal_real length = current ? INVCAL_SQRT(invcal_dot(current, current, 3)) : 0;
    invcal_real best = -3;
    invcal_real up[3];

    for (unsigned n = 0; n < CODE_KINDS * CODES; n++) {
        if (!direction(n, up)) {
            continue;
        }
        const invcal_real gain = gain_of(l, up);
        const invcal_real cosine =
            invcal_is_positive(length) ? invcal_dot(up, current, 3) / length : 0;
        const invcal_real merit = cosine > MOVED ? -2 : cosine;
        if (gain >= least && merit > best + FIRST) {
            best = merit;
            memcpy(next->up, up, sizeof up);
        }
    }
    //@ assert \initialized(next->up + (0 .. 2));
}

/* sqrt(K(r,r)) from L. */
static void roots(const invcal_real *l, invcal_real *root)
{
    invcal_cholesky_inverse_diagonal(l, INVCAL_PARAMETERS, root);
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        root[r] = INVCAL_SQRT(root[r]);
    }
}

static uint16_t improved(const invcal_guidance *next)
{
    invcal_real least = FALLS;
    invcal_real most = 0;
    uint16_t bits = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real falls = 1 - next->after[r] / next->before[r];
        most = falls > most ? falls : most;
    }
    least = most < least ? most : least;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real falls = 1 - next->after[r] / next->before[r];
        bits |= (uint16_t)((falls >= least ? 1u : 0u) << r);
    }
    return bits;
}

/* What next->up will do; l is L of the sums, and lost. */
static void predict(const invcal_normal *normal, invcal_real *l, invcal_guidance *next)
{
    invcal_real h[INVCAL_PARAMETERS];

    next->gain = gain_of(l, next->up);
    roots(l, next->before);
    invcal_row(next->up, h);
    (void)factor_with(normal, h, l); /* what was positive definite and a square more */
    roots(l, next->after);
    next->improves = improved(next);
}

invcal_status invcal_guidance_next(const invcal_normal *normal, const invcal_real *current,
                                   invcal_guidance *next)
{
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];

    INVCAL_ASSERT(normal && next);
    if (factor_with(normal, NULL, l) != INVCAL_OK) {
        return INVCAL_BAD_SETTING;
    }
    choose_codes(l, largest_gain(l) * (1 - EQUAL), current, next);
    predict(normal, l, next);
    return INVCAL_OK;
}

invcal_status invcal_guidance_of(const invcal_normal *normal, const invcal_real up[3],
                                 invcal_guidance *next)
{
    invcal_real l[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    invcal_observation row;

    INVCAL_ASSERT(normal && up && next);
    const invcal_status status = invcal_observation_vertical(up, up, &row);
    if (status != INVCAL_OK) {
        return status;
    }
    if (factor_with(normal, NULL, l) != INVCAL_OK) {
        return INVCAL_BAD_SETTING;
    }
    memcpy(next->up, up, sizeof next->up);
    predict(normal, l, next);
    return INVCAL_OK;
}

/* ---- in words ------------------------------------------------------------------------------- */

#define NAMED INVCAL_REAL(0.1) /* a component below is none: 6 degrees */

static char *write_text(char *at, const char *text)
{
    while (*text != '\0') { /* at most 7 steps: the length of the texts below */
        *at++ = *text++;
    }
    return at;
}

static char *append_axis(char *at, const invcal_real up[3], unsigned axis)
{
    *at++ = up[axis] < 0 ? '-' : '+';
    *at++ = (char)('x' + axis);
    return at;
}

/* ", tilt 45 deg": the angle to the axis, to 5 degrees. */
static char *append_tilt(char *at, invcal_real cosine)
{
    unsigned degrees = 5;

    /* at most 10 steps */
    while (degrees < 55 &&
           INVCAL_COS(((invcal_real)degrees + INVCAL_REAL(2.5)) * INVCAL_DEGREE) > cosine) {
        degrees += 5;
    }
    at = write_text(at, ", tilt ");
    if (degrees >= 10) {
        *at++ = (char)('0' + degrees / 10);
    }
    *at++ = (char)('0' + degrees % 10);
    return write_text(at, " deg, ");
}

/* z, x and y, the largest component first; of equal ones in this order. */
static void rank(const invcal_real up[3], unsigned axis[3])
{
    axis[0] = 2;
    axis[1] = 0;
    axis[2] = 1;
    for (unsigned i = 0; i < 3; i++) { /* pairs 0 1, 1 2, 0 1: sorted */
        const unsigned k = i % 2;
        if (INVCAL_FABS(up[axis[k + 1]]) > INVCAL_FABS(up[axis[k]]) + FIRST) {
            const unsigned other = axis[k];
            axis[k] = axis[k + 1];
            axis[k + 1] = other;
        }
    }
}

void invcal_guidance_words(const invcal_real up[3], char words[INVCAL_GUIDANCE_WORDS])
{
    unsigned axis[3];

    INVCAL_ASSERT(up && words);
    rank(up, axis);
    char *at = write_text(append_axis(words, up, axis[0]), " up");
    if (INVCAL_FABS(up[axis[1]]) > NAMED) {
        const int both = INVCAL_FABS(up[axis[2]]) > NAMED;
        at = append_tilt(at, INVCAL_FABS(up[axis[0]]));
        at = append_axis(at, up, axis[1]);
        if (both) {
            at = append_axis(write_text(at, " and "), up, axis[2]);
        }
        at = write_text(at, both ? " rise" : " rises");
    }
    *at = '\0';
}
