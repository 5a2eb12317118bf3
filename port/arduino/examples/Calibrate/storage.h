/* SPDX-License-Identifier: MIT
 *
 * storage.h: calibration and session in the EEPROM, safe against a power cut while they are written.
 */
#ifndef STORAGE_H
#define STORAGE_H

#include <invcal.h>

extern const invcal_store calibration_store;
extern const invcal_store session_store;

#endif
