/* SPDX-License-Identifier: MIT
 *
 * Positions from an array of numbers, x y z, x y z, ..., as an argument.
 */
#ifndef TESTS_POSITIONS_H
#define TESTS_POSITIONS_H

#include "invcal/positions.h"

#define POSITIONS_OF(raw, count, nominal, noise)                                                   \
    (&(const invcal_positions){(const invcal_vector *)(raw), (count), (nominal), (noise), NULL})

/* The same with temperatures. */
#define POSITIONS_AT(raw, temperature, count, nominal, noise)                                      \
    (&(const invcal_positions){(const invcal_vector *)(raw), (count), (nominal), (noise),          \
                               (temperature)})

/* Less some of them: judge.h. */
#define SELECTION(raw, count, left_out, nominal, noise)                                            \
    (&(const invcali_selection){*POSITIONS_OF(raw, count, nominal, noise), (invcali_set)(left_out)})

#endif
