/* SPDX-License-Identifier: MIT */
#include "invcal/invcal.h"
#include "vector.h"

#define NAMED INVCAL_REAL(0.1)    /* a component below is none: 6 degrees */
#define LARGER INVCAL_REAL(1e-3)  /* of components that differ by less, the first counts */
#define COARSE INVCAL_REAL(640.0) /* unit of the table: 1/640 */

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

/* The angle whose cosine this is, to 5 degrees; 5 at least. */
static unsigned tilt(invcal_real cosine)
{
    /* 1 - cosine of 7.5, 12.5 ... 52.5 degrees */
    static const uint8_t border[] = {5, 15, 30, 49, 72, 100, 132, 168, 208, 250};
    unsigned n = 0;

    /* at most 10 steps */
    while (n < sizeof border && COARSE * (1 - cosine) > border[n]) {
        n++;
    }
    return 5 * (n + 1);
}

static char *put_degrees(char *at, unsigned degrees)
{
    if (degrees >= 10) {
        *at++ = (char)('0' + degrees / 10);
    }
    *at++ = (char)('0' + degrees % 10);
    return at;
}

const char *invcal_words(const invcal_real up[3], char words[INVCAL_WORDS])
{
    /* 0, 1 and 2 stand for the axes, the largest component first; # for the tilt */
    static const char upright[] = "0 up";
    static const char tilted[] = "0 up, tilt # deg, 1 rises";
    static const char tilted_twice[] = "0 up, tilt # deg, 1 and 2 rise";
    unsigned axis[3];
    char *at = words;

    INVCAL_ASSERT(up && words);
    rank(up, axis);
    const char *text = INVCAL_FABS(up[axis[1]]) > NAMED ? tilted : upright;
    text = INVCAL_FABS(up[axis[2]]) > NAMED ? tilted_twice : text;
    for (; *text != '\0'; text++) { /* at most 31 steps: the length of the texts above */
        const unsigned n = (unsigned)(*text - '0');
        if (n < 3) {
            const unsigned which = axis[n];
            *at++ = up[which] < 0 ? '-' : '+';
            *at++ = (char)('x' + which);
        } else if (*text == '#') {
            at = put_degrees(at, tilt(INVCAL_FABS(up[axis[0]])));
        } else {
            *at++ = *text;
        }
    }
    *at = '\0';
    return words;
}
