/* SPDX-License-Identifier: MIT */
#include "invcal/store.h"

#include <stddef.h>
#include <string.h>

#include "bytes.h"
#include "solve.h"

enum { SENSOR_AT = 4, DATE_AT = 12, RECORD_REALS_AT = 24 };
enum { RECORD_REALS = 27, BEFORE_SIGMA = 18 }; /* reals */
enum { EVERY_PARAMETER = 0x1FF };              /* as a mask */

/* The reals come first in the structure, too, and in the same order. */
typedef char invcal_record_is_in_order
    [offsetof(invcal_record, sigma) == BEFORE_SIGMA * sizeof(invcal_real) ? 1 : -1];

void invcal_record_init(invcal_record *record, const invcal_calibration *calibration,
                        const invcal_quality *quality)
{
    INVCAL_ASSERT(record && calibration && quality);
    memset(record, 0, sizeof *record);
    record->noise = quality->noise;
    record->rms = quality->rms;
    record->condition = quality->condition;
    record->calibration = *calibration;
    memcpy(record->sigma, quality->sigma, sizeof record->sigma);
    record->positions = quality->positions;
    record->weak = quality->weak;
    record->verdict = quality->verdict;
}

static void put_record(const invcal_record *r, uint8_t *bytes)
{
    memcpy(bytes + SENSOR_AT, r->sensor, sizeof r->sensor);
    uint8_t *at = invcal_put_u32(bytes + DATE_AT, r->date);
    at = invcal_put_two(at, r->positions, r->weak);
    at = invcal_put_two(at, r->from_prior, r->verdict | (unsigned)r->temperature_known << 8);
    (void)invcal_put_reals(at, r, RECORD_REALS);
    invcal_seal(bytes, INVCAL_RECORD_KIND, INVCAL_RECORD_SIZE);
}

/* Returns 1 if all reals are finite. */
static int get_record(const uint8_t *bytes, invcal_record *r)
{
    memcpy(r->sensor, bytes + SENSOR_AT, sizeof r->sensor);
    r->date = invcal_get_u32(bytes + DATE_AT);
    r->positions = invcal_get_u16(bytes + 16);
    r->weak = invcal_get_u16(bytes + 18);
    r->from_prior = invcal_get_u16(bytes + 20);
    r->verdict = bytes[22];
    r->temperature_known = bytes[23];
    return invcal_get_reals(bytes + RECORD_REALS_AT, r, RECORD_REALS);
}

/* WEAK is what has weak parameters; the other two verdicts are 0 and 1. */
static int is_consistent(const invcal_record *r)
{
    const unsigned verdict = r->weak > 0 ? INVCAL_WEAK : r->verdict & 1u;

    return r->verdict == verdict && (r->weak | r->from_prior) <= EVERY_PARAMETER &&
           (r->temperature_known ? r->temperature_known == 1 : r->temperature == 0);
}

/* Reads and judges; r is lost on failure. */
static invcal_status read_record(const uint8_t *bytes, uint32_t size, invcal_record *r)
{
    const invcal_status status = invcal_unseal(bytes, size, INVCAL_RECORD_KIND);
    if (status != INVCAL_OK) {
        return status;
    }
    if (invcal_get_u16(bytes + 2) != INVCAL_RECORD_SIZE) {
        return INVCAL_DAMAGED;
    }
    if (!get_record(bytes, r)) {
        return INVCAL_NOT_FINITE;
    }
    if (!is_consistent(r)) {
        return INVCAL_DAMAGED;
    }
    return invcal_nominal_check(&r->calibration);
}

/* What was written is read again: rounded to float, it may be none. */
invcal_status invcal_record_encode(const invcal_record *record, uint8_t bytes[INVCAL_RECORD_SIZE])
{
    invcal_record r;

    INVCAL_ASSERT(record && bytes);
    put_record(record, bytes);
    return read_record(bytes, INVCAL_RECORD_SIZE, &r);
}

invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out)
{
    invcal_record r;

    INVCAL_ASSERT(bytes && out);
    const invcal_status status = read_record(bytes, size, &r);
    if (status == INVCAL_OK) {
        *out = r;
    }
    return status;
}

/* ---- in a memory ------------------------------------------------------------------------------- */

invcal_status invcal_save(const invcal_store *store, const invcal_calibration *calibration,
                          const invcal_quality *quality)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record r;

    invcal_record_init(&r, calibration, quality);
    const invcal_status status = invcal_record_encode(&r, bytes);
    return status == INVCAL_OK ? invcal_store_save(store, bytes, sizeof bytes) : status;
}

invcal_status invcal_load(const invcal_store *store, invcal_calibration *calibration)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record r;
    uint32_t size = 0;

    INVCAL_ASSERT(calibration);
    invcal_status status = invcal_store_load(store, bytes, sizeof bytes, &size);
    if (status == INVCAL_OK) {
        status = read_record(bytes, size, &r);
    }
    if (status == INVCAL_OK) {
        *calibration = r.calibration;
    }
    return status;
}
