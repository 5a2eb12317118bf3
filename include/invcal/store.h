/* SPDX-License-Identifier: MIT
 *
 * invcal/store.h: what survives a reset.
 *
 *     save, load      a calibration, or a session to go on with, in a memory of yours
 *     store           the memory: bytes in two slots, safe against power loss
 *     record          a calibration with all that is known about it, as 136 bytes
 *     session bytes   a session, as 76 bytes and 12 for each position
 *
 * The first is what most programs need:
 *
 *     static const invcal_store memory = {read, erase, program, NULL, 4096, 8};
 *
 *     once: invcal_save(&memory, &calibration, &quality);
 *     then: if (invcal_load(&memory, &calibration) == INVCAL_OK)
 *               invcal_apply(&calibration, raw, g);
 *
 * invcal.h states the rules and units.
 */
#ifndef INVCAL_STORE_H
#define INVCAL_STORE_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the store: bytes in two slots ---------------------------------------------------------------
 *
 * The bytes may be anything: a record, a session, or your own. A save never touches those that a
 * load would find: it erases the other slot, programs the new ones there, reads them back, and only
 * then confirms them, with one granule of zeros behind. Wherever power fails, a later load finds
 * the old ones or the new ones in full.
 *
 * The memory is NOR flash, or anything that can behave like it. Erasing sets all bits of a slot,
 * programming clears some. A granule is the smallest piece that can be programmed; each is
 * programmed once at most between two erasures, as flash with error correction demands. An EEPROM,
 * FRAM or file has granules of 1 byte, and its erase fills the slot with 0xFF.
 *
 * A slot, everything with the least significant byte first:
 *
 *     at        size  what
 *     0         1     kind, 0x5C
 *     1         1     version, 1
 *     2         2     size of what is stored
 *     4         4     sequence number: one more than that of the save before, modulo 2^32
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

/* How many bytes of a slot it takes to store size bytes. */
#define INVCAL_STORE_BYTES(size, granularity)                                                      \
    (((uint32_t)(size) + 12u + (uint32_t)(granularity) - 1u) / (uint32_t)(granularity) *           \
         (uint32_t)(granularity) +                                                                 \
     (uint32_t)(granularity))

#define INVCAL_STORE_GRANULARITY_MAX 32u /* bytes */

/* The memory. Slots are 0 and 1; offsets are from the start of the slot; the callbacks return 0,
 * or anything else for a failure. Every one must come back only when the memory has finished. */
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

/* Saves size bytes, 1 ... 65535. They are what is loaded from now on.
 *
 * Returns INVCAL_OK: read back and found right;
 *   INVCAL_BAD_STORE  a granularity not in the list above, or a slot too small for anything;
 *   INVCAL_BAD_COUNT  size 0;
 *   INVCAL_NO_SPACE   more than a slot holds, or than 65535: nothing was erased;
 *   INVCAL_IO         a callback failed, or what was read back differs: a worn or protected memory.
 *                     The old bytes are still loaded; the new ones are only if the very last step
 *                     failed, that of confirming them, or if there were no old ones. Also if
 *                     neither slot can be read: nothing was erased then, and invcal_store_erase
 *                     makes a new start.
 * One slot that cannot be read (error correction, after a power cut) is erased and used.
 * Reads both slots, and the new bytes once more. Stack: about 200 bytes, without the callbacks. */
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

/* ---- a calibration ------------------------------------------------------------------------------- */

typedef struct {
    invcal_real field;
    invcal_real field_sigma;
    invcal_real temperature;
    invcal_real noise;
    invcal_real rms;
    invcal_real condition;
    invcal_calibration calibration;
    invcal_real sigma[INVCAL_PARAMETERS];
    uint8_t sensor[8];
    uint32_t date;
    uint16_t positions;
    uint16_t weak;
    uint16_t from_prior;
    uint8_t verdict;
    uint8_t temperature_known;
} invcal_record;

#define INVCAL_RECORD_SIZE 136u
#define INVCAL_RECORD_SIZE_MAX 184u

void invcal_record_init(invcal_record *record, const invcal_calibration *calibration,
                        const invcal_quality *quality);
invcal_status invcal_record_encode(const invcal_record *record, uint8_t bytes[INVCAL_RECORD_SIZE]);
invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out);

invcal_status invcal_save(const invcal_store *store, const invcal_calibration *calibration,
                          const invcal_quality *quality);
invcal_status invcal_load(const invcal_store *store, invcal_calibration *calibration);

#define INVCAL_SESSION_SIZE (76u + 12u * INVCAL_MAX_POSITIONS)
invcal_status invcal_session_encode(const invcal_session *session,
                                    uint8_t bytes[INVCAL_SESSION_SIZE], uint32_t *size);
invcal_status invcal_session_decode(const uint8_t *bytes, uint32_t size, invcal_session *out);
invcal_status invcal_save_session(const invcal_store *store, const invcal_session *session);
invcal_status invcal_load_session(const invcal_store *store, invcal_session *session);

#ifdef __cplusplus
}
#endif

#endif
