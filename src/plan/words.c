/* SPDX-License-Identifier: MIT
 *
 * A direction in words, computed in integers: no printf, no acos. The axis closest to up is named
 * first; each other one that is more than 6 degrees above or below the horizon is named as rising,
 * with its sign.
 */
#include "invcal/plan.h"
#include "../core/vector.h"

/* Components are counted in parts, 640, so that the last border of tilt, 250, still fits a byte. */
#define WHOLE 640    /* of the unit vector */
enum { NAMED = 64 }; /* an axis up to this is not named: 6 degrees */
enum { TEXTS = 7 };

/* The tilt in units of 5 degrees, at least 1, whose cosine is `less` parts below 1. */
static INVCAL_ONCE unsigned tilt(unsigned less)
{
    /* of 7.5, 12.5 ... 52.5 degrees */
    static const uint8_t border[] = {5, 15, 30, 49, 72, 100, 132, 168, 208, 250};
    unsigned n = 1;

    INVCAL_ROLL
    for (unsigned i = 0; i < sizeof border; i++) {
        n += less > border[i];
    }
    return n;
}

/* Writes text number n: before the first, second, third axis; after the third, second, first. # is
 * the tilt, as a multiple of 5 degrees. Returns its end, a 0. */
INVCAL_NOINLINE static char *put(char *at, unsigned n, unsigned fives)
{
    static const char texts[] = "\0 up, tilt # deg, \0 and \0 rise\0 rises\0 up\0";
    const char *text = texts;

    for (; n > 0; n--) {          /* at most TEXTS - 1 times */
        while (*text++ != '\0') { /* at most 42 steps: the length of all */
        }
    }
    while ((*at = *text++) != '\0') { /* at most 17 steps: that of the longest */
        if (*at == '#') {
            if (fives > 1) {
                *at++ = (char)('0' + fives / 2);
            }
            *at = fives % 2 == 0 ? '0' : '5';
        }
        at++;
    }
    return at;
}

const char *invcal_direction_text(const invcal_real up[3], char text[INVCAL_TEXT_SIZE])
{
    unsigned size[3];
    unsigned largest = 0;
    unsigned axis = 0;
    unsigned named = 0;
    char *at = text;

    INVCAL_ASSERT(up && text);
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        const invcal_real x = INVCAL_FABS(up[i]);
        unsigned parts = WHOLE;
        if (x < 1) {
            //@ assert \is_finite(x); // no NaN is less than 1
            parts = (unsigned)(int)(x * WHOLE); /* as signed: less code in software */
        }
        size[i] = parts;
        const unsigned rank = parts + (i ^ 1u); /* of equals z comes first, then x */
        if (rank > largest) {
            largest = rank;
            axis = i;
        }
    }
    const unsigned fives = tilt(WHOLE - size[axis]);
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) { /* the largest first, then in the order x, y, z, x */
        if (size[axis] > NAMED) {
            at = put(at, named, fives);
            *at++ = up[axis] < 0 ? '-' : '+';
            *at++ = (char)('x' + axis);
            named++;
        }
        axis = axis == 2 ? 0 : axis + 1;
    }
    (void)put(at, TEXTS - 1 - named, fives);
    return text;
}
