/* SPDX-License-Identifier: MIT
 *
 * invcal/store.h: what survives a reset.
 *
 *     memory          two slots of a flash, an EEPROM or a file, and how they are reached
 *     save, load      a calibration, or a session to go on with: what most programs need
 *     store           the same for any bytes, safe against power loss; how they stand in the slots
 *     record          a calibration with all that is known about it, as 136 bytes
 *
 * invcal.h states the rules and units.
 */
#ifndef INVCAL_STORE_H
#define INVCAL_STORE_H

#include <stddef.h>

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A program and a library whose choices differ do not link: see invcal.h. */
#define invcal_load INVCAL_CHOSEN(invcal_load, 9)
#define invcal_load_v1 INVCAL_CHOSEN(invcal_load_v1, 9)
#define invcal_record_init INVCAL_CHOSEN(invcal_record_init, 9)
#define invcal_record_decode INVCAL_CHOSEN(invcal_record_decode, 9)
#define invcal_load_session INVCAL_CHOSEN(invcal_load_session, INVCAL_MAX_POSITIONS)
#define invcal_session_resume INVCAL_CHOSEN(invcal_session_resume, INVCAL_MAX_POSITIONS)

/* ---- the memory -----------------------------------------------------------------------------------
 *
 * It is NOR flash, or anything that can behave like it. Erasing sets all bits of a slot, programming
 * clears some. A granule is the smallest piece that can be programmed; each is programmed once at
 * most between two erasures, as flash with error correction demands. An EEPROM, FRAM or file has
 * granules of 1 byte, and its erase fills the slot with 0xFF. */

/* How many bytes of a slot it takes to store size bytes. */
#define INVCAL_STORE_BYTES(size, granularity)                                                      \
    (((uint32_t)(size) + 12u + (uint32_t)(granularity) - 1u) / (uint32_t)(granularity) *           \
         (uint32_t)(granularity) +                                                                 \
     (uint32_t)(granularity))

#define INVCAL_STORE_GRANULARITY_MAX 32u /* bytes */

/* Slots are 0 and 1; offsets are from the start of the slot; the callbacks return 0, or anything
 * else for a failure. Every one must come back only when the memory has finished. */
typedef struct {
    /* Reads size bytes, at most 32. Any offset and size within the slot; bytes of any alignment. */
    int (*read)(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size);
    /* Sets all bytes of the slot to 0xFF. */
    int (*erase)(void *context, unsigned slot);
    /* Programs size bytes, at most 32, within the slot. Offset and size are multiples of the
     * granularity, in ascending order; bytes of any alignment. */
    int (*program)(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                   uint32_t size);
    void *context;        /* yours, handed to the callbacks */
    uint32_t slot_size;   /* bytes, INVCAL_STORE_BYTES(most to be stored, granularity) or more */
    uint32_t granularity; /* 1, 2, 4, 8, 16 or 32 bytes */
} invcal_store;

/* ---- a calibration, a session -------------------------------------------------------------------
 *
 *     at first:      if (invcal_load(&result, &calibration) != INVCAL_OK)
 *                        calibrate, and then invcal_save(&result, &calibration, &quality)
 *     to calibrate:  if (invcal_load_session(&progress, &session) != INVCAL_OK)
 *                        invcal_session_init(&session, 16384, 100);
 *                    after INVCAL_TAKEN: invcal_save_session(&progress, &session)
 *
 * A store holds one thing: these are two. */

/* Saves a calibration, and how good it is, as a record (see below); over field, so before
 * invcal_scale.
 *
 * Returns INVCAL_OK; as invcal_store_save; INVCAL_NOT_FINITE, INVCAL_BAD_NOMINAL, INVCAL_DAMAGED as
 * invcal_record_encode, of what no solution gives. Stack: about 500 bytes, without the callbacks. */
invcal_status invcal_save(const invcal_store *store, const invcal_calibration *calibration,
                          const invcal_quality *quality);

/* Loads it. Of the rest, invcal_store_load and invcal_record_decode know.
 *
 * Returns INVCAL_OK; as invcal_store_load; as invcal_record_decode. INVCAL_NO_SPACE or
 * INVCAL_OTHER_VERSION: it holds something else. Stack: about 500 bytes. */
invcal_status invcal_load(const invcal_store *store, invcal_calibration *calibration);

/* The same of what release 0.1.0 saved, for a device that has been in use since then: it asks this one
 * if invcal_load fails. Over field, as all calibrations; what is saved from now on invcal_load knows.
 *
 * Returns as invcal_load. Stack: about 900 bytes. */
invcal_status invcal_load_v1(const invcal_store *store, invcal_calibration *calibration);

/* Saves what lasts of a session: see invcal_session_size.
 *
 * Returns as invcal_store_save. Stack as that. */
invcal_status invcal_save_session(const invcal_store *store, const invcal_session *session);

/* Loads it, to go on with a stream that begins. If anything fails, begin the session anew.
 *
 * Returns as invcal_store_load, then as invcal_session_resume. Stack as these. */
