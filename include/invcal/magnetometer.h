/* SPDX-License-Identifier: MIT
 *
 * invcal/magnetometer.h: a magnetometer calibrates itself while it is moved.
 *
 * A compass is not held still in twelve orientations, but waved for a minute. Its samples lie on
 * the same ellipsoid as positions (invcal.h), but neighbours have a common error, and the hand
 * prefers some directions. So they are sorted into 18 cells of direction, and the means of the
 * cells are the positions (mathematics_magnetometer.md).
 *
 *     invcal_magnetometer_init(&magnetometer, NULL)
 *     for every sample:
 *         if (invcal_magnetometer_feed(&magnetometer, x, y, z) == INVCAL_TAKEN) another cell
 *             invcal_magnetometer_next(&magnetometer, along)                   show where to turn
 *     invcal_magnetometer_solve(&magnetometer, &calibration, &quality, &found)
 *
 * Turn it slowly, for a minute or so, until each side of the case has pointed along the field, away
 * from iron and electric currents. Disturbed samples are dropped, or the disturbance is reported.
 *
 * The length of the field need not be known: calibrated readings have length 1. invcal_scale with
 * the field of a map, in uT, converts them; with found.field it keeps the scale of nominal.
 * With an accelerometer, invcal_dip finds the rotation between the axes of both.
 *
 * invcal_save of store.h keeps the result, invcal_store_save the bytes of the structure, to go on
 * after a reset of the same firmware. invcal.h states the rules and units.
 */
#ifndef INVCAL_MAGNETOMETER_H
#define INVCAL_MAGNETOMETER_H

#include "invcal/frame.h"
#include "invcal/private.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_CELLS 18u /* of direction: 6 faces and 12 edges of a cube, 0.7 sr each */

/* A disturbance. Of two the larger value is reported. */
typedef uint8_t invcal_disturbance;
enum {
    INVCAL_UNDISTURBED, /* none was found */
    INVCAL_PASSING,     /* samples contradict the others, and are dropped: a magnet passed by */
    INVCAL_PLACES, /* the field differs from place to place: turn it where it is, away from iron */
    INVCAL_STEP    /* readings changed, or over a quarter were dropped: something magnetic moved on
                       the device or near it. It stays reported: begin again */
};

/* A sentence for it, without a full stop; "" for INVCAL_UNDISTURBED; "unknown disturbance" for
 * other values. */
const char *invcal_disturbance_text(invcal_disturbance disturbance);

/* A magnetometer in motion: 1,500 bytes (float). */
typedef struct {
    invcal_calibration own_work;     /* private: to readings of about length 1 around 0 */
    invcal_private_magnetometer own; /* private */
} invcal_magnetometer;

/* Further results, besides invcal_quality. */
typedef struct {
    invcal_real field; /* in the unit of nominal */
    invcal_real rms;   /* of samples against the solution before them, over field; 0: unknown */
    invcal_real alike; /* number of successive samples with a common error; 0: unknown */
    uint32_t samples;  /* accepted since the first; above 16 million fewer, as dropped is then */
    uint32_t dropped;  /* samples that contradicted them */
    uint8_t covered;   /* cells with samples, of INVCAL_CELLS */
    uint8_t gap_deg;   /* from the worst empty cell to the nearest with samples: 0, 45, 60, 90 */
    invcal_disturbance disturbance; /* the largest */
} invcal_magnetometer_found;

/* Begins.
 *
 * nominal  data sheet (invcal_nominal): raw counts to any unit, such as uT; its zero does not
 *          matter. Null: as read.
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOMINAL: every sample is refused then. */
INVCAL_NODISCARD invcal_status invcal_magnetometer_init(invcal_magnetometer *magnetometer,
                                                        const invcal_calibration *nominal);

/* Feeds one sample, raw counts.
 *
 * From time to time it looks at all samples. After the first solution it drops samples that
 * contradict it, and those before it, unless they agree with later samples once these cover all
 * sides. If a wild sample prevents a solution, it begins again.
 *
 * Returns INVCAL_NOTHING; INVCAL_TAKEN if it is the first in its cell, more than 18 times if cells
 * move with the solution; INVCAL_REFUSED if it is dropped, or not a number.
 * Cost: 300 instructions; at a look up to 100,000 instructions; 350 instructions on average over
 * 12,000 samples, with ten looks. Stack: about 1,200 bytes. */
invcal_event invcal_magnetometer_feed(invcal_magnetometer *magnetometer, invcal_real x,
                                      invcal_real y, invcal_real z);

