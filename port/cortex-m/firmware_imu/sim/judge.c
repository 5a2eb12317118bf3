/* SPDX-License-Identifier: MIT
 *
 * The end: compares the stored result with the true triads.
 */
#include <math.h>

#include "board.h"
#include "flash.h"
#include "invcal/gyro.h"
#include "print.h"
#include "world.h"

#define SIGMAS 4.0f   /* largest error of a stored number */
#define LENGTH 0.001f /* largest error of a calibrated reading of 1 g */
#define BIAS 0.5f     /* counts, largest error of an offset of the gyroscope */

/* A perfect matrix makes the identity of the truth. */
static int is_gyro_good(const invcal_imu_record *record)
{
    int good = 1;

    for (unsigned i = 0; i < 9; i++) {
        const unsigned r = i / 3, c = i % 3;
        float error = r == c ? -1.0f : 0;
        for (unsigned k = 0; k < 3; k++) {
            error += record->gyro.matrix[r][k] * gyro_truth.gain[k][c];
        }
        const float off = error / record->sigma[i];
        print("world: ");
        print(invcal_imu_parameter_name(i));
        print(" is wrong by 1e-4 ");
        print_fixed(1e4f * error, 2);
        print(", sigma ");
        print_fixed(off, 1);
        print("\n");
        good &= fabsf(off) <= SIGMAS && record->sigma[i] < 0.002f;
    }
    for (unsigned i = 0; i < 3; i++) {
        good &= fabsf(record->gyro.offset[i] - gyro_truth.offset[i]) < BIAS;
    }
    return good;
}

/* Each axis up and down, without noise: the largest error of any component. */
static int is_accelerometer_good(const invcal_calibration *calibration)
{
    float worst = 0;

    for (unsigned face = 0; face < 6; face++) {
        const float sign = face % 2 ? -1.0f : 1.0f;
        float a[3];
        for (unsigned i = 0; i < 3; i++) {
            a[i] = sim_truth.offset[i] + sign * sim_truth.gain[i][face / 2];
        }
        invcal_apply(calibration, a, a);
        a[face / 2] -= sign;
        for (unsigned i = 0; i < 3; i++) {
            worst = fabsf(a[i]) <= worst ? worst : fabsf(a[i]);
        }
    }
    print("world: 1 g is read with an error of up to ");
    print_fixed(worst, 6);
    print(" g\n");
    return worst <= LENGTH;
}

void judge(void)
{
    static invcal_imu_record record;
    const invcal_status status = invcal_load_imu(&calibration_store, &record);

    if (status != INVCAL_OK) {
        print("world: no calibration was stored: ");
        print(invcal_status_text(status));
        print("\n");
        board_exit(1);
    }
    const int good =
        is_gyro_good(&record) & is_accelerometer_good(&record.accelerometer.calibration);
    print(good ? "world: the stored calibration is good\n"
               : "world: the stored calibration is not good\n");
    board_exit(!good);
}
