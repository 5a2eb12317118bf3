/* SPDX-License-Identifier: MIT
 *
 * The end of the run: compares what is stored with the true parameters.
 */
#include <math.h>

#include "board.h"
#include "imu.h"
#include "invcal/positions.h"
#include "invcal/result.h"
#include "print.h"
#include "sim.h"

#define SIGMAS 4.0f    /* largest error of a stored number */
#define READING 0.001f /* largest error of a calibrated reading of 1 g */

int verify_parameter(const char *name, float truth, float stored, float sigma)
{
    const float off = (stored - truth) / sigma;

    print("world: truth ");
    print(name);
    print(" ");
    print_fixed(truth, 5);
    print(", stored ");
    print_fixed(stored, 5);
    print(", off by ");
    print_fixed(off, 1);
    print(" sigma\n");
    return sigma > 0 && fabsf(off) <= SIGMAS;
}

/* The offsets in counts, and the other parameters relative to the data sheet's scale. */
static int are_parameters_good(const invcal_record *record)
{
    static const invcal_real zero[3] = {0, 0, 0};
    static const invcal_real counts[3] = {IMU_COUNTS, IMU_COUNTS, IMU_COUNTS};
    static const char *const offset[3] = {"offset_x", "offset_y", "offset_z"};
    static const uint8_t pair[3][2] = {{0, 1}, {0, 2}, {2, 1}};
    invcal_calibration nominal;
    invcal_real x[INVCAL_PARAMETERS];
    int good = invcal_nominal(zero, counts, &nominal) == INVCAL_OK;

    invcal_deviation(&record->calibration, &nominal, x);
    for (unsigned i = 0; i < 3; i++) {
        good &= verify_parameter(offset[i], sim_truth.offset[i], record->calibration.offset[i],
                                 record->sigma[i] * IMU_COUNTS);
    }
    for (unsigned i = 0; i < 3; i++) {
        const unsigned r = INVCAL_DK_X + i;
        const float dk = sim_truth.gain[i][i] / IMU_COUNTS - 1;
        good &= verify_parameter(invcal_parameter_text(r), dk, x[r], record->sigma[r]);
    }
    for (unsigned i = 0; i < 3; i++) {
        const unsigned r = INVCAL_GAMMA_XY + i;
        const unsigned a = pair[i][0], b = pair[i][1];
        const float gamma = (sim_truth.gain[a][b] + sim_truth.gain[b][a]) / IMU_COUNTS;
        good &= verify_parameter(invcal_parameter_text(r), gamma, x[r], record->sigma[r]);
    }
    return good;
}

/* Each axis up and down, without noise: the largest error of any component. */
static int are_readings_good(const invcal_calibration *calibration)
{
    float worst = 0;

    for (unsigned face = 0; face < 6; face++) {
        const float sign = face % 2 ? -1.0f : 1.0f;
        float a[3];
        for (unsigned i = 0; i < 3; i++) {
            a[i] = sim_truth.offset[i] + sign * sim_truth.gain[i][face / 2];
        }
        invcal_apply(calibration, a[0], a[1], a[2], a);
        a[face / 2] -= sign;
        for (unsigned i = 0; i < 3; i++) {
            worst = fabsf(a[i]) <= worst ? worst : fabsf(a[i]);
        }
    }
    print("world: 1 g is read with an error of up to ");
    print_fixed(worst, 6);
    print(" g\n");
    return worst <= READING;
}

void verify(void)
{
    invcal_record record;
    const invcal_status status = load_record(&record);

    if (status != INVCAL_OK) {
        print("world: no calibration was stored: ");
        print(invcal_status_text(status));
        print("\n");
        board_exit(1);
    }
    const int good =
        are_parameters_good(&record) & are_readings_good(&record.calibration) & verify_others();
    print(good ? "world: the stored calibration is good\n"
               : "world: the stored calibration is not good\n");
    board_exit(!good);
}
