/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "bytes.h"
#include "invcal/thermal.h"
#include "polynomials.h"

enum { WITHIN_AT = 4, NOMINAL_MATRIX_AT = 172 }; /* the record within, and the matrix */
enum { BEHIND = WITHIN_AT + INVCAL_RECORD_SIZE, BEHIND_V1 = WITHIN_AT + INVCAL_RECORD_SIZE_V1 };

invcal_status invcal_thermal_record_from_v1(const uint8_t *old, uint32_t size,
                                            uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE])
{
    invcal_thermal_record r;

    INVCAL_ASSERT(old && bytes);
    invcal_status status = invcal_unseal(old, size, INVCAL_THERMAL_KIND_V1);
    if (status == INVCAL_OK) {
        status = invcal_thermal_check_length(old, BEHIND_V1);
    }
    if (status == INVCAL_OK) {
        status = invcal_record_from_v1(old + WITHIN_AT, INVCAL_RECORD_SIZE_V1, bytes + WITHIN_AT);
    }
    if (status != INVCAL_OK) {
        return status;
    }
    const unsigned length = INVCAL_THERMAL_RECORD_BYTES(old[BEHIND_V1]);
    memcpy(bytes + BEHIND, old + BEHIND_V1, length - BEHIND);
    invcal_over_field(old + WITHIN_AT, bytes + NOMINAL_MATRIX_AT);
    invcal_seal(bytes, INVCAL_THERMAL_KIND, length);
    return invcal_thermal_record_decode(bytes, length, &r);
}
