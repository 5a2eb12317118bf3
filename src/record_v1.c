/* SPDX-License-Identifier: MIT
 *
 * Records of version 1, of release 0.1.0: its matrices are in the unit of the field, and delta, dk,
 * gamma and sigma_offset stand before sigma.
 */
#include <string.h>

#include "bytes.h"
#include "invcal/store.h"

enum { FIELD_AT = 24, MATRIX_AT = 60, SIGMA_AT = 96, SIGMA_SIZE = 36 };
enum { SKIPPED = INVCAL_RECORD_SIZE_V1 - INVCAL_RECORD_SIZE };

void invcal_over_field(const uint8_t *record, uint8_t *matrix)
{
    invcal_real field;
    invcal_real m[9];

    (void)invcal_get_reals(record + FIELD_AT, &field, 1);
    (void)invcal_get_reals(matrix, m, 9);
    for (unsigned i = 0; i < 9; i++) {
        m[i] /= field;
    }
    (void)invcal_put_reals(matrix, m, 9);
}

/* r is what the new bytes say. */
static invcal_status renew(const uint8_t *old, uint32_t size, uint8_t *bytes, invcal_record *r)
{
    const invcal_status status = invcal_unseal(old, size, INVCAL_RECORD_KIND_V1);
    if (status != INVCAL_OK) {
        return status;
    }
    if (invcal_get_u16(old + 2) != INVCAL_RECORD_SIZE_V1) {
        return INVCAL_DAMAGED;
    }
    memcpy(bytes, old, SIGMA_AT);
    memcpy(bytes + SIGMA_AT, old + SIGMA_AT + SKIPPED, SIGMA_SIZE);
    invcal_over_field(old, bytes + MATRIX_AT);
    invcal_seal(bytes, INVCAL_RECORD_KIND, INVCAL_RECORD_SIZE);
    return invcal_record_decode(bytes, INVCAL_RECORD_SIZE, r);
}

invcal_status invcal_record_from_v1(const uint8_t *old, uint32_t size,
                                    uint8_t bytes[INVCAL_RECORD_SIZE])
{
    invcal_record r;

    INVCAL_ASSERT(old && bytes);
    return renew(old, size, bytes, &r);
}

invcal_status invcal_load_v1(const invcal_store *store, invcal_calibration *calibration)
{
    uint8_t old[INVCAL_RECORD_SIZE_V1];
    uint32_t size = 0;

    INVCAL_ASSERT(calibration);
    invcal_status status = invcal_store_load(store, old, sizeof old, &size);
    if (status == INVCAL_OK) {
        uint8_t bytes[INVCAL_RECORD_SIZE];
        invcal_record r;
        status = renew(old, size, bytes, &r);
        if (status == INVCAL_OK) {
            *calibration = r.calibration;
        }
    }
    return status;
}
