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
#include "invcal/invcal.h"
#include "positions.h"

#if INVCAL_DOUBLE || FLT_EVAL_METHOD
#error "the digest is that of the float build, where floats are computed as floats"
#endif

enum { MAX_POSITIONS = 48 };
static float raw[MAX_POSITIONS][3];

/* ---- output --------------------------------------------------------------------------------- */

static uint32_t digest;

/* A line: what it is, and its bits. */
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

static void solution_results(const invcal_solution *solution)
{
    results("offset", solution->calibration.offset, 3);
    results("matrix", &solution->calibration.matrix[0][0], 9);
    results("delta", solution->delta, 3);
    results("dk", solution->dk, 3);
    results("gamma", solution->gamma, 3);
}

static void quality_results(const invcal_quality *quality)
{
    results("sigma_offset", quality->sigma_offset, 3);
    results("sigma_delta", quality->sigma_delta, 3);
    results("sigma_dk", quality->sigma_dk, 3);
    results("sigma_gamma", quality->sigma_gamma, 3);
    results("noise", &quality->noise, 1);
    results("dof", &quality->dof, 1);
    results("coverage", &quality->coverage, 1);
    results("residual_rms", &quality->residual_rms, 1);
    results("residual_max", &quality->residual_max, 1);
    results("condition", &quality->condition, 1);
    result("worst", quality->worst);
    result("undetermined", quality->undetermined);
    result("from_prior", quality->from_prior);
    result("verdict", quality->verdict);
}

static void calibrate(const char *name, unsigned count, const invcal_settings *settings)
{
    invcal_solution solution;
    invcal_quality quality;
    invcal_reason reason;
    const invcal_status status =
        invcal_calibrate(&raw[0][0], count, settings, &solution, &quality, &reason);

    report_text("set ");
    report_text(name);
    board_put('\n');
    result("status", status);
    if (status == INVCAL_OK) {
        solution_results(&solution);
        quality_results(&quality);
    } else {
        result("position", reason.position);
        result("undetermined", reason.undetermined);
    }
}

/* ---- real sensors --------------------------------------------------------------------------- */

static void real_set(const char *name, const double position[][3], unsigned count, double gravity,
                     const double zero[3], const double lsb[3])
{
    invcal_settings settings = {.field = (float)gravity};

    if (count > MAX_POSITIONS) {
        board_exit(1);
    }
    for (unsigned axis = 0; axis < 3; axis++) {
        settings.nominal.offset[axis] = (float)zero[axis];
        settings.nominal.matrix[axis][axis] = (float)lsb[axis];
        for (unsigned i = 0; i < count; i++) {
            raw[i][axis] = (float)position[i][axis];
        }
    }
    calibrate(name, count, &settings);
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

/* All directions alike: a point in the unit ball, and outwards from there. */
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

static invcal_settings counts(void)
{
    invcal_settings settings = {.field = 1, .noise = 1e-3f};

    for (int axis = 0; axis < 3; axis++) {
        settings.nominal.offset[axis] = 32768;
        settings.nominal.matrix[axis][axis] = 1.0f / 4096;
    }
    return settings;
}

static void simulated_sets(void)
{
    invcal_settings settings = counts();

    for (unsigned count = 9; count <= 24; count++) {
        simulate(count, count % 2 ? 0.01f : 0.1f, 1e-3f);
        settings.frame = count % 3 ? INVCAL_FRAME_SYMMETRIC : INVCAL_FRAME_TRIANGULAR;
        calibrate("simulated", count, &settings);
    }
    settings.noise = 0;
    calibrate("unknown noise", 24, &settings);
}

static void sets_with_a_prior(void)
{
    invcal_settings settings = counts();

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        settings.prior[r] = 0.02f;
    }
    for (unsigned count = 4; count <= 12; count += 4) {
        simulate(count, 0.02f, 1e-3f);
        calibrate("prior", count, &settings);
    }
}

/* ---- refusals ------------------------------------------------------------------------------- */

static void refusals(void)
{
    invcal_settings settings = counts();

    simulate(18, 0.02f, 1e-3f);
    calibrate("too few", 8, &settings);
    settings.field = 0;
    calibrate("no field", 18, &settings);
    settings.field = 1;
    raw[11][1] = NAN;
    calibrate("not finite", 18, &settings);
    memcpy(raw[11], settings.nominal.offset, sizeof raw[11]);
    calibrate("out of range", 18, &settings);
    simulate(18, 0.02f, 0.5f);
    calibrate("not of one length", 18, &settings);
    simulate(18, 0, 0);
    for (int i = 0; i < 18; i++) {
        raw[i][2] = raw[0][2];
    }
    calibrate("at one height", 18, &settings);
}

int main(void)
{
    REAL_SET(xsens_mti);
    REAL_SET(mpu9150_0);
    REAL_SET(mpu9150_1);
    REAL_SET(t265);
    simulated_sets();
    sets_with_a_prior();
    refusals();
    put_line("digest", digest);
    return 0;
}
