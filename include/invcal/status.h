/* SPDX-License-Identifier: MIT
 *
 * invcal/status.h: what a function answers, and the names of the nine parameters.
 *
 * Rules that hold for the whole library and are not repeated at each function:
 *
 * - A function that returns anything but INVCAL_OK has left all its outputs untouched, unless
 *   its own description says otherwise.
 * - Every comparison fails closed: a NaN is never taken for a good value.
 * - All structures are plain data owned by the caller. They hold no pointers into themselves,
 *   may be copied with memcpy, and need no release.
 * - There are no globals: every function is reentrant, and safe in an interrupt or a thread as
 *   long as nobody else changes its arguments meanwhile.
 * - A null pointer is a programming error (INVCAL_ASSERT), not a status.
 */
#ifndef INVCAL_STATUS_H
#define INVCAL_STATUS_H

#include "invcal/config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a function answers. */
typedef enum {
    INVCAL_OK = 0,       /* it has done what it says */
    INVCAL_NOT_FINITE,   /* a reading is NaN or infinite */
    INVCAL_OUT_OF_RANGE, /* a reading is below 1/10 or above 10 of the field: wrong scale, field */
    INVCAL_NOT_UNIT,     /* a known direction is not a unit vector */
    INVCAL_BAD_SETTING,  /* field, noise, weight, prior, nominal calibration, plan, record or
                            store unusable */
    INVCAL_MIXED,        /* rows of the exact and of the linear kind in one set of equations */
    INVCAL_TOO_FEW,      /* fewer positions than parameters without a prior, or than 5 in a group */
    INVCAL_UNDETERMINED, /* the positions leave some parameters open: see invcal_undetermined */
    INVCAL_NOT_ELLIPSOID, /* the readings lie on no ellipsoid that a sensor triad can produce */
    INVCAL_NO_RECORD,     /* nothing is stored there */
    INVCAL_DAMAGED,       /* stored bytes are not what was written: too short, or a wrong CRC */
    INVCAL_OTHER_VERSION, /* stored by a version of the library, or of another kind, unknown here */
    INVCAL_NO_SPACE,      /* does not fit into the buffer or the slot */
    INVCAL_IO,            /* the memory's driver reports a failure */
    INVCAL_BAD_RATE,      /* not 8 to 8000 samples per second */
    INVCAL_BAD_RAILS,     /* the least count is not below the greatest */
    INVCAL_REST_SHORT,    /* motion came before the rest was READY */
    INVCAL_REST_DRIFT,    /* its readings creep: a slow turn, or it settles */
    INVCAL_REST_CLIPPED,  /* a reading was at the end of the sensor's range */
    INVCAL_REST_FROZEN,   /* nothing has ever changed, or noise ceased, or an axis stands still amid
                             the noise of the others: not read, or at a rail that was not stated */
    INVCAL_REST_GAP,      /* too short, for samples were lost */
    INVCAL_REST_SAME,     /* where the last position was taken: it tells nothing new */
    INVCAL_STATUS_COUNT   /* their number; no status */
} invcal_status;

/* A sentence for a status, in plain English without a full stop, in read-only memory.
 * Any value outside the enumeration gives "unknown status". */
const char *invcal_status_text(invcal_status status);

/* The nine parameters in the order of the paper's vector X and of every array of nine here. */
enum {
    INVCAL_DELTA_X = 0, /* zero offset over field (an accelerometer's: unit g) */
    INVCAL_DELTA_Y,     /* likewise */
    INVCAL_DELTA_Z,     /* likewise */
    INVCAL_DK_X,        /* scale error (1) */
    INVCAL_DK_Y,        /* likewise */
    INVCAL_DK_Z,        /* likewise */
    INVCAL_GAMMA_XY,    /* non-orthogonality (rad): sum of the two cross terms of the pair */
    INVCAL_GAMMA_XZ,    /* likewise */
    INVCAL_GAMMA_ZY,    /* likewise */
    INVCAL_PARAMETERS   /* their number */
};

/* The name of a parameter: "delta_x" ... "gamma_zy". Outside 0 ... 8: "?". */
const char *invcal_parameter_name(unsigned parameter);

#ifdef __cplusplus
}
#endif

#endif
