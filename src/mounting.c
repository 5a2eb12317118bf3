/* SPDX-License-Identifier: MIT */
#include "imu.h"
#include "rotation.h"
#include "vector.h"

#define DEGREES INVCAL_REAL(57.29578)
#define CLEAR INVCAL_REAL(4.0)  /* squares of the next best way over those of the best */
#define STUCK INVCAL_REAL(1e-4) /* an axis that has less of all squares never turns */
enum { SIGNS = 8, ORDERS = 6, LEAST_TURNS = 2 };

/* Way k of 48: M has in row i the axis `of`, with its sign. */
static void set_way(invcal_imu_work *w, unsigned k, invcal_real unit, int8_t axes[3])
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
            w->out->parameter[3 * i + j] = is_negative ? -element : element;
        }
    }
}

/* Gyroscope axes that never turn: a bit each. */
static unsigned find_stuck(const invcal_moves *m)
{
    invcal_real square[3] = {0, 0, 0};
    unsigned stuck = 0;

    for (unsigned k = 0; k < m->first; k++) {
        for (unsigned i = 0; i < 3; i++) {
            square[i] += (invcal_real)m->segment[k].v[i] * (invcal_real)m->segment[k].v[i];
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        const int turns = square[i] > STUCK * (square[0] + square[1] + square[2]);
        stuck |= (turns ? 0u : 1u) << i;
    }
    return stuck;
}

invcal_status invcal_imu_mounting(const invcal_real *raw, unsigned count,
                                  const invcal_calibration *accelerometer,
                                  const invcal_moves *moves, int8_t axes[3], invcal_real *unit)
{
    invcal_imu_work w;
    invcal_imu out;
    int8_t best_axes[3] = {0, 0, 0};
    invcal_real best = INVCAL_REAL_MAX;
    invcal_real next = INVCAL_REAL_MAX;
    invcal_real best_unit = 1;

    INVCAL_ASSERT((raw || count == 0) && accelerometer && moves && axes && unit);
    invcal_status status = invcal_imu_begin(&w, raw, count, accelerometer, moves, NULL, &out);
    const unsigned stuck = find_stuck(moves);
    if (status == INVCAL_OK && stuck != 0) {
        for (unsigned i = 0; i < 3; i++) {
            axes[i] = (int8_t)((stuck >> i & 1u) != 0 ? 0 : i + 1);
        }
        *unit = 1;
        return INVCAL_OK;
    }
    w.n = 0;
    for (unsigned k = 0; k < 2 * SIGNS * ORDERS && status == INVCAL_OK; k++) {
        const invcal_real scale = k < SIGNS * ORDERS ? 1 : DEGREES;
        int8_t way[3];
        unsigned is_another = 0;
        set_way(&w, k % (SIGNS * ORDERS), scale, way);
        status = invcal_imu_sum(&w);
        if (status == INVCAL_OK && w.pass.moved.rows / 2 < LEAST_TURNS) {
            status = INVCAL_TOO_FEW;
        }
        for (unsigned i = 0; i < 3; i++) {
            is_another |= way[i] != best_axes[i];
        }
        const invcal_real squares = w.pass.residuals;
        if (squares < best) {
            next = is_another ? best : next;
            best = squares;
            best_unit = scale;
            for (unsigned i = 0; i < 3; i++) {
                best_axes[i] = way[i];
            }
        } else if (is_another && squares < next) {
            next = squares;
        } /* cppcheck-suppress misra-c2012-15.7 ; it is one of many */
    }
    if (status == INVCAL_OK && !(next > CLEAR * best)) {
        status = INVCAL_UNDETERMINED;
    }
    if (status == INVCAL_OK) {
        for (unsigned i = 0; i < 3; i++) {
            axes[i] = best_axes[i];
        }
        *unit = best_unit;
    }
    return status;
}

const char *invcal_imu_parameter_name(unsigned parameter)
{
    static const char names[INVCAL_GYRO_PARAMETERS][8] = {"gyro_xx", "gyro_xy", "gyro_xz",
                                                          "gyro_yx", "gyro_yy", "gyro_yz",
                                                          "gyro_zx", "gyro_zy", "gyro_zz"};

    return parameter < INVCAL_GYRO_PARAMETERS
               ? names[parameter]
               : invcal_parameter_name(parameter - INVCAL_GYRO_PARAMETERS);
}
