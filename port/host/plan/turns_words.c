/* SPDX-License-Identifier: MIT
 *
 * Parameters of turns in words.
 */
#include <stdio.h>
#include <string.h>

#include "design/parameters.h"
#include "plan/turns.h"
#include "plan/words.h"

const char *turns_parameter(unsigned parameter)
{
    static const char *const gyro[INVCAL_GYRO_PARAMETERS] = {
        "gyro scale x",  "gyro angle xy", "gyro angle xz", "gyro angle yx", "gyro scale y",
        "gyro angle yz", "gyro angle zx", "gyro angle zy", "gyro scale z"};

    return parameter < INVCAL_GYRO_PARAMETERS ? gyro[parameter]
                                              : parameter_words(parameter - INVCAL_GYRO_PARAMETERS);
}

const char *turns_parameters(unsigned bits, char text[TURNS_LIST_MAX])
{
    text[0] = '\0';
    for (unsigned i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        if (bits >> i & 1u) {
            const size_t length = strlen(text);
            snprintf(text + length, TURNS_LIST_MAX - length, "%s%s", length > 0 ? ", " : "",
                     turns_parameter(i));
        }
    }
    return text;
}

unsigned turns_kind(unsigned parameter)
{
    if (parameter < INVCAL_GYRO_PARAMETERS) {
        return parameter % 4 == 0 ? 1 : 2;
    }
    return (parameter - INVCAL_GYRO_PARAMETERS) / 3;
}
