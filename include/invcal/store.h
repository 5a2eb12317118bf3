/* SPDX-License-Identifier: MIT
 *
 * invcal/store.h: what survives a reset.
 *
 *     memory          two slots of a flash, an EEPROM or a file, and callbacks to access them
 *     save, load      a calibration, or a session to resume: what most programs need
 *     store           the same for any bytes, safe against power loss
 *     record          a calibration with all that is known about it, as 136 bytes
 *
 * invcal.h states the rules and units; frozen.md, "Stored bytes", lists what is where.
 */
#ifndef INVCAL_STORE_H
#define INVCAL_STORE_H

#include <stddef.h>

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the memory ---------------------------------------------------------------------------------
 *
 * NOR flash, or any memory that can behave like it. Erasing sets all bits of a slot, programming
 * clears some. A granule is the smallest unit that can be programmed; each is programmed at most
 * once between two erasures, as flash with error correction requires. An EEPROM, FRAM or file has
 * granules of 1 byte, and its erase fills the slot with 0xFF. */

/* Bytes of a slot needed to store size bytes. */
#define INVCAL_STORE_BYTES(size, granularity)                                                      \
    (((uint32_t)(size) + 12u + (uint32_t)(granularity) - 1u) / (uint32_t)(granularity) *           \
         (uint32_t)(granularity) +                                                                 \
     (uint32_t)(granularity))

#define INVCAL_STORE_GRANULARITY_MAX 32u /* bytes */

/* Slots are 0 and 1; offsets are from the start of the slot; the callbacks return 0, or anything
 * else for a failure. A callback returns only when the memory has finished. */
typedef struct {
    /* Reads size bytes, at most 32. Any offset and size within the slot; bytes of any alignment. */
    int (*read)(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size);
    /* Sets all bytes of the slot to 0xFF. */
    int (*erase)(void *context, unsigned slot);
    /* Programs size bytes, at most 32, within the slot. Offset and size are multiples of the
     * granularity, in ascending order; bytes of any alignment. */
    int (*program)(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                   uint32_t size);
    void *context;        /* yours, passed to the callbacks */
    uint32_t slot_size;   /* bytes, at least INVCAL_STORE_BYTES(max size, granularity) */
    uint32_t granularity; /* 1, 2, 4, 8, 16 or 32 bytes */
} invcal_store;

/* ---- a calibration, a session -------------------------------------------------------------------
 *
 * A store holds one object: these are two stores. Their slots have at least
 * INVCAL_STORE_BYTES(INVCAL_RECORD_SIZE, granularity) and
 * INVCAL_STORE_BYTES(INVCAL_SESSION_SIZE, granularity) bytes.
 *
 * A session is begun first, then loaded: what was begun and set stays. */

/* Saves a calibration, and how good it is, as a record (see below); over field, so before
 * invcal_scale.
 *
 * Returns INVCAL_OK; as invcal_store_save; INVCAL_NOT_FINITE, INVCAL_BAD_NOMINAL, INVCAL_DAMAGED as
 * invcal_record_encode, for arguments not from a solution. Cost: 17,000 instructions. Stack: about
 * 500 bytes; both without the callbacks. */
invcal_status invcal_save(const invcal_calibration *calibration, const invcal_quality *quality,
                          const invcal_store *store);

/* Loads it. For its other contents, use invcal_store_load and invcal_record_decode.
 *
 * Returns INVCAL_OK; as invcal_store_load; as invcal_record_decode. INVCAL_NO_SPACE,
 * INVCAL_OTHER_VERSION or INVCAL_DAMAGED: it holds something else.
 * Cost: 11,000 instructions. Stack: about 450 bytes; both as above. */
INVCAL_NODISCARD invcal_status invcal_load(invcal_calibration *calibration,
                                           const invcal_store *store);

/* Saves settings and positions of a session, as invcal_session_size.
 *
 * Returns as invcal_store_save. Cost: 22,000 instructions for 18 positions, without the callbacks.
 * Stack as that. */
invcal_status invcal_session_save(const invcal_session *session, const invcal_store *store);

/* Loads it into a session that was begun, to resume with a new stream. Noise is learned again, and
 * a device still in its last orientation may take it again.
 *
 * Returns as invcal_store_load, then as invcal_session_resume. INVCAL_OTHER_SETTINGS: also if it
 * holds something else. If it fails, the session is as it was begun: to ignore that is to begin
 * again. Cost: 17,000 instructions for 18 positions. Stack as these. */
invcal_status invcal_session_load(invcal_session *session, const invcal_store *store);

/* ---- the store: any bytes -----------------------------------------------------------------------
 *
 * A save never touches the slot that a load would find: it erases the other one, programs the bytes
 * there, reads them back, and only then confirms them, with one granule of zeros after them.
 * Whenever power fails, a later load finds the old bytes or all of the new ones.
 *
 * Limits: it cannot guard against a driver that reports success before the memory is done, or
 * against two saves at once. The granularity is part of the format: with another one, the data
 * may not be found. */

/* Saves size bytes, 1 ... 65535 (65459 where int has 16 bits). A later load returns them.
 *
 * Returns INVCAL_OK: read back and verified;
 *   INVCAL_BAD_STORE  a granularity not in the list above, or a slot too small for anything;
 *   INVCAL_BAD_COUNT  size 0;
 *   INVCAL_NO_SPACE   more than a slot holds, or than the above: nothing was erased;
 *   INVCAL_IO         a callback failed, or the bytes read back differ: a worn or protected memory.
 *                     A load still returns the old bytes; the new ones only if the very last step,
 *                     confirming them, failed, or if there were no old ones. Also returned if
 *                     neither slot can be read: nothing was erased then; call invcal_store_erase to
 *                     start over.
 * If one slot cannot be read (error correction, after a power cut), it is erased and used.
 * Stack: about 180 bytes, without the callbacks. */
invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size);

/* Loads them.
 *
 * capacity  size of the buffer.
 * size      out: how many were stored.
 *
 * Returns INVCAL_OK;
 *   INVCAL_NO_RECORD  nothing is stored, or nothing undamaged;
 *   INVCAL_NO_SPACE   more than capacity is stored;
 *   INVCAL_BAD_STORE  as invcal_store_save;
 *   INVCAL_IO         nothing was found, but one or both slots cannot be read: there may be
 *                     something. If the second reading, of what was found, fails or differs, bytes
 *                     is overwritten.
 * If one slot cannot be read, loads the other, even if it is the older. Stack as above. */
invcal_status invcal_store_load(const invcal_store *store, uint8_t *bytes, uint32_t capacity,
                                uint32_t *size);

/* Erases both slots, the one that a load would take last. If power fails, or the first slot cannot
 * be erased, a load finds that one or nothing; never the older one.
 *
 * Returns INVCAL_OK; INVCAL_BAD_STORE; INVCAL_IO if a callback failed, or a slot still holds
 * something. Stack as above. */
invcal_status invcal_store_erase(const invcal_store *store);

/* ---- the record of a calibration ----------------------------------------------------------------
 *
 * Use it to store more than invcal_save does: which sensor, when, at what temperature; or to send
 * it. It is the same on every machine. Reals are stored as IEEE-754 binary32: a double build keeps
 * 24 bits of each number, an error of 6e-8 of the value (0.002 counts of an offset of 33000);
 * decoding and encoding again gives the same bytes. It begins with its kind,
 * version and length, and ends with a CRC-32. */
#define INVCAL_RECORD_SIZE 136u /* bytes of a record */

/* Unknown values are 0. */
typedef struct {
    invcal_real field;       /* length of the field where it was made, in your unit: what
                                invcal_scale needs to put that unit into the calibration */
    invcal_real field_sigma; /* standard deviation of that */
    invcal_real temperature; /* at which it was made, degrees Celsius */
    invcal_real noise;       /* of invcal_quality */
    invcal_real rms;         /* of invcal_quality */
    invcal_real condition;   /* of invcal_quality */
    /* over field: never after invcal_scale, which cannot be detected */
    invcal_calibration calibration;
    invcal_real sigma[INVCAL_PARAMETERS]; /* of invcal_quality */
    uint8_t sensor[8];                    /* which one: a serial number or any other bytes */
    uint32_t date;                        /* when: in any unit, such as seconds since your epoch */
    uint16_t positions;                   /* of invcal_quality */
    uint16_t weak;                        /* of invcal_quality */
    uint16_t held;                        /* of invcal_quality */
    uint8_t verdict;                      /* of invcal_quality */
    uint8_t temperature_known;            /* 1: temperature is known; 0: temperature is 0 */
} invcal_record;

/* Makes a record of the result of invcal_calibrate or a session. Everything else is unknown: fill
 * it in. */
void invcal_record_init(invcal_record *record, const invcal_calibration *calibration,
                        const invcal_quality *quality);

/* Encodes a record as bytes.
 *
 * Returns INVCAL_OK: invcal_record_decode accepts the bytes. On failure they are overwritten:
 *   INVCAL_NOT_FINITE   a number is NaN, infinite, or beyond the largest float;
 *   INVCAL_BAD_NOMINAL  rounded to float, the calibration is singular or absurdly scaled;
 *   INVCAL_DAMAGED      the record contradicts itself: verdict WEAK without a weak parameter, or
 *                       the reverse; an unknown verdict; a tenth parameter; an unknown temperature
 *                       that is not 0.
 * Stack: about 240 bytes. */
invcal_status invcal_record_encode(const invcal_record *record, uint8_t bytes[INVCAL_RECORD_SIZE]);

/* Decodes a record from bytes, at any alignment.
 *
 * size  number of bytes; those after the record are ignored.
 *
 * Returns INVCAL_OK;
 *   INVCAL_DAMAGED        too few bytes, or a wrong CRC;
 *   INVCAL_OTHER_VERSION  sound, but not of this kind, or of an unknown version;
 *   as invcal_record_encode, for a content that it refuses.
 * Stack as above. */
invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out);

/* ---- a session without an invcal_store ----------------------------------------------------------
 *
 * For a memory that keeps blobs, such as NVS. The bytes are for the same device: a build with
 * another number type, byte order or layout of the structure refuses them. A table of another size
 * accepts them if they fit. */
#define INVCAL_SESSION_SIZE                                                                        \
    ((uint32_t)(offsetof(invcal_session, mean) +                                                   \
                INVCAL_MAX_POSITIONS * sizeof(invcal_vector))) /* bytes at most */

/* The number of bytes to save, from the beginning of a session. */
uint32_t invcal_session_size(const invcal_session *session);

/* Resumes from these bytes, at any alignment, with a new stream.
 *
 * size  number of bytes.
 *
 * Returns INVCAL_OK; else the session is as it was begun, without positions:
 *   INVCAL_NOT_BEGUN;
 *   INVCAL_OTHER_SETTINGS  they were saved with another nominal calibration or rate, or by another
 *                          build;
 *   INVCAL_DAMAGED         their number does not match the table;
 *   INVCAL_NO_SPACE        more than INVCAL_SESSION_SIZE.
 * The means are not checked: solving refuses bad ones. */
invcal_status invcal_session_resume(invcal_session *session, const uint8_t *bytes, uint32_t size);

#ifdef __cplusplus
}
#endif

#endif
