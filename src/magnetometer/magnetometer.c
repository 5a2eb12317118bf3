/* SPDX-License-Identifier: MIT
 *
 * A magnetometer in motion (mathematics_magnetometer.md). Each sample becomes a row in its cell
 * ("Cells"), and is compared with the solution so far. The cells are solved again at 100 samples
 * and whenever there are five eighths more ("Looks"): the number of solutions grows only with the
 * logarithm of that of the samples.
 *
 * There are two tables of cells, of samples up to the last look and since, because a step shows as
 * a difference between them ("Disturbances"). Both are in the coordinates in which the last
 * solution is about the unit sphere; `work` converts raw counts to them.
 */
#include "invcal/magnetometer.h"

#include <stddef.h>
#include <string.h>

#include "cells.h"
#include "../calibrate/judge.h"
#include "../core/solve.h"
#include "../core/texts.h"
#include "../core/sums.h"
#include "../core/vector.h"

/* Without a solution, the box of the readings places the cells. The first solution is from samples
 * that were compared with nothing, the second from later samples only. */
enum { NO_SOLUTION, FIRST_SOLUTION, SECOND_SOLUTION };
enum { FIRST_LOOK = 100, LARGEST_BLOCK = 4096 };
#define FULL_COUNT UINT32_C(16777216)
/* Until there are residuals: eight of a tenth of the field, and the sum of their squares. */
enum { INITIAL_COUNT = 8 };
#define INITIAL_SQUARES INVCAL_REAL(0.08)
#define CONTRADICTS INVCAL_REAL(25.0) /* square of 5 */
#define FAR INVCAL_REAL(0.01)
#define WIDE_GAP INVCAL_REAL(0.6)      /* a cosine: more than 45 degrees */
#define PLACES_RMS INVCAL_REAL(0.03)   /* above the noise of any magnetometer */
#define PLACES_ALIKE INVCAL_REAL(10.0) /* and common to this many samples in a row */
enum { POWER_SAMPLES = 64 };
#define DEEP INVCAL_REAL(0.3) /* square of 0.55 */

invcal_status invcal_magnetometer_init(invcal_magnetometer *magnetometer,
                                       const invcal_calibration *nominal)
{
    static const invcal_calibration as_read = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

    INVCAL_ASSERT(magnetometer);
    const invcal_calibration *const work = nominal != NULL ? nominal : &as_read;
    const invcal_status status = invcali_nominal_check(work);
    magnetometer->own.due = 0; /* not begun */
    if (status == INVCAL_OK) {
        invcali_zero(&magnetometer->own, sizeof magnetometer->own);
        magnetometer->own_work = *work;
        magnetometer->own.unit = 1;
        magnetometer->own.due = FIRST_LOOK;
    }
    return status;
}

static invcali_cell_tables both_tables(const invcal_magnetometer *m)
{
    const invcali_cell_tables tables = {&m->own.early, &m->own.late};

    return tables;
}

/* ---- residuals of samples -------------------------------------------------------------------- */

/* The mean square of the sum of eta r over a block, per sample. That is the mean square of r if
 * samples are independent, and n times that if n in a row have a common error. 0: unknown. */
static invcal_real power_of(const invcal_magnetometer *m)
{
    return m->own.blocked >= POWER_SAMPLES ? m->own.products / (invcal_real)m->own.blocked : 0;
}

static void end_block(invcal_magnetometer *m)
{
    m->own.products += invcali_dot3(m->own.block, m->own.block);
    m->own.blocked += m->own.in_block;
    invcali_zero(m->own.block, sizeof m->own.block);
    m->own.in_block = 0;
}

/* Compares a sample with the solution so far. Returns 0 if its residual is too large: more than 5
 * times the root mean square. A block is a sixteenth of the samples so far, so that it soon
 * outlasts errors that neighbours share. */
