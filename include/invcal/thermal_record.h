/* SPDX-License-Identifier: MIT
 *
 * invcal/thermal_record.h: a calibration for every temperature with all that is known about it as
 * 296, 332 or 368 bytes (degree 0, 1, 2), the same on every machine: for a memory (store.h), a
 * file or a radio.
 *
 * The bytes; numbers as in record.h.
 *
 *     at    size  what
 *       0   1     kind, 0xCB
 *       1   1     version, 1
 *       2   2     length, 260 + 36 (degree + 1)
 *       4   184   what holds at the reference, as record.h stores it
 *     188   1     degree
 *     189   1     fitted
 *     190   1     fallback
 *     191   1     frame
 *     192   16    reference, span, least, greatest
 *     208   48    nominal: offset x, y, z, matrix by rows
 *     256   36    the coefficients x of t^0; so for each further power up to the degree
 *     ...   4     CRC-32, as in record.h, of all before it
 *
 * A device that does not know its temperature finds the 184 bytes of record.h at byte 4.
 */
#ifndef INVCAL_THERMAL_RECORD_H
#define INVCAL_THERMAL_RECORD_H

#include "invcal/record.h"
#include "invcal/thermal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a record of that degree takes. */
#define INVCAL_THERMAL_RECORD_BYTES(degree) (260u + 36u * ((degree) + 1u))

/* The largest that this build writes and reads. */
#define INVCAL_THERMAL_RECORD_SIZE INVCAL_THERMAL_RECORD_BYTES(INVCAL_THERMAL_DEGREE)

/* What is stored. */
typedef struct {
    invcal_thermal_calibration thermal; /* the calibration */
    /* What else is known, as invcal_thermal_calibrate judged it at the reference. When encoded,
     * its calibration, delta, dk, gamma and field are those of `thermal`, whatever stands here. */
    invcal_record record;
} invcal_thermal_record;

/* A record as bytes.
 *
 * length  how many of the bytes it takes: those of its own degree.
 *
 * Returns INVCAL_OK; on failure bytes and length are untouched:
 *   INVCAL_NOT_FINITE     a number is NaN, infinite, or beyond the largest float;
 *   INVCAL_BAD_SETTING    what invcal_thermal_calibrate never gives: a span that is not positive,
 *                         a range upside down, a degree beyond INVCAL_THERMAL_DEGREE; or
 *                         invcal_record_encode says so;
 *   INVCAL_NOT_ELLIPSOID  there is no calibration at the reference.
 * Stack: about 1,300 bytes. */
invcal_status invcal_thermal_record_encode(const invcal_thermal_record *record,
                                           uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE],
                                           uint32_t *length);

/* A record from bytes, at any alignment.
 *
 * size  how many bytes there are; what follows the record is not looked at.
 *
 * Returns INVCAL_OK: the record is one that invcal_thermal_record_encode accepts. Else out is
 * untouched:
 *   INVCAL_DAMAGED        as invcal_record_decode;
 *   INVCAL_OTHER_VERSION  sound, but not of this kind and version, or of a degree beyond
 *                         INVCAL_THERMAL_DEGREE.
 * Stack: about 1,300 bytes. */
invcal_status invcal_thermal_record_decode(const uint8_t *bytes, uint32_t size,
                                           invcal_thermal_record *out);

#ifdef __cplusplus
}
#endif

#endif
