/* SPDX-License-Identifier: MIT
 *
 * The simulated world of the firmware of both sensors.
 */
#include <math.h>

#include "flash.h"
#include "invcal/gyro_store.h"
#include "invcal/result.h"
#include "sim.h"

#define BIAS 0.5f    /* counts: largest error of an offset of the gyroscope */
#define SIGMA 0.002f /* largest sigma */

const uint16_t hand_script[HAND_PLACES] = {
    [3] = KNOCKS,     [4] = RESET_IN_MOVE, [6] = HURRIES,
    [8] = SLOW_FLASH, [9] = POWER_CUT,     [11] = RESET_IN_MOVE,
};

static invcal_imu_result both;

invcal_status load_record(invcal_record *record)
{
    uint8_t bytes[INVCAL_IMU_RECORD_SIZE];
    uint32_t size;

    const invcal_status status = invcal_store_load(&calibration_store, bytes, sizeof bytes, &size);
    return status == INVCAL_OK ? invcal_imu_decode(bytes, size, &both, record) : status;
}

/* The product of a perfect matrix and the true gain is the identity. */
int verify_others(void)
{
    int good = 1;

    for (unsigned i = 0; i < 9; i++) {
        const unsigned r = i / 3, c = i % 3;
        const float sigma = both.sigma[INVCAL_GYRO_XX + i];
        float product = 0;
        for (unsigned k = 0; k < 3; k++) {
            product += both.gyro.matrix[r][k] * sim_gyro_truth.gain[k][c];
        }
        good &= verify_parameter(invcal_parameter_text(INVCAL_GYRO_XX + i), r == c ? 1 : 0, product,
                                 sigma) &
                (sigma < SIGMA);
    }
    for (unsigned i = 0; i < 3; i++) {
        good &= fabsf(both.gyro.offset[i] - sim_gyro_truth.offset[i]) < BIAS;
    }
    return good;
}
