/* SPDX-License-Identifier: MIT
 *
 * invcal/thermal_store.h: a calibration for every temperature as bytes, for a memory (store.h), a
 * file or a radio.
 *
 * 248, 284 or 320 bytes (degree 0, 1, 2), the same on every machine; every build reads every
 * degree. frozen.md has their table. A device that does not know its temperature finds a record of
 * store.h at byte 4.
 */
#ifndef INVCAL_THERMAL_STORE_H
#define INVCAL_THERMAL_STORE_H

#include "invcal/store.h"
#include "invcal/thermal.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_THERMAL_RECORD_SIZE 320u /* bytes at most: for INVCAL_STORE_BYTES */

/* Saves the result of invcal_thermal_calibrate.
 *
 * Returns INVCAL_OK; as invcal_store_save; as invcal_thermal_encode, for arguments not from a
 * solution. Stack: about 1,200 bytes, without the callbacks. */
invcal_status invcal_thermal_save(const invcal_thermal *thermal, const invcal_quality *quality,
                                  const invcal_store *store);

/* Loads it. For what is known about it, use invcal_store_load and invcal_thermal_decode.
 *
 * Returns INVCAL_OK; as invcal_store_load; as invcal_thermal_decode. INVCAL_NO_SPACE,
 * INVCAL_OTHER_VERSION or INVCAL_DAMAGED: it holds something else. Stack: about 1,000 bytes, as
 * above. */
INVCAL_NODISCARD invcal_status invcal_thermal_load(invcal_thermal *out, const invcal_store *store);

/* Encodes it, as 212 + 36 (degree + 1) bytes.
 *
 * about  the record of invcal_thermal_at the reference: invcal_record_init, then what you know.
 *
 * Returns INVCAL_OK: invcal_thermal_decode accepts the bytes. On failure they are overwritten: as
 * invcal_record_encode; INVCAL_NOT_ELLIPSOID; INVCAL_BAD_COUNT for a degree above 2; INVCAL_DAMAGED
 * for what no fit gives, or a record of another calibration. Stack: about 660 bytes. */
invcal_status invcal_thermal_encode(const invcal_thermal *thermal, const invcal_record *about,
                                    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE]);

/* Decodes it from bytes, at any alignment.
 *
 * size   number of bytes; those after the end are ignored.
 * about  out: the record within; may be null. 0.2.0 may have turned its frame: byte 143, which is
 *        ignored.
 *
 * Returns INVCAL_OK; INVCAL_OTHER_VERSION for sound bytes of another kind or version, or of a
 * degree above 2; as invcal_thermal_encode otherwise. Stack: as above. */
invcal_status invcal_thermal_decode(const uint8_t *bytes, uint32_t size, invcal_thermal *out,
                                    invcal_record *about);

#ifdef __cplusplus
}
#endif

#endif
