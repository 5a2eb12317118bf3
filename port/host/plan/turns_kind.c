/* SPDX-License-Identifier: MIT
 *
 * The kinds of the 18 parameters.
 */
#include "plan/turns.h"

unsigned turns_kind(unsigned parameter)
{
    if (parameter >= INVCAL_GYRO_XX) {
        return (parameter - INVCAL_GYRO_XX) % 4 == 0 ? 1 : 2;
    }
    return parameter / 3;
}
