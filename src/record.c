/* SPDX-License-Identifier: MIT */
#include "invcal/store.h"

#include <stddef.h>
#include <string.h>

#include "bytes.h"
#include "solve.h"
#include "vector.h"

enum { KIND = 0xCA, FIRST_VERSION = 1 };
enum { REALS_AT = 24, TEMPERATURE_AT = 32, SIGMA_AT = 96 };
enum { REALS = 27, REALS_BEFORE_SIGMA = 18 };
enum { SKIPPED = 48 }; /* in version 1, before sigma: delta, dk, gamma, sigma_offset */
#define MAY_BE_NEGATIVE UINT32_C(0x3FFC4) /* bit i: real i: temperature and calibration */
#define INFINITE UINT32_C(0x7F800000)     /* as binary32; NaN and all that is negative are more */
#define ABSOLUTE UINT32_C(0x7FFFFFFF)     /* all but the sign */

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
    memcpy(bytes + 4, r->sensor, sizeof r->sensor);
    uint8_t *at = invcal_put_u32(bytes + 12, r->date);
    at = invcal_put_two(at, r->positions, r->weak);
    at = invcal_put_two(at, r->from_prior, r->verdict | (unsigned)r->temperature_known << 8);
    (void)invcal_put_reals(at, r, REALS);
    invcal_seal(bytes, KIND, INVCAL_RECORD_SIZE);
}

/* Does it contradict itself? */
static int is_consistent(const invcal_record *r)
{
    const unsigned expected = r->weak ? INVCAL_WEAK : r->verdict & 1u;
    return (r->weak | r->from_prior) >> INVCAL_PARAMETERS == 0 && r->verdict == expected &&
           (r->temperature_known ? r->temperature_known == 1 : r->temperature == 0);
}

static invcal_status read_record(const uint8_t *bytes, uint32_t size, invcal_record *r)
{
    invcal_status status = invcal_unseal(bytes, size, KIND, FIRST_VERSION);
    if (status != INVCAL_OK) {
        return status;
    }
    const unsigned skip = bytes[1] == FIRST_VERSION ? SKIPPED : 0;
    if (invcal_get_u16(bytes + 2) != INVCAL_RECORD_SIZE + skip) {
        return INVCAL_DAMAGED;
    }
    memcpy(r->sensor, bytes + 4, sizeof r->sensor);
    r->date = invcal_get_u32(bytes + 12);
    r->positions = (uint16_t)invcal_get_u16(bytes + 16);
    r->weak = (uint16_t)invcal_get_u16(bytes + 18);
    r->from_prior = (uint16_t)invcal_get_u16(bytes + 20);
    r->verdict = bytes[22];
    r->temperature_known = bytes[23];
    if (!(invcal_get_reals(bytes + REALS_AT, r, REALS_BEFORE_SIGMA) &&
          invcal_get_reals(bytes + SIGMA_AT + skip, r->sigma, INVCAL_PARAMETERS))) {
        return INVCAL_NOT_FINITE;
    }
    if (!is_consistent(r)) {
        return INVCAL_DAMAGED;
    }
    if (skip > 0) {
        (void)invcal_scale(&r->calibration, 1 / r->field);
    }
    return invcal_nominal_check(&r->calibration);
}

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
        return status;
    }
    return status == INVCAL_OTHER_VERSION ? status : INVCAL_DAMAGED;
}

invcal_status invcal_save(const invcal_store *store, const invcal_calibration *calibration,
                          const invcal_quality *quality)
{
    invcal_record r;
    uint8_t bytes[INVCAL_RECORD_SIZE];

    invcal_record_init(&r, calibration, quality);
    const invcal_status status = invcal_record_encode(&r, bytes);
    return status == INVCAL_OK ? invcal_store_save(store, bytes, sizeof bytes) : status;
}

invcal_status invcal_load(const invcal_store *store, invcal_calibration *calibration)
{
    invcal_record r;
    uint8_t bytes[INVCAL_RECORD_SIZE_MAX];
    uint32_t size;

    invcal_status status = invcal_store_load(store, bytes, sizeof bytes, &size);
    if (status == INVCAL_OK) {
        status = invcal_record_decode(bytes, size, &r);
    }
    if (status == INVCAL_OK) {
        *calibration = r.calibration;
    }
    return status;
}
