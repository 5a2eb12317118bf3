/* SPDX-License-Identifier: MIT */
#include "export/diagonal.h"

#include <math.h>

#include "maths/eigen.h"
#include "export/text.h"
#include "maths/matrix.h"
#include "cli/message.h"
#include "core/system.h"

#define MG 1000.0
#define RINGS 1000u
#define POINTS 16u /* of a quarter of a ring */

/* The eigenvalues of P'P. */
static void squared_singular_values(double p[3][3], double value[3])
{
    double packed[6];

    for (unsigned r = 0; r < 3; r++) {
        for (unsigned c = 0; c <= r; c++) {
            packed[INVCAL_PACKED(r, c)] = p[0][r] * p[0][c] + p[1][r] * p[1][c] + p[2][r] * p[2][c];
        }
    }
    eigenvalues(packed, 3, value);
    for (unsigned i = 0; i < 3; i++) {
        value[i] = fmax(value[i], 0); /* rounding */
    }
}

/* The root mean square of |P u| - 1 has no elementary form. In the axes of P'P the integrand is the
 * same in all octants. In one of them z is uniformly distributed, and the midpoint rule in z and in
 * the angle is accurate to six digits. */
static double length_rms(const double value[3])
{
    double sum = 0;

    for (unsigned ring = 0; ring < RINGS; ring++) {
        const double z = (ring + 0.5) / RINGS;
        for (unsigned point = 0; point < POINTS; point++) {
            const double angle = 1.5707963267948966 * (point + 0.5) / POINTS;
            const double x2 = (1 - z * z) * cos(angle) * cos(angle);
            const double y2 = (1 - z * z) * sin(angle) * sin(angle);
            const double length = sqrt(value[0] * x2 + value[1] * y2 + value[2] * z * z);
            sum += (length - 1) * (length - 1) / (RINGS * POINTS);
        }
    }
    return sqrt(sum);
}

/* In the true field u a driver reads B u + offset, B = full matrix^-1, and a system with scales s
 * shows P u, P = diag(s) B. With E = P - 1 the error E u has, over the sphere, the mean square
 * trace(E'E)/3 because the mean of u u' is 1/3, and its largest length is the largest singular
 * value of E. The length |P u| lies between the singular values of P. */
static export_error error_of(const double scale[3], double b[3][3])
{
    double p[3][3];
    double e[3][3];
    double value[3];
    export_error error;

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            p[i][j] = scale[i] * b[i][j];
            e[i][j] = p[i][j] - (i == j);
        }
    }
    squared_singular_values(e, value);
    error.rms = sqrt((value[0] + value[1] + value[2]) / 3);
    error.max = sqrt(fmax(value[0], fmax(value[1], value[2])));
    squared_singular_values(p, value);
    const double longest = sqrt(fmax(value[0], fmax(value[1], value[2])));
    const double shortest = sqrt(fmin(value[0], fmin(value[1], value[2])));
    error.length_max = fmax(fabs(longest - 1), fabs(shortest - 1));
    error.length_rms = length_rms(value);
    return error;
}

/* With another offset c, axis i of the error is s_i (B_i u + o_i - c_i) - u_i, B_i row i of B.
 * Its mean square is s_i^2 (|B_i|^2/3 + (o_i - c_i)^2) - 2 s_i B_ii/3 + 1/3, with the minimum
 * (1 - B_ii^2/|B_i|^2)/3 at c = o and s_i = B_ii / |B_i|^2, independent of the other axes. */
export_diagonal export_diagonal_fit(const invcal_calibration *full)
{
    export_diagonal d;
    double b[3][3];
    double cut_off[3];

    (void)matrix_inverse(full, b); /* regular: see export_driver */
    for (unsigned i = 0; i < 3; i++) {
        d.scale[i] = b[i][i] / (b[i][0] * b[i][0] + b[i][1] * b[i][1] + b[i][2] * b[i][2]);
        cut_off[i] = full->matrix[i][i];
    }
    d.best = error_of(d.scale, b);
    d.cut_off = error_of(cut_off, b);
    return d;
}

void export_diagonal_message(const export_job *job, const export_diagonal *d)
{
    message("%s has no cross terms: the best fit leaves %.4f mg rms, %.4f mg at most (in length "
            "%.4f and %.4f); dropping them would leave %.4f and %.4f (%.4f and %.4f)",
            job->format, MG * d->best.rms, MG * d->best.max, MG * d->best.length_rms,
            MG * d->best.length_max, MG * d->cut_off.rms, MG * d->cut_off.max,
            MG * d->cut_off.length_rms, MG * d->cut_off.length_max);
}

static void comment_error(FILE *file, const char *prefix, const char *label, const export_error *e)
{
    export_comment(file, prefix, "  %-22s %10.4f %10.4f %10.4f %10.4f", label, MG * e->rms,
                   MG * e->max, MG * e->length_rms, MG * e->length_max);
}

void export_diagonal_comment(FILE *file, const char *prefix, const export_diagonal *d)
{
    export_comment(file, prefix,
                   "No cross terms can be stored. Remaining error, mg (thousandths of");
    export_comment(file, prefix, "the field), over all directions:");
    export_comment(file, prefix, "  %-22s %10s %10s %10s %10s", "", "vector rms", "max",
                   "length rms", "max");
    comment_error(file, prefix, "this best fit", &d->best);
    comment_error(file, prefix, "cross terms dropped", &d->cut_off);
}
