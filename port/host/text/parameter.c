/* SPDX-License-Identifier: MIT */
#include "text/parameter.h"

#include "invcal/gyro.h"
#include "text/append.h"

const char *parameter_words(unsigned parameter)
{
    static const char *const words[INVCAL_PARAMETERS] = {"offset x", "offset y", "offset z",
                                                         "scale x",  "scale y",  "scale z",
                                                         "angle xy", "angle xz", "angle zy"};

    return words[parameter];
}

const char *parameter_words_imu(unsigned parameter)
{
    static const char *const gyro[INVCAL_IMU_PARAMETERS - INVCAL_PARAMETERS] = {
        "gyro scale x",  "gyro angle xy", "gyro angle xz", "gyro angle yx", "gyro scale y",
        "gyro angle yz", "gyro angle zx", "gyro angle zy", "gyro scale z"};

    return parameter < INVCAL_PARAMETERS ? parameter_words(parameter)
                                         : gyro[parameter - INVCAL_PARAMETERS];
}

const char *parameter_list_imu(uint32_t bits, char *text, size_t size)
{
    text[0] = '\0';
    for (unsigned i = 0; i < INVCAL_IMU_PARAMETERS; i++) {
        if (bits >> i & 1u) {
            append(text, size, "%s%s", *text ? ", " : "", parameter_words_imu(i));
        }
    }
    return text;
}
