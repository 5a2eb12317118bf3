/* SPDX-License-Identifier: MIT
 *
 * invcal/gyro_store.h: what survives a reset of gyro.h: rests and moves, and the result.
 *
 * store.h has the memory; invcal.h states the rules and units.
 */
#ifndef INVCAL_GYRO_STORE_H
#define INVCAL_GYRO_STORE_H

#include "invcal/gyro.h"
#include "invcal/store.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- rests and moves ---------------------------------------------------------------------------
 *
 * Moves are useless without the means of their rests, so both are kept together, in one slot: after
 * a power failure both are old or both are new. The move during the reset is refused,
 * INVCAL_MOVE_GAP: the next rest begins another. These bytes belong to the device, as those of a
 * session. */

/* Bytes to save at most: for INVCAL_STORE_BYTES. */
#define INVCAL_IMU_SIZE                                                                            \
    ((uint32_t)(offsetof(invcal_imu, session) - offsetof(invcal_imu, own.layout)) +                \
     INVCAL_SESSION_SIZE)

/* Saves both. Returns INVCAL_OK; INVCAL_NOT_BEGUN; as invcal_store_save. Stack: as that. */
invcal_status invcal_imu_save(const invcal_imu *imu, const invcal_store *store);

/* Loads both into what was begun, to resume with new streams of samples. What was stated by _set_
 * stays.
 *
 * Returns INVCAL_OK; else both are as they were begun: as invcal_session_load; INVCAL_DAMAGED also
 * if the moves are inconsistent; INVCAL_OTHER_SETTINGS also for the gyroscope's. Stack: about 320
 * bytes, without the callbacks. */
invcal_status invcal_imu_load(invcal_imu *imu, const invcal_store *store);

/* ---- the result --------------------------------------------------------------------------------
 *
 * Both calibrations and their quality as 344 bytes, for a memory, a file or a radio; the same on
 * every machine. frozen.md has their table. A device without gyroscope support finds a record of
 * store.h at byte 4. */
#define INVCAL_IMU_RECORD_SIZE 344u /* bytes */

/* Encodes a result.
 *
 * about  null; or a record of which field, field_sigma, temperature, sensor and date are taken. All
 *        of it, if it has the same calibration: the accelerometer's own, which was held.
 *
 * Returns INVCAL_OK: invcal_imu_decode accepts the bytes. On failure they are overwritten: as
 * invcal_record_encode, of either sensor; INVCAL_DAMAGED also for a verdict that contradicts weak.
 * Stack: about 730 bytes. */
INVCAL_NODISCARD invcal_status invcal_imu_encode(const invcal_imu_result *result,
                                                 const invcal_record *about,
                                                 uint8_t bytes[INVCAL_IMU_RECORD_SIZE]);

/* Decodes a result from bytes, at any alignment.
 *
 * size   number of bytes; any after the record are ignored.
 * out    members that the table above does not name are 0.
 * about  out: the record of the accelerometer; may be null.
 *
 * Returns INVCAL_OK; INVCAL_DAMAGED; INVCAL_OTHER_VERSION for intact bytes of another kind or
 * version; as invcal_imu_encode otherwise. Stack: as above. */
INVCAL_NODISCARD invcal_status invcal_imu_decode(const uint8_t *bytes, uint32_t size,
                                                 invcal_imu_result *out, invcal_record *about);

/* Saves a result as these bytes; so before invcal_scale.
 *
 * Returns INVCAL_OK; as invcal_store_save; as invcal_imu_encode. Stack: about 1,100 bytes, without
 * the callbacks. */
invcal_status invcal_imu_save_result(const invcal_imu_result *result, const invcal_store *store);

/* Loads it.
 *
 * Returns INVCAL_OK; as invcal_store_load; as invcal_imu_decode: for most other contents,
 * INVCAL_NO_SPACE or INVCAL_DAMAGED. Stack: about 1,100 bytes, without the callbacks. */
INVCAL_NODISCARD invcal_status invcal_imu_load_result(invcal_imu_result *out,
                                                      const invcal_store *store);

#ifdef __cplusplus
}
#endif

#endif
