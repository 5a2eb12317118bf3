/* SPDX-License-Identifier: MIT
 *
 * Finds exchanged or reversed axes of a gyroscope after a solution was refused (mathematics_imu.md,
 * "Verdict"). M is an argument of the integration of segments, so each mounting costs one pass over
 * the equations, without an unknown and without a sample.
 */
#include "imu.h"
#include "rotation.h"
#include "../core/vector.h"

#define DEGREES INVCAL_REAL(57.29578)
#define CLEAR INVCAL_REAL(4.0)   /* min ratio of the squares of the second best and the best */
#define NO_TURN INVCAL_REAL(1e4) /* 0.2 degrees, squared, in units of a segment */
#define STUCK INVCAL_REAL(1e-4)  /* an axis with a smaller share of all squares never turns */
enum { SIGNS = 8, ORDERS = 6, MOUNTINGS = SIGNS * ORDERS, LEAST_TURNS = 2 };

/* Sets M to mounting k of 48: row i has one element, at of[i]. Half of them are mirror images, as
 * after a single wrong sign. */
static void set_mounting(invcali_imu_work *w, unsigned k, invcal_real unit, int8_t axes[3])
{
    const unsigned order = k / SIGNS;
    const unsigned first = order / 2;
    const unsigned second = (first + 1 + order % 2) % 3;
    const unsigned of[3] = {first, second, 3 - first - second};

    for (unsigned i = 0; i < 3; i++) {
        const int is_negative = (k >> i & 1u) != 0;
        axes[i] = (int8_t)(is_negative ? -(int)of[i] - 1 : (int)of[i] + 1);
        for (unsigned j = 0; j < 3; j++) {
            const invcal_real element = j == of[i] ? unit : 0;
            w->parameter[3 * i + j] = is_negative ? -element : element;
        }
    }
}

/* Sets axes that never turn to 0, the others to themselves. Returns whether one never turns. */
static int find_stuck(const invcal_private_moves *m, int8_t axes[3])
{
    invcal_real square[3] = {0, 0, 0};
    int is_stuck = 0;

    for (unsigned k = 0; k < m->first; k++) {
        for (unsigned i = 0; i < 3; i++) {
            square[i] += (invcal_real)m->segment[k].v[i] * (invcal_real)m->segment[k].v[i];
        }
    }
    const invcal_real least = NO_TURN + STUCK * (square[0] + square[1] + square[2]);
    for (unsigned i = 0; i < 3; i++) {
        const int never = m->first > 0 && square[i] < least;
        axes[i] = (int8_t)(never ? 0 : i + 1);
        is_stuck |= never;
    }
    return is_stuck;
}

/* The best mounting, and the sum of squares of the second best. */
typedef struct {
    invcal_real squares, next, unit;
    int8_t axes[3];
} best_mounting;

static void compare(best_mounting *best, const int8_t axes[3], invcal_real unit,
                    invcal_real squares)
{
    if (squares < best->squares) {
        best->next = best->squares;
        best->squares = squares;
        best->unit = unit;
        memcpy(best->axes, axes, sizeof best->axes);
    } else if (squares < best->next) {
        best->next = squares;
    } /* cppcheck-suppress misra-c2012-15.7 ; it is one of many */
}

static invcal_status try_all(invcali_imu_work *w, best_mounting *best)
{
    for (unsigned k = 0; k < 2 * MOUNTINGS; k++) {
        const invcal_real unit = k < MOUNTINGS ? 1 : DEGREES;
        int8_t axes[3];
        set_mounting(w, k % MOUNTINGS, unit, axes);
        const invcal_status status = invcali_imu_sum(w);
        if (status != INVCAL_OK) {
            return status;
        }
        if (w->pass.kind[INVCAL_OF_MOVES] / 2 < LEAST_TURNS) {
            return INVCAL_TOO_FEW;
        }
        compare(best, axes, unit, w->pass.residuals);
    }
    return best->next > CLEAR * best->squares ? INVCAL_OK : INVCAL_UNDETERMINED;
}

invcal_status invcali_imu_mounting_of(const invcal_imu *imu, const invcal_positions *positions,
                                      int8_t axes[3], invcal_real *unit)
{
    invcali_imu_work w;
    invcal_imu_result out;
    best_mounting best;

    invcal_status status = invcali_imu_begin(&w, imu, positions, NULL, &out);
    best.squares = INVCAL_REAL_MAX;
    best.next = INVCAL_REAL_MAX;
    best.unit = 1;
    if (status == INVCAL_OK && !find_stuck(&imu->own, best.axes)) {
        w.n = 0;
        status = try_all(&w, &best);
    }
    if (status == INVCAL_OK) {
        memcpy(axes, best.axes, sizeof best.axes);
        *unit = best.unit;
    }
    return status;
}

invcal_status invcal_imu_mounting(const invcal_imu *imu, int8_t axes[3], invcal_real *unit)
{
    INVCAL_ASSERT(imu && axes && unit);
    if (!invcali_imu_is_begun(imu)) {
        return INVCAL_NOT_BEGUN;
    }
    const invcal_positions positions = invcali_imu_positions(imu);
    return invcali_imu_mounting_of(imu, &positions, axes, unit);
}
