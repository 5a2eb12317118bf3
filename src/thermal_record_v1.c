/* SPDX-License-Identifier: MIT
 *
 * Thermal records of version 1, of release 0.1.0: matrices are in the unit of the field.
 */
#include "bytes.h"
#include "invcal/thermal.h"
#include "thermal_record.h"

enum { RECORD_AT_V1 = 4, AFTER_RECORD_V1 = RECORD_AT_V1 + INVCAL_RECORD_SIZE_V1 };

invcal_status invcal_thermal_record_decode_v1(const uint8_t *bytes, uint32_t size,
                                              invcal_thermal_record *out)
{
    invcal_thermal_record r;

    INVCAL_ASSERT(bytes && out);
    invcal_status status = invcal_unseal(bytes, size, INVCAL_THERMAL_KIND_V1);
    if (status == INVCAL_OK) {
        status = invcal_thermal_check_length(bytes, AFTER_RECORD_V1);
    }
    if (status == INVCAL_OK) {
        status = invcal_record_decode_v1(bytes + RECORD_AT_V1, INVCAL_RECORD_SIZE_V1, &r.record);
    }
    if (status == INVCAL_OK) {
        status = invcal_thermal_read(bytes + AFTER_RECORD_V1, &r);
    }
    if (status == INVCAL_OK) {
        invcal_over_field(r.thermal.nominal.matrix[0], r.record.field);
        status = invcal_thermal_check(&r);
    }
    if (status == INVCAL_OK) {
        *out = r;
    }
    return status;
}
