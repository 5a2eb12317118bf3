/* SPDX-License-Identifier: MIT */
#include "export/driver.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "maths/matrix.h"
#include "cli/message.h"
#include "text/unit.h"

/* m/s^2 per unit of the readings; 0 if they are counts or unknown. */
static double unit_si(const char *unit)
{
    reading_unit u;

    return unit_parse(unit, &u) ? unit_scale(u, UNIT_STANDARD_GRAVITY) : 0;
}

/* 1 if a nominal value is from a data sheet or a unit, as the driver's are; not one from the range
 * of the data or from an earlier calibration. */
static int is_stated(const char *origin)
{
    return strcmp(origin, "given") == 0 || strcmp(origin, "unit") == 0 ||
           strcmp(origin, "sensor") == 0;
}

/* Where the driver's zero and scale come from, in words; null if unknown. */
static const char *find_scale(const export_job *job, const double *given_zero,
                              const double *given_lsb, double zero[3], double lsb[3])
{
    const calibration_file *c = &job->file;
    const double unit = unit_si(c->unit);
    const char *from = given_lsb  ? "--zero and --lsb"
                       : unit > 0 ? c->unit
                       : is_stated(c->zero_from) && is_stated(c->lsb_from) && !c->has_cross_terms
                           ? "the nominal zero and scale of the calibration"
                           : NULL;

    for (unsigned i = 0; i < 3; i++) {
        zero[i] = given_lsb ? given_zero[i] : unit > 0 ? 0 : c->zero[i];
        lsb[i] = given_lsb ? given_lsb[i] : unit > 0 ? unit : job->si * c->lsb[i];
    }
    return from;
}

/* The driver delivers d = S (raw - zero), S = diag(lsb); calibrated = si M (raw - offset) m/s^2.
 * So raw = S^-1 d + zero, and calibrated = si M S^-1 (d - S (offset - zero)). */
static void set_driver_calibration(export_job *job, const double zero[3], const double lsb[3])
{
    const invcal_calibration *c = &job->file.calibration;

    for (unsigned i = 0; i < 3; i++) {
        job->driver.offset[i] = lsb[i] * (c->offset[i] - zero[i]);
        for (unsigned j = 0; j < 3; j++) {
            job->driver.matrix[i][j] = job->si * c->matrix[i][j] / lsb[j];
        }
    }
}

int export_driver(export_job *job, const double *zero, const double *lsb)
{
    double driver_zero[3];
    double driver_lsb[3];
    double inverse[3][3];

    job->driver_from = find_scale(job, zero, lsb, driver_zero, driver_lsb);
    if (!job->driver_from) {
        return message_usage("export",
                             "%s: the scale of the driver is unknown: state --zero X,Y,Z --lsb S "
                             "(m/s^2 per input unit)",
                             job->source);
    }
    set_driver_calibration(job, driver_zero, driver_lsb);
    if (!matrix_inverse(&job->driver, inverse) ||
        !(fabs(job->driver.offset[0]) + fabs(job->driver.offset[1]) + fabs(job->driver.offset[2]) <
          1e30)) {
        return message_usage("export", "%s: the scale of the driver is out of range, %s",
                             job->source, job->driver_from);
    }
    return EXIT_GOOD;
}
