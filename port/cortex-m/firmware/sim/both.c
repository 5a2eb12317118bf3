/* SPDX-License-Identifier: MIT
 *
 * The simulated world of the firmware of both sensors.
 */
#include <math.h>

#include "flash.h"
#include "invcal/gyro.h"
#include "sim.h"

#define BIAS 0.5f    /* counts: largest error of an offset of the gyroscope */
#define SIGMA 0.002f /* largest sigma */

const uint16_t hand_script[HAND_PLACES] = {
    [3] = KNOCKS,     [4] = RESET_IN_MOVE, [6] = HURRIES,
    [8] = SLOW_FLASH, [9] = POWER_CUT,     [11] = RESET_IN_MOVE,
};

static invcal_imu_record both;

invcal_status load_record(invcal_record *record)
{
    const invcal_status status = invcal_imu_load(&both, &calibration_store);

    *record = both.accelerometer;
    return status;
}

/* The product of a perfect matrix and the true gain is the identity. */
int verify_others(void)
{
    int good = 1;

    for (unsigned i = 0; i < INVCAL_GYRO_PARAMETERS; i++) {
        const unsigned r = i / 3, c = i % 3;
        float product = 0;
        for (unsigned k = 0; k < 3; k++) {
            product += both.gyro.matrix[r][k] * sim_gyro_truth.gain[k][c];
        }
        good &=
            verify_parameter(invcal_imu_parameter_text(i), r == c ? 1 : 0, product, both.sigma[i]) &
            (both.sigma[i] < SIGMA);
    }
    for (unsigned i = 0; i < 3; i++) {
        good &= fabsf(both.gyro.offset[i] - sim_gyro_truth.offset[i]) < BIAS;
    }
    return good;
}