invcal_status invcal_load_session(const invcal_store *store, invcal_session *session);

/* ---- the store: any bytes ------------------------------------------------------------------------
 *
 * A save never touches what a load would find: it erases the other slot, programs the bytes there,
 * reads them back, and only then confirms them, with one granule of zeros behind. Wherever power
 * fails, a later load finds the old bytes or the new ones in full.
 *
 * A slot, everything with the least significant byte first:
 *
 *     at        size  what
 *     0         1     kind, 0x5C
 *     1         1     version, 1
 *     2         2     size of what is stored
 *     4         4     sequence number: one more than that of the save before, if any, mod 2^32
 *     8         size  what is stored
 *               ...   0xFF, up to 4 bytes before the end of a granule
 *     E - 4     4     CRC-32 (IEEE 802.3, as zlib) of all bytes before it
 *     E               one granule: 0x00, confirmed; 0xFF, not
 *
 * Which one is loaded if both slots have a right CRC: the confirmed one; of two confirmed ones the
 * later; of two that are not, the earlier, because its writing had come to an end when that of the
 * later began. One that is not confirmed is loaded if there is no other. So a cell that a power cut
 * left half programmed, and that reads as 0 now and as 1 later, does no harm: were the CRC alone to
 * decide, the next save might erase the good slot for it.
 *
 * What it cannot do: guard against a driver that reports success before the memory is done, or
 * two saves at once. The granularity belongs to the format: with another one, nothing is found. */

/* Saves size bytes, 1 ... 65535 (65459 where int has 16 bits). They are what is loaded from now on.
 *
 * Returns INVCAL_OK: read back and found right;
 *   INVCAL_BAD_STORE  a granularity not in the list above, or a slot too small for anything;
 *   INVCAL_BAD_COUNT  size 0;
 *   INVCAL_NO_SPACE   more than a slot holds, or than the above: nothing was erased;
 *   INVCAL_IO         a callback failed, or what was read back differs: a worn or protected memory.
 *                     The old bytes are still loaded; the new ones are only if the very last step
 *                     failed, that of confirming them, or if there were no old ones. Also if
 *                     neither slot can be read: nothing was erased then, and invcal_store_erase
 *                     makes a new start.
 * One slot that cannot be read (error correction, after a power cut) is erased and used.
 * Reads both slots, and the new bytes twice. Stack: about 200 bytes, without the callbacks. */
invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size);

/* Loads them.
 *
 * capacity  of bytes.
 * size      out: how many were stored.
 *
 * Returns INVCAL_OK;
 *   INVCAL_NO_RECORD  nothing is stored, or nothing that is undamaged;
 *   INVCAL_NO_SPACE   it is more than capacity;
 *   INVCAL_BAD_STORE  as invcal_store_save;
 *   INVCAL_IO         nothing is found, but one slot, or both, cannot be read: there may be
 *                     something. If reading fails, or differs, when it was found already, bytes are
 *                     lost.
 * If one slot cannot be read, what is in the other is loaded, were it the older: a device with an
 * old calibration is better off than one without. Stack as above. */
invcal_status invcal_store_load(const invcal_store *store, uint8_t *bytes, uint32_t capacity,
                                uint32_t *size);

/* Forgets everything: erases both slots, the one that would be loaded last. If power fails, or the
 * first slot cannot be erased, that one is loaded, or nothing; never the older one.
 *
 * Returns INVCAL_OK; INVCAL_BAD_STORE; INVCAL_IO if a callback failed, or a slot still holds
 * something. Stack as above. */
invcal_status invcal_store_erase(const invcal_store *store);

/* ---- the record of a calibration ---------------------------------------------------------------
 *
 * For those who want to store more than invcal_save does: which sensor, when, at what temperature;
 * or to send it. It is the same on every machine: integers with the least significant byte first;
 * reals as IEEE-754 binary32 in the same order, whatever invcal_real is. A float build loses nothing.
 * A double build keeps 24 bits of each number, an error of 6e-8 of the value (0.002 counts of an
 * offset of 33000); encoded again, what was decoded gives the same bytes: storing it more often loses
 * nothing more.
 *
 * It begins with its kind, its version (now 2) and its length, and ends with the CRC-32 (IEEE 802.3, as
 * zlib) of all before it. What later versions may change: everything but that. So any version can tell
 * sound bytes of another one from damaged ones. Any change of the rest, be it one more verdict, gets
 * another version, and for what a release has written all that follow have a function.
 *
 * Damage is noticed for sure if it is one to four wrong bits, any run of up to 32 wrong bits, or any two
 * bytes exchanged; else, one time in 2^32 it goes unnoticed.
 *
 *     at    size  what                         at    size  what
 *       0   1     kind, 0xCA                    28   4     field_sigma
 *       1   1     version, 2                    32   4     temperature
 *       2   2     length, 136                   36   4     noise
 *       4   8     sensor                        40   4     rms
 *      12   4     date                          44   4     condition
 *      16   2     positions                     48   12    offset x, y, z
 *      18   2     weak                          60   36    matrix by rows
 *      20   2     from_prior                    96   36    sigma of the nine parameters
 *      22   1     verdict                      132   4     CRC
 *      23   1     temperature_known
 *      24   4     field
 *
 * Version 1, of release 0.1.0, has 48 bytes more before sigma, and its matrix gives the unit of its
 * field. */
