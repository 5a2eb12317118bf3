/* SPDX-License-Identifier: MIT
 *
 * The sizes of the structures that firmware keeps, for nm to read: an array as large as each.
 */
#include "invcal/invcal.h"

#define SIZE_OF(name)                                                                              \
    extern char size_of_##name[sizeof(name)];                                                      \
    char size_of_##name[sizeof(name)]

SIZE_OF(invcal_calibration);
SIZE_OF(invcal_observation);
SIZE_OF(invcal_normal);
SIZE_OF(invcal_solution);
SIZE_OF(invcal_residuals);
SIZE_OF(invcal_quality);
SIZE_OF(invcal_outliers);
SIZE_OF(invcal_still);
SIZE_OF(invcal_session);
SIZE_OF(invcal_record);
SIZE_OF(invcal_allan);
SIZE_OF(invcal_noise);
SIZE_OF(invcal_thermal_settings);
SIZE_OF(invcal_thermal_calibration);
SIZE_OF(invcal_thermal_sums);
SIZE_OF(invcal_thermal_record);
