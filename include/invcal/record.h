/* SPDX-License-Identifier: MIT
 *
 * invcal/record.h: a calibration with all that is known about it as 184 bytes, the same on every
 * machine: for a memory (store.h), a file or a radio.
 *
 * The bytes. Integers with the least significant byte first; reals as IEEE-754 binary32 in the
 * same order, whatever invcal_real is: a double build keeps 24 bits of each, an error of 6e-8 of
 * the value (0.002 counts of an offset of 33000), and none of what a float build computes.
 *
 *     at    size  what                         at    size  what
 *       0   1     kind, 0xCA                    44   4     condition
 *       1   1     version, 1                    48   12    offset x, y, z
 *       2   2     length, 184                   60   36    matrix by rows
 *       4   8     sensor                        96   12    delta x, y, z
 *      12   4     date                         108   12    dk x, y, z
 *      16   2     positions                    120   12    gamma xy, xz, zy
 *      18   2     undetermined                 132   12    sigma_offset
 *      20   2     from_prior                   144   12    sigma_delta
 *      22   1     verdict                      156   12    sigma_dk
 *      23   1     temperature_known            168   12    sigma_gamma
 *      24   4     field                        180   4     CRC-32 (IEEE 802.3, as zlib) of
 *      28   4     field_sigma                              bytes 0 ... 179
 *      32   4     temperature
 *      36   4     noise
 *      40   4     residual_rms
 *
 * What later versions may change: everything but the first four bytes, and that the last four of
 * the length are the CRC of those before. So any version can tell a sound record of another one
 * from a damaged one. Any change of the rest, be it one more verdict, gets another version.
 */
#ifndef INVCAL_RECORD_H
#define INVCAL_RECORD_H

#include <stdint.h>

#include "invcal/calibration.h"
#include "invcal/quality.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_RECORD_SIZE 184u /* bytes of a record */

/* Names and units are those of invcal_solution and invcal_quality. What is not known stays 0. */
typedef struct {
    invcal_calibration calibration; /* of invcal_solution */
    invcal_real delta[3];           /* likewise */
    invcal_real dk[3];              /* likewise */
    invcal_real gamma[3];           /* likewise */
    invcal_real sigma_offset[3];    /* of invcal_quality */
    invcal_real sigma_delta[3];     /* likewise */
    invcal_real sigma_dk[3];        /* likewise */
    invcal_real sigma_gamma[3];     /* likewise */
    invcal_real field;              /* the field it was made in, field units, > 0 */
    invcal_real field_sigma;        /* standard deviation of that; 0: not known */
    invcal_real temperature;        /* at which it was made, degrees Celsius */
    uint8_t temperature_known;      /* 0: temperature is not */
    uint8_t sensor[8];              /* which one: a serial number or any other bytes of yours */
    uint32_t date;                  /* when: in what you count, such as seconds since your epoch */
    invcal_real noise;              /* of invcal_quality */
    invcal_real residual_rms;       /* likewise */
    invcal_real condition;          /* likewise */
    invcal_verdict verdict;         /* likewise */
    uint16_t positions;             /* how many made it */
    uint16_t undetermined;          /* bit r: parameter r */
    uint16_t from_prior;            /* likewise */
} invcal_record;

/* A record as bytes.
 *
 * Without temperature_known the temperature is not looked at, and stored as 0. A condition beyond
 * the largest float is stored as that.
 *
 * Returns INVCAL_OK;
 *   INVCAL_NOT_FINITE   a number is NaN, infinite, or beyond the largest float;
 *   INVCAL_BAD_SETTING  rounded to float, the matrix is singular or the field not positive; or the
 *                       verdict is none.
 * Sigmas and masks are not judged. Stack: about 400 bytes. */
invcal_status invcal_record_encode(const invcal_record *record, uint8_t bytes[INVCAL_RECORD_SIZE]);

/* A record from bytes, at any alignment.
 *
 * size  how many bytes there are; what follows the record is not looked at.
 *
 * Returns INVCAL_OK: the record is one that invcal_record_encode accepts;
 *   INVCAL_DAMAGED        too few bytes, a wrong CRC, or a content that is never encoded. Sure for
 *                         any one to four wrong bits, any run of up to 32 wrong bits, and any
 *                         two bytes exchanged; else, one time in 2^32 it goes unnoticed;
 *   INVCAL_OTHER_VERSION  sound, but not of this kind and version.
 * Stack: about 400 bytes. */
invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out);

#ifdef __cplusplus
}
#endif

#endif
