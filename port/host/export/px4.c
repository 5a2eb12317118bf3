/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "cli/command.h"
#include "export/diagonal.h"
#include "export/text.h"
#include "text/constant.h"
#include "cli/message.h"

#define SCALE_MIN 0.1
#define SCALE_MAX 3.0
#define IGNORED 0.01

static double length(double x, double y, double z)
{
    return sqrt(x * x + y * y + z * z);
}

/* Releases that load parameters with set_offset and set_scale ignore an offset within 0.01 m/s^2 of
 * 0, and scales within 0.01 of 1. */
static int is_ignored(const double offset[3], const double scale[3])
{
    return !(length(offset[0], offset[1], offset[2]) > IGNORED) ||
           !(length(scale[0] - 1, scale[1] - 1, scale[2] - 1) > IGNORED);
}

static int check(const export_job *job)
{
    const export_diagonal d = export_diagonal_fit(&job->driver);
    double bias[3];

    for (unsigned i = 0; i < 3; i++) {
        if (!(d.scale[i] >= SCALE_MIN && d.scale[i] <= SCALE_MAX)) {
            message("%s: the scale of %c would be %.6g, but PX4 takes 0.1 to 3: is the driver's "
                    "scale right (%s)?",
                    job->source, (int)"xyz"[i], d.scale[i], job->driver_from);
            return EXIT_DATA;
        }
    }
    const int failure = export_check_range(job, job->driver.offset, 3, 1);
    if (failure) {
        return failure;
    }
    export_diagonal_message(job, &d);
    if (!export_gyro_bias(job, bias)) {
        export_gyro_warn(job, EXPORT_NO_UNIT);
    }
    if (is_ignored(job->driver.offset, d.scale)) {
        message("warning: some PX4 releases ignore an offset shorter than 0.01 m/s^2, or scales "
                "within 0.01 of 1, as here; check what \"sensors status\" shows");
    }
    return EXIT_GOOD;
}

/* PX4-Autopilot, src/lib/sensor_calibration/Accelerometer.hpp, Correct():
 *
 *     corrected = rotation (data - thermal offset - offset) o scale     (o: axis by axis)
 *
 * data is sensor_accel, m/s^2 in the axes that the driver delivers, after its own rotation
 * (src/lib/drivers/accelerometer/PX4Accelerometer.cpp, update()). So the offset is in m/s^2 and is
 * applied before the scale, and both are the best diagonal fit to driver -> m/s^2. vehicle_imu,
 * sensor_combined and vehicle_acceleration have been corrected by it (VehicleIMU.cpp, Publish()): a
 * calibration of one of those would have to be combined with that of the vehicle.
 *
 * Names and limits: src/modules/sensors/module.yaml: CAL_ACCn_XOFF ... ZOFF without limits,
 * CAL_ACCn_XSCALE ... ZSCALE 0.1 to 3. CAL_ACCn_ID identifies the sensor; without it PX4 ignores
 * the calibration (Utilities.cpp). CAL_ACCn_PRIO and ROT are left to PX4.
 *
 * File: QGroundControl, ParameterManager::readParametersFromStream(): vehicle, component, name,
 * value and MAV_PARAM_TYPE (9: float, 6: int32), separated by tabs; '#' begins a comment. PX4's own
 * `param import` reads binary files only. Numbers are written with the digits of a float. */
static void write_file(FILE *file, const export_job *job)
{
    const export_diagonal d = export_diagonal_fit(&job->driver);
    char text[NUMBER_TEXT_MAX];
    double bias[3];

    export_heading(file, EXPORT_COMMENT, job);
    export_comment(file, EXPORT_COMMENT,
                   "PX4: corrected = scale (reading - offset), axis by axis,");
    export_comment(file, EXPORT_COMMENT, "of readings of the driver in m/s^2; its scale: %s",
                   job->driver_from);
    export_comment(file, EXPORT_COMMENT,
                   "The log must be of sensor_accel: sensor_combined is corrected already.");
    export_diagonal_comment(file, EXPORT_COMMENT, &d);
    export_comment(file, EXPORT_COMMENT, "QGroundControl: Parameters, Tools, Load from file.");
    if (job->device_id > 0) {
        fprintf(file, "1\t1\tCAL_ACC%u_ID\t%.0f\t6\n", job->instance, job->device_id);
    } else {
        export_comment(file, EXPORT_COMMENT,
                       "CAL_ACC%u_ID must be the sensor's: calibrated before, or --device-id.",
                       job->instance);
    }
    for (unsigned i = 0; i < 3; i++) {
        fprintf(file, "1\t1\tCAL_ACC%u_%cOFF\t%s\t9\n", job->instance, (int)"XYZ"[i],
                constant_float(job->driver.offset[i], text));
    }
    for (unsigned i = 0; i < 3; i++) {
        fprintf(file, "1\t1\tCAL_ACC%u_%cSCALE\t%s\t9\n", job->instance, (int)"XYZ"[i],
                constant_float(d.scale[i], text));
    }
    if (export_gyro_bias(job, bias)) {
        export_comment(file, EXPORT_COMMENT,
                       "The gyroscope's bias, rad/s; PX4 has no parameter for its scale.");
        export_comment_no_g(file, EXPORT_COMMENT, job);
        for (unsigned i = 0; i < 3; i++) {
            fprintf(file, "1\t1\tCAL_GYRO%u_%cOFF\t%s\t9\n", job->instance, (int)"XYZ"[i],
                    constant_float(bias[i], text));
        }
    } else {
        export_gyro_comment(file, EXPORT_COMMENT, job, EXPORT_NO_UNIT);
    }
}

const export_format export_px4 = {
    "px4", EXPORT_GRAVITY | EXPORT_ACCELERATION | EXPORT_DRIVER | EXPORT_INSTANCE, check,
    write_file};
