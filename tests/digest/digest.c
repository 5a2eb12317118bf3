/* SPDX-License-Identifier: MIT
 *
 * Calibrates fixed sets of positions and prints the bits of every number that comes out, a line
 * each, and at the end a CRC-32 of all of them: equal on all machines with IEEE-754 floats.
 * What goes in is equal everywhere too: decimal constants, integers, + - * / and square roots.
 */
#include <math.h>
#include <string.h>

#include "../../src/bytes.h"
#include "../report.h"
#include "expected.h"
#include "invcal/expert.h"
#include "positions.h"

#if INVCAL_DOUBLE || FLT_EVAL_METHOD
#error "the digest is that of the float build, where floats are computed as floats"
#endif

enum { MOST = 48 }; /* positions */
static float raw[MOST][3];
static invcal_calibration nominal;

/* ---- output --------------------------------------------------------------------------------- */

static uint32_t digest;

/* A line: a name and bits. */
static void put_line(const char *name, uint32_t bits)
{
    report_text(name);
    board_put(' ');
    for (int shift = 28; shift >= 0; shift -= 4) {
        board_put("0123456789ABCDEF"[bits >> shift & 0xFu]);
    }
    board_put('\n');
}

static void result(const char *name, uint32_t bits)
{
    uint8_t bytes[4];

    invcal_put_u32(bytes, bits);
    digest = invcal_crc32(digest, bytes, sizeof bytes);
    put_line(name, bits);
}

static void results(const char *name, const float *x, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &x[i], sizeof bits);
        result(name, bits);
    }
}

/* ---- calibrations --------------------------------------------------------------------------- */

static void calibration_results(const invcal_calibration *calibration)
{
    float x[INVCAL_PARAMETERS];

    invcal_deviation(calibration, &nominal, x);
    results("offset", calibration->offset, 3);
    results("matrix", &calibration->matrix[0][0], 9);
    results("deviation", x, INVCAL_PARAMETERS);
}

static void quality_results(const invcal_quality *quality)
{
    const float coverage = invcal_coverage(quality->sigma_dof);
    float sigma[3];

    invcal_sigma_offset(quality, &nominal, sigma);
    results("sigma_offset", sigma, 3);
    results("sigma", quality->sigma, INVCAL_PARAMETERS);
    results("noise", &quality->noise, 1);
    results("rms", &quality->rms, 1);
    results("max", &quality->max, 1);
    results("condition", &quality->condition, 1);
    results("coverage", &coverage, 1);
    results("size", &quality->size, 1);
    result("left_out", (uint32_t)quality->left_out);
    result("suspected", (uint32_t)quality->suspected);
    result("weak", quality->weak);
    result("positions", quality->positions);
    result("dof", quality->dof);
    result("sigma_dof", quality->sigma_dof);
    result("worst", quality->worst);
    result("systematic", quality->systematic);
    result("axis", quality->axis);
    result("unchecked", quality->unchecked);
    result("verdict", quality->verdict);
}

static void begin_set(const char *name, invcal_status status)
{
    report_text("set ");
    report_text(name);
    board_put('\n');
    result("status", status);
}

static void calibrate(const char *name, unsigned count, float noise)
{
    invcal_calibration calibration;
    invcal_quality quality;
    const invcal_status status =
        invcal_calibrate(raw[0], count, &nominal, noise, &calibration, &quality);

    begin_set(name, status);
    if (status != INVCAL_OK) {
        result("position", invcal_bad_reading(raw[0], count, &nominal));
        result("undetermined", invcal_undetermined(raw[0], count, &nominal));
        return;
    }
    calibration_results(&calibration);
    quality_results(&quality);
    invcal_make_triangular(&calibration, &nominal);
    results("triangular", &calibration.matrix[0][0], 9);
}

/* ---- real sensors --------------------------------------------------------------------------- */

static void real_set(const char *name, const double position[][3], unsigned count, double gravity,
                     const double zero[3], const double lsb[3])
{
    if (count > MOST) {
        board_exit(1);
    }
    memset(&nominal, 0, sizeof nominal);
    for (unsigned axis = 0; axis < 3; axis++) {
        nominal.offset[axis] = (float)zero[axis];
        nominal.matrix[axis][axis] = (float)lsb[axis] / (float)gravity;
        for (unsigned i = 0; i < count; i++) {
            raw[i][axis] = (float)position[i][axis];
        }
    }
    calibrate(name, count, 0);
}

