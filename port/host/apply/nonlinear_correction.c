/* SPDX-License-Identifier: MIT */
#include "apply/nonlinear_correction.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "fit/fit.h"
#include "maths/matrix.h"
#include "cli/message.h"

#define STEPS 50     /* each leaves less than half */
#define ENOUGH 1e-12 /* over the field */
#define STEEPEST 0.5

/* The orthonormal factor of a matrix, by Newton's steps R = (R + R^-T) / 2. Returns 1; 0 for a singular one. */
static int find_turn(invcal_calibration *r)
{
    double inverse[3][3];

    for (unsigned step = 0; step < STEPS; step++) {
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

static void product(const double (*a)[3], const double (*b)[3], double out[3][3])
{
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
}

/* The calibration in the frame of the sensor's axes, whatever frame the file has: A = R S, and S is what
 * --frame symmetric would have written. */
static int find_symmetric(nonlinear_correction *c, const calibration_file *file)
{
    const invcal_calibration over = fit_over_field(&file->calibration, file->nonlinear.field);
    invcal_calibration turn = {.offset = {0, 0, 0}};
    double back[3][3];

    product((const double(*)[3])over.matrix, (const double(*)[3])c->inverse, turn.matrix);
    if (!find_turn(&turn)) {
        return 0;
    }
    for (unsigned i = 0; i < 9; i++) {
        back[i / 3][i % 3] = turn.matrix[i % 3][i / 3];
    }
    memcpy(c->symmetric.offset, over.offset, sizeof over.offset);
    product((const double(*)[3])back, (const double(*)[3])over.matrix, c->symmetric.matrix);
    return 1;
}

/* An error changes by less than half of a change in what the axes feel: each step leaves less than half. */
static int converges(const nonlinear_correction *c)
{
    double gain[3][3];
    double most = 0;
    int is_flat = 1;

    product((const double(*)[3])c->symmetric.matrix, (const double(*)[3])c->inverse, gain);
    for (unsigned a = 0; a < 3; a++) {
        most = fmax(most, fabs(gain[a][0]) + fabs(gain[a][1]) + fabs(gain[a][2]));
    }
    for (unsigned a = 0; a < 3; a++) {
        const double slope =
            NONLINEAR_EDGE * (2 * fabs(c->term[0][a]) + 3 * NONLINEAR_EDGE * fabs(c->term[1][a]));
        is_flat = is_flat && most * slope < STEEPEST;
    }
    return is_flat;
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

/* The error of an axis, held at the edge. */
static double error_of(const nonlinear_correction *c, unsigned axis, double eta)
{
    const double x = fmax(-NONLINEAR_EDGE, fmin(NONLINEAR_EDGE, eta));

    return x * x * (c->term[0][axis] + x * c->term[1][axis]);
}

static double largest(const double v[3])
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

void nonlinear_correction_take(nonlinear_correction *c, double raw[3])
{
    const double was[3] = {raw[0], raw[1], raw[2]};
    double eta[3] = {0, 0, 0};
    double moved = 1;

    if (!c->is_needed) {
        return;
    }
    for (unsigned step = 0; step < STEPS && moved > ENOUGH; step++) {
        double now[3];
        double error[3];
        invcal_apply(&c->symmetric, raw, now);
        for (unsigned a = 0; a < 3; a++) {
            error[a] = error_of(c, a, now[a]);
            eta[a] -= now[a];
        }
        moved = largest(eta);
        for (unsigned a = 0; a < 3; a++) {
            const double *n = c->inverse[a];
            raw[a] = was[a] - (n[0] * error[0] + n[1] * error[1] + n[2] * error[2]);
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
