/* SPDX-License-Identifier: MIT */
#include "invcal/thermal_record.h"

#include <string.h>

#include "bytes.h"
#include "vector.h"

enum {
    THERMAL_KIND = 0xCB,
    THERMAL_VERSION = 1,
    RECORD_AT = 4,
    DEGREE_AT = 188,
    THERMAL_REALS_AT = 192
};

/* In the order of their bytes. The field stands in the record. */
static void each_thermal_real(invcal_way *w, invcal_thermal_calibration *c)
{
    invcal_way_each(w, &c->reference, 1);
    invcal_way_each(w, &c->span, 1);
    invcal_way_each(w, &c->least, 1);
    invcal_way_each(w, &c->greatest, 1);
    invcal_way_each(w, c->nominal.offset, 3);
    for (unsigned i = 0; i < 3; i++) {
        invcal_way_each(w, c->nominal.matrix[i], 3);
    }
    for (unsigned k = 0; k <= c->degree; k++) {
        invcal_way_each(w, c->x[k], INVCAL_PARAMETERS);
    }
}

static int is_consistent_thermal(const invcal_thermal_calibration *c)
{
    return c->span > 0 && c->least <= c->greatest && c->fitted <= c->degree &&
           (unsigned)c->fallback <= INVCAL_THERMAL_OPEN &&
           (unsigned)c->frame <= INVCAL_FRAME_TRIANGULAR;
}

/* Rounds a calibration to float and judges what remains, as record.c does. */
static invcal_status settle_thermal(invcal_thermal_calibration *c, invcal_solution *at_reference)
{
    invcal_way w = {INVCAL_TO_FLOAT, NULL, NULL, 1};
    invcal_thermal_place place;

    if (c->degree > INVCAL_THERMAL_DEGREE) {
        return INVCAL_BAD_SETTING;
    }
    invcal_way_each(&w, &c->field, 1);
    each_thermal_real(&w, c);
    if (!w.finite) {
        return INVCAL_NOT_FINITE;
    }
    if (!is_consistent_thermal(c)) {
        return INVCAL_BAD_SETTING;
    }
    return invcal_thermal_at(c, c->reference, at_reference, &place);
}

/* Settles the calibration, and puts the record of what holds at its reference: what else is known
 * stands in `known`. */
static invcal_status put_reference(invcal_thermal_calibration *c, const invcal_record *known,
                                   uint8_t bytes[INVCAL_RECORD_SIZE])
{
    invcal_record r = *known;
    invcal_solution s;

    memset(&s, 0, sizeof s); /* written only if there is one */
    const invcal_status status = settle_thermal(c, &s);
    if (status != INVCAL_OK) {
        return status;
    }
    r.calibration = s.calibration;
    memcpy(r.delta, s.delta, sizeof r.delta);
    memcpy(r.dk, s.dk, sizeof r.dk);
    memcpy(r.gamma, s.gamma, sizeof r.gamma);
    r.field = c->field;
    return invcal_record_encode(&r, bytes);
}

invcal_status invcal_thermal_record_encode(const invcal_thermal_record *record,
                                           uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE],
                                           uint32_t *length)
{
    INVCAL_ASSERT(record && bytes && length);
    invcal_thermal_calibration c = record->thermal;
    invcal_way w = {INVCAL_PUT, bytes + THERMAL_REALS_AT, NULL, 1};
    const invcal_status status = put_reference(&c, &record->record, bytes + RECORD_AT);

    if (status != INVCAL_OK) {
        return status;
    }
    const uint32_t size = INVCAL_THERMAL_RECORD_BYTES(c.degree);
    bytes[0] = THERMAL_KIND;
    bytes[1] = THERMAL_VERSION;
    invcal_put_u16(bytes + 2, (uint16_t)size);
    bytes[DEGREE_AT] = c.degree;
    bytes[DEGREE_AT + 1] = c.fitted;
    bytes[DEGREE_AT + 2] = (uint8_t)c.fallback;
    bytes[DEGREE_AT + 3] = (uint8_t)c.frame;
    each_thermal_real(&w, &c);
    //@ assert \initialized(bytes + (0 .. size - INVCAL_CRC_SIZE - 1)); // all fitted into floats
    invcal_put_u32(w.to, invcal_crc32(0, bytes, size - INVCAL_CRC_SIZE));
    *length = size;
    return INVCAL_OK;
}

/* What a sound record of this kind and version says of its own shape. */
static invcal_status check_shape(const uint8_t *bytes)
{
    const uint32_t length = invcal_get_u16(bytes + 2);

    if (length < INVCAL_THERMAL_RECORD_BYTES(0u) ||
        length != INVCAL_THERMAL_RECORD_BYTES(bytes[DEGREE_AT])) {
        return INVCAL_DAMAGED;
    }
    return bytes[DEGREE_AT] > INVCAL_THERMAL_DEGREE ? INVCAL_OTHER_VERSION : INVCAL_OK;
}

invcal_status invcal_thermal_record_decode(const uint8_t *bytes, uint32_t size,
                                           invcal_thermal_record *out)
{
    INVCAL_ASSERT(bytes && out);
    invcal_thermal_calibration c = {0};
    invcal_record r;
    uint8_t again[INVCAL_RECORD_SIZE];

    if (!invcal_is_sound(bytes, size)) {
        return INVCAL_DAMAGED;
    }
    if (bytes[0] != THERMAL_KIND || bytes[1] != THERMAL_VERSION) {
        return INVCAL_OTHER_VERSION;
    }
    invcal_status status = check_shape(bytes);
    if (status != INVCAL_OK) {
        return status;
    }
    memset(&r, 0, sizeof r); /* a record is written only if it is one */
    status = invcal_record_decode(bytes + RECORD_AT, INVCAL_RECORD_SIZE, &r);
    if (status != INVCAL_OK) {
        return status;
    }
    c.field = r.field;
    c.degree = bytes[DEGREE_AT];
    c.fitted = bytes[DEGREE_AT + 1];
    c.fallback = (invcal_thermal_fallback)bytes[DEGREE_AT + 2];
    c.frame = (invcal_frame)bytes[DEGREE_AT + 3];
    invcal_way w = {INVCAL_GET, NULL, bytes + THERMAL_REALS_AT, 1};
    each_thermal_real(&w, &c);
    if (put_reference(&c, &r, again) != INVCAL_OK) { /* never encoded */
        return INVCAL_DAMAGED;
    }
    out->thermal = c;
    out->record = r;
    return INVCAL_OK;
}
