/* SPDX-License-Identifier: MIT */
#include "core/vector.h"
#include "fuzz.h"
#include "invcal/background.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/solve.h"

uint8_t take_byte(source *s)
{
    if (s->left == 0) {
        return 0;
    }
    s->left--;
    return *s->at++;
}

uint32_t take_u32(source *s)
{
    uint32_t value = 0;

    for (unsigned i = 0; i < 4; i++) {
        value |= (uint32_t)take_byte(s) << 8 * i;
    }
    return value;
}

int32_t take_i32(source *s)
{
    const uint32_t bits = take_u32(s);
    int32_t value;

    memcpy(&value, &bits, sizeof value);
    return value;
}

static invcal_real take_special(source *s)
{
    const invcal_real largest = INVCAL_REAL_MAX;
    const invcal_real special[] = {
        0,
        -(invcal_real)0,
        (invcal_real)NAN,
        (invcal_real)INFINITY,
        -(invcal_real)INFINITY,
        largest,
        -largest,
        INVCAL_DOUBLE ? (invcal_real)DBL_MIN : (invcal_real)FLT_MIN,
        1 / largest, /* denormal */
        INVCAL_EPSILON,
        1 + INVCAL_EPSILON,
        INVCAL_SQRT(largest),
        (invcal_real)4294967296.0,
    };

    return special[take_byte(s) % (sizeof special / sizeof special[0])];
}

static invcal_real take_bits(source *s)
{
    uint8_t bytes[sizeof(invcal_real)];
    invcal_real value;

    for (unsigned i = 0; i < sizeof bytes; i++) {
        bytes[i] = take_byte(s);
    }
    memcpy(&value, bytes, sizeof value);
    return value;
}

invcal_real take_real(source *s, invcal_real usual)
{
    switch (take_byte(s) % 8) {
    case 1: /* within 25 % */
        return usual * (1 + (invcal_real)((int)take_byte(s) - 128) / 512);
    case 2:
        return (invcal_real)((int)take_byte(s) - 128) / 64;
    case 3: /* float has them from -45 to 38 */
        return (invcal_real)pow(10, (int)take_byte(s) % 90 - 48);
    case 4:
        return take_special(s);
    case 5:
        return take_bits(s);
    default:
        return usual;
    }
}

static void take_nominal(source *s, invcal_calibration *nominal)
{
    for (unsigned i = 0; i < 3; i++) {
        nominal->offset[i] = take_real(s, nominal->offset[i]);
        for (unsigned j = 0; j < 3; j++) {
            nominal->matrix[i][j] = take_real(s, nominal->matrix[i][j]);
        }
    }
}

conditions take_conditions(source *s)
{
    enum { NOMINAL = 1, FIELD = 2, NOISE = 4, PRIOR = 8, TRIANGULAR = 16 };
    const unsigned unusual = take_byte(s);
    conditions c;

    memset(&c, 0, sizeof c);
    for (unsigned i = 0; i < 3; i++) {
        c.nominal.matrix[i][i] = INVCAL_REAL(0.001);
    }
    c.field = 1;
    if (unusual & NOMINAL) {
        take_nominal(s, &c.nominal);
    }
    if (unusual & FIELD) {
        c.field = take_real(s, 1);
    }
    if (unusual & NOISE) {
        c.noise = take_real(s, INVCAL_REAL(0.0001));
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS && unusual & PRIOR; r++) {
        c.prior[r] = take_real(s, INVCAL_REAL(0.05));
    }
    c.is_triangular = (unusual & TRIANGULAR) != 0;
    return c;
}

void direction_of(unsigned number, invcal_real up[3])
{
    /* A spiral from pole to pole, the golden angle from one to the next. */
    const double z = 1 - (2 * (number % 24) + 1) / 24.0;
    const double angle = 2.39996 * (number % 24);

    up[0] = (invcal_real)(sqrt(1 - z * z) * cos(angle));
    up[1] = (invcal_real)(sqrt(1 - z * z) * sin(angle));
    up[2] = (invcal_real)z;
}

void fuzz_fail(const char *file, int line, const char *condition, const char *function)
{
    fprintf(stderr, "%s:%d: %s: does not hold: %s\n", file, line, function, condition);
    abort();
}

