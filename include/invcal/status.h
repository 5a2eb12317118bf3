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
    INVCAL_OK = 0x00, /* done */

    /* the data */
    INVCAL_NOT_FINITE = 0x10,    /* a reading is NaN or infinite */
    INVCAL_TOO_FEW = 0x11,       /* too few positions, or too few of something else */
    INVCAL_UNDETERMINED = 0x12,  /* the positions leave some parameters open: invcal_undetermined */
    INVCAL_NOT_ELLIPSOID = 0x13, /* the readings lie on no ellipsoid that a triad can produce */
    INVCAL_MOUNTING = 0x14, /* axes, signs or unit of gyroscope and accelerometer differ: gyro.h */

    /* why a session refuses a sample: a static interval that is no position, or how it was begun */
    INVCAL_OUT_OF_RANGE = 0x20, /* a reading is shorter than 0.1 or longer than 10 fields */
    INVCAL_REST_SHORT = 0x21,   /* motion came before it was READY */
    INVCAL_REST_DRIFT = 0x22,   /* readings creep: a slow turn, or settling */
    INVCAL_REST_CLIPPED = 0x23, /* a reading reached the end of the sensor's range */
    INVCAL_REST_FROZEN = 0x24,  /* the readings do not change, or no longer; or one axis stays
                                   constant while the others are noisy: it is not being read */
    INVCAL_REST_GAP = 0x25,     /* short, since samples were lost */
    INVCAL_REST_SAME = 0x26,    /* the orientation of the last position: nothing new */
    INVCAL_NOT_BEGUN = 0x27,    /* the structure was not initialised */
    INVCAL_OTHER_BUILD = 0x28,  /* program and library were built with other options: config.h */
    INVCAL_BAD_NOMINAL = 0x29,  /* the nominal calibration: singular, not finite, absurdly scaled */
    INVCAL_BAD_RATE = 0x2A,     /* samples per second */

    /* a move between rests: gyro.h */
    INVCAL_MOVE_GAP = 0x30,   /* samples were lost in it */
    INVCAL_MOVE_LONG = 0x31,  /* it took more than 10 s */
    INVCAL_MOVE_APART = 0x32, /* it contradicts the others */

    /* an argument; the function's description gives its range */
    INVCAL_BAD_LIMITS = 0x40,      /* the ends of the sensor's range */
    INVCAL_BAD_NOISE = 0x41,       /* a standard deviation */
    INVCAL_BAD_PRIOR = 0x42,       /* a prior's standard deviation */
    INVCAL_BAD_FIELD = 0x43,       /* the length of the field */
    INVCAL_BAD_COUNT = 0x44,       /* of positions, or of anything else */
    INVCAL_BAD_DIRECTION = 0x45,   /* not a unit vector */
    INVCAL_BAD_ANGLE = 0x46,       /* of a turn, or of a stand's program */
    INVCAL_BAD_TEMPERATURE = 0x47, /* a temperature, its reference or its span */
    INVCAL_BAD_TIME = 0x48,        /* averaging times, a time to hold */
    INVCAL_BAD_STORE = 0x49,       /* slot size or granularity of a memory */

    /* stored bytes */
    INVCAL_NO_RECORD = 0x60,      /* nothing is stored there */
    INVCAL_DAMAGED = 0x61,        /* not what was written: too short, a wrong CRC, or nonsense */
    INVCAL_OTHER_VERSION = 0x62,  /* of an unknown version of the library, or an unknown kind */
    INVCAL_OTHER_SETTINGS = 0x63, /* of a session with another nominal calibration or rate, or of
                                another build */
    INVCAL_NO_SPACE = 0x64,       /* larger than the buffer, the slot, or the table of a session */
    INVCAL_IO = 0x65,             /* the memory's driver reports a failure */

    INVCAL_STATUS_END = 0x70 /* above all; not a status */
} invcal_status;

/* A sentence for a status, without a full stop, in read-only memory. Any value outside the
 * enumeration gives "unknown status". */
const char *invcal_status_text(invcal_status status);

#ifdef __cplusplus
}
#endif

#endif
