/* SPDX-License-Identifier: MIT
 *
 * Parameters of turns: their kinds.
 */
#include "plan/turns.h"

unsigned turns_kind(unsigned parameter)
{
    if (parameter < INVCAL_GYRO_PARAMETERS) {
        return parameter % 4 == 0 ? 1 : 2;
    }
    return (parameter - INVCAL_GYRO_PARAMETERS) / 3;
}