int is_finite(invcal_real x)
{
    return INVCAL_FABS(x) <= INVCAL_REAL_MAX;
}

void require_finite(const invcal_real *x, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        REQUIRE(is_finite(x[i]));
    }
}

void require_sigma(const invcal_real *x, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        REQUIRE(is_finite(x[i]) && x[i] >= 0);
    }
}

void require_regular(const invcal_calibration *calibration)
{
    require_finite(calibration->offset, 3);
    require_finite(&calibration->matrix[0][0], 9);
    REQUIRE(invcali_nominal_check(calibration) == INVCAL_OK);
}

/* ---- solutions, looked at in double ----------------------------------------------------------- */

/* m^-1, and the product of the lengths of the rows over the determinant, which is the more above 1, the
 * more they lean towards each other. */
static double invert(const invcal_real m[3][3], double inverse[3][3])
{
    double c[3][3];
    double lengths = 1;

    for (unsigned i = 0; i < 3; i++) {
        const invcal_real *a = m[(i + 1) % 3];
        const invcal_real *b = m[(i + 2) % 3];
        double square = 0;
        for (unsigned j = 0; j < 3; j++) {
            const unsigned k = (j + 1) % 3;
            const unsigned l = (j + 2) % 3;
            c[i][j] = (double)a[k] * (double)b[l] - (double)a[l] * (double)b[k];
            square += (double)m[i][j] * (double)m[i][j];
        }
        lengths *= sqrt(square);
    }
    const double det =
        (double)m[0][0] * c[0][0] + (double)m[0][1] * c[0][1] + (double)m[0][2] * c[0][2];
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            inverse[i][j] = c[j][i] / det;
        }
    }
    return lengths / fabs(det);
}

/* I + S = N M^-1. */
static void axes_of(const invcal_calibration *calibration, const invcal_calibration *nominal,
                    double p[3][3])
{
    double inverse[3][3];

    (void)invert((const invcal_real(*)[3])calibration->matrix, inverse);
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            p[i][j] = 0;
            for (unsigned k = 0; k < 3; k++) {
                p[i][j] += (double)nominal->matrix[i][k] * inverse[k][j];
            }
        }
    }
}

/* Sylvester's criterion, for the symmetric part of p minus `shift`. */
static int is_definite(double shift, double p[3][3])
{
    const double x = p[0][0] - shift;
    const double y = p[1][1] - shift;
    const double z = p[2][2] - shift;
    const double xy = (p[0][1] + p[1][0]) / 2;
    const double xz = (p[0][2] + p[2][0]) / 2;
    const double yz = (p[1][2] + p[2][1]) / 2;

    return x > 0 && x * y - xy * xy > 0 &&
           x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz) > 0;
}

/* How far the centre is from the zero of nominal; and how much of that the rounding of a large zero hides. */
static double centre_of(const invcal_calibration *calibration, const invcal_calibration *nominal,
                        double *hidden)
{
    double square = 0;
    double lost = 0;

    for (unsigned i = 0; i < 3; i++) {
        double delta = 0;
        for (unsigned j = 0; j < 3; j++) {
            const double n = (double)nominal->matrix[i][j];
            delta += n * ((double)calibration->offset[j] - (double)nominal->offset[j]);
            lost += fabs(n * (double)calibration->offset[j]) + fabs(n * (double)nominal->offset[j]);
        }
        square += delta * delta;
    }
    *hidden = lost * (double)INVCAL_EPSILON;
    return sqrt(square);
}

void require_calibration(const invcal_calibration *calibration, const invcal_calibration *nominal,
                         int is_of_angles)
{
    double unused[3][3];
    double p[3][3];
    double hidden;

    require_finite(calibration->offset, 3);
    require_finite(&calibration->matrix[0][0], 9);
    const double leaning = invert((const invcal_real(*)[3])nominal->matrix, unused);
    const double slack = 1e-3 + 1000 * leaning * (double)INVCAL_EPSILON;
    if (slack < 0.05) { /* the limits are the library's, up to rounding */
        axes_of(calibration, nominal, p);
        REQUIRE(is_definite((is_of_angles ? 1 / 30.0 : 0.1) - slack, p));
        REQUIRE(centre_of(calibration, nominal, &hidden) <
                (is_of_angles ? 17.33 : 10) * (1 + slack) + hidden);
    }
}

