/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "invcal/invcal.h"
#include "vector.h"

#define NAMED INVCAL_REAL(0.1)    /* a component below is none: 6 degrees */
#define LARGER INVCAL_REAL(1e-3)  /* of components that differ by less, the first counts */
#define COARSE INVCAL_REAL(640.0) /* unit of the table: 1/640 */

static char *append_text(char *at, const char *text)
{
    while (*text != '\0') { /* at most 7 steps: the length of the texts below */
        *at++ = *text++;
    }
    return at;
}

static char *append_axis(char *at, const invcal_real up[3], unsigned axis)
{
    *at++ = up[axis] < 0 ? '-' : '+';
    *at++ = (char)('x' + axis);
    return at;
}

/* ", tilt 45 deg, ": the angle to the axis, to 5 degrees. */
static char *append_tilt(char *at, invcal_real cosine)
{
    /* 1 - cosine of 7.5, 12.5 ... 52.5 degrees */
    static const uint8_t border[] = {5, 15, 30, 49, 72, 100, 132, 168, 208, 250};
    unsigned n = 0;

    /* at most 10 steps */
    while (n < sizeof border && COARSE * (1 - cosine) > border[n]) {
        n++;
    }
    const unsigned degrees = 5 * (n + 1);
    at = append_text(at, ", tilt ");
    if (degrees >= 10) {
        *at++ = (char)('0' + degrees / 10);
    }
    *at++ = (char)('0' + degrees % 10);
    return append_text(at, " deg, ");
}

/* z, x and y, the largest component first; of equal ones in this order. */
static void rank(const invcal_real up[3], unsigned axis[3])
{
    axis[0] = 2;
    axis[1] = 0;
    axis[2] = 1;
    for (unsigned i = 0; i < 3; i++) { /* pairs 0 1, 1 2, 0 1: sorted */
        const unsigned k = i % 2;
        if (INVCAL_FABS(up[axis[k + 1]]) > INVCAL_FABS(up[axis[k]]) + LARGER) {
            const unsigned other = axis[k];
            axis[k] = axis[k + 1];
            axis[k + 1] = other;
        }
    }
}

const char *invcal_words(const invcal_real up[3], char words[INVCAL_WORDS])
{
    unsigned axis[3];

    INVCAL_ASSERT(up && words);
    rank(up, axis);
    char *at = append_text(append_axis(words, up, axis[0]), " up");
    if (INVCAL_FABS(up[axis[1]]) > NAMED) {
        const int both = INVCAL_FABS(up[axis[2]]) > NAMED;
        at = append_tilt(at, INVCAL_FABS(up[axis[0]]));
        at = append_axis(at, up, axis[1]);
        if (both) {
            at = append_axis(append_text(at, " and "), up, axis[2]);
        }
        at = append_text(at, both ? " rise" : " rises");
    }
    *at = '\0';
    return words;
}
