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
 * is brought to m/s^2. A triangular frame gives its "body frame": zeros below the diagonal of T.
 *
 * File: save() writes T, K in full, and B; load() reads these 21 numbers, with any white space
 * between, and no further. It knows no comments, so ours stand behind. */
static void write_file(FILE *file, const export_job *job)
{
    const export_factors f = export_factors_of(job, job->si);
    const double *offset = job->file.calibration.offset;

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
        fprintf(file, "%s\n", number_text(offset[i], text));
    }
    putc('\n', file);
    export_heading(file, EXPORT_COMMENT, job);
    export_comment(file, EXPORT_COMMENT, "imu_tk: T K (X - B), X in input units, result in m/s^2");
}

const export_format export_imu_tk = {"imu_tk", EXPORT_GRAVITY | EXPORT_ACCELERATION,
                                     export_factors_check, write_file};