static int is_alike(invcal_magnetometer *m, const invcal_real h[INVCAL_PARAMETERS])
{
    const invcal_real r = invcali_dot(m->own.p, h, INVCAL_PARAMETERS) - INVCAL_REAL(0.5);
    const invcal_real n = (invcal_real)(m->own.blocked + m->own.in_block + INITIAL_COUNT);

    if (!(r * r * n <= CONTRADICTS * (m->own.squares + INITIAL_SQUARES))) {
        return 0;
    }
    m->own.squares += r * r;
    m->own.in_block++;
    INVCAL_UNROLL
    for (unsigned i = 0; i < 3; i++) {
        m->own.block[i] += r * h[i];
    }
    if (m->own.in_block >= LARGEST_BLOCK || m->own.in_block >= m->own.samples / 16) {
        end_block(m);
    }
    return 1;
}

/* ---- looks at all samples -------------------------------------------------------------------- */

/* Moves the centre by shift and makes scale 1. Returns 0 if that is impossible. */
static int is_recentred(invcal_magnetometer *m, const invcal_real shift[3], invcal_real scale)
{
    invcal_calibration c = {{shift[0], shift[1], shift[2]},
                            {{1 / scale, 0, 0}, {0, 1 / scale, 0}, {0, 0, 1 / scale}}};

    if (invcali_compose(&m->own_work, &c) != INVCAL_OK) {
        return 0;
    }
    m->own_work = c;
    m->own.unit *= scale;
    invcali_cells_move(&m->own.early, shift, scale);
    invcali_cells_move(&m->own.late, shift, scale);
    return 1;
}

/* Before the first solution p holds the box: the smallest readings, then the largest. Returns half
 * its longest edge. */
static invcal_real half_of_box(const invcal_magnetometer *m)
{
    invcal_real half = 0;

    for (unsigned i = 0; i < 3; i++) {
        if (m->own.p[3 + i] - m->own.p[i] > 2 * half) {
            half = (m->own.p[3 + i] - m->own.p[i]) / 2;
        }
    }
    return half;
}

static void recentre_by_box(invcal_magnetometer *m)
{
    invcal_real *const low = m->own.p;
    invcal_real *const high = &m->own.p[3];
    invcal_real shift[3];
    const invcal_real scale = half_of_box(m);

    for (unsigned i = 0; i < 3; i++) {
        shift[i] = (low[i] + high[i]) / 2;
    }
    if (is_recentred(m, shift, scale)) {
        for (unsigned i = 0; i < 3; i++) {
            low[i] = (low[i] - shift[i]) / scale;
            high[i] = (high[i] - shift[i]) / scale;
        }
    }
}

/* Returns whether there is a solution. Its quality is checked only before the second one. */
static int is_found(const invcal_magnetometer *m, invcali_cell_fit *fit)
{
    if (m->own.stage == SECOND_SOLUTION) {
        return invcali_cells_solve(fit) == INVCAL_OK;
    }
    return invcali_cells_calibrate(fit) == INVCAL_OK && fit->quality.verdict != INVCAL_WEAK &&
           fit->quality.dof >= 2;
}

/* Returns whether the centre or the scale has moved by more than a hundredth. Less does not change
 * the cells. */
static int is_far(const invcali_cell_fit *fit)
{
    const invcal_real *const shift = fit->triad.offset;

    return !(invcali_dot3(shift, shift) < FAR * FAR &&
             INVCAL_FABS(invcali_cells_field(fit) - 1) < FAR);
}

/* Solves table `one` and the late samples, and moves the readings to the unit sphere. Samples are
 * then compared with p. Returns 0 if there is no solution. */
static int has_solution(invcal_magnetometer *m, const invcal_private_cells *one,
                        invcali_cell_fit *fit)
{
    unsigned worst;

    fit->tables.early = one;
    fit->tables.late = &m->own.late;
    if (!(invcali_cells_gap(&fit->tables, &worst) > WIDE_GAP) || !is_found(m, fit)) {
        return 0;
    }
    fit->tables = both_tables(m);
    m->own.has_step |=
        (uint8_t)invcali_cells_step(fit, m->own.before > 0 ? m->own.before : power_of(m));
    fit->tables.early = one;
    if (is_far(fit) && (!is_recentred(m, fit->triad.offset, invcali_cells_field(fit)) ||
                        invcali_cells_solve(fit) != INVCAL_OK)) {
        return 0;
    }
    memcpy(m->own.p, fit->p, sizeof m->own.p);
    for (unsigned i = INVCAL_DK_X; i <= INVCAL_DK_Z; i++) {
        m->own.p[i] += INVCAL_REAL(0.5); /* J + h p is one product, less 1/2 */
    }
    return 1;
}

