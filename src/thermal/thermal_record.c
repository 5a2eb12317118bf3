/* SPDX-License-Identifier: MIT
 *
 * Encodes and decodes a calibration over temperature: the record of the one at the reference
 * (record.c), complete with its own CRC, then the polynomials. The two must agree. Only lengths are
 * compared, since the frame of the record may have been turned.
 */
#include <stddef.h>

#include "../core/bytes.h"
#include "invcal/thermal.h"
#include "polynomials.h"
#include "../core/vector.h"

#define AGREED INVCAL_REAL(1e-4) /* over field: max difference of two calibrations */

enum { RECORD_AT = 4, AFTER_RECORD = RECORD_AT + INVCAL_RECORD_SIZE, REALS_AFTER = 4 };
enum { BEFORE_X = 16 }; /* reals */

/* The reals come first in the structure, too, and in the same order. */
typedef char
    invcal_thermal_is_in_order[offsetof(invcal_thermal, x) == BEFORE_X * sizeof(invcal_real) ? 1
                                                                                             : -1];

static unsigned count_reals(unsigned degree)
{
    return BEFORE_X + (degree + 1) * INVCAL_PARAMETERS;
}

/* Element (j, k) of M'M: with the offset it gives all lengths, for any rotation of the
 * calibration. */
static invcal_real gram(const invcal_calibration *c, unsigned j, unsigned k)
{
    return c->matrix[0][j] * c->matrix[0][k] + c->matrix[1][j] * c->matrix[1][k] +
           c->matrix[2][j] * c->matrix[2][k];
}

static int agree_in_length(const invcal_calibration *a, const invcal_calibration *b)
{
    invcal_real scale[3]; /* over field per count */

    for (unsigned j = 0; j < 3; j++) {
        scale[j] = INVCAL_SQRT(gram(b, j, j));
        if (!(INVCAL_FABS(a->offset[j] - b->offset[j]) * scale[j] <= AGREED)) {
            return 0;
        }
        for (unsigned k = 0; k <= j; k++) {
            const invcal_real change = INVCAL_FABS(gram(a, j, k) - gram(b, j, k));
            if (!(change <= AGREED * scale[j] * scale[k])) {
                return 0;
            }
        }
    }
    return 1;
}

/* Is it a calibration, and the record within that of its reference? */
static INVCAL_ONCE invcal_status check_thermal(const invcal_thermal_record *r)
{
    const invcal_thermal *t = &r->thermal;
    invcal_thermal_place place;
    invcal_calibration c;

    if (!(t->span > 0) || !(t->min <= t->max) || t->fitted > t->degree ||
        t->fallback > INVCAL_THERMAL_OPEN || r->is_triangular > 1) {
        return INVCAL_DAMAGED;
    }
    invcal_status status = invcal_nominal_check(&t->nominal);
    if (status == INVCAL_OK) {
        status = invcal_thermal_at(t, t->reference, &c, &place);
    }
    return status == INVCAL_OK && !agree_in_length(&r->record.calibration, &c) ? INVCAL_DAMAGED
                                                                               : status;
}

/* Does the stated length fit the degree? */
static INVCAL_ONCE invcal_status check_length(const uint8_t *bytes)
{
    const unsigned length = invcal_get_u16(bytes + 2);

    if (length <= AFTER_RECORD || length != INVCAL_THERMAL_RECORD_BYTES(bytes[AFTER_RECORD])) {
        return INVCAL_DAMAGED;
    }
    return bytes[AFTER_RECORD] < INVCAL_THERMAL_ROWS ? INVCAL_OK : INVCAL_OTHER_VERSION;
}

/* Reads the part after the record within. */
static INVCAL_ONCE invcal_status read_tail(const uint8_t *tail, invcal_thermal_record *r)
{
    invcal_zero(&r->thermal, sizeof r->thermal);
    r->thermal.degree = tail[0];
    r->thermal.fitted = tail[1];
    r->thermal.fallback = tail[2];
    r->is_triangular = tail[3];
    return invcal_get_reals(tail + REALS_AFTER, &r->thermal, count_reals(tail[0]))
               ? INVCAL_OK
               : INVCAL_NOT_FINITE;
}

/* Overwrites r on failure. */
static invcal_status read_thermal(const uint8_t *bytes, uint32_t size, invcal_thermal_record *r)
{
    invcal_status status = invcal_unseal(bytes, size, INVCAL_THERMAL_KIND);
    if (status == INVCAL_OK) {
        status = check_length(bytes);
    }
    if (status == INVCAL_OK) {
        status = invcal_record_decode(bytes + RECORD_AT, INVCAL_RECORD_SIZE, &r->record);
    }
    if (status == INVCAL_OK) {
        status = read_tail(bytes + AFTER_RECORD, r);
    }
    return status == INVCAL_OK ? check_thermal(r) : status;
}

invcal_status invcal_thermal_record_init(invcal_thermal_record *record,
                                         const invcal_thermal *thermal,
                                         const invcal_quality *quality)
{
    invcal_thermal_place place;
    invcal_calibration c;

    INVCAL_ASSERT(record && thermal && quality);
    const invcal_status status = invcal_thermal_at(thermal, thermal->reference, &c, &place);
    if (status == INVCAL_OK) {
        invcal_record_init(&record->record, &c, quality);
        record->thermal = *thermal;
        record->is_triangular = 0;
    }
    return status;
}

/* Decodes the bytes again: rounded to float, they may not be a calibration. */
invcal_status invcal_thermal_record_encode(const invcal_thermal_record *record,
                                           uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE])
{
    const invcal_thermal *t = &record->thermal;
    invcal_thermal_record r;

    INVCAL_ASSERT(record && bytes);
    const invcal_status status = t->degree < INVCAL_THERMAL_ROWS
                                     ? invcal_record_encode(&record->record, bytes + RECORD_AT)
                                     : INVCAL_BAD_COUNT;
    if (status != INVCAL_OK) {
        return status;
    }
    const unsigned length = INVCAL_THERMAL_RECORD_BYTES(t->degree);
    uint8_t *at = invcal_put_two(bytes + AFTER_RECORD, t->degree | (unsigned)t->fitted << 8,
                                 t->fallback | (unsigned)record->is_triangular << 8);
    (void)invcal_put_reals(at, t, count_reals(t->degree));
    invcal_seal(bytes, INVCAL_THERMAL_KIND, length);
    return read_thermal(bytes, length, &r);
}

invcal_status invcal_thermal_record_decode(const uint8_t *bytes, uint32_t size,
                                           invcal_thermal_record *out)
{
    invcal_thermal_record r;

    INVCAL_ASSERT(bytes && out);
    const invcal_status status = read_thermal(bytes, size, &r);
    if (status == INVCAL_OK) {
        *out = r;
    }
    return status;
}
