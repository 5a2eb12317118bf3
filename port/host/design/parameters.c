/* SPDX-License-Identifier: MIT */
#include "design/parameters.h"

#include <stdio.h>
#include <string.h>

#include "invcal/invcal.h"

static void append(char *text, size_t size, const char *more)
{
    const size_t length = strlen(text);

    snprintf(text + length, size - length, "%s", more);
}

unsigned parameters_count(uint16_t bits)
{
    unsigned count = 0;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        count += (unsigned)bits >> r & 1u;
    }
    return count;
}

const char *parameters_list(uint16_t bits, char *text, size_t size)
{
    text[0] = '\0';
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if ((unsigned)bits >> r & 1u) {
            append(text, size, *text ? ", " : "");
            append(text, size, parameter_words(r));
        }
    }
    return text;
}

const char *parameters_advice(uint16_t bits, char *text, size_t size)
{
    static const char *const along[] = {"+x and -x", "+y and -y", "+z and -z"};
    static const char *const between[] = {"x and y", "x and z", "z and y"};
    const char *joint = "the field along ";

    text[0] = '\0';
    for (unsigned i = 0; i < 3; i++) {
        /* the two ends of an axis determine its offset and its scale */
        if ((bits >> (INVCAL_DELTA_X + i) | bits >> (INVCAL_DK_X + i)) & 1) {
            append(text, size, joint);
            append(text, size, along[i]);
            joint = ", ";
        }
    }
    joint = *text ? ", and midway between " : "the field midway between ";
    for (unsigned i = 0; i < 3; i++) {
        if (bits >> (INVCAL_GAMMA_XY + i) & 1) {
            append(text, size, joint);
            append(text, size, between[i]);
            joint = ", ";
        }
    }
    append(text, size, *text ? "" : "the field in other directions");
    return text;
}
