/* SPDX-License-Identifier: MIT
 *
 * text/parameter.h: the names of the parameters in plain words.
 */
#ifndef PARAMETER_H
#define PARAMETER_H

#include <stddef.h>
#include <stdint.h>

/* "offset x", "scale y", "angle zy", ... of the nine. */
const char *parameter_words(unsigned parameter);

/* The same, then "gyro scale x", "gyro angle xy", ... of the 18 of both sensors. */
const char *parameter_words_imu(unsigned parameter);

/* Those whose bits are set: "offset z, gyro angle yz". Truncated to `size`. Returns text. */
#define PARAMETER_LIST_MAX 320
const char *parameter_list_imu(uint32_t bits, char *text, size_t size);

#endif
