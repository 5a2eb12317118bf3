/* SPDX-License-Identifier: MIT
 *
 * The rotation from the calibrated axes to those of the case (mathematics_imu.md, "The frame of the
 * case"). Rests are kept as one 3x3 sum, B = sum c a', whose orthonormal factor is the
 * least-squares rotation (Wahba's problem). Newton's iteration of solve.c finds it, so no singular
 * values are computed.
 */
#include "invcal/frame.h"

#include <limits.h>
#include <string.h>

#include "../core/solve.h"
#include "../core/vector.h"

/* Min squared product of the two larger singular values of the sums, whose three add up to 3 if all
 * directions agree. It is reached by two faces 26 degrees apart; two at 90 degrees give 5. */
#define LEAST_SPREAD INVCAL_REAL(0.18)
#define LEAST_LEVEL INVCAL_REAL(0.25) /* of 1 + cos */
/* Min length of the mean direction of rests in one orientation: two may be 51 degrees apart. */
#define LEAST_MEAN INVCAL_REAL(0.9)

void invcal_frame_init(invcal_frame *frame)
{
    INVCAL_ASSERT(frame);
    invcali_zero(frame, sizeof *frame);
}

invcal_status invcal_frame_add(invcal_frame *frame, const invcal_calibration *calibration,
                               const invcal_real raw[3], const invcal_real up[3])
{
    invcal_real a[3];

    INVCAL_ASSERT(frame && calibration && raw && up);
    invcali_correct(calibration, raw, a);
    const invcal_real length = INVCAL_SQRT(invcali_dot3(a, a));
    if (!invcali_are_finite(a)) {
        return INVCAL_NOT_FINITE;
    }
    if (!(length >= INVCAL_REAL(0.5) && length <= 2)) {
        return INVCAL_OUT_OF_RANGE;
    }
    if (!invcali_is_unit(up)) {
        return INVCAL_BAD_DIRECTION;
    }
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            frame->own_sum[i][j] += up[i] * a[j] / length;
        }
    }
    frame->count += frame->count < UINT_MAX;
    return INVCAL_OK;
}

/* Covariance of the angles: (tr S I - S)^-1 with S = sum c a' R', or tr S I - S = sum (I - c c'),
 * since a direction determines no turn about itself. */
static void judge_frame(const invcal_frame *frame, const invcal_rotation *rotation,
                        invcal_frame_quality *quality)
{
    invcal_real information[3][3];
    invcal_real covariance[3][3];
    invcal_real trace = 0;

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            information[i][j] = -invcali_dot3(frame->own_sum[i], rotation->r[j]);
        }
        trace -= information[i][i];
    }
    for (unsigned i = 0; i < 3; i++) {
        information[i][i] += trace;
    }
    invcali_inverse3((const invcal_real(*)[3])information, covariance);
    for (unsigned i = 0; i < 3; i++) {
        quality->sigma[i] = INVCAL_SQRT(covariance[i][i]);
    }
    const invcal_real off =
        2 - 2 * trace / invcali_number(frame->count); /* of |c - R a|^2, the mean */
    quality->scatter = off > 0 ? INVCAL_SQRT(off) : 0;
}

/* With singular values s of the sums B, |C| of its cofactors C is s1 s2, and B + C has the same
 * directions: so two faces, with s3 = 0, still determine R as the orthonormal factor of B + C. */
invcal_status invcal_frame_solve(const invcal_frame *frame, invcal_rotation *out,
                                 invcal_frame_quality *quality)
{
    invcal_real work[INVCAL_WORK];
    invcal_real b[3][3];
    invcal_real(*c)[3] = (invcal_real(*)[3])work;

    INVCAL_ASSERT(frame && out);
    if (frame->count < 2) {
        return INVCAL_TOO_FEW;
    }
    /* as LEAST_SPREAD expects, for any number of rests */
    const invcal_real scale = 3 / invcali_number(frame->count);
    for (unsigned i = 0; i < 9; i++) {
        b[i / 3][i % 3] = scale * frame->own_sum[i / 3][i % 3];
    }
    (void)invcali_cofactors((const invcal_real(*)[3])b, c);
    for (unsigned i = 0; i < 9; i++) {
        b[i / 3][i % 3] += c[i / 3][i % 3];
    }
    if (!(invcali_cofactors((const invcal_real(*)[3])b, c) > LEAST_SPREAD)) {
        return INVCAL_UNDETERMINED;
    }
    invcali_make_symmetric(b, work);
    memcpy(out->r, work, sizeof out->r);
    if (quality != NULL) {
        judge_frame(frame, out, quality);
    }
    return INVCAL_OK;
}

/* The sum of the readings a, each times c.up: their number if all agree. Returns its length. */
static invcal_real sum_along(const invcal_frame *frame, const invcal_real up[3], invcal_real a[3])
{
    for (unsigned j = 0; j < 3; j++) {
        a[j] = up[0] * frame->own_sum[0][j] + up[1] * frame->own_sum[1][j] +
               up[2] * frame->own_sum[2][j];
    }
    return INVCAL_SQRT(invcali_dot3(a, a));
}

/* With v = a x c: I + [v] + [v]^2 / (1 + a.c), [v]^2 = v v' - v.v I. Near half a turn a and c are
 * opposite, and v no longer shows the axis: more than 139 degrees, LEAST_LEVEL, are refused. The
 * mean direction is no reading of `up` if it is short: the rests contradict each other. */
invcal_status invcal_frame_level(const invcal_frame *frame, const invcal_real up[3],
                                 invcal_rotation *out)
{
    invcal_real a[3];
    invcal_real v[3];

    INVCAL_ASSERT(frame && up && out);
    if (frame->count < 1) {
        return INVCAL_TOO_FEW;
    }
    const invcal_real length = sum_along(frame, up, a);
    const invcal_real c = 1 + invcali_dot3(a, up) / length;
    if (!(c > LEAST_LEVEL && length >= LEAST_MEAN * invcali_number(frame->count))) {
        return INVCAL_UNDETERMINED;
    }
    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = (i + 1) % 3;
        const unsigned k = (i + 2) % 3;
        v[i] = (a[j] * up[k] - a[k] * up[j]) / length;
    }
    const invcal_real square = invcali_dot3(v, v);
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            out->r[i][j] = v[i] * v[j] / c;
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = (i + 1) % 3;
        const unsigned k = (i + 2) % 3;
        out->r[i][i] += 1 - square / c;
        out->r[j][k] -= v[i];
        out->r[k][j] += v[i];
    }
    return INVCAL_OK;
}

void invcal_rotate(invcal_calibration *calibration, const invcal_rotation *rotation)
{
    invcal_real column[3];

    INVCAL_ASSERT(calibration && rotation);
    for (unsigned j = 0; j < 3; j++) {
        for (unsigned i = 0; i < 3; i++) {
            column[i] = calibration->matrix[i][j];
        }
        for (unsigned i = 0; i < 3; i++) {
            calibration->matrix[i][j] = invcali_dot3(rotation->r[i], column);
        }
    }
}
