/* SPDX-License-Identifier: MIT
 *
 * calibrate/cross_check.h: compares the result with the l1 estimate from all positions.
 */
#ifndef CALIBRATE_CROSS_CHECK_H
#define CALIBRATE_CROSS_CHECK_H

#include "result/result.h"

void cross_check(calibrate_result *result);

#endif
