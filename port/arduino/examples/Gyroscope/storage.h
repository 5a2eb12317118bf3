/* SPDX-License-Identifier: MIT
 *
 * storage.h: the calibration of both sensors in the EEPROM, safe against a power cut while it is written.
 */
#ifndef STORAGE_H
#define STORAGE_H

#include <invcal.h>
#include <invcal/gyro_store.h>

extern const invcal_store calibration_store;

#endif
