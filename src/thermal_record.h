/* SPDX-License-Identifier: MIT
 *
 * Internal: the steps of decoding a thermal record of any version.
 */
#ifndef INVCAL_THERMAL_RECORD_H
#define INVCAL_THERMAL_RECORD_H

#include "invcal/thermal.h"

/* Does the stated length fit the degree at `at`? INVCAL_DAMAGED if not;
 * INVCAL_OTHER_VERSION for a degree above 2. */
invcal_status invcal_thermal_check_length(const uint8_t *bytes, unsigned at);

/* Reads the part after the record within. INVCAL_NOT_FINITE. */
invcal_status invcal_thermal_read(const uint8_t *tail, invcal_thermal_record *r);

/* Is it a calibration, and the record within that of its reference? */
invcal_status invcal_thermal_check(const invcal_thermal_record *r);

#endif
