/* SPDX-License-Identifier: MIT
 *
 * invcal/store.h: a record of bytes kept in two slots of a memory, safe against power loss.
 *
 * The bytes may be anything: those of record.h, or your own. A save never touches the record
 * that a load would find: it erases the other slot, programs the new record there, reads it
 * back, and only then confirms it, with one granule of zeros behind it. Wherever power fails, a
 * later load finds the old record or the new one in full.
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
 *     2         2     size of the record
 *     4         4     sequence number: one more than that of the record before, modulo 2^32
 *     8         size  the record
 *               ...   0xFF, up to 4 bytes before the end of a granule
 *     E - 4     4     CRC-32 (IEEE 802.3, as zlib) of all bytes before it
 *     E               one granule: 0x00, the record is confirmed; 0xFF, it is not
 *
 * Which one is loaded if both slots hold a record with a right CRC: the confirmed one; of two
 * confirmed ones the later; of two that are not, the earlier, because its writing had come to an
 * end when that of the later began. One that is not confirmed is loaded if there is no other.
 * So a cell that a power cut left half programmed, and that reads as 0 now and as 1 later, does
 * no harm: were the CRC alone to decide, the next save might erase the good record for it.
 *
 * What it cannot do: guard against a driver that reports success before the memory is done, or
 * two saves at once. The granularity belongs to the format: with another one, nothing is found.
 */
#ifndef INVCAL_STORE_H
#define INVCAL_STORE_H

#include <stdint.h>

#include "invcal/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How many bytes of a slot a record takes. */
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
    uint32_t slot_size;   /* bytes, INVCAL_STORE_BYTES(largest record, granularity) or more */
    uint32_t granularity; /* 1, 2, 4, 8, 16 or 32 bytes */
} invcal_store;

/* Saves a record. It is the one that is loaded from now on.
 *
 * size  1 ... 65535
 *
 * Returns INVCAL_OK: read back and found right;
 *   INVCAL_BAD_SETTING  size 0, a granularity not in the list above, or a slot that is too small
 *                       for any record;
 *   INVCAL_NO_SPACE     larger than a slot or 65535 bytes: nothing was erased;
 *   INVCAL_IO           a callback failed, or what was read back differs: a worn or protected
 *                       memory. The old record is still loaded; the new one is only if the very
 *                       last step failed, that of confirming it, or if there was no old one.
 *                       Also if neither slot can be read: nothing was erased then, and
 *                       invcal_store_erase makes a new start.
 * One slot that cannot be read (error correction, after a power cut) is erased and used.
 * Reads both slots, and the new record once more. Stack: about 200 bytes (Cortex-M4F, -Os),
 * without the callbacks. */
invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size);

/* Loads the record.
 *
 * bytes  room for capacity bytes.
 * size   how many of them are the record.
 *
 * Returns INVCAL_OK;
 *   INVCAL_NO_RECORD    there is none, or none that is undamaged;
 *   INVCAL_NO_SPACE     it is larger than capacity;
 *   INVCAL_BAD_SETTING  as invcal_store_save;
 *   INVCAL_IO           no record is found, but one slot, or both, cannot be read: there may be
 *                       one. If reading fails, or differs, when a record was found already, bytes
 *                       are lost.
 * If one slot cannot be read, the record in the other is loaded, were it the older one: a device
 * with an old calibration is better off than one without. Stack as above. */
invcal_status invcal_store_load(const invcal_store *store, uint8_t *bytes, uint32_t capacity,
                                uint32_t *size);

/* Forgets everything: erases both slots, the one that would be loaded last. If power fails, or
 * the first slot cannot be erased, that record is loaded, or none; never the older one.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING as invcal_store_save; INVCAL_IO if a callback failed, or
 * a slot still holds a record. Stack as above. */
invcal_status invcal_store_erase(const invcal_store *store);

#ifdef __cplusplus
}
#endif

#endif
