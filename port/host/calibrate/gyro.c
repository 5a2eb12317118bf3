/* SPDX-License-Identifier: MIT */
#include "calibrate/gyro.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "maths/eigen.h"
#include "maths/matrix.h"
#include "core/system.h"

#define ACCELEROMETER ((1u << INVCAL_PARAMETERS) - 1) /* its parameters */

/* The moves determine the accelerometer, and the rests alone do not, or poorly. */
static int moves_determine_more(const request *r, int refused, const calibrate_result *result)
{
    const gyro_fit *g = &result->gyro;
    const int is_plain = !r->value[OPT_THERMAL] && r->degree == 0 && !fit_has_prior(&r->settings);

    return is_plain && g->has_readings && !g->word && (g->imu.weak & ACCELEROMETER) == 0 &&
           (refused || result->quality.verdict == INVCAL_WEAK);
}

/* Residuals of the lengths, as in invcal_quality. */
static void measure_residuals(const calibrate_result *result, invcal_quality *q)
{
    const rejection *kept = &result->rejected;
    double squares = 0;

    for (unsigned k = 0; k < kept->kept_count; k++) {
        double v[3];
        invcal_apply(&result->gyro.imu.accelerometer, kept->kept[3 * (size_t)k],
                     kept->kept[3 * (size_t)k + 1], kept->kept[3 * (size_t)k + 2], v);
        const double r = fabs(sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1);
        squares += r * r;
        if (!(r <= q->max)) {
            q->max = r;
            q->worst = (uint16_t)k;
        }
    }
    q->rms = sqrt(squares / kept->kept_count);
}

/* Degrees of freedom of the noise of a mean, which is estimated from the lengths of the rests
 * alone, as in the library. */
static double dof_of_rests(const gyro_fit *g)
{
    return (double)g->imu.dof * g->rests / (g->rests + 2.0 * g->imu.moves);
}

/* The lengths disagree by more than their noise. This is judged by a fit of the lengths alone, with
 * the angles from the moves as a prior. */
static int is_disturbed(const calibrate_result *result)
{
    const rejection *kept = &result->rejected;
    fit_settings with;
    fit_solution solution;
    fit_quality lengths;

    calibrate_with_moves(result, &with);
    with.nominal = result->gyro.imu.accelerometer;
    return fit_make(kept->kept, kept->kept_count, &with, &solution, &lengths, NULL) == INVCAL_OK &&
           lengths.verdict == INVCAL_ROUGH && !calibrate_is_coarse(result);
}

