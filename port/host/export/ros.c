/* SPDX-License-Identifier: MIT */
#include "export/text.h"

static const char no_gyro[] = "imu_calib measures its bias at each start";

static void find_bias(const invcal_calibration *c, double bias[3])
{
    for (unsigned i = 0; i < 3; i++) {
        bias[i] = c->matrix[i][0] * c->offset[0] + c->matrix[i][1] * c->offset[1] +
                  c->matrix[i][2] * c->offset[2];
    }
}

static int check(const export_job *job)
{
    double bias[3];

    find_bias(&job->driver, bias);
    const int failure = export_check_range(job, bias, 3, 0);
    if (!failure) {
        export_gyro_warn(job, no_gyro);
    }
    return failure;
}

/* The package imu_calib (github.com/dpkoch/imu_calib), src/accel_calib/accel_calib.cpp,
 * applyCalib():
 *
 *     corrected = SM raw - bias
 *
 * raw is linear_acceleration of sensor_msgs/Imu, in m/s^2 (REP 103). The bias is subtracted after
 * the multiplication: matrix (raw - offset) = matrix raw - matrix offset, so SM is the matrix and
 * bias = matrix offset, all of driver -> m/s^2.
 *
 * File: loadCalib() reads the members SM, 9 numbers by rows, and bias, 3 numbers, from YAML. */
static void write_file(FILE *file, const export_job *job)
{
    const invcal_calibration *c = &job->driver;
    double bias[3];
    char text[NUMBER_TEXT_MAX];

    find_bias(c, bias);
    export_heading(file, EXPORT_COMMENT, job);
    export_comment(file, EXPORT_COMMENT,
                   "For apply_calib of the package imu_calib: corrected = SM raw - bias, of");
    export_comment(file, EXPORT_COMMENT,
                   "sensor_msgs/Imu linear_acceleration in m/s^2; the driver's scale: %s",
                   job->driver_from);
    export_gyro_comment(file, EXPORT_COMMENT, job, no_gyro);
    fputs("SM: [", file);
    for (unsigned i = 0; i < 9; i++) {
        fprintf(file, "%s%s",
                i == 0       ? ""
                : i % 3 == 0 ? ",\n     "
                             : ", ",
                number_text(c->matrix[i / 3][i % 3], text));
    }
    fputs("]\nbias: [", file);
    for (unsigned i = 0; i < 3; i++) {
        fprintf(file, "%s%s", i == 0 ? "" : ", ", number_text(bias[i], text));
    }
    fputs("]\n", file);
}

const export_format export_ros = {"ros", EXPORT_GRAVITY | EXPORT_ACCELERATION | EXPORT_DRIVER,
                                  check, write_file};
