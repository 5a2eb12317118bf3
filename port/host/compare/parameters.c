/* SPDX-License-Identifier: MIT
 *
 * The nine parameters by which calibrations are compared.
 *
 * In a calibration the sensor reads raw = offset + G a, G = matrix^-1. Row i of G is the sensitive
 * axis of sensor i: its length is the scale, and its angles with the other two differ from 90
 * degrees by gamma,
 *
 *     scale_i = |G_i|,     sin gamma_ij = G_i G_j / (|G_i| |G_j|)
 *
 * Lengths of readings do not determine the rotation of the calibrated axes: matrix and R matrix are
 * the same calibration for any rotation R; G becomes G R', and neither of the two changes. Two
 * calibrations may therefore have different nominals, and so slightly rotated frames.
 *
 * The nominal is the older calibration, or the median of a fleet: zero o, scales N. The sensor
 * reads, over the field, u = (I + S) eta + delta with I + S = N^-1 G, and
 *
 *     delta_i = (offset_i - o_i) / (N_i field),   1 + dk_i = S_i's length = scale_i / N_i
 *
 * which to first order are delta, dk and gamma = S_ij + S_ji of invcal_deviation. The angles of the
 * nominal are not 0: the deviation of an angle is the difference from them.
 *
 * Sigma in a file is relative to its own nominal, of scales 1 / lsb: that of dk times 1 / lsb is
 * sigma of the scale, and that of gamma is for S_ij + S_ji, whose rows are scaled by 1 / (lsb
 * scale). Sigma of dk includes the uncertainty of the field. */
#include <math.h>
#include <string.h>

#include "compare/compare.h"
#include "invcal/result.h"
#include "maths/matrix.h"

#define DOF_MAX 1000u /* more make no difference */

/* The sensors of angles xy, xz, zy. */
static const unsigned pair[3][2] = {{0, 1}, {0, 2}, {2, 1}};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* From the coverage factor for 95 %, which falls with the degrees of freedom. */
static unsigned dof_of(double interval)
{
    unsigned dof = 1;

    while (dof < DOF_MAX && invcal_coverage(dof) > interval * (1 + 1e-9)) {
        dof++;
    }
    return dof;
}

static void find_sigma(const calibration_file *file, compare_item *item)
{
    double ratio[3]; /* of the nominal scale to that of the sensor */

    for (unsigned i = 0; i < 3; i++) {
        const double scale = item->x[INVCAL_DK_X + i];
        const double nominal = fabs(1 / file->lsb[i]);
        ratio[i] = isfinite(nominal) ? nominal / fabs(scale) : 1;
        item->sigma[INVCAL_DELTA_X + i] = file->sigma_offset[i];
        item->sigma[INVCAL_DK_X + i] = file->sigma_dk[i] * ratio[i] * fabs(scale);
        item->field_sigma[i] = file->gravity_sigma > 0
                                   ? file->gravity_sigma / file->gravity * ratio[i] * fabs(scale)
                                   : 0;
    }
    for (unsigned k = 0; k < 3; k++) {
        item->sigma[INVCAL_GAMMA_XY + k] =
            file->sigma_gamma[k] * (ratio[pair[k][0]] + ratio[pair[k][1]]) / 2;
    }
    item->dof = dof_of(file->interval);
}

void compare_parameters(const calibration_file *file, const invcal_calibration *calibration,
                        compare_item *item)
{
    double g[3][3] = {{0}};
    double sign[3];

    (void)matrix_inverse(calibration, g); /* checked when the file was read */
    for (unsigned i = 0; i < 3; i++) {
        /* An axis may be reversed; in the frame of a stand, the sign shows the mounting. */
        sign[i] = g[i][i] < 0 && strcmp(file->frame, "stand") != 0 ? -1 : 1;
        item->x[INVCAL_DELTA_X + i] = calibration->offset[i];
        item->x[INVCAL_DK_X + i] = sign[i] * sqrt(dot(g[i], g[i]));
    }
    for (unsigned k = 0; k < 3; k++) {
        const unsigned i = pair[k][0];
        const unsigned j = pair[k][1];
        const double lengths = item->x[INVCAL_DK_X + i] * item->x[INVCAL_DK_X + j];
        item->x[INVCAL_GAMMA_XY + k] = asin(dot(g[i], g[j]) / lengths);
    }
    find_sigma(file, item);
}

double compare_divisor(const double nominal[INVCAL_PARAMETERS], double field, unsigned p)
{
    return p >= INVCAL_GAMMA_XY ? 1
           : p >= INVCAL_DK_X   ? nominal[p]
                                : nominal[INVCAL_DK_X + p] * field;
}
