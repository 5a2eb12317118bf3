/* SPDX-License-Identifier: MIT
 *
 * Records of version 1, of release 0.1.0: its matrices are in the unit of the field; delta, dk,
 * gamma and sigma_offset come before sigma; and weak was the third verdict and the last.
 */
#include <string.h>

#include "bytes.h"
#include "invcal/store.h"
#include "solve.h"

enum { VERDICT_AT_V1 = 22, WEAK_V1 = 2, SIGMA_AT = 96, SIGMA_SIZE = 36 };
enum { SKIPPED = INVCAL_RECORD_SIZE_V1 - INVCAL_RECORD_SIZE };

void invcal_over_field(invcal_real *matrix, invcal_real field)
{
    for (unsigned i = 0; i < 9; i++) {
        matrix[i] /= field;
    }
}

invcal_status invcal_record_decode_v1(const uint8_t *bytes, uint32_t size, invcal_record *out)
{
    uint8_t now[INVCAL_RECORD_SIZE]; /* in the order of the current version */
    invcal_record r;

    INVCAL_ASSERT(bytes && out);
    invcal_status status = invcal_unseal(bytes, size, INVCAL_RECORD_KIND_V1);
    if (status != INVCAL_OK) {
        return status;
    }
    if (invcal_get_u16(bytes + 2) != INVCAL_RECORD_SIZE_V1 || bytes[VERDICT_AT_V1] > WEAK_V1) {
        return INVCAL_DAMAGED;
    }
    memcpy(now, bytes, SIGMA_AT);
    if (now[VERDICT_AT_V1] == WEAK_V1) {
        now[VERDICT_AT_V1] = INVCAL_WEAK;
    }
    memcpy(now + SIGMA_AT, bytes + SIGMA_AT + SKIPPED, SIGMA_SIZE);
    invcal_seal(now, INVCAL_RECORD_KIND, sizeof now);
    status = invcal_record_decode(now, sizeof now, &r);
    if (status == INVCAL_OK) {
        invcal_over_field(r.calibration.matrix[0], r.field);
        status = invcal_nominal_check(&r.calibration);
    }
    if (status == INVCAL_OK) {
        *out = r;
    }
    return status;
}

invcal_status invcal_load_v1(const invcal_store *store, invcal_calibration *calibration)
{
    uint8_t bytes[INVCAL_RECORD_SIZE_V1];
    invcal_record r;
    uint32_t size = 0;

    INVCAL_ASSERT(calibration);
    invcal_status status = invcal_store_load(store, bytes, sizeof bytes, &size);
    if (status == INVCAL_OK) {
        status = invcal_record_decode_v1(bytes, size, &r);
    }
    if (status == INVCAL_OK) {
        *calibration = r.calibration;
    }
    return status;
}