/* The moves determine what the rests leave undetermined. */
static void use_joint_solution(calibrate_result *result)
{
    const invcal_imu_result *imu = &result->gyro.imu;
    double information[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    fit_settings with = result->settings;
    /* only the gyroscope can be weak here: see moves_determine_more */
    const int is_weak = imu->verdict == INVCAL_WEAK;
    invcal_quality q = {.verdict = !is_weak       ? imu->verdict
                                   : imu->dof > 0 ? INVCAL_GOOD
                                                  : INVCAL_NO_REDUNDANCY,
                        .noise = imu->noise,
                        .positions = (uint16_t)result->rejected.kept_count,
                        .sigma_dof = (uint16_t)lround(dof_of_rests(&result->gyro))};

    memcpy(q.sigma, imu->sigma, sizeof q.sigma);
    measure_residuals(result, &q);
    result->refused = (refusal){.word = NULL};
    result->is_joint = 1;
    result->solution = fit_solution_of(&imu->accelerometer, &result->settings);
    result->quality = fit_quality_of(&q, &result->settings, &result->solution);
    result->quality.dof = dof_of_rests(&result->gyro);
    calibrate_with_moves(result, &with);
    fit_information(result->rejected.kept, result->rejected.kept_count, &with, &result->solution,
                    result->quality.noise, information);
    result->quality.condition = eigen_condition(information, INVCAL_PARAMETERS);
    if (result->quality.verdict == INVCAL_GOOD && is_disturbed(result)) {
        result->quality.verdict = INVCAL_ROUGH; /* no rest is left out here */
        result->gyro.imu.verdict = is_weak ? INVCAL_WEAK : INVCAL_ROUGH;
    }
}

/* An approximate calibration of the accelerometer; null if there is none. A nominal one that is
 * guessed from the range of few rests is far from the truth: a sphere fits better. */
static const invcal_calibration *find_start(int refused, const calibrate_result *result,
                                            invcal_calibration *approximate)
{
    const rejection *kept = &result->rejected;

    if (!refused) {
        return &result->solution.symmetric;
    }
    if (!nominal_is_guess(&result->nominal)) {
        return &result->settings.nominal;
    }
    return nominal_from_sphere(kept->kept, kept->kept_count, approximate) ? approximate : NULL;
}

int calibrate_gyro(const request *r, const gyro_log *gyro, int refused, calibrate_result *result)
{
    const double *clip = r->value[OPT_CLIP] ? r->clip : NULL;
    invcal_calibration approximate;
    const int may_help = refused == EXIT_DATA && result->refused.undetermined != 0;

    if (gyro->readings == 0 || (refused && !may_help) || result->data->count == 0) {
        return refused;
    }
    const int failure =
        gyro_make(&result->gyro, gyro, &r->gyro, (unsigned)nearbyint(result->log->rate), clip,
                  result->data, &result->rejected, find_start(refused, result, &approximate));
    if (failure) {
        return failure;
    }
    if (moves_determine_more(r, refused, result)) {
        use_joint_solution(result);
        return EXIT_GOOD;
    }
    if (refused && !result->gyro.word && result->gyro.imu.weak) {
        gyro_refuse_open(&result->gyro);
    }
    if (refused && result->gyro.word) {
        const size_t length = strlen(result->refused.remedy);
        snprintf(result->refused.remedy + length, REFUSAL_MAX - length,
                 ". The moves between them do not determine them either: %s%s%s",
                 result->gyro.reason, *result->gyro.remedy ? ": " : "", result->gyro.remedy);
    }
    return refused;
}

/* The rotation closest to a matrix, by Newton's iteration X <- (X + X^-T) / 2. */
static void nearest_rotation(double x[3][3])
{
    for (unsigned n = 0; n < 20; n++) {
        invcal_calibration c = {.offset = {0}};
        double inverse[3][3];
        memcpy(c.matrix, x, sizeof c.matrix);
        if (!matrix_inverse(&c, inverse)) {
            return;
        }
        for (unsigned i = 0; i < 9; i++) {
            x[i / 3][i % 3] = (x[i / 3][i % 3] + inverse[i % 3][i / 3]) / 2;
        }
    }
}

static void multiply(const double (*a)[3], const double (*b)[3], double out[3][3])
{
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
}

void calibrate_gyro_turn(calibrate_result *result)
{
    gyro_fit *g = &result->gyro;
    double inverse[3][3];
    double turn[3][3];
    double turned[3][3];

    if (!g->has_readings || g->word || !matrix_inverse(&g->imu.accelerometer, inverse)) {
        return;
    }
    multiply((const double(*)[3])result->solution.calibration.matrix, (const double(*)[3])inverse,
             turn);
    nearest_rotation(turn);
    multiply((const double(*)[3])turn, (const double(*)[3])g->calibration.matrix, turned);
    memcpy(g->calibration.matrix, turned, sizeof turned);
    multiply((const double(*)[3])turn, (const double(*)[3])g->g, turned);
    for (unsigned i = 0; i < 9; i++) { /* the acceleration is also in the new axes */
        const double *row = turned[i / 3];
        const double *of = turn[i % 3];
        g->g[i / 3][i % 3] = row[0] * of[0] + row[1] * of[1] + row[2] * of[2];
    }
}
