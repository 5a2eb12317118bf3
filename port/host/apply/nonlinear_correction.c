/* SPDX-License-Identifier: MIT */
#include "apply/nonlinear_correction.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "fit/fit.h"
#include "maths/matrix.h"
#include "cli/message.h"

#define ITERATIONS 50   /* each leaves less than half of the error */
#define TOLERANCE 1e-12 /* over the field */
#define SLOPE_MAX 0.5   /* of the error over eta: the iteration converges below 1 */

/* The orthogonal factor of a matrix, by Newton's iteration R = (R + R^-T) / 2. Returns 1; 0 if it
 * is singular. */
static int nearest_rotation(invcal_calibration *r)
{
    double inverse[3][3];

    for (unsigned step = 0; step < ITERATIONS; step++) {
        if (!matrix_inverse(r, inverse)) {
            return 0;
        }
        for (unsigned i = 0; i < 9; i++) {
            double *element = &r->matrix[i / 3][i % 3];
            *element = (*element + inverse[i % 3][i / 3]) / 2;
        }
    }
    return 1;
}

static void multiply(const double (*a)[3], const double (*b)[3], double out[3][3])
{
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
}

/* The calibration in the symmetric frame, from that in the frame of the file: A = R S. */
static int find_symmetric(nonlinear_correction *c, const calibration_file *file)
{
    const invcal_calibration over = fit_over_field(&file->calibration, file->nonlinear.field);
    invcal_calibration turn = {.offset = {0, 0, 0}};
    double back[3][3];

    multiply((const double(*)[3])over.matrix, (const double(*)[3])c->inverse, turn.matrix);
    if (!nearest_rotation(&turn)) {
        return 0;
    }
    for (unsigned i = 0; i < 9; i++) {
        back[i / 3][i % 3] = turn.matrix[i % 3][i / 3];
    }
    memcpy(c->symmetric.offset, over.offset, sizeof over.offset);
    multiply((const double(*)[3])back, (const double(*)[3])over.matrix, c->symmetric.matrix);
    return 1;
}

/* 1 if the error changes by less than half of a change of eta, so that each iteration leaves less
 * than half. */
static int converges(const nonlinear_correction *c)
{
    double gain[3][3];
    double gain_max = 0;
    int is_small = 1;

    multiply((const double(*)[3])c->symmetric.matrix, (const double(*)[3])c->inverse, gain);
    for (unsigned a = 0; a < 3; a++) {
        gain_max = fmax(gain_max, fabs(gain[a][0]) + fabs(gain[a][1]) + fabs(gain[a][2]));
    }
    for (unsigned a = 0; a < 3; a++) {
        const double slope =
            NONLINEAR_EDGE * (2 * fabs(c->term[0][a]) + 3 * NONLINEAR_EDGE * fabs(c->term[1][a]));
        is_small = is_small && gain_max * slope < SLOPE_MAX;
    }
    return is_small;
}

int nonlinear_correction_begin(nonlinear_correction *c, const calibration_file *file,
                               const char *name)
{
    *c = (nonlinear_correction){.is_needed = file->has_nonlinear};
    if (!c->is_needed) {
        return EXIT_GOOD;
    }
    const invcal_calibration nominal =
        fit_over_field(&file->nonlinear.nominal, file->nonlinear.field);
    memcpy(c->term, file->nonlinear.term, sizeof c->term);
    if (!matrix_inverse(&nominal, c->inverse) || !find_symmetric(c, file) || !converges(c)) {
        message("%s: \"nonlinearity\" is too large: not a calibration", name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

/* The error of an axis; beyond the edge that at the edge. */
static double error_of(const nonlinear_correction *c, unsigned axis, double eta)
{
    const double x = fmax(-NONLINEAR_EDGE, fmin(NONLINEAR_EDGE, eta));

    return x * x * (c->term[0][axis] + x * c->term[1][axis]);
}

static double largest(const double v[3])
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

void nonlinear_correction_remove(nonlinear_correction *c, double raw[3])
{
    const double measured[3] = {raw[0], raw[1], raw[2]};
    double eta[3] = {0, 0, 0};
    double change = 1;

    if (!c->is_needed) {
        return;
    }
    for (unsigned step = 0; step < ITERATIONS && change > TOLERANCE; step++) {
        double now[3];
        double error[3];
        invcal_apply(&c->symmetric, raw[0], raw[1], raw[2], now);
        for (unsigned a = 0; a < 3; a++) {
            error[a] = error_of(c, a, now[a]);
            eta[a] -= now[a];
        }
        change = largest(eta);
        for (unsigned a = 0; a < 3; a++) {
            const double *n = c->inverse[a];
            raw[a] = measured[a] - (n[0] * error[0] + n[1] * error[1] + n[2] * error[2]);
            eta[a] = now[a];
        }
    }
    c->readings++;
    c->beyond += largest(eta) > NONLINEAR_EDGE;
    c->farthest = fmax(c->farthest, largest(eta));
}

void nonlinear_correction_end(const nonlinear_correction *c, const char *log)
{
    if (c->beyond > 0) {
        message("warning: %s: %lu of %lu readings are beyond %.3g times the field on an axis, up "
                "to %.3g, where its nonlinearity is unknown: they are corrected as at that limit",
                log, c->beyond, c->readings, NONLINEAR_EDGE, c->farthest);
    }
}