#define INVCAL_RECORD_SIZE 136u    /* bytes of a record */
#define INVCAL_RECORD_SIZE_V1 184u /* of one of version 1 */

/* What is not known is 0. */
typedef struct {
    invcal_real field;       /* length of the field where it was made, in a unit of yours: what
                                invcal_scale needs to put that unit into the calibration */
    invcal_real field_sigma; /* standard deviation of that */
    invcal_real temperature; /* at which it was made, degrees Celsius */
    invcal_real noise;       /* of invcal_quality */
    invcal_real rms;         /* of invcal_quality */
    invcal_real condition;   /* of invcal_quality */
    /* over field: not after invcal_scale, which nobody could tell */
    invcal_calibration calibration;
    invcal_real sigma[INVCAL_PARAMETERS]; /* of invcal_quality */
    uint8_t sensor[8];         /* which one: a serial number or any other bytes of yours */
    uint32_t date;             /* when: in what you count, such as seconds since your epoch */
    uint16_t positions;        /* of invcal_quality */
    uint16_t weak;             /* of invcal_quality */
    uint16_t from_prior;       /* bit r: of invcal_calibrate_with_prior (expert.h) */
    uint8_t verdict;           /* of invcal_quality */
    uint8_t temperature_known; /* 1: temperature is; 0: it is 0 */
} invcal_record;

/* A record of what invcal_calibrate or a session gave. All that they do not know is unknown: fill
 * it in. */
void invcal_record_init(invcal_record *record, const invcal_calibration *calibration,
                        const invcal_quality *quality);

/* A record as bytes.
 *
 * Returns INVCAL_OK: invcal_record_decode accepts the bytes. On failure they are lost:
 *   INVCAL_NOT_FINITE   a number is NaN, infinite, or beyond the largest float;
 *   INVCAL_BAD_NOMINAL  rounded to float, the calibration is singular or absurdly scaled;
 *   INVCAL_DAMAGED      the record contradicts itself: WEAK, and no parameter is, or the reverse;
 *                       a tenth parameter; a temperature that is not known, and not 0.
 * Stack: about 300 bytes. */
invcal_status invcal_record_encode(const invcal_record *record, uint8_t bytes[INVCAL_RECORD_SIZE]);

/* A record from bytes, at any alignment.
 *
 * size  how many bytes there are; what follows the record is not looked at.
 *
 * Returns INVCAL_OK;
 *   INVCAL_DAMAGED        too few bytes, or a wrong CRC;
 *   INVCAL_OTHER_VERSION  sound, but not of this kind, or of a version that is not known here;
 *   as invcal_record_encode, for a content that it refuses.
 * Stack as above. */
invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out);

/* The same of a record of version 1, which release 0.1.0 wrote: over field, as all are now; `field` still
 * says in which unit it was.
 *
 * Returns as invcal_record_decode; INVCAL_OTHER_VERSION for any version but 1. Stack: about 500 bytes. */
invcal_status invcal_record_decode_v1(const uint8_t *bytes, uint32_t size, invcal_record *out);

/* ---- what lasts of a session ---------------------------------------------------------------------
 *
 * All that it was told and has taken stands at the beginning of the structure. What it knows of the
 * stream stands behind: a rest that was going on is lost, noise is learned anew, and who lies where
 * the last position was taken may see it taken once more, which does no harm.
 *
 * These bytes are the device's own: another number type, order of bytes or version of the library
 * refuses them. A table of another size takes them if they fit. Those of release 0.1.0 are refused, as
 * its procedure was another one. */
#define INVCAL_SESSION_SIZE                                                                        \
    ((uint32_t)(offsetof(invcal_session, mean) +                                                   \
                sizeof(invcal_real[INVCAL_MAX_POSITIONS][3]))) /* bytes at most */

/* How many bytes of a session, from its beginning, last. Who has other means than an invcal_store keeps
 * these. */
uint32_t invcal_session_size(const invcal_session *session);

/* Goes on with a session whose first bytes have been put back, and a stream that begins. If it fails,
 * begin the session anew.
 *
 * size  how many bytes were put back.
 *
 * Returns INVCAL_OK;
 *   INVCAL_OTHER_VERSION  they are not what a build like this has kept;
 *   INVCAL_DAMAGED        nor are they as long as their table;
 *   INVCAL_BAD_NOMINAL, INVCAL_BAD_NOISE, INVCAL_BAD_RATE, INVCAL_BAD_RAILS    a content that no session
 *   has. The means are not looked at: what solves refuses any that is none. */
invcal_status invcal_session_resume(invcal_session *session, uint32_t size);

#ifdef __cplusplus
}
#endif

#endif