/* Drops the early samples unless the means of their cells agree with the solution: the variance of
 * a mean is power / n, and the mean of n r^2 / power over the cells must not exceed 1. Since the
 * solution has errors too, some are dropped without need. */
static void drop_unlike(invcal_magnetometer *m)
{
    const invcal_real power = power_of(m);
    invcal_real excess = 0;

    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        if (m->own.early.count[k] > 0) {
            const invcal_real n = invcali_number(m->own.early.count[k]);
            const invcal_real sum =
                invcali_dot(m->own.p, m->own.early.sum[k], INVCAL_PARAMETERS) - n / 2;
            excess += sum * sum / n - power;
        }
    }
    if (!(excess <= 0)) {
        invcali_zero(&m->own.early, sizeof m->own.early);
    }
}

/* The mean square of the distance of all samples from their centre. */
static invcal_real spread_of(const invcal_private_cells *cells)
{
    invcal_real sum[INVCAL_PARAMETERS] = {0};
    invcal_real n = 0;

    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        n += invcali_number(cells->count[k]);
        for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
            sum[i] += cells->sum[k][i];
        }
    }
    return (sum[INVCAL_DK_X] + sum[INVCAL_DK_Y] + sum[INVCAL_DK_Z] - invcali_dot3(sum, sum) / n) /
           n;
}

/* A wild sample widens the box, so that all others share a few cells, and there would be no
 * solution, however many come. So if nearly all are deep inside the box, and do not lie on an
 * ellipsoid, the next sample is the first again. */
static void forget_wild(invcal_magnetometer *m, invcali_cell_fit *fit)
{
    const invcal_real half = half_of_box(m);

    fit->tables = both_tables(m);
    if (spread_of(&m->own.early) < DEEP * half * half &&
        invcali_cells_calibrate(fit) != INVCAL_OK) {
        invcali_zero(&m->own.early, sizeof m->own.early);
        invcali_zero(m->own.p, sizeof m->own.p);
        m->own.samples = 0;
        m->own.due = FIRST_LOOK;
    }
}

/* The first samples were compared with nothing and may be disturbed. They are compared as soon as
 * later samples cover all sides too. */
static void look_at_samples(invcal_magnetometer *m)
{
    const int is_first = m->own.stage == NO_SOLUTION;
    invcali_cell_fit fit;

    if (is_first) {
        recentre_by_box(m);
    }
    if (m->own.stage != SECOND_SOLUTION && has_solution(m, &m->own.late, &fit)) {
        m->own.stage = SECOND_SOLUTION;
        drop_unlike(m);
    } else {
        if (has_solution(m, &m->own.early, &fit) && is_first) {
            m->own.stage = FIRST_SOLUTION;
        }
    }
    if (is_first || m->own.stage == SECOND_SOLUTION) {
        invcali_cells_merge(&m->own.early, &m->own.late);
    }
    if (m->own.stage == NO_SOLUTION) {
        forget_wild(m, &fit);
    }
    end_block(m);
    m->own.before = power_of(m);
    m->own.squares /= 2; /* residuals of an older solution count half */
    m->own.products /= 2;
    m->own.blocked /= 2;
}

/* ---- samples --------------------------------------------------------------------------------- */

/* Returns 0 if it is not a number, or could not be squared. */
static int widen_box(invcal_magnetometer *m, const invcal_real v[INVCAL_PARAMETERS])
{
    if (!invcali_are_finite(&v[INVCAL_DK_X])) {
        return 0;
    }
    for (unsigned i = 0; i < 3; i++) {
        if (v[i] < m->own.p[i]) {
            m->own.p[i] = v[i];
        }
        if (v[i] > m->own.p[3 + i]) {
            m->own.p[3 + i] = v[i];
        }
    }
    return 1;
}

