/* SPDX-License-Identifier: MIT
 *
 * storage.h: the calibration in the EEPROM, safe against a power cut while it is written.
 */
#ifndef STORAGE_H
#define STORAGE_H

#include <invcal.h>

/* Returns INVCAL_OK; as invcal_store_load and invcal_record_decode. */
invcal_status storage_load(invcal_calibration &calibration);

/* Returns INVCAL_OK; as invcal_record_encode and invcal_store_save. */
invcal_status storage_save(const invcal_session &session, const invcal_solution &solution,
                           const invcal_quality &quality);

#endif
