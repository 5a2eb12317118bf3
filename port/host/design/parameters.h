/* SPDX-License-Identifier: MIT
 *
 * design/parameters.h: names of the nine parameters, and of the positions that determine them.
 *
 * Texts are cut to fit into `size`.
 */
#ifndef PARAMETERS_H
#define PARAMETERS_H

#include <stddef.h>
#include <stdint.h>

#include "text/parameter.h"

/* How many bits are set. */
unsigned parameters_count(uint16_t bits);

/* Those whose bits are set: "offset z, scale z". Returns text. */
const char *parameters_list(uint16_t bits, char *text, size_t size);

/* Positions that determine them, to follow "add positions with": "the field along +z and -z, and
 * midway between x and z". Returns text. */
const char *parameters_advice(uint16_t bits, char *text, size_t size);

#endif
