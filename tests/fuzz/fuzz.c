/* SPDX-License-Identifier: MIT */
#include "fuzz.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

invcal_settings take_settings(source *s)
{
    enum { NOMINAL = 1, FIELD = 2, NOISE = 4, PRIOR = 8, TRIANGULAR = 16, FRAME = 32 };
    const unsigned unusual = take_byte(s);
    invcal_settings settings;

    memset(&settings, 0, sizeof settings);
    for (unsigned i = 0; i < 3; i++) {
        settings.nominal.matrix[i][i] = INVCAL_REAL(0.001);
    }
    settings.field = 1;
    if (unusual & NOMINAL) {
        take_nominal(s, &settings.nominal);
    }
    if (unusual & FIELD) {
        settings.field = take_real(s, 1);
    }
    if (unusual & NOISE) {
        settings.noise = take_real(s, INVCAL_REAL(0.0001));
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS && unusual & PRIOR; r++) {
        settings.prior[r] = take_real(s, INVCAL_REAL(0.05));
    }
    settings.frame = unusual & TRIANGULAR ? INVCAL_FRAME_TRIANGULAR : INVCAL_FRAME_SYMMETRIC;
    if (unusual & FRAME) {
        settings.frame = (invcal_frame)take_byte(s);
    }
    return settings;
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

void require_calibration(const invcal_calibration *calibration)
{
    invcal_real inverse[3][3];

    require_finite(calibration->offset, 3);
    require_finite(&calibration->matrix[0][0], 9);
    REQUIRE(invcal_calibration_inverse(calibration, inverse) == INVCAL_OK);
}

/* Sylvester, in double, of I + S and of its distance to the limits. */
static int is_definite(double shift, double sign, const invcal_solution *solution)
{
    const double x = shift + sign * (double)solution->dk[0];
    const double y = shift + sign * (double)solution->dk[1];
    const double z = shift + sign * (double)solution->dk[2];
    const double xy = sign * (double)solution->gamma[0] / 2;
    const double xz = sign * (double)solution->gamma[1] / 2;
    const double yz = sign * (double)solution->gamma[2] / 2;

    return x > 0 && x * y - xy * xy > 0 &&
           x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz) > 0;
}

void require_solution(const invcal_solution *solution)
{
    const double slack = 1e-3; /* the limits are those of the library, but for rounding */

    require_finite(solution->delta, 3);
    require_finite(solution->dk, 3);
    require_finite(solution->gamma, 3);
    REQUIRE(is_definite(1 - 0.1 + slack, 1, solution));
    REQUIRE(is_definite(10 * (1 + slack) - 1, -1, solution));
    require_finite(solution->calibration.offset, 3);
    require_finite(&solution->calibration.matrix[0][0], 9);
}

void require_quality(const invcal_quality *quality)
{
    require_sigma(quality->sigma_offset, 3);
    require_sigma(quality->sigma_delta, 3);
    require_sigma(quality->sigma_dk, 3);
    require_sigma(quality->sigma_gamma, 3);
    require_sigma(&quality->noise, 1);
    require_sigma(&quality->dof, 1);
    require_sigma(&quality->residual_rms, 1);
    require_sigma(&quality->residual_max, 1);
    require_finite(&quality->condition, 1);
    REQUIRE(quality->noise > 0 && quality->condition >= 1);
    REQUIRE(quality->coverage > 1 && quality->coverage < 13);
    REQUIRE(quality->verdict <= INVCAL_WEAK);
    REQUIRE(quality->undetermined < 1u << INVCAL_PARAMETERS);
    REQUIRE(quality->from_prior < 1u << INVCAL_PARAMETERS);
    REQUIRE((quality->verdict == INVCAL_WEAK) == (quality->undetermined != 0));
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
