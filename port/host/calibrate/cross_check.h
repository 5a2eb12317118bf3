/* SPDX-License-Identifier: MIT
 *
 * calibrate/cross_check.h: does the l1 estimate of all positions agree with the result?
 */
#ifndef CALIBRATE_CROSS_CHECK_H
#define CALIBRATE_CROSS_CHECK_H

#include "result/result.h"

void cross_check(calibrate_result *result);

#endif
