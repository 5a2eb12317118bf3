/* SPDX-License-Identifier: MIT
 *
 * invcal/guidance.h: which orientation to take next.
 *
 * Of 26 directions - the 6 faces, 12 edges and 8 corners of a cube - the one with the largest
 * h K h' is asked for, K = (H'H)^-1 of the positions so far: it multiplies det H'H by the most,
 * 1 + h K h', and so makes all nine parameters together the most certain (mathematics.md,
 * "Guidance"). A small ridge on H'H makes that work from the first position on. Nine positions
 * that follow determine everything, sqrt(K(r,r)) at most 3.01; eighteen come within 0.3 of the
 * largest log det H'H there can be. Positions need not be hit: what was really read is in the
 * sums, and the next direction makes up for it. Hand errors of 10 degrees cost little.
 */
#ifndef INVCAL_GUIDANCE_H
#define INVCAL_GUIDANCE_H

#include <stdint.h>

#include "invcal/cholesky.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The orientation to take next, and what it will do. */
typedef struct {
    invcal_real up[3]; /* the direction that is to point upwards, in the frame of the case: unit */
    invcal_real gain;  /* h K h' of it */
    invcal_real before[INVCAL_PARAMETERS]; /* sqrt(K(r,r)), sigma of parameter r over that of a
                                              position mean, so far. Far above 10: open as yet; the
                                              ridge ends it at 100 over the root of the largest
                                              diagonal element of H'H */
    invcal_real after[INVCAL_PARAMETERS];  /* the same with this position */
    uint16_t improves; /* bit r: sigma of parameter r falls by a tenth or more; at least the one
                          that falls most */
} invcal_guidance;

/* The direction to take next.
 *
 * normal   the equations so far, of either kind; empty at the beginning. Not changed.
 * current  the latest reading, over field, or null. Directions whose h K h' is within 1 % of the
 *          largest count as equal: of these the nearest is asked for, but none within 26 degrees,
 *          which would be the same position again, if there is another. Without it, or if it is
 *          not finite or zero: the first, in the order faces, edges, corners, and +z before -z.
 * next     the direction, and what it will do.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING if sums are not finite, or no sums of squares.
 * Cost: 52 forward solutions and 2 factorisations, about 3000 multiply-adds.
 * Stack: about 420 bytes (float, Cortex-M4F, -Os). */
invcal_status invcal_guidance_next(const invcal_normal *normal, const invcal_real *current,
                                   invcal_guidance *next);

/* The same for a direction of one's own, such as the next position of a program.
 *
 * up  unit vector within 1e-4.
 *
 * Returns INVCAL_OK; INVCAL_NOT_FINITE, INVCAL_OUT_OF_RANGE or INVCAL_NOT_UNIT for what is none;
 * INVCAL_BAD_SETTING as above. Stack: as above. */
invcal_status invcal_guidance_of(const invcal_normal *normal, const invcal_real up[3],
                                 invcal_guidance *next);

#define INVCAL_GUIDANCE_WORDS 40u /* bytes, with the terminating zero */

/* A direction in words: "+z up"; "+z up, tilt 45 deg, +x rises"; "-z up, tilt 55 deg, +x and -y
 * rise": from an axis pointing up, tilt the case by so much (to 5 degrees) that the sides named
 * come up. Plain ASCII, terminated by zero; all of words beyond is left alone.
 *
 * up  unit vector, next->up. */
void invcal_guidance_words(const invcal_real up[3], char words[INVCAL_GUIDANCE_WORDS]);

#ifdef __cplusplus
}
#endif

#endif
