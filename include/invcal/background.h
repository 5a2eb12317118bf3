/* SPDX-License-Identifier: MIT
 *
 * invcal/background.h: a device that is never calibrated on purpose: feed it samples for days.
 *
 * A rest in a well covered direction is refused (INVCAL_REFUSED, INVCAL_REST_SAME); the table keeps
 * the most informative positions, up to INVCAL_MAX_POSITIONS - 1. If it is full, the least
 * informative one is dropped, the one just taken included, and of two alike the older; after 88
 * days each is dropped. Set up, read and solve the session inside with the functions of invcal.h,
 * and keep it with those of store.h: all positions that were loaded count as new.
 *
 * invcal.h states the rules and units.
 */
#ifndef INVCAL_BACKGROUND_H
#define INVCAL_BACKGROUND_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The positions and the detector, and how old they are. */
typedef struct {
    invcal_session session;            /* to be used by invcal.h, but fed from here */
    uint8_t age[INVCAL_MAX_POSITIONS]; /* days */
} invcal_background;

/* Begins: as invcal_session_init_nominal.
 *
 * size  sizeof *background. */
INVCAL_NODISCARD invcal_status invcal_background_init(invcal_background *background, size_t size,
                                                      const invcal_calibration *nominal,
                                                      invcal_real rate);

/* Feeds one sample: as invcal_session_feed, but refuses a position that adds little. At the end of
 * a rest it compares the positions kept. Cost: of that, 26,000 instructions. */
invcal_event invcal_background_feed(invcal_background *background, int32_t x, int32_t y, int32_t z);

/* Call it once a day: positions become a day older. */
void invcal_background_age(invcal_background *background);

/* Is `found` the better of two calibrations?
 *
 * Returns 1 if its verdict is no worse, and the sum of the squares of its nine 95 % intervals,
 * invcal_coverage of sigma_dof times sigma, is smaller, so that a sigma that happens to be small
 * does not decide. 0 otherwise, also if they are equal. Stack: about 40 bytes. */
int invcal_improves(const invcal_quality *found, const invcal_quality *present);

#ifdef __cplusplus
}
#endif

#endif
