/* SPDX-License-Identifier: MIT */
#include "read/column.h"

const char *column_name(column which)
{
    static const char *const names[COLUMN_COUNT] = {
        "x", "y", "z", "std_x", "std_y", "std_z", "n", "t", "temperature", "alpha", "beta"};

    return names[which];
}
