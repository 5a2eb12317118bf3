/* SPDX-License-Identifier: MIT
 *
 * invcal/magnetometer.h: a magnetometer calibrates itself while it is moved.
 *
 * Nobody holds a compass still in twelve orientations: it is waved for a minute. Its samples lie on the same
 * ellipsoid as positions do (invcal.h), but neighbours err alike, and most are where the hand likes to be.
 * So they are spread evenly: 18 cells of equal size around the faces and edges of a cube hold the mean of
 * their rows each (mathematics.md, "A magnetometer in motion"), and the cells are positions.
 *
 *     invcal_magnetometer_init(&magnetometer, &nominal);
 *     for every sample:
 *         if (invcal_magnetometer_feed(&magnetometer, raw) == INVCAL_TAKEN)     one more cell is covered:
 *             invcal_magnetometer_next(&magnetometer, along)                    turn through the white part
 *     invcal_magnetometer_solve(&magnetometer, &calibration, &quality, &found)
 *
 * Turn it slowly, within a minute or so, so that each side of the case has pointed along the field: away from
 * iron, and from what carries a current. What disturbs it all the same is left out or named.
 *
 * The length of the field need not be known: calibrated readings have length 1. invcal_scale with the
 * field in uT, where a map tells it, makes uT of them; with found.field it keeps the scale of
 * nominal, and only offset and shape are calibrated.
 *
 * Beside an accelerometer invcal_dip finds how the axes of both are turned against each other.
 *
 * invcal_save of store.h keeps the result. The state has no pointers: its bytes, kept by invcal_store_save and
 * put back after a reset, go on where they were; but only under the same firmware.
 *
 * invcal.h states the rules and units.
 */
#ifndef INVCAL_MAGNETOMETER_H
#define INVCAL_MAGNETOMETER_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_CELLS 18u /* of direction: 6 faces and 12 edges of a cube, 0.7 sr each */

/* What was not as it should be. Of two the larger is named. */
typedef enum {
    INVCAL_UNDISTURBED, /* nothing was found */
    INVCAL_PASSING, /* samples contradict the others, and are left out: a magnet or iron passed by */
    INVCAL_PLACES,  /* the field differs from place to place: turn it where it is, away from iron */
    INVCAL_STEP     /* readings were different before and after: something magnetic has moved on
                           the device or near it. Begin anew */
} invcal_disturbance;

/* A sentence for it, without a full stop; "" for INVCAL_UNDISTURBED; any other value gives "unknown
 * disturbance". */
const char *invcal_disturbance_text(invcal_disturbance disturbance);

/* Internal: sums of rows. */
typedef struct {
    invcal_real sum[INVCAL_CELLS][INVCAL_PARAMETERS]; /* over the samples of each cell */
    uint16_t count[INVCAL_CELLS];                     /* how many they stand for */
} invcal_cells;

/* A magnetometer being moved: 1,500 bytes (float). */
typedef struct {
    invcal_calibration work; /* readings of about length 1 around 0, in which the cells lie */
    invcal_real unit;        /* length 1 of these, in the unit of nominal */
    invcal_real p[INVCAL_PARAMETERS]; /* the solution so far; before it, the box of the readings */
    invcal_real squares;  /* sum of what samples differ from it by, squared, over field */
    invcal_real products; /* sum over blocks of |sum eta r|^2, r being that difference */
    invcal_real before;   /* what the last came to, over samples, at the last look */
    invcal_real block[3]; /* sum eta r of the block that is being filled */
    uint32_t blocked;     /* samples in squares, but for those in the block */
    uint32_t samples;     /* taken in; above 16 million fewer */
    uint32_t due;         /* of them, when they are looked at next */
    uint32_t left_out;    /* for contradicting the solution so far */
    uint16_t in_block;    /* samples */
    uint8_t stage;        /* of the solution, see magnetometer.c */
    uint8_t has_step;     /* one was seen */
    invcal_cells early;   /* of the samples up to the last look at them */
    invcal_cells late;    /* and since: what they differ by is a step */
} invcal_magnetometer;

/* What is known beside invcal_quality. */
typedef struct {
    invcal_real field; /* its length, in the unit of nominal */
    invcal_real rms;   /* of what samples differ from the solution by, over field; 0: not known */
    invcal_real alike; /* how many samples in a row err as one; 0: not known */
    uint32_t samples;  /* taken in */
    uint32_t left_out; /* and not, for contradicting them */
    uint8_t covered;   /* cells with samples, of INVCAL_CELLS */
    uint8_t
        gap; /* degrees from the worst cell without one to the nearest with one: 0, 45, 60, 90 */
    uint8_t disturbance; /* an invcal_disturbance */
} invcal_magnetometer_found;

/* Begins.
 *
 * nominal  data sheet (invcal_nominal): raw counts to any one unit, such as uT; its zero does not
 *          matter, so 0 and 1 do for a magnetometer of which nothing is known.
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOMINAL. */
invcal_status invcal_magnetometer_init(invcal_magnetometer *magnetometer,
                                       const invcal_calibration *nominal);

/* Feeds one sample, raw counts.
 *
 * Now and then it looks at what has come, and from the first solution on leaves out what contradicts
 * it; what came before that solution is dropped as soon as later samples cover all sides as well.
 *
 * Returns INVCAL_NOTHING; INVCAL_TAKEN if it is the first in its cell; INVCAL_REFUSED if it is left out,
 * or no number.
 *
 * Cost: 220 instructions; a look up to 75,000: with its ten looks 250 on average over 12,000 samples.
 * Stack: about 1,200 bytes. */
