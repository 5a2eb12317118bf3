/* SPDX-License-Identifier: MIT */
#include "invcal/record.h"

#include <string.h>

#include "bytes.h"
#include "vector.h"

enum { RECORD_KIND = 0xCA, RECORD_VERSION = 1, RECORD_REALS_AT = 24, TEMPERATURE_AT = 32 };

/* In the order of their bytes. */
static void each_record_real(invcal_way *w, invcal_record *r)
{
    invcal_way_each(w, &r->field, 1);
    invcal_way_each(w, &r->field_sigma, 1);
    invcal_way_each(w, &r->temperature, 1);
    invcal_way_each(w, &r->noise, 1);
    invcal_way_each(w, &r->residual_rms, 1);
    invcal_way_each(w, &r->condition, 1);
    invcal_way_each(w, r->calibration.offset, 3);
    for (unsigned i = 0; i < 3; i++) {
        invcal_way_each(w, r->calibration.matrix[i], 3);
    }
    invcal_way_each(w, r->delta, 3);
    invcal_way_each(w, r->dk, 3);
    invcal_way_each(w, r->gamma, 3);
    invcal_way_each(w, r->sigma_offset, 3);
    invcal_way_each(w, r->sigma_delta, 3);
    invcal_way_each(w, r->sigma_dk, 3);
    invcal_way_each(w, r->sigma_gamma, 3);
}

/* Rounds a record to float and judges what remains: what passes here passes when it is read. */
static invcal_status settle_record(invcal_record *r)
{
    invcal_real inverse[3][3];
    invcal_way w = {INVCAL_TO_FLOAT, NULL, NULL, 1};

    each_record_real(&w, r);
    if (!w.finite) {
        return INVCAL_NOT_FINITE;
    }
    if (!(r->field > 0) || (unsigned)r->verdict > INVCAL_WEAK || r->temperature_known > 1) {
        return INVCAL_BAD_SETTING;
    }
    return invcal_calibration_inverse(&r->calibration, inverse);
}

invcal_status invcal_record_encode(const invcal_record *record, uint8_t bytes[INVCAL_RECORD_SIZE])
{
    INVCAL_ASSERT(record && bytes);
    const invcal_real most = (invcal_real)FLT_MAX;
    invcal_record r = *record;
    invcal_way w = {INVCAL_PUT, bytes + RECORD_REALS_AT, NULL, 1};

    r.temperature_known = r.temperature_known != 0;
    if (!r.temperature_known) {
        r.temperature = 0;
    }
    if (r.condition > most && invcal_is_finite(r.condition)) {
        r.condition = most;
    }
    const invcal_status status = settle_record(&r);
    if (status != INVCAL_OK) {
        return status;
    }
    bytes[0] = RECORD_KIND;
    bytes[1] = RECORD_VERSION;
    invcal_put_u16(bytes + 2, INVCAL_RECORD_SIZE);
    memcpy(bytes + 4, r.sensor, sizeof r.sensor);
    invcal_put_u32(bytes + 12, r.date);
    invcal_put_u16(bytes + 16, r.positions);
    invcal_put_u16(bytes + 18, r.undetermined);
    invcal_put_u16(bytes + 20, r.from_prior);
    bytes[22] = (uint8_t)r.verdict;
    bytes[23] = r.temperature_known;
    each_record_real(&w, &r);
    //@ assert \initialized(bytes + (0 .. INVCAL_RECORD_SIZE - INVCAL_CRC_SIZE - 1)); // as settled
    invcal_put_u32(w.to, invcal_crc32(0, bytes, INVCAL_RECORD_SIZE - INVCAL_CRC_SIZE));
    return INVCAL_OK;
}

invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out)
{
    INVCAL_ASSERT(bytes && out);
    invcal_record r;

    if (!invcal_is_sound(bytes, size)) {
        return INVCAL_DAMAGED;
    }
    if (bytes[0] != RECORD_KIND || bytes[1] != RECORD_VERSION) {
        return INVCAL_OTHER_VERSION;
    }
    if (invcal_get_u16(bytes + 2) != INVCAL_RECORD_SIZE) {
        return INVCAL_DAMAGED;
    }
    memset(&r, 0, sizeof r); /* each_real looks at what it replaces */
    memcpy(r.sensor, bytes + 4, sizeof r.sensor);
    r.date = invcal_get_u32(bytes + 12);
    r.positions = invcal_get_u16(bytes + 16);
    r.undetermined = invcal_get_u16(bytes + 18);
    r.from_prior = invcal_get_u16(bytes + 20);
    r.verdict = (invcal_verdict)bytes[22];
    r.temperature_known = bytes[23];
    invcal_way w = {INVCAL_GET, NULL, bytes + RECORD_REALS_AT, 1};
    each_record_real(&w, &r);
    if (settle_record(&r) != INVCAL_OK ||
        (!r.temperature_known && !invcal_are_zero(bytes + TEMPERATURE_AT, 4))) {
        return INVCAL_DAMAGED;
    }
    *out = r;
    return INVCAL_OK;
}