#define REAL_SET(name)                                                                             \
    real_set(#name, name##_positions, sizeof name##_positions / sizeof name##_positions[0],        \
             expected_##name##_gravity, expected_##name##_zero, expected_##name##_lsb)

/* ---- simulated sensors: a field of 1, 4096 counts ------------------------------------------- */

static uint32_t state = UINT32_C(2463534242); /* of the random source, xorshift32 */

/* -1 ... 1, exact in a float. */
static float random_uniform(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return (float)(state >> 8) / 8388608 - 1;
}

/* Uniform in direction: a random point in the unit ball, projected outwards. */
static void random_direction(float eta[3])
{
    float square;

    do {
        for (int i = 0; i < 3; i++) {
            eta[i] = random_uniform();
        }
        square = eta[0] * eta[0] + eta[1] * eta[1] + eta[2] * eta[2];
    } while (square > 1 || square < 0.1f);
    for (int i = 0; i < 3; i++) {
        eta[i] /= sqrtf(square);
    }
}

/* Parameters within +- size, and readings that are wrong by up to +- noise. */
static void simulate(unsigned count, float size, float noise)
{
    float x[INVCAL_PARAMETERS];

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        x[r] = size * random_uniform();
    }
    for (unsigned i = 0; i < count; i++) {
        float e[3];
        random_direction(e);
        const float u[3] = {
            (1 + x[3]) * e[0] + x[6] / 2 * e[1] + x[7] / 2 * e[2] + x[0],
            x[6] / 2 * e[0] + (1 + x[4]) * e[1] + x[8] / 2 * e[2] + x[1],
            x[7] / 2 * e[0] + x[8] / 2 * e[1] + (1 + x[5]) * e[2] + x[2],
        };
        for (int axis = 0; axis < 3; axis++) {
            raw[i][axis] = 32768 + 4096 * (u[axis] + noise * random_uniform());
        }
    }
}

static void counts(void)
{
    static const float zero[3] = {32768, 32768, 32768};
    static const float scale[3] = {4096, 4096, 4096};

    (void)invcal_nominal(zero, scale, &nominal);
}

static void simulated_sets(void)
{
    for (unsigned count = 9; count <= 24; count++) {
        simulate(count, count % 2 ? 0.01f : 0.1f, 1e-3f);
        calibrate("simulated", count, 1e-3f);
    }
    calibrate("unknown noise", 24, 0);
}

static void sets_with_a_prior(void)
{
    float prior[INVCAL_PARAMETERS];

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        prior[r] = 0.02f;
    }
    for (unsigned count = 4; count <= 12; count += 4) {
        invcal_calibration calibration;
        invcal_quality quality;
        uint16_t from_prior;
        simulate(count, 0.02f, 1e-3f);
        const invcal_status status = invcal_calibrate_with_prior(
            raw[0], count, &nominal, 1e-3f, prior, &calibration, &quality, &from_prior);
        begin_set("prior", status);
        if (status == INVCAL_OK) {
            calibration_results(&calibration);
            quality_results(&quality);
            result("from_prior", from_prior);
        }
    }
}

static void judge(const char *name, unsigned count)
{
    invcal_calibration calibration;
    invcal_quality quality;
    const invcal_status status =
        invcal_calibrate_judged(raw[0], count, &nominal, 0, &calibration, &quality);

    begin_set(name, status);
    if (status == INVCAL_OK) {
        calibration_results(&calibration);
        quality_results(&quality);
    }
}

/* One position in six is wrong by a tenth of the field; or x drifts by a thousandth from each to
 * the next. */
static void sets_with_outliers_or_drift(void)
{
    for (unsigned count = 12; count <= 24; count += 6) {
        simulate(count, 0.02f, 1e-3f);
        for (unsigned i = 3; i < count; i += 6) {
            raw[i][i % 3] += 410;
        }
        judge("outliers", count);
        simulate(count, 0.02f, 1e-3f);
        for (unsigned i = 0; i < count; i++) {
            raw[i][0] += 4 * (float)i;
        }
        judge("drift", count);
    }
}

/* ---- refusals ------------------------------------------------------------------------------- */

static void refusals(void)
{
    simulate(18, 0.02f, 1e-3f);
    calibrate("too few", 8, 1e-3f);
    calibrate("absurd noise", 18, 1);
    raw[11][1] = NAN;
    calibrate("not finite", 18, 1e-3f);
    memcpy(raw[11], nominal.offset, sizeof raw[11]);
    calibrate("out of range", 18, 1e-3f);
    simulate(18, 0.02f, 0.5f);
    calibrate("not of one length", 18, 1e-3f);
    simulate(18, 0, 0);
    for (int i = 0; i < 18; i++) {
        raw[i][2] = raw[0][2];
    }
    calibrate("at one height", 18, 1e-3f);
}

int main(void)
{
    REAL_SET(xsens_mti);
    REAL_SET(mpu9150_0);
    REAL_SET(mpu9150_1);
    REAL_SET(t265);
    counts();
    simulated_sets();
    sets_with_a_prior();
    sets_with_outliers_or_drift();
    refusals();
    put_line("digest", digest);
    return 0;
}
