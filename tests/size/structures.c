/* SPDX-License-Identifier: MIT
 *
 * The sizes of the structures that firmware keeps, for nm: an array as large as each.
 */
#include "invcal/allan.h"
#include "invcal/background.h"
#include "invcal/expert.h"
#include "invcal/frame.h"
#include "invcal/gyro.h"
#include "invcal/magnetometer.h"
#include "invcal/store.h"
#include "invcal/thermal.h"
#include "core/sums.h"

#define SIZE_OF(name)                                                                              \
    extern char size_of_##name[sizeof(name)];                                                      \
    char size_of_##name[sizeof(name)]

SIZE_OF(invcal_calibration);
SIZE_OF(invcali_row);
SIZE_OF(invcal_sums);
SIZE_OF(invcal_frame);
SIZE_OF(invcal_imu);
SIZE_OF(invcal_imu_result);
SIZE_OF(invcal_private_moves);
SIZE_OF(invcal_quality);
SIZE_OF(invcal_private_rests);
SIZE_OF(invcal_session);
SIZE_OF(invcal_background);
SIZE_OF(invcal_record);
SIZE_OF(invcal_allan);
SIZE_OF(invcal_noise);
SIZE_OF(invcal_magnetometer);
SIZE_OF(invcal_dip);
SIZE_OF(invcal_thermal);
