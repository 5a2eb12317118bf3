/* SPDX-License-Identifier: MIT
 *
 * invcal/status.h: what a function returns. Every header includes it.
 */
#ifndef INVCAL_STATUS_H
#define INVCAL_STATUS_H

#include "invcal/double.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a function returns. Values never change; new ones are added at the end of a group. */
typedef enum {
    INVCAL_OK = 0, /* done */

    /* the data */
    INVCAL_NOT_FINITE = 0x10, /* a reading is NaN or infinite */
    INVCAL_TOO_FEW,           /* too few positions, or too few of something else */
    INVCAL_UNDETERMINED,      /* the positions leave some parameters open: invcal_undetermined */
    INVCAL_NOT_ELLIPSOID,     /* the readings do not lie on an ellipsoid that a triad can produce */
    INVCAL_MOUNTING, /* axes, signs or unit of gyroscope and accelerometer do not match: gyro.h */

    /* why a session refuses a sample: a static interval that is no position, or its own beginning */
    INVCAL_OUT_OF_RANGE =
        0x20,            /* a reading is shorter than 0.1 or longer than 10 times the field */
    INVCAL_REST_SHORT,   /* motion came before it was READY */
    INVCAL_REST_DRIFT,   /* readings creep: a slow turn, or settling */
    INVCAL_REST_CLIPPED, /* a reading reached the end of the sensor's range */
    INVCAL_REST_FROZEN,  /* the readings do not change, or no longer; or one axis stays
                                   constant while the others are noisy: it is not being read */
    INVCAL_REST_GAP,     /* short, since samples were lost */
    INVCAL_REST_SAME,    /* the orientation of the last position: nothing new */
    INVCAL_NOT_BEGUN,    /* the structure was not initialised */
    INVCAL_OTHER_BUILD,  /* program and library were built with other options: config.h */
    INVCAL_BAD_NOMINAL,  /* the nominal calibration: singular, not finite, absurdly scaled */
    INVCAL_BAD_RATE,     /* samples per second */

    /* a move between rests: gyro.h */
    INVCAL_MOVE_GAP = 0x30, /* samples were lost in it */
    INVCAL_MOVE_LONG,       /* it took more than 10 s */
    INVCAL_MOVE_APART,      /* it contradicts the others */

    /* an argument; the function's description gives its range */
    INVCAL_BAD_LIMITS = 0x40, /* the ends of the sensor's range */
    INVCAL_BAD_NOISE,         /* a standard deviation */
    INVCAL_BAD_PRIOR,         /* a prior's standard deviation */
    INVCAL_BAD_FIELD,         /* the length of the field */
    INVCAL_BAD_COUNT,         /* of positions, or of anything else */
    INVCAL_BAD_DIRECTION,     /* not a unit vector */
    INVCAL_BAD_ANGLE,         /* angles, or positions per group, of a stand's program */
    INVCAL_BAD_TEMPERATURE,   /* a temperature, its reference or its span */
    INVCAL_BAD_TIME,          /* averaging times, a time to hold */
    INVCAL_BAD_STORE,         /* slot size or granularity of a memory */

    /* stored bytes */
    INVCAL_NO_RECORD = 0x60, /* nothing is stored there */
    INVCAL_DAMAGED,          /* not what was written: too short, a wrong CRC, or nonsense */
    INVCAL_OTHER_VERSION,    /* of an unknown version of the library, or an unknown kind */
    INVCAL_OTHER_SETTINGS,   /* of a session with another nominal calibration or rate, or of
                                another build */
    INVCAL_NO_SPACE,         /* larger than the buffer, the slot, or the table of a session */
    INVCAL_IO,               /* the memory's driver reports a failure */

    INVCAL_STATUS_END = 0x70 /* above all; not a status */
} invcal_status;

/* A sentence for a status, without a full stop, in read-only memory. Any value outside the
 * enumeration gives "unknown status". */
const char *invcal_status_text(invcal_status status);

#ifdef __cplusplus
}
#endif

#endif
