/* SPDX-License-Identifier: MIT
 *
 * Inputs of the proofs. An analysis with them covers every run with any inputs that the headers allow:
 * ANY(object) is any bytes at all, including NaN and infinities.
 */
#ifndef ARBITRARY_H
#define ARBITRARY_H

#include <__fc_builtin.h>

#define ANY(object) Frama_C_make_unknown((char *)&(object), sizeof(object))

/* A number from low to high, inclusive. */
#define BETWEEN(low, high) Frama_C_unsigned_int_interval(low, high)

#endif
