/* SPDX-License-Identifier: MIT */
#include "export/factors.h"
#include "export/text.h"

static void write_row(FILE *file, double x, double y, double z)
{
    char text[3][NUMBER_TEXT_MAX];

    fprintf(file, "%s %s %s\n", number_text(x, text[0]), number_text(y, text[1]),
            number_text(z, text[2]));
}

/* imu_tk (github.com/Kyle-ak/imu_tk), include/imu_tk/calibration.h, CalibratedTriad_:
 *
 *     unbiasNormalize(X) = T K (X - B)
 *
 * T has ones on its diagonal, K is diagonal, and X is what the log holds: raw counts in its own
 * examples (apps/test_imu_calib.cpp). So B = offset, and matrix = T K column by column; the result
 * is converted to m/s^2. A triangular frame gives its "body frame": zeros below the diagonal of T.
 *
 * File: save() writes T, K in full, and B; load() reads these 21 numbers, separated by any white
 * space, and no further. It does not know comments, so ours follow the numbers. */
static void write_triad(FILE *file, const invcal_calibration *c, double factor)
{
    const export_factors f = export_factors_of(c, factor);

    for (unsigned i = 0; i < 3; i++) {
        write_row(file, f.misalignment[i][0], f.misalignment[i][1], f.misalignment[i][2]);
    }
    putc('\n', file);
    write_row(file, f.scale[0], 0, 0);
    write_row(file, 0, f.scale[1], 0);
    write_row(file, 0, 0, f.scale[2]);
    putc('\n', file);
    for (unsigned i = 0; i < 3; i++) {
        char text[NUMBER_TEXT_MAX];
        fprintf(file, "%s\n", number_text(c->offset[i], text));
    }
    putc('\n', file);
}

static int check(const export_job *job)
{
    return export_factors_check(job, &job->file.calibration, job->si);
}

static void write_file(FILE *file, const export_job *job)
{
    write_triad(file, &job->file.calibration, job->si);
    export_heading(file, EXPORT_COMMENT, job);
    export_comment(file, EXPORT_COMMENT, "imu_tk: T K (X - B), X in %s, result in m/s^2",
                   export_input_unit(job));
}

/* The gyroscope's file has the same format, with the result in rad/s, the unit of
 * MultiPosCalibration_. */
static int check_gyro(const export_job *job)
{
    return export_factors_check(job, &job->file.gyro, 1);
}

static void write_gyro(FILE *file, const export_job *job)
{
    write_triad(file, &job->file.gyro, 1);
    export_heading(file, EXPORT_COMMENT, job);
    export_comment(file, EXPORT_COMMENT, "The figures above are the accelerometer's.");
    export_gyro_heading(file, EXPORT_COMMENT, job);
    export_comment(file, EXPORT_COMMENT, "imu_tk: T K (X - B), X in input units, result in rad/s");
    export_comment_no_g(file, EXPORT_COMMENT, job);
}

const export_format export_imu_tk = {"imu_tk", EXPORT_GRAVITY | EXPORT_ACCELERATION, check,
                                     write_file};
const export_format export_imu_tk_gyro = {"imu_tk-gyro", EXPORT_GYRO, check_gyro, write_gyro};
