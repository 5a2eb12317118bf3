/* SPDX-License-Identifier: MIT
 *
 * The end: what is stored, compared with what the triad really is.
 */
#include <math.h>

#include "board.h"
#include "flash.h"
#include "imu.h"
#include "invcal/expert.h"
#include "print.h"
#include "sim.h"

#define SIGMAS 4.0f   /* that a stored number may be off */
#define LENGTH 0.001f /* that a calibrated reading of 1 g may be off */

/* One number beside its truth. Returns 1 if it is good. */
static int is_close(const char *name, float truth, float stored, float sigma)
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

/* The offsets in counts, and the nine parameters by the data sheet's scale. */
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
        good &= is_close(offset[i], sim_truth.offset[i], record->calibration.offset[i],
                         record->sigma[i] * IMU_COUNTS);
    }
    for (unsigned i = 0; i < 3; i++) {
        const unsigned r = INVCAL_DK_X + i;
        const float dk = sim_truth.gain[i][i] / IMU_COUNTS - 1;
        good &= is_close(invcal_parameter_name(r), dk, x[r], record->sigma[r]);
    }
    for (unsigned i = 0; i < 3; i++) {
        const unsigned r = INVCAL_GAMMA_XY + i;
        const unsigned a = pair[i][0], b = pair[i][1];
        const float gamma = (sim_truth.gain[a][b] + sim_truth.gain[b][a]) / IMU_COUNTS;
        good &= is_close(invcal_parameter_name(r), gamma, x[r], record->sigma[r]);
    }
    return good;
}

/* Each axis up and down, without noise: the largest error of the calibrated length. */
static int are_lengths_good(const invcal_calibration *calibration)
{
    float worst = 0;

    for (unsigned axis = 0; axis < 6; axis++) {
        float a[3];
        for (unsigned i = 0; i < 3; i++) {
            const float gain = sim_truth.gain[i][axis / 2];
            a[i] = sim_truth.offset[i] + (axis % 2 ? -gain : gain);
        }
        invcal_apply(calibration, a, a);
        const float error = fabsf(sqrtf(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) - 1);
        worst = error <= worst ? worst : error;
    }
    print("world: 1 g is read with an error of up to ");
    print_fixed(worst, 6);
    print(" g\n");
    return worst <= LENGTH;
}

void judge(void)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    uint32_t size;
    invcal_record record;
    invcal_status status = invcal_store_load(&calibration_store, bytes, sizeof bytes, &size);

    if (status == INVCAL_OK) {
        status = invcal_record_decode(bytes, size, &record);
    }
    if (status != INVCAL_OK) {
        print("world: no calibration was stored: ");
        print(invcal_status_text(status));
        print("\n");
        board_exit(1);
    }
    const int good = are_parameters_good(&record) & are_lengths_good(&record.calibration);
    print(good ? "world: the stored calibration is good\n"
               : "world: the stored calibration is not good\n");
    board_exit(!good);
}
