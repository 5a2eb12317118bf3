/* SPDX-License-Identifier: MIT
 *
 * Internal: the steps of reading a thermal record, of whichever version.
 */
#ifndef INVCAL_THERMAL_RECORD_H
#define INVCAL_THERMAL_RECORD_H

#include "invcal/thermal.h"

/* Does the length that is stated fit the degree, which stands at `at`? INVCAL_DAMAGED if not;
 * INVCAL_OTHER_VERSION for a degree above that of the build. */
invcal_status invcal_thermal_check_length(const uint8_t *bytes, unsigned at);

/* Reads what stands behind the record within. INVCAL_NOT_FINITE. */
invcal_status invcal_thermal_read(const uint8_t *behind, invcal_thermal_record *r);

/* Is it a calibration, and the record within that of its reference? */
invcal_status invcal_thermal_check(const invcal_thermal_record *r);

#endif
