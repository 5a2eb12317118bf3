/* SPDX-License-Identifier: MIT
 *
 * Fixed sets of positions: of real sensors, simulated ones, with a prior, wrong and hopeless ones.
 */
#include "../positions.h"
#include "digest.h"
#include "plan/guidance.h"
#include "core/solve.h"

#include "board.h"
#include "expected.h"
#include "positions.h"

enum { MOST = 48 }; /* positions */
static float raw[MOST][3];
static invcal_calibration nominal;

static void begin_set(const char *name, invcal_status status)
{
    digest_set(name);
    digest_bits("status", status);
}

static void calibrate(const char *name, unsigned count, float noise)
{
    invcal_calibration calibration;
    invcal_quality quality;
    const invcal_status status = invcal_calibrate_plain(
        POSITIONS_OF(raw[0], count, &nominal, noise), &calibration, &quality);

    begin_set(name, status);
    if (status != INVCAL_OK) {
        digest_bits("position", invcal_bad_reading(POSITIONS_OF(raw[0], count, &nominal, 0)));
        digest_bits("undetermined", invcal_undetermined(POSITIONS_OF(raw[0], count, &nominal, 0)));
        return;
    }
    digest_calibration(&calibration, &nominal);
    digest_quality(&quality, &nominal);
    invcali_make_triangular(&calibration, &nominal);
    digest_reals("triangular", &calibration.matrix[0][0], 9);
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
    }
    for (unsigned axis = 0; axis < 3; axis++) {
        nominal.matrix[axis][axis] = (float)lsb[axis] / (float)gravity;
    }
    for (unsigned i = 0; i < count; i++) {
        for (unsigned axis = 0; axis < 3; axis++) {
            raw[i][axis] = (float)position[i][axis];
        }
    }
    calibrate(name, count, 0);
}

#define REAL_SET(name)                                                                             \
    real_set(#name, name##_positions, sizeof name##_positions / sizeof name##_positions[0],        \
             expected_##name##_gravity, expected_##name##_zero, expected_##name##_lsb)

/* ---- simulated sensors ---------------------------------------------------------------------- */

static void simulated_sets(void)
{
    for (unsigned count = 9; count <= 24; count++) {
        input_positions(raw, count, count % 2 ? 0.01f : 0.1f, 1e-3f);
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
        input_positions(raw, count, 0.02f, 1e-3f);
        const invcal_status status = invcal_calibrate_prior(
            POSITIONS_OF(raw[0], count, &nominal, 1e-3f), prior, &calibration, &quality);
        begin_set("prior", status);
        if (status == INVCAL_OK) {
            digest_calibration(&calibration, &nominal);
            digest_quality(&quality, &nominal);
        }
    }
}

static void six_faces(void)
{
    invcal_calibration calibration;
    invcal_quality quality;

    for (unsigned i = 0; i < 6; i++) {
        for (unsigned a = 0; a < 3; a++) {
            raw[i][a] = 32768 + 40 * input_uniform();
        }
        raw[i][i / 2] += i % 2 ? -4060 : 4150;
    }
    const invcal_status status = invcal_calibrate_faces(POSITIONS_OF(raw[0], 6, &nominal, 1e-3f),
                                                        INVCAL_CROSS_AXIS, &calibration, &quality);
    begin_set("six faces", status);
    digest_calibration(&calibration, &nominal);
    digest_quality(&quality, &nominal);
}

/* ---- positions that are wrong --------------------------------------------------------------- */

static void judge(const char *name, unsigned count)
{
    invcal_calibration calibration;
    invcal_quality quality;
    const invcal_status status =
        invcal_calibrate(POSITIONS_OF(raw[0], count, &nominal, 0), &calibration, &quality);

    begin_set(name, status);
    if (status == INVCAL_OK) {
        digest_calibration(&calibration, &nominal);
        digest_quality(&quality, &nominal);
    }
}

/* One position in six is wrong by a tenth of the field; or x drifts by a thousandth from each to
 * the next; or it is bent. */
static void sets_with_outliers_or_drift(void)
{
    for (unsigned count = 12; count <= 24; count += 6) {
        input_positions(raw, count, 0.02f, 1e-3f);
        for (unsigned i = 3; i < count; i += 6) {
            raw[i][i % 3] += 410;
        }
        judge("outliers", count);
        input_positions(raw, count, 0.02f, 1e-3f);
        for (unsigned i = 0; i < count; i++) {
            raw[i][0] += 4 * (float)i;
        }
        judge("drift", count);
        input_positions(raw, count, 0.02f, 1e-3f);
        for (unsigned i = 0; i < count; i++) {
            const float x = (raw[i][0] - 32768) / 4096;
            raw[i][0] += 80 * x * x * x;
        }
        judge("bent", count);
    }
}

/* The same without a test for drift; and which position would be next, and how good it would be. */
static void robust(void)
{
    invcal_calibration calibration;
    invcal_quality quality;
    float up[3], root[INVCAL_PARAMETERS];

    input_positions(raw, 18, 0.02f, 1e-3f);
    raw[7][0] -= 300;
    const invcal_status status =
        invcal_calibrate_robust(POSITIONS_OF(raw[0], 18, &nominal, 1e-3f), &calibration, &quality);
    begin_set("robust", status);
    digest_calibration(&calibration, &nominal);
    digest_quality(&quality, &nominal);
    invcali_next(POSITIONS_OF(raw[0], 18, &nominal, 0), up);
    digest_reals("next", up, 3);
    invcali_prospect(POSITIONS_OF(raw[0], 18, &nominal, 0), up, root);
    digest_reals("root", root, INVCAL_PARAMETERS);
}

static void refusals(void)
{
    input_positions(raw, 18, 0.02f, 1e-3f);
    calibrate("too few", 8, 1e-3f);
    calibrate("absurd noise", 18, 1);
    raw[11][1] = NAN;
    calibrate("not finite", 18, 1e-3f);
    memcpy(raw[11], nominal.offset, sizeof raw[11]);
    calibrate("out of range", 18, 1e-3f);
    input_positions(raw, 18, 0.02f, 0.5f);
    calibrate("not of one length", 18, 1e-3f);
    input_positions(raw, 18, 0, 0);
    for (int i = 0; i < 18; i++) {
        raw[i][2] = raw[0][2];
    }
    calibrate("at one height", 18, 1e-3f);
}

void part_calibrations(void)
{
    REAL_SET(xsens_mti);
    REAL_SET(mpu9150_0);
    REAL_SET(mpu9150_1);
    REAL_SET(t265);
    input_nominal(&nominal);
    simulated_sets();
    sets_with_a_prior();
    six_faces();
    sets_with_outliers_or_drift();
    robust();
    refusals();
}