/* Where to turn next: the cell farthest from all with samples; if all have some, the one with the
 * fewest.
 *
 * along  out: unit vector, the direction of the case to point along the field, which points north,
 *        and down by the dip, 60 degrees or more in most of Europe and North America: there, let
 *        the opposite side point up (invcal_direction_text), and swing it.
 * Cost: up to 19,000 instructions. Stack: about 120 bytes. */
void invcal_magnetometer_next(const invcal_magnetometer *magnetometer, invcal_real along[3]);

/* Solves the samples so far. More may follow.
 *
 * out      the calibration, over field; symmetric against nominal.
 * quality  its positions are the cells. sigma counts samples with a common error once, or is that
 *          of the scatter of the cells if clearly larger. Verdicts: no redundancy while alike is
 *          not known; weak also for the parameters along a gap of 60 degrees or more; rough if STEP
 *          or PLACES is reported, or more than an eighth was dropped.
 * found    out; may be null.
 *
 * Returns INVCAL_OK; INVCAL_NOT_BEGUN;
 *   INVCAL_TOO_FEW        fewer than nine cells have samples;
 *   INVCAL_UNDETERMINED   they leave parameters undetermined;
 *   INVCAL_NOT_ELLIPSOID, INVCAL_OUT_OF_RANGE   as for invcal_calibrate;
 *   INVCAL_BAD_NOMINAL    the result cannot be a calibration.
 * Cost: 76,000 instructions. Stack: about 1,200 bytes. */
INVCAL_NODISCARD invcal_status invcal_magnetometer_solve(const invcal_magnetometer *magnetometer,
                                                         invcal_calibration *out,
                                                         invcal_quality *quality,
                                                         invcal_magnetometer_found *found);

/* ---- its axes and those of an accelerometer -----------------------------------------------------
 *
 * Lengths do not show how the calibrated axes of each are mounted. But the angle between up and the
 * field is the same in all orientations, 90 degrees plus the dip: with a calibrated acceleration a
 * and a calibrated field m, both of length 1, at the same instants
 *
 *     a R m = s    the same for all,    (R, s) minimise  sum (a R m - s)^2
 *
 * R turns m into the axes of a. An error of a degree in it makes one of a degree or more in a
 * tilt-compensated heading.
 *
 *     invcal_dip_init(&dip);
 *     ... for each instant: invcal_dip_add(&dip, a, m);           calibrated, of any length
 *     if (invcal_dip_solve(&dip, found.alike, &rotation, &quality) == INVCAL_OK)
 *         invcal_rotate(&calibration, &rotation);                 the magnetometer's
 *
 * Turn slowly: the hand's acceleration is not gravity. */

/* The sums over all instants: 224 bytes. */
typedef struct {
    invcal_real own_sum[INVCAL_PRIVATE_DIP * (INVCAL_PRIVATE_DIP + 1u) / 2u]; /* private */
    unsigned count; /* instants; at most UINT_MAX */
} invcal_dip;

/* The quality of the rotation. */
typedef struct {
    invcal_real sigma[3]; /* of the three angles about the axes of a, rad */
    invcal_real sine;     /* s: of the field's angle above the horizon; negative in the north */
    invcal_real scatter;  /* of a R m about s, root mean square */
    invcal_real heading;  /* error of a heading that sigma causes, rad, over all orientations */
} invcal_dip_quality;

/* Clears the sums. All bytes zero is the same state. */
void invcal_dip_init(invcal_dip *dip);

/* Adds an instant.
 *
 * up, field  calibrated, in the axes of each sensor; of any length above 0.
 *
 * Returns INVCAL_OK; else the sums are unchanged: INVCAL_NOT_FINITE; INVCAL_OUT_OF_RANGE if the
 * product of the lengths is 0 or beyond the number type. Cost: 460 instructions. Stack: about 80
 * bytes. */
invcal_status invcal_dip_add(invcal_dip *dip, const invcal_real up[3], const invcal_real field[3]);

/* Solves for R. A rotation by more than 90 degrees may be refused: exchange axes first.
 *
 * alike    as in invcal_magnetometer_found: sigma counts so many instants once. Less than 1, or a
 *          NaN, counts as 1.
 * quality  out; may be null.
 *
 * Returns INVCAL_OK;
 *   INVCAL_TOO_FEW        fewer than 5 instants;
 *   INVCAL_UNDETERMINED   an angle is open: all turns were about one axis, or the field is
 *                         vertical; or none fits, as if a and m are not of the same instants.
 * Cost: 31,000 instructions. Stack: about 560 bytes. */
INVCAL_NODISCARD invcal_status invcal_dip_solve(const invcal_dip *dip, invcal_real alike,
                                                invcal_rotation *out, invcal_dip_quality *quality);

#ifdef __cplusplus
}
#endif

#endif