invcal_event invcal_magnetometer_feed(invcal_magnetometer *magnetometer, const invcal_real raw[3]);

/* Where to turn next: the cell that is farthest from all with samples; where all have some, the one
 * with fewest.
 *
 * along  out: the direction of the case that is to point along the field: a unit vector. The field
 *        points north, and down by the dip, 60 degrees and more in most of Europe and North
 *        America: let the opposite side point up there (invcal_words), and swing it around.
 *
 * Cost: 13,000 instructions. Stack: about 100 bytes. */
void invcal_magnetometer_next(const invcal_magnetometer *magnetometer, invcal_real along[3]);

/* Solves what has come so far. More may follow.
 *
 * out      the calibration, over field; symmetric against nominal.
 * quality  its positions are the cells. sigma counts samples that err alike once, or is what the
 *          cells scatter by if that is clearly more. No redundancy: nothing is
 *          known yet of how samples err alike. It is weak also where the gap is 60 degrees or more, in what
 *          lies along it, and
 *          rough where a step or PLACES is named, or more than an eighth was left out.
 * found    out; may be null.
 *
 * Returns INVCAL_OK; else nothing is written:
 *   INVCAL_TOO_FEW        fewer than nine cells have samples;
 *   INVCAL_UNDETERMINED   they leave parameters open;
 *   INVCAL_NOT_ELLIPSOID  as for invcal_calibrate;
 *   INVCAL_BAD_NOMINAL    what came out cannot be a calibration.
 * Cost: 50,000 instructions. Stack: about 1,200 bytes. */
invcal_status invcal_magnetometer_solve(const invcal_magnetometer *magnetometer,
                                        invcal_calibration *out, invcal_quality *quality,
                                        invcal_magnetometer_found *found);

/* A cell as a position, to look at: along the mean of its samples, and as long as they are by root mean
 * square once calibrated.
 *
 * calibration  that of invcal_magnetometer_solve; not scaled.
 * k            0 ... INVCAL_CELLS - 1.
 * raw          out: raw counts.
 *
 * Returns how many samples are in it; 0: none, raw is as it was. Cost: 500 instructions. */
unsigned invcal_magnetometer_cell(const invcal_magnetometer *magnetometer,
                                  const invcal_calibration *calibration, unsigned k,
                                  invcal_real raw[3]);

/* ---- its axes and those of an accelerometer ------------------------------------------------------
 *
 * Lengths leave open how the calibrated axes of each sit on the board. But up and the field have the same
 * angle between them wherever the device turns, 90 degrees and the dip: with a calibrated acceleration a and a
 * calibrated field m, both of length 1, at the same instants
 *
 *     a R m = s    the same for all,    (R, s) minimise  sum (a R m - s)^2
 *
 * R turns m to the axes of a. It is what a compass that is corrected for tilt depends on: a degree of it is
 * a degree of heading and more.
 *
 *     invcal_dip_init(&dip);
 *     ... for each instant: invcal_dip_add(&dip, a, m);           calibrated, of any length
 *     if (invcal_dip_solve(&dip, found.alike, r, &quality) == INVCAL_OK) {
 *         invcal_frame_turn(r, &calibration);                     frame.h; that of the magnetometer
 *     }
 *
 * The hand must turn slowly: what it accelerates is no gravity. */

#define INVCAL_DIP_ROW 10u /* the nine products of a and m, and 1 */

/* The sums of all instants: 224 bytes. */
typedef struct {
    /* The triangle of the row times itself over all instants. */
    invcal_real sum[INVCAL_DIP_ROW * (INVCAL_DIP_ROW + 1u) / 2u];
    unsigned count; /* instants; at most UINT_MAX */
} invcal_dip;

/* What they tell. */
typedef struct {
    invcal_real sigma[3]; /* of the three angles about the axes of a, rad */
    invcal_real sine;     /* s: of how far the field points up; north of the equator negative */
    invcal_real scatter;  /* of a R m about it, root mean square */
    invcal_real
        heading; /* what sigma leaves of the error of a heading, rad, over all orientations */
} invcal_dip_quality;

/* Empties the sums. All bytes zero is the same state. */
void invcal_dip_init(invcal_dip *dip);

/* Adds an instant.
 *
 * up, field  calibrated, in the axes of each sensor; of any length above 0.
 *
 * Returns INVCAL_OK; else the sums are as they were: INVCAL_NOT_FINITE; INVCAL_OUT_OF_RANGE for a length of
 * 0, or one that cannot be squared. Cost: 350 instructions. Stack: about 80 bytes. */
invcal_status invcal_dip_add(invcal_dip *dip, const invcal_real up[3], const invcal_real field[3]);

/* Solves them. A rotation by more than 90 degrees may be refused: axes that are turned by half against each other have
 * to be put right before.
 *
 * alike     how many instants in a row err as one (invcal_magnetometer_found), at least 1: sigma is
 *           by so many fewer.
 * rotation  out: R.
 * quality   out; may be null.
 *
 * Returns INVCAL_OK; else nothing is written:
 *   INVCAL_TOO_FEW        fewer than 5 instants;
 *   INVCAL_UNDETERMINED   they leave an angle open: all about one axis, or the field is vertical; or they
 *                         tell no angle, as what is not of one instant does.
 * Cost: 35,000 instructions. Stack: about 500 bytes. */
invcal_status invcal_dip_solve(const invcal_dip *dip, invcal_real alike, invcal_real rotation[3][3],
                               invcal_dip_quality *quality);

#ifdef __cplusplus
}
#endif

#endif