invcal_event invcal_magnetometer_feed(invcal_magnetometer *magnetometer, invcal_real x,
                                      invcal_real y, invcal_real z)
{
    invcal_magnetometer *const m = magnetometer;
    const invcal_real raw[3] = {x, y, z};
    invcal_real h[INVCAL_PARAMETERS];

    INVCAL_ASSERT(m);
    if (m->own.due == 0) { /* not begun */
        return INVCAL_REFUSED;
    }
    if (m->own.samples == 0 && invcali_are_finite(raw)) {
        memcpy(m->own_work.offset, raw,
               sizeof m->own_work.offset); /* so that the readings are small */
    }
    invcali_correct(&m->own_work, raw, h);
    invcali_row_of(h);
    if (m->own.stage != NO_SOLUTION ? !is_alike(m, h) : !widen_box(m, h)) {
        m->own.dropped += m->own.dropped < FULL_COUNT && invcali_are_finite(&h[INVCAL_DK_X]);
        return INVCAL_REFUSED;
    }
    const unsigned k = invcali_cell_of_often(h);
    const unsigned before = (unsigned)m->own.early.count[k] + m->own.late.count[k];
    invcali_cells_add(&m->own.late, k, h);
    m->own.samples++;
    if (m->own.samples >= m->own.due) {
        look_at_samples(m);
        m->own.due += 5 * m->own.due / 8;
        if (m->own.due > FULL_COUNT) { /* the older ones count half */
            m->own.samples /= 2;
            m->own.dropped /= 2;
            m->own.due = FULL_COUNT;
        }
    }
    return before == 0 ? INVCAL_TAKEN : INVCAL_NOTHING;
}

void invcal_magnetometer_next(const invcal_magnetometer *magnetometer, invcal_real along[3])
{
    unsigned worst;

    INVCAL_ASSERT(magnetometer && along);
    const invcali_cell_tables tables = both_tables(magnetometer);
    (void)invcali_cells_gap(&tables, &worst);
    invcali_cell_direction(worst, along);
}

/* ---- result ---------------------------------------------------------------------------------- */

/* Faces and edges have only these angles; with samples in nine cells, none is larger. */
static uint8_t gap_of(invcal_real cosine)
{
    return cosine > INVCAL_REAL(0.8)    ? 0u
           : cosine > WIDE_GAP          ? 45u
           : cosine > INVCAL_REAL(0.25) ? 60u
                                        : 90u;
}

static void fill_found(const invcal_magnetometer *m, const invcali_cell_fit *fit,
                       invcal_magnetometer_found *found)
{
    const invcal_real power = power_of(m);
    unsigned worst;

    found->field = m->own.unit * invcali_cells_field(fit);
    const uint32_t compared = m->own.blocked + m->own.in_block;
    found->rms = compared > 0 ? INVCAL_SQRT(m->own.squares / (invcal_real)compared) : 0;
    found->alike = m->own.squares > 0 ? power / (found->rms * found->rms) : 0;
    found->samples = m->own.samples;
    found->dropped = m->own.dropped;
    found->covered = (uint8_t)fit->quality.positions;
    found->gap_deg = gap_of(invcali_cells_gap(&fit->tables, &worst));
    found->disturbance = m->own.dropped > 0 ? INVCAL_PASSING : INVCAL_UNDISTURBED;
    if (found->rms > PLACES_RMS && found->alike > PLACES_ALIKE) {
        found->disturbance = INVCAL_PLACES;
    }
    if (m->own.has_step || m->own.dropped > m->own.samples / 4 ||
        invcali_cells_step(fit, m->own.before > 0 ? m->own.before : power)) {
        found->disturbance = INVCAL_STEP;
    }
}

/* The parameters that an empty cell leaves to the other cells: offset and scale of its axes, and
 * the angle between two. */