void require_solution(const invcal_calibration *calibration, const conditions *c)
{
    invcal_calibration other = *calibration;
    invcal_real x[INVCAL_PARAMETERS];

    require_calibration(calibration, &c->nominal, c->is_linear);
    invcal_deviation(calibration, &c->nominal, x);
    require_finite(x, INVCAL_PARAMETERS);
    if (c->is_triangular) {
        invcali_make_triangular(&other, &c->nominal);
        require_finite(&other.matrix[0][0], 9);
        REQUIRE(memcmp(other.offset, calibration->offset, sizeof other.offset) == 0);
    }
    const invcal_calibration before = other;
    const int is_field = is_finite(c->field) && c->field > 0;
    REQUIRE((invcal_scale(&other, c->field) == INVCAL_OK) == is_field);
    if (!is_field || c->field == 1) {
        REQUIRE(memcmp(&before, &other, sizeof other) == 0);
    }
}

unsigned count_bits(invcal_mask set)
{
    unsigned count = 0;

    for (; set > 0; set &= set - 1) {
        count++;
    }
    return count;
}

void require_quality(const invcal_quality *q, unsigned count)
{
    const invcal_real coverage = invcal_coverage(q->sigma_dof);

    require_sigma(q->sigma, INVCAL_PARAMETERS);
    require_sigma(&q->noise, 1);
    require_sigma(&q->rms, 1);
    require_sigma(&q->max, 1);
    REQUIRE(q->noise > 0 && q->condition >= 1);
    REQUIRE(q->rms <= INVCAL_REAL(0.1) && q->rms <= q->max * INVCAL_REAL(1.0001));
    REQUIRE(coverage > 1 && coverage < 13);
    REQUIRE(q->positions > 0 && q->positions + count_bits(q->left_out) == count);
    REQUIRE(q->dof <= q->positions && q->dof <= q->sigma_dof && q->worst < count);
    REQUIRE(q->worst >= INVCAL_MAX_POSITIONS || !(q->left_out >> q->worst & 1u));
    REQUIRE(q->verdict <= INVCAL_WEAK && q->weak < 1u << INVCAL_PARAMETERS);
    REQUIRE((q->verdict == INVCAL_WEAK) == (q->weak != 0));
    REQUIRE(q->verdict > INVCAL_NO_REDUNDANCY || (q->verdict == INVCAL_GOOD) == (q->dof > 0));
    REQUIRE((q->left_out & q->suspected) == 0);
    REQUIRE(q->systematic <= INVCAL_HYSTERESIS && q->axis < 3 && (q->unchecked & ~0x1Eu) == 0);
    REQUIRE(q->verdict == INVCAL_WEAK ||
            (q->verdict == INVCAL_DRIFTING) == (q->systematic == INVCAL_DRIFT));
    REQUIRE(q->verdict == INVCAL_WEAK ||
            (q->verdict == INVCAL_BENT) == (q->systematic > INVCAL_DRIFT));
    require_finite(&q->size, 1);
    REQUIRE(!invcal_improves(q, q));
}

/* A stated noise counts as four residuals, unless the residuals speak against it: then it does not count. (Repeated
 * directions leave dof, not sigma_dof.) */
void require_noise(const invcal_quality *q, invcal_real stated)
{
    const double least = (double)stated * sqrt(4.0 / (4.0 + q->positions));

    REQUIRE(q->sigma_dof == q->dof || q->sigma_dof + INVCAL_PARAMETERS == q->positions ||
            (double)q->noise >= least * (1 - 8 * (double)INVCAL_EPSILON));
}

void require_direction(const invcal_real up[3])
{
    const double square = (double)up[0] * (double)up[0] + (double)up[1] * (double)up[1] +
                          (double)up[2] * (double)up[2];

    REQUIRE(fabs(square - 1) < 1e-5);
}

enum { MARK = 0xA5 };

void mark(void *object, size_t size)
{
    memset(object, MARK, size);
}

void require_mark(const void *object, size_t size)
{
    const uint8_t *bytes = object;

    for (size_t i = 0; i < size; i++) {
        REQUIRE(bytes[i] == MARK);
    }
}
