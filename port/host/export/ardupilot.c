/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "cli/command.h"
#include "export/diagonal.h"
#include "export/text.h"
#include "text/constant.h"
#include "cli/message.h"

#define SCALE_MIN 0.8
#define SCALE_MAX 1.2
#define OFFSET_MAX 9.80665 /* m/s^2 */
#define OFFSET_RANGE 3.5

/* INS_ACC..., INS_ACC2..., INS_ACC3... */
static const char *const prefixes[] = {"INS_ACC", "INS_ACC2", "INS_ACC3"};
static const char *const gyros[] = {"INS_GYR", "INS_GYR2", "INS_GYR3"};

#define INSTANCES (sizeof prefixes / sizeof prefixes[0])

static int refuse(const export_job *job, const char *what, unsigned axis, double value,
                  const char *range)
{
    message("%s: the %s of %c would be %.6g, but ArduPilot takes %s: is the driver's scale right "
            "(%s)?",
            job->source, what, (int)"xyz"[axis], value, range, job -> driver_from);
    return EXIT_DATA;
}

static int check(const export_job *job)
{
    const export_diagonal d = export_diagonal_fit(&job->driver);
    double bias[3];
    double largest = 0;

    for (unsigned i = 0; i < 3; i++) {
        const double offset = job->driver.offset[i];
        if (!(d.scale[i] >= SCALE_MIN && d.scale[i] <= SCALE_MAX)) {
            return refuse(job, "scale", i, d.scale[i], "0.8 to 1.2");
        }
        if (!(fabs(offset) <= OFFSET_MAX)) {
            return refuse(job, "offset", i, offset, "-9.80665 to 9.80665 m/s^2");
        }
        largest = fmax(largest, fabs(offset));
    }
    if (job->instance >= INSTANCES) {
        return message_usage("export", "--instance %u: must be 0 to 2 for ArduPilot",
                             job->instance);
    }
    export_diagonal_message(job, &d);
    if (!export_gyro_bias(job, bias)) {
        export_gyro_warn(job, EXPORT_NO_UNIT);
    }
    if (largest > OFFSET_RANGE) {
        message("warning: an offset of %.4g m/s^2 is beyond ArduPilot's range of +-3.5; a ground "
                "station may ask for confirmation",
                largest);
    }
    return EXIT_GOOD;
}

/* ArduPilot, libraries/AP_InertialSensor/AP_InertialSensor_Backend.cpp,
 * _rotate_and_correct_accel(): the reading, m/s^2, turned into the sensor's place on the board;
 *
 *     accel -= offset;  accel.x *= scale.x;  (y, z alike)
 *
 * then turned to the body. So the offset is in m/s^2 and is applied before the scale, and both are
 * the best diagonal fit to driver -> m/s^2, in the axes of an ArduPilot log before
 * AHRS_ORIENTATION. Backends correct a sample before it is logged (IMU, ACC): the log must be of a
 * vehicle with offsets 0, scales 1 and AHRS_ORIENTATION 0.
 *
 * Names and ranges: AP_InertialSensor.cpp: INS_ACCOFFS_X ... Z, -3.5 to 3.5 m/s^2, and
 * INS_ACCSCAL_X ... Z, 0.8 to 1.2. Its own calibration refuses scales beyond and offsets above
 * 9.80665 (AccelCalibrator::accept_result()), and so does this export. Before take-off, INS_ACC_ID
 * must be that of the sensor (accel_calibrated_ok_all()).
 *
 * File: NAME,VALUE; '#' begins a comment (MissionPlanner, ParamFile.loadParamFile(); pymavlink,
 * mavparm.py, load()). */
static void write_file(FILE *file, const export_job *job)
{
    const export_diagonal d = export_diagonal_fit(&job->driver);
    const char *prefix = prefixes[job->instance];
    double bias[3];
    char text[NUMBER_TEXT_MAX];

    export_heading(file, EXPORT_COMMENT, job);
    export_comment(file, EXPORT_COMMENT,
                   "ArduPilot: corrected = scale (reading - offset), axis by axis, of readings of");
    export_comment(file, EXPORT_COMMENT, "the driver in m/s^2; its scale: %s", job->driver_from);
    export_comment(file, EXPORT_COMMENT,
                   "ArduPilot logs corrected readings: record with offsets 0 and scales 1.");
    export_diagonal_comment(file, EXPORT_COMMENT, &d);
    if (job->device_id > 0) {
        fprintf(file, "%s_ID,%.0f\n", prefix, job->device_id);
    } else {
        export_comment(file, EXPORT_COMMENT,
                       "%s_ID must be the sensor's: calibrated before, or --device-id.", prefix);
    }
    for (unsigned i = 0; i < 3; i++) {
        fprintf(file, "%sOFFS_%c,%s\n", prefix, (int)"XYZ"[i],
                constant_float(job->driver.offset[i], text));
    }
    for (unsigned i = 0; i < 3; i++) {
        fprintf(file, "%sSCAL_%c,%s\n", prefix, (int)"XYZ"[i], constant_float(d.scale[i], text));
    }
    if (export_gyro_bias(job, bias)) {
        export_comment(
            file, EXPORT_COMMENT,
            "The gyroscope's bias, rad/s; measured again at each start unless INS_GYR_CAL is 0.");
        export_comment_no_g(file, EXPORT_COMMENT, job);
        for (unsigned i = 0; i < 3; i++) {
            fprintf(file, "%sOFFS_%c,%s\n", gyros[job->instance], (int)"XYZ"[i],
                    constant_float(bias[i], text));
        }
    } else {
        export_gyro_comment(file, EXPORT_COMMENT, job, EXPORT_NO_UNIT);
    }
}

const export_format export_ardupilot = {
    "ardupilot", EXPORT_GRAVITY | EXPORT_ACCELERATION | EXPORT_DRIVER | EXPORT_INSTANCE, check,
    write_file};