static uint16_t parameters_along(unsigned cell)
{
    invcal_real along[3];
    unsigned bits = 0;
    unsigned axes = 0;
    unsigned sum = 0;

    invcali_cell_direction(cell, along);
    for (unsigned i = 0; i < 3; i++) {
        if (INVCAL_FABS(along[i]) > 0) {
            bits |= 1u << (INVCAL_DELTA_X + i) | 1u << (INVCAL_DK_X + i);
            axes++;
            sum += i;
        }
    }
    return (uint16_t)(axes == 2 ? bits | 1u << (INVCAL_GAMMA_XY + sum - 1u) : bits);
}

static void judge_motion(const invcal_magnetometer *m, const invcal_magnetometer_found *found,
                         const invcali_cell_tables *tables, invcal_quality *quality)
{
    unsigned worst;

    if (m->own.blocked < POWER_SAMPLES) { /* their correlation is not known yet */
        invcali_raise(quality, INVCAL_NO_REDUNDANCY);
    }
    if (found->gap_deg > 45) {
        (void)invcali_cells_gap(tables, &worst);
        quality->weak |= parameters_along(worst);
        invcali_raise(quality, INVCAL_WEAK);
    }
    if (found->disturbance > INVCAL_PASSING || found->dropped > found->samples / 8) {
        invcali_raise(quality, INVCAL_ROUGH);
    }
}

invcal_status invcal_magnetometer_solve(const invcal_magnetometer *magnetometer,
                                        invcal_calibration *out, invcal_quality *quality,
                                        invcal_magnetometer_found *found)
{
    const invcal_magnetometer *const m = magnetometer;
    invcal_magnetometer_found f;
    invcali_cell_fit fit;

    INVCAL_ASSERT(m && out && quality);
    if (m->own.due == 0) {
        return INVCAL_NOT_BEGUN;
    }
    fit.tables = both_tables(m);
    invcal_status status = invcali_cells_calibrate(&fit);
    if (status != INVCAL_OK) {
        return status;
    }
    fill_found(m, &fit, &f);
    invcali_cells_weigh(&fit, power_of(m));
    /* of delta, which is in units of the cells so far */
    for (unsigned i = 0; i < 3; i++) {
        fit.quality.sigma[i] /= invcali_cells_field(&fit);
    }
    judge_motion(m, &f, &fit.tables, &fit.quality);
    status = invcali_compose(&m->own_work, &fit.triad);
    if (status == INVCAL_OK) {
        *out = fit.triad;
        *quality = fit.quality;
        if (found != NULL) {
            *found = f;
        }
    }
    return status;
}

/* The calibration of raw counts, after the inverse of work, calibrates the coordinates of the
 * cells. */
unsigned invcali_magnetometer_cell(const invcal_magnetometer *magnetometer,
                                   const invcal_calibration *calibration, unsigned k,
                                   invcal_real raw[3])
{
    invcal_real inverse[3][3];
    invcal_calibration triad;
    invcal_real point[3] = {0, 0, 0};

    INVCAL_ASSERT(magnetometer && calibration && k < INVCAL_CELLS && raw);
    const invcal_calibration *const work = &magnetometer->own_work;
    const invcali_cell_tables tables = both_tables(magnetometer);
    invcali_inverse3(work->matrix, inverse);
    invcali_correct(work, calibration->offset, triad.offset);
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real *const a = calibration->matrix[i];
        for (unsigned j = 0; j < 3; j++) {
            triad.matrix[i][j] = a[0] * inverse[0][j] + a[1] * inverse[1][j] + a[2] * inverse[2][j];
        }
    }
    const unsigned count = invcali_cells_point(&tables, &triad, k, point);
    for (unsigned i = 0; i < 3 && count > 0; i++) {
        raw[i] = work->offset[i] + invcali_dot3(inverse[i], point);
    }
    return count;
}

const char *invcal_disturbance_text(invcal_disturbance disturbance)
{
    static const char texts[] =
        "\0"
        "samples contradict the others and were left out, as if a magnet or iron had passed by\0"
        "the field differs from place to place: turn it where it is, away from iron\0"
        "readings changed at some time, as if something magnetic had moved: begin again\0"
        "unknown disturbance";

    return invcali_text(texts, disturbance, INVCAL_STEP + 1u);
}
