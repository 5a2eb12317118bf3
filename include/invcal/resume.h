/* SPDX-License-Identifier: MIT
 *
 * invcal/resume.h: a session as bytes, to go on with after a reset.
 *
 *     after INVCAL_SESSION_TAKEN, _ENOUGH, _FINISHED, and after invcal_session_age:
 *         invcal_resume_encode(&session, bytes, &size);
 *         invcal_store_save(&store, bytes, size);
 *     after a reset:
 *         if (invcal_store_load(&store, bytes, INVCAL_RESUME_SIZE, &size) != INVCAL_OK ||
 *             invcal_resume_decode(bytes, size, &session) != INVCAL_OK)
 *             invcal_session_init(&session, &setup);
 *         for every sample: invcal_session_feed
 *
 * Kept is all that a session was told and has taken. Not kept is what it knows of the stream
 * (still.h): a rest that was going on is lost, noise is learned anew, and who lies where the last
 * position was taken may see it taken once more, which does no harm.
 *
 * The bytes. Integers with the least significant byte first, low and high in two's complement;
 * reals as IEEE-754 binary32 in the same order. S and C are what stands at 4 and 8.
 *
 *     at    size  what                         at        size  what
 *       0   1     kind, 0xC5                   24        12    nominal offset x, y, z
 *       1   1     version, 1                   36        36    nominal matrix by rows
 *       2   2     length                       72        4     field
 *       4   2     S, positions in the table    76        4     noise
 *       6   2     step                         80        36    prior
 *       8   4     C, positions taken           116       12    start 1, 2, 3; 0 without a plan
 *      12   2     per_group                    128       12    target of delta, dk, gamma
 *      14   1     frame                        140       4     rate
 *      15   1     bit 0: background,           144       12    temperature, coldest, warmest
 *                 bit 1: is_enough             156       8     mean_sigma, hold
 *      16   4     low                          164       13 S  position by position: mean x, y, z;
 *      20   4     high                                         age, 1 byte
 *                                              164 + 13 S      only if C > S, 164: the moments,
 *                                                              H'Wj, j'Wj
 *                                              length - 4      CRC-32 (IEEE 802.3, as zlib)
 *
 * 402 bytes for 18 positions. The sums are stored only if more positions were taken than the table
 * holds. Else they are made again from the table, in the order and with the weights of the session:
 * that takes fewer bytes, and they always belong to the means.
 *
 * A float build loses nothing: after decode all is as before to the bit, and so is the result. A
 * double build keeps 24 bits of each number: of a mean of 4000 counts 0.0001, of 33000 counts 0.002
 * are lost. The parameters change by about that much over the field (measured: 2e-7 with 4000
 * counts); those of stored sums, of which 6e-8 of each are lost, by less. Encoded again, a decoded
 * session gives the same bytes: storing it more often loses nothing more.
 *
 * What later versions may change: as record.h. The two are told apart by their kind.
 */
#ifndef INVCAL_RESUME_H
#define INVCAL_RESUME_H

#include <stdint.h>

#include "invcal/session.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The most bytes that a session takes: 748 by default. A slot of store.h needs
 * INVCAL_STORE_BYTES(INVCAL_RESUME_SIZE, granularity). */
#define INVCAL_RESUME_SIZE (332u + 13u * INVCAL_MAX_POSITIONS)

/* A session as bytes.
 *
 * session  begun by invcal_session_init or invcal_resume_decode.
 * size     how many bytes it takes; those behind are left untouched.
 *
 * Returns INVCAL_OK: invcal_resume_decode of the same build accepts the bytes;
 *   INVCAL_NOT_FINITE    a number is NaN, infinite, or beyond the largest float;
 *   INVCAL_OUT_OF_RANGE  rounded to float, a mean is no reading of the field any more: in a double
 *                        build, for one in millions of those at the very limits of observation.h;
 *   INVCAL_BAD_SETTING   rounded to float, the settings are unusable; or the counts contradict
 *                        each other: that is no session.
 * Stack: about 500 bytes (float, Cortex-M4F, -Os). */
invcal_status invcal_resume_encode(const invcal_session *session, uint8_t bytes[INVCAL_RESUME_SIZE],
                                   uint32_t *size);

/* A session from bytes, at any alignment. It goes on with a stream that begins.
 *
 * size  how many bytes there are; what follows the session is not looked at.
 *
 * Returns INVCAL_OK;
 *   INVCAL_DAMAGED        too few bytes, a wrong CRC, or a content that is never encoded: a setup
 *                         that invcal_session_init refuses, a mean that is no reading of its
 *                         field, counts that contradict each other;
 *   INVCAL_OTHER_VERSION  sound, but not of this kind and version;
 *   INVCAL_NO_SPACE       sound, but its table is larger than INVCAL_MAX_POSITIONS of this build
 *                         (or its count than an unsigned). A larger table reads a smaller one.
 * Stack: about 700 bytes; that is less than a session, as none is built beside *out. */
invcal_status invcal_resume_decode(const uint8_t *bytes, uint32_t size, invcal_session *out);

#ifdef __cplusplus
}
#endif

#endif
