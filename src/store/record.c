/* SPDX-License-Identifier: MIT
 *
 * Encodes and decodes the record of a calibration: the table is in store.h. Reals are the first
 * members of the structure, in the order of the bytes, so that they are copied as one run. Every
 * encoded record is decoded again: rounding to float may have made it singular or infinite.
 */
#include "invcal/store.h"

#include <stddef.h>
#include <string.h>

#include "../core/bytes.h"
#include "../core/solve.h"
#include "../core/vector.h"

enum { SENSOR_AT = 4, DATE_AT = 12, POSITIONS_AT = 16, WEAK_AT = 18, PRIOR_AT = 20 };
enum {
    VERDICT_AT = 22,
    KNOWN_AT = 23,
    REALS_AT = 24,
    TEMPERATURE_AT = 32,
    NOISE_AT = 36,
    OFFSET_AT = 48
};
enum { RECORD_REALS = 27, BEFORE_SIGMA = 18, CALIBRATION_REALS = 12 };
enum { EVERY_PARAMETER = 0x1FF }; /* as a mask */

/* The reals come first in the structure, too, and in the same order. */
typedef char invcali_record_is_in_order
    [offsetof(invcal_record, sigma) == BEFORE_SIGMA * sizeof(invcal_real) ? 1 : -1];
typedef char invcali_quality_is_in_order
    [offsetof(invcal_quality, rms) == offsetof(invcal_quality, noise) + sizeof(invcal_real) ? 1
                                                                                            : -1];

void invcal_record_init(invcal_record *record, const invcal_calibration *calibration,
                        const invcal_quality *quality)
{
    INVCAL_ASSERT(record && calibration && quality);
    invcali_zero(record, sizeof *record);
    record->noise = quality->noise;
    record->rms = quality->rms;
    record->condition = quality->condition;
    record->calibration = *calibration;
    memcpy(record->sigma, quality->sigma, sizeof record->sigma);
    record->positions = quality->positions;
    record->weak = quality->weak;
    record->held = quality->held;
    record->verdict = quality->verdict;
}

static INVCAL_ONCE void put_record(const invcal_record *r, uint8_t *bytes)
{
    memcpy(bytes + SENSOR_AT, r->sensor, sizeof r->sensor);
    uint8_t *at = invcali_put_u32(bytes + DATE_AT, r->date);
    at = invcali_put_two(at, r->positions, r->weak);
    at = invcali_put_two(at, r->held,
                         invcali_swap(r->verdict) | (unsigned)r->temperature_known << 8);
    (void)invcali_put_reals(at, r, RECORD_REALS);
}

/* WEAK if and only if a parameter is weak; a temperature that is not known is 0, of any sign. */
static INVCAL_ONCE int is_consistent(const uint8_t *bytes)
{
    const unsigned weak = invcali_get_u16(bytes + WEAK_AT);
    const unsigned verdict = bytes[VERDICT_AT];
    const unsigned known = bytes[KNOWN_AT];

    return verdict <= invcali_swap(INVCAL_WEAK) &&
           (weak > 0) == (verdict == invcali_swap(INVCAL_WEAK)) &&
           (weak | invcali_get_u16(bytes + PRIOR_AT)) <= EVERY_PARAMETER &&
           (known > 0 ? known == 1 : invcali_get_u32(bytes + TEMPERATURE_AT) << 1 == 0);
}

/* Reads the reals and checks everything; overwrites r on failure. */
static invcal_status read_reals(const uint8_t *bytes, uint32_t size, invcal_record *r)
{
    const invcal_status status = invcali_unseal(bytes, size, INVCAL_RECORD_KIND);
    if (status != INVCAL_OK) {
        return status;
    }
    if (invcali_get_u16(bytes + 2) != INVCAL_RECORD_SIZE) {
        return INVCAL_DAMAGED;
    }
    if (!invcali_get_reals(bytes + REALS_AT, r, RECORD_REALS)) {
        return INVCAL_NOT_FINITE;
    }
    return is_consistent(bytes) ? invcali_nominal_check(&r->calibration) : INVCAL_DAMAGED;
}

/* Decodes the bytes again: rounded to float, they may not be a calibration. */
static invcal_status seal_record(uint8_t *bytes)
{
    invcal_record r;

    invcali_seal(bytes, INVCAL_RECORD_KIND, INVCAL_RECORD_SIZE);
    return read_reals(bytes, INVCAL_RECORD_SIZE, &r);
}

invcal_status invcal_record_encode(const invcal_record *record, uint8_t bytes[INVCAL_RECORD_SIZE])
{
    INVCAL_ASSERT(record && bytes);
    put_record(record, bytes);
    return seal_record(bytes);
}

invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out)
{
    invcal_record r;

    INVCAL_ASSERT(bytes && out);
    const invcal_status status = read_reals(bytes, size, &r);
    if (status == INVCAL_OK) {
        memcpy(r.sensor, bytes + SENSOR_AT, sizeof r.sensor);
        r.date = invcali_get_u32(bytes + DATE_AT);
        r.positions = invcali_get_u16(bytes + POSITIONS_AT);
        r.weak = invcali_get_u16(bytes + WEAK_AT);
        r.held = invcali_get_u16(bytes + PRIOR_AT);
        r.verdict = invcali_swap(bytes[VERDICT_AT]);
        r.temperature_known = bytes[KNOWN_AT];
        *out = r;
    }
    return status;
}

/* ---- in a memory ----------------------------------------------------------------------------- */

/* The bytes of a record from invcal_record_init, without making one. */
invcal_status invcal_save(const invcal_calibration *calibration, const invcal_quality *quality,
                          const invcal_store *store)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];

    INVCAL_ASSERT(calibration && quality);
    invcali_zero(bytes, sizeof bytes);
    uint8_t *at = invcali_put_two(bytes + POSITIONS_AT, quality->positions, quality->weak);
    (void)invcali_put_two(at, quality->held, invcali_swap(quality->verdict));
    at = invcali_put_reals(bytes + NOISE_AT, &quality->noise, 2); /* and rms */
    at = invcali_put_reals(at, &quality->condition, 1);
    at = invcali_put_reals(at, calibration, CALIBRATION_REALS);
    (void)invcali_put_reals(at, quality->sigma, INVCAL_PARAMETERS);
    const invcal_status status = seal_record(bytes);
    return status == INVCAL_OK ? invcal_store_save(store, bytes, sizeof bytes) : status;
}

invcal_status invcal_load(invcal_calibration *calibration, const invcal_store *store)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record r;
    uint32_t size = 0;

    INVCAL_ASSERT(calibration);
    invcal_status status = invcal_store_load(store, bytes, sizeof bytes, &size);
    if (status == INVCAL_OK) {
        status = read_reals(bytes, size, &r);
    }
    if (status == INVCAL_OK) {
        (void)invcali_get_reals(bytes + OFFSET_AT, calibration, CALIBRATION_REALS);
    }
    return status;
}
