/* SPDX-License-Identifier: MIT
 * A config header (INVCAL_CONFIG_HEADER) that makes programming errors stop the tests. */
#include <assert.h>

#define INVCAL_ASSERT(condition) assert(condition)
