/* SPDX-License-Identifier: MIT */
#include "maths/matrix.h"

#include <float.h>
#include <math.h>

#include "core/system.h"

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Divides each row of the matrix by its largest element. */
static void split(const invcal_calibration *c, double row[3][3], double scale[3])
{
    for (unsigned i = 0; i < 3; i++) {
        const double *m = c->matrix[i];
        scale[i] = fmax(fabs(m[0]), fmax(fabs(m[1]), fabs(m[2])));
        for (unsigned j = 0; j < 3; j++) {
            row[i][j] = m[j] / scale[i];
        }
    }
}

/* Each column of the inverse is the cross product of two scaled rows over their determinant and the
 * scale of the third: in any unit, nothing over- or underflows. */
int matrix_inverse(const invcal_calibration *calibration, double inverse[3][3])
{
    double row[3][3];
    double scale[3];
    double column[3];
    int is_finite = 1;

    split(calibration, row, scale);
    cross(row[1], row[2], column);
    const double det = row[0][0] * column[0] + row[0][1] * column[1] + row[0][2] * column[2];
    for (unsigned i = 0; i < 3; i++) {
        cross(row[(i + 1) % 3], row[(i + 2) % 3], column);
        for (unsigned j = 0; j < 3; j++) {
            inverse[j][i] = column[j] / det / scale[i];
            is_finite = is_finite && fabs(inverse[j][i]) <= DBL_MAX;
        }
    }
    return is_finite && fabs(det) > 16 * DBL_EPSILON; /* the scaled rows have lengths of 1 to 1.7 */
}

/* A^-1 = L^-1' L^-1, row by row: no later element needs one that has been overwritten. */
int matrix_invert_packed(double *a, unsigned n)
{
    if (invcali_factor(a, n, n, INVCAL_FLOOR) != INVCAL_OK) {
        return 0;
    }
    invcali_invert(a, n);
    for (unsigned r = 0; r < n; r++) {
        for (unsigned c = 0; c <= r; c++) {
            double sum = 0;
            for (unsigned i = r; i < n; i++) {
                sum += a[INVCAL_PACKED(i, r)] * a[INVCAL_PACKED(i, c)];
            }
            a[INVCAL_PACKED(r, c)] = sum;
        }
    }
    return 1;
}
