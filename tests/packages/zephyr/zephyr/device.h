/* SPDX-License-Identifier: MIT
 *
 * In place of Zephyr's header of this name: what the sample uses of it, as its documentation says.
 */
#ifndef MOCK_DEVICE_H
#define MOCK_DEVICE_H

#include <stdbool.h>

struct device {
    const char *name;
};

#define DT_ALIAS(alias) mock_##alias
#define DEVICE_DT_GET(node) (&node)
extern const struct device mock_accel0;

bool device_is_ready(const struct device *dev);

#endif
