/* SPDX-License-Identifier: MIT
 *
 * Encodes and decodes a calibration over temperature: the record of the one at the reference
 * (record.c), complete with its own CRC, then the polynomials. The two must agree. Only lengths are
 * compared, since 0.2.0 may have turned the frame of the record; its flag for that is ignored.
 */
#include <stddef.h>

#include "../core/bytes.h"
#include "invcal/thermal_store.h"
#include "polynomials.h"
#include "../core/vector.h"

#define AGREED INVCAL_REAL(1e-4) /* over field: max difference of two calibrations */

enum { RECORD_AT = 4, AFTER_RECORD = RECORD_AT + INVCAL_RECORD_SIZE, REALS_AFTER = 4 };
enum { BEFORE_X = 16 }; /* reals */
#define THERMAL_LENGTH(degree) (212u + 36u * ((degree) + 1u))

/* The reals come first in the structure, too, and in the same order. */
typedef char
    invcali_thermal_is_in_order[offsetof(invcal_thermal, x) == BEFORE_X * sizeof(invcal_real) ? 1
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

/* Is it a calibration, and that of the record within the one at its reference? */
static INVCAL_ONCE invcal_status check_thermal(const invcal_thermal *t,
                                               const invcal_calibration *recorded)
{
    invcal_calibration c;

    if (!(t->span > 0) || !(t->min <= t->max) || t->fitted > t->degree ||
        t->fallback > INVCAL_THERMAL_OPEN) {
        return INVCAL_DAMAGED;
    }
    invcal_status status = invcali_nominal_check(&t->nominal);
    if (status == INVCAL_OK) {
        status = invcal_thermal_at(t, t->reference, &c, NULL);
    }
    return status == INVCAL_OK && !agree_in_length(recorded, &c) ? INVCAL_DAMAGED : status;
}

/* Does the stated length fit the degree? */
static INVCAL_ONCE invcal_status check_length(const uint8_t *bytes)
{
    const unsigned length = invcali_get_u16(bytes + 2);

    if (length <= AFTER_RECORD || length != THERMAL_LENGTH(bytes[AFTER_RECORD])) {
        return INVCAL_DAMAGED;
    }
    return bytes[AFTER_RECORD] < INVCAL_ROWS ? INVCAL_OK : INVCAL_OTHER_VERSION;
}

/* Reads the part after the record within. */
static INVCAL_ONCE invcal_status read_tail(const uint8_t *tail, invcal_thermal *t)
{
    invcali_zero(t, sizeof *t);
    t->degree = tail[0];
    t->fitted = tail[1];
    t->fallback = tail[2];
    return invcali_get_reals(tail + REALS_AFTER, t, count_reals(tail[0])) ? INVCAL_OK
                                                                          : INVCAL_NOT_FINITE;
}

/* Overwrites t and about on failure. */
static invcal_status read_thermal(const uint8_t *bytes, uint32_t size, invcal_thermal *t,
                                  invcal_record *about)
{
    invcal_status status = invcali_unseal(bytes, size, INVCAL_THERMAL_KIND);
    if (status == INVCAL_OK) {
        status = check_length(bytes);
    }
    if (status == INVCAL_OK) {
        status = invcal_record_decode(bytes + RECORD_AT, INVCAL_RECORD_SIZE, about);
    }
    if (status == INVCAL_OK) {
        status = read_tail(bytes + AFTER_RECORD, t);
    }
    return status == INVCAL_OK ? check_thermal(t, &about->calibration) : status;
}

/* Decodes the bytes again: rounded to float, they may not be a calibration. */
invcal_status invcal_thermal_encode(const invcal_thermal *thermal, const invcal_record *about,
                                    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE])
{
    invcal_thermal t;
    invcal_record r;

    INVCAL_ASSERT(thermal && about && bytes);
    const invcal_status status = thermal->degree < INVCAL_ROWS
                                     ? invcal_record_encode(about, bytes + RECORD_AT)
                                     : INVCAL_BAD_COUNT;
    if (status != INVCAL_OK) {
        return status;
    }
    const unsigned length = THERMAL_LENGTH(thermal->degree);
    uint8_t *at = invcali_put_two(
        bytes + AFTER_RECORD, thermal->degree | (unsigned)thermal->fitted << 8, thermal->fallback);
    (void)invcali_put_reals(at, thermal, count_reals(thermal->degree));
    invcali_seal(bytes, INVCAL_THERMAL_KIND, length);
    return read_thermal(bytes, length, &t, &r);
}

invcal_status invcal_thermal_decode(const uint8_t *bytes, uint32_t size, invcal_thermal *out,
                                    invcal_record *about)
{
    invcal_thermal t;
    invcal_record r;

    INVCAL_ASSERT(bytes && out);
    const invcal_status status = read_thermal(bytes, size, &t, &r);
    if (status == INVCAL_OK) {
        *out = t;
        if (about != NULL) {
            *about = r;
        }
    }
    return status;
}

/* ---- in a memory ----------------------------------------------------------------------------- */

invcal_status invcal_thermal_save(const invcal_thermal *thermal, const invcal_quality *quality,
                                  const invcal_store *store)
{
    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE];
    invcal_calibration c;
    invcal_record r;

    INVCAL_ASSERT(thermal && quality && store);
    invcal_status status = invcal_thermal_at(thermal, thermal->reference, &c, NULL);
    if (status == INVCAL_OK) {
        invcal_record_init(&r, &c, quality);
        status = invcal_thermal_encode(thermal, &r, bytes);
    }
    return status == INVCAL_OK ? invcal_store_save(store, bytes, THERMAL_LENGTH(thermal->degree))
                               : status;
}

invcal_status invcal_thermal_load(invcal_thermal *out, const invcal_store *store)
{
    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE];
    uint32_t size = 0;

    INVCAL_ASSERT(out);
    const invcal_status status = invcal_store_load(store, bytes, sizeof bytes, &size);
    return status == INVCAL_OK ? invcal_thermal_decode(bytes, size, out, NULL) : status;
}
